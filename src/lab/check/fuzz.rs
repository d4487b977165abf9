//! Fuzz: what is read, cut, split and drawn may be anything; nothing may panic, and no picture holds a color that is no number.
//!
//! Seven targets take turns: scene texts (legal NFF and `.sipp`, mangled), screen files (legal, mangled), cutting, splitting, drawing lists, and
//! whole pictures of mangled scenes. A legal text is mangled by bytes changed, dropped, repeated, and by words replaced
//! with numbers that hurt. The same seed gives the same executions; a panic is caught and is a miss with its number.
//!
//! Source: B. Miller, L. Fredriksen, B. So, "An Empirical Study of the Reliability of UNIX Utilities", CACM 33(12), 1990.

use super::scenes::{AREA_RASTERIZERS, draw};
use super::tally::{Tally, sum};
use super::{Effort, Random, Report};
use crate::color::Rgb;
use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, Clipper};
use crate::geometry::split::{SplitScratch, split};
use crate::image::Image;
use crate::math::Vec3;
use crate::parse::{ParseOptions, read_nff, read_sipp};
use crate::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use crate::render::{self, Canvas, render};
use crate::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use crate::screen::{DrawList, Grid, Plane};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// One kind of execution; returns how many colors or coordinates are not numbers.
type Target = (&'static str, fn(&mut Random, &mut Tally) -> u64);

const TARGETS: [Target; 7] = [
    ("scene texts read", scene_text),
    ("trees of objects read", tree_text),
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
    report.some("of the screen files, still legal", tally.of("legal files"));
    report.some("of the polygons, cut to something", tally.of("cut to something"));
    report.some("of the scenes, with a picture", tally.of("pictures"));
    report.none("panics", tally.of("panics"));
    report.none("colors and coordinates that are not numbers", tally.of("not numbers"));
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
            tally.example(|| format!("execution {number}, {name}: {not_numbers} are not numbers"));
        }
        Err(_) => {
            tally.add("panics", 1);
            tally.example(|| format!("execution {number}, {name}: panics"));
        }
    }
}

const SCENE: &str = "v\nfrom 0 0 -5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 24 16\nb .1 .2 .3\nl 4 5 -3\n\
    f 1 .5 .2 .7 .3 8 0 1\np 4\n-1 -1 0\n1 -1 0\n1 1 .5\n-1 1 .5\nf .2 .9 .4 .8 .1 3 .5 1\n\
    pp 3\n-2 0 1 0 0 -1\n0 2 1 0 .6 -.8\n2 0 1 .6 0 -.8\ns 0 0 1 .5\nc\n0 -1 0 .3\n0 1 0 .1\n\
    p 6\n0 0 -1\n2 0 -1\n2 1 -1\n1 .2 -1\n.5 1 -1\n0 1 -1\n";

const TREE: &str = "shader s phong { ambient .3 diffuse .6 color 1 .5 .2 } shader t basic { c3 .2 opacity .5 }\nobject arm { \
    cylinder { radius .1 length 2 shader s } rotate x 30deg move 0 0 1 use hand { scale 1 1 -1 } }\nobject hand { \
    sphere { radius .4 res 6 shader t } surface s { v 0 0 0 v 1 0 0 n 0 0 1 v 0 1 0 polygon { 1 2 3 } } }\nworld { use arm \
    clone arm { shader t matrix 1 0 0 0 1 0 0 0 1 3 0 0 } prism { outline 0 0 1 0 0 1 height 2 shader s } }\nlight a spot { from 3 3 9 \
    at 0 0 0 opening 40 edge soft }\ncamera { from 0 0 9 at 0 0 0 focal .3 } background .1 .2 .3 image 24 16\n";

/// Words that hurt.
const WORDS: [&str; 20] = [
    "nan",
    "-inf",
    "1e999",
    "-0",
    "1e-320",
    "1e308",
    "-1e30",
    "0",
    "3",
    "-3",
    "1e9",
    "4294967296",
    "1.",
    "+.5",
    "p",
    "v",
    "f",
    "pp",
    "#",
    "\0",
];

/// `text` after up to three changes.
fn mangled(text: &str, random: &mut Random) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + random.below(3) {
        let at = random.below(bytes.len() as u64) as usize;
        let end = (at + 1 + random.below(12) as usize).min(bytes.len());
        match random.below(6) {
            0 => bytes[at] = random.bits() as u8,
            1 => drop(bytes.drain(at..end)),
            2 => {
                let again = bytes[at..end].to_vec();
                bytes.splice(at..at, again);
            }
            _ => {
                // The word at or behind `at`.
                let is_space = |byte: &u8| byte.is_ascii_whitespace();
                let start = bytes[..at].iter().rposition(is_space).map_or(0, |space| space + 1);
                let end = bytes[at..].iter().position(is_space).map_or(bytes.len(), |space| at + space);
                let word = WORDS[random.below(WORDS.len() as u64) as usize];
                bytes.splice(start.min(end)..end, word.bytes());
            }
        }
        if bytes.is_empty() {
            bytes.push(b' ');
        }
    }
    bytes
}

fn scene_text(random: &mut Random, tally: &mut Tally) -> u64 {
    let text = mangled(SCENE, random);
    let Ok(parsed) = read_nff("fuzz", &text, ParseOptions::default()) else { return 0 };
    tally.add("legal texts", 1);
    let vertices = parsed.scene.surfaces.iter().flat_map(|surface| &surface.mesh.vertices);
    vertices.filter(|vertex| !vertex.is_finite()).count() as u64
}

fn tree_text(random: &mut Random, tally: &mut Tally) -> u64 {
    let text = mangled(TREE, random);
    let Ok(parsed) = read_sipp("fuzz", &text, ParseOptions::default()) else { return 0 };
    tally.add("legal trees", 1);
    let transforms = parsed.scene.objects.iter().map(|object| object.parent_from_local);
    transforms.filter(|transform| transform.is_nan()).count() as u64
}

fn picture(random: &mut Random, tally: &mut Tally) -> u64 {
    let text = mangled(SCENE, random);
    let Ok(parsed) = read_nff("fuzz", &text, ParseOptions::default()) else { return 0 };
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
    let Ok(rendered) = render(&parsed.scene, &choices, Some(rasterizer)) else { return 0 };
    tally.add("pictures", 1);
    nans(&rendered.image)
}

fn screen_file(random: &mut Random, tally: &mut Tally) -> u64 {
    let mut list = DrawList::new(12, 10);
    list.push_flat(&[(1.0, 1.0), (9.0, 2.5), (4.0, 8.25)], 1.0, [0.5, 0.25, 1.0]);
    list.push_flat(&[(0.0, 0.0), (12.0, 0.0), (12.0, 10.0), (6.0, 5.0), (0.0, 10.0)], 0.5, [1.0; 3]);
    let mut text = Vec::new();
    let Some(attributes) = Attributes::from_names("color") else { return 0 };
    if write_v2(&list, &Sheet::default(), attributes, &mut text).is_err() {
        return 0;
    }
    let text = mangled(&String::from_utf8_lossy(&text), random);
    let options = ReadOptions { max_pixels: 10_000, ..ReadOptions::default() };
    let Ok(file) = read(&String::from_utf8_lossy(&text), &options) else { return 0 };
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
