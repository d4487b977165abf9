//! Witness: the smallest case that shows a mistake, found by making a failing one smaller.
//!
//! failing case -SHRINK-> fewer faces, three corners, a smaller picture, rounder numbers -> text and a screen file
//!
//! Every smaller case is drawn by the subject anew, and kept when it still fails the same way: as the named mistake says, or,
//! without a name, at all. Pictures made elsewhere cannot be asked again; for them the smallest failing case there is stays.
//!
//! Cost: one drawing a try, at most [`MOST_TRIES`].

use super::case::{Case, Face};
use super::covered::{Outline, cross};
use super::paint::{Painted, paint};
use super::rules::Rules;
use super::subject::Subject;
use super::verdict::{Cause, Shot, Verdict, checked, wrong};
use crate::image::Picture;
use crate::math::edges;
use crate::plan::Accepts;
use crate::screen::file::{Attributes, ScreenWriteError, write_v2};

/// Drawings that one witness may cost.
const MOST_TRIES: usize = 240;

/// A small failing case.
#[derive(Clone, Debug)]
pub struct Witness {
    /// What to draw.
    pub case: Case,
    /// Wrong pixels.
    pub wrong: usize,
    /// The first of them: column and row.
    pub first: (usize, usize),
    /// What it shows, and what it should.
    pub levels: ([u8; 3], [u8; 3]),
    /// The picture: `#` right, `.` background, `!` extra, `?` missing, `z` a face behind, `~` another color.
    pub rows: Vec<String>,
    /// Edge by edge, on which side of it the first wrong sample lies.
    pub edges: Vec<String>,
}

impl Witness {
    /// The case as a v2 screen file.
    ///
    /// # Errors
    /// Whatever the writer says.
    pub fn screen_file(&self) -> Result<Vec<u8>, ScreenWriteError> {
        let mut text = Vec::new();
        write_v2(&self.case.list(Accepts::AnyPolygon), &self.case.sheet(), Attributes::default(), &mut text)?;
        Ok(text)
    }
}

/// Gives every aspect that is charged with something its witness.
pub(super) fn find_all(subject: &dyn Subject, verdict: &mut Verdict) {
    for index in 0..verdict.aspects.len() {
        let contract = (Rules::default(), None);
        let (before, after) = match &verdict.aspects[index].cause {
            Some(Cause::Named(fault)) => {
                let rules = verdict.faults[*fault].rules.clone();
                (rules.0, Some(rules.1))
            }
            Some(Cause::Unexplained { .. }) => contract,
            _ => continue,
        };
        verdict.aspects[index].witness = find(subject, &verdict.aspects[index].shots, &Goal { before, after });
    }
}

/// How a case must fail.
struct Goal {
    /// Not as these rules say.
    before: Rules,
    /// But as these do.
    after: Option<Rules>,
}

impl Goal {
    fn is_met(&self, case: &Case, picture: &Picture) -> bool {
        let differs = !wrong(picture, &paint(case, &self.before)).is_empty();
        differs && self.after.as_ref().is_none_or(|after| wrong(picture, &paint(case, after)).is_empty())
    }
}

fn find(subject: &dyn Subject, shots: &[Shot], goal: &Goal) -> Option<Witness> {
    let failing = |goal: &Goal| {
        let meets = |shot: &&Shot| shot.picture().is_some_and(|picture| goal.is_met(&shot.case, picture));
        shots.iter().filter(meets).min_by_key(|shot| (shot.case.faces.len(), shot.case.width * shot.case.height))
    };
    // Where no case fails exactly as the mistake says, any failing one is better than none.
    let any = Goal { before: goal.before.clone(), after: None };
    let (shot, goal) = failing(goal).map(|shot| (shot, goal)).or_else(|| failing(&any).map(|shot| (shot, &any)))?;
    let (case, picture) = match subject.can_draw_anything() {
        true => Shrinking { subject, goal, tries: 0 }.shrink(shot),
        false => (shot.case.clone(), shot.picture()?.clone()),
    };
    Some(described(case, &picture, &goal.before))
}

