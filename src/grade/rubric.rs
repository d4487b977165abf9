//! Rubric: how many points an aspect is worth, from a TOML file.
//!
//! ```toml
//! [points]
//! "sample position" = 20
//! ties = 0
//! ```
//!
//! Aspects that the file does not name keep their own points. A name that no aspect of the lab has is an error: a slip of the
//! pen must not cost a class its points.

use super::labs::{Aspect, Lab};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Points by aspect.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rubric {
    /// Points of the aspects that it names.
    #[serde(default)]
    points: BTreeMap<String, f64>,
}

impl Rubric {
    /// A rubric for `lab` from the text of a file.
    ///
    /// # Errors
    /// In words: what the text breaks, or which name or number makes no sense.
    pub fn parse(text: &str, lab: &Lab) -> Result<Rubric, String> {
        let rubric: Rubric = toml::from_str(text).map_err(|error| error.to_string().trim_end().to_string())?;
        for (name, &points) in &rubric.points {
            if !lab.aspects.iter().any(|aspect| aspect.name == name) {
                let names: Vec<_> = lab.aspects.iter().map(|aspect| aspect.name).collect();
                return Err(format!("lab {} has no aspect `{name}`; it has {}", lab.name, names.join(", ")));
            }
            if !(points.is_finite() && points >= 0.0) {
                return Err(format!("`{name}` is worth {points} points: at least 0 is expected"));
            }
        }
        Ok(rubric)
    }

    /// The most points of an aspect.
    #[must_use]
    pub fn points(&self, aspect: &Aspect) -> f64 {
        self.points.get(aspect.name).copied().unwrap_or_else(|| f64::from(aspect.points))
    }
}
