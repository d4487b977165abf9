//! Objects: scenes that stand on the land, a house on a hill.
//!
//! `object` of `.fcell`, scenes by name, heights -OBJECTS-> one scene, its objects where they stand
//!
//! A scene becomes an object by its box: what is up in its camera's view is up on the land, the middle of the box is over the place that is named,
//! and its lowest point is on the ground: the lowest ground below the four corners and the middle of the box, so that no corner hangs in the air. On a
//! slope the uphill side is in the ground, as houses are.
//!
//! A scene that stands in a hundred places is there once, and a hundred objects point at it.
//!
//! Space: world metres, x east, y north, z up. Cost: one pass over the vertices of each scene.

use super::area::Head;
use crate::math::{Affine3, Mat3, Vec3, radians};
use crate::model::{Detail, tessellate};
use crate::scene::{Mesh, Object, ObjectId, Place, Scene, Surface, TextureId};
use std::collections::BTreeMap;

/// Scenes by the name that areas call them.
pub type Models = BTreeMap<String, Scene>;

/// The smallest scale of an object; the largest is its inverse.
pub const SMALLEST_SCALE: f64 = 1e-6;

/// A scene and where it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// The file it is in, relative to the area's.
    pub file: String,
    /// World position on the map, metres.
    pub at: [f64; 2],
    /// Degrees counterclockwise, seen from above.
    pub turn: f64,
    /// How many times as large as its file says; its units are metres.
    pub scale: f64,
    /// Where it was declared.
    pub place: Place,
}

/// What stands on an area.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stood {
    /// All objects; each one that stands is a child of the world.
    pub scene: Scene,
    /// A ball around each of these, in the same order.
    pub balls: Vec<(Vec3, f64)>,
    /// The box around each, world space.
    pub boxes: Vec<[Vec3; 2]>,
}

/// Why an object cannot stand.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObjectError {
    /// Nobody has read its file.
    #[error("{place}: the scene `{file}` was not read")]
    Unread {
        /// Where it was declared.
        place: String,
        /// Which.
        file: String,
    },
    /// Its scene shows nothing.
    #[error("{place}: the scene `{file}` has neither polygons nor shapes: nothing of it could stand here")]
    Empty {
        /// Where it was declared.
        place: String,
        /// Which.
        file: String,
    },
    /// There is no land.
    #[error("{place}: there is no ground for `{file}` at {x} {y}: that is outside of all cells, or a void")]
    NoGround {
        /// Where it was declared.
        place: String,
        /// Which.
        file: String,
        /// World metres.
        x: f64,
        /// World metres.
        y: f64,
    },
}

