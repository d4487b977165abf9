//! Draft -> scene, everything looked up before.
//!
//! Draft, Checked -BUILD-> Scene
//!
//! Nodes come in an order in which everything a node is made of stands before it. A node first becomes [`Parts`], its
//! surfaces and children; only where it stands in the tree does it become an object. So a definition that is used
//! a thousand times is parts once, and each `use` is one object that lists the same parts.
//!
//! Cost: linear in what the file says and in what `copy` and `clone` make.

use super::check::Checked;
use super::draft::{Copying, Draft, Node, NodeKind, RawSurface};
use super::names::bytes;
use crate::diagnostic::{Source, Span, printable};
use crate::math::Affine3;
use crate::scene::{Camera, Material, Object, ObjectId, Place, Reflection, Scene, Surface, SurfaceId, TextureId};

/// The scene of a draft that is free of mistakes.
pub(super) fn build(source: &Source, mut draft: Draft, checked: &Checked) -> Scene {
    let mut scene = Scene { files: vec![source.name.clone()], ..Scene::default() };
    let resolution = draft.image;
    scene.lights = std::mem::take(&mut draft.lights);
    scene.background = draft.background;
    scene.textures = std::mem::take(&mut draft.textures);
    scene.camera = draft.camera.map(|camera| Camera { resolution: resolution.unwrap_or(camera.resolution), ..camera });
    let surfaces = std::mem::take(&mut draft.surfaces);
    let two_sided = draft.two_sided;
    let materials: Vec<(Material, u32)> = draft.shaders.iter().map(|shader| (shader.material, shader.line)).collect();
    let surfaces = surfaces.into_iter().zip(&checked.shaders);
    let surfaces = surfaces.map(|(surface, &shader)| {
        let made_of = shader.map_or((picture_material(surface.picture), 0), |shader| materials[shader as usize]);
        finished(surface, made_of, two_sided)
    });
    let imports = std::mem::take(&mut draft.imports);
    let mut builder = Builder {
        source,
        nodes: &draft.nodes,
        checked,
        materials: &materials,
        parts: vec![None; draft.nodes.len()],
        is_target: vec![false; draft.nodes.len()],
        surfaces: surfaces.map(Some).collect(),
        placed: Vec::new(),
        imports: Vec::new(),
        scene,
    };
    builder.placed = vec![None; builder.surfaces.len()];
    checked.targets.iter().flatten().for_each(|&target| builder.is_target[target as usize] = true);
    imports.into_iter().for_each(|import| builder.import(import));
    checked.order.iter().for_each(|&node| builder.node(node));
    builder.scene
}

/// A picture as it is: no light shades what has no form.
fn picture_material(texture: Option<TextureId>) -> Material {
    let reflection = Reflection::Phong;
    Material { reflection, ambient: Some(1.0), diffuse: 0.0, specular: 0.0, texture, ..Material::default() }
}

fn finished(surface: RawSurface, (material, line): (Material, u32), two_sided: bool) -> Surface {
    Surface {
        material,
        mesh: surface.mesh,
        primitives: surface.primitive.into_iter().collect(),
        two_sided: surface.two_sided.unwrap_or(two_sided),
        place: Place { file: 0, line },
    }
}

/// What a node is made of.
#[derive(Clone, Default)]
struct Parts {
    surfaces: Vec<SurfaceId>,
    children: Vec<ObjectId>,
}

struct Builder<'a> {
    source: &'a Source,
    nodes: &'a [Node],
    checked: &'a Checked,
    materials: &'a [(Material, u32)],
    /// Of nodes that were built and not taken.
    parts: Vec<Option<Parts>>,
    /// Some reference needs the parts of this node.
    is_target: Vec<bool>,
    /// Those that are not in the scene yet.
    surfaces: Vec<Option<Surface>>,
    /// Where in the scene each surface of the draft is.
    placed: Vec<Option<SurfaceId>>,
    /// The top-level objects of each import.
    imports: Vec<Vec<ObjectId>>,
    scene: Scene,
}

