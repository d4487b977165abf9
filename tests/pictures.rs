//! Golden pictures: every scene of `scenes/`, and built-in scenes at 128 x 128. Written by the reference path alone.

mod support;

use farop::parse::{Format, ParseOptions, load};
use farop::plan::{Choices, Culling, Shading};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::render;
use farop::scene::Scene;
use farop::snapshot::assert_picture;
use farop::spd::Curves;
use std::path::Path;
use support::built_in::built_in;

fn picture(scene: &Scene, choices: &Choices) -> farop::image::Picture {
    let rasterizer: &dyn Rasterizer = if choices.shading == Shading::Wire { &PerPolygon(Wire) } else { &ZBuffer };
    let rendered = render(scene, choices, Some(rasterizer)).unwrap_or_else(|error| panic!("{error}"));
    rendered.image.encode(choices.encoding)
}

#[test]
fn scenes_of_the_project() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let entries = std::fs::read_dir(&folder).expect("scenes are part of the project").flatten();
    let mut files: Vec<_> = entries.map(|entry| entry.path()).filter(|path| Format::of_path(path).is_some()).collect();
    files.sort();
    assert!(files.len() >= 22);
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a scene is text");
        assert!(text.starts_with("# ") && text.contains("To see:"), "{} says what it shows", file.display());
        let is_sipp = Format::of_path(&file) == Some(Format::Sipp);
        let is_area = Format::of_path(&file) == Some(Format::Fcell);
        let most = if is_area { 99 } else { 30 + 10 * usize::from(is_sipp) };
        assert!(text.lines().count() <= most, "{} is short", file.display());
        let parsed = load(&file, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}"));
        let name = file.file_stem().expect("a name").to_string_lossy().into_owned();
        // An import leaves lights and camera out, and says so; an area says how many trees it has.
        assert_eq!(parsed.notices.list.len(), usize::from(name == "merge" || is_area), "{}", parsed.notices);
        // SIPP's own demonstrations are drawn so.
        let shading = if is_sipp { Shading::Phong } else { Choices::default().shading };
        let prefix = if is_sipp { "scene_sipp" } else { "scene" };
        assert_picture!(
            &format!("{prefix}_{name}"),
            picture(
                &parsed.into_scene(),
                &Choices { shading, size: is_area.then_some((128, 96)), ..Choices::default() }
            )
        );
    }
}

const GOLDEN: [(&str, u32); 10] = [
    ("balls", 2),
    ("gears", 4),
    ("lattice", 2),
    ("mount", 6),
    ("rings", 2),
    ("shells", 1),
    ("sombrero", 1),
    ("teapot", 6),
    ("tetra", 5),
    ("tree", 7),
];

#[test]
fn built_in_scenes() {
    for (name, size) in GOLDEN {
        let scene = built_in(name, size, Curves::Kept);
        // The teapot is an open sheet.
        let culling = if name == "teapot" { Culling::None } else { Culling::Back };
        let choices = Choices { size: Some((128, 128)), culling, ..Choices::default() };
        assert_picture!(&format!("spd_{name}"), picture(&scene, &choices));
    }
}

#[test]
fn four_shadings_of_the_teapot() {
    let scene = built_in("teapot", 6, Curves::Kept);
    for &shading in Shading::ALL {
        let choices = Choices { size: Some((128, 96)), shading, culling: Culling::None, ..Choices::default() };
        assert_picture!(&format!("teapot_{}", shading.name()), picture(&scene, &choices));
    }
}

#[test]
fn the_teapot_cut_by_the_view_volume() {
    let mut scene = built_in("teapot", 6, Curves::Kept);
    let camera = scene.camera.as_mut().expect("the scene has a view");
    (camera.angle, camera.hither) = (26.0, 9.5);
    let choices = Choices { size: Some((128, 128)), culling: Culling::None, ..Choices::default() };
    assert_picture!("teapot_cut", picture(&scene, &choices));
}

#[test]
fn supersampled_balls() {
    let scene = built_in("balls", 2, Curves::Kept);
    let choices = Choices { size: Some((96, 96)), samples: 4, shading: Shading::Phong, ..Choices::default() };
    assert_picture!("balls_4x4_phong", picture(&scene, &choices));
}

#[test]
fn the_last_row_and_column_are_not_empty() {
    // A floor that fills the picture, under both readings of NFF's angle.
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/side_cut.nff");
    let scene = load(&folder, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene;
    for &angle in farop::plan::AngleSpan::ALL {
        let drawn = picture(&scene, &Choices { angle, ..Choices::default() });
        let (last_x, last_y) = (drawn.width() - 1, drawn.height() - 1);
        let sky = drawn.pixel(0, 0);
        assert!(drawn.pixel(last_x, last_y) != sky && drawn.pixel(0, last_y) != sky, "{}", angle.name());
    }
}
