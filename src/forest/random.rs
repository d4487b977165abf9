//! Random: numbers that look like chance, and are the same wherever and whenever they are asked for.
//!
//! seed of the area, cell, stand, counter -RANDOM-> 64 bits -> places, sizes, colors of trees; invented landscapes
//!
//! Why no generator with a state: whoever asks first would change what the others get. A number here depends only on what it is for,
//! so cells may be loaded in any order, by any thread, and forgotten and loaded again.
//!
//! Space: none. Source: G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014 (the mix and its constants).
//! Cost: two multiplications a number.

/// One step of SplitMix64: every bit of the result depends on every bit of `word`.
#[must_use]
#[inline]
pub fn mix64(word: u64) -> u64 {
    let word = word.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    word ^ (word >> 31)
}

/// The number for a list of words; the order counts.
///
/// ```
/// use farop::forest::random::key;
/// assert_ne!(key(&[1, 2]), key(&[2, 1]));
/// ```
#[must_use]
#[inline]
pub fn key(words: &[u64]) -> u64 {
    words.iter().fold(0, |state, word| mix64(state ^ *word))
}

/// The upper 53 bits as a number from 0 to 1, without 1.
#[must_use]
#[inline]
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

/// Where normal numbers end, in standard deviations.
pub const TRUNCATED_AT: f64 = 2.5;

/// Steps of the table of [`Normal`].
const STEPS: usize = 1024;

/// Normal numbers with mean 0 that end at plus and minus [`TRUNCATED_AT`]: a table of their quantiles, read with linear interpolation.
///
/// Their deviation is 0.955 of what it was before their ends were cut off. Why a table: trees take two numbers each in every frame.
pub struct Normal {
    quantiles: [f32; STEPS + 1],
}

impl Normal {
    /// The table; 1,025 bisections.
    #[must_use]
    pub fn table() -> Normal {
        let below = |z: f64| 0.5 * libm::erfc(-z * std::f64::consts::FRAC_1_SQRT_2);
        let (first, last) = (below(-TRUNCATED_AT), below(TRUNCATED_AT));
        let quantile = |step: usize| {
            let share = first + (last - first) * step as f64 / STEPS as f64;
            let (mut low, mut high) = (-TRUNCATED_AT, TRUNCATED_AT);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if below(middle) < share { low = middle } else { high = middle }
            }
            (0.5 * (low + high)) as f32
        };
        Normal { quantiles: std::array::from_fn(quantile) }
    }

    /// The one table of the program.
    pub fn shared() -> &'static Normal {
        static TABLE: std::sync::LazyLock<Normal> = std::sync::LazyLock::new(Normal::table);
        &TABLE
    }

    /// The normal number at 32 random bits.
    #[must_use]
    #[inline]
    pub fn at(&self, bits: u32) -> f64 {
        let index = (bits >> 22) as usize;
        let share = f64::from(bits & 0x3F_FFFF) / f64::from(1 << 22);
        let (low, high) = (f64::from(self.quantiles[index]), f64::from(self.quantiles[index + 1]));
        low + (high - low) * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normal_numbers_have_the_mean_and_deviation_they_promise() {
        let numbers: Vec<f64> = (0..20_000).map(|index| Normal::shared().at(mix64(index) as u32)).collect();
        let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
        let variance = numbers.iter().map(|z| (z - mean) * (z - mean)).sum::<f64>() / numbers.len() as f64;
        assert!(mean.abs() < 4.0 * 0.955 / 20_000_f64.sqrt(), "{mean}");
        assert!((variance.sqrt() - 0.9546).abs() < 0.02, "{}", variance.sqrt());
        assert!(numbers.iter().all(|z| z.abs() <= TRUNCATED_AT));
    }
}
