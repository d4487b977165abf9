//! What may be asked of `farop forest`.

use super::import::Import;
use super::stock::{New, Pack, Unpack};
use crate::cli::options::{encoding, finite, not_negative, point, size};
use crate::color::Encoding;
use crate::math::Vec3;
use crate::plan::{AlphaRule, Shading};
use clap::{Args, Subcommand, ValueEnum};
use std::path::PathBuf;

/// A forest: what is in it, pictures of it, walks through it
#[derive(Args)]
#[command(
    args_conflicts_with_subcommands = true,
    subcommand_negates_reqs = true,
    after_help = "Examples:\n  farop forest new --hectares 1000 -o area.fpack\n  farop forest area.fpack\n  farop forest area.fpack --at-mark NAME --height 60 --labels -o view.png\n  farop forest area.fpack --tour --frames walk.gif --size 320x240"
)]
pub(in crate::cli) struct ForestCommand {
    #[command(subcommand)]
    pub verb: Option<Verb>,
    /// Forest, .fcell or .fpack; without further options, what is in it
    #[arg(required = true, value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Picture to write, .png or .ppm
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// The year that is shown [default: the first of each stand]
    #[arg(long, value_name = "YEAR", allow_hyphen_values = true)]
    pub year: Option<i32>,
    /// Two years side by side in one picture
    #[arg(long, value_names = ["YEAR", "YEAR"], num_args = 2, conflicts_with = "year", requires = "output", allow_hyphen_values = true)]
    pub compare: Option<Vec<i32>>,
    /// Compass and named places over the picture
    #[arg(long)]
    pub labels: bool,
    #[command(flatten)]
    pub eye: Eye,
    #[command(flatten)]
    pub walk: Walk,
    #[command(flatten)]
    pub forest: Forest,
    #[command(flatten)]
    pub picture: Picture,
}

#[derive(Subcommand)]
pub(in crate::cli) enum Verb {
    Pack(Pack),
    Unpack(Unpack),
    New(New),
    Import(Box<Import>),
}

/// Where a picture is seen from.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Observer")]
pub(in crate::cli) struct Eye {
    /// Eye in metres from the south-west corner of cell 0 0, as X,Y,Z
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true, conflicts_with = "at_mark")]
    pub from: Option<Vec3>,
    /// Point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub at: Option<Vec3>,
    /// Stand at this named place
    #[arg(long, value_name = "NAME")]
    pub at_mark: Option<String>,
    /// So many metres above the ground there
    #[arg(long, value_name = "M", default_value_t = 1.7, value_parser = finite, allow_hyphen_values = true)]
    pub height: f64,
    /// Look that way, in degrees from north to east [default: to the middle of the area]
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true, conflicts_with = "at")]
    pub heading: Option<f64>,
    /// Look so many degrees up
    #[arg(long, value_name = "DEG", default_value_t = 0.0, value_parser = finite, allow_hyphen_values = true, conflicts_with = "at")]
    pub pitch: f64,
    /// Full opening in degrees across the smaller side
    #[arg(long, value_name = "DEG", default_value_t = 45.0, value_parser = finite)]
    pub angle_of_view: f64,
}

impl Eye {
    /// What an observer does who was told nothing.
    pub fn usual() -> Eye {
        let (from, at, at_mark, heading) = (None, None, None, None);
        Eye { from, at, at_mark, height: 1.7, heading, pitch: 0.0, angle_of_view: 45.0 }
    }
}

