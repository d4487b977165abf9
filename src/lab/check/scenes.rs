//! Scenes: the polygons, meshes and pictures that several experiments draw.
//!
//! Space: outlines in samples; meshes in eye space, which is world space with z turned round, because the camera stands at
//! the origin and looks along -z with an opening of 90 degrees.

use super::Random;
use crate::color::Rgb;
use crate::math::{Affine3, Vec3};
use crate::plan::Transparency;
use crate::raster::{Frame, PutCounts, Rasterizer, Scanline, Watkins, ZBuffer};
use crate::scene::{Camera, Light, Material, Mesh, Object, ObjectId, Place, Scene, Surface, SurfaceId};
use crate::screen::{DrawList, Plane};

/// A point of an outline.
pub(super) type Point = (f64, f64);

/// What a rasterizer left of a list.
pub(super) struct Drawn {
    /// The polygon that every sample shows.
    pub owner: Vec<Option<u32>>,
    /// What was put.
    pub puts: PutCounts,
}

/// Draws all rows of `list` on `threads` threads.
pub(super) fn draw(list: &DrawList, rasterizer: &dyn Rasterizer, threads: u32) -> Drawn {
    let mut frame = Frame::default();
    let size = (list.width, list.height);
    let target = frame.target(size, 0..list.height, Rgb::gray(0.0), Transparency::Over);
    let mut target = target.with_threads(threads);
    rasterizer.draw(list, &mut target);
    let puts = target.finish();
    let samples = list.width as usize * list.height as usize;
    Drawn { owner: (0..samples).map(|index| frame.sample(index).0).collect(), puts }
}

/// The built-in rasterizers that draw areas.
pub(super) const AREA_RASTERIZERS: [(&str, &(dyn Rasterizer + Sync)); 3] =
    [("zbuffer", &ZBuffer), ("watkins", &Watkins), ("scanline", &Scanline)];

/// Gives every polygon of `list` a constant depth, each nearer than the one before: whoever draws in order puts every covered
/// sample of every polygon, so nothing that is drawn twice can hide.
pub(super) fn stack(list: &mut DrawList) {
    let numbers = list.varying.count();
    for index in 0..list.polygons.len() {
        list.polygons[index].first_plane = list.planes.len() as u32;
        list.planes.push(Plane::constant(1.0 + index as f64 / 65_536.0, list.precision));
        list.planes.extend((0..numbers).map(|_| Plane::constant(1.0, list.precision)));
    }
}

/// A random outline within `width` x `height` samples; `adversarial` ones are made of what rounding gets wrong.
pub(super) fn outline(random: &mut Random, (width, height): (u32, u32), adversarial: bool) -> Vec<Point> {
    let (width, height) = (f64::from(width), f64::from(height));
    let corners = 3 + random.below(6);
    let mut anywhere = |step: f64| {
        let mut along = |end: f64| {
            let at = random.between(0.0, end);
            // On sample centers, on their 256ths, or wherever.
            (if step > 0.0 { (at / step).floor() * step + if step == 1.0 { 0.5 } else { 0.0 } } else { at }).min(end)
        };
        (along(width), along(height))
    };
    if !adversarial {
        return (0..corners).map(|_| anywhere(0.0)).collect();
    }
    let [a, b, c] = [anywhere(1.0), anywhere(1.0), anywhere(1.0)];
    let fine = [anywhere(1.0 / 256.0), anywhere(1.0 / 256.0)];
    match random.below(6) {
        // Corners on sample centers.
        0 => (0..corners).map(|index| [a, b, c][index as usize % 3]).take(3).collect(),
        // Edges along rows and columns of centers.
        1 => vec![a, (b.0, a.1), b, (a.0, b.1)],
        // A sliver beside the line from a to b, a step or two wide.
        2 => {
            let share = random.unit();
            let step = (1.0 + random.below(2) as f64) / 256.0;
            vec![a, b, ((a.0 + (b.0 - a.0) * share).min(width - step) + step, a.1 + (b.1 - a.1) * share)]
        }
        // On the finest steps, two of them on one center.
        3 => vec![fine[0], a, fine[1]],
        // Concave: a notch down to a center.
        4 => vec![(0.0, 0.0), (width, 0.0), (width, height), c, (0.0, height)],
        // Touches itself: two triangles that share the corner c, in one outline.
        _ => vec![a, c, b, fine[0], c, fine[1]],
    }
}

/// A camera at the origin that looks along -z with an opening of 90 degrees.
pub(super) fn camera(width: u32, height: u32) -> Camera {
    let (from, at, up) = (Vec3::ZERO, Vec3::NEG_Z, Vec3::Y);
    let resolution = (width, height);
    Camera { from, at, up, angle: 90.0, hither: 1e-3, yon: None, resolution, place: Place::default() }
}

/// The world point at the eye-space point (x, y, w).
pub(super) fn world(eye: Vec3) -> Vec3 {
    Vec3::new(eye.x, eye.y, -eye.z)
}

/// One object of one surface, a white light beside the eye.
pub(super) fn scene(camera: Camera, material: Material, mesh: Mesh, two_sided: bool) -> Scene {
    let place = Place::default();
    let surface = Surface { material, mesh, primitives: Vec::new(), two_sided, place };
    let surfaces = vec![SurfaceId(0)];
    let object =
        Object { name: String::new(), parent_from_local: Affine3::IDENTITY, surfaces, children: Vec::new(), place };
    Scene {
        facing: std::collections::BTreeSet::new(),
        textures: Vec::new(),
        files: vec!["check".into()],
        objects: vec![object],
        surfaces: vec![surface],
        world: vec![ObjectId(0)],
        lights: vec![Light::point(Vec3::new(-3.0, 4.0, 2.0), Rgb::WHITE, place)],
        camera: Some(camera),
        background: None,
    }
}
