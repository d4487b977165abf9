//! Draw: shapes into a texture, through a drape's matrix.
//!
//! shapes, matrix -DRAW-> rings in texels -`fill`-> texels with alpha
//!
//! Lines are areas on the ground here: a piece has four corners, a corner a disc, and all turn the same way, so that what they cover together is covered once.
//! A width in pixels is one in metres that grows with the distance from the eye, linearly, as the way across a pixel does.
//!
//! Why everything is cut before it is divided: behind the center of the map's perspective there is no place on the map, and near it places are
//! infinitely far off. What can be seen is farther from the center than that (`forest::drape`).
//!
//! Space: metres of the area in, texels out, row 0 the lowest. Cost: the edges of all shapes, and the texels they cover.

use super::fill::{Rule, fill};
use super::{Length, Pen, Shape, Unit};
use crate::forest::drape::Drape;
use crate::forest::polygon::Point;
use crate::forest::vector::{Geometry, Rings};
use crate::image::textures::{FirstRow, Texels};
use crate::math::{Mat3, Vec2, Vec3};

/// Corners of a disc.
const CORNERS: usize = 12;
/// What is nearer to the center of the perspective than this share of what can be seen is cut off.
const NEAREST: f64 = 0.5;

/// Draws shapes, the first lowest, into `side` x `side` texels. Where nothing is, alpha is 0. `pixel` says how many metres a pixel across the view has at a
/// place. `None` for no texels, or more than a picture has.
#[must_use]
pub fn draw(shapes: &[Shape], drape: &Drape, side: u32, pixel: &dyn Fn(Point) -> f64) -> Option<Texels> {
    let count = side as usize * side as usize;
    let scale = f64::from(side);
    let texels = Mat3::from_diagonal(Vec3::new(scale, scale, 1.0));
    let least = drape.strength.map_or(NEAREST, |strength| strength * NEAREST);
    let mut sheet =
        Sheet { pixel, matrix: texels * drape.texture_from_ground, least, side, colors: vec![[0.0; 4]; count] };
    shapes.iter().for_each(|shape| sheet.shape(shape));
    let rgba = sheet.colors.iter().map(|&[red, green, blue, alpha]| {
        let level = |channel: f32| if alpha > 0.0 { (channel / alpha).round().clamp(0.0, 255.0) as u8 } else { 0 };
        [level(red), level(green), level(blue), (alpha * 255.0).round().clamp(0.0, 255.0) as u8]
    });
    Texels::new(side, side, rgba.collect(), FirstRow::AtV0)
}

/// Texels while they are drawn: display values times alpha, and alpha.
struct Sheet<'a> {
    pixel: &'a dyn Fn(Point) -> f64,
    matrix: Mat3,
    least: f64,
    side: u32,
    colors: Vec<[f32; 4]>,
}

