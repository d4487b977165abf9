//! `farop forest import`: other people's stands, inventory and relief as an area.
//!
//! grids, polygons, table -parse-> Sources -forest::import-> Area -> `.fpack`, `.fcell`

use super::stock::{check_ending, is_pack, told, written};
use crate::cli::error::{self, CliError, notice};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::forest::cells::Cells;
use crate::forest::elevation::{Unit, fill_voids, merge};
use crate::forest::import::{Choices, Record, Relief, Sources, What, import};
use crate::forest::pack;
use crate::forest::vector::{Crs, Layer};
use crate::image::save::WholeFile;
use crate::parse::{GridOptions, check_field, load_grid, load_inventory, load_vectors};
use crate::write::write_fcell;
use clap::Args;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Polygons of stands, an inventory and a relief as an area
#[derive(Args)]
#[command(
    after_help = "Example:\n  farop forest import --relief N42E001.hgt.gz --stands stands.geojson --inventory stands.csv --lines roads.geojson -o area.fpack\n  farop forest import --relief N42E001.hgt.gz --stands landcover.geojson --defaults -o area.fpack"
)]
pub(in crate::cli) struct Import {
    /// Grid of heights; several that are neighbors merge
    #[arg(long, value_name = "GRID", required = true, num_args = 1..)]
    relief: Vec<PathBuf>,
    /// Projection of a relief that counts metres, EPSG:326zz or EPSG:327zz
    #[arg(long, value_name = "EPSG:N", value_parser = crs)]
    relief_crs: Option<Crs>,
    /// Polygons of stands or of land use, .geojson, .shp, .zip
    #[arg(long, value_name = "FILE")]
    stands: PathBuf,
    /// Table of what grows on them, .csv: stand, species, height, density, ...
    #[arg(long, value_name = "TABLE", required_unless_present = "defaults")]
    inventory: Option<PathBuf>,
    /// What columns and attributes are called: FIELD=NAME
    #[arg(long, value_name = "FIELD=NAME", value_parser = pair)]
    map: Vec<(String, String)>,
    /// Polygons without a row get what is usual for their land use, in OpenStreetMap's words
    #[arg(long)]
    defaults: bool,
    /// Roads and rivers, .geojson, .shp, .zip
    #[arg(long, value_name = "FILE")]
    lines: Option<PathBuf>,
    /// Only what the stands are in this year
    #[arg(long, value_name = "YEAR", allow_hyphen_values = true)]
    year: Option<i32>,
    /// A stand is felled in a year
    #[arg(long, value_name = "STAND:YEAR", value_parser = done)]
    cut: Vec<(String, i32, Option<String>)>,
    /// A stand burns in a year
    #[arg(long, value_name = "STAND:YEAR", value_parser = done)]
    burn: Vec<(String, i32, Option<String>)>,
    /// A stand is planted anew in a year
    #[arg(long, value_name = "STAND:YEAR:SPECIES", value_parser = done)]
    replant: Vec<(String, i32, Option<String>)>,
    /// Map of the area [default: the zone of UTM of its middle]
    #[arg(long, value_name = "EPSG:N", value_parser = crs)]
    crs: Option<Crs>,
    /// Ground where no polygon is
    #[arg(long, value_name = "NAME", default_value = "grass")]
    ground: String,
    /// Every random number of the area begins here
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
    /// Area to write, .fpack or .fcell
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

fn crs(text: &str) -> Result<Crs, String> {
    Crs::named(text).ok_or_else(|| "known are EPSG:4326, EPSG:326zz and EPSG:327zz (zones of UTM)".to_string())
}

fn pair(text: &str) -> Result<(String, String), String> {
    let (field, name) = text.split_once('=').ok_or("expected FIELD=NAME, as in `height=mean_h`")?;
    check_field(field)?;
    Ok((field.to_string(), name.to_string()))
}

fn done(text: &str) -> Result<(String, i32, Option<String>), String> {
    let mut words = text.split(':');
    let (stand, year) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
    let year = year.parse().map_err(|_| format!("`{year}` is no year; expected STAND:YEAR, as in `12:2026`"))?;
    Ok((stand.to_string(), year, words.next().map(str::to_string)))
}

fn diagnosed(errors: &Diagnostics) -> CliError {
    CliError::Diagnosed(errors.render(error::stderr_has_color()))
}

impl Import {
    pub fn run(&self) -> Result<(), CliError> {
        check_ending(&self.output, if is_pack(&self.output) { "fpack" } else { "fcell" })?;
        let map: BTreeMap<String, String> = self.map.iter().cloned().collect();
        let table = match &self.inventory {
            None => Vec::new(),
            Some(path) => {
                let read = load_inventory(path, &map).map_err(|errors| diagnosed(&errors))?;
                tell(&read.notices);
                read.records
            }
        };
        let plan = self.plan()?;
        let stands = layer(&self.stands)?;
        let lines = self.lines.as_deref().map(layer).transpose()?;
        let relief = self.relief()?;
        let sources = Sources { relief: &relief, stands: &stands, lines: lines.as_ref(), table: &table, plan: &plan };
        let Import { crs, year, seed, ref ground, defaults: has_defaults, .. } = *self;
        let choices = Choices { crs, year, seed, ground: ground.clone(), has_defaults, map, ..Choices::default() };
        let imported = import(&sources, &choices).map_err(|errors| diagnosed(&without_source(errors)))?;
        tell(&without_source(imported.notices));
        // The area itself may be what standard output is for.
        error::tell(&imported.summary.to_string());
        let area = imported.area;
        if is_pack(&self.output) {
            let counts = pack::write(&area.head, area.cells.into_values(), &self.output).map_err(CliError::failed)?;
            return told(&self.output, &counts);
        }
        let cells = Cells::Loaded(area);
        if self.output.as_os_str() == "-" {
            return write_fcell(&cells, &mut std::io::stdout().lock()).map_err(|error| written(&self.output, error));
        }
        let mut file = WholeFile::create(&self.output)?;
        write_fcell(&cells, &mut file).map_err(|error| written(&self.output, error))?;
        Ok(file.commit()?)
    }

