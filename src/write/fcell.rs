//! Writes `.fcell`: an area of forest as text, cell after cell.
//!
//! Cells (Area or Pack) -WRITE FCELL-> text -parse::fcell-> the same Area
//!
//! Every number reads back to the same bits. Cells are written as they are loaded, so a pack of any size can be looked at as text.
//! Language: `docs/fcell.md`. Cost: one cell in memory.

use super::number::write_number;
use crate::forest::area::{Cell, Cover, Form, Ground, Head, Line, Owner, Patch, Plant, Stand, StandState};
use crate::forest::cells::Cells;
use std::io::{self, Write};

/// Writes an area as `.fcell`.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidData`] for a number that is infinite or not a number, for a name that no text can hold (`"`,
/// `#`, a line break, nothing), and for a cell of a pack that cannot be loaded.
pub fn write_fcell(cells: &Cells, out: &mut dyn Write) -> io::Result<()> {
    let head = cells.head();
    let mut printer = Printer { head, out };
    printer.head()?;
    for index in cells.indices() {
        let cell = cells.load(index).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
        cell.map_or(Ok(()), |cell| printer.cell(&cell))?;
    }
    writeln!(printer.out, "end")
}

struct Printer<'a> {
    head: &'a Head,
    out: &'a mut dyn Write,
}

