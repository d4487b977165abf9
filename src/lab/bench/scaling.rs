//! Scaling: by which power of the size times grow.
//!
//! (size, time) pairs -SCALING-> exponent
//!
//! An exponent of 1 is linear: twice as much takes twice as long. Below 1 something does not grow with the size; above 1 the size
//! itself costs, caches that are left above all.

/// The sides of the pictures that are drawn for the exponent in pixels.
pub const SIDES: [u32; 8] = [64, 128, 256, 512, 1024, 2048, 4096, 8192];

/// The exponent of the line nearest to all pairs where both axes are logarithmic; `None` below two different sizes.
#[must_use]
pub fn exponent(pairs: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = pairs.iter().filter(|pair| pair.0 > 0.0 && pair.1 > 0.0).map(log).collect();
    let count = logs.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|pair| pair.0), mean(|pair| pair.1));
    let spread: f64 = logs.iter().map(|pair| (pair.0 - x) * (pair.0 - x)).sum();
    let together: f64 = logs.iter().map(|pair| (pair.0 - x) * (pair.1 - y)).sum();
    (logs.len() > 1 && spread > 0.0).then(|| together / spread)
}

/// The exponent between each pair and the one before it.
#[must_use]
pub fn steps(pairs: &[(f64, f64)]) -> Vec<Option<f64>> {
    let mut steps = vec![None; pairs.len().min(1)];
    steps.extend(pairs.windows(2).map(exponent));
    steps
}

fn log(pair: &(f64, f64)) -> (f64, f64) {
    (pair.0.ln(), pair.1.ln())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found_again() {
        let pairs: Vec<(f64, f64)> = [10.0f64, 100.0, 1000.0].map(|size| (size, 3.0 * size * size)).to_vec();
        assert!((exponent(&pairs).expect("three sizes") - 2.0).abs() < 1e-12);
        let steps: Vec<_> = steps(&pairs).into_iter().flatten().collect();
        assert!(steps.len() == 2 && steps.iter().all(|step| (step - 2.0).abs() < 1e-12), "{steps:?}");
        assert_eq!(exponent(&pairs[..1]), None);
        assert_eq!(exponent(&[(5.0, 1.0), (5.0, 2.0)]), None);
    }
}
