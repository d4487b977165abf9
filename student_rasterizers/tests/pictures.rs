//! A picture test of your own: the same macro that farop's own pictures are tested with.
//!
//! `FAROP_PICTURES=accept cargo test -p student_rasterizers` accepts what is drawn now; look at the picture first.

use farop::raster::{PerPolygon, ZBuffer};
use farop::render::{Canvas, draw};
use farop::screen::DrawList;
use farop::screen::file::Sheet;
use farop::snapshot::assert_picture;
use student_rasterizers::solved_example::TenLines;

/// Three polygons that overlap, one of them concave.
fn overlapping() -> DrawList {
    let mut list = DrawList::new(48, 32);
    list.push_flat(&[(2.0, 2.0), (30.5, 4.5), (24.0, 29.0), (4.25, 26.0)], 0.5, [0.8, 0.2, 0.1]);
    list.push_flat(&[(12.0, 8.0), (46.0, 6.0), (38.5, 30.0)], 0.75, [0.1, 0.4, 0.8]);
    list.push_flat(&[(8.0, 14.0), (44.0, 14.0), (44.0, 20.0), (26.0, 16.0), (8.0, 20.0)], 0.6, [0.9, 0.8, 0.2]);
    list
}

#[test]
fn ten_lines_draw_the_accepted_picture() {
    let canvas = Canvas::of_sheet(&Sheet::default());
    let (drawn, _) = draw(&overlapping(), Some(&PerPolygon(TenLines)), &canvas);
    let (reference, _) = draw(&overlapping(), Some(&ZBuffer), &canvas);
    assert!(drawn == reference, "not the z-buffer's picture");
    assert_picture!("overlapping", drawn);
}
