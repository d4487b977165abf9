/* shade.c: Phong's light at every sample, from corner values: shares of areas, over w, and divided again. Polygons are fans of triangles,
   a sample is in one when an odd number of the fan's triangles hold it. Lab phong. */
#include "fresh.h"

static float *depths;

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void make_unit(double *v) {
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3 && length > 0; i++) v[i] /= length;
}

/* Light of one lamp, added to a color. */
static void add_light(const Surface *s, const Light *l, const double *normal, const double *point, double *color) {
    double to_light[3], view[3], mirrored[3], half[3];
    for (int i = 0; i < 3; i++) to_light[i] = l->at[i] - point[i], view[i] = -point[i];
    if (SLIP(light_direction_turned)) for (int i = 0; i < 3; i++) to_light[i] = -to_light[i];
    double distance = sqrt(dot(to_light, to_light));
    if (!SLIP(light_not_unit)) make_unit(to_light);
    if (!SLIP(view_not_unit)) make_unit(view);
    if (SLIP(view_along_the_axis)) view[0] = view[1] = 0, view[2] = -1;
    if (SLIP(view_away_from_the_eye)) for (int i = 0; i < 3; i++) view[i] = -view[i];
    double cosine = dot(normal, to_light);
    if (SLIP(both_sides_lit)) cosine = fabs(cosine);
    if (SLIP(dark_side_takes_light) == 0 && cosine <= 0 && !SLIP(highlight_in_the_dark)) return;
    for (int i = 0; i < 3; i++) {
        mirrored[i] = (SLIP(mirrored_once) ? 1 : 2) * cosine * normal[i] - to_light[i];
        half[i] = to_light[i] + view[i];
    }
    make_unit(half);
    double toward = SLIP(halfway_vector) ? dot(normal, half) : dot(mirrored, view);
    if (SLIP(highlight_of_the_light)) toward = dot(to_light, view);
    double shine = SLIP(power_halved) ? s->power / 2 : SLIP(power_fixed) ? 10 : s->power;
    double gloss = s->ks * pow(toward > 0 ? toward : 0, shine);
    if (SLIP(no_highlight)) gloss = 0;
    if (SLIP(highlight_by_cosine)) gloss *= cosine;
    if (SLIP(highlight_in_the_dark) && cosine < 0) cosine = 0;
    double fade = SLIP(fades_with_distance) ? 1 / distance : SLIP(fades_with_square) ? 1 / (distance * distance) : 1;
    for (int i = 0; i < 3; i++) {
        double tint = SLIP(highlight_in_the_surface_color) ? s->diffuse[i] : 1;
        double lamp = SLIP(lamps_white) ? 1 : l->color[i];
        color[i] += fade * lamp * (s->diffuse[i] * cosine + tint * gloss);
        if (SLIP(ambient_for_each_light)) color[i] += s->ambient[i];
    }
}

static void light_of(const Surface *s, double *normal, const double *point, double *color) {
    if (!SLIP(normal_not_unit)) make_unit(normal);
    if (SLIP(normal_turned_to_the_eye) && dot(normal, point) > 0) for (int i = 0; i < 3; i++) normal[i] = -normal[i];
    for (int i = 0; i < 3; i++) color[i] = SLIP(no_ambient) || SLIP(ambient_for_each_light) ? 0 : s->ambient[i];
    int count = SLIP(first_light_only) && lights > 1 ? 1 : lights;
    for (int i = 0; i < count; i++) add_light(s, &light[i], normal, point, color);
    for (int i = 0; i < 3 && SLIP(mean_of_lights) && lights; i++) color[i] = s->ambient[i] + (color[i] - s->ambient[i]) / lights;
}

