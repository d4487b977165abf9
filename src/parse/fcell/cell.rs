//! Cells, and what stands in them one by one: measured trees, roads, rivers.

use super::Reader;
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::{Cell, Ground, Line, MeasuredTree};
use crate::parse::wording::{plain, quote};

/// The farthest column and row of a cell.
const FARTHEST: i32 = 1_000_000;
/// How far beyond the border of a cell a position is still meant to be on it, in metres.
const TOLERANCE: f64 = 1e-3;
/// The tallest tree and the widest crown, in metres.
pub(super) const TALLEST: f64 = 200.0;
/// The most points of a line or corners of a ring.
pub(super) const MOST_CORNERS: usize = 100_000;
/// Kinds of lines that are drawn each in its own way.
pub(super) const KINDS: [&str; 3] = ["road", "path", "river"];

/// The cell in hand.
pub(super) struct Open {
    pub cell: Cell,
    /// Its index in the text.
    pub span: Span,
    /// The first statement that gave it heights.
    pub ground: Option<Span>,
}

impl Reader<'_> {
    /// `cell COLUMN ROW [size METRES] [seed NUMBER]`
    pub(super) fn cell(&mut self) -> Result<(), Diagnostic> {
        self.close_cell();
        self.is_lost = true;
        let (place, first) = (self.place(), self.words.peek().span);
        let index = [self.cell_number("column")?, self.cell_number("row")?];
        let mut seed = 0;
        loop {
            if self.words.take_field("size") {
                let keyword = self.words.keyword;
                self.set_side(keyword)?;
            } else if self.words.take_field("seed") {
                seed = self.words.whole("a seed", 0..=u64::MAX)?;
            } else {
                break;
            }
        }
        if let Some(known) = self.cells.get(&index) {
            let error = Diagnostic::error(format!("cell {} {} comes twice", index[0], index[1])).at(first, "again");
            return Err(error.help(format!("it was declared on line {}: remove one of them", known.place.line)));
        }
        let ground = Ground::Mesh { vertices: Vec::new(), triangles: Vec::new() };
        let (stands, patches, trees, lines) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let cell = Cell { index, seed, cover: None, ground, stands, patches, trees, lines, place };
        self.open = Some(Open { cell, span: self.words.keyword, ground: None });
        self.is_lost = false;
        Ok(())
    }

    fn cell_number(&mut self, what: &str) -> Result<i32, Diagnostic> {
        self.words.whole(&format!("the {what} of a cell"), -FARTHEST..=FARTHEST)
    }

    /// Puts the cell in hand to the others, or tells what it lacks.
    pub(super) fn close_cell(&mut self) {
        self.is_lost = false;
        let Some(mut open) = self.open.take() else { return };
        let [column, row] = open.cell.index;
        if open.ground.is_none() {
            let error = Diagnostic::error(format!("cell {column} {row} has no ground")).at(open.span, "this cell");
            self.errors.push(error.help("give it heights: `dem 2 2 0 0 0 0` is flat"));
        }
        if let (Ground::Mesh { triangles, .. }, Some(first), false) = (&open.cell.ground, open.ground, self.is_lost)
            && triangles.is_empty()
            && self.errors.is_empty()
        {
            let error = Diagnostic::error(format!("cell {column} {row} has vertices and no triangles"));
            self.errors.push(error.at(first, "the first vertex").help("write `t 0 1 2` behind them"));
        }
        if let Ground::Lattice { counts, .. } = &open.cell.ground
            && counts.iter().all(|&count| count == Ground::VOID)
        {
            let message = format!("cell {column} {row} has no height that was measured: its ground is not drawn");
            self.oddities.push(Diagnostic::notice(message).at(open.ground.unwrap_or(open.span), "all are voids"));
        }
        for stand in &mut open.cell.stands {
            stand.states.sort_by_key(|state| state.year);
        }
        self.cells.insert(open.cell.index, open.cell);
    }

    /// The cell in hand, for a statement that needs one.
    pub(super) fn opened(&mut self) -> Result<&mut Open, Diagnostic> {
        if self.is_lost && self.open.is_none() {
            // The mistake in its head was told; one cell less does not make more mistakes.
            let cell = Cell {
                index: [i32::MIN; 2],
                seed: 0,
                cover: None,
                ground: Ground::Mesh { vertices: Vec::new(), triangles: Vec::new() },
                stands: Vec::new(),
                patches: Vec::new(),
                trees: Vec::new(),
                lines: Vec::new(),
                place: crate::scene::Place::default(),
            };
            self.open = Some(Open { cell, span: self.words.keyword, ground: Some(self.words.keyword) });
        }
        let (span, keyword) = (self.words.keyword, quote(self.words.keyword_text()));
        self.open.as_mut().ok_or_else(|| {
            let error = Diagnostic::error(format!("{keyword} outside of a cell")).at(span, "belongs to no cell");
            error.help("write `cell COLUMN ROW` above it")
        })
    }

    /// A position in the cell; on the border where it is beyond it by less than [`TOLERANCE`].
    pub(super) fn position(&mut self, what: &str) -> Result<[f64; 2], Diagnostic> {
        let start = self.words.peek().span;
        let mut at = [self.words.number(&format!("x of {what}"))?, 0.0];
        let end = self.words.peek().span;
        at[1] = self.words.number(&format!("y of {what}"))?;
        let side = self.head.side;
        let on_one_line = self.lines.clone().at(start.start) == self.lines.clone().at(end.start);
        let span = if on_one_line { Span { start: start.start, end: end.end } } else { start };
        if !at.iter().all(|metres| (-TOLERANCE..=side + TOLERANCE).contains(metres)) {
            let error = Diagnostic::error(format!("{what} lies outside of its cell"));
            let error = error.at(span, format!("expected two numbers from 0 to {side}"));
            return Err(error.help(
                "positions are metres from the south-west corner of the cell; cut at its border what is larger",
            ));
        }
        let inside = at.map(|metres| metres.clamp(0.0, side));
        if inside != at {
            self.moved = (self.moved.0 + 1, if self.moved.0 == 0 { span } else { self.moved.1 });
        }
        Ok(inside)
    }

    /// `n` and as many positions.
    pub(super) fn positions(&mut self, least: usize, what: &str) -> Result<Vec<[f64; 2]>, Diagnostic> {
        let declared = self.words.peek().span;
        let count: usize = self.words.whole(&format!("the number of {what}s"), least..=MOST_CORNERS)?;
        let mut positions = Vec::new();
        for found in 0..count {
            let next = self.words.peek();
            if next.begins_statement() || next.is("hole") {
                let keyword = plain(self.words.keyword_text());
                let error = Diagnostic::error(format!("`{keyword}` declares {count} {what}s but only {found} follow"));
                let error = error.at(declared, "declared here").at(next.span, "expected two numbers, `x y`");
                return Err(error.help(format!("write {found}, or add what is missing")));
            }
            positions.push(self.position(&format!("a {what}"))?);
        }
        Ok(positions)
    }

    /// `tree CODE X Y HEIGHT CROWN [TURN]`
    pub(super) fn tree(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        self.opened()?;
        let species = self.species_index()?;
        let at = self.position("a tree")?;
        let height = self.words.within("the height of a tree", 0.01..=TALLEST)?;
        let crown = self.words.within("the crown of a tree", 0.01..=TALLEST)?;
        let has_turn = self.words.peek().is_numeric();
        let turn = if has_turn { self.words.within("the turn of a tree", -360.0..=360.0)? } else { 0.0 };
        self.opened()?.cell.trees.push(MeasuredTree { species, at, height, crown, turn, place });
        Ok(())
    }

    /// `line KIND w METRES N X Y ...`
    pub(super) fn line(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        self.opened()?;
        let (kind, span) = self.words.text("road, path or river")?;
        if !KINDS.contains(&kind.as_str()) {
            let message = format!("{} is drawn like a path", quote(kind.as_bytes()));
            let help = crate::parse::statements::did_you_mean(kind.as_bytes(), &KINDS);
            self.oddities.push(Diagnostic::notice(message).at(span, "a kind that is not known").help(help));
        }
        if !self.words.take_field("w") {
            let next = self.words.peek();
            let error = Diagnostic::error("a line without a width").at(next.span, "expected `w` and metres");
            return Err(error.help(super::vocabulary::shape("line")));
        }
        let width = self.words.within("the width of a line", 0.01..=self.head.side)?;
        let points = self.positions(2, "point")?;
        self.opened()?.cell.lines.push(Line { kind, width, points, place });
        Ok(())
    }
}
