//! Lens: some pixels of a picture, enlarged, with the edges and sample points as thin as they are.
//!
//! Shot -LENS-> SVG
//!
//! What is enlarged is the place, not the pen: outlines keep their width and sample points their size on the screen, so that one sees
//! on which side of an edge a center lies. A wrong pixel is cut in two: above the diagonal as drawn, below as it is right.
//!
//! Space: the SVG's units are samples.

use crate::grade::case::Case;
use crate::grade::verdict::Shot;
use crate::image::Picture;
use maud::{Markup, html};
use std::fmt::Write;

/// Pixels on each side of the one in the middle.
const AROUND: i64 = 3;

/// The picture around a pixel, with everything that decides it.
pub(super) fn around(shot: &Shot, (drawn, right): (&Picture, &Picture), (x, y): (usize, usize)) -> Markup {
    let range = |middle: usize, end: usize| {
        // At a side of the picture the window moves and stays as large.
        let low = (middle as i64 - AROUND).min(end as i64 - 2 * AROUND - 1).max(0);
        (low as usize, ((low + 2 * AROUND + 1) as usize).min(end))
    };
    let (columns, rows) = (range(x, drawn.width()), range(y, drawn.height()));
    view(&shot.case, &shot.wrong, (drawn, Some(right)), (columns, rows), Some((x, y)))
}

/// Pixels of a picture from one column and row to before another; `chosen` is framed.
pub(super) fn view(
    case: &Case,
    wrong: &[usize],
    (drawn, right): (&Picture, Option<&Picture>),
    ((left, end_x), (top, end_y)): ((usize, usize), (usize, usize)),
    chosen: Option<(usize, usize)>,
) -> Markup {
    let side = case.samples as usize;
    let (width, height) = ((end_x - left) * side, (end_y - top) * side);
    let mut shapes = String::new();
    for y in top..end_y {
        for x in left..end_x {
            let is_wrong = wrong.contains(&(y * drawn.width() + x));
            let right = right.filter(|_| is_wrong).map(|right| right.pixel(x, y));
            pixel(&mut shapes, (x * side, y * side, side), drawn.pixel(x, y), right);
        }
    }
    outlines(&mut shapes, case);
    points(&mut shapes, ((left * side, end_x * side), (top * side, end_y * side)));
    if let Some((x, y)) = chosen {
        let _ = write!(shapes, "<path class=\"chosen\" d=\"M{} {}h{side}v{side}h-{side}z\"/>", x * side, y * side);
    }
    let words = format!("{} columns and {} rows enlarged, with edges and sample points", end_x - left, end_y - top);
    html! {
        svg.zoom role="img" aria-label=(words) viewBox=(format!("{} {} {width} {height}", left * side, top * side))
            style=(format!("aspect-ratio:{width}/{height}")) { (super::plain(&shapes)) }
    }
}

/// Writing to a String cannot fail, here and below.
fn pixel(shapes: &mut String, (x, y, side): (usize, usize, usize), [r, g, b]: [u8; 3], right: Option<[u8; 3]>) {
    let _ = write!(shapes, "<path fill=\"rgb({r},{g},{b})\" d=\"M{x} {y}h{side}v{side}h-{side}z\"/>");
    if let Some([r, g, b]) = right {
        let _ = write!(shapes, "<path fill=\"rgb({r},{g},{b})\" d=\"M{} {y}v{side}h-{side}z\"/>", x + side);
        let _ = write!(
            shapes,
            "<path class=\"bad\" d=\"M{x} {y}h{side}v{side}h-{side}zM{} {y}l-{side} {side}\"/>",
            x + side
        );
    }
}

fn outlines(shapes: &mut String, case: &Case) {
    for face in &case.faces {
        let corners: Vec<_> = face.corners.iter().map(|(x, y)| format!("{x},{y}")).collect();
        let corners = corners.join(" ");
        let _ = write!(
            shapes,
            "<polygon class=\"halo\" points=\"{corners}\"/><polygon class=\"edge\" points=\"{corners}\"/>"
        );
    }
}

/// A dot of a size that does not grow: a line without length, with round ends.
fn points(shapes: &mut String, ((left, right), (top, bottom)): ((usize, usize), (usize, usize))) {
    let mut path = String::new();
    for y in top..bottom {
        for x in left..right {
            let _ = write!(path, "M{x}.5 {y}.5h0");
        }
    }
    let _ = write!(shapes, "<path class=\"dots under\" d=\"{path}\"/><path class=\"dots\" d=\"{path}\"/>");
}