/// Stands the objects of an area on ground of this `height`.
///
/// # Errors
/// [`ObjectError`].
pub fn stand(
    head: &Head,
    models: &Models,
    mut height: impl FnMut([f64; 2]) -> Option<f64>,
) -> Result<Stood, ObjectError> {
    let mut stood = Stood { scene: Scene { files: head.files.clone(), ..Scene::default() }, ..Stood::default() };
    let mut known: BTreeMap<&str, (Vec<ObjectId>, Mat3, [Vec3; 2])> = BTreeMap::new();
    for standing in &head.objects {
        let place = || stood_place(head, standing.place);
        let file = standing.file.clone();
        if !known.contains_key(standing.file.as_str()) {
            let Some(model) = models.get(&standing.file) else {
                return Err(ObjectError::Unread { place: place(), file });
            };
            let upright = upright(model);
            let Some(bounds) = bounds(model, &upright) else { return Err(ObjectError::Empty { place: place(), file }) };
            let roots = add(&mut stood.scene, model);
            known.insert(&standing.file, (roots, upright, bounds));
        }
        let (roots, upright, bounds) = &known[standing.file.as_str()];
        let turned = Mat3::from_rotation_z(radians(standing.turn)) * standing.scale;
        let middle = (bounds[0] + bounds[1]) * 0.5;
        let corner = |x: usize, y: usize| Vec3::new(bounds[x].x, bounds[y].y, 0.0) - middle.with_z(0.0);
        let arms = [Vec3::ZERO, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(|arm| turned * arm);
        let [x, y] = standing.at;
        let grounds = arms.map(|arm| height([x + arm.x, y + arm.y]));
        // Over the edge of the area or a void, what is known counts.
        let Some(ground) = grounds.into_iter().flatten().reduce(f64::min).filter(|_| grounds[0].is_some()) else {
            return Err(ObjectError::NoGround { place: place(), file, x, y });
        };
        let foot = Vec3::new(x, y, ground) - turned * middle.with_z(bounds[0].z);
        let parent_from_local = Affine3 { matrix3: turned * *upright, translation: foot };
        let half = (bounds[1] - bounds[0]) * (0.5 * standing.scale);
        let center = foot + turned * middle;
        let reach = Vec3::new(half.truncate().length(), half.truncate().length(), half.z);
        stood.balls.push((center, half.length()));
        stood.boxes.push([center - reach, center + reach]);
        stood.scene.world.push(ObjectId(stood.scene.objects.len() as u32));
        let (name, children, place) = (standing.file.clone(), roots.clone(), standing.place);
        stood.scene.objects.push(Object { name, parent_from_local, surfaces: Vec::new(), children, place });
    }
    Ok(stood)
}

fn stood_place(head: &Head, place: Place) -> String {
    let file = head.files.get(usize::from(place.file)).map_or("the area", String::as_str);
    if place.line == 0 { file.to_string() } else { format!("{file}:{}", place.line) }
}

/// Adds the objects of a scene, without its lights and its view; returns its top-level ones.
fn add(scene: &mut Scene, model: &Scene) -> Vec<ObjectId> {
    let world = std::mem::take(&mut scene.world);
    let model = Scene { lights: Vec::new(), camera: None, background: None, ..model.clone() };
    scene.merge(model);
    std::mem::replace(&mut scene.world, world)
}

/// From a scene to one with z up: what is up in its camera's view, the nearest of the axes; z where it has no camera.
fn upright(model: &Scene) -> Mat3 {
    let up = model.camera.map_or(Vec3::Z, |camera| camera.up);
    let [x, y, z] = up.to_array().map(f64::abs);
    let axis = if z >= x && z >= y { 2 } else { usize::from(y >= x) };
    // Cyclic, so that nothing is mirrored; upside down is half a turn about another axis.
    let cyclic = match axis {
        0 => Mat3::from_cols(Vec3::Z, Vec3::X, Vec3::Y),
        1 => Mat3::from_cols(Vec3::X, Vec3::Z, -Vec3::Y),
        _ => Mat3::IDENTITY,
    };
    if up[axis] < 0.0 { Mat3::from_diagonal(Vec3::new(1.0, -1.0, -1.0)) * cyclic } else { cyclic }
}

/// The box around everything in a scene, after `map`.
fn bounds(model: &Scene, map: &Mat3) -> Option<[Vec3; 2]> {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    let mut shape = Mesh::default();
    let walked = model.walk(|placed| {
        let mut add = |mesh: &Mesh| {
            for &index in &mesh.outlines {
                let point = *map * placed.world_from_local.transform_point3(mesh.vertices[index as usize]);
                if point.is_finite() {
                    (low, high) = (low.min(point), high.max(point));
                }
            }
        };
        for &id in &placed.object.surfaces {
            let Surface { mesh, primitives, .. } = model.surface(id);
            add(mesh);
            for primitive in primitives {
                shape.clear();
                tessellate(&primitive.shape, primitive.inside, Detail::Segments(24), 0, &mut shape);
                add(&shape);
            }
        }
    });
    (walked.is_ok() && low.x <= high.x).then_some([low, high])
}

impl Stood {
    /// The scene with its textures behind `before` others.
    #[must_use]
    pub fn behind(mut self, before: usize) -> Stood {
        for surface in &mut self.scene.surfaces {
            surface.material.texture = surface.material.texture.map(|id| TextureId(id.0 + before as u32));
        }
        self
    }
}