/// Where a walk leads, and what is kept of it.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Walk")]
pub(in crate::cli) struct Walk {
    /// Walk a recorded path, frame by frame
    #[arg(long, value_name = "FILE", conflicts_with_all = ["walk", "tour"])]
    pub path: Option<PathBuf>,
    /// Walk over these places, in metres; H is above the ground
    #[arg(long, value_name = "X Y H X Y H ...", conflicts_with = "tour", allow_hyphen_values = true)]
    pub walk: Option<String>,
    /// Walk over the named places, or across the area where there are none
    #[arg(long)]
    pub tour: bool,
    /// Walk as a device steers: lines of HEADING PITCH SPEED, a frame each; - is standard input
    #[arg(long, value_name = "FILE", conflicts_with_all = ["path", "walk", "tour"])]
    pub input: Option<PathBuf>,
    /// Metres a second
    #[arg(long, value_name = "M", default_value_t = 10.0, value_parser = finite)]
    pub speed: f64,
    /// Frames a second of a movie, and of the walk
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub rate: u32,
    /// At trees: slide along them, or stop
    #[arg(long, value_name = "HOW", num_args = 0..=1, require_equals = true, default_missing_value = "slide")]
    pub collide: Option<CollideName>,
    /// At most so many frames
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub first: Option<u64>,
    /// Write the walk as a path
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Movie to write: OUT.gif, OUT.y4m, or a folder for numbered PNG
    #[arg(long, value_name = "OUT")]
    pub frames: Option<PathBuf>,
    /// One hash a frame, on standard output
    #[arg(long)]
    pub hash: bool,
    /// How fast it goes: frames, trees and terrain polygons a second
    #[arg(long)]
    pub benchmark: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum CollideName {
    Slide,
    Stop,
}

/// How the forest is drawn.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Forest")]
pub(in crate::cli) struct Forest {
    /// How far trees and ground are drawn, in metres
    #[arg(long, value_name = "M", default_value_t = 2000.0, value_parser = not_negative)]
    pub horizon: f64,
    /// auto (by size on the picture), crossed, billboards, mesh, silhouettes or none
    #[arg(long, value_name = "HOW", default_value = "auto")]
    pub trees: TreesName,
    /// Nearby, every triangle of the ground wears one cover, and no wrong one is farther than M metres from a border
    #[arg(long, value_name = "M", value_parser = not_negative, allow_hyphen_values = true)]
    pub cover_tolerance: Option<f64>,
    /// What trees are that come near: pictures, or meshes in the light of the sun
    #[arg(long, value_name = "HOW", default_value = "pictures")]
    pub near_trees: NearName,
    /// Pixels above which a tree is near
    #[arg(long, value_name = "PX", default_value_t = 160.0, value_parser = not_negative)]
    pub near_height: f64,
    /// Error of the relief, in pixels
    #[arg(long, value_name = "PX", default_value_t = 1.0, value_parser = not_negative)]
    pub tolerance: f64,
    /// Leaves and grass: spring, summer (as painted), autumn or winter
    #[arg(long, value_name = "NAME", conflicts_with = "day")]
    pub season: Option<SeasonName>,
    /// The season of this day of the year, 1 to 366; south of the equator half a year later
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=366))]
    pub day: Option<u32>,
    /// A map on the ground, .fmap
    #[arg(long, value_name = "FILE")]
    pub map: Option<PathBuf>,
    /// The view of the map that is shown [default: its first]
    #[arg(long, value_name = "NAME", requires = "map")]
    pub map_view: Option<String>,
    /// lispsm (sharp near and far), uniform, exact (asked at every sample), or the papers' thesis and program
    #[arg(long, value_name = "HOW", default_value = "lispsm", requires = "map")]
    pub drape: DrapeName,
    /// Texels of the map's texture, each way
    #[arg(long, value_name = "N", default_value_t = 1024, requires = "map", value_parser = clap::value_parser!(u32).range(1..=8192))]
    pub map_texture: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum SeasonName {
    Spring,
    Summer,
    Autumn,
    Winter,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum DrapeName {
    Lispsm,
    Uniform,
    Exact,
    Thesis,
    Program,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum NearName {
    Pictures,
    Mesh,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(in crate::cli) enum TreesName {
    Auto,
    Crossed,
    Billboards,
    Mesh,
    Silhouettes,
    None,
}

/// How the picture is made.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub(in crate::cli) struct Picture {
    /// Size in pixels: WxH, or N for NxN
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "640x480")]
    pub size: (u32, u32),
    /// flat, gouraud, phong or wire
    #[arg(short, long, value_name = "NAME", default_value = "gouraud")]
    pub shading: Shading,
    /// A: every pixel is the mean of A x A samples
    #[arg(long, value_name = "A", default_value_t = 1)]
    pub samples: u32,
    /// Rasterizer
    #[arg(short, long, value_name = "NAME", default_value = "fast")]
    pub rasterizer: String,
    /// Threads; the picture does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
    /// Pictures with holes: coverage (as many samples as alpha says), test (all above the threshold), or paper (nothing repaired)
    #[arg(long, value_name = "RULE", default_value = "coverage")]
    pub alpha: AlphaRule,
    /// srgb, or linear: numbers straight through, as in 1996
    #[arg(long, value_name = "NAME", default_value = "srgb", value_parser = encoding)]
    pub encoding: Encoding,
}
