//! Look: one wrong sample of any picture, and which mistake would explain it.
//!
//! DrawList, picture drawn, picture that is right -LOOK-> what the sample resembles, the mistake that explains it and the samples around it
//!
//! The grader names mistakes on small cases of its own. Here the case is what lies around a sample of the user's scene: its polygons become
//! [`Face`]s, every mutant paints the neighborhood, and one is named by the grader's measure: it leaves at most 5 % of what is wrong. Where
//! several do, all of them are named: a neighborhood may not tell them apart. Mirrored pictures show only in the whole one, so they are looked for there.
//!
//! Space: samples, levels encoded linearly. Cost: a hundred mutants times the polygons around the sample times 361 samples.

use super::case::{Case, Face};
use super::mutants::{self, Mutant};
use super::paint::paint;
use super::rules::{Border, Place, Rules};
use crate::color::Encoding;
use crate::image::{Image, Picture};
use crate::plan::{Interpolation, Varying};
use crate::raster::coverage;
use crate::screen::{DrawList, Evaluation, ScreenPolygon};

/// Samples around the one in question that are judged, in each direction, and how many more are painted.
const RADIUS: i32 = 7;
const MARGIN: i32 = 2;
/// Around a sample with more polygons no mistake is looked for.
const MOST_POLYGONS: usize = 400;
/// Part of the wrong samples that a named mistake leaves at most.
const LEFT: f64 = 0.05;
/// More mistakes that explain the same are not listed.
const MOST_NAMES: usize = 3;

/// What is seen at a wrong sample.
#[derive(Clone, Debug)]
pub struct Sight {
    /// What it shows.
    pub shown: [u8; 3],
    /// What is right.
    pub right: [u8; 3],
    /// Where that color comes from.
    pub resembles: Resembles,
    /// Wrong samples around it (or of the whole picture), and how many were judged.
    pub wrong: (usize, usize),
    /// Whether all of the picture was judged.
    pub is_whole: bool,
    /// Mistakes that explain it, with the wrong samples that each explains.
    pub mistakes: Vec<(Mutant, usize)>,
}

/// Whose color a sample shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resembles {
    /// The background's.
    Background,
    /// That of a polygon over the sample.
    Over(u32),
    /// That of a polygon whose bounds begin so many samples from the center.
    Beside(u32, f64),
    /// Nobody's.
    Nobody,
}

/// Looks at sample `at`; `None` when it is right. `drawn` and `right` have a pixel a sample of `list`, `background` is linear light.
#[must_use]
pub fn look(list: &DrawList, (drawn, right): (&Image, &Image), background: [f64; 3], at: (i32, i32)) -> Option<Sight> {
    let [drawn, right] = [drawn, right].map(|image| image.encode(Encoding::Linear));
    let place = (at.0 as usize, at.1 as usize);
    let (shown, expected) = (drawn.pixel(place.0, place.1), right.pixel(place.0, place.1));
    if are_alike(shown, expected) {
        return None;
    }
    let resembles = resembles(list, background, shown, at);
    let sight = Sight { shown, right: expected, resembles, wrong: (0, 0), is_whole: false, mistakes: Vec::new() };
    let turned = turned(&drawn, &right, place);
    if let Some((mistake, wrong, left)) = turned {
        let judged = drawn.width() * drawn.height();
        return Some(Sight {
            wrong: (wrong, judged),
            is_whole: true,
            mistakes: vec![(mistake, wrong - left)],
            ..sight
        });
    }
    Some(around(list, (&drawn, &right), background, at).map_or(sight.clone(), |(wrong, mistakes)| Sight {
        wrong,
        mistakes,
        ..sight
    }))
}

/// One level more or less is rounding.
fn are_alike(a: [u8; 3], b: [u8; 3]) -> bool {
    (0..3).all(|channel| a[channel].abs_diff(b[channel]) <= 1)
}

