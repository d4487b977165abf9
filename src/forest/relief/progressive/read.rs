//! Read: as many halvings as there are bytes.
//!
//! bytes -> head, chunks -> halved diamonds, heights of their middles -> mesh
//!
//! A halving is only taken when both of its parents were: bytes that say otherwise are damaged, whatever their checksum.
//!
//! Units: metres. Cost: a step a halving, then the mesh; 5 bytes a sample of the whole grid.

use super::code::{Numbers, array, corners, crc32, expected, point_at, unfolded};
use super::{CHUNK, HEAD, MAGIC, ProgressiveError, Received};
use crate::forest::elevation::{Frame, Grid, SAMPLE_LIMIT, Unit};
use crate::forest::relief::Hierarchy;
use crate::forest::relief::lattice::{Field, Lattice, Point};
use crate::forest::relief::mesh::{ReliefMesh, mesh};
use crate::forest::relief::scan::{Plane, rows};

/// Reads as many halvings as `bytes` hold.
///
/// # Errors
/// The head is not whole, or a chunk is damaged.
pub fn read(name: &str, bytes: &[u8]) -> Result<Received, ProgressiveError> {
    let mut reading = Reading::new(name, bytes)?;
    while let Some(chunk) = Chunk::at(bytes, reading.position)? {
        reading.take(&chunk)?;
        if !chunk.is_whole || chunk.halvings == 0 {
            reading.is_whole = chunk.is_whole;
            break;
        }
        reading.position = chunk.end;
    }
    Ok(reading.finished())
}

/// A stream being read.
struct Reading {
    grid: Grid,
    lattice: Lattice,
    step: f64,
    halved: Field<bool>,
    bound: f32,
    halvings: usize,
    position: usize,
    is_whole: bool,
}

impl Reading {
    fn new(name: &str, bytes: &[u8]) -> Result<Reading, ProgressiveError> {
        let fault = |at: usize, what: &str| ProgressiveError::Head { at, what: what.to_string() };
        if !bytes.starts_with(MAGIC) {
            return Err(fault(0, "expected a progressive relief, which begins with FRELIEF1"));
        }
        if bytes.len() < HEAD {
            return Err(fault(bytes.len(), "the file ends within its head"));
        }
        let length = usize::from(u16::from_le_bytes(array(bytes, HEAD - 2)));
        let end = HEAD + length + 4;
        if bytes.len() < end {
            return Err(fault(bytes.len(), "the file ends within its head"));
        }
        if crc32(&bytes[..end - 4]) != u32::from_le_bytes(array(bytes, end - 4)) {
            return Err(fault(end - 4, "the checksum of the head is another: it is damaged"));
        }
        let number = |at: usize| f64::from_le_bytes(array(bytes, at));
        let size = [8, 12].map(|at| u32::from_le_bytes(array(bytes, at)) as usize);
        let unit = if bytes[16] == 0 { Unit::Degrees } else { Unit::Metres };
        let frame = Frame { unit, west: number(17), north: number(25), step: [number(33), number(41)] };
        let step = number(49);
        let is_sound = frame.step.iter().chain([&step]).all(|&step| step > 0.0 && step.is_finite())
            && frame.west.is_finite()
            && frame.north.is_finite();
        let samples = size[0].saturating_mul(size[1]);
        if !is_sound || samples > SAMPLE_LIMIT {
            return Err(fault(8, "no grid has such a size and such steps"));
        }
        let grid = Grid::new(name, (size[0], size[1]), vec![0.0; samples], frame)
            .map_err(|error| fault(8, &error.to_string()))?;
        let lattice = Lattice::new(&grid);
        let bound = f32::from_le_bytes(array(bytes, 73));
        let halved = Field::new(&lattice, false);
        let mut reading = Reading { grid, lattice, step, halved, bound, halvings: 0, position: end, is_whole: false };
        for (index, corner) in corners(&lattice).into_iter().enumerate() {
            let count = i32::from_le_bytes(array(bytes, 57 + 4 * index));
            reading.set_count(corner, i64::from(count));
        }
        Ok(reading)
    }

