//! A x A samples in A x A passes: each pass draws a picture of one sample a pixel, at its own place within the pixels, with its own depths,
//! and is added to a sum. Coverage by the sign of edges, counted along the row. Labs supersampling, zbuffer.

mod sheet;

use sheet::{Picture, Polygon, Sheet, is};

/// A sample of the large picture that a pass asks in each pixel.
#[derive(Clone, Copy)]
struct Offset {
    x: usize,
    y: usize,
}

/// Whether the center of a sample is in a polygon: edges at or left of it, odd. Whole numbers, in 1/256.
fn covers(polygon: &Polygon, x: usize, y: usize) -> bool {
    let middle = if is("corners_of_samples") { 0 } else { 128 };
    let (px, py) = (256 * x as i64 + middle, 256 * y as i64 + middle);
    let places: Vec<(i64, i64)> =
        polygon.corners.iter().map(|c| ((c.x * 256.0).round() as i64, (c.y * 256.0).round() as i64)).collect();
    let mut is_inside = false;
    for i in 0..places.len() {
        let (mut a, mut b) = (places[i], places[(i + 1) % places.len()]);
        if a.1 > b.1 {
            (a, b) = (b, a);
        }
        if is("upper_ends_lost") {
            (a.1, b.1) = (a.1 + 1, b.1 + 1);
        }
        let side = (px - a.0) * (b.1 - a.1) - (py - a.1) * (b.0 - a.0);
        if a.1 <= py && py < b.1 && (side > 0 || (side == 0 && !is("strictly_right"))) {
            is_inside = !is_inside;
        }
    }
    is_inside
}

/// Columns and rows of pixels that a polygon can reach.
fn bounds(polygon: &Polygon, a: usize) -> [std::ops::Range<usize>; 2] {
    let ends = |at: fn(&sheet::Corner) -> f64| {
        let all = polygon.corners.iter().map(at);
        let (low, high) = all.fold((f64::MAX, 0.0_f64), |(low, high), place| (low.min(place), high.max(place)));
        low as usize / a..(high.ceil() as usize).div_ceil(a)
    };
    [ends(|corner| corner.x), ends(|corner| corner.y)]
}

/// One pass: a color a pixel. `depths` come from outside, so that they need no room of their own in each pass.
fn pass(sheet: &Sheet, offset: Offset, depths: &mut Vec<f64>) -> Vec<[f64; 3]> {
    let a = sheet.samples;
    let (width, height) = (sheet.width / a, sheet.height / a);
    if !(is("depths_not_cleared") && depths.len() == width * height) {
        *depths = vec![0.0; width * height];
    }
    let empty = if is("passes_on_black") { [0.0; 3] } else { sheet.background };
    let mut colors = vec![empty; width * height];
    let mut layers: Vec<Vec<(f64, [f64; 3], [f64; 3])>> = vec![Vec::new(); width * height];
    for polygon in &sheet.polygons {
        let [columns, rows] = bounds(polygon, a);
        for (row, column) in rows.flat_map(|row| columns.clone().map(move |column| (row, column))) {
            let at = row * width + column;
            let (x, y) = (column * a + offset.x, row * a + offset.y);
            if !covers(polygon, x, y) {
                continue;
            }
            let (u, v) = if is("depth_of_the_pixel") { (column * a, row * a) } else { (x, y) };
            let depth = polygon.depth(u, v);
            let is_behind = if is("equal_depth_wins") { depth < depths[at] } else { depth <= depths[at] };
            if is_behind {
                continue;
            }
            let (u, v) = if is("color_of_the_pixel") { (column * a + a / 2, row * a + a / 2) } else { (x, y) };
            let light = polygon.color(u, v);
            if polygon.is_opaque() {
                (depths[at], colors[at]) = (depth, light);
            } else {
                layers[at].push((depth, light, polygon.opacity));
            }
        }
    }
    for at in 0..width * height {
        layers[at].retain(|layer| layer.0 > depths[at]);
        layers[at].reverse();
        layers[at].sort_by(|one, other| one.0.total_cmp(&other.0));
        for (_, light, opacity) in &layers[at] {
            (0..3).for_each(|i| colors[at][i] += opacity[i] * (light[i] - colors[at][i]));
        }
    }
    colors
}

/// The places of the passes.
fn offsets(a: usize) -> Vec<Offset> {
    let all = (0..a * a).map(|n| Offset { x: n % a, y: n / a });
    if is("diagonal_only") {
        return (0..a).map(|n| Offset { x: n, y: n }).collect();
    }
    if is("same_place") {
        return vec![Offset { x: a / 2, y: a / 2 }; a * a];
    }
    if is("two_by_two") {
        return all.filter(|offset| offset.x < 2 && offset.y < 2).collect();
    }
    if is("last_pass_lost") {
        return all.take((a * a - 1).max(1)).collect();
    }
    if is("columns_only") {
        return (0..a).map(|x| Offset { x, y: a / 2 }).collect();
    }
    all.collect()
}

fn draw(sheet: &Sheet) -> Picture {
    let (width, height) = (sheet.width / sheet.samples, sheet.height / sheet.samples);
    let mut sums = vec![[0.0; 3]; width * height];
    let (passes, mut depths) = (offsets(sheet.samples), Vec::new());
    let mut weight = passes.len() as f64;
    if is("divided_by_a") {
        weight = sheet.samples as f64;
    }
    if is("divided_by_a_square_always") {
        weight = (sheet.samples * sheet.samples) as f64 + 1.0;
    }
    for (n, offset) in passes.iter().enumerate() {
        let colors = pass(sheet, *offset, &mut depths);
        for (sum, color) in sums.iter_mut().zip(colors) {
            for i in 0..3 {
                let light = color[i];
                let part = if is("levels_cut_in_each_pass") {
                    (light * 255.0 / weight).floor() / 255.0 * weight
                } else {
                    light
                };
                let gamma = if is("mean_of_display_values") { light.powf(1.0 / 2.2) } else { part };
                sum[i] = match () {
                    () if is("mean_of_means") && n > 0 => (sum[i] + light) / 2.0,
                    () if is("mean_of_means") => light,
                    () if is("brightest_sample") => sum[i].max(light),
                    () => sum[i] + gamma,
                };
            }
        }
    }
    if !is("mean_of_means") && !is("brightest_sample") {
        sums.iter_mut().flatten().for_each(|sum| *sum /= weight);
    }
    if is("mean_of_display_values") {
        sums.iter_mut().flatten().for_each(|light| *light = light.powf(2.2));
    }
    if is("box_of_three") {
        sums = blurred(&sums, width);
    }
    Picture { width, height, colors: sums }
}

/// Every pixel with its right neighbor.
fn blurred(colors: &[[f64; 3]], width: usize) -> Vec<[f64; 3]> {
    let right = |at: usize| if at % width + 1 < width { at + 1 } else { at };
    (0..colors.len()).map(|at| std::array::from_fn(|i| (colors[at][i] + colors[right(at)][i]) / 2.0)).collect()
}

fn main() {
    sheet::serve(draw);
}
