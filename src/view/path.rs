//! Path: where the eye was, frame by frame; recorded, kept as text, played again.
//!
//! eye -PATH-> file -PATH-> eye
//!
//! Why one pose a frame and not keys and times: a frame that came late would end elsewhere. A path is also a benchmark,
//! and a benchmark must see the same pictures on every machine, so playing shows pose after pose, whatever the clock says.
//! Why text with all digits: it can be read and compared, and reading it back gives the same bits.
//!
//! Space: world, scene units.

use crate::math::Vec3;
use std::fmt::Write;

/// Where the eye stands and looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// The eye.
    pub from: Vec3,
    /// What is in the middle of the picture.
    pub at: Vec3,
    /// What is up.
    pub up: Vec3,
}

/// Why a path cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line} of the path: {what}")]
pub struct PathError {
    /// 1-based.
    pub line: usize,
    /// What is wrong and what is expected.
    pub what: String,
}

const FIRST_LINE: &str = "farop-path 1";
/// More poses are refused: ten hours at 30 a second.
const MOST: usize = 1 << 20;

/// The path as text.
#[must_use]
pub fn write_path(poses: &[Pose]) -> String {
    let mut text = format!("{FIRST_LINE}\n# a frame a line: from, at, up\n");
    for pose in poses {
        let numbers = [pose.from, pose.at, pose.up].map(|v| format!("{:?} {:?} {:?}", v.x, v.y, v.z));
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}", numbers.join("  "));
    }
    text
}

/// The poses of a path; lines that are empty or begin with `#` say nothing.
///
/// # Errors
/// [`PathError`] names the first line that is no pose.
///
/// ```
/// use farop::view::path::{read_path, write_path};
/// let text = "farop-path 1\n0 0 0.1  0 0 -1  0 1 0\n";
/// let poses = read_path(text).expect("one pose");
/// assert_eq!(read_path(&write_path(&poses)), Ok(poses));
/// assert_eq!(read_path("0 0 0").expect_err("no first line").line, 1);
/// ```
pub fn read_path(text: &str) -> Result<Vec<Pose>, PathError> {
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let fault = |line: usize, what: String| PathError { line, what };
    match lines.next() {
        Some((_, FIRST_LINE)) => {}
        _ => return Err(fault(1, format!("expected `{FIRST_LINE}`; record a path with the key p, save it with w"))),
    }
    let mut poses = Vec::new();
    for (number, line) in lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        let expected = "expected nine finite numbers: from, at, up";
        let words: Option<Vec<f64>> = line.split_whitespace().map(|word| word.parse().ok()).collect();
        let words = words.filter(|words| words.len() == 9 && words.iter().all(|number| number.is_finite()));
        let words = words.ok_or_else(|| fault(number, expected.to_string()))?;
        let vector = |start: usize| Vec3::new(words[start], words[start + 1], words[start + 2]);
        let pose = Pose { from: vector(0), at: vector(3), up: vector(6) };
        if pose.from == pose.at || pose.up == Vec3::ZERO {
            return Err(fault(number, "from and at must differ, and up must have a direction".to_string()));
        }
        if poses.len() == MOST {
            return Err(fault(number, format!("more than {MOST} frames")));
        }
        poses.push(pose);
    }
    Ok(poses)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_comes_back() {
        let pose = |x: f64| Pose { from: Vec3::new(x, 1.0 / 3.0, 1e-300), at: Vec3::splat(-1e20), up: Vec3::Y };
        let poses: Vec<_> = (0..5).map(|step| pose(f64::from(step) * 0.1)).collect();
        assert_eq!(read_path(&write_path(&poses)).expect("its own text"), poses);
    }

    #[test]
    fn faults_have_a_line() {
        let at = |text: &str| read_path(&format!("farop-path 1\n\n{text}")).expect_err(text).line;
        assert_eq!(at("# fine\n1 2 3"), 4);
        assert_eq!([at("0 0 0 0 0 0 0 1 0"), at("0 0 0 0 0 nan 0 1 0"), at("0 0 0 0 0 1 0 0 0")], [3; 3]);
        assert_eq!(read_path("").expect_err("nothing").line, 1);
    }
}