    /// Takes the halvings of a chunk, of one that was cut those that are there.
    fn take(&mut self, chunk: &Chunk<'_>) -> Result<(), ProgressiveError> {
        let damaged = |what: String| ProgressiveError::Chunk { at: chunk.start, what };
        self.bound = chunk.bound;
        let mut numbers = Numbers { bytes: chunk.bytes, at: 0 };
        let mut next = 0_u64;
        for number in 0..chunk.halvings {
            let (Some(skipped), Some(offset)) = (numbers.next(), numbers.next()) else {
                return if chunk.is_whole {
                    Err(damaged(format!("it ends before halving {}", number + 1)))
                } else {
                    Ok(())
                };
            };
            let place = next.saturating_add(skipped);
            let middle = point_at(&self.lattice, chunk.level, place).filter(|&middle| self.can_be_halved(middle));
            let middle = middle.ok_or_else(|| damaged(format!("halving {} is none of this relief", number + 1)))?;
            let count = self.expected_count(middle).saturating_add(unfolded(offset));
            self.set_count(middle, count);
            self.halved.set(middle, true);
            self.halvings += 1;
            next = place + 1;
        }
        Ok(())
    }

    fn can_be_halved(&self, middle: Point) -> bool {
        let lattice = &self.lattice;
        lattice.diamond(middle).is_some()
            && lattice.touches(middle)
            && !self.halved.at(middle)
            && lattice.parents(middle).all(|parent| self.halved.at(parent))
    }

    fn expected_count(&self, middle: Point) -> i64 {
        expected(&self.lattice, middle, |point| {
            let Point { x, y } = self.lattice.nearest(point);
            (f64::from(self.grid.height(x as usize, y as usize)) / self.step).round() as i64
        })
    }

    fn set_count(&mut self, point: Point, count: i64) {
        let Point { x, y } = self.lattice.nearest(point);
        let at = y as usize * self.grid.columns() + x as usize;
        self.grid.heights_mut()[at] = (count as f64 * self.step) as f32;
    }

    fn finished(self) -> Received {
        let Reading { mut grid, halved, bound, halvings, is_whole, .. } = self;
        let mesh = mesh(&Hierarchy::without_bounds(&grid), |middle| halved.at(middle));
        fill(&mut grid, &mesh);
        Received { grid, mesh, bound: f64::from(bound), halvings, is_whole }
    }
}

/// Gives every sample the height of the mesh there.
fn fill(grid: &mut Grid, mesh: &ReliefMesh) {
    let limits = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
    for face in &mesh.faces {
        let plane = Plane::new(&face.triangle, face.heights);
        rows(&face.triangle, limits, |y, first, last| {
            for x in first..=last {
                let at = y as usize * grid.columns() + x as usize;
                grid.heights_mut()[at] = plane.at(x, y) as f32;
            }
        });
    }
}

/// One level of one band.
struct Chunk<'a> {
    start: usize,
    end: usize,
    level: usize,
    halvings: usize,
    /// Of all that is not halved before it.
    bound: f32,
    bytes: &'a [u8],
    is_whole: bool,
}

impl Chunk<'_> {
    /// The chunk that begins there; `None` where not even its head is there.
    fn at(bytes: &[u8], start: usize) -> Result<Option<Chunk<'_>>, ProgressiveError> {
        let Some(head) = bytes.get(start..start + CHUNK) else { return Ok(None) };
        let [halvings, length] = [1, 5].map(|at| u32::from_le_bytes(array(head, at)) as usize);
        let bound = f32::from_le_bytes(array(head, 9));
        let (first, end) = (start + CHUNK, (start + CHUNK).saturating_add(length).saturating_add(4));
        let is_whole = end <= bytes.len();
        let last = (first.saturating_add(length)).min(bytes.len());
        if is_whole && crc32(&bytes[start..end - 4]) != u32::from_le_bytes(array(bytes, end - 4)) {
            return Err(ProgressiveError::Chunk { at: start, what: "its checksum is another".to_string() });
        }
        let level = usize::from(head[0]);
        Ok(Some(Chunk { start, end, level, halvings, bound, bytes: &bytes[first..last], is_whole }))
    }
}
