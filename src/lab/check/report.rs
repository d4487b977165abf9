//! What an experiment found: figures, and misses.

use serde::Serialize;
use std::cmp::Ordering;
use std::fmt::Write;

/// What one check found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Name of the check.
    pub name: &'static str,
    /// What should hold.
    pub claim: &'static str,
    /// What was counted and measured, in the order of the experiment.
    pub figures: Vec<Figure>,
    /// What does not hold, one sentence each; empty when the claim stands.
    pub misses: Vec<String>,
}

/// One number of a report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figure {
    /// What it is.
    pub name: String,
    /// How much.
    pub value: Value,
    /// What it may be at most; none for a figure that only informs.
    pub limit: Option<Value>,
}

/// A count or a measure.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A whole number.
    Count(u64),
    /// A real number.
    Measure(f64),
}

/// More misses of one check than this are only counted.
const MOST_MISSES: usize = 20;

impl Report {
    /// An empty report.
    #[must_use]
    pub fn new(name: &'static str, claim: &'static str) -> Report {
        Report { name, claim, figures: Vec::new(), misses: Vec::new() }
    }

    /// A count that informs: how many cases, how hard they were.
    pub fn count(&mut self, name: impl Into<String>, count: u64) {
        self.figures.push(Figure { name: name.into(), value: Value::Count(count), limit: None });
    }

    /// A measure that informs.
    pub fn measure(&mut self, name: impl Into<String>, value: f64) {
        self.figures.push(Figure { name: name.into(), value: Value::Measure(value), limit: None });
    }

    /// A count that must be 0.
    pub fn none(&mut self, name: impl Into<String>, count: u64) {
        self.at_most(name, Value::Count(count), Value::Count(0));
    }

    /// Cases of this kind must have occurred: without them the experiment says nothing about them.
    pub fn some(&mut self, name: impl Into<String>, count: u64) {
        let name = name.into();
        if count == 0 {
            self.miss(format!("no case of `{name}` occurred: the experiment does not test it"));
        }
        self.count(name, count);
    }

    /// A value that must not exceed `limit`; one that is not a number does.
    pub fn at_most(&mut self, name: impl Into<String>, value: Value, limit: Value) {
        let name = name.into();
        if !value.partial_cmp(&limit).is_some_and(Ordering::is_le) {
            self.miss(format!("{name} is {value}, more than {limit}"));
        }
        self.figures.push(Figure { name, value, limit: Some(limit) });
    }

    /// A measure that must lie within `low..=high`.
    pub fn within(&mut self, name: impl Into<String>, value: f64, (low, high): (f64, f64)) {
        let name = name.into();
        if !(low..=high).contains(&value) {
            self.miss(format!("{name} is {value}, not within {low} to {high}"));
        }
        self.figures.push(Figure { name, value: Value::Measure(value), limit: Some(Value::Measure(high)) });
    }

    /// Something that does not hold.
    pub fn miss(&mut self, sentence: impl Into<String>) {
        if self.misses.len() < MOST_MISSES {
            self.misses.push(sentence.into());
        }
    }

    /// Whether the claim stands.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.misses.is_empty()
    }

    /// The report as lines of text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = format!("{}: {}\n", self.name, self.claim);
        for figure in &self.figures {
            let limit = figure.limit.map_or_else(String::new, |limit| format!("  (at most {limit})"));
            let _ = writeln!(text, "  {:>16}  {}{limit}", figure.value.to_string(), figure.name);
        }
        for miss in &self.misses {
            let _ = writeln!(text, "  miss: {miss}");
        }
        text + if self.holds() { "  holds\n" } else { "  DOES NOT HOLD\n" }
    }
}

impl std::fmt::Display for Value {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Value::Count(count) => write!(formatter, "{count}"),
            Value::Measure(value) if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) => {
                write!(formatter, "{value:.3e}")
            }
            Value::Measure(value) => write!(formatter, "{value:.4}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_exceeds_its_limit_is_a_miss() {
        let mut report = Report::new("a", "b");
        report.none("errors", 0);
        report.at_most("share", Value::Measure(0.5), Value::Measure(0.5));
        assert!(report.holds());
        report.at_most("not a number", Value::Measure(f64::NAN), Value::Measure(1.0));
        report.none("errors", 3);
        report.some("ties", 0);
        report.within("slope", 1.6, (1.4, 1.5));
        assert_eq!(report.misses.len(), 4, "{:?}", report.misses);
    }
}
