//! Draft -> everything looked up: which shader, which object, in which order; cycles and runaway copies are refused here.
//!
//! Why sizes are counted before anything is built: 60 lines of doubling are 2^60 objects. Sizes are sums over the
//! definition, with numbers that stop at their largest value, so counting costs nothing and cannot be fooled.
//!
//! Cost: linear in nodes and references.

use super::MOST_ERRORS;
use super::draft::{Copying, Draft, Node, NodeKind, RawSurface};
use super::names::{Names, bytes};
use super::notices::{Notices, Oddity};
use super::order::order;
use crate::diagnostic::{Diagnostic, Source, Span};
use crate::parse::wording::plain;
use crate::scene::{Mesh, Scene};

/// How many nodes and, apart from them, surfaces `copy` and `clone` may make.
const MOST_COPIES: u64 = 1_000_000;
/// How many vertices and corners `clone` may make.
const MOST_CLONED_CORNERS: u64 = 20_000_000;

/// What was looked up.
pub(super) struct Checked {
    /// For each surface of the draft, its shader; none where it shows a picture as it is.
    pub shaders: Vec<Option<u32>>,
    /// For each node, the node that it refers to.
    pub targets: Vec<Option<u32>>,
    /// For each clone, the shader that replaces others.
    pub new_shaders: Vec<Option<u32>>,
    /// The nodes to build, each behind all it is made of.
    pub order: Vec<u32>,
}

/// Looks everything up.
pub(super) fn check(source: &Source, draft: &Draft, notices: &mut Notices) -> Result<Checked, Vec<Diagnostic>> {
    let mut errors = Vec::new();
    let names = Names::new(source, draft, &mut errors);
    // What is told is enough: looking for similar names is slow, and a file may hold a million mistakes.
    let mut found = |lookup: &dyn Fn() -> Result<u32, Diagnostic>| {
        if errors.len() > MOST_ERRORS {
            return None;
        }
        lookup().map_err(|error| errors.push(error)).ok()
    };
    let mut shader_of = |surface: &RawSurface| match surface.picture {
        // It needs none.
        Some(_) => None,
        None => Some(found(&|| names.shader(surface.shader)).unwrap_or_default()),
    };
    let shaders: Vec<Option<u32>> = draft.surfaces.iter().map(&mut shader_of).collect();
    let (mut targets, mut new_shaders) = (vec![None; draft.nodes.len()], vec![None; draft.nodes.len()]);
    for (index, node) in draft.nodes.iter().enumerate() {
        let NodeKind::Reference { target, shader, .. } = node.kind else { continue };
        targets[index] = found(&|| names.object(target));
        new_shaders[index] = shader.and_then(|shader| found(&|| names.shader(shader)));
        if targets[index].is_some_and(|target| draft.nodes[target as usize].is_transformed) {
            notices.note(Oddity::TransformsLeft, node.keyword);
        }
    }
    let order = order(source, draft, &targets);
    errors.extend(order.cycles);
    if errors.is_empty() {
        errors.extend(Sizes::new(source, draft, &targets).check(&order.drawn));
    }
    // Of many mistakes those that stand first are told.
    errors.sort_by_key(|error| error.labels.first().map_or(Span::default().start, |(span, _)| span.start));
    let checked = Checked { shaders, targets, new_shaders, order: order.drawn };
    if errors.is_empty() { Ok(checked) } else { Err(errors) }
}

/// How much a node stands for, everything below it included.
#[derive(Clone, Copy, Default)]
struct Size {
    objects: u64,
    surfaces: u64,
    /// Vertices and corners of polygons.
    corners: u64,
}

impl Size {
    fn add(&mut self, other: Size) {
        self.objects = self.objects.saturating_add(other.objects);
        self.surfaces = self.surfaces.saturating_add(other.surfaces);
        self.corners = self.corners.saturating_add(other.corners);
    }
}

