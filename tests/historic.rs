//! The historic switches, each held against an own small computation.

mod support;

use farop::color::Encoding;
use farop::math::Vec3;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Accepts, Choices, FlatRule, Interpolation, Plan, PlanError, Shading};
use farop::raster::coverage;
use farop::raster::{Rasterizer, Registry, ZBuffer};
use farop::render::{list, render};
use farop::scene::{NormalSource, Scene};
use farop::screen::{Evaluation, ScreenPolygon};
use farop::spd::Curves;
use support::built_in::built_in;

fn read(text: &str, polygon_normals: NormalSource) -> Scene {
    let options = ParseOptions { polygon_normals, ..ParseOptions::default() };
    read_nff("test", text.as_bytes(), options).unwrap_or_else(|errors| panic!("{errors}")).scene
}

fn linear(choices: Choices) -> Choices {
    Choices { encoding: Encoding::Linear, ..choices }
}

/// An eye at (0, 0, 5) that looks down -z with 90 degrees, and one light, high on the right.
const VIEW: &str =
    "b 0 0 0\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 90\nhither 1\nresolution 64 64\nl 3 4 6\nf 1 1 1 0.8 0 1 0 0\n";

/// Two halves of a roof that share the ridge x = 0; the left one reaches over the left side (x = -5), where it starts.
const ROOF: &str = "p 4\n-7 -2 -1\n0 -2 1\n0 2 1\n-7 2 -1\np 4\n0 -2 1\n3 -2 -1\n3 2 -1\n0 2 1\n";

