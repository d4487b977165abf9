//! A case: a small picture made of a few faces, in numbers that have exact answers.
//!
//! Face -CASE-> DrawList -> subject; the same faces -> [`super::rules`], which draws them right or with one mistake
//!
//! Why faces and not scenes: here depth and colors are planes written down, not results of a geometry stage. Corners are
//! multiples of 1/256.
//!
//! Space: samples; colors are linear light.

use super::lines::rule::Ink;
use crate::color::{Encoding, Rgb};
use crate::geometry::split::{SplitScratch, split};
use crate::math::Vec3;
use crate::plan::{Accepts, Transparency, Varying};
use crate::screen::file::Sheet;
use crate::screen::shader::{EyeLight, SurfaceShading};
use crate::screen::{DrawList, EdgeKind, Plane, PolygonRecord, ScreenVertex, Source};

/// A polygon on the screen with the planes of 1/w and of three values over w.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Around the outline, in samples.
    pub corners: Vec<(f64, f64)>,
    /// a, b, c of 1/w = a x + b y + c.
    pub inverse_w: [f64; 3],
    /// The same of red, green, blue (in a lit case: of the normal) over w.
    pub over_w: [[f64; 3]; 3],
    /// 1 hides what is behind.
    pub opacity: f64,
}

/// The light of a lit case: one lamp or two, one material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Eye space.
    pub position: Vec3,
    /// Of its light.
    pub color: [f64; 3],
    /// Another lamp: its place and its color.
    pub second: Option<(Vec3, [f64; 3])>,
    /// Ka Ia C: light where no lamp reaches.
    pub ambient: [f64; 3],
    /// Kd C.
    pub diffuse: [f64; 3],
    /// Ks.
    pub specular: f64,
    /// Exponent of the highlight.
    pub shine: f64,
}

impl Lamp {
    /// Place and color of each lamp.
    pub fn lamps(&self) -> impl Iterator<Item = (Vec3, [f64; 3])> + use<> {
        [Some((self.position, self.color)), self.second].into_iter().flatten()
    }
}

/// A small picture to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// A few words.
    pub name: String,
    /// Samples across.
    pub width: u32,
    /// Samples down.
    pub height: u32,
    /// A x A samples make a pixel.
    pub samples: u32,
    /// In list order.
    pub faces: Vec<Face>,
    /// Behind everything.
    pub background: [f64; 3],
    /// Values are normals, and this lights them.
    pub lamp: Option<Lamp>,
    /// Only the edges are drawn.
    pub lines: bool,
    /// Who draws it may answer samples as levels: the mean of a pixel is then that of rounded numbers.
    pub answered_in_levels: bool,
}

impl Face {
    /// One color, facing the viewer.
    #[must_use]
    pub fn flat(corners: &[(f64, f64)], depth: f64, color: [f64; 3]) -> Face {
        let over_w = color.map(|channel| [0.0, 0.0, channel * depth]);
        Face { corners: corners.to_vec(), inverse_w: [0.0, 0.0, depth], over_w, opacity: 1.0 }
    }

    /// One color, slanted: 1/w at three corners of the outline's first three.
    #[must_use]
    pub fn slanted(corners: &[(f64, f64)], inverse_w: [f64; 3], color: [f64; 3]) -> Face {
        let plane = plane_through([corners[0], corners[1], corners[2]], inverse_w);
        let over_w = color.map(|channel| plane.map(|number| number * channel));
        Face { corners: corners.to_vec(), inverse_w: plane, over_w, opacity: 1.0 }
    }

    /// A triangle with a w and three values at every corner.
    #[must_use]
    pub fn smooth(corners: [(f64, f64); 3], w: [f64; 3], values: [[f64; 3]; 3]) -> Face {
        let inverse_w = plane_through(corners, w.map(|w| 1.0 / w));
        let over = |number: usize| plane_through(corners, [0, 1, 2].map(|corner| values[corner][number] / w[corner]));
        Face { corners: corners.to_vec(), inverse_w, over_w: [over(0), over(1), over(2)], opacity: 1.0 }
    }

    /// The same with another opacity.
    #[must_use]
    pub fn with_opacity(self, opacity: f64) -> Face {
        Face { opacity, ..self }
    }

