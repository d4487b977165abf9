//! Pixels: where a rasterizer that needs no grid of samples in memory puts finished pixels.
//!
//! Rasterizer -mean of A x A samples-> PIXELS -> Image
//!
//! Why beside [`super::Target`]: a target keeps depth, color and owner of every sample, 24 bytes each, and with A x A samples a pixel that
//! is A x A times the picture. An algorithm that finishes one part of the picture after the other (tiles) can average on the spot.
//!
//! Space: pixels, row 0 on top; light is linear.

use super::PutCounts;
use crate::color::Rgb;
use crate::plan::Transparency;

/// The pixels of a picture, A x A samples each, and what drawing them depends on besides the list.
#[derive(Debug)]
pub struct Pixels<'a> {
    /// Pixels across; the list has `samples` times as many samples.
    pub width: usize,
    /// A.
    pub samples: u32,
    /// Linear light behind everything.
    pub background: Rgb<f32>,
    /// How transparent layers add up.
    pub rule: Transparency,
    /// Threads that may be used; the picture must not depend on it.
    pub threads: u32,
    /// Row after row from the top; whatever is in it is overwritten.
    pub light: &'a mut [Rgb<f32>],
    /// What was put, for `--stats`.
    pub counts: PutCounts,
}
