/* Lines as Bresenham drew them, in whole numbers of 1/256: along the longer direction, one sample a step; ends by their diamonds. */
#include "held.h"

static const Sheet *sheet;
static double *picture;

static void put(long x, long y) {
    if (x < 0 || y < 0 || x >= sheet->width || y >= sheet->height) return;
    memcpy(picture + 3 * (y * sheet->width + x), sheet->line, sizeof sheet->line);
}

static long floored(long a, long b) { return a / b - (a % b != 0 && (a < 0) != (b < 0)); }

/* Whether a point is in the diamond around the center of sample (i, j); of its border the upper sides and the left corner. */
static int in_diamond(long x, long y, long i, long j) {
    long dx = x - 256 * i - 128, dy = y - 256 * j - 128, sum = labs(dx) + labs(dy);
    return sum < 128 || (sum == 128 && (dy < 0 || (dy == 0 && dx < 0)));
}

static void line(long x0, long y0, long x1, long y1) {
    long dx = x1 - x0, dy = y1 - y0;
    int steep = labs(dy) > labs(dx);
#ifdef SLIP_steep_by_columns
    steep = 0;
#endif
#ifdef SLIP_flat_by_rows
    steep = 1;
#endif
#ifdef SLIP_upright_lost
    if (dx == 0) return;
#endif
#ifdef SLIP_leftward_lost
    if (x1 < x0) return;
#endif
    /* p runs along, q across. */
    long p0 = steep ? y0 : x0, q0 = steep ? x0 : y0, dp = steep ? dy : dx, dq = steep ? dx : dy;
#ifdef SLIP_rising_goes_down
    dq = labs(dq);
#endif
    if (dp == 0 && dq == 0) return;
    if (dp == 0) return;
    long p1 = p0 + dp, low = dp > 0 ? p0 : p1, high = dp > 0 ? p1 : p0;
    long first = floored(low - 128 + 255, 256), last = floored(high - 128, 256), skip_p = -99, skip_q = -99;
    /* The diamond of the end is not left; that of the start is, even if its center lies behind. */
    long ei = floored(x1, 256), ej = floored(y1, 256), si = floored(x0, 256), sj = floored(y0, 256);
#ifndef SLIP_end_drawn_too
    for (long i = ei - 1; i <= ei + 1; i++)
        for (long j = ej - 1; j <= ej + 1; j++)
            if (in_diamond(x1, y1, i, j)) skip_p = steep ? j : i, skip_q = steep ? i : j;
#endif
    for (long i = si - 1; i <= si + 1; i++)
        for (long j = sj - 1; j <= sj + 1; j++)
            if (in_diamond(x0, y0, i, j) && !(skip_p == (steep ? j : i) && skip_q == (steep ? i : j))) {
#ifndef SLIP_start_not_drawn
                put(i, j);
#else
                skip_p = steep ? j : i, skip_q = steep ? i : j;
#endif
            }
    for (long p = first; p <= last; p++) {
        /* q = q0 + (center - p0) dq / dp; its sample has q from 256 j (in) to 256 j + 256 (out). */
        long step = (256 * p + 128 - p0) * dq, along = dp;
        if (along < 0) step = -step, along = -along;
        long q = floored(q0 * along + step, 256 * along);
#ifdef SLIP_across_rounded
        q = floored(q0 * along + step + 128 * along, 256 * along);
#endif
        /* The left corner belongs, the right one does not: for steep lines that is the same rule with x across. */
        if (p == skip_p && q == skip_q) continue;
        if (steep) put(q, p);
        else put(p, q);
    }
}

static long whole(double v) {
#if defined SLIP_corners_cut
    return 256 * (long)v + 128;
#elif defined SLIP_corners_rounded
    return 256 * lround(v) + 128;
#else
    return lround(v * 256);
#endif
}

static void paint(const Sheet *s, double *out) {
    sheet = s, picture = out;
    for (int n = 0; n < s->faces; n++) {
        const Face *f = &s->face[n];
        int edges = f->points;
#ifdef SLIP_triangles_only
        if (edges > 3) edges = 3;
#endif
        for (int i = 0; i < edges; i++) {
            const Point *a = &f->point[i], *b = &f->point[(i + 1) % f->points];
            if (!a->is_cut) line(whole(a->x), whole(a->y), whole(b->x), whole(b->y));
        }
    }
}
