/* bank.h: the reading and writing that all C programs of the bank share. With -DLIBRARY the same algorithm is a shared library.
   An algorithm defines draw(): `rgb` arrives with the background. Its slips are -DSLIP_name; those of reading and writing stand here. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef LIBRARY
#include "farop.h"
#endif

typedef struct { double a, b, c, low, high; int constant; } plane;
typedef struct { double x, y, inverse_w, w, value[6]; } corner;
typedef struct { int first, count, surface; double opacity[3]; plane planes[7]; } polygon;
typedef struct { double ambient[3], diffuse[3], ks, power; } surface;
typedef struct { double place[3], color[3]; } lamp;
typedef struct {
    int width, height, samples, normals;
    double background[3];
    int corner_count, polygon_count, lamp_count, surface_count;
    corner *corners;
    polygon *polygons;
    lamp *lamps;
    surface *surfaces;
} scene;

static void draw(const scene *s, double *rgb);

/* a x + b y + c at the center of a sample, between low and high. */
static double plane_at(const plane *p, int x, int y) {
    double v;
    if (p->constant) return p->c;
#if defined SLIP_plane_without_y
    v = p->a * (x + 0.5) + p->c;
#elif defined SLIP_planes_at_the_corner
    v = p->a * x + p->b * y + p->c;
#else
    v = p->a * (x + 0.5) + p->b * (y + 0.5) + p->c;
#endif
    return (float)v;
}

static double clamped(const plane *p, double v) { return v < p->low ? p->low : v > p->high ? p->high : v; }
static inline double depth_at(const polygon *g, int x, int y) { return clamped(&g->planes[0], plane_at(&g->planes[0], x, y)); }

static inline double value_at(const polygon *g, int number, int x, int y) {
    const plane *p = &g->planes[1 + number];
    if (p->constant) return p->c;
#ifdef SLIP_clamped_over_w
    return clamped(p, plane_at(p, x, y)) / depth_at(g, x, y);
#endif
#ifdef SLIP_times_depth
    return clamped(p, plane_at(p, x, y) * depth_at(g, x, y));
#endif
#ifdef SLIP_depth_of_the_corner
    return clamped(p, plane_at(p, x, y) / g->planes[0].high);
#endif
    return clamped(p, plane_at(p, x, y) / depth_at(g, x, y));
}

static inline void put(const scene *s, const polygon *g, int x, int y, double *rgb) {
#if defined SLIP_wrong_stride
    double *at = rgb + 3 * (y * s->height + x);
#else
    double *at = rgb + 3 * (y * s->width + x);
#endif
    for (int c = 0; c < 3; c++) at[c] = value_at(g, c, x, y);
}

/* Glass is kept apart until everything opaque is there. */
typedef struct { int at, order; double depth, color[3], opacity[3]; } layer;
static layer *layers;
static int layer_count, layer_room;

static int nearer_last(const void *a, const void *b) {
    const layer *p = a, *q = b;
    if (p->at != q->at) return p->at < q->at ? -1 : 1;
    if (p->depth != q->depth) return p->depth < q->depth ? -1 : 1;
    return q->order - p->order;
}

/* Whether polygon g is glass; then its sample is kept for later. */
static inline int is_glass(const scene *s, const polygon *g, int x, int y, double depth) {
#ifdef SLIP_glass_ignored
    return 0;
#endif
    if (g->opacity[0] == 1 && g->opacity[1] == 1 && g->opacity[2] == 1) return 0;
    if (layer_count == layer_room) layers = realloc(layers, (layer_room = 2 * layer_room + 64) * sizeof *layers);
    layer *l = &layers[layer_count++];
    l->at = y * s->width + x, l->order = (int)(g - s->polygons), l->depth = depth;
    for (int c = 0; c < 3; c++) l->color[c] = value_at(g, c, x, y), l->opacity[c] = g->opacity[c];
    return 1;
}

