"""Warnock's way: a box of samples that no edge comes near is inside or outside as a whole; any other is quartered."""
from screen import SLIP, odd, run


def is_near(corners, left, top, right, bottom):
    """Whether an edge may come into the box around the centers."""
    for n, (ax, ay) in enumerate(corners):
        bx, by = corners[n - 1]
        if SLIP == "closing_edge_forgotten" and n == 0:
            continue
        if SLIP == "corners_for_edges":
            if left <= ax <= right and top <= ay <= bottom:
                return True
        elif max(ax, bx) >= left and min(ax, bx) <= right and max(ay, by) >= top and min(ay, by) <= bottom:
            return True
    return False


def fill(polygon, put, x, y, width, height):
    """Covers the box of width x height samples from (x, y)."""
    if width <= 0 or height <= 0:
        return
    smallest = 2 if SLIP == "boxes_of_four" else 1
    is_small = width <= smallest and height <= smallest
    if is_small or not is_near(polygon.corners, x + 0.5, y + 0.5, x + width - 0.5, y + height - 0.5):
        at = (x + 0.5, y + 0.5)
        if SLIP == "asked_at_upper_left":
            at = (x, y)
        elif SLIP == "asked_at_the_right":
            at = (x + 1, y + 0.5)
        elif SLIP == "asked_a_quarter_in":
            at = (x + 0.25, y + 0.25)
        if odd(polygon.corners, *at):
            for j in range(height):
                for i in range(width):
                    put(x + i, y + j)
        return
    w, h = (width + 1) // 2, (height + 1) // 2
    rest_w, rest_h = width - w, height - h
    if SLIP == "odd_sizes_cut":
        w, h = max(width // 2, 1), max(height // 2, 1)
        rest_w, rest_h = (w if width > 1 else 0), (h if height > 1 else 0)
    fill(polygon, put, x, y, w, h)
    fill(polygon, put, x + w, y, rest_w, h)
    fill(polygon, put, x, y + h, w, rest_h)
    if SLIP != "fourth_quarter_lost":
        fill(polygon, put, x + w, y + h, rest_w, rest_h)


def draw(scene):
    rows = [[scene.background] * scene.width for _ in range(scene.height)]
    depths = [[0.0] * scene.width for _ in range(scene.height)]
    panes = []
    for number, polygon in enumerate(scene.polygons):
        def put(x, y):
            depth = polygon.depth(x, y)
            if polygon.is_glass:
                panes.append((depth, -number, x, y))
                return
            if SLIP == "depth_rounded":
                depth = round(depth, 1)
            if SLIP == "depth_on_the_row_only":
                depth = polygon.depth(0, y)
            if SLIP == "written_before_tested":
                rows[y][x] = polygon.color(x, y)
            if depth > depths[y][x]:
                depths[y][x] = depth
                rows[y][x] = polygon.color(x, y)
        fill(polygon, put, 0, 0, scene.width, scene.height)
    # Glass after everything opaque, from far to near.
    for depth, number, x, y in sorted(panes):
        if depth > depths[y][x]:
            rows[y][x] = scene.polygons[-number].over(x, y, rows[y][x])
    return rows


if __name__ == "__main__":
    run(draw)
