//! Blend: one ground picture out of four, by height.
//!
//! Texels of four grounds, heights -BLEND-> Texels
//!
//! Sand at the sea, grass above it, rock, snow: ground i weighs max(0, 1 - |h - c_i| / r_i), and weights are divided by their sum, so one ground
//! passes into the next without an edge. Out of all reaches the nearest ground shows alone. Colors are mixed as linear light: mixed as display values, the passage would be too dark.
//!
//! Space: heights in metres; pictures in texels, rows from the lowest.
//! Source: J. Caralo (paper 004): one texture from four, with limits of height. The formula is ours, the paper has none; [`Mode::Limits`] is its words alone.
//! Cost: four look-ups a texel.

use crate::color::{Encoding, Rgb};
use crate::image::textures::{FirstRow, Rgba, Texels};

/// Where a ground shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// Where it weighs most, in metres.
    pub center: f64,
    /// How far above and below it weighs at all, in metres; above 0.
    pub reach: f64,
}

/// How grounds meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// They pass into each other.
    #[default]
    Weights,
    /// As paper 004 says and no more: each has limits. Between them only the one whose center is nearest shows, so there are edges.
    Limits,
}

/// Weights of four grounds at a height; their sum is 1. A height that is not a number has the first ground.
///
/// ```
/// use farop::forest::blend::{Layer, Mode, weights};
/// let layers = [0.0, 100.0, 200.0, 300.0].map(|center| Layer { center, reach: 100.0 });
/// assert_eq!(weights(&layers, 125.0, Mode::Weights), [0.0, 0.75, 0.25, 0.0]);
/// assert_eq!(weights(&layers, 125.0, Mode::Limits), [0.0, 1.0, 0.0, 0.0]);
/// ```
#[must_use]
pub fn weights(layers: &[Layer; 4], height: f64, mode: Mode) -> [f64; 4] {
    let weigh = |layer: &Layer| (1.0 - (height - layer.center).abs() / layer.reach).max(0.0);
    let all = [0, 1, 2, 3].map(|index| weigh(&layers[index]));
    let sum: f64 = all.iter().sum();
    if mode == Mode::Weights && sum > 0.0 && sum.is_finite() {
        return all.map(|weight| weight / sum);
    }
    let distance = |index: &usize| (height - layers[*index].center).abs();
    let nearest = (0..4).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
    [0, 1, 2, 3].map(|index| if index == nearest { 1.0 } else { 0.0 })
}

/// The picture of `side` x `side` texels whose texel at (u, v), each 0 to 1, shows the grounds at `height(u, v)`.
///
/// Grounds repeat `tiles` times over the picture; the texel of them that is under the center of the picture's texel counts. `None` without texels.
#[must_use]
pub fn picture(
    grounds: [&Texels; 4],
    layers: &[Layer; 4],
    mode: Mode,
    side: u32,
    tiles: f64,
    height: &dyn Fn(f64, f64) -> f64,
) -> Option<Texels> {
    let center = |index: u32| (f64::from(index) + 0.5) / f64::from(side);
    let texel = |index: u64| {
        let at = [center((index % u64::from(side)) as u32), center((index / u64::from(side)) as u32)];
        let weights = weights(layers, height(at[0], at[1]), mode);
        mix(grounds.map(|ground| look_up(ground, at.map(|share| share * tiles))), weights)
    };
    let count = u64::from(side) * u64::from(side);
    Texels::new(side, side, (0..count).map(texel).collect(), FirstRow::AtV0)
}

fn look_up(ground: &Texels, at: [f64; 2]) -> Rgba {
    let (width, height) = ground.size();
    let index = |share: f64, count: u32| (((share - share.floor()) * f64::from(count)) as u32).min(count - 1);
    ground.at(index(at[0], width), index(at[1], height))
}

fn mix(texels: [Rgba; 4], weights: [f64; 4]) -> Rgba {
    let mut light = [0.0; 3];
    for (texel, weight) in texels.iter().zip(weights) {
        let [r, g, b, _] = texel.map(|level| f64::from(level) / 255.0);
        let part = Encoding::Srgb.decode(Rgb::new(r, g, b)).to_array();
        (0..3).for_each(|channel| light[channel] += weight * part[channel]);
    }
    let [r, g, b] = Encoding::Srgb
        .encode(Rgb::new(light[0], light[1], light[2]))
        .to_array()
        .map(|share| (share * 255.0 + 0.5) as u8);
    [r, g, b, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYERS: [Layer; 4] = [
        Layer { center: 0.0, reach: 60.0 },
        Layer { center: 100.0, reach: 80.0 },
        Layer { center: 200.0, reach: 40.0 },
        Layer { center: 300.0, reach: 70.0 },
    ];

    #[test]
    fn weights_add_up_to_one_and_pass_without_a_jump() {
        for mode in [Mode::Weights, Mode::Limits] {
            for height in (-500..900).map(f64::from).chain([f64::NAN, f64::INFINITY, -1e300]) {
                assert!((weights(&LAYERS, height, mode).iter().sum::<f64>() - 1.0).abs() < 1e-12, "{height}");
            }
        }
        // Where reaches overlap: from 20 to 60, alone from 60 on.
        assert_eq!(weights(&LAYERS, 10.0, Mode::Weights), [1.0, 0.0, 0.0, 0.0]);
        assert_eq!(weights(&LAYERS, 70.0, Mode::Weights), [0.0, 1.0, 0.0, 0.0]);
        let both = weights(&LAYERS, 40.0, Mode::Weights);
        assert!((both[0] - (1.0 / 3.0) / (1.0 / 3.0 + 0.25)).abs() < 1e-12 && both[2] == 0.0, "{both:?}");
        assert_eq!(weights(&LAYERS, 1e6, Mode::Weights), [0.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn each_height_shows_its_ground() {
        let colors = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 255]];
        let grounds = colors.map(|color| Texels::new(1, 1, vec![color], FirstRow::AtV0).expect("a texel"));
        let grounds = [&grounds[0], &grounds[1], &grounds[2], &grounds[3]];
        let rising = |_: f64, v: f64| v * 400.0 - 50.0;
        let blended = picture(grounds, &LAYERS, Mode::Weights, 8, 3.0, &rising).expect("64 texels");
        // Row 0 is at height -25, row 7 at 325.
        assert_eq!((blended.at(3, 0), blended.at(3, 7)), (colors[0], colors[3]));
        let halfway = picture(grounds, &LAYERS, Mode::Weights, 1, 1.0, &|_, _| 40.0).expect("a texel");
        assert_eq!(halfway.at(0, 0), [199, 175, 0, 255], "4/7 red and 3/7 green, as light");
        assert!(picture(grounds, &LAYERS, Mode::Limits, 0, 1.0, &rising).is_none());
    }
}
