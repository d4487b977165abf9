//! Survey: where the stands lie, on which map, in which cells; and what is wrong where that cannot be.
//!
//! layer, relief -SURVEY-> the world of the area, or what to do
//!
//! Space: the layer's projection, then the area's map. Cost: linear in corners.

use super::owners::place_of;
use super::{Choices, MOST_CELLS, Relief, World};
use crate::diagnostic::Diagnostic;
use crate::forest::elevation::zone_of;
use crate::forest::polygon::Point;
use crate::forest::vector::{Crs, Feature, Geometry, Layer};

fn corners(layer: &Layer) -> impl Iterator<Item = (usize, &Feature, Point)> {
    layer.features.iter().enumerate().flat_map(|(index, feature)| {
        let parts = if let Geometry::Polygons(parts) = &feature.geometry { parts.as_slice() } else { &[] };
        parts.iter().flat_map(|part| &part.outer).map(move |&corner| (index, feature, corner))
    })
}

/// The rectangle around all polygons: least and most.
pub(super) fn bounds(layer: &Layer) -> Option<[Point; 2]> {
    corners(layer).map(|(.., corner)| [corner, corner]).reduce(|[low, high], [corner, _]| {
        [[0, 1].map(|axis| low[axis].min(corner[axis])), [0, 1].map(|axis| high[axis].max(corner[axis]))]
    })
}

/// Degrees are longitude and latitude, in this order.
pub(super) fn check_degrees(layer: &Layer, crs: Crs) -> Result<(), Diagnostic> {
    let is_wrong = |corner: &Point| crs == Crs::Degrees && (corner[0].abs() > 180.0 || corner[1].abs() > 84.0);
    let Some((index, feature, corner)) = corners(layer).find(|(.., corner)| is_wrong(corner)) else { return Ok(()) };
    let place = place_of(layer, feature, index);
    let error = Diagnostic::error(format!("{place}: longitude {} latitude {} lie on no UTM map", corner[0], corner[1]));
    Err(error.help(match corner[0].abs() <= 84.0 && corner[1].abs() <= 180.0 {
        true => "are the axes swapped? Longitude comes first; `--swap-axes` reads them the other way round",
        false => "are these metres? Say the projection with `--stands-crs EPSG:326zz`",
    }))
}

/// The UTM map of the middle of what lies there.
pub(super) fn map_of(crs: Crs, [low, high]: [Point; 2]) -> Crs {
    match crs {
        Crs::Utm { .. } => crs,
        Crs::Degrees => Crs::Utm { zone: zone_of((low[0] + high[0]) / 2.0), south: low[1] + high[1] < 0.0 },
    }
}

/// The rectangle of cells around all polygons and the margin.
pub(super) fn world(layer: &Layer, [crs, map]: [Crs; 2], choices: &Choices) -> Result<(World, [i32; 2]), Diagnostic> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for (.., corner) in corners(layer) {
        let at = crs.to(map, corner);
        low = [0, 1].map(|axis| low[axis].min(at[axis]));
        high = [0, 1].map(|axis| high[axis].max(at[axis]));
    }
    let (side, margin) = (choices.side, f64::from(choices.margin));
    let first = low.map(|number| (number / side).floor() - margin);
    let last = high.map(|number| (number / side).ceil() + margin);
    let size = [0, 1].map(|axis| (last[axis] - first[axis]).max(1.0));
    if size[0] * size[1] <= MOST_CELLS as f64 {
        let origin = first.map(|number| number * side);
        return Ok((World { crs: map, origin, side }, size.map(|number| number as i32)));
    }
    let error = Diagnostic::error(format!(
        "the stands of `{}` lie in {:.0} x {:.0} cells of {side} m, more than {MOST_CELLS}",
        layer.name, size[0], size[1]
    ));
    Err(error.help(
        "is one polygon far from the others, or the projection another? Or import parts, or larger cells (`--side`)",
    ))
}

/// No polygon lies where there are heights.
pub(super) fn nowhere(relief: &Relief, layer: &Layer, crs: Crs, [low, high]: [Point; 2]) -> Diagnostic {
    let bordered = |numbers: [f64; 4]| numbers.map(|number| format!("{number:.4}")).join(" ");
    let message = format!(
        "the stands of `{}` ({}: from {}) lie outside of the relief `{}` ({}: from {}), west south east north",
        layer.name,
        epsg(crs),
        bordered([low[0], low[1], high[0], high[1]]),
        relief.grid.name,
        epsg(relief.crs),
        bordered(relief.grid.borders())
    );
    let is_there = |place: Point| relief.height(crs, place).is_some();
    let swapped = corners(layer).any(|(.., corner)| is_there([corner[1], corner[0]]));
    Diagnostic::error(message).help(match swapped {
        true => "the axes are swapped: read them the other way round with `--swap-axes`",
        false => "take the tile of heights that is there, or say the projection with `--stands-crs`",
    })
}

fn epsg(crs: Crs) -> String {
    format!("EPSG:{}", crs.code())
}
