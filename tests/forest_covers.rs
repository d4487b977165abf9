//! Ground of a forest that wears one cover a triangle, judged place by place: which face is over it, which outlines are around it, and is there
//! another cover within the tolerance. Nothing here knows of halving, samples or bounds.

use farop::forest::area::{Cell, Owner};
use farop::forest::cells::Cells;
use farop::forest::pictures::Pictures;
use farop::forest::relief::criterion::Observer;
use farop::forest::terrain::Terrain;
use farop::forest::terrain::relief::{Faces, View};
use farop::math::Vec3;
use std::collections::HashMap;
use std::path::Path;
use std::sync::OnceLock;

#[path = "support/command.rs"]
mod command;

use command::Desk;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/forest.fcell");

fn area() -> (Cells, HashMap<[i32; 2], Cell>) {
    let (cells, _) = farop::parse::load_cells(Path::new(SCENE)).expect("a scene of the project");
    let all = cells.indices().into_iter().map(|index| (index, cells.load(index).expect("in memory").expect("there")));
    let all = all.collect();
    (cells, all)
}

/// Painted once for all tests.
fn pictures(cells: &Cells) -> &'static Pictures {
    static PICTURES: OnceLock<Pictures> = OnceLock::new();
    PICTURES.get_or_init(|| Pictures::new(cells.head(), Path::new("")).expect("all are painted"))
}

