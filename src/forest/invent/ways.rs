//! Ways: the river, roads that look for gentle slopes, and places with names.
//!
//! Relief -WAYS-> polylines over the whole area, cut into cells; marks
//!
//! A road goes from mark to mark; at each step it takes, of eleven directions around that of its goal, the one with the least of climb and detour. So it follows
//! contours where it can, as roads do.
//!
//! Space: world metres. Cost: some thousand steps of eleven heights, once an area; kept: 16 bytes every 40 m.

use super::regions::{Point, round};
use super::relief::Relief;
use crate::forest::area::{CellIndex, Line, Mark};
use crate::math::{cos, sin};
use crate::scene::Place;
use std::collections::BTreeMap;

/// Metres of a step.
const STEP: f64 = 40.0;

/// Lines of all cells that have some.
pub(super) type Lines = BTreeMap<CellIndex, Vec<Line>>;

/// The marks of an area: peaks, villages by the river, the lake.
pub(super) fn marks(relief: &Relief) -> Vec<Mark> {
    let [width, height] = relief.size;
    let mut marks = vec![mark("Lagoa Verde", relief.lake.center)];
    for (name, share) in [("Aldeia da Ponte", 0.16), ("Vale de Moinhos", 0.78)] {
        let y = height * share;
        marks.push(mark(name, [(relief.river(y) + 170.0).clamp(0.0, width), y]));
    }
    // The highest place of each quarter.
    for (name, quarter) in [
        ("Cabeço do Lobo", [0.0, 0.0]),
        ("Monte da Cruz", [0.5, 0.0]),
        ("Serra da Nave", [0.0, 0.5]),
        ("Pico Alto", [0.5, 0.5]),
    ] {
        let place = |index: u32| {
            [0, 1].map(|axis| {
                relief.size[axis] * (quarter[axis] + 0.04 + 0.42 * f64::from([index % 40, index / 40][axis]) / 39.0)
            })
        };
        let places = (0..1600).map(place);
        let highest = places.max_by(|a, b| relief.height(*a).total_cmp(&relief.height(*b)));
        marks.extend(highest.map(|at| mark(name, at)));
    }
    marks
}

fn mark(name: &str, at: Point) -> Mark {
    Mark { name: name.to_string(), at: at.map(round), place: Place::default() }
}

/// The river and the roads between the marks, by cell.
pub(super) fn lines(relief: &Relief, marks: &[Mark], side: f64) -> Lines {
    let mut lines = Lines::new();
    let steps = (relief.size[1] / STEP).ceil() as u32;
    let river: Vec<Point> = (0..=steps).map(|step| f64::from(step) * STEP).map(|y| [relief.river(y), y]).collect();
    add(&mut lines, "river", 14.0, &river, side, relief);
    // From village to village, and up to each peak from the nearer one.
    let Some([_, south, north, peaks @ ..]) = marks.get(..) else { return lines };
    add(&mut lines, "road", 7.0, &road(relief, south.at, north.at), side, relief);
    for peak in peaks {
        let distance = |village: &Mark| (village.at[0] - peak.at[0]).abs() + (village.at[1] - peak.at[1]).abs();
        let village = if distance(south) < distance(north) { south } else { north };
        add(&mut lines, "road", 5.0, &road(relief, village.at, peak.at), side, relief);
    }
    lines
}

/// Steps from one place toward another, where it is not steep and not in the lake.
fn road(relief: &Relief, from: Point, to: Point) -> Vec<Point> {
    let mut points = vec![from];
    let mut at = from;
    let mut last = [0.0; 2];
    for _ in 0..((relief.size[0] + relief.size[1]) * 2.0 / STEP) as usize {
        let off = [to[0] - at[0], to[1] - at[1]];
        let distance = (off[0] * off[0] + off[1] * off[1]).sqrt();
        if distance < 1.5 * STEP {
            break;
        }
        let toward = off.map(|part| part / distance);
        let height = relief.height(at);
        let try_turn = |turn: i32| {
            let angle = f64::from(turn) * 0.26;
            let (c, s) = (cos(angle), sin(angle));
            let way = [toward[0] * c - toward[1] * s, toward[0] * s + toward[1] * c];
            let next = [at[0] + way[0] * STEP, at[1] + way[1] * STEP];
            let ahead = [at[0] + way[0] * 4.0 * STEP, at[1] + way[1] * 4.0 * STEP];
            let climb = (relief.height(next) - height).abs() / STEP
                + 0.7 * (relief.height(ahead) - height).abs() / (4.0 * STEP);
            let bend = 1.0 - (way[0] * last[0] + way[1] * last[1]);
            let wet = if relief.lake.share(ahead) < 1.15 { 50.0 } else { 0.0 };
            (6.0 * climb + 0.4 * angle * angle + 1.3 * bend + wet, next, way)
        };
        let Some((_, next, way)) = (-5..=5).map(try_turn).min_by(|a, b| a.0.total_cmp(&b.0)) else { break };
        points.push(next);
        (at, last) = (next, way);
    }
    points.push(to);
    points
}

/// Cuts a polyline at the borders of cells and adds its pieces to them; what lies in the lake is left out.
fn add(lines: &mut Lines, kind: &str, width: f64, points: &[Point], side: f64, relief: &Relief) {
    let cell = |at: Point| at.map(|metres| (metres / side).floor() as i32);
    let inside =
        |at: Point| (0..2).all(|axis| (0.0..relief.size[axis]).contains(&at[axis])) && relief.lake.share(at) > 0.99;
    let mut open: Option<CellIndex> = None;
    for pair in points.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let shares = border_shares(a, b, side);
        let at = |share: f64| [0, 1].map(|axis| round(a[axis] + (b[axis] - a[axis]) * share));
        for piece in shares.windows(2).filter(|piece| piece[1] > piece[0]) {
            let middle = at(0.5 * (piece[0] + piece[1]));
            let index = cell(middle);
            if !inside(middle) {
                open = None;
                continue;
            }
            let local =
                |point: Point| [0, 1].map(|axis| (point[axis] - f64::from(index[axis]) * side).clamp(0.0, side));
            let (start, end) = (local(at(piece[0])), local(at(piece[1])));
            let own = lines.entry(index).or_default();
            match own.last_mut().filter(|_| open == Some(index)) {
                Some(line) => line.points.push(end),
                None => {
                    own.push(Line { kind: kind.to_string(), width, points: vec![start, end], place: Place::default() })
                }
            }
            open = Some(index);
        }
    }
    for line in lines.values_mut().flatten() {
        line.points.dedup();
    }
    lines.values_mut().for_each(|own| own.retain(|line| line.points.len() > 1));
    lines.retain(|_, own| !own.is_empty());
}

/// Where a step begins, passes borders of cells, and ends, in order; 0 to 1.
fn border_shares(a: Point, b: Point, side: f64) -> Vec<f64> {
    let mut shares = vec![0.0, 1.0];
    for axis in 0..2 {
        let (low, high) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
        let crossed = ((low / side).floor() as i64 + 1)..=(high / side).floor() as i64;
        shares.extend(crossed.map(|border| (border as f64 * side - a[axis]) / (b[axis] - a[axis])));
    }
    shares.sort_by(f64::total_cmp);
    shares
}
