//! Subject: whatever draws and is graded, by whichever door it comes.
//!
//! DrawList -SUBJECT-> Picture, or the reason why there is none
//!
//! Why 8-bit pictures and not light: programs in other languages and pictures made elsewhere have nothing else, and the same
//! algorithm must get the same verdict through every door. Probes are encoded linearly, so that a plain round(255 c) is right.
//!
//! A rasterizer in this process cannot be stopped: Rust has no way to end a thread. A panic is caught and becomes a finding; an
//! endless loop ends with the patience of whoever waits, and keeps the results written so far. Doors with a process of their own
//! have limits on time and memory.

use crate::color::Encoding;
use crate::image::{Image, Picture};
use crate::plan::Accepts;
use crate::raster::external::External;
use crate::raster::{Frame, Order, PutCounts, Rasterizer};
use crate::render::{Canvas, draw};
use crate::screen::DrawList;
use crate::screen::file::Sheet;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// What happened, in one sentence.
    pub message: String,
    /// What to do about it.
    pub hint: String,
}

/// A picture, and what is known of how it came about.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The picture, encoded linearly.
    pub picture: Picture,
    /// What was put; only a rasterizer in this process can be watched.
    pub puts: Option<PutCounts>,
}

/// Something that draws lists.
pub trait Subject {
    /// Draws `list` as `sheet` says.
    ///
    /// # Errors
    /// [`Failure`] when there is no picture, or one that cannot be compared pixel by pixel.
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure>;

    /// How many lists it is best asked for together: those with a process of their own start once for all of them.
    fn batch(&self) -> usize {
        1
    }

    /// As [`Subject::draw`], of many lists on one sheet.
    fn draw_all(&self, lists: &[DrawList], sheet: &Sheet) -> Vec<Result<Answer, Failure>> {
        lists.iter().map(|list| self.draw(list, sheet)).collect()
    }

    /// Draws `list` once more and says in which order fragments were put; `None` where nobody can look, or nothing was drawn.
    fn order(&self, list: &DrawList, sheet: &Sheet) -> Option<Order> {
        let _ = (list, sheet);
        None
    }

    /// Whether [`Subject::order`] can answer.
    fn can_be_watched(&self) -> bool {
        false
    }

    /// The polygons it takes.
    fn accepts(&self) -> Accepts {
        Accepts::AnyPolygon
    }

    /// Whether samples may come as levels of 8 bits, whose mean is taken on this side of the door.
    fn answers_in_levels(&self) -> bool {
        false
    }

    /// Whether it can be asked for new pictures; a folder of pictures cannot, so its witnesses are not made smaller.
    fn can_draw_anything(&self) -> bool {
        true
    }
}

/// A rasterizer in this process.
pub struct InProcess<'a>(pub &'a dyn Rasterizer);

impl Subject for InProcess<'_> {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let canvas = Canvas { threads: 1, ..Canvas::of_sheet(sheet) };
        let drawn = catch_unwind(AssertUnwindSafe(|| draw(list, Some(self.0), &canvas)));
        let (image, puts) = drawn.map_err(|panic| Failure {
            message: format!("the rasterizer panicked: {}", panic_text(panic.as_ref())),
            hint: "Run the smallest case alone with `farop raster`, and read the line the panic names.".to_string(),
        })?;
        Ok(Answer { picture: image.encode(Encoding::Linear), puts: Some(puts) })
    }

    fn order(&self, list: &DrawList, sheet: &Sheet) -> Option<Order> {
        let mut frame = Frame::default();
        let size = (list.width, list.height);
        let mut target = frame.target(size, 0..list.height, sheet.background, sheet.transparency).watched();
        catch_unwind(AssertUnwindSafe(|| self.0.draw(list, &mut target))).ok()?;
        target.finish().order
    }

    fn can_be_watched(&self) -> bool {
        true
    }

    fn accepts(&self) -> Accepts {
        self.0.accepts()
    }
}

pub(super) fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "without words".to_string())
}

/// A rasterizer outside this process: a program or a library, in its jail.
pub struct Outside {
    external: External,
    /// It did not draw several lists in one run, or not as it draws them alone: so it is not asked to again.
    draws_one: Cell<bool>,
    /// Drawn in a run of many, a list once gave the picture that it gives alone.
    is_trusted: Cell<bool>,
}

/// Lists that a program gets in one run.
const BATCH: usize = 24;

impl Outside {
    /// A door to `external`.
    #[must_use]
    pub fn new(external: External) -> Outside {
        Outside { external, draws_one: Cell::new(false), is_trusted: Cell::new(false) }
    }
}

fn seen(image: &Image, sheet: &Sheet) -> Answer {
    Answer { picture: image.average(sheet.samples as usize).encode(Encoding::Linear), puts: None }
}

impl Subject for Outside {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let answer = self.external.picture(list, sheet).map_err(|failure| Failure {
            message: failure.to_string(),
            hint: format!(
                "Run the smallest case alone: farop raster CASE.scr -r '{}' -o case.png",
                self.external.name()
            ),
        })?;
        Ok(seen(&answer.image, sheet))
    }

    fn answers_in_levels(&self) -> bool {
        true
    }

    fn batch(&self) -> usize {
        if self.draws_one.get() { 1 } else { BATCH }
    }

    fn draw_all(&self, lists: &[DrawList], sheet: &Sheet) -> Vec<Result<Answer, Failure>> {
        if lists.len() > 1 && !self.draws_one.get() {
            let answers = self.external.at_once(lists, sheet).unwrap_or_default();
            let answers: Vec<_> = answers.iter().map(|answer| seen(&answer.image, sheet)).collect();
            // What is left over from one picture in the next must not count against a program that need draw only one.
            let alone = |list: &DrawList| self.draw(list, sheet).ok().map(|answer| answer.picture);
            let is_same =
                |(list, answer): (&DrawList, &Answer)| alone(list).is_some_and(|alone| alone == answer.picture);
            if self.is_trusted.get() || lists.last().zip(answers.last()).is_some_and(is_same) {
                self.is_trusted.set(true);
                if !answers.is_empty() {
                    return answers.into_iter().map(Ok).collect();
                }
            }
            self.draws_one.set(true);
        }
        lists.iter().map(|list| self.draw(list, sheet)).collect()
    }
}
