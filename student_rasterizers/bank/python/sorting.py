"""No depth buffer: at every sample the polygons that cover it are sorted, and the nearest shows."""
from screen import SLIP, odd, run


def key(polygon, x, y):
    if SLIP == "sorted_by_first_corner":
        return polygon.w[0]
    if SLIP == "sorted_by_mean":
        return sum(polygon.w) / len(polygon.w)
    if SLIP == "sorted_by_farthest":
        return max(polygon.w)
    if SLIP == "sorted_as_text":
        return str(100 / polygon.depth(x, y))
    if SLIP == "sorted_at_the_next_sample":
        return -polygon.depth(x + 1, y)
    return -polygon.depth(x, y)


def shown(covering, x, y, background):
    """The nearest; and through glass what is behind."""
    if not covering:
        return background
    if covering[0].is_glass:
        return covering[0].over(x, y, shown(covering[1:], x, y, background))
    return covering[0].color(x, y)


def draw(scene):
    rows = []
    boxes = []
    for polygon in scene.polygons:
        xs, ys = zip(*polygon.corners)
        boxes.append((polygon, min(xs), max(xs), min(ys), max(ys)))
    for y in range(scene.height):
        row = []
        near = [(polygon, left, right) for polygon, left, right, top, bottom in boxes if top <= y + 0.5 <= bottom]
        if not near:
            rows.insert(0 if SLIP == "rows_put_in_front" else y, [scene.background] * scene.width)
            continue
        for x in range(scene.width):
            at = (x + 0.5, y + 0.5)
            covering = [
                polygon for polygon, left, right in near if left <= at[0] <= right and odd(polygon.corners, *at)
            ]
            if SLIP == "never_more_than_two":
                covering = covering[:2]
            if SLIP == "list_turned_round":
                covering.reverse()
            covering.sort(key=lambda polygon: key(polygon, x, y))
            if SLIP == "last_of_the_sorted":
                covering.reverse()
            if SLIP == "second_nearest":
                covering = covering[1:] or covering
            row.append(shown(covering, x, y, scene.background))
        if SLIP == "rows_put_in_front":
            rows.insert(0, row)
        else:
            rows.append(row)
    return rows


if __name__ == "__main__":
    run(draw)