/* Twice the signed area of three points. */
static double area(double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/* Twice the area with the sample's center; 0 counts as the side that the tie rule gives: down the left, along the top. */
static int is_right_of(const Vertex *a, const Vertex *b, double x, double y) {
    double side = a->y < b->y ? area(a->x, a->y, b->x, b->y, x, y) : area(b->x, b->y, a->x, a->y, x, y);
    return SLIP(ties_to_the_left) ? side < 0 : side <= 0;
}

static int is_inside(const Vertex *corner[3], double x, double y) {
    int is_odd = 0;
    for (int i = 0; i < 3; i++) {
        const Vertex *a = corner[i], *b = corner[(i + 1) % 3];
        if ((a->y <= y) != (b->y <= y)) is_odd ^= is_right_of(a, b, x, y);
    }
    return is_odd;
}

/* Six values at a sample; of the polygon's first three corners that span an area. */
static void values_at(const Polygon *p, double x, double y, double *value) {
    const Vertex *v = &vertex[p->first];
    int j = 1;
    while (j + 2 < p->count && area(v[0].x, v[0].y, v[j].x, v[j].y, v[j + 1].x, v[j + 1].y) == 0) j++;
    const Vertex *c[3] = {&v[0], &v[j], &v[j + 1]};
    double whole = area(c[0]->x, c[0]->y, c[1]->x, c[1]->y, c[2]->x, c[2]->y), sum = 0, share[3];
    for (int i = 0; i < 3; i++) {
        const Vertex *a = c[(i + 1) % 3], *b = c[(i + 2) % 3];
        share[i] = whole == 0 ? i == 0 : area(x, y, a->x, a->y, b->x, b->y) / whole;
        if (!SLIP(shares_on_the_screen)) share[i] *= c[i]->inverse_w;
        sum += share[i];
    }
    for (int n = 0; n < 6; n++) {
        double over = 0, low = INFINITY, high = -INFINITY;
        for (int i = 0; i < 3; i++) over += share[i] * c[i]->value[n];
        for (int i = 0; i < p->count; i++) low = fmin(low, v[i].value[n]), high = fmax(high, v[i].value[n]);
        value[n] = fmin(fmax(over / sum, low), high);
        if (SLIP(values_of_the_first_corner)) value[n] = v[0].value[n];
        if (SLIP(normal_of_the_first_corner) && n < 3) value[n] = v[0].value[n];
        if (SLIP(point_of_the_first_corner) && n >= 3) value[n] = v[0].value[n];
    }
}

static void color_of(const Polygon *p, int x, int y, double *color) {
    double value[6], here[3];
    if (!has_normals) {
        for (int i = 0; i < 3; i++) color[i] = value_at(p, 1 + i, x, y);
        return;
    }
    double middle = SLIP(asked_at_the_corner_of_samples) ? 0 : 0.5;
    values_at(p, x + middle, y + middle, value);
    memcpy(here, value + 3, sizeof here);
    if (SLIP(point_upside_down)) here[1] = -here[1];
    const Surface *s = &surface[SLIP(first_surface) ? 0 : p->surface];
    light_of(s, value, here, color);
    if (!SLIP(light_at_corners)) return;
    double sum = 0, total[3] = {0, 0, 0};
    for (int i = 0; i < p->count; i++) {
        const Vertex *v = &vertex[p->first + i];
        double normal[3] = {v->value[0], v->value[1], v->value[2]}, own[3];
        light_of(s, normal, v->value + 3, own);
        double share = 1 / (1e-9 + hypot(x + 0.5 - v->x, y + 0.5 - v->y));
        sum += share;
        for (int n = 0; n < 3; n++) total[n] += share * own[n];
    }
    for (int n = 0; n < 3; n++) color[n] = total[n] / sum;
}

static int is_covered(const Polygon *p, int x, int y) {
    const Vertex *v = &vertex[p->first];
    int is_odd = 0;
    for (int i = 1; i + 1 < p->count; i++) {
        const Vertex *corner[3] = {&v[0], &v[i], &v[i + 1]};
        is_odd ^= is_inside(corner, x + 0.5, y + 0.5);
    }
    return is_odd;
}

static void draw(void) {
    depths = room((size_t)width * height, sizeof *depths);
    for (const Polygon *p = polygon; p < polygon + polygons; p++) {
        int left = width, right = 0, top = height, bottom = 0;
        for (const Vertex *v = &vertex[p->first]; v < &vertex[p->first + p->count]; v++) {
            left = fmin(left, floor(v->x)), right = fmax(right, ceil(v->x));
            top = fmin(top, floor(v->y)), bottom = fmax(bottom, ceil(v->y));
        }
        for (int y = top; y < bottom; y++) {
            for (int x = left; x < right; x++) {
                size_t at = (size_t)y * width + x;
                if (!is_covered(p, x, y)) continue;
                float depth = (float)depth_at(p, x, y);
                if (depth <= depths[at]) continue;
                double color[3];
                color_of(p, x, y, color);
                if (!is_opaque(p)) keep(p, x, y, depth, color);
                else depths[at] = depth, memcpy(picture + 3 * at, color, sizeof color);
            }
        }
    }
    blend(depths);
    free(depths);
}
