//! Steer: a walk out of directions and speeds, as any device can write them.
//!
//! lines `HEADING PITCH SPEED` -STEER-> poses, one a line
//!
//! A line is a frame: the eye goes in the direction of the heading, on the ground, as far as the speed takes it in a frame's time, and looks there and up by the pitch.
//! So a program that reads a joystick, a game pad or a phone writes three numbers a frame, into a file or a pipe.
//!
//! A device may be pulled out in the middle of a line: what is cut off at the very end is left out, and told; everything before it counts.
//!
//! Units: degrees from north to east, degrees up, metres a second. `#` begins a comment.

use super::path::Pose;
use crate::math::{Vec3, cos, radians, sin};

/// What was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Steering {
    /// One a frame.
    pub samples: Vec<Sample>,
    /// The text of a last line that was cut off.
    pub cut: Option<String>,
}

/// Where to and how fast, in one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Degrees from north to east.
    pub heading: f64,
    /// Degrees up, -90 to 90.
    pub pitch: f64,
    /// Metres a second; below 0 backwards.
    pub speed: f64,
}

/// A line that is no sample.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "line {line}, column {column}: {found} where {expected} is expected; a line is `HEADING PITCH SPEED`, degrees from north to east, degrees up, metres a second"
)]
pub struct SteerError {
    /// From 1.
    pub line: usize,
    /// In bytes, from 1.
    pub column: usize,
    /// What stands there.
    pub found: String,
    /// What should.
    pub expected: &'static str,
}

/// Names, and how far a number may be from 0.
const FIELDS: [(&str, f64); 3] = [("a heading in degrees", 1e9), ("a pitch from -90 to 90", 90.0), ("a speed", 1e6)];

/// Reads all samples of a text; bytes that are no UTF-8 are no numbers.
///
/// # Errors
/// The first line that is no sample, unless it is the last and has no end.
pub fn read_steering(text: &[u8]) -> Result<Steering, SteerError> {
    let mut steering = Steering::default();
    for (number, line) in text.split_inclusive(|&byte| byte == b'\n').enumerate() {
        let is_cut = line.last() != Some(&b'\n');
        match sample(&String::from_utf8_lossy(line), number + 1) {
            Ok(sample) => steering.samples.extend(sample),
            Err(_) if is_cut => steering.cut = Some(String::from_utf8_lossy(line).into_owned()),
            Err(error) => return Err(error),
        }
    }
    Ok(steering)
}

/// The sample of a line; `None` for one that says nothing.
fn sample(line: &str, number: usize) -> Result<Option<Sample>, SteerError> {
    let said = line.split('#').next().unwrap_or_default();
    let mut words = said.split_whitespace();
    let column = |word: &str| word.as_ptr() as usize - line.as_ptr() as usize + 1;
    let mut numbers = [0.0; 3];
    for (index, (what, most)) in FIELDS.into_iter().enumerate() {
        let Some(word) = words.next() else {
            if index == 0 {
                return Ok(None);
            }
            let (column, found) = (said.trim_end().len() + 1, "the end of the line".to_string());
            return Err(SteerError { line: number, column, found, expected: what });
        };
        match word.trim_end_matches(',').parse() {
            Ok(value) if f64::abs(value) <= most => numbers[index] = value,
            _ => {
                let found = format!("`{}`", word.escape_debug());
                return Err(SteerError { line: number, column: column(word), found, expected: what });
            }
        }
    }
    match words.next() {
        None => Ok(Some(Sample { heading: numbers[0], pitch: numbers[1], speed: numbers[2] })),
        Some(word) => {
            let found = format!("`{}`", word.escape_debug());
            Err(SteerError { line: number, column: column(word), found, expected: "the end of the line" })
        }
    }
}

/// Poses of a walk that begins at `start`, east and north, with `rate` frames a second; `eye` says where the eye is over a place. Like a recorded
/// path it shows the start first; a sample says where the next frame is, and where both look.
///
/// # Errors
/// The first of `eye`.
pub fn steer<E>(
    samples: &[Sample],
    start: [f64; 2],
    rate: u32,
    mut eye: impl FnMut([f64; 2]) -> Result<Vec3, E>,
) -> Result<Vec<Pose>, E> {
    let mut at = start;
    samples
        .iter()
        .map(|sample| {
            let (heading, pitch) = (radians(sample.heading), radians(sample.pitch));
            let level = Vec3::new(sin(heading), cos(heading), 0.0);
            let from = eye(at)?;
            let ahead = level * cos(pitch) + Vec3::Z * sin(pitch);
            let step = level * (sample.speed / f64::from(rate.max(1)));
            at = [at[0] + step.x, at[1] + step.y];
            // Straight up and down, the top of the picture is where the heading points from or to.
            Ok(Pose { from, at: from + ahead * 100.0, up: Vec3::Z * cos(pitch) - level * sin(pitch) })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_lead_where_they_say() {
        let text = b"# north, then east, then back\n0 0 10\n90 -10, 5\n\n90 0 -5 # backwards\n0 90 0\n";
        let steering = read_steering(text).expect("four samples");
        assert_eq!((steering.samples.len(), &steering.cut), (4, &None));
        let eye = |[x, y]: [f64; 2]| Ok::<_, ()>(Vec3::new(x, y, 100.0));
        let poses = steer(&steering.samples, [50.0, 60.0], 10, eye).expect("poses");
        let places: Vec<Vec3> = poses.iter().map(|pose| pose.from).collect();
        let expected = [(50.0, 60.0), (50.0, 61.0), (50.5, 61.0), (50.0, 61.0)];
        for (place, (x, y)) in places.into_iter().zip(expected) {
            assert!((place - Vec3::new(x, y, 100.0)).length() < 1e-9, "{place}");
        }
        assert!(((poses[1].at - poses[1].from).normalize().z + sin(radians(10.0))).abs() < 1e-12);
        assert!((poses[3].up - Vec3::NEG_Y).length() < 1e-9);
    }

    #[test]
    fn a_line_that_is_none_has_its_place_and_a_cut_one_loses_nothing_before_it() {
        for (text, line, column, found) in [
            ("0 0 1\n0 x 1\n", 2, 3, "`x`"),
            ("0 0\n", 1, 4, "the end of the line"),
            ("0 0 1 7\n", 1, 7, "`7`"),
            ("0 91 1\n", 1, 3, "`91`"),
            ("0 0 nan\n", 1, 5, "`nan`"),
            ("0 0 1\n\u{7}\n", 2, 1, "`\\u{7}`"),
        ] {
            let error = read_steering(text.as_bytes()).expect_err(text);
            assert_eq!((error.line, error.column, error.found.as_str()), (line, column, found), "{text}");
        }
        let steering = read_steering(b"1 2 3\n4 5 6\n7 8").expect("two samples");
        assert_eq!((steering.samples.len(), steering.cut.as_deref()), (2, Some("7 8")));
        // A last line without an end that is whole counts.
        assert_eq!(read_steering(b"1 2 3").expect("a sample").samples.len(), 1);
        assert_eq!(read_steering(b"").expect("nothing").samples.len(), 0);
    }
}
