/* The z-buffer of zbuffer_lib.c as a program: v2 screen files on standard input, P6 pictures on standard output.
   gcc -O2 -std=c11 -ffp-contract=off -o zbuffer zbuffer.c zbuffer_lib.c -lm */
#include "farop.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *zeros(size_t count, size_t size) {
    void *memory = calloc(count + 1, size);
    if (!memory) { fprintf(stderr, "no memory for %zu records\n", count); exit(1); }
    return memory;
}

static const char *RULES[] = {"constant", "blocks", "samples", "double", "scanline"};

static void read_plane(const char *line, farop_plane *plane) {
    char rule[16] = "";
    sscanf(line, "plane %*s %lf %lf %lf %lf %lf %15s", &plane->a, &plane->b, &plane->c, &plane->low, &plane->high, rule);
    for (int number = 0; number < 5; number++)
        if (!strcmp(rule, RULES[number])) plane->rule = number;
}

static void read_vertex(const char *line, farop_vertex *v) {
    double *n = v->values;
    sscanf(line, "vertex %lf %lf %lf %*s %*s %lf %*s %lf %lf %lf %lf %lf %lf", &v->x, &v->y, &v->inverse_w, &v->w, n, n + 1,
           n + 2, n + 3, n + 4, n + 5);
}

/* Reads one file up to its `end`; 0 when there is none. Memory is that of the counts in the head. */
static int read_list(FILE *in, farop_list *list, farop_vertex **vertices, farop_plane **planes, farop_polygon **polygons) {
    static char line[1 << 16];
    uint32_t vertex_room = 0, polygon_room = 0;
    memset(list, 0, sizeof *list);
    list->abi = FAROP_ABI;
    while (fgets(line, sizeof line, in)) {
        char word[24] = "", name[24] = "";
        sscanf(line, "%23s %23s", word, name);
        if (!strcmp(word, "size")) sscanf(line, "size %u %u", &list->width, &list->height);
        if (!strcmp(word, "background"))
            sscanf(line, "background %f %f %f", list->background, list->background + 1, list->background + 2);
        if (!strcmp(word, "interpolation")) list->perspective = !strcmp(name, "perspective");
        if (!strcmp(word, "precision")) list->double_precision = !strcmp(name, "double");
        if (!strcmp(word, "varying")) {
            list->varying = !strcmp(name, "color") ? FAROP_COLOR : !strcmp(name, "nothing") ? FAROP_NOTHING : FAROP_NORMAL_EYE;
            list->value_count = list->varying * 3;
            list->planes_each = list->varying ? 1 + list->value_count : 0;
        }
        if (!strcmp(word, "polygons")) *polygons = zeros(polygon_room = (uint32_t)strtoul(name, 0, 10), sizeof **polygons);
        if (!strcmp(word, "polygons")) *planes = zeros((size_t)polygon_room * list->planes_each, sizeof **planes);
        if (!strcmp(word, "vertices")) *vertices = zeros(vertex_room = (uint32_t)strtoul(name, 0, 10), sizeof **vertices);
        if (!strcmp(word, "polygon") && list->polygon_count < polygon_room) {
            farop_polygon *polygon = &(*polygons)[list->polygon_count++];
            sscanf(line, "polygon %*s %u %u %f %f %f %u", &polygon->vertex_count, &polygon->surface, polygon->opacity,
                   polygon->opacity + 1, polygon->opacity + 2, &polygon->line);
            polygon->first_vertex = list->vertex_count;
            polygon->first_plane = list->plane_count;
        }
        if (!strcmp(word, "plane") && list->plane_count < polygon_room * list->planes_each)
            read_plane(line, &(*planes)[list->plane_count++]);
        if (!strcmp(word, "vertex") && list->vertex_count < vertex_room) read_vertex(line, &(*vertices)[list->vertex_count++]);
        if (!strcmp(word, "end")) return 1;
    }
    return 0;
}

static void write_picture(const farop_target *target, FILE *out) {
    size_t count = (size_t)target->width * target->height * 3;
    unsigned char *levels = zeros(count, 1);
    for (size_t i = 0; i < count; i++) levels[i] = (unsigned char)lround(fmin(fmax(255.0 * target->rgb[i], 0.0), 255.0));
    fprintf(out, "P6\n%u %u\n255\n", target->width, target->height);
    fwrite(levels, 1, count, out);
    fflush(out);
    free(levels);
}

int main(void) {
    farop_list list;
    farop_vertex *vertices = NULL;
    farop_plane *planes = NULL;
    farop_polygon *polygons = NULL;
    while (read_list(stdin, &list, &vertices, &planes, &polygons)) {
        list.vertices = vertices, list.planes = planes, list.polygons = polygons;
        size_t samples = (size_t)list.width * list.height;
        farop_target target = {list.width, list.height, zeros(samples * 3, sizeof(float)), zeros(samples, sizeof(double))};
        for (size_t i = 0; i < samples * 3; i++) target.rgb[i] = list.background[i % 3];
        farop_draw(&list, &target);
        write_picture(&target, stdout);
        free(target.rgb), free(target.depth), free(vertices), free(planes), free(polygons);
    }
    return 0;
}
