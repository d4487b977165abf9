//! Fuzz: what is read, cut, split and drawn may be anything; nothing may panic, and no picture holds a color that is no number.
//!
//! Eight targets take turns: scene texts (NFF and `.sipp`), Bezier files, screen files of both kinds, cutting, splitting, drawing lists, and
//! whole pictures of mangled scenes. Texts are legal ones, mangled ([`super::fuzz_texts`]); what is said about them is written out, too,
//! for messages quote the text. The same seed gives the same executions; a panic is caught and is a miss with its number and words.
//!
//! Source: B. Miller, L. Fredriksen, B. So, "An Empirical Study of the Reliability of UNIX Utilities", CACM 33(12), 1990.

use super::fuzz_texts::{CURVES, SCENE, TREE, mangled, screen_text};
use super::scenes::{AREA_RASTERIZERS, draw};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::color::Rgb;
use crate::diagnostic::Diagnostics;
use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper};
use crate::geometry::split::{SplitScratch, split};
use crate::image::Image;
use crate::math::Vec3;
use crate::parse::{BezierNet, Format, ParseOptions, Parsed, read_bezier, read_ftri, read_nff, read_sipp};
use crate::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use crate::render::{self, Canvas, render};
use crate::scene::Primitive;
use crate::screen::file::{ReadOptions, read};
use crate::screen::{DrawList, Grid, Plane};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// One kind of execution; returns how many colors or coordinates are not numbers, and how many indices point nowhere.
type Target = (&'static str, fn(&mut Random, &mut Tally) -> u64);

const TARGETS: [Target; 8] = [
    ("scene texts read", scene_text),
    ("trees of objects read", tree_text),
    ("Bezier files read", curves_text),
    ("screen files read", screen_file),
    ("polygons cut", cut),
    ("outlines split", split_outline),
    ("lists drawn", wild_list),
    ("scenes drawn", picture),
];

/// Executes every target in turn.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    // Fewer than this, and no mangled file is still legal.
    let executions = effort.count(60_000, 6_000_000).max(3_000);
    let tally = sum(executions, |number, tally| execute(number, &mut effort.random(number), tally));
    report.count("executions", executions);
    TARGETS.iter().for_each(|(name, _)| report.some(*name, tally.of(name)));
    report.some("of the texts, still legal", tally.of("legal texts"));
    report.some("of the trees, still legal", tally.of("legal trees"));
    report.some("of the Bezier files, still legal", tally.of("legal curves"));
    report.some("of the screen files, still legal", tally.of("legal files"));
    report.some("of the polygons, cut to something", tally.of("cut to something"));
    report.some("of the scenes, with a picture", tally.of("pictures"));
    report.none("panics", tally.of("panics"));
    report.none("colors and coordinates that are not numbers, indices that point nowhere", tally.of("not numbers"));
    tally.examples.iter().for_each(|example| report.miss(example));
}

fn execute(number: u64, random: &mut Random, tally: &mut Tally) {
    let (name, target) = TARGETS[(number % TARGETS.len() as u64) as usize];
    tally.add(name, 1);
    // After a panic the counts may lack some, which the panic's own count outweighs.
    match catch_unwind(AssertUnwindSafe(|| target(random, tally))) {
        Ok(0) => {}
        Ok(not_numbers) => {
            tally.add("not numbers", not_numbers);
            tally.example(|| format!("execution {number}, {name}: {not_numbers} are not numbers or point nowhere"));
        }
        Err(cause) => {
            tally.add("panics", 1);
            tally.example(|| format!("execution {number}, {name}: panics, {}", words_of(&*cause)));
        }
    }
}

/// What a panic said.
fn words_of(cause: &(dyn std::any::Any + Send)) -> &str {
    let text = cause.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| cause.downcast_ref::<&str>().copied()).unwrap_or("without a word")
}

