/* Any polygon as a fan of triangles over a stencil: each triangle turns the samples in it over, and odd ones are inside. */
#include "bank.h"

static long long fixed(double x) { return (long long)floor(x * 512 + 0.5); }

/* On which side of a -> b: > 0 inside, and centers on the edge go to left and top edges. */
static int inside(long long ax, long long ay, long long bx, long long by, long long px, long long py) {
    long long e = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
#ifdef SLIP_edges_in_int16
    e = (long long)(short)(bx - ax) * (short)(py - ay) - (long long)(short)(by - ay) * (short)(px - ax);
#endif
    if (e != 0) return e > 0;
#if defined SLIP_top_only
    return by == ay && bx > ax;
#elif defined SLIP_bottom_for_top
    return by < ay || (by == ay && bx < ax);
#else
    return by < ay || (by == ay && bx > ax);
#endif
}

static void turn_over(const scene *s, const corner *a, const corner *b, const corner *c, unsigned char *stencil) {
    long long x[3] = {fixed(a->x), fixed(b->x), fixed(c->x)}, y[3] = {fixed(a->y), fixed(b->y), fixed(c->y)};
    long long area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
#ifdef SLIP_other_winding_lost
    if (area < 0) return;
#endif
    if (area == 0) return;
    if (area < 0) {
        long long t = x[1];
        x[1] = x[2], x[2] = t, t = y[1], y[1] = y[2], y[2] = t;
    }
    double left = fmin(fmin(a->x, b->x), c->x), right = fmax(fmax(a->x, b->x), c->x);
    double top = fmin(fmin(a->y, b->y), c->y), bottom = fmax(fmax(a->y, b->y), c->y);
    for (int py = (int)top; py < s->height && py <= bottom; py++)
        for (int px = (int)left; px < s->width && px <= right; px++) {
            long long cx = px * 512 + 256, cy = py * 512 + 256;
            int in = 1;
            for (int k = 0; k < 3; k++) in = in && inside(x[k], y[k], x[(k + 1) % 3], y[(k + 1) % 3], cx, cy);
#ifdef SLIP_or_for_xor
            stencil[py * s->width + px] |= in;
#else
            stencil[py * s->width + px] ^= in;
#endif
        }
}

static void draw(const scene *s, double *rgb) {
    size_t samples = (size_t)s->width * s->height;
    double *depths = calloc(samples + 1, sizeof *depths);
    unsigned char *stencil = calloc(samples + 1, 1);
#ifdef SLIP_cleared_to_far
    for (size_t i = 0; i < samples; i++) depths[i] = 1e30;
#endif
    for (int n = 0; n < s->polygon_count; n++) {
        const polygon *g = &s->polygons[n];
        const corner *c = &s->corners[g->first];
        double left = s->width, right = 0, top = s->height, bottom = 0;
        for (int k = 0; k < g->count; k++) {
            left = fmin(left, c[k].x), right = fmax(right, c[k].x);
            top = fmin(top, c[k].y), bottom = fmax(bottom, c[k].y);
        }
#ifdef SLIP_fan_ends_early
        for (int k = 1; k + 2 < g->count; k++) turn_over(s, c, c + k, c + k + 1, stencil);
#elif defined SLIP_first_triangle_only
        turn_over(s, c, c + 1, c + 2, stencil);
#elif defined SLIP_strip_for_fan
        for (int k = 0; k + 2 < g->count; k++) turn_over(s, c + k, c + k + 1, c + k + 2, stencil);
#else
        for (int k = 1; k + 1 < g->count; k++) turn_over(s, c, c + k, c + k + 1, stencil);
#endif
        for (int y = (int)top; y < s->height && y <= bottom; y++)
            for (int x = (int)left; x < s->width && x <= right; x++) {
                int at = y * s->width + x;
                double d = depth_at(g, x, y);
#ifdef SLIP_depth_as_int
                d = (int)(d * 10);
#endif
#ifdef SLIP_depth_of_middle
                d = depth_at(g, s->width / 2, s->height / 2);
#endif
                int in = stencil[at];
#ifndef SLIP_stencil_not_cleared
                stencil[at] = 0;
#endif
                if (!in || is_glass(s, g, x, y, d)) continue;
#ifdef SLIP_farther_hides
                if (depths[at] != 0 && d >= depths[at]) continue;
#else
                if (d <= depths[at]) continue;
#endif
#ifndef SLIP_depth_kept_only_once
                depths[at] = d;
#else
                if (depths[at] == 0) depths[at] = d;
#endif
                put(s, g, x, y, rgb);
            }
    }
    lay_glass(depths, rgb);
    free(depths), free(stencil);
}
