//! Outside: eye space as somebody sees it who stands beside the view volume.
//!
//! areas and lines in eye space -OUTSIDE-> board
//!
//! Why the pipeline once more: the areas become a scene of their own, seen by a camera of its own, so hidden areas are hidden by
//! the same rasterizers. Lines are laid over, dark where an area hides them.
//!
//! Space: eye space is left-handed; with z turned round it is the world of the scene that is drawn here.

use super::board::{Board, Point, unpacked};
use super::state::Outside;
use crate::color::{Encoding, Rgb};
use crate::math::{Affine3, Vec3, cos, radians, sin, tan};
use crate::plan::{Accepts, Choices, Culling, Plan, Shading, View};
use crate::raster::{Fast, Frame, Rasterizer};
use crate::render;
use crate::scene::{Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Scene, Surface, SurfaceId};

/// An area in eye space.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Its corners.
    pub corners: Vec<Vec3>,
    /// 0x00RRGGBB.
    pub color: u32,
    /// 1 hides what is behind.
    pub opacity: f64,
}

/// A line in eye space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// From here.
    pub from: Vec3,
    /// To here.
    pub to: Vec3,
    /// 0x00RRGGBB.
    pub color: u32,
    /// How much of it is seen through areas, of 256.
    pub through: u32,
}

/// Of lines that are hidden but not to be forgotten.
const FAINT: u32 = 72;

/// The background of eye space seen from outside.
const NOTHING: [u8; 3] = [22, 24, 32];
/// Degrees that the picture spans.
const ANGLE: f64 = 40.0;

/// The view volume: its eight corners up to a distance, and its twelve edges; and lines from the eye.
#[must_use]
pub fn volume(view: &View, far: f64) -> (Vec<Vec3>, Vec<Line>) {
    let (kx, ky) = view.clip_from_eye();
    let at = |z: f64| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec3::new(x * z / kx, y * z / ky, z))
    };
    let (near, far) = (at(view.hither), at(far));
    let mut lines = Vec::new();
    let color = super::board::ink::BLUE;
    for corner in 0..4 {
        let next = (corner + 1) % 4;
        lines.push(Line { from: near[corner], to: near[next], color, through: FAINT });
        lines.push(Line { from: far[corner], to: far[next], color, through: FAINT });
        lines.push(Line { from: near[corner], to: far[corner], color, through: FAINT });
        lines.push(Line { from: Vec3::ZERO, to: near[corner], color: 0x30_50_80, through: FAINT });
    }
    ([near, far].concat(), lines)
}

/// The lines around an area.
pub fn outline(corners: &[Vec3], color: u32, through: u32) -> impl Iterator<Item = Line> {
    crate::math::edges(corners).map(move |(&from, &to)| Line { from, to, color, through })
}

/// Draws areas and lines on a board of `size`, so that all of `around` is in sight.
///
/// # Errors
/// There is nothing to look at: a coordinate is not finite.
pub fn draw(areas: &[Area], lines: &[Line], around: &[Vec3], from: Outside, size: (u32, u32)) -> Result<Board, String> {
    let scene = scene(areas, camera(around, from, size));
    let choices = Choices { size: Some(size), shading: Shading::Flat, culling: Culling::None, ..Choices::default() };
    let rasterizer = Fast::default();
    let list = render::list(&scene, &choices, Some(&rasterizer)).map_err(|error| error.to_string())?;
    let plan = Plan::new(&scene, &choices, Accepts::AnyPolygon).map_err(|error| error.to_string())?;
    let background =
        Encoding::Srgb.decode(Rgb::new(NOTHING[0], NOTHING[1], NOTHING[2]).map(|level| f64::from(level) / 255.0));
    let mut frame = Frame::default();
    let target = frame.target((list.width, list.height), 0..list.height, background.to_f32(), choices.transparency);
    let mut target = target.with_threads(render::Canvas::new(&scene, &choices).threads);
    rasterizer.draw(&list, &mut target);
    target.finish();
    let mut board = Board::of_picture(&frame.image(list.width, 0..list.height).encode(Encoding::Srgb));
    lines.iter().for_each(|line| draw_line(&mut board, *line, &plan.view, &frame));
    Ok(board)
}

