//! Eye: the camera that keys and pointer move: around the scene, through it, or over its ground.
//!
//! events -EYE-> Camera of the scene
//!
//! Orbit turns about the point in the middle of the picture. Fly goes where it looks. Walk goes where it looks, too, but
//! keeps its height: it moves square to the scene's up.
//!
//! Space: world, scene units; angles in radians. Sines are those of `math`: a path must not depend on the platform.

use super::path::Pose;
use crate::math::{PI, Vec3, acos, cos, sin, unit};
use crate::scene::Camera;

/// How keys move the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gait {
    /// About the middle of the picture.
    Orbit,
    /// Where it looks.
    Fly,
    /// Where it looks, at the same height.
    Walk,
}

impl Gait {
    /// All, in the order of the key.
    pub const ALL: [Gait; 3] = [Gait::Orbit, Gait::Fly, Gait::Walk];

    /// What the window calls it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Gait::Orbit => "orbit",
            Gait::Fly => "fly",
            Gait::Walk => "walk",
        }
    }
}

/// Where the eye is, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Where it is.
    pub pose: Pose,
    /// How it moves.
    pub gait: Gait,
    /// Steps of speed, negative backwards; see [`Eye::speed`].
    pub steps: i32,
    /// Of the scene: what is up for a walker.
    up: Vec3,
    /// Distance from the eye to the middle, of the scene's own view: the measure of speed.
    reach: f64,
}

/// The eye never looks straighter up or down than this far from the pole.
const POLE: f64 = 0.02;

impl Eye {
    /// The eye of the scene's own camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Eye {
        let pose = Pose { from: camera.from, at: camera.at, up: camera.up };
        let reach = (camera.at - camera.from).length();
        Eye { pose, gait: Gait::Orbit, steps: 0, up: unit(camera.up).unwrap_or(Vec3::Y), reach }
    }

    /// The same eye, which moves in that way.
    #[must_use]
    pub fn with_gait(self, gait: Gait) -> Eye {
        Eye { gait, ..self }
    }

    /// The camera of the scene, moved here. Hither stays what the scene's own view made of it.
    #[must_use]
    pub fn camera(&self, own: &Camera) -> Camera {
        let hither = if own.hither > 0.0 { own.hither } else { self.reach / 1000.0 };
        Camera { from: self.pose.from, at: self.pose.at, up: self.pose.up, hither, ..*own }
    }

    /// Scene units a second: nothing, then twice as fast with every step.
    #[must_use]
    pub fn speed(&self) -> f64 {
        let speed = self.reach / 16.0 * f64::from(1_u32 << (self.steps.unsigned_abs().saturating_sub(1)).min(12));
        if self.steps == 0 { 0.0 } else { speed * f64::from(self.steps.signum()) }
    }

    /// Turns by angles to the right and up; in orbit the eye goes round the middle, else it looks elsewhere.
    pub fn turn(&mut self, right: f64, up: f64) {
        let Some(forward) = unit(self.pose.at - self.pose.from) else { return };
        let distance = (self.pose.at - self.pose.from).length();
        let turned = self.turned(forward, right, up);
        match self.gait {
            Gait::Orbit => self.pose.from = self.pose.at - turned * distance,
            Gait::Fly | Gait::Walk => self.pose.at = self.pose.from + turned * distance,
        }
    }

    fn turned(&self, forward: Vec3, right: f64, up: f64) -> Vec3 {
        let about_up = rotated(forward, self.up, -right);
        let Some(side) = unit(about_up.cross(self.up)) else { return about_up };
        // From the pole: 0 looks along up.
        let polar = acos(about_up.dot(self.up).clamp(-1.0, 1.0));
        let up = polar - (polar - up).clamp(POLE, PI - POLE);
        unit(rotated(about_up, side, up)).unwrap_or(about_up)
    }

    /// Comes nearer to the middle, or goes away from it: `factor` times as far. Only in orbit.
    pub fn approach(&mut self, factor: f64) {
        let way = (self.pose.at - self.pose.from) * factor;
        if self.gait == Gait::Orbit && way.length() > self.reach * 1e-6 && way.length() < self.reach * 1e6 {
            self.pose.from = self.pose.at - way;
        }
    }

    /// Goes up by a share of the reach: eye and middle alike.
    pub fn rise(&mut self, share: f64) {
        let way = self.up * (self.reach * share);
        (self.pose.from, self.pose.at) = (self.pose.from + way, self.pose.at + way);
    }

    /// Goes on for some seconds; in orbit it stays.
    pub fn advance(&mut self, seconds: f64) {
        let forward = self.pose.at - self.pose.from;
        let direction = match self.gait {
            Gait::Orbit => None,
            Gait::Fly => unit(forward),
            Gait::Walk => unit(forward - self.up * forward.dot(self.up)),
        };
        let way = direction.map_or(Vec3::ZERO, |direction| direction * (self.speed() * seconds));
        (self.pose.from, self.pose.at) = (self.pose.from + way, self.pose.at + way);
    }

    /// Whether time moves it.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.gait != Gait::Orbit && self.steps != 0
    }

    /// Where on the ground north is: +y where z is up, -z where y is up; square to the scene's up.
    #[must_use]
    pub fn north(&self) -> Vec3 {
        let axis = if self.up.abs().max_element() == self.up.y.abs() { Vec3::NEG_Z } else { Vec3::Y };
        unit(axis - self.up * axis.dot(self.up)).unwrap_or(Vec3::X)
    }

    /// East: to the right of north, for somebody who stands upright.
    #[must_use]
    pub fn east(&self) -> Vec3 {
        self.north().cross(self.up)
    }

    /// What is up for a walker.
    #[must_use]
    pub fn upright(&self) -> Vec3 {
        self.up
    }
}

