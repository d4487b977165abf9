//! What each historic choice costs, measured: `cargo run --release --example historic`.
//!
//! Prints; judges nothing. docs/historic.md quotes what it prints. Levels are of 8-bit pictures, the largest of a pixel's
//! three channels. Where times are compared, the candidates take turns run by run.

#[path = "../tests/support/mod.rs"]
mod support;

use farop::image::Picture;
use farop::math::{Vec3, cos, newell_normal, radians, sin, unit};
use farop::parse::{ParseOptions, Winding, read_nff};
use farop::plan::{
    Accepts, AngleSpan, Choices, ClipLight, Culling, FlatRule, Interpolation, Plan, Shading, Transparency,
};
use farop::raster::{ZBuffer, coverage};
use farop::render::render;
use farop::scene::{NormalSource, Scene};
use farop::screen::{DrawList, Grid};
use farop::spd::{self, Curves};
use support::half_planes::HalfPlanes;
use support::random::Random;

const SIDE: u32 = 512;

fn main() {
    table();
    integer_coordinates();
    relight_at_the_side();
    roll();
    winding();
    angle();
    time();
}

fn text_of(name: &str, size: u32) -> Vec<u8> {
    let mut text = Vec::new();
    spd::generate(spd::find(name).expect("a built-in scene"), size, Curves::Kept, &mut text).expect("memory takes it");
    text
}

fn read(name: &str, text: &[u8], options: ParseOptions) -> Scene {
    read_nff(name, text, options).expect("a legal scene").scene
}

fn built_in(name: &str, size: u32, options: ParseOptions) -> Scene {
    read(name, &text_of(name, size), options)
}

fn picture(scene: &Scene, choices: &Choices) -> Picture {
    render(scene, choices, Some(&ZBuffer)).expect("a usable view").image.encode(choices.encoding)
}

/// How two pictures differ: pixels, and the largest and mean difference of those, in levels.
fn difference(a: &Picture, b: &Picture) -> (usize, u32, f64) {
    let levels = a.colors().zip(b.colors()).map(|(a, b)| (0..3).map(|c| u32::from(a[c].abs_diff(b[c]))).max());
    let changed: Vec<u32> = levels.map(|level| level.unwrap_or(0)).filter(|&level| level > 0).collect();
    let mean = f64::from(changed.iter().sum::<u32>()) / changed.len().max(1) as f64;
    (changed.len(), changed.iter().copied().max().unwrap_or(0), mean)
}

/// The same scene with the camera turned about its axis.
fn rolled(scene: &Scene, degrees: f64) -> Scene {
    let mut scene = scene.clone();
    let camera = scene.camera.as_mut().expect("has a view");
    let forward = unit(camera.at - camera.from).expect("looks somewhere");
    let right = unit(forward.cross(camera.up)).expect("up is up");
    camera.up = right.cross(forward) * cos(radians(degrees)) + right * sin(radians(degrees));
    scene
}

/// The same scene from so near that the sides of the picture cut it.
fn close_up(scene: &Scene, share: f64) -> Scene {
    let mut scene = scene.clone();
    let camera = scene.camera.as_mut().expect("has a view");
    camera.from = camera.at + (camera.from - camera.at) * share;
    scene
}

// 1. Every switch against the default.

fn scenes(options: ParseOptions) -> Vec<(&'static str, Scene)> {
    let (gears, teapot) = (built_in("gears", 4, options), built_in("teapot", 6, options));
    let (rolled, close) = (rolled(&gears, 30.0), close_up(&teapot, 0.35));
    let mount = built_in("mount", 6, options);
    vec![("gears", gears), ("gears, rolled 30", rolled), ("teapot", teapot), ("teapot, close", close), ("mount", mount)]
}

