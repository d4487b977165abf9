//! Transforms: words -> affine maps.
//!
//! Each transform is applied after those listed before it, in the coordinates of the parent (SIPP's "post-multiply"). SIPP
//! writes row vectors, v' = v M; farop's matrices are for column vectors, so the list T1 T2 T3 becomes T3 * T2 * T1.
//!
//! Angles follow the right-hand rule. Quarter turns are exact: degrees are brought into the first eighth of the circle
//! before they become radians, which rounds nothing.
//!
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide"; O. Rodrigues, J. Math. Pures Appl. 5, 1840 (turning about an axis).

use super::Reader;
use super::trouble::{Trouble, bad_number};
use super::words::Kind;
use crate::diagnostic::{Diagnostic, Span};
use crate::math::{Affine3, Mat3, Vec3, cos, radians, sin, unit};
use crate::parse::tokens;
use crate::parse::wording::{plain, quote};

impl Reader<'_> {
    /// Reads the transform that starts with the next word, and puts it behind what `so_far` already does.
    pub(super) fn transform(&mut self, so_far: Affine3) -> Result<Affine3, Trouble> {
        let keyword = self.words.take().span;
        let next = match self.words.bytes(keyword) {
            b"rotate" => self.rotate()?,
            b"scale" => Affine3::from_scale(self.words.vector("`scale X Y Z`")?),
            b"move" => Affine3::from_translation(self.words.vector("`move X Y Z`")?),
            b"mirror" => self.mirror()?,
            _ => self.matrix()?,
        };
        if self.words.is_number_next() {
            let span = self.words.peek().span;
            let word = plain(self.words.bytes(keyword));
            let error = Diagnostic::error(format!("a number too many behind `{word}`"));
            return Err(error.at(span, "belongs to nothing").help(format!("write {}", shape(&word))).into());
        }
        let both = next * so_far;
        if !both.is_finite() {
            let error = Diagnostic::error("the transforms up to here lead beyond the range of numbers");
            return Err(error.at(keyword, "with this one").help("the largest number is about 1.8e308").into());
        }
        Ok(both)
    }

    fn rotate(&mut self) -> Result<Affine3, Trouble> {
        let token = self.words.expect_word("`rotate`", "`x`, `y`, `z` or `point`")?;
        let axis = match self.words.bytes(token.span) {
            b"x" => Vec3::X,
            b"y" => Vec3::Y,
            b"z" => Vec3::Z,
            b"point" => return self.rotate_about_line(),
            word => {
                let error = Diagnostic::error(format!("{} is no axis", quote(word)));
                let error = error.at(token.span, "expected `x`, `y`, `z` or `point`");
                return Err(error.help(format!("write {}", shape("rotate"))).into());
            }
        };
        self.words.take();
        let (cosine, sine) = self.angle()?;
        Ok(Affine3::from_mat3(turn_about(axis, cosine, sine)))
    }

    fn rotate_about_line(&mut self) -> Result<Affine3, Trouble> {
        let point = self.labeled("point", "rotate")?;
        let axis = self.direction("axis", "rotate")?;
        let (cosine, sine) = self.angle()?;
        let turn = turn_about(axis, cosine, sine);
        Ok(Affine3::from_mat3_translation(turn, point - turn * point))
    }

    fn mirror(&mut self) -> Result<Affine3, Trouble> {
        let point = self.labeled("point", "mirror")?;
        let n = self.direction("normal", "mirror")?;
        // v' = v - 2 (v . n) n: every column of the matrix is a mirrored axis.
        let flip = Mat3::from_cols(Vec3::X - 2.0 * n.x * n, Vec3::Y - 2.0 * n.y * n, Vec3::Z - 2.0 * n.z * n);
        Ok(Affine3::from_mat3_translation(flip, 2.0 * point.dot(n) * n))
    }

    /// Four rows of three; SIPP's rows are the columns of a matrix for column vectors.
    fn matrix(&mut self) -> Result<Affine3, Trouble> {
        let mut rows = [Vec3::ZERO; 4];
        for row in &mut rows {
            *row = self.words.vector("`matrix` and 12 numbers")?;
        }
        Ok(Affine3::from_cols(rows[0], rows[1], rows[2], rows[3]))
    }

    /// A word and the vector behind it.
    fn labeled(&mut self, label: &str, owner: &str) -> Result<Vec3, Trouble> {
        if !self.words.take_word(label) {
            let token = self.words.peek();
            if token.kind == Kind::End {
                return Err(Trouble::End(format!("`{label} X Y Z`")));
            }
            let error = Diagnostic::error(format!("{} where `{label}` is expected", self.words.describe(token)));
            return Err(error.at(token.span, format!("write {}", shape(owner))).into());
        }
        self.words.vector(&format!("`{label} X Y Z`"))
    }

    /// A labeled vector as a unit direction.
    fn direction(&mut self, label: &str, owner: &str) -> Result<Vec3, Trouble> {
        let start = self.words.peek().span;
        let vector = self.labeled(label, owner)?;
        unit(vector).ok_or_else(|| {
            let error = Diagnostic::error(format!("`{label}` is 0 0 0, which is no direction"));
            error.at(start, "this one").help(format!("write a direction such as `{label} 0 0 1`")).into()
        })
    }

    /// Cosine and sine of an angle with its unit.
    fn angle(&mut self) -> Result<(f64, f64), Trouble> {
        let token = self.words.expect_word("`rotate`", "an angle such as `30deg`")?;
        let word = self.words.bytes(token.span);
        let (digits, unit) = match word {
            [digits @ .., b'd', b'e', b'g'] => (digits, Some(Unit::Degrees)),
            [digits @ .., b'r', b'a', b'd'] => (digits, Some(Unit::Radians)),
            _ => (word, None),
        };
        let number =
            tokens::number(digits).map_err(|why| bad_number(word, token.span, why, "an angle such as `30deg`"))?;
        self.words.take();
        match unit {
            Some(Unit::Degrees) => Ok(turn_of_degrees(number.value)),
            Some(Unit::Radians) => Ok((cos(number.value), sin(number.value))),
            None if number.value == 0.0 => Ok((1.0, 0.0)),
            None => Err(self.no_unit(token.span)),
        }
    }

    fn no_unit(&self, span: Span) -> Trouble {
        let digits = plain(self.words.bytes(span));
        let error = Diagnostic::error(format!("the angle `{digits}` has no unit")).at(span, "degrees or radians?");
        let unit_follows = self.words.is_next("deg") || self.words.is_next("rad");
        let unit = if unit_follows { plain(self.words.next_bytes()) } else { String::new() };
        error
            .help(if unit_follows {
                format!("write `{digits}{unit}`, without a blank")
            } else {
                format!("write `{digits}deg` or `{digits}rad`")
            })
            .into()
    }
}

