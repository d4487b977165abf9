//! Planes: pictures of one number a pixel, and filters over them, for the metrics.
//!
//! Space: pixels from the top left. Cost: two rows of weights a pixel, one across and one down.

use crate::math::exp;

/// One number a pixel, row after row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Plane {
    pub width: usize,
    pub height: usize,
    pub values: Vec<f64>,
    /// What filters see outside: the nearest pixel, or nothing.
    pub repeat: bool,
}

impl Plane {
    /// Pixel by pixel product.
    pub fn times(&self, other: &Plane) -> Plane {
        let values = self.values.iter().zip(&other.values).map(|(a, b)| a * b).collect();
        Plane { values, ..*self }
    }
}

/// `2 radius + 1` weights of a Gaussian that sum to 1.
pub(super) fn gaussian(radius: usize, deviation: f64) -> Vec<f64> {
    let at = |index: usize| (index as f64 - radius as f64) / deviation;
    let weights: Vec<f64> = (0..=2 * radius).map(|index| exp(-at(index) * at(index) / 2.0)).collect();
    let sum: f64 = weights.iter().sum();
    weights.iter().map(|weight| weight / sum).collect()
}

/// The sum of the pixels around each pixel, weighted by the product of `across` and `down`.
pub(super) fn separable(plane: &Plane, across: &[f64], down: &[f64]) -> Plane {
    let turned = turn(&along_rows(plane, across));
    turn(&along_rows(&turned, down))
}

fn along_rows(plane: &Plane, weights: &[f64]) -> Plane {
    let radius = weights.len() / 2;
    let mut values = Vec::with_capacity(plane.values.len());
    let mut padded = Vec::new();
    for row in plane.values.chunks_exact(plane.width.max(1)) {
        let (first, last) = if plane.repeat { (row[0], row[row.len() - 1]) } else { (0.0, 0.0) };
        padded.clear();
        padded.resize(radius, first);
        padded.extend_from_slice(row);
        padded.resize(row.len() + 2 * radius, last);
        values.extend(
            padded.windows(weights.len()).map(|near| near.iter().zip(weights).map(|(a, b)| a * b).sum::<f64>()),
        );
    }
    Plane { values, ..*plane }
}

/// Rows become columns.
fn turn(plane: &Plane) -> Plane {
    let mut values = Vec::with_capacity(plane.values.len());
    for x in 0..plane.width {
        values.extend((0..plane.height).map(|y| plane.values[y * plane.width + x]));
    }
    Plane { width: plane.height, height: plane.width, values, repeat: plane.repeat }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_see_their_neighborhood() {
        let dot = |repeat| Plane { width: 3, height: 2, values: vec![4.0, 0.0, 0.0, 0.0, 0.0, 0.0], repeat };
        let (across, down) = ([0.25, 0.5, 0.25], [0.0, 1.0, 0.0]);
        assert_eq!(separable(&dot(false), &across, &down).values, [2.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(separable(&dot(true), &across, &down).values, [3.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(separable(&dot(true), &[0.0, 1.0, 0.0], &across).values, [3.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
        let weights = gaussian(5, 1.5);
        assert!(
            (weights.iter().sum::<f64>() - 1.0).abs() < 1e-15 && weights[5] > weights[4] && weights[0] == weights[10]
        );
    }
}
