/* Lines column by column (row by row where they are steep), with the diamond rule at both ends. */
#include "bank.h"

static void dot(const scene *s, double *rgb, int x, int y) {
    if (x < 0 || y < 0 || x >= s->width || y >= s->height) return;
    for (int c = 0; c < 3; c++) rgb[3 * (y * s->width + x) + c] = s->background[0] + s->background[1] + s->background[2] > 1.5 ? 0 : 1;
}

static int in_diamond(double x, double y, int px, int py) { return fabs(x - px - 0.5) + fabs(y - py - 0.5) < 0.5; }

static void line(const scene *s, double *rgb, double ax, double ay, double bx, double by) {
    int steep = fabs(by - ay) > fabs(bx - ax);
#ifdef SLIP_never_steep
    steep = 0;
#endif
#ifdef SLIP_steep_exchanged
    steep = !steep;
#endif
#ifdef SLIP_ends_rounded
    ax = floor(ax) + 0.5, ay = floor(ay) + 0.5, bx = floor(bx) + 0.5, by = floor(by) + 0.5;
#endif
    if (steep) { double t = ax; ax = ay, ay = t, t = bx, bx = by, by = t; }
    if (ax == bx) return;
    double slope = (by - ay) / (bx - ax);
#ifdef SLIP_slope_as_int
    slope = (int)slope;
#endif
#ifdef SLIP_always_down
    slope = fabs(slope);
#endif
#ifdef SLIP_backward_lost
    if (bx < ax) return;
#endif
    int from = (int)floor(fmin(ax, bx)), to = (int)floor(fmax(ax, bx));
#ifdef SLIP_last_column_lost
    to--;
#endif
    for (int x = from; x <= to; x++) {
        /* The point of the line in the middle of the column, or the end that falls short of it. */
        double middle = fmin(fmax(x + 0.5, fmin(ax, bx)), fmax(ax, bx));
        double at = ay + (middle - ax) * slope;
        int y = (int)floor(at);
#ifdef SLIP_rounded_row
        y = (int)floor(at + 0.5);
#endif
#ifdef SLIP_row_above
        y = (int)ceil(at) - 2;
#endif
        int whole = middle == x + 0.5;
        int px = steep ? y : x, py = steep ? x : y;
        double mx = steep ? at : middle, my = steep ? middle : at, ex = steep ? by : bx, ey = steep ? bx : by;
#if defined SLIP_both_ends || defined SLIP_ends_rounded
        (void)whole, (void)ex, (void)ey, (void)mx, (void)my;
#else
        if (!whole && !in_diamond(mx, my, px, py)) continue;
        if (in_diamond(ex, ey, px, py)) continue;
#endif
        dot(s, rgb, px, py);
#ifdef SLIP_two_wide
        dot(s, rgb, px, py + 1);
#endif
    }
}

static void draw(const scene *s, double *rgb) {
    for (int n = 0; n < s->polygon_count; n++) {
        const corner *c = &s->corners[s->polygons[n].first];
        int count = s->polygons[n].count;
#ifdef SLIP_first_edge_lost
        for (int k = 1; k < count; k++) {
#elif defined SLIP_every_other_edge
        for (int k = 0; k < count; k += 2) {
#else
        for (int k = 0; k < count; k++) {
#endif
            const corner *a = &c[k], *b = &c[(k + 1) % count];
            line(s, rgb, a->x, a->y, b->x, b->y);
        }
    }
}
