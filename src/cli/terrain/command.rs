//! The command: what is asked for, reading and merging, and where the relief goes.

use super::covers::{CoverOptions, Covered};
use super::maps::OnMap;
use super::progressive::{receive, send};
use super::relief::Made;
use super::report;
use crate::cli::error::{self, CliError, notice};
use crate::cli::options::{finite, not_negative, point, size};
use crate::cli::render::save_picture;
use crate::cli::scenes::{as_rasterizer, check_drawn, find_rasterizer};
use crate::forest::elevation::{Filled, Grid, Merged, Unit, fill_voids, merge};
use crate::forest::relief::scene::{Colors, to_scene, to_scene_by};
use crate::image::encode_for;
use crate::image::save::{SaveError, WholeFile};
use crate::math::Vec3;
use crate::parse::{GridOptions, load_grid};
use crate::plan::{Choices, Shading};
use crate::raster::Registry;
use crate::render::render;
use crate::scene::{Camera, Scene};
use crate::write::{write_nff, write_sipp};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// Elevation grids as a relief of few triangles
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop terrain N42E001.hgt.gz --error 50 -o relief.nff\n  farop terrain N41E001.hgt N42E001.hgt --triangles 5000 -o map.png"
)]
pub(in crate::cli) struct TerrainCommand {
    /// Grids: .hgt, .dt0 .dt1 .dt2, .asc, .png, each also with .gz; neighbors merge. Or one .frel
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Scene (.nff, .sipp) or picture (.png, .ppm) to write; without it, the figures only
    #[arg(short, long, value_name = "FILE")]
    pub(super) output: Option<PathBuf>,
    /// Fill voids of up to N samples; larger ones stay holes
    #[arg(long, value_name = "N", default_value_t = 2500)]
    fill: usize,
    #[command(flatten)]
    pub(super) wanted: Wanted,
    #[command(flatten)]
    pub(super) view: View,
    #[command(flatten)]
    on_map: OnMap,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    pub(super) covers: CoverOptions,
    /// Write a stream of halvings to -o FILE.frel: any beginning of it is a relief
    #[arg(long, requires = "output")]
    progressive: bool,
    /// Measure the errors of a .frel (whole or cut) against this grid
    #[arg(long, value_name = "FILE")]
    against: Option<PathBuf>,
    /// The figures as JSON
    #[arg(long)]
    json: bool,
    /// Also the times
    #[arg(long)]
    pub(super) stats: bool,
}

/// How many triangles, and where.
#[derive(Args, Clone)]
#[command(next_help_heading = "Relief")]
pub(super) struct Wanted {
    /// No sample is farther than M metres from the relief [default: a hundredth of the range of heights]
    #[arg(long, value_name = "M", value_parser = not_negative, allow_hyphen_values = true, conflicts_with = "triangles")]
    pub error: Option<f64>,
    /// At most N triangles
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..))]
    pub triangles: Option<u32>,
    /// With --triangles, halve first what has the largest sum of squares, or the largest error
    #[arg(long, value_name = "WHAT", default_value = "squares")]
    pub measure: MeasureName,
    /// error: the same in metres everywhere; view: as many pixels as --tolerance; paper: its three factors
    #[arg(long, value_name = "NAME", default_value = "error", conflicts_with = "triangles")]
    pub criterion: CriterionName,
    /// conforming: neighbors are halved too; fictitious: they stay, as in the paper
    #[arg(long, value_name = "NAME", default_value = "conforming", conflicts_with = "triangles")]
    pub mode: ModeName,
    /// In fictitious mode, leave T-junctions open as in the paper: pinholes
    #[arg(long)]
    pub open: bool,
    /// Of the paper's criterion: least hypotenuse, as a share of the terrain's diagonal
    #[arg(long, value_name = "SHARE", default_value_t = 0.01, value_parser = not_negative)]
    pub size_factor: f64,
    /// Largest distance, as a share of the farthest
    #[arg(long, value_name = "SHARE", default_value_t = 0.8, value_parser = not_negative)]
    pub distance_factor: f64,
    /// Least curvature, as a share of the largest
    #[arg(long, value_name = "SHARE", default_value_t = 0.2, value_parser = not_negative)]
    pub curvature_factor: f64,
    /// The observer walks from --from to here; what changes is told for every step
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub walk: Option<Vec3>,
    /// Steps of the walk
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub steps: u32,
}

