//! Lines by the midpoint rule: a line is turned until it runs right and down, flatter than 45 degrees, and an error says when to step down.
//! The ends follow the diamond rule. Lab wire.

mod sheet;

use sheet::{Corner, Picture, Sheet, is};

/// Steps of a sample: twice 1/256, so that centers are whole.
const SAMPLE: i64 = 512;
const HALF: i64 = SAMPLE / 2;

/// A place in steps.
type Place = (i64, i64);

fn place(corner: &Corner) -> Place {
    let steps = |at: f64| {
        if is("whole_samples") {
            return at.floor() as i64 * SAMPLE + HALF;
        }
        let at = if is("centers_on_corners") { at + 0.5 } else { at };
        (at * SAMPLE as f64).round() as i64
    };
    (steps(corner.x), steps(corner.y))
}

/// The sample whose diamond holds a place. Of its border the left corner and the two upper sides belong to a diamond.
fn diamond((x, y): Place) -> Option<Place> {
    let (column, row) = (x.div_euclid(SAMPLE), y.div_euclid(SAMPLE));
    let (dx, dy) = (x - column * SAMPLE - HALF, y - row * SAMPLE - HALF);
    let away = dx.abs() + dy.abs();
    let is_inside = away < HALF || (away == HALF && (dy < 0 || (dy == 0 && dx < 0)) && dx != HALF);
    is_inside.then_some((column, row))
}

/// Samples of a line.
fn line(from: Place, to: Place, show: &mut impl FnMut(i64, i64)) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let is_steep = dy.abs() > dx.abs() && !is("steep_like_flat");
    let turn = |(x, y): Place| if is_steep { (y, x) } else { (x, y) };
    let (mut start, mut end) = (turn(from), turn(to));
    let (mut start_diamond, mut end_diamond) = (diamond(from).map(turn), diamond(to).map(turn));
    let mut is_back = end.0 < start.0;
    if is_back && is("always_to_the_right") {
        (start, end, is_back) = (end, start, false);
        (start_diamond, end_diamond) = (end_diamond, start_diamond);
    }
    if is_back && is("leftward_lost") {
        return;
    }
    let mut put = |column: i64, row: i64| {
        let (x, y) = if is_steep && !is("not_turned_back") { (row, column) } else { (column, row) };
        show(x, y);
    };
    if let Some((column, row)) = start_diamond
        && start_diamond != end_diamond
        && !is("start_lost")
    {
        put(column, row);
    }
    if is("end_too")
        && let Some((column, row)) = end_diamond
    {
        put(column, row);
    }
    // Columns whose centers the line passes: at or behind the start, before the end.
    let (low, high) = if is_back { (end.0 + 1, start.0 + 1) } else { (start.0, end.0) };
    let column_of = |x: i64| (x - HALF + SAMPLE - 1).div_euclid(SAMPLE);
    let (first, mut last) = (column_of(low), column_of(high));
    if is("last_column_too") {
        last += 1;
    }
    if first >= last {
        return;
    }
    let run = (end.0 - start.0).abs();
    let rise = if is_back { start.1 - end.1 } else { end.1 - start.1 };
    // The height at the first center, as a whole number and a rest over the run.
    let from_low = first * SAMPLE + HALF - if is_back { end.0 } else { start.0 };
    let base = if is_back { end.1 } else { start.1 };
    let scaled = rise * from_low;
    let (mut height, mut rest) = (base + scaled.div_euclid(run), scaled.rem_euclid(run));
    if is("starts_at_its_corner") {
        (height, rest) = (base, 0);
    }
    let step = rise * SAMPLE;
    for column in first..last {
        let row = if is("nearest_row_line") { (height + HALF).div_euclid(SAMPLE) } else { height.div_euclid(SAMPLE) };
        let is_end = [start_diamond, end_diamond].contains(&Some((column, row)));
        if !is_end || is("ends_not_asked") {
            put(column, row);
        }
        let moved = rest + step;
        height += moved.div_euclid(run);
        rest = moved.rem_euclid(run);
        if is("error_dropped") {
            rest = 0;
        }
        if is("slope_whole") {
            height = base + (column + 1 - first) * SAMPLE * (rise / run.max(1));
        }
    }
}

/// The neighbor of a corner along the outline.
fn next(corners: &[Corner], i: usize) -> &Corner {
    &corners[(i + 1) % corners.len()]
}

fn draw(sheet: &Sheet) -> Picture {
    let mut colors = vec![sheet.background; sheet.width * sheet.height];
    let (width, height) = (sheet.width as i64, sheet.height as i64);
    for polygon in &sheet.polygons {
        let corners = &polygon.corners;
        let open = usize::from(is("not_closed"));
        for i in 0..corners.len() - open {
            if corners[i].is_cut {
                continue;
            }
            line(place(&corners[i]), place(next(corners, i)), &mut |x, y| {
                let y = if is("upside_down") { height - 1 - y } else { y };
                if (0..width).contains(&x) && (0..height).contains(&y) {
                    let at = (y * width + x) as usize;
                    let was = colors[at];
                    colors[at] = if is("drawn_twice_is_off") && was == sheet.line_color {
                        sheet.background
                    } else {
                        sheet.line_color
                    };
                }
            });
            if is("corners_marked") {
                let (x, y) = place(&corners[i]);
                let at = (y / SAMPLE * width + x / SAMPLE) as usize;
                if at < colors.len() {
                    colors[at] = sheet.line_color;
                }
            }
        }
    }
    Picture { width: sheet.width, height: sheet.height, colors }
}

fn main() {
    sheet::serve(draw);
}