enum Unit {
    Degrees,
    Radians,
}

/// A transform as it should be written.
fn shape(keyword: &str) -> &'static str {
    match keyword {
        "rotate" => "`rotate x 30deg` or `rotate point X Y Z axis X Y Z 30deg`",
        "scale" => "`scale X Y Z`",
        "move" => "`move X Y Z`",
        "mirror" => "`mirror point X Y Z normal X Y Z`",
        _ => "`matrix` and 12 numbers",
    }
}

/// Turning about a unit axis through the origin (Rodrigues): what lies along the axis stays, to the last bit, the rest turns.
fn turn_about(axis: Vec3, cosine: f64, sine: f64) -> Mat3 {
    let turned = |v: Vec3| {
        let along = axis * axis.dot(v);
        along + (v - along) * cosine + axis.cross(v) * sine
    };
    Mat3::from_cols(turned(Vec3::X), turned(Vec3::Y), turned(Vec3::Z))
}

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
fn turn_of_degrees(degrees: f64) -> (f64, f64) {
    // `%` rounds nothing, nor does taking whole quarters off.
    let positive = degrees.abs() % 360.0;
    let quarter = (positive / 90.0).floor();
    let rest = positive - 90.0 * quarter;
    let (x, y) = if rest <= 45.0 {
        (cos(radians(rest)), sin(radians(rest)))
    } else {
        (sin(radians(90.0 - rest)), cos(radians(90.0 - rest)))
    };
    let (cosine, sine) = match quarter as u32 {
        0 => (x, y),
        1 => (-y, x),
        2 => (-x, -y),
        _ => (y, -x),
    };
    (cosine, if degrees < 0.0 { -sine } else { sine })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let turns = [(0.0, (1.0, 0.0)), (90.0, (0.0, 1.0)), (180.0, (-1.0, 0.0)), (270.0, (0.0, -1.0))];
        for (degrees, expected) in turns {
            for around in [-720.0, 0.0, 360.0, 36_000.0] {
                assert_eq!(turn_of_degrees(degrees + around), expected, "{degrees} + {around}");
            }
        }
        for degrees in -800..800 {
            let (cosine, sine) = turn_of_degrees(f64::from(degrees) * 0.7);
            let angle = radians(f64::from(degrees) * 0.7);
            assert!((cosine - angle.cos()).abs() < 2e-15 && (sine - angle.sin()).abs() < 2e-15, "{degrees}");
        }
        assert_eq!(turn_about(Vec3::X, 0.0, 1.0), Mat3::from_cols(Vec3::X, Vec3::Z, -Vec3::Y));
    }
}