/// By winding: how often the outline goes around.
fn is_inside(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
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

/// The number of the ground at a place of the world; none outside all cells.
fn true_cover(cells: &HashMap<[i32; 2], Cell>, place: [f64; 2]) -> Option<u8> {
    let index = place.map(|metres| (metres / 240.0).floor() as i32);
    let cell = cells.get(&index)?;
    let at = [0, 1].map(|axis| place[axis] - 240.0 * f64::from(index[axis]));
    let mut found = cell.cover;
    for patch in &cell.patches {
        if is_inside(&patch.outer, at) && !patch.holes.iter().any(|hole| is_inside(hole, at)) {
            found = match patch.owner {
                Owner::Cover(cover) => Some(cover),
                Owner::Stand(stand) => cell.stands[stand as usize].states[0].cover.or(cell.cover),
            };
        }
    }
    Some(found.map_or(0, |cover| cover + 1))
}

/// Whether there is a place with another ground within a distance: looked for along 48 rays.
fn is_near_border(cells: &HashMap<[i32; 2], Cell>, place: [f64; 2], distance: f64) -> bool {
    let own = true_cover(cells, place);
    (0..48 * 24).any(|at| {
        let (angle, radius) = (f64::from(at / 24) * 0.1309, distance * f64::from(at % 24 + 1) / 24.0);
        let other = [place[0] + radius * farop::math::cos(angle), place[1] + radius * farop::math::sin(angle)];
        true_cover(cells, other).is_some_and(|other| Some(other) != own)
    })
}

fn view(eye: [f64; 3], near: f64) -> View {
    // It sees in all directions.
    let observer = Observer { eye: Vec3::from_array(eye), focal: 400.0, sides: [Vec3::ZERO; 4] };
    View { observer, tolerance: 4.0, near }
}

/// Every edge has a face on either side, or lies on the border of the area.
fn assert_no_cracks(faces: &Faces) {
    let mut uses = HashMap::<(u32, u32), i32>::new();
    for face in &faces.faces {
        let outline = faces.outline(face);
        for (&a, &b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            *uses.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { 10 };
        }
    }
    for ((a, b), uses) in uses {
        let [a, b] = [a, b].map(|at| faces.corners[at as usize].position);
        let is_border = |one: f64, other: f64| one == other && (one == 0.0 || one == 480.0);
        let is_single = uses == 1 || uses == 10;
        assert!(uses == 11 || is_single && (is_border(a.x, b.x) || is_border(a.y, b.y)), "{uses} faces at {a} {b}");
    }
}

#[test]
fn no_wrong_ground_is_farther_from_a_border_than_asked() {
    let (cells, all) = area();
    let pictures = pictures(&cells);
    let mut last = 0;
    for tolerance in [1000.0, 40.0, 15.0, 6.0] {
        let terrain = Terrain::with_covers(&cells, None, pictures, Some(tolerance)).expect("an area");
        let mut faces = Faces::default();
        terrain.faces(&view([210.0, 100.0, 900.0], 1000.0), &mut faces);
        assert_no_cracks(&faces);
        let promise = faces.border_error.expect("borders are kept");
        assert!(promise <= tolerance, "{tolerance} m: {promise} m promised");
        let (mut asked, mut wrong) = (0, 0);
        for face in &faces.faces {
            let corners: Vec<Vec3> =
                faces.outline(face).iter().map(|&at| faces.corners[at as usize].position).collect();
            let worn = face.cover.expect("all are near");
            let parts = (((corners[1] - corners[0]).length() / 5.0) as usize).clamp(2, 12);
            for (i, j) in (0..parts).flat_map(|i| (0..parts - i).map(move |j| (i, j))) {
                let share = |at: usize| (at as f64 + 0.31) / parts as f64;
                let place = corners[0] + (corners[1] - corners[0]) * share(i) + (corners[2] - corners[0]) * share(j);
                let place = [place.x, place.y];
                let is_in = share(i) + share(j) < 1.0;
                asked += usize::from(is_in);
                if is_in && true_cover(&all, place) != Some(worn) {
                    wrong += 1;
                    assert!(
                        is_near_border(&all, place, 1.05 * promise),
                        "{tolerance} m: {place:?}, {promise} m promised"
                    );
                }
            }
        }
        assert!(asked > 3000 && wrong > 20, "{tolerance}: {wrong} of {asked}");
        assert!(faces.faces.len() > last, "{tolerance}");
        last = faces.faces.len();
    }
    assert!(last > 1500, "{last}");
}

#[test]
fn ground_with_borders_depends_on_the_eye_alone() {
    let (cells, _) = area();
    let pictures = pictures(&cells);
    let terrain = Terrain::with_covers(&cells, None, pictures, Some(8.0)).expect("an area");
    let (mut faces, mut there) = (Faces::default(), Vec::new());
    let eyes: Vec<[f64; 3]> = (0..8).map(|step| [30.0 + 50.0 * f64::from(step), 60.0, 470.0]).collect();
    let seen = |faces: &Faces| (faces.faces.clone(), faces.outlines.clone(), faces.corners.clone());
    for eye in &eyes {
        terrain.faces(&view(*eye, 120.0), &mut faces);
        assert_no_cracks(&faces);
        assert!(faces.border_error.is_some_and(|error| error <= 8.0), "{:?}", faces.border_error);
        there.push(seen(&faces));
    }
    assert!(there[0].0.len() != there[7].0.len());
    for (eye, before) in eyes.iter().zip(&there).rev() {
        terrain.faces(&view(*eye, 120.0), &mut faces);
        assert!(seen(&faces) == *before, "another ground at {eye:?}");
    }
}

#[test]
fn the_command_says_how_exactly_borders_are_kept() {
    let desk = Desk::new();
    let told = desk.done(&format!("forest {SCENE} --trees none --size 40x30 --cover-tolerance 12 -o out.ppm"));
    let error = told.stderr.split("is farther than ").nth(1).and_then(|rest| rest.split(" m").next());
    assert!(error.and_then(|error| error.parse().ok()).is_some_and(|error: f64| error <= 12.0), "{}", told.stderr);
    for (tolerance, words) in [("0", "the cover tolerance is 0"), ("0.01", "can be kept"), ("-2", "--cover-tolerance")]
    {
        let outcome = desk.run(&format!("forest {SCENE} --size 40x30 --cover-tolerance {tolerance} -o out.ppm"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{tolerance}: {}", outcome.stderr);
    }
}
