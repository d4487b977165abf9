//! Words: the text over the board.
//!
//! State, counts, stages -WORDS-> lines -panel-> board

use super::eye::Gait;
use super::stages::short;
use super::{Compare, Guide, Show, Viewer, guide, made};
use crate::plan::{EXACT_SUBPIXELS, Shading};
use crate::render::Canvas;
use crate::render::why::Asked;

impl Viewer<'_> {
    /// The text over the board, line by line: what is shown, how it is made, counts, the step in hand, the pixel in hand.
    pub fn text(&mut self) -> Vec<String> {
        let mut lines = vec![self.title()];
        lines.extend(self.counts());
        lines.extend(self.progress());
        lines.extend(self.stage_text.iter().cloned());
        lines.extend(self.inspected());
        lines
    }

    fn title(&self) -> String {
        let state = &self.state;
        let choices = &state.choices;
        let bits = match choices.subpixel_bits {
            EXACT_SUBPIXELS => "no grid".to_string(),
            bits => format!("{bits} bits"),
        };
        let rasterizer = self.maker.rasterizers.get(state.rasterizer).map_or("", |named| &named.0);
        // Only the picture is compared.
        let compare = if state.show == Show::Picture { state.compare } else { Compare::Yours };
        let rasterizer = match (choices.shading, compare) {
            (Shading::Wire, _) => "wire",
            (_, Compare::Yours) => rasterizer,
            (_, Compare::Reference) => "zbuffer (reference)",
            (_, Compare::Difference) => "difference",
        };
        let step = state.step().map_or(String::new(), |step| format!(", step {step}"));
        format!(
            "{}{step} | {} | {rasterizer} | {}x{} samples | {} culling | {bits}",
            state.show.name(),
            choices.shading.name(),
            choices.samples,
            choices.samples,
            choices.culling.name()
        )
    }

    fn counts(&mut self) -> Option<String> {
        let counts = &self.maker.listed(&self.wish()).ok()?.counts;
        let shapes = &counts.tessellated;
        Some(format!(
            "polygons: {} ({} back, {} outside, {} drawn, {} cut)",
            counts.polygons + shapes.polygons,
            counts.backfacing + shapes.backfacing,
            counts.clipped + shapes.clipped,
            counts.rendered + shapes.rendered,
            counts.cut
        ))
    }

    /// How the eye moves, and what is being recorded, played or saved.
    fn progress(&self) -> Option<String> {
        let state = &self.state;
        let mut words = vec![state.eye.gait.name().to_string()];
        if state.eye.gait != Gait::Orbit {
            words.push(format!("speed {}", short(state.eye.speed())));
        }
        if state.guide != Guide::Nothing {
            words.push(format!("heading {:.0}", guide::heading(&state.eye)));
        }
        words.extend(state.rate.map(|rate| format!("{rate:.0} frames/s")));
        words.extend(state.is_recording.then(|| format!("recording {} frames", state.path.len())));
        words.extend(state.playing.map(|next| format!("playing {next} of {}", state.path.len())));
        words.extend(state.movie.map(|frame| format!("saving frame {frame}")));
        (words.len() > 1).then(|| words.join(", "))
    }

    /// The words of `farop why` for the pixel in question.
    fn inspected(&mut self) -> Vec<String> {
        let Some(pixel) = self.state.inspected.filter(|_| !self.state.show.is_outside()) else { return Vec::new() };
        let wish = self.wish();
        let Ok(listed) = self.maker.listed(&wish) else { return Vec::new() };
        let rasterizer = self.maker.rasterizer(&wish);
        let canvas = Canvas::new(&self.maker.scene, &wish.choices);
        let asked =
            Asked { list: &listed.list, scene: Some(&self.maker.scene), canvas, encoding: wish.choices.encoding };
        let side = wish.choices.samples as i32;
        let samples = (0..side * side).map(|n| (pixel.0 * side + n % side, pixel.1 * side + n / side));
        let said = samples
            .map(|sample| made::carefully(|| asked.sample(sample, Some(rasterizer))).unwrap_or_else(|panic| panic));
        said.collect::<String>().lines().map(String::from).collect()
    }
}
