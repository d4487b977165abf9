"""Rows as long whole numbers, a bit a sample: every edge turns round all bits from its crossing to the right border. What is left is even-odd.
Labs coverage, zbuffer, gouraud. Screen files in, P6 pictures out; the slip is the program's argument."""
import struct
import sys

SLIP = sys.argv[1] if len(sys.argv) > 1 else "none"


def slip(name):
    return SLIP == name


def single(number):
    return struct.unpack("f", struct.pack("f", number))[0]


class Plane:
    def __init__(self, words):
        self.a, self.b, self.c, self.low, self.high = map(float, words[1:6])
        if slip("slopes_exchanged"):
            self.a, self.b = self.b, self.a
        self.rule = words[6]

    def at(self, x, y):
        if self.rule == "constant":
            return self.c
        if self.rule != "blocks":
            return single(self.a * (x + 0.5) + self.b * (y + 0.5) + self.c)
        left, top = x // 16 * 16, y // 16 * 16
        start = single(self.a * (left + 0.5) + self.b * (top + 0.5) + self.c)
        across, down = single(single(self.a) * (x - left)), single(single(self.b) * (y - top))
        if slip("rest_of_the_block_forgotten"):
            down = 0
        return single(start + single(across + down))

    def within(self, value):
        return min(max(value, self.low), self.high)


