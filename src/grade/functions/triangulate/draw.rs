//! Draw: an outline and its triangles as text.

use super::judge::turn;
use super::{Case, Whole};
use std::fmt::Write;

/// Characters across and down.
const COLUMNS: i64 = 36;
const ROWS: i64 = 14;

/// The question and the answer for a reader.
pub(super) fn show(case: &Case, triangles: Option<&[[u32; 3]]>, complaint: &str) -> String {
    let mut text = format!("  smallest case: {} corners", case.ring.len());
    if !case.is_plain() || case.tilt != 0 {
        let (outline, normal) = case.in_space();
        let _ =
            write!(text, " in space, normal {normal}, first corner {}; here as seen from the normal's tip", outline[0]);
    }
    if case.exponent != 0 {
        let _ = write!(text, "; coordinates are times 2^{}", case.exponent);
    }
    text.push_str("\n    outline:");
    for (index, [x, y]) in case.ring.iter().enumerate() {
        let _ = write!(text, " {index}({x}, {y})");
    }
    text.push('\n');
    if let Some(triangles) = triangles {
        let listed: Vec<_> =
            triangles.iter().zip('a'..='z').map(|([a, b, c], letter)| format!("{letter} {a}-{b}-{c}")).collect();
        let more = if triangles.len() > listed.len() { ", ..." } else { "" };
        let listed = if listed.is_empty() { "none".to_string() } else { listed.join(", ") };
        let _ = writeln!(text, "    triangles: {listed}{more}");
        picture(case, triangles).iter().for_each(|row| text += &format!("      {row}\n"));
        text += "    letters: triangles, 0-9 corners, ? not covered, ! covered twice or outside of the polygon\n";
    }
    text + "    wrong:  " + complaint + "\n"
}

fn bounds(ring: &[Whole]) -> (Whole, Whole) {
    let start = (ring[0], ring[0]);
    ring.iter()
        .fold(start, |(low, high), p| ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])]))
}

/// Rows from the top. Coordinates are multiplied so that samples are whole numbers, too.
fn picture(case: &Case, triangles: &[[u32; 3]]) -> Vec<String> {
    let (low, high) = bounds(&case.ring);
    let size = [(high[0] - low[0]).max(1), (high[1] - low[1]).max(1)];
    let scaled: Vec<Whole> =
        case.ring.iter().map(|p| [(p[0] - low[0]) * 2 * COLUMNS, (p[1] - low[1]) * 2 * ROWS]).collect();
    let mut rows = Vec::new();
    for row in (0..ROWS).rev() {
        let symbol = |column: i64| symbol(&scaled, triangles, [(2 * column + 1) * size[0], (2 * row + 1) * size[1]]);
        rows.push((0..COLUMNS).map(symbol).collect::<Vec<char>>());
    }
    for (index, p) in scaled.iter().enumerate().take(10) {
        let column = (p[0] / (2 * size[0])).clamp(0, COLUMNS - 1) as usize;
        let row = ROWS - 1 - (p[1] / (2 * size[1])).clamp(0, ROWS - 1);
        rows[row as usize][column] = char::from_digit(index as u32, 10).unwrap_or('+');
    }
    rows.iter().map(|row| row.iter().collect::<String>().trim_end().to_string()).collect()
}

fn symbol(ring: &[Whole], triangles: &[[u32; 3]], p: Whole) -> char {
    let is_over = |triangle: &[u32; 3]| {
        let corners: Option<Vec<Whole>> = triangle.iter().map(|&index| ring.get(index as usize).copied()).collect();
        corners.is_some_and(|corners| covers(&corners, p))
    };
    let over: Vec<usize> = (0..triangles.len()).filter(|&number| is_over(&triangles[number])).collect();
    match (covers(ring, p), over.as_slice()) {
        (false, []) => '.',
        (true, []) => '?',
        (true, [number]) => char::from(b'a' + (number % 26) as u8),
        _ => '!',
    }
}

/// Whether an odd number of edges lies to the right of a point; points on edges belong to one side.
fn covers(ring: &[Whole], p: Whole) -> bool {
    let crosses = |(&a, &b): (&Whole, &Whole)| {
        let spans = (a[1] > p[1]) != (b[1] > p[1]);
        let side = turn(a, b, p);
        spans && if b[1] > a[1] { side > 0 } else { side < 0 }
    };
    crate::math::edges(ring).filter(|&edge| crosses(edge)).count() % 2 == 1
}
