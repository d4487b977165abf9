# Reads a farop v2 screen file into lists and says what is in it. Usage: python3 reader.py FILE.scr
# Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md.
import sys

width = height = 0
polygons = []  # each: its surface, its planes by name, its vertices
with open(sys.argv[1]) as file:
    for line in file:
        word = line.split("#")[0].split()
        if not word:
            continue
        if word[0] == "size":
            width, height = int(word[1]), int(word[2])
        elif word[0] == "polygon":
            polygons.append({"surface": int(word[3]), "planes": {}, "vertices": []})
        elif word[0] == "plane":  # value = a * x + b * y + c; name, then a b c low high
            polygons[-1]["planes"][word[1]] = [float(number) for number in word[2:7]]
        elif word[0] == "vertex":  # x y inverse_w xw yw w edge, then what varies
            x, y, inverse_w = (float(number) for number in word[1:4])
            values = [float(number) for number in word[8:]]
            polygons[-1]["vertices"].append((x, y, inverse_w, values))

# Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample.
xs = [vertex[0] for polygon in polygons for vertex in polygon["vertices"]]
ys = [vertex[1] for polygon in polygons for vertex in polygon["vertices"]]
print(f"size {width} {height}")
print(f"polygons {len(polygons)}")
print(f"vertices {len(xs)}")
print(f"x {min(xs, default=0):.6f} {max(xs, default=0):.6f}")
print(f"y {min(ys, default=0):.6f} {max(ys, default=0):.6f}")
