//! The ways of placing trees, side by side: the same half hectare four times, full and thinned.
//!
//! `cargo run --example placements -- PICTURE.png`: Poisson, squares, rows, and the paper's triangles; 400 trees a hectare above,
//! below the same stand thinned to 150.

use farop::forest::area::{Cell, Ground, Head, Owner, Patch, Plant, Spread, Stand, StandState};
use farop::forest::place::{Placement, Sizes, grow};
use farop::image::{Picture, encode_for};
use farop::math::Vec3;
use farop::scene::Place;

/// Pixels a side of a panel, and metres of land it shows.
const PANEL: usize = 210;
const METRES: f64 = 70.0;

fn stand(plant: Plant) -> Stand {
    let state = |(year, density)| StandState {
        year: Some(year),
        species: 0,
        height: Spread { mean: 14.0, deviation: 2.0 },
        crown: Spread { mean: 3.2, deviation: 0.6 },
        density,
        crown_base: None,
        plant,
        picture: None,
        cover: None,
    };
    Stand { number: 3, states: [(2011, 400.0), (2026, 150.0)].map(state).to_vec(), place: Place::default() }
}

fn cell(head: &Head, plant: Plant) -> Cell {
    let (side, place) = (head.side, Place::default());
    let outer = vec![[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]];
    Cell {
        index: [0, 0],
        seed: 5,
        cover: None,
        ground: Ground::Lattice { size: [2; 2], base: 0.0, step: 1.0, counts: vec![0; 4] },
        stands: vec![stand(plant)],
        patches: vec![Patch { owner: Owner::Stand(0), outer, holes: Vec::new(), place }],
        trees: Vec::new(),
        lines: Vec::new(),
        place,
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::path::PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "placements.png".to_string()));
    let head = Head { side: 240.0, seed: 1, ..Head::default() };
    let corner = |x: f64, y: f64| Vec3::new(x, y, 0.0);
    let fan: Vec<[Vec3; 3]> = (0..64)
        .flat_map(|index| {
            let (x, y) = (f64::from(index % 8) * 30.0, f64::from(index / 8) * 30.0);
            let [a, b, c, d] = [corner(x, y), corner(x + 30.0, y), corner(x + 30.0, y + 30.0), corner(x, y + 30.0)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let ways = [Plant::Poisson, Plant::Jittered, Plant::Rows].map(|plant| (plant, Placement::Lattice));
    let (width, height) = (4 * (PANEL + 6) - 6, 2 * (PANEL + 6) - 6);
    let mut rgb = vec![255; width * height * 3];
    for (column, (plant, placement)) in
        ways.into_iter().chain([(Plant::Poisson, Placement::Triangles(&fan))]).enumerate()
    {
        let cell = cell(&head, plant);
        for (row, year) in [2011, 2026].into_iter().enumerate() {
            let sizes = Sizes::new(&head, &cell, Some(year));
            let trees = grow(&head, &cell, Some(year), placement, &|_| 0.0)?;
            for index in 0..PANEL * PANEL {
                let (x, y) = (index % PANEL, index / PANEL);
                let at = [x, PANEL - 1 - y].map(|pixel| 80.0 + (pixel as f64 + 0.5) * METRES / PANEL as f64);
                // The tallest crown over the pixel, lit from the upper left.
                let mut color = [0.80, 0.78, 0.62];
                for tree in &trees {
                    let foot = tree.at(head.side);
                    let off = [at[0] - foot[0], at[1] - foot[1]];
                    let reach = 0.5 * sizes.of(*tree).crown;
                    let share = (off[0] * off[0] + off[1] * off[1]) / (reach * reach);
                    if share < 1.0 {
                        let light = 0.55 + 0.35 * (off[1] - off[0]) / reach * share.sqrt();
                        color = [0.42, 0.60, 0.26].map(|channel| channel * light.clamp(0.2, 1.0) * 1.3);
                    }
                }
                let start = 3 * ((row * (PANEL + 6) + y) * width + column * (PANEL + 6) + x);
                (0..3).for_each(|channel| rgb[start + channel] = (color[channel] * 255.0) as u8);
            }
        }
    }
    std::fs::write(&path, encode_for(&path, &Picture::from_rgb(width, height, rgb)?)?)?;
    Ok(())
}