    /// 1/w at a point.
    #[must_use]
    pub fn inverse_w_at(&self, point: (f64, f64)) -> f64 {
        at(self.inverse_w, point)
    }

    /// The three values at a point.
    #[must_use]
    pub fn values_at(&self, point: (f64, f64)) -> [f64; 3] {
        let inverse_w = self.inverse_w_at(point);
        self.over_w.map(|plane| at(plane, point) / inverse_w)
    }

    /// Whether the three values are the same all over it.
    #[must_use]
    pub fn is_flat(&self) -> bool {
        let first = self.values_at(self.corners[0]);
        self.corners
            .iter()
            .all(|&corner| self.values_at(corner).iter().zip(first).all(|(value, first)| (value - first).abs() < 1e-12))
    }

    /// The same face moved.
    #[must_use]
    pub fn moved(&self, (dx, dy): (f64, f64)) -> Face {
        let shift = |[a, b, c]: [f64; 3]| [a, b, c - a * dx - b * dy];
        let corners = self.corners.iter().map(|&(x, y)| (x + dx, y + dy)).collect();
        Face { corners, inverse_w: shift(self.inverse_w), over_w: self.over_w.map(shift), opacity: self.opacity }
    }
}

fn at([a, b, c]: [f64; 3], (x, y): (f64, f64)) -> f64 {
    a * x + b * y + c
}

/// The plane that takes `values` at three points; without area, the first value everywhere.
pub(super) fn plane_through([p, q, r]: [(f64, f64); 3], values: [f64; 3]) -> [f64; 3] {
    let (ux, uy, vx, vy) = (q.0 - p.0, q.1 - p.1, r.0 - p.0, r.1 - p.1);
    let area = ux * vy - uy * vx;
    let (du, dv) = (values[1] - values[0], values[2] - values[0]);
    if area == 0.0 || (du == 0.0 && dv == 0.0) {
        return [0.0, 0.0, values[0]];
    }
    let (a, b) = ((du * vy - dv * uy) / area, (dv * ux - du * vx) / area);
    [a, b, values[0] - a * p.0 - b * p.1]
}

impl Case {
    /// A picture of `width` x `height` on black.
    #[must_use]
    pub fn new(name: &str, (width, height): (u32, u32), faces: Vec<Face>) -> Case {
        let (background, lamp, name) = ([0.0; 3], None, name.to_string());
        Case { name, width, height, samples: 1, faces, background, lamp, lines: false, answered_in_levels: false }
    }

    /// The same picture of the polygons that a rasterizer accepts: what is wrong with triangles is wrong with each of them.
    #[must_use]
    pub fn cut_for(mut self, accepts: Accepts) -> Case {
        let lines = self.lines;
        let cut = |face: Face| {
            let parts = pieces(&face.corners, accepts, lines);
            parts.into_iter().map(move |corners| Face { corners, ..face.clone() })
        };
        self.faces = self.faces.into_iter().flat_map(cut).collect();
        self
    }

    /// What else the picture depends on.
    #[must_use]
    pub fn sheet(&self) -> Sheet {
        let background = Rgb::from(self.background).to_f32();
        Sheet { samples: self.samples, background, transparency: Transparency::Over, encoding: Encoding::Linear }
    }

    /// The case as a rasterizer gets it.
    #[must_use]
    pub fn list(&self, accepts: Accepts) -> DrawList {
        let mut list = DrawList::new(self.width, self.height);
        list.has_blending = self.faces.iter().any(|face| face.opacity < 1.0);
        if self.lines {
            (list.varying, list.has_depth) = (Varying::Nothing, false);
            list.shader.line_color = Rgb::from(Ink::Right.on(self.background)).to_f32();
        }
        if let Some(lamp) = self.lamp {
            list.varying = Varying::NormalEye;
            let lights = lamp.lamps().map(|(position, color)| EyeLight::point(position, Rgb::from(color)));
            list.shader.lights.extend(lights);
        }
        for face in &self.faces {
            self.push(face, accepts, &mut list);
        }
        list
    }

