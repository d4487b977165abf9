/* Reads a farop v2 screen file into arrays and says what is in it. cc reader.c -o reader && ./reader FILE.scr
   Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
typedef struct { double x, y, inverse_w, values[6]; } Vertex; /* values: red green blue, or normal and eye */
typedef struct { long first, count, planes; double plane[7][3]; } Polygon; /* a b c; plane 0 is depth */

int main(int argc, char **argv) {
    FILE *file = argc > 1 ? fopen(argv[1], "r") : NULL;
    if (!file) { fprintf(stderr, "usage: reader FILE.scr\n"); return 1; }
    Vertex *vertices = NULL; Polygon *polygons = NULL;
    long width = 0, height = 0, polygon_count = 0, vertex_count = 0, p = -1, v = 0;
    static char line[4096];
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "#")] = 0;
        sscanf(line, "size %ld %ld", &width, &height);
        if (sscanf(line, "polygons %ld", &polygon_count) == 1) polygons = calloc(polygon_count + 1, sizeof *polygons);
        if (sscanf(line, "vertices %ld", &vertex_count) == 1) vertices = calloc(vertex_count + 1, sizeof *vertices);
        if (!strncmp(line, "polygon ", 8) && p + 1 < polygon_count) polygons[++p].first = v;
        if (!strncmp(line, "plane ", 6) && p >= 0 && polygons[p].planes < 7) {
            double *abc = polygons[p].plane[polygons[p].planes++];
            sscanf(line, "plane %*s %lf %lf %lf", abc, abc + 1, abc + 2);
        } else if (!strncmp(line, "vertex ", 7) && p >= 0 && v < vertex_count) {
            Vertex *n = &vertices[v++]; /* x y inverse_w xw yw w edge, then values */
            sscanf(line, "vertex %lf %lf %lf %*s %*s %*s %*s %lf %lf %lf %lf %lf %lf", &n->x, &n->y, &n->inverse_w,
                   n->values, n->values + 1, n->values + 2, n->values + 3, n->values + 4, n->values + 5);
            polygons[p].count++;
        }
    }
    /* Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample. */
    double low[2] = {v ? 1e30 : 0, v ? 1e30 : 0}, high[2] = {0, 0};
    for (long i = 0; i < 2 * v; i++) {
        double at = i % 2 ? vertices[i / 2].y : vertices[i / 2].x;
        low[i % 2] = at < low[i % 2] ? at : low[i % 2];
        high[i % 2] = at > high[i % 2] ? at : high[i % 2];
    }
    printf("size %ld %ld\npolygons %ld\nvertices %ld\n", width, height, p + 1, v);
    printf("x %.6f %.6f\ny %.6f %.6f\n", low[0], high[0], low[1], high[1]);
}
