//! A rasterizer in a C library: `farop __host lib:PATH` loads it and speaks the protocol of `exec:` for it.
//!
//! screen files on standard input -HOST-> `farop_draw` -> PF pictures on standard output
//!
//! The structs here are those of `student_rasterizers/other_languages/c/farop.h`, field by field: `tests/doors.rs` holds both
//! layouts against each other. Everything a library does wrong ends this process, which is in the jail and is not the one that asked.
//!
//! Why floats come back: nothing is rounded on the way, so a right library draws the z-buffer's bytes under any encoding.

// A library written by somebody else cannot be called otherwise; each use says what it relies on.
#![allow(unsafe_code)]

use super::answer::write_floats;
use super::{LIBRARY_ERROR, background, existing};
use crate::plan::{Interpolation, Varying};
use crate::screen::file::{ReadOptions, ScreenFile, read};
use crate::screen::{DrawList, EdgeKind, Evaluation, Precision};
use std::ffi::OsStr;
use std::io::{BufRead, Write};
use std::path::Path;

/// The version of the structs: `FAROP_ABI`.
const ABI: u32 = 1;

#[repr(C)]
struct CPlane {
    abc: [f64; 3],
    low: f64,
    high: f64,
    rule: i32,
    reserved: i32,
}

#[repr(C)]
struct CVertex {
    x: f64,
    y: f64,
    inverse_w: f64,
    w: f64,
    values: [f64; 6],
    edge: i32,
    reserved: i32,
}

#[repr(C)]
struct CPolygon {
    first_vertex: u32,
    vertex_count: u32,
    first_plane: u32,
    surface: u32,
    opacity: [f32; 3],
    line: u32,
}

#[repr(C)]
struct CList {
    abi: u32,
    width: u32,
    height: u32,
    subpixel_bits: u32,
    varying: u32,
    value_count: u32,
    planes_each: u32,
    perspective: u32,
    double_precision: u32,
    background: [f32; 3],
    vertex_count: u32,
    plane_count: u32,
    polygon_count: u32,
    reserved: u32,
    vertices: *const CVertex,
    planes: *const CPlane,
    polygons: *const CPolygon,
}

#[repr(C)]
struct CTarget {
    width: u32,
    height: u32,
    rgb: *mut f32,
    depth: *mut f64,
}

type Draw = unsafe extern "C" fn(*const CList, *mut CTarget);

/// Sizes and offsets of the structs, as `name value` lines: what the layout test compares with C's.
#[must_use]
pub fn layout() -> Vec<(&'static str, usize)> {
    use std::mem::{offset_of, size_of};
    vec![
        ("sizeof(farop_plane)", size_of::<CPlane>()),
        ("offsetof(farop_plane, low)", offset_of!(CPlane, low)),
        ("offsetof(farop_plane, rule)", offset_of!(CPlane, rule)),
        ("sizeof(farop_vertex)", size_of::<CVertex>()),
        ("offsetof(farop_vertex, inverse_w)", offset_of!(CVertex, inverse_w)),
        ("offsetof(farop_vertex, values)", offset_of!(CVertex, values)),
        ("offsetof(farop_vertex, edge)", offset_of!(CVertex, edge)),
        ("sizeof(farop_polygon)", size_of::<CPolygon>()),
        ("offsetof(farop_polygon, first_plane)", offset_of!(CPolygon, first_plane)),
        ("offsetof(farop_polygon, opacity)", offset_of!(CPolygon, opacity)),
        ("offsetof(farop_polygon, line)", offset_of!(CPolygon, line)),
        ("sizeof(farop_list)", size_of::<CList>()),
        ("offsetof(farop_list, varying)", offset_of!(CList, varying)),
        ("offsetof(farop_list, double_precision)", offset_of!(CList, double_precision)),
        ("offsetof(farop_list, background)", offset_of!(CList, background)),
        ("offsetof(farop_list, vertex_count)", offset_of!(CList, vertex_count)),
        ("offsetof(farop_list, vertices)", offset_of!(CList, vertices)),
        ("offsetof(farop_list, planes)", offset_of!(CList, planes)),
        ("offsetof(farop_list, polygons)", offset_of!(CList, polygons)),
        ("sizeof(farop_target)", size_of::<CTarget>()),
        ("offsetof(farop_target, rgb)", offset_of!(CTarget, rgb)),
        ("offsetof(farop_target, depth)", offset_of!(CTarget, depth)),
        ("FAROP_ABI", ABI as usize),
    ]
}

/// Serves the library that `lib:PATH` names until standard input ends; the exit code of the process.
#[must_use]
pub fn serve(name: &OsStr) -> u8 {
    let path = name.to_str().and_then(|name| name.strip_prefix("lib:")).unwrap_or_default();
    match load_and_serve(Path::new(path)) {
        Ok(()) => 0,
        Err(message) => {
            let _ = writeln!(std::io::stderr(), "{LIBRARY_ERROR}{message}");
            2
        }
    }
}

