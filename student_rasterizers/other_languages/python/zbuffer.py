"""A z-buffer in plain Python: v2 screen files on standard input, P6 pictures on standard output.

    farop render spd:gears:1 --size 128 -r "exec:python3 zbuffer.py" -o gears.png

Samples: x to the right, y down; sample (x, y) has its center at (x + 0.5, y + 0.5). docs/screen-files.md says what each record means.
Messages go to standard error: print(..., file=sys.stderr). Standard output holds the picture and nothing else.
"""
import struct
import sys
from math import ceil

FLOAT = struct.Struct("f")


def single(number):
    """The nearest number in single precision: farop's planes are rounded so, and depths are compared to the last bit."""
    return FLOAT.unpack(FLOAT.pack(number))[0]


class Plane:
    def __init__(self, words):  # name a b c low high rule
        self.a, self.b, self.c, self.low, self.high = (float(word) for word in words[1:6])
        self.rule = words[6]

    def at(self, x, y):
        """The value at the center of sample (x, y). a * x + b * y + c is nearly the same; this has the same last bit."""
        if self.rule == "constant":
            return self.c
        if self.rule != "blocks":
            value = self.a * (x + 0.5) + self.b * (y + 0.5) + self.c
            return single(value) if self.rule == "samples" else value
        left, top = x & ~15, y & ~15  # of the block of 16 x 16 samples
        start = single(self.a * (left + 0.5) + self.b * (top + 0.5) + self.c)
        step = single(single(single(self.a) * (x - left)) + single(single(self.b) * (y - top)))
        return single(start + step)

    def clamp(self, value):
        return self.low if value < self.low else self.high if value > self.high else value


class Polygon:
    def __init__(self):
        self.corners = []
        self.planes = []  # depth, then red, green, blue

    def depth(self, x, y):
        return self.planes[0].clamp(self.planes[0].at(x, y))

    def color(self, x, y, depth, perspective):
        color = []
        for plane in self.planes[1:4]:
            value = plane.at(x, y)
            if perspective and plane.rule not in ("constant", "scanline"):
                value = single(value / depth) if plane.rule != "double" else value / depth
            color.append(plane.clamp(value))
        return color

    def spans(self):
        """Covered samples: row, first column, column behind the last. Even-odd, edges by the tie rule."""
        ys = [y for _, y in self.corners]
        for row in range(int(min(ys)), ceil(max(ys))):
            columns = []
            for (x1, y1), (x2, y2) in zip(self.corners, self.corners[1:] + self.corners[:1]):
                if y1 > y2:
                    x1, y1, x2, y2 = x2, y2, x1, y1
                if y1 <= row + 0.5 < y2:  # at or below the upper end, strictly above the lower end
                    columns.append(first_column(x1, y1, x2 - x1, y2 - y1, row))
            columns.sort()
            for first, end in zip(columns[::2], columns[1::2]):
                yield row, first, end


def first_column(x, y, dx, dy, row):
    """The first column whose center is at or right of an edge, on the center line of a row."""
    down = row + 0.5 - y
    column = ceil(x + down * dx / dy - 0.5)
    # The division was rounded; products of these numbers are exact, so this is where it is decided.
    while (column - 0.5 - x) * dy >= down * dx:
        column -= 1
    while (column + 0.5 - x) * dy < down * dx:
        column += 1
    return column


def read_list(lines):
    """The next file of the stream: its head as a dictionary, and its polygons. None at the end of the stream."""
    head, polygons = {}, []
    for line in lines:
        word = line.split("#")[0].split()
        if not word:
            continue
        if word[0] == "polygon":
            polygons.append(Polygon())
        elif word[0] == "plane":
            polygons[-1].planes.append(Plane(word[1:]))
        elif word[0] == "vertex":
            polygons[-1].corners.append((float(word[1]), float(word[2])))
        elif word[0] == "end":
            return head, polygons
        else:
            head[word[0]] = word[1:]
    return None


def draw(head, polygons):
    """One color a sample, rows from the top."""
    width, height = (int(word) for word in head["size"])
    background = [float(word) for word in head["background"]]
    perspective = head["interpolation"][0] == "perspective"
    depths = [[0.0] * width for _ in range(height)]
    colors = [[background] * width for _ in range(height)]
    for polygon in polygons:
        for y, first, end in polygon.spans():
            for x in range(first, end):
                depth = polygon.depth(x, y)
                if depth > depths[y][x]:  # strictly: of equal depths the first polygon stays
                    depths[y][x] = depth
                    colors[y][x] = polygon.color(x, y, depth, perspective)
    return width, height, colors


def write_picture(width, height, colors, out):
    out.write(b"P6\n%d %d\n255\n" % (width, height))
    for row in colors:
        out.write(bytes(int(min(max(255.0 * single(channel), 0.0), 255.0) + 0.5) for color in row for channel in color))
    out.flush()


if __name__ == "__main__":
    while (read := read_list(sys.stdin)) is not None:
        write_picture(*draw(*read), sys.stdout.buffer)
