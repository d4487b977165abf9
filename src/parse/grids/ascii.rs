//! ESRI ASCII grids: six or so lines that say where, then the heights as text.
//!
//! ```text
//! ncols 144
//! nrows 144
//! xllcorner -105.5604       or xllcenter: the middle of the sample instead of the corner of its cell
//! yllcorner 40.0904
//! cellsize 0.000833333333   or dx and dy
//! NODATA_value -9999        optional
//! 2350 2346.5 ...           nrows rows from the north
//! ```
//! Words in any case and order, numbers over as many lines as one likes. Cells are squares around their samples: half a cell lies between
//! the corner and the first sample.
//!
//! Source: Esri, "ASCII raster format". Cost: linear in the text.

use super::{GridFile, GridOptions};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span, printable, suggest};
use crate::forest::elevation::{Frame, Grid, SAMPLE_LIMIT, Unit};
use crate::parse::tokens::{self, NotANumber};

const WORDS: [&str; 10] =
    ["ncols", "nrows", "xllcorner", "yllcorner", "xllcenter", "yllcenter", "cellsize", "dx", "dy", "nodata_value"];

pub(super) fn read(file: &GridFile<'_>, options: &GridOptions) -> Result<Grid, Diagnostics> {
    let source = Source::verbatim(&file.name, file.bytes);
    let mut reader = Reader { source: &source, tail: tokens::skip_space(file.bytes) };
    let header = reader.header()?;
    let heights = reader.heights(&header)?;
    file.grid((header.columns, header.rows), heights, header.frame(options.unit))
}

/// What the first lines say.
#[derive(Default)]
struct Header {
    columns: usize,
    rows: usize,
    /// Of the first sample of the last row.
    west: f64,
    south: f64,
    step: [f64; 2],
    nodata: Option<f64>,
}

impl Header {
    /// Degrees where nobody says otherwise and the grid fits on the globe in steps below a tenth: no map has cells of ten centimetres.
    fn frame(&self, unit: Option<Unit>) -> Frame {
        let north = self.south + self.step[1] * (self.rows - 1) as f64;
        let east = self.west + self.step[0] * (self.columns - 1) as f64;
        let on_globe = self.south >= -90.0 && north <= 90.0 && self.west >= -180.0 && east <= 360.0;
        let likely = if on_globe && self.step[0].max(self.step[1]) < 0.1 { Unit::Degrees } else { Unit::Metres };
        Frame { unit: unit.unwrap_or(likely), west: self.west, north, step: self.step }
    }
}

struct Reader<'a> {
    source: &'a Source,
    tail: &'a [u8],
}

