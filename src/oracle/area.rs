//! Area: which share of each pixel a polygon covers, exactly, instead of counting samples.
//!
//! DrawList -AREA-> Image
//!
//! The even-odd area inside a pixel is an integral over its height of covered length. Between two neighboring heights at
//! which anything happens (a corner, a crossing of two edges, an edge that enters the pixel's column) every edge is
//! straight, so the length in the middle times the height is the integral; concave and self-crossing outlines included.
//!
//! Why the pixel's corner as origin, and the place of an edge on the pixel's upper side from a product in two parts: a
//! plain `x0 + t (x1 - x0)` of an edge 4096 samples long is off by 1e-12 of a pixel, which is all that is allowed.
//!
//! Space: samples, or pixels of A x A samples. Source: the integral is Fubini's; the product in two parts is Dekker, "A
//! Floating-Point Technique for Extending the Available Precision", Numerische Mathematik 18, 1971.
//! Cost: k^2 for the k edges that reach into a pixel's rows.

use super::Vertices;
use crate::color::Rgb;
use crate::image::Image;
use crate::math::edges;
use crate::screen::{DrawList, ScreenPolygon};

/// A share of a pixel, and how far it may be off.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// 0 to 1.
    pub area: f64,
    /// Bound of the rounding errors.
    pub error: f64,
}

/// The share of the unit square with the upper left corner `pixel` that lies inside `outline`, by the even-odd rule.
///
/// Coordinates are finite. The stated error takes them as exact.
#[must_use]
pub fn share(outline: &[(f64, f64)], pixel: (f64, f64)) -> Share {
    let reaching: Vec<Line> = edges(outline).filter_map(|(&a, &b)| Line::within(a, b, pixel)).collect();
    let mut heights: Vec<f64> = reaching.iter().flat_map(|line| [line.top, line.bottom]).collect();
    for (index, line) in reaching.iter().enumerate() {
        // Where it enters or leaves the column, and where it crosses others.
        heights.extend([0.0, 1.0].map(|side| (side - line.x) / line.slope));
        heights.extend(reaching[..index].iter().map(|other| (other.x - line.x) / (line.slope - other.slope)));
    }
    heights.retain(|height| (0.0..=1.0).contains(height));
    heights.sort_unstable_by(f64::total_cmp);
    let mut share = Share::default();
    for slab in heights.windows(2).filter(|slab| slab[0] < slab[1]) {
        let (height, middle) = (slab[1] - slab[0], slab[0] + (slab[1] - slab[0]) / 2.0);
        let met = reaching.iter().filter(|line| line.top < middle && middle < line.bottom);
        let mut places: Vec<f64> = met.map(|line| (line.x + line.slope * middle).clamp(0.0, 1.0)).collect();
        places.sort_unstable_by(f64::total_cmp);
        share.area += height * places.chunks_exact(2).map(|pair| pair[1] - pair[0]).sum::<f64>();
    }
    // Every line is a few last digits from its place (see `Line::within`), and so is every sum.
    share.error = (reaching.len() * 16 + heights.len() * 2) as f64 * f64::EPSILON;
    share
}

/// An edge as x over y, seen from the pixel's upper left corner.
struct Line {
    /// Where it starts within the pixel's rows, 0 to 1.
    top: f64,
    /// Where it ends.
    bottom: f64,
    /// Its x at height 0.
    x: f64,
    /// Its change of x over the pixel's height.
    slope: f64,
}

impl Line {
    /// The part of the edge from `a` to `b` in the pixel's rows; `None` where it has none, and for level edges, which bound
    /// no length.
    fn within(a: (f64, f64), b: (f64, f64), pixel: (f64, f64)) -> Option<Line> {
        let local = |(x, y): (f64, f64)| (x - pixel.0, y - pixel.1);
        let (a, b) = (local(a), local(b));
        let (upper, lower) = if a.1 <= b.1 { (a, b) } else { (b, a) };
        let (top, bottom) = (upper.1.max(0.0), lower.1.min(1.0));
        if top >= bottom {
            return None;
        }
        let height = lower.1 - upper.1;
        // x at height 0 is (x_upper y_lower - x_lower y_upper) / height. The products are large and nearly equal; with
        // their errors added back the difference is good to its last digits.
        let (first, first_error) = product(upper.0, lower.1);
        let (second, second_error) = product(lower.0, upper.1);
        let x = ((first - second) + (first_error - second_error)) / height;
        Some(Line { top, bottom, x, slope: (lower.0 - upper.0) / height })
    }
}

/// A product and its rounding error.
fn product(a: f64, b: f64) -> (f64, f64) {
    let rounded = a * b;
    (rounded, libm::fma(a, b, -rounded))
}

