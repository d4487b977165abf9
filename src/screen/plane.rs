//! The plane equation of a value over the screen, and the one order of operations that evaluates it.
//!
//! project -> PLANE -> every rasterizer
//!
//! Why one definition: depth and colors of a pixel must not depend on which rasterizer asks, in which order, in which
//! tile or on how many threads. So nothing is accumulated along a scan line (`z += dz` gives another last bit for
//! every starting point). At the first sample center of each 16 x 16 block of the picture the plane is evaluated in
//! `f64` and rounded once to `f32`; inside the block `a*dx + b*dy` is added in `f32`, dx, dy = 0..15, without fused
//! multiply-add. A tile of any size that is made of blocks can work in `f32` lanes and get the same bits.
//!
//! Space: samples, x right, y down; sample (x, y) has its center at (x + 0.5, y + 0.5).
//! Cost: one `f64` evaluation a block and polygon, two multiplications and two additions in `f32` a sample.

use super::lane::{Lane, in_block};

/// Width and height of the blocks that anchor the evaluation, in samples; fixed on the picture.
pub const BLOCK: i32 = 16;

/// A plane that changes, within one block, by more than this multiple of its own range over the polygon's vertices is
/// evaluated at every sample: the step inside the block would lose its digits.
const STEEP: f64 = 256.0;

/// The digits that planes are evaluated in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// `f32` inside blocks, the default.
    Single,
    /// `f64` at every sample (`--depth f64`).
    Double,
}

/// How a plane is evaluated; decided from the polygon alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evaluation {
    /// The same value everywhere.
    Constant,
    /// Anchored at blocks, `f32` inside.
    Blocks,
    /// In `f64` at every sample, rounded to `f32`.
    Samples,
    /// In `f64` at every sample, not rounded.
    Double,
    /// No plane at all: the polygon's corners decide, along its edges and the scan line ([`super::ScreenPolygon::values`]).
    ScanLine,
}

/// A value that is linear on the screen: `a x + b y + c`, with the range it has at the polygon's vertices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Change per sample to the right.
    pub a: f64,
    /// Change per sample down.
    pub b: f64,
    /// Value at the upper left corner of the picture, the point (0, 0).
    pub c: f64,
    /// Least value at the clipped polygon's vertices.
    pub low: f64,
    /// Greatest value there.
    pub high: f64,
    /// How it is evaluated.
    pub evaluation: Evaluation,
}

impl Plane {
    /// A value that is the same everywhere.
    #[must_use]
    pub fn constant(value: f64, precision: Precision) -> Plane {
        let value = round(value, precision);
        Plane { a: 0.0, b: 0.0, c: value, low: value, high: value, evaluation: Evaluation::Constant }
    }

    /// The mark of a value that is not linear over the polygon and runs along its edges and scan lines.
    #[must_use]
    pub fn along_scan_lines(value_range: (f64, f64), precision: Precision) -> Plane {
        let (low, high) = (round(value_range.0, precision), round(value_range.1, precision));
        Plane { a: 0.0, b: 0.0, c: low, low, high, evaluation: Evaluation::ScanLine }
    }

    /// The plane of `coefficients` (a, b, c); `plane_range` is the range of the plane itself at the polygon's vertices
    /// and decides how it is evaluated, `value_range` is what results are clamped to (the same for depth; for a
    /// varying, whose plane is value / w, the range of the value).
    #[must_use]
    pub fn new(
        coefficients: [f64; 3],
        plane_range: (f64, f64),
        value_range: (f64, f64),
        precision: Precision,
    ) -> Plane {
        let [a, b, c] = coefficients;
        let change_in_block = (a.abs() + b.abs()) * f64::from(BLOCK - 1);
        let evaluation = if precision == Precision::Double {
            Evaluation::Double
        } else if change_in_block > STEEP * (plane_range.1 - plane_range.0) {
            Evaluation::Samples
        } else {
            Evaluation::Blocks
        };
        Plane { a, b, c, low: round(value_range.0, precision), high: round(value_range.1, precision), evaluation }
    }

    /// The value at the center of sample (x, y), not clamped. Exactly an `f32` unless evaluated in `f64`.
    #[must_use]
    #[inline]
    pub fn at(&self, x: i32, y: i32) -> f64 {
        match self.evaluation {
            // Only the outline knows a value that runs along scan lines; alone, its least one is as good as any.
            Evaluation::Constant | Evaluation::ScanLine => self.c,
            Evaluation::Double => self.exact(x, y),
            Evaluation::Samples => f64::from(self.exact(x, y) as f32),
            Evaluation::Blocks => {
                // The origin of the block: its first sample. The mask also rounds down left of the picture.
                let (block_x, block_y) = (x & !(BLOCK - 1), y & !(BLOCK - 1));
                let at = [(x - block_x) as f32, (y - block_y) as f32];
                f64::from(in_block(self.anchor(block_x, block_y), self.slope(), at))
            }
        }
    }

