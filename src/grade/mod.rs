//! Grade: draw small lists with a rasterizer, and say what is wrong with the pictures.
//!
//! probe -> DrawList -rasterizer-> Image -> compared with a picture drawn by hand -> Finding
//!
//! Why pictures drawn by hand (in [`probes`], as text) and not the built-in z-buffer's: a check that shares code with what it
//! checks shares its mistakes, and a reader can see from the text what is asked. Why so small: a wrong picture of six
//! samples a side names its reason; a wrong picture of gears does not.
//!
//! Space: samples; a picture has a character a sample: `1` shows the first polygon of the list, `.` the background, `?` a
//! color that belongs to no polygon.
//! Cost: a few hundred samples a probe.

mod area_rules;
pub mod bundle;
pub mod case;
mod cases;
pub mod class;
mod covered;
mod covering;
mod diagnose;
pub mod extremes;
pub mod folder;
pub mod functions;
pub mod handout;
pub mod harness;
pub mod hidden;
pub mod html;
pub mod labs;
pub mod light_rules;
mod lighting;
mod line_spans;
pub mod lines;
pub mod listed;
pub mod look;
mod memory;
pub mod mutants;
pub mod paint;
mod pairs;
pub mod pictures;
pub mod pixel_rules;
mod pixels;
mod place;
mod probes;
pub mod program_rules;
mod quarters;
pub mod remote;
pub mod rubric;
pub mod rules;
pub mod runs;
pub mod scan;
mod search;
mod shape;
mod stack;
pub mod subject;
mod summed;
mod values;
pub mod verdict;
mod watch;
pub mod witness;
pub mod write;

pub use diagnose::Fault;
pub use labs::{LABS, Lab};
pub use probes::{Flat, Probe, probes};
pub use subject::{InProcess, Outside, Subject};
pub use verdict::{Request, Verdict, grade};

use crate::color::Rgb;
use crate::geometry::split::{SplitScratch, split};
use crate::image::Image;
use crate::math::Vec3;
use crate::plan::{Accepts, Transparency};
use crate::raster::{PutCounts, Rasterizer};
use crate::render::{Canvas, draw};
use crate::screen::DrawList;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// One thing that is wrong with a rasterizer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Name of the probe that found it.
    pub probe: &'static str,
    /// What the probe tests, in one line.
    pub tests: &'static str,
    /// What is wrong: how many samples, the first of them, what it shows.
    pub message: String,
    /// What to look at.
    pub hint: &'static str,
    /// The picture that was expected, row by row.
    pub expected: Vec<String>,
    /// The picture that was drawn; empty when the rasterizer panicked.
    pub drawn: Vec<String>,
}

/// Draws every probe with `rasterizer`; nothing is found wanting when the result is empty.
///
/// A rasterizer that panics is a finding, too. One that takes only triangles is given triangles.
///
/// ```
/// use farop::{grade::check, raster::ZBuffer};
/// assert!(check(&ZBuffer).is_empty());
/// ```
#[must_use]
pub fn check(rasterizer: &dyn Rasterizer) -> Vec<Finding> {
    probes().iter().filter_map(|probe| judge(rasterizer, probe)).collect()
}

fn judge(rasterizer: &dyn Rasterizer, probe: &Probe) -> Option<Finding> {
    let (list, owners) = probe.list(rasterizer.accepts());
    let drawn_once = || catch_unwind(AssertUnwindSafe(|| draw(&list, Some(rasterizer), &CANVAS))).ok();
    let finding = |message: String, drawn| Finding {
        probe: probe.name,
        tests: probe.tests,
        message,
        hint: probe.hint,
        expected: probe.expected.iter().map(ToString::to_string).collect(),
        drawn,
    };
    let (Some((image, puts)), Some((again, _))) = (drawn_once(), drawn_once()) else {
        return Some(finding("the rasterizer panicked".to_string(), Vec::new()));
    };
    let drawn = as_text(&image, owners);
    let message = if image == again {
        complaint(probe, &drawn, puts)
    } else {
        Some("drawn twice, the same list gave two pictures: something is kept between calls".to_string())
    };
    message.map(|message| finding(message, drawn))
}

/// What is wrong with the text of a picture; `None` when nothing is.
fn complaint(probe: &Probe, drawn: &[String], puts: PutCounts) -> Option<String> {
    let expected = probe.expected.iter().flat_map(|row| row.chars());
    let pairs: Vec<_> = expected.zip(drawn.iter().flat_map(|row| row.chars())).collect();
    let wrong = pairs.iter().filter(|(expected, drawn)| expected != drawn).count();
    if let Some(first) = pairs.iter().position(|(expected, drawn)| expected != drawn) {
        let width = probe.size().0 as usize;
        let ((x, y), (expected, drawn), all) = ((first % width, first / width), pairs[first], pairs.len());
        let (expected, drawn) = (described(expected), described(drawn));
        return Some(format!(
            "{wrong} of {all} samples are wrong, the first at ({x}, {y}): {drawn} instead of {expected}"
        ));
    }
    let stray = puts.stray_writes;
    (stray > 0).then(|| format!("the picture is right, but {stray} fragments were put outside of it"))
}

