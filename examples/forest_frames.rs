//! Frames of a forest: how long they take and what they look like.
//!
//! `cargo run --release --example forest_frames -- table [FRAMES]`: frames, trees and terrain polygons a second at four sizes, for `fast` and
//! `zbuffer`, one thread and two. Sizes and rasterizers take turns frame by frame; medians.
//! `... -- billboards`: 50 to 400 trees of full size, crossed pictures against facing ones.
//! `... -- pictures FOLDER`: what frames look like, 640 x 480. `... -- compose`: where the time of composing goes.
//!
//! The landscape is an invented one of 6,000 ha with its densities scaled so that about 125,000 trees are in view.

use farop::forest::area::{Area, Head, MeasuredTree, Species};
use farop::forest::cells::Cells;
use farop::forest::frame::{Choices, Composer, FrameCounts, Trees};
use farop::forest::invent::invent;
use farop::forest::pictures::Pictures;
use farop::geometry::Stage;
use farop::image::{Image, Picture, encode_for};
use farop::lab::bench::summary::Summary;
use farop::math::{PI, Vec3, cos, sin};
use farop::plan::{self, Plan};
use farop::raster::{Frame, Rasterizer, Registry};
use farop::render::{Canvas, draw_into};
use farop::scene::{Camera, Place, Scene};
use farop::screen::DrawList;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["pictures", folder] => pictures(Path::new(folder)),
        ["billboards"] => billboards(),
        ["compose"] => compose(),
        ["table"] => table(16),
        ["table", frames] => table(frames.parse()?),
        _ => Err("one of: table [FRAMES], billboards, pictures FOLDER, compose".into()),
    }
}

/// An invented landscape with `factor` times its trees, never more than 2000 a hectare.
fn landscape(hectares: f64, factor: f64) -> Result<Cells, Failure> {
    let land = invent(hectares, 7)?;
    let mut area = Area { head: land.head().clone(), cells: BTreeMap::new() };
    for mut cell in land.cells() {
        for state in cell.stands.iter_mut().flat_map(|stand| &mut stand.states) {
            state.density = (state.density * factor).min(2000.0);
        }
        area.cells.insert(cell.index, cell);
    }
    Ok(Cells::Loaded(area))
}

fn camera(from: Vec3, turn: f64, pitch: f64) -> Camera {
    let ahead = Vec3::new(cos(turn) * cos(pitch), sin(turn) * cos(pitch), sin(pitch));
    let place = Place::default();
    Camera {
        from,
        at: from + ahead * 100.0,
        up: Vec3::Z,
        angle: 45.0,
        hither: 0.5,
        yon: None,
        resolution: (0, 0),
        place,
    }
}

/// An eye `above` metres over the ground of an area.
fn over(composer: &Composer<'_>, cells: &Cells, at: [f64; 2], above: f64) -> Result<Vec3, Failure> {
    let head = cells.head();
    let index = head.cell_at(at);
    let cell = cells.load(index)?.ok_or("no such cell")?;
    let corner = head.corner(index);
    let ground = composer.terrain().height(&cell, [at[0] - corner.x, at[1] - corner.y]);
    Ok(Vec3::new(at[0], at[1], ground + above))
}

/// A walk over the canopy, a wide bend through the middle of the area.
fn path(composer: &Composer<'_>, cells: &Cells, frames: usize) -> Result<Vec<Camera>, Failure> {
    let frame = |index: usize| {
        let share = index as f64 / frames.max(2) as f64;
        let at = [3000.0 + 1500.0 * share, 3600.0 + 500.0 * sin(PI * share)];
        Ok(camera(over(composer, cells, at, 30.0)?, 0.6 + share, -0.08))
    };
    (0..frames).map(frame).collect()
}

/// Memory that frames of one rasterizer share.
struct Painter {
    stage: Stage,
    list: DrawList,
    frame: Frame,
    image: Image,
    levels: Vec<u8>,
}

/// Milliseconds of plan and geometry, of the rasterizer, of the levels; samples put.
#[derive(Clone, Copy, Default)]
struct Times {
    geometry: f64,
    raster: f64,
    levels: f64,
    puts: u64,
}

impl Painter {
    fn new((width, height): (u32, u32)) -> Painter {
        let image = Image::new(width as usize, height as usize, farop::color::Rgb::gray(0.0));
        Painter {
            stage: Stage::default(),
            list: DrawList::new(0, 0),
            frame: Frame::default(),
            image,
            levels: Vec::new(),
        }
    }

