//! Write: a hierarchy as halvings, the worst first.
//!
//! Hierarchy -> bands of bounds, levels in them -> chunks
//!
//! Units: metres. Cost: all halvings are in memory, 8 bytes each.

use super::code::{corners, crc32, expected, folded, place_of, push_number};
use super::{FINE_STEP, MAGIC, ProgressiveError};
use crate::forest::elevation::{Frame, Grid, Unit};
use crate::forest::relief::Hierarchy;
use crate::forest::relief::lattice::{Point, level};
use std::collections::BTreeMap;
use std::io::{self, Write};

/// The same grid with heights that the stream can hold, and the step they are whole numbers of: metres if all are whole already.
#[must_use]
pub fn stepped(grid: &Grid) -> (Grid, f64) {
    let is_whole = grid.heights().iter().all(|height| height.is_nan() || height.fract() == 0.0);
    let step = if is_whole { 1.0 } else { FINE_STEP };
    let rounded = |&height: &f32| ((f64::from(height) / step).round() * step) as f32;
    let mut stepped = grid.clone();
    stepped.heights_mut().iter_mut().for_each(|height| *height = rounded(height));
    (stepped, step)
}

/// Writes all halvings of a hierarchy over a grid of [`stepped`] heights. Returns how many there are.
///
/// # Errors
/// Those of `sink`; voids.
pub fn write(hierarchy: &Hierarchy<'_>, step: f64, sink: &mut dyn Write) -> io::Result<usize> {
    let voids = hierarchy.grid.voids();
    if voids > 0 {
        return Err(io::Error::other(ProgressiveError::Voids { voids }));
    }
    sink.write_all(&head(hierarchy, step))?;
    let count = |point: Point| (hierarchy.height(point) / step).round() as i64;
    let (mut halvings, largest) = (0, largest_bound(hierarchy));
    for ((band, _), (level, middles)) in bands(hierarchy, largest) {
        let mut bytes = Vec::new();
        let mut next = 0;
        for &middle in &middles {
            let place = place_of(&hierarchy.lattice, middle);
            push_number(&mut bytes, place - next);
            next = place + 1;
            push_number(&mut bytes, folded(count(middle) - expected(&hierarchy.lattice, middle, count)));
        }
        halvings += middles.len();
        chunk(sink, (level as u8, middles.len()), limit_of(band, largest), &bytes)?;
    }
    // The last chunk holds nothing, and says that nothing is missing.
    chunk(sink, (0, 0), 0.0, &[])?;
    Ok(halvings)
}

/// Every halving that is worth anything: by band, in it by level from the coarse one, in it by place.
#[allow(clippy::type_complexity, reason = "a name for it would hide the order, which is the point")]
fn bands(hierarchy: &Hierarchy<'_>, largest: f32) -> impl Iterator<Item = ((u32, usize), (usize, Vec<Point>))> {
    let mut bands: BTreeMap<(u32, usize), (usize, Vec<Point>)> = BTreeMap::new();
    hierarchy.lattice.from_the_smallest(|middle| {
        let bound = hierarchy.bound(middle);
        if bound > 0.0 {
            let level = level(middle);
            let entry = bands.entry((band_of(bound, largest), usize::MAX - level)).or_insert((level, Vec::new()));
            entry.1.push(middle);
        }
    });
    bands.into_iter().map(|(key, (level, mut middles))| {
        middles.sort_by_key(|middle| (middle.y, middle.x));
        (key, (level, middles))
    })
}

/// The bound of the two roots.
fn largest_bound(hierarchy: &Hierarchy<'_>) -> f32 {
    let roots = hierarchy.lattice.roots();
    roots.iter().map(|root| hierarchy.bound(root.middle())).fold(0.0, f32::max)
}

/// The limit of a band: every bound in it, and behind it, is at most this. `largest` times a power of the root of one half.
fn limit_of(band: u32, largest: f32) -> f32 {
    let half = largest * 0.5_f32.powi(band as i32 / 2);
    if band.is_multiple_of(2) { half } else { half * std::f32::consts::FRAC_1_SQRT_2 }
}

/// The last band whose limit is not below `bound`.
fn band_of(bound: f32, largest: f32) -> u32 {
    (0..200).take_while(|&band| limit_of(band, largest) >= bound).last().unwrap_or(0)
}

fn head(hierarchy: &Hierarchy<'_>, step: f64) -> Vec<u8> {
    let grid = hierarchy.grid;
    let mut head = MAGIC.to_vec();
    [grid.columns(), grid.rows()].iter().for_each(|&size| head.extend((size as u32).to_le_bytes()));
    head.push(u8::from(grid.frame.unit == Unit::Metres));
    let Frame { west, north, step: [east, south], .. } = grid.frame;
    [west, north, east, south, step].iter().for_each(|number| head.extend(number.to_le_bytes()));
    for corner in corners(&hierarchy.lattice) {
        head.extend(((hierarchy.height(corner) / step).round() as i32).to_le_bytes());
    }
    head.extend(largest_bound(hierarchy).to_le_bytes());
    let mut length = grid.name.len().min(usize::from(u16::MAX));
    while !grid.name.is_char_boundary(length) {
        length -= 1;
    }
    head.extend((length as u16).to_le_bytes());
    head.extend(&grid.name.as_bytes()[..length]);
    head.extend(crc32(&head).to_le_bytes());
    head
}

fn chunk(sink: &mut dyn Write, (level, halvings): (u8, usize), bound: f32, bytes: &[u8]) -> io::Result<()> {
    let mut all = vec![level];
    all.extend((halvings as u32).to_le_bytes());
    all.extend((bytes.len() as u32).to_le_bytes());
    all.extend(bound.to_le_bytes());
    all.extend(bytes);
    all.extend(crc32(&all).to_le_bytes());
    sink.write_all(&all)
}
