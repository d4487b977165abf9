//! The classic screen file, written: whole numbers, as FAROP did in 1996.
//!
//! ```text
//! xmax ymax zmax cmax
//! number of polygons
//! 1                     before every polygon
//! n ymax ymin           its corners, its largest and smallest y
//! x y z R G B           n times
//! 1
//! 127                   the end
//! ```
//!
//! What the paper leaves open is decided here. y runs down. Pixel centers lie at whole numbers, as in SIPP, so a corner
//! x samples from the left edge of the picture becomes round(x - 1/2), the sample that holds it, 0 to xmax - 1. Depth is
//! z = round(zmax (1/hither - 1/w) / (1/hither - 1/yon)): 0 at hither, zmax at yon, linear on the screen. Colors run from 0
//! to cmax, encoded as the picture's. Color and depth include their maximum, x and y do not.
//!
//! What is lost: up to half a sample of position, half a step of z and color, planes, transparency, samples per pixel (the
//! file is of the sample grid), background, and with Phong everything between the corners.
//! Space: samples. Source: Pereira, "FAROP", IST/INESC 1996, appendix A.2.

use super::ScreenWriteError;
use crate::color::{Encoding, Rgb};
use crate::math::{Vec3, unit};
use crate::screen::{DrawList, ScreenPolygon};
use std::io::{BufWriter, Write};

/// The largest value of zmax and cmax.
pub(super) const MAX_RESOLUTION: u32 = 1 << 31;

/// How fine the whole numbers of a classic file are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassicOptions {
    /// zmax, 1 to 2^31 (`--z-resolution`). The default 65535 takes 16 bits; the paper's files have that of the picture.
    pub z_resolution: u32,
    /// cmax, 1 to 2^31 (`--color-resolution`). The default 255 keeps 8-bit levels; the paper's files have 128 and 512.
    pub color_resolution: u32,
    /// Distance at which z is zmax (`--yon`). `None`: the list's own far plane, or its farthest vertex where that is
    /// infinitely far.
    pub yon: Option<f64>,
    /// What color numbers mean.
    pub encoding: Encoding,
}

impl Default for ClassicOptions {
    fn default() -> Self {
        ClassicOptions { z_resolution: 65535, color_resolution: 255, yon: None, encoding: Encoding::Srgb }
    }
}

/// What was written, for the caller to print.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassicReport {
    /// How many polygons.
    pub polygons: usize,
    /// The distance at which z is zmax.
    pub yon: f64,
    /// Vertices nearer than hither or beyond yon, whose z was set to 0 or zmax.
    pub z_clamped: usize,
    /// Polygons that are not opaque; the file cannot say so.
    pub transparent: usize,
    /// Polygons whose corners all fell on one line: they cover nothing anymore.
    pub collapsed: usize,
}

/// Writes `list` as a classic file.
///
/// # Errors
/// [`ScreenWriteError`] when a resolution or yon makes no sense, and whatever `out` says.
pub fn write_classic(
    list: &DrawList,
    options: &ClassicOptions,
    out: &mut dyn Write,
) -> Result<ClassicReport, ScreenWriteError> {
    let scale = Scale::new(list, options)?;
    let (polygons, yon) = (list.len(), list.unit / scale.farthest);
    let mut report = ClassicReport { polygons, yon, z_clamped: 0, transparent: 0, collapsed: 0 };
    let mut out = BufWriter::new(out);
    let (width, height) = (list.width, list.height);
    writeln!(out, "{width} {height} {} {}", options.z_resolution, options.color_resolution)?;
    writeln!(out, "{polygons}")?;
    let mut corners = Vec::new();
    for polygon in list.polygons() {
        corners.clear();
        let count = polygon.vertices().len();
        corners.extend((0..count).map(|corner| scale.corner(list, &polygon, corner, &mut report)));
        report.transparent += usize::from(list.shader.opacity(&polygon) != Rgb::gray(1.0));
        report.collapsed += usize::from(lie_in_a_line(&corners));
        let rows = corners.iter().map(|&[_, y, ..]| y);
        let (low, high) = rows.fold((i64::MAX, 0), |(low, high), y| (low.min(y), high.max(y)));
        writeln!(out, "1\n{count} {high} {low}")?;
        for [x, y, z, r, g, b] in &corners {
            writeln!(out, "{x} {y} {z} {r} {g} {b}")?;
        }
    }
    writeln!(out, "1\n127")?;
    out.flush()?;
    Ok(report)
}