    /// The value at the center of sample (x, y), within the range at the vertices: a sample outside the true outline
    /// (snapping moved an edge over it) must not see the plane run away.
    #[must_use]
    #[inline]
    pub fn clamped_at(&self, x: i32, y: i32) -> f64 {
        self.clamp(self.at(x, y))
    }

    /// Brings a value into the range at the vertices.
    #[must_use]
    #[inline]
    pub fn clamp(&self, value: f64) -> f64 {
        value.hold(self.low, self.high)
    }

    /// The plane at the first sample (x, y) of a block, rounded once: what [`in_block`] starts from.
    #[must_use]
    #[inline]
    pub fn anchor(&self, x: i32, y: i32) -> f32 {
        self.exact(x, y) as f32
    }

    /// Change per sample to the right and down, for [`in_block`].
    #[must_use]
    #[inline]
    pub fn slope(&self) -> [f32; 2] {
        [self.a as f32, self.b as f32]
    }

    /// Whether every number that it is evaluated to is anchored at blocks or constant, and an `f32`: then lanes of `f32` do.
    #[must_use]
    #[inline]
    pub fn fits_single(&self) -> bool {
        let single = |number: f64| number == f64::from(number as f32);
        let anchored = match self.evaluation {
            Evaluation::Blocks => true,
            // Not -0, which a sum with 0 turns into 0.
            Evaluation::Constant => {
                single(self.c) && self.a == 0.0 && self.b == 0.0 && self.c.to_bits() != (-0.0f64).to_bits()
            }
            Evaluation::Samples | Evaluation::Double | Evaluation::ScanLine => false,
        };
        anchored && single(self.low) && single(self.high)
    }

    /// Multiplies the plane by `plane`, and the range of the values by `values`.
    pub(super) fn scale(&mut self, plane: f64, values: f64) {
        (self.a, self.b, self.c) = (self.a * plane, self.b * plane, self.c * plane);
        (self.low, self.high) = (self.low * values, self.high * values);
    }

    /// The plane of something that varies, after all lengths were multiplied by `lengths`: the value is a length or is not,
    /// and in `perspective` the plane is that of value / w.
    pub(super) fn scale_varying(&mut self, is_length: bool, perspective: bool, lengths: f64) {
        let value = if is_length { lengths } else { 1.0 };
        let over_w = perspective && self.evaluation != Evaluation::Constant;
        self.scale(if over_w { value / lengths } else { value }, value);
    }

    /// Whether every number of it is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        [self.a, self.b, self.c, self.low, self.high].iter().all(|number| number.is_finite())
    }

    #[inline]
    fn exact(&self, x: i32, y: i32) -> f64 {
        self.a * (f64::from(x) + 0.5) + self.b * (f64::from(y) + 0.5) + self.c
    }
}

fn round(value: f64, precision: Precision) -> f64 {
    match precision {
        Precision::Single => f64::from(value as f32),
        Precision::Double => value,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(a: f64, b: f64, c: f64, precision: Precision) -> Plane {
        Plane::new([a, b, c], (-1e3, 1e3), (-1e3, 1e3), precision)
    }

    #[test]
    fn blocks_stay_within_two_ulp_of_the_exact_plane() {
        let (single, double) =
            (plane(0.013, -0.007, 0.3, Precision::Single), plane(0.013, -0.007, 0.3, Precision::Double));
        for y in 0..200 {
            for x in 0..200 {
                let (rounded, exact) = (single.at(x, y), double.at(x, y));
                assert!(
                    (rounded - exact).abs() <= 2.0 * f64::from(f32::EPSILON) * 4.0,
                    "({x}, {y}): {rounded} {exact}"
                );
                assert_eq!(rounded, f64::from(rounded as f32));
            }
        }
    }

    #[test]
    fn left_of_the_picture_blocks_go_on() {
        let single = plane(1.0, 0.0, 0.0, Precision::Single);
        assert_eq!(single.at(-1, 0), -0.5);
        assert_eq!(single.at(-17, 0), -16.5);
    }

    #[test]
    fn a_steep_sliver_is_evaluated_at_every_sample() {
        let sliver = Plane::new([1e6, 0.0, -5e6], (0.0, 1.0), (0.0, 1.0), Precision::Single);
        assert_eq!(sliver.evaluation, Evaluation::Samples);
        assert_eq!(sliver.clamped_at(4, 0), 0.0);
        assert_eq!(sliver.clamped_at(5, 0), 1.0);
    }
}
