//! Field: the exact picture of a map, asked for place by place.
//!
//! shapes -FIELD-> pieces in bins of a grid; a place on the ground -> the color of the topmost piece that covers it
//!
//! No texel comes between: what covers a place is decided from the vectors themselves, so this is what textures are held against. It has no
//! soft edges; several samples a pixel have.
//!
//! Space: u, v from 0 to 1 over a square of the ground in; metres inside. Cost: the pieces whose boxes touch the bin of a place, from the topmost down.

use super::draw::dashed;
use super::{Length, Shape, Unit};
use crate::forest::polygon::Point;
use crate::forest::vector::{Geometry, Rings};
use crate::image::textures::Field;
use crate::math::{Vec2, edges};

/// Bins of the grid, each way.
const BINS: usize = 128;
/// Slabs that a polygon's edges are sorted into by height.
const SLABS: usize = 64;
/// Metres of a pixel that widths in pixels are counted with, at most: far away lines would cover all.
const LARGEST_PIXEL: f64 = 64.0;

/// A map that is asked place by place.
#[derive(Debug)]
pub struct Exact {
    corner: Point,
    size: f64,
    pieces: Vec<Piece>,
    /// Of each bin, row by row, numbers of its pieces, the lowest first.
    bins: Vec<Vec<u32>>,
}

#[derive(Debug)]
struct Piece {
    color: [u8; 3],
    form: Form,
}

#[derive(Debug)]
enum Form {
    /// Within half a width of the way between two points; `is_round` at its ends, too.
    Line { from: Vec2, to: Vec2, width: Length, is_round: bool },
    /// Within half a size of a point.
    Disc { at: Vec2, size: Length },
    /// Inside a polygon and none of its holes.
    Area(Slabs),
}

/// A polygon's edges by height.
#[derive(Debug)]
struct Slabs {
    low: Vec2,
    high: Vec2,
    slabs: Vec<Vec<[Vec2; 2]>>,
}

impl Exact {
    /// For a square of the ground whose south-west corner and side these are, in metres of the area.
    #[must_use]
    pub fn new(shapes: &[Shape], corner: Point, size: f64) -> Exact {
        let mut exact = Exact { corner, size, pieces: Vec::new(), bins: vec![Vec::new(); BINS * BINS] };
        shapes.iter().for_each(|shape| exact.shape(shape));
        exact
    }

    fn shape(&mut self, shape: &Shape) {
        match &shape.geometry {
            Geometry::Points(points) => {
                let Some(color) = shape.fill else { return };
                for &at in points {
                    let at = Vec2::from_array(at);
                    self.add(color, Form::Disc { at, size: shape.size }, (at, at, shape.size));
                }
            }
            Geometry::Lines(lines) => lines.iter().for_each(|line| self.line(line.clone(), shape)),
            Geometry::Polygons(polygons) => polygons.iter().for_each(|rings| self.polygon(rings, shape)),
        }
    }

    fn polygon(&mut self, rings: &Rings, shape: &Shape) {
        if let Some(color) = shape.fill {
            let slabs = Slabs::new(rings);
            let reach = (slabs.low, slabs.high, Length { value: 0.0, unit: Unit::Metres });
            self.add(color, Form::Area(slabs), reach);
        }
        for ring in std::iter::once(&rings.outer).chain(&rings.holes) {
            self.line(ring.iter().chain(ring.first()).copied().collect(), shape);
        }
    }

    fn line(&mut self, line: Vec<Point>, shape: &Shape) {
        let Some(pen) = shape.pen else { return };
        for piece in dashed(&line, pen.dash) {
            let is_closed = piece.first() == piece.last();
            let last = piece.len().saturating_sub(2);
            for (index, pair) in piece.windows(2).enumerate() {
                let (from, to) = (Vec2::from_array(pair[0]), Vec2::from_array(pair[1]));
                // Round towards the next piece, straight at the end of all.
                let is_round = is_closed || index < last;
                let form = Form::Line { from, to, width: pen.width, is_round };
                self.add(pen.color, form, (from.min(to), from.max(to), pen.width));
            }
        }
    }

