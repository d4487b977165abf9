//! Detail: what stands for a tree, by how high it is in the picture.
//!
//! height in pixels, direction to the eye -DETAIL-> [`Look`]s, each with the share of samples it has
//!
//! | Pixels | A tree is |
//! |---|---|
//! | above a limit that is asked for | a mesh ([`solid`](super::solid)) |
//! | above 48 | two pictures crossed, and a lying one when looked down on |
//! | 8 to 48 | one picture that faces the eye |
//! | 2 to 8 | a triangle in the mean color of the picture |
//! | below 2 | one for many: some stay, larger, and stand for the others |
//!
//! Near a limit both looks are there and share the samples between them ([`Fade`](crate::scene::Fade)): from 10 % below it to 10 % above one
//! takes over from the other in sixteenths. No tree pops. And nothing is remembered from frame to frame: a look is a function of the place of the eye
//! alone, so a path played twice, or from its middle, gives the same pictures; the band of fading does what hysteresis is for.
//!
//! Space: pixels high, metres. Source: `docs/forest-frames.md`; X. Decoret et al., "Billboard Clouds", SIGGRAPH 2003 (what pictures can
//! stand for); A. Falcão, M. Próspero dos Santos (crossed pictures), J. Caralo (facing ones).

use crate::math::Vec3;

/// Above this many pixels a tree is crossed pictures.
pub const CROSSED: f64 = 48.0;
/// Above this many it has a picture.
pub const PICTURE: f64 = 8.0;
/// Below this many one stands for several.
pub const SINGLE: f64 = 2.0;
/// How far from a limit both looks are there, as a factor.
pub const BAND: f64 = 1.1;
/// From this sine of the angle below the level on, a lying picture is added: 35 degrees. It is whole at [`STEEP`].
const DOWN: f64 = 0.573_576_436_351_046;
/// 45 degrees.
const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// What a part of a tree looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A mesh ([`solid`](super::solid)).
    Solid,
    /// Two upright pictures at right angles.
    Crossed,
    /// A lying picture, above the others.
    Lying,
    /// One picture that faces the eye.
    Facing,
    /// A triangle without a picture.
    Narrow,
}

/// A form and the sixteenths of samples it has: from `from` to below `to`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// What it is.
    pub form: Form,
    /// First rank.
    pub from: u8,
    /// Behind the last rank.
    pub to: u8,
}

/// The looks of one tree; at most three.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Looks {
    list: [Option<Look>; 3],
    /// How much larger it is drawn, for those that are not.
    pub scale: f64,
}

impl Looks {
    /// The looks, those nearer to the tree first.
    pub fn iter(&self) -> impl Iterator<Item = Look> {
        self.list.into_iter().flatten()
    }

    /// One look that has all samples.
    #[must_use]
    #[inline]
    pub fn only(form: Form) -> Looks {
        Looks { list: [Some(Look { form, from: 0, to: 16 }), None, None], scale: 1.0 }
    }

    /// With one more, behind the others.
    fn with(mut self, look: Option<Look>) -> Looks {
        if let Some(free) = self.list.iter_mut().find(|look| look.is_none()) {
            *free = look;
        }
        self
    }

    /// Whether nothing is drawn: others stand for it.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.list[0].is_none()
    }
}

/// What a tree of so many pixels is, seen `down` (the sine of the angle below the level); `chance` is its own number.
#[must_use]
#[inline]
pub fn looks(pixels: f64, down: f64, chance: u32) -> Looks {
    if pixels <= SINGLE {
        return thinned(pixels, chance);
    }
    if pixels < PICTURE / BAND {
        return Looks::only(Form::Narrow);
    }
    if pixels < PICTURE * BAND {
        return both(Form::Facing, Form::Narrow, sixteenths(pixels, PICTURE), None);
    }
    if pixels < CROSSED / BAND {
        return Looks::only(Form::Facing);
    }
    let lying = lying(down);
    if pixels < CROSSED * BAND {
        return both(Form::Crossed, Form::Facing, sixteenths(pixels, CROSSED), lying);
    }
    Looks { list: [Some(Look { form: Form::Crossed, from: 0, to: 16 }), lying, None], scale: 1.0 }
}

