//! Statements about the whole area: projection, kinds of trees and ground, landmarks.

use super::Reader;
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::{Cover, Form, Mark, Species};
use crate::forest::objects::{SMALLEST_SCALE, Standing};
use crate::forest::paint;
use crate::parse::statements::did_you_mean;
use crate::parse::wording::quote;
use std::path::Path;

/// The largest coordinate of a map.
const FARTHEST: f64 = 1e9;
/// The largest side of a cell.
const LARGEST_SIDE: f64 = 100_000.0;
/// Metres that a picture covers where the file does not say: Landscaper's.
const USUAL_TILE: f64 = 30.0;
/// The most species, and the most covers, of an area.
const MOST_SPECIES: usize = 10_000;
const MOST_COVERS: usize = 255;

impl Reader<'_> {
    /// `crs`, `origin`, `side`, `seed`: before all cells.
    pub(super) fn of_area(&mut self, keyword: &[u8]) -> Result<(), Diagnostic> {
        let span = self.words.keyword;
        match keyword {
            b"crs" => self.head.crs = self.words.text("a projection such as EPSG:32629")?.0,
            b"origin" => {
                let east = self.words.within("metres east of the origin", -FARTHEST..=FARTHEST)?;
                self.head.origin = [east, self.words.within("metres north of the origin", -FARTHEST..=FARTHEST)?];
            }
            b"side" => self.set_side(span)?,
            _ => self.head.seed = self.words.whole("a seed", 0..=u64::MAX)?,
        }
        match self.open.is_some() || self.is_lost {
            true => {
                let error = Diagnostic::error(format!("{} belongs to the whole area", quote(keyword)));
                Err(error.at(span, "too late").help("write it before the first `cell`"))
            }
            false => Ok(()),
        }
    }

    /// The side of all cells, which is said once, or always the same.
    pub(super) fn set_side(&mut self, at: Span) -> Result<(), Diagnostic> {
        let span = self.words.peek().span;
        let side = self.words.within("the side of a cell", 1.0..=LARGEST_SIDE)?;
        if let Some(first) = self.side.filter(|_| self.head.side != side) {
            let message = format!("a cell of {side} m among cells of {} m", self.head.side);
            let error = Diagnostic::error(message).at(span, "another size").at(first, "the side of all cells");
            return Err(error.help("all cells of an area are equally large"));
        }
        if self.side.is_none() && !self.cells.is_empty() && self.head.side != side {
            let message = format!("a cell of {side} m among cells of {} m", self.head.side);
            let error = Diagnostic::error(message).at(span, "another size");
            return Err(error.help("write `side METRES` before the first cell; 240 where nobody does"));
        }
        self.head.side = side;
        self.side = self.side.or(Some(at));
        Ok(())
    }

    /// `species CODE [form WORD] [image FILE]...`
    pub(super) fn species(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        let (code, span) = self.words.text("the species' code")?;
        let mut species = Species { code, form: Form::default(), images: Vec::new(), place };
        loop {
            if self.words.take_field("form") {
                species.form = self.words.choice("form", &Form::ALL)?;
            } else if self.words.take_field("image") {
                species.images.push(self.picture("a picture, or paint:NAME")?);
            } else {
                break;
            }
        }
        if let Some(first) = self.head.species.iter().find(|known| known.code == species.code) {
            return Err(twice("species", &species.code, span, first.place.line));
        }
        if self.head.species.len() == MOST_SPECIES || species.images.len() > 255 {
            let error = Diagnostic::error(format!("more than {MOST_SPECIES} species, or 255 pictures of one"));
            return Err(error.at(span, "this one"));
        }
        self.head.species.push(species);
        Ok(())
    }

    /// `cover NUMBER IMAGE [tile METRES]`
    pub(super) fn cover(&mut self) -> Result<(), Diagnostic> {
        let (place, span) = (self.place(), self.words.peek().span);
        let number = self.words.whole("the cover's number", 0..=u32::MAX)?;
        let image = self.picture("its picture, or paint:NAME")?;
        let has_tile = self.words.take_field("tile");
        let tile = if has_tile { self.words.within("a tile", 0.01..=LARGEST_SIDE)? } else { USUAL_TILE };
        if let Some(first) = self.head.covers.iter().find(|known| known.number == number) {
            return Err(twice("cover", &number.to_string(), span, first.place.line));
        }
        if self.head.covers.len() == MOST_COVERS {
            return Err(Diagnostic::error(format!("more than {MOST_COVERS} covers")).at(span, "this one"));
        }
        self.head.covers.push(Cover { number, image, tile, place });
        Ok(())
    }

    /// The name of a picture; what the program shall paint must be something it can.
    fn picture(&mut self, what: &str) -> Result<String, Diagnostic> {
        let (name, span) = self.words.text(what)?;
        if name.starts_with("paint:") {
            paint::check(&name).map_err(|error| {
                let message = format!("the program cannot paint {}", quote(error.word.as_bytes()));
                Diagnostic::error(message).at(span, "no such picture").help(error.advice)
            })?;
        }
        Ok(name)
    }

    /// `mark "NAME" X Y`: in the cell in hand; before all cells, from the south-west corner of cell 0 0.
    pub(super) fn mark(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        let (name, _) = self.words.text("the landmark's name")?;
        let at = self.place_on_map("the landmark")?;
        self.head.marks.push(Mark { name, at, place });
        Ok(())
    }

    /// A position: in the cell in hand; before all cells, from the south-west corner of cell 0 0. World metres.
    fn place_on_map(&mut self, what: &str) -> Result<[f64; 2], Diagnostic> {
        match self.open.as_ref().map(|open| open.cell.index) {
            Some(index) => {
                let corner = self.head.corner(index);
                let [x, y] = self.position(what)?;
                Ok([corner.x + x, corner.y + y])
            }
            None => {
                let mut metres = || self.words.within("a place on the map", -FARTHEST..=FARTHEST);
                Ok([metres()?, metres()?])
            }
        }
    }

    /// `object FILE X Y [TURN [SCALE]]`: a scene that stands on the land, its place as for `mark`.
    pub(super) fn object(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        let (file, span) = self.words.text("the file of a scene")?;
        let ending = Path::new(&file).extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_lowercase();
        if ["fcell", "fpack", "fmap"].contains(&ending.as_str()) {
            let error = Diagnostic::error(format!("`{file}` is no scene that can stand on an area"));
            return Err(error.at(span, "this file").help("scenes are `.nff`, `.sipp` and `.ftri`"));
        }
        let at = self.place_on_map("the object")?;
        let (mut turn, mut scale) = (0.0, 1.0);
        if !self.words.peek().begins_statement() {
            turn = self.words.within("the turn in degrees", -FARTHEST..=FARTHEST)?;
        }
        if !self.words.peek().begins_statement() {
            scale = self.words.within("the scale", SMALLEST_SCALE..=1.0 / SMALLEST_SCALE)?;
        }
        self.head.objects.push(Standing { file, at, turn, scale, place });
        Ok(())
    }

    /// Index of the species of that code.
    pub(super) fn species_index(&mut self) -> Result<u16, Diagnostic> {
        let word = self.words.word("the code of a species")?;
        let found = self.head.species.iter().position(|species| species.code.as_bytes() == word.bytes);
        found.map(|index| index as u16).ok_or_else(|| {
            let known: Vec<&str> = self.head.species.iter().map(|species| species.code.as_str()).collect();
            let error = Diagnostic::error(format!("there is no species {}", quote(word.bytes)));
            let error = error.at(word.span, "not declared above");
            if known.is_empty() {
                return error.help("declare it first: `species CODE form conifer`");
            }
            error.help(did_you_mean(word.bytes, &known))
        })
    }

    /// Index of the cover of that number.
    pub(super) fn cover_index(&mut self) -> Result<u8, Diagnostic> {
        let span = self.words.peek().span;
        let number: u32 = self.words.whole("the number of a cover", 0..=u32::MAX)?;
        let found = self.head.covers.iter().position(|cover| cover.number == number);
        found.map(|index| index as u8).ok_or_else(|| {
            let error = Diagnostic::error(format!("there is no cover {number}")).at(span, "not declared above");
            error.help(format!("declare it first: `cover {number} paint:grass`"))
        })
    }
}

/// Two things of one name.
pub(super) fn twice(what: &str, name: &str, again: Span, first_line: u32) -> Diagnostic {
    let error = Diagnostic::error(format!("{what} `{name}` is declared twice")).at(again, "again");
    error.help(format!("it was declared on line {first_line}: remove one of them, or give it another name"))
}
