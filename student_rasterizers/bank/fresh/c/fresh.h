/* fresh.h: screen files in, P6 pictures out, for the C programs of the fresh set. A program defines draw().
   A slip is -DSLIP_name; SLIP(name) is 1 with it and 0 without. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PLACE_1 0,
#define SECOND(a, b, ...) b
#define ON3(place) SECOND(place 1, 0, 0)
#define ON2(word) ON3(PLACE_##word)
#define ON(word) ON2(word)
#define SLIP(name) ON(SLIP_##name)

enum { CONSTANT, BLOCKS, SAMPLES, DOUBLE };
typedef struct { double a, b, c, low, high; int rule; } Plane;
typedef struct { double x, y, inverse_w, w, value[6]; int is_cut; } Vertex;
typedef struct { int first, count, surface, planes; double opacity[3]; Plane plane[7]; } Polygon;
typedef struct { double ambient[3], diffuse[3], ks, power; } Surface;
typedef struct { double at[3], color[3]; } Light;
typedef struct { int x, y, polygon; double depth, color[3], opacity[3]; } Layer;

static int width, height, polygons, vertices, lights, has_normals, layers;
static double background[3], *picture;
static Polygon *polygon;
static Vertex *vertex;
static Surface *surface;
static Light *light;
static Layer *layer;

/* Fills `picture`, three numbers a sample, rows from the top; it holds the background. */
static void draw(void);

/* The value of a plane at the center of a sample, to the last bit of docs/screen-files.md. */
static double plane_at(const Plane *p, int x, int y) {
    if (p->rule == CONSTANT) return p->c;
    double exact = p->a * (x + 0.5) + p->b * (y + 0.5) + p->c;
    if (p->rule == DOUBLE) return exact;
    if (p->rule == SAMPLES) return (float)exact;
    int left = x & ~15, top = y & ~15;
    float start = (float)(p->a * (left + 0.5) + p->b * (top + 0.5) + p->c);
    float step = (float)p->a * (float)(x - left) + (float)p->b * (float)(y - top);
    return start + step;
}

static double within(const Plane *p, double value) { return value < p->low ? p->low : value > p->high ? p->high : value; }

static double depth_at(const Polygon *p, int x, int y) { return within(&p->plane[0], plane_at(&p->plane[0], x, y)); }

/* What varies: plane `n`, from 1. */
static double value_at(const Polygon *p, int n, int x, int y) {
    const Plane *plane = &p->plane[n];
    double value = plane_at(plane, x, y);
    if (plane->rule == CONSTANT) return value;
    value /= depth_at(p, x, y);
    return within(plane, plane->rule == DOUBLE ? value : (float)value);
}

static int is_opaque(const Polygon *p) { return p->opacity[0] >= 1 && p->opacity[1] >= 1 && p->opacity[2] >= 1; }

/* Puts what is transparent aside. */
static void keep(const Polygon *p, int x, int y, double depth, const double color[3]) {
    if ((layers & (layers + 1)) == 0) layer = realloc(layer, (2 * (size_t)layers + 2) * sizeof *layer);
    Layer *l = &layer[layers++];
    l->x = x, l->y = y, l->polygon = (int)(p - polygon), l->depth = depth;
    memcpy(l->color, color, sizeof l->color), memcpy(l->opacity, p->opacity, sizeof l->opacity);
}

static int farther_first(const void *left, const void *right) {
    const Layer *a = left, *b = right;
    if (a->depth != b->depth) return a->depth < b->depth ? -1 : 1;
    return b->polygon - a->polygon;
}

/* Blends what was kept, from the back to the front, where it is nearer than `depth`. */
static void blend(const float *depth) {
    if (layers) qsort(layer, layers, sizeof *layer, farther_first);
    for (Layer *l = layer; l < layer + layers; l++) {
        size_t at = (size_t)l->y * width + l->x;
        for (int i = 0; i < 3 && (float)l->depth > depth[at]; i++) {
            double *c = &picture[3 * at + i];
            *c += l->opacity[i] * (l->color[i] - *c);
        }
    }
    layers = 0;
}

static void *room(size_t count, size_t size) { return calloc(count + 1, size); }

