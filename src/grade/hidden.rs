//! Hidden probes: the pictures of a lab turned, mirrored, moved and colored anew, as a number says that students do not have.
//!
//! Aspect, seed -HIDDEN-> cases that ask the same questions with other pictures
//!
//! Why made of the visible ones: what an aspect asks (an edge through a center, a notch on a scan line) must stay what it is, so
//! that points of both sets mean the same and every mistake keeps its name. A program that has learned the visible
//! pictures by heart fails: none of its outlines is where it was. Only random triangles of the seed are new altogether.
//!
//! Exact: corners stay multiples of 1/256, and centers on edges stay on edges. Lit pictures are mirrored through the
//! view axis with their lamps and normals; turning them would change the angle of view.

use super::case::{Case, Face, Lamp};
use super::cases::Random;
use super::labs::Aspect;

/// Which probes of a lab are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Probes {
    /// Those that `farop suite LAB` hands out.
    Visible,
    /// Those that only the grader has.
    Hidden,
}

/// Pictures are made larger by at most so many pixels at each side.
const MARGIN: u64 = 3;

/// The hidden cases of an aspect.
#[must_use]
pub fn cases(aspect: &Aspect, seed: u64) -> Vec<Case> {
    let letters = aspect.name.bytes().fold(0_u64, |sum, letter| sum.wrapping_mul(31).wrapping_add(u64::from(letter)));
    let mut random = Random(seed ^ letters.rotate_left(32) ^ 0x000F_AB1E);
    // The random ones among them are others than those of any small seed.
    let visible = (aspect.cases)(random.next());
    let touches = visible.iter().any(reaches_border);
    visible.into_iter().map(|case| changed(case, &mut random, touches)).collect()
}

/// Whether a face reaches the side of the picture: then that is what is asked about, and there is no room to move in.
fn reaches_border(case: &Case) -> bool {
    let (width, height) = (f64::from(case.width), f64::from(case.height));
    let outside = |&(x, y): &(f64, f64)| x <= 0.0 || y <= 0.0 || x >= width || y >= height;
    case.faces.iter().any(|face| face.corners.iter().any(outside))
}

fn changed(mut case: Case, random: &mut Random, touches: bool) -> Case {
    // One of the seven that are not the picture itself; lit ones only mirror.
    let turn = 1 + random.next() % if case.lamp.is_some() { 3 } else { 7 };
    if turn & 1 == 1 {
        case = mirrored(case);
    }
    if turn & 2 == 2 {
        case = upside_down(case);
    }
    if turn & 4 == 4 {
        case = transposed(case);
    }
    case = recolored(case, random.next() % 5 + 1);
    if !touches && case.lamp.is_none() {
        case = moved(case, random);
    }
    case
}

/// Left becomes right.
fn mirrored(case: Case) -> Case {
    let width = f64::from(case.width);
    let turn = |[a, b, c]: [f64; 3]| [-a, b, c + a * width];
    let mut case = with_faces(case, |(x, y)| (width - x, y), turn);
    if let Some(lamp) = &mut case.lamp {
        reflect(lamp, &mut case.faces, 0);
    }
    case
}

/// Above becomes below.
fn upside_down(case: Case) -> Case {
    let height = f64::from(case.height);
    let turn = |[a, b, c]: [f64; 3]| [a, -b, c + b * height];
    let mut case = with_faces(case, |(x, y)| (x, height - y), turn);
    if let Some(lamp) = &mut case.lamp {
        reflect(lamp, &mut case.faces, 1);
    }
    case
}

/// Columns become rows.
fn transposed(case: Case) -> Case {
    let (width, height) = (case.height, case.width);
    let case = with_faces(case, |(x, y)| (y, x), |[a, b, c]| [b, a, c]);
    Case { width, height, ..case }
}

fn with_faces(
    case: Case,
    place: impl Fn((f64, f64)) -> (f64, f64),
    turn: impl Fn([f64; 3]) -> [f64; 3] + Copy,
) -> Case {
    let changed = |face: &Face| Face {
        corners: face.corners.iter().map(|&corner| place(corner)).collect(),
        inverse_w: turn(face.inverse_w),
        over_w: face.over_w.map(turn),
        opacity: face.opacity,
    };
    Case { faces: case.faces.iter().map(changed).collect(), ..case }
}

/// Lamps and normals, mirrored along an axis of eye space.
fn reflect(lamp: &mut Lamp, faces: &mut [Face], axis: usize) {
    lamp.position[axis] = -lamp.position[axis];
    if let Some((position, _)) = &mut lamp.second {
        position[axis] = -position[axis];
    }
    for face in faces {
        face.over_w[axis] = face.over_w[axis].map(|number| -number);
    }
}

/// Red, green and blue exchanged: one of the five orders that are not their own.
fn recolored(mut case: Case, order: u64) -> Case {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let order = ORDERS[order as usize % 6];
    let mixed = |color: [f64; 3]| order.map(|channel| color[channel]);
    case.background = mixed(case.background);
    if let Some(lamp) = &mut case.lamp {
        (lamp.color, lamp.ambient, lamp.diffuse) = (mixed(lamp.color), mixed(lamp.ambient), mixed(lamp.diffuse));
        lamp.second = lamp.second.map(|(position, color)| (position, mixed(color)));
        return case;
    }
    for face in &mut case.faces {
        face.over_w = order.map(|channel| face.over_w[channel]);
    }
    case
}

/// A larger picture, in which it stands somewhere else.
fn moved(case: Case, random: &mut Random) -> Case {
    let mut pixels = || random.next() % (MARGIN + 1);
    let [left, above, right, below] = [0; 4].map(|_| pixels() as u32 * case.samples);
    let faces = case.faces.iter().map(|face| face.moved((f64::from(left), f64::from(above)))).collect();
    Case { width: case.width + left + right, height: case.height + above + below, faces, ..case }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::labs::LABS;
    use crate::grade::paint::paint;
    use crate::grade::rules::Rules;

    fn aspects() -> impl Iterator<Item = &'static Aspect> {
        LABS.iter().flat_map(|lab| lab.aspects)
    }

    #[test]
    fn the_same_number_gives_the_same_probes_and_another_gives_others() {
        for aspect in aspects().filter(|aspect| !(aspect.cases)(1).is_empty()) {
            assert_eq!(cases(aspect, 7), cases(aspect, 7), "{}", aspect.name);
            assert_ne!(cases(aspect, 7), cases(aspect, 8), "{}", aspect.name);
        }
    }

    #[test]
    fn no_visible_picture_passes_for_a_hidden_one() {
        for aspect in aspects() {
            let seen: Vec<_> = (aspect.cases)(1).iter().map(|case| paint(case, &Rules::default())).collect();
            for case in cases(aspect, 77) {
                let right = paint(&case, &Rules::default());
                // A picture of a whole color is the same from all sides.
                let is_plain = right.low.iter().all(|level| *level == right.low[0]);
                assert!(is_plain || !seen.contains(&right), "{}: {}", aspect.name, case.name);
            }
        }
    }

    #[test]
    fn corners_stay_on_the_grid() {
        let on_grid = |number: f64| (number * 256.0).fract() == 0.0;
        for case in aspects().flat_map(|aspect| cases(aspect, 3)) {
            let corners = case.faces.iter().flat_map(|face| &face.corners);
            assert!(corners.into_iter().all(|&(x, y)| on_grid(x) && on_grid(y)), "{}", case.name);
            assert_eq!((case.width % case.samples, case.height % case.samples), (0, 0), "{}", case.name);
        }
    }
}
