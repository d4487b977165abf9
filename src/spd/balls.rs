//! balls: the sphereflake, (9^(size + 1) - 1) / 8 mirroring spheres over a floor.
//!
//! What it tests: spheres of very different radius, reflection, depth of recursion. Every sphere carries nine of a
//! third of its radius: six around its equator, three above.
//!
//! Source: SPD 3.14; E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::rounded::{acos, asin};
use super::turn::{rotation, rotation_y, rotation_z};
use super::{Counts, SpdScene, power};
use crate::math::{Mat3, PI, Vec3};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "balls",
    default_size: 4,
    summary: "the sphereflake: every mirroring sphere carries nine of a third of its size",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| Counts { p: 1, s: power(9, size.saturating_add(1)) / 8, l: 3, f: 2, ..Counts::default() },
};

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(2.1, 1.3, 1.7),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 45.0,
        hither: 0.01,
        resolution: 512,
        lights: vec![Vec3::new(4.0, 3.0, 2.0), Vec3::new(1.0, -4.0, 4.0), Vec3::new(-3.0, 1.0, 5.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.75, 0.33], [0.8, 0.0, NO_HIGHLIGHT, 0.0, 1.0])?;
    nff.polygon(&[(12.0, 12.0), (-12.0, 12.0), (-12.0, -12.0), (12.0, -12.0)].map(|(x, y)| Vec3::new(x, y, -0.5)))?;
    nff.surface([1.0, 0.9, 0.7], [0.5, 0.5, 3.0827, 0.0, 1.0])?;
    let mut written = Ok(());
    for_each_ball(size, &mut |center, radius| {
        if written.is_ok() {
            written = nff.sphere(center, radius);
        }
    });
    written
}

/// Calls `visit` with center and radius of each sphere of a flake of that depth: (9^(depth + 1) - 1) / 8 of them.
pub(super) fn for_each_ball(depth: u32, visit: &mut impl FnMut(Vec3, f64)) {
    Flake { directions: directions() }.spheres(depth, &Ball { center: Vec3::ZERO, radius: 0.5, up: Vec3::Z }, visit);
}

/// Where the nine smaller spheres sit on one whose `up` is +z; unit vectors.
fn directions() -> Vec<Vec3> {
    let d = 1.0 / 2.0_f64.sqrt();
    let tilt = rotation(Vec3::new(d, -d, 0.0), asin(2.0 / 6.0_f64.sqrt()));
    let third = [Vec3::new(d, d, 0.0), Vec3::new(d, 0.0, -d), Vec3::new(0.0, d, -d)].map(|base| tilt * base);
    let turns = (0..3).map(|i| rotation_z(2.0 * PI * f64::from(i) / 3.0));
    turns.flat_map(|turn| third.map(|direction| turn * direction)).collect()
}

struct Flake {
    directions: Vec<Vec3>,
}

struct Ball {
    center: Vec3,
    radius: f64,
    /// Away from the sphere that carries it; unit.
    up: Vec3,
}

impl Flake {
    fn spheres(&self, depth: u32, ball: &Ball, visit: &mut impl FnMut(Vec3, f64)) {
        visit(ball.center, ball.radius);
        if depth == 0 {
            return;
        }
        let turn = from_z_axis(ball.up);
        for &direction in &self.directions {
            let up = turn * direction;
            let center = ball.center + up * (4.0 * ball.radius / 3.0);
            self.spheres(depth - 1, &Ball { center, radius: ball.radius / 3.0, up }, visit);
        }
    }
}

/// The turn that takes the z axis to `up`; near the z axis, where the hinge is ill defined, none or half a turn.
fn from_z_axis(up: Vec3) -> Mat3 {
    if up.z >= 0.9999 {
        return Mat3::IDENTITY;
    }
    if up.z <= -0.9999 {
        return rotation_y(PI);
    }
    let hinge = Vec3::Z.cross(up);
    rotation(hinge / hinge.length(), acos(up.z))
}
