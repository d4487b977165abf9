//! `farop why`: every polygon over a pixel, and which one wins by which rule; what a rasterizer drew there, and which mistake explains it.

use super::error::{self, CliError};
use super::options::PictureOptions;
use super::raster::read_screen_file;
use super::scenes::{Chosen, SceneOptions, as_rasterizer, check_drawn, find_rasterizer};
use crate::color::{Encoding, Rgb};
use crate::grade::look::{Resembles, Sight, look};
use crate::image::Image;
use crate::raster::{Rasterizer, Registry, ZBuffer};
use crate::render::{self, Canvas, why};
use crate::scene::Scene;
use crate::screen::DrawList;
use crate::screen::file::ReadOptions;
use clap::Args;
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

/// Every polygon over a pixel, its depth and edges, who wins and by which rule
#[derive(Args)]
#[command(after_help = "Examples:\n  farop why spd:gears --pixel 256,256\n  farop why small.scr --pixel 3,4 -r mine")]
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
        let chosen = find_rasterizer(registry, &self.rasterizer)?;
        let subject = self.subject(as_rasterizer(&chosen))?;
        let samples = subject.canvas.samples;
        let (width, height) = (subject.list.width / samples, subject.list.height / samples);
        if self.pixel.0 >= width || self.pixel.1 >= height {
            let (x, y) = self.pixel;
            return Err(CliError::failed(format!("pixel {x},{y} is outside the picture of {width}x{height}")));
        }
        let pictures = self.pictures(&subject, as_rasterizer(&chosen))?;
        // A program outside farop gives a picture; which polygon it put where only the program knows.
        let outside = matches!(chosen, Some(Chosen::Outside(_)));
        let rasterizer = as_rasterizer(&chosen).filter(|_| !outside);
        let mut text = String::new();
        for number in 0..samples * samples {
            let (x, y) = (self.pixel.0 * samples + number % samples, self.pixel.1 * samples + number / samples);
            let sample = (x as i32, y as i32);
            // Writing to a String cannot fail.
            let _ = subject.sample(sample, rasterizer, &mut text);
            if let Some((drawn, right)) = &pictures {
                if outside {
                    let light = drawn.pixel(x as usize, y as usize);
                    text += &format!("  {} drew color {}\n", self.rasterizer, subject.levels(light));
                }
                let background = subject.canvas.background.to_f64().to_array();
                if let Some(sight) = look(&subject.list, (drawn, right), background, sample) {
                    let colors = [drawn, right].map(|image| subject.levels(image.pixel(x as usize, y as usize)));
                    let _ = said(&sight, &colors, &mut text);
                }
            }
        }
        error::print(&text)
    }

    /// What is asked about: a screen file, or scenes.
    fn subject(&self, rasterizer: Option<&dyn Rasterizer>) -> Result<Subject, CliError> {
        if let [name] = &self.scenes.scenes[..]
            && Path::new(name).extension().is_some_and(|ending| ending == "scr")
        {
            let file = read_screen_file(Path::new(name), &ReadOptions::default())?;
            let (canvas, encoding) = (Canvas::of_sheet(&file.sheet), file.sheet.encoding);
            return Ok(Subject { list: file.list, scene: None, canvas, encoding });
        }
        let loaded = self.scenes.load(&self.picture)?;
        let choices = self.picture.choices();
        let list = render::list(&loaded.scene, &choices, rasterizer)?;
        let canvas = Canvas::new(&loaded.scene, &choices);
        Ok(Subject { list, scene: Some(loaded.scene), canvas, encoding: choices.encoding })
    }

    /// All samples as the rasterizer draws them, and as they should be; lines are taken as they are drawn.
    fn pictures(
        &self,
        subject: &Subject,
        rasterizer: Option<&dyn Rasterizer>,
    ) -> Result<Option<(Image, Image)>, CliError> {
        let Some(rasterizer) = rasterizer else { return Ok(None) };
        let canvas = Canvas { samples: 1, ..subject.canvas };
        let drawn = catch_unwind(AssertUnwindSafe(|| render::draw(&subject.list, Some(rasterizer), &canvas)));
        let (drawn, puts) =
            drawn.map_err(|_| CliError::failed(format!("`{}` panicked; the message is above", self.rasterizer)))?;
        check_drawn(&puts)?;
        let right =
            if subject.list.has_depth { render::draw(&subject.list, Some(&ZBuffer), &canvas).0 } else { drawn.clone() };
        Ok(Some((drawn, right)))
    }
}

