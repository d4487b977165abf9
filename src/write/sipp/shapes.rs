//! Shapes in the words of the language: one line each, except for nets of control points.

use super::Printer;
use crate::math::Vec3;
use crate::scene::{Primitive, Shape, SurfaceId, TeapotPart, TextureMapping};
use std::io;

impl Printer<'_> {
    /// One shape with everything that is said about it.
    pub(super) fn primitive(&mut self, id: SurfaceId, primitive: &Primitive) -> io::Result<()> {
        self.indent()?;
        write!(self.out, "{} {{ shader {}", word(&primitive.shape), self.shaders.name(id))?;
        self.shape(&primitive.shape)?;
        match primitive.resolution {
            Some([n, m]) if n == m => write!(self.out, " res {n}")?,
            Some([n, m]) => write!(self.out, " res {n} {m}")?,
            None => {}
        }
        match primitive.texture {
            TextureMapping::Natural => write!(self.out, " texture natural")?,
            TextureMapping::Cylindrical => write!(self.out, " texture cylindrical")?,
            TextureMapping::Spherical => write!(self.out, " texture spherical")?,
            TextureMapping::World => {}
        }
        if primitive.inside {
            write!(self.out, " inside")?;
        }
        if self.scene.surface(id).two_sided && !self.default_two_sided {
            write!(self.out, " two_sided on")?;
        }
        writeln!(self.out, " }}")
    }

    fn shape(&mut self, shape: &Shape) -> io::Result<()> {
        match *shape {
            Shape::Sphere { center, radius } => {
                self.parameter("radius", &[radius])?;
                if center == Vec3::ZERO { Ok(()) } else { self.parameter("center", &center.to_array()) }
            }
            Shape::Cone { base, base_radius, apex, apex_radius } => {
                self.parameter("base", &[base.x, base.y, base.z, base_radius])?;
                self.parameter("apex", &[apex.x, apex.y, apex.z, apex_radius])
            }
            Shape::Ellipsoid { radii } => self.parameter("radii", &radii.to_array()),
            Shape::CappedCone { bottom_radius, top_radius, length } => {
                if bottom_radius == top_radius {
                    self.parameter("radius", &[bottom_radius])?;
                } else {
                    self.parameter("bottom", &[bottom_radius])?;
                    self.parameter("top", &[top_radius])?;
                }
                self.parameter("length", &[length])
            }
            Shape::Block { size } if is_cube(size) => self.parameter("size", &[size.x]),
            Shape::Block { size } => self.parameter("size", &size.to_array()),
            Shape::Prism { ref outline, height } => {
                self.parameter("outline", outline.as_flattened())?;
                self.parameter("height", &[height])
            }
            Shape::Torus { ring_radius, tube_radius } => {
                self.parameter("ring", &[ring_radius])?;
                self.parameter("tube", &[tube_radius])
            }
            Shape::Patches(ref net) => self.net(&net.vertices, "patch", net.patches.iter().copied()),
            // The file runs along its curves the other way.
            Shape::Curves(ref net) => {
                self.net(&net.vertices, "curve", net.curves.iter().map(|&[a, b, c, d]| [d, c, b, a]))
            }
            Shape::Teapot(_) => Ok(()),
        }
    }

    /// Control points and indices on lines of their own.
    fn net<const SIZE: usize>(
        &mut self,
        vertices: &[Vec3],
        keyword: &str,
        pieces: impl Iterator<Item = [u32; SIZE]>,
    ) -> io::Result<()> {
        writeln!(self.out)?;
        self.depth += 1;
        vertices.iter().try_for_each(|vertex| self.line("v", &vertex.to_array()))?;
        for indices in pieces {
            // Whole numbers below 2^32: as f64 they print as they are.
            self.line(keyword, &indices.map(|index| f64::from(index) + 1.0))?;
        }
        self.depth -= 1;
        self.indent()
    }
}

fn is_cube(size: Vec3) -> bool {
    size == Vec3::splat(size.x)
}

/// What the language calls a shape.
fn word(shape: &Shape) -> &'static str {
    match *shape {
        Shape::Sphere { .. } => "sphere",
        Shape::Cone { .. } => "open_cone",
        Shape::Ellipsoid { .. } => "ellipsoid",
        Shape::CappedCone { bottom_radius, top_radius, .. } if bottom_radius == top_radius => "cylinder",
        Shape::CappedCone { .. } => "cone",
        Shape::Block { size } if is_cube(size) => "cube",
        Shape::Block { .. } => "block",
        Shape::Prism { .. } => "prism",
        Shape::Torus { .. } => "torus",
        Shape::Patches(_) | Shape::Curves(_) => "bezier",
        Shape::Teapot(part) => match part {
            TeapotPart::Whole => "teapot",
            TeapotPart::Body => "teapot_body",
            TeapotPart::Lid => "teapot_lid",
            TeapotPart::Handle => "teapot_handle",
            TeapotPart::Spout => "teapot_spout",
        },
    }
}
