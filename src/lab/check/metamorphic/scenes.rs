//! Relations between two scenes.
//!
//! Space: the scenes of `random_scenes`: the eye at the origin, the view along -z.

use super::super::random_scenes::{SIDE, hard};
use super::{Case, Effort, Pair, Report, case, drawn};
use crate::color::Rgb;
use crate::geometry::flatten;
use crate::image::Image;
use crate::math::{Vec3, newell_normal, pow};
use crate::parse::{ParseOptions, read_nff};
use crate::plan::{Accepts, Choices, DepthFormat, NeedsMode, Plan};
use crate::scene::{LightSource, NormalSource, Scene};
use crate::write::write_nff;

/// Surfaces and the polygons of each in another order.
pub(super) fn order(case: &mut Case) -> Result<Option<Pair>, String> {
    let mut scene = case.scene.clone();
    for surface in &mut scene.surfaces {
        shuffle(&mut surface.mesh.polygons, &mut case.random);
    }
    shuffle(&mut scene.objects[0].surfaces, &mut case.random);
    Ok(Some(case.exact(drawn(&scene, &case.choices)?.image)))
}

/// Source: R. Durstenfeld, "Algorithm 235: Random permutation", CACM 7(7), 1964.
fn shuffle<T>(values: &mut [T], random: &mut super::Random) {
    for end in (1..values.len()).rev() {
        values.swap(end, random.below(end as u64 + 1) as usize);
    }
}

/// Outlines that start at another corner. Under light from far away facets have one color and are not split: which triangles a split gives,
/// and which of them snapping flips, may depend on the first corner. Needles are left out: the normal is summed from the first corner, and
/// rounding turns the normal of a needle by as much as the needle is long for its width.
pub(super) fn start(case: &mut Case) -> Result<Option<Pair>, String> {
    let (to_light, place) = (Vec3::new(0.3, 0.5, 0.8), crate::scene::Place::default());
    let source = LightSource::Directional { to_light };
    case.scene.lights = vec![crate::scene::Light { source, color: Rgb::WHITE, intensity: None, place }];
    for surface in &mut case.scene.surfaces {
        let mesh = &mut surface.mesh;
        mesh.polygons.iter_mut().for_each(|polygon| polygon.normals = NormalSource::Facet);
    }
    leave_out_needles(&mut case.scene);
    dull(case)?;
    let mut scene = case.scene.clone();
    for surface in &mut scene.surfaces {
        let mesh = &mut surface.mesh;
        for polygon in &mesh.polygons {
            let range = polygon.start as usize..(polygon.start + polygon.count) as usize;
            mesh.outlines[range].rotate_left(case.random.below(u64::from(polygon.count)) as usize);
        }
    }
    Ok(Some(case.rounded(drawn(&scene, &case.choices)?.image, false)))
}

fn leave_out_needles(scene: &mut Scene) {
    for mesh in scene.surfaces.iter_mut().map(|surface| &mut surface.mesh) {
        let (vertices, outlines) = (&mesh.vertices, &mesh.outlines);
        mesh.polygons.retain(|p| !is_needle(&outlines[p.start as usize..(p.start + p.count) as usize], vertices));
    }
}

/// Twice the area is less than a thousandth of the square of the extent.
fn is_needle(outline: &[u32], vertices: &[Vec3]) -> bool {
    let corners: Vec<Vec3> = outline.iter().map(|&index| vertices[index as usize]).collect();
    let extent = corners.iter().map(|&corner| (corner - corners[0]).length()).fold(0.0, f64::max);
    newell_normal(&corners).length() < 1e-3 * extent * extent
}

/// Leaves out the polygons that a plane cuts, and highlights.
fn uncut(case: &mut Case) -> Result<(), String> {
    for surface in &mut case.scene.surfaces {
        let mesh = &mut surface.mesh;
        let outside = |&index: &u32| {
            let at = mesh.vertices[index as usize];
            at.x.abs() >= -at.z || at.y.abs() >= -at.z || -at.z <= 1.0
        };
        let outlines = &mesh.outlines;
        mesh.polygons.retain(|p| !outlines[p.start as usize..(p.start + p.count) as usize].iter().any(outside));
    }
    dull(case)
}

/// Triangles that are no needles, and every number in f64: of two equal diagonals a last digit picks one, and on a steep plane the last digits of f32 are more
/// than [`super::SLACK`]. What f32 may cost is for the check `color` to say.
fn steady(case: &mut Case) -> Result<(), String> {
    case.choices.depth = DepthFormat::F64;
    let plan = Plan::new(&case.scene, &case.choices, Accepts::AnyPolygon).map_err(|error| error.to_string())?;
    case.scene = flatten(&case.scene, &plan, true);
    leave_out_needles(&mut case.scene);
    Ok(())
}

/// Leaves out highlights: NFF's begin at once where the light rises over the surface, and there a last digit decides.
fn dull(case: &mut Case) -> Result<(), String> {
    case.scene.surfaces.iter_mut().for_each(|surface| surface.material.specular = 0.0);
    case.plain = drawn(&case.scene, &case.choices)?;
    Ok(())
}

/// A wider picture of the same scale: everything stands whole pixels farther right. Only polygons that no plane cuts: a cut corner is
/// snapped, and another plane cuts elsewhere.
pub(super) fn shift(case: &mut Case) -> Result<Option<Pair>, String> {
    steady(case)?;
    uncut(case)?;
    if case.plain.list.is_empty() {
        return Ok(None);
    }
    let by = 1 + case.random.below(40) as u32;
    let size = Some((SIDE + 2 * by, SIDE));
    let wide = drawn(&case.scene, &Choices { size, ..case.choices.clone() })?.image;
    let actual = image_of(|x, y| wide.pixel(x + by as usize, y));
    Ok(Some(case.rounded(actual, false)))
}

