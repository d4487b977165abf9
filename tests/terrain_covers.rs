//! Borders between covers on a relief, judged place by place: which triangle is over it, which polygon is under it, how far is the nearest outline.
//! Nothing here knows of halving, samples or bounds.

use farop::forest::elevation::{Frame, Grid, Unit};
use farop::forest::relief::borders::{Borders, KeepingBorders};
use farop::forest::relief::criterion::{ByError, Criterion};
use farop::forest::relief::finer::finer;
use farop::forest::relief::{Hierarchy, ReliefMesh, mesh};

#[path = "support/command.rs"]
mod command;

use command::Desk;

type Place = [f64; 2];

/// Metres from sample to sample, not the same both ways.
const STEP: [f64; 2] = [30.0, 40.0];

fn land(columns: usize, rows: usize) -> Grid {
    let frame = Frame { unit: Unit::Metres, west: 0.0, north: 0.0, step: STEP };
    let height = |at: usize| {
        let (x, y) = ((at % columns) as f64, (at / columns) as f64);
        (40.0 * farop::math::sin(x / 6.0) * farop::math::cos(y / 5.0)) as f32
    };
    Grid::new("land", (columns, rows), (0..columns * rows).map(height).collect(), frame).expect("large enough")
}

/// Polygons that do not overlap: all of an outline is a border. Cover 0 is around them.
fn polygons() -> Vec<(u8, Vec<Place>)> {
    let star = (0..14).map(|corner| {
        let (angle, radius) = (f64::from(corner) * 0.4488, if corner % 2 == 0 { 210.0 } else { 90.0 });
        [333.0 + radius * farop::math::cos(angle), 401.0 + radius * farop::math::sin(angle)]
    });
    vec![
        (1, star.collect()),
        (2, vec![[611.0, 17.0], [893.0, 55.0], [640.0, 333.0]]),
        (3, vec![[640.0, 333.0], [893.0, 55.0], [1111.0, 700.0], [580.0, 690.0]]),
        (4, vec![[40.0, 730.0], [900.0, 731.0], [900.0, 742.0], [40.0, 743.0]]),
    ]
}

/// By winding: how often the outline goes around.
fn is_inside(outline: &[Place], [x, y]: Place) -> bool {
    let mut turns = 0;
    for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
        let left = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]);
        if a[1] <= y && b[1] > y && left > 0.0 {
            turns += 1;
        } else if a[1] > y && b[1] <= y && left < 0.0 {
            turns -= 1;
        }
    }
    turns != 0
}

fn true_cover(place: Place) -> u8 {
    polygons().iter().find(|(_, outline)| is_inside(outline, place)).map_or(0, |found| found.0)
}

