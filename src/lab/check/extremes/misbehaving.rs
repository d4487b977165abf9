//! Item 102: rasterizers of others that misbehave, in this program and outside of it.
//!
//! In this program: fragments outside the picture are dropped and counted, depths that are no numbers harm no other sample, a panic is
//! caught by whoever asked. An endless loop there cannot be ended: Rust has no way to end a thread.
//! Outside, in the jail: a crash, an endless loop, memory, a flood of output, words before the picture, nothing at all; each must get
//! its name. The program that does it is farop itself, so it takes farop as a program: tests of the library alone get a notice.

use super::Outcome;
use super::tools::ensure;
use crate::color::Rgb;
use crate::plan::Transparency;
use crate::raster::external::{Enforced, External, Limits};
use crate::raster::{Rasterizer, Target};
use crate::render::{Canvas, draw};
use crate::screen::file::Sheet;
use crate::screen::{DrawList, Fragment};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::time::Duration;

/// Kinds of `farop __misbehave`, and the name that each must get.
const KINDS: [(&str, &str); 6] = [
    ("crash", "crash"),
    ("loop", "time-out"),
    ("memory", "memory"),
    ("flood", "too-much-output"),
    ("talk", "text-before-picture"),
    ("nothing", "no-output"),
];

pub(super) fn outcome() -> Outcome {
    in_this_program()?;
    let Some(enforced) = enforced()? else { return Ok(()) };
    for (kind, expected) in KINDS {
        // Where nobody limits memory, there is nothing to be seen of it.
        if kind == "memory" && !enforced.resources {
            continue;
        }
        let Some(program) = External::misbehaving(kind, limits()) else { continue };
        let name = program
            .picture(&DrawList::new(1, 1), &Sheet::default())
            .map_or_else(|failure| failure.name(), |_| "a picture");
        ensure(name == expected, format!("{kind}: `{name}`, not `{expected}`"))?;
    }
    Ok(())
}

/// What of the item could not be tried here.
pub(super) fn notice() -> Option<String> {
    match enforced() {
        Ok(None) => {
            Some("102 was tried with rasterizers of this program only; `farop check` tries programs, too".to_string())
        }
        Ok(Some(enforced)) => {
            let text = enforced.to_string();
            text.contains("NOT").then(|| format!("102 in a jail with holes; {text}"))
        }
        // That is a miss of the item, and told there.
        Err(_) => None,
    }
}

fn limits() -> Limits {
    Limits { wall: Duration::from_secs(1), memory: 256 << 20, output: 1 << 20, ..Limits::default() }
}

/// What the jail enforces; `None` where this program cannot start itself.
fn enforced() -> Result<Option<Enforced>, String> {
    let patient = Limits { wall: Duration::from_secs(10), ..limits() };
    let Some(program) = External::misbehaving("picture", patient) else { return Ok(None) };
    let answer = program.picture(&DrawList::new(1, 1), &Sheet::default());
    answer.map(|answer| Some(answer.enforced)).map_err(|failure| format!("a good program: {failure}"))
}

/// Writes everywhere, with depths that are no numbers; then gives up.
struct Rogue {
    panics: bool,
}

impl Rasterizer for Rogue {
    fn draw(&self, _: &DrawList, target: &mut Target<'_>) {
        let ends = [i32::MIN, -1, 0, 3, 4, i32::MAX];
        for (x, y) in ends.into_iter().flat_map(|y| ends.map(|x| (x, y))) {
            let (color, opacity) = (Rgb::gray(0.5), Rgb::gray(1.0));
            target.put(Fragment { x, y, depth: f64::NAN, color, opacity, polygon: u32::MAX - 1 });
            let _ = target.depth(x, y);
        }
        if self.panics {
            // As a panic, without its words on standard error.
            resume_unwind(Box::new("on purpose"));
        }
    }
}

fn in_this_program() -> Outcome {
    let canvas = Canvas { samples: 1, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };
    let list = DrawList::new(4, 4);
    let (image, puts) = draw(&list, Some(&Rogue { panics: false }), &canvas);
    ensure((puts.puts, puts.stray_writes) == (4, 32), format!("{} put, {} stray", puts.puts, puts.stray_writes))?;
    let drawn = image.pixels().iter().filter(|light| light.r == 0.5).count();
    let finite = image.pixels().iter().all(|light| light.to_array().iter().all(|channel| channel.is_finite()));
    ensure(drawn == 4 && finite, format!("{drawn} samples of 4, finite: {finite}"))?;
    let panicked = catch_unwind(AssertUnwindSafe(|| draw(&list, Some(&Rogue { panics: true }), &canvas))).is_err();
    ensure(panicked, "a panic came to nobody's notice")
}
