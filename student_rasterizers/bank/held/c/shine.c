/* Phong: a span between the crossings of a row, pair by pair, and light at every sample of it. */
#include "held.h"

typedef struct { double x, y, z; } V;
static V minus(V a, V b) { return (V){a.x - b.x, a.y - b.y, a.z - b.z}; }
static V times(double k, V a) { return (V){k * a.x, k * a.y, k * a.z}; }
static double dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V unit(V a) { return times(1 / sqrt(dot(a, a)), a); }

static void light(const Sheet *s, const Surface *f, V normal, V point, double *color) {
    V eye = times(-1, point);
    V n = unit(normal), v = unit(eye);
#ifdef SLIP_normal_not_unit
    n = normal;
#endif
#ifdef SLIP_eye_at_infinity
    v = (V){0, 0, -1};
#endif
#ifdef SLIP_eye_vector_not_unit
    v = eye;
#endif
    for (int c = 0; c < 3; c++) color[c] = f->ambient[c];
#ifdef SLIP_ambient_forgotten
    for (int c = 0; c < 3; c++) color[c] = 0;
#endif
    int lamps = s->lamps;
#ifdef SLIP_first_lamp_only
    lamps = lamps > 1 ? 1 : lamps;
#endif
    for (int i = 0; i < lamps; i++) {
        const Lamp *lamp = &s->lamp[i];
        V way = minus((V){lamp->at[0], lamp->at[1], lamp->at[2]}, point), l = unit(way);
#ifdef SLIP_lamp_vector_not_unit
        l = way;
#endif
#ifdef SLIP_lamp_as_a_direction
        l = unit((V){lamp->at[0], lamp->at[1], lamp->at[2]});
#endif
        double nl = dot(n, l), fade = 1;
#ifdef SLIP_both_sides_lit
        nl = fabs(nl);
#endif
#ifdef SLIP_fades_with_distance
        fade = 1 / dot(way, way);
#endif
#if !defined SLIP_dark_side_subtracts && !defined SLIP_highlight_on_the_dark_side
        if (nl <= 0) continue;
#endif
        V r = minus(times(2 * nl, n), l);
        double rv = dot(r, v);
#ifdef SLIP_mirror_sign
        rv = dot(minus(l, times(2 * nl, n)), v);
#endif
#ifdef SLIP_half_vector
        rv = dot(n, unit((V){l.x + v.x, l.y + v.y, l.z + v.z}));
#endif
        if (rv < 0) rv = 0;
        double gloss = f->ks * pow(rv, f->power);
#ifdef SLIP_power_ignored
        gloss = f->ks * rv;
#endif
#ifdef SLIP_dark_side_subtracts
        if (nl <= 0) gloss = 0;
#endif
        for (int c = 0; c < 3; c++) {
            double matte = f->diffuse[c] * nl, shine = gloss;
#ifdef SLIP_highlight_on_the_dark_side
            if (matte < 0) matte = 0;
#endif
#ifdef SLIP_highlight_in_surface_color
            shine *= f->diffuse[c];
#endif
            color[c] += fade * lamp->light[c] * (matte + shine);
        }
    }
}

static double own(const Face *f, int number, double x, double y, double depth) {
    const Ramp *r = &f->ramp[1 + number];
    return r->flat ? r->c : within(r, ramp_at(r, x, y) / depth);
}

static void sample(const Sheet *s, const Face *f, int x, int y, double *color) {
    double depth = depth_of(f, x, y), v[6];
    if (!s->has_normals) {
        for (int c = 0; c < 3; c++) color[c] = own(f, c, x + 0.5, y + 0.5, depth);
        return;
    }
    for (int i = 0; i < 6; i++) v[i] = own(f, i, x + 0.5, y + 0.5, depth);
#ifdef SLIP_normal_of_the_first_corner
    memcpy(v, f->point[0].own, 3 * sizeof *v);
#endif
#ifdef SLIP_normal_linear_on_the_screen
    if (f->points == 3) {
        const Point *a = f->point, *b = a + 1, *c = a + 2;
        double all = (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y), px = x + 0.5, py = y + 0.5;
        double u = ((px - a->x) * (c->y - a->y) - (c->x - a->x) * (py - a->y)) / all;
        double t = ((b->x - a->x) * (py - a->y) - (px - a->x) * (b->y - a->y)) / all;
        for (int i = 0; i < 6; i++) v[i] = (1 - u - t) * a->own[i] + u * b->own[i] + t * c->own[i];
    }
#endif
    light(s, &s->surface[f->surface], (V){v[0], v[1], v[2]}, (V){v[3], v[4], v[5]}, color);
}

/* The light at the corners, brought to the sample by the inverses of distances. */
static void gouraud(const Sheet *s, const Face *f, int x, int y, double *color) {
    const Point *a = f->point, *b = a + 1, *c = a + f->points - 1;
    double all = (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y), px = x + 0.5, py = y + 0.5;
    double u = ((px - a->x) * (c->y - a->y) - (c->x - a->x) * (py - a->y)) / all;
    double t = ((b->x - a->x) * (py - a->y) - (px - a->x) * (b->y - a->y)) / all;
    const Point *of[3] = {a, b, c};
    double weight[3] = {(1 - u - t) * a->over_w, u * b->over_w, t * c->over_w}, sum = weight[0] + weight[1] + weight[2], one[3];
    color[0] = color[1] = color[2] = 0;
    for (int i = 0; i < 3; i++) {
        const double *o = of[i]->own;
        light(s, &s->surface[f->surface], (V){o[0], o[1], o[2]}, (V){o[3], o[4], o[5]}, one);
        for (int k = 0; k < 3; k++) color[k] += weight[i] / sum * one[k];
    }
}

static int rising(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

static void paint(const Sheet *s, double *out) {
    double *depths = calloc((size_t)s->width * s->height + 1, sizeof *depths);
    for (int n = 0; n < s->faces; n++) {
        const Face *f = &s->face[n];
        int *ends = calloc(f->points + 1, sizeof *ends);
        double top = 1e9, bottom = -1e9;
        for (int i = 0; i < f->points; i++) top = fmin(top, f->point[i].y), bottom = fmax(bottom, f->point[i].y);
        for (int y = (int)floor(fmax(top, 0)); y < bottom && y < s->height; y++) {
            int count = 0;
            for (int i = 0; i < f->points; i++) {
                const Point *a = &f->point[i], *b = &f->point[(i + 1) % f->points];
                if (a->y > b->y) { const Point *t = a; a = b; b = t; }
                if (a->y > y + 0.5 || b->y <= y + 0.5) continue;
                ends[count++] = (int)ceil(a->x + (y + 0.5 - a->y) * (b->x - a->x) / (b->y - a->y) - 0.5);
            }
            qsort(ends, count, sizeof *ends, rising);
            for (int i = 0; i + 1 < count; i += 2)
                for (int x = ends[i] < 0 ? 0 : ends[i]; x < ends[i + 1] && x < s->width; x++) {
                    double depth = depth_of(f, x, y);
                    int at = y * s->width + x;
                    if (depth <= depths[at]) continue;
                    depths[at] = depth;
#ifdef SLIP_light_at_corners
                    if (s->has_normals) gouraud(s, f, x, y, out + 3 * at);
                    else sample(s, f, x, y, out + 3 * at);
#else
                    (void)gouraud, sample(s, f, x, y, out + 3 * at);
#endif
                }
        }
        free(ends);
    }
    free(depths);
}
