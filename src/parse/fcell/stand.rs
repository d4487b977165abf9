//! Stands: what grows, by year.

use super::Reader;
use super::cell::TALLEST;
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::{MOST_DENSITY, Plant, Spread, Stand, StandState};
use crate::parse::statements::did_you_mean;
use crate::parse::wording::quote;

/// Fields of a `stand`.
pub(super) const FIELDS: &[&str] = &["species", "h", "crown", "dens", "hcb", "year", "plant", "tex", "cover"];

/// What was read of a stand so far.
#[derive(Default)]
struct Draft {
    species: Option<u16>,
    height: Option<Spread>,
    crown: Option<Spread>,
    density: Option<f64>,
    crown_base: Option<f64>,
    year: Option<i32>,
    plant: Plant,
    picture: Option<u8>,
    cover: Option<u8>,
    /// The fields that were there.
    given: Vec<&'static str>,
}

impl Reader<'_> {
    /// `stand NUMBER species CODE h MEAN [SD] crown MEAN [SD] dens N [hcb M] [year Y] [plant WORD] [tex N] [cover N]`
    pub(super) fn stand(&mut self) -> Result<(), Diagnostic> {
        let (place, span) = (self.place(), self.words.peek().span);
        let number: u32 = self.words.whole("the stand's number", 0..=u32::MAX)?;
        let mut draft = Draft::default();
        while let Some(&field) = FIELDS.iter().find(|field| self.words.peek().is(field)) {
            let at = self.words.peek();
            if !self.words.take_field(field) {
                break;
            }
            if draft.given.contains(&field) {
                let error = Diagnostic::error(format!("stand {number} has `{field}` twice")).at(at.span, "again");
                return Err(error.help("remove one of them; other years are `stand` lines of their own"));
            }
            draft.given.push(field);
            self.field(field, &mut draft)?;
        }
        let next = self.words.peek();
        if !next.begins_statement() {
            return Err(self.words.unexpected(next, FIELDS));
        }
        let state = self.state(number, draft)?;
        let is_shared = self.shared.iter().find(|stand| stand.number == number).map(|stand| stand.place.line);
        if let Some(line) = is_shared.filter(|_| self.open.is_some()) {
            return Err(super::header::twice("stand", &number.to_string(), span, line));
        }
        let stands = match &mut self.open {
            Some(open) => &mut open.cell.stands,
            None => &mut self.shared,
        };
        add(stands, Stand { number, states: vec![state], place }, span)
    }

    fn field(&mut self, field: &str, draft: &mut Draft) -> Result<(), Diagnostic> {
        match field {
            "species" => draft.species = Some(self.species_index()?),
            "h" => draft.height = Some(self.spread("the height of trees")?),
            "crown" => draft.crown = Some(self.spread("the crown of trees")?),
            "dens" => draft.density = Some(self.density()?),
            "hcb" => draft.crown_base = Some(self.words.within("the crown base", 0.0..=TALLEST)?),
            "year" => draft.year = Some(self.words.whole("a year", -10_000..=10_000)?),
            "plant" => draft.plant = self.words.choice("way of planting", &Plant::ALL)?,
            "tex" => draft.picture = Some(self.words.whole("the number of a picture", 0..=u8::MAX)?),
            _ => draft.cover = Some(self.cover_index()?),
        }
        Ok(())
    }

    fn spread(&mut self, what: &str) -> Result<Spread, Diagnostic> {
        let mean = self.words.within(what, 0.01..=TALLEST)?;
        let has_deviation = self.words.peek().is_numeric();
        let what = format!("the deviation of {what}");
        let deviation = if has_deviation { self.words.within(&what, 0.0..=TALLEST)? } else { 0.0 };
        Ok(Spread { mean, deviation })
    }

    fn density(&mut self) -> Result<f64, Diagnostic> {
        let word = self.words.peek();
        let density = self.words.number("trees a hectare")?;
        if (0.0..=MOST_DENSITY).contains(&density) {
            return Ok(density);
        }
        let error = Diagnostic::error(format!("{} trees a hectare cannot be", quote(word.bytes)));
        let error = error.at(word.span, format!("expected 0 to {MOST_DENSITY}"));
        Err(error.help("`dens` counts trees a hectare (10,000 m2) on the map: a grown wood has 200 to 2,000"))
    }

    /// The state of a draft, or which field is missing.
    fn state(&self, number: u32, draft: Draft) -> Result<StandState, Diagnostic> {
        let missing = |field: &str| {
            let error = Diagnostic::error(format!("stand {number} has no `{field}`"));
            error.at(self.words.keyword, "this stand").help(super::vocabulary::shape("stand"))
        };
        let height = draft.height.ok_or_else(|| missing("h"))?;
        if let Some(base) = draft.crown_base.filter(|&base| base >= height.mean) {
            let message = format!("the crowns of stand {number} begin at {base} m, above its trees");
            return Err(Diagnostic::error(message).at(self.words.keyword, format!("trees of {} m", height.mean)));
        }
        Ok(StandState {
            year: draft.year,
            species: draft.species.ok_or_else(|| missing("species"))?,
            height,
            crown: draft.crown.ok_or_else(|| missing("crown"))?,
            density: draft.density.ok_or_else(|| missing("dens"))?,
            crown_base: draft.crown_base,
            plant: draft.plant,
            picture: draft.picture,
            cover: draft.cover,
        })
    }

    /// The stand of that number: index into those of the cell in hand. One of the whole area is copied into it.
    pub(super) fn stand_index(&mut self) -> Result<u32, Diagnostic> {
        let word = self.words.peek();
        let number: u32 = self.words.whole("the number of a stand", 0..=u32::MAX)?;
        let shared = self.shared.iter().find(|stand| stand.number == number).cloned();
        let all = self.shared.iter().map(|stand| stand.number.to_string());
        let mut known: Vec<String> = all.collect();
        let stands = &mut self.opened()?.cell.stands;
        if let Some(index) = stands.iter().position(|stand| stand.number == number) {
            return Ok(index as u32);
        }
        if let Some(shared) = shared {
            stands.push(shared);
            return Ok(stands.len() as u32 - 1);
        }
        known.extend(stands.iter().map(|stand| stand.number.to_string()));
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        let error = Diagnostic::error(format!("there is no stand {number}")).at(word.span, "not declared above");
        Err(match known.len() {
            0 => error.help(super::vocabulary::shape("stand")),
            _ => error.help(did_you_mean(word.bytes, &known)),
        })
    }
}

/// Adds a stand, or another year of one.
fn add(stands: &mut Vec<Stand>, stand: Stand, at: Span) -> Result<(), Diagnostic> {
    let Some(known) = stands.iter_mut().find(|known| known.number == stand.number) else {
        stands.push(stand);
        return Ok(());
    };
    let year = stand.states[0].year;
    if let Some(same) = known.states.iter().find(|state| state.year == year || state.year.is_none() || year.is_none()) {
        let says = |year: Option<i32>| year.map_or("without a year".to_string(), |year| format!("of {year}"));
        let message = format!("stand {} has a line {} already", stand.number, says(same.year));
        let error = Diagnostic::error(message).at(at, "again");
        return Err(error
            .help(format!("its first line is {}; every line of a stand needs a `year` of its own", known.place.line)));
    }
    known.states.extend(stand.states);
    Ok(())
}
