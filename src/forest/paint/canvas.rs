//! Canvas: leaves, needles and branches as small shapes, one over the other.
//!
//! shapes in units of the tree's height -CANVAS-> Texels
//!
//! Why units of the height: a picture of 256 x 256 texels hangs on a tree that is three times as high as wide; leaves must look right there, so on the
//! picture they are wide. Twice as many samples each way are painted and then averaged, which makes edges soft.
//!
//! Space: x to the right from the middle, y upward from the foot, in heights of the tree; samples from the upper left.
//! Cost: the samples of the shapes' boxes.

use crate::image::textures::{FirstRow, Rgba, Texels, Wrap, dilate};

/// Texels along each side of every painted picture.
pub const SIDE: usize = 256;
/// Samples along each side.
const SAMPLES: usize = 2 * SIDE;

/// A color while painting; 1 is white.
pub(super) type Paint = [f64; 3];

/// A picture being painted. Nothing is there at first.
pub(super) struct Canvas {
    samples: Vec<Option<[f32; 3]>>,
    /// Width of the picture in heights.
    width: f64,
    /// Shapes that leave it come in on the other side.
    wraps: bool,
}

impl Canvas {
    /// For a tree this wide, in its heights.
    pub(super) fn of_tree(width: f64) -> Canvas {
        Canvas { samples: vec![None; SAMPLES * SAMPLES], width, wraps: false }
    }

    /// For a ground that repeats, one high and wide (x from -0.5 to 0.5), with a color everywhere.
    pub(super) fn of_ground(color: impl Fn(f64, f64) -> Paint) -> Canvas {
        let center = |index: usize| (index as f64 + 0.5) / SAMPLES as f64;
        let at =
            |index: usize| Some(color(center(index % SAMPLES), center(index / SAMPLES)).map(|channel| channel as f32));
        Canvas { samples: (0..SAMPLES * SAMPLES).map(at).collect(), width: 1.0, wraps: true }
    }

    /// An ellipse with half axes `axes`, the first along the unit vector `along`.
    pub(super) fn ellipse(&mut self, center: [f64; 2], along: [f64; 2], axes: [f64; 2], color: Paint) {
        let reach = axes[0].max(axes[1]);
        self.shape(center, [reach; 2], |at| {
            let part = (at[0] * along[0] + at[1] * along[1]) / axes[0];
            let across = (at[1] * along[0] - at[0] * along[1]) / axes[1];
            (part * part + across * across <= 1.0).then_some(color)
        });
    }

    /// A line that gets thinner, with round ends; `color` is asked for how far across it is, -1 to 1 from its right side to its left.
    pub(super) fn stroke(&mut self, from: [f64; 2], to: [f64; 2], widths: [f64; 2], color: impl Fn(f64) -> Paint) {
        let along = [to[0] - from[0], to[1] - from[1]];
        let square = (along[0] * along[0] + along[1] * along[1]).max(1e-12);
        let length = square.sqrt();
        let widest = widths[0].max(widths[1]);
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        let reach = [0.5 * along[0].abs() + widest, 0.5 * along[1].abs() + widest];
        self.shape(middle, reach, |at| {
            let at = [at[0] + 0.5 * along[0], at[1] + 0.5 * along[1]];
            let share = ((at[0] * along[0] + at[1] * along[1]) / square).clamp(0.0, 1.0);
            let off = [at[0] - share * along[0], at[1] - share * along[1]];
            let half = 0.5 * (widths[0] + (widths[1] - widths[0]) * share);
            let across = (along[0] * off[1] - along[1] * off[0]) / length;
            (off[0] * off[0] + off[1] * off[1] <= half * half).then(|| color((across / half).clamp(-1.0, 1.0)))
        });
    }

    /// Asks `inside` for the color of every sample within `reach` of `center`; positions are told from the center.
    fn shape(&mut self, center: [f64; 2], reach: [f64; 2], inside: impl Fn([f64; 2]) -> Option<Paint>) {
        let (per_x, per_y) = (SAMPLES as f64 / self.width, SAMPLES as f64);
        let x = (center[0] + 0.5 * self.width) * per_x;
        let y = (1.0 - center[1]) * per_y;
        let range = |middle: f64, reach: f64| (middle - reach).floor() as i64..(middle + reach).ceil() as i64;
        let last = SAMPLES as i64;
        for row in range(y, reach[1] * per_y) {
            for column in range(x, reach[0] * per_x) {
                let is_on = (0..last).contains(&row) && (0..last).contains(&column);
                if is_on || self.wraps {
                    let at = [(column as f64 + 0.5 - x) / per_x, -(row as f64 + 0.5 - y) / per_y];
                    if let Some(color) = inside(at) {
                        let index = row.rem_euclid(last) * last + column.rem_euclid(last);
                        self.samples[index as usize] = Some(color.map(|channel| channel as f32));
                    }
                }
            }
        }
    }

    /// The picture: means of four samples; where nothing is, the color of what is near.
    pub(super) fn finish(self) -> Texels {
        let texel = |index: usize| {
            let (x, y) = (index % SIDE * 2, index / SIDE * 2);
            let corners = [0, 1, SAMPLES, SAMPLES + 1].map(|step| self.samples[y * SAMPLES + x + step]);
            mean(corners)
        };
        let rgba: Vec<Rgba> = (0..SIDE * SIDE).map(texel).collect();
        let size = SIDE as u32;
        // The number of texels is right, so there is a picture.
        let texels = Texels::new(size, size, rgba, FirstRow::Top);
        let wrap = if self.wraps { Wrap::Repeat } else { Wrap::Clamp };
        texels.map_or_else(empty, |texels| dilate(&texels, wrap))
    }
}

fn empty() -> Texels {
    Texels::new(1, 1, vec![[0; 4]], FirstRow::Top).unwrap_or_else(empty)
}

fn mean(corners: [Option<[f32; 3]>; 4]) -> Rgba {
    let (mut sum, mut count) = ([0.0_f32; 3], 0.0_f32);
    for color in corners.into_iter().flatten() {
        (0..3).for_each(|channel| sum[channel] += color[channel]);
        count += 1.0;
    }
    let level = |channel: f32| (channel / count.max(1.0) * 255.0 + 0.5) as u8;
    [level(sum[0]), level(sum[1]), level(sum[2]), (count / 4.0 * 255.0 + 0.5) as u8]
}