class Face:
    def __init__(self, words):
        self.opacity = [float(word) for word in words[3:6]]
        self.planes, self.corners, self.weights, self.values = [], [], [], []

    def depth(self, x, y):
        if slip("depth_is_w"):
            return 1000 - 1 / self.planes[0].within(self.planes[0].at(x, y))
        if slip("mean_depth"):
            return sum(self.weights) / len(self.weights)
        depth = self.planes[0].within(self.planes[0].at(x, y))
        return round(depth, 2) if slip("depth_rounded") else depth

    def color(self, x, y):
        if slip("nearest_corner"):
            return self.values[self.nearest(x + 0.5, y + 0.5)]
        if slip("by_distance"):
            return self.spread(x + 0.5, y + 0.5)
        if slip("mean_of_corners"):
            return [sum(value[i] for value in self.values) / len(self.values) for i in range(3)]
        if slip("one_color_a_face"):
            return self.values[-1]
        depth, color = self.planes[0].within(self.planes[0].at(x, y)), []
        for plane in self.planes[1:4]:
            value = plane.at(x, y)
            if plane.rule != "constant":
                value = plane.within(single(value * depth if slip("times_depth") else value / depth))
            color.append(value)
        if slip("saturated"):
            return [round(4 * channel) / 4 for channel in color]
        return color[::-1] if slip("blue_first") else color

    def nearest(self, x, y):
        return min(range(len(self.corners)), key=lambda i: (self.corners[i][0] - x) ** 2 + (self.corners[i][1] - y) ** 2)

    def spread(self, x, y):
        shares = [1 / (1e-6 + ((a - x) ** 2 + (b - y) ** 2) ** 0.5) for a, b in self.corners]
        return [sum(share * value[i] for share, value in zip(shares, self.values)) / sum(shares) for i in range(3)]

    def outline(self):
        """Corners in 1/256 sample."""
        places = [(round(x * 256), round(y * 256)) for x, y in self.corners]
        if slip("quarter_samples"):
            places = [(round(x * 4) * 64, round(y * 4) * 64) for x, y in self.corners]
        if slip("whole_rows"):
            places = [(x, y // 256 * 256) for x, y in places]
        if slip("around_the_middle"):
            from math import atan2
            u, v = (sum(place) / len(places) for place in zip(*places))
            places.sort(key=lambda place: atan2(place[1] - v, place[0] - u))
        if slip("box"):
            (left, right), (top, bottom) = ((min(line), max(line)) for line in zip(*places))
            places = [(left, top), (right, top), (right, bottom), (left, bottom)]
        return places


def up(a, b):
    """a / b, rounded up."""
    return -(-a // b)


def rows_between(y0, y1):
    """Rows whose centers are at or below y0, and above y1."""
    if slip("lower_end_belongs"):
        return range((y0 - 128) // 256 + 1, (y1 - 128) // 256 + 1)
    if slip("rows_from_ends"):
        return range(y0 // 256, y1 // 256)
    return range(up(y0 - 128, 256), up(y1 - 128, 256))


def masks(face, width, height):
    """The covered samples of each row, the first one in the highest bit."""
    rows = [0] * height
    places = face.outline()
    pairs = list(zip(places, places[1:] + places[:1]))
    if slip("not_closed"):
        pairs.pop()
    for (x0, y0), (x1, y1) in pairs:
        if y0 > y1:
            if slip("rising_edges_lost"):
                continue
            x0, y0, x1, y1 = x1, y1, x0, y0
        if slip("steep_only") and abs(x1 - x0) > 4 * (y1 - y0):
            continue
        for y in rows_between(y0, y1):
            down = 256 * y + 128 - y0
            across = (x0 - 128) * (y1 - y0) + down * (x1 - x0)
            column = up(across, 256 * (y1 - y0))
            if slip("right_of_the_edge"):
                column = across // (256 * (y1 - y0)) + 1
            if slip("column_to_the_nearest"):
                column = round(x0 / 256 + down * (x1 - x0) / (y1 - y0) / 256)
            bits = (1 << max(width - column, 0)) - 1
            if slip("last_bit_short"):
                bits &= ~1
            if slip("turned_on_only"):
                rows[y] |= bits
            elif 0 <= y < height:
                rows[y] ^= bits
    if slip("first_row_lost"):
        rows[0] = 0
    return rows


def columns(bits, width):
    """Columns whose bits are set."""
    while bits:
        high = bits.bit_length() - 1
        yield width - 1 - high
        bits ^= 1 << high


def blended(layers, behind):
    """Layers, the nearest first."""
    for _, _, color, opacity in sorted(layers, key=lambda layer: (layer[0], -layer[1])):
        if slip("shares_turned_round"):
            opacity = [1 - share for share in opacity]
        behind = [share * own + (1 - share) * old for share, own, old in zip(opacity, color, behind)]
    return behind


OLD = {}


def paint(width, height, background, faces):
    """One color a sample, row by row."""
    depths = [[0.0] * width for _ in range(height)]
    if slip("one_row_of_depths"):
        depths = [[0.0] * width] * height
    if slip("depths_of_before"):
        depths = OLD.setdefault((width, height), depths)
    if slip("black_background"):
        background = [0.0] * 3
    colors = [background] * (width * height)
    kept = [[] for _ in colors]
    if slip("sorted_by_first_corner"):
        faces = sorted(faces, key=lambda face: face.weights[0])
    if slip("from_the_last"):
        faces = faces[::-1]
    for number, face in enumerate(faces):
        clear = min(face.opacity) < 1 and not slip("opaque_glass")
        for y, bits in enumerate(masks(face, width, height)):
            for x in columns(bits, width):
                depth, at = face.depth(x, y), y * width + x
                if slip("no_depth_test") or slip("sorted_by_first_corner"):
                    depth = depths[y][x] + 1e-6
                if slip("rounded_up_a_hair") and not depth > depths[y][x] * 0.98:
                    continue
                if not slip("rounded_up_a_hair") and not depth > depths[y][x]:
                    continue
                if clear:
                    kept[at].append((depth, number, face.color(x, y), face.opacity))
                else:
                    depths[y][x], colors[at] = depth, face.color(x, y)
    for at, layers in enumerate(kept):
        colors[at] = blended([layer for layer in layers if layer[0] > depths[at // width][at % width]], colors[at])
    return colors


def level(light):
    if slip("levels_cut"):
        return int(max(min(light, 1), 0) * 255)
    if slip("of_256"):
        return min(int(light * 256), 255)
    if slip("display_curve"):
        light = max(light, 0) ** (1 / 2.2)
    if slip("bright_ones_wrap"):
        return int(light * 256) & 255
    return int(max(min(light, 1), 0) * 255 + 0.5)


def write(width, height, colors):
    if slip("left_is_right"):
        colors = [color for y in range(height) for color in reversed(colors[y * width:(y + 1) * width])]
    if slip("columns_first"):
        colors = [colors[(n % height) * width + n // height] for n in range(width * height)]
    levels = bytes(level(channel) for color in colors for channel in color)
    sys.stdout.buffer.write(b"P6\n%d %d\n255\n" % (width, height) + levels)
    sys.stdout.buffer.flush()


def main():
    width = height = 0
    background, faces = [0.0] * 3, []
    for line in sys.stdin:
        word, *rest = line.split() or ["#"]
        if word == "size":
            width, height = map(int, rest)
        elif word == "background":
            background = [float(number) for number in rest]
        elif word == "polygon":
            faces.append(Face(rest))
        elif word == "plane":
            faces[-1].planes.append(Plane(rest))
        elif word == "vertex":
            numbers = rest[:6]
            faces[-1].corners.append((float(numbers[0]), float(numbers[1])))
            faces[-1].weights.append(float(numbers[2]))
            faces[-1].values.append([float(number) for number in rest[7:10]])
        elif word == "end":
            write(width, height, paint(width, height, background, faces))
            faces = []


main()
