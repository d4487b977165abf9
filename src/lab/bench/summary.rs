//! Many times -> the middle one, the quarters and the least.

use serde::Serialize;

/// What is told of many times, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// The least.
    pub least: f64,
    /// A quarter of the times are below.
    pub low: f64,
    /// Half of the times are below.
    pub median: f64,
    /// A quarter of the times are above.
    pub high: f64,
}

impl Summary {
    /// Of some times; zeros of none.
    #[must_use]
    pub fn of(times: impl IntoIterator<Item = f64>) -> Summary {
        let mut sorted: Vec<f64> = times.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let at = |share| quantile(&sorted, share);
        Summary { least: at(0.0), low: at(0.25), median: at(0.5), high: at(0.75) }
    }
}

/// The value below which `share` of the `sorted` values lie, between two of them in proportion; 0 of none.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return 0.0 };
    let place = share * last as f64;
    let (below, rest) = (place as usize, place.fract());
    let above = (below + 1).min(last);
    sorted[below] + (sorted[above] - sorted[below]) * rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_by_hand() {
        let summary = Summary::of([5.0, 1.0, 2.0, 4.0, 3.0]);
        assert_eq!(summary, Summary { least: 1.0, low: 2.0, median: 3.0, high: 4.0 });
        assert_eq!(Summary::of([1.0, 2.0]), Summary { least: 1.0, low: 1.25, median: 1.5, high: 1.75 });
        assert_eq!(Summary::of([]), Summary::default());
    }
}
