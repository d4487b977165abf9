//! Maps on reliefs: `farop terrain GRID --map V.fmap -o view.png`.
//!
//! `.fmap`, Grid -shapes in metres of the relief-> the relief's surfaces again, wearing the map
//!
//! A grid in degrees lies in metres of its own, a degree as long as in its middle (`Grid::spacing`): positions are brought to degrees and go the same way, so
//! that a road lies on the samples it was measured with. A grid in metres does not say in which projection it is; `--grid-crs` does.
//!
//! Space: metres from the south-west corner.

use crate::cli::error::CliError;
use crate::cli::forest::{DrapeName, maps};
use crate::forest::elevation::{Grid, Unit};
use crate::forest::frame::GroundMap;
use crate::forest::map::{first_placed, shapes_by};
use crate::forest::vector::Crs;
use crate::scene::{Camera, Scene};
use clap::Args;
use std::path::PathBuf;

/// Which map, and how it lies.
#[derive(Args, Clone)]
#[command(next_help_heading = "Map on the relief")]
pub(super) struct OnMap {
    /// A map on the relief, .fmap
    #[arg(long, value_name = "FILE", requires = "output", conflicts_with = "progressive")]
    pub map: Option<PathBuf>,
    /// The view of the map that is shown [default: its first]
    #[arg(long, value_name = "NAME", requires = "map")]
    map_view: Option<String>,
    /// lispsm (sharp near and far), uniform, exact (asked at every sample), or the papers' thesis and program
    #[arg(long, value_name = "HOW", default_value = "lispsm", requires = "map")]
    drape: DrapeName,
    /// Texels of the map's texture, each way
    #[arg(long, value_name = "N", default_value_t = 1024, requires = "map", value_parser = clap::value_parser!(u32).range(1..=8192))]
    map_texture: u32,
    /// Projection of a grid in metres: EPSG:326zz or EPSG:327zz, a zone of UTM
    #[arg(long, value_name = "CRS", requires = "map", value_parser = zone)]
    grid_crs: Option<Crs>,
}

impl OnMap {
    /// Lays the map on the relief of `grid`; what there is to tell of it.
    pub fn wear(&self, grid: &Grid, scene: &mut Scene, camera: &Camera) -> Result<Option<String>, CliError> {
        let Some(path) = &self.map else { return Ok(None) };
        let (map, view) = maps::read(path, self.map_view.as_deref())?;
        let view = &map.views[view];
        let crs = match (grid.frame.unit, self.grid_crs) {
            (Unit::Degrees, None) => Some(Crs::Degrees),
            (Unit::Degrees, Some(_)) => {
                return Err(CliError::failed(format!("`{}` is in degrees: leave out --grid-crs", grid.name)));
            }
            (Unit::Metres, crs) => crs,
        };
        if let (None, Some((layer, of))) = (crs, first_placed(&map, view)) {
            return Err(CliError::failed(format!(
                "layer `{layer}` is in EPSG:{}, and `{}` is in metres of an unknown projection: say it, as in --grid-crs EPSG:32631",
                of.code(),
                grid.name
            )));
        }
        let [west, south, ..] = grid.borders();
        let ([x, y], step) = (grid.spacing(), grid.frame.step);
        let shapes = shapes_by(&map, view, &|of, point| {
            let [east, north] = crs.map_or(point, |crs| of.to(crs, point));
            [(east - west) / step[0] * x, (north - south) / step[1] * y]
        });
        let reach = [[0.0; 2], grid.extent()];
        let mut ground = GroundMap::within(reach, &view.name, shapes, maps::by(self.drape, self.map_texture))
            .map_err(CliError::failed)?;
        ground.wear(scene, camera);
        Ok(ground.figures.as_ref().map(maps::told))
    }
}

/// A zone of UTM by its EPSG number.
fn zone(text: &str) -> Result<Crs, String> {
    match Crs::named(text) {
        Some(crs @ Crs::Utm { .. }) => Ok(crs),
        _ => Err("expected a zone of UTM, EPSG:32601 to 32660 or 32701 to 32760".to_string()),
    }
}
