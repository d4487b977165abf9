//! Remote: clips and triangulations of a class, asked across the border of a process.
//!
//! question -WORDS-> the student's function, in its jail -WORDS-> answer
//!
//! A question is a line of words, an answer another: whole numbers as they are, reals as the sixteen hexadecimal digits of their bits, since
//! answers are judged to the bit. Each question is a run of its own: what a function keeps, it keeps for itself.
//!
//! Space: as the functions have it. Cost: a start a question, some milliseconds.

use super::harness::set_aside;
use crate::geometry::clip::{ClipVertex, ClipVolume, MAX_ATTRIBUTES};
use crate::math::Vec3;
use crate::raster::external::{self, Limits};
use crate::raster::functions::{ClipFunction, TriangulateFunction};
use crate::screen::EdgeKind;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::ExitCode;
use std::sync::atomic::{AtomicU32, Ordering};

/// More corners than any answer may have.
const MOST: usize = 1 << 16;
/// Time-outs after which nothing more is asked.
const PATIENCE: u32 = 2;

/// Words on their way out.
#[derive(Default)]
struct Line(String);

impl Line {
    fn real(&mut self, value: f64) {
        let _ = write!(self.0, "{:016x} ", value.to_bits());
    }

    fn whole(&mut self, value: usize) {
        let _ = write!(self.0, "{value} ");
    }

    fn point(&mut self, point: Vec3) {
        [point.x, point.y, point.z].into_iter().for_each(|value| self.real(value));
    }

    fn corners(&mut self, corners: &[ClipVertex]) {
        self.whole(corners.len());
        for corner in corners {
            self.point(corner.position);
            corner.attributes.iter().for_each(|&value| self.real(value));
            self.whole(match corner.edge {
                EdgeKind::Original => 0,
                EdgeKind::Cut => 1,
                EdgeKind::Diagonal => 2,
            });
        }
    }
}

/// Words on their way in; `None` where they are not what was agreed on.
struct Words<'a>(std::str::SplitAsciiWhitespace<'a>);

impl Words<'_> {
    fn real(&mut self) -> Option<f64> {
        u64::from_str_radix(self.0.next()?, 16).ok().map(f64::from_bits)
    }

    fn whole(&mut self) -> Option<usize> {
        self.0.next()?.parse().ok()
    }

    fn count(&mut self) -> Option<usize> {
        self.whole().filter(|&count| count <= MOST)
    }

    fn point(&mut self) -> Option<Vec3> {
        Some(Vec3::new(self.real()?, self.real()?, self.real()?))
    }

    fn corners(&mut self) -> Option<Vec<ClipVertex>> {
        (0..self.count()?).map(|_| self.corner()).collect()
    }

    fn corner(&mut self) -> Option<ClipVertex> {
        let position = self.point()?;
        let mut attributes = [0.0; MAX_ATTRIBUTES];
        for value in &mut attributes {
            *value = self.real()?;
        }
        let edge = match self.whole()? {
            0 => EdgeKind::Original,
            1 => EdgeKind::Cut,
            2 => EdgeKind::Diagonal,
            _ => return None,
        };
        Some(ClipVertex { position, attributes, edge })
    }
}

/// Answers questions with a clip: the `main` of a submission.
#[must_use]
pub fn serve_clip(clip: &ClipFunction) -> ExitCode {
    serve(|words| {
        let attributes = words.whole()?;
        let (hither, yon) = (words.real()?, words.real()?);
        let volume = ClipVolume { hither, yon: yon.is_finite().then_some(yon) };
        let polygon = words.corners()?;
        let mut line = Line::default();
        line.corners(&clip(&polygon, &volume, attributes));
        Some(line)
    })
}

/// Answers questions with a triangulation: the `main` of a submission.
#[must_use]
pub fn serve_triangulate(triangulate: &TriangulateFunction) -> ExitCode {
    serve(|words| {
        let normal = words.point()?;
        let outline = (0..words.count()?).map(|_| words.point()).collect::<Option<Vec<_>>>()?;
        let triangles = triangulate(&outline, normal);
        let mut line = Line::default();
        line.whole(triangles.len());
        triangles.iter().flatten().for_each(|&corner| line.whole(corner as usize));
        Some(line)
    })
}

fn serve(answer: impl Fn(&mut Words<'_>) -> Option<Line>) -> ExitCode {
    super::harness::panics_in_one_line();
    let Ok(mut out) = set_aside() else { return ExitCode::from(2) };
    for question in std::io::stdin().lines().map_while(Result::ok) {
        let Some(Line(line)) = answer(&mut Words(question.split_ascii_whitespace())) else { return ExitCode::from(2) };
        if writeln!(out, "{line}").is_err() {
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

/// A function in another process.
pub(super) struct Remote {
    words: Vec<OsString>,
    limits: Limits,
    time_outs: AtomicU32,
}

impl Remote {
    /// Behind the program `words`.
    pub fn new(words: Vec<OsString>, limits: Limits) -> Remote {
        Remote { words, limits, time_outs: AtomicU32::new(0) }
    }

    /// A clip that asks it.
    pub fn clip(&self, polygon: &[ClipVertex], volume: &ClipVolume, attributes: usize) -> Vec<ClipVertex> {
        let mut line = Line::default();
        line.whole(attributes);
        line.real(volume.hither);
        line.real(volume.yon.unwrap_or(f64::INFINITY));
        line.corners(polygon);
        self.asked(&line, |words| words.corners())
    }

    /// A triangulation that asks it.
    pub fn triangulate(&self, outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {
        let mut line = Line::default();
        line.point(normal);
        line.whole(outline.len());
        outline.iter().for_each(|&point| line.point(point));
        self.asked(&line, |words| {
            let count = words.count()?;
            let mut corner = || words.whole().and_then(|corner| u32::try_from(corner).ok());
            (0..count).map(|_| Some([corner()?, corner()?, corner()?])).collect()
        })
    }

    /// Asks; what goes wrong is a panic, as it is of a function in this process: whoever calls it catches that.
    fn asked<T>(&self, Line(question): &Line, read: impl Fn(&mut Words<'_>) -> Option<T>) -> T {
        if self.time_outs.load(Ordering::Relaxed) >= PATIENCE {
            give_up(format!("it is not asked any more, after {PATIENCE} answers that did not come in time"));
        }
        let run = external::ask(&self.words, format!("{question}\n").into_bytes(), &self.limits);
        let run = run.unwrap_or_else(|failure| give_up(failure.to_string()));
        if let Some(failure) = run.failure {
            self.time_outs.fetch_add(u32::from(failure.name() == "time-out"), Ordering::Relaxed);
            give_up(failure.to_string());
        }
        let text = String::from_utf8_lossy(&run.stdout);
        read(&mut Words(text.split_ascii_whitespace())).unwrap_or_else(|| give_up("no answer came back".to_string()))
    }
}

/// Unwinds without a word on standard error.
fn give_up(words: String) -> ! {
    std::panic::resume_unwind(Box::new(words))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_survive_to_the_bit() {
        let mut attributes = [0.1; MAX_ATTRIBUTES];
        attributes[3] = -0.0;
        let corner = ClipVertex { position: Vec3::new(1e-300, f64::MAX, 0.3), attributes, edge: EdgeKind::Cut };
        let mut line = Line::default();
        line.corners(&[corner, corner]);
        let read = Words(line.0.split_ascii_whitespace()).corners().expect("our own words");
        assert_eq!(read, [corner, corner]);
        assert!(read[1].attributes[3].is_sign_negative());
        assert_eq!(Words("99999999 0".split_ascii_whitespace()).corners(), None);
    }
}
