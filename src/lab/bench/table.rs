//! Table: the rows of a bench as text, as JSON, and as the one line that scripts read.
//!
//! rows -TABLE-> text of at most 100 columns

use super::frame::STAGES;
use super::summary::Summary;
use super::{FrameTimes, Row};
use crate::report::StageTime;
use serde_json::{Value, json};
use std::fmt::Write;

/// What was drawn, for head lines and figures a second.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Subject {
    /// The scene's name.
    pub scene: String,
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Name of the shading.
    pub shading: &'static str,
    /// A: samples of a pixel in each direction.
    pub samples: u32,
    /// Triangles that go into the pipeline.
    pub triangles: u64,
    /// Time from the file or name to the scene, milliseconds of the clock.
    pub parse: Summary,
    /// Bytes of the file, where there is one.
    pub file_bytes: Option<u64>,
    /// The most memory the process has held, bytes.
    pub peak_bytes: u64,
}

/// What the columns mean.
pub const LEGEND: &str = "\
times     milliseconds of the clock, medians; frame: plan to levels (8 bits a channel), with its
          quarters; cpu: of the processor, all threads; write: the picture as PNG, on top
Mtri/s    triangles into the pipeline, Mpx/s: pixels of the picture, in millions a second of frame
B/px      bytes of memory a frame is made in (draw list, sample grid, picture) for each pixel
differ    pixels that show something else than the first row's
";

/// The table of a scene.
#[must_use]
pub fn text(subject: &Subject, rows: &[Row]) -> String {
    let mut text = head(subject, rows);
    let _ = writeln!(
        text,
        "{:10} {:>3}{:>5}{:>7}{:>7}{:>7}{:>7} {:<14}{:>6}{:>6}{:>7}{:>6}{:>6}{:>7}",
        "rasterizer",
        "thr",
        "plan",
        "geomet",
        "raster",
        "levels",
        "frame",
        "(quarters)",
        "cpu",
        "write",
        "Mtri/s",
        "Mpx/s",
        "B/px",
        "differ"
    );
    for row in rows {
        let name = shortened(&row.name, 10);
        if let Some(reason) = &row.failure {
            let reason = reason.lines().next().unwrap_or_default();
            let _ = writeln!(text, "{name:10} {:>3}  {}", row.threads, shortened(reason, 80));
            continue;
        }
        let [plan, geometry, raster, levels, write] = medians(row, |stage| stage.elapsed);
        let (frame, cpu) = (frame(row, |time| time.elapsed), frame(row, processor));
        let quarters = format!("({}..{})", short(frame.low), short(frame.high));
        let _ = writeln!(
            text,
            "{name:10} {:>3}{}{}{}{}{} {quarters:<14}{}{}{:>7.1}{:>6.1}{:>6.0}{:>7}",
            row.threads,
            cell(plan, 5),
            cell(geometry, 7),
            cell(raster, 7),
            cell(levels, 7),
            cell(frame.median, 7),
            cell(cpu.median, 6),
            cell(write, 6),
            subject.triangles as f64 / frame.median / 1e3,
            pixels(subject) / frame.median / 1e3,
            row.bytes as f64 / pixels(subject),
            row.differing
        );
    }
    for row in rows.iter().filter(|row| row.instructions.is_some()) {
        let count = row.instructions.unwrap_or(0) as f64;
        let (triangles, pixels) = (count / subject.triangles.max(1) as f64, count / pixels(subject));
        let _ = writeln!(
            text,
            "{:10} {:.1} million instructions a frame on one thread: {triangles:.0} a triangle, {pixels:.1} a pixel",
            shortened(&row.name, 10),
            count / 1e6
        );
    }
    text
}

/// What was drawn, how it was read, how often it was drawn.
fn head(subject: &Subject, rows: &[Row]) -> String {
    let (width, height) = subject.size;
    let rounds = rows.iter().map(|row| row.times.len()).max().unwrap_or(0);
    let drawn = rows.iter().map(|row| row.drawn).max().unwrap_or(0);
    let read = match subject.file_bytes {
        Some(bytes) => {
            let megabytes = bytes as f64 / 1e6;
            let speed = megabytes / subject.parse.median * 1e3;
            format!("read in {} ms ({megabytes:.1} MB, {speed:.0} MB/s)", short(subject.parse.median))
        }
        None => format!("made and read in {} ms", short(subject.parse.median)),
    };
    format!(
        "{}: {width}x{height}, {}, {} x {} samples; {rounds} rounds\n{} triangles, {drawn} polygons drawn; {read}; peak memory {:.0} MB\n",
        subject.scene,
        subject.shading,
        subject.samples,
        subject.samples,
        subject.triangles,
        subject.peak_bytes as f64 / 1e6
    )
}

