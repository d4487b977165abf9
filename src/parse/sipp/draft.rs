//! A `.sipp` file as it was read: everything by name, nothing looked up yet.
//!
//! words -reader-> DRAFT -check, build-> Scene
//!
//! Why a step between text and scene: names may be used above the line that defines them.
//!
//! Names are spans of the source, so a million of them cost nothing but their place.

use crate::diagnostic::Span;
use crate::math::Affine3;
use crate::scene::{Camera, Light, Material, Mesh, Primitive, Scene, Texture, TextureId};

/// Everything a file says.
#[derive(Default)]
pub(super) struct Draft {
    pub shaders: Vec<Shader>,
    /// Pictures of shaders.
    pub textures: Vec<Texture>,
    /// Definitions, nested objects, uses, imports and worlds.
    pub nodes: Vec<Node>,
    pub surfaces: Vec<RawSurface>,
    /// What was imported: a scene of its own, without view and lights.
    pub imports: Vec<Scene>,
    pub lights: Vec<Light>,
    /// As written; its resolution is filled in from `image`.
    pub camera: Option<Camera>,
    pub background: Option<crate::color::Rgb>,
    pub image: Option<(u32, u32)>,
    /// For surfaces that do not say themselves.
    pub two_sided: bool,
}

/// A `shader` statement.
pub(super) struct Shader {
    pub name: Span,
    pub line: u32,
    pub material: Material,
}

/// A node of the tree, or of a definition.
pub(super) struct Node {
    /// Empty where it has none.
    pub name: Span,
    /// The word it starts with.
    pub keyword: Span,
    pub line: u32,
    pub parent_from_local: Affine3,
    /// The file gives at least one transform.
    pub is_transformed: bool,
    pub kind: NodeKind,
    /// Indices into [`Draft::surfaces`].
    pub surfaces: Vec<u32>,
    /// Indices into [`Draft::nodes`], in the order of the file.
    pub children: Vec<u32>,
}

impl Node {
    pub fn has_content(&self) -> bool {
        !self.surfaces.is_empty() || !self.children.is_empty()
    }
}

/// Where a node gets its surfaces and children from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NodeKind {
    /// A block of its own at the level of the file: a definition.
    Definition,
    /// A block inside another: it is drawn where it stands.
    Nested,
    /// Likewise, and it turns to the camera.
    Facing,
    /// A `world`.
    World,
    /// `use`, `copy`, `clone`: those of the object `target`.
    Reference {
        how: Copying,
        target: Span,
        /// Replaces the shader of every surface of a clone.
        shader: Option<Span>,
    },
    /// Index into [`Draft::imports`].
    Import(u32),
}

/// How much of an object a reference makes anew.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Copying {
    /// The node alone; SIPP's `object_instance`.
    Use,
    /// All nodes; SIPP's `object_dup`.
    Copy,
    /// All nodes and surfaces; SIPP's `object_deep_dup`.
    Clone,
}

/// Polygons or a shape, and the name of what they are made of.
pub(super) struct RawSurface {
    pub shader: Span,
    pub mesh: Mesh,
    pub primitive: Option<Primitive>,
    pub two_sided: Option<bool>,
    /// In place of a shader: a picture that is shown as it is.
    pub picture: Option<TextureId>,
}
