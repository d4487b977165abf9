//! Warp: the matrices of drapes.
//!
//! what can be seen -WARP-> a square of texels around it
//!
//! With the sun straight above, the perspective of Wimmer and others has its center on the ground's level behind what can be seen, and looks
//! along the ground where the observer looks. At a distance w from the center, across becomes x/w, along becomes -1/w: twice as far is half as
//! large. Then the box around what can be seen is stretched over the texture.
//!
//! Corrected from the paper, as it is printed: its center is the eye, and what is beside or behind the eye (a view steeply down) has
//! w <= 0; the authors' program steps back from the eye by n - near, their formula's number, which mends most of it. Here the center lies
//! n behind the nearest point that can be seen: w >= n > 0, whatever the view.
//!
//! Space: ground in, (s, t, q) out. Cost: one pass over the corners of what can be seen.

use super::{Drape, View};
use crate::math::{Mat3, Vec2, Vec3};

/// The observer on the ground: where, and which way is ahead and right.
pub(super) struct Ahead {
    eye: Vec2,
    right: Vec2,
    ahead: Vec2,
    /// Sine of the angle between the view and straight down (or up).
    sine: f64,
}

/// Evenly, north up; `None` where nothing can be seen, or nothing but a line.
pub(super) fn uniform(body: &[Vec3]) -> Option<Drape> {
    let even = |point: Vec3| Vec3::new(point.x, point.y, 1.0);
    let texture_from_ground = fitted(body, &Mat3::IDENTITY, even)?;
    Some(Drape { texture_from_ground, strength: None })
}

impl Ahead {
    /// Straight down there is no ahead: then what is up in the picture is.
    pub fn of(view: &View) -> Ahead {
        let flat = |axis: Vec3| axis.truncate().normalize_or_zero();
        let sine = (1.0 - view.ahead.z * view.ahead.z).max(0.0).sqrt();
        let ahead = match flat(view.ahead) {
            ahead if sine > 1e-9 && ahead != Vec2::ZERO => ahead,
            _ => flat(view.up),
        };
        Ahead { eye: view.from.truncate(), right: Vec2::new(ahead.y, -ahead.x), ahead, sine }
    }

    fn along(&self, point: Vec3) -> f64 {
        (point.truncate() - self.eye).dot(self.ahead)
    }

    /// The nearest and the farthest of what can be seen, along the ground from the eye.
    fn reach(&self, body: &[Vec3]) -> [f64; 2] {
        body.iter()
            .map(|&point| self.along(point))
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[near, far], along| [near.min(along), far.max(along)])
    }

    /// How deep what can be seen is.
    pub fn depth(&self, body: &[Vec3]) -> f64 {
        let [near, far] = self.reach(body);
        far - near
    }

    /// The perspective from `strength` behind what can be seen.
    pub fn perspective(&self, body: &[Vec3], strength: f64) -> Option<Drape> {
        self.centered(body, self.reach(body)[0] - strength)
    }

    /// The paper's: from the eye. Its number n cancels out when the box is stretched over the texture.
    pub fn thesis(&self, body: &[Vec3]) -> Option<Drape> {
        self.centered(body, 0.0)
    }

    /// That of the authors' program: n - near behind the eye.
    pub fn program(&self, body: &[Vec3], near: f64) -> Option<Drape> {
        // Straight down their n is infinite: evenly, then.
        if self.sine < 1e-6 {
            return uniform(body);
        }
        let nearest = near / self.sine;
        let farthest = nearest + self.depth(body) * self.sine;
        let n = (nearest + (nearest * farthest).sqrt()) / self.sine;
        self.centered(body, near - n)
    }

    /// From a center so far ahead of the eye; `None` if something to be seen is not ahead of it.
    fn centered(&self, body: &[Vec3], center: f64) -> Option<Drape> {
        let nearest = self.reach(body)[0];
        if nearest.is_nan() || nearest <= center {
            return None;
        }
        // Rows of (across, -1, w) over (x, y, 1).
        let across = self.right.extend(-self.right.dot(self.eye));
        let w = self.ahead.extend(-self.ahead.dot(self.eye) - center);
        let rows = Mat3::from_cols(across, -Vec3::Z, w).transpose();
        let texture_from_ground = fitted(body, &rows, |point| rows * point.truncate().extend(1.0))?;
        Some(Drape { texture_from_ground, strength: Some(nearest - center) })
    }
}

/// `rows`, then the box around where they take the `body` stretched over the square from 0 to 1.
fn fitted(body: &[Vec3], rows: &Mat3, place: impl Fn(Vec3) -> Vec3) -> Option<Mat3> {
    let places = body.iter().map(|&point| place(point)).map(|place| place.truncate() / place.z);
    let (low, high) =
        places.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), place| (low.min(place), high.max(place)));
    let size = high - low;
    if !(size.x > 0.0 && size.y > 0.0 && size.is_finite()) {
        return None;
    }
    let stretch = Mat3::from_cols(
        Vec3::new(1.0 / size.x, 0.0, 0.0),
        Vec3::new(0.0, 1.0 / size.y, 0.0),
        Vec3::new(-low.x / size.x, -low.y / size.y, 1.0),
    );
    Some(stretch * *rows)
}