static inline void lay_glass(const double *depths, double *rgb) {
    qsort(layers, layer_count, sizeof *layers, nearer_last);
    for (int n = 0; n < layer_count; n++) {
        layer *l = &layers[n];
        for (int c = 0; c < 3 && l->depth > depths[l->at]; c++)
            rgb[3 * l->at + c] = rgb[3 * l->at + c] * (1 - l->opacity[c]) + l->color[c] * l->opacity[c];
    }
    layer_count = 0;
}

#ifdef LIBRARY
void farop_draw(const farop_list *list, farop_target *target) {
    scene s = {0};
    s.width = list->width, s.height = list->height, s.samples = 1;
    s.corner_count = list->vertex_count, s.polygon_count = list->polygon_count;
    s.corners = calloc(s.corner_count + 1, sizeof *s.corners);
    s.polygons = calloc(s.polygon_count + 1, sizeof *s.polygons);
    for (int i = 0; i < s.corner_count; i++) {
        const farop_vertex *v = &list->vertices[i];
        corner c = {v->x, v->y, v->inverse_w, v->w, {0}};
        memcpy(c.value, v->values, sizeof c.value);
        s.corners[i] = c;
    }
    for (int i = 0; i < s.polygon_count; i++) {
        const farop_polygon *from = &list->polygons[i];
        s.polygons[i].first = from->first_vertex, s.polygons[i].count = from->vertex_count;
        for (int c = 0; c < 3; c++) s.polygons[i].opacity[c] = from->opacity[c];
        for (unsigned k = 0; k < list->planes_each && k < 7; k++) {
            const farop_plane *p = &list->planes[from->first_plane + k];
            plane own = {p->a, p->b, p->c, p->low, p->high, p->rule == FAROP_CONSTANT};
            s.polygons[i].planes[k] = own;
        }
    }
    size_t count = (size_t)s.width * s.height * 3;
    double *rgb = calloc(count + 1, sizeof *rgb);
    for (size_t i = 0; i < count; i++) rgb[i] = target->rgb[i];
    draw(&s, rgb);
    for (size_t i = 0; i < count; i++) target->rgb[i] = (float)rgb[i];
    free(rgb), free(s.corners), free(s.polygons);
}
#else
static void read_plane(polygon *g, int number, char *words) {
    plane *p = &g->planes[number];
    char rule[16] = "";
    sscanf(words, "%*s %lf %lf %lf %lf %lf %15s", &p->a, &p->b, &p->c, &p->low, &p->high, rule);
    p->constant = rule[0] == 'c';
}