struct Shrinking<'a> {
    subject: &'a dyn Subject,
    goal: &'a Goal,
    tries: usize,
}

impl Shrinking<'_> {
    fn shrink(mut self, shot: &Shot) -> (Case, Picture) {
        let (mut case, mut picture) = (shot.case.clone(), None);
        while let Some(found) = self.first_failing(smaller(&case)) {
            case = found.0;
            picture = Some(found.1);
        }
        let picture = picture.or_else(|| shot.picture().cloned()).unwrap_or_else(|| Picture::filled(1, 1, [0; 3]));
        (case, picture)
    }

    /// The first of `cases` that fails. Drawn together or one by one, the same is found after as many tries.
    fn first_failing(&mut self, mut cases: Vec<Case>) -> Option<(Case, Picture)> {
        cases.truncate(MOST_TRIES.saturating_sub(self.tries));
        // All are made of one case, so they have one sheet.
        let sheet = cases.first()?.sheet();
        for cases in cases.chunks(self.subject.batch()) {
            let lists: Vec<_> = cases.iter().map(|case| case.list(self.subject.accepts())).collect();
            for (case, answer) in cases.iter().zip(self.subject.draw_all(&lists, &sheet)) {
                self.tries += 1;
                let picture = checked(answer, &paint(case, &Rules::default())).map(|answer| answer.picture);
                if let Some(picture) = picture.ok().filter(|picture| self.goal.is_met(case, picture)) {
                    return Some((case.clone(), picture));
                }
            }
        }
        None
    }
}

/// Cases a step smaller, the greatest steps first. Every one is smaller in faces, corners, area or roundness, so it ends.
fn smaller(case: &Case) -> Vec<Case> {
    let mut cases = Vec::new();
    let with_faces = |faces: Vec<Face>| Case { faces, ..case.clone() };
    if case.faces.len() > 2 {
        let half = case.faces.len() / 2;
        cases.extend([with_faces(case.faces[..half].to_vec()), with_faces(case.faces[half..].to_vec())]);
    }
    for index in 0..case.faces.len() {
        let mut faces = case.faces.clone();
        faces.remove(index);
        if !faces.is_empty() {
            cases.push(with_faces(faces));
        }
    }
    for (index, face) in case.faces.iter().enumerate().filter(|(_, face)| face.corners.len() > 3) {
        for corner in 0..face.corners.len() {
            let mut faces = case.faces.clone();
            faces[index].corners.remove(corner);
            cases.push(with_faces(faces));
        }
    }
    cases.extend(cropped(case));
    for grid in [1.0, 0.5, 0.25, 0.125] {
        cases.extend(rounded(case, grid));
    }
    cases
}

/// The case with whole rows or columns cut off that no face reaches.
fn cropped(case: &Case) -> Option<Case> {
    let corners = || case.faces.iter().flat_map(|face| face.corners.iter());
    let low = corners().fold((f64::INFINITY, f64::INFINITY), |low, corner| (low.0.min(corner.0), low.1.min(corner.1)));
    let high = corners().fold((1.0, 1.0), |high: (f64, f64), corner| (high.0.max(corner.0), high.1.max(corner.1)));
    let side = f64::from(case.samples);
    let cut = |low: f64| (low / side).floor().max(0.0) * side;
    let keep = |high: f64, cut: f64| (((high - cut) / side).ceil() * side) as u32;
    let (dx, dy) = (cut(low.0), cut(low.1));
    // A lamp lights points of the picture as a whole.
    if case.lamp.is_some() {
        return None;
    }
    let (width, height) = (keep(high.0, dx).min(case.width), keep(high.1, dy).min(case.height));
    let faces = case.faces.iter().map(|face| face.moved((-dx, -dy))).collect();
    (width * height < case.width * case.height).then(|| Case { width, height, faces, ..case.clone() })
}