/// The scene in a text; what is wrong with it, or remarkable, is put into words as users see it.
fn scene_of(text: &[u8], format: Format) -> Option<Parsed> {
    let read = match format {
        Format::Nff => read_nff("fuzz", text, ParseOptions::default()),
        Format::Sipp => read_sipp("fuzz", text, ParseOptions::default()),
        Format::Ftri => read_ftri("fuzz", text),
        // Their own tests mangle them: tests/fcell_errors.rs, forest::pack.
        Format::Fcell | Format::Fpack => return None,
    };
    match read {
        Ok(parsed) => {
            put_into_words(&parsed.notices);
            Some(parsed)
        }
        Err(mistakes) => {
            put_into_words(&mistakes);
            None
        }
    }
}

/// In color, without, and on one line: all quote the text.
fn put_into_words(said: &Diagnostics) {
    drop((said.render(true), said.render(false), said.to_string()));
}

fn scene_text(random: &mut Random, tally: &mut Tally) -> u64 {
    let Some(parsed) = scene_of(&mangled(SCENE, random), Format::Nff) else { return 0 };
    tally.add("legal texts", 1);
    let vertices = parsed.scene.surfaces.iter().flat_map(|surface| &surface.mesh.vertices);
    vertices.filter(|vertex| !vertex.is_finite()).count() as u64
}

fn tree_text(random: &mut Random, tally: &mut Tally) -> u64 {
    let Some(parsed) = scene_of(&mangled(TREE, random), Format::Sipp) else { return 0 };
    tally.add("legal trees", 1);
    let transforms = parsed.scene.objects.iter().map(|object| object.parent_from_local);
    transforms.filter(|transform| transform.is_nan()).count() as u64
}

fn curves_text(random: &mut Random, tally: &mut Tally) -> u64 {
    match read_bezier("fuzz", &mangled(CURVES, random)) {
        Ok(BezierNet::Curves(net)) => {
            tally.add("legal curves", 1);
            net.curves.iter().flatten().filter(|&&index| index as usize >= net.vertices.len()).count() as u64
        }
        Ok(BezierNet::Patches(net)) => {
            tally.add("legal curves", 1);
            net.patches.iter().flatten().filter(|&&index| index as usize >= net.vertices.len()).count() as u64
        }
        Err(mistakes) => {
            put_into_words(&mistakes);
            0
        }
    }
}

fn picture(random: &mut Random, tally: &mut Tally) -> u64 {
    let (text, format) = if random.once_in(3) { (TREE, Format::Sipp) } else { (SCENE, Format::Nff) };
    let Some(parsed) = scene_of(&mangled(text, random), format) else { return 0 };
    let scene = parsed.into_scene();
    // A shape of a million polygons takes time and shows nothing new.
    let finest = |shape: &Primitive| shape.resolution.map_or(0, |[a, b]| a.max(b));
    if scene.surfaces.iter().flat_map(|surface| &surface.primitives).any(|shape| finest(shape) > 64) {
        return 0;
    }
    let choices = Choices {
        size: Some((1 + random.below(24) as u32, 1 + random.below(24) as u32)),
        shading: [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wire][random.below(4) as usize],
        culling: [Culling::Back, Culling::Nff, Culling::None][random.below(3) as usize],
        depth: [DepthFormat::F32, DepthFormat::F64, DepthFormat::Int24, DepthFormat::Int16][random.below(4) as usize],
        subpixel_bits: random.below(17) as u32,
        resolution: Some(1 + random.below(4) as u32),
        triangles: random.once_in(2),
        threads: Some(1),
        ..Choices::default()
    };
    let rasterizer = AREA_RASTERIZERS[random.below(3) as usize].1;
    let Ok(rendered) = render(&scene, &choices, Some(rasterizer)) else { return 0 };
    tally.add("pictures", 1);
    nans(&rendered.image)
}

fn screen_file(random: &mut Random, tally: &mut Tally) -> u64 {
    let text = screen_text(random);
    let text = mangled(&text, random);
    let options = ReadOptions { max_pixels: 10_000, ..ReadOptions::default() };
    let file = match read(&String::from_utf8_lossy(&text), &options) {
        Ok(file) => file,
        Err(mistake) => {
            drop(mistake.to_string());
            return 0;
        }
    };
    tally.add("legal files", 1);
    if u64::from(file.list.width) * u64::from(file.list.height) > 1 << 16 {
        return 0;
    }
    draw(&file.list, AREA_RASTERIZERS[random.below(3) as usize].1, 1);
    file.list.vertices.iter().filter(|vertex| !(vertex.x.is_finite() && vertex.y.is_finite())).count() as u64
}