struct Sizes<'a> {
    source: &'a Source,
    draft: &'a Draft,
    targets: &'a [Option<u32>],
    /// Of each import.
    imports: Vec<Size>,
}

impl<'a> Sizes<'a> {
    fn new(source: &'a Source, draft: &'a Draft, targets: &'a [Option<u32>]) -> Sizes<'a> {
        let imports = draft.imports.iter().map(|scene| {
            let corners = scene.surfaces.iter().map(|surface| corners(&surface.mesh)).sum();
            Size { objects: scene.objects.len() as u64, surfaces: scene.surfaces.len() as u64, corners }
        });
        Sizes { source, draft, targets, imports: imports.collect() }
    }

    /// The first node, in building order, that stands for too much.
    fn check(&self, order: &[u32]) -> Option<Diagnostic> {
        let mut sizes = vec![Size::default(); self.draft.nodes.len()];
        let (mut instances, mut copied, mut cloned) = (Size::default(), Size::default(), Size::default());
        let budget = Scene::INSTANCE_BUDGET as u64;
        for &index in order {
            let node = &self.draft.nodes[index as usize];
            let size = self.size(node, self.targets[index as usize], &sizes);
            sizes[index as usize] = size;
            if node.kind == NodeKind::World {
                instances.add(size);
            }
            if size.objects > budget || instances.objects > budget {
                return Some(self.too_much(node, &format!("more than {budget} objects")));
            }
            if size.surfaces > budget || instances.surfaces > budget {
                return Some(self.too_much(node, &format!("more than {budget} surfaces")));
            }
            match node.kind {
                NodeKind::Reference { how: Copying::Copy, .. } => copied.add(size),
                NodeKind::Reference { how: Copying::Clone, .. } => {
                    copied.add(size);
                    cloned.add(size);
                }
                _ => continue,
            }
            if copied.objects > MOST_COPIES || cloned.surfaces > MOST_COPIES || cloned.corners > MOST_CLONED_CORNERS {
                return Some(self.too_many_copies(node));
            }
        }
        None
    }

    fn size(&self, node: &Node, target: Option<u32>, sizes: &[Size]) -> Size {
        if let Some(target) = target {
            return sizes[target as usize];
        }
        let mut size = Size { objects: u64::from(node.kind != NodeKind::World), ..Size::default() };
        for &surface in &node.surfaces {
            let corners = corners(&self.draft.surfaces[surface as usize].mesh);
            size.add(Size { objects: 0, surfaces: 1, corners });
        }
        node.children.iter().for_each(|&child| size.add(sizes[child as usize]));
        if let NodeKind::Import(import) = node.kind {
            size.add(self.imports[import as usize]);
        }
        size
    }

    fn too_much(&self, node: &Node, what: &str) -> Diagnostic {
        let message = match node.kind {
            NodeKind::World => format!("the world holds {what}"),
            NodeKind::Reference { .. } => format!("this `{}` stands for {what}", self.word(node)),
            _ => format!("`{}` holds {what}", plain(bytes(self.source, node.name))),
        };
        let help = "objects that use each other multiply: each doubling doubles everything below it";
        Diagnostic::error(message).at(node.keyword, "counted up to here").help(help)
    }

    fn too_many_copies(&self, node: &Node) -> Diagnostic {
        let message = format!(
            "the copies up to this `{}` are more than {MOST_COPIES} objects or surfaces, or {MOST_CLONED_CORNERS} vertices",
            self.word(node)
        );
        Diagnostic::error(message)
            .at(node.keyword, "counted up to here")
            .help("`use` shares what `copy` and `clone` repeat")
    }

    fn word(&self, node: &Node) -> String {
        plain(bytes(self.source, node.keyword))
    }
}

/// Vertices and corners of polygons.
fn corners(mesh: &Mesh) -> u64 {
    (mesh.vertices.len() + mesh.outlines.len()) as u64
}
