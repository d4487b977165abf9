//! Coverage of a million triangles against an independent integer test; prints a table, exits 1 on any error.
//!
//! `cargo run --release --example coverage_full`

#[path = "../tests/support/mod.rs"]
mod support;

use std::process::ExitCode;
use support::cut::CutTally;
use support::random::Random;
use support::shapes::Shapes;
use support::tally::Tally;

/// Sub-pixel bits and how many triangles: most of them on the grid that pictures are drawn on.
const RUNS: [(u32, u64); 5] = [(0, 100_000), (4, 100_000), (8, 600_000), (12, 100_000), (16, 100_000)];
/// Meshes cut by the pipeline, each number of bits.
const MESHES: u64 = 2_000;

fn main() -> ExitCode {
    println!("random polygons, sizes log-uniform up to 4096 x 4096 samples; half of the triangles share edges");
    print_heads();
    let mut total = Tally::default();
    for (bits, triangles) in RUNS {
        let mut tally = Tally::default();
        let mut shapes = Shapes { random: Random::new(1996 + u64::from(bits)), steps: 1 << bits };
        tally.run(&mut shapes, triangles, 4096.0);
        print_row(&format!("{bits:2}"), &tally);
        total.add(&tally);
    }
    print_row("all", &total);

    println!("\nmeshes through the pipeline, cut at the sides of the picture, half of them at hither and yon too");
    print_heads();
    let (mut clean, mut met) = (total.is_clean(), [0; 4]);
    for (bits, _) in RUNS {
        let mut cut = CutTally::default();
        cut.run(&mut Random::new(2026 + u64::from(bits)), bits, MESHES);
        print_row(&format!("{bits:2}"), &cut.tally);
        clean &= cut.tally.is_clean() && cut.lost == 0;
        met = [met[0] + cut.meshes, met[1] + cut.cut, met[2] + cut.flipped, met[3] + cut.lost];
    }
    println!("{} meshes, {} cut polygons, {} turned by snapping, {} lost", met[0], met[1], met[2], met[3]);
    println!("{}", if clean { "\nno errors" } else { "\nERRORS" });
    if clean { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn print_heads() {
    let heads = ["triangles", "outlines", "samples", "one by one", "ties", "on centers", "shared", "wrong", "holes"];
    print!("bits");
    heads.iter().for_each(|head| print!(" {head:>13}"));
    println!(" {:>8}", "doubles");
}

fn print_row(name: &str, tally: &Tally) {
    print!("{name:>4}");
    let counts = [tally.triangles, tally.outlines, tally.samples, tally.ties.one_by_one, tally.ties.on_edges];
    let more = [tally.corners_on_centers, tally.shared_edges, tally.wrong, tally.holes];
    counts.iter().chain(&more).for_each(|count| print!(" {count:>13}"));
    println!(" {:>8}", tally.doubles);
}