fn distance_to_outlines(place: Place) -> f64 {
    let mut least = f64::INFINITY;
    for (_, outline) in polygons() {
        for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let (along, off) = ([b[0] - a[0], b[1] - a[1]], [place[0] - a[0], place[1] - a[1]]);
            let share = (off[0] * along[0] + off[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
            let share = share.clamp(0.0, 1.0);
            least = least.min((off[0] - share * along[0]).hypot(off[1] - share * along[1]));
        }
    }
    least
}

/// The farthest that a wrong place is from a border, over places everywhere in every triangle, and how many were asked.
fn judged(grid: &Grid, mesh: &ReliefMesh, borders: &Borders) -> (f64, usize) {
    let ([dx, dy], south) = (grid.spacing(), (grid.rows() - 1) as f64);
    let (mut farthest, mut asked) = (0.0_f64, 0);
    for face in &mesh.faces {
        let worn = borders.cover(&face.triangle);
        let corners: Vec<Place> = mesh
            .outline(face)
            .iter()
            .map(|&at| mesh.vertices[at as usize].point)
            .map(|point| [f64::from(point.x) * dx, (south - f64::from(point.y)) * dy])
            .collect();
        for pair in corners[1..].windows(2) {
            // Many in large triangles, some in small ones.
            let side = (pair[0][0] - corners[0][0]).hypot(pair[0][1] - corners[0][1]);
            let parts = ((side / 4.0) as usize).clamp(5, 60);
            for (i, j) in (0..parts).flat_map(|i| (0..parts - i).map(move |j| (i, j))) {
                let share = |at: usize| (at as f64 + 0.31) / parts as f64;
                let (u, v) = (share(i), share(j));
                let at = |axis: usize| {
                    let base = corners[0][axis];
                    base + u * (pair[0][axis] - base) + v * (pair[1][axis] - base)
                };
                let place = [at(0), at(1)];
                asked += 1;
                if u + v < 1.0 && true_cover(place) != worn {
                    farthest = farthest.max(distance_to_outlines(place));
                }
            }
        }
    }
    (farthest, asked)
}

fn borders_of(grid: &Grid) -> Borders {
    let ([dx, dy], south) = (grid.spacing(), grid.rows() - 1);
    Borders::new(grid, |x, y| true_cover([x as f64 * dx, (south - y) as f64 * dy]))
}

#[test]
fn no_wrong_place_is_farther_from_a_border_than_asked() {
    for (columns, rows, parts) in [(33, 17, 1), (38, 21, 4), (24, 19, 8)] {
        let grid = finer(&land(columns, rows), parts);
        let (hierarchy, borders) = (Hierarchy::new(&grid), borders_of(&grid));
        let (mut last, mut without) = (0, 0.0);
        for tolerance in [1e9, 200.0, 90.0, 40.0, 20.0, 10.0, 5.0] {
            if tolerance < borders.finest() {
                continue;
            }
            let criterion = ByError { hierarchy: &hierarchy, error: 15.0 };
            let keeping = KeepingBorders { criterion, borders: Some(&borders), tolerance };
            let mesh = mesh::mesh(&hierarchy, |middle| keeping.score(middle) > 1.0);
            let (farthest, asked) = judged(&grid, &mesh, &borders);
            assert!(asked > 10_000, "{asked}");
            let promise = borders.promise(mesh.faces.iter().map(|face| &face.triangle));
            assert!(promise <= tolerance, "{columns} x {rows}, {tolerance} m: {promise} m promised");
            assert!(farthest <= promise, "{columns} x {rows}, {tolerance} m: {farthest} m, {promise} m promised");
            // Neither is the bound so loose that it says nothing.
            assert!(
                tolerance > 1e6 || promise < 6.0 * farthest + borders.finest(),
                "{tolerance}: {farthest} {promise}"
            );
            assert!(mesh.triangles() >= last, "{tolerance} m");
            (last, without) = (mesh.triangles(), if tolerance > 1e6 { farthest } else { without });
        }
        assert!(without > 60.0, "the heights alone keep the borders: {without} m");
    }
}

/// A cell of 240 m with a meadow whose border is slanted, and the same ground as a grid of 30 m.
fn desk() -> Desk {
    let desk = Desk::new();
    let rows: String = (0..9).map(|y| (0..9).map(|x| format!("{} ", 100 + x * y)).collect::<String>() + "\n").collect();
    let head = "ncols 9\nnrows 9\nxllcorner 0\nyllcorner 0\ncellsize 30\nNODATA_value -9999\n";
    desk.write("land.asc", format!("{head}{rows}"));
    desk.write(
        "land.fcell",
        "fcell 1\ncrs EPSG:32629 origin 0 0\ncover 1 paint:grass tile 10\ncover 2 paint:rock tile 10\n\
         cell 0 0 size 240 seed 1\nground 1\ndem 2 2 z0 100 dz 1  0 0 0 0\n\
         poly 1 cover 2 outer 4 20 -0 220 10 170 230 5 110\nend\n",
    );
    desk
}

#[test]
fn the_command_keeps_borders_and_says_so() {
    let desk = desk();
    let mut triangles = Vec::new();
    for tolerance in [1000.0, 60.0, 30.0, 10.0, 2.0] {
        let asked = format!(
            "terrain land.asc --units metres --error 30 --covers land.fcell --cover-tolerance {tolerance} --json"
        );
        let told = desk.done(&asked);
        let figures: serde_json::Value = serde_json::from_slice(&told.stdout).expect("it is JSON");
        let covers = &figures["covers"];
        assert!(covers["promise"].as_f64().is_some_and(|promise| promise <= tolerance), "{covers}");
        assert!(covers["farthest"].as_f64() <= covers["promise"].as_f64(), "{covers}");
        triangles.push(figures["triangles"].as_u64().expect("a number"));
    }
    assert!(triangles.is_sorted() && triangles[0] * 4 < triangles[4], "{triangles:?}");
    desk.done("terrain land.asc --units metres --covers land.fcell -o land.nff");
    let walk = "terrain land.asc --units metres --covers land.fcell --criterion view --walk 100,100,150 --steps 3";
    assert!(String::from_utf8_lossy(&desk.done(walk).stdout).contains("30.00 m asked: no wrong cover farther than"));
}

#[test]
fn what_cannot_be_kept_is_refused() {
    let desk = desk();
    let says = |arguments: &str, words: &[&str]| {
        let outcome = desk.run(&format!("terrain land.asc --units metres {arguments}"));
        assert_eq!(outcome.code, 2, "{arguments}: {}", outcome.stderr);
        words.iter().for_each(|word| assert!(outcome.stderr.contains(word), "{arguments}: {}", outcome.stderr));
    };
    says("--covers land.fcell --cover-tolerance 0", &["write metres above 0"]);
    says("--covers land.fcell --cover-tolerance 0.001", &["--cover-tolerance 0.001", "write 0.06 or more"]);
    says("--covers land.fcell --cover-tolerance -3", &["--cover-tolerance"]);
    says("--covers land.fcell --mode fictitious", &["leave out --mode fictitious"]);
    says("--covers land.fcell --triangles 50", &["--triangles"]);
    says("--cover-tolerance 5", &["--covers"]);
    says("--covers gone.fcell", &["gone.fcell"]);
    says("--covers land.asc", &["is no area of forest"]);
    let far = String::from_utf8(desk.read("land.fcell")).expect("text").replace("cell 0 0", "cell 9 9");
    desk.write("far.fcell", far);
    says("--covers far.fcell", &["covers no sample", "240 m east"]);
}
