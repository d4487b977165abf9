//! The head of a pack: names, projection, kinds of trees and ground, landmarks.
//!
//! Head <-HEAD-> chunks
//!
//! | Tag | What is in it |
//! |---|---|
//! | `AREA` | origin (2 f64), side (f64), seed (u64), projection (text) |
//! | `FILE` | names of the files it came from |
//! | `SPEC` | species: code, form (u8), pictures, place |
//! | `COVR` | covers: number (u32), tile (f64), picture, place |
//! | `MARK` | landmarks: x, y (2 f64), name, place |
//! | `OBJS` | objects: x, y, turn, scale (4 f64), file, place; missing where there are none |

use super::bytes::{Reader, chunk, chunks, push_chunk, push_count, push_f64, push_text};
use crate::forest::area::{Cover, Form, Head, Mark, Species};
use crate::forest::objects::{SMALLEST_SCALE, Standing};
use crate::scene::Place;

/// The chunks of `head`, one behind the other.
///
/// # Errors
/// What a pack cannot hold.
pub(super) fn encode(head: &Head) -> Result<Vec<u8>, String> {
    check(head)?;
    let mut bytes = Vec::new();
    push_chunk(&mut bytes, b"AREA", |bytes| {
        [head.origin[0], head.origin[1], head.side].into_iter().try_for_each(|number| push_f64(bytes, number))?;
        bytes.extend(head.seed.to_le_bytes());
        push_text(bytes, &head.crs)
    })?;
    push_chunk(&mut bytes, b"FILE", |bytes| {
        push_count(bytes, head.files.len())?;
        head.files.iter().try_for_each(|file| push_text(bytes, file))
    })?;
    push_chunk(&mut bytes, b"SPEC", |bytes| {
        push_count(bytes, head.species.len())?;
        head.species.iter().try_for_each(|species| push_species(bytes, species))
    })?;
    push_chunk(&mut bytes, b"COVR", |bytes| {
        push_count(bytes, head.covers.len())?;
        head.covers.iter().try_for_each(|cover| {
            bytes.extend(cover.number.to_le_bytes());
            push_f64(bytes, cover.tile)?;
            push_text(bytes, &cover.image)?;
            push_place(bytes, cover.place);
            Ok(())
        })
    })?;
    push_chunk(&mut bytes, b"MARK", |bytes| {
        push_count(bytes, head.marks.len())?;
        head.marks.iter().try_for_each(|mark| {
            mark.at.into_iter().try_for_each(|number| push_f64(bytes, number))?;
            push_text(bytes, &mark.name)?;
            push_place(bytes, mark.place);
            Ok(())
        })
    })?;
    // Areas without objects are packed as before there were any.
    if !head.objects.is_empty() {
        push_chunk(&mut bytes, b"OBJS", |bytes| push_objects(bytes, &head.objects))?;
    }
    Ok(bytes)
}

fn push_objects(bytes: &mut Vec<u8>, objects: &[Standing]) -> Result<(), String> {
    push_count(bytes, objects.len())?;
    objects.iter().try_for_each(|object| {
        let [x, y] = object.at;
        [x, y, object.turn, object.scale].into_iter().try_for_each(|number| push_f64(bytes, number))?;
        push_text(bytes, &object.file)?;
        push_place(bytes, object.place);
        Ok(())
    })
}

fn push_species(bytes: &mut Vec<u8>, species: &Species) -> Result<(), String> {
    push_text(bytes, &species.code)?;
    bytes.push(Form::ALL.iter().position(|&(_, form)| form == species.form).unwrap_or_default() as u8);
    push_count(bytes, species.images.len())?;
    species.images.iter().try_for_each(|image| push_text(bytes, image))?;
    push_place(bytes, species.place);
    Ok(())
}

/// The head of these chunks; those that are not known are skipped.
///
/// # Errors
/// What is wrong with the bytes.
pub(super) fn decode(bytes: &[u8]) -> Result<Head, String> {
    let chunks = chunks(bytes)?;
    let list = |tag| chunk(&chunks, tag).unwrap_or(&[0; 4]);
    let area = chunk(&chunks, b"AREA").ok_or("it does not say where the area is and how large its cells are")?;
    let mut area = Reader::new(area, "origin and side");
    let mut head = Head { origin: [area.f64()?, area.f64()?], side: area.f64()?, seed: area.u64()?, ..Head::default() };
    head.crs = area.text()?;
    head.files = Reader::new(list(b"FILE"), "names of files").list(2, Reader::text)?;
    head.species = Reader::new(list(b"SPEC"), "species").list(13, species)?;
    head.covers = Reader::new(list(b"COVR"), "covers").list(20, |reader| {
        let (number, tile) = (reader.u32()?, reader.f64()?);
        Ok(Cover { number, tile, image: reader.text()?, place: place(reader)? })
    })?;
    head.marks = Reader::new(list(b"MARK"), "landmarks").list(24, |reader| {
        let at = [reader.f64()?, reader.f64()?];
        Ok(Mark { at, name: reader.text()?, place: place(reader)? })
    })?;
    head.objects = Reader::new(list(b"OBJS"), "objects").list(40, |reader| {
        let (at, turn, scale) = ([reader.f64()?, reader.f64()?], reader.f64()?, reader.f64()?);
        Ok(Standing { file: reader.text()?, at, turn, scale, place: place(reader)? })
    })?;
    check(&head)?;
    Ok(head)
}

fn species(reader: &mut Reader<'_>) -> Result<Species, String> {
    let code = reader.text()?;
    let form = usize::from(reader.u8()?);
    let &(_, form) = Form::ALL.get(form).ok_or_else(|| format!("a species has form {form}, which is none"))?;
    Ok(Species { code, form, images: reader.list(2, Reader::text)?, place: place(reader)? })
}

/// What every head must keep.
fn check(head: &Head) -> Result<(), String> {
    if !(head.side > 0.0 && head.side.is_finite()) {
        return Err(format!("the side of its cells is {} m", head.side));
    }
    if head.covers.len() > 255 || head.species.len() > 65_535 {
        return Err("it has more than 255 covers or 65535 species".to_string());
    }
    if let Some(object) =
        head.objects.iter().find(|object| !(SMALLEST_SCALE..=1.0 / SMALLEST_SCALE).contains(&object.scale))
    {
        return Err(format!("the object `{}` has the scale {}", object.file, object.scale));
    }
    match head.covers.iter().find(|cover| !(cover.tile > 0.0 && cover.tile.is_finite())) {
        Some(cover) => Err(format!("cover {} repeats after {} m", cover.number, cover.tile)),
        None => Ok(()),
    }
}

/// Appends a place.
pub(super) fn push_place(bytes: &mut Vec<u8>, place: Place) {
    bytes.extend(place.file.to_le_bytes());
    bytes.extend(place.line.to_le_bytes());
}

/// A place of 6 bytes.
pub(super) fn place(reader: &mut Reader<'_>) -> Result<Place, String> {
    Ok(Place { file: reader.u16()?, line: reader.u32()? })
}