    /// What is done to stands, as records that go before the inventory's.
    fn plan(&self) -> Result<Vec<Record>, CliError> {
        let mut plan = Vec::new();
        for (option, list) in [("--cut", &self.cut), ("--burn", &self.burn), ("--replant", &self.replant)] {
            for (stand, year, species) in list {
                let what = match (option, species) {
                    ("--cut", None) => What::Cut,
                    ("--burn", None) => What::Burnt,
                    ("--replant", Some(species)) => What::Replanted { species: species.clone(), form: None },
                    ("--replant", None) => {
                        return Err(CliError::failed(format!(
                            "--replant {stand}:{year}: which species? STAND:YEAR:SPECIES"
                        )));
                    }
                    _ => {
                        return Err(CliError::failed(format!(
                            "{option} {stand}:{year}: a species belongs to --replant"
                        )));
                    }
                };
                plan.push(Record {
                    stand: stand.clone(),
                    year: Some(*year),
                    what,
                    origin: format!("{option} {stand}:{year}"),
                });
            }
        }
        Ok(plan)
    }

    fn relief(&self) -> Result<Relief, CliError> {
        let grids = self.relief.iter().map(|path| load_grid(path, &GridOptions::default()));
        let grids = grids.collect::<Result<Vec<_>, _>>().map_err(|errors| diagnosed(&errors))?;
        let mut grid = merge(grids).map_err(CliError::failed)?.grid;
        let filled = fill_voids(&mut grid, 10_000);
        if filled.samples > 0 {
            notice(&format!("{} samples of the relief that nobody measured are filled", filled.samples));
        }
        let crs = match (grid.frame.unit, self.relief_crs) {
            (Unit::Degrees, None | Some(Crs::Degrees)) => Crs::Degrees,
            (Unit::Metres, Some(crs @ Crs::Utm { .. })) => crs,
            (Unit::Metres, _) => {
                return Err(CliError::failed(
                    "the relief counts metres and does not say on which map: add --relief-crs EPSG:326zz or EPSG:327zz",
                ));
            }
            (Unit::Degrees, Some(_)) => {
                return Err(CliError::failed("the relief counts degrees: leave out --relief-crs"));
            }
        };
        Ok(Relief { grid, crs })
    }
}

fn layer(path: &Path) -> Result<Layer, CliError> {
    let read = load_vectors(path).map_err(|errors| diagnosed(&errors))?;
    tell(&read.notices);
    Ok(Layer { name: path.display().to_string(), ..read.layer })
}

fn tell(notices: &Diagnostics) {
    if !notices.is_empty() {
        error::diagnose(&notices.render(error::stderr_has_color()));
    }
}

fn without_source(list: Vec<Diagnostic>) -> Diagnostics {
    let mut diagnostics = Diagnostics::default();
    diagnostics.list.extend(list);
    diagnostics
}
