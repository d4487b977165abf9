//! Rings: whether polygons are some.
//!
//! positions -RINGS-> Rings, or what is wrong
//!
//! Repeated positions are left out: programs write them, and they change nothing.

use crate::forest::polygon::Point;
use crate::forest::vector::Rings;
use crate::parse::fcell::outline::{Flaw, flaw};

/// A polygon of closed rings, the outline first.
pub(super) fn polygon(rings: Vec<Vec<Point>>) -> Result<Rings, String> {
    let mut open = Vec::with_capacity(rings.len());
    for (number, mut ring) in rings.into_iter().enumerate() {
        let name = if number == 0 { "the outline".to_string() } else { format!("hole {number}") };
        if ring.len() < 4 {
            return Err(format!(
                "{name} has {} positions: a ring has four or more, the last is the first again",
                ring.len()
            ));
        }
        if ring.first() != ring.last() {
            let [first, last] = [ring[0], ring[ring.len() - 1]];
            return Err(format!("{name} is not closed: it begins at {first:?} and ends at {last:?}"));
        }
        ring.dedup();
        ring.pop();
        if ring.len() < 3 {
            return Err(format!("{name} has less than three different corners"));
        }
        open.push(ring);
    }
    if let Some(flaw) = flaw(&open) {
        return Err(told(&flaw));
    }
    let mut rings = open.into_iter();
    let Some(outer) = rings.next() else { return Err("a polygon without an outline".to_string()) };
    Ok(Rings { outer, holes: rings.collect() })
}

pub(in crate::parse) fn told(flaw: &Flaw) -> String {
    let name = |ring: usize| if ring == 0 { "the outline".to_string() } else { format!("hole {ring}") };
    match *flaw {
        Flaw::Flat { ring } => format!("{} has no area: all corners are on one line", name(ring)),
        Flaw::Twice { ring, at } => format!("{} has the corner {at:?} twice", name(ring)),
        Flaw::Crossing { ring, edges: [first, second], near } => {
            format!("{} crosses or touches itself: edges {first} and {second} meet near {near:?}", name(ring))
        }
        Flaw::Outside { hole, at } => format!("hole {hole} is not within the outline: its corner {at:?} is not"),
        Flaw::Rings { rings: [first, second], near } => {
            format!("{} and {} cross, or lie in each other, near {near:?}", name(first), name(second))
        }
    }
}
