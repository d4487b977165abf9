//! Drape: where on a picture of a map every place on the ground is.
//!
//! view, box of the land -BODY-> what of the land can be seen -WARP-> 3 x 3 matrix -MEASURE-> texels a pixel gets
//!
//! A map is drawn into a texture and the texture is laid on the land. Laid on evenly, a far view leaves a few texels to the ground before
//! the observer's feet, and roads are blurred. So the map is drawn in a perspective of its own, in which what is near is large (light space
//! perspective shadow maps, with the sun straight above). That perspective looks along the ground: height has no part in it, so a map stays
//! where it belongs on any relief, and the matrix takes a place on the ground alone, (x, y, 1), to (s, t, q); s/q and t/q are the place on the texture.
//!
//! Why a search: one number is free, how strong the perspective is. The paper and the authors' later program have a formula for it each, good for
//! some views and bad for others. Here the number is sought that makes the worst pixel best.
//!
//! Space: metres, x east, y north, z up; textures from 0 to 1. Sources: paper 001; M. Wimmer, D. Scherzer, W. Purgathofer, "Light Space
//! Perspective Shadow Maps", EGSR 2004. Cost: some hundred points a try, some 130 tries a view.

mod body;
mod measure;
mod warp;

pub use measure::Texels;

use super::frustum;
use crate::math::{Mat3, Vec2, Vec3, newell_normal};
use crate::scene::Camera;
use measure::Spot;

/// A picture of the land: who looks, how far, and the box that the land lies in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The eye.
    pub from: Vec3,
    /// Unit vectors to the right, up, and along the view.
    pub right: Vec3,
    /// See `right`.
    pub up: Vec3,
    /// See `right`.
    pub ahead: Vec3,
    /// Pixels that a length of 1 has at distance 1.
    pub focal: f64,
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Distances along the view between which there is something to see.
    pub depths: [f64; 2],
    /// The lowest and the highest corner of the box.
    pub land: [Vec3; 2],
}

/// How the map is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Evenly, north up: as much of the land as can be seen.
    Uniform,
    /// The paper's perspective, from the eye.
    Thesis,
    /// That of its source's program: from behind the eye.
    Program,
    /// The perspective that makes the worst pixel best; evenly where that is better still.
    Searched,
}

/// A map laid on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drape {
    /// Takes (x, y, 1) on the ground to (s, t, q).
    pub texture_from_ground: Mat3,
    /// How far behind the nearest of what can be seen the map's perspective has its center, in metres; `None`: it has none.
    pub strength: Option<f64>,
}

impl View {
    /// What `camera` sees in a picture of `size`, of land in the box from `low` to `high`, no farther than `horizon`.
    ///
    /// The nearest is the camera's near plane, or a thousandth of the way to where it looks.
    #[must_use]
    pub fn of_camera(camera: &Camera, size: (u32, u32), horizon: f64, land: [Vec3; 2]) -> View {
        let way = camera.at - camera.from;
        let ahead = way.normalize_or_zero();
        let right = ahead.cross(camera.up).normalize_or_zero();
        let near = if camera.hither > 0.0 { camera.hither } else { way.length() / 1000.0 };
        let (up, focal) = (right.cross(ahead), frustum::focal(camera, size));
        View { from: camera.from, right, up, ahead, focal, size, depths: [near, horizon], land }
    }
}

impl View {
    /// How wide a pixel is across the view, at a place on the ground half as high as the land.
    #[must_use]
    pub fn metres_a_pixel(&self, [x, y]: [f64; 2]) -> f64 {
        let height = (self.land[0].z + self.land[1].z) / 2.0;
        let depth = (Vec3::new(x, y, height) - self.from).dot(self.ahead);
        depth.max(self.depths[0]) / self.focal
    }
}

impl Drape {
    /// The drape for `view`; `None` where none of the land is in view, or the method has no answer: the paper's where something to be seen is beside or
    /// behind the eye.
    #[must_use]
    pub fn new(method: Method, view: &View) -> Option<Drape> {
        let body = body::seen(view);
        Drape::by(method, view, &body, &measure::points(view))
    }

    /// The drape for the faces of the land itself, and how many texels of `side` x `side` a pixel gets on them. The box of a mountain holds much air, and a
    /// map need not be sharp there.
    #[must_use]
    pub fn on_land<'a>(
        method: Method,
        view: &View,
        side: u32,
        faces: impl Iterator<Item = &'a [Vec3]>,
    ) -> Option<(Drape, Texels)> {
        let (mut body, mut spots) = (Vec::new(), Vec::new());
        for face in faces {
            let part = body::in_view(view, face);
            let normal = newell_normal(face);
            let is_upright = normal.z > 0.0 && part.len() > 2;
            let middle = part.iter().sum::<Vec3>() / part.len().max(1) as f64;
            // What turns away from the eye shows nothing.
            if is_upright && normal.dot(view.from - middle) > 0.0 {
                spots.push(Spot { point: middle, normal });
            }
            body.extend(part);
        }
        let spots: Vec<Spot> = spots.iter().step_by(spots.len().div_ceil(MOST_SPOTS).max(1)).copied().collect();
        let drape = Drape::by(method, view, &body, &spots)?;
        Some((drape, Texels::at(&drape, view, &spots, side)?))
    }

    fn by(method: Method, view: &View, body: &[Vec3], spots: &[Spot]) -> Option<Drape> {
        match method {
            Method::Uniform => warp::uniform(body),
            Method::Thesis => warp::Ahead::of(view).thesis(body),
            Method::Program => warp::Ahead::of(view).program(body, view.depths[0]),
            Method::Searched => searched(view, body, spots),
        }
    }

    /// The place on the texture of a place on the ground, from 0 to 1 where it can be seen; `None` behind the center of the perspective.
    #[must_use]
    pub fn place(&self, ground: Vec2) -> Option<Vec2> {
        let place = self.texture_from_ground * ground.extend(1.0);
        (place.z > 0.0).then(|| place.truncate() / place.z)
    }
}

/// The weakest and the strongest perspective that are tried differ by this, a tenth of it at a step of a power of ten's twentieth.
const STEPS: usize = 120;
/// 10 to the power of 1/20.
const STEP: f64 = 1.122_018_454_301_963_3;
/// Spots of the land that a drape is judged by.
const MOST_SPOTS: usize = 1500;
/// Halvings of the step around the best.
const HALVINGS: usize = 5;

fn searched(view: &View, body: &[Vec3], spots: &[Spot]) -> Option<Drape> {
    let uniform = warp::uniform(body)?;
    let ahead = warp::Ahead::of(view);
    let worst = |drape: &Drape| measure::worst(drape, view, spots);
    let depth = ahead.depth(body);
    let mut best = (worst(&uniform), uniform);
    let mut strength = depth * 1e-3;
    for _ in 0..STEPS {
        best = better(best, ahead.perspective(body, strength), &worst);
        strength *= STEP;
    }
    let mut step = STEP;
    for _ in 0..HALVINGS {
        step = step.sqrt();
        let Some(middle) = best.1.strength else { break };
        for strength in [middle / step, middle * step] {
            best = better(best, ahead.perspective(body, strength), &worst);
        }
    }
    Some(best.1)
}

fn better(best: (f64, Drape), other: Option<Drape>, worst: &impl Fn(&Drape) -> f64) -> (f64, Drape) {
    match other.map(|drape| (worst(&drape), drape)) {
        Some(other) if other.0 > best.0 => other,
        _ => best,
    }
}

#[cfg(test)]
mod tests;