fn image_of(pixel: impl Fn(usize, usize) -> Rgb<f32>) -> Image {
    let mut image = Image::new(SIDE as usize, SIDE as usize, Rgb::gray(0.0));
    for y in 0..SIDE as usize {
        for x in 0..SIDE as usize {
            image.set_pixel(x, y, pixel(x, y));
        }
    }
    image
}

/// Everything 2^k times as large and as far.
pub(super) fn scale(case: &mut Case) -> Result<Option<Pair>, String> {
    let k = [-100, -37, -10, -1, 1, 10, 37, 100][case.random.below(8) as usize];
    let scene = scaled(&case.scene, k);
    Ok(Some(case.bytes(drawn(&scene, &case.choices)?.image)))
}

fn scaled(scene: &Scene, k: i32) -> Scene {
    let factor = pow(2.0, f64::from(k));
    let mut scene = moved(scene, |place| place * factor, |normal| normal);
    if let Some(camera) = &mut scene.camera {
        camera.hither *= factor;
        camera.yon = camera.yon.map(|yon| yon * factor);
        camera.at *= factor;
    }
    scene
}

/// The scene with all places and normals changed, the eye aside.
fn moved(scene: &Scene, place: impl Fn(Vec3) -> Vec3, normal: impl Fn(Vec3) -> Vec3) -> Scene {
    let mut scene = scene.clone();
    for surface in &mut scene.surfaces {
        surface.mesh.vertices.iter_mut().for_each(|at| *at = place(*at));
        surface.mesh.normals.iter_mut().for_each(|at| *at = normal(*at));
    }
    for light in &mut scene.lights {
        if let LightSource::Point { position } = &mut light.source {
            *position = place(*position);
        }
    }
    scene
}

/// How far the scale may go until a byte changes: for the record.
pub(super) fn reach(effort: &Effort, report: &mut Report) {
    for (depth, name) in [(crate::plan::DepthFormat::F32, "f32"), (crate::plan::DepthFormat::F64, "f64")] {
        let Ok(mut base) = case(effort.seed) else { continue };
        base.choices.depth = depth;
        let Ok(plain) = drawn(&base.scene, &base.choices) else { continue };
        let same = |k: i32| drawn(&scaled(&base.scene, k), &base.choices).is_ok_and(|drawn| drawn.image == plain.image);
        let last = |sign: i32| (1..1100).take_while(|&k| same(sign * k)).last().unwrap_or(0);
        report.count(format!("largest k of 2^k that changes no byte, {name}"), last(1) as u64);
        report.count(format!("largest k of 2^-k that changes no byte, {name}"), last(-1) as u64);
    }
}

/// A reflection turns outlines about: they are reversed, and their first corner stays first.
fn reflected(scene: &Scene, map: impl Fn(Vec3) -> Vec3 + Copy) -> Scene {
    let mut scene = moved(scene, map, map);
    for surface in &mut scene.surfaces {
        let mesh = &mut surface.mesh;
        for polygon in &mesh.polygons {
            mesh.outlines[polygon.start as usize + 1..(polygon.start + polygon.count) as usize].reverse();
        }
    }
    scene
}

/// Columns become rows. Only polygons that no plane cuts: the sides are cut left before top, and the corners then come in another order to
/// where polygons are split.
pub(super) fn exchange(case: &mut Case) -> Result<Option<Pair>, String> {
    steady(case)?;
    uncut(case)?;
    let scene = reflected(&case.scene, |at| Vec3::new(-at.y, -at.x, at.z));
    let turned = drawn(&scene, &case.choices)?.image;
    let actual = image_of(|x, y| turned.pixel(y, x));
    Ok(Some(case.rounded(actual, true)))
}

/// Left becomes right.
pub(super) fn mirror(case: &mut Case) -> Result<Option<Pair>, String> {
    steady(case)?;
    dull(case)?;
    let scene = reflected(&case.scene, |at| Vec3::new(-at.x, at.y, at.z));
    let turned = drawn(&scene, &case.choices)?.image;
    let actual = image_of(|x, y| turned.pixel(SIDE as usize - 1 - x, y));
    Ok(Some(case.rounded(actual, true)))
}

/// This scene and another, in both orders. Both have the same lights.
pub(super) fn merge(case: &mut Case) -> Result<Option<Pair>, String> {
    let mut other = hard(case.random.bits());
    other.surfaces.iter_mut().for_each(|surface| surface.material.opacity = Rgb::WHITE);
    let (mut behind, mut before) = (case.scene.clone(), other.clone());
    behind.merge(other);
    before.merge(case.scene.clone());
    case.plain = drawn(&behind, &case.choices)?;
    Ok(Some(case.exact(drawn(&before, &case.choices)?.image)))
}

/// Everything computed, needed or not.
pub(super) fn full_needs(case: &mut Case) -> Result<Option<Pair>, String> {
    let full = drawn(&case.scene, &Choices { needs: NeedsMode::Full, ..case.choices.clone() })?;
    Ok(Some(case.bytes(full.image)))
}

/// NFF knows no yon; what else it loses is told, and then nothing can be said.
pub(super) fn written(case: &mut Case) -> Result<Option<Pair>, String> {
    case.scene.camera.iter_mut().for_each(|camera| camera.yon = None);
    case.plain = drawn(&case.scene, &case.choices)?;
    let mut text = Vec::new();
    let losses = write_nff(&case.scene, &mut text).map_err(|error| error.to_string())?;
    if !losses.is_empty() {
        return Ok(None);
    }
    let back = read_nff("written", &text, ParseOptions::default()).map_err(|errors| errors.to_string())?;
    Ok(Some(case.bytes(drawn(&back.scene, &case.choices)?.image)))
}
