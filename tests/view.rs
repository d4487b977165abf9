//! Everything the window shows, without a window: pictures accepted by eye, text, and what must hold whatever is shown.

#[path = "support/viewer.rs"]
mod support;

use farop::plan::{Choices, Shading};
use farop::raster::{PerPolygon, PolygonRasterizer, Target, ZBuffer, coverage};
use farop::render::render;
use farop::screen::{ScreenPolygon, Shader};
use farop::snapshot::assert_picture;
use farop::view::{Action, Board, Compare, Event, Key, Viewer, keys, read_keys};
use support::{press, rasterizers, scene, told, viewer};

/// What keys show of a scene, without text: it has snapshots of its own.
fn shown(name: &str, side: u32, keys: &str) -> farop::image::Picture {
    let mut viewer = viewer(name, side);
    press(&mut viewer, &format!("t{keys}"));
    viewer.draw();
    assert_eq!(viewer.trouble(), None);
    viewer.board().picture()
}

#[test]
fn stages_have_pictures() {
    assert_picture!("view_eye", shown("three_triangles.nff", 128, "2"));
    assert_picture!("view_eye_hand", shown("three_triangles.nff", 128, "2<left*4>+.."));
    assert_picture!("view_clip", shown("hither_cut.nff", 128, "3"));
    assert_picture!("view_clip_sides", shown("spd:gears:1", 128, "3"));
    assert_picture!("view_clip_hand", shown("hither_cut.nff", 128, "3."));
    assert_picture!("view_split", shown("star.nff", 128, "4"));
    assert_picture!("view_split_hand", shown("star.nff", 128, "4.."));
    assert_picture!("view_screen", shown("hither_cut.nff", 96, "5."));
}

#[test]
fn rasterizers_have_pictures_step_by_step() {
    assert_picture!("view_zbuffer", shown("depth_overlap.nff", 96, "6..."));
    assert_picture!("view_watkins", shown("depth_overlap.nff", 96, "rr6<home>>>>>"));
}

#[test]
fn maps_have_pictures() {
    for (key, name) in [("7", "depth"), ("8", "normals"), ("9", "overdraw"), ("0", "polygons")] {
        assert_picture!(&format!("view_{name}"), shown("depth_overlap.nff", 96, key));
    }
}

#[test]
fn overlays_have_pictures() {
    assert_picture!("view_edges", shown("depth_overlap.nff", 96, "e"));
    assert_picture!("view_lens", shown("depth_overlap.nff", 128, "<at:40,40>i-----"));
    assert_picture!("view_guide", shown("merge.sipp", 128, "nn"));
    let mut viewer = viewer("depth_overlap.nff", 128);
    viewer.draw();
    assert_picture!("view_text", viewer.board().picture());
    viewer.reload(Err("error: broken".to_string()));
    viewer.draw();
    assert_picture!("view_broken", viewer.board().picture());
}

#[test]
fn help_is_text_with_every_key() {
    insta::assert_snapshot!("view_help", keys::help(100).join("\n"));
}

/// Draws everything, but the last column of every polygon too.
struct Wide;

impl PolygonRasterizer for Wide {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (width, height) = (target.width(), target.height());
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let covers = |x: i32| coverage::covers(polygon.vertices(), polygon.grid(), x, y);
            if (covers(x) || covers(x - 1)) && polygon.depth(x, y) > target.depth(x, y) {
                target.put(shader.fragment(polygon, x, y));
            }
        }
    }
}

#[test]
fn yours_reference_and_difference_are_a_key_apart() {
    let wide = PerPolygon(Wide);
    let mut named = rasterizers();
    named.insert(0, ("wide".to_string(), &wide));
    let choices = Choices { size: Some((96, 96)), ..Choices::default() };
    let mut viewer = Viewer::new(scene("depth_overlap.nff"), &choices, named).expect("a camera");
    press(&mut viewer, "t");
    let yours = viewer.draw().clone();
    press(&mut viewer, "x");
    let reference = viewer.draw().clone();
    let rendered = render(&scene("depth_overlap.nff"), &choices, Some(&ZBuffer)).expect("a view");
    assert_eq!(reference, Board::of_picture(&rendered.image.encode(choices.encoding)));
    assert!(yours != reference);
    press(&mut viewer, "x");
    assert_picture!("view_difference", viewer.draw().picture());
    let differing = yours.pixels().iter().zip(reference.pixels()).filter(|(a, b)| a != b).count();
    assert!(told(&mut viewer, "").contains(&format!("{differing} of 9216 pixels differ")));
    // Watkins is right.
    assert!(told(&mut viewer, "rrr").contains("\n0 of 9216 pixels differ"));
    assert_eq!(viewer.state.compare, Compare::Difference);
}

#[test]
fn the_picture_is_that_of_render() {
    for (keys, shading, samples) in [("", Shading::Gouraud, 1), ("s", Shading::Flat, 1), ("ssa", Shading::Phong, 2)] {
        let mut viewer = viewer("spd:balls:1", 40);
        press(&mut viewer, &format!("t{keys}"));
        let choices = Choices { size: Some((40, 40)), shading, samples, ..Choices::default() };
        let rendered = render(&scene("spd:balls:1"), &choices, Some(&ZBuffer)).expect("a view");
        assert!(*viewer.draw() == Board::of_picture(&rendered.image.encode(choices.encoding)), "{keys}");
    }
}

