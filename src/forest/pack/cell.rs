//! One cell in a pack: chunks that are read by themselves.
//!
//! Cell <-CELL-> chunks
//!
//! | Tag | What is in it |
//! |---|---|
//! | `CELL` | column, row (2 i32), seed (u64), cover (u8; 255: none), place |
//! | `GRID` | lattice: columns, rows (2 u16), base, step (2 f64), counts (i16 each) |
//! | `MESH` | vertices (x, y as u16, z as f32), triangles (3 u32, cover u8) |
//! | `STND` | stands: number (u32), place, states (`stand`) |
//! | `PTCH` | patches: kind (u8), owner (u32), place, rings of corners (x, y as u16) |
//! | `TREE` | measured trees: species (u16), x, y (2 u16), height, crown, turn (3 f32), place |
//! | `LINE` | roads and rivers: kind, width (f32), points (x, y as u16), place |
//!
//! Positions are 65,535ths of the side: 3.7 mm of 240 m, and what lies on the border stays on it, so neighbors still meet. Lengths and
//! densities are `f32`. What a pack gives back is packed again without a change.
//!
//! Cost: one pass; memory of the cell.

use super::bytes::{Reader, chunk, chunks, push_chunk, push_count, push_f32, push_f64, push_text};
use super::head::{place, push_place};
use super::stand;
use crate::forest::area::{Cell, Ground, Head, Line, MeasuredTree, Owner, Patch};
use crate::math::Vec3;

/// The cover byte that means none.
pub(super) const NO_COVER: u8 = 255;

/// Positions as parts of the side of a cell.
#[derive(Clone, Copy)]
struct Fractions {
    side: f64,
}

impl Fractions {
    fn push(self, bytes: &mut Vec<u8>, at: [f64; 2]) {
        self.shortened(at).into_iter().for_each(|part| bytes.extend(part.to_le_bytes()));
    }

    fn shortened(self, at: [f64; 2]) -> [u16; 2] {
        // A cast saturates: what lies outside is moved onto the border.
        at.map(|metres| (metres / self.side * 65_535.0).round() as u16)
    }

    fn read(self, reader: &mut Reader<'_>) -> Result<[f64; 2], String> {
        let parts = [reader.u16()?, reader.u16()?];
        // The border is the border whatever rounding says.
        let metres = |part| if part == u16::MAX { self.side } else { self.side * (f64::from(part) / 65_535.0) };
        Ok(parts.map(metres))
    }

    /// A ring without the corners that have become one.
    fn ring(self, ring: &[[f64; 2]]) -> Vec<[u16; 2]> {
        let mut corners: Vec<[u16; 2]> = ring.iter().map(|&corner| self.shortened(corner)).collect();
        corners.dedup();
        while corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        corners
    }
}

/// The chunks of `cell`.
///
/// # Errors
/// What a pack cannot hold.
pub(super) fn encode(head: &Head, cell: &Cell) -> Result<Vec<u8>, String> {
    super::check::check(head, cell)?;
    let (fractions, mut bytes) = (Fractions { side: head.side }, Vec::new());
    push_chunk(&mut bytes, b"CELL", |bytes| {
        cell.index.into_iter().for_each(|index| bytes.extend(index.to_le_bytes()));
        bytes.extend(cell.seed.to_le_bytes());
        bytes.push(cell.cover.unwrap_or(NO_COVER));
        push_place(bytes, cell.place);
        Ok(())
    })?;
    push_ground(&mut bytes, fractions, &cell.ground)?;
    push_list(&mut bytes, b"STND", &cell.stands, stand::push)?;
    let kept: Vec<_> = cell.patches.iter().filter_map(|patch| Some((patch, rings(fractions, patch)?))).collect();
    push_list(&mut bytes, b"PTCH", &kept, |bytes, (patch, rings)| push_patch(bytes, patch, rings))?;
    push_list(&mut bytes, b"TREE", &cell.trees, |bytes, tree| {
        bytes.extend(tree.species.to_le_bytes());
        fractions.push(bytes, tree.at);
        [tree.height, tree.crown, tree.turn].into_iter().try_for_each(|number| push_f32(bytes, number))?;
        push_place(bytes, tree.place);
        Ok(())
    })?;
    push_list(&mut bytes, b"LINE", &cell.lines, |bytes, line| {
        push_text(bytes, &line.kind)?;
        push_f32(bytes, line.width)?;
        push_count(bytes, line.points.len())?;
        line.points.iter().for_each(|&point| fractions.push(bytes, point));
        push_place(bytes, line.place);
        Ok(())
    })?;
    Ok(bytes)
}

/// A chunk of a list; none for an empty one.
fn push_list<T>(
    bytes: &mut Vec<u8>,
    tag: &[u8; 4],
    list: &[T],
    mut push: impl FnMut(&mut Vec<u8>, &T) -> Result<(), String>,
) -> Result<(), String> {
    push_chunk(bytes, tag, |bytes| {
        if list.is_empty() {
            return Ok(());
        }
        push_count(bytes, list.len())?;
        list.iter().try_for_each(|item| push(bytes, item))
    })
}

fn push_ground(bytes: &mut Vec<u8>, fractions: Fractions, ground: &Ground) -> Result<(), String> {
    match ground {
        Ground::Lattice { size, base, step, counts } => push_chunk(bytes, b"GRID", |bytes| {
            size.iter().for_each(|length| bytes.extend(length.to_le_bytes()));
            push_f64(bytes, *base)?;
            push_f64(bytes, *step)?;
            counts.iter().for_each(|count| bytes.extend(count.to_le_bytes()));
            Ok(())
        }),
        Ground::Mesh { vertices, triangles } => push_chunk(bytes, b"MESH", |bytes| {
            push_count(bytes, vertices.len())?;
            vertices.iter().try_for_each(|vertex| {
                fractions.push(bytes, [vertex.x, vertex.y]);
                push_f32(bytes, vertex.z)
            })?;
            push_count(bytes, triangles.len())?;
            for (corners, cover) in triangles {
                corners.iter().for_each(|corner| bytes.extend(corner.to_le_bytes()));
                bytes.push(cover.unwrap_or(NO_COVER));
            }
            Ok(())
        }),
    }
}

