//! The shapes of NFF and SIPP: what a file says in one line and a picture needs as many polygons.
//!
//! Space: the local space of the object. [`crate::model`] turns them into polygons.
//! Source: E. Haines, NFF; J. Yngvesson and I. Wallin, "SIPP User's Guide".

use crate::math::Vec3;
use std::sync::Arc;

/// A shape of the file and its place in the order of the surface's polygons.
#[derive(Clone, Debug, PartialEq)]
pub struct Primitive {
    /// What it is, in local space.
    pub shape: Shape,
    /// Only the inside is visible (NFF writes this as a negative radius).
    pub inside: bool,
    /// It comes before this polygon of [`Surface::mesh`](super::Surface::mesh) (or after all, if this is the number of polygons).
    pub before: u32,
    /// 1-based line in the file of the surface.
    pub line: u32,
    /// How finely the file wants it cut up, SIPP's `res`; two numbers for a torus (around the ring, around the tube), else equal.
    /// `None`: as fine as the picture needs.
    pub resolution: Option<[u32; 2]>,
    /// How texture coordinates lie on it; kept for the printer until textures come.
    pub texture: TextureMapping,
}

impl Primitive {
    /// `shape` seen from outside, as fine as the picture needs, behind `before` polygons.
    #[must_use]
    pub fn new(shape: Shape, before: u32, line: u32) -> Primitive {
        Primitive { shape, inside: false, before, line, resolution: None, texture: TextureMapping::default() }
    }
}

/// How texture coordinates lie on a shape; SIPP's four modes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TextureMapping {
    /// The shape's own parameters.
    Natural,
    /// Around the z axis.
    Cylindrical,
    /// Around the origin.
    Spherical,
    /// The local coordinates themselves, SIPP's default.
    #[default]
    World,
}

/// The shapes. Radii and sizes are positive, or zero at one end of a cone.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points at `radius` from `center`.
    Sphere {
        /// Local space.
        center: Vec3,
        /// Local units.
        radius: f64,
    },
    /// A cone or, with equal radii, a cylinder: the side only, open at both ends (NFF).
    ///
    /// Where `base` and `apex` coincide it is the flat disc or ring between the two radii, facing +z.
    Cone {
        /// Center of the first end.
        base: Vec3,
        /// Radius there.
        base_radius: f64,
        /// Center of the other end.
        apex: Vec3,
        /// Radius there.
        apex_radius: f64,
    },
    /// A sphere about the origin, scaled along the axes (SIPP).
    Ellipsoid {
        /// Half axes along x, y and z.
        radii: Vec3,
    },
    /// A cone or cylinder about the z axis from -length/2 to length/2, closed at ends with a radius above 0 (SIPP).
    CappedCone {
        /// Radius at z = -length/2.
        bottom_radius: f64,
        /// Radius at z = length/2.
        top_radius: f64,
        /// Local units.
        length: f64,
    },
    /// A box about the origin (SIPP's block and cube).
    Block {
        /// Full size along x, y and z.
        size: Vec3,
    },
    /// An outline in the xy plane, raised from z = -height/2 to height/2 and closed (SIPP).
    Prism {
        /// Counterclockwise seen from +z; simple, may be concave; at least 3 points.
        outline: Arc<[[f64; 2]]>,
        /// Local units.
        height: f64,
    },
    /// A ring about the z axis (SIPP).
    Torus {
        /// From the origin to the middle of the tube.
        ring_radius: f64,
        /// Of the tube.
        tube_radius: f64,
    },
    /// Bicubic Bezier patches (SIPP).
    Patches(Arc<PatchNet>),
    /// Cubic Bezier curves turned about the z axis (SIPP).
    Curves(Arc<CurveNet>),
    /// Newell's teapot or a part of it, at a quarter of its size, z up, base at z = 0 (SIPP).
    Teapot(TeapotPart),
}

/// Control points of Bezier patches. Every index is valid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchNet {
    /// Local space.
    pub vertices: Vec<Vec3>,
    /// 16 indices a patch: u along the row, v across rows. The front is where du x dv points: u to the right, v upward.
    pub patches: Vec<[u32; 16]>,
}

/// Control points of Bezier curves that turn about the z axis. Every index is valid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CurveNet {
    /// Local space.
    pub vertices: Vec<Vec3>,
    /// 4 indices a curve; the front is on the right-hand side of a curve that runs upward at x > 0, y = 0, seen from -y.
    pub curves: Vec<[u32; 4]>,
}

/// Which part of the teapot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TeapotPart {
    /// All four.
    #[default]
    Whole,
    /// Three curves of rotation.
    Body,
    /// Two curves of rotation.
    Lid,
    /// Four patches.
    Handle,
    /// Four patches.
    Spout,
}
