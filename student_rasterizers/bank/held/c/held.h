/* held.h: screen files in, P6 pictures out, for the C programs of the held-out set. A program defines paint(). Slips are -DSLIP_name. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct { double a, b, c, low, high; int flat; } Ramp;
typedef struct { double x, y, over_w, w, own[6]; int is_cut; } Point;
typedef struct { int points, surface, ramps; double opacity[3]; Ramp ramp[7]; Point *point; } Face;
typedef struct { double ambient[3], diffuse[3], ks, power; } Surface;
typedef struct { double at[3], light[3]; } Lamp;
typedef struct {
    int width, height, faces, lamps, has_normals;
    double background[3], line[3];
    Face *face;
    Surface *surface;
    Lamp *lamp;
} Sheet;

/* `out` has three numbers a sample, and holds the background. */
static void paint(const Sheet *sheet, double *out);

static double ramp_at(const Ramp *r, double x, double y) {
    return r->flat ? r->c : (double)(float)(r->a * x + r->b * y + r->c);
}

static double within(const Ramp *r, double value) { return value < r->low ? r->low : value > r->high ? r->high : value; }

static double depth_of(const Face *f, int x, int y) { return within(&f->ramp[0], ramp_at(&f->ramp[0], x + 0.5, y + 0.5)); }

static void numbers(char **words, double *into, int count) {
    for (int i = 0; i < count; i++) into[i] = atof(words[i]);
}

static int next_sheet(Sheet *s) {
    static char text[4096];
    Point *pool = NULL;
    memset(s, 0, sizeof *s);
    while (fgets(text, sizeof text, stdin)) {
        char *word[40] = {0};
        int n = 0;
        for (char *w = strtok(text, " \t\r\n"); w && n < 40; w = strtok(NULL, " \t\r\n")) word[n++] = w;
        if (n == 0 || word[0][0] == '#') continue;
        const char *key = word[0];
        Face *last = s->faces ? &s->face[s->faces - 1] : NULL;
        if (!strcmp(key, "size")) s->width = atoi(word[1]), s->height = atoi(word[2]);
        else if (!strcmp(key, "background")) numbers(word + 1, s->background, 3);
        else if (!strcmp(key, "varying")) s->has_normals = !strcmp(word[1], "normal_eye");
        else if (!strcmp(key, "line_color")) numbers(word + 1, s->line, 3);
        else if (!strcmp(key, "lights")) s->lamp = calloc(atoi(word[1]) + 1, sizeof *s->lamp);
        else if (!strcmp(key, "surfaces")) s->surface = calloc(atoi(word[1]) + 1, sizeof *s->surface);
        else if (!strcmp(key, "polygons")) s->face = calloc(atoi(word[1]) + 1, sizeof *s->face);
        else if (!strcmp(key, "vertices")) pool = calloc(atoi(word[1]) + 1, sizeof *pool);
        else if (!strcmp(key, "light")) {
            Lamp *l = &s->lamp[s->lamps++];
            numbers(word + 1, l->at, 3), numbers(word + 4, l->light, 3);
        } else if (!strcmp(key, "surface")) {
            Surface *f = &s->surface[atoi(word[1])];
            numbers(word + 2, f->ambient, 3), numbers(word + 5, f->diffuse, 3);
            f->ks = atof(word[8]), f->power = atof(word[9]);
        } else if (!strcmp(key, "polygon")) {
            Face *f = &s->face[s->faces++];
            f->surface = atoi(word[3]), f->point = pool;
            numbers(word + 4, f->opacity, 3);
        } else if (!strcmp(key, "plane") && last && last->ramps < 7) {
            double v[5];
            numbers(word + 2, v, 5);
            last->ramp[last->ramps++] = (Ramp){v[0], v[1], v[2], v[3], v[4], !strcmp(word[7], "constant")};
        } else if (!strcmp(key, "vertex") && last) {
            Point *p = pool++;
            p->x = atof(word[1]), p->y = atof(word[2]), p->over_w = atof(word[3]), p->w = atof(word[6]);
            p->is_cut = strcmp(word[7], "original") != 0;
            numbers(word + 8, p->own, n - 8 < 6 ? n - 8 : 6);
            last->points++;
        } else if (!strcmp(key, "end")) return 1;
    }
    return 0;
}

int main(void) {
    Sheet s;
    while (next_sheet(&s)) {
        size_t count = 3 * (size_t)s.width * s.height;
        double *out = calloc(count + 3, sizeof *out);
        for (size_t i = 0; i < count; i++) out[i] = s.background[i % 3];
        paint(&s, out);
        printf("P6\n%d %d\n255\n", s.width, s.height);
        for (size_t i = 0; i < count; i++) putchar((int)(fmin(fmax(out[i], 0), 1) * 255 + 0.5));
        fflush(stdout);
        free(out);
        if (s.faces) free(s.face[0].point);
        free(s.face), free(s.surface), free(s.lamp);
    }
    return 0;
}
