//! The command line: a library function that takes a registry of rasterizers.
//!
//! arguments -CLI-> scenes, choices -render-> picture, counts -> files and text
//!
//! Why a library function: a student's program is one line, `farop::cli::main(Registry::built_in().with("mine", ...))`,
//! and has every subcommand with its own rasterizer in it.
//!
//! Exit codes: 0 done, 1 checked and found wanting, 2 could not run (message on stderr, no partial file).

mod bench;
mod bundle;
mod check;
mod class;
mod compare;
mod convert;
mod dump;
mod error;
mod extremes;
mod forest;
mod generate;
mod grade;
mod lab;
mod lab_suite;
mod lighting;
mod list;
mod options;
mod plan;
mod raster;
mod render;
mod results;
mod sandbox;
mod scenes;
mod stages;
mod stats;
pub mod student;
mod suite;
mod terrain;
mod view;
mod why;

use crate::raster::fast::Instructions;
use crate::raster::{Registry, external};
use clap::{CommandFactory, Parser, Subcommand};
use error::CliError;
use std::io::Write;
use std::process::ExitCode;

/// Runs the command line of this process with the rasterizers in `registry`.
#[must_use]
pub fn main(registry: Registry) -> ExitCode {
    external::this_program_is_host();
    run(&registry, std::env::args_os())
}

/// Runs `arguments` (the program's name first) with the rasterizers in `registry`.
pub fn run(registry: &Registry, arguments: impl IntoIterator<Item = std::ffi::OsString>) -> ExitCode {
    let arguments: Vec<_> = arguments.into_iter().collect();
    // How farop starts itself for rasterizers outside of it: nothing that a user types.
    match arguments.get(1).and_then(|word| word.to_str()) {
        Some("__jail") => return ExitCode::from(external::enter_jail(&arguments[2..])),
        Some("__misbehave") => {
            return ExitCode::from(external::misbehave(&arguments.get(2).cloned().unwrap_or_default()));
        }
        Some("__host") => {
            return ExitCode::from(external::serve_library(&arguments.get(2).cloned().unwrap_or_default()));
        }
        _ => {}
    }
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => {
            // Help and version are no errors; clap knows which stream they go to.
            let failed = error.use_stderr();
            let _ = error.print();
            return ExitCode::from(if failed { 2 } else { 0 });
        }
    };
    let asked = Instructions::asked().map_err(CliError::failed);
    match asked.and_then(|_| cli.command.map_or_else(first_steps, |command| command.run(registry))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let code = error.exit_code();
            // Nobody may be reading any more; there is nobody left to tell.
            let _ = write!(std::io::stderr(), "{}", error.message());
            ExitCode::from(code)
        }
    }
}

/// See the 3D pipeline, plug in a rasterizer, learn why a picture is wrong.
#[derive(Parser)]
#[command(name = "farop", version, max_term_width = 80)]
#[command(after_help = "Examples:\n  farop render spd:gears -o gears.png\n  farop plan spd:teapot --shading phong")]
struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    Render(render::RenderCommand),
    Dump(dump::DumpCommand),
    Raster(raster::RasterCommand),
    Suite(suite::SuiteCommand),
    Compare(compare::CompareCommand),
    Check(check::CheckCommand),
    Lab(lab::LabCommand),
    Bench(bench::BenchCommand),
    Grade(grade::GradeCommand),
    Sandbox(sandbox::SandboxCommand),
    Convert(convert::ConvertCommand),
    Generate(generate::GenerateCommand),
    Plan(plan::PlanCommand),
    Terrain(Box<terrain::TerrainCommand>),
    Forest(Box<forest::ForestCommand>),
    Why(why::WhyCommand),
    View(view::ViewCommand),
    List(list::ListCommand),
    /// Student crates
    Student {
        #[command(subcommand)]
        command: StudentCommand,
    },
    /// Completions for a shell, on standard output
    #[command(after_help = "Examples:\n  farop completions bash > farop.bash\n  farop completions fish | source")]
    Completions {
        /// bash, elvish, fish, powershell or zsh
        shell: clap_complete::Shell,
    },
}

#[derive(Subcommand)]
enum StudentCommand {
    /// A new student crate from the template, here
    #[command(
        after_help = "Examples:\n  farop student new ana\n  cargo run -p student_ana -- render spd:gears -r mine"
    )]
    New {
        /// Lower-case letters, digits and `_`
        name: String,
    },
}

impl Command {
    fn run(self, registry: &Registry) -> Result<(), CliError> {
        match self {
            Command::Render(command) => command.run(registry),
            Command::Dump(command) => command.run(registry),
            Command::Raster(command) => command.run(registry),
            Command::Suite(command) => command.run(registry),
            Command::Compare(command) => command.run(),
            Command::Check(command) => command.run(),
            Command::Lab(command) => command.run(registry),
            Command::Bench(command) => command.run(registry),
            Command::Grade(command) => command.run(registry),
            Command::Sandbox(command) => command.run(),
            Command::Convert(command) => command.run(),
            Command::Generate(command) => command.run(),
            Command::Plan(command) => command.run(registry),
            Command::Terrain(command) => command.run(registry),
            Command::Forest(command) => command.run(registry),
            Command::Why(command) => command.run(registry),
            Command::View(command) => command.run(registry),
            Command::List(command) => command.run(registry),
            Command::Student { command: StudentCommand::New { name } } => new_student(&name),
            Command::Completions { shell } => {
                let mut script = Vec::new();
                clap_complete::generate(shell, &mut Cli::command(), "farop", &mut script);
                error::print(&String::from_utf8_lossy(&script))
            }
        }
    }
}

fn first_steps() -> Result<(), CliError> {
    error::print(
        "farop shows the 3D pipeline. Three commands to try:\n\n  \
         farop render spd:gears -o gears.png    a picture of a built-in scene\n  \
         farop plan spd:balls                   what a scene needs, and why\n  \
         farop list scenes                      what else there is\n\n\
         `farop --help` lists all commands.\n",
    )
}

fn new_student(name: &str) -> Result<(), CliError> {
    let folder = std::env::current_dir().map_err(|error| CliError::failed(format!("no current folder: {error}")))?;
    let created = student::create(&folder, name).map_err(|error| CliError::failed(error.to_string()))?;
    error::print(&created.to_string())
}