fn described(sample: char) -> String {
    match sample {
        '.' => "background".to_string(),
        '?' => "a color of no polygon".to_string(),
        number => format!("polygon {number}"),
    }
}

/// What probes are drawn on: black, one sample a pixel.
const CANVAS: Canvas = Canvas { samples: 1, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };

/// The color of polygon `number`, from 1: exact in `f32`, no two alike, none like the background.
fn color(number: usize) -> [f64; 3] {
    let step = number as f64 / 16.0;
    [step, 1.0 - step, 0.5]
}

fn as_text(image: &Image, polygons: usize) -> Vec<String> {
    let symbol = |&light: &Rgb<f32>| {
        if light == CANVAS.background {
            return '.';
        }
        let shown = (1..=polygons).find(|&number| Rgb::from(color(number)).to_f32() == light);
        shown.and_then(|number| char::from_digit(number as u32, 10)).unwrap_or('?')
    };
    (0..image.height()).map(|row| image.row(row).iter().map(symbol).collect()).collect()
}

impl Probe {
    /// Width and height of its picture in samples.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.expected.first().map_or(0, |row| row.len()) as u32, self.expected.len() as u32)
    }

    /// The probe as a rasterizer gets it, and how many polygons it has before they are split.
    fn list(&self, accepts: Accepts) -> (DrawList, usize) {
        let (width, height) = self.size();
        let mut list = DrawList::new(width, height);
        for (index, polygon) in self.polygons.iter().enumerate() {
            for corners in polygon.pieces(accepts) {
                list.push_flat(&corners, polygon.depth, color(index + 1));
            }
        }
        (list, self.polygons.len())
    }
}

impl Flat {
    /// Its corners; or the corners of its triangles, which cover the same samples.
    fn pieces(&self, accepts: Accepts) -> Vec<Vec<(f64, f64)>> {
        if accepts == Accepts::AnyPolygon {
            return vec![self.corners.to_vec()];
        }
        let outline: Vec<_> = self.corners.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
        let mut triangles = Vec::new();
        split(&outline, crate::math::newell_normal(&outline), &mut SplitScratch::default(), &mut triangles);
        triangles.iter().map(|triangle| triangle.map(|corner| self.corners[corner as usize]).to_vec()).collect()
    }
}

impl fmt::Display for Finding {
    /// What, how many, why, and the two pictures side by side.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.probe, self.message)?;
        writeln!(f, "  tests: {}\n  hint:  {}", self.tests, self.hint)?;
        let width = self.expected.first().map_or(0, String::len).max("expected".len());
        writeln!(f, "  {:width$}   drawn", "expected")?;
        for (row, expected) in self.expected.iter().enumerate() {
            writeln!(f, "  {expected:width$}   {}", self.drawn.get(row).map_or("", String::as_str))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::{PerPolygon, PolygonRasterizer, Target, ZBuffer};
    use crate::screen::{ScreenPolygon, Shader};

    struct Panics;

    impl Rasterizer for Panics {
        fn draw(&self, _: &DrawList, _: &mut Target<'_>) {
            panic!("on purpose");
        }
    }

    struct Triangles;

    impl Rasterizer for Triangles {
        fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
            assert!(list.polygons().all(|polygon| polygon.vertices().len() == 3));
            ZBuffer.draw(list, target);
        }

        fn accepts(&self) -> Accepts {
            Accepts::Triangles
        }
    }

    struct Paints;

    impl PolygonRasterizer for Paints {
        fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
            target.put(shader.fragment(polygon, 0, 0));
        }
    }

    #[test]
    fn a_panic_is_a_finding() {
        let findings = check(&Panics);
        assert_eq!(findings.len(), probes().len());
        assert!(findings[0].message.contains("panicked"));
    }

    #[test]
    fn triangles_are_enough_to_pass() {
        assert_eq!(check(&Triangles), []);
    }

    #[test]
    fn a_finding_shows_both_pictures() {
        let text = check(&PerPolygon(Paints))[0].to_string();
        let rows = ["inside: 13 of 30 samples are wrong, the first at (0, 0): polygon 1 instead of background"];
        rows.iter().for_each(|row| assert!(text.contains(row), "{text}"));
        assert!(text.contains("  ......     1.....\n  .1111.     ......\n"), "{text}");
    }
}
