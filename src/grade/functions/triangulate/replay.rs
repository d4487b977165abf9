//! Replay: triangles as ears, cut one after another, up to the first that is none.
//!
//! Who cuts ears puts out Previous, Current, Next of what is left at that time. So the order of the triangles tells at which step
//! something went wrong, and how.

use super::judge::{corners, is_within_edge, turn};
use super::{Case, Whole};

/// What is wrong with a cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slip {
    /// Current is a reflex corner.
    Reflex,
    /// Another corner is inside.
    Inside,
    /// Another corner is on the diagonal.
    OnDiagonal,
    /// Without area, while others were left.
    Flat,
    /// All cuts are ears, but they are too few.
    Early,
}

/// The first slip; `None` where there is none, or where the triangles are no ears.
pub(super) fn first_slip(case: &Case, triangles: &[[u32; 3]]) -> Option<Slip> {
    let count = case.ring.len();
    let mut left: Vec<u32> = (0..count as u32).collect();
    for triangle in triangles {
        let current = position_of_current(&left, *triangle)?;
        let others = || left.iter().filter(|index| !triangle.contains(index)).map(|&index| case.ring[index as usize]);
        let [before, now, after] = ear(&left, current).map(|index| case.ring[index as usize]);
        let area = turn(before, now, after);
        if area < 0 {
            return Some(Slip::Reflex);
        }
        if area > 0 && others().any(|p| is_inside(corners(&case.ring, *triangle), p)) {
            return Some(Slip::Inside);
        }
        if case.is_simple && area > 0 && others().any(|p| is_within_edge(before, after, p)) {
            return Some(Slip::OnDiagonal);
        }
        if case.is_simple && area == 0 && left.len() >= 3 {
            return Some(Slip::Flat);
        }
        left.remove(current);
    }
    (triangles.len() < count - 2).then_some(Slip::Early)
}

fn ear(left: &[u32], current: usize) -> [u32; 3] {
    let count = left.len();
    [left[(current + count - 1) % count], left[current], left[(current + 1) % count]]
}

/// Which of what is left a triangle cuts off.
fn position_of_current(left: &[u32], triangle: [u32; 3]) -> Option<usize> {
    if left.len() < 3 {
        return None;
    }
    (0..left.len()).find(|&current| {
        let mut sorted = ear(left, current);
        let mut wanted = triangle;
        sorted.sort_unstable();
        wanted.sort_unstable();
        sorted == wanted
    })
}

fn is_inside([a, b, c]: [Whole; 3], p: Whole) -> bool {
    let sides = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
    sides.iter().all(|&side| side > 0) || sides.iter().all(|&side| side < 0)
}

/// The triangles that are meant when they name places in the shrinking list, not corners.
pub(super) fn decoded(count: usize, triangles: &[[u32; 3]]) -> Option<Vec<[u32; 3]>> {
    let mut left: Vec<u32> = (0..count as u32).collect();
    let mut decoded = Vec::new();
    for triangle in triangles {
        if triangle.iter().any(|&place| place as usize >= left.len()) {
            return None;
        }
        decoded.push(triangle.map(|place| left[place as usize]));
        left.remove(triangle[1] as usize);
    }
    Some(decoded)
}