/// `vector` turned about the unit vector `axis`, counterclockwise seen from its tip. Source: Rodrigues 1840.
fn rotated(vector: Vec3, axis: Vec3, angle: f64) -> Vec3 {
    let (sine, cosine) = (sin(angle), cos(angle));
    vector * cosine + axis.cross(vector) * sine + axis * (axis.dot(vector) * (1.0 - cosine))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Place;

    fn eye(gait: Gait) -> Eye {
        let (from, at, up, place) = (Vec3::new(0.0, 0.0, 8.0), Vec3::ZERO, Vec3::Y, Place::default());
        let camera = Camera { from, at, up, angle: 45.0, hither: 0.0, yon: None, resolution: (8, 8), place };
        Eye { gait, ..Eye::new(&camera) }
    }

    #[test]
    fn orbit_keeps_its_distance_and_never_passes_the_pole() {
        let mut eye = eye(Gait::Orbit);
        let mut height = 0.0;
        for _ in 0..100 {
            eye.turn(0.1, 0.2);
            let rises = (eye.pose.at - eye.pose.from).y;
            assert!(rises > height - 1e-9, "over the pole: {rises} after {height}");
            height = rises;
        }
        let way = eye.pose.at - eye.pose.from;
        assert!((way.length() - 8.0).abs() < 1e-9 && eye.pose.at == Vec3::ZERO);
        assert!(way.normalize().y > 0.99 && way.normalize().y < 1.0);
    }

    #[test]
    fn right_is_right() {
        let mut walker = eye(Gait::Walk);
        walker.turn(PI / 2.0, 0.0);
        assert!((walker.pose.at - Vec3::new(8.0, 0.0, 8.0)).length() < 1e-9, "{:?}", walker.pose);
        let mut orbiter = eye(Gait::Orbit);
        orbiter.turn(PI / 2.0, 0.0);
        assert!((orbiter.pose.from - Vec3::new(-8.0, 0.0, 0.0)).length() < 1e-9);
        assert_eq!((orbiter.north(), orbiter.east()), (Vec3::NEG_Z, Vec3::X));
    }

    #[test]
    fn walking_keeps_the_height_and_flying_does_not() {
        let height = |gait: Gait| {
            let mut eye = eye(gait);
            eye.turn(0.0, 0.5);
            eye.steps = 3;
            eye.advance(1.0);
            (eye.speed(), eye.pose.from.y, eye.pose.from.z)
        };
        let (speed, walked, z) = height(Gait::Walk);
        assert_eq!((speed, walked), (2.0, 0.0));
        assert!((z - 6.0).abs() < 1e-9);
        assert!(height(Gait::Fly).1 > 0.9);
        assert_eq!(height(Gait::Orbit).2, eye(Gait::Orbit).pose.from.z * cos(0.5));
    }

    #[test]
    fn hither_does_not_change_on_the_way() {
        let mut eye = eye(Gait::Orbit);
        eye.approach(0.5);
        let own = Camera { hither: -1.0, ..eye.camera(&camera_of(&eye)) };
        assert_eq!(eye.camera(&own).hither, 0.008);
        assert_eq!((eye.pose.from.z, eye.is_moving()), (4.0, false));
    }

    fn camera_of(eye: &Eye) -> Camera {
        let Pose { from, at, up } = eye.pose;
        Camera { from, at, up, angle: 45.0, hither: 0.0, yon: None, resolution: (8, 8), place: Place::default() }
    }
}
