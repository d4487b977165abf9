//! The tables of `docs/terrain.md`: relief of real tiles, beside the figures that were measured before there was a program.
//!
//! `cargo run --release --example relief_tables [FOLDER]`; the folder is `../shared/data/terrain` unless named.

use farop::forest::elevation::{Grid, fill_voids, merge};
use farop::forest::relief::budget::{Measure, with_triangles};
use farop::forest::relief::fictitious::{self, Seams};
use farop::forest::relief::{Hierarchy, Quality, ReliefMesh, mesh, quality, strip};
use farop::parse::{GridOptions, load_grid};
use farop::report::StageTimer;
use std::path::PathBuf;

/// Triangles, largest error, RMSE: measured with prototypes in other languages.
type Known = (usize, f64, f64);

/// Asked error; then conforming and fictitious, as known before.
const PYRENEES: [(f64, Known, Known); 3] = [
    (200.0, (16_465, 200.0, 65.7), (12_970, 290.0, 75.9)),
    (50.0, (157_381, 50.0, 17.1), (131_445, 87.8, 19.7)),
    (10.0, (914_804, 10.0, 3.50), (837_069, 19.0, 3.93)),
];
const HAWAII: [(f64, Known, Known); 3] = [
    (200.0, (611, 200.0, 52.7), (407, 287.0, 61.9)),
    (50.0, (10_220, 50.0, 12.0), (6_006, 88.8, 15.2)),
    (10.0, (164_951, 10.0, 3.26), (118_106, 18.5, 3.79)),
];

fn main() {
    let folder = std::env::args().nth(1).map_or_else(|| PathBuf::from("../shared/data/terrain"), PathBuf::from);
    let load = |name: &str| load_grid(&folder.join(name), &GridOptions::default()).map_err(|error| println!("{error}"));
    let (Ok(mut pyrenees), Ok(south), Ok(hawaii)) =
        (load("hgt/N42E001.hgt.gz"), load("hgt/N41E001.hgt.gz"), load("dted/n19_w156_3arc_v2.dt1.gz"))
    else {
        println!("notice: the tiles are not in {}", folder.display());
        return;
    };
    let joint = merge(vec![pyrenees.clone(), south]).map(|merged| merged.grid);
    fill_voids(&mut pyrenees, usize::MAX);
    let crop = |grid: &Grid| grid.crop(0..1025, 0..1025).expect("tiles are larger");
    let (pyrenees, hawaii) = (crop(&pyrenees), crop(&hawaii));
    errors("P", &pyrenees, &PYRENEES);
    errors("H", &hawaii, &HAWAII);
    budgets("P", &pyrenees, &[10, 45, 845, 3549, 5873]);
    budgets("H", &hawaii, &[10, 45, 845, 3549, 5873]);
    if let Ok(mut joint) = joint {
        fill_voids(&mut joint, usize::MAX);
        budgets("N42 + N41", &joint, &[10, 45, 845, 3549, 5873, 5127]);
    }
}

fn errors(name: &str, grid: &Grid, known: &[(f64, Known, Known)]) {
    let timer = StageTimer::start();
    let hierarchy = Hierarchy::new(grid);
    println!("\n{name}: errors in {:.0} ms of processor time", milliseconds(timer));
    println!(
        "  asked   mode         triangles (known)    largest (known)     RMSE (known)   strip/triangle   ms of mesh"
    );
    for (error, conforming, with_fictitious) in known {
        let timer = StageTimer::start();
        let mesh = mesh::within(&hierarchy, *error);
        let ms = milliseconds(timer);
        row(*error, "conforming", (&quality(grid, &mesh), &mesh), conforming, ms);
        let timer = StageTimer::start();
        let mesh = fictitious::within(&hierarchy, *error, Seams::Open).mesh;
        let ms = milliseconds(timer);
        row(*error, "fictitious", (&quality(grid, &mesh), &mesh), with_fictitious, ms);
    }
}

fn row(error: f64, mode: &str, (found, mesh): (&Quality, &ReliefMesh), known: &Known, ms: f64) {
    let ratio = strip::strip(mesh).len() as f64 / found.triangles.max(1) as f64;
    println!(
        "  {error:5}   {mode}  {:>9} ({:>7})  {:>7.1} ({:>5.1})  {:>7.2} ({:>5.2})   {ratio:.2}   {ms:.0}",
        found.triangles, known.0, found.largest, known.1, found.rmse, known.2
    );
}

/// Processor time: the wall clock of a shared machine says little.
fn milliseconds(timer: StageTimer) -> f64 {
    let time = timer.stop();
    time.user + time.system
}

fn budgets(name: &str, grid: &Grid, budgets: &[usize]) {
    let hierarchy = Hierarchy::new(grid);
    println!("\n{name}: budget   by squares: triangles, RMSE, largest   by largest: triangles, RMSE, largest");
    for &budget in budgets {
        print!("  {budget:>7}");
        for measure in [Measure::Squares, Measure::Largest] {
            let found = quality(grid, &with_triangles(&hierarchy, budget, measure));
            print!("   {:>5} {:>7.1} {:>7.1}", found.triangles, found.rmse, found.largest);
        }
        println!();
    }
}