#[test]
fn every_show_and_every_choice_gives_a_picture() {
    let mut viewer = viewer("glass.nff", 24);
    press(&mut viewer, "t");
    let mut pictures = std::collections::BTreeSet::new();
    for digit in "1234567890".chars() {
        for keys in ["", "s", "s", "s", "a", "b", "b", "g", "ggg", "r", "r", "x", "e", "i", "n", "n", "."] {
            press(&mut viewer, &format!("{digit}{keys}"));
            pictures.insert(viewer.draw().pixels().to_vec());
            assert_eq!(viewer.trouble(), None, "{digit} {keys}");
        }
    }
    assert!(pictures.len() > 60, "{}", pictures.len());
}

#[test]
fn the_inspector_says_what_why_says() {
    let mut viewer = viewer("coplanar.nff", 96);
    let text = told(&mut viewer, "<at:50,50>i");
    assert!(text.contains("equal depth: the first in the list keeps the sample"), "{text}");
    insta::assert_snapshot!("view_inspector", text);
    // The arrows go to the next pixel, and the pointer does not turn the camera meanwhile.
    let pose = viewer.state.eye.pose;
    assert!(told(&mut viewer, "<right><press><at:60,60><left><release>").contains("sample 59,60"));
    assert_eq!(viewer.state.eye.pose, pose);
}

#[test]
fn a_broken_scene_leaves_the_last_good_picture() {
    let mut viewer = viewer("star.nff", 200);
    press(&mut viewer, "t2s<left*3>");
    let good = viewer.draw().clone();
    let text = include_str!("../scenes/star.nff").replacen("hither 1", "hither one", 1);
    let error = farop::parse::read_nff("star.nff", text.as_bytes(), Default::default()).expect_err("broken");
    viewer.reload(Err(error.render(false)));
    viewer.draw();
    assert!(viewer.trouble().is_some_and(|trouble| trouble.contains("star.nff:8:8")), "{:?}", viewer.trouble());
    let rows = good.width() * 16;
    assert!(viewer.board().pixels() != good.pixels() && viewer.board().pixels()[..rows] == good.pixels()[..rows]);
    // A good one is taken, and the eye stays where it is.
    viewer.reload(Ok(scene("star.nff")));
    assert!(*viewer.draw() == good);
    let without_camera = farop::scene::Scene { camera: None, ..scene("star.nff") };
    viewer.reload(Ok(without_camera));
    viewer.draw();
    assert!(viewer.trouble().is_some_and(|trouble| trouble.contains("no view")), "{:?}", viewer.trouble());
}

#[test]
fn a_rasterizer_that_panics_does_not_close_the_window() {
    struct Panics;
    impl PolygonRasterizer for Panics {
        fn draw_polygon(&self, _: &ScreenPolygon<'_>, _: &Shader, _: &mut Target<'_>) {
            panic!("row 9 of 8");
        }
    }
    let panics = PerPolygon(Panics);
    let mut named = rasterizers();
    named.push(("panics".to_string(), &panics));
    let choices = Choices { size: Some((32, 32)), threads: Some(1), ..Choices::default() };
    let mut viewer = Viewer::new(scene("star.nff"), &choices, named).expect("a camera");
    press(&mut viewer, "t");
    let good = viewer.draw().clone();
    press(&mut viewer, "rrr");
    viewer.draw();
    assert!(viewer.trouble().is_some_and(|trouble| trouble.contains("row 9 of 8")), "{:?}", viewer.trouble());
    press(&mut viewer, "r");
    assert!(*viewer.draw() == good);
}

#[test]
fn every_key_of_the_help_does_something() {
    for (key, what) in keys::GROUPS.iter().flat_map(|group| group.1) {
        for word in key.split(' ').filter(|word| !["drag", "arrows"].contains(word)) {
            let word = if word.chars().count() > 1 { format!("<{word}>") } else { word.replace('<', "<lt>") };
            let changes = |state: &str| {
                let mut viewer = viewer("star.nff", 32);
                press(&mut viewer, state);
                let before = viewer.state.clone();
                let actions = press(&mut viewer, &word);
                viewer.state != before || !actions.is_empty()
            };
            // In one of two states every key has something to change.
            assert!(changes("5.....c<at:9,9><up>pp") || changes("2....."), "{word}: {what}");
        }
    }
    let quit = |keys: &str| press(&mut viewer("star.nff", 32), keys).contains(&Action::Quit);
    assert!(quit("q") && quit("<esc>") && !quit("h<esc>i<esc>"));
}

#[test]
fn capital_letters_go_back() {
    let mut viewer = viewer("star.nff", 32);
    let before = viewer.state.clone();
    press(&mut viewer, "sSaAbBrRgG");
    assert_eq!(viewer.state, before);
    press(&mut viewer, "sabrg");
    assert!(viewer.state.choices != before.choices && viewer.state.rasterizer == 1);
}

#[test]
fn sizes_and_pointers_out_of_range_are_held() {
    let mut viewer = viewer("star.nff", 32);
    for event in [Event::Size(0, 0), Event::Pointer(-5, 9_999), Event::Key(Key::Letter('i')), Event::Wheel(1e9)] {
        viewer.handle(&event);
        viewer.draw();
    }
    assert_eq!(viewer.state.size(), (16, 16));
    assert_eq!(viewer.state.inspected, Some((0, 15)));
    for keys in ["<size:50x20>", "i<wheel:-99>", "6<lt><lt>,", "<time:1e300>c<up*50><time:9>", "v"] {
        read_keys(keys).expect(keys).iter().for_each(|event| _ = viewer.handle(event));
        viewer.draw();
        assert_eq!(viewer.trouble(), None, "{keys}");
    }
    assert_eq!((viewer.board().width(), viewer.board().height()), (50, 20));
}
