//! Land of a frame: faces of the relief as surfaces, one a cell nearby and one for all that is far.
//!
//! Faces, stocked cells -LAND-> surfaces of the scene
//!
//! Nearby a cell wears the pictures of its covers, chosen sample by sample ([`Mosaic`](crate::image::textures::Mosaic)): borders of stands and
//! roads are where they are, whatever triangles there are. Where borders are kept, a triangle wears the one picture of its cover instead, without roads. Far land has one color a corner: that of its ground, or of the crowns over it. Normals
//! are those of the samples, so that light does not change when triangles do.

use super::choices::{FrameCounts, GroundLook};
use super::dress::ground_material;
use super::sink::{Sink, add_corner};
use crate::forest::area::{CellIndex, Ground, Head};
use crate::forest::terrain::relief::{Corner, Face, Faces, distance_to_cell};
use crate::forest::window::{Stock, Stocked};
use crate::image::textures::{FirstRow, Mosaic};
use crate::math::{Vec3, newell_normal};
use crate::scene::{Mesh, NormalSource, Texture, TextureId};

/// What land is drawn of.
pub(super) struct Lander<'a> {
    pub head: &'a Head,
    pub stock: &'a Stock,
    pub look: GroundLook,
    /// The eye, and metres to the horizon.
    pub eye: (Vec3, f64),
}

/// Lists that frames share.
#[derive(Default)]
pub(super) struct Lists {
    /// Faces by cell: those without one last.
    order: Vec<(Option<CellIndex>, Option<u8>, u32)>,
    /// Index + 1 of each corner in the surface in hand, and those that are not 0.
    local: Vec<u32>,
    used: Vec<u32>,
}

impl Lander<'_> {
    /// Adds all faces; pictures of grounds are added to `textures`.
    pub fn add(
        &self,
        faces: &Faces,
        lists: &mut Lists,
        sink: &mut Sink,
        textures: &mut Vec<Texture>,
        counts: &mut FrameCounts,
    ) {
        counts.terrain_polygons += faces.faces.len() as u64;
        lists.local.resize(lists.local.len().max(faces.corners.len()), 0);
        let mut order = std::mem::take(&mut lists.order);
        order.clear();
        let is_worn = |cell: &CellIndex| self.look == GroundLook::Pictures && self.stock.at(*cell).is_some();
        let numbered = faces.faces.iter().enumerate();
        order.extend(numbered.map(|(at, face)| {
            let cell = face.cell.filter(is_worn);
            (cell, cell.and(face.cover), at as u32)
        }));
        order.sort_unstable();
        for group in order.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let cell = group[0].0.and_then(|index| self.stock.at(index));
            let texture = cell.map(|cell| match group[0].1 {
                Some(cover) => only(cell, cover, textures),
                None => worn(cell, textures),
            });
            let mesh = sink.surface(ground_material(texture), false);
            for &(_, _, at) in group {
                self.face(faces, &faces.faces[at as usize], cell, mesh, lists);
            }
            lists.used.drain(..).for_each(|at| lists.local[at as usize] = 0);
        }
        lists.order = order;
        self.meshes(sink, textures, counts);
    }

    fn face(&self, faces: &Faces, face: &Face, cell: Option<&Stocked>, mesh: &mut Mesh, lists: &mut Lists) {
        let start = mesh.outlines.len() as u32;
        for &at in faces.outline(face) {
            let local = &mut lists.local[at as usize];
            if *local == 0 {
                let Corner { position, normal, color } = faces.corners[at as usize];
                let place = cell.map(|cell| self.place(cell, position));
                *local = add_corner(mesh, (position, normal), place.is_none().then_some(color), place) + 1;
                lists.used.push(at);
            }
            mesh.outlines.push(*local - 1);
        }
        let (count, normals) = (face.count, NormalSource::Given);
        mesh.polygons.push(crate::scene::Polygon { start, count, line: 0, normals });
    }

    /// Where a world position is in the picture of its cell.
    fn place(&self, cell: &Stocked, position: Vec3) -> Vec3 {
        let corner = self.head.corner(cell.cell.index);
        Vec3::new((position.x - corner.x) / self.head.side, (position.y - corner.y) / self.head.side, 0.0)
    }

    /// Adds the cells that are meshes as they are.
    fn meshes(&self, sink: &mut Sink, textures: &mut Vec<Texture>, counts: &mut FrameCounts) {
        for stocked in self.stock.cells() {
            let Ground::Mesh { vertices, triangles } = &stocked.cell.ground else { continue };
            if distance_to_cell(stocked.cell.index, self.head.side, self.eye.0) >= self.eye.1 {
                continue;
            }
            let texture = worn(stocked, textures);
            let mesh = sink.surface(ground_material(Some(texture)), false);
            let corner = self.head.corner(stocked.cell.index);
            mesh.vertices.extend(vertices.iter().map(|vertex| corner + *vertex));
            mesh.texture.extend(vertices.iter().map(|vertex| Vec3::new(vertex.x, vertex.y, 0.0) / self.head.side));
            for (corners, _) in triangles {
                let positions = corners.map(|corner| vertices.get(corner as usize).copied());
                let [Some(a), Some(b), Some(c)] = positions else { continue };
                // Of no area: nothing shows it.
                if newell_normal(&[a, b, c]) != Vec3::ZERO {
                    mesh.push_polygon(corners, NormalSource::Averaged, 0);
                    counts.terrain_polygons += 1;
                }
            }
        }
    }
}

/// Adds the picture of a cell's ground.
fn worn(cell: &Stocked, textures: &mut Vec<Texture>) -> TextureId {
    textures.push(cell.ground.clone());
    TextureId((textures.len() - 1) as u32)
}

/// Adds the picture of one cover of a cell's ground, repeated over all of the cell.
fn only(cell: &Stocked, cover: u8, textures: &mut Vec<Texture>) -> TextureId {
    let tile = cell.ground.mosaic.as_ref().and_then(|mosaic| mosaic.tiles().get(usize::from(cover)).cloned());
    match tile.and_then(|tile| Mosaic::new((1, 1), vec![0], FirstRow::AtV0, vec![tile])) {
        Some(mosaic) => {
            textures.push(Texture::mosaic("ground", mosaic));
            TextureId((textures.len() - 1) as u32)
        }
        None => worn(cell, textures),
    }
}