    fn push(&self, face: &Face, accepts: Accepts, list: &mut DrawList) {
        let surface = list.shader.push_unlit_surface();
        let record = &mut list.shader.surfaces[surface as usize];
        record.opacity = Rgb::gray(face.opacity as f32);
        if let Some(lamp) = self.lamp {
            let (ambient, diffuse) = (Rgb::from(lamp.ambient), Rgb::from(lamp.diffuse));
            let (specular, shine) = (lamp.specular, lamp.shine);
            *record = SurfaceShading { ambient, diffuse, specular, shine, ..*record };
        }
        let first_plane = list.planes.len() as u32;
        if !self.lines {
            self.push_planes(face, list);
        }
        for corners in pieces(&face.corners, accepts, self.lines) {
            let first_vertex = list.vertices.len() as u32;
            for &corner in &corners {
                self.push_vertex(face, corner, list);
            }
            let vertex_count = corners.len() as u32;
            let source = Source::default();
            list.polygons.push(PolygonRecord { first_vertex, vertex_count, first_plane, surface, source });
        }
    }

    fn push_vertex(&self, face: &Face, (x, y): (f64, f64), list: &mut DrawList) {
        let w = 1.0 / if self.lines { 1.0 } else { face.inverse_w_at((x, y)) };
        let homogeneous = Vec3::new(x, y, 1.0) * w;
        list.vertices.push(ScreenVertex { x, y, homogeneous, edge: EdgeKind::Original });
        if self.lines {
            return;
        }
        list.values.extend_from_slice(&face.values_at((x, y)));
        if self.lamp.is_some() {
            list.values.extend_from_slice(&self.eye((x, y), w).to_array());
        }
    }

    fn push_planes(&self, face: &Face, list: &mut DrawList) {
        let range = |value: &dyn Fn((f64, f64)) -> f64| {
            let values = face.corners.iter().map(|&corner| value(corner));
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
        };
        let precision = list.precision;
        let depths = range(&|corner| face.inverse_w_at(corner));
        list.planes.push(Plane::new(face.inverse_w, depths, depths, precision));
        for number in 0..3 {
            let values = range(&|corner| face.values_at(corner)[number]);
            let planes = range(&|corner| at(face.over_w[number], corner));
            let is_constant = values.1 - values.0 < 1e-12;
            list.planes.push(match is_constant {
                true => Plane::constant(values.0, precision),
                false => Plane::new(face.over_w[number], planes, values, precision),
            });
        }
        if self.lamp.is_none() {
            return;
        }
        for axis in 0..3 {
            let plane = self.eye_plane(axis);
            let values = range(&|corner| self.eye(corner, 1.0 / face.inverse_w_at(corner))[axis]);
            let planes = range(&|corner| at(plane, corner));
            list.planes.push(Plane::new(plane, planes, values, precision));
        }
    }

    /// Plane of an eye coordinate over w: the picture is `width` samples across at distance `width`.
    fn eye_plane(&self, axis: usize) -> [f64; 3] {
        let (scale, middle) = (f64::from(self.width), (f64::from(self.width) / 2.0, f64::from(self.height) / 2.0));
        match axis {
            0 => [1.0 / scale, 0.0, -middle.0 / scale],
            1 => [0.0, -1.0 / scale, middle.1 / scale],
            _ => [0.0, 0.0, 1.0],
        }
    }

    /// The point in eye space that is seen at a point of the screen, at distance w.
    #[must_use]
    pub fn eye(&self, point: (f64, f64), w: f64) -> Vec3 {
        let axis = |axis: usize| at(self.eye_plane(axis), point) * w;
        Vec3::new(axis(0), axis(1), axis(2))
    }
}

/// The corners whole, or of the triangles that cover the same samples.
fn pieces(corners: &[(f64, f64)], accepts: Accepts, lines: bool) -> Vec<Vec<(f64, f64)>> {
    if accepts == Accepts::AnyPolygon || lines || corners.len() == 3 {
        return vec![corners.to_vec()];
    }
    let outline: Vec<_> = corners.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
    let mut triangles = Vec::new();
    split(&outline, crate::math::newell_normal(&outline), &mut SplitScratch::default(), &mut triangles);
    triangles.iter().map(|triangle| triangle.map(|corner| corners[corner as usize]).to_vec()).collect()
}
