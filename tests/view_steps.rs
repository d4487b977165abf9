//! Stepping through three triangles shows what `docs/tour.md` says, state by state; and what stepping must hold everywhere.

#[path = "support/viewer.rs"]
mod support;

use farop::math::{Vec3, length, newell_normal};
use farop::plan::{Accepts, Choices, Plan, Shading};
use farop::view::cut;
use farop::view::stages::Traced;
use support::{scene, told, viewer};

/// The numbers that the tour has for the orange triangle, as the tour writes them, and as the window does.
const TOUR: &[(&str, &str, &str)] = &[
    ("2.", "(-4, -1, 2), (1, -1, 2), (0, 2, 4)", "corners (-4, -1, 2) (1, -1, 2) (0, 2, 4)"),
    ("2.", "n.P > 0 is the front", "> 0: the front"),
    ("3.", "(-2, -1, 2) and (-8/3, 0, 8/3)", "(x, y, w) (-2, -1, 2) (1, -1, 2) (0, 2, 4) (-2.6667, 0, 2.6667)"),
    ("3.", "x = -w", "against the plane x = -w, left: 3 corners"),
    ("4.", "the quadrilateral into two", "ear 1 of 2"),
    ("5.", "(0, 6), (6, 6), (4, 2), (0, 4)", "corners (0, 6) (6, 6) (4, 2) (0, 4)"),
    ("5.", "1/8 + row/16", "1/w = 0.125 + 0 x + 0.0625 y"),
    ("5.", "0.8 times the color (1, 0.5, 0)", "light (0.8, 0.4, 0)"),
    ("1<at:2,3>i", "0.34375", "depth 0.34375"),
    ("1<at:3,2>i", "0.8 * 255 = 204", "color 204 102 0"),
];

#[test]
fn three_triangles_as_the_tour_tells_it() {
    let tour = include_str!("../docs/tour.md").split_whitespace().collect::<Vec<_>>().join(" ");
    for (keys, in_tour, in_window) in TOUR {
        assert!(tour.contains(in_tour), "the tour has no `{in_tour}` any more");
        let text = told(&mut eight(), keys);
        assert!(text.contains(in_window), "{keys}: `{in_window}` is not in\n{text}");
    }
}

/// The viewer of the tour: 8 x 8 pixels, flat, numbers straight through.
fn eight() -> farop::view::Viewer<'static> {
    let mut viewer = viewer("three_triangles.nff", 8);
    viewer.state.choices.shading = Shading::Flat;
    viewer.state.choices.encoding = farop::color::Encoding::Linear;
    viewer.state.choices.threads = Some(1);
    viewer
}

#[test]
fn every_state_of_three_triangles() {
    let (mut viewer, mut states) = (eight(), String::new());
    for keys in
        ["2", ".", ".", ".", "3", ".", "4", ".", ".", "5", ".", ".", "6", ".", ".", "rr6<end>", "<home>.....", "."]
    {
        states += &format!("[{keys}]\n{}\n\n", told(&mut viewer, keys));
    }
    insta::assert_snapshot!("view_three_triangles", states);
}

#[test]
fn back_is_the_way_that_was_come() {
    for (name, keys) in [("depth_overlap.nff", "6"), ("star.nff", "4"), ("hither_cut.nff", "3"), ("spd:gears:1", "5")] {
        let mut viewer = viewer(name, 32);
        told(&mut viewer, keys);
        let mut seen = vec![viewer.draw().clone()];
        for _ in 0..3 {
            told(&mut viewer, ".");
            seen.push(viewer.draw().clone());
        }
        while let Some(board) = seen.pop() {
            assert!(*viewer.draw() == board, "{name}, {} steps left", seen.len());
            told(&mut viewer, ",");
        }
        assert!(told(&mut viewer, "<home>>>>>>>>>>>>>").contains("step"));
        assert!(!told(&mut viewer, "<end>").contains("step"));
    }
}

#[test]
fn the_last_step_is_the_whole_picture() {
    let mut viewer = viewer("depth_overlap.nff", 40);
    let whole = told(&mut viewer, "t1");
    let picture = viewer.draw().clone();
    told(&mut viewer, "6");
    assert!(whole.contains("picture") && *viewer.draw() == picture);
}

fn traced(name: &str) -> Traced {
    let scene = scene(name);
    let choices = Choices { size: Some((64, 64)), ..Choices::default() };
    let plan = Plan::new(&scene, &choices, Accepts::AnyPolygon).expect("a view");
    Traced::new(&scene, plan)
}

const SCENES: [&str; 6] =
    ["three_triangles.nff", "hither_cut.nff", "side_cut.nff", "inside_sphere.nff", "glass.sipp", "spd:teapot:2"];

#[test]
fn stages_are_linked_without_a_gap() {
    for name in SCENES {
        let traced = traced(name);
        let linked: Vec<usize> = traced.kept.iter().copied().flatten().collect();
        assert_eq!(linked, (0..traced.trace.clipped.len()).collect::<Vec<_>>(), "{name}");
        assert_eq!(traced.pieces.last().map_or(0, |last| last.end), traced.list.len(), "{name}");
        assert!(traced.pieces.windows(2).all(|pair| pair[0].end == pair[1].start && !pair[0].is_empty()), "{name}");
        for (number, pieces) in traced.pieces.iter().enumerate() {
            let source = traced.trace.clipped[number].source;
            assert!(
                pieces.clone().all(|piece| traced.list.polygon(piece).record().source == source),
                "{name} {number}"
            );
        }
    }
}

#[test]
fn what_is_cut_off_and_what_stays_is_the_polygon() {
    for name in SCENES {
        let traced = traced(name);
        let area = |corners: &[Vec3]| if corners.is_empty() { Vec3::ZERO } else { newell_normal(corners) };
        let mut left: Vec<Vec<Vec3>> = traced.trace.eye.iter().map(|polygon| polygon.corners.clone()).collect();
        for cut::Crossing { polygon, plane } in traced.crossings() {
            let whole = area(&left[polygon]);
            let [kept, gone] = cut::cut(&left[polygon], plane, &traced.plan);
            let slack = 1e-9 * (length(whole) + 1e-9);
            assert!(length(area(&kept) + area(&gone) - whole) <= slack, "{name} {polygon} {plane:?}");
            left[polygon] = kept;
        }
        // What stays at the end is what the clipper left.
        for (eye, clipped) in traced.kept.iter().enumerate().filter_map(|(eye, kept)| Some((eye, (*kept)?))) {
            let (ours, theirs) = (area(&left[eye]), area(&traced.eye_corners(clipped)));
            assert!(length(ours - theirs) <= 1e-9 * (length(theirs) + 1e-9), "{name} {eye}: {ours} {theirs}");
        }
    }
}
