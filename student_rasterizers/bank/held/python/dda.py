"""Lines by steps along the longer direction and a slope (DDA), from column center to column center; ends by their diamonds."""
from math import ceil, floor

from held import sheets, slip, write


def diamond_of(x, y):
    """The sample in whose diamond a point lies, or None."""
    for i in (floor(x) - 1, floor(x), floor(x) + 1):
        for j in (floor(y) - 1, floor(y), floor(y) + 1):
            dx, dy = x - i - 0.5, y - j - 0.5
            away = abs(dx) + abs(dy)
            if away < 0.5 or away == 0.5 and (dy < 0 or dy == 0 and dx < 0):
                return i, j
    return None


def line(start, end):
    """Samples from start to end."""
    (x0, y0), (x1, y1) = start, end
    if start == end:
        return
    is_steep = abs(y1 - y0) > abs(x1 - x0)
    turn = (lambda p, q: (q, p)) if is_steep else (lambda p, q: (p, q))
    (p0, q0), (p1, q1) = turn(x0, y0), turn(x1, y1)
    first, last = diamond_of(x0, y0), diamond_of(x1, y1)
    if first and first != last:
        yield first
    slope = (q1 - q0) / (p1 - p0)
    if slip("slope_of_whole_numbers"):
        slope = (q1 - q0) // (p1 - p0)
    if slip("slope_inverted") and slope:
        slope = 1 / slope
    low, high = ceil(min(p0, p1) - 0.5), floor(max(p0, p1) - 0.5)
    if slip("one_step_short") and high > low:
        high -= 1
    across = q0 + (low + 0.5 - p0) * slope
    if slip("no_prestep"):
        across = q0 if p0 < p1 else q1
    for p in range(low, high + 1):
        # A product instead of a sum keeps the last bit.
        q = across + (p - low) * slope
        if slip("across_kept_whole"):
            q = across = int(across) + (slope if p > low else 0)
        if slip("across_up"):
            q += 0.999
        sample = turn(p, floor(q))
        if sample != last:
            yield sample


for sheet in sheets():
    colors = [sheet.background] * (sheet.width * sheet.height)
    for face in sheet.faces:
        ends = face.corners[1:] + face.corners[:1]
        if slip("open_outline"):
            ends = face.corners[1:]
        if slip("fan_from_the_first"):
            ends = face.corners[:1] * len(face.corners)
        for start, end in zip(face.corners, ends):
            for x, y in line(start, end):
                if 0 <= x < sheet.width and 0 <= y < sheet.height:
                    colors[y * sheet.width + x] = sheet.line_color
    write(sheet.width, sheet.height, colors)
