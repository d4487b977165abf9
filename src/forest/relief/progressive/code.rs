//! Code: numbers as bytes, halvings as numbers.
//!
//! Units: none. Cost: a few operations a number.

use crate::forest::relief::lattice::{Lattice, Point, level};

/// Numbers of variable length, seven bits a byte, the lowest first.
pub(super) struct Numbers<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
}

impl Iterator for Numbers<'_> {
    type Item = u64;

    /// `None` where the bytes end, and for what is longer than 64 bits.
    fn next(&mut self) -> Option<u64> {
        let mut number = 0_u64;
        for shift in (0..64).step_by(7) {
            let byte = *self.bytes.get(self.at)?;
            self.at += 1;
            number |= u64::from(byte & 0x7F) << shift;
            if byte < 0x80 {
                return Some(number);
            }
        }
        None
    }
}

pub(super) fn push_number(bytes: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Small numbers of either sign as small numbers: 0, -1, 1, -2 become 0, 1, 2, 3.
pub(super) fn folded(number: i64) -> u64 {
    ((number << 1) ^ (number >> 63)) as u64
}

pub(super) fn unfolded(number: u64) -> i64 {
    (number >> 1) as i64 ^ -((number & 1) as i64)
}

/// The count in the middle of a hypotenuse, from those of its ends.
pub(super) fn expected(lattice: &Lattice, middle: Point, count: impl Fn(Point) -> i64) -> i64 {
    lattice.diamond(middle).map_or(0, |diamond| count(diamond.a).saturating_add(count(diamond.b)).div_euclid(2))
}

/// A middle's place among the points of its reach, row by row.
pub(super) fn place_of(lattice: &Lattice, middle: Point) -> u64 {
    let reach = Lattice::reach(middle);
    let width = u64::from(lattice.side / reach + 1);
    u64::from(middle.y / reach) * width + u64::from(middle.x / reach)
}

/// The middle of that level at that place, if there is one.
pub(super) fn point_at(lattice: &Lattice, wanted: usize, place: u64) -> Option<Point> {
    let reach = 1_u32.checked_shl(u32::try_from(wanted / 2).ok()?).filter(|&reach| reach < lattice.side)?;
    let width = u64::from(lattice.side / reach + 1);
    let (x, y) = (place % width, place / width);
    let point = Point { x: u32::try_from(x).ok()? * reach, y: u32::try_from(y).ok().filter(|_| y < width)? * reach };
    (level(point) == wanted && Lattice::reach(point) == reach).then_some(point)
}

pub(super) fn corners(lattice: &Lattice) -> [Point; 4] {
    let side = lattice.side;
    [(0, 0), (side, 0), (0, side), (side, side)].map(|(x, y)| Point { x, y })
}

pub(super) fn array<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    let mut array = [0; N];
    array.copy_from_slice(&bytes[at..at + N]);
    array
}

pub(super) fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = flate2::Crc::new();
    crc.update(bytes);
    crc.sum()
}