/// The picture of flat polygons that do not overlap: each pixel the colors of the polygons in it, by area.
///
/// A pixel is `samples` x `samples` samples of the list. The color of a polygon is what varies at its first corner. What no
/// polygon covers shows `background`. Returned beside the picture: the largest error bound of any pixel's area.
#[must_use]
pub fn picture(list: &DrawList, vertices: Vertices, samples: u32, background: Rgb) -> (Image, f64) {
    let samples = samples.max(1);
    let (width, height) = ((list.width / samples) as usize, (list.height / samples) as usize);
    let mut sums = vec![(Rgb::BLACK, Share::default()); width * height];
    for polygon in list.polygons() {
        let outline = outline(&polygon, vertices, f64::from(samples));
        let color = match *polygon.vertex_values(0) {
            [r, g, b, ..] => Rgb::new(r, g, b),
            _ => Rgb::WHITE,
        };
        let reach = |axis: fn(&(f64, f64)) -> f64, end: usize| {
            let (low, high) = outline.iter().map(axis).fold((f64::MAX, f64::MIN), |(l, h), at| (l.min(at), h.max(at)));
            // Casts saturate.
            low.floor() as usize..(high.ceil() as usize).min(end)
        };
        for y in reach(|p| p.1, height) {
            for x in reach(|p| p.0, width) {
                let found = share(&outline, (x as f64, y as f64));
                let sum = &mut sums[y * width + x];
                *sum = (
                    sum.0 + color * found.area,
                    Share { area: sum.1.area + found.area, error: sum.1.error + found.error },
                );
            }
        }
    }
    let mut image = Image::new(width, height, Rgb::gray(0.0));
    for (pixel, (color, share)) in image.pixels_mut().iter_mut().zip(&sums) {
        *pixel = (*color + background * (1.0 - share.area)).to_f32();
    }
    (image, sums.iter().map(|(_, share)| share.error).fold(0.0, f64::max))
}

/// The corners of a polygon in units of `samples` samples.
#[must_use]
pub fn outline(polygon: &ScreenPolygon<'_>, vertices: Vertices, samples: f64) -> Vec<(f64, f64)> {
    let place = |vertex: &crate::screen::ScreenVertex| match vertices {
        Vertices::Snapped => (vertex.x / samples, vertex.y / samples),
        Vertices::Raw => {
            let scaled = vertex.homogeneous;
            (scaled.x / scaled.z / samples, scaled.y / scaled.z / samples)
        }
    };
    polygon.vertices().iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hand_computed_shares() {
        let triangle = [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)];
        let at = |outline: &[(f64, f64)], x: f64, y: f64| share(outline, (x, y)).area;
        assert_eq!([at(&triangle, 0.0, 0.0), at(&triangle, 1.0, 0.0), at(&triangle, 1.0, 1.0)], [1.0, 0.5, 0.0]);
        let notch = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5, 0.5), (0.0, 1.0)];
        assert_eq!(at(&notch, 0.0, 0.0), 0.75);
        // A bow-tie: two triangles of a quarter each; a square wound twice is a hole.
        assert_eq!(at(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)], 0.0, 0.0), 0.5);
        let inner = [(0.25, 0.25), (0.75, 0.25), (0.75, 0.75), (0.25, 0.75), (0.25, 0.25)];
        let outer = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)];
        assert_eq!(at(&[outer.as_slice(), &inner].concat(), 0.0, 0.0), 0.75);
    }

    #[test]
    fn long_thin_triangles_keep_their_area() {
        // From (0, 0) to (4096, 1): the pixel at column c has the trapezoid between c/4096 and (c+1)/4096 above the edge.
        let sliver = [(0.0, 0.0), (4096.0, 0.0), (4096.0, 1.0)];
        for column in [0.0, 1.0, 777.0, 4095.0] {
            let found = share(&sliver, (column, 0.0));
            let expected = (column + 0.5) / 4096.0;
            assert!((found.area - expected).abs() <= found.error, "{column}: {found:?} {expected}");
            assert!(found.error < 1e-12);
        }
    }

    #[test]
    fn a_long_edge_keeps_its_place() {
        // Corners thousands of pixels away, in 2^-20 of a pixel; the edge falls by less than a pixel over the pixel in hand.
        const UNIT: i128 = 1 << 20;
        let mut state = 7_u64;
        let mut whole = |low: i128, high: i128| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            low + i128::from(state >> 20) % (high - low)
        };
        let mut judged = 0;
        while judged < 200 {
            let (x0, x1) = (whole(-4000 * UNIT, -3600 * UNIT), whole(3600 * UNIT, 4000 * UNIT));
            let (y0, y1) = (whole(-400 * UNIT, 400 * UNIT), whole(-400 * UNIT, 400 * UNIT));
            let (column, run) = (whole(-3000, 3000), x1 - x0);
            // Height of the edge over the middle of the column, in half units times `run`; its fall over the column.
            let middle = 2 * y0 * run + ((2 * column + 1) * UNIT - 2 * x0) * (y1 - y0);
            let (row, fall) = (middle.div_euclid(2 * UNIT * run), UNIT * (y1 - y0).abs());
            let inside = middle - row * 2 * UNIT * run;
            if inside < fall || inside > 2 * UNIT * run - fall {
                continue;
            }
            let at = |x: i128, y: i128| (x as f64 / UNIT as f64, y as f64 / UNIT as f64);
            let outline = [at(x0, y0), at(x1, y1), at(x1, 4000 * UNIT), at(x0, 4000 * UNIT)];
            let found = share(&outline, (column as f64, row as f64)).area;
            let expected = 1.0 - inside as f64 / (2 * UNIT * run) as f64;
            assert!((found - expected).abs() < 4e-15, "{found} {expected}");
            judged += 1;
        }
    }
}