fn table() {
    println!("each switch against the default, {SIDE} x {SIDE}; max and mean (of pixels that differ) in levels\n");
    println!("{:<26} {:<17} {:>8} {:>7} {:>4} {:>6}", "switch", "scene", "pixels", "share", "max", "mean");
    let (gouraud, flat) = (base(), Choices { shading: Shading::Flat, ..base() });
    let rows: [(&str, &Choices, Choices); 8] = [
        ("--subpixel-bits 0", &gouraud, Choices { subpixel_bits: 0, ..base() }),
        ("--clip-light relight", &gouraud, Choices { clip_light: ClipLight::Relight, ..base() }),
        ("--interpolation screen", &gouraud, Choices { interpolation: Interpolation::Screen, ..base() }),
        ("--interpolation scanline", &gouraud, Choices { interpolation: Interpolation::ScanLine, ..base() }),
        ("--flat sipp", &flat, Choices { flat: FlatRule::Sipp, ..flat.clone() }),
        ("--transparency additive", &gouraud, Choices { transparency: Transparency::Additive, ..base() }),
        ("--culling nff", &gouraud, Choices { culling: Culling::Nff, ..base() }),
        ("--angle centers", &gouraud, Choices { angle: AngleSpan::Centers, ..base() }),
    ];
    let facet = scenes(ParseOptions::default());
    for (name, without, with) in &rows {
        for (of, scene) in &facet {
            row(name, of, &picture(scene, without), &picture(scene, with));
        }
    }
    let linear = Choices { encoding: farop::color::Encoding::Linear, ..base() };
    for (of, scene) in &facet {
        row("--encoding linear", of, &picture(scene, &gouraud), &picture(scene, &linear));
    }
    let smooth = scenes(ParseOptions { polygon_normals: NormalSource::Averaged, ..ParseOptions::default() });
    for ((of, facet), (_, smooth)) in facet.iter().zip(&smooth) {
        row("--normals smooth", of, &picture(facet, &gouraud), &picture(smooth, &gouraud));
    }
    // The corners of smooth gears have many values: here n-gons are interpolated.
    let scan_line = Choices { interpolation: Interpolation::ScanLine, ..base() };
    for (of, smooth) in &smooth[..2] {
        row("scanline, normals smooth", of, &picture(smooth, &gouraud), &picture(smooth, &scan_line));
    }
    println!("\nto see");
    TO_SEE.iter().for_each(|line| println!("{line}"));
}

/// What to look for, a line a switch.
const TO_SEE: [&str; 10] = [
    "--subpixel-bits 0         ragged edges; teeth of different widths",
    "--clip-light relight      colors of polygons at the border, which move when the border does",
    "--interpolation screen    highlights a little too near, largest on floors",
    "--interpolation scanline  horizontal streaks across polygons with many corners; other ones after a roll",
    "--flat sipp               two colors in what should be one plane; faces that lean towards their neighbors",
    "--transparency additive   layers of glass too dense where they lie over each other",
    "--culling nff             the far sides of glass",
    "--angle centers           edges half a pixel nearer to the middle, at the border",
    "--encoding linear         everything between black and white too dark",
    "--normals smooth          cushions: flat faces that bend at their rims",
];

fn base() -> Choices {
    Choices { size: Some((SIDE, SIDE)), threads: Some(1), ..Choices::default() }
}

fn row(name: &str, scene: &str, without: &Picture, with: &Picture) {
    let (pixels, max, mean) = difference(without, with);
    let share = 100.0 * pixels as f64 / (without.width() * without.height()) as f64;
    println!("{name:<26} {scene:<17} {pixels:>8} {share:>6.2}% {max:>4} {mean:>6.2}");
}

// 2. Integer screen coordinates against exact coverage.

/// Grid on which random corners are exact.
const FINE: u32 = 16;

fn integer_coordinates() {
    println!("\n3,000 random triangles, a third of them within 6 pixels, against coverage of the exact corners");
    println!("{:>4} {:>12} {:>8} {:>8} {:>10}", "bits", "edge pixels", "wrong", "share", "lost");
    for bits in [0, 2, 4, 6, 8] {
        let mut random = Random::new(1996);
        let (mut pixels, mut wrong, mut lost) = (0, 0, 0);
        for number in 0..3000 {
            let reach = if number % 3 == 0 { 6.0 } else { 100.0 };
            let corners = [(); 3].map(|()| (random.between(10.0, 10.0 + reach), random.between(10.0, 10.0 + reach)));
            let fine = corners.map(|(x, y)| (Grid { bits: FINE }.snap(x), Grid { bits: FINE }.snap(y)));
            let found = judge(fine, bits);
            (pixels, wrong, lost) = (pixels + found.0, wrong + found.1, lost + u32::from(found.2));
        }
        let share = 100.0 * f64::from(wrong) / f64::from(pixels);
        println!("{bits:>4} {pixels:>12} {wrong:>8} {share:>7.3}% {:>9.2}%", f64::from(lost) / 30.0);
    }
}

/// Pixels along the edges, how many of them are decided wrongly, and whether the triangle vanished or turned round.
fn judge(corners: [(f64, f64); 3], bits: u32) -> (u32, u32, bool) {
    let half_steps = |v: f64| (v * f64::from(1 << (FINE + 1))) as i64;
    let exact = HalfPlanes::new(corners.map(|(x, y)| (half_steps(x), half_steps(y))), 1 << FINE);
    let mut list = DrawList::new(128, 128);
    list.grid = Grid { bits };
    list.push_flat(&corners, 1.0, [1.0; 3]);
    let polygon = list.polygon(0);
    let (mut pixels, mut wrong) = (0, 0);
    for y in 8..112 {
        for x in 8..112 {
            if is_near_outline(&corners, (f64::from(x) + 0.5, f64::from(y) + 0.5)) {
                pixels += 1;
                let drawn = coverage::covers(polygon.vertices(), list.grid, x, y);
                wrong += u32::from(drawn != exact.covers(x, y));
            }
        }
    }
    let snapped: Vec<_> = polygon.vertices().iter().map(|v| (v.x, v.y)).collect();
    (pixels, wrong, area(&snapped) * area(&corners) <= 0.0)
}