/// Eye space with z turned round: right-handed, like every world.
fn world(eye: Vec3) -> Vec3 {
    Vec3::new(eye.x, eye.y, -eye.z)
}

/// Stands so far away that the ball around everything fits.
fn camera(around: &[Vec3], from: Outside, size: (u32, u32)) -> Camera {
    let low = around.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = around.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let (at, radius) = (world((low + high) / 2.0), (high - low).length() / 2.0);
    let (round, up) = (radians(from.round), radians(from.up));
    let direction = Vec3::new(sin(round) * cos(up), sin(up), cos(round) * cos(up));
    let distance = radius * 0.9 / tan(radians(ANGLE / 2.0)) / from.zoom;
    Camera {
        from: at + direction * distance,
        at,
        up: Vec3::Y,
        angle: ANGLE,
        hither: distance / 1000.0,
        yon: None,
        resolution: size,
        place: Place::default(),
    }
}

/// A surface for every color, all of one object.
fn scene(areas: &[Area], camera: Camera) -> Scene {
    let mut kinds: Vec<(u32, u64)> = Vec::new();
    let mut surfaces: Vec<Surface> = Vec::new();
    for area in areas.iter().filter(|area| area.corners.len() >= 3 && area.corners.iter().all(|p| p.is_finite())) {
        let kind = (area.color, area.opacity.to_bits());
        let index = kinds.iter().position(|&known| known == kind).unwrap_or_else(|| {
            kinds.push(kind);
            surfaces.push(surface(area));
            kinds.len() - 1
        });
        let mesh = &mut surfaces[index].mesh;
        let outline: Vec<u32> = area.corners.iter().map(|&corner| mesh.push_vertex(world(corner))).collect();
        mesh.push_polygon(&outline, NormalSource::Facet, 0);
    }
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: Vec::new(),
        place: Place::default(),
    };
    Scene {
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![Light::point(camera.from, Rgb::WHITE, Place::default())],
        camera: Some(camera),
        ..Scene::default()
    }
}

fn surface(area: &Area) -> Surface {
    let [red, green, blue] = unpacked(area.color).map(|level| f64::from(level) / 255.0);
    let material = Material { color: Rgb::new(red, green, blue), diffuse: 1.0, ..Material::default() };
    let material = Material { opacity: Rgb::gray(area.opacity), ..material };
    Surface { material, mesh: Mesh::default(), primitives: Vec::new(), two_sided: true, place: Place::default() }
}

/// Draws a line pixel by pixel; where an area is nearer, it is faint. 1/w is linear along a line on the screen.
fn draw_line(board: &mut Board, line: Line, view: &View, frame: &Frame) {
    let [from, to] = [line.from, line.to].map(|end| view.to_eye(world(end)));
    // A camera that was moved into the volume sees lines that begin behind it: those are cut off.
    let Some([from, to]) = in_front([from, to], view.hither) else { return };
    let (half_width, half_height) = view.half();
    let screen = |eye: Vec3| (half_width + eye.x / eye.z * view.scale, half_height - eye.y / eye.z * view.scale);
    let ends: [Point; 2] = [screen(from), screen(to)];
    let (dx, dy) = (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1);
    let steps = dx.abs().max(dy.abs()).ceil().clamp(1.0, 1e5);
    for step in 0..=steps as i64 {
        let share = step as f64 / steps;
        let (x, y) = ((ends[0].0 + dx * share).floor() as i64, (ends[0].1 + dy * share).floor() as i64);
        if board.pixel(x, y).is_none() {
            continue;
        }
        let inverse_w = (1.0 - share) / from.z + share / to.z;
        let (_, depth, _) = frame.sample(y as usize * board.width() + x as usize);
        board.blend(x, y, line.color, if depth > inverse_w * 1.002 { line.through } else { 256 });
    }
}

fn in_front(mut ends: [Vec3; 2], hither: f64) -> Option<[Vec3; 2]> {
    if ends.iter().all(|end| end.z < hither) || !ends.iter().all(|end| end.is_finite()) {
        return None;
    }
    let share = (hither - ends[0].z) / (ends[1].z - ends[0].z);
    let on_plane = ends[0] + (ends[1] - ends[0]) * share;
    ends.iter_mut().filter(|end| end.z < hither).for_each(|end| *end = on_plane);
    Some(ends)
}
