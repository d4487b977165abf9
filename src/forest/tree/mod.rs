//! Tree: a small area of forest as one scene, every tree an object.
//!
//! Cells -TREE (growth, ground, quads, pictures)-> Scene -> plan, geometry, any rasterizer, lab, `--dump-stage scene`
//!
//! area -> cell -> ground, lines, stands -> trees. A tree is an object of its own with a transform of its own (its foot, its turn, crown
//! and height as scales), and all trees that wear one picture share one surface: two quads that cross. Landmarks are objects without
//! surfaces: a name and a place.
//!
//! Why only small areas: an object takes some 200 bytes, and 95,000 ha hold thirty million trees. Whoever walks through such an area
//! sees the cells around himself only; this tree is for looking at a scene as a whole, part by part, with all that farop can tell of scenes.
//!
//! Space: world metres, x east, y north, z up, from the south-west corner of cell (0, 0).
//! Source: A. Falcao, M. Prospero dos Santos, Landscaper 2.0: crossed quads, one texture for each species and form.
//! Cost: one object a tree; 2 x 64 x 64 triangles for a cell whose ground has several covers.

mod error;
mod ground;
mod growth;
mod lines;
mod pictures;
mod quads;
mod view;

pub use error::TreeError;

use super::area::{Cell, CellIndex, Head};
use super::cells::Cells;
use super::objects::{Models, stand};
use crate::math::{Affine3, Vec3};
use crate::scene::{Camera, Object, ObjectId, Place, Scene, Surface, SurfaceId};
use ground::Land;
use pictures::Pictures;
use std::collections::BTreeMap;
use std::path::Path;

/// The most trees of one scene tree: 100 MB of objects.
pub const MOST_TREES: usize = 500_000;
/// The most cells of one scene tree.
pub const MOST_CELLS: usize = 2_000;

/// An area as a scene, and what there is to tell about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Grown {
    /// Objects, surfaces, a sun and a sky.
    pub scene: Scene,
    /// Where it is seen from if nobody says otherwise: from above the south, all of it.
    pub camera: Camera,
    /// How many trees there are.
    pub trees: usize,
}

/// The scene of all cells in a year (`None`: the first of every stand); pictures are looked for in `folder`, objects among `models`.
///
/// # Errors
/// [`TreeError`]: more trees or cells than [`MOST_TREES`] and [`MOST_CELLS`], a picture or a cell that cannot be read.
pub fn scene(cells: &Cells, (folder, models): (&Path, &Models), year: Option<i32>) -> Result<Grown, TreeError> {
    let loaded = load(cells, year)?;
    let head = cells.head();
    let mut builder = Builder {
        head,
        year,
        land: Land::new(head, &loaded, year),
        pictures: Pictures::new(head, folder),
        scene: Scene { files: head.files.clone(), ..Scene::default() },
        trees: 0,
    };
    let area = builder.object("area", Affine3::IDENTITY, Place::default());
    builder.scene.world.push(area);
    for cell in loaded.values() {
        let object = builder.cell(cell)?;
        builder.child(area, object);
    }
    for mark in &head.marks {
        let foot = Vec3::new(mark.at[0], mark.at[1], builder.land.height(mark.at).unwrap_or_default());
        let object = builder.object(&mark.name, Affine3::from_translation(foot), mark.place);
        builder.child(area, object);
    }
    let stood = stand(head, models, |place| builder.land.height(place))?;
    let Builder { mut scene, land, pictures, trees, .. } = builder;
    scene.textures = pictures.textures;
    scene.merge(stood.scene);
    // In the one tree: what stands on the area is part of it.
    let stood = scene.world.split_off(1);
    scene.objects[area.0 as usize].children.extend(stood);
    let camera = view::camera(&land);
    scene.lights.push(view::sun());
    scene.background = Some(view::SKY);
    Ok(Grown { scene, camera, trees })
}

/// All cells, if they are not too many.
fn load(cells: &Cells, year: Option<i32>) -> Result<BTreeMap<CellIndex, Cell>, TreeError> {
    let indices = cells.indices();
    if indices.len() > MOST_CELLS {
        return Err(TreeError::TooManyCells { cells: indices.len() });
    }
    let (mut loaded, mut trees) = (BTreeMap::new(), 0.0);
    for index in indices {
        let Some(cell) = cells.load(index)? else { continue };
        trees += growth::expected(&cell, year);
        if trees > MOST_TREES as f64 {
            return Err(TreeError::TooManyTrees { trees });
        }
        loaded.insert(index, cell);
    }
    Ok(loaded)
}

/// A scene in the making.
struct Builder<'a> {
    head: &'a Head,
    year: Option<i32>,
    land: Land<'a>,
    pictures: Pictures<'a>,
    scene: Scene,
    trees: usize,
}

impl Builder<'_> {
    fn object(&mut self, name: &str, parent_from_local: Affine3, place: Place) -> ObjectId {
        let (surfaces, children) = (Vec::new(), Vec::new());
        self.scene.objects.push(Object { name: name.to_string(), parent_from_local, surfaces, children, place });
        ObjectId(self.scene.objects.len() as u32 - 1)
    }

    fn child(&mut self, parent: ObjectId, child: ObjectId) {
        self.scene.objects[parent.0 as usize].children.push(child);
    }

    fn surface(&mut self, object: ObjectId, surface: Surface) {
        self.scene.surfaces.push(surface);
        let id = SurfaceId(self.scene.surfaces.len() as u32 - 1);
        self.scene.objects[object.0 as usize].surfaces.push(id);
    }

    fn cell(&mut self, cell: &Cell) -> Result<ObjectId, TreeError> {
        let [column, row] = cell.index;
        let corner = Affine3::from_translation(self.head.corner(cell.index));
        let object = self.object(&format!("cell {column} {row}"), corner, cell.place);
        for (cover, mesh) in self.land.meshes(cell) {
            let material = self.pictures.ground(cover)?;
            self.surface(
                object,
                Surface { material, mesh, primitives: Vec::new(), two_sided: false, place: cell.place },
            );
        }
        for line in &cell.lines {
            let mesh = lines::strip(&self.land, cell, line);
            if !mesh.polygons.is_empty() {
                let material = lines::material(&line.kind);
                let strip = self.object(&line.kind, Affine3::IDENTITY, line.place);
                self.child(object, strip);
                let place = line.place;
                self.surface(strip, Surface { material, mesh, primitives: Vec::new(), two_sided: true, place });
            }
        }
        self.grow(cell, object)?;
        Ok(object)
    }

    /// The trees of a cell, those of a stand below one object.
    fn grow(&mut self, cell: &Cell, object: ObjectId) -> Result<(), TreeError> {
        let mut groves: BTreeMap<Option<u32>, ObjectId> = BTreeMap::new();
        for tree in growth::trees(self.head, cell, self.year, &self.land)? {
            let grove = match groves.get(&tree.stand) {
                Some(&grove) => grove,
                None => {
                    let name = tree.stand.map_or("measured trees".to_string(), |number| format!("stand {number}"));
                    let grove = self.object(&name, Affine3::IDENTITY, tree.place);
                    self.child(object, grove);
                    groves.insert(tree.stand, grove);
                    grove
                }
            };
            let surface = self.pictures.tree(&tree, &mut self.scene.surfaces)?;
            let code = &self.head.species[usize::from(tree.species)].code;
            let child = self.object(code, quads::placed(&tree), tree.place);
            self.scene.objects[child.0 as usize].surfaces.push(surface);
            self.child(grove, child);
            self.trees += 1;
        }
        Ok(())
    }
}
