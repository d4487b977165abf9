//! Inventory: a table of stands, as foresters keep it, as records.
//!
//! CSV file -INVENTORY-> records -forest::import-> stands of an area
//!
//! A row is a stand in a year: what grows there, or what was done to it (`action`: cut, burnt, replanted). Heights and crowns are in metres, densities in trees a hectare,
//! DBH in centimetres. A crown that was not measured is estimated from DBH, or from the height when the area is made.
//!
//! Why all mistakes at once: an inventory has a thousand rows and comes from a spreadsheet; up to 20 are told, each with line and column.
//!
//! Space: metres, years. Cost: linear. Source: the columns hold those of SVS and EnVision; crowns from DBH as in FVS, linear, with round numbers of ours.

mod columns;
mod csv;
mod row;

use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span, printable, suggest};
use crate::forest::import::{Record, What};
use crate::parse::wording::quote;
use columns::{Columns, fields, is_field};
use csv::table;
use row::Row;
use std::collections::BTreeMap;
use std::path::Path;

/// The most bytes of a table.
const MOST_BYTES: usize = 1 << 28;
/// Mistakes that are told.
const MOST_ERRORS: usize = 20;

/// Rows of an inventory, and what is worth knowing about them.
#[derive(Clone, Debug)]
pub struct Inventory {
    /// In the order of the file.
    pub records: Vec<Record>,
    /// Columns that are not used, and the like.
    pub notices: Diagnostics,
}

/// Reads a table of stands; `map` says what its columns are called where they have other names (field to column).
///
/// # Errors
/// The file cannot be read, has no rows, misses a column, or has numbers and words that mean nothing, or a stand twice in a year.
pub fn load_inventory(path: &Path, map: &BTreeMap<String, String>) -> Result<Inventory, Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    let refused = |message: String, help: &str| Diagnostics::without_source(Diagnostic::error(message).help(help));
    let bytes = std::fs::read(path).map_err(|error| {
        refused(format!("cannot read `{name}`: {error}"), "is it the right name, and the right folder?")
    })?;
    read_inventory(&name, &bytes, map)
}

/// As [`load_inventory`], for bytes in memory.
///
/// # Errors
/// As [`load_inventory`].
pub fn read_inventory(name: &str, bytes: &[u8], map: &BTreeMap<String, String>) -> Result<Inventory, Diagnostics> {
    let refused = |message: String, help: &str| Diagnostics::without_source(Diagnostic::error(message).help(help));
    if bytes.len() > MOST_BYTES {
        return Err(refused(format!("`{name}` is larger than {MOST_BYTES} bytes"), "split the table"));
    }
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(refused(format!("`{name}` is UTF-16 text"), "save it as UTF-8"));
    }
    if bytes.contains(&0) {
        return Err(refused(format!("`{name}` is no text"), "save the table as CSV: text with commas"));
    }
    let source = Source::verbatim(name, bytes);
    let mut notices = Vec::new();
    match records(&source, map, &mut notices) {
        Ok(records) => Ok(Inventory { records, notices: Diagnostics::new(&source, notices) }),
        Err(errors) => Err(Diagnostics::new(&source, errors)),
    }
}

/// Checks what `--map` wants; fields that it may name are those of a table.
///
/// # Errors
/// What to write instead.
pub fn check_field(field: &str) -> Result<(), String> {
    if is_field(field) || field == "class" || field == "leaf" {
        return Ok(());
    }
    let known = fields();
    Err(match suggest(field, &known) {
        Some(meant) => format!("`{field}` is no field; did you mean `{meant}`?"),
        None => format!("`{field}` is no field; known are {}, and of polygons class, leaf", known.join(", ")),
    })
}

fn records(
    source: &Source,
    map: &BTreeMap<String, String>,
    notices: &mut Vec<Diagnostic>,
) -> Result<Vec<Record>, Vec<Diagnostic>> {
    let table = table(&source.text).map_err(|error| vec![error])?;
    let Some((header, rows)) = table.rows.split_first() else {
        let error = Diagnostic::error(format!("`{}` has no rows", source.name));
        return Err(vec![error.help("the first row names the columns: stand, species, height, density")]);
    };
    let columns = Columns::of(header, map, notices).map_err(|error| vec![error])?;
    let (mut errors, mut found) = (Vec::new(), Vec::new());
    let mut lines = source.lines();
    let mut seen: BTreeMap<(String, Option<i32>), Span> = BTreeMap::new();
    for row in rows {
        let line = lines.at(row[0].span.start);
        let (_, start) = source.line_text(row[0].span.start);
        let reader = Row { columns: &columns, row, header, has_decimal_commas: table.has_decimal_commas };
        match reader.record() {
            Ok((record, span)) => {
                let before = &source.text[start as usize..span.start as usize];
                let column = String::from_utf8_lossy(before).trim_start_matches('\u{FEFF}').chars().count() + 1;
                if let Some(before) = seen.insert((record.stand.clone(), record.year), span) {
                    errors.push(twice(&record, span, before));
                }
                found.push(Record { origin: format!("{}:{line}:{column}", source.name), ..record });
            }
            Err(error) => errors.push(error),
        }
        if errors.len() >= MOST_ERRORS {
            break;
        }
    }
    errors.extend(seen.iter().filter_map(|((stand, year), span)| {
        let other = seen.range((stand.clone(), Some(i32::MIN))..=(stand.clone(), Some(i32::MAX))).next();
        let (_, dated) = other.filter(|((_, dated), _)| year.is_none() && dated.is_some())?;
        let is_measured = found
            .iter()
            .any(|record| record.stand == *stand && record.year.is_some() && matches!(record.what, What::Grows(_)));
        is_measured.then(|| {
            let error = Diagnostic::error(format!(
                "stand {} has a row without a year and rows with one",
                quote(stand.as_bytes())
            ));
            error
                .at(*span, "from when on?")
                .at(*dated, "this one has a year")
                .help("give every row of the stand its year")
        })
    }));
    if found.is_empty() && errors.is_empty() {
        let error = Diagnostic::error(format!("`{}` has no rows below its first one", source.name));
        errors.push(error.help("a row is a stand: its name, species, height, density"));
    }
    if errors.is_empty() { Ok(found) } else { Err(errors) }
}

fn twice(record: &Record, span: Span, before: Span) -> Diagnostic {
    let when = record.year.map_or("without a year".to_string(), |year| format!("in {year}"));
    let error = Diagnostic::error(format!("stand {} is in the table twice {when}", quote(record.stand.as_bytes())));
    error
        .at(span, "again here")
        .at(before, "first here")
        .help("a stand has one species and one row a year; of a mixed one, keep the leading species")
}
