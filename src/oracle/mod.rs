//! Oracles: what the picture ought to be, found by other means than the ones that draw it.
//!
//! DrawList -EXACT-> owner of every sample; Scene -RAY-> light through every sample; DrawList -AREA-> exact share of every pixel
//!
//! Why a room of its own: a rasterizer that is compared with its own arithmetic agrees with its own mistakes. Nothing here
//! uses the `raster` or the `geometry` room; [`exact`] and [`area`] share the screen types with them, [`ray`] shares the
//! scene types and the values of [`crate::plan::Choices`], and each states the rules it judges by anew.
//!
//! | Oracle | Judges | How |
//! |---|---|---|
//! | [`exact`] | coverage, ownership of shared edges, depth order | whole numbers of any length, no rounding at all |
//! | [`ray`] | tessellation, silhouettes, shading | one ray a sample against the shapes as the file states them |
//! | [`area`] | supersampling | the area of each polygon in each pixel, by integration |
//!
//! [`number`] holds the exact numbers, [`depth`] the two meanings of "nearer".

pub mod area;
mod covering;
pub mod depth;
pub mod exact;
pub mod number;
pub mod ray;

/// Which corners of a screen polygon are meant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vertices {
    /// Those on the grid, which the contract's coverage is about.
    #[default]
    Snapped,
    /// Those before snapping: x = `homogeneous.x / w`, taken as the exact dyadic numbers that they are.
    Raw,
}
