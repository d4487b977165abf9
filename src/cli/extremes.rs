//! `farop grade LAB --extremes`: at which size, offset or depth a rasterizer begins to be wrong.

use super::error::{self, CliError, notice};
use super::scenes::{Chosen, find_rasterizer};
use crate::grade::extremes::{Finding, json, kinds, probe, text};
use crate::grade::{InProcess, Lab, Outside, Subject};
use crate::image::save;
use crate::raster::Registry;
use crate::screen::file::{Attributes, Sheet, write_v2};
use std::path::Path;

/// Pushes the rasterizer of that name through all kinds of `lab`; the first list that breaks goes to `witness`.
pub(super) fn run(
    lab: &Lab,
    (name, registry): (&str, &Registry),
    witness: Option<&Path>,
    as_json: bool,
) -> Result<(), CliError> {
    if super::grade::is_about_function(lab) {
        return Err(CliError::failed(format!(
            "the lab `{}` is about a function: --extremes is for rasterizers",
            lab.name
        )));
    }
    let findings = match find_rasterizer(registry, name)? {
        Some(Chosen::Registered(entry)) => probe_all(lab, &InProcess(&*entry.rasterizer))?,
        Some(Chosen::Outside(external)) => probe_all(lab, &Outside::new(external))?,
        None => return Err(CliError::failed("`none` draws nothing: there is nothing to grade")),
    };
    let report =
        if as_json { format!("{:#}\n", json(lab.name, name, &findings)) } else { text(lab.name, name, &findings) };
    error::print(&report)?;
    let first = findings.iter().find_map(|finding| finding.first.as_ref());
    if let Some(path) = witness {
        match first {
            Some(first) => {
                let mut text = Vec::new();
                write_v2(&first.step.list, &Sheet::default(), Attributes::default(), &mut text)
                    .map_err(CliError::failed)?;
                save::write_whole(path, &text)?;
            }
            None => notice(&format!("nothing breaks, so {} is not written", path.display())),
        }
    }
    let broken: Vec<_> =
        findings.iter().filter(|finding| finding.first.is_some()).map(|finding| finding.kind).collect();
    if broken.is_empty() { Ok(()) } else { Err(CliError::Wanting(format!("found wanting: {}", broken.join(", ")))) }
}

fn probe_all(lab: &Lab, subject: &dyn Subject) -> Result<Vec<Finding>, CliError> {
    let kinds = kinds(lab, subject.accepts());
    if kinds.is_empty() {
        return Err(CliError::failed(format!(
            "lab `{}` fills no polygons; --extremes is for coverage, zbuffer, gouraud, watkins, phong and supersampling",
            lab.name
        )));
    }
    Ok(kinds.iter().map(|kind| probe(subject, kind)).collect())
}
