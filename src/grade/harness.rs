//! Harness: what a class's Rust submission is compiled into, a program that draws what it is given.
//!
//! screen files on standard input -HARNESS-> the student's rasterizer -> PF pictures on standard output
//!
//! Why a program and not this process: an endless loop can be ended, and what it reads, writes and starts can be held. The protocol is
//! that of `exec:`; floats go back, so that nothing is rounded, and a remark beside each picture says what a picture does not
//! show: fragments put outside, and the order of all of them.
//!
//! What a submission prints does not reach the grader: standard output is set aside before it begins. A program in which the
//! student's code runs can still lie about the order; it cannot lie about pictures, which are judged outside.

use crate::plan::Accepts;
use crate::raster::external::write_remarked;
use crate::raster::{Frame, Order, Rasterizer, Target};
use crate::render::{Canvas, draw};
use crate::screen::ScreenPolygon;
use crate::screen::file::{ReadOptions, ScreenFile, read};
use serde::{Deserialize, Serialize};
use std::io::{BufRead, Write};
use std::ops::Range;
use std::process::ExitCode;

/// The word for "watch the order, too".
pub(super) const WATCH: &str = "watch";
/// The word for "which polygons do you take?".
pub(super) const ACCEPTS: &str = "accepts";
/// The answer to that, of one that takes triangles alone.
pub(super) const TRIANGLES: &str = "triangles";

type Sample = (i32, i32);

/// What a picture does not show.
#[derive(Clone, Copy, Debug, Default, Deserialize, Serialize)]
pub(super) struct Remark {
    pub stray: u64,
    reads: (u64, Option<Sample>),
    repeats: (u64, Option<Sample>),
    steps_back: (u64, Option<[Sample; 2]>),
}

impl Remark {
    fn new(stray: u64, order: Order) -> Remark {
        Remark {
            stray,
            reads: (order.depth_reads, order.first_read),
            repeats: (order.repeats, order.first_repeat),
            steps_back: (order.steps_back, order.first_step_back),
        }
    }

    pub fn order(self) -> Order {
        Order {
            depth_reads: self.reads.0,
            first_read: self.reads.1,
            repeats: self.repeats.0,
            first_repeat: self.repeats.1,
            steps_back: self.steps_back.0,
            first_step_back: self.steps_back.1,
        }
    }
}

/// Draws with `rasterizer` until standard input ends: the `main` of a submission.
#[must_use]
pub fn serve(rasterizer: &dyn Rasterizer) -> ExitCode {
    panics_in_one_line();
    let asked = std::env::args().nth(1).unwrap_or_default();
    let Ok(mut out) = set_aside() else { return ExitCode::from(2) };
    if asked == ACCEPTS {
        let answer = if rasterizer.accepts() == Accepts::Triangles { TRIANGLES } else { "polygons" };
        return if writeln!(out, "{answer}").is_ok() { ExitCode::SUCCESS } else { ExitCode::from(2) };
    }
    let mut input = std::io::stdin().lock();
    while let Some(text) = next_file(&mut input) {
        let Ok(file) = read(&text, &ReadOptions::default()) else { return ExitCode::from(2) };
        let picture = drawn(rasterizer, &file, asked == WATCH);
        if out.write_all(&picture).and_then(|()| out.flush()).is_err() {
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}

/// The place first; the grader shows the last line.
pub(super) fn panics_in_one_line() {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map(|place| format!("{}:{}", place.file(), place.line())).unwrap_or_default();
        let words = super::subject::panic_text(panic.payload());
        let _ = writeln!(std::io::stderr(), "panicked at {place}: {}", words.replace('\n', " "));
    }));
}

fn drawn(rasterizer: &dyn Rasterizer, file: &ScreenFile, is_watched: bool) -> Vec<u8> {
    let (list, sheet) = (&file.list, &file.sheet);
    let canvas = Canvas { samples: 1, threads: 1, ..Canvas::of_sheet(sheet) };
    let (image, puts) = draw(list, Some(rasterizer), &canvas);
    let mut order = Order::default();
    if is_watched {
        let mut frame = Frame::default();
        let size = (list.width, list.height);
        let mut target = frame.target(size, 0..list.height, sheet.background, sheet.transparency).watched();
        rasterizer.draw(list, &mut target);
        order = target.finish().order.unwrap_or_default();
    }
    let remark = serde_json::to_string(&Remark::new(puts.stray_writes, order)).unwrap_or_default();
    let rgb: Vec<f32> =
        (0..image.height()).flat_map(|row| image.row(row)).flat_map(|light| [light.r, light.g, light.b]).collect();
    let mut bytes = Vec::new();
    write_remarked(image.width(), &rgb, &remark, &mut bytes);
    bytes
}

/// The next screen file: up to its line `end`.
fn next_file(input: &mut impl BufRead) -> Option<String> {
    let mut text = String::new();
    loop {
        let start = text.len();
        match input.read_line(&mut text) {
            Ok(0) | Err(_) => return Some(text).filter(|text| !text.trim().is_empty()),
            Ok(_) if text[start..].trim_end() == "end" => return Some(text),
            Ok(_) => {}
        }
    }
}

/// Standard output for pictures alone; what the student's code prints goes to standard error from now on.
#[cfg(unix)]
pub(super) fn set_aside() -> std::io::Result<impl Write> {
    let out = nix::unistd::dup(std::io::stdout())?;
    nix::unistd::dup2_stdout(std::io::stderr())?;
    Ok(std::fs::File::from(out))
}

#[cfg(not(unix))]
pub(super) fn set_aside() -> std::io::Result<impl Write> {
    Ok(std::io::stdout())
}

/// Columns and rows that a polygon can reach, held inside the target: as the lab crate has it under `crate::reach`.
#[must_use]
pub fn reach(polygon: &ScreenPolygon<'_>, target: &Target<'_>) -> (Range<i32>, Range<i32>) {
    let within = |coordinates: &mut dyn Iterator<Item = f64>, limits: Range<i32>| {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = coordinates.fold(start, |(low, high), x| (low.min(x), high.max(x)));
        (low.floor() as i32).max(limits.start)..(high.ceil() as i32).min(limits.end)
    };
    let corners = polygon.vertices();
    let columns = within(&mut corners.iter().map(|corner| corner.x), 0..target.width());
    (columns, within(&mut corners.iter().map(|corner| corner.y), target.row_range()))
}