impl Builder<'_> {
    fn import(&mut self, import: Scene) {
        // The world holds nothing yet but what the import puts there.
        let _ = self.scene.merge(import);
        self.imports.push(std::mem::take(&mut self.scene.world));
    }

    fn node(&mut self, index: u32) {
        let node = &self.nodes[index as usize];
        let target = self.checked.targets[index as usize];
        let parts = match (node.kind, target) {
            (NodeKind::Import(import), _) => {
                Parts { surfaces: Vec::new(), children: self.imports[import as usize].clone() }
            }
            (NodeKind::Reference { how, .. }, Some(target)) => {
                let parts = self.parts[target as usize].clone().unwrap_or_default();
                match how {
                    Copying::Use => parts,
                    Copying::Copy => self.copy(parts),
                    Copying::Clone => self.clone_of(parts, self.checked.new_shaders[index as usize]),
                }
            }
            _ => Parts {
                surfaces: node.surfaces.iter().map(|&surface| self.surface(surface)).collect(),
                children: node.children.iter().map(|&child| self.object(child)).collect(),
            },
        };
        if node.kind == NodeKind::World {
            return self.world(node, parts);
        }
        self.parts[index as usize] = Some(parts);
    }

    /// Puts a node, whose parts are built, into the scene.
    fn object(&mut self, index: u32) -> ObjectId {
        let node = &self.nodes[index as usize];
        let slot = &mut self.parts[index as usize];
        let parts = if self.is_target[index as usize] { slot.clone() } else { slot.take() };
        self.push(node, node.name, parts.unwrap_or_default())
    }

    fn push(&mut self, node: &Node, name: Span, parts: Parts) -> ObjectId {
        self.scene.objects.push(Object {
            name: printable(bytes(self.source, name)),
            parent_from_local: node.parent_from_local,
            surfaces: parts.surfaces,
            children: parts.children,
            place: Place { file: 0, line: node.line },
        });
        let id = ObjectId(self.scene.objects.len() as u32 - 1);
        if node.kind == NodeKind::Facing {
            self.scene.facing.insert(id);
        }
        id
    }

    /// The children of a world are the top-level objects; what it has of its own needs an object to belong to.
    fn world(&mut self, node: &Node, parts: Parts) {
        if parts.surfaces.is_empty() && node.parent_from_local == Affine3::IDENTITY {
            self.scene.world.extend(parts.children);
        } else {
            let object = self.push(node, Span::default(), parts);
            self.scene.world.push(object);
        }
    }

    fn surface(&mut self, index: u32) -> SurfaceId {
        let index = index as usize;
        if let Some(surface) = self.surfaces[index].take() {
            self.scene.surfaces.push(surface);
            self.placed[index] = Some(SurfaceId(self.scene.surfaces.len() as u32 - 1));
        }
        self.placed[index].expect("a surface is taken once, and placed then")
    }

    /// New nodes for everything below; surfaces stay shared.
    fn copy(&mut self, parts: Parts) -> Parts {
        let mut next = self.scene.objects.len();
        let children = parts.children.into_iter().map(|child| self.repeat(child)).collect();
        // The new nodes still have the old children: one after the other gets new ones.
        while next < self.scene.objects.len() {
            let old = std::mem::take(&mut self.scene.objects[next].children);
            let new = old.into_iter().map(|child| self.repeat(child)).collect();
            self.scene.objects[next].children = new;
            next += 1;
        }
        Parts { surfaces: parts.surfaces, children }
    }

    fn repeat(&mut self, object: ObjectId) -> ObjectId {
        let copy = self.scene.object(object).clone();
        self.scene.objects.push(copy);
        let again = ObjectId(self.scene.objects.len() as u32 - 1);
        if self.scene.facing.contains(&object) {
            self.scene.facing.insert(again);
        }
        again
    }

    /// New nodes and new surfaces, of another shader if there is one.
    fn clone_of(&mut self, parts: Parts, shader: Option<u32>) -> Parts {
        let first = self.scene.objects.len();
        let copied = self.copy(parts);
        for object in first..self.scene.objects.len() {
            let old = std::mem::take(&mut self.scene.objects[object].surfaces);
            self.scene.objects[object].surfaces = self.clone_surfaces(old, shader);
        }
        Parts { surfaces: self.clone_surfaces(copied.surfaces, shader), children: copied.children }
    }

    fn clone_surfaces(&mut self, surfaces: Vec<SurfaceId>, shader: Option<u32>) -> Vec<SurfaceId> {
        let again = |id: SurfaceId| {
            let mut surface = self.scene.surface(id).clone();
            if let Some(shader) = shader {
                let (material, line) = self.materials[shader as usize];
                surface.material = material;
                // Lines of polygons are those of the surface's file: an imported one keeps its place.
                if surface.place.file == 0 {
                    surface.place.line = line;
                }
            }
            self.scene.surfaces.push(surface);
            SurfaceId(self.scene.surfaces.len() as u32 - 1)
        };
        surfaces.into_iter().map(again).collect()
    }
}
