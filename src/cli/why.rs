//! `farop why`: every polygon over a pixel, and which one wins by which rule.

use super::error::{self, CliError};
use super::options::PictureOptions;
use super::scenes::{Chosen, SceneOptions, as_rasterizer, check_drawn, find_rasterizer};
use crate::color::Rgb;
use crate::image::Image;
use crate::plan::Choices;
use crate::raster::{Rasterizer, Registry};
use crate::render::{self, Canvas, Rendered, why};
use crate::scene::Scene;
use clap::Args;
use std::fmt::Write;

/// Every polygon over a pixel, its depth and edges, who wins and by which rule
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop why spd:gears --pixel 256,256\n  farop why scene.nff --size 64 --pixel 12,40 -r wire"
)]
pub(super) struct WhyCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Column and row, 0,0 is the upper left
    #[arg(long, value_name = "X,Y", value_parser = pixel)]
    pixel: (u32, u32),
    /// Rasterizer whose result is held against the rules
    #[arg(short, long, value_name = "NAME", default_value = "zbuffer")]
    rasterizer: String,
    #[command(flatten)]
    picture: PictureOptions,
}

fn pixel(text: &str) -> Result<(u32, u32), String> {
    let (x, y) = text.split_once(',').ok_or("expected X,Y, as in 12,40")?;
    let number = |text: &str| text.trim().parse::<u32>().map_err(|_| format!("`{text}` is not a column or row"));
    Ok((number(x)?, number(y)?))
}

impl WhyCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let chosen = find_rasterizer(registry, &self.rasterizer)?;
        let outside = matches!(chosen, Some(Chosen::Outside(_)));
        let rasterizer = as_rasterizer(&chosen).filter(|_| !outside);
        let choices = self.picture.choices();
        let rendered = render::render_with(&loaded.scene, &choices, None, |_| ())?;
        let (width, height) = rendered.plan.view.pixels;
        if self.pixel.0 >= width || self.pixel.1 >= height {
            let (x, y) = self.pixel;
            return Err(CliError::failed(format!("pixel {x},{y} is outside the picture of {width}x{height}")));
        }
        // A program outside farop gives a picture; which polygon it put where only the program knows.
        let picture =
            if outside { Some(picture_of(&loaded.scene, &choices, &rendered, as_rasterizer(&chosen))?) } else { None };
        let mut text = String::new();
        let corner = (self.pixel.0 * choices.samples, self.pixel.1 * choices.samples);
        for sample in 0..choices.samples * choices.samples {
            let sample = (corner.0 + sample % choices.samples, corner.1 + sample / choices.samples);
            let context = Context { scene: &loaded.scene, choices: &choices, rendered: &rendered };
            // Writing to a String cannot fail.
            let _ = context.sample((sample.0 as i32, sample.1 as i32), rasterizer, &mut text);
            if let Some(image) = &picture {
                let light = image.pixel(sample.0 as usize, sample.1 as usize);
                text += &format!("  {} drew color {}\n", self.rasterizer, context.levels(light));
            }
        }
        error::print(&text)
    }
}

/// The sample grid as a rasterizer outside farop draws it.
fn picture_of(
    scene: &Scene,
    choices: &Choices,
    rendered: &Rendered,
    rasterizer: Option<&dyn Rasterizer>,
) -> Result<Image, CliError> {
    let canvas = Canvas { samples: 1, ..Canvas::new(scene, choices) };
    let (image, puts) = render::draw(&rendered.list, rasterizer, &canvas);
    check_drawn(&puts)?;
    Ok(image)
}

struct Context<'a> {
    scene: &'a Scene,
    choices: &'a Choices,
    rendered: &'a Rendered,
}

impl Context<'_> {
    fn sample(&self, sample: (i32, i32), rasterizer: Option<&dyn Rasterizer>, text: &mut String) -> std::fmt::Result {
        let list = &self.rendered.list;
        let explanation = why::explain(list, sample.0, sample.1);
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

    fn candidate(&self, candidate: &why::Candidate, text: &mut String) -> std::fmt::Result {
        let surface = &self.rendered.list.shader.surfaces[candidate.surface as usize];
        let line = crate::scene::Place { line: candidate.source.line, ..surface.place };
        let piece = if candidate.source.tessellated { " (piece of a shape)" } else { "" };
        let depth = self.rendered.list.depth_in_scene_units(candidate.depth);
        let (place, color) = (self.scene.describe(line), self.levels(candidate.color));
        write!(text, "  polygon {}, {place}{piece}: depth {depth}, color {color}", candidate.polygon)?;
        if candidate.opacity != Rgb::gray(1.0) {
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
        explanation: &why::Explanation,
        text: &mut String,
    ) -> std::fmt::Result {
        let canvas = Canvas::new(self.scene, self.choices);
        let Some(drawn) = why::drawn(&self.rendered.list, rasterizer, &canvas, sample) else { return Ok(()) };
        let expected = explanation.winner.map(|index| explanation.candidates[index].polygon);
        let depth = self.rendered.list.depth_in_scene_units(drawn.depth);
        let what =
            drawn.polygon.map_or("nothing opaque".to_string(), |polygon| format!("polygon {polygon} at depth {depth}"));
        let verdict = if drawn.polygon == expected { "as the rules say" } else { "NOT what the rules say" };
        writeln!(text, "  the rasterizer put {what}, {verdict}; color {}", self.levels(drawn.color))
    }

    fn levels(&self, color: Rgb<f32>) -> String {
        let [r, g, b] = color.to_array().map(|light| self.choices.encoding.level(light));
        format!("{r} {g} {b}")
    }
}
