/* sbuffer.c: scan line by scan line; a row is a list of visible segments from left to right, and every polygon's segments are put in
   where they are nearer. No depth is kept: two segments are compared by their planes. Lab watkins. */
#include "fresh.h"

typedef struct Segment { int from, to, polygon; struct Segment *next; } Segment;

static Segment *row_list, *pool;
static int used, pool_size;
static long (*corner)[2];
static int *first_row, *end_row;

static long up_div(long a, long b) { return a / b + (a % b > 0); }

static Segment *segment(int from, int to, int number, Segment *next) {
    Segment *s = &pool[used++];
    s->from = from, s->to = to, s->polygon = number, s->next = next;
    return s;
}

/* Whether the new polygon is in front of the old one at a sample. */
static int wins(int new, int old, int x, int y) {
    double a = depth_at(&polygon[new], x, y), b = depth_at(&polygon[old], x, y);
    if (SLIP(farther_wins)) return a < b;
    if (SLIP(depth_at_the_edge_of_samples)) {
        const Plane *p = &polygon[new].plane[0], *q = &polygon[old].plane[0];
        a = p->a * x + p->b * y + p->c, b = q->a * x + q->b * y + q->c;
    }
    if (SLIP(depth_of_corners)) a = vertex[polygon[new].first].inverse_w, b = vertex[polygon[old].first].inverse_w;
    return a > b || (SLIP(later_of_equals) && a == b);
}

/* The first column of from ... to - 1 where the answer is no longer that at `from`; `to` if it stays. */
static int change(int new, int old, int from, int to, int y) {
    int is_in_front = wins(new, old, from, y);
    if (SLIP(compared_at_the_left)) return to;
    if (wins(new, old, to - 1, y) == is_in_front) return to;
    if (SLIP(crossing_in_the_middle)) return (from + to) / 2;
    int low = from, high = to - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (wins(new, old, middle, y) == is_in_front) low = middle;
        else high = middle;
    }
    return SLIP(crossing_a_column_late) ? high + 1 : high;
}

/* Puts from ... to - 1 of a polygon into the list of the row. */
static void insert(int from, int to, int number, int y) {
    Segment **at = &row_list;
    while (from < to && used + 3 <= pool_size) {
        while (*at && (*at)->to <= from) at = &(*at)->next;
        Segment *old = *at;
        if (!old || to <= old->from) {
            *at = segment(from, to, number, old);
            return;
        }
        if (from < old->from) {
            if (!SLIP(gap_left_open)) *at = segment(from, old->from, number, old), at = &(*at)->next;
            from = old->from;
            continue;
        }
        int end = to < old->to ? to : old->to;
        int middle = change(number, old->polygon, from, end, y);
        if (wins(number, old->polygon, from, y)) {
            Segment *rest = old->next;
            if (middle < old->to && !SLIP(right_rest_lost)) rest = segment(middle, old->to, old->polygon, rest);
            Segment *mine = segment(from, middle, number, rest);
            old->to = from;
            if (SLIP(left_rest_lost)) old->to = old->from;
            old->next = mine, at = &mine->next;
        }
        from = middle;
    }
}

static int by_column(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* Segments of a polygon on a row, by its crossings with the row of centers. */
static void scan(int number, int y, int *crossing) {
    const Polygon *p = &polygon[number];
    long center = 256L * y + 128;
    if (SLIP(row_above)) center -= 128;
    int count = 0;
    for (int i = 0; i < p->count; i++) {
        const long *a = corner[p->first + i], *b = corner[p->first + (i + 1) % p->count];
        if (a[1] > b[1]) {
            const long *other = a;
            a = b, b = other;
        }
        int is_crossed = a[1] <= center && center < b[1];
        if (SLIP(both_ends_count)) is_crossed = a[1] <= center && center <= b[1] && a[1] != b[1];
        if (SLIP(neither_end_counts)) is_crossed = a[1] < center && center < b[1];
        if (!is_crossed) continue;
        long height = b[1] - a[1];
        crossing[count++] = (int)up_div((a[0] - 128) * height + (center - a[1]) * (b[0] - a[0]), 256 * height);
    }
    if (!SLIP(crossings_unsorted)) qsort(crossing, count, sizeof *crossing, by_column);
    if (SLIP(first_and_last_crossing) && count > 2) crossing[1] = crossing[count - 1], count = 2;
    for (int i = 0; i + 1 < count; i += SLIP(every_pair) ? 1 : 2) {
        if (SLIP(last_column_too)) insert(crossing[i], crossing[i + 1] + 1 > width ? width : crossing[i + 1] + 1, number, y);
        else insert(crossing[i], crossing[i + 1], number, y);
    }
}

/* Rows that a polygon can reach, and corners in 1/256 sample. */
static void prepare(void) {
    for (int i = 0; i < vertices; i++) {
        corner[i][0] = lround(vertex[i].x * 256), corner[i][1] = lround(vertex[i].y * 256);
        if (SLIP(nearest_sample)) corner[i][0] = 256 * lround(vertex[i].x), corner[i][1] = 256 * lround(vertex[i].y);
    }
    for (int n = 0; n < polygons; n++) {
        const Polygon *p = &polygon[n];
        long top = corner[p->first][1], bottom = top;
        for (int i = 1; i < p->count; i++) {
            long y = corner[p->first + i][1];
            top = y < top ? y : top, bottom = y > bottom ? y : bottom;
        }
        first_row[n] = (int)up_div(top - 128, 256), end_row[n] = (int)up_div(bottom - 128, 256);
        if (SLIP(bucket_a_row_late)) first_row[n] = (int)up_div(top, 256);
        if (SLIP(leaves_a_row_early)) end_row[n]--;
        if (SLIP(thin_ones_dropped) && end_row[n] - first_row[n] < 2) end_row[n] = first_row[n];
        if (SLIP(rows_of_ends_only) && p->count > 2) first_row[n] = (int)up_div(corner[p->first][1] - 128, 256);
    }
}

static void show(int y) {
    for (const Segment *s = row_list; s; s = s->next) {
        for (int x = s->from; x < s->to; x++) {
            int at = SLIP(color_of_the_left_end) ? s->from : x;
            for (int i = 0; i < 3; i++) picture[3 * ((size_t)y * width + x) + i] = value_at(&polygon[s->polygon], 1 + i, at, y);
        }
    }
}

static void draw(void) {
    corner = room(vertices, sizeof *corner);
    first_row = room(polygons, sizeof *first_row), end_row = room(polygons, sizeof *end_row);
    int *crossing = room(vertices, sizeof *crossing);
    pool_size = SLIP(small_pool) ? 8 : 4 * width + 4 * vertices + 64;
    pool = room(pool_size, sizeof *pool);
    prepare();
    for (int y = SLIP(first_row_skipped) ? 1 : 0; y < height; y++) {
        row_list = NULL, used = 0;
        for (int n = 0; n < polygons; n++) {
            if (first_row[n] <= y && y < end_row[n]) scan(n, y, crossing);
        }
        show(y);
    }
    free(corner), free(first_row), free(end_row), free(crossing), free(pool);
}
