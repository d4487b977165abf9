//! Measure: how many texels of a draped map a pixel of the view gets.
//!
//! drape, view -MEASURE-> texels a pixel, at points of the picture
//!
//! Around a place on the ground the map and the picture are linear: a step on the ground is a step in texels and a step in pixels. One divided
//! by the other is a matrix that takes a step of a pixel to texels, and its smaller singular value says how many texels the pixel's worst
//! direction gets. Less than 1 is blur; about 1 is as sharp as the screen.
//!
//! Where only its box is known, the land is somewhere between the bottom and the top, so rays of the view are taken to the bottom, the middle and the top of it. Where its
//! faces are, their middles are taken.
//!
//! Space: world, pixels, texels. Cost: some 30 products a point.

use super::body::half_picture;
use super::{Drape, View};
use crate::math::{Mat2, Vec2, Vec3};

/// Rays across and down.
const RAYS: [usize; 2] = [24, 18];

/// A place on the land and the upward normal of the land there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub point: Vec3,
    pub normal: Vec3,
}

/// Texels a pixel gets, over many pixels of a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texels {
    /// One in a hundred pixels gets fewer.
    pub first_percentile: f64,
    /// Every other one gets fewer.
    pub median: f64,
}

impl Texels {
    /// Of a map of `side` x `side` texels; `None` where none of the land is in view.
    #[must_use]
    pub fn of(drape: &Drape, view: &View, side: u32) -> Option<Texels> {
        Texels::at(drape, view, &points(view), side)
    }

    pub(super) fn at(drape: &Drape, view: &View, spots: &[Spot], side: u32) -> Option<Texels> {
        let mut texels: Vec<f64> = spots.iter().map(|&spot| texels_at(drape, view, spot)).collect();
        texels.sort_by(f64::total_cmp);
        let at = |index: usize| texels.get(index).map(|texels| texels * f64::from(side));
        Some(Texels { first_percentile: at(texels.len() / 100)?, median: at(texels.len() / 2)? })
    }
}

/// Places that rays of the view meet, at the bottom, in the middle and at the top of the land.
pub(super) fn points(view: &View) -> Vec<Spot> {
    let [low, high] = view.land;
    let half = half_picture(view);
    let mut points = Vec::new();
    for height in [low.z, (low.z + high.z) / 2.0, high.z] {
        for ray in 0..RAYS[0] * RAYS[1] {
            let part = |index: usize, count: usize| (2 * index + 1) as f64 / count as f64 - 1.0;
            let (x, y) = (part(ray % RAYS[0], RAYS[0]) * half[0], part(ray / RAYS[0], RAYS[1]) * half[1]);
            let direction = view.ahead + view.right * x + view.up * y;
            // The direction has length 1 along the view, so this is the depth.
            let depth = (height - view.from.z) / direction.z;
            let point = view.from + direction * depth;
            let inside = point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
            if inside && depth >= view.depths[0] && depth <= view.depths[1] {
                points.push(Spot { point: Vec3::new(point.x, point.y, height), normal: Vec3::Z });
            }
        }
    }
    points
}

/// The fewest that any of `spots` gets, in widths of the texture.
pub(super) fn worst(drape: &Drape, view: &View, spots: &[Spot]) -> f64 {
    spots.iter().map(|&spot| texels_at(drape, view, spot)).fold(f64::INFINITY, f64::min)
}

/// What a step of a pixel at a spot is on the map in its worst direction, in widths of the texture; 0 where nothing is known.
fn texels_at(drape: &Drape, view: &View, spot: Spot) -> f64 {
    let map = map_from_ground(&drape.texture_from_ground, spot.point.truncate());
    let smaller = smaller_singular_value(map * pixels_from_ground(view, spot).inverse());
    if smaller.is_finite() { smaller } else { 0.0 }
}

/// How the place on the map changes with that on the ground: the rule of quotients.
fn map_from_ground(matrix: &crate::math::Mat3, ground: Vec2) -> Mat2 {
    let place = *matrix * ground.extend(1.0);
    let column = |step: Vec3| (step.truncate() - place.truncate() * (step.z / place.z)) / place.z;
    Mat2::from_cols(column(matrix.x_axis), column(matrix.y_axis))
}

/// How the pixel changes with the place on the ground, which rises and falls as its normal says.
fn pixels_from_ground(view: &View, Spot { point, normal }: Spot) -> Mat2 {
    let arm = point - view.from;
    let depth = arm.dot(view.ahead);
    let (x, y) = (arm.dot(view.right) / depth, arm.dot(view.up) / depth);
    let column = |axis: Vec3| {
        let step = Vec2::new(axis.dot(view.right), axis.dot(view.up)) - Vec2::new(x, y) * axis.dot(view.ahead);
        step * (view.focal / depth)
    };
    let step = |axis: Vec3| axis - Vec3::Z * (normal.dot(axis) / normal.z);
    Mat2::from_cols(column(step(Vec3::X)), column(step(Vec3::Y)))
}

fn smaller_singular_value(matrix: Mat2) -> f64 {
    let squares = matrix.x_axis.length_squared() + matrix.y_axis.length_squared();
    let product = matrix.determinant().abs();
    let larger = ((squares + (squares * squares - 4.0 * product * product).max(0.0).sqrt()) / 2.0).sqrt();
    product / larger
}