impl Sheet<'_> {
    fn shape(&mut self, shape: &Shape) {
        match &shape.geometry {
            Geometry::Points(points) => {
                let Some(color) = shape.fill else { return };
                let discs = points.iter().map(|&point| disc(point, self.metres(shape.size, point) / 2.0));
                let discs: Vec<Vec<Point>> = discs.map(|disc| self.projected(&disc)).collect();
                self.put(&discs, Rule::NonZero, color);
            }
            Geometry::Lines(lines) => {
                lines.iter().for_each(|line| self.line(line, false, shape.pen));
            }
            Geometry::Polygons(polygons) => polygons.iter().for_each(|rings| self.polygon(rings, shape)),
        }
    }

    fn polygon(&mut self, rings: &Rings, shape: &Shape) {
        let all = || std::iter::once(&rings.outer).chain(&rings.holes);
        if let Some(color) = shape.fill {
            let projected: Vec<Vec<Point>> = all().map(|ring| self.projected(ring)).collect();
            self.put(&projected, Rule::EvenOdd, color);
        }
        all().for_each(|ring| self.line(ring, true, shape.pen));
    }

    fn line(&mut self, line: &[Point], is_closed: bool, pen: Option<Pen>) {
        let Some(pen) = pen else { return };
        let closing = line.first().filter(|_| is_closed);
        let line: Vec<Point> = line.iter().chain(closing).copied().collect();
        let mut rings = Vec::new();
        for piece in dashed(&line, pen.dash) {
            stroke(&piece, |point| self.metres(pen.width, point) / 2.0, &mut rings);
        }
        rings.iter_mut().for_each(|ring| *ring = self.projected(ring));
        self.put(&rings, Rule::NonZero, pen.color);
    }

    /// A length at a place, in metres of the ground.
    fn metres(&self, length: Length, at: Point) -> f64 {
        match length.unit {
            Unit::Metres => length.value,
            Unit::Pixels => length.value * (self.pixel)(at),
        }
    }

    fn homogeneous(&self, [x, y]: Point) -> Vec3 {
        self.matrix * Vec3::new(x, y, 1.0)
    }

    /// A ring in texels, cut where it comes too near to the center.
    fn projected(&self, ring: &[Point]) -> Vec<Point> {
        let mut left = Vec::with_capacity(ring.len() + 2);
        let Some(&last) = ring.last() else { return left };
        let mut from = self.homogeneous(last);
        for &point in ring {
            let to = self.homogeneous(point);
            if (from.z > self.least) != (to.z > self.least) {
                left.push(divided(self.cut(from, to)));
            }
            if to.z > self.least {
                left.push(divided(to));
            }
            from = to;
        }
        left
    }

    fn cut(&self, from: Vec3, to: Vec3) -> Vec3 {
        let point = from + (to - from) * ((self.least - from.z) / (to.z - from.z));
        Vec3::new(point.x, point.y, self.least)
    }

    fn put(&mut self, rings: &[Vec<Point>], rule: Rule, color: [u8; 3]) {
        let (side, colors) = (self.side as usize, &mut self.colors);
        let over = color.map(f32::from);
        fill(rings, rule, self.side, |row, column, shares| {
            let first = row * side + column;
            for (texel, &share) in colors[first..first + shares.len()].iter_mut().zip(shares) {
                let share = share.min(1.0);
                for (channel, value) in texel.iter_mut().zip([over[0], over[1], over[2], 1.0]) {
                    *channel = *channel * (1.0 - share) + value * share;
                }
            }
        });
    }
}

fn divided(place: Vec3) -> Point {
    (place.truncate() / place.z).to_array()
}

/// A disc, counterclockwise.
fn disc([x, y]: Point, radius: f64) -> Vec<Point> {
    (0..CORNERS)
        .map(|corner| {
            let angle = 2.0 * crate::math::PI * corner as f64 / CORNERS as f64;
            [x + radius * crate::math::cos(angle), y + radius * crate::math::sin(angle)]
        })
        .collect()
}

/// What a pen covers along a line, half as wide as `radius` says at each corner: rings that all turn counterclockwise.
fn stroke(line: &[Point], radius: impl Fn(Point) -> f64, rings: &mut Vec<Vec<Point>>) {
    for pair in line.windows(2) {
        let (from, to) = (Vec2::from_array(pair[0]), Vec2::from_array(pair[1]));
        let Some(along) = (to - from).try_normalize() else { continue };
        let aside = Vec2::new(-along.y, along.x);
        let (first, last) = (aside * radius(pair[0]), aside * radius(pair[1]));
        rings.push([from - first, to - last, to + last, from + first].map(|corner| corner.to_array()).to_vec());
    }
    // Ends stay as they are: a road ends where it does. Corners in between are round.
    let inner = line.get(1..line.len().saturating_sub(1)).unwrap_or_default();
    rings.extend(inner.iter().map(|&corner| disc(corner, radius(corner))));
    if line.first() == line.last() {
        rings.extend(line.first().map(|&corner| disc(corner, radius(corner))));
    }
}

/// A line cut into dashes.
pub(super) fn dashed(line: &[Point], dash: Option<[f64; 2]>) -> Vec<Vec<Point>> {
    /// Dashes of one line: more would not be seen.
    const MOST: usize = 100_000;
    let Some([on, off]) = dash else { return vec![line.to_vec()] };
    let mut pieces: Vec<Vec<Point>> = line.first().map(|&first| vec![first]).into_iter().collect();
    let (mut left, mut is_on) = (on, true);
    for pair in line.windows(2) {
        let (mut from, to) = (Vec2::from_array(pair[0]), Vec2::from_array(pair[1]));
        while from.distance(to) > left && pieces.len() < MOST {
            from += (to - from).normalize_or_zero() * left;
            if is_on {
                pieces.last_mut().into_iter().for_each(|piece| piece.push(from.to_array()));
            } else {
                pieces.push(vec![from.to_array()]);
            }
            is_on = !is_on;
            left = if is_on { on } else { off };
        }
        left -= from.distance(to);
        if is_on {
            pieces.last_mut().into_iter().for_each(|piece| piece.push(to.to_array()));
        }
    }
    pieces
}
