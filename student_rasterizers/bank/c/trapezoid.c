/* Polygons cut into trapezoids at the heights of their corners; in each, edges are sorted by x and filled in pairs. */
#include "bank.h"

static int by_number(const void *a, const void *b) {
    double d = *(const double *)a - *(const double *)b;
    return d < 0 ? -1 : d > 0;
}

typedef struct { const corner *upper, *lower; double x_middle; } side;
static int by_middle(const void *a, const void *b) {
    double d = ((const side *)a)->x_middle - ((const side *)b)->x_middle;
    return d < 0 ? -1 : d > 0;
}

/* First whole k with k + 0.5 >= x. */
static int first_center(double x) {
#if defined SLIP_half_up
    return (int)floor(x + 0.5);
#elif defined SLIP_cast
    return (int)x;
#elif defined SLIP_cast_and_one
    return (int)x + 1;
#else
    return (int)ceil(x - 0.5);
#endif
}

static int column(const side *e, int y, int first_row) {
    double x0 = e->upper->x, y0 = e->upper->y, dx = e->lower->x - x0, dy = e->lower->y - y0;
#if defined SLIP_slope_in_float_summed
    float x = (float)(x0 + (first_row + 0.5 - y0) * dx / dy), slope = (float)((int)(dx / dy * 64) / 64.0);
    for (int row = first_row; row < y; row++) x += slope;
    return first_center(x);
#elif defined SLIP_from_the_corner_not_the_center
    return first_center(x0 + (y - floor(y0)) * dx / dy);
#elif defined SLIP_slope_turned_over
    return first_center(x0 + (y + 0.5 - y0) * (dx != 0 ? dy / dx : 0));
#elif defined SLIP_half_up || defined SLIP_cast || defined SLIP_cast_and_one
    return first_center(x0 + (y + 0.5 - y0) * dx / dy);
#else
    /* The quotient is rounded; whole numbers decide. */
    int k = first_center(x0 + (y + 0.5 - y0) * dx / dy);
    while ((k - 0.5 - x0) * dy >= (y + 0.5 - y0) * dx) k--;
    while ((k + 0.5 - x0) * dy < (y + 0.5 - y0) * dx) k++;
    (void)first_row;
    return k;
#endif
}

static void fill(const scene *s, const polygon *g, const side *l, const side *r, int top, int bottom, double *rgb, double *depths) {
    for (int y = top; y < bottom; y++) {
        int from = column(l, y, top), to = column(r, y, top);
#ifdef SLIP_ends_not_clipped
        to += 1; /* and nobody looks whether that is still on this row */
#endif
#ifdef SLIP_never_less_than_one
        if (to == from) to++;
        if (to > s->width) to = s->width;
#endif
        for (int x = from; x < to; x++) {
            double d = depth_at(g, x, y), *kept = &depths[y * s->width + x];
#ifdef SLIP_depth_summed
            double first = depth_at(g, from, y);
            d = first + (x - from) * (float)((int)(g->planes[0].a * 256) / 256.0);
#endif
            if (is_glass(s, g, x, y, d) || d <= *kept) continue;
            *kept = d;
            put(s, g, x, y, rgb);
        }
    }
}

static void draw(const scene *s, double *rgb) {
    double *depths = calloc((size_t)s->width * s->height + 99, sizeof *depths);
    for (int n = 0; n < s->polygon_count; n++) {
        const polygon *g = &s->polygons[n];
        const corner *c = &s->corners[g->first];
        double heights[256];
        side sides[256];
        int levels = g->count < 256 ? g->count : 256;
        for (int k = 0; k < levels; k++) heights[k] = c[k].y;
        qsort(heights, levels, sizeof *heights, by_number);
        for (int k = 0; k + 1 < levels; k++) {
            double upper = heights[k], lower = heights[k + 1];
            int top = (int)ceil(upper - 0.5), bottom = (int)ceil(lower - 0.5), count = 0;
#ifdef SLIP_rows_half_up
            top = (int)floor(upper + 0.5), bottom = (int)floor(lower + 0.5);
#endif
#ifdef SLIP_row_of_the_middle_corner_lost
            if (k > 0) top++;
#endif
#ifdef SLIP_lower_part_lost
            if (k > 0) break;
#endif
            if (upper == lower) continue;
            for (int i = 0; i < g->count; i++) {
                const corner *a = &c[i], *b = &c[(i + 1) % g->count];
                if (a->y > b->y) { const corner *t = a; a = b; b = t; }
                if (a->y > upper || b->y < lower || a->y == b->y) continue;
                side one = {a, b, a->x + ((upper + lower) / 2 - a->y) * (b->x - a->x) / (b->y - a->y)};
                sides[count++] = one;
            }
#ifndef SLIP_left_and_right_not_sorted
            qsort(sides, count, sizeof *sides, by_middle);
#endif
#ifdef SLIP_outermost_sides
            if (count > 2) sides[1] = sides[count - 1], count = 2;
#endif
            for (int i = 0; i + 1 < count; i += 2) fill(s, g, &sides[i], &sides[i + 1], top, bottom, rgb, depths);
        }
    }
    lay_glass(depths, rgb);
    free(depths);
}
