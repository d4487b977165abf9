//! Triangles between two walked edges, values by shares of areas. A polygon is a fan of triangles; a sample belongs to it when an odd
//! number of them hold it. Labs coverage, zbuffer, gouraud.

mod sheet;

use sheet::{Corner, Picture, Polygon, Sheet, is};

/// A corner in 1/256 sample.
type Place = (i64, i64);

/// An edge, walked from row to row: its crossing is `whole + rest / down`.
struct Walk {
    whole: i64,
    rest: i64,
    down: i64,
    across: i64,
}

impl Walk {
    /// At the center of `row`.
    fn new((x0, y0): Place, (x1, y1): Place, row: i64) -> Walk {
        let (down, across) = ((y1 - y0).max(1), x1 - x0);
        let first = if is("no_prestep") { 0 } else { (row * 256 + 128 - y0) * across };
        Walk { whole: x0 + first.div_euclid(down), rest: first.rem_euclid(down), down, across }
    }

    /// The first column whose center is at or right of the crossing.
    fn column(&self) -> i64 {
        let up = if is("fraction_cut_off") { self.whole } else { self.whole + i64::from(self.rest > 0) };
        (up - 128 + 255).div_euclid(256)
    }

    fn step(&mut self) {
        let across =
            if is("slope_rounded") { (self.across * 16).div_euclid(self.down) * self.down / 16 } else { self.across };
        let moved = self.rest + 256 * across;
        self.whole += moved.div_euclid(self.down);
        self.rest = moved.rem_euclid(self.down);
    }
}

/// The first row whose center is at or below a height.
fn row_behind(y: i64) -> i64 {
    if is("rows_by_rounding_up") { (y + 255).div_euclid(256) } else { (y - 128 + 255).div_euclid(256) }
}

/// Rows from one height to another between two edges.
fn walk(rows: std::ops::Range<i64>, edges: [(Place, Place); 2], toggle: &mut impl FnMut(i64, i64)) {
    let [mut one, mut other] = edges.map(|(from, to)| Walk::new(from, to, rows.start));
    for row in rows {
        let (mut left, mut right) = (one.column(), other.column());
        if left > right && !is("long_edge_on_the_left") {
            (left, right) = (right, left);
        }
        right += i64::from(is("column_too_many"));
        left += i64::from(is("left_column_lost"));
        (left..right).for_each(|x| toggle(x, row));
        (one.step(), other.step());
    }
}

/// Half of a triangle above its middle corner, then the half below.
fn triangle(corners: [Place; 3], toggle: &mut impl FnMut(i64, i64)) {
    let [mut a, mut b, mut c] = corners;
    let area = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    if (is("one_winding") && area <= 0) || (is("small_area_skipped") && area.abs() < 2 * 256 * 256) {
        return;
    }
    if is("flat_by_whole_samples") && whole_area(corners) == 0 {
        return;
    }
    if a.1 > b.1 {
        (a, b) = (b, a);
    }
    if b.1 > c.1 && !is("sorted_in_part") {
        (b, c) = (c, b);
    }
    if a.1 > b.1 {
        (a, b) = (b, a);
    }
    let [top, middle, end] = [a, b, c].map(|place| row_behind(place.1));
    let upper_end = middle + i64::from(is("middle_row_twice"));
    walk(top..upper_end, [(a, c), (a, b)], toggle);
    let lower = middle + i64::from(is("middle_row_lost"));
    // The long edge goes on where it was.
    let end = end + i64::from(is("bottom_row_too"));
    walk(lower..end, [(a, c), (b, c)], toggle);
}

