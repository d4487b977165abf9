//! The body of a v2 file: lights and surfaces ([`super::shading`]), then polygons with their planes and vertices; written and read
//! side by side.

use super::ScreenFileError;
use super::header::{Header, RecordCounts, color, color_text, name_of, varying_names};
use super::number::Number;
use super::shading::{read_light, read_surface};
use super::textures::read_texture;
use super::words::Words;
use crate::color::Rgb;
use crate::math::Vec3;
use crate::plan::Interpolation;
use crate::screen::{DrawList, EdgeKind, Evaluation, Plane, PolygonRecord, ScreenPolygon, ScreenVertex, Source};
use std::io::{self, Write};

const EDGES: [(EdgeKind, &str); 3] =
    [(EdgeKind::Original, "original"), (EdgeKind::Cut, "cut"), (EdgeKind::Diagonal, "diagonal")];
const EVALUATIONS: [(Evaluation, &str); 5] = [
    (Evaluation::Constant, "constant"),
    (Evaluation::Blocks, "blocks"),
    (Evaluation::Samples, "samples"),
    (Evaluation::Double, "double"),
    (Evaluation::ScanLine, "scanline"),
];
const ORIGINS: [(bool, &str); 2] = [(false, "polygon"), (true, "tessellated")];
pub(super) const WHOLE: std::ops::RangeInclusive<u64> = 0..=u32::MAX as u64;

/// Writes numbers, each behind a blank.
pub(super) fn numbers(out: &mut dyn Write, numbers: &[f64]) -> io::Result<()> {
    numbers.iter().try_for_each(|&number| write!(out, " {}", Number(number)))
}