/// Who looks, and how the picture is made.
#[derive(Args, Clone)]
#[command(next_help_heading = "View and picture")]
pub(super) struct View {
    /// Eye in metres from the south-west corner, as X,Y,Z [default: above the middle]
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    from: Option<Vec3>,
    /// Point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    at: Option<Vec3>,
    /// Full opening in degrees across the smaller side
    #[arg(long, value_name = "DEG", value_parser = finite)]
    angle_of_view: Option<f64>,
    /// Size in pixels: WxH, or N for NxN
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<(u32, u32)>,
    /// Error of --criterion view, in pixels
    #[arg(long, value_name = "PX", default_value_t = 1.0, value_parser = not_negative)]
    pub tolerance: f64,
    /// ladder (green to white by height), grounds (four that blend by height) or plain
    #[arg(long, value_name = "NAME", default_value = "ladder")]
    colors: ColorsName,
    /// flat, gouraud, phong or wire
    #[arg(short, long, value_name = "NAME", default_value = "gouraud")]
    shading: Shading,
    /// A: every pixel is the mean of A x A samples
    #[arg(long, value_name = "A", default_value_t = 1)]
    samples: u32,
    /// Rasterizer of the picture
    #[arg(short, long, value_name = "NAME", default_value = "zbuffer")]
    rasterizer: String,
}

