//! `farop list`: what there is.

use super::error::{self, CliError};
use crate::grade;
use crate::lab::check::CHECKS;
use crate::raster::Registry;
use crate::spd;
use clap::{Args, ValueEnum};

/// What there is: scenes, rasterizers, labs or checks
#[derive(Args)]
#[command(after_help = "Examples:\n  farop list scenes\n  farop list rasterizers")]
pub(super) struct ListCommand {
    /// Of what
    #[arg(value_enum)]
    what: What,
}

#[derive(Clone, Copy, ValueEnum)]
enum What {
    Scenes,
    Rasterizers,
    Labs,
    Checks,
}

impl ListCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        error::print(&match self.what {
            What::Scenes => scenes(),
            What::Rasterizers => rasterizers(registry),
            What::Labs => labs(),
            What::Checks => checks(),
        })
    }
}

fn scenes() -> String {
    let mut text = String::from("name       size  polygons  shapes  what there is to see\n");
    for scene in &spd::SCENES {
        let counts = spd::counts(scene, scene.default_size, spd::Curves::Kept);
        let size = if scene.sized { scene.default_size.to_string() } else { "-".to_string() };
        let (polygons, shapes) = (counts.p + counts.pp, counts.s + counts.c);
        text += &format!("{:<9} {size:>5} {polygons:>9} {shapes:>7}  {}\n", scene.name, scene.summary);
    }
    text += "\nbench scene  sizes (triangles)                     what there is to see\n";
    for scene in spd::bench::BENCH_SCENES {
        let sizes: Vec<_> = scene.sizes.iter().map(|(name, _)| *name).collect();
        let sizes = if sizes.is_empty() { "-".to_string() } else { sizes.join(" ") };
        text += &format!("{:<12} {sizes:<33} {}\n", scene.name, scene.summary);
    }
    text + "Render one with `farop render spd:NAME` or, of another size, `farop render spd:NAME:SIZE`; those for measuring are `bench:NAME:SIZE`.\n"
}

fn rasterizers(registry: &Registry) -> String {
    let rows = registry.iter().map(|entry| format!("{:<11}{}\n", entry.name, entry.summary));
    rows.collect::<String>()
        + "none       draws nothing: counts and times only\n\
           exec:CMD   a program in any language (docs/doors.md)\n\
           lib:PATH   a C library (docs/doors.md)\n"
}

fn checks() -> String {
    CHECKS.iter().map(|check| format!("{:<14}{}\n", check.name, check.claim)).collect::<String>()
        + "Run one with `farop check NAME`, all of them in short with `farop check --quick`.\n"
}

fn labs() -> String {
    let mut text = String::new();
    for lab in grade::LABS.iter().chain(grade::functions::FUNCTION_LABS) {
        text += &format!("{:<14}{}\n", lab.name, lab.summary);
        for aspect in lab.aspects {
            text += &format!("  {:<18}{:>3}  {}\n", aspect.name, aspect.points, aspect.asks);
        }
    }
    text + "The number is the points of an aspect. Grade with `farop grade LAB -r NAME`. What is asked: docs/labs/LAB.md;\n\
            hints: `farop grade LAB --hint 1`, then 2 and 3.\n"
}
