//! `--stats`: counts and times; as text, line by line FAROP's diagnostics (appendix A.3 of the paper).

use super::lighting::{light_words, surface_words};
use super::scenes::Loaded;
use crate::plan::Plan;
use crate::raster::PutCounts;
use crate::raster::external::Confinement;
use crate::render::Rendered;
use crate::report::{StageTime, peak_bytes};
use crate::scene::{Scene, Shape};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// How statistics are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StatsFormat {
    /// FAROP's lines.
    Text,
    /// One JSON object.
    Json,
}

impl std::str::FromStr for StatsFormat {
    type Err = String;
    fn from_str(name: &str) -> Result<StatsFormat, String> {
        match name {
            "text" => Ok(StatsFormat::Text),
            "json" => Ok(StatsFormat::Json),
            _ => Err("there is text, json".to_string()),
        }
    }
}

/// The statistics of a picture drawn by `rasterizer` into `output`.
pub(super) fn text(format: StatsFormat, loaded: &Loaded, rendered: &Rendered, run: (&str, Option<&Path>)) -> String {
    match format {
        StatsFormat::Json => format!("{}\n", json(rendered)),
        StatsFormat::Text => lines(loaded, rendered, run),
    }
}

fn json(rendered: &Rendered) -> serde_json::Value {
    let (counts, puts) = (&rendered.counts, &rendered.puts);
    serde_json::json!({
        "schema": 1,
        "objects": counts.objects,
        "surfaces": counts.surfaces,
        "polygons": counts.polygons,
        "vertices": counts.vertices,
        "backfacing": counts.backfacing,
        "clipped": counts.clipped,
        "cut": counts.cut,
        "inside": counts.inside,
        "rendered": counts.rendered,
        "triangles": counts.triangles,
        "split": counts.split,
        "skipped": counts.skipped,
        "nonplanar": counts.nonplanar,
        "self_crossing": counts.self_crossing,
        "puts": puts.puts,
        "overdraw": puts.overdraw,
        "stray_writes": puts.stray_writes,
        "rasterizer": puts.own.iter().chain(&puts.most).collect::<BTreeMap<_, _>>(),
        "spans_without_pixel_work": span_share(puts),
        "enforced": puts.confinement.as_ref().map(Confinement::json),
        "tessellated": counts.tessellated,
        "work": counts.work,
        "times_ms": rendered.times,
        "peak_bytes": peak_bytes(),
    })
}

/// FAROP's lines, in FAROP's order.
fn lines(loaded: &Loaded, rendered: &Rendered, (rasterizer, output): (&str, Option<&Path>)) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = import_lines(loaded, &rendered.plan, &mut text);
    let _ = geometry_lines(rendered, output, &mut text);
    let _ = raster_lines(rendered, rasterizer, &mut text);
    text
}

fn import_lines(loaded: &Loaded, plan: &Plan, text: &mut String) -> std::fmt::Result {
    let scene = &loaded.scene;
    writeln!(text, "NFF scene will be imported!")?;
    writeln!(text, "Pipeline: Parsing NFF file, wait...")?;
    for notice in &loaded.notices {
        writeln!(text, "Pipeline: Be aware: {notice}")?;
    }
    if scene.background.is_some() {
        writeln!(text, "Pipeline: NFF background loaded")?;
    }
    writeln!(text, "Pipeline: NFF view parameters loaded")?;
    for light in &scene.lights {
        let (position, color) = (light.source.position(), light.color);
        let position = format!("({:.2} {:.2} {:.2})", position.x, position.y, position.z);
        let color = format!("({:.2} {:.2} {:.2})", color.r, color.g, color.b);
        writeln!(text, "Pipeline: NFF light loaded {position} {color}{}", light_words(light))?;
    }
    for surface in &scene.surfaces {
        let material = &surface.material;
        let (ambient, color) = (material.ambient.unwrap_or(plan.ambient * material.diffuse), material.color);
        writeln!(
            text,
            "Pipeline: NFF surface with {} polygons ({ambient:.2},{:.2},{:.2},{},{:.2},{:.2},{:.2}){}",
            surface.mesh.polygons.len(),
            material.specular,
            material.diffuse,
            material.shine,
            color.r,
            color.g,
            color.b,
            surface_words(surface)
        )?;
    }
    let [spheres, cones, others] = shapes(scene);
    let (surfaces, polygons) = (scene.surfaces.len(), plan.survey.polygons);
    let others = if others > 0 { format!(", {others} other shapes") } else { String::new() };
    writeln!(
        text,
        "Pipeline: Imported {surfaces} surfaces with {polygons} polygons, {spheres} spheres and {cones} cones{others}."
    )?;
    writeln!(text, "Pipeline: NFF parser done")?;
    write_timer(text, loaded.parse_time)
}

/// How many spheres, cones and other shapes there are.
fn shapes(scene: &Scene) -> [usize; 3] {
    let mut numbers = [0; 3];
    for primitive in scene.surfaces.iter().flat_map(|surface| &surface.primitives) {
        let kind = match primitive.shape {
            Shape::Sphere { .. } => 0,
            Shape::Cone { .. } | Shape::CappedCone { .. } => 1,
            _ => 2,
        };
        numbers[kind] += 1;
    }
    numbers
}

