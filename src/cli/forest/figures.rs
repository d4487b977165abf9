//! Figures of a walk: frames, trees and polygons a second, in the middle and at worst.

use super::paint::Painted;
use crate::lab::bench::summary::Summary;
use std::fmt::Write;

/// What all frames took.
#[derive(Default)]
pub(super) struct Figures {
    frames: Vec<Painted>,
}

impl Figures {
    pub fn add(&mut self, frame: Painted) {
        self.frames.push(frame);
    }

    /// The table of `--benchmark`; `head` says what was played, `samples` how many a frame has, `peak` bytes of memory.
    pub fn text(&self, head: &str, samples: u64, peak: u64) -> String {
        let all = self.frames.len().max(1) as f64;
        let seconds: f64 = self.frames.iter().map(Painted::total).sum();
        let per_frame = |of: fn(&Painted) -> u64| self.frames.iter().map(of).sum::<u64>() as f64 / all;
        let per_second = |frame: f64| frame * all / seconds.max(1e-9);
        let summary = Summary::of(self.frames.iter().map(Painted::total));
        // The first frame loads all cells around the observer; it is told by itself.
        let rest = if self.frames.len() > 1 { &self.frames[1..] } else { &self.frames[..] };
        let worst = rest.iter().map(Painted::total).fold(0.0, f64::max);
        let first = self.frames.first().map_or(0.0, Painted::total);
        let milliseconds = |seconds: f64| seconds * 1e3;
        let mut text = format!("{head}\n");
        let mut row = |name: &str, value: String| {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {name:9} {value}");
        };
        row(
            "frames/s",
            format!(
                "{:.2} over all, {:.2} in the middle, {:.2} at worst",
                all / seconds.max(1e-9),
                1.0 / summary.median.max(1e-9),
                1.0 / worst.max(1e-9)
            ),
        );
        row(
            "ms",
            format!(
                "{:.1} in the middle, {:.1} at worst: {:.2} times; the first frame {:.1}",
                milliseconds(summary.median),
                milliseconds(worst),
                worst / summary.median.max(1e-9),
                milliseconds(first)
            ),
        );
        let stage =
            |index: usize| milliseconds(Summary::of(self.frames.iter().map(|frame| frame.seconds[index])).median);
        row(
            "stages",
            format!(
                "compose {:.1}, geometry {:.1}, raster {:.1}, levels {:.1} ms",
                stage(0),
                stage(1),
                stage(2),
                stage(3)
            ),
        );
        let trees = per_frame(|frame| frame.trees);
        row("trees", format!("{trees:.0} a frame, {:.3} million a second", per_second(trees) / 1e6));
        let terrain = per_frame(|frame| frame.terrain);
        row("terrain", format!("{terrain:.0} polygons a frame, {:.1} thousand a second", per_second(terrain) / 1e3));
        row("polygons", format!("{:.0} a frame, all together", per_frame(|frame| frame.polygons)));
        row(
            "overdraw",
            format!("{:.2} samples put for one that is seen", per_frame(|frame| frame.puts) / samples.max(1) as f64),
        );
        row("memory", format!("{:.1} MB at most", peak as f64 / 1e6));
        text
    }
}
