//! The teapot's control points: 32 grids of 4 x 4, made from the few numbers that they consist of.
//!
//! newell -> [`super::teapot`] (SIPP's shape) and [`crate::spd`] (the whole scene, as triangles)
//!
//! Why not a table of 512 points: four fifths of them follow from profiles by turning and from rows by mirroring,
//! and so one sees the lathe: a profile of four (radius, height) and a quarter circle that a cubic approximates.
//!
//! Scene units; the table top is z = 0, the spout points to +x. Source: M. Newell, 1975; the numbers are those of
//! the published set, as in F. Crow, "The Origins of the Teapot", IEEE CG&A 7(1), 1987, 8-19, with the bottom that was
//! added later.

use crate::math::Vec3;

/// The control points of a patch, four rows of four.
pub(crate) type Grid = [[Vec3; 4]; 4];

/// How far the inner control points of a quarter circle stand out (0.5523 would be the best circle).
const KAPPA: f64 = 0.56;
/// The same for the widest row of the knob, as published.
const KNOB_KAPPA: f64 = 0.5625;

/// Four rows of (radius, height, kappa).
pub(super) type Profile = [(f64, f64, f64); 4];

const fn profile(points: [(f64, f64); 4]) -> Profile {
    let [a, b, c, d] = points;
    [(a.0, a.1, KAPPA), (b.0, b.1, KAPPA), (c.0, c.1, KAPPA), (d.0, d.1, KAPPA)]
}

pub(super) const RIM: Profile = profile([(1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4)]);
pub(super) const UPPER_BODY: Profile = profile([(1.5, 2.4), (1.75, 1.875), (2.0, 1.35), (2.0, 0.9)]);
pub(super) const LOWER_BODY: Profile = profile([(2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15)]);
pub(super) const KNOB: Profile = [(0.0, 3.15, KAPPA), (0.8, 3.15, KNOB_KAPPA), (0.0, 2.85, KAPPA), (0.2, 2.7, KAPPA)];
pub(super) const LID: Profile = profile([(0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4)]);
const BOTTOM: Profile = profile([(0.0, 0.0), (1.425, 0.0), (1.5, 0.075), (1.5, 0.15)]);

/// Quarter circles from one unit vector to the next: clockwise from above, so that patches face outward.
const CLOCKWISE: [(Vec3, Vec3); 4] =
    [(Vec3::X, Vec3::NEG_Y), (Vec3::NEG_Y, Vec3::NEG_X), (Vec3::NEG_X, Vec3::Y), (Vec3::Y, Vec3::X)];
/// The bottom goes from its center outward and faces down: the other way around.
const COUNTERCLOCKWISE: [(Vec3, Vec3); 4] =
    [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::NEG_X), (Vec3::NEG_X, Vec3::NEG_Y), (Vec3::NEG_Y, Vec3::X)];

/// Four rows of a tube that is symmetric in y: x and z on one side, x and z on the other, half width.
pub(super) type Tube = [(f64, f64, f64, f64, f64); 4];

pub(super) const HANDLE: [Tube; 2] = [
    [
        (-1.6, 2.025, -1.5, 2.25, 0.3),
        (-2.3, 2.025, -2.5, 2.25, 0.3),
        (-2.7, 2.025, -3.0, 2.25, 0.3),
        (-2.7, 1.8, -3.0, 1.8, 0.3),
    ],
    [
        (-2.7, 1.8, -3.0, 1.8, 0.3),
        (-2.7, 1.575, -3.0, 1.35, 0.3),
        (-2.5, 1.125, -2.65, 0.9375, 0.3),
        (-2.0, 0.9, -1.9, 0.6, 0.3),
    ],
];
pub(super) const SPOUT: [Tube; 2] = [
    [
        (1.7, 1.425, 1.7, 0.6, 0.66),
        (2.6, 1.425, 3.1, 0.825, 0.66),
        (2.3, 2.1, 2.4, 2.025, 0.25),
        (2.7, 2.4, 3.3, 2.4, 0.25),
    ],
    [
        (2.7, 2.4, 3.3, 2.4, 0.25),
        (2.8, 2.475, 3.525, 2.49375, 0.25),
        (2.9, 2.475, 3.45, 2.5125, 0.15),
        (2.8, 2.4, 3.2, 2.4, 0.15),
    ],
];

/// All 32 patches in the published order: rim, body, handle, spout, lid, bottom.
pub(crate) fn grids() -> Vec<Grid> {
    let mut grids = Vec::with_capacity(32);
    for profile in [&RIM, &UPPER_BODY, &LOWER_BODY] {
        grids.extend(turned(profile, CLOCKWISE));
    }
    for tube in HANDLE.iter().chain(&SPOUT) {
        grids.extend(halves(tube));
    }
    for profile in [&KNOB, &LID] {
        grids.extend(turned(profile, CLOCKWISE));
    }
    grids.extend(turned(&BOTTOM, COUNTERCLOCKWISE));
    grids
}

/// Four patches around the z axis.
fn turned(profile: &Profile, quarters: [(Vec3, Vec3); 4]) -> [Grid; 4] {
    quarters.map(|(from, to)| {
        profile.map(|(radius, height, kappa)| {
            [from, from + to * kappa, from * kappa + to, to]
                .map(|corner| (corner * radius).map(six_decimals).with_z(height))
        })
    })
}

/// The two patches of a tube, one at negative y and one at positive.
pub(super) fn halves(tube: &Tube) -> [Grid; 2] {
    let near = tube.map(|(x1, z1, x2, z2, w)| {
        [Vec3::new(x1, 0.0, z1), Vec3::new(x1, -w, z1), Vec3::new(x2, -w, z2), Vec3::new(x2, 0.0, z2)]
    });
    let far = tube.map(|(x1, z1, x2, z2, w)| {
        [Vec3::new(x2, 0.0, z2), Vec3::new(x2, w, z2), Vec3::new(x1, w, z1), Vec3::new(x1, 0.0, z1)]
    });
    [near, far]
}

/// The published numbers are decimals of at most six places; products carry noise beyond them.
fn six_decimals(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighboring_quarters_share_their_edge() {
        let grids = grids();
        assert_eq!(grids.len(), 32);
        for part in [0, 4, 8, 20, 24, 28] {
            for quarter in 0..4 {
                let (here, next) = (&grids[part + quarter], &grids[part + (quarter + 1) % 4]);
                for row in 0..4 {
                    assert_eq!(here[row][3], next[row][0], "part {part}, quarter {quarter}, row {row}");
                }
            }
        }
    }
}
