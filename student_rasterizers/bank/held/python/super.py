"""A supersampler: a dictionary of samples, filled by half planes' crossings, and a mean of A x A of them for each pixel."""
from math import ceil, floor

from held import color_at, depth_at, edges, sheets, slip, write


def is_inside(outline, px, py):
    """An odd number of edges at or left of the point."""
    odd = False
    for (ax, ay), (bx, by) in outline:
        if ay <= py < by and (px - ax) * (by - ay) >= (py - ay) * (bx - ax):
            odd = not odd
    return odd


def place(x, y, a):
    """Where sample (x, y) is asked for."""
    if slip("all_at_the_middle"):
        return (x // a + 0.5) * a, (y // a + 0.5) * a
    if slip("samples_at_corners") and a > 1:
        return x, y
    if slip("offsets_only_across"):
        return x + 0.5, (y // a + 0.5) * a
    return x + 0.5, y + 0.5


def sampled(sheet):
    """Depth and color of every sample that is covered."""
    a, samples, depths = sheet.samples, {}, {}
    for face in sheet.faces:
        outline = list(edges(face))
        xs, ys = zip(*face.corners)
        margin = a if slip("all_at_the_middle") or slip("offsets_only_across") else 0
        for y in range(max(floor(min(ys)) - margin, 0), min(ceil(max(ys)) + margin + 1, sheet.height)):
            for x in range(max(floor(min(xs)) - margin, 0), min(ceil(max(xs)) + margin + 1, sheet.width)):
                px, py = place(x, y, a)
                if not is_inside(outline, px, py):
                    continue
                key = (x // a, y // a) if slip("depth_a_pixel") else (x, y)
                depth = depth_at(face, x + 0.5, y + 0.5)
                if depth > depths.get(key, 0):
                    depths[key] = depth
                    samples[x, y] = color_at(face, x + 0.5, y + 0.5)
                    if slip("color_at_the_middle"):
                        samples[x, y] = color_at(face, (x // a + 0.5) * a, (y // a + 0.5) * a)
    return samples


def pixel(samples, sheet, x, y):
    """The mean of a pixel's samples."""
    a, back = sheet.samples, sheet.background
    block = [(x * a + n % a, y * a + n // a) for n in range(a * a)]
    if slip("diagonal_only"):
        block = [(x * a + n, y * a + n) for n in range(a)]
    if slip("last_row_and_column_left_out") and a > 1:
        block = [(x * a + n % (a - 1), y * a + n // (a - 1)) for n in range((a - 1) ** 2)]
    if slip("block_moved_by_half"):
        block = [(max(i - a // 2, 0), max(j - a // 2, 0)) for i, j in block]
    if slip("neighbors_too") and a > 1:
        block = [(x * a + i, y * a + j) for i in range(a + 1) for j in range(a + 1)]
        block = [(min(i, sheet.width - 1), min(j, sheet.height - 1)) for i, j in block]
    if slip("block_of_two"):
        block = [(x * a + min(n % 2, a - 1), y * a + min(n // 2, a - 1)) for n in range(4)]
    colors = [samples.get(key, back) for key in block]
    if slip("covered_samples_only"):
        colors = [samples[key] for key in block if key in samples] or [back]
    if slip("black_where_nothing_is"):
        colors = [samples.get(key, (0, 0, 0)) for key in block] if any(key in samples for key in block) else [back]
    if slip("one_by_one_halved"):
        mean = colors[0]
        for color in colors[1:]:
            mean = [(p + q) / 2 for p, q in zip(mean, color)]
        return mean
    if slip("divided_by_a"):
        return [sum(channel) / a for channel in zip(*colors)]
    if slip("brightest"):
        return max(colors, key=sum)
    if slip("majority"):
        return max(colors, key=colors.count)
    if slip("rounded_down"):
        return [sum(int(v * 255) for v in channel) // len(channel) / 255 for channel in zip(*colors)]
    if slip("mean_of_squares"):
        return [(sum(v * v for v in channel) / len(channel)) ** 0.5 for channel in zip(*colors)]
    return [sum(channel) / len(channel) for channel in zip(*colors)]


for sheet in sheets():
    samples = sampled(sheet)
    width, height = sheet.width // sheet.samples, sheet.height // sheet.samples
    write(width, height, [pixel(samples, sheet, x, y) for y in range(height) for x in range(width)])