/// What the files leave open.
#[derive(Args, Clone)]
#[command(next_help_heading = "Files")]
struct Reading {
    /// What an ASCII grid counts in, degrees or metres [default: by its numbers]
    #[arg(long, value_name = "UNIT")]
    units: Option<UnitName>,
    /// Metres from pixel to pixel of a PNG
    #[arg(long, value_name = "M", default_value_t = 30.0, value_parser = finite)]
    spacing: f64,
    /// Heights of black and white of a PNG, in metres
    #[arg(long, value_name = "LOW,HIGH", default_value = "0,255", value_parser = pair, allow_hyphen_values = true)]
    heights: (f64, f64),
    /// A colored PNG holds heights: -10000 + 0.1 (65536 R + 256 G + B)
    #[arg(long)]
    colored: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MeasureName {
    Squares,
    Largest,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum CriterionName {
    Error,
    View,
    Paper,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ModeName {
    Conforming,
    Fictitious,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ColorsName {
    Ladder,
    Grounds,
    Plain,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum UnitName {
    Degrees,
    Metres,
}

impl TerrainCommand {
    pub fn run(self: Box<Self>, registry: &Registry) -> Result<(), CliError> {
        if let Some(path) = &self.output
            && !is_scene(path)
            && !self.progressive
        {
            encode_for(path, &crate::image::Picture::filled(1, 1, [0; 3])).map_err(|error| {
                CliError::failed(format!(
                    "{error}\nhelp: a relief is written as a scene, .nff or .sipp, or as a picture"
                ))
            })?;
        }
        if let (Some(map), Some(path)) = (&self.on_map.map, self.output.as_ref().filter(|path| is_scene(path))) {
            let (map, path) = (map.display(), path.display());
            return Err(CliError::failed(format!(
                "{path}: no scene file can hold the map {map}; write a picture, .png or .ppm, or leave out --map"
            )));
        }
        let rasterizer = find_rasterizer(registry, self.view.rasterizer())?;
        let (merged, filled, made) = self.relief()?;
        let grid = &merged.grid;
        if let Some(path) = self.output.as_ref().filter(|_| self.progressive) {
            return error::print(&send(path, grid)?);
        }
        let text = if self.json {
            report::json(&merged, &filled, &made)?
        } else {
            report::text(&merged, &filled, &made, self.stats)
        };
        if let Some(path) = &self.output {
            let mut scene = match &made.covered {
                Some((Covered { borders, colors, .. }, _)) => {
                    to_scene_by(grid, &made.mesh, colors, |face| usize::from(borders.cover(&face.triangle)))
                }
                None => to_scene(grid, &made.mesh, &self.view.colors(grid)),
            };
            scene.camera = Some(Camera { resolution: self.view.size.unwrap_or(made.camera.resolution), ..made.camera });
            let camera = scene.camera.unwrap_or(made.camera);
            if let Some(told) = self.on_map.wear(grid, &mut scene, &camera)? {
                notice(&told);
            }
            if is_scene(path) {
                write_scene(path, &scene)?;
            } else {
                let choices = self.view.choices();
                let drawn = render(&scene, &choices, as_rasterizer(&rasterizer))?;
                check_drawn(&drawn.puts)?;
                save_picture(path, &drawn.image.encode(choices.encoding))?;
            }
        }
        error::print(&text)
    }

    /// The inputs.
    pub(super) fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// What a stream is measured against.
    pub(super) fn against(&self) -> Option<&PathBuf> {
        self.against.as_ref()
    }

    /// The relief that is asked for, or that a stream holds.
    fn relief(&self) -> Result<(Merged, Filled, Made), CliError> {
        let camera = |grid: &Grid| self.view.camera(grid, self.wanted.criterion);
        if let Some(stream) = self.stream()? {
            let known = self.against.as_ref().map(|path| self.read(std::slice::from_ref(path))).transpose()?;
            return receive(stream, known.as_ref().map(|(merged, _)| &merged.grid), camera);
        }
        let (mut merged, filled) = self.read(&self.files)?;
        let covered = Covered::new(self, &mut merged.grid)?;
        let made = Made::new(self, &merged.grid, &camera(&merged.grid), covered)?;
        Ok((merged, filled, made))
    }

    /// Reads, merges and fills.
    fn read(&self, files: &[PathBuf]) -> Result<(Merged, Filled), CliError> {
        let reading = &self.reading;
        if reading.spacing <= 0.0 {
            return Err(CliError::failed(format!("--spacing {}: write a number of metres above 0", reading.spacing)));
        }
        let unit = reading.units.map(|unit| if unit == UnitName::Degrees { Unit::Degrees } else { Unit::Metres });
        let (spacing, heights, colored) = (reading.spacing, reading.heights, reading.colored);
        let options = GridOptions { unit, spacing, heights, colored };
        let load = |path: &PathBuf| {
            load_grid(path, &options).map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))
        };
        let grids = files.iter().map(load).collect::<Result<Vec<Grid>, CliError>>()?;
        let mut merged = merge(grids).map_err(CliError::failed)?;
        let filled = fill_voids(&mut merged.grid, self.fill);
        let grid = &merged.grid;
        if grid.range().is_none() {
            let count = grid.columns() * grid.rows();
            return Err(CliError::failed(format!(
                "`{}` has no heights: all {count} samples are voids; is it the right file, and the right NODATA_value?",
                grid.name
            )));
        }
        Ok((merged, filled))
    }
}

impl View {
    /// The camera of the options; without an eye, above the middle, or where the observer matters, in the south.
    fn camera(&self, grid: &Grid, criterion: CriterionName) -> Camera {
        use crate::forest::relief::scene::{from_above, from_south};
        let is_from_above = criterion == CriterionName::Error && self.from.is_none();
        let mut camera = if is_from_above { from_above(grid) } else { from_south(grid) };
        camera.from = self.from.unwrap_or(camera.from);
        camera.at = self.at.unwrap_or(camera.at);
        camera.angle = self.angle_of_view.unwrap_or(camera.angle);
        camera.resolution = self.size.unwrap_or(camera.resolution);
        // Straight down there is no up but north.
        let down = camera.at - camera.from;
        if down.x == 0.0 && down.y == 0.0 {
            camera.up = Vec3::Y;
        }
        if self.from.is_some() || self.at.is_some() {
            camera.hither = 0.0;
        }
        camera
    }

    /// `-s wire` and `-r wire` are one thing.
    fn rasterizer(&self) -> &str {
        if self.shading == Shading::Wire && self.rasterizer == "zbuffer" { "wire" } else { &self.rasterizer }
    }

    fn choices(&self) -> Choices {
        let shading = if self.rasterizer() == "wire" { Shading::Wire } else { self.shading };
        Choices { size: self.size, shading, samples: self.samples, ..Choices::default() }
    }

    fn colors(&self, grid: &Grid) -> Colors {
        match self.colors {
            ColorsName::Ladder => Colors::Ladder,
            ColorsName::Plain => Colors::Plain,
            ColorsName::Grounds => {
                let (low, high) = grid.range().unwrap_or_default();
                Colors::four_grounds((f64::from(low), f64::from(high)))
            }
        }
    }
}

fn is_scene(path: &Path) -> bool {
    let ends = |ending: &str| path.extension().is_some_and(|end| end.eq_ignore_ascii_case(ending));
    ends("nff") || ends("sipp")
}

fn write_scene(path: &Path, scene: &Scene) -> Result<(), CliError> {
    let is_sipp = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("sipp"));
    let write = if is_sipp { write_sipp } else { write_nff };
    let mut file = WholeFile::create(path)?;
    let lost = write(scene, &mut file).map_err(|error| CliError::from(SaveError::at(path, error)))?;
    file.commit()?;
    // That the object has a name is not worth a notice here: nobody gave it one.
    let format = if is_sipp { "SIPP" } else { "NFF" };
    let worth = lost.iter().filter(|text| !text.contains("name"));
    worth.for_each(|text| notice(&format!("not in the {format} file: {text}")));
    Ok(())
}

/// Two numbers.
fn pair(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once(',').ok_or("expected two numbers, as in 354,3019")?;
    Ok((finite(low)?, finite(high)?))
}
