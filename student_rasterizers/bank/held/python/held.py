"""Screen files in, pictures out, for the Python programs of the held-out set. The slip is the program's argument."""
import sys
from types import SimpleNamespace

SLIP = sys.argv[1] if len(sys.argv) > 1 else "none"


def slip(name):
    return SLIP == name


def ramp(plane, x, y):
    """a x + b y + c"""
    a, b, c, low, high, rule = plane
    return c if rule == "constant" else a * x + b * y + c


def within(plane, value):
    return min(max(value, plane[3]), plane[4])


def depth_at(face, x, y):
    """1/w at a point."""
    return within(face.planes[0], ramp(face.planes[0], x, y))


def color_at(face, x, y):
    depth, color = depth_at(face, x, y), []
    for plane in face.planes[1:4]:
        value = ramp(plane, x, y)
        color.append(value if plane[5] == "constant" else within(plane, value / depth))
    return color


def sheets():
    """Sheet after sheet from standard input."""
    sheet = SimpleNamespace(faces=[])
    for line in sys.stdin:
        key, *rest = line.split() or ["#"]
        if key == "size":
            sheet.width, sheet.height = map(int, rest)
        elif key == "samples":
            sheet.samples = int(rest[0])
        elif key in ("background", "line_color"):
            setattr(sheet, key, tuple(map(float, rest)))
        elif key == "polygon":
            opacity = list(map(float, rest[3:6]))
            sheet.faces.append(SimpleNamespace(opacity=opacity, planes=[], corners=[], over_w=[], w=[], own=[], number=len(sheet.faces)))
        elif key == "plane":
            sheet.faces[-1].planes.append((*map(float, rest[1:6]), rest[6]))
        elif key == "vertex":
            face = sheet.faces[-1]
            face.corners.append((float(rest[0]), float(rest[1])))
            face.over_w.append(float(rest[2]))
            face.w.append(float(rest[5]))
            face.own.append(list(map(float, rest[7:])))
        elif key == "end":
            yield sheet
            sheet = SimpleNamespace(faces=[])


def write(width, height, colors):
    """A P6 picture; `colors` has one color a sample, row by row."""
    levels = bytes(int(min(max(channel, 0), 1) * 255 + 0.5) for color in colors for channel in color)
    sys.stdout.buffer.write(b"P6\n%d %d\n255\n" % (width, height) + levels)
    sys.stdout.buffer.flush()


def edges(face):
    """Neighbors along the outline, the upper end first."""
    for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
        yield (a, b) if a[1] <= b[1] else (b, a)