fn resembles(list: &DrawList, background: [f64; 3], shown: [u8; 3], (x, y): (i32, i32)) -> Resembles {
    let level = |light: f64| Encoding::Linear.level(light as f32);
    if are_alike(shown, background.map(level)) {
        return Resembles::Background;
    }
    let center = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let mut nearest = Resembles::Nobody;
    for polygon in list.polygons() {
        let color = list.shader.fragment(&polygon, x, y).color.to_array().map(|light| Encoding::Linear.level(light));
        if !are_alike(color, shown) {
            continue;
        }
        if coverage::covers(polygon.vertices(), list.grid, x, y) {
            return Resembles::Over(polygon.index);
        }
        let distance = distance(&polygon, center);
        if !matches!(nearest, Resembles::Beside(_, other) if other <= distance) {
            nearest = Resembles::Beside(polygon.index, distance);
        }
    }
    nearest
}

/// From a point to the bounds of a polygon.
fn distance(polygon: &ScreenPolygon<'_>, (x, y): (f64, f64)) -> f64 {
    let ((left, top), (right, bottom)) = bounds(polygon);
    let (dx, dy) = ((left - x).max(x - right).max(0.0), (top - y).max(y - bottom).max(0.0));
    (dx * dx + dy * dy).sqrt()
}

fn bounds(polygon: &ScreenPolygon<'_>) -> ((f64, f64), (f64, f64)) {
    let start = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    polygon.vertices().iter().fold(start, |(low, high), vertex| {
        ((low.0.min(vertex.x), low.1.min(vertex.y)), (high.0.max(vertex.x), high.1.max(vertex.y)))
    })
}

/// Whether the whole picture is mirrored or turned: the mistake, wrong samples, and those it leaves.
fn turned(drawn: &Picture, right: &Picture, (x, y): (usize, usize)) -> Option<(Mutant, usize, usize)> {
    let (width, height) = (drawn.width(), drawn.height());
    let turn = |place: Place, (x, y): (usize, usize)| match place {
        Place::UpsideDown => Some((x, height - 1 - y)),
        Place::Mirrored => Some((width - 1 - x, y)),
        Place::HalfTurn => Some((width - 1 - x, height - 1 - y)),
        Place::Transposed if width == height => Some((y, x)),
        _ => None,
    };
    let mismatches = |place: Option<Place>| {
        let all = (0..width * height).map(|at| (at % width, at / width));
        let source = |at: (usize, usize)| place.map_or(Some(at), |place| turn(place, at));
        all.filter(|&(x, y)| {
            !source((x, y)).is_some_and(|from| are_alike(drawn.pixel(x, y), right.pixel(from.0, from.1)))
        })
        .count()
    };
    let wrong = mismatches(None);
    mutants::usual().into_iter().find_map(|mutant| {
        let place = mutant.applied_to(&Rules::default()).place;
        let from = turn(place, (x, y))?;
        let explains = are_alike(drawn.pixel(x, y), right.pixel(from.0, from.1));
        let left = if explains { mismatches(Some(place)) } else { wrong };
        (left as f64 <= LEFT * wrong as f64).then_some((mutant, wrong, left))
    })
}

/// Wrong samples around `at`, samples judged, and the mistakes that explain them.
type Around = ((usize, usize), Vec<(Mutant, usize)>);

fn around(
    list: &DrawList,
    (drawn, right): (&Picture, &Picture),
    background: [f64; 3],
    at: (i32, i32),
) -> Option<Around> {
    let window = Window::new(list, at);
    let case = window.case(list, background)?;
    let places: Vec<(usize, usize, usize)> = window.judged(list).collect();
    // Where the faces do not give what the list does (clamped values), nothing can be judged by them.
    let honest = paint(&case, &Rules::default());
    let judged: Vec<_> = places.into_iter().filter(|&(x, y, index)| honest.allows(index, right.pixel(x, y))).collect();
    let left = |rules: &Rules| {
        let painted = paint(&case, rules);
        let explains_it = painted.allows(window.index(at), drawn.pixel(at.0 as usize, at.1 as usize));
        explains_it.then(|| judged.iter().filter(|&&(x, y, index)| !painted.allows(index, drawn.pixel(x, y))).count())
    };
    let wrong = judged.iter().filter(|&&(x, y, index)| !honest.allows(index, drawn.pixel(x, y))).count();
    let mut scores: Vec<(usize, Mutant)> = Vec::new();
    for mutant in mutants::usual().into_iter().filter(is_local) {
        if let Some(left) = left(&mutant.applied_to(&Rules::default())) {
            scores.push((left, mutant));
        }
    }
    scores.sort_by_key(|(left, _)| *left);
    let best = scores.first().map_or(usize::MAX, |(left, _)| *left);
    let slack = ((wrong as f64 * LEFT).ceil() as usize).max(1);
    let mut mistakes: Vec<(Mutant, usize)> = Vec::new();
    for (left, mutant) in scores {
        let is_new = mistakes.iter().all(|(other, _)| other.name != mutant.name);
        if is_new && left as f64 <= LEFT * wrong as f64 && left < best + slack && mistakes.len() < MOST_NAMES {
            mistakes.push((mutant, wrong - left));
        }
    }
    Some(((wrong, judged.len()), mistakes))
}