/// Twice the area, in whole samples.
fn whole_area(corners: [Place; 3]) -> i64 {
    let [a, b, c] = corners.map(|(x, y)| (x >> 8, y >> 8));
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

fn place(corner: &Corner) -> Place {
    ((corner.x * 256.0).round() as i64, (corner.y * 256.0).round() as i64)
}

/// Columns and rows that a polygon can reach, with one more at each side.
fn bounds(polygon: &Polygon, sheet: &Sheet) -> [std::ops::Range<usize>; 2] {
    let ends = |at: fn(&Corner) -> f64, size: usize| {
        let all = polygon.corners.iter().map(at);
        let (low, high) = all.fold((f64::MAX, 0.0_f64), |(low, high), place| (low.min(place), high.max(place)));
        (low as usize).saturating_sub(1)..(high.ceil() as usize + 1).min(size)
    };
    [ends(|corner| corner.x, sheet.width), ends(|corner| corner.y, sheet.height)]
}

/// Samples that a polygon covers, toggled by its triangles.
fn cover(polygon: &Polygon, sheet: &Sheet, is_covered: &mut [bool]) {
    let [columns, rows] = bounds(polygon, sheet);
    let places: Vec<Place> = polygon.corners.iter().map(place).collect();
    let triangles = places.len().saturating_sub(2) - usize::from(is("last_triangle_lost") && places.len() > 3);
    for i in 0..triangles {
        let corners = [places[0], places[i + 1], places[i + 2]];
        triangle(corners, &mut |x, y| {
            // What is negative is far beyond.
            let (x, y) = (x as usize, y as usize);
            if columns.contains(&x) && rows.contains(&y) {
                let at = y * sheet.width + x;
                is_covered[at] = is("united") || !is_covered[at];
            }
        });
    }
}

/// Shares of three corners at a place: areas over the whole area.
fn shares(corners: [&Corner; 3], x: f64, y: f64) -> [f64; 3] {
    let area = |a: (f64, f64), b: (f64, f64), c: (f64, f64)| (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
    let [a, b, c] = corners.map(|corner| (corner.x, corner.y));
    let whole = area(a, b, c);
    if whole == 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let [mut p, mut q, mut r] = [area((x, y), b, c), area(a, (x, y), c), area(a, b, (x, y))].map(|part| part / whole);
    if is("shares_exchanged") {
        (q, r) = (r, q);
    }
    if is("third_share_forgotten") {
        r = 0.0;
    }
    if is("shares_in_eighths") {
        [p, q, r] = [p, q, r].map(|share| (share * 8.0).round() / 8.0);
    }
    [p, q, r]
}

/// Three corners that span an area; the first ones, if there are.
fn spanning(polygon: &Polygon) -> [&Corner; 3] {
    let c = &polygon.corners;
    let is_flat = |i: usize| (c[i].x - c[0].x) * (c[i + 1].y - c[0].y) == (c[i].y - c[0].y) * (c[i + 1].x - c[0].x);
    let at = (1..c.len() - 1).find(|&i| !is_flat(i)).unwrap_or(1);
    if is("sorted_without_colors") {
        return sorted([&c[0], &c[at], &c[at + 1]]);
    }
    [&c[0], &c[at], &c[at + 1]]
}

fn sorted(mut corners: [&Corner; 3]) -> [&Corner; 3] {
    corners.sort_by(|a, b| a.y.total_cmp(&b.y));
    corners
}

fn color(polygon: &Polygon, x: usize, y: usize) -> [f64; 3] {
    let corners = spanning(polygon);
    let middle = if is("asked_at_the_upper_left") { 0.0 } else { 0.5 };
    let share = shares(corners, x as f64 + middle, y as f64 + middle);
    let inverse_w: f64 = (0..3).map(|i| share[i] * corners[i].inverse_w).sum();
    let w: f64 = (0..3).map(|i| share[i] * corners[i].w).sum();
    std::array::from_fn(|channel| {
        let own = |i: usize| {
            let whose = if is("sorted_without_colors") { &polygon.corners[i] } else { corners[i] };
            whose.values[channel]
        };
        let over: f64 = (0..3).map(|i| share[i] * own(i) * corners[i].inverse_w).sum();
        let light = if is("linear_on_the_screen") {
            (0..3).map(|i| share[i] * own(i)).sum()
        } else if is("times_w") {
            over * w
        } else if is("w_for_its_inverse") {
            (0..3).map(|i| share[i] * own(i) * corners[i].w).sum::<f64>() / w
        } else {
            over / inverse_w
        };
        let all = polygon.corners.iter().map(|corner| corner.values[channel]);
        let (low, high) = all.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        if is("blue_from_the_first") && channel == 2 { own(0) } else { light.clamp(low, high) }
    })
}

/// Blends what is kept at a sample, nearest first; of equals the first in the list.
fn blend(behind: [f64; 3], mut layers: Vec<(f64, [f64; 3], [f64; 3])>) -> [f64; 3] {
    layers.sort_by(|a, b| b.0.total_cmp(&a.0));
    if is("glass_from_behind") {
        layers.reverse();
    }
    std::array::from_fn(|i| {
        let (mut sum, mut rest) = (0.0, 1.0);
        for (_, light, opacity) in &layers {
            sum += rest * opacity[i] * light[i];
            rest *= 1.0 - opacity[i];
        }
        sum + if is("nothing_behind_glass") && !layers.is_empty() { 0.0 } else { rest * behind[i] }
    })
}

fn main() {
    let mut kept = Vec::new();
    sheet::serve(|sheet| {
        let count = sheet.width * sheet.height;
        let (mut colors, mut layers) = (vec![sheet.background; count], vec![Vec::new(); count]);
        if !is("depth_from_the_last_picture") || kept.len() != count {
            kept = vec![0.0; count];
        }
        let mut is_covered = vec![false; count];
        for polygon in &sheet.polygons {
            cover(polygon, sheet, &mut is_covered);
            let [columns, rows] = bounds(polygon, sheet);
            for at in rows.flat_map(|y| columns.clone().map(move |x| y * sheet.width + x)) {
                let (x, y) = (at % sheet.width, at / sheet.width);
                if !is_covered[at] {
                    continue;
                }
                is_covered[at] = is("coverage_not_cleared");
                let nearest = polygon.corners.iter().map(|corner| corner.inverse_w).fold(0.0, f64::max);
                let depth = if is("nearest_corner") { nearest } else { polygon.depth(x, y) };
                let bias = if is("bias") { 0.01 } else { 0.0 };
                if depth <= kept[at] + bias {
                    continue;
                }
                if polygon.is_opaque() {
                    (kept[at], colors[at]) = (depth, color(polygon, x, y));
                } else {
                    layers[at].push((depth, color(polygon, x, y), polygon.opacity));
                }
            }
        }
        let blended = (0..count).map(|at| {
            let seen = layers[at].iter().filter(|layer| layer.0 > kept[at] || is("glass_through_walls"));
            blend(colors[at], seen.copied().collect())
        });
        Picture { width: sheet.width, height: sheet.height, colors: blended.collect() }
    });
}