/// Everything of a scene as JSON.
#[must_use]
pub fn json(subject: &Subject, rows: &[Row]) -> Value {
    let row = |row: &Row| {
        let stage = |number: usize| {
            let of =
                |what: fn(StageTime) -> f64| Summary::of(row.times.iter().map(|times| what(times.stages()[number])));
            json!({ "elapsed": of(|time| time.elapsed), "processor": of(processor) })
        };
        let stages: serde_json::Map<String, Value> =
            STAGES.iter().enumerate().map(|(number, name)| (name.to_string(), stage(number))).collect();
        let elapsed = frame(row, |time| time.elapsed);
        json!({
            "rasterizer": row.name,
            "threads": row.threads,
            "rounds": row.times.len(),
            "stages_ms": stages,
            "frame_ms": { "elapsed": elapsed, "processor": frame(row, processor) },
            "triangles_per_second": (elapsed.median > 0.0).then(|| subject.triangles as f64 / elapsed.median * 1e3),
            "pixels_per_second": (elapsed.median > 0.0).then(|| pixels(subject) / elapsed.median * 1e3),
            "bytes_per_pixel": row.bytes as f64 / pixels(subject),
            "polygons_drawn": row.drawn,
            "differing_pixels": row.differing,
            "instructions": row.instructions,
            "failure": row.failure,
        })
    };
    json!({
        "scene": subject.scene,
        "size": [subject.size.0, subject.size.1],
        "shading": subject.shading,
        "samples": subject.samples,
        "triangles": subject.triangles,
        "parse_ms": subject.parse,
        "file_bytes": subject.file_bytes,
        "peak_bytes": subject.peak_bytes,
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
    })
}

/// One line for scripts: names and values with `=` between, times in milliseconds a frame.
#[must_use]
pub fn one_line(subject: &Subject, row: &Row) -> String {
    let (elapsed, cpu) = (frame(row, |time| time.elapsed), frame(row, processor));
    let [_, geometry, raster, levels, _] = medians(row, |stage| stage.elapsed);
    let (width, height) = subject.size;
    format!(
        "farop-{} {} mode={} size={width}x{height} aa={} threads={} tris={} median_ms={:.3} min_ms={:.3} cpu_ms={:.3} \
         geometry_ms={geometry:.3} raster_ms={raster:.3} levels_ms={levels:.3}\n",
        row.name,
        subject.scene.rsplit('/').next().unwrap_or_default(),
        subject.shading,
        subject.samples,
        row.threads,
        subject.triangles,
        elapsed.median,
        elapsed.least,
        cpu.median
    )
}

/// Times of the frame.
fn frame(row: &Row, what: fn(StageTime) -> f64) -> Summary {
    Summary::of(row.times.iter().map(|times| what(times.frame())))
}

/// The median of each stage.
fn medians(row: &Row, what: fn(StageTime) -> f64) -> [f64; 5] {
    let stage =
        |number: usize| Summary::of(row.times.iter().map(|times: &FrameTimes| what(times.stages()[number]))).median;
    [0, 1, 2, 3, 4].map(stage)
}

fn processor(time: StageTime) -> f64 {
    time.user + time.system
}

fn pixels(subject: &Subject) -> f64 {
    f64::from(subject.size.0) * f64::from(subject.size.1)
}

/// `text`, cut at `width` characters with a mark if it is longer.
fn shortened(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_string();
    }
    text.chars().take(width - 1).chain(['~']).collect()
}

/// Milliseconds in a cell.
fn cell(time: f64, width: usize) -> String {
    format!(" {:>w$}", short(time), w = width - 1)
}

/// Milliseconds in as many digits as mean something.
fn short(time: f64) -> String {
    match time {
        time if time < 10.0 => format!("{time:.2}"),
        time if time < 1000.0 => format!("{time:.1}"),
        time => format!("{time:.0}"),
    }
}
