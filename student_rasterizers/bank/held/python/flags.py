"""Edge flags: each edge sets a flag on each row where it passes; along the row, flags turn the inside on and off. A z-buffer."""
from math import ceil, floor

from held import SLIP, color_at, depth_at, edges, ramp, sheets, slip, within, write


def crossing(a, b, y, first):
    """The first column at or right of the edge on row y."""
    (ax, ay), (bx, by) = a, b
    if slip("no_prestep"):
        return ceil(ax + (y - first) * (bx - ax) / (by - ay) - 0.5)
    if slip("whole_slope"):
        return ceil(ax + (y + 0.5 - ay) * ((bx - ax) // (by - ay)) - 0.5)
    if slip("slope_upside_down"):
        return ceil(ax + (y + 0.5 - ay) * ((by - ay) / (bx - ax) if bx != ax else 0) - 0.5)
    x = ax + (y + 0.5 - ay) * (bx - ax) / (by - ay)
    if slip("columns_cut"):
        return floor(x)
    if slip("columns_one_right"):
        return ceil(x - 0.5) + 1
    return ceil(x - 0.5)


def flagged(face, width, height):
    """Row by row, the columns where inside and outside change."""
    rows = {}
    for a, b in edges(face):
        first, last = ceil(a[1] - 0.5), ceil(b[1] - 0.5)
        if slip("rows_cut"):
            first, last = int(a[1]), int(b[1])
        if slip("last_row_too"):
            last += a[1] != b[1]
        if slip("short_edges_are_level") and b[1] - a[1] < 1:
            continue
        for y in range(max(first, 0), min(last, height)):
            rows.setdefault(y, []).append(min(max(crossing(a, b, y, first), 0), width))
    return rows


def spans(face, width, height):
    for y, columns in flagged(face, width, height).items():
        columns.sort()
        if slip("outermost_only"):
            columns = [columns[0], columns[-1]]
        if slip("right_end_included"):
            columns = [x + n % 2 for n, x in enumerate(columns)]
        for left, right in zip(columns[::2], columns[1::2]):
            yield y, left, min(right, width)


def between(face, y, left, right):
    """Colors of a span by its ends' colors and a step a sample."""
    a, b = color_at(face, left + 0.5, y + 0.5), color_at(face, right - 0.5, y + 0.5)
    steps = max(right - left - 1, 1)
    for x in range(left, right):
        if slip("color_steps_in_whole_levels"):
            step = [int((q - p) * 255 / steps) / 255 for p, q in zip(a, b)]
            yield [p + (x - left) * s for p, s in zip(a, step)]
        else:
            yield [p + (q - p) * (x - left) / steps for p, q in zip(a, b)]


def color(face, x, y):
    px, py = x + 0.5, y + 0.5
    if slip("last_corner_everywhere") and face.planes[1][5] != "constant":
        return face.own[-1][:3]
    if slip("red_decides") and face.planes[1][5] != "constant":
        red = color_at(face, px, py)[0]
        first, *_, last = face.own
        share = (red - first[0]) / (last[0] - first[0]) if last[0] != first[0] else 0
        return [p + share * (q - p) for p, q in zip(first, last)]
    if slip("times_w_in_between"):
        # Value / w times w, but w is taken linear on the screen.
        w = w_linear(face, px, py)
        return [p[2] if p[5] == "constant" else within(p, ramp(p, px, py) * w) for p in face.planes[1:4]]
    return color_at(face, px, py)


def w_linear(face, px, py):
    (ax, ay), (bx, by), (cx, cy) = face.corners[:3]
    area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
    if area == 0:
        return face.w[0]
    u = ((px - ax) * (cy - ay) - (cx - ax) * (py - ay)) / area
    v = ((bx - ax) * (py - ay) - (px - ax) * (by - ay)) / area
    return (1 - u - v) * face.w[0] + u * face.w[1] + v * face.w[2]


def depth(face, x, y):
    if slip("depth_of_the_first_corner"):
        return face.over_w[0]
    if slip("w_in_place_of_its_inverse"):
        return round(1 / max(w_linear(face, x + 0.5, y + 0.5), 1e-6), 10)
    if slip("depth_of_the_row_start"):
        return depth_at(face, min(corner[0] for corner in face.corners), y + 0.5)
    return depth_at(face, x + 0.5, y + 0.5)


def draw(sheet):
    width, height = sheet.width, sheet.height
    colors, depths = [sheet.background] * (width * height), [0.0] * (width * height)
    panes = {}
    for face in sheet.faces:
        is_glass = face.opacity != [1, 1, 1]
        for y, left, right in spans(face, width, height):
            stepped = list(between(face, y, left, right)) if SLIP in STEPPED and right > left else None
            for x in range(left, right):
                at, d = y * width + x, depth(face, x, y)
                if is_glass and not slip("glass_is_opaque"):
                    panes.setdefault(at, []).append((-d, face.number, face))
                elif d > depths[at] or slip("ties_to_the_last") and d == depths[at]:
                    if not slip("depth_not_kept"):
                        depths[at] = d
                    colors[at] = stepped[x - left] if stepped else color(face, x, y)
    for at, here in panes.items():
        here.sort(key=lambda pane: pane[:2], reverse=True)
        for minus_depth, _, face in here:
            if -minus_depth > depths[at]:
                front = color(face, at % width, at // width)
                opacity = [1 - o for o in face.opacity] if slip("opacity_is_transparency") else face.opacity
                colors[at] = [o * f + (1 - o) * b for o, f, b in zip(opacity, front, colors[at])]
    return colors


STEPPED = ("color_steps_in_whole_levels", "linear_along_the_span")
for sheet in sheets():
    write(sheet.width, sheet.height, draw(sheet))
