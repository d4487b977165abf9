//! Rubric: how many points an aspect is worth, and who sees what of it, from a TOML file.
//!
//! ```toml
//! [points]
//! "sample position" = 20
//! ties = 0
//!
//! [visibility]            # visible (that is what the others are), after_due_date, after_published, hidden
//! slivers = "after_due_date"
//!
//! [hidden]                # of the probes of `--hidden SEED`
//! share = 0.4             # of every aspect's points; half of them where it is not said
//! visibility = "hidden"   # that is what they are where it is not said
//! ```
//!
//! Aspects that the file does not name keep their own points. A name that no aspect of the lab has is an error: a slip of the
//! pen must not cost a class its points.

use super::labs::{Aspect, Lab};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Points by aspect, and who sees them.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rubric {
    /// Points of the aspects that it names.
    #[serde(default)]
    points: BTreeMap<String, f64>,
    /// Who sees them.
    #[serde(default)]
    visibility: BTreeMap<String, Visibility>,
    /// What holds for hidden probes.
    #[serde(default)]
    hidden: HiddenProbes,
}

/// Who sees a result, and when: Gradescope's words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Visibility {
    /// Everybody, at once.
    #[default]
    Visible,
    /// Students, when the assignment is over.
    AfterDueDate,
    /// Students, when grades are published.
    AfterPublished,
    /// Teachers alone.
    Hidden,
}

impl Visibility {
    /// Gradescope's word for it.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["visible", "after_due_date", "after_published", "hidden"][self as usize]
    }
}

/// What holds for hidden probes.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct HiddenProbes {
    /// Of every aspect's points.
    pub share: f64,
    /// Who sees how they ended.
    pub visibility: Visibility,
}

impl Default for HiddenProbes {
    fn default() -> HiddenProbes {
        HiddenProbes { share: 0.5, visibility: Visibility::Hidden }
    }
}

impl Rubric {
    /// A rubric for `lab` from the text of a file.
    ///
    /// # Errors
    /// In words: what the text breaks, or which name or number makes no sense.
    pub fn parse(text: &str, lab: &Lab) -> Result<Rubric, String> {
        let rubric: Rubric = toml::from_str(text).map_err(|error| error.to_string().trim_end().to_string())?;
        for name in rubric.points.keys().chain(rubric.visibility.keys()) {
            if !lab.aspects.iter().any(|aspect| aspect.name == name) {
                let names: Vec<_> = lab.aspects.iter().map(|aspect| aspect.name).collect();
                return Err(format!("lab {} has no aspect `{name}`; it has {}", lab.name, names.join(", ")));
            }
        }
        for (name, &points) in &rubric.points {
            if !(points.is_finite() && points >= 0.0) {
                return Err(format!("`{name}` is worth {points} points: at least 0 is expected"));
            }
        }
        let share = rubric.hidden.share;
        if !(0.0..=1.0).contains(&share) {
            return Err(format!("the share of hidden probes is {share}: a number from 0 to 1 is expected"));
        }
        Ok(rubric)
    }

    /// The most points of an aspect.
    #[must_use]
    pub fn points(&self, aspect: &Aspect) -> f64 {
        self.points.get(aspect.name).copied().unwrap_or_else(|| f64::from(aspect.points))
    }

    /// Who sees an aspect's result.
    #[must_use]
    pub fn visibility(&self, aspect: &str) -> Visibility {
        self.visibility.get(aspect).copied().unwrap_or_default()
    }

    /// What holds for hidden probes.
    #[must_use]
    pub fn hidden(&self) -> HiddenProbes {
        self.hidden
    }
}
