//! tree: a branching tree of 2^(size + 1) - 1 cone stubs with a sphere at each joint.
//!
//! What it tests: thin shapes far below a pixel beside a trunk that fills the picture; seven lights.
//! Every branch carries two, shorter and thinner, turned to fixed angles.
//!
//! Source: SPD 3.14; kindred: Y. Kawaguchi, "A Morphological Study of the Form of Nature", Computer Graphics 16(3),
//! 1982, and M. Aono and T. L. Kunii, "Botanical Tree Image Generation", IEEE CG&A 4(5), 1984.

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::tessellate::Cone;
use super::turn::{rotation_x, rotation_z};
use super::{Counts, SpdScene, power};
use crate::math::{Affine3, Mat3, Vec3, radians};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "tree",
    default_size: 11,
    summary: "a bare tree: every branch, a cone with a round end, carries two smaller ones",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let branches = power(2, size.saturating_add(1)) - 1;
        Counts { p: 1, s: branches, c: branches, l: 7, f: 2, ..Counts::default() }
    },
};

/// Radius of the far end of a branch, as a part of that of the near end.
const TAPER: f64 = 0.67;

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(4.5, 0.4, 2.0),
        at: Vec3::new(0.0, 0.0, 1.5),
        up: Vec3::Z,
        angle: 45.0,
        hither: 1.0,
        resolution: 512,
        lights: vec![
            Vec3::new(-5.0, 5.0, 50.0),
            Vec3::new(30.0, -30.0, 30.0),
            Vec3::new(-40.0, -30.0, 20.0),
            Vec3::new(10.0, 30.0, 40.0),
            Vec3::new(-30.0, 40.0, 10.0),
            Vec3::new(50.0, 25.0, 20.0),
            Vec3::new(-10.0, -60.0, 30.0),
        ],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([0.2, 0.7, 0.2], [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
    nff.polygon(&[(50.0, 50.0), (-50.0, 50.0), (-50.0, -50.0), (50.0, -50.0)].map(|(x, y)| Vec3::new(x, y, 0.0)))?;
    nff.surface([0.55, 0.4, 0.2], [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0])?;
    let forks = [fork(0.65, 90.0, 40.0), fork(0.70, 230.0, 25.0)];
    grow(nff, &forks, &Branch { scene_from_branch: Affine3::IDENTITY, girth: 1.0 }, size)
}

/// From a branch to its parent: shrunk, bent away, turned around, and moved to the end of the parent. Degrees.
fn fork(scale: f64, around: f64, bend: f64) -> Affine3 {
    let turn = rotation_z(radians(around)) * rotation_x(radians(bend)) * Mat3::from_diagonal(Vec3::splat(scale));
    Affine3::from_mat3_translation(turn, Vec3::Z)
}

struct Branch {
    /// A branch is the unit stretch of the z axis in its own frame.
    scene_from_branch: Affine3,
    /// Thickness, that of the trunk being 1.
    girth: f64,
}

fn grow(nff: &mut Nff<'_>, forks: &[Affine3; 2], branch: &Branch, depth: u32) -> io::Result<()> {
    let base = branch.scene_from_branch.translation;
    let apex = branch.scene_from_branch.transform_point3(Vec3::Z);
    let base_radius = 0.15 * branch.girth;
    let apex_radius = TAPER * base_radius;
    nff.cone(&Cone { base, base_radius, apex, apex_radius })?;
    nff.sphere(apex, apex_radius)?;
    if depth == 0 {
        return Ok(());
    }
    forks.iter().try_for_each(|&parent_from_child| {
        let scene_from_branch = branch.scene_from_branch * parent_from_child;
        grow(nff, forks, &Branch { scene_from_branch, girth: TAPER * branch.girth }, depth - 1)
    })
}
