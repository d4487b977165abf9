//! How long trees take to grow and landscapes to be invented; and a map of one.
//!
//! `cargo run --release --example growing -- [HECTARES] [SEED] [MAP.png]` prints nanoseconds a tree for each way of planting, milliseconds a cell, and the
//! most memory used; with a third argument it writes a map of covers and relief, lit from the north-west, 4 pixels a cell.

use farop::forest::area::{Cell, Ground, Head, Owner, Patch, Plant, Spread, Stand, StandState};
use farop::forest::cover::raster;
use farop::forest::invent::{Invented, invent};
use farop::forest::place::{Placement, Sizes, grow};
use farop::image::{Picture, encode_for};
use farop::math::Vec3;
use farop::scene::Place;
use std::hint::black_box;
use std::time::Instant;

type Failure = Box<dyn std::error::Error>;

/// The height under a position of a lattice, bilinear.
fn ground(cell: &Cell, at: [f64; 2], side: f64) -> f64 {
    let Ground::Lattice { size, .. } = &cell.ground else { return f64::NAN };
    let last = f64::from(size[0] - 1);
    let [x, y] = [at[0] / side * last, (1.0 - at[1] / side) * last];
    let [i, j] = [x, y].map(|steps| steps.clamp(0.0, last - 1.0) as usize);
    let (u, v) = (x - i as f64, y - j as f64);
    let mix = |row: usize| cell.ground.sample(i, row) * (1.0 - u) + cell.ground.sample(i + 1, row) * u;
    mix(j) * (1.0 - v) + mix(j + 1) * v
}

/// A cell that is one stand of 900 trees a hectare.
fn plain(head: &Head, cell: &Cell, plant: Plant) -> Cell {
    let state = StandState {
        year: None,
        species: 0,
        height: Spread { mean: 14.0, deviation: 2.0 },
        crown: Spread { mean: 4.0, deviation: 0.6 },
        density: 900.0,
        crown_base: None,
        plant,
        picture: None,
        cover: None,
    };
    let (side, place) = (head.side, Place::default());
    let outer = vec![[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]];
    Cell {
        stands: vec![Stand { number: 1, states: vec![state], place }],
        patches: vec![Patch { owner: Owner::Stand(0), outer, holes: Vec::new(), place }],
        ..cell.clone()
    }
}

/// Nanoseconds a tree, the median of 15 runs.
fn time(head: &Head, cell: &Cell, placement: Placement) -> Result<(usize, f64), Failure> {
    let mut times = Vec::new();
    let mut count = 0;
    for _ in 0..15 {
        let start = Instant::now();
        let trees = grow(head, cell, Some(2018), placement, &|at| ground(cell, at, head.side))?;
        times.push(start.elapsed().as_secs_f64() * 1e9);
        count = black_box(trees).len();
    }
    times.sort_by(f64::total_cmp);
    Ok((count, times[times.len() / 2] / count.max(1) as f64))
}

/// The relief of a cell as 128 triangles.
fn triangles(cell: &Cell, side: f64) -> Vec<[Vec3; 3]> {
    let corner = |i: u32, j: u32| {
        Vec3::new(f64::from(i) * side / 8.0, f64::from(j) * side / 8.0, cell.ground.sample(i as usize, 8 - j as usize))
    };
    let square = |index: u32| {
        let (i, j) = (index % 8, index / 8);
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..64).flat_map(square).collect()
}

fn print_trees(land: &Invented) -> Result<(), Failure> {
    let head = land.head();
    let [columns, rows] = land.size();
    let Some(cell) = land.cell([columns as i32 / 3, rows as i32 / 3]) else { return Ok(()) };
    for (name, plant) in Plant::ALL {
        let (count, nanoseconds) = time(head, &plain(head, &cell, plant), Placement::Lattice)?;
        println!("{name:<10} {count:>6} trees, {nanoseconds:5.1} ns each");
    }
    let (count, nanoseconds) =
        time(head, &plain(head, &cell, Plant::Poisson), Placement::Triangles(&triangles(&cell, head.side)))?;
    println!("triangles  {count:>6} trees, {nanoseconds:5.1} ns each");
    let (count, nanoseconds) = time(head, &cell, Placement::Lattice)?;
    println!("invented   {count:>6} trees, {nanoseconds:5.1} ns each, {} patches", cell.patches.len());
    let trees = grow(head, &cell, Some(2018), Placement::Lattice, &|_| 0.0)?;
    let sizes = Sizes::new(head, &cell, Some(2018));
    let start = Instant::now();
    let sum: f64 = trees.iter().map(|tree| sizes.of(*tree).height).sum();
    let each = start.elapsed().as_secs_f64() * 1e9 / trees.len().max(1) as f64;
    println!("sizes      {each:.1} ns each, mean height {:.1} m", sum / trees.len().max(1) as f64);
    Ok(())
}

