//! Which polygon a rasterizer shows at every sample, read off the picture: every polygon in a color of its own.

use super::draw;
use farop::color::Rgb;
use farop::plan::Varying;
use farop::raster::Rasterizer;
use farop::screen::{DrawList, Plane, Precision};

/// The same polygons, opaque, each with its number plus one as red, in the same depth planes.
pub fn numbered(list: &DrawList) -> DrawList {
    let mut own = list.clone();
    own.varying = Varying::Color;
    own.has_blending = false;
    own.shader.surfaces.iter_mut().for_each(|surface| surface.opacity = Rgb::gray(1.0));
    own.planes.clear();
    own.values = vec![0.0; 3 * own.vertices.len()];
    for (index, polygon) in list.polygons().enumerate() {
        own.polygons[index].first_plane = own.planes.len() as u32;
        own.planes.push(*polygon.depth_plane().expect("a list with depth"));
        let number = (index + 1) as f64;
        own.planes.extend([number, 0.0, 0.0].map(|value| Plane::constant(value, Precision::Single)));
        let first = own.polygons[index].first_vertex as usize;
        (first..first + polygon.vertices().len()).for_each(|vertex| own.values[3 * vertex] = number);
    }
    own
}

/// The owner of every sample of a [`numbered`] list.
pub fn owners(list: &DrawList, rasterizer: &dyn Rasterizer) -> Vec<Option<u32>> {
    let (image, _) = draw(list, rasterizer);
    image.pixels().iter().map(|light| (light.r as u32).checked_sub(1)).collect()
}
