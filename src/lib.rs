//! farop: scenes in, a geometry stage that students can read, any rasterizer plugged in, honest answers out.

pub mod color;
pub mod image;
pub mod math;
pub mod scene;

pub use self::image::snapshot;
