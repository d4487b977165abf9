"""Reading v2 screen files and writing pictures, for the Python programs of the bank. `SLIP` is what the program was started with."""
import sys

SLIP = sys.argv[1] if len(sys.argv) > 1 else "none"


class Plane:
    def __init__(self, words):
        self.a, self.b, self.c, self.low, self.high = map(float, words[1:6])
        self.constant = words[6] == "constant"

    def at(self, x, y):
        if self.constant:
            return self.c
        return self.a * (x + 0.5) + self.b * (y + 0.5) + self.c

    def clamp(self, value):
        return min(max(value, self.low), self.high)


class Polygon:
    def __init__(self, words):
        self.opacity = [float(word) for word in words[4:7]]
        self.is_glass = self.opacity != [1, 1, 1]
        self.surface, self.planes, self.corners, self.values, self.w = int(words[3]), [], [], [], []

    def depth(self, x, y):
        return self.planes[0].clamp(self.planes[0].at(x, y))

    def value(self, number, x, y):
        plane = self.planes[1 + number]
        if plane.constant:
            return plane.c
        return plane.clamp(plane.at(x, y) / self.depth(x, y))

    def color(self, x, y):
        return [self.value(number, x, y) for number in range(3)]

    def over(self, x, y, behind):
        """Its color at a sample, with what is behind."""
        return [o * c + (1 - o) * b for o, c, b in zip(self.opacity, self.color(x, y), behind)]


class Scene:
    def __init__(self):
        self.polygons, self.lamps, self.surfaces = [], [], []


def read():
    """The next scene on standard input, or None."""
    scene = Scene()
    for line in sys.stdin:
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        key, rest = words[0], words[1:]
        if key == "size":
            scene.width, scene.height = map(int, rest)
            if SLIP == "size_exchanged_inside":
                scene.width, scene.height = scene.height, scene.width
        elif key == "background":
            scene.background = list(map(float, rest))
        elif key == "light":
            scene.lamps.append((list(map(float, rest[:3])), list(map(float, rest[3:6]))))
        elif key == "surface":
            n = list(map(float, rest[1:9]))
            scene.surfaces.append((n[:3], n[3:6], n[6], n[7]))
        elif key == "varying":
            scene.normals = rest[0] == "normal_eye"
        elif key == "polygon":
            scene.polygons.append(Polygon(words))
        elif key == "plane":
            scene.polygons[-1].planes.append(Plane(rest))
        elif key == "vertex":
            last = scene.polygons[-1]
            last.corners.append((float(rest[0]), float(rest[1])))
            last.w.append(float(rest[5]))
            last.values.append(list(map(float, rest[7:])))
        elif key == "end":
            if SLIP == "background_is_gray":
                scene.background = [0.25] * 3
            return scene
    return None


def level(light):
    if SLIP == "levels_of_100":
        return round(min(max(light, 0), 1) * 100) * 255 // 100
    if SLIP == "inverted":
        light = 1 - light
    if SLIP == "srgb":
        light = 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055
    if SLIP == "one_level_less":
        return max(int(min(max(light, 0), 1) * 255 + 0.5) - 1, 0)
    return int(min(max(light, 0), 1) * 255 + 0.5)


def run(draw):
    """Draws scene after scene. `draw` gives one color a sample, a list of rows."""
    out = sys.stdout.buffer
    while (scene := read()) is not None:
        rows = draw(scene)
        width, height = scene.width, scene.height
        if SLIP == "size_exchanged_inside":
            width, height = height, width
        flat = bytes(level(channel) for row in rows for color in row for channel in color)
        out.write(b"P6\n%d %d\n255\n" % (width, height) + flat)
        out.flush()


def odd(corners, px, py):
    """Whether the point is inside: even-odd, left and upper edges belong to it. Products of these numbers are exact."""
    inside = False
    for n, (ax, ay) in enumerate(corners):
        bx, by = corners[n - 1]
        if ay > by:
            ax, ay, bx, by = bx, by, ax, ay
        if ay <= py < by and (px - ax) * (by - ay) >= (py - ay) * (bx - ax):
            inside = not inside
    return inside
