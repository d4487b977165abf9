"""Gouraud along scan lines: color / w and 1/w at both ends of a run, from the edges; in between a straight line."""
from math import ceil, floor

from screen import SLIP, run


def ends(polygon, row):
    """Where edges cross the middle of a row: x, 1/w, color / w."""
    found = []
    count = len(polygon.corners)
    middle = row + 0.5
    for n in range(count):
        m = (n + 1) % count
        (ax, ay), (bx, by) = polygon.corners[n], polygon.corners[m]
        if SLIP == "colors_of_sorted_corners":
            order = sorted(range(count), key=lambda k: polygon.corners[k][1])
            colors = {order[k]: polygon.values[k] for k in range(count)}
        else:
            colors = polygon.values
        a, b = (1 / polygon.w[n], colors[n]), (1 / polygon.w[m], colors[m])
        if ay > by:
            ax, ay, bx, by, a, b = bx, by, ax, ay, b, a
        if not ay <= middle < by:
            continue
        share = (middle - ay) / (by - ay)
        if SLIP == "share_from_the_row":
            share = min(max((row - ay) / (by - ay), 0), 1)
        if SLIP == "share_turned_round":
            share = 1 - share
        if SLIP == "share_as_int":
            share = int(share)
        if SLIP == "share_along_x" and bx != ax:
            share = abs((ax + (middle - ay) / (by - ay) * (bx - ax) - bx) / (bx - ax))
        x = ax + (middle - ay) * (bx - ax) / (by - ay)
        over = [[channel * end[0] for channel in end[1]] for end in (a, b)]
        if SLIP == "colors_on_the_screen":
            over = [a[1], b[1]]
        if SLIP == "colors_on_the_edges_only":
            inverse = a[0] + share * (b[0] - a[0])
            over = [[channel * inverse for channel in end[1]] for end in (a, b)]
        found.append((x, a[0] + share * (b[0] - a[0]), [p + share * (q - p) for p, q in zip(*over)]))
    return sorted(found, key=lambda end: end[0])


def draw(scene):
    rows = [[scene.background] * scene.width for _ in range(scene.height)]
    depths = [[0.0] * scene.width for _ in range(scene.height)]
    for polygon in scene.polygons:
        ys = [y for _, y in polygon.corners]
        for y in range(floor(min(ys)), min(ceil(max(ys)), scene.height)):
            crossings = ends(polygon, y)
            for left, right in zip(crossings[::2], crossings[1::2]):
                first, end = ceil(left[0] - 0.5), ceil(right[0] - 0.5)
                for x in range(first, end):
                    t = (x + 0.5 - left[0]) / (right[0] - left[0])
                    if SLIP == "from_the_first_sample":
                        t = (x - first) / (end - first)
                    if SLIP == "to_the_last_sample":
                        t = (x - first) / max(end - 1 - first, 1)
                    depth = left[1] + t * (right[1] - left[1])
                    over = [p + t * (q - p) for p, q in zip(left[2], right[2])]
                    if SLIP == "color_of_the_left_end":
                        over = [p * depth / left[1] for p in left[2]]
                    if depth <= depths[y][x]:
                        continue
                    depths[y][x] = depth
                    color = over if SLIP in ("colors_on_the_screen", "never_divided") else [p / depth for p in over]
                    if SLIP == "red_for_all":
                        color = [color[0]] * 3
                    rows[y][x] = color
    return rows


if __name__ == "__main__":
    run(draw)
