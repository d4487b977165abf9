//! `farop why`: what a rasterizer drew at a pixel, whose color that is, which mistake explains it.

#[path = "support/command.rs"]
mod command;

use command::{Desk, project_scene};
use farop::grade::look::{Resembles, Sight, look};
use farop::image::Image;
use farop::plan::{Choices, Shading};
use farop::raster::{PerPolygon, PolygonRasterizer, Rasterizer, Target, Watkins, ZBuffer, coverage};
use farop::render::{self, Canvas};
use farop::screen::{DrawList, Fragment, ScreenPolygon, ScreenVertex, Shader};

const SIDE: u32 = 64;

fn scene_list() -> DrawList {
    let scene = std::fs::read(project_scene("depth_overlap.nff")).expect("a scene of the project");
    let parsed = farop::parse::read_nff("overlap.nff", &scene, farop::parse::ParseOptions::default()).expect("legal");
    let choices = Choices { size: Some((SIDE, SIDE)), shading: Shading::Gouraud, ..Choices::default() };
    render::list(&parsed.scene, &choices, None).expect("a list")
}

fn drawn(list: &DrawList, rasterizer: &dyn Rasterizer) -> Image {
    render::draw(list, Some(rasterizer), &Canvas::of_sheet(&farop::screen::file::Sheet::default())).0
}

/// What is seen at some of the samples that are wrong.
fn sights(list: &DrawList, rasterizer: &dyn Rasterizer) -> Vec<((i32, i32), Sight)> {
    let (wrong, right) = (drawn(list, rasterizer), drawn(list, &ZBuffer));
    let samples = (0..SIDE as i32).flat_map(|y| (0..SIDE as i32).map(move |x| (x, y)));
    // Each costs a hundred pictures: some must do.
    let differs = |&(x, y): &(i32, i32)| wrong.pixel(x as usize, y as usize) != right.pixel(x as usize, y as usize);
    let all: Vec<_> = samples.filter(differs).collect();
    let some = all.iter().copied().step_by(all.len() / 24 + 1);
    some.filter_map(|at| look(list, (&wrong, &right), [0.0; 3], at).map(|sight| (at, sight))).collect()
}

fn names(sight: &Sight) -> Vec<&'static str> {
    sight.mistakes.iter().map(|(mistake, _)| mistake.name).collect()
}

/// A z-buffer that looks for polygons a part of a sample beside the center, takes the farther one, or draws upside down.
struct Planted {
    shift: i32,
    far_wins: bool,
    upside_down: bool,
}

impl PolygonRasterizer for Planted {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        // Half a sample to the right and down is the same as asking at the corner.
        let offset = f64::from(self.shift) / 2.0;
        let move_one = |vertex: &ScreenVertex| ScreenVertex { x: vertex.x + offset, y: vertex.y + offset, ..*vertex };
        let moved: Vec<_> = polygon.vertices().iter().map(move_one).collect();
        let (width, height) = (target.width(), target.height());
        for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
            let row = if self.upside_down { target.height() - 1 - y } else { y };
            if !coverage::covers(&moved, polygon.grid(), x, y) {
                continue;
            }
            let (depth, kept) = (polygon.depth(x, y), target.depth(x, row));
            if if self.far_wins { kept == 0.0 || depth < kept } else { depth > kept } {
                target.put(Fragment { y: row, ..shader.fragment(polygon, x, y) });
            }
        }
    }
}

const NO_MISTAKE: Planted = Planted { shift: 0, far_wins: false, upside_down: false };

#[test]
fn where_nothing_is_wrong_nothing_is_seen() {
    let list = scene_list();
    assert!(sights(&list, &PerPolygon(NO_MISTAKE)).is_empty() && sights(&list, &Watkins).is_empty());
}

#[test]
fn samples_at_the_corner_are_named_from_one_pixel() {
    let list = scene_list();
    let all = sights(&list, &PerPolygon(Planted { shift: 1, ..NO_MISTAKE }));
    assert!(all.len() > 10, "{}", all.len());
    let named = all.iter().filter(|(_, sight)| names(sight).contains(&"samples at the corner")).count();
    assert!(named * 10 >= all.len() * 9, "{named} of {}", all.len());
    // Where the background shows instead of a polygon, and the other way round.
    assert!(all.iter().any(|(_, sight)| sight.resembles == Resembles::Background));
    assert!(all.iter().any(|(_, sight)| matches!(sight.resembles, Resembles::Beside(..))));
}

#[test]
fn the_far_polygon_in_front_is_named() {
    let list = scene_list();
    let all = sights(&list, &PerPolygon(Planted { far_wins: true, ..NO_MISTAKE }));
    let (_, sight) = all.first().expect("a wrong sample");
    assert!(matches!(sight.resembles, Resembles::Over(_)), "{sight:?}");
    let named = all.iter().filter(|(_, sight)| names(sight).contains(&"far wins")).count();
    assert!(named * 10 >= all.len() * 9, "{named} of {}: {:?}", all.len(), names(sight));
}

#[test]
fn an_upside_down_picture_is_seen_in_the_whole_of_it() {
    let list = scene_list();
    let all = sights(&list, &PerPolygon(Planted { upside_down: true, ..NO_MISTAKE }));
    assert!(!all.is_empty());
    assert!(all.iter().all(|(_, sight)| sight.is_whole && names(sight) == ["upside down"]), "{:?}", all[0]);
}

#[test]
fn the_command_takes_screen_files_and_tells_whose_color_it_is() {
    let desk = Desk::new();
    let scene = std::fs::read(project_scene("depth_overlap.nff")).expect("a scene of the project");
    desk.write("overlap.nff", scene);
    desk.done("dump overlap.nff --size 64 -o overlap.scr");
    // Of a file, as of a scene; only the places in the scene are unknown.
    let of_scene = desk.done("why overlap.nff --size 64 --pixel 32,32").text().to_string();
    let of_file = desk.done("why overlap.scr --pixel 32,32").text().to_string();
    let without_places: String = of_scene
        .lines()
        .map(|line| match line.split_once(", overlap.nff:") {
            Some((start, rest)) => format!("{start}:{}\n", rest.split_once(':').map_or("", |(_, rest)| rest)),
            None => format!("{line}\n"),
        })
        .collect();
    assert_eq!(of_file, without_places);
    assert_eq!(desk.run("why overlap.scr --pixel 64,0").code, 2);
    // Watkins is right: nothing is added.
    let watkins = desk.done("why overlap.scr --pixel 32,32 -r watkins");
    assert!(watkins.text().ends_with(of_file.lines().last().map(|line| format!("{line}\n")).as_deref().unwrap_or("")));
    assert!(!watkins.text().contains("it drew"));
}
