//! Owners: whose land each polygon is.
//!
//! polygons, rows of the inventory -OWNERS-> stands with their states, grounds
//!
//! A polygon names its stand in an attribute. A stand with rows has their states; one without gets those of its land use where defaults are wanted, and
//! is left out otherwise. Stands keep their numbers; those with names get the numbers behind, in the order of the file.
//!
//! Space: none. Cost: a look-up a polygon.

use super::kinds::Kinds;
use super::land_use::{self, Use, text_of};
use super::record::Record;
use super::states::states;
use super::{Choices, Sources};
use crate::diagnostic::{Diagnostic, suggest};
use crate::forest::area::{Stand, StandState};
use crate::forest::vector::{Feature, Layer};
use crate::scene::Place;
use std::collections::BTreeMap;

/// What attributes are called that name a stand, where nobody says.
const STAND_NAMES: [&str; 6] = ["stand", "stand_id", "standid", "stand_no", "id_stand", "plot"];
/// How many names a message lists.
const MOST_LISTED: usize = 8;

/// What a polygon became.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owned {
    Stand(u32),
    Ground(u8),
    Nothing,
}

/// Stands and whose rows they are.
pub(super) struct Owners<'a> {
    table: BTreeMap<&'a str, Vec<&'a Record>>,
    plan: BTreeMap<&'a str, Vec<&'a Record>>,
    defaults: Vec<Record>,
    numbers: BTreeMap<String, u32>,
    next: u32,
    /// The stands that came to be, by number.
    pub stands: BTreeMap<u32, (String, Stand)>,
    /// Names without rows, with their first feature and how many there are.
    unmatched: BTreeMap<String, (String, usize)>,
    /// What was left out, and how often.
    pub dropped: BTreeMap<String, usize>,
    /// Rows that a plan goes before.
    planned_away: usize,
}

impl<'a> Owners<'a> {
    pub fn new(sources: &Sources<'a>, choices: &Choices) -> Owners<'a> {
        let by_stand = |records: &'a [Record]| {
            let mut found: BTreeMap<&str, Vec<&Record>> = BTreeMap::new();
            for record in records {
                found.entry(record.stand.as_str()).or_default().push(record);
            }
            found
        };
        let (table, plan) = (by_stand(sources.table), by_stand(sources.plan));
        let names = sources.stands.features.iter().filter_map(|feature| stand_of(feature, choices));
        let largest = names.filter_map(|name| name.parse::<u32>().ok()).max().unwrap_or(0);
        Owners {
            table,
            plan,
            defaults: Vec::new(),
            numbers: BTreeMap::new(),
            next: largest.saturating_add(1),
            stands: BTreeMap::new(),
            unmatched: BTreeMap::new(),
            dropped: BTreeMap::new(),
            planned_away: 0,
        }
    }

    /// Whose land a polygon is.
    ///
    /// # Errors
    /// It does not name its stand, and nobody wants defaults.
    pub fn of(
        &mut self,
        feature: &Feature,
        place: &str,
        choices: &Choices,
        kinds: &mut Kinds,
    ) -> Result<Owned, Diagnostic> {
        let name = stand_of(feature, choices);
        let land_use = if choices.has_defaults { Some(land_use::of(feature, &choices.map)) } else { None };
        if let Some(name) = name.as_deref().filter(|name| self.is_known(name)) {
            return Ok(Owned::Stand(self.stand(name, kinds, choices.year)));
        }
        match (land_use, name) {
            (Some(Use::Trees(name)), _) => {
                if !self.defaults.iter().any(|record| record.stand == name) {
                    self.defaults.extend(land_use::usual_stand(name));
                }
                Ok(Owned::Stand(self.stand(name, kinds, choices.year)))
            }
            (Some(Use::Ground(ground)), _) => Ok(Owned::Ground(kinds.cover(ground))),
            (Some(Use::Nothing(what)), _) => {
                *self.dropped.entry(format!("polygons `{what}`: no ground of its own")).or_default() += 1;
                Ok(Owned::Nothing)
            }
            (None, Some(name)) => {
                self.unmatched.entry(name).or_insert((place.to_string(), 0)).1 += 1;
                *self.dropped.entry("polygons: no row in the table".to_string()).or_default() += 1;
                Ok(Owned::Nothing)
            }
            (None, None) => Err(nameless(feature, place, choices)),
        }
    }

    fn is_known(&self, name: &str) -> bool {
        self.table.contains_key(name) || self.plan.contains_key(name)
    }