/// From a list's numbers to whole ones.
struct Scale {
    options: ClassicOptions,
    /// 1 / hither.
    nearest: f64,
    /// 1 / yon.
    farthest: f64,
}

impl Scale {
    fn new(list: &DrawList, options: &ClassicOptions) -> Result<Scale, ScreenWriteError> {
        if list.grid.is_exact() {
            return Err(ScreenWriteError::Unsnapped);
        }
        let resolutions = [("z-resolution", options.z_resolution), ("color-resolution", options.color_resolution)];
        for (what, value) in resolutions {
            if !(1..=MAX_RESOLUTION).contains(&value) {
                return Err(ScreenWriteError::Resolution { what, value });
            }
        }
        let nearest = list.depth_mapping.nearest;
        let hither = list.unit / nearest;
        if let Some(yon) = options.yon.filter(|&yon| !(yon.is_finite() && yon > hither)) {
            return Err(ScreenWriteError::Yon { yon, hither });
        }
        let farthest_vertex = list.vertices.iter().fold(nearest, |farthest, vertex| farthest.min(inverse_w(vertex)));
        let own = Some(list.depth_mapping.farthest).filter(|&farthest| farthest > 0.0);
        let farthest = options.yon.map(|yon| list.unit / yon).or(own).unwrap_or(farthest_vertex);
        Ok(Scale { options: *options, nearest, farthest })
    }

    /// x, y, z, red, green, blue of a corner.
    fn corner(
        &self,
        list: &DrawList,
        polygon: &ScreenPolygon<'_>,
        corner: usize,
        report: &mut ClassicReport,
    ) -> [i64; 6] {
        let vertex = &polygon.vertices()[corner];
        let inverse_w = inverse_w(vertex);
        report.z_clamped += usize::from(!(self.farthest..=self.nearest).contains(&inverse_w));
        let light = corner_light(list, polygon, corner);
        let cmax = f64::from(self.options.color_resolution);
        let [r, g, b] = self
            .options
            .encoding
            .encode(light)
            .map(|channel| (channel.clamp(0.0, 1.0) * cmax).round() as i64)
            .to_array();
        [pixel(vertex.x, list.width), pixel(vertex.y, list.height), self.depth(inverse_w), r, g, b]
    }

    fn depth(&self, inverse_w: f64) -> i64 {
        let range = self.nearest - self.farthest;
        // With everything at hither there is no range.
        let share = if range > 0.0 { (self.nearest - inverse_w) / range } else { 0.0 };
        (share.clamp(0.0, 1.0) * f64::from(self.options.z_resolution)).round() as i64
    }
}

fn inverse_w(vertex: &crate::screen::ScreenVertex) -> f64 {
    1.0 / vertex.homogeneous.z
}

/// The sample whose center is nearest to a coordinate: the one that holds it, and the last one for the far side.
fn pixel(coordinate: f64, side: u32) -> i64 {
    (coordinate.floor() as i64).clamp(0, i64::from(side) - 1)
}

/// Light at a corner, in all digits: what varies, or what a surface with that normal sends.
fn corner_light(list: &DrawList, polygon: &ScreenPolygon<'_>, corner: usize) -> Rgb {
    let values = polygon.vertex_values(corner);
    match *values {
        [r, g, b] | [r, g, b, _, _] => Rgb::new(r, g, b),
        [nx, ny, nz, ex, ey, ez] | [nx, ny, nz, ex, ey, ez, _, _] => {
            let normal = unit(Vec3::new(nx, ny, nz)).unwrap_or(Vec3::NEG_Z);
            list.shader.light(polygon.surface(), Vec3::new(ex, ey, ez), normal)
        }
        [nx, ny, nz, ex, ey, ez, r, g, b] | [nx, ny, nz, ex, ey, ez, r, g, b, _, _] => {
            let normal = unit(Vec3::new(nx, ny, nz)).unwrap_or(Vec3::NEG_Z);
            list.shader.light_colored(polygon.surface(), (Vec3::new(ex, ey, ez), normal), Rgb::new(r, g, b))
        }
        _ => list.shader.line_color.to_f64(),
    }
}

/// Whether the polygon has lost its area: all corners lie on one line through the first.
fn lie_in_a_line(corners: &[[i64; 6]]) -> bool {
    let from_first = |&[x, y, ..]: &[i64; 6]| (x - corners[0][0], y - corners[0][1]);
    let Some((ux, uy)) = corners.iter().map(from_first).find(|&offset| offset != (0, 0)) else { return true };
    corners.iter().map(from_first).all(|(x, y)| ux * y == uy * x)
}
