/* active.c: one polygon after another, by a list of active edges. Corners are in 1/256 sample; an edge carries its crossing with the row of
   centers as a whole number of 1/256 and a remainder over its height, so that nothing drifts. Labs coverage, zbuffer, gouraud. */
#include "fresh.h"

typedef struct Edge {
    long first, last;              /* rows: first, and behind the last */
    long x, rest, height;          /* the crossing is x + rest / height */
    long step, step_rest;
    struct Edge *next;
} Edge;

static float *depths;
static Edge *waiting, *active;

static long floor_div(long a, long b) { return a / b - (a % b < 0); }

/* The first row or column whose center is at or behind a place in 1/256. */
static long behind(long place) { return floor_div(place - 128 + 255, 256); }

static void enter(long x0, long y0, long x1, long y1, Edge *e) {
    if (y0 > y1) {
        long x = x0, y = y0;
        x0 = x1, y0 = y1, x1 = x, y1 = y;
    }
    e->first = behind(y0), e->last = behind(y1);
    if (SLIP(upper_end_excluded)) e->first = floor_div(y0 + 128, 256), e->last = floor_div(y1 + 128, 256);
    if (SLIP(one_row_too_many)) e->last++;
    if (SLIP(last_row_left_out)) e->last--;
    if (e->first >= e->last || y0 == y1) return;
    e->height = y1 - y0;
    long down = SLIP(starts_at_the_corner) ? 0 : (e->first * 256 + 128 - y0) * (x1 - x0);
    e->x = x0 + floor_div(down, e->height), e->rest = down - floor_div(down, e->height) * e->height;
    e->step = floor_div(256 * (x1 - x0), e->height), e->step_rest = 256 * (x1 - x0) - e->step * e->height;
    if (SLIP(remainder_dropped)) e->step_rest = 0;
    if (SLIP(slope_in_whole_samples)) e->step = (x1 - x0) / e->height * 256, e->step_rest = 0;
    e->next = waiting, waiting = e;
}

static int is_left(const Edge *a, const Edge *b) { return a->x != b->x ? a->x < b->x : a->rest * b->height < b->rest * a->height; }

/* Puts an edge in its place from left to right. */
static void sort_in(Edge *e) {
    Edge **at = &active;
    while (*at && !is_left(e, *at)) at = &(*at)->next;
    e->next = *at, *at = e;
}

/* Edges that begin at this row come in. */
static void begin(long row) {
    for (Edge **at = &waiting; *at;) {
        Edge *e = *at;
        if (e->first > row) {
            at = &e->next;
            continue;
        }
        *at = e->next;
        sort_in(e);
    }
}

/* Edges that end go, the others move to the next row and are sorted anew. */
static void go_on(long row) {
    Edge *old = active, **last = &active;
    active = NULL;
    while (old) {
        Edge *e = old;
        old = e->next;
        if (e->last <= row + 1) continue;
        e->x += e->step, e->rest += e->step_rest;
        if (e->rest >= e->height) e->x++, e->rest -= e->height;
        if (SLIP(sorted_only_once)) *last = e, last = &e->next, e->next = NULL;
        else sort_in(e);
    }
}

static double w_at(const Polygon *p, int x, int y) {
    /* w by the same plane that 1/w has, through the corners: not linear on the screen. */
    const Vertex *v = &vertex[p->first];
    double area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y);
    if (area == 0) return v[0].w;
    double s = ((x + 0.5 - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (y + 0.5 - v[0].y)) / area;
    double t = ((v[1].x - v[0].x) * (y + 0.5 - v[0].y) - (x + 0.5 - v[0].x) * (v[1].y - v[0].y)) / area;
    return v[0].w + s * (v[1].w - v[0].w) + t * (v[2].w - v[0].w);
}

