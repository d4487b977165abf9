//! Table: the rows of the lab as text, CSV and JSON.
//!
//! rows -TABLE-> text
//!
//! Error columns are the same in every run; only times change.

use super::pareto::{Standing, standings};
use super::{Kind, Row, points};
use crate::plan::Choices;
use serde_json::{Value, json};
use std::fmt::Write;

/// Names of the columns of the text table, below which they are explained.
const HEAD: &str = "      ms    ±ms  worst  1/1000    rms visible   edges  outline    FLIP  1-SSIM";

/// The rows as a table of at most 110 columns; `*` marks the front by the RMS error, `~` what another run may put there.
#[must_use]
pub fn text(rows: &[Row]) -> String {
    let marks = standings(&points(rows, Kind::Rms));
    let width = rows.iter().map(|row| row.configuration.name.chars().count()).max().unwrap_or(0).clamp(13, 30);
    let mut text = format!("  {:width$}{HEAD}\n", "configuration");
    for (row, standing) in rows.iter().zip(marks) {
        let mark = match standing {
            Standing::Front => '*',
            Standing::Tied => '~',
            Standing::Dominated => ' ',
        };
        let name: String = row.configuration.name.chars().take(width).collect();
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

/// What the columns mean.
pub const LEGEND: &str = "\
ms, ±ms   median time of a frame (plan, geometry, raster, averaging), and median distance from it
worst     largest error of a channel, levels of 255; 1/1000: one pixel in a thousand errs by more; rms: root mean square
visible   samples in a million that show another polygon or shape than a ray meets
edges     of a million samples at edges, those that snapping or the rasterizer gives to another polygon
outline   distance of the outlines in pixels (Hausdorff, 8 at most); FLIP: mean, 0 to 1; 1-SSIM: 0 is the same structure
*         on the front by rms: none is as accurate in less time; ~ beaten, but by less than the spread of the times
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
                    flip_worst,dissimilarity,front\n"
        .to_string();
    let marks = standings(&points(rows, Kind::Rms));
    let known = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for (row, standing) in rows.iter().zip(marks) {
        let Row { configuration: of, timing, errors } = row;
        let Choices { shading, samples, tolerance, subpixel_bits, depth, .. } = &of.choices;
        let (shading, depth) = (shading.name(), depth.name());
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        let made = [
            format!("{},{}", quoted(&of.name), quoted(&of.rasterizer)),
            format!("{shading},{samples},{tolerance},{subpixel_bits},{depth}"),
            format!("{},{},{},{}", timing.median, timing.spread, timing.least, timing.runs),
            format!("{},{},{}", errors.worst_levels, errors.thousandth_levels, errors.rms_levels),
            [errors.wrong_visible_ppm, errors.wrong_coverage_ppm, errors.silhouette_px].map(known).join(","),
            format!("{},{},{}", errors.flip_mean, errors.flip_worst, errors.dissimilarity),
            format!("{}", standing == Standing::Front),
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
        let Row { configuration: of, timing, errors } = row;
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
            "times_ms": timing,
            "errors": errors,
            "standing": Value::Object(standing.collect()),
        })
    };
    json!({ "schema": 1, "run": run, "rows": rows.iter().enumerate().map(row).collect::<Vec<_>>() })
}