fn geometry_lines(rendered: &Rendered, output: Option<&Path>, text: &mut String) -> std::fmt::Result {
    let (plan, counts, times) = (&rendered.plan, &rendered.counts, &rendered.times);
    let (width, height) = plan.view.pixels;
    let resolution = format!("{width},{height},{},256", plan.choices.depth.name());
    let (hither, yon) = (plan.view.hither * plan.view.unit, plan.view.yon * plan.view.unit);
    writeln!(text, "Pipeline: Hither:{hither:.2}, Yon:{yon:.2}, Resolution(X,Y,Z,Color):{resolution}")?;
    writeln!(text, "Pipeline: Pipeline creating render data, wait...")?;
    writeln!(text, "Timer started")?;
    if let Some(output) = output {
        writeln!(text, "Pipeline: Image file to be created: '{}'", output.display())?;
    }
    writeln!(text, "Pipeline: Objects loaded: {}", counts.objects)?;
    writeln!(text, "Pipeline: Surfaces loaded: {}", counts.surfaces)?;
    writeln!(text, "Pipeline: Polygons loaded: {}", counts.polygons)?;
    if counts.tessellated.polygons > 0 {
        writeln!(text, "Pipeline: Polygons of shapes: {}", counts.tessellated.polygons)?;
    }
    if counts.nonplanar > 0 {
        writeln!(text, "Pipeline: Polygons not planar, cut in two: {}", counts.nonplanar)?;
    }
    writeln!(text, "Pipeline: Polygons ready to be rendered!")?;
    let mut geometry = times.plan;
    geometry += times.geometry;
    write_timer(text, geometry)
}

fn raster_lines(rendered: &Rendered, rasterizer: &str, text: &mut String) -> std::fmt::Result {
    let (counts, puts, times) = (&rendered.counts, &rendered.puts, &rendered.times);
    writeln!(text, "Pipeline: {rasterizer} rendering, wait...")?;
    writeln!(text, "Timer started")?;
    let shading = rendered.plan.choices.shading.name();
    writeln!(text, "Pipeline: Render Mode: {}{}", shading[..1].to_uppercase(), &shading[1..])?;
    writeln!(text, "Pipeline: {rasterizer} rasterization done!")?;
    write_timer(text, times.raster)?;
    writeln!(text, "Pipeline: Successful End")?;
    writeln!(text, "Pipeline: Polygons backfacing: {}", counts.backfacing)?;
    writeln!(text, "Pipeline: Polygons totally clipped: {}", counts.clipped)?;
    writeln!(text, "Pipeline: Polygons split to triangles: {}", counts.split)?;
    writeln!(text, "Pipeline: Polygons rendered: {}", counts.rendered)?;
    if counts.self_crossing > 0 {
        writeln!(text, "Pipeline: Polygons that cross themselves (drawn even-odd): {}", counts.self_crossing)?;
    }
    let tessellated = counts.tessellated;
    if tessellated.polygons > 0 {
        let (backfacing, clipped, rendered) = (tessellated.backfacing, tessellated.clipped, tessellated.rendered);
        writeln!(text, "Pipeline: Of shapes: backfacing {backfacing}, clipped {clipped}, rendered {rendered}")?;
    }
    writeln!(
        text,
        "Pipeline: Fragments put: {}, overdrawn: {}, outside: {}",
        puts.puts, puts.overdraw, puts.stray_writes
    )?;
    for (name, count) in puts.own.iter().chain(&puts.most) {
        writeln!(text, "Pipeline: {rasterizer}: {name}: {count}")?;
    }
    if let Some(confinement) = &puts.confinement {
        writeln!(text, "Pipeline: {rasterizer}: {}", confinement.enforced)?;
    }
    if let Some(share) = span_share(puts) {
        let percent = share * 100.0;
        writeln!(text, "Pipeline: {rasterizer}: share of spans decided without per-pixel work: {percent:.2} %")?;
    }
    writeln!(text, "Pipeline: Picture written")?;
    write_timer(text, times.write)?;
    writeln!(text, "Pipeline: Peak memory: {:.1} MB", peak_bytes() as f64 / 1e6)?;
    // Nothing is left to release, but the log ends as it always did.
    writeln!(text, "Pipeline: Releasing resources...!")?;
    writeln!(text, "Pipeline: Release complete!")
}

/// The share of spans that were decided as a whole, for rasterizers that count spans.
fn span_share(puts: &PutCounts) -> Option<f64> {
    let count = |name: &str| puts.own.get(name).copied();
    let pixel_work = count("spans halved")? + count("spans of one sample, compared")?;
    let spans = count("spans").filter(|&spans| spans > 0)?;
    Some(1.0 - pixel_work as f64 / spans as f64)
}

fn write_timer(text: &mut String, time: StageTime) -> std::fmt::Result {
    let [elapsed, user, system] = [time.elapsed, time.user, time.system].map(|milliseconds| milliseconds / 1e3);
    writeln!(text, "Timer Stopped (Elapsed: {elapsed:.3}s, User: {user:.3}s, System: {system:.3}s)")
}