static void color_of(const Polygon *p, int x, int y, double color[3]) {
    for (int i = 0; i < 3; i++) {
        const Plane *q = &p->plane[1 + i];
        color[i] = value_at(p, 1 + i, x, y);
        if (SLIP(not_divided) && q->rule != CONSTANT) color[i] = within(q, plane_at(q, x, y));
        if (SLIP(divided_by_the_first_corner) && q->rule != CONSTANT) color[i] = within(q, plane_at(q, x, y) * vertex[p->first].w);
    }
    if (SLIP(green_from_red)) color[1] = color[0];
}

static void put(const Polygon *p, int x, int y, int start) {
    size_t at = SLIP(rows_as_long_as_columns) ? ((size_t)y * height + x) % ((size_t)width * height) : (size_t)y * width + x;
    float depth = (float)depth_at(p, SLIP(depth_of_the_run) ? start : x, y);
    if (SLIP(w_instead)) depth = 1 / (float)w_at(p, x, y);
    if (SLIP(depth_in_a_byte)) depth = (float)(int)(depth * 255 + 0.5f) / 255;
    if (SLIP(depth_of_the_corner)) depth = (float)vertex[p->first].inverse_w;
    if (SLIP(no_center_in_depth)) depth = (float)within(&p->plane[0], p->plane[0].a * x + p->plane[0].b * y + p->plane[0].c);
    int is_nearer = SLIP(last_of_equals) ? depth >= depths[at] : depth > depths[at];
    if (SLIP(cleared_to_one)) is_nearer = depth < depths[at];
    double color[3];
    color_of(p, SLIP(color_of_the_run) ? start : x, y, color);
    if (SLIP(depth_kept_anyway) && !is_nearer) depths[at] = depth;
    if (!is_nearer) return;
    if (!is_opaque(p) && !SLIP(blended_at_once) && !SLIP(glass_hides)) {
        keep(p, x, y, depth, color);
        return;
    }
    for (int i = 0; i < 3; i++) {
        double share = SLIP(glass_hides) ? 1 : p->opacity[i];
        picture[3 * at + i] += share * (color[i] - picture[3 * at + i]);
    }
    if (SLIP(depth_not_kept)) return;
    if (is_opaque(p) || SLIP(glass_hides)) depths[at] = depth;
}

static void fill(const Polygon *p, long row) {
    for (Edge *left = active; left && left->next; left = left->next->next) {
        Edge *right = left->next;
        long from = behind(left->x + (left->rest > 0)), to = behind(right->x + (right->rest > 0));
        if (SLIP(columns_rounded_down)) from = floor_div(left->x, 256), to = floor_div(right->x, 256);
        if (SLIP(right_end_too)) to++;
        if (SLIP(left_tie_out)) from = floor_div(left->x + 128, 256), to = floor_div(right->x + 128, 256);
        if (SLIP(outermost_pair)) while (right->next) right = right->next, to = behind(right->x + (right->rest > 0));
        for (long x = from; x < to && x < width; x++) {
            if (x >= 0 && row < height) put(p, (int)x, (int)row, (int)from);
        }
        if (SLIP(outermost_pair)) return;
    }
}

static long fixed(double place) {
    long whole = lround(place * 256);
    return SLIP(sixteen_bits) ? (short)whole : whole;
}

static void draw_polygon(const Polygon *p) {
    Edge *edges = room(p->count, sizeof *edges);
    int count = SLIP(four_corners_at_most) && p->count > 4 ? 4 : p->count;
    for (int i = 0; i < count; i++) {
        const Vertex *a = &vertex[p->first + i], *b = &vertex[p->first + (i + 1) % count];
        enter(fixed(a->x), fixed(a->y), fixed(b->x), fixed(b->y), &edges[i]);
    }
    for (long row = 0; row < height && (waiting || active); row++) {
        begin(row);
        fill(p, row);
        go_on(row);
    }
    waiting = active = NULL;
    free(edges);
}

static void draw(void) {
    size_t samples = (size_t)width * height;
    depths = room(samples, sizeof *depths);
    for (size_t i = 0; i < samples && SLIP(cleared_to_one); i++) depths[i] = 1;
    for (const Polygon *p = polygon; p < polygon + polygons; p++) draw_polygon(p);
    blend(depths);
    free(depths);
}