static int read_scene(scene *s) {
    static char line[4096];
    int plane_number = 0;
    memset(s, 0, sizeof *s);
    while (fgets(line, sizeof line, stdin)) {
        char word[32] = "";
        int length = 0, n = 0;
        if (sscanf(line, "%31s%n", word, &length) != 1) continue;
        char *rest = line + length;
        if (!strcmp(word, "size")) sscanf(rest, "%d %d", &s->width, &s->height);
        if (!strcmp(word, "samples")) sscanf(rest, "%d", &s->samples);
#ifndef SLIP_background_not_read
        double *b = s->background;
        if (!strcmp(word, "background")) sscanf(rest, "%lf %lf %lf", b, b + 1, b + 2);
#endif
        if (!strcmp(word, "varying")) s->normals = strstr(rest, "normal") != 0;
        if (!strcmp(word, "lights") && sscanf(rest, "%d", &n)) s->lamps = calloc(n + 1, sizeof *s->lamps);
        if (!strcmp(word, "surfaces") && sscanf(rest, "%d", &n)) s->surfaces = calloc(n + 1, sizeof *s->surfaces);
        if (!strcmp(word, "polygons") && sscanf(rest, "%d", &n)) s->polygons = calloc(n + 1, sizeof *s->polygons);
        if (!strcmp(word, "vertices") && sscanf(rest, "%d", &n)) s->corners = calloc(n + 1, sizeof *s->corners);
        if (!strcmp(word, "light")) {
            double *p = s->lamps[s->lamp_count].place, *c = s->lamps[s->lamp_count].color;
            sscanf(rest, "%lf %lf %lf %lf %lf %lf", p, p + 1, p + 2, c, c + 1, c + 2);
            s->lamp_count++;
        }
        if (!strcmp(word, "surface")) {
            surface *f = &s->surfaces[s->surface_count++];
            double *a = f->ambient, *d = f->diffuse;
            sscanf(rest, "%*d %lf %lf %lf %lf %lf %lf %lf %lf", a, a + 1, a + 2, d, d + 1, d + 2, &f->ks, &f->power);
        }
        if (!strcmp(word, "polygon")) {
            polygon *g = &s->polygons[s->polygon_count++];
            double *o = g->opacity;
            sscanf(rest, "%*d %d %d %lf %lf %lf", &g->count, &g->surface, o, o + 1, o + 2);
            g->first = s->corner_count;
            plane_number = 0;
        }
        if (!strcmp(word, "plane")) {
            int to = plane_number++;
#ifdef SLIP_green_and_blue_exchanged
            to = to == 2 ? 3 : to == 3 ? 2 : to;
#endif
#ifdef SLIP_colors_one_field_late
            to = to == 0 ? 0 : to % 3 + 1;
#endif
            if (to < 7) read_plane(&s->polygons[s->polygon_count - 1], to, rest);
        }
        if (!strcmp(word, "vertex")) {
            corner *v = &s->corners[s->corner_count++];
            double *n = v->value;
            sscanf(rest, "%lf %lf %lf %*f %*f %lf %*s %lf %lf %lf %lf %lf %lf", &v->x, &v->y, &v->inverse_w, &v->w, n, n + 1,
                   n + 2, n + 3, n + 4, n + 5);
#ifdef SLIP_x_and_y_exchanged_on_reading
            double x = v->x;
            v->x = v->y, v->y = x;
#endif
#ifdef SLIP_corners_as_int
            v->x = (int)v->x, v->y = (int)v->y;
#endif
#ifdef SLIP_four_subpixel_bits
            v->x = floor(v->x * 4 + 0.5) / 4, v->y = floor(v->y * 4 + 0.5) / 4;
#endif
        }
        if (!strcmp(word, "end")) return 1;
    }
    return 0;
}

static unsigned char level(double light) {
#if defined SLIP_levels_cut
    return (unsigned char)(255 * fmin(fmax(light, 0), 1));
#elif defined SLIP_levels_up
    return (unsigned char)ceil(255 * fmin(fmax(light, 0), 1));
#elif defined SLIP_light_over_255
    return (unsigned char)fmin(fmax(light, 0), 1);
#elif defined SLIP_not_cut_at_one
    return (unsigned char)(long)(255 * light + 0.5);
#else
    return (unsigned char)(255 * fmin(fmax(light, 0), 1) + 0.5);
#endif
}

#ifndef OWN_MEAN
#define mean_of(s, rgb) (rgb)
#endif

int main(void) {
    scene s;
    while (read_scene(&s)) {
        size_t samples = (size_t)s.width * s.height;
        double *rgb = calloc(samples * 3 + 999, sizeof *rgb);
        for (size_t i = 0; i < samples * 3; i++) rgb[i] = s.background[i % 3];
        draw(&s, rgb);
        double *out = mean_of(&s, rgb);
        printf("P6\n%d %d\n255\n", s.width, s.height);
        for (int n = 0; n < s.width * s.height; n++) {
            int x = n % s.width, y = n / s.width;
#if defined SLIP_rows_from_the_bottom
            y = s.height - 1 - y;
#elif defined SLIP_written_by_columns
            x = n / s.height, y = n % s.height;
#elif defined SLIP_turned_half
            x = s.width - 1 - x, y = s.height - 1 - y;
#endif
            for (int c = 0; c < 3; c++) putchar(level(out[3 * (y * s.width + x) + c]));
        }
        fflush(stdout);
        free(rgb), free(s.corners), free(s.polygons), free(s.lamps), free(s.surfaces);
    }
    return 0;
}
#endif
