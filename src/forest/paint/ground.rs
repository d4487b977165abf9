//! Ground: tiles of forest floor, grass, water and so on, that fit to themselves on all sides.
//!
//! name -GROUND-> noise that repeats, blades and stones that leave on one side and come in on the other -CANVAS-> Texels
//!
//! Why so little contrast in the large: a tile is repeated eight times in a cell, and a dark corner would be seen eight times. What is strong is small.
//!
//! Space: the tile is 1 x 1; usually 30 m of land, so a texel is 12 cm. Cost: noise at 262,144 samples, a few thousand shapes.

use super::canvas::{Canvas, Paint};
use super::chance::{Chance, noise, octaves};

/// All grounds that the program paints, as `paint:NAME` says them.
pub const GROUNDS: [&str; 11] =
    ["pine_floor", "grass", "heath", "field", "water", "rock", "sand", "snow", "road", "slash", "burnt"];

/// Small things that lie about.
struct Litter {
    count: usize,
    /// Half lengths and half widths, least and most.
    sizes: [[f64; 2]; 2],
    colors: [Paint; 2],
    /// Upright as blades, or any way round.
    upright: bool,
}

/// Paints a ground; `None` for a name that is not among [`GROUNDS`].
pub(super) fn paint(name: &str) -> Option<Canvas> {
    let seed = GROUNDS.iter().position(|ground| *ground == name)? as u64 * 100 + 7;
    let mixed = |dark: Paint, bright: Paint, cells: u32| {
        move |x: f64, y: f64| mix(dark, bright, 0.5 + 0.42 * octaves(seed, x, y, cells, 5))
    };
    let (mut canvas, litter) = match name {
        "pine_floor" => (Canvas::of_ground(mixed([0.26, 0.20, 0.13], [0.42, 0.33, 0.21], 7)), pine_floor()),
        "grass" => (Canvas::of_ground(mixed([0.24, 0.33, 0.13], [0.37, 0.46, 0.19], 6)), grass()),
        "heath" => (Canvas::of_ground(mixed([0.26, 0.26, 0.15], [0.40, 0.36, 0.22], 8)), heath()),
        "field" => (Canvas::of_ground(move |x, y| field(seed, x, y)), stubble()),
        "water" => (Canvas::of_ground(move |x, y| water(seed, x, y)), Vec::new()),
        "rock" => (Canvas::of_ground(move |x, y| rock(seed, x, y)), Vec::new()),
        "sand" => (Canvas::of_ground(mixed([0.70, 0.62, 0.45], [0.82, 0.75, 0.58], 9)), sand()),
        "slash" => (Canvas::of_ground(mixed([0.36, 0.29, 0.19], [0.52, 0.44, 0.30], 7)), slash()),
        "burnt" => (Canvas::of_ground(mixed([0.09, 0.085, 0.08], [0.24, 0.22, 0.20], 7)), burnt()),
        "snow" => (Canvas::of_ground(mixed([0.86, 0.89, 0.94], [0.97, 0.98, 1.0], 5)), Vec::new()),
        _ => (Canvas::of_ground(mixed([0.47, 0.44, 0.40], [0.58, 0.55, 0.50], 12)), gravel()),
    };
    let mut chance = Chance::new(&[seed]);
    litter.iter().for_each(|litter| litter.strew(&mut canvas, &mut chance));
    Some(canvas)
}

impl Litter {
    fn strew(&self, canvas: &mut Canvas, chance: &mut Chance) {
        for _ in 0..self.count {
            let at = [chance.between(-0.5, 0.5), chance.share()];
            let along = if self.upright { [0.5 * chance.around(), 1.0] } else { chance.direction() };
            let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
            let axes = [0, 1].map(|axis| chance.between(self.sizes[0][axis], self.sizes[1][axis]));
            let color = mix(self.colors[0], self.colors[1], chance.share());
            canvas.ellipse(at, along.map(|part| part / length), axes, color);
        }
    }
}

fn mix(dark: Paint, bright: Paint, share: f64) -> Paint {
    let share = share.clamp(0.0, 1.0);
    [0, 1, 2].map(|channel| dark[channel] + (bright[channel] - dark[channel]) * share)
}

fn pine_floor() -> Vec<Litter> {
    let needles = [[0.006, 0.0012], [0.014, 0.0019]];
    vec![
        Litter {
            count: 260,
            sizes: [[0.010, 0.007], [0.030, 0.020]],
            colors: [[0.22, 0.24, 0.11], [0.31, 0.33, 0.15]],
            upright: false,
        },
        Litter { count: 5200, sizes: needles, colors: [[0.24, 0.17, 0.10], [0.55, 0.42, 0.26]], upright: false },
        Litter {
            count: 60,
            sizes: [[0.005, 0.004], [0.008, 0.006]],
            colors: [[0.20, 0.13, 0.08], [0.33, 0.23, 0.15]],
            upright: false,
        },
        Litter { count: 1400, sizes: needles, colors: [[0.30, 0.30, 0.14], [0.44, 0.42, 0.22]], upright: false },
    ]
}

