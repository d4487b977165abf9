/* farop.h: a rasterizer as a C library. Fill in farop_draw, build, draw:

       gcc -O2 -std=c11 -shared -fPIC -o zbuffer.so zbuffer_lib.c -lm
       farop render spd:gears -r lib:./zbuffer.so -o gears.png

   The fields are those of the v2 screen file: docs/screen-files.md says what each means. Samples: x to the right, y down; sample
   (x, y) has its center at (x + 0.5, y + 0.5). Colors are linear light, 0 to 1. Depth is 1/w: larger is nearer, 0 infinitely far. */
#ifndef FAROP_H
#define FAROP_H
#include <stdint.h>

#define FAROP_ABI 1 /* changes when a struct changes */

/* Rules of a plane: how it is evaluated at a sample. farop_at knows them. */
enum { FAROP_CONSTANT = 0, FAROP_BLOCKS = 1, FAROP_SAMPLES = 2, FAROP_DOUBLE = 3, FAROP_SCANLINE = 4 };
/* What varies over a polygon. */
enum { FAROP_NOTHING = 0, FAROP_COLOR = 1, FAROP_NORMAL_EYE = 2, FAROP_NORMAL_EYE_COLOR = 3 };
/* Where an edge comes from. */
enum { FAROP_ORIGINAL = 0, FAROP_CUT = 1, FAROP_DIAGONAL = 2 };

typedef struct { /* value = a x + b y + c, brought into low ... high */
    double a, b, c, low, high;
    int32_t rule;
    int32_t reserved;
} farop_plane;

typedef struct {
    double x, y;       /* in samples, multiples of 2^-subpixel_bits */
    double inverse_w;  /* 1/w, the depth */
    double w;          /* distance along the view */
    double values[6];  /* red green blue; or normal x y z, eye point x y z (a color behind them: planes only) */
    int32_t edge;      /* of the edge to the next vertex */
    int32_t reserved;
} farop_vertex;

typedef struct {
    uint32_t first_vertex, vertex_count; /* its corners, in order around the outline: list->vertices[first_vertex] ... */
    uint32_t first_plane;                /* list->planes[first_plane] is depth, then one plane for each value */
    uint32_t surface;
    float opacity[3];                    /* 1: opaque */
    uint32_t line;                       /* in the scene file */
} farop_polygon;

typedef struct {
    uint32_t abi;            /* FAROP_ABI */
    uint32_t width, height;  /* in samples */
    uint32_t subpixel_bits;
    uint32_t varying;        /* FAROP_COLOR, ...; pictures on surfaces are left out */
    uint32_t value_count;    /* how many of vertex.values are used; 9: all six, and three more planes */
    uint32_t planes_each;    /* planes of a polygon: 1 + value_count, or 0 */
    uint32_t perspective;    /* 1: planes of values hold value / w */
    uint32_t double_precision;
    float background[3];
    uint32_t vertex_count, plane_count, polygon_count, reserved;
    const farop_vertex *vertices;
    const farop_plane *planes;
    const farop_polygon *polygons;
} farop_list;

typedef struct { /* arrives with the background color and depth 0 */
    uint32_t width, height;
    float *rgb;    /* rgb[(y * width + x) * 3]: red, then green, then blue; row 0 on top */
    double *depth; /* depth[y * width + x]; yours to use */
} farop_target;

#ifdef __cplusplus
extern "C" {
#endif
/* Yours: draws list into target. Keep nothing between calls. */
void farop_draw(const farop_list *list, farop_target *target);
#ifdef __cplusplus
}
#endif

/* The plane's value at the center of sample (x, y), not yet brought into low ... high: the last bit as farop has it. */
static inline double farop_at(const farop_plane *plane, int32_t x, int32_t y) {
    int32_t at_x = plane->rule == FAROP_BLOCKS ? x & ~15 : x, at_y = plane->rule == FAROP_BLOCKS ? y & ~15 : y;
    double start = plane->a * (at_x + 0.5) + plane->b * (at_y + 0.5) + plane->c;
    if (plane->rule == FAROP_CONSTANT || plane->rule == FAROP_SCANLINE) return plane->c;
    if (plane->rule == FAROP_DOUBLE) return start;
    if (plane->rule == FAROP_SAMPLES) return (float)start;
    float step = (float)plane->a * (float)(x - at_x) + (float)plane->b * (float)(y - at_y);
    return (float)start + step;
}

static inline double farop_clamp(const farop_plane *plane, double value) {
    return value < plane->low ? plane->low : value > plane->high ? plane->high : value;
}

/* 1/w of a polygon at sample (x, y). */
static inline double farop_depth(const farop_list *list, const farop_polygon *polygon, int32_t x, int32_t y) {
    const farop_plane *plane = &list->planes[polygon->first_plane];
    return farop_clamp(plane, farop_at(plane, x, y));
}

/* Value `number` (0: red, 1: green, 2: blue) of a polygon at sample (x, y), where its depth is inverse_w. */
static inline double farop_value(const farop_list *list, const farop_polygon *polygon, uint32_t number, int32_t x,
                                 int32_t y, double inverse_w) {
    const farop_plane *plane = &list->planes[polygon->first_plane + 1 + number];
    double value = farop_at(plane, x, y);
    int over_w = (list->perspective || number >= 3) && plane->rule != FAROP_CONSTANT && plane->rule != FAROP_SCANLINE;
    if (over_w) value = list->double_precision ? value / inverse_w : (float)value / (float)inverse_w;
    return farop_clamp(plane, value);
}
#endif