/// The rings of a patch; `None` where nothing is left of it.
fn rings(fractions: Fractions, patch: &Patch) -> Option<Vec<Vec<[u16; 2]>>> {
    let outer = Some(fractions.ring(&patch.outer)).filter(|ring| ring.len() > 2)?;
    let holes = patch.holes.iter().map(|hole| fractions.ring(hole)).filter(|ring| ring.len() > 2);
    Some(std::iter::once(outer).chain(holes).collect())
}

fn push_patch(bytes: &mut Vec<u8>, patch: &Patch, rings: &[Vec<[u16; 2]>]) -> Result<(), String> {
    let (kind, owner) = match patch.owner {
        Owner::Stand(stand) => (0_u8, stand),
        Owner::Cover(cover) => (1, u32::from(cover)),
    };
    bytes.push(kind);
    bytes.extend(owner.to_le_bytes());
    push_place(bytes, patch.place);
    push_count(bytes, rings.len())?;
    for ring in rings {
        push_count(bytes, ring.len())?;
        ring.iter().flatten().for_each(|part| bytes.extend(part.to_le_bytes()));
    }
    Ok(())
}

/// The cell of these chunks; those that are not known are skipped.
///
/// # Errors
/// What is wrong with the bytes, or with what they say.
pub(super) fn decode(head: &Head, bytes: &[u8]) -> Result<Cell, String> {
    let (fractions, chunks) = (Fractions { side: head.side }, chunks(bytes)?);
    let list = |tag| chunk(&chunks, tag).unwrap_or(&[0; 4]);
    let mut start = Reader::new(chunk(&chunks, b"CELL").ok_or("it does not say which cell it is")?, "column and row");
    let (index, seed) = ([start.i32()?, start.i32()?], start.u64()?);
    let cover = start.u8()?;
    let cell = Cell {
        index,
        seed,
        cover: (cover != NO_COVER).then_some(cover),
        place: place(&mut start)?,
        ground: match (chunk(&chunks, b"GRID"), chunk(&chunks, b"MESH")) {
            (Some(lattice), _) => self::lattice(&mut Reader::new(lattice, "heights"))?,
            (None, Some(mesh)) => self::mesh(&mut Reader::new(mesh, "triangles"), fractions)?,
            (None, None) => return Err("it has no ground".to_string()),
        },
        stands: Reader::new(list(b"STND"), "stands").list(14, stand::read)?,
        patches: Reader::new(list(b"PTCH"), "patches").list(15, |reader| patch(reader, fractions))?,
        trees: Reader::new(list(b"TREE"), "trees").list(24, |reader| tree(reader, fractions))?,
        lines: Reader::new(list(b"LINE"), "lines").list(16, |reader| line(reader, fractions))?,
    };
    super::check::check(head, &cell)?;
    Ok(cell)
}

fn lattice(reader: &mut Reader<'_>) -> Result<Ground, String> {
    let size = [reader.u16()?, reader.u16()?];
    let (base, step) = (reader.f64()?, reader.f64()?);
    let count = usize::from(size[0]) * usize::from(size[1]);
    let (counts, _) = reader.take(2 * count)?.as_chunks::<2>();
    Ok(Ground::Lattice { size, base, step, counts: counts.iter().map(|&count| i16::from_le_bytes(count)).collect() })
}

fn mesh(reader: &mut Reader<'_>, fractions: Fractions) -> Result<Ground, String> {
    let vertices = reader.list(8, |reader| {
        let [x, y] = fractions.read(reader)?;
        Ok(Vec3::new(x, y, reader.f32()?))
    })?;
    let triangles = reader.list(13, |reader| {
        let corners = [reader.u32()?, reader.u32()?, reader.u32()?];
        let cover = reader.u8()?;
        Ok((corners, (cover != NO_COVER).then_some(cover)))
    })?;
    Ok(Ground::Mesh { vertices, triangles })
}

fn patch(reader: &mut Reader<'_>, fractions: Fractions) -> Result<Patch, String> {
    let (kind, owner) = (reader.u8()?, reader.u32()?);
    let owner = match (kind, u8::try_from(owner)) {
        (0, _) => Owner::Stand(owner),
        (1, Ok(cover)) => Owner::Cover(cover),
        _ => return Err(format!("a patch belongs to owner {owner} of kind {kind}, which is none")),
    };
    let place = place(reader)?;
    let mut rings = reader.list(4, |reader| reader.list(4, |reader| fractions.read(reader)))?.into_iter();
    let outer = rings.next().ok_or("a patch has no outline")?;
    Ok(Patch { owner, outer, holes: rings.collect(), place })
}

fn tree(reader: &mut Reader<'_>, fractions: Fractions) -> Result<MeasuredTree, String> {
    let (species, at) = (reader.u16()?, fractions.read(reader)?);
    let (height, crown, turn) = (reader.f32()?, reader.f32()?, reader.f32()?);
    Ok(MeasuredTree { species, at, height, crown, turn, place: place(reader)? })
}

fn line(reader: &mut Reader<'_>, fractions: Fractions) -> Result<Line, String> {
    let (kind, width) = (reader.text()?, reader.f32()?);
    let points = reader.list(4, |reader| fractions.read(reader))?;
    Ok(Line { kind, width, points, place: place(reader)? })
}