/// What a rasterizer drew instead, and why it may have.
fn said(sight: &Sight, [drawn, right]: &[String; 2], text: &mut String) -> std::fmt::Result {
    write!(text, "  it drew {drawn}, right is {right}: ")?;
    match sight.resembles {
        Resembles::Background => writeln!(text, "that is the background")?,
        Resembles::Over(polygon) => writeln!(text, "that is the color of polygon {polygon} here")?,
        Resembles::Beside(polygon, distance) if distance > 0.0 => {
            writeln!(
                text,
                "that is the color of polygon {polygon}, which begins {distance:.2} samples from the center"
            )?;
        }
        Resembles::Beside(polygon, _) => {
            writeln!(text, "that is the color of polygon {polygon}, which does not cover the center")?;
        }
        Resembles::Nobody => writeln!(text, "that is no polygon's color here, nor the background")?,
    }
    let (wrong, judged) = sight.wrong;
    let place = if sight.is_whole { "of the picture's" } else { "of the nearest" };
    match &sight.mistakes[..] {
        [] if judged == 0 => Ok(()),
        [] => writeln!(text, "  {wrong} {place} {judged} samples are wrong, and no single mistake explains them"),
        [(mistake, explained)] => {
            writeln!(
                text,
                "  {wrong} {place} {judged} samples are wrong; one mistake explains {explained} of them: {}",
                mistake.name
            )?;
            writeln!(text, "    why:   {}\n    rule:  {}\n    read:  {}", mistake.cause, mistake.rule, mistake.read)
        }
        several => {
            writeln!(text, "  {wrong} {place} {judged} samples are wrong; here several mistakes would look alike:")?;
            several.iter().try_for_each(|(mistake, explained)| {
                writeln!(text, "    {} (explains {explained}): {}", mistake.name, mistake.cause)
            })
        }
    }
}

/// A list to ask about, and what it is drawn on.
struct Subject {
    list: DrawList,
    /// Where polygons come from; a screen file does not know.
    scene: Option<Scene>,
    canvas: Canvas,
    encoding: Encoding,
}

impl Subject {
    fn sample(&self, sample: (i32, i32), rasterizer: Option<&dyn Rasterizer>, text: &mut String) -> std::fmt::Result {
        let explanation = why::explain(&self.list, sample.0, sample.1);
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
        let surface = &self.list.shader.surfaces[candidate.surface as usize];
        let line = crate::scene::Place { line: candidate.source.line, ..surface.place };
        let place = self.scene.as_ref().map_or(String::new(), |scene| format!(", {}", scene.describe(line)));
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
        explanation: &why::Explanation,
        text: &mut String,
    ) -> std::fmt::Result {
        let Some(drawn) = why::drawn(&self.list, rasterizer, &self.canvas, sample) else { return Ok(()) };
        let expected = explanation.winner.map(|index| explanation.candidates[index].polygon);
        let depth = self.list.depth_in_scene_units(drawn.depth);
        let what =
            drawn.polygon.map_or("nothing opaque".to_string(), |polygon| format!("polygon {polygon} at depth {depth}"));
        let verdict = if drawn.polygon == expected { "as the rules say" } else { "NOT what the rules say" };
        writeln!(text, "  the rasterizer put {what}, {verdict}; color {}", self.levels(drawn.color))
    }

    fn levels(&self, color: Rgb<f32>) -> String {
        let [r, g, b] = color.to_array().map(|light| self.encoding.level(light));
        format!("{r} {g} {b}")
    }
}
