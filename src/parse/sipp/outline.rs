//! Is this a simple outline in the plane? For prisms.
//!
//! Two edges that are no neighbors may not touch, neighbors may not fold back onto each other; decided exactly.
//!
//! Why sorted by x: edges can only touch where their extents overlap, so each is compared with few others. An outline has at
//! most [`MOST_POINTS`], so that even the worst takes a moment.

use crate::parse::area::turn_in_plane;

/// Points of the longest outline that is checked, and so accepted.
const MOST_POINTS: usize = 10_000;

/// What is wrong with an outline, and what to do.
pub(super) struct Fault {
    pub message: String,
    pub help: &'static str,
}

/// Simple, with an area, not too long.
pub(super) fn check(points: &[[f64; 2]]) -> Result<(), Fault> {
    let fault = |message: String, help| Err(Fault { message, help });
    let count = points.len();
    if count < 3 {
        return fault(
            format!("an outline has at least 3 points, this one has {count}"),
            "write `outline X Y X Y X Y ...`",
        );
    }
    if count > MOST_POINTS {
        let message = format!("an outline has at most {MOST_POINTS} points, this one has {count}");
        return fault(message, "cut the prism into several");
    }
    if let Some((a, b)) = crossing(points) {
        let message = format!("the outline crosses or touches itself: edges {} and {}", a + 1, b + 1);
        return fault(message, "edge 1 leads from the first point to the second; go once around the shape");
    }
    Ok(())
}

/// The enclosed area is on the right-hand side. For simple outlines.
pub(super) fn is_clockwise(points: &[[f64; 2]]) -> bool {
    // At the lowest of the leftmost points a simple outline turns the way it goes round.
    let count = points.len();
    let order = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    let Some(at) = (0..count).min_by(|&a, &b| order(&points[a], &points[b])) else { return false };
    turn_in_plane(points[(at + count - 1) % count], points[at], points[(at + 1) % count]) < 0.0
}

/// Two edges that touch where they should not.
fn crossing(points: &[[f64; 2]]) -> Option<(usize, usize)> {
    let count = points.len();
    let edge = |index: usize| (points[index], points[(index + 1) % count]);
    let left = |index: usize| edge(index).0[0].min(edge(index).1[0]);
    let right = |index: usize| edge(index).0[0].max(edge(index).1[0]);
    let mut by_left: Vec<usize> = (0..count).collect();
    by_left.sort_by(|&a, &b| left(a).total_cmp(&left(b)).then(a.cmp(&b)));
    for (rank, &a) in by_left.iter().enumerate() {
        for &b in by_left[rank + 1..].iter().take_while(|&&b| left(b) <= right(a)) {
            let (first, second) = (a.min(b), a.max(b));
            let touches = if second == first + 1 {
                folds_back(points[first], points[second], points[(second + 1) % count])
            } else if first == 0 && second == count - 1 {
                folds_back(points[second], points[0], points[1])
            } else {
                meet(edge(first), edge(second))
            };
            if touches {
                return Some((first, second));
            }
        }
    }
    None
}

/// The outline turns round at `b`, or stands still there.
fn folds_back(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> bool {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
    a == b || b == c || turn_in_plane(a, b, c) == 0.0 && u[0] * v[0] + u[1] * v[1] <= 0.0
}

type Edge = ([f64; 2], [f64; 2]);

/// Two edges have a point in common.
fn meet((a, b): Edge, (c, d): Edge) -> bool {
    let (c_side, d_side) = (turn_in_plane(a, b, c), turn_in_plane(a, b, d));
    let (a_side, b_side) = (turn_in_plane(c, d, a), turn_in_plane(c, d, b));
    let opposite = |x: f64, y: f64| x > 0.0 && y < 0.0 || x < 0.0 && y > 0.0;
    if opposite(c_side, d_side) && opposite(a_side, b_side) {
        return true;
    }
    let on = |side: f64, p: [f64; 2], (a, b): Edge| {
        let within = |axis: usize| p[axis] >= a[axis].min(b[axis]) && p[axis] <= a[axis].max(b[axis]);
        side == 0.0 && within(0) && within(1)
    };
    on(c_side, c, (a, b)) || on(d_side, d, (a, b)) || on(a_side, a, (c, d)) || on(b_side, b, (c, d))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_fine(points: &[[f64; 2]]) -> bool {
        check(points).is_ok()
    }

    #[test]
    fn simple_outlines_pass_and_others_do_not() {
        assert!(is_fine(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 1.0], [0.0, 2.0]]), "concave");
        assert!(is_fine(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0]]), "a straight corner");
        assert!(!is_fine(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]), "a bow tie");
        assert!(!is_fine(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 2.0]]), "folds back");
        assert!(!is_fine(&[[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), "a point twice");
        assert!(!is_fine(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]]), "touches itself");
        assert!(!is_fine(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), "a line");
        assert!(!is_fine(&[[0.0, 0.0], [1.0, 1.0]]));
    }

    #[test]
    fn clockwise_is_told() {
        let mut points = vec![[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [3.0, 2.0], [1.0, 1.0], [3.0, 0.0]];
        for _ in 0..6 {
            points.rotate_left(1);
            assert!(is_clockwise(&points), "{points:?}");
        }
        points.reverse();
        assert!(!is_clockwise(&points));
    }
}