/// What a part of a picture can show: not where the whole of it lies.
fn is_local(mutant: &Mutant) -> bool {
    let rules = mutant.applied_to(&Rules::default());
    let turned = [Place::UpsideDown, Place::Mirrored, Place::HalfTurn, Place::Transposed];
    !turned.contains(&rules.place) && rules.border != Border::BeyondSquare
}

/// The samples around one, as far as the picture has them.
struct Window {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
    at: (i32, i32),
}

impl Window {
    fn new(list: &DrawList, at: (i32, i32)) -> Window {
        let reach = RADIUS + MARGIN;
        let (width, height) = (list.width as i32, list.height as i32);
        let (left, top) = ((at.0 - reach).max(0), (at.1 - reach).max(0));
        Window { left, top, right: (at.0 + reach + 1).min(width), bottom: (at.1 + reach + 1).min(height), at }
    }

    fn index(&self, (x, y): (i32, i32)) -> usize {
        ((y - self.top) * (self.right - self.left) + x - self.left) as usize
    }

    /// Column, row and number in the window of what is judged.
    fn judged(&self, list: &DrawList) -> impl Iterator<Item = (usize, usize, usize)> {
        let span = |center: i32, size: u32| (center - RADIUS).max(0)..(center + RADIUS + 1).min(size as i32);
        let (columns, rows) = (span(self.at.0, list.width), span(self.at.1, list.height));
        let samples = rows.flat_map(move |y| columns.clone().map(move |x| (x, y)));
        samples.map(|(x, y)| (x as usize, y as usize, self.index((x, y))))
    }

    /// Its polygons as faces; `None` where they are none: lines, lights at every sample, values linear on the screen.
    fn case(&self, list: &DrawList, background: [f64; 3]) -> Option<Case> {
        if list.varying != Varying::Color || list.interpolation != Interpolation::Perspective || !list.has_depth {
            return None;
        }
        let reaches = |polygon: &ScreenPolygon<'_>| {
            let ((left, top), (right, bottom)) = bounds(polygon);
            left <= f64::from(self.right + 1)
                && right >= f64::from(self.left - 1)
                && top <= f64::from(self.bottom + 1)
                && bottom >= f64::from(self.top - 1)
        };
        let near: Vec<_> = list.polygons().filter(reaches).collect();
        if near.len() > MOST_POLYGONS {
            return None;
        }
        let faces = near.iter().map(|polygon| self.face(list, polygon)).collect::<Option<Vec<_>>>()?;
        let size = ((self.right - self.left) as u32, (self.bottom - self.top) as u32);
        Some(Case { background, ..Case::new("around a sample", size, faces) })
    }

    fn face(&self, list: &DrawList, polygon: &ScreenPolygon<'_>) -> Option<Face> {
        let depth = polygon.depth_plane()?;
        let inverse_w = [depth.a, depth.b, depth.c];
        let over_w = |plane: &crate::screen::Plane| match plane.evaluation {
            Evaluation::Constant => inverse_w.map(|number| number * plane.c),
            _ => [plane.a, plane.b, plane.c],
        };
        let [red, green, blue] = polygon.varying_planes() else { return None };
        let face = Face {
            corners: polygon.vertices().iter().map(|vertex| (vertex.x, vertex.y)).collect(),
            inverse_w,
            over_w: [over_w(red), over_w(green), over_w(blue)],
            opacity: f64::from(list.shader.opacity(polygon).r),
        };
        Some(face.moved((f64::from(-self.left), f64::from(-self.top))))
    }
}