/// Writes a polygon, its planes and its vertices; with `extra_color`, the lit color behind normal and eye point.
pub(super) fn write_polygon(
    list: &DrawList,
    polygon: &ScreenPolygon<'_>,
    extra_color: bool,
    out: &mut dyn Write,
) -> io::Result<()> {
    let Source { line, number, tessellated } = polygon.record().source;
    write!(out, "polygon {} {} {}", polygon.index, polygon.vertices().len(), polygon.surface())?;
    let opacity = color_text(list.shader.opacity(polygon));
    writeln!(out, " {opacity} {line} {number} {}", name_of(tessellated, &ORIGINS))?;
    let names = ["depth"].into_iter().chain(varying_names(list.varying).iter().copied());
    for (name, plane) in names.zip(polygon.depth_plane().into_iter().chain(polygon.varying_planes())) {
        write!(out, "plane {name}")?;
        numbers(out, &[plane.a, plane.b, plane.c, plane.low, plane.high])?;
        writeln!(out, " {}", name_of(plane.evaluation, &EVALUATIONS))?;
    }
    for (corner, vertex) in polygon.vertices().iter().enumerate() {
        let values = polygon.vertex_values(corner);
        let Vec3 { x: xw, y: yw, z: w } = vertex.homogeneous;
        write!(out, "vertex")?;
        numbers(out, &[vertex.x, vertex.y, 1.0 / w, xw, yw, w])?;
        write!(out, " {}", name_of(vertex.edge, &EDGES))?;
        numbers(out, values)?;
        if extra_color {
            write!(out, " {}", color_text(list.shader.color(polygon, values)))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Reads everything behind the head into its list.
pub(super) fn read_body(words: &mut Words<'_>, header: &mut Header) -> Result<(), ScreenFileError> {
    let RecordCounts { lights, surfaces, polygons, vertices } = header.counts;
    let Header { list, extra_color, sheet, textures, .. } = header;
    list.shader.lights = (0..lights).map(|_| read_light(words)).collect::<Result<_, _>>()?;
    (0..*textures).try_for_each(|index| read_texture(words, index, sheet, &mut list.shader.textures))?;
    let textures = &list.shader.textures;
    list.shader.surfaces = (0..surfaces).map(|index| read_surface(words, index, textures)).collect::<Result<_, _>>()?;
    list.vertices.reserve_exact(vertices);
    list.values.reserve_exact(vertices * list.varying.count());
    list.polygons.reserve_exact(polygons);
    for index in 0..polygons {
        let vertices_left = vertices - list.vertices.len();
        let record = read_polygon(words, index, vertices_left, list)?;
        for _ in 0..record.vertex_count {
            read_vertex(words, *extra_color, list)?;
        }
        list.polygons.push(record);
    }
    words.record("end")?;
    let word = words.first_word();
    if !word.text.is_empty() {
        return Err(words.error(word, "the end of the file"));
    }
    if list.vertices.len() < vertices {
        return Err(words.error(word, format!("{vertices} vertices, as the head says")));
    }
    Ok(())
}

/// Reads a polygon and its planes; its vertices are the next ones.
fn read_polygon(
    words: &mut Words<'_>,
    index: usize,
    vertices_left: usize,
    list: &mut DrawList,
) -> Result<PolygonRecord, ScreenFileError> {
    words.record("polygon")?;
    words.whole("the number of the polygon", index as u64..=index as u64)?;
    let word = words.word();
    let vertex_count = words.whole_of(word, "how many vertices it has", 3..=WHOLE.end() / 8)? as u32;
    if vertex_count as usize > vertices_left {
        let expected =
            format!("at most {vertices_left} vertices, which is what is left of those that the head declares");
        return Err(words.error(word, expected));
    }
    let surface = read_surface_of_polygon(words, list)?;
    let line = words.whole("the line in the scene file", WHOLE)? as u32;
    let number = words.whole("the number within its surface", WHOLE)? as u32;
    let tessellated = words.choice("where it comes from", &ORIGINS)?;
    words.end_of_record()?;
    let first_vertex = list.vertices.len() as u32;
    let first_plane = read_planes(words, list)?;
    let source = Source { line, number, tessellated };
    Ok(PolygonRecord { first_vertex, vertex_count, first_plane, surface, source })
}

/// The surface, and its opacity, which stands in the polygon too so that a simple reader can skip the table of surfaces.
fn read_surface_of_polygon(words: &mut Words<'_>, list: &DrawList) -> Result<u32, ScreenFileError> {
    let word = words.word();
    let last = match list.shader.surfaces.len() {
        0 => return Err(words.error(word, "no polygon, because the file has no surface")),
        count => count as u64 - 1,
    };
    let surface = words.whole_of(word, "the number of its surface", 0..=last)? as u32;
    let word = words.peek();
    let opacity = color(words, "opacity")?;
    let of_surface = list.shader.surfaces[surface as usize].opacity;
    if opacity != of_surface {
        let expected = format!("the opacity of surface {surface}, {}", color_text(of_surface));
        return Err(words.error(word, expected).with_help("a polygon repeats the opacity of its surface"));
    }
    if !list.has_blending && opacity != Rgb::gray(1.0) {
        let error = words.error(word, "opacity 1 1 1, because of `blending no`");
        return Err(error.with_help("write `blending yes` in the head"));
    }
    Ok(surface)
}

/// Reads the planes of a polygon and returns the place of the first in the list.
fn read_planes(words: &mut Words<'_>, list: &mut DrawList) -> Result<u32, ScreenFileError> {
    let first = list.planes.len();
    if !list.has_depth {
        return Ok(first as u32);
    }
    // Only what varies may run along scan lines, and only where the head says so; that rule is the last of all.
    let planes_only = &EVALUATIONS[..EVALUATIONS.len() - 1];
    let rules = if list.interpolation == Interpolation::ScanLine { &EVALUATIONS } else { planes_only };
    read_plane(words, "depth", planes_only).map(|plane| list.planes.push(plane))?;
    for name in varying_names(list.varying) {
        read_plane(words, name, rules).map(|plane| list.planes.push(plane))?;
    }
    // Triangles of one polygon shared their planes, and the file repeats them.
    let count = list.planes.len() - first;
    if first >= count && list.planes[first - count..first] == list.planes[first..] {
        list.planes.truncate(first);
        return Ok((first - count) as u32);
    }
    Ok(first as u32)
}

fn read_plane(words: &mut Words<'_>, name: &str, rules: &[(Evaluation, &str)]) -> Result<Plane, ScreenFileError> {
    words.record("plane")?;
    words.choice("the plane's name", &[((), name)])?;
    let [a, b, c] =
        vector(words, ["change per sample to the right", "change per sample down", "value at (0, 0)"])?.into();
    let low = words.number("the least value at the vertices")?;
    let word = words.word();
    let high = word.text.parse().ok().filter(|&high: &f64| low <= high && high.is_finite());
    let high = high.ok_or_else(|| words.error(word, "the greatest value at the vertices, not below the least"))?;
    let evaluation = words.choice("how it is evaluated", rules)?;
    words.end_of_record()?;
    Ok(Plane { a, b, c, low, high, evaluation })
}

fn read_vertex(words: &mut Words<'_>, extra_color: bool, list: &mut DrawList) -> Result<(), ScreenFileError> {
    words.record("vertex")?;
    let x = on_grid(words, ("x", list.width), list)?;
    let y = on_grid(words, ("y", list.height), list)?;
    let inverse_w = words.number("1 / w")?;
    let (xw, yw) = (words.number("x times w")?, words.number("y times w")?);
    let word = words.word();
    // Told apart from w by more than a rounding, 1 / w belongs to another vertex.
    let fits = |w: &f64| *w > 0.0 && w.is_finite() && (w * inverse_w - 1.0).abs() <= 1e-9;
    let w = word.text.parse().ok().filter(fits);
    let w = w.ok_or_else(|| words.error(word, "w, above 0, of which 1 / w stands before"))?;
    let edge = words.choice("the edge that starts here", &EDGES)?;
    for name in varying_names(list.varying) {
        list.values.push(words.number(name)?);
    }
    if extra_color {
        color(words, "of the vertex")?;
    }
    words.end_of_record()?;
    list.vertices.push(ScreenVertex { x, y, homogeneous: Vec3::new(xw, yw, w), edge });
    Ok(())
}

/// A coordinate: inside the picture, which is what rasterizers are promised, and a multiple of the grid's step.
fn on_grid(words: &mut Words<'_>, (name, side): (&str, u32), list: &DrawList) -> Result<f64, ScreenFileError> {
    let word = words.word();
    let inside = |value: &f64| 0.0 <= *value && *value <= f64::from(side);
    let value = word.text.parse().ok().filter(inside);
    let value = value.ok_or_else(|| {
        let error = words.error(word, format!("{name}, a number from 0 to {side}"));
        error.with_help("polygons of a screen file are clipped: all of them lie inside the picture")
    })?;
    if list.grid.snap(value) != value {
        let expected = format!("{name}, a multiple of 1/{}", list.grid.steps());
        return Err(words.error(word, expected).with_help("`subpixel_bits` in the head says how fine the grid is"));
    }
    Ok(value)
}

pub(super) fn vector(words: &mut Words<'_>, names: [&str; 3]) -> Result<Vec3, ScreenFileError> {
    let mut number = |name: &str| words.number(name);
    Ok(Vec3::new(number(names[0])?, number(names[1])?, number(names[2])?))
}
