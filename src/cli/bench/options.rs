//! What `farop bench` takes.
//!
//! Names that scripts for other renderers use are known besides farop's own: `--mode`, `--aa`, `--frames`, `--filter`.

use super::super::options::PictureOptions;
use clap::{Arg, ArgAction, ArgMatches, Args, FromArgMatches};

/// Where the time of a frame goes, each rasterizer side by side
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop bench bench:flake:100k --threads 1,2 -r fast -r zbuffer\n  farop bench --scaling -r fast --json",
    mut_arg("threads", many),
    mut_arg("shading", |arg| arg.alias("mode")),
    mut_arg("samples", |arg| arg.alias("aa"))
)]
pub(in crate::cli) struct BenchCommand {
    /// Scene files or built-in ones, each measured for itself [default: three]
    #[arg(value_name = "SCENE")]
    pub scenes: Vec<String>,
    /// Format of standard input and of unknown endings
    #[arg(long, value_name = "FORMAT", value_parser = ["nff", "sipp", "ftri"])]
    pub format: Option<String>,
    /// Rasterizers; may be repeated, the first draws what others are compared with [default: all]
    #[arg(short, long, value_name = "NAME")]
    pub rasterizer: Vec<String>,
    /// Frames of each that are counted, after two that warm up [default: 9]
    #[arg(long, value_name = "N", alias = "frames", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub rounds: Option<u32>,
    /// Start no further round after so many seconds a scene
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0, value_parser = seconds)]
    pub budget: f64,
    /// How times grow with triangles (1k to MOST) and with pixels (64x64 to 8192x8192, as --max-pixels allows)
    #[arg(long, value_name = "MOST", num_args = 0..=1, require_equals = true, default_missing_value = "1m",
          value_parser = ["10k", "100k", "1m", "10m"])]
    pub scaling: Option<String>,
    /// Count processor instructions of a frame, with valgrind: takes minutes
    #[arg(long)]
    pub instructions: bool,
    /// JSON instead of tables
    #[arg(long, conflicts_with = "one_line")]
    pub json: bool,
    /// One line for scripts, of the first rasterizer (default: fast) alone
    #[arg(long, conflicts_with_all = ["scaling", "instructions"])]
    pub one_line: bool,
    /// Taken from scripts, of no use here
    #[arg(long, hide = true)]
    pub filter: Option<String>,
    #[command(flatten)]
    pub threads: ThreadCounts,
    #[command(flatten)]
    pub picture: PictureOptions,
}

/// The numbers behind `--threads`, which here may be several: read before [`PictureOptions`] takes its one.
#[derive(Clone, Debug, Default)]
pub(in crate::cli) struct ThreadCounts(pub Vec<u32>);

impl Args for ThreadCounts {
    fn augment_args(command: clap::Command) -> clap::Command {
        command
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        command
    }
}

impl FromArgMatches for ThreadCounts {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(ThreadCounts(matches.get_many("threads").into_iter().flatten().copied().collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = ThreadCounts::from_arg_matches(matches)?;
        Ok(())
    }
}

/// `--threads 1,2,4`.
fn many(arg: Arg) -> Arg {
    arg.action(ArgAction::Append)
        .value_delimiter(',')
        .value_name("N[,N...]")
        .help("Numbers of threads, each measured [default: as many as there are cores]")
}

fn seconds(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|seconds| (0.0..1e9).contains(seconds));
    number.ok_or_else(|| "expected seconds, 0 or more".to_string())
}