/// Unit normal of a convex polygon's first corner; world space.
fn face_normal(corners: &[Vec3]) -> Vec3 {
    (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalize()
}

/// Ambient and diffuse light of VIEW's surface, world space; one light and the ambient have intensity 1/2.
fn lit(point: Vec3, normal: Vec3) -> f64 {
    let to_light = (Vec3::new(3.0, 4.0, 6.0) - point).normalize();
    0.8 * (0.5 + 0.5 * normal.dot(to_light).max(0.0))
}

#[test]
fn sipp_lights_a_facet_by_the_mean_normal_at_the_first_vertex_left() {
    let scene = read(&format!("{VIEW}{ROOF}"), NormalSource::Facet);
    let choices = linear(Choices { shading: Shading::Flat, flat: FlatRule::Sipp, ..Choices::default() });
    let drawn = list(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
    let left = [Vec3::new(-7.0, -2.0, -1.0), Vec3::new(0.0, -2.0, 1.0), Vec3::new(0.0, 2.0, 1.0)];
    let right = [Vec3::new(0.0, -2.0, 1.0), Vec3::new(3.0, -2.0, -1.0), Vec3::new(3.0, 2.0, -1.0)];
    let (own, ridge) = (face_normal(&left), (face_normal(&left) + face_normal(&right)).normalize());

    // The right half starts at the ridge, whole: the light there, with the mean of both faces.
    let color = drawn.polygon(1).values(40, 32)[0];
    assert!((color - lit(right[0], ridge)).abs() < 1e-6, "{color}");
    assert!((color - lit(right[0], face_normal(&right))).abs() > 0.01, "the face's own normal would do, too");

    // The left half is cut on the edge from its first vertex to the ridge: both light and normal are those of the cut.
    let polygon = drawn.polygon(0);
    let Vec3 { x: xw, z: w, .. } = polygon.vertices()[0].homogeneous;
    let cut_x = (xw / w - 32.0) / 32.0 * w;
    assert!((cut_x + w).abs() < 1e-9, "the first vertex is on the left side");
    let share = (cut_x + 7.0) / 7.0;
    let on_lower_edge = left[0] + (left[1] - left[0]) * share;
    let on_upper_edge = on_lower_edge + Vec3::new(0.0, 4.0, 0.0);
    let normal = (own * (1.0 - share) + ridge * share).normalize();
    let color = polygon.values(10, 32)[0];
    let expected = [on_lower_edge, on_upper_edge].map(|point| lit(point, normal));
    assert!(expected.iter().any(|light| (color - light).abs() < 1e-6), "{color} {expected:?}");
    // One color everywhere.
    assert_eq!(polygon.values(20, 40)[0], color);
}

#[test]
fn sipp_keeps_normals_that_a_file_gives() {
    let given = "pp 3\n-1 -1 0 0.6 0 0.8\n1 -1 0 0 0 1\n0 1 0 0 0 1\n";
    let scene = read(&format!("{VIEW}{given}"), NormalSource::Facet);
    let choices = linear(Choices { shading: Shading::Flat, flat: FlatRule::Sipp, ..Choices::default() });
    let drawn = list(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
    let color = drawn.polygon(0).values(32, 32)[0];
    assert!((color - lit(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(0.6, 0.0, 0.8))).abs() < 1e-6);
}

/// An "M" with a normal of its own at every corner, tilted away from the eye, reaching over the upper and right side.
const M: &str = "pp 7\n-3 -3 1 -0.6 0 0.8\n-1 -3 1 0 0 1\n0 0 0 0.8 0 0.6\n1 -3 1 0 0.6 0.8\n6 -3 1 0.6 0 0.8\n\
                 3 7 -2 -0.8 0 0.6\n-3 7 -2 0 -0.6 0.8\n";

/// The value of one number at a sample: all crossings, sorted, in pairs; f64.
fn scan_line_value(polygon: &ScreenPolygon<'_>, number: usize, (x, y): (i32, i32)) -> Option<f64> {
    let (center_x, center_y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let vertices = polygon.vertices();
    let mut crossings = Vec::new();
    for (i, a) in vertices.iter().enumerate() {
        let j = if i + 1 == vertices.len() { 0 } else { i + 1 };
        let b = &vertices[j];
        if (a.y > center_y) != (b.y > center_y) {
            let along = (center_y - a.y) / (b.y - a.y);
            let (from, to) = (polygon.vertex_values(i)[number], polygon.vertex_values(j)[number]);
            crossings.push((a.x + along * (b.x - a.x), from + along * (to - from)));
        }
    }
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let pair = crossings.chunks(2).find(|pair| pair[0].0 <= center_x && center_x < pair[1].0)?;
    let along = (center_x - pair[0].0) / (pair[1].0 - pair[0].0);
    Some(pair[0].1 + along * (pair[1].1 - pair[0].1))
}

#[test]
fn values_run_along_edges_and_scan_lines() {
    for (text, shading) in [(M, Shading::Gouraud), (M, Shading::Phong)] {
        let scene = read(&format!("{VIEW}{text}"), NormalSource::Facet);
        let choices = Choices { interpolation: Interpolation::ScanLine, shading, ..Choices::default() };
        let drawn = list(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
        assert_eq!(drawn.len(), 1, "the polygon stays whole");
        let polygon = drawn.polygon(0);
        assert!(polygon.vertices().len() > 7, "it is cut");
        let mut samples = 0;
        for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
            if coverage::covers(polygon.vertices(), drawn.grid, x, y) {
                let values = polygon.values(x, y);
                for number in 0..3 {
                    let expected = scan_line_value(&polygon, number, (x, y)).expect("a pair around a covered sample");
                    assert!((values[number] - expected).abs() < 1e-6, "({x}, {y}): {} {expected}", values[number]);
                }
                samples += 1;
            }
        }
        assert!(samples > 1000, "{samples}");
    }
}

#[test]
fn every_rasterizer_draws_the_same_scan_lines() {
    let registry = Registry::built_in();
    let watkins = &registry.find("watkins").expect("is built in").rasterizer;
    let mut gears = built_in("gears", 1, Curves::Kept);
    for surface in &mut gears.surfaces {
        surface.mesh.polygons.iter_mut().for_each(|polygon| polygon.normals = NormalSource::Averaged);
    }
    for scene in [gears, read(&format!("{VIEW}{M}{ROOF}"), NormalSource::Averaged)] {
        for shading in [Shading::Gouraud, Shading::Phong] {
            let choices =
                |interpolation| Choices { shading, interpolation, size: Some((96, 96)), ..Choices::default() };
            let choices = (choices(Interpolation::ScanLine), choices(Interpolation::Screen));
            let of = |rasterizer: &dyn Rasterizer| render(&scene, &choices.0, Some(rasterizer)).expect("a usable view");
            let reference = of(&ZBuffer);
            assert!(reference.list.planes.iter().any(|plane| plane.evaluation == Evaluation::ScanLine));
            assert!(reference.image == of(&**watkins).image);
            let screen = render(&scene, &choices.1, Some(&ZBuffer)).expect("a usable view");
            assert!(reference.image != screen.image, "the switch does nothing");
        }
    }
}

#[test]
fn over_triangles_scan_lines_are_planes_on_the_screen() {
    let triangles = "pp 3\n-2.5 -2.5 2 0 0 1\n2.5 -2.5 2 0.6 0 0.8\n0 3 -4 0 0 1\npp 3\n-3 -2 -1 0.8 0 0.6\n3 -2 1 0.6 0 0.8\n0 3 0 0 0.6 0.8\n";
    let scene = read(&format!("{VIEW}{triangles}"), NormalSource::Facet);
    let drawn = |interpolation| {
        let choices = Choices { interpolation, size: Some((96, 96)), ..Choices::default() };
        render(&scene, &choices, Some(&ZBuffer)).expect("a usable view")
    };
    let (scan_line, screen) = (drawn(Interpolation::ScanLine), drawn(Interpolation::Screen));
    assert_eq!(screen.counts.rendered, 2);
    assert!(scan_line.image == screen.image);
}

#[test]
fn the_eye_point_is_in_space_however_normals_run() {
    let scene = read(&format!("{VIEW}pp 3\n-3 -3 2 0 0 1\n3 -3 2 0.6 0 0.8\n0 3 -4 0 0 1\n"), NormalSource::Facet);
    let point = |interpolation| {
        let choices = Choices { shading: Shading::Phong, interpolation, ..Choices::default() };
        let drawn = list(&scene, &choices, Some(&ZBuffer)).expect("a usable view");
        let values = drawn.polygon(0).values(32, 40);
        [values[3], values[4], values[5]]
    };
    let expected = point(Interpolation::Perspective);
    assert_eq!(point(Interpolation::Screen), expected);
    assert_eq!(point(Interpolation::ScanLine), expected);
}

#[test]
fn historic_choices_that_contradict_others_are_refused() {
    let scene = read(&format!("{VIEW}{M}"), NormalSource::Facet);
    let plan = |choices: Choices, accepts| Plan::new(&scene, &choices, accepts);
    let scan_line = || Choices { interpolation: Interpolation::ScanLine, ..Choices::default() };
    let any = Accepts::AnyPolygon;

    let sipp = Choices { flat: FlatRule::Sipp, ..Choices::default() };
    assert_eq!(plan(sipp, any).err(), Some(PlanError::FlatRuleWithoutFlat("sipp", "gouraud")));
    let flat = Choices { shading: Shading::Flat, ..scan_line() };
    assert_eq!(plan(flat, any).err(), Some(PlanError::NothingToInterpolate("flat")));
    let triangles = Choices { triangles: true, ..scan_line() };
    assert!(matches!(plan(triangles, any), Err(PlanError::ScanLineNeedsPolygons(why)) if why.contains("--triangles")));
    assert!(matches!(
        plan(scan_line(), Accepts::Triangles),
        Err(PlanError::ScanLineNeedsPolygons(why)) if why.contains("rasterizer")
    ));

    let rows = plan(scan_line(), any).expect("fits").explain();
    let split = rows.iter().find(|row| row.need == "split").expect("has a row");
    assert_eq!((split.decision.as_str(), split.reason.contains("scan lines")), ("no", true));
}
