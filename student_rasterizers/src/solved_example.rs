//! A rasterizer in ten lines: how the pieces fit together.
//!
//! It asks farop which samples are covered; finding that out is the lab. And it is slow, because it asks once a sample: a
//! faster one finds the two ends of a covered run and fills what is between.

use farop::raster::coverage::covers;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::{ScreenPolygon, Shader};

/// Keeps the nearest polygon at every sample of its bounding box that it covers.
pub struct TenLines;

impl PolygonRasterizer for TenLines {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let reach = |(low, high): (i32, i32), along: f64| (low.min(along as i32), high.max(along as i32));
        let (left, right) = polygon.vertices().iter().fold((i32::MAX, 0), |range, corner| reach(range, corner.x));
        let (top, bottom) = polygon.vertices().iter().fold((i32::MAX, 0), |range, corner| reach(range, corner.y));
        for y in top..=bottom {
            for x in left..=right {
                if covers(polygon.vertices(), polygon.grid(), x, y) && polygon.depth(x, y) > target.depth(x, y) {
                    target.put(shader.fragment(polygon, x, y));
                }
            }
        }
    }
}
