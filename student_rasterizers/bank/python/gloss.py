"""Phong's light at every sample; a ray through the center of each sample, and a list of what it meets."""
from math import sqrt

from screen import SLIP, odd, run


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    length = sqrt(dot(a, a))
    return [number / length for number in a]


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def light(scene, surface, normal, point):
    ambient, diffuse, ks, power = scene.surfaces[surface]
    n = unit(normal)
    if SLIP == "unit_by_sum":
        n = [number / sum(abs(other) for other in normal) for number in normal]
    if SLIP == "normal_y_reversed":
        n = [n[0], -n[1], n[2]]
    if SLIP == "normal_z_reversed":
        n = [n[0], n[1], -n[2]]
    if SLIP == "normal_in_eight_bits":
        n = [round(number * 8) / 8 for number in n]
    color = list(ambient)
    if SLIP == "ambient_twice":
        color = [2 * channel for channel in ambient]
    for place, lamp in scene.lamps:
        to_lamp = unit(minus(place, point))
        if SLIP == "lamp_at_the_eye":
            to_lamp = unit(minus([0, 0, 0], point))
        to_eye = unit([-number for number in point])
        cosine = dot(n, to_lamp)
        if SLIP == "cosine_squared":
            cosine = cosine * abs(cosine)
        if cosine <= 0:
            continue
        mirrored = [2 * cosine * p - q for p, q in zip(n, to_lamp)]
        if SLIP == "mirror_of_view_at_lamp":
            mirrored = [2 * cosine * p - q for p, q in zip(to_lamp, n)]
        shine = max(dot(mirrored, to_eye), 0) ** power
        if SLIP == "power_times":
            shine = max(dot(mirrored, to_eye), 0) * power
        if SLIP == "power_halved":
            shine = max(dot(mirrored, to_eye), 0) ** (power / 2)
        if SLIP == "highlight_from_normal":
            shine = max(dot(n, to_eye), 0) ** power
        if SLIP == "highlight_times_cosine":
            shine *= cosine
        if SLIP == "ks_forgotten":
            ks = 1
        for c in range(3):
            kd = 1 if SLIP == "kd_forgotten" else diffuse[c]
            color[c] += lamp[c] * (kd * cosine + ks * shine)
        if SLIP == "fades_with_distance":
            d = minus(place, point)
            color = [a + (channel - a) / dot(d, d) for channel, a in zip(color, ambient)]
    return color


def draw(scene):
    rows = []
    for y in range(scene.height):
        row = []
        for x in range(scene.width):
            shown, nearest = None, 0
            for polygon in scene.polygons:
                if odd(polygon.corners, x + 0.5, y + 0.5) and polygon.depth(x, y) > nearest:
                    shown, nearest = polygon, polygon.depth(x, y)
            if shown is None:
                row.append(scene.background)
            elif scene.normals:
                values = [shown.value(number, x, y) for number in range(6)]
                row.append(light(scene, shown.surface, values[:3], values[3:]))
            else:
                row.append(shown.color(x, y))
        rows.append(row)
    return rows


if __name__ == "__main__":
    run(draw)
