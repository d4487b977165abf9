"""No depth buffer: on each row, polygons come and go from left to right; of those that are there, the nearest shows at each sample."""
from math import ceil

from held import color_at, depth_at, edges, sheets, slip, write


def events_of(face, height):
    """Row, column, face: there the polygon comes or goes."""
    for a, b in edges(face):
        first, last = ceil(a[1] - 0.5), ceil(b[1] - 0.5)
        if slip("first_row_lost") and first < last:
            first = ceil(min(y for _, y in face.corners) - 0.5) + 1 if first == ceil(min(y for _, y in face.corners) - 0.5) else first
        if slip("leaves_one_row_late"):
            last += first < last
        for y in range(max(first, 0), min(last, height)):
            x = a[0] + (y + 0.5 - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
            if slip("crossing_of_the_first_row"):
                x = a[0] + (first + 0.5 - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
            yield y, max(ceil(x - 0.5), 0)


def nearest(there, x, y):
    if slip("deepest_shows"):
        return min(there, key=lambda face: depth_at(face, x, y))
    if slip("last_of_equals"):
        return max(there, key=lambda face: (depth_at(face, x, y), face.number))
    return max(there, key=lambda face: (depth_at(face, x, y), -face.number))


def over(face, x, y, there):
    """The color of all that is there, glass too."""
    solid = [other for other in there if other.opacity == [1, 1, 1]]
    color, behind = BACK, 0.0
    if solid:
        face = nearest(solid, x, y)
        color, behind = color_at(face, x, y), depth_at(face, x, y)
    glass = [other for other in there if other.opacity != [1, 1, 1] and depth_at(other, x, y) > behind]
    for pane in sorted(glass, key=lambda other: (depth_at(other, x, y), -other.number)):
        front = color_at(pane, x, y)
        color = [o * f + (1 - o) * b for o, f, b in zip(pane.opacity, front, color)]
    return color


def row(y, events, width):
    """Colors of a row."""
    events.sort(key=lambda event: event[0])
    if slip("events_in_list_order"):
        events.sort(key=lambda event: event[1].number)
    colors, there, number = [BACK] * width, [], 0
    shown = None
    for x in range(width):
        is_changed = False
        while number < len(events) and events[number][0] <= x:
            face, is_changed = events[number][1], True
            if face in there:
                there.remove(face)
                if slip("nothing_behind_what_leaves") and face is shown:
                    shown = None
            else:
                there.append(face)
                if slip("nothing_behind_what_leaves"):
                    shown = nearest([face] + ([shown] if shown else []), x + 0.5, y + 0.5)
            number += 1
        if slip("nothing_behind_what_leaves"):
            if shown:
                colors[x] = color_at(shown, x + 0.5, y + 0.5)
            continue
        px, py = x + 0.5, y + 0.5
        if slip("decided_where_the_span_begins"):
            if is_changed:
                start = px
            px_decide = start if there else px
            if there:
                colors[x] = color_at(nearest(there, px_decide, py), px, py)
        elif slip("decided_in_the_middle"):
            if is_changed:
                end = events[number][0] if number < len(events) else width
                middle = (x + end) / 2
            if there:
                colors[x] = color_at(nearest(there, middle, py), px, py)
        elif slip("decided_by_nearest_corner"):
            if there:
                colors[x] = color_at(max(there, key=lambda face: (max(face.over_w), -face.number)), px, py)
        elif slip("depth_a_row_late"):
            if there:
                colors[x] = color_at(nearest(there, px, py - 1), px, py)
        elif there:
            colors[x] = over(None, px, py, there)
    if slip("left_open_at_the_end") and there:
        pass
    return colors


def draw(sheet):
    rows = {}
    for face in sheet.faces:
        for y, x in events_of(face, sheet.height):
            rows.setdefault(y, []).append((x, face))
    if slip("two_events_a_row"):
        for y, events in rows.items():
            kept = []
            for face in sheet.faces:
                own = sorted((event for event in events if event[1] is face), key=lambda event: event[0])
                kept += own if len(own) < 3 else [own[0], own[-1]]
            rows[y] = kept
    colors = []
    for y in range(sheet.height):
        colors += row(y, rows.get(y, []), sheet.width)
    return colors


for sheet in sheets():
    BACK = sheet.background
    write(sheet.width, sheet.height, draw(sheet))
