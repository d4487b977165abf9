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


def draw(scene):
    rows = []
    for y in range(scene.height):
        row = []
        for x in range(scene.width):
            at = (x + 0.5, y + 0.5)
            covering = [polygon for polygon in scene.polygons if odd(polygon.corners, *at)]
            if SLIP == "never_more_than_two":
                covering = covering[:2]
            if SLIP == "list_turned_round":
                covering.reverse()
            covering.sort(key=lambda polygon: key(polygon, x, y))
            if SLIP == "last_of_the_sorted":
                covering.reverse()
            if SLIP == "second_nearest":
                covering = covering[1:] or covering
            row.append(covering[0].color(x, y) if covering else scene.background)
        if SLIP == "rows_put_in_front":
            rows.insert(0, row)
        else:
            rows.append(row)
    return rows


if __name__ == "__main__":
    run(draw)