static void read_polygon(const char *line) {
    Polygon *p = &polygon[polygons++];
    double *o = p->opacity;
    sscanf(line, "%*s %*d %d %d %lf %lf %lf", &p->count, &p->surface, o, o + 1, o + 2);
    p->first = vertices, p->planes = 0;
}

static void read_plane(const char *line) {
    Polygon *p = &polygon[polygons - 1];
    char rule[16] = "";
    Plane *q = &p->plane[p->planes < 7 ? p->planes++ : 6];
    sscanf(line, "%*s %*s %lf %lf %lf %lf %lf %15s", &q->a, &q->b, &q->c, &q->low, &q->high, rule);
    q->rule = rule[0] == 'c' ? CONSTANT : rule[0] == 'b' ? BLOCKS : rule[0] == 's' ? SAMPLES : DOUBLE;
}

static void read_vertex(const char *line) {
    Vertex *v = &vertex[vertices++];
    char edge[16] = "";
    double *n = v->value;
    sscanf(line, "%*s %lf %lf %lf %*f %*f %lf %15s %lf %lf %lf %lf %lf %lf", &v->x, &v->y, &v->inverse_w, &v->w, edge, n, n + 1,
           n + 2, n + 3, n + 4, n + 5);
    v->is_cut = strcmp(edge, "original") != 0;
    if (SLIP(whole_coordinates)) v->x = (int)v->x, v->y = (int)v->y;
}

static void read_surface(const char *line) {
    int number = 0;
    sscanf(line, "%*s %d", &number);
    Surface *s = &surface[number];
    double *a = s->ambient, *d = s->diffuse;
    sscanf(line, "%*s %*d %lf %lf %lf %lf %lf %lf %lf %lf", a, a + 1, a + 2, d, d + 1, d + 2, &s->ks, &s->power);
}

static void read_light(const char *line) {
    Light *l = &light[lights++];
    sscanf(line, "%*s %lf %lf %lf %lf %lf %lf", l->at, l->at + 1, l->at + 2, l->color, l->color + 1, l->color + 2);
}

/* The next sheet; 0 at the end of the input. */
static int read_sheet(void) {
    char line[1024], key[32];
    int count = 0;
    polygons = vertices = lights = 0;
    while (fgets(line, sizeof line, stdin)) {
        if (sscanf(line, "%31s", key) != 1 || key[0] == '#') continue;
        sscanf(line, "%*s %d", &count);
        if (!strcmp(key, "size")) sscanf(line, "%*s %d %d", &width, &height);
        else if (!strcmp(key, "background")) sscanf(line, "%*s %lf %lf %lf", background, background + 1, background + 2);
        else if (!strcmp(key, "varying")) has_normals = strstr(line, "normal_eye") != NULL;
        else if (!strcmp(key, "lights")) light = room(count, sizeof *light);
        else if (!strcmp(key, "surfaces")) surface = room(count, sizeof *surface);
        else if (!strcmp(key, "polygons")) polygon = room(count, sizeof *polygon);
        else if (!strcmp(key, "vertices")) vertex = room(count, sizeof *vertex);
        else if (!strcmp(key, "light")) read_light(line);
        else if (!strcmp(key, "surface")) read_surface(line);
        else if (!strcmp(key, "polygon")) read_polygon(line);
        else if (!strcmp(key, "plane")) read_plane(line);
        else if (!strcmp(key, "vertex")) read_vertex(line);
        else if (!strcmp(key, "end")) return 1;
    }
    return 0;
}

int main(void) {
    while (read_sheet()) {
        size_t samples = (size_t)width * height;
        picture = room(3 * samples, sizeof *picture);
        for (size_t i = 0; i < 3 * samples; i++) picture[i] = background[i % 3];
        if (SLIP(last_polygon_unread)) polygons = polygons > 1 ? polygons - 1 : polygons;
        draw();
        printf("P6\n%d %d\n255\n", width, height);
        for (size_t i = 0; i < 3 * samples; i++) putchar((int)(fmin(fmax(picture[i], 0), 1) * 255 + 0.5));
        fflush(stdout);
        free(picture), free(polygon), free(vertex), free(surface), free(light);
        polygon = NULL, vertex = NULL, surface = NULL, light = NULL;
    }
    return 0;
}