/// As [`looks`], with a mesh above `limit` pixels, which must be well above [`CROSSED`].
#[must_use]
#[inline]
pub fn looks_with_solids(pixels: f64, down: f64, chance: u32, limit: f64) -> Looks {
    if pixels < limit / BAND {
        return looks(pixels, down, chance);
    }
    match sixteenths(pixels, limit) {
        16 => Looks::only(Form::Solid),
        share => {
            // The lying picture goes as the crossed ones do: it never has more samples than they.
            let lying = lying(down).map(|look| Look { to: look.to.min(16 - share), ..look });
            both(Form::Solid, Form::Crossed, share, None).with(lying)
        }
    }
}

/// The lying picture of a tree that is looked down on.
#[must_use]
#[inline]
pub fn lying(down: f64) -> Option<Look> {
    let share = ((down - DOWN) / (STEEP - DOWN) * 17.0).floor().clamp(0.0, 16.0) as u8;
    (share > 0).then_some(Look { form: Form::Lying, from: 0, to: share })
}

/// One of many: kept with the chance by which it would otherwise be too small, and so much larger that the area stays.
fn thinned(pixels: f64, chance: u32) -> Looks {
    let share = (pixels / SINGLE) * (pixels / SINGLE);
    let kept = f64::from(chance) < share * (f64::from(u32::MAX) + 1.0);
    let look = kept.then_some(Look { form: Form::Narrow, from: 0, to: 16 });
    Looks { list: [look, None, None], scale: 1.0 / share.sqrt() }
}

/// Sixteenths of the nearer look around a limit.
fn sixteenths(pixels: f64, limit: f64) -> u8 {
    let (low, high) = (limit / BAND, limit * BAND);
    ((pixels - low) / (high - low) * 17.0).floor().clamp(0.0, 16.0) as u8
}

/// Two looks that share all samples. A lying picture fades with the crossed ones it belongs to.
fn both(near: Form, far: Form, share: u8, lying: Option<Look>) -> Looks {
    let first = Look { form: near, from: 0, to: share };
    let second = Look { form: far, from: share, to: 16 };
    let lying = lying.map(|look| Look { to: look.to.min(share), ..look }).filter(|look| look.to > 0);
    match share {
        0 => Looks { list: [Some(second), None, None], scale: 1.0 },
        16 => Looks { list: [Some(first), lying, None], scale: 1.0 },
        _ => Looks { list: [Some(first), Some(second), lying], scale: 1.0 },
    }
}

