/* Edge functions in whole numbers, stepped over quads of 2 x 2 samples; an edge that is passed turns inside and outside round.
   A z-buffer; glass is collected and laid on top at the end. */
#include "held.h"

typedef struct { long ax, ay, by, dx, dy, value; int is_up; } Edge;
typedef struct { int at, order; double depth, color[3], opacity[3]; } Pane;
static Pane *panes;
static int pane_count, pane_room;

static void color_of(const Face *f, int x, int y, double *color) {
    double px = x + 0.5, py = y + 0.5;
#ifdef SLIP_color_of_the_quad
    px = x / 2 * 2 + 0.5, py = y / 2 * 2 + 0.5;
#endif
#ifdef SLIP_color_at_the_corner
    px = x, py = y;
#endif
    double depth = within(&f->ramp[0], ramp_at(&f->ramp[0], px, py));
    for (int c = 0; c < 3; c++) {
        const Ramp *r = &f->ramp[1 + c];
#ifdef SLIP_blue_from_green
        if (c == 2) r = &f->ramp[2];
#endif
        double value = ramp_at(r, px, py);
#ifdef SLIP_divided_twice
        if (!r->flat) value /= depth;
#endif
        color[c] = r->flat ? r->c : within(r, value / depth);
#ifdef SLIP_w_of_the_first_corner
        if (!r->flat) color[c] = within(r, value * f->point[0].w);
#endif
    }
}

static int far_first(const void *left, const void *right) {
    const Pane *a = left, *b = right;
    if (a->at != b->at) return a->at - b->at;
    if (a->depth != b->depth) return a->depth < b->depth ? -1 : 1;
    return b->order - a->order;
}

static void blend(double *out, const double *color, const double *opacity) {
    for (int c = 0; c < 3; c++) out[c] = out[c] * (1 - opacity[c]) + color[c] * opacity[c];
}

static void sample(const Sheet *s, const Face *f, int x, int y, double *depths, double *out) {
    double depth = depth_of(f, x, y), color[3];
    int at = y * s->width + x, is_glass = f->opacity[0] < 1 || f->opacity[1] < 1 || f->opacity[2] < 1;
    color_of(f, x, y, color);
#ifdef SLIP_depth_in_256_steps
    depth = floor(depth * 255) / 255;
#endif
#ifdef SLIP_depth_of_the_middle
    depth = 0;
    for (int i = 0; i < f->points; i++) depth += f->point[i].over_w / f->points;
#endif
#ifdef SLIP_depth_of_the_quad
    depth = depth_of(f, x / 2 * 2, y / 2 * 2);
#endif
    double *kept = &depths[at];
#ifdef SLIP_depth_stride
    kept = &depths[y * s->height + x];
#endif
    if (is_glass) {
#ifdef SLIP_glass_at_once
        if (depth > *kept) blend(out + 3 * at, color, f->opacity);
        return;
#endif
        if (pane_count == pane_room) panes = realloc(panes, (pane_room = 2 * pane_room + 99) * sizeof *panes);
        Pane *p = &panes[pane_count++];
        p->at = at, p->order = (int)(f - s->face), p->depth = depth;
        memcpy(p->color, color, sizeof color), memcpy(p->opacity, f->opacity, sizeof p->opacity);
#ifdef SLIP_glass_hides
        if (depth > *kept) *kept = depth;
#endif
        return;
    }
#ifdef SLIP_depth_always_written
    int is_nearer = depth > *kept;
    *kept = depth;
    if (!is_nearer) return;
#elif defined SLIP_depth_bias
    if (depth <= *kept + 0.02) return;
    *kept = depth;
#else
    if (depth <= *kept) return;
    *kept = depth;
#endif
    memcpy(out + 3 * at, color, sizeof color);
}

static long fixed(double v) { return lround(v * 256); }