/// A number of any size, seldom none at all.
fn wild(random: &mut Random) -> f64 {
    let sizes = [0.0, -0.0, 1.0, -1.0, 5e-324, 1e-300, 1e-30, 3.5, 1e6, 1e30, 1e300, f64::MAX];
    match random.below(64) {
        0 => f64::from_bits(random.bits()),
        1..=20 => sizes[random.below(12) as usize] * if random.once_in(2) { 1.0 } else { -1.0 },
        _ => random.between(-4.0, 4.0),
    }
}

fn wild_points(random: &mut Random) -> Vec<Vec3> {
    let count = random.below(12);
    let mut points: Vec<Vec3> = (0..count).map(|_| Vec3::new(wild(random), wild(random), wild(random))).collect();
    if random.once_in(4) {
        points.extend(points.clone());
    }
    points
}

fn cut(random: &mut Random, tally: &mut Tally) -> u64 {
    let volume =
        ClipVolume { hither: wild(random).abs().max(1e-300), yon: random.once_in(2).then(|| wild(random).abs()) };
    let polygon: Vec<ClipVertex> = wild_points(random)
        .into_iter()
        .map(|position| ClipVertex { position, attributes: [0.5; 8], ..ClipVertex::default() })
        .collect();
    let mut clipper = Clipper::default();
    let Clipped::Cut(left) = clipper.clip(&polygon, &volume, 8) else { return 0 };
    tally.add("cut to something", 1);
    let is_number = |v: &&ClipVertex| v.position.is_finite() && v.attributes.iter().all(|value| value.is_finite());
    left.iter().filter(|vertex| !is_number(vertex)).count() as u64
}

fn split_outline(random: &mut Random, _: &mut Tally) -> u64 {
    let outline = wild_points(random);
    let normal = Vec3::new(wild(random), wild(random), wild(random));
    let mut triangles = Vec::new();
    split(&outline, normal, &mut SplitScratch::default(), &mut triangles);
    // As many triangles as promised, over corners that there are.
    let corners = triangles.iter().flatten().filter(|&&corner| corner as usize >= outline.len());
    corners.count() as u64 + triangles.len().abs_diff(outline.len().saturating_sub(2)) as u64
}

/// Polygons on the grid, in the picture or not, over planes of wild coefficients.
fn wild_list(random: &mut Random, _: &mut Tally) -> u64 {
    let mut list = DrawList::new(1 + random.below(20) as u32, 1 + random.below(20) as u32);
    list.grid = Grid { bits: random.below(17) as u32 };
    for _ in 0..random.below(5) {
        let mut along = |end: u32| random.between(-2.0, f64::from(end) + 2.0);
        let corners: Vec<_> = (0..3).map(|_| (along(list.width), along(list.height))).collect();
        list.push_flat(&corners, 1.0, [0.5; 3]);
        let first = list.polygons[list.len() - 1].first_plane as usize;
        for plane in &mut list.planes[first..] {
            // As steep as `f32` can carry; the geometry stage keeps planes that are not finite out of lists.
            let mut finite = || Some(wild(random)).filter(|x| x.abs() <= 1e36).unwrap_or(1.0);
            let coefficients = [finite(), finite(), finite()];
            // A broken screen file may hold a range upside down.
            let range = if random.once_in(8) { (1.0, 0.25) } else { (0.25, 1.0) };
            *plane = Plane::new(coefficients, range, range, list.precision);
        }
    }
    let mut not_numbers = 0;
    for (_, rasterizer) in AREA_RASTERIZERS {
        let canvas = Canvas { samples: 1, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };
        let (image, _) = render::draw(&list, Some(rasterizer), &canvas);
        not_numbers += nans(&image);
    }
    not_numbers
}

fn nans(image: &Image) -> u64 {
    image.pixels().iter().filter(|light| light.to_array().iter().any(|channel| channel.is_nan())).count() as u64
}
