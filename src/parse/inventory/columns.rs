//! Columns: what the columns of an inventory are, by the names that people give them.
//!
//! first row, `--map NAME=FIELD` -COLUMNS-> the column of each field
//!
//! Names do not distinguish capitals; blanks and hyphens count as `_`. A name that nobody knows is told and not used.
//!
//! Space: none. Cost: none to speak of.

use super::csv::Field;
use crate::diagnostic::{Diagnostic, suggest};
use crate::parse::wording::quote;
use std::collections::BTreeMap;

/// A field of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Known {
    Stand,
    Species,
    Form,
    Height,
    HeightDeviation,
    Crown,
    CrownDeviation,
    Density,
    CrownBase,
    CrownRatio,
    Diameter,
    Year,
    Action,
    Plant,
    Cover,
}

/// Every field, what `--map` calls it, and what else columns are called.
const NAMES: [(Known, &str, &[&str]); 15] = [
    (Known::Stand, "stand", &["stand_id", "standid", "stand_no", "id", "plot"]),
    (Known::Species, "species", &["spp", "sp", "species_code", "code"]),
    (Known::Form, "form", &["shape"]),
    (Known::Height, "height", &["h", "ht", "height_m", "mean_height"]),
    (Known::HeightDeviation, "sd", &["height_sd", "sd_height", "h_sd", "sd_h"]),
    (Known::Crown, "crown", &["crown_m", "crown_diameter", "crown_width", "cw"]),
    (Known::CrownDeviation, "crown_sd", &["sd_crown", "cw_sd"]),
    (Known::Density, "density", &["dens", "trees_ha", "trees_per_ha", "tph", "n_ha", "stems_ha", "trees/ha"]),
    (Known::CrownBase, "hcb", &["crown_base", "base", "height_to_crown"]),
    (Known::CrownRatio, "crown_ratio", &["live_crown_ratio", "lcr", "cr"]),
    (Known::Diameter, "dbh", &["dbh_cm", "diameter", "d"]),
    (Known::Year, "year", &["from", "from_year", "date"]),
    (Known::Action, "action", &["event", "treatment", "deed"]),
    (Known::Plant, "plant", &["planting", "pattern"]),
    (Known::Cover, "cover", &["ground", "floor"]),
];

/// Which column holds which field.
pub(super) struct Columns {
    places: BTreeMap<Known, usize>,
}

impl Columns {
    /// The columns of a table; names that are not known become notices.
    ///
    /// # Errors
    /// A field twice, or one that rows cannot do without is missing.
    pub fn of(
        header: &[Field],
        map: &BTreeMap<String, String>,
        notices: &mut Vec<Diagnostic>,
    ) -> Result<Columns, Diagnostic> {
        let mut places: BTreeMap<Known, usize> = BTreeMap::new();
        for (index, field) in header.iter().enumerate() {
            let Some(known) = known(&mapped(&field.text, map)) else {
                notices.extend(unused(field, index));
                continue;
            };
            if let Some(before) = places.insert(known, index) {
                let message = format!("two columns hold the {}", name(known));
                let error =
                    Diagnostic::error(message).at(field.span, "the second").at(header[before].span, "the first");
                return Err(error.help("leave one out, or give it another name"));
            }
        }
        let columns = Columns { places };
        let mut needed = vec![Known::Stand];
        if !columns.has(Known::Action) {
            needed.extend([Known::Species, Known::Height, Known::Density]);
        }
        let missing: Vec<&str> = needed.into_iter().filter(|known| !columns.has(*known)).map(name).collect();
        if missing.is_empty() {
            return Ok(columns);
        }
        let message = format!(
            "the table has no column {}",
            missing.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
        );
        let error = Diagnostic::error(message);
        let error = match header.last() {
            Some(last) => error.at(
                crate::diagnostic::Span { start: header[0].span.start, end: last.span.end },
                "these are its columns",
            ),
            None => error,
        };
        Err(error.help(format!("name it so in the first row, or say which it is: `--map NAME={}`", missing[0])))
    }

    pub fn has(&self, known: Known) -> bool {
        self.places.contains_key(&known)
    }

    /// The field of a row, if there is something in it.
    pub fn field<'a>(&self, row: &'a [Field], known: Known) -> Option<&'a Field> {
        row.get(*self.places.get(&known)?).filter(|field| !field.text.is_empty())
    }
}

/// What messages and `--map` call a field.
pub(super) fn name(known: Known) -> &'static str {
    NAMES.iter().find(|entry| entry.0 == known).map_or("", |entry| entry.1)
}

/// Whether `--map` may name it.
pub(super) fn is_field(name: &str) -> bool {
    NAMES.iter().any(|entry| entry.1 == name)
}

/// All names that `--map` may say.
pub(super) fn fields() -> Vec<&'static str> {
    NAMES.iter().map(|entry| entry.1).collect()
}

fn plain(name: &str) -> String {
    name.trim().to_lowercase().replace([' ', '-', '.'], "_")
}

/// The name of a column, as `--map` wants it.
fn mapped(name: &str, map: &BTreeMap<String, String>) -> String {
    map.iter().find(|(_, column)| plain(column) == plain(name)).map_or_else(|| plain(name), |(field, _)| field.clone())
}

fn known(name: &str) -> Option<Known> {
    NAMES.iter().find(|(_, own, others)| *own == name || others.contains(&name)).map(|entry| entry.0)
}

fn unused(field: &Field, index: usize) -> Option<Diagnostic> {
    if field.text.is_empty() {
        return None;
    }
    let notice =
        Diagnostic::notice(format!("column {} of the table, {}, is not used", index + 1, quote(field.text.as_bytes())));
    let known = fields();
    Some(notice.at(field.span, "this one").help(match suggest(&plain(&field.text), &known) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("used are {}", known.join(", ")),
    }))
}