/// The case with one corner moved to a coarser grid, for every corner that is not on it.
fn rounded(case: &Case, grid: f64) -> Vec<Case> {
    let round = |x: f64| (x / grid).round() * grid;
    let mut cases = Vec::new();
    for (index, face) in case.faces.iter().enumerate() {
        for (corner, &(x, y)) in face.corners.iter().enumerate() {
            let moved = (round(x), round(y));
            let inside = moved.0 <= f64::from(case.width) && moved.1 <= f64::from(case.height);
            if moved != (x, y) && inside && face.is_flat() && face.inverse_w[..2] == [0.0, 0.0] {
                let mut faces = case.faces.clone();
                faces[index].corners[corner] = moved;
                cases.push(Case { faces, ..case.clone() });
            }
        }
    }
    cases
}

fn described(case: Case, picture: &Picture, before: &Rules) -> Witness {
    let right = paint(&case, before);
    let all = wrong(picture, &right);
    let first = all.first().copied().unwrap_or(0);
    let place = (first % right.width, first / right.width);
    let sample = ((place.0 as u32 * case.samples) as i32, (place.1 as u32 * case.samples) as i32);
    let rows =
        (0..right.height).map(|y| (0..right.width).map(|x| symbol(&case, picture, &right, (x, y))).collect::<String>());
    Witness {
        wrong: all.len(),
        first: place,
        levels: (picture.pixel(place.0, place.1), right.low[first]),
        rows: rows.collect(),
        edges: edge_values(&case, &right, sample),
        case,
    }
}

fn symbol(case: &Case, picture: &Picture, right: &Painted, (x, y): (usize, usize)) -> char {
    let index = y * right.width + x;
    let (shown, front) = (picture.pixel(x, y), right.front[index]);
    if right.allows(index, shown) {
        return if front.is_some() || right.high[index] != level(case.background) { '#' } else { '.' };
    }
    let is_background = (0..3).all(|channel| shown[channel].abs_diff(level(case.background)[channel]) <= 1);
    match (front, is_background) {
        (None, false) => '!',
        (Some(_), true) => '?',
        (Some(front), false) if shows_another(case, (shown, front), ((x as i32), (y as i32))) => 'z',
        _ => '~',
    }
}

fn level(color: [f64; 3]) -> [u8; 3] {
    color.map(|light| (light.clamp(0.0, 1.0) * 255.0).round() as u8)
}

/// Whether a flat face other than the front one covers the sample and has the color that is shown.
fn shows_another(case: &Case, (shown, front): ([u8; 3], usize), sample: (i32, i32)) -> bool {
    let rules = Rules::default();
    case.faces.iter().enumerate().any(|(index, face)| {
        index != front
            && level(face.values_at(face.corners[0])) == shown
            && Outline::new(&face.corners, &rules, (case.width, case.height)).covers(sample, &rules)
    })
}

/// The edges of the face in question, with the side on which the center of the sample lies.
fn edge_values(case: &Case, right: &Painted, sample: (i32, i32)) -> Vec<String> {
    let center = (f64::from(sample.0) + 0.5, f64::from(sample.1) + 0.5);
    let at = (sample.1 as usize / case.samples as usize) * right.width + sample.0 as usize / case.samples as usize;
    let Some(face) = case.faces.get(right.front[at].unwrap_or(0)) else { return Vec::new() };
    let edge = |(a, b): (&(f64, f64), &(f64, f64))| {
        let value = cross(*a, *b, center);
        let side = if value > 0.0 {
            "right of it"
        } else if value < 0.0 {
            "left of it"
        } else {
            "exactly on it"
        };
        format!("({}, {}) to ({}, {}): {value:+}, {side}", a.0, a.1, b.0, b.1)
    };
    edges(&face.corners).map(edge).collect()
}
