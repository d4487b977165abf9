//! Triangles -> surfaces: a surface for each range, or for each color of it.
//!
//! Why one for each color: a color that is the material's need not be carried to every vertex and every sample (Phong). A range with
//! few colors, in runs, becomes as many surfaces; one whose vertices are colored one by one keeps its colors in the mesh.

use super::vector;
use crate::color::Rgb;
use crate::math::{Vec3, unit};
use crate::scene::{Material, Mesh, NormalSource, Place, Surface, TextureId, TriangleKind, TriangleRange, Triangles};

/// Runs of one color become surfaces where they are at least this long on average: a surface costs as much as some triangles.
const TRIANGLES_A_SURFACE: usize = 8;

/// All surfaces, in the order they are drawn.
pub(super) fn surfaces(triangles: &Triangles) -> Vec<Surface> {
    let mut sorter = Sorter { triangles, place_of: vec![NOWHERE; triangles.positions.len()], used: Vec::new() };
    let ranges = triangles.ranges.iter().filter(|range| range.count > 0);
    ranges.flat_map(|&range| sorter.range(range)).collect()
}

/// Takes triangles out of the one list of the file, with the vertices that they use.
struct Sorter<'a> {
    triangles: &'a Triangles,
    /// Where a vertex of the file is in the surface in hand.
    place_of: Vec<u32>,
    /// The vertices of the file that are in the surface in hand.
    used: Vec<u32>,
}

/// Not in the surface in hand.
const NOWHERE: u32 = u32::MAX;

impl Sorter<'_> {
    fn range(&mut self, range: TriangleRange) -> Vec<Surface> {
        let triangles = self.triangles;
        let indices = &triangles.indices[range.first as usize..(range.first + range.count) as usize];
        let runs = runs(indices, &triangles.colors);
        match runs {
            Some(runs) => runs.into_iter().map(|(color, run)| self.surface(run, range.kind, Some(color))).collect(),
            None => vec![self.surface(indices, range.kind, None)],
        }
    }

    /// The surface of the triangles of `indices`, of one color, or of those of its vertices.
    fn surface(&mut self, indices: &[u32], kind: TriangleKind, color: Option<[f32; 3]>) -> Surface {
        let mut mesh = Mesh::default();
        mesh.polygons.reserve_exact(indices.len() / 3);
        mesh.outlines.reserve_exact(indices.len());
        for corners in indices.chunks_exact(3) {
            let outline = [corners[0], corners[1], corners[2]].map(|index| self.vertex(index, kind, color, &mut mesh));
            mesh.push_polygon(&outline, NormalSource::Given, 0);
        }
        for index in self.used.drain(..) {
            self.place_of[index as usize] = NOWHERE;
        }
        let [ambient, diffuse, specular, shine] = self.triangles.material.map(f64::from);
        let color = color.map_or(Rgb::WHITE, rgb);
        let material = Material { color, ambient: Some(ambient), diffuse, specular, shine, ..Material::default() };
        let two_sided = kind == TriangleKind::Textured;
        // The file has one picture, if any: [`crate::scene::Scene::picture_on`] finds none where it has none.
        let material = Material { texture: two_sided.then_some(TextureId(0)), ..material };
        Surface { material, mesh, primitives: Vec::new(), two_sided, place: Place::default() }
    }

    /// Where vertex `index` of the file is in `mesh`.
    fn vertex(&mut self, index: u32, kind: TriangleKind, color: Option<[f32; 3]>, mesh: &mut Mesh) -> u32 {
        let (from, at) = (self.triangles, index as usize);
        let place = &mut self.place_of[at];
        if *place == NOWHERE {
            *place = mesh.vertices.len() as u32;
            self.used.push(index);
            mesh.vertices.push(vector(from.positions[at]));
            mesh.normals.push(unit(vector(from.normals[at])).unwrap_or(Vec3::ZERO));
            if color.is_none() {
                mesh.colors.push(rgb(from.colors[at]));
            }
            if kind == TriangleKind::Textured {
                let [u, v] = from.texture[at].map(f64::from);
                mesh.texture.push(Vec3::new(u, v, 0.0));
            }
        }
        *place
    }
}

/// Triangles in runs of one color; `None` where the colors of a triangle differ, or runs are short.
fn runs<'a>(indices: &'a [u32], colors: &[[f32; 3]]) -> Option<Vec<([f32; 3], &'a [u32])>> {
    let color = |index: u32| colors[index as usize];
    let is_one = |corners: &[u32]| color(corners[0]) == color(corners[1]) && color(corners[0]) == color(corners[2]);
    if !indices.chunks_exact(3).all(is_one) {
        return None;
    }
    let mut runs = Vec::new();
    let mut start = 0;
    for end in (3..=indices.len()).step_by(3) {
        if end == indices.len() || color(indices[end]) != color(indices[start]) {
            runs.push((color(indices[start]), &indices[start..end]));
            start = end;
        }
    }
    (runs.len() == 1 || indices.len() / 3 >= runs.len() * TRIANGLES_A_SURFACE).then_some(runs)
}

fn rgb(numbers: [f32; 3]) -> Rgb {
    numbers.map(f64::from).into()
}