    fn paint(&mut self, scene: &Scene, rasterizer: &dyn Rasterizer, threads: u32) -> Result<Times, Failure> {
        let choices = plan::Choices { threads: Some(threads), ..plan::Choices::default() };
        let start = Instant::now();
        let plan = Plan::new(scene, &choices, rasterizer.accepts())?;
        self.stage.run(scene, &plan, &mut self.list);
        let geometry = milliseconds(start);
        let start = Instant::now();
        let canvas = Canvas::new(scene, &choices);
        let puts = draw_into(&self.list, rasterizer, &canvas, (&mut self.frame, &mut self.image)).puts;
        let raster = milliseconds(start);
        let start = Instant::now();
        self.image.encode_into(choices.encoding, &mut self.levels);
        Ok(Times { geometry, raster, levels: milliseconds(start), puts })
    }

    fn save(&self, path: &Path) -> Result<(), Failure> {
        let picture = Picture::from_rgb(self.image.width(), self.image.height(), self.levels.clone())?;
        Ok(std::fs::write(path, encode_for(path, &picture)?)?)
    }
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn pictures(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)?;
    let cells = landscape(6000.0, 1.0)?;
    let paint = Pictures::new(cells.head(), Path::new("."))?;
    let registry = Registry::built_in();
    let fast = registry.find("fast").ok_or("no fast")?.rasterizer.as_ref();
    let mut composer = Composer::new(&cells, paint, Choices::default())?;
    let size = (640, 480);
    let mut painter = Painter::new(size);
    let views = [
        ("inside", [3900.0, 3700.0], 1.8, 0.7, 0.03),
        ("canopy", [3000.0, 3600.0], 30.0, 0.7, -0.08),
        ("slope", [3500.0, 3200.0], 90.0, 1.9, -0.25),
        ("flight", [2500.0, 2500.0], 600.0, 0.8, -0.5),
        ("down", [3600.0, 3600.0], 150.0, 0.8, -1.5),
    ];
    for (name, at, above, turn, pitch) in views {
        let camera = camera(over(&composer, &cells, at, above)?, turn, pitch);
        for (suffix, trees) in [("", Trees::Auto), ("_crossed", Trees::Crossed), ("_billboards", Trees::Billboards)] {
            composer.choose(Choices { trees, ..Choices::default() })?;
            let (scene, counts) = composer.compose(&camera, size)?;
            let times = painter.paint(scene, fast, 2)?;
            painter.save(&folder.join(format!("{name}{suffix}.png")))?;
            println!("{name}{suffix}: {counts:?}; geometry {:.1} raster {:.1} ms", times.geometry, times.raster);
        }
    }
    Ok(())
}

fn compose() -> Result<(), Failure> {
    let cells = landscape(6000.0, FACTOR)?;
    let paint = Pictures::new(cells.head(), Path::new("."))?;
    let start = Instant::now();
    let mut composer = Composer::new(&cells, paint, Choices::default())?;
    println!(
        "survey {:.0} ms, {} squares a side, {:.1} MB",
        milliseconds(start),
        composer.terrain().squares(),
        mega(composer.terrain().bytes())
    );
    let cameras = path(&composer, &cells, 16)?;
    for trees in [Trees::None, Trees::Auto, Trees::Billboards, Trees::Crossed] {
        composer.choose(Choices { trees, ..Choices::default() })?;
        let mut times = Vec::new();
        let mut total = FrameCounts::default();
        for _ in 0..8 {
            for camera in &cameras {
                let start = Instant::now();
                let (_, counts) = composer.compose(camera, (640, 480))?;
                times.push(milliseconds(start));
                total = counts;
            }
        }
        let summary = Summary::of(times);
        println!(
            "{trees:?}: {:.2} ms in the middle, {:.2} at least; {:.1} MB; {total:?}",
            summary.median,
            summary.least,
            mega(composer.bytes())
        );
    }
    Ok(())
}

fn mega(bytes: usize) -> f64 {
    bytes as f64 / 1e6
}

/// Densities of the landscape are multiplied by this: about 125,000 trees in view along the path.
const FACTOR: f64 = 1.0;
const SIZES: [(u32, u32); 4] = [(320, 240), (640, 480), (800, 600), (1024, 768)];

/// A row of the table.
#[derive(Default)]
struct Row {
    compose: Vec<f64>,
    geometry: Vec<f64>,
    raster: Vec<f64>,
    total: Vec<f64>,
    trees: u64,
    terrain: u64,
    overdraw: f64,
}

