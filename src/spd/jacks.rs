//! jacks: six-armed jacks within jacks, (8^size - 1) / 7 of them.
//!
//! What it tests: a hierarchy of transformations; normals that are not unit: in patches mode they are
//! rotated and divided by the scale, as the original does it, so a reader must normalize them.
//! In patches mode the resolution is always 2.
//!
//! Source: SPD 3.14.

use super::nff::{Nff, View};
use super::tessellate::{Cone, Patch, SphereGrid, cone};
use super::turn::{rotation_x, rotation_y};
use super::{Counts, SpdScene, power};
use crate::math::{Affine3, Vec3, radians};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "jacks",
    default_size: 1,
    summary: "a jack of three rods and six spheres, with eight of half its size around it, and so on",
    sized: true,
    fixed_resolution: Some(RESOLUTION),
    view,
    body,
    count: |size, _| {
        let jacks = power(8, size) / 7;
        Counts { s: jacks.saturating_mul(6), c: jacks.saturating_mul(3), l: 1, f: 1, ..Counts::default() }
    },
};

const RESOLUTION: u32 = 2;

fn view(_size: u32) -> View {
    View {
        background: [0.2, 0.05, 0.2],
        from: Vec3::new(0.0, 0.0, -8.0),
        at: Vec3::ZERO,
        up: Vec3::Y,
        angle: 25.0,
        hither: 0.001,
        resolution: 256,
        lights: vec![Vec3::new(-10.0, 3.0, -20.0)],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([0.737, 0.561, 0.561], [0.7, 0.7, 11.1434, 0.0, 1.0])?;
    let turn = rotation_x(radians(-30.0)) * rotation_y(radians(-20.0));
    let patches = if nff.keeps_curves() { Vec::new() } else { patches()? };
    jacks(nff, &patches, &Frame { scene_from_jack: Affine3::from_mat3(turn), scale: 1.0 }, size)
}

struct Frame {
    scene_from_jack: Affine3,
    /// How much `scene_from_jack` lengthens, kept beside it because its columns hold it with noise only.
    scale: f64,
}

impl Frame {
    /// The frame of something smaller inside this one: scaled first, then moved.
    fn inside(&self, scale: f64, moved: Vec3) -> Frame {
        let smaller = Affine3::from_translation(moved) * Affine3::from_scale(Vec3::splat(scale));
        Frame { scene_from_jack: self.scene_from_jack * smaller, scale: self.scale * scale }
    }
}

/// A jack and, for `levels` above 1, eight smaller ones in the octants of its cube.
fn jacks(nff: &mut Nff<'_>, patches: &[Patch], frame: &Frame, levels: u32) -> io::Result<()> {
    let jack = frame.inside(0.75, Vec3::ZERO);
    if nff.keeps_curves() {
        curves(nff, &jack)?
    } else {
        triangles(nff, patches, &jack)?
    }
    if levels == 1 {
        return Ok(());
    }
    for x in [-0.5, 0.5] {
        for y in [-0.5, 0.5] {
            for z in [-0.5, 0.5] {
                jacks(nff, patches, &frame.inside(0.5, Vec3::new(x, y, z)), levels - 1)?;
            }
        }
    }
    Ok(())
}

/// The rods of a jack in its own frame.
fn rods() -> [Cone; 3] {
    [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| Cone { base: -axis, base_radius: 0.1, apex: axis, apex_radius: 0.1 })
}

/// The centers of the spheres in the jack's own frame; their radius is 0.2.
const TIPS: [Vec3; 6] = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z];
const TIP_RADIUS: f64 = 0.2;

fn curves(nff: &mut Nff<'_>, frame: &Frame) -> io::Result<()> {
    let placed = |point| frame.scene_from_jack.transform_point3(point);
    for rod in rods() {
        nff.cone(&Cone {
            base: placed(rod.base),
            base_radius: rod.base_radius * frame.scale,
            apex: placed(rod.apex),
            apex_radius: rod.apex_radius * frame.scale,
        })?;
    }
    TIPS.iter().try_for_each(|&tip| nff.sphere(placed(tip), TIP_RADIUS * frame.scale))
}

/// The triangles of a jack in its own frame.
fn patches() -> io::Result<Vec<Patch>> {
    let mut patches = Vec::new();
    let mut keep = |patch| {
        patches.push(patch);
        Ok(())
    };
    for rod in rods() {
        cone(&rod, RESOLUTION, &mut keep)?;
    }
    let grid = SphereGrid::new(RESOLUTION);
    for tip in TIPS {
        grid.sphere(tip, TIP_RADIUS, &mut keep)?;
    }
    Ok(patches)
}

fn triangles(nff: &mut Nff<'_>, patches: &[Patch], frame: &Frame) -> io::Result<()> {
    patches.iter().try_for_each(|patch| {
        let points = patch.points.map(|point| frame.scene_from_jack.transform_point3(point));
        // The matrix lengthens once: divided twice, the length is 1 / scale. Adding zero turns -0 into 0.
        let divisor = frame.scale * frame.scale;
        let normals =
            patch.normals.map(|normal| frame.scene_from_jack.transform_vector3(normal) / divisor + Vec3::ZERO);
        nff.patch(Patch { points, normals })
    })
}