fn load_and_serve(path: &Path) -> Result<(), String> {
    // SAFETY: loading runs the library's initializers, which may do anything. That is why this process is in the jail.
    let library = unsafe { libloading::Library::new(existing(path)?) }.map_err(with_source)?;
    // SAFETY: the header declares the function with this type. A library that defines it otherwise harms this process only.
    let draw = unsafe { library.get::<Draw>(c"farop_draw") };
    let draw = draw.map_err(|error| format!("it has no function `farop_draw`: {}", with_source(error)))?;
    let mut input = std::io::stdin().lock();
    while let Some(text) = next_file(&mut input).map_err(|error| error.to_string())? {
        let mut file = read(&text, &ReadOptions::default()).map_err(|error| error.to_string())?;
        if file.list.has_texture() {
            file.list = file.list.without_texture();
        }
        let mut out = Vec::new();
        write_floats(file.list.width as usize, &call(*draw, &file), &mut out);
        std::io::stdout().lock().write_all(&out).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// The loader's own words, which stand one level below.
fn with_source(error: libloading::Error) -> String {
    std::error::Error::source(&error).map_or(error.to_string(), ToString::to_string)
}

/// The next screen file of a stream: up to its line `end`.
fn next_file(input: &mut impl BufRead) -> std::io::Result<Option<String>> {
    let mut text = String::new();
    loop {
        let start = text.len();
        if input.read_line(&mut text)? == 0 {
            return Ok(Some(text).filter(|text| !text.trim().is_empty()));
        }
        if text[start..].trim_end() == "end" {
            return Ok(Some(text));
        }
    }
}

/// The light that `draw` leaves in its target.
fn call(draw: Draw, file: &ScreenFile) -> Vec<f32> {
    let list = &file.list;
    let (vertices, planes, polygons) = (vertices(list), planes(list), polygons(list));
    let background = background(&file.sheet);
    let samples = list.width as usize * list.height as usize;
    let (mut rgb, mut depth) = (background.repeat(samples), vec![0.0; samples]);
    let value_count = list.varying.count() as u32;
    let c_list = CList {
        abi: ABI,
        width: list.width,
        height: list.height,
        subpixel_bits: list.grid.bits,
        varying: match list.varying {
            Varying::Nothing => 0,
            Varying::Color => 1,
            Varying::NormalEye => 2,
            Varying::NormalEyeColor => 3,
            // Lists come without pictures.
            Varying::ColorTexture | Varying::NormalEyeTexture | Varying::NormalEyeColorTexture => 0,
        },
        value_count,
        planes_each: if list.has_depth { 1 + value_count } else { 0 },
        perspective: u32::from(list.interpolation == Interpolation::Perspective),
        double_precision: u32::from(list.precision == Precision::Double),
        background,
        vertex_count: vertices.len() as u32,
        plane_count: planes.len() as u32,
        polygon_count: polygons.len() as u32,
        reserved: 0,
        vertices: vertices.as_ptr(),
        planes: planes.as_ptr(),
        polygons: polygons.as_ptr(),
    };
    let (rgb_at, depth_at) = (rgb.as_mut_ptr(), depth.as_mut_ptr());
    let mut target = CTarget { width: list.width, height: list.height, rgb: rgb_at, depth: depth_at };
    // SAFETY: all pointers lead to arrays of the stated lengths that live until the call is over. What the library does beyond
    // them ends this process, which is in the jail.
    unsafe { draw(&c_list, &mut target) };
    rgb
}

fn vertices(list: &DrawList) -> Vec<CVertex> {
    let count = list.varying.count();
    let convert = |(index, vertex): (usize, &crate::screen::ScreenVertex)| {
        // Colors behind normal and eye point have planes, but no room here.
        let mut values = [0.0; 6];
        let room = count.min(values.len());
        values[..room].copy_from_slice(&list.values[index * count..index * count + room]);
        let edge = match vertex.edge {
            EdgeKind::Original => 0,
            EdgeKind::Cut => 1,
            EdgeKind::Diagonal => 2,
        };
        let w = vertex.homogeneous.z;
        CVertex { x: vertex.x, y: vertex.y, inverse_w: 1.0 / w, w, values, edge, reserved: 0 }
    };
    list.vertices.iter().enumerate().map(convert).collect()
}

fn planes(list: &DrawList) -> Vec<CPlane> {
    let convert = |plane: &crate::screen::Plane| {
        let rule = match plane.evaluation {
            Evaluation::Constant => 0,
            Evaluation::Blocks => 1,
            Evaluation::Samples => 2,
            Evaluation::Double => 3,
            Evaluation::ScanLine => 4,
        };
        CPlane { abc: [plane.a, plane.b, plane.c], low: plane.low, high: plane.high, rule, reserved: 0 }
    };
    list.planes.iter().map(convert).collect()
}

fn polygons(list: &DrawList) -> Vec<CPolygon> {
    let convert = |polygon: crate::screen::ScreenPolygon<'_>| {
        let record = polygon.record();
        CPolygon {
            first_vertex: record.first_vertex,
            vertex_count: record.vertex_count,
            first_plane: record.first_plane,
            surface: record.surface,
            opacity: list.shader.opacity(&polygon).to_array(),
            line: record.source.line,
        }
    };
    list.polygons().map(convert).collect()
}