fn grass() -> Vec<Litter> {
    let blades = [[0.006, 0.0012], [0.017, 0.0022]];
    vec![
        Litter { count: 5000, sizes: blades, colors: [[0.17, 0.27, 0.08], [0.33, 0.45, 0.16]], upright: true },
        Litter { count: 2400, sizes: blades, colors: [[0.35, 0.46, 0.18], [0.52, 0.60, 0.28]], upright: true },
        Litter { count: 300, sizes: blades, colors: [[0.55, 0.52, 0.28], [0.66, 0.62, 0.36]], upright: true },
    ]
}

fn heath() -> Vec<Litter> {
    let clumps = [[0.012, 0.009], [0.030, 0.022]];
    let twigs = [[0.004, 0.002], [0.010, 0.004]];
    vec![
        Litter { count: 300, sizes: clumps, colors: [[0.19, 0.21, 0.11], [0.27, 0.28, 0.15]], upright: false },
        Litter { count: 4000, sizes: twigs, colors: [[0.22, 0.25, 0.12], [0.42, 0.42, 0.22]], upright: true },
        Litter { count: 1500, sizes: twigs, colors: [[0.38, 0.24, 0.30], [0.56, 0.38, 0.45]], upright: true },
    ]
}

fn stubble() -> Vec<Litter> {
    let stalks = [[0.004, 0.0012], [0.012, 0.002]];
    vec![Litter { count: 3500, sizes: stalks, colors: [[0.56, 0.47, 0.24], [0.83, 0.74, 0.46]], upright: true }]
}

/// Branches that were left, and stumps.
fn slash() -> Vec<Litter> {
    let branches = [[0.008, 0.0014], [0.024, 0.0026]];
    let stumps = [[0.007, 0.006], [0.011, 0.009]];
    vec![
        Litter { count: 2600, sizes: branches, colors: [[0.29, 0.22, 0.14], [0.58, 0.49, 0.34]], upright: false },
        Litter { count: 60, sizes: stumps, colors: [[0.62, 0.50, 0.33], [0.78, 0.66, 0.46]], upright: false },
    ]
}

/// Ash, charred branches and stumps.
fn burnt() -> Vec<Litter> {
    let branches = [[0.008, 0.0012], [0.022, 0.0024]];
    let stumps = [[0.006, 0.005], [0.010, 0.008]];
    vec![
        Litter { count: 1500, sizes: branches, colors: [[0.03, 0.03, 0.03], [0.12, 0.11, 0.10]], upright: false },
        Litter { count: 900, sizes: branches, colors: [[0.30, 0.29, 0.28], [0.46, 0.45, 0.43]], upright: false },
        Litter { count: 60, sizes: stumps, colors: [[0.02, 0.02, 0.02], [0.07, 0.06, 0.06]], upright: false },
    ]
}

fn sand() -> Vec<Litter> {
    let grains = [[0.002, 0.002], [0.004, 0.003]];
    vec![Litter { count: 900, sizes: grains, colors: [[0.60, 0.52, 0.38], [0.90, 0.84, 0.70]], upright: false }]
}

fn gravel() -> Vec<Litter> {
    let stones = [[0.002, 0.002], [0.008, 0.005]];
    vec![Litter { count: 5000, sizes: stones, colors: [[0.38, 0.36, 0.33], [0.68, 0.65, 0.60]], upright: false }]
}

/// Furrows along y: whole waves over the tile.
fn field(seed: u64, x: f64, y: f64) -> Paint {
    let bent = x + 0.004 * noise(seed + 50, x, y, 6);
    let wave = crate::math::sin(bent * 20.0 * 2.0 * crate::math::PI);
    mix([0.50, 0.40, 0.22], [0.74, 0.64, 0.38], 0.5 + 0.28 * wave + 0.3 * octaves(seed, x, y, 8, 4))
}

/// Ripples: noise that is drawn out along x, with lights where it is steep.
fn water(seed: u64, x: f64, y: f64) -> Paint {
    let height =
        |y: f64| noise(seed, x + 0.02 * noise(seed + 9, x, y, 8), y * 3.0, 9) + 0.5 * noise(seed + 1, x, y * 3.0, 19);
    let slope = (height(y + 0.004) - height(y)) * 6.0;
    let deep = mix([0.10, 0.21, 0.29], [0.15, 0.29, 0.37], 0.5 + 0.5 * octaves(seed + 2, x, y, 4, 3));
    let glint = slope.max(0.0) * slope.max(0.0);
    let light = 0.10 * (glint / (1.0 + glint)) + 0.04 * slope.clamp(-1.0, 1.0);
    deep.map(|channel| channel + light)
}

/// Lit from the upper left, with cracks where ridges of noise meet.
fn rock(seed: u64, x: f64, y: f64) -> Paint {
    let height = |x: f64, y: f64| octaves(seed, x, y, 9, 6);
    let slope = (height(x + 0.004, y + 0.004) - height(x, y)) * 3.0;
    let crack = 1.0 - (octaves(seed + 30, x, y, 13, 3).abs() * 9.0).min(1.0);
    let tone = 0.52 + 0.8 * slope + 0.15 * height(x, y) - 0.22 * crack;
    mix([0.25, 0.24, 0.23], [0.66, 0.63, 0.58], tone)
}
