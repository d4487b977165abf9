//! Relations between two ways to draw one list, or between a list and one that must look the same.
//!
//! Space: samples.

use super::{Case, Pair};
use crate::image::Image;
use crate::plan::Choices;
use crate::raster::{Frame, Rasterizer, ZBuffer};
use crate::render::{Canvas, draw, render_with};
use crate::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use crate::screen::{DrawList, EdgeKind, ScreenVertex};

/// Any number of threads.
pub(super) fn threads(case: &mut Case) -> Result<Option<Pair>, String> {
    let threads = Some([2, 3, 5, 7, 16, 33, 64][case.random.below(7) as usize]);
    let again = super::drawn(&case.scene, &Choices { threads, ..case.choices.clone() })?;
    Ok(Some(case.bytes(again.image)))
}

/// Some rows at a time.
pub(super) fn bands(case: &mut Case) -> Result<Option<Pair>, String> {
    let list = &case.plain.list;
    let rows_each = 1 + case.random.below(20) as u32;
    let canvas = Canvas::new(&case.scene, &case.choices);
    let mut image = Image::new(list.width as usize, list.height as usize, canvas.background);
    let mut frame = Frame::default();
    for first in (0..list.height).step_by(rows_each as usize) {
        let rows = first..(first + rows_each).min(list.height);
        let mut target = frame.target((list.width, list.height), rows.clone(), canvas.background, canvas.transparency);
        ZBuffer.draw(list, &mut target);
        target.finish();
        let band = frame.image(list.width, rows.clone());
        for row in rows {
            image.row_mut(row as usize).copy_from_slice(band.row((row - first) as usize));
        }
    }
    Ok(Some(case.bytes(image)))
}

/// Convex polygons cut in two between two of their corners; both halves keep the planes.
pub(super) fn chord(case: &mut Case) -> Result<Option<Pair>, String> {
    let random = &mut case.random;
    changed(case.plain.list.clone(), &case.scene, &case.choices, |list, index| {
        let corners = corners(list, index);
        let count = corners.len();
        if count < 4 || !is_convex(list, &corners) {
            return None;
        }
        let (from, reach) = (random.below(count as u64) as usize, 2 + random.below(count as u64 - 3) as usize);
        let turned: Vec<ScreenVertex> = (0..count).map(|i| corners[(from + i) % count]).collect();
        let second: Vec<ScreenVertex> = turned[reach..].iter().chain(&turned[..1]).copied().collect();
        Some(vec![turned[..=reach].to_vec(), second])
    })
    .map(|image| image.map(|image| case.bytes(image)))
}

/// Corners in the middle of edges whose middle lies on the grid.
pub(super) fn inserted(case: &mut Case) -> Result<Option<Pair>, String> {
    changed(case.plain.list.clone(), &case.scene, &case.choices, |list, index| {
        let corners = corners(list, index);
        let mut outline = Vec::new();
        for (a, b) in crate::math::edges(&corners) {
            outline.push(*a);
            let (x, y) = ((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
            if list.grid.snap(x) == x && list.grid.snap(y) == y {
                let homogeneous = (a.homogeneous + b.homogeneous) / 2.0;
                outline.push(ScreenVertex { x, y, homogeneous, edge: EdgeKind::Original });
            }
        }
        (outline.len() > corners.len()).then(|| vec![outline])
    })
    .map(|image| image.map(|image| case.bytes(image)))
}

/// Written as a lossless screen file, read back, drawn.
pub(super) fn dumped(case: &mut Case) -> Result<Option<Pair>, String> {
    let canvas = Canvas::new(&case.scene, &case.choices);
    let sheet = Sheet {
        samples: 1,
        background: canvas.background,
        transparency: canvas.transparency,
        encoding: case.choices.encoding,
    };
    let mut text = Vec::new();
    let attributes = Attributes::default();
    write_v2(&case.plain.list, &sheet, attributes, &mut text).map_err(|error| error.to_string())?;
    let text = String::from_utf8(text).map_err(|error| error.to_string())?;
    let back = read(&text, &ReadOptions::default()).map_err(|error| error.to_string())?;
    let (image, _) = draw(&back.list, Some(&ZBuffer), &Canvas::of_sheet(&back.sheet));
    Ok(Some(case.bytes(image)))
}

fn corners(list: &DrawList, index: usize) -> Vec<ScreenVertex> {
    list.polygon(index).vertices().to_vec()
}

fn is_convex(list: &DrawList, corners: &[ScreenVertex]) -> bool {
    let at = |i: usize| {
        let corner = corners[i % corners.len()];
        (list.grid.fixed(corner.x), list.grid.fixed(corner.y))
    };
    let turn = |i: usize| {
        let (a, b, c) = (at(i), at(i + 1), at(i + 2));
        let cross = i128::from(b.0 - a.0) * i128::from(c.1 - b.1) - i128::from(b.1 - a.1) * i128::from(c.0 - b.0);
        cross.signum()
    };
    let first = turn(0);
    first != 0 && (1..corners.len()).all(|i| turn(i) == first)
}

/// The picture of the list with some polygons replaced by others over the same planes; `None` where none is.
fn changed(
    list: DrawList,
    scene: &crate::scene::Scene,
    choices: &Choices,
    mut replace: impl FnMut(&DrawList, usize) -> Option<Vec<Vec<ScreenVertex>>>,
) -> Result<Option<Image>, String> {
    let mut new = list.clone();
    new.polygons.clear();
    let mut any = false;
    for (index, record) in list.polygons.iter().enumerate() {
        let Some(outlines) = replace(&list, index) else {
            new.polygons.push(*record);
            continue;
        };
        any = true;
        for outline in outlines {
            let (first_vertex, vertex_count) = (new.vertices.len() as u32, outline.len() as u32);
            new.vertices.extend_from_slice(&outline);
            // What varies is read from the planes; the corners only have to be there.
            new.values.resize(new.vertices.len() * new.varying.count(), 0.0);
            new.polygons.push(crate::screen::PolygonRecord { first_vertex, vertex_count, ..*record });
        }
    }
    if !any {
        return Ok(None);
    }
    let drawn = render_with(scene, choices, Some(&ZBuffer), |list| *list = new).map_err(|error| error.to_string())?;
    Ok(Some(drawn.image))
}
