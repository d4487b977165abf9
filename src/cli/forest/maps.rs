//! The map of `farop forest`: read, and laid on the ground of all frames.

use super::options::{DrapeName, Forest};
use crate::cli::error::{self, CliError};
use crate::forest::area::Head;
use crate::forest::drape::Method;
use crate::forest::frame::{Laying, MapFigures};
use crate::forest::map::{Map, Shape, shapes};
use crate::parse::load_map;
use std::path::Path;

/// The shapes of a view of a map, and what the view is called.
pub(super) type Shown = (String, Vec<Shape>);

/// The map that options name, in metres of the area.
pub(super) fn of(options: &Forest, head: &Head) -> Result<Option<Shown>, CliError> {
    let Some(path) = &options.map else { return Ok(None) };
    let (map, view) = read(path, options.map_view.as_deref())?;
    let view = &map.views[view];
    let shapes = shapes(&map, view, (&head.crs, head.origin)).map_err(CliError::failed)?;
    Ok(Some((view.name.clone(), shapes)))
}

/// A map, and the number of the view that is asked for.
pub(in crate::cli) fn read(path: &Path, asked: Option<&str>) -> Result<(Map, usize), CliError> {
    let loaded = load_map(path);
    let (map, notices) = loaded.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
    notices.iter().for_each(|notices| error::diagnose(&notices.render(error::stderr_has_color())));
    let found = map.views.iter().position(|view| asked.is_none_or(|name| view.name == name));
    let Some(view) = found else {
        let known: Vec<&str> = map.views.iter().map(|view| view.name.as_str()).collect();
        let asked = asked.unwrap_or_default();
        return Err(CliError::failed(format!("{} has no view `{asked}`: it has {}", path.display(), known.join(", "))));
    };
    Ok((map, view))
}

/// How options lay a map on the ground.
pub(super) fn laying(options: &Forest) -> Laying {
    by(options.drape, options.map_texture)
}

/// A way of laying, with so many texels each way.
pub(in crate::cli) fn by(drape: DrapeName, side: u32) -> Laying {
    let method = match drape {
        DrapeName::Lispsm => Method::Searched,
        DrapeName::Uniform => Method::Uniform,
        DrapeName::Thesis => Method::Thesis,
        DrapeName::Program => Method::Program,
        DrapeName::Exact => return Laying::Exact,
    };
    Laying::Drawn(method, side)
}

/// How sharp a map was, in words.
pub(in crate::cli) fn told(MapFigures { texels, strength }: &MapFigures) -> String {
    let strength =
        strength.map_or("without perspective".to_string(), |n| format!("its center {n:.0} m behind what is seen"));
    format!(
        "the map has {:.3} texels a pixel at the first percentile, {:.3} in the middle; {strength}",
        texels.first_percentile, texels.median
    )
}
