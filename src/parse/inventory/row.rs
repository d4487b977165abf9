//! Row: the fields of a row as a record.
//!
//! fields -ROW-> what grows on a stand, or what was done to it
//!
//! What is not known is left empty: deviations are then a tenth of the height, crowns come from DBH or from the form.
//!
//! Space: metres, trees a hectare; DBH in centimetres. Source: see [`super`].

use super::columns::{Columns, Known, name};
use super::csv::Field;
use crate::diagnostic::{Diagnostic, Span, suggest};
use crate::forest::area::{Form, MOST_DENSITY, Plant, SMALLEST, Spread};
use crate::forest::import::{Growth, Record, What};
use crate::parse::wording::quote;
use std::ops::RangeInclusive;

/// The tallest tree, and the widest crown, in metres.
const TALLEST: f64 = 150.0;

/// A row that is being read.
pub(super) struct Row<'a> {
    pub columns: &'a Columns,
    pub row: &'a [Field],
    pub header: &'a [Field],
    pub has_decimal_commas: bool,
}

impl Row<'_> {
    /// The record, and where its stand is named.
    pub fn record(&self) -> Result<(Record, Span), Diagnostic> {
        if let Some(extra) = self
            .row
            .get(self.header.len())
            .filter(|_| self.row[self.header.len()..].iter().any(|field| !field.text.is_empty()))
        {
            let error = Diagnostic::error(format!("{} fields, and {} columns", self.row.len(), self.header.len()));
            return Err(error
                .at(extra.span, "the first one too many")
                .help("a field with a separator in it stands in quotes"));
        }
        let stand = self.needed(Known::Stand)?;
        let year = self.number(Known::Year, -9999.0..=9999.0)?;
        if let (Some(number), Some(field)) = (year.filter(|number| number.fract() != 0.0), self.field(Known::Year)) {
            let error = Diagnostic::error(format!("the year {number} is not whole"));
            return Err(error.at(field.span, "a year was expected").help("write it as 2018"));
        }
        let what = self.what(year.is_some())?;
        let record =
            Record { stand: whole(&stand.text), year: year.map(|number| number as i32), what, origin: String::new() };
        Ok((record, stand.span))
    }

    fn what(&self, has_year: bool) -> Result<What, Diagnostic> {
        let Some(action) = self.field(Known::Action) else { return Ok(What::Grows(self.growth()?)) };
        let what = match action.text.to_lowercase().as_str() {
            "grows" | "none" | "-" => return Ok(What::Grows(self.growth()?)),
            "cut" | "felled" | "harvest" | "harvested" | "clearcut" => What::Cut,
            "burnt" | "burned" | "burn" | "fire" => What::Burnt,
            "replanted" | "replant" | "planted" => {
                What::Replanted { species: self.needed(Known::Species)?.text.clone(), form: self.form()? }
            }
            other => {
                let known = ["cut", "burnt", "replanted", "grows"];
                let error =
                    Diagnostic::error(format!("{} is nothing that is done to a stand", quote(action.text.as_bytes())));
                let error = error.at(action.span, "what became of it?");
                return Err(error.help(match suggest(other, &known) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!("known are {}", known.join(", ")),
                }));
            }
        };
        if has_year {
            return Ok(what);
        }
        let error = Diagnostic::error(format!("since when is the stand {}?", action.text));
        Err(error.at(action.span, "this needs a year").help("write the year in the column `year`"))
    }

    fn growth(&self) -> Result<Growth, Diagnostic> {
        let species = self.needed(Known::Species)?.text.clone();
        self.needed(Known::Height)?;
        self.needed(Known::Density)?;
        let sizes = SMALLEST..=TALLEST;
        let mean = self.number(Known::Height, sizes.clone())?.unwrap_or(SMALLEST);
        let deviation = self.number(Known::HeightDeviation, 0.0..=TALLEST)?.unwrap_or(0.1 * mean);
        let height = Spread { mean, deviation };
        let diameter = self.number(Known::Diameter, 0.0..=1000.0)?;
        let crown = self.number(Known::Crown, sizes)?.or(diameter.map(|diameter| 0.8 + 0.16 * diameter));
        let spread = self.number(Known::CrownDeviation, 0.0..=TALLEST)?;
        let crown = crown.map(|mean| Spread { mean, deviation: spread.unwrap_or(mean * deviation / height.mean) });
        let ratio =
            self.number(Known::CrownRatio, 0.0..=100.0)?.map(|ratio| if ratio > 1.0 { ratio / 100.0 } else { ratio });
        let crown_base = self.number(Known::CrownBase, 0.0..=mean)?.or(ratio.map(|ratio| mean * (1.0 - ratio)));
        Ok(Growth {
            species,
            form: self.form()?,
            height,
            crown,
            density: self.number(Known::Density, 0.0..=MOST_DENSITY)?.unwrap_or(0.0),
            crown_base,
            plant: self.word(Known::Plant, &Plant::ALL)?.unwrap_or_default(),
            cover: self.field(Known::Cover).map(|field| field.text.clone()),
        })
    }

    fn form(&self) -> Result<Option<Form>, Diagnostic> {
        self.word(Known::Form, &Form::ALL)
    }

    fn field(&self, known: Known) -> Option<&Field> {
        self.columns.field(self.row, known)
    }

    fn needed(&self, known: Known) -> Result<&Field, Diagnostic> {
        self.field(known).ok_or_else(|| {
            let last = self.row.last().map_or(Span::default(), |field| field.span);
            let error = Diagnostic::error(format!("a row without {}", name(known)));
            if self.columns.has(known) {
                let first = self.row.first().map_or(last, |field| field.span);
                return error
                    .at(Span { start: first.start, end: last.end }, "in this row")
                    .help("fill it in, or leave the row out");
            }
            error
                .at(last, "in this row")
                .help(format!("the table has no column `{}`; rows that say what grows need it", name(known)))
        })
    }

    /// A number in its range; `None` where there is none.
    fn number(&self, known: Known, range: RangeInclusive<f64>) -> Result<Option<f64>, Diagnostic> {
        let Some(field) = self.field(known) else { return Ok(None) };
        let text = if self.has_decimal_commas { field.text.replace(',', ".") } else { field.text.clone() };
        let what = name(known);
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(|| {
            let error = Diagnostic::error(format!("{} is no number", quote(field.text.as_bytes())));
            error
                .at(field.span, format!("{what} was expected"))
                .help("write it with digits and a point, as 14.2; leave it empty where it is not known")
        })?;
        if range.contains(&number) {
            return Ok(Some(number));
        }
        let error = Diagnostic::error(format!("{what} {number} is not within {} to {}", range.start(), range.end()));
        Err(error
            .at(field.span, "here")
            .help("heights and crowns are in metres, densities in trees a hectare, DBH in centimetres"))
    }

    fn word<T: Copy>(&self, known: Known, words: &[(&'static str, T)]) -> Result<Option<T>, Diagnostic> {
        let Some(field) = self.field(known) else { return Ok(None) };
        let lower = field.text.to_lowercase();
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == lower) {
            return Ok(Some(*value));
        }
        let all: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let error = Diagnostic::error(format!("{} is no {}", quote(field.text.as_bytes()), name(known)));
        let error = error.at(field.span, "here");
        Err(error.help(match suggest(&lower, &all) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!("known are {}", all.join(", ")),
        }))
    }
}

/// `12.0` of a spreadsheet is stand 12.
fn whole(text: &str) -> String {
    let number =
        text.strip_suffix(".0").filter(|number| !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit()));
    number.unwrap_or(text).to_string()
}
