//! Reliefs of made grids, judged by means that know nothing of the hierarchy: barycentric heights, areas, and pictures.

use farop::forest::elevation::{Frame, Grid, Unit};
use farop::forest::relief::budget::{Measure, with_triangles};
use farop::forest::relief::fictitious::{self, Seams};
use farop::forest::relief::scene::{Colors, to_scene};
use farop::forest::relief::{Hierarchy, ReliefMesh, mesh, quality};
use farop::plan::{Choices, Culling, Shading};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{Camera, Scene};

#[path = "support/command.rs"]
mod command;

use command::Desk;

/// Rough and smooth parts, not a multiple of anything.
fn land(columns: usize, rows: usize, seed: u64) -> Grid {
    let frame = Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step: [30.0, 40.0] };
    let mut state = seed;
    let mut heights = Vec::new();
    for at in 0..columns * rows {
        let (x, y) = ((at % columns) as f64, (at / columns) as f64);
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let rough = if x > y { (state >> 33) as f64 / f64::from(1u32 << 31) * 40.0 } else { 0.0 };
        heights.push((300.0 * farop::math::sin(x / 8.0) * farop::math::cos(y / 11.0) + rough) as f32);
    }
    Grid::new("land", (columns, rows), heights, frame).expect("large enough")
}

/// The largest distance of every sample from every triangle that holds it, by barycentric coordinates; and the sum of areas in cells.
fn judged(grid: &Grid, mesh: &ReliefMesh) -> (f64, f64) {
    let (mut largest, mut area) = (0.0_f64, 0.0);
    let mut held = vec![false; grid.columns() * grid.rows()];
    for face in &mesh.faces {
        let corners: Vec<[f64; 3]> = mesh
            .outline(face)
            .iter()
            .map(|&at| mesh.vertices[at as usize])
            .map(|v| [f64::from(v.point.x), f64::from(v.point.y), v.height])
            .collect();
        for pair in corners[1..].windows(2) {
            let [a, b, c] = [corners[0], pair[0], pair[1]];
            let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            assert!(doubled <= 0.0, "turned round: rows count southward");
            area -= doubled / 2.0;
            let low = |i: usize| a[i].min(b[i]).min(c[i]) as usize;
            let high = |i: usize| a[i].max(b[i]).max(c[i]) as usize;
            for y in low(1)..=high(1) {
                for x in low(0)..=high(0) {
                    let (px, py) = (x as f64, y as f64);
                    let u = ((px - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (py - a[1])) / doubled;
                    let v = ((b[0] - a[0]) * (py - a[1]) - (px - a[0]) * (b[1] - a[1])) / doubled;
                    if doubled < 0.0 && u >= -1e-12 && v >= -1e-12 && u + v <= 1.0 + 1e-12 {
                        let height = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
                        largest = largest.max((height - f64::from(grid.height(x, y))).abs());
                        held[y * grid.columns() + x] = true;
                    }
                }
            }
        }
    }
    assert!(held.iter().all(|&held| held), "a sample lies under no triangle");
    (largest, area)
}

#[test]
fn no_sample_is_farther_than_asked() {
    for (columns, rows, seed) in [(33, 33, 1), (47, 29, 2), (20, 65, 3), (2, 9, 4), (5, 2, 5)] {
        let grid = land(columns, rows, seed);
        let hierarchy = Hierarchy::new(&grid);
        let mut last = usize::MAX;
        for error in [0.0, 1.5, 10.0, 60.0, 1e9] {
            let mesh = mesh::within(&hierarchy, error);
            let (largest, area) = judged(&grid, &mesh);
            let found = quality(&grid, &mesh);
            assert!(largest <= error * (1.0 + 1e-12) + 1e-9, "{columns} x {rows}, {error} m: {largest} m");
            assert!((largest - found.largest).abs() < 1e-9, "{largest}, the report says {}", found.largest);
            assert!((area - ((columns - 1) * (rows - 1)) as f64).abs() < 1e-9, "{columns} x {rows}: {area} cells");
            assert!(mesh.triangles() <= last, "{error}");
            last = mesh.triangles();
        }
    }
}

#[test]
fn other_meshes_are_reported_as_they_are() {
    let grid = land(40, 33, 9);
    let hierarchy = Hierarchy::new(&grid);
    let open = fictitious::within(&hierarchy, 30.0, Seams::Open).mesh;
    let stitched = fictitious::within(&hierarchy, 30.0, Seams::Stitched).mesh;
    let budget = with_triangles(&hierarchy, 300, Measure::Squares);
    for mesh in [open, stitched, budget] {
        let (largest, area) = judged(&grid, &mesh);
        assert!((largest - quality(&grid, &mesh).largest).abs() < 1e-9);
        assert!((area - 39.0 * 32.0).abs() < 1e-9);
    }
}

/// Pixels of the background within the relief: holes.
fn holes(grid: &Grid, mesh: &ReliefMesh, bits: u32) -> usize {
    let scene = to_scene(grid, mesh, &Colors::Plain);
    // Near enough that the relief covers all of the picture, from a corner no edge is parallel to.
    let camera = scene.camera.expect("it has one");
    let down = camera.from - camera.at;
    let camera = Camera { from: camera.at + down * 0.55, angle: 20.0, resolution: (640, 640), ..camera };
    let background = Some(farop::color::Rgb::new(1.0, 0.0, 1.0));
    let scene = Scene { camera: Some(camera), background, ..scene };
    let choices = Choices {
        shading: Shading::Flat,
        subpixel_bits: bits,
        culling: Culling::None,
        threads: Some(1),
        ..Choices::default()
    };
    let drawn = render(&scene, &choices, Some(&ZBuffer)).expect("it has a view");
    drawn.image.pixels().iter().filter(|light| light.g == 0.0).count()
}

#[test]
fn t_junctions_open_pinholes_and_nothing_else_does() {
    let grid = land(65, 65, 7);
    let hierarchy = Hierarchy::new(&grid);
    let (mut open, mut other) = (0, 0);
    for error in [5.0, 20.0, 60.0] {
        let by_paper = fictitious::within(&hierarchy, error, Seams::Open);
        assert!(by_paper.junctions > 10);
        for bits in [4, 8] {
            open += holes(&grid, &by_paper.mesh, bits);
            other += holes(&grid, &fictitious::within(&hierarchy, error, Seams::Stitched).mesh, bits);
            other += holes(&grid, &mesh::within(&hierarchy, error), bits);
        }
    }
    assert!(open > 3, "{open}");
    assert_eq!(other, 0);
}

/// A little land as an ASCII grid.
fn asc() -> String {
    let grid = land(40, 33, 11);
    let header = "ncols 40\nnrows 33\nxllcorner 1000\nyllcorner 2000\ncellsize 30\nNODATA_value -9999\n";
    let line = |row: usize| {
        let words: Vec<String> = grid.row(row).iter().map(|height| format!("{:.1}", height)).collect();
        words.join(" ") + "\n"
    };
    (0..33).fold(header.to_string(), |text, row| text + &line(row))
}

#[test]
fn a_relief_is_a_scene_that_renders() {
    let desk = Desk::new();
    desk.write("land.asc", asc());
    let told = desk.done("terrain land.asc --error 20 -o relief.nff");
    let told = String::from_utf8(told.stdout).expect("text");
    assert!(told.contains("40 x 33 samples, 1015 to 2185 m east, 2015 to 2975 m north"), "{told}");
    assert!(told.contains("at most 20 m off at every sample"), "{told}");
    let by_scene = desk.made("render relief.nff --size 96x80 -s gouraud", "by_scene.ppm");
    let at_once = desk.made("terrain land.asc --error 20 --size 96x80", "at_once.ppm");
    let differing = by_scene.iter().zip(&at_once).filter(|(a, b)| a.abs_diff(**b) > 1).count();
    assert!(by_scene.len() == at_once.len() && differing == 0, "{differing} bytes differ");
    desk.done("plan relief.nff");
    let lines = desk.made("terrain land.asc --error 20 --size 96x80 -s wire", "lines.ppm");
    assert!(lines != at_once && lines == desk.made("terrain land.asc --error 20 --size 96x80 -r wire", "wire.ppm"));
    assert!(lines[14..].chunks(3).filter(|pixel| **pixel != lines[14..17]).count() > 500, "lines are drawn");
    desk.done("terrain land.asc --error 20 -o relief.sipp");
    desk.done("render relief.sipp --size 32 -r watkins -o sipp.png");
}

#[test]
fn figures_as_json_are_the_same_twice() {
    let desk = Desk::new();
    desk.write("land.asc", asc());
    let run = |arguments: &str| desk.done(&format!("terrain land.asc --json {arguments}")).stdout;
    for arguments in [
        "",
        "--triangles 200",
        "--triangles 200 --measure largest",
        "--mode fictitious --error 15",
        "--criterion view --tolerance 3",
        "--criterion paper",
    ] {
        let once = run(arguments);
        assert_eq!(once, run(arguments), "{arguments}");
        let figures: serde_json::Value = serde_json::from_slice(&once).expect("JSON");
        let count = figures["triangles"].as_u64().expect("a count");
        assert!((2..=2 * 39 * 32).contains(&count), "{arguments}: {count}");
        assert_eq!(figures["samples"], 40 * 33, "{arguments}");
    }
    let walk =
        desk.done("terrain land.asc --criterion view --walk 900,300,400 --steps 4 --from 100,100,400 --at 300,300,0");
    let walk = String::from_utf8(walk.stdout).expect("text");
    assert_eq!(walk.lines().filter(|line| line.starts_with("step ")).count(), 5, "{walk}");
}