fn area(c: &[(f64, f64)]) -> f64 {
    (c[1].0 - c[0].0) * (c[2].1 - c[0].1) - (c[1].1 - c[0].1) * (c[2].0 - c[0].0)
}

/// Whether a pixel's center is within half a pixel of an edge.
fn is_near_outline(corners: &[(f64, f64); 3], (x, y): (f64, f64)) -> bool {
    (0..3).any(|from| {
        let (a, b) = (corners[from], corners[(from + 1) % 3]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let along = ((x - a.0) * dx + (y - a.1) * dy) / (dx * dx + dy * dy);
        let along = along.clamp(0.0, 1.0);
        let (off_x, off_y) = (x - a.0 - along * dx, y - a.1 - along * dy);
        off_x * off_x + off_y * off_y < 0.25
    })
}

// 3. Light after clipping: the side of the picture slides over a triangle.

/// scenes/cut_fan.nff with the Kd, Ks and power of `shine`.
fn fan(shine: &str) -> Scene {
    let text = include_str!("../scenes/cut_fan.nff").replace("0.2 0.8 10", shine);
    read("fan", text.as_bytes(), ParseOptions::default())
}

fn relight_at_the_side() {
    println!(
        "\nthe right side of the picture cuts a triangle and moves in by 1 pixel a step, from 256 to 128 pixels wide,"
    );
    println!("the eye stays. Change of a pixel that stays in view, in levels:");
    println!("{:<24} {:<14} {:>12} {:>14}", "surface", "clip light", "max a step", "max in all");
    for (name, shine) in [("Kd .8", "0.8 0 1"), ("Ks .8, power 1", "0.2 0.8 1"), ("Ks .8, power 10", "0.2 0.8 10")] {
        for clip_light in [ClipLight::Interpolate, ClipLight::Relight] {
            let scene = fan(shine);
            let wide = |width| {
                picture(
                    &scene,
                    &Choices { size: Some((width, 128)), clip_light, threads: Some(1), ..Choices::default() },
                )
            };
            let (mut step, mut all) = (0, 0);
            let first = wide(256);
            let mut before = first.clone();
            for width in (128..256).step_by(2).rev() {
                let now = wide(width);
                step = step.max(change(&before, &now));
                all = all.max(change(&first, &now));
                before = now;
            }
            println!("{name:<24} {:<14} {step:>12} {all:>14}", clip_light.name());
        }
    }
}

/// The largest change between two pictures of the same height around the same middle.
fn change(wide: &Picture, narrow: &Picture) -> u8 {
    let shift = (wide.width() - narrow.width()) / 2;
    let pixels = (0..narrow.height()).flat_map(|y| (0..narrow.width()).map(move |x| (x, y)));
    let of = |(x, y)| {
        let (a, b): ([u8; 3], [u8; 3]) = (wide.pixel(x + shift, y), narrow.pixel(x, y));
        (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0)
    };
    pixels.map(of).max().unwrap_or(0)
}

// 4. Interpolation while the camera rolls.

/// A kite seen at a slant whose corners are bright and dark in turn.
fn kite() -> Scene {
    read("kite", include_bytes!("../scenes/slanted_kite.nff"), ParseOptions::default())
}

fn roll() {
    println!(
        "\na slanted kite, corners bright and dark in turn; the camera rolls. Levels, {SIDE} x {SIDE}, linear encoding:"
    );
    println!(
        "to itself upright: the same point, the picture turned back (nearest pixel, so 1 or 2 levels mean nothing)"
    );
    println!("{:<12} {:>5} {:>19} {:>26}", "values run", "roll", "to itself upright", "to perspective, same roll");
    for interpolation in [Interpolation::Perspective, Interpolation::Screen, Interpolation::ScanLine] {
        for degrees in [0.0, 15.0, 30.0, 45.0] {
            let (ambient, light_intensity) = (Some(0.05), Some(0.95));
            let linear = Choices { encoding: farop::color::Encoding::Linear, ambient, light_intensity, ..base() };
            let choices = Choices { interpolation, ..linear.clone() };
            let (upright, turned) = (picture(&kite(), &choices), picture(&rolled(&kite(), degrees), &choices));
            let reference = picture(&rolled(&kite(), degrees), &linear);
            let (own_max, own_mean) = turned_back(&upright, &turned, degrees);
            let (_, max, mean) = difference(&reference, &turned);
            println!("{:<12} {degrees:>5} {own_max:>11} {own_mean:>7.2} {max:>17} {mean:>8.2}", interpolation.name());
        }
    }
}

/// Largest and mean difference of pixels that show the kite in both pictures, `turned` turned back by `degrees`.
fn turned_back(upright: &Picture, turned: &Picture, degrees: f64) -> (u8, f64) {
    let (c, s, half) = (cos(radians(degrees)), sin(radians(degrees)), f64::from(SIDE) / 2.0);
    let (mut max, mut sum, mut count) = (0, 0.0, 0.0);
    for y in 0..SIDE as usize {
        for x in 0..SIDE as usize {
            let (dx, dy) = (x as f64 + 0.5 - half, y as f64 + 0.5 - half);
            // Up turned to the right: the picture turns to the left, counterclockwise.
            let (from_x, from_y) = (half + c * dx + s * dy, half - s * dx + c * dy);
            let inside = |v: f64| (0.0..f64::from(SIDE)).contains(&v).then_some(v as usize);
            let (Some(from_x), Some(from_y)) = (inside(from_x), inside(from_y)) else { continue };
            let (a, b) = (upright.pixel(x, y)[1], turned.pixel(from_x, from_y)[1]);
            // The kite's ambient light is above 0, the background is 0.
            if a > 0 && b > 0 {
                let level = a.abs_diff(b);
                (max, sum, count) = (max.max(level), sum + f64::from(level), count + 1.0);
            }
        }
    }
    (max, sum / f64::max(count, 1.0))
}

// 5. Winding of nurbtst, angle, time.

fn winding() {
    println!("\nnurbtst: polygons whose Newell normal opposes the mean of their vertex normals");
    println!("{:<16} {:>9} {:>9} {:>9} {:>9}", "winding", "polygons", "wrong", "culled", "rendered");
    for (name, winding) in [("file", Winding::File), ("auto", Winding::Auto)] {
        let scene = built_in("nurbtst", 6, ParseOptions { winding, ..ParseOptions::default() });
        let (mut polygons, mut wrong) = (0, 0);
        for mesh in scene.surfaces.iter().map(|surface| &surface.mesh) {
            for polygon in mesh.polygons.iter().filter(|polygon| polygon.normals == NormalSource::Given) {
                let outline = mesh.outline(polygon);
                let corners: Vec<Vec3> = outline.iter().map(|&i| mesh.vertices[i as usize]).collect();
                let mean: Vec3 = outline.iter().map(|&i| mesh.normals[i as usize]).sum();
                polygons += 1;
                wrong += u32::from(newell_normal(&corners).dot(mean) < 0.0);
            }
        }
        let counts = render(&scene, &base(), None).expect("a usable view").counts;
        println!("{name:<16} {polygons:>9} {wrong:>9} {:>9} {:>9}", counts.backfacing, counts.rendered);
    }
}

fn angle() {
    println!("\nangle centers: how far a point moves towards the middle of the picture, in pixels");
    println!("{:>6} {:>10} {:>10} {:>10}", "size", "middle", "halfway", "border");
    let scene = built_in("gears", 4, ParseOptions::default());
    for side in [16, 128, 512, 1024] {
        let scale = |angle| {
            let choices = Choices { size: Some((side, side)), angle, ..Choices::default() };
            Plan::new(&scene, &choices, Accepts::AnyPolygon).expect("a usable view").view.scale
        };
        let shrink = 1.0 - scale(AngleSpan::Centers) / scale(AngleSpan::Edges);
        let at = |share: f64| share * f64::from(side) / 2.0 * shrink;
        println!("{side:>6} {:>10.4} {:>10.4} {:>10.4}", at(0.0), at(0.5), at(1.0));
    }
}

fn time() {
    println!(
        "\ntime, gears with smooth normals at {SIDE} x {SIDE}, one thread: median of 9 interleaved runs, milliseconds"
    );
    let smooth = ParseOptions { polygon_normals: NormalSource::Averaged, ..ParseOptions::default() };
    let scene = built_in("gears", 4, smooth);
    let all = [Interpolation::Perspective, Interpolation::Screen, Interpolation::ScanLine];
    let mut times = [const { Vec::new() }; 3];
    for round in 0..10 {
        for (interpolation, times) in all.into_iter().zip(&mut times) {
            let choices = Choices { interpolation, ..base() };
            let taken = render(&scene, &choices, Some(&ZBuffer)).expect("a usable view").times;
            // The first round warms up.
            times.extend((round > 0).then_some((taken.geometry.elapsed, taken.raster.elapsed)));
        }
    }
    for (interpolation, mut times) in all.into_iter().zip(times) {
        times.sort_by(|a, b| (a.0 + a.1).total_cmp(&(b.0 + b.1)));
        let (geometry, raster) = times[times.len() / 2];
        println!("{:<12} geometry {geometry:>7.1}  raster {raster:>7.1}", interpolation.name());
    }
}