impl Reader<'_> {
    fn offset(&self) -> usize {
        self.source.text.len() - self.tail.len()
    }

    fn error(&self, message: String, label: &str, help: impl Into<String>) -> Diagnostics {
        let length = tokens::word(self.tail).len();
        let span = Span::new(self.offset(), self.offset() + length);
        Diagnostics::new(self.source, vec![Diagnostic::error(message).at(span, label).help(help)])
    }

    /// The next word as a number.
    fn number(&mut self, what: &str) -> Result<f64, Diagnostics> {
        match tokens::number(self.tail) {
            Ok(number) => {
                self.tail = tokens::skip_space(&self.tail[number.length..]);
                Ok(number.value)
            }
            Err(_) if self.tail.is_empty() => {
                Err(self.error(format!("the file ends where {what} is expected"), "here", "is the file whole?"))
            }
            Err(NotANumber::TooLarge) => {
                Err(self.error(format!("{what} is too large"), "above 1.8e308", "write a height in metres"))
            }
            Err(NotANumber::Malformed) => {
                let word = printable(tokens::word(self.tail));
                let help =
                    if word.contains(',') { "write a point, not a comma" } else { "write a number, as in 2350.5" };
                Err(self.error(format!("expected {what}, found `{word}`"), "not a number", help))
            }
        }
    }

    fn header(&mut self) -> Result<Header, Diagnostics> {
        let mut values: [Option<f64>; 10] = [None; 10];
        while self.tail.first().is_some_and(u8::is_ascii_alphabetic) {
            let word = String::from_utf8_lossy(tokens::word(self.tail)).to_lowercase();
            let Some(index) = WORDS.iter().position(|known| *known == word) else {
                let help = match suggest(&word, &WORDS) {
                    Some(similar) => format!("did you mean `{similar}`?"),
                    None => format!("there is {}", WORDS.join(", ")),
                };
                return Err(self.error(format!("unknown word `{}`", printable(word.as_bytes())), "here", help));
            };
            if values[index].is_some() {
                return Err(self.error(format!("`{word}` stands here a second time"), "again", "keep one of them"));
            }
            self.tail = tokens::nth_word(self.tail, 1);
            let value = self.number(&format!("the value of `{word}`"))?;
            values[index] = Some(value);
        }
        self.understood(&values)
    }

    /// The header of the values in the order of [`WORDS`].
    fn understood(&self, values: &[Option<f64>; 10]) -> Result<Header, Diagnostics> {
        let missing = |what: &str| {
            let help = "a header has ncols, nrows, xllcorner, yllcorner (or xllcenter, yllcenter) and cellsize";
            self.error(format!("the header has no {what}"), "heights begin here", help)
        };
        let count = |index: usize| {
            let value = values[index].ok_or_else(|| missing(&format!("`{}`", WORDS[index])))?;
            if value.fract() == 0.0 && (2.0..=SAMPLE_LIMIT as f64).contains(&value) {
                return Ok(value as usize);
            }
            let message = format!("`{}` is {value}", WORDS[index]);
            Err(self.error(message, "after this header", "write a whole number of at least 2"))
        };
        let (columns, rows) = (count(0)?, count(1)?);
        let cell = |own: usize| {
            let value = values[own].or(values[6]).ok_or_else(|| missing("`cellsize`"))?;
            if value > 0.0 {
                Ok(value)
            } else {
                Err(self.error(format!("the cell size is {value}"), "after this header", "write a number above 0"))
            }
        };
        let step = [cell(7)?, cell(8)?];
        let origin = |corner: usize, center: usize, step: f64| match (values[corner], values[center]) {
            (Some(at), _) => Ok(at + step / 2.0),
            (None, Some(at)) => Ok(at),
            (None, None) => Err(missing(&format!("`{}`", WORDS[corner]))),
        };
        let (west, south) = (origin(2, 4, step[0])?, origin(3, 5, step[1])?);
        // A height takes two bytes at least; nothing is reserved for what is not there.
        if columns.saturating_mul(rows) > self.tail.len().div_ceil(2) {
            let (found, wanted) = (tokens::count_numbers(self.tail), columns.saturating_mul(rows));
            return Err(self.too_few(found, wanted, (columns, rows)));
        }
        Ok(Header { columns, rows, west, south, step, nodata: values[9] })
    }

    fn too_few(&self, found: usize, wanted: usize, (columns, rows): (usize, usize)) -> Diagnostics {
        let message = format!("{columns} columns and {rows} rows are {wanted} heights, but {found} follow");
        self.error(message, "the heights", "is the file whole? If so, correct `ncols` and `nrows`")
    }

    fn heights(&mut self, header: &Header) -> Result<Vec<f32>, Diagnostics> {
        let wanted = header.columns * header.rows;
        let start = self.tail;
        let mut heights = Vec::with_capacity(wanted);
        while heights.len() < wanted {
            if self.tail.is_empty() {
                self.tail = start;
                return Err(self.too_few(heights.len(), wanted, (header.columns, header.rows)));
            }
            let before = self.tail;
            let value = self.number("a height")?;
            if value.abs() > 1e6 && Some(value) != header.nodata {
                self.tail = before;
                let help = "heights are metres; if it stands for no data, say so: `NODATA_value`";
                let word = printable(tokens::word(before));
                return Err(self.error(format!("{word} m is no height"), "here", help));
            }
            heights.push(if Some(value) == header.nodata { f32::NAN } else { value as f32 });
        }
        if self.tail.is_empty() {
            return Ok(heights);
        }
        let message =
            format!("{} columns and {} rows are {wanted} heights, but more follow", header.columns, header.rows);
        Err(self.error(message, "the first too many", "correct `ncols` and `nrows`"))
    }
}
