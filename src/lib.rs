//! farop: scenes in, a geometry stage that students can read, any rasterizer plugged in, honest answers out.

pub mod color;
pub mod diagnostic;
pub mod geometry;
pub mod image;
pub mod math;
pub mod model;
pub mod parse;
pub mod plan;
pub mod raster;
pub mod render;
pub mod report;
pub mod scene;
pub mod screen;
pub mod spd;
pub mod write;

pub use self::image::snapshot;
