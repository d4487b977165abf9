//! The map of `farop forest`: read, and laid on the ground of all frames.

use super::options::{DrapeName, Forest};
use crate::cli::error::{self, CliError};
use crate::forest::area::Head;
use crate::forest::drape::Method;
use crate::forest::frame::{Laying, MapFigures};
use crate::forest::map::{Shape, shapes};
use crate::parse::load_map;

/// The shapes of a view of a map, and what the view is called.
pub(super) type Shown = (String, Vec<Shape>);

/// The map that options name, in metres of the area.
pub(super) fn of(options: &Forest, head: &Head) -> Result<Option<Shown>, CliError> {
    let Some(path) = &options.map else { return Ok(None) };
    let loaded = load_map(path);
    let (map, notices) = loaded.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))?;
    notices.iter().for_each(|notices| error::diagnose(&notices.render(error::stderr_has_color())));
    let Some(view) = map.view(options.map_view.as_deref()) else {
        let known: Vec<&str> = map.views.iter().map(|view| view.name.as_str()).collect();
        let asked = options.map_view.as_deref().unwrap_or_default();
        return Err(CliError::failed(format!("{} has no view `{asked}`: it has {}", path.display(), known.join(", "))));
    };
    let shapes = shapes(&map, view, (&head.crs, head.origin)).map_err(CliError::failed)?;
    Ok(Some((view.name.clone(), shapes)))
}

/// How options lay a map on the ground.
pub(super) fn laying(options: &Forest) -> Laying {
    let method = match options.drape {
        DrapeName::Lispsm => Method::Searched,
        DrapeName::Uniform => Method::Uniform,
        DrapeName::Thesis => Method::Thesis,
        DrapeName::Program => Method::Program,
        DrapeName::Exact => return Laying::Exact,
    };
    Laying::Drawn(method, options.map_texture)
}

/// How sharp a map was, in words.
pub(super) fn told(MapFigures { texels, strength }: &MapFigures) -> String {
    let strength =
        strength.map_or("without perspective".to_string(), |n| format!("its center {n:.0} m behind what is seen"));
    format!(
        "the map has {:.3} texels a pixel at the first percentile, {:.3} in the middle; {strength}",
        texels.first_percentile, texels.median
    )
}
