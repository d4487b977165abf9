//! HGT: the tiles of the Shuttle Radar Topography Mission.
//!
//! Nothing but heights: big-endian 16-bit whole metres, rows from the north, -32768 where the radar saw nothing. The size of the file is the
//! size of the grid, and the name is the corner in the south-west: `N42E001` covers 42 to 43 north, 1 to 2 east.
//!
//! Source: NASA/USGS, "SRTM Topography" (documentation of version 2.1), 2009.

use super::GridFile;
use crate::diagnostic::Diagnostics;
use crate::forest::elevation::{Frame, Grid, Unit};

/// Samples a side, and what such tiles are called.
const SIDES: [(usize, &str); 2] = [(1201, "3 arc seconds"), (3601, "1 arc second")];
/// What stands for "not measured".
const VOID: i16 = i16::MIN;

pub(super) fn read(file: &GridFile<'_>) -> Result<Grid, Diagnostics> {
    let (south, west) = corner(&file.stem).ok_or_else(|| {
        file.refused(
            format!("`{}`: its name does not say where it lies", file.name),
            "an HGT file is called by its south-west corner, as in `N42E001.hgt` or `S13W072.hgt`: \
             N or S and 0 to 90, E or W and 0 to 180",
        )
    })?;
    let Some(&(side, _)) = SIDES.iter().find(|(side, _)| 2 * side * side == file.bytes.len()) else {
        let known = SIDES.map(|(side, what)| format!("{} ({side} x {side} samples, {what})", 2 * side * side));
        return Err(file.refused(
            format!("`{}` has {} bytes; an HGT tile has {}", file.name, file.bytes.len(), known.join(" or ")),
            "is the file whole? Get it again",
        ));
    };
    let height = |pair: &[u8]| match i16::from_be_bytes([pair[0], pair[1]]) {
        VOID => f32::NAN,
        metres => f32::from(metres),
    };
    let step = 1.0 / (side - 1) as f64;
    let frame = Frame { unit: Unit::Degrees, west, north: south + 1.0, step: [step, step] };
    file.grid((side, side), file.bytes.chunks_exact(2).map(height).collect(), frame)
}

/// Latitude and longitude of the south-west corner that a name begins with.
fn corner(name: &str) -> Option<(f64, f64)> {
    let number = |from: usize, to: usize| {
        name.get(from..to).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))?.parse::<u32>().ok()
    };
    let sign = |at: usize, plus: u8, minus: u8| match name.as_bytes().get(at)?.to_ascii_uppercase() {
        letter if letter == plus => Some(1.0),
        letter if letter == minus => Some(-1.0),
        _ => None,
    };
    let south = sign(0, b'N', b'S')? * f64::from(number(1, 3).filter(|&latitude| latitude <= 90)?);
    let west = sign(3, b'E', b'W')? * f64::from(number(4, 7).filter(|&longitude| longitude <= 180)?);
    (name.len() == 7).then_some((south, west))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_signs() {
        assert_eq!(corner("N42E001"), Some((42.0, 1.0)));
        assert_eq!(corner("S13W072"), Some((-13.0, -72.0)));
        assert_eq!(corner("s01e100"), Some((-1.0, 100.0)));
        for wrong in ["", "N42", "N42E1", "N42E001x", "X42E001", "N4xE001", "N91E000", "N42E181", "N+2E001", "N42É01"]
        {
            assert_eq!(corner(wrong), None, "{wrong}");
        }
    }
}
