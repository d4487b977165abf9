//! The 1996 paper's own run, and twelve more scenes, against counts of an independent program.
//!
//! No decision in these scenes is closer than 1e-6 to a limit, so every correct pipeline gives these numbers.

mod support;

use farop::parse::{ParseOptions, load};
use farop::plan::Choices;
use farop::scene::Scene;
use farop::spd::Curves;
use std::path::Path;
use support::built_in::{built_in, geometry_of};

/// File of the reference set, built-in scene, size, curves; polygons, back-facing, clipped, cut, inside, rendered, triangles.
type Row = (&'static str, &'static str, u32, Curves, [u64; 7]);

const ROWS: [Row; 13] = [
    ("balls-s2-t.nff.gz", "balls", 2, Curves::Patches(3), [9829, 5024, 0, 1, 4804, 4805, 4806]),
    ("gears-s1.nff", "gears", 1, Curves::Kept, [147, 84, 0, 1, 62, 63, 267]),
    // 9345, 4864, 39 and 4442 are what FAROP printed in 1996.
    ("gears-s4.nff.gz", "gears", 4, Curves::Kept, [9345, 4864, 39, 45, 4397, 4442, 17659]),
    ("jacks-t.nff", "jacks", 1, Curves::Patches(2), [336, 168, 0, 0, 168, 168, 168]),
    ("lattice-s2-t.nff.gz", "lattice", 2, Curves::Patches(3), [4212, 2346, 1248, 201, 417, 618, 719]),
    ("mount-s4-c.nff", "mount", 4, Curves::Kept, [512, 173, 6, 19, 314, 333, 344]),
    ("mount-s6-c.nff.gz", "mount", 6, Curves::Kept, [8192, 3067, 190, 83, 4852, 4935, 4977]),
    ("nurbtst-def.nff", "nurbtst", 1, Curves::Kept, [1500, 1128, 0, 0, 372, 372, 372]),
    ("sombrero-def.nff", "sombrero", 1, Curves::Kept, [1922, 48, 514, 86, 1274, 1360, 1405]),
    ("teapot-s12.nff.gz", "teapot", 12, Curves::Kept, [9264, 4619, 4, 17, 4624, 4641, 4784]),
    ("teapot-s6.nff.gz", "teapot", 6, Curves::Kept, [2292, 1149, 0, 8, 1135, 1143, 1182]),
    ("tetra-s3.nff", "tetra", 3, Curves::Kept, [64, 25, 0, 0, 39, 39, 39]),
    ("tetra-s6.nff", "tetra", 6, Curves::Kept, [4096, 1600, 0, 0, 2496, 2496, 2496]),
];

fn counted(scene: &Scene, triangles: bool) -> [u64; 7] {
    let (list, counts) = geometry_of(scene, &Choices { triangles, ..Choices::default() });
    if triangles && counts.tessellated.polygons == 0 {
        assert_eq!(list.len() as u64, counts.triangles, "the list holds the triangles that were counted");
    }
    [counts.polygons, counts.backfacing, counts.clipped, counts.cut, counts.inside, counts.rendered, counts.triangles]
}

#[test]
fn built_in_scenes_give_the_counts_of_the_oracle() {
    for (file, name, size, curves, expected) in ROWS {
        let scene = built_in(name, size, curves);
        assert_eq!(counted(&scene, false), expected, "{file}");
        assert_eq!(counted(&scene, true), expected, "{file}, in triangles");
    }
}

#[test]
fn the_reference_files_give_the_counts_of_the_oracle() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/spd");
    if !folder.is_dir() {
        println!("notice: no reference files beside the project; the built-in scenes stand for them");
        return;
    }
    for (file, _, _, _, expected) in ROWS {
        let parsed =
            load(&folder.join(file), None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}"));
        assert_eq!(counted(&parsed.scene, false), expected, "{file}");
    }
}
