//! Lookup: pictures that lie on a surface in a perspective of their own, and pictures that are computed where somebody looks.
//!
//! u, v -LOOKUP-> place on a picture, or what is there
//!
//! A map is drawn in a perspective that makes near ground large (`forest::drape`), so that its place on the picture is a quotient: s/q, t/q.
//! A quotient is not linear, and corners cannot carry it. What corners carry is the place on the ground, and every sample makes of it
//! the place on the picture.
//!
//! Space: u, v of the surface in; 0 to 1 over the picture out. Cost: nine products and a quotient a sample; of a computed picture, whatever it takes.

use super::filter::Sample;
use crate::color::{Encoding, Rgb};
use crate::math::{Mat3, Vec2};
use std::fmt::Debug;
use std::sync::Arc;

/// How a picture is found from u and v where it is not simply there.
#[derive(Clone, Debug)]
pub enum Lookup {
    /// At (s/q, t/q) of the matrix times (u, v, 1).
    Projected(Mat3),
    /// By asking; the picture is not looked at.
    Computed(Arc<dyn Field>),
}

/// A picture without texels.
pub trait Field: Debug + Send + Sync {
    /// Red, green, blue and alpha at `place`, display values of sRGB, for a sample that is `step` wide where it is narrower.
    fn at(&self, place: Vec2, step: f64) -> [u8; 4];
}

impl PartialEq for Lookup {
    /// Computed pictures are the same if they are one.
    fn eq(&self, other: &Lookup) -> bool {
        match (self, other) {
            (Lookup::Projected(one), Lookup::Projected(other)) => one == other,
            (Lookup::Computed(one), Lookup::Computed(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }
}

impl Lookup {
    /// The place on a projected picture, and how it changes where u and v change by `slopes`; as they are for others, and behind the
    /// center of the projection.
    #[must_use]
    pub fn place(matrix: &Mat3, [u, v]: [f64; 2], slopes: [[f32; 2]; 2]) -> ([f64; 2], [[f32; 2]; 2]) {
        let of = *matrix * Vec2::new(u, v).extend(1.0);
        if of.z.is_nan() || of.z <= 0.0 {
            return ([u, v], slopes);
        }
        let place = of.truncate() / of.z;
        // The rule of quotients.
        let changed = |[du, dv]: [f32; 2]| {
            let step = matrix.x_axis * f64::from(du) + matrix.y_axis * f64::from(dv);
            let step = (step.truncate() - place * step.z) / of.z;
            [step.x as f32, step.y as f32]
        };
        (place.to_array(), slopes.map(changed))
    }

    /// What a computed picture shows.
    #[must_use]
    pub fn sample(field: &dyn Field, [u, v]: [f64; 2], slopes: [[f32; 2]; 2], encoding: Encoding) -> Sample {
        let length = |[du, dv]: [f32; 2]| Vec2::new(f64::from(du), f64::from(dv)).length();
        let [red, green, blue, alpha] = field.at(Vec2::new(u, v), length(slopes[0]).min(length(slopes[1])));
        let display = Rgb::new(red, green, blue).map(|level| f64::from(level) / 255.0);
        Sample { color: encoding.decode(display).to_f32(), alpha: f32::from(alpha) / 255.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;

    #[test]
    fn a_projected_place_is_a_quotient_and_changes_as_one() {
        let matrix = Mat3::from_cols(Vec3::new(2.0, 0.5, 0.1), Vec3::new(0.0, 1.0, 0.4), Vec3::new(0.3, 0.2, 1.0));
        let at = |u: f64, v: f64| Lookup::place(&matrix, [u, v], [[0.0; 2]; 2]).0;
        let (u, v) = (0.25, 0.75);
        let w = 0.1 * u + 0.4 * v + 1.0;
        assert_eq!(at(u, v), [(2.0 * u + 0.3) / w, (0.5 * u + v + 0.2) / w]);
        let (_, slopes) = Lookup::place(&matrix, [u, v], [[1e-3, 0.0], [0.0, 1e-3]]);
        for (slope, (du, dv)) in slopes.into_iter().zip([(1e-3, 0.0), (0.0, 1e-3)]) {
            let (before, after) = (at(u - du / 2.0, v - dv / 2.0), at(u + du / 2.0, v + dv / 2.0));
            for axis in 0..2 {
                assert!((f64::from(slope[axis]) - (after[axis] - before[axis])).abs() < 1e-8);
            }
        }
        // Behind the center nothing is turned around.
        assert_eq!(at(-20.0, 0.0), [-20.0, 0.0]);
    }
}
