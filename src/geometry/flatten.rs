//! Flatten: a scene of polygons only, as the rasterizer would have met it.
//!
//! Scene + Plan -FLATTEN-> Scene -write-> NFF
//!
//! Shapes become the very polygons that the geometry stage makes of them for this view, in their place in
//! the file's order; so the written scene gives the same picture, byte for byte.

use super::split::{SplitScratch, split};
use super::tessellate::detail;
use crate::math::{Affine3, Vec3, newell_normal};
use crate::model;
use crate::plan::Plan;
use crate::scene::{Mesh, NormalSource, Object, ObjectId, Scene, Surface, SurfaceId};
use std::collections::BTreeSet;

/// `scene` with every shape turned into polygons as `plan` sees it; with `triangles`, polygons are split as well.
///
/// A shape's fineness depends on where it stands, so every instance gets surfaces of its own and the tree becomes flat:
/// one object a placed object, with its transform to world space.
#[must_use]
pub fn flatten(scene: &Scene, plan: &Plan, triangles: bool) -> Scene {
    let mut flat = Scene {
        objects: Vec::new(),
        surfaces: Vec::new(),
        world: Vec::new(),
        facing: BTreeSet::new(),
        ..scene.clone()
    };
    // The plan has walked the same tree within its budget.
    let walked = scene.walk(|placed| {
        let first = flat.surfaces.len() as u32;
        for &id in &placed.object.surfaces {
            let surface = flat_surface(scene.surface(id), &placed.world_from_local, plan);
            flat.surfaces.push(if triangles { in_triangles(&surface) } else { surface });
        }
        let surfaces = (first..flat.surfaces.len() as u32).map(SurfaceId).collect();
        flat.world.push(ObjectId(flat.objects.len() as u32));
        let (name, parent_from_local) = (placed.object.name.clone(), placed.world_from_local);
        flat.objects.push(Object {
            name,
            parent_from_local,
            surfaces,
            children: Vec::new(),
            place: placed.object.place,
        });
    });
    debug_assert!(walked.is_ok());
    flat
}

fn flat_surface(surface: &Surface, world_from_local: &Affine3, plan: &Plan) -> Surface {
    let mut flat = Surface { mesh: Mesh::default(), primitives: Vec::new(), ..surface.clone() };
    let mut shape = Mesh::default();
    let mut next = 0;
    append_vertices(&mut flat.mesh, &surface.mesh);
    for primitive in &surface.primitives {
        append_polygons(&mut flat.mesh, &surface.mesh, next..primitive.before as usize, 0);
        next = primitive.before as usize;
        shape.clear();
        let detail = detail(primitive, world_from_local, plan);
        model::tessellate(&primitive.shape, primitive.inside, detail, primitive.line, &mut shape);
        let offset = append_vertices(&mut flat.mesh, &shape);
        append_polygons(&mut flat.mesh, &shape, 0..shape.polygons.len(), offset);
    }
    append_polygons(&mut flat.mesh, &surface.mesh, next..surface.mesh.polygons.len(), 0);
    flat
}

/// Adds all vertices of `from` and returns the index of the first.
fn append_vertices(to: &mut Mesh, from: &Mesh) -> u32 {
    let offset = to.vertices.len() as u32;
    if !from.texture.is_empty() {
        to.texture.resize(to.vertices.len(), Vec3::ZERO);
    }
    for (index, &vertex) in from.vertices.iter().enumerate() {
        match from.normals.get(index) {
            Some(&normal) => to.push_vertex_with_normal(vertex, normal),
            None => to.push_vertex(vertex),
        };
        // `push_vertex` made room, if there is any.
        if let (Some(place), Some(&own)) = (to.texture.last_mut(), from.texture.get(index)) {
            *place = own;
        }
    }
    offset
}

fn append_polygons(to: &mut Mesh, from: &Mesh, range: std::ops::Range<usize>, offset: u32) {
    for polygon in &from.polygons[range] {
        let outline: Vec<_> = from.outline(polygon).iter().map(|index| index + offset).collect();
        to.push_polygon(&outline, polygon.normals, polygon.line);
    }
}

/// The same surface in triangles, over the same vertices.
fn in_triangles(surface: &Surface) -> Surface {
    let mut split_surface = surface.clone();
    let mesh = &mut split_surface.mesh;
    // Averaged normals are means over the polygons that were; they have to be fixed before these are gone.
    let mut fixed = Vec::new();
    model::vertex_normals(&surface.mesh, &[NormalSource::Averaged], &mut fixed);
    mesh.normals = fixed;
    mesh.polygons.clear();
    mesh.outlines.clear();
    let (mut scratch, mut triangles) = (SplitScratch::default(), Vec::new());
    for polygon in &surface.mesh.polygons {
        let outline = surface.mesh.outline(polygon);
        let corners: Vec<Vec3> = outline.iter().map(|&index| surface.mesh.vertices[index as usize]).collect();
        triangles.clear();
        split(&corners, newell_normal(&corners), &mut scratch, &mut triangles);
        let normals = if polygon.normals == NormalSource::Averaged { NormalSource::Given } else { polygon.normals };
        for triangle in &triangles {
            mesh.push_polygon(&triangle.map(|corner| outline[corner as usize]), normals, polygon.line);
        }
    }
    split_surface
}
