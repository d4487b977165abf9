//! The scene: a tree of objects, what they are made of, lights and a camera.
//!
//! text -parse-> SCENE -plan, geometry-> DrawList
//!
//! FAROP's model (section 4.2 of the paper): an object has surfaces, sub-objects, and one transform relative to
//! its parent; a surface has one material, a list of vertices shared by its polygons, and the polygons.
//!
//! Why arenas and indices instead of nested boxes: 100,000 nested objects are legal input, and dropping or
//! walking that many boxes recursively overflows the stack. Indices also let several parents share one child.
//!
//! Space: every object has its own local space; `parent_from_local` leads out of it. World space is right-handed,
//! polygons are counterclockwise seen from their front. Colors are display values, as written in the file.

mod light;
mod material;
mod mesh;
mod shape;
mod texture;
mod tree;
mod triangles;

pub use light::{Light, LightSource, SpotEdge};
pub use material::{Material, Reflection};
pub use mesh::{Mesh, NormalSource, Polygon};
pub use shape::{CurveNet, PatchNet, Primitive, Shape, TeapotPart, TextureMapping};
pub use texture::{CutOut, Fade, Texture, TextureId};
pub use tree::{InstanceBudgetExceeded, Placed, Walk};
pub use triangles::{MAGIC, MOST_LIGHTS, TriangleKind, TriangleRange, Triangles};

use crate::color::Rgb;
use crate::math::{Affine3, Vec3};
use std::collections::BTreeSet;

/// Everything that was read: the tree of objects, lights, camera and background.
///
/// Every index in it is valid; [`Scene::merge`] keeps it so.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Names of the files (or built-in scenes) it came from; [`Place::file`] points here.
    pub files: Vec<String>,
    /// All objects, in no particular order; [`ObjectId`] points here.
    pub objects: Vec<Object>,
    /// All surfaces; [`SurfaceId`] points here.
    pub surfaces: Vec<Surface>,
    /// Pictures on surfaces; [`TextureId`] points here.
    pub textures: Vec<Texture>,
    /// The top-level objects, in the order of the files: the children of the world.
    pub world: Vec<ObjectId>,
    /// Objects that turn about their own z axis until their front, against y, faces the camera: pictures of trees.
    pub facing: BTreeSet<ObjectId>,
    /// The lights, in the order of the files.
    pub lights: Vec<Light>,
    /// Where it is seen from; `None` until a file or the command line says so.
    pub camera: Option<Camera>,
    /// Color behind everything; `None` means black.
    pub background: Option<Rgb>,
}

/// Points at one of [`Scene::objects`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ObjectId(pub u32);

/// Points at one of [`Scene::surfaces`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SurfaceId(pub u32);

/// A line of a scene file: what diagnostics and `farop why` name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Index into [`Scene::files`].
    pub file: u16,
    /// 1-based; 0 where there is no line (built in the program).
    pub line: u32,
}

/// A node of the tree: surfaces, sub-objects, and one transform relative to the parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// What the file calls it; may be empty.
    pub name: String,
    /// Leads from this object's local space to its parent's (for a top-level object: to world space).
    pub parent_from_local: Affine3,
    /// Drawn before the children, in this order.
    pub surfaces: Vec<SurfaceId>,
    /// Sub-objects, in this order. No cycles.
    pub children: Vec<ObjectId>,
    /// Where it was declared.
    pub place: Place,
}

/// Polygons and primitives of one material that share a list of vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Color and reflection.
    pub material: Material,
    /// The polygons of the file.
    pub mesh: Mesh,
    /// Spheres, cones and other shapes, turned into polygons only when the view is known.
    pub primitives: Vec<Primitive>,
    /// Back faces are drawn, too, whatever the user chose (SIPP's `show_backfaces`).
    pub two_sided: bool,
    /// Where its material was declared.
    pub place: Place,
}

/// Where the scene is seen from, in world space, and how large the picture is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye.
    pub from: Vec3,
    /// The point in the middle of the picture.
    pub at: Vec3,
    /// A direction that is up in the picture; neither unit nor square to the view.
    pub up: Vec3,
    /// Full opening in degrees, across the smaller side of the picture; above 0, below 180.
    pub angle: f64,
    /// Distance of the near plane along the view; `<= 0` means 1/1000 of the distance from `from` to `at`.
    pub hither: f64,
    /// Distance of the far plane; `None`: infinitely far.
    pub yon: Option<f64>,
    /// Width and height of the picture in pixels.
    pub resolution: (u32, u32),
    /// Where it was declared.
    pub place: Place,
}

impl Scene {
    /// The object `id` points at.
    #[must_use]
    pub fn object(&self, id: ObjectId) -> &Object {
        &self.objects[id.0 as usize]
    }

    /// The surface `id` points at.
    #[must_use]
    pub fn surface(&self, id: SurfaceId) -> &Surface {
        &self.surfaces[id.0 as usize]
    }

    /// The picture that the polygons of `surface` wear: it has one, and they have texture coordinates. Shapes have none.
    #[must_use]
    pub fn picture_on(&self, surface: &Surface) -> Option<(TextureId, &Texture)> {
        let has_places = !surface.mesh.texture.is_empty() && surface.primitives.is_empty();
        let id = surface.material.texture.filter(|_| has_places)?;
        Some((id, self.textures.get(id.0 as usize)?))
    }

    /// Adds `later` behind what is here: objects and lights add up, view parameters of `later` win.
    ///
    /// Returns which view parameters were replaced, for the notice that FAROP prints.
    pub fn merge(&mut self, later: Scene) -> Vec<&'static str> {
        let mut replaced = Vec::new();
        if later.camera.is_some() && self.camera.is_some() {
            replaced.push("camera");
        }
        if later.background.is_some() && self.background.is_some() {
            replaced.push("background");
        }
        let (files, objects, surfaces) =
            (self.files.len() as u16, self.objects.len() as u32, self.surfaces.len() as u32);
        let moved = |place: Place| Place { file: place.file + files, ..place };
        self.files.extend(later.files);
        self.objects.extend(later.objects.into_iter().map(|object| Object {
            surfaces: object.surfaces.iter().map(|id| SurfaceId(id.0 + surfaces)).collect(),
            children: object.children.iter().map(|id| ObjectId(id.0 + objects)).collect(),
            place: moved(object.place),
            ..object
        }));
        let textures = self.textures.len() as u32;
        let surfaces_of_later = later.surfaces.into_iter();
        self.surfaces.extend(surfaces_of_later.map(|surface| {
            let texture = surface.material.texture.map(|id| TextureId(id.0 + textures));
            Surface { material: Material { texture, ..surface.material }, place: moved(surface.place), ..surface }
        }));
        self.textures.extend(later.textures);
        self.world.extend(later.world.iter().map(|id| ObjectId(id.0 + objects)));
        self.facing.extend(later.facing.iter().map(|id| ObjectId(id.0 + objects)));
        self.lights.extend(later.lights.into_iter().map(|light| Light { place: moved(light.place), ..light }));
        self.camera = later.camera.map(|camera| Camera { place: moved(camera.place), ..camera }).or(self.camera);
        self.background = later.background.or(self.background);
        replaced
    }

    /// `file:line` of a place, for messages.
    #[must_use]
    pub fn describe(&self, place: Place) -> String {
        let file = self.files.get(usize::from(place.file)).map_or("?", String::as_str);
        if place.line == 0 { file.to_string() } else { format!("{file}:{}", place.line) }
    }
}
