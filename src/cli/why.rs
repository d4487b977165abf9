//! `farop why`: every polygon over a pixel, and which one wins by which rule; what a rasterizer drew there, and which mistake explains it.

use super::error::{self, CliError};
use super::options::PictureOptions;
use super::raster::read_screen_file;
use super::scenes::{Chosen, SceneOptions, as_rasterizer, check_drawn, find_rasterizer};
use crate::color::Encoding;
use crate::grade::look::{Resembles, Sight, look};
use crate::image::Image;
use crate::raster::{Rasterizer, Registry, ZBuffer};
use crate::render::why::Asked;
use crate::render::{self, Canvas};
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
            text += &subject.asked().sample(sample, rasterizer);
            if let Some((drawn, right)) = &pictures {
                if outside {
                    let light = drawn.pixel(x as usize, y as usize);
                    text += &format!("  {} drew color {}\n", self.rasterizer, subject.asked().levels(light));
                }
                let background = subject.canvas.background.to_f64().to_array();
                if let Some(sight) = look(&subject.list, (drawn, right), background, sample) {
                    let colors =
                        [drawn, right].map(|image| subject.asked().levels(image.pixel(x as usize, y as usize)));
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
    fn asked(&self) -> Asked<'_> {
        Asked { list: &self.list, scene: self.scene.as_ref(), canvas: self.canvas, encoding: self.encoding }
    }
}
