"""Row by row: crossings of the row's middle with all sides, filled in pairs, with a depth for every sample."""
from math import ceil

from screen import SLIP, run


def crossings(corners, y):
    """Where sides cross the middle of a row, from left to right."""
    if SLIP == "last_corner_dropped" and len(corners) > 3:
        corners = corners[:-1]
    middle, found, count = y + (1.5 if SLIP == "one_row_ahead" else 0.5), [], len(corners)
    for n in range(count):
        last = 1 if SLIP == "closed_to_the_second" else 0
        (ax, ay), (bx, by) = corners[n], corners[n + 1 if n + 1 < count else last]
        if ay > by:
            ax, ay, bx, by = bx, by, ax, ay
        if ay <= middle < by:
            found.append(ax + (middle - ay) * (bx - ax) / (by - ay))
    return sorted(set(found) if SLIP == "equal_crossings_once" else found)


def depth_of(polygon, x, y):
    if SLIP == "middle_of_the_bounds":
        xs, ys = zip(*polygon.corners)
        return polygon.depth((min(xs) + max(xs) - 1) / 2, (min(ys) + max(ys) - 1) / 2)
    return polygon.depth(x, y)


def color_of(polygon, x, y, first):
    color = polygon.color(x - first if SLIP == "x_from_the_span" else x, y)
    if SLIP == "red_of_the_first_corner":
        color[0] = polygon.values[0][0]
    if SLIP == "half_of_the_first_corner":
        color = [(c + own) / 2 for c, own in zip(color, polygon.values[0])]
    if SLIP == "limits_exchanged":
        color = [min(max(c, max(all)), min(all)) for c, all in zip(color, zip(*polygon.values))]
    return color


def is_nearer(depth, depths, x, y):
    if SLIP == "compared_with_the_left":
        return depth > depths[y][max(x - 1, 0)]
    if SLIP == "texts_of_two_digits":
        return f"{depth:.2f}" > f"{depths[y][x]:.2f}"
    return depth > depths[y][x]


def draw(scene):
    rows = [[scene.background] * scene.width for _ in range(scene.height)]
    depths = [[0.0] * scene.width for _ in range(scene.height)]
    panes = []
    for number, polygon in enumerate(scene.polygons):
        start = int(polygon.corners[0][1]) if SLIP == "from_the_first_corner_down" else 0
        for y in range(start, scene.height):
            found = crossings(polygon.corners, y)
            for left, right in zip(found[::2], found[1::2]):
                first = ceil(left - 0.5)
                for x in range(first, ceil(right - 0.5)):
                    depth = depth_of(polygon, x, y)
                    if polygon.is_glass:
                        panes.append((depth, -number, x, y))
                    elif is_nearer(depth, depths, x, y):
                        depths[y][x] = depth
                        rows[y][x] = color_of(polygon, x, y, first)
    for depth, number, x, y in sorted(panes):
        if depth > depths[y][x]:
            rows[y][x] = scene.polygons[-number].over(x, y, rows[y][x])
    return rows


if __name__ == "__main__":
    run(draw)
