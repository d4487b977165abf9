//! `farop suite LAB`: the probes of a lab as screen files, with expected pictures, a manifest, readers and a sheet to print.
//!
//! lab, seed -SUITE-> NN-aspect-case.scr, expected/NN-aspect-case.png, manifest.json, sheet.html, reader.*
//!
//! Hidden probes go to a folder of their own, which is not handed out: a folder with both would be, one day.

use super::dump::DumpFormat;
use super::error::{self, CliError};
use super::suite::{hash, make_folder};
use crate::color::Encoding;
use crate::grade::case::Case;
use crate::grade::folder::files;
use crate::grade::hidden::Probes;
use crate::grade::{Lab, html, pictures};
use crate::image::{Picture, encode_for, save};
use crate::plan::Accepts;
use crate::raster::ZBuffer;
use crate::render::{self, Canvas};
use crate::screen::file::{READERS, ReadOptions, read};
use serde_json::{Value, json};
use std::path::Path;

/// Writes the probes of `lab`, visible or hidden as it says, into `folder`.
pub(super) fn write(
    lab: &Lab,
    folder: &Path,
    format: &DumpFormat,
    (seed, triangles): (u64, bool),
) -> Result<(), CliError> {
    let files = files(lab, seed);
    if format.is_classic()
        && let Some((_, case)) = files.iter().find(|(_, case)| case.lines || case.lamp.is_some() || case.samples > 1)
    {
        let words = "a classic file has no lines, no lights and one sample a pixel; leave --classic out";
        return Err(CliError::failed(format!("lab {}, \"{}\": {words}", lab.name, case.name)));
    }
    let expected = folder.join("expected");
    make_folder(folder)?;
    make_folder(&expected)?;
    let accepts = if triangles { Accepts::Triangles } else { Accepts::AnyPolygon };
    let mut entries = Vec::new();
    let aspects = lab.aspects.iter().flat_map(|aspect| lab.cases(aspect, seed).into_iter().map(|_| aspect.name));
    for ((name, case), aspect) in files.iter().zip(aspects) {
        let mut text = Vec::new();
        format.write_to(&mut text, &case.list(accepts), &case.sheet()).map_err(CliError::failed)?;
        let right = if format.is_classic() { of_classic(&text)? } else { pictures::right(case) };
        save::write_whole(&folder.join(format!("{name}.scr")), &text)?;
        let path = expected.join(format!("{name}.png"));
        save::write_whole(&path, &encode_for(&path, &right).map_err(CliError::failed)?)?;
        entries.push(entry(name, (aspect, case), &text, &right));
    }
    for (name, text) in READERS {
        save::write_whole(&folder.join(name), text.as_bytes())?;
    }
    save::write_whole(&folder.join("sheet.html"), html::sheet(lab, &files, seed).as_bytes())?;
    let manifest = manifest(lab, format.is_classic(), (seed, triangles), entries);
    save::write_whole(&folder.join("manifest.json"), format!("{manifest:#}\n").as_bytes())?;
    error::print(&told(lab, folder, (files.len(), seed), format.is_classic()))
}

/// What a classic file shows is what is left of the case after rounding: it is read back and drawn.
fn of_classic(text: &[u8]) -> Result<Picture, CliError> {
    let options = ReadOptions { encoding: Encoding::Linear, ..ReadOptions::default() };
    let file = read(&String::from_utf8_lossy(text), &options).map_err(CliError::failed)?;
    let canvas = Canvas { threads: 1, ..Canvas::of_sheet(&file.sheet) };
    Ok(render::draw(&file.list, Some(&ZBuffer), &canvas).0.encode(Encoding::Linear))
}

fn entry(name: &str, (aspect, case): (&str, &Case), text: &[u8], right: &Picture) -> Value {
    json!({
        "file": format!("{name}.scr"),
        "expected": format!("expected/{name}.png"),
        "aspect": aspect,
        "case": case.name,
        "polygons": case.faces.len(),
        "samples": case.samples,
        "width": right.width(),
        "height": right.height(),
        "sha256": hash(text),
        "picture_sha256": hash(right.rgb()),
    })
}

fn manifest(lab: &Lab, is_classic: bool, (seed, triangles): (u64, bool), files: Vec<Value>) -> Value {
    let rules: serde_json::Map<String, Value> =
        html::RULES.iter().map(|(about, rule)| (about.to_lowercase(), Value::from(*rule))).collect();
    json!({
        "schema": 1,
        "lab": lab.name,
        "probes": if lab.probes == Probes::Hidden { "hidden" } else { "visible" },
        "seed": seed,
        "format": if is_classic { "classic" } else { "v2" },
        "triangles": triangles,
        "rules": rules,
        "any_consistent_ties": !lab.fixes_ties,
        "note": "picture_sha256 is of the decoded pixels: red, green, blue, rows from the top. Where a level lies between two the lower is shown.",
        "files": files,
    })
}

fn told(lab: &Lab, folder: &Path, (count, seed): (usize, u64), is_classic: bool) -> String {
    let (name, place) = (lab.name, folder.display());
    if is_classic {
        return format!(
            "{count} screen files in {place}; compare with the pictures in expected: rounded coordinates are not graded\n"
        );
    }
    if lab.probes == Probes::Hidden {
        return format!(
            "{count} hidden screen files in {place}: keep this folder and the seed to yourself; then `farop grade {name} --pictures DIR --hidden {seed}`\n"
        );
    }
    format!(
        "{count} screen files in {place}; draw each as NAME.ppm, then `farop grade {name} --pictures DIR --seed {seed}`\n"
    )
}
