//! Relief: heights of an invented landscape at any position, out of the seed alone.
//!
//! seed, world position -RELIEF-> metres
//!
//! Sums of noise whose octaves are weaker where the ground is steep already: slopes stay smooth and ridges sharp, as if water had
//! run over them. A river's valley is cut into them from north to south, and a lake lies in it.
//!
//! Space: world metres. Source: K. Perlin, "Improving Noise", SIGGRAPH 2002 (gradients, fade); the damping by slopes is known from I. Quilez's texts on terrain noise.
//! Cost: 8 octaves a sample, 0.4 microseconds.

use crate::forest::random::{key, mix64, unit};
use crate::math::{PI, sin};

/// The highest an invented landscape gets, in metres.
pub(super) const HIGHEST: f64 = 900.0;
/// Half the width of the valley's flat ground, and of all that the river has cut, in metres.
const FLAT: f64 = 90.0;
const CUT: f64 = 1500.0;

/// What heights depend on.
pub(super) struct Relief {
    seed: u64,
    /// Width and height of the area in metres.
    pub(super) size: [f64; 2],
    /// Phases of the river's bends.
    phases: [f64; 3],
    pub(super) lake: Lake,
}

/// A lake with a rounded outline.
pub(super) struct Lake {
    pub(super) center: [f64; 2],
    pub(super) radius: f64,
    pub(super) level: f64,
    turn: [f64; 2],
}

impl Relief {
    pub(super) fn new(seed: u64, size: [f64; 2]) -> Relief {
        let phases = [1, 2, 3].map(|number| 2.0 * PI * unit(key(&[seed, 0x21, number])));
        let lake = Lake { center: [0.0; 2], radius: 0.0, level: 0.0, turn: [1.0, 0.0] };
        let mut relief = Relief { seed, size, phases, lake };
        let y = size[1] * (0.35 + 0.3 * unit(key(&[seed, 0x22])));
        let angle = 2.0 * PI * unit(key(&[seed, 0x23]));
        relief.lake = Lake {
            center: [relief.river(y), y],
            radius: (0.030 * size[0].min(size[1])).clamp(60.0, 800.0),
            level: relief.floor(y),
            turn: [sin(angle + 0.5 * PI), sin(angle)],
        };
        relief
    }

    /// Where the river is at this northing: metres to the east.
    pub(super) fn river(&self, y: f64) -> f64 {
        let bend = |index: usize, length: f64, width: f64| width * sin(2.0 * PI * y / length + self.phases[index]);
        let room = (0.16 * self.size[0]).min(2600.0);
        0.46 * self.size[0] + bend(0, 14_300.0, room) + bend(1, 4700.0, 0.22 * room) + bend(2, 1430.0, 0.06 * room)
    }

    /// The valley's ground: it falls to the south by 7 m a km.
    pub(super) fn floor(&self, y: f64) -> f64 {
        20.0 + 0.007 * y
    }

    /// Metres above the sea.
    pub(super) fn height(&self, [x, y]: [f64; 2]) -> f64 {
        let mountains = self.mountains(x, y);
        let floor = self.floor(y);
        let from_river = (x - self.river(y)).abs();
        let rise = smooth((from_river - FLAT) / CUT);
        let valley = floor + (mountains - floor).max(4.0) * rise;
        let shore = self.lake.share([x, y]);
        // Flat to the shore and a little beyond; then half a radius until the land is its own again.
        let height = self.lake.level + (valley - self.lake.level) * smooth((shore - 1.06) / 0.5);
        height.clamp(0.0, HIGHEST)
    }

    fn mountains(&self, x: f64, y: f64) -> f64 {
        const TURN: [f64; 2] = [0.8, 0.6];
        // Bent before it is asked: no ridge runs straight.
        let bend = [1, 2].map(|number| 700.0 * gradient_noise(self.seed ^ mix64(number), x / 5200.0, y / 5200.0)[0]);
        let mut at = [(x + bend[0]) / 4600.0, (y + bend[1]) / 4600.0];
        let (mut sum, mut weight, mut slope) = (0.0, 1.0, [0.0; 2]);
        for octave in 0..8 {
            let [value, dx, dy] = gradient_noise(self.seed.wrapping_add(octave), at[0], at[1]);
            slope = [slope[0] + dx * 0.7, slope[1] + dy * 0.7];
            let ridge = 1.0 - 1.9 * value.abs();
            let part = if octave < 2 { 0.45 * ridge + 0.75 * value } else { value };
            sum += weight * part / (1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
            weight *= 0.5;
            at = [2.0 * (TURN[0] * at[0] - TURN[1] * at[1]), 2.0 * (TURN[1] * at[0] + TURN[0] * at[1])];
        }
        // High massifs and low country, by a noise of 15 km.
        let massif = 0.62 + 0.75 * gradient_noise(self.seed ^ 0x5EED, x / 15_000.0, y / 15_000.0)[0];
        let height = 40.0 + 900.0 * massif.clamp(0.25, 1.2) * (0.14 + 1.05 * sum).max(0.0);
        // The last metres are pressed together, so that nothing is cut off flat.
        if height < 700.0 { height } else { 700.0 + 200.0 * (1.0 - 1.0 / (1.0 + (height - 700.0) / 200.0)) }
    }
}

impl Lake {
    /// How far out a position is: 1 on the shore.
    pub(super) fn share(&self, at: [f64; 2]) -> f64 {
        let off = [at[0] - self.center[0], at[1] - self.center[1]];
        let distance = (off[0] * off[0] + off[1] * off[1]).sqrt();
        if distance < 1e-6 { 0.0 } else { distance / self.reach([off[0] / distance, off[1] / distance]) }
    }

    /// How far the shore is in a direction. Twice and three times the angle, without angles; so little that the outline stays convex.
    pub(super) fn reach(&self, direction: [f64; 2]) -> f64 {
        let times = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
        let turned = times(direction, self.turn);
        let double = times(turned, turned);
        self.radius * (1.0 + 0.11 * double[0] + 0.03 * times(double, turned)[1])
    }
}

/// 0 to 1 with level ends.
fn smooth(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Perlin's noise, about -1 to 1, and its slopes along x and y.
pub(super) fn gradient_noise(seed: u64, x: f64, y: f64) -> [f64; 3] {
    let (column, row) = (x.floor(), y.floor());
    let [fx, fy] = [x - column, y - row];
    let fade = |t: f64| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let fade_slope = |t: f64| 30.0 * t * t * (t - 1.0) * (t - 1.0);
    let corner = |dx: i64, dy: i64| {
        let bits = mix64(seed ^ mix64((column as i64 + dx) as u64).wrapping_add((row as i64 + dy) as u64));
        // One of 65,536 slopes each way: not all of one length, which no eye sees.
        let slope = [bits & 0xFFFF, (bits >> 16) & 0xFFFF].map(|bits| bits as f64 / 32_768.0 - 1.0);
        let value = slope[0] * (fx - dx as f64) + slope[1] * (fy - dy as f64);
        [value, slope[0], slope[1]]
    };
    let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
    let (u, v) = (fade(fx), fade(fy));
    let mix = |k: usize| a[k] + (b[k] - a[k]) * u + (c[k] - a[k]) * v + (a[k] - b[k] - c[k] + d[k]) * u * v;
    let across = (b[0] - a[0]) + (a[0] - b[0] - c[0] + d[0]) * v;
    let up = (c[0] - a[0]) + (a[0] - b[0] - c[0] + d[0]) * u;
    [1.4 * mix(0), 1.4 * (mix(1) + across * fade_slope(fx)), 1.4 * (mix(2) + up * fade_slope(fy))]
}
