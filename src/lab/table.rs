//! Table: the rows of the lab as text, CSV and JSON.
//!
//! rows -TABLE-> text
//!
//! Error columns are the same in every run; only times change.

use super::pareto::{Standing, standings};
use super::{Kind, Row, Volume, points, volumes};
use crate::plan::Choices;
use serde_json::{Value, json};
use std::fmt::Write;

/// Names of the columns of the text table, below which they are explained.
const HEAD: &str = "      ms    ±ms  worst  1/1000    rms visible   edges  outline    FLIP  1-SSIM";

/// Names are as wide as this at least and at most.
const NAME: (usize, usize) = (13, 44);

/// The rows as a table of at most 124 columns; `*` marks the front by the RMS error, `~` what another run may put there, `!` what
/// gave no picture, with the reason.
#[must_use]
pub fn text(rows: &[Row]) -> String {
    let marks = standings(&points(rows, Kind::Rms));
    let width = rows.iter().map(|row| row.configuration.name.chars().count()).max().unwrap_or(0).clamp(NAME.0, NAME.1);
    let mut text = format!("  {:width$}{HEAD}\n", "configuration");
    for (row, standing) in rows.iter().zip(marks) {
        let name = shortened(&row.configuration.name, width);
        if let Some(reason) = &row.failure {
            // Of a long reason the first line; CSV and JSON have it all.
            let reason = reason.lines().next().unwrap_or_default();
            let _ = writeln!(text, "! {name:width$}  {}", shortened(reason, HEAD.chars().count() - 2));
            continue;
        }
        let mark = match standing {
            Standing::Front => '*',
            Standing::Tied => '~',
            Standing::Dominated => ' ',
        };
        let (timing, errors) = (&row.timing, &row.errors);
        let _ = writeln!(
            text,
            "{mark} {name:width$}{:>8}{:>7}{:>7.1}{:>8.2}{:>7.3}{}{}{}{:>8.5}{:>8.5}",
            milliseconds(timing.median),
            milliseconds(timing.spread),
            errors.worst_levels,
            errors.thousandth_levels,
            errors.rms_levels,
            maybe(errors.wrong_visible_ppm, 8, 0),
            maybe(errors.wrong_coverage_ppm, 8, 0),
            maybe(errors.silhouette_px, 9, 3),
            errors.flip_mean,
            errors.dissimilarity
        );
    }
    text
}

/// The hypervolumes as a table: a column a kind of error, a line for all rows and one for each rasterizer; empty where there are none.
#[must_use]
pub fn volume_text(rows: &[Row]) -> String {
    let volumes = volumes(rows);
    let Some(first) = volumes.first() else { return String::new() };
    let line = |name: &str, number: &dyn Fn(&Volume) -> String| {
        let cells: String = volumes.iter().map(|volume| format!("{:>10}", number(volume))).collect();
        format!("  {:width$}{cells}\n", shortened(name, NAME.1), width = NAME.1)
    };
    let mut text = line("hypervolume", &|volume| volume.kind.name().to_string());
    text += &line("all", &|volume| format!("{:.3}", volume.all));
    // Of a single rasterizer it is the same once more.
    for name in first.of.keys().filter(|_| first.of.len() > 1) {
        text += &line(&format!("-r {name}"), &|volume| maybe(volume.of.get(name).copied().flatten(), 0, 3));
    }
    text += &line("reference point, ms", &|volume| milliseconds(volume.reference.0));
    text + &line("reference point, error", &|volume| match volume.reference.1 {
        large if large >= 100.0 => format!("{large:.0}"),
        small => format!("{small:.3}"),
    })
}

/// `text`, with its middle left out if it is longer than `width`: both ends of a command tell it from others.
fn shortened(text: &str, width: usize) -> String {
    let count = text.chars().count();
    if count <= width {
        return text.to_string();
    }
    let (head, tail) = ((width - 1) / 2, width / 2);
    text.chars().take(head).chain(['~']).chain(text.chars().skip(count - tail)).collect()
}

