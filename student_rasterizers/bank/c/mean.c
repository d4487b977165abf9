/* A z-buffer of A x A samples a pixel that takes its own mean: the picture has the size of the pixels. */
#define OWN_MEAN
#define mean_of(s, rgb) own_mean(s, rgb)
static double *own_mean(void *s, double *rgb);
#include "bank.h"

/* A sample is in when an odd number of edges pass it on the left. */
static int inside(const corner *c, int count, double px, double py) {
    int odd = 0;
    for (int i = 0; i < count; i++) {
        const corner *a = &c[i], *b = &c[(i + 1) % count];
        if ((a->y > py) == (b->y > py)) continue;
        if (b->y < a->y) { const corner *t = a; a = b; b = t; }
        odd ^= (px - a->x) * (b->y - a->y) >= (py - a->y) * (b->x - a->x);
    }
    return odd;
}

static void draw(const scene *s, double *rgb) {
    double *depths = calloc((size_t)s->width * s->height + 1, sizeof *depths);
    for (int n = 0; n < s->polygon_count; n++)
        for (int y = 0; y < s->height; y++)
            for (int x = 0; x < s->width; x++) {
                const polygon *g = &s->polygons[n];
                double d = depth_at(g, x, y), *kept = &depths[y * s->width + x], px = x + 0.5, py = y + 0.5;
#ifdef SLIP_no_offset_down
                py = y / s->samples * s->samples + s->samples / 2.0;
#endif
                if (!inside(&s->corners[g->first], g->count, px, py) || d <= *kept) continue;
                *kept = d;
                put(s, g, x, y, rgb);
            }
    free(depths);
}

static double *own_mean(void *of, double *rgb) {
    scene *s = of;
    int a = s->samples, w = s->width / a, h = s->height / a;
    for (int n = 0; n < w * h * 3; n++) {
        int c = n % 3, x = n / 3 % w, y = n / 3 / w;
        double sum = 0;
        for (int j = 0; j < a; j++)
            for (int i = 0; i < a; i++) {
                double light = rgb[3 * ((y * a + j) * s->width + x * a + i) + c];
#if defined SLIP_divided_before_adding
                sum += (int)(255 * light) / (a * a) / 255.0;
#elif defined SLIP_sum_in_a_byte
                sum = (unsigned char)(int)(255 * sum + 255 * light + 0.5) / 255.0;
#elif defined SLIP_always_two
                if (i < 2 && j < 2) sum += light;
#elif defined SLIP_middle_sample
                if (i == a / 2 && j == a / 2) sum = light * a * a;
#elif defined SLIP_darkest_sample
                sum = (i | j) == 0 ? light * a * a : fmin(sum, light * a * a);
#elif defined SLIP_diagonal_only
                if (i == j) sum += light * a;
#else
                sum += light;
#endif
            }
#ifdef SLIP_always_two
        rgb[n] = sum / (a > 1 ? 4 : 1);
#else
        rgb[n] = sum / (a * a);
#endif
    }
    s->width = w, s->height = h;
    return rgb;
}
