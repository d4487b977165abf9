//! Axis: a logarithmic scale with labeled ticks at 1, 2 and 5 times powers of ten.

use crate::math::{log, pow};

/// From values to places on the chart.
pub(super) struct Axis {
    /// Logarithms of the ends.
    range: (f64, f64),
    places: (f64, f64),
    /// Where lines are drawn.
    pub ticks: Vec<Tick>,
}

/// A labeled value.
pub(super) struct Tick {
    pub value: f64,
    pub label: String,
}

impl Axis {
    /// An axis that shows all `values` between the two `places`. Values of 0 stand at its low end.
    pub fn new(values: &[f64], places: (f64, f64)) -> Axis {
        let positive = values.iter().copied().filter(|&value| value > 0.0);
        let (low, high) = positive.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), v| (low.min(v), high.max(v)));
        let (low, high) = if low <= high { (low, high) } else { (0.1, 1.0) };
        let has_zero = values.iter().any(|&value| value <= 0.0);
        // A little air at both ends, and at least a factor of 3 in all.
        let wide = (3.0 * low / high).max(1.0).sqrt();
        let (low, high) = (low / wide / if has_zero { 2.5 } else { 1.15 }, high * wide * 1.15);
        let mut axis = Axis { range: (log(low), log(high)), places, ticks: Vec::new() };
        axis.ticks = axis.round_values((low, high));
        if has_zero {
            axis.ticks.retain(|tick| tick.value > low * 1.5);
            axis.ticks.push(Tick { value: 0.0, label: "0".to_string() });
        }
        axis
    }

    /// The place of a value.
    pub fn place(&self, value: f64) -> f64 {
        let share = (log(value.max(1e-300)) - self.range.0) / (self.range.1 - self.range.0);
        self.places.0 + share.clamp(0.0, 1.0) * (self.places.1 - self.places.0)
    }

    fn round_values(&self, (low, high): (f64, f64)) -> Vec<Tick> {
        let ten = log(10.0);
        let decades = (self.range.1 - self.range.0) / ten;
        let steps: &[f64] = if decades < 3.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let powers = (self.range.0 / ten).floor() as i32..=(self.range.1 / ten).ceil() as i32;
        let values = powers.flat_map(|power| steps.iter().map(move |step| (*step, power)));
        let tick =
            |(step, power): (f64, i32)| Tick { value: step * pow(10.0, f64::from(power)), label: label(step, power) };
        values.map(tick).filter(|tick| (low..=high).contains(&tick.value)).collect()
    }
}

/// `step` times 10 to `power`, without needless digits.
fn label(step: f64, power: i32) -> String {
    match power {
        0..=5 => format!("{}", step * pow(10.0, f64::from(power))),
        -4..=-1 => format!("{:.*}", power.unsigned_abs() as usize, step * pow(10.0, f64::from(power))),
        _ => format!("{step}e{power}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::new(&[0.0, 0.3, 12.0], (100.0, 0.0));
        let labels: Vec<&str> = axis.ticks.iter().map(|tick| tick.label.as_str()).collect();
        assert_eq!(labels, ["0.2", "0.5", "1", "2", "5", "10", "0"]);
        assert_eq!(axis.place(0.0), 100.0);
        assert!(axis.place(12.0) < 10.0 && axis.place(0.3) < 90.0);
        assert!(Axis::new(&[], (0.0, 1.0)).ticks.len() > 1);
        assert_eq!((label(5.0, -6), label(2.0, 3), label(1.0, 7)), ("5e-6".into(), "2000".into(), "1e7".into()));
    }
}
