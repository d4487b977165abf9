//! Polygons: which land belongs to which stand or cover.

use super::Reader;
use super::outline::{Flaw, flaw, is_counterclockwise};
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::{Owner, Patch};

/// The most corners of a polygon with all its holes.
const MOST_HOLES: usize = 10_000;

impl Reader<'_> {
    /// `poly NUMBER stand NUMBER | cover NUMBER, outer N X Y ... [hole N X Y ...]...`
    pub(super) fn poly(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        self.opened()?;
        let number: u32 = self.words.whole("the polygon's number", 0..=u32::MAX)?;
        let owner = self.owner(number)?;
        let at = self.words.peek().span;
        if !self.words.take_field("outer") {
            let next = self.words.peek();
            if next.begins_statement() {
                return Err(self.words.ends_early(next, "`outer`, the number of corners and their positions"));
            }
            return Err(self.words.unexpected(next, &["outer", "hole"]));
        }
        let mut spans = vec![at];
        let mut rings = vec![self.ring(number)?];
        loop {
            let at = self.words.peek().span;
            if !self.words.take_field("hole") {
                break;
            }
            if spans.len() > MOST_HOLES {
                return Err(
                    Diagnostic::error(format!("polygon {number} has more than {MOST_HOLES} holes")).at(at, "this one")
                );
            }
            rings.push(self.ring(number)?);
            spans.push(at);
        }
        if let Some(found) = flaw(&rings) {
            return Err(told(number, &found, &spans));
        }
        in_one_direction(&mut rings);
        let outer = rings.remove(0);
        self.opened()?.cell.patches.push(Patch { owner, outer, holes: rings, place });
        Ok(())
    }

    /// Whose land it is.
    fn owner(&mut self, number: u32) -> Result<Owner, Diagnostic> {
        if self.words.take_field("stand") {
            return Ok(Owner::Stand(self.stand_index()?));
        }
        if self.words.take_field("cover") {
            return Ok(Owner::Cover(self.cover_index()?));
        }
        let word = self.words.peek();
        let error = Diagnostic::error(format!("polygon {number} belongs to nobody"));
        let error = error.at(word.span, "expected `stand` or `cover`, and its number");
        Err(error.help(super::vocabulary::shape("poly")))
    }

    /// The corners of one ring; a first corner that is written again at the end is left out.
    fn ring(&mut self, number: u32) -> Result<Vec<[f64; 2]>, Diagnostic> {
        let declared = self.words.peek().span;
        let mut ring = self.positions(3, "corner")?;
        if ring.first() == ring.last() {
            ring.pop();
        }
        if ring.len() < 3 {
            let error = Diagnostic::error(format!("a ring of polygon {number} has less than 3 corners"));
            return Err(error.at(declared, "the last corner is the first one again").help("rings close by themselves"));
        }
        Ok(ring)
    }
}

/// Outlines counterclockwise, holes clockwise: who reads an area need not ask.
fn in_one_direction(rings: &mut [Vec<[f64; 2]>]) {
    for (index, ring) in rings.iter_mut().enumerate() {
        if is_counterclockwise(ring) != (index == 0) {
            ring[1..].reverse();
        }
    }
}

/// A flaw in words: `spans` are where the rings begin.
fn told(number: u32, flaw: &Flaw, spans: &[Span]) -> Diagnostic {
    let name = |ring: usize| if ring == 0 { "the outline".to_string() } else { format!("hole {ring}") };
    let corner = |at: [f64; 2]| format!("({}, {})", at[0], at[1]);
    match *flaw {
        Flaw::Flat { ring } => Diagnostic::error(format!("{} of polygon {number} has no area", name(ring)))
            .at(spans[ring], "all corners are on one line"),
        Flaw::Twice { ring, at } => {
            let message = format!("{} of polygon {number} has the corner {} twice", name(ring), corner(at));
            Diagnostic::error(message).at(spans[ring], "in this").help("write it once")
        }
        Flaw::Crossing { ring, edges: [first, second], near } => {
            let message = format!("{} of polygon {number} crosses or touches itself", name(ring));
            let label = format!("edges {first} and {second} meet near {}", corner(near));
            Diagnostic::error(message)
                .at(spans[ring], label)
                .help("make two polygons of it, or bring its corners in order")
        }
        Flaw::Outside { hole, at } => {
            let message = format!("hole {hole} of polygon {number} is not within its outline");
            let error = Diagnostic::error(message).at(spans[hole], format!("its corner {} is not", corner(at)));
            error.at(spans[0], "the outline").help("a hole lies within; land that is elsewhere is a polygon of its own")
        }
        Flaw::Rings { rings: [first, second], near } => {
            let message = format!("{} and {} of polygon {number} cross", name(first), name(second));
            let error = Diagnostic::error(message).at(spans[second], format!("they meet near {}", corner(near)));
            error.at(spans[first], "with this").help("holes lie within the outline, and not over each other")
        }
    }
}
