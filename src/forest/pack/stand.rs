//! A stand in a pack: its number and what it is by year.
//!
//! Stand <-STAND-> number (u32), place, count, then 34 bytes a state: flags, plant, picture, cover (4 u8), species (u16), year (i32),
//! height, crown (4 f32), density, crown base (2 f32)
//!
//! Flags: 1 a year is given, 2 a crown base, 4 a picture, 8 a cover.

use super::bytes::{Reader, push_count, push_f32};
use super::head::{place, push_place};
use crate::forest::area::{Plant, Spread, Stand, StandState};

/// Appends a stand.
pub(super) fn push(bytes: &mut Vec<u8>, stand: &Stand) -> Result<(), String> {
    bytes.extend(stand.number.to_le_bytes());
    push_place(bytes, stand.place);
    push_count(bytes, stand.states.len())?;
    for state in &stand.states {
        let given = [state.year.is_some(), state.crown_base.is_some(), state.picture.is_some(), state.cover.is_some()];
        bytes.push(given.iter().rev().fold(0, |flags, &given| 2 * flags + u8::from(given)));
        bytes.push(Plant::ALL.iter().position(|&(_, plant)| plant == state.plant).unwrap_or_default() as u8);
        bytes.push(state.picture.unwrap_or_default());
        bytes.push(state.cover.unwrap_or_default());
        bytes.extend(state.species.to_le_bytes());
        bytes.extend(state.year.unwrap_or_default().to_le_bytes());
        let (height, crown) = (state.height, state.crown);
        let base = state.crown_base.unwrap_or_default();
        let numbers = [height.mean, height.deviation, crown.mean, crown.deviation, state.density, base];
        numbers.into_iter().try_for_each(|number| push_f32(bytes, number))?;
    }
    Ok(())
}

/// Reads a stand.
pub(super) fn read(reader: &mut Reader<'_>) -> Result<Stand, String> {
    let (number, place) = (reader.u32()?, place(reader)?);
    Ok(Stand { number, states: reader.list(34, state)?, place })
}

fn state(reader: &mut Reader<'_>) -> Result<StandState, String> {
    let (flags, plant) = (reader.u8()?, usize::from(reader.u8()?));
    let &(_, plant) =
        Plant::ALL.get(plant).ok_or_else(|| format!("a stand is planted in way {plant}, which is none"))?;
    let (picture, cover, species, year) = (reader.u8()?, reader.u8()?, reader.u16()?, reader.i32()?);
    let height = Spread { mean: reader.f32()?, deviation: reader.f32()? };
    let crown = Spread { mean: reader.f32()?, deviation: reader.f32()? };
    let (density, base) = (reader.f32()?, reader.f32()?);
    Ok(StandState {
        year: (flags & 1 != 0).then_some(year),
        species,
        height,
        crown,
        density,
        crown_base: (flags & 2 != 0).then_some(base),
        plant,
        picture: (flags & 4 != 0).then_some(picture),
        cover: (flags & 8 != 0).then_some(cover),
    })
}