fn table(frames: usize) -> Result<(), Failure> {
    let cells = landscape(6000.0, FACTOR)?;
    let paint = Pictures::new(cells.head(), Path::new("."))?;
    let registry = Registry::built_in();
    let mut composer = Composer::new(&cells, paint, Choices::default())?;
    let cameras = path(&composer, &cells, frames)?;
    println!(
        "| trees | rasterizer | threads | size | frames/s | M trees/s | k terrain polygons/s | overdraw | compose | geometry | raster ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for trees in [Trees::Auto, Trees::Crossed] {
        composer.choose(Choices { trees, ..Choices::default() })?;
        for (name, threads) in [("fast", 1), ("fast", 2), ("zbuffer", 1), ("zbuffer", 2)] {
            let rasterizer = registry.find(name).ok_or("no such rasterizer")?.rasterizer.as_ref();
            let mut rows: Vec<(Row, Painter)> =
                SIZES.iter().map(|&size| (Row::default(), Painter::new(size))).collect();
            for (index, camera) in cameras.iter().enumerate() {
                for (&size, (row, painter)) in SIZES.iter().zip(&mut rows) {
                    let start = Instant::now();
                    let (scene, counts) = composer.compose(camera, size)?;
                    let compose = milliseconds(start);
                    let times = painter.paint(scene, rasterizer, threads)?;
                    // The first frame loads cells and makes pictures ready.
                    if index > 0 {
                        row.add(compose, &times, &counts, size);
                    }
                }
            }
            for (size, (row, _)) in SIZES.iter().zip(&rows) {
                println!("| {trees:?} | {name} | {threads} | {}x{} {}", size.0, size.1, row.text());
            }
        }
    }
    Ok(())
}

impl Row {
    fn add(&mut self, compose: f64, times: &Times, counts: &FrameCounts, size: (u32, u32)) {
        self.compose.push(compose);
        self.geometry.push(times.geometry);
        self.raster.push(times.raster);
        self.total.push(compose + times.geometry + times.raster + times.levels);
        self.trees += counts.submitted;
        self.terrain += counts.terrain_polygons;
        self.overdraw += times.puts as f64 / f64::from(size.0 * size.1);
    }

    fn text(&self) -> String {
        let count = self.total.len().max(1) as f64;
        let median = |values: &Vec<f64>| Summary::of(values.iter().copied()).median;
        let frames = 1e3 / median(&self.total);
        let per_second = |sum: u64| sum as f64 / count * frames;
        format!(
            "| {frames:.2} | {:.3} | {:.1} | {:.2} | {:.1} | {:.1} | {:.1} |",
            per_second(self.trees) / 1e6,
            per_second(self.terrain) / 1e3,
            self.overdraw / count,
            median(&self.compose),
            median(&self.geometry),
            median(&self.raster)
        )
    }
}

/// Trees of full size in rows before the eye.
fn billboards() -> Result<(), Failure> {
    println!("| trees | facing frames/s | crossed frames/s | crossed / facing time |");
    println!("|---|---|---|---|");
    let registry = Registry::built_in();
    let fast = registry.find("fast").ok_or("no fast")?.rasterizer.as_ref();
    for count in [50, 100, 200, 300, 400] {
        let cells = rows_of_trees(count);
        let paint = Pictures::new(cells.head(), Path::new("."))?;
        let mut composer = Composer::new(&cells, paint, Choices::default())?;
        let camera = camera(Vec3::new(120.0, 2.0, 2.0), PI / 2.0, 0.0);
        let mut times = [Vec::new(), Vec::new()];
        let mut painter = Painter::new((640, 480));
        for _ in 0..41 {
            for (times, trees) in times.iter_mut().zip([Trees::Billboards, Trees::Crossed]) {
                composer.choose(Choices { trees, ..Choices::default() })?;
                let start = Instant::now();
                let (scene, _) = composer.compose(&camera, (640, 480))?;
                painter.paint(scene, fast, 1)?;
                times.push(milliseconds(start));
            }
        }
        let [facing, crossed] = times.map(|times| Summary::of(times).median);
        println!("| {count} | {:.1} | {:.1} | {:.2} |", 1e3 / facing, 1e3 / crossed, crossed / facing);
    }
    Ok(())
}

/// Trees 5 m wide and high as in the paper, ten in a row.
fn rows_of_trees(count: usize) -> Cells {
    use farop::forest::area::{Cell, Form, Ground};
    let place = Place::default();
    let trees = (0..count).map(|index| {
        let at = [90.0 + 6.0 * (index % 10) as f64 + 3.0, 15.0 + 5.0 * (index / 10) as f64];
        MeasuredTree { species: 0, at, height: 5.0, crown: 5.0, turn: 20.0 * index as f64, place }
    });
    let head = Head {
        side: 240.0,
        species: vec![Species { code: "OAK".into(), form: Form::Broadleaf, images: vec![], place }],
        ..Head::default()
    };
    let cell = Cell {
        index: [0, 0],
        seed: 0,
        cover: None,
        ground: Ground::Lattice { size: [2, 2], base: 0.0, step: 1.0, counts: vec![0; 4] },
        stands: vec![],
        patches: vec![],
        trees: trees.collect(),
        lines: vec![],
        place,
    };
    Cells::Loaded(Area { head, cells: BTreeMap::from([([0, 0], cell)]) })
}