/* Inside by the edges left of one sample of the quad: bit 0 of `which` is right, bit 1 is down. */
static int inside(const Edge *edge, int edges, long x, long y, int which) {
    int odd = 0;
    long px = 256 * x + 128, py = 256 * y + 128;
    (void)px;
#ifdef SLIP_all_edges_agree
    int all = 1, none = 1;
    for (int i = 0; i < edges; i++) {
        const Edge *e = &edge[i];
        long value = (px - e->ax) * e->dy - (py - e->ay) * e->dx;
        if (e->is_up) value = -value;
        int owns = e->dy ? e->is_up : !e->is_up;
        if (value < 0 || (value == 0 && owns)) all = 0;
        if (value > 0 || (value == 0 && !owns)) none = 0;
    }
    return all || none;
#endif
    for (int i = 0; i < edges; i++) {
        const Edge *e = &edge[i];
        long value = e->value + (which & 1 ? 256 * e->dy : 0) - (which & 2 ? 256 * e->dx : 0);
#ifdef SLIP_horizontal_edges_inside
        if (e->dy == 0 && e->ay == py && px >= e->ax && px < e->ax + e->dx) return 1;
#endif
        if (e->ay <= py && py < e->by) odd ^= value >= 0;
    }
    return odd;
}

static void face(const Sheet *s, const Face *f, double *depths, double *out) {
    Edge *edge = calloc(f->points + 1, sizeof *edge);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9, area = 0;
    for (int i = 0; i < f->points; i++) {
        const Point *a = &f->point[i], *b = &f->point[(i + 1) % f->points];
        left = fmin(left, a->x), right = fmax(right, a->x), top = fmin(top, a->y), bottom = fmax(bottom, a->y);
        area += (a->x * b->y - b->x * a->y) / 2;
        int is_up = a->y > b->y || (a->y == b->y && a->x > b->x);
        if (is_up) { const Point *t = a; a = b; b = t; }
        edge[i] = (Edge){fixed(a->x), fixed(a->y), fixed(b->y), fixed(b->x) - fixed(a->x), fixed(b->y) - fixed(a->y), 0, is_up};
    }
    int x0 = (int)floor(left), x1 = (int)ceil(right), y0 = (int)floor(top), y1 = (int)ceil(bottom), skip = 0;
#ifdef SLIP_area_below_one
    skip = fabs(area) < 1;
#endif
#ifdef SLIP_box_end_cut
    x1 = (int)right, y1 = (int)bottom;
#endif
    if (x1 > s->width) x1 = s->width;
    if (y1 > s->height) y1 = s->height;
#ifdef SLIP_picture_one_smaller
    if (x1 > s->width - 1) x1 = s->width - 1;
    if (y1 > s->height - 1) y1 = s->height - 1;
#endif
    x0 = x0 < 0 ? 0 : x0 / 2 * 2, y0 = y0 < 0 ? 0 : y0 / 2 * 2;
#ifdef SLIP_half_quads_lost
    x1 = x1 / 2 * 2, y1 = y1 / 2 * 2;
#endif
#ifdef SLIP_first_quad_off
    if (y0 > 0) y0 += 2;
#endif
    if (area == 0) skip = 1;
    for (int i = 0; i < f->points; i++)
        edge[i].value = (256L * x0 + 128 - edge[i].ax) * edge[i].dy - (256L * y0 + 128 - edge[i].ay) * edge[i].dx;
    for (int y = y0; y < y1 && !skip; y += 2) {
        for (int x = x0; x < x1; x += 2) {
            for (int which = 0; which < 4; which++) {
                int sx = x + (which & 1), sy = y + (which >> 1);
                if (sx < x1 && sy < y1 && inside(edge, f->points, sx, sy, which)) sample(s, f, sx, sy, depths, out);
            }
            for (int i = 0; i < f->points; i++) edge[i].value += 512 * edge[i].dy;
        }
        for (int i = 0; i < f->points; i++) {
            long columns = (x1 - x0 + 1) / 2;
#ifdef SLIP_row_starts_one_late
            columns -= 1;
#endif
            edge[i].value -= 512 * edge[i].dy * columns + 512 * edge[i].dx;
        }
    }
    free(edge);
}

static void paint(const Sheet *s, double *out) {
    double *depths = calloc((size_t)(s->width + s->height) * (s->width + s->height) + 1, sizeof *depths);
#ifdef SLIP_cleared_to_a_tenth
    for (int i = 0; i < s->width * s->height; i++) depths[i] = 0.1;
#endif
    for (int n = 0; n < s->faces; n++) face(s, &s->face[n], depths, out);
    qsort(panes, pane_count, sizeof *panes, far_first);
    for (int n = 0; n < pane_count; n++) {
        const Pane *p = &panes[n];
#ifdef SLIP_glass_hides
        if (p->depth < depths[p->at]) continue;
#elif !defined SLIP_glass_without_test
        if (p->depth <= depths[p->at]) continue;
#endif
        blend(out + 3 * p->at, p->color, p->opacity);
    }
    pane_count = 0;
    free(depths);
}