/// Unit directions of a facing picture: to its right, and up along it. `away` leads from the eye to the tree, `right` is the camera's right.
///
/// No angle is computed: right is at a right angle to the way to the tree, on the map. Where the eye is above the foot there is no such way; then
/// right is the camera's. An upright picture is a line when seen from above, so from 35 degrees down on it leans back, until it faces
/// the eye.
#[must_use]
#[inline]
pub fn facing(away: Vec3, right: Vec3) -> (Vec3, Vec3) {
    let level = (away.x * away.x + away.y * away.y).sqrt();
    let across = if level > 1e-9 { Vec3::new(away.y / level, -away.x / level, 0.0) } else { right };
    let length = away.length();
    let down = if length > 1e-9 { -away.z / length } else { 0.0 };
    if down <= DOWN {
        return (across, Vec3::Z);
    }
    // The direction at right angles to both, leaning away from the eye; mixed with upright by how far down it looks.
    let ahead = across.cross(Vec3::Z) * -1.0;
    let leaning = ahead * down + Vec3::Z * (level / length.max(1e-9));
    let share = ((down - DOWN) / (0.94 - DOWN)).min(1.0);
    (across, (Vec3::Z * (1.0 - share) + leaning * share).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{PI, cos, sin};

    #[test]
    fn looks_share_every_sample_at_every_size() {
        for step in 0..20_000 {
            let pixels = f64::from(step) * 0.005 + 0.001;
            for down in [-1.0, 0.0, 0.6, 0.7, 1.0] {
                let looks = looks(pixels, down, 0);
                let own: Vec<Look> = looks.iter().filter(|look| look.form != Form::Lying).collect();
                let shown: u32 = own.iter().map(|look| u32::from(look.to - look.from)).sum();
                assert_eq!(shown, 16, "{pixels}");
                assert!(own.windows(2).all(|pair| pair[0].to == pair[1].from), "{pixels}: {own:?}");
                assert!(looks.iter().all(|look| look.from < look.to), "{pixels}");
            }
        }
    }

    #[test]
    fn meshes_end_in_crossed_pictures_and_nothing_jumps() {
        let shares = |pixels: f64, down: f64, form: Form| {
            let looks = looks_with_solids(pixels, down, 0, 160.0);
            looks.iter().filter(|look| look.form == form).map(|look| i32::from(look.to - look.from)).sum::<i32>()
        };
        for down in [0.0, 0.6, 0.64, 0.9] {
            let mut pixels = 60.0;
            while pixels < 200.0 {
                let [solid, crossed, lying] =
                    [Form::Solid, Form::Crossed, Form::Lying].map(|form| shares(pixels, down, form));
                assert_eq!(solid + crossed, 16, "{pixels}");
                assert!(lying <= crossed, "{pixels}: {lying} lying with {crossed} crossed");
                for form in [Form::Solid, Form::Crossed, Form::Lying] {
                    let change = (shares(pixels, down, form) - shares(pixels * 1.001, down, form)).abs();
                    assert!(change <= 1, "{form:?} at {pixels}: {change}");
                }
                pixels *= 1.001;
            }
        }
        assert_eq!(looks_with_solids(300.0, 0.9, 0, 160.0), Looks::only(Form::Solid));
        assert_eq!(looks_with_solids(100.0, 0.0, 7, 160.0), looks(100.0, 0.0, 7), "far trees are what they were");
    }

    #[test]
    fn nothing_jumps_at_a_limit() {
        // From one step to the next no form gains or loses more than a sixteenth, but the narrow one, which is the last in any case.
        let share = |pixels: f64, form: Form| {
            looks(pixels, 0.0, 0).iter().find(|look| look.form == form).map_or(0, |look| i32::from(look.to - look.from))
        };
        let mut pixels = 2.1;
        while pixels < 80.0 {
            for form in [Form::Crossed, Form::Facing, Form::Narrow] {
                let change = (share(pixels, form) - share(pixels * 1.001, form)).abs();
                assert!(change <= 1, "{form:?} at {pixels}: {change}");
            }
            pixels *= 1.001;
        }
        assert_eq!(looks(2.0, 0.0, u32::MAX).scale, 1.0, "thinning begins with all");
    }

    #[test]
    fn those_that_stay_have_the_area_of_all() {
        for pixels in [0.1, 0.5, 1.0, 1.9] {
            let chances = (0..100_000_u32).map(|number| number.wrapping_mul(2_654_435_769));
            let area: f64 = chances
                .map(|chance| looks(pixels, 0.0, chance))
                .filter(|looks| !looks.is_nothing())
                .map(|looks| looks.scale * looks.scale)
                .sum();
            assert!((area / 100_000.0 - 1.0).abs() < 0.05, "{pixels}: {area}");
        }
    }

    #[test]
    fn facing_pictures_turn_without_a_jump() {
        let mut last: Option<Vec3> = None;
        for step in 0..=3600 {
            let turn = f64::from(step) / 3600.0 * 2.0 * PI;
            let away = Vec3::new(cos(turn), sin(turn), -0.1) * 20.0;
            let (right, up) = facing(away, Vec3::X);
            assert!(right.dot(away).abs() < 1e-9 && (right.length() - 1.0).abs() < 1e-12 && up == Vec3::Z);
            assert!(last.is_none_or(|last| (right - last).length() < 0.002), "{step}");
            last = Some(right);
        }
    }

    #[test]
    fn facing_pictures_lean_back_without_a_jump() {
        let mut last = Vec3::Z;
        for step in 0..=900 {
            let pitch = f64::from(step) / 900.0 * PI / 2.0;
            let away = Vec3::new(cos(pitch), 0.0, -sin(pitch)) * 100.0;
            let (right, up) = facing(away, Vec3::NEG_Y);
            assert!(right.is_finite() && up.is_finite() && (up.length() - 1.0).abs() < 1e-12);
            assert!((up - last).length() < 0.01, "{step}: {up}");
            assert!(up.z >= -1e-12 && up.x >= -1e-12, "away from the eye: {up}");
            last = up;
        }
        assert!((last - Vec3::X).length() < 1e-6, "from above it lies: {last}");
        assert_eq!(facing(Vec3::ZERO, Vec3::Y), (Vec3::Y, Vec3::Z), "at the tree itself");
    }
}