/// What the columns mean.
pub const LEGEND: &str = "\
ms, ±ms   median time of a frame (plan, geometry, raster, averaging), and median distance from it
worst     largest error of a channel, levels of 255; 1/1000: one pixel in a thousand errs by more; rms: root mean square
visible   samples in a million that show another polygon or shape than a ray meets
edges     of a million samples at edges, those that snapping or the rasterizer gives to another polygon
outline   distance of the outlines in pixels (Hausdorff, 8 at most); FLIP: mean, 0 to 1; 1-SSIM: 0 is the same structure
*         on the front by rms: none is as accurate in less time; ~ beaten, but by less than the spread of the times
!         no picture came; why
hypervolume  share of the chart's box, from the least time and error to the reference point (the most of both), both axes
          logarithmic, that is dominated: 1 is best; an error of 0 counts as a tenth of the least other one
";

fn milliseconds(time: f64) -> String {
    if time < 100.0 { format!("{time:.2}") } else { format!("{time:.0}") }
}

fn maybe(value: Option<f64>, width: usize, digits: usize) -> String {
    value.map_or_else(|| format!("{:>width$}", "-"), |value| format!("{value:>width$.digits$}"))
}

/// The rows as CSV with a line of names; fields that no oracle knows are empty.
#[must_use]
pub fn csv(rows: &[Row]) -> String {
    let mut text = "configuration,rasterizer,shading,samples,tolerance,subpixel_bits,depth,median_ms,spread_ms,least_ms,runs,\
                    worst_levels,thousandth_levels,rms_levels,wrong_visible_ppm,wrong_coverage_ppm,silhouette_px,flip_mean,\
                    flip_worst,dissimilarity,front,failure\n"
        .to_string();
    let marks = standings(&points(rows, Kind::Rms));
    let known = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for (row, standing) in rows.iter().zip(marks) {
        let Row { configuration: of, timing, errors, failure } = row;
        let Choices { shading, samples, tolerance, subpixel_bits, depth, .. } = &of.choices;
        let (shading, depth) = (shading.name(), depth.name());
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        let finite = |values: &[f64]| {
            let known = |&value: &f64| known(value.is_finite().then_some(value));
            values.iter().map(known).collect::<Vec<_>>().join(",")
        };
        let made = [
            format!("{},{}", quoted(&of.name), quoted(&of.rasterizer)),
            format!("{shading},{samples},{tolerance},{subpixel_bits},{depth}"),
            format!("{},{},{},{}", timing.median, timing.spread, timing.least, timing.runs),
            finite(&[errors.worst_levels, errors.thousandth_levels, errors.rms_levels]),
            [errors.wrong_visible_ppm, errors.wrong_coverage_ppm, errors.silhouette_px].map(known).join(","),
            finite(&[errors.flip_mean, errors.flip_worst, errors.dissimilarity]),
            format!("{}", standing == Standing::Front),
            failure.as_ref().map_or_else(String::new, |reason| quoted(&reason.replace('\n', " "))),
        ];
        text += &made.join(",");
        text.push('\n');
    }
    text
}

/// The rows as a JSON object, with what `run` says about the run.
#[must_use]
pub fn json(rows: &[Row], run: &Value) -> Value {
    let marks: Vec<_> = Kind::ALL.iter().map(|&kind| (kind, standings(&points(rows, kind)))).collect();
    let row = |(index, row): (usize, &Row)| {
        let Row { configuration: of, timing, errors, failure } = row;
        let standing = marks.iter().map(|(kind, marks)| (format!("{kind:?}").to_lowercase(), json!(marks[index])));
        json!({
            "configuration": of.name,
            "rasterizer": of.rasterizer,
            "shading": of.choices.shading.name(),
            "samples": of.choices.samples,
            "tolerance": of.choices.tolerance,
            "subpixel_bits": of.choices.subpixel_bits,
            "depth": of.choices.depth.name(),
            "interpolation": of.choices.interpolation.name(),
            "times_ms": failure.is_none().then_some(timing),
            "errors": failure.is_none().then_some(errors),
            "failure": failure,
            "standing": Value::Object(standing.collect()),
        })
    };
    let volumes = volumes(rows).into_iter().map(|volume| (format!("{:?}", volume.kind).to_lowercase(), json!(volume)));
    json!({
        "schema": 1,
        "run": run,
        "rows": rows.iter().enumerate().map(row).collect::<Vec<_>>(),
        "hypervolumes": Value::Object(volumes.collect()),
    })
}
