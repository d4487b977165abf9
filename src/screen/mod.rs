//! What the geometry stage hands to a rasterizer: polygons on the screen, with everything to draw them.
//!
//! geometry -> DRAW LIST -> rasterizer -> Fragment -> target
//!
//! Why flat arrays: a million polygons cost five allocations, reused from frame to frame; [`DrawList::polygon`]
//! lends views of them that read like objects.
//!
//! Space: samples, x right, y down, the upper left corner of the picture is (0, 0); sample (i, j) has its center at
//! (i + 0.5, j + 0.5). Vertices are snapped to a grid of 2^-bits samples. Depth is 1/w, larger is nearer, 0 is
//! infinitely far. Colors are linear light.

pub(crate) mod corner;
pub mod file;
mod fragment;
mod grid;
mod instructions;
pub mod lane;
pub(crate) mod lanes;
pub(crate) mod linear;
mod list;
mod plain;
mod plane;
mod polygon;
mod scan_line;
pub mod shader;
mod shared;

pub use fragment::{Fragment, Values};
pub use grid::Grid;
pub use instructions::{Instructions, VARIABLE};
pub use list::{DepthMapping, DrawList, PolygonRecord, Source};
pub use plane::{BLOCK, Evaluation, Plane, Precision};
pub use polygon::ScreenPolygon;
pub use shader::Shader;
pub(crate) use shared::{OWN, SharedCorner, SharedTriangle};
pub use shared::{Shared, Whole};

use crate::math::Vec3;

/// Where an edge of a polygon comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EdgeKind {
    /// From the scene.
    #[default]
    Original,
    /// Made by clipping: lies on a side of the view volume. Wire does not draw it.
    Cut,
    /// A diagonal, made by splitting a polygon into triangles.
    Diagonal,
}

/// A corner of a screen polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenVertex {
    /// Samples to the right, snapped to the grid. Coverage is decided on these; without a grid, on `homogeneous`.
    pub x: f64,
    /// Samples down, snapped.
    pub y: f64,
    /// (x w, y w, w) before snapping: the exact corner is at x = `homogeneous.x / w`; w is the distance along the view.
    pub homogeneous: Vec3,
    /// The edge that starts here.
    pub edge: EdgeKind,
}