/// A map: covers by color, trees darker, light from the north-west; the river and the roads.
fn map(land: &Invented) -> Result<Picture, Failure> {
    const PIXELS: usize = 4;
    const COLORS: [[f64; 3]; 9] = [
        [0.5, 0.5, 0.5],
        [0.24, 0.40, 0.22],
        [0.62, 0.70, 0.40],
        [0.55, 0.52, 0.36],
        [0.88, 0.80, 0.50],
        [0.30, 0.47, 0.66],
        [0.60, 0.57, 0.53],
        [0.9, 0.85, 0.7],
        [0.5, 0.5, 0.5],
    ];
    let [columns, rows] = land.size();
    let (width, height) = (columns * PIXELS, rows * PIXELS);
    let mut rgb = vec![255; width * height * 3];
    for cell in land.cells() {
        let numbers = raster(land.head(), &cell, Some(2018), PIXELS);
        let step = land.head().side / PIXELS as f64;
        let mut put = |x: usize, y: usize, color: [f64; 3], light: f64| {
            let [column, row] = cell.index.map(|index| index as usize * PIXELS);
            let index = 3 * ((height - 1 - row - y) * width + column + x);
            (0..3).for_each(|channel| rgb[index + channel] = (color[channel] * light * 255.0) as u8);
        };
        for (index, number) in numbers.iter().enumerate() {
            let (x, y) = (index % PIXELS, index / PIXELS);
            let corner = land.head().corner(cell.index);
            let at = [corner.x + (x as f64 + 0.5) * step, corner.y + (y as f64 + 0.5) * step];
            let slope = [
                land.height([at[0] + 30.0, at[1]]) - land.height(at),
                land.height([at[0], at[1] + 30.0]) - land.height(at),
            ];
            let light = (0.80 + 0.9 * (slope[0] - slope[1]) / 30.0).clamp(0.25, 1.1);
            put(x, y, COLORS[usize::from(*number)].map(|channel| channel.min(0.9)), light);
        }
        for line in &cell.lines {
            let color = if line.kind == "river" { [0.25, 0.42, 0.66] } else { [0.95, 0.93, 0.88] };
            for pair in line.points.windows(2) {
                for share in 0..8 {
                    let at =
                        [0, 1].map(|axis| pair[0][axis] + (pair[1][axis] - pair[0][axis]) * f64::from(share) / 8.0);
                    let [x, y] = at.map(|metres| ((metres / step) as usize).min(PIXELS - 1));
                    put(x, y, color, 1.0);
                }
            }
        }
    }
    Ok(Picture::from_rgb(width, height, rgb)?)
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let hectares = arguments.first().map_or(Ok(95_000.0), |word| word.parse())?;
    let seed = arguments.get(1).map_or(Ok(7), |word| word.parse())?;
    let start = Instant::now();
    let land = invent(hectares, seed)?;
    println!("{} cells; marks, river and roads in {:.2} s", land.len(), start.elapsed().as_secs_f64());
    if let Some(path) = arguments.get(2).map(std::path::Path::new) {
        std::fs::write(path, encode_for(path, &map(&land)?)?)?;
        return Ok(());
    }
    print_trees(&land)?;
    let start = Instant::now();
    let (mut patches, mut trees, mut corners) = (0, 0.0, 0);
    for cell in land.cells() {
        patches += cell.patches.len();
        for patch in &cell.patches {
            corners += patch.outer.len();
            let Owner::Stand(stand) = patch.owner else { continue };
            let density = cell.stands[stand as usize].in_year(Some(2018)).map_or(0.0, |state| state.density);
            trees += density * farop::forest::polygon::area(&patch.outer) / 1e4;
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    println!(
        "{} cells invented in {seconds:.2} s, {:.3} ms each; {patches} patches, {corners} corners, {trees:.0} trees",
        land.len(),
        seconds * 1e3 / land.len() as f64
    );
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    println!("{}", status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or("peak memory: not known here"));
    Ok(())
}