impl Printer<'_> {
    fn head(&mut self) -> io::Result<()> {
        let head = self.head;
        writeln!(self.out, "fcell 1")?;
        if !head.crs.is_empty() {
            write!(self.out, "crs")?;
            self.name(&head.crs)?;
            writeln!(self.out)?;
        }
        write!(self.out, "origin")?;
        self.numbers(&head.origin)?;
        write!(self.out, "\nside")?;
        self.numbers(&[head.side])?;
        writeln!(self.out, "\nseed {}", head.seed)?;
        for species in &head.species {
            write!(self.out, "species")?;
            self.name(&species.code)?;
            write!(self.out, " form {}", word(&Form::ALL, species.form))?;
            for image in &species.images {
                write!(self.out, " image")?;
                self.name(image)?;
            }
            writeln!(self.out)?;
        }
        for Cover { number, image, tile, .. } in &head.covers {
            write!(self.out, "cover {number}")?;
            self.name(image)?;
            write!(self.out, " tile")?;
            self.numbers(&[*tile])?;
            writeln!(self.out)?;
        }
        for mark in &head.marks {
            write!(self.out, "mark")?;
            self.name(&mark.name)?;
            self.numbers(&mark.at)?;
            writeln!(self.out)?;
        }
        for object in &head.objects {
            write!(self.out, "object")?;
            self.name(&object.file)?;
            self.numbers(&[object.at[0], object.at[1], object.turn, object.scale])?;
            writeln!(self.out)?;
        }
        Ok(())
    }

    fn cell(&mut self, cell: &Cell) -> io::Result<()> {
        let [column, row] = cell.index;
        writeln!(self.out, "cell {column} {row} seed {}", cell.seed)?;
        if let Some(cover) = cell.cover {
            writeln!(self.out, "ground {}", self.cover(cover)?)?;
        }
        self.ground(&cell.ground)?;
        cell.stands.iter().try_for_each(|stand| self.stand(stand))?;
        for (index, patch) in cell.patches.iter().enumerate() {
            self.patch(index + 1, patch, &cell.stands)?;
        }
        for tree in &cell.trees {
            let species = self.head.species.get(usize::from(tree.species)).ok_or_else(missing)?;
            write!(self.out, "tree")?;
            self.name(&species.code)?;
            self.numbers(&[tree.at[0], tree.at[1], tree.height, tree.crown, tree.turn])?;
            writeln!(self.out)?;
        }
        cell.lines.iter().try_for_each(|line| self.line(line))
    }

    fn ground(&mut self, ground: &Ground) -> io::Result<()> {
        match ground {
            Ground::Lattice { size: [columns, rows], base, step, counts } => {
                write!(self.out, "dem {columns} {rows} z0")?;
                self.numbers(&[*base])?;
                write!(self.out, " dz")?;
                self.numbers(&[*step])?;
                writeln!(self.out)?;
                for row in counts.chunks(usize::from(*columns).max(1)) {
                    for count in row {
                        let void = *count == Ground::VOID;
                        if void { write!(self.out, " -")? } else { write!(self.out, " {count}")? }
                    }
                    writeln!(self.out)?;
                }
            }
            Ground::Mesh { vertices, triangles } => {
                for vertex in vertices {
                    write!(self.out, "v")?;
                    self.numbers(&vertex.to_array())?;
                    writeln!(self.out)?;
                }
                for ([a, b, c], cover) in triangles {
                    write!(self.out, "t {a} {b} {c}")?;
                    if let Some(cover) = cover {
                        write!(self.out, " cover {}", self.cover(*cover)?)?;
                    }
                    writeln!(self.out)?;
                }
            }
        }
        Ok(())
    }

    fn stand(&mut self, stand: &Stand) -> io::Result<()> {
        stand.states.iter().try_for_each(|state| self.state(stand.number, state))
    }

    fn state(&mut self, number: u32, state: &StandState) -> io::Result<()> {
        let species = self.head.species.get(usize::from(state.species)).ok_or_else(missing)?;
        write!(self.out, "stand {number} species")?;
        self.name(&species.code)?;
        for (field, spread) in [("h", state.height), ("crown", state.crown)] {
            write!(self.out, " {field}")?;
            self.numbers(&[spread.mean, spread.deviation])?;
        }
        write!(self.out, " dens")?;
        self.numbers(&[state.density])?;
        if let Some(base) = state.crown_base {
            write!(self.out, " hcb")?;
            self.numbers(&[base])?;
        }
        if let Some(year) = state.year {
            write!(self.out, " year {year}")?;
        }
        write!(self.out, " plant {}", word(&Plant::ALL, state.plant))?;
        if let Some(picture) = state.picture {
            write!(self.out, " tex {picture}")?;
        }
        if let Some(cover) = state.cover {
            write!(self.out, " cover {}", self.cover(cover)?)?;
        }
        writeln!(self.out)
    }

    fn patch(&mut self, number: usize, patch: &Patch, stands: &[Stand]) -> io::Result<()> {
        match patch.owner {
            Owner::Stand(stand) => {
                let stand = stands.get(stand as usize).ok_or_else(missing)?.number;
                write!(self.out, "poly {number} stand {stand}")?;
            }
            Owner::Cover(cover) => write!(self.out, "poly {number} cover {}", self.cover(cover)?)?,
        }
        self.positions(" outer", &patch.outer)?;
        patch.holes.iter().try_for_each(|hole| self.positions(" hole", hole))?;
        writeln!(self.out)
    }

    fn line(&mut self, line: &Line) -> io::Result<()> {
        write!(self.out, "line")?;
        self.name(&line.kind)?;
        write!(self.out, " w")?;
        self.numbers(&[line.width])?;
        self.positions("", &line.points)?;
        writeln!(self.out)
    }

    fn positions(&mut self, field: &str, positions: &[[f64; 2]]) -> io::Result<()> {
        write!(self.out, "{field} {}", positions.len())?;
        positions.iter().try_for_each(|position| self.numbers(position))
    }

    /// A blank before each.
    fn numbers(&mut self, numbers: &[f64]) -> io::Result<()> {
        numbers.iter().try_for_each(|&number| write_number(self.out, number))
    }

    /// A blank and the name, in quotes where it needs them.
    fn name(&mut self, name: &str) -> io::Result<()> {
        let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "_-.:/".contains(letter);
        if name.is_empty() || name.contains(['"', '#']) || name.contains(|letter: char| letter.is_control()) {
            return Err(io::Error::new(io::ErrorKind::InvalidData, format!("no text can hold the name {name:?}")));
        }
        if name.chars().all(is_plain) { write!(self.out, " {name}") } else { write!(self.out, " \"{name}\"") }
    }

    /// The number of a cover in the text.
    fn cover(&self, index: u8) -> io::Result<u32> {
        self.head.covers.get(usize::from(index)).map(|cover| cover.number).ok_or_else(missing)
    }
}

/// The word of a value in its list.
fn word<T: PartialEq + Copy>(all: &[(&'static str, T)], value: T) -> &'static str {
    all.iter().find(|(_, known)| *known == value).map_or("", |&(word, _)| word)
}

fn missing() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "a cell names a species, a cover or a stand that is not there")
}
