//! Tell: an explanation in words, as `farop why` prints it and the window shows it.
//!
//! explanation -TELL-> lines of text
//!
//! Why here and not in the command line: two doors show the same text, and a sample must not have two answers.

use super::Canvas;
use crate::color::{Encoding, Rgb};
use crate::raster::Rasterizer;
use crate::scene::Scene;
use crate::screen::DrawList;
use std::fmt::Write;

/// A list to ask about, and what it is drawn on.
#[derive(Clone, Copy, Debug)]
pub struct Asked<'a> {
    /// The list.
    pub list: &'a DrawList,
    /// Where its polygons come from; a screen file does not know.
    pub scene: Option<&'a Scene>,
    /// Background and samples.
    pub canvas: Canvas,
    /// What levels mean.
    pub encoding: Encoding,
}

impl Asked<'_> {
    /// What lies over a sample, and what `rasterizer` left there; lines that end in line breaks.
    #[must_use]
    pub fn sample(&self, sample: (i32, i32), rasterizer: Option<&dyn Rasterizer>) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write(sample, rasterizer, &mut text);
        text
    }

    fn write(&self, sample: (i32, i32), rasterizer: Option<&dyn Rasterizer>, text: &mut String) -> std::fmt::Result {
        let explanation = super::explain(self.list, sample.0, sample.1);
        let center = (f64::from(sample.0) + 0.5, f64::from(sample.1) + 0.5);
        writeln!(text, "sample {},{} (center {}, {})", sample.0, sample.1, center.0, center.1)?;
        for candidate in &explanation.candidates {
            self.candidate(candidate, text)?;
        }
        match explanation.winner {
            Some(index) => {
                writeln!(text, "  shown: polygon {}: {}", explanation.candidates[index].polygon, explanation.rule)?
            }
            None => writeln!(text, "  {}", explanation.rule)?,
        }
        if let Some(rasterizer) = rasterizer {
            self.drawn(sample, rasterizer, &explanation, text)?;
        }
        Ok(())
    }

    fn candidate(&self, candidate: &super::Candidate, text: &mut String) -> std::fmt::Result {
        let surface = &self.list.shader.surfaces[candidate.surface as usize];
        let line = crate::scene::Place { line: candidate.source.line, ..surface.place };
        let place = self.scene.map_or(String::new(), |scene| format!(", {}", scene.describe(line)));
        let piece = if candidate.source.tessellated { " (piece of a shape)" } else { "" };
        let depth = self.list.depth_in_scene_units(candidate.depth);
        let color = self.levels(candidate.color);
        write!(text, "  polygon {}{place}{piece}: depth {depth}, color {color}", candidate.polygon)?;
        if candidate.is_hole() {
            text.push_str(", a hole of its picture");
        } else if candidate.opacity != Rgb::gray(1.0) {
            write!(text, ", opacity {:?}", candidate.opacity.to_array())?;
        }
        writeln!(text)?;
        let edge = |(number, value): (usize, &f64)| {
            let through = if *value == 0.0 { " (through the center: the tie rule decides)" } else { "" };
            format!("{number}: {value}{through}")
        };
        let edges: Vec<_> = candidate.edges.iter().enumerate().map(edge).collect();
        writeln!(text, "    edges {}", edges.join(", "))
    }

    fn drawn(
        &self,
        sample: (i32, i32),
        rasterizer: &dyn Rasterizer,
        explanation: &super::Explanation,
        text: &mut String,
    ) -> std::fmt::Result {
        let Some(drawn) = super::drawn(self.list, rasterizer, &self.canvas, sample) else { return Ok(()) };
        let expected = explanation.winner.map(|index| explanation.candidates[index].polygon);
        let depth = self.list.depth_in_scene_units(drawn.depth);
        let what =
            drawn.polygon.map_or("nothing opaque".to_string(), |polygon| format!("polygon {polygon} at depth {depth}"));
        let verdict = if drawn.polygon == expected { "as the rules say" } else { "NOT what the rules say" };
        writeln!(text, "  the rasterizer put {what}, {verdict}; color {}", self.levels(drawn.color))
    }

    /// A light as the levels of a display.
    #[must_use]
    pub fn levels(&self, color: Rgb<f32>) -> String {
        let [r, g, b] = color.to_array().map(|light| self.encoding.level(light));
        format!("{r} {g} {b}")
    }
}
