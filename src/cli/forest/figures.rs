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

    /// The table of `--benchmark`; `head` says what was played, `peak` is bytes of memory.
    pub fn text(&self, head: &str, peak: u64) -> String {
        let mut text = format!("{head}\n");
        let memory = ("memory", format!("{:.1} MB at most", peak as f64 / 1e6));
        for (name, value) in self.times().into_iter().chain(self.counts()).chain([memory]) {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {name:9} {value}");
        }
        text
    }

    /// Milliseconds of all frames.
    fn sum(&self) -> f64 {
        self.frames.iter().map(Painted::total).sum()
    }

    fn times(&self) -> [(&'static str, String); 3] {
        let middle = Summary::of(self.frames.iter().map(Painted::total)).median;
        // The first frame loads all cells around the observer; it is told by itself.
        let rest = if self.frames.len() > 1 { &self.frames[1..] } else { &self.frames[..] };
        let worst = rest.iter().map(Painted::total).fold(0.0, f64::max);
        let first = self.frames.first().map_or(0.0, Painted::total);
        let stage = |index: usize| Summary::of(self.frames.iter().map(|frame| frame.milliseconds[index])).median;
        let rate = |milliseconds: f64| 1e3 / milliseconds.max(1e-6);
        let all = self.sum() / self.frames.len().max(1) as f64;
        let times = worst / middle.max(1e-6);
        [
            (
                "frames/s",
                format!("{:.2} over all, {:.2} in the middle, {:.2} at worst", rate(all), rate(middle), rate(worst)),
            ),
            (
                "ms",
                format!("{middle:.1} in the middle, {worst:.1} at worst: {times:.2} times; the first frame {first:.1}"),
            ),
            (
                "stages",
                format!(
                    "compose {:.1}, geometry {:.1}, raster {:.1}, levels {:.1} ms",
                    stage(0),
                    stage(1),
                    stage(2),
                    stage(3)
                ),
            ),
        ]
    }

    fn counts(&self) -> Vec<(&'static str, String)> {
        let all = self.frames.len().max(1) as f64;
        let total = |of: fn(&Painted) -> u64| self.frames.iter().map(of).sum::<u64>() as f64;
        let per_second = |count: f64| 1e3 * count / self.sum().max(1e-6);
        let (trees, terrain) = (total(|frame| frame.trees), total(|frame| frame.terrain));
        let [solids, triangles] = [total(|frame| frame.solids[0]), total(|frame| frame.solids[1])].map(|sum| sum / all);
        let mut counts = vec![
            ("trees", format!("{:.0} a frame, {:.3} million a second", trees / all, per_second(trees) / 1e6)),
            (
                "terrain",
                format!("{:.0} polygons a frame, {:.1} thousand a second", terrain / all, per_second(terrain) / 1e3),
            ),
            ("polygons", format!("{:.0} a frame, all together", total(|frame| frame.polygons) / all)),
            ("overdraw", overdraw(total(|frame| frame.puts), total(|frame| frame.overdraw))),
        ];
        if solids > 0.0 {
            counts.insert(1, ("meshes", format!("{solids:.1} trees a frame, {triangles:.0} triangles")));
        }
        counts
    }
}

fn overdraw(puts: f64, over: f64) -> String {
    if over == 0.0 {
        return "not counted by a rasterizer of finished pixels; `-r zbuffer` counts it".to_string();
    }
    format!("{:.2} samples put for each that is seen", puts / (puts - over).max(1.0))
}
