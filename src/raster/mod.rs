//! Rasterizers: which polygon is in front at every sample, and what color it shows.
//!
//! DrawList -RASTERIZER-> Fragment -> target -> Image
//!
//! The contract is two traits. Implement [`PolygonRasterizer`] when one polygon at a time is enough, [`Rasterizer`]
//! when the algorithm must see all polygons at once. Both get the same list, both write fragments into a [`Target`],
//! and both are plugged in through the [`Registry`].

pub mod coverage;
mod exact_edge;
pub mod external;
pub mod fast;
pub mod functions;
mod layers;
mod order;
mod pixels;
mod put_counts;
mod registry;
mod scanline;
mod target;
pub mod watkins;
mod wire;
mod zbuffer;

pub use fast::Fast;
pub use order::Order;
pub use pixels::Pixels;
pub use put_counts::PutCounts;
pub use registry::{Registered, Registry};
pub use scanline::Scanline;
pub use target::{Frame, Target};
pub use watkins::Watkins;
pub use wire::Wire;
pub use zbuffer::ZBuffer;

use crate::plan::Accepts;
use crate::screen::{DrawList, ScreenPolygon, Shader};

/// Decides, for every pixel, which polygon is in front and what color it shows.
///
/// Implement this when the algorithm must see all polygons at once (Watkins, tiles).
/// When one polygon at a time is enough (z-buffer, wire), implement [`PolygonRasterizer`].
pub trait Rasterizer {
    /// Draws `list` into `target`.
    ///
    /// * `list`: screen polygons, already clipped, in scene order.
    /// * `target`: arrives with the background color and depth 0 (1/w: infinitely far). Writes outside it are
    ///   dropped and counted, and the count is reported: a wrong rounding is not a crash.
    /// * Keep no state between calls: the same list must give the same picture twice.
    fn draw(&self, list: &DrawList, target: &mut Target<'_>);

    /// The polygons this algorithm can take; the plan splits the others into triangles.
    fn accepts(&self) -> Accepts {
        Accepts::AnyPolygon
    }

    /// Whether it reads shared triangles ([`DrawList::shared`]): only then lists have some. For algorithms that make planes of their
    /// own; most leave it at that.
    fn reads_shared(&self) -> bool {
        false
    }

    /// Draws all of `pixels` without a target: for algorithms that finish one part of the picture after the other and need no
    /// grid of samples in memory. `false`, and nothing drawn: `list` wants [`Rasterizer::draw`]. Most algorithms leave it at that.
    fn draw_pixels(&self, _list: &DrawList, _pixels: &mut Pixels<'_>) -> bool {
        false
    }
}

/// A rasterizer that never needs to look past the polygon in hand (FAROP's operation 16).
pub trait PolygonRasterizer {
    /// Draws one polygon over whatever earlier polygons left in `target`.
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>);

    /// The polygons this algorithm can take; the plan splits the others into triangles.
    fn accepts(&self) -> Accepts {
        Accepts::AnyPolygon
    }
}

/// Makes a [`Rasterizer`] of a [`PolygonRasterizer`] by handing it the list in order.
pub struct PerPolygon<R>(pub R);

impl<R: PolygonRasterizer> Rasterizer for PerPolygon<R> {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        for polygon in list.polygons() {
            self.0.draw_polygon(&polygon, &list.shader, target);
        }
    }

    fn accepts(&self) -> Accepts {
        self.0.accepts()
    }
}
