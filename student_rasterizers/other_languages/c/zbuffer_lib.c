/* A z-buffer as a library. gcc -O2 -std=c11 -ffp-contract=off -shared -fPIC -o zbuffer.so zbuffer_lib.c -lm */
#include "farop.h"
#include <math.h>

/* Crossings of one scan line that are kept; a polygon with more of them at one height loses the rest. */
enum { MOST = 256 };

/* First column whose center is at or right of the edge a -> b on the center line of row y. The numbers are small
   multiples of 1/256, so products and sums are exact, and the one division decides nothing: it is checked. */
static int32_t first_column(const farop_vertex *a, const farop_vertex *b, int32_t y) {
    double dx = b->x - a->x, dy = b->y - a->y, down = y + 0.5 - a->y;
    int32_t column = (int32_t)ceil(a->x + down * dx / dy - 0.5);
    while ((column - 0.5 - a->x) * dy >= down * dx) column--; /* the center before is at or right, too */
    while ((column + 0.5 - a->x) * dy < down * dx) column++;  /* this center is still left */
    return column;
}

/* Columns where edges cross the center line of row y, from left to right. Inside is between first and second, third and fourth, ... */
static int crossings(const farop_list *list, const farop_polygon *polygon, int32_t y, int32_t *columns) {
    const farop_vertex *corner = &list->vertices[polygon->first_vertex];
    int count = 0;
    for (uint32_t i = 0; i < polygon->vertex_count; i++) {
        const farop_vertex *a = &corner[i], *b = &corner[(i + 1) % polygon->vertex_count];
        if (a->y > b->y) { const farop_vertex *upper = b; b = a; a = upper; }
        /* At or below the upper end, strictly above the lower one: the tie rule. Level edges cross nothing. */
        if (!(a->y <= y + 0.5 && y + 0.5 < b->y) || count == MOST) continue;
        int32_t column = first_column(a, b, y);
        int at = count++;
        for (; at > 0 && columns[at - 1] > column; at--) columns[at] = columns[at - 1];
        columns[at] = column;
    }
    return count;
}

static void draw_sample(const farop_list *list, const farop_polygon *polygon, int32_t x, int32_t y, farop_target *target) {
    double depth = farop_depth(list, polygon, x, y);
    uint64_t sample = (uint64_t)y * target->width + (uint64_t)x;
    /* Strictly nearer: of equal depths the first polygon stays. */
    if (depth <= target->depth[sample]) return;
    target->depth[sample] = depth;
    for (uint32_t channel = 0; channel < 3; channel++)
        target->rgb[sample * 3 + channel] = (float)farop_value(list, polygon, channel, x, y, depth);
}

void farop_draw(const farop_list *list, farop_target *target) {
    if (list->abi != FAROP_ABI || list->varying != FAROP_COLOR) return; /* flat and Gouraud lists */
    for (uint32_t p = 0; p < list->polygon_count; p++) {
        const farop_polygon *polygon = &list->polygons[p];
        const farop_vertex *corner = &list->vertices[polygon->first_vertex];
        double top = corner[0].y, bottom = corner[0].y;
        for (uint32_t i = 1; i < polygon->vertex_count; i++) {
            top = fmin(top, corner[i].y);
            bottom = fmax(bottom, corner[i].y);
        }
        for (int32_t y = (int32_t)top; y < bottom; y++) {
            int32_t columns[MOST];
            int count = crossings(list, polygon, y, columns);
            for (int i = 0; i + 1 < count; i += 2)
                for (int32_t x = columns[i]; x < columns[i + 1]; x++) draw_sample(list, polygon, x, y, target);
        }
    }
}