    /// The number of a stand, made when it is named for the first time.
    fn stand(&mut self, name: &str, kinds: &mut Kinds, year: Option<i32>) -> u32 {
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        let number = name.parse().unwrap_or_else(|_| {
            self.next = self.next.saturating_add(1);
            self.next - 1
        });
        self.numbers.insert(name.to_string(), number);
        let usual: Vec<&Record> = self.defaults.iter().filter(|record| record.stand == name).collect();
        let rows = self.table.get(name).cloned().unwrap_or(usual);
        let plan = self.plan.get(name).cloned().unwrap_or_default();
        let (states, left_out) = states(&rows, &plan, kinds);
        self.planned_away += left_out;
        let stand = in_year(Stand { number, states, place: Place::default() }, year);
        self.stands.insert(number, (name.to_string(), stand));
        number
    }

    /// What the table and the polygons do not know of each other.
    pub fn notices(&self) -> Vec<Diagnostic> {
        let mut notices = Vec::new();
        if !self.unmatched.is_empty() {
            let names = listed(self.unmatched.iter().map(|(name, (place, _))| format!("`{name}` ({place})")));
            let message = format!("{} stands have polygons and no row in the table: {names}", self.unmatched.len());
            let help = match self.closest() {
                Some((name, meant)) => format!("did `{name}` mean `{meant}`? Else add rows for them"),
                None => "add rows for them, or `--defaults` for land as OpenStreetMap names it".to_string(),
            };
            notices.push(Diagnostic::notice(message).help(help));
        }
        let without = |rows: &BTreeMap<&str, Vec<&Record>>| {
            let lost = rows.iter().filter(|(name, _)| !self.numbers.contains_key(**name));
            lost.filter_map(|(name, rows)| rows.first().map(|row| format!("`{name}` ({})", row.origin)))
                .collect::<Vec<_>>()
        };
        for (rows, what) in [(&self.table, "in the table"), (&self.plan, "in the plan")] {
            let lost = without(rows);
            if !lost.is_empty() {
                let message =
                    format!("{} stands are {what} and have no polygon: {}", lost.len(), listed(lost.iter().cloned()));
                notices.push(
                    Diagnostic::notice(message)
                        .help("is the attribute that names stands the right one? `--map ATTRIBUTE=stand`"),
                );
            }
        }
        if self.planned_away > 0 {
            let message = format!("the plan goes before {} rows of the table", self.planned_away);
            notices.push(Diagnostic::notice(message).help("rows of the year of a plan's deed and later are left out"));
        }
        notices
    }

    fn closest(&self) -> Option<(&str, &str)> {
        let known: Vec<&str> = self.table.keys().copied().collect();
        self.unmatched.keys().find_map(|name| suggest(name, &known).map(|meant| (name.as_str(), meant)))
    }
}

/// What the polygon calls its stand.
fn stand_of(feature: &Feature, choices: &Choices) -> Option<String> {
    let told = choices.map.get("stand");
    let names = told
        .map(String::as_str)
        .into_iter()
        .chain(if told.is_some() { &[][..] } else { &STAND_NAMES[..] }.iter().copied());
    names.into_iter().find_map(|name| text_of(feature, name)).filter(|name| !name.is_empty())
}

fn nameless(feature: &Feature, place: &str, choices: &Choices) -> Diagnostic {
    let wanted = choices.map.get("stand").map_or("stand", String::as_str);
    let known: Vec<&str> = feature.attributes.keys().map(String::as_str).collect();
    let error = Diagnostic::error(format!("{place}: no attribute `{wanted}` names the stand"));
    error.help(match (suggest(wanted, &known), known.is_empty()) {
        (Some(meant), _) => format!("did you mean `--map {meant}=stand`?"),
        (None, true) => "it has no attributes at all".to_string(),
        (None, false) => format!(
            "say which it is, `--map ATTRIBUTE=stand`; it has {}",
            listed(known.iter().map(|name| format!("`{name}`")))
        ),
    })
}

/// A stand as it is in a year, for good.
fn in_year(mut stand: Stand, year: Option<i32>) -> Stand {
    if let (Some(_), Some(state)) = (year, stand.in_year(year).cloned()) {
        stand.states = vec![StandState { year: None, ..state }];
    }
    stand
}

/// Some names, and how many more there are.
fn listed(names: impl Iterator<Item = String>) -> String {
    let mut names: Vec<String> = names.collect();
    let more = names.len().saturating_sub(MOST_LISTED);
    names.truncate(MOST_LISTED);
    if more > 0 { format!("{} and {more} more", names.join(", ")) } else { names.join(", ") }
}

/// Where a feature was read: what messages begin with.
pub(super) fn place_of(layer: &Layer, feature: &Feature, index: usize) -> String {
    let file = layer.files.get(usize::from(feature.place.file)).unwrap_or(&layer.name);
    let line = if feature.place.line > 0 { format!(":{}", feature.place.line) } else { String::new() };
    format!("{file}{line}: feature {}", index + 1)
}