    fn add(&mut self, color: [u8; 3], form: Form, (low, high, around): (Vec2, Vec2, Length)) {
        let margin = metres(around, LARGEST_PIXEL) / 2.0;
        let bin = |along: f64, corner: f64| (along - corner) / self.size * BINS as f64;
        let first = [bin(low.x - margin, self.corner[0]), bin(low.y - margin, self.corner[1])];
        let last = [bin(high.x + margin, self.corner[0]), bin(high.y + margin, self.corner[1])];
        let end = BINS as f64;
        let is_beside = (0..2).any(|axis| last[axis] < 0.0 || first[axis] >= end || first[axis].is_nan());
        if is_beside {
            return;
        }
        let range = |axis: usize| first[axis].max(0.0) as usize..=(last[axis].min(end - 1.0) as usize);
        let number = self.pieces.len() as u32;
        for row in range(1) {
            for column in range(0) {
                self.bins[row * BINS + column].push(number);
            }
        }
        self.pieces.push(Piece { color, form });
    }

    /// The color at a place in metres of the area, where a pixel is so many metres wide.
    #[must_use]
    pub fn color(&self, place: Vec2, pixel: f64) -> Option<[u8; 3]> {
        let bin = |along: f64, corner: f64| ((along - corner) / self.size * BINS as f64).floor();
        let (column, row) = (bin(place.x, self.corner[0]), bin(place.y, self.corner[1]));
        let range = 0.0..BINS as f64;
        if !(range.contains(&column) && range.contains(&row)) {
            return None;
        }
        let numbers = &self.bins[row as usize * BINS + column as usize];
        let pieces = numbers.iter().rev().map(|&number| &self.pieces[number as usize]);
        pieces.into_iter().find(|piece| piece.form.covers(place, pixel.min(LARGEST_PIXEL))).map(|piece| piece.color)
    }
}

impl Field for Exact {
    fn at(&self, place: Vec2, step: f64) -> [u8; 4] {
        let ground = Vec2::from_array(self.corner) + place * self.size;
        match self.color(ground, step * self.size) {
            Some([red, green, blue]) => [red, green, blue, 255],
            None => [0; 4],
        }
    }
}

fn metres(length: Length, pixel: f64) -> f64 {
    match length.unit {
        Unit::Metres => length.value,
        Unit::Pixels => length.value * pixel,
    }
}

impl Form {
    fn covers(&self, place: Vec2, pixel: f64) -> bool {
        match self {
            Form::Disc { at, size } => at.distance(place) <= metres(*size, pixel) / 2.0,
            Form::Line { from, to, width, is_round } => {
                let (way, arm) = (*to - *from, place - *from);
                let share = arm.dot(way) / way.length_squared();
                let is_before = share < 0.0 || share > 1.0 && !is_round;
                let nearest = *from + way * share.clamp(0.0, 1.0);
                !is_before && nearest.distance(place) <= metres(*width, pixel) / 2.0
            }
            Form::Area(slabs) => slabs.contains(place),
        }
    }
}

impl Slabs {
    fn new(rings: &Rings) -> Slabs {
        let all = || std::iter::once(&rings.outer).chain(&rings.holes);
        let (low, high) = rings.outer.iter().fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), &point| {
            (low.min(Vec2::from_array(point)), high.max(Vec2::from_array(point)))
        });
        let mut slabs = Slabs { low, high, slabs: vec![Vec::new(); SLABS] };
        for (&from, &to) in all().flat_map(|ring| edges(ring)) {
            let [first, last] = [from[1].min(to[1]), from[1].max(to[1])].map(|y| slabs.slab(y));
            let edge = [from, to].map(Vec2::from_array);
            slabs.slabs[first..=last].iter_mut().for_each(|slab| slab.push(edge));
        }
        slabs
    }

    fn slab(&self, y: f64) -> usize {
        let height = self.high.y - self.low.y;
        if height > 0.0 {
            ((y - self.low.y) / height * SLABS as f64).clamp(0.0, SLABS as f64 - 1.0) as usize
        } else {
            0
        }
    }

    /// Whether edges to the right of a place are odd in number.
    fn contains(&self, place: Vec2) -> bool {
        let is_in_box = place.cmpge(self.low).all() && place.cmple(self.high).all();
        let crossed = self.slabs[self.slab(place.y)].iter().filter(|[from, to]| {
            (from.y <= place.y) != (to.y <= place.y)
                && place.x < from.x + (to.x - from.x) * ((place.y - from.y) / (to.y - from.y))
        });
        is_in_box && crossed.count() % 2 == 1
    }
}
