//! Frame: the forest around an observer, as one scene.
//!
//! Cells, Pictures, camera -FRAME-> Scene, counts -> plan, geometry, any rasterizer
//!
//! Why a scene a frame: a forest is then nothing special to anybody. Every rasterizer, a student's too, draws it; the checks and the lab take it
//! like any other scene.
//!
//! A frame is a function of area, choices and camera: what was seen before changes nothing but the time it takes. Playing a path twice, or
//! from its middle, gives equal scenes.
//!
//! | File | What is in it |
//! |---|---|
//! | `choices` | what may be chosen, and what is counted |
//! | `trees` | from records of 8 bytes to polygons |
//! | `land` | faces of the relief as surfaces |
//! | `maps` | a map on them |
//! | `dress` | textures and materials |
//! | `sink` | surfaces in memory that frames share |
//!
//! Space: world metres, x east, y north, z up, from the south-west corner of cell (0, 0).
//! Source: A. Falcão, M. Próspero dos Santos, "Visualização de paisagens florestais"; `docs/forest-frames.md` teaches each step and has
//! the figures.

mod choices;
mod dress;
mod land;
mod maps;
mod sink;
mod trees;

pub use choices::{Choices, FrameCounts, FrameError, GroundLook, Trees};
pub use dress::SUN;
pub use maps::{GroundMap, Laying, MapFigures};

use super::cells::Cells;
use super::frustum::{Frustum, focal};
use super::heights::Heights;
use super::map::Shape;
use super::objects::{Models, Stood, stand};
use super::pictures::Pictures;
use super::relief::criterion::Observer;
use super::terrain::Terrain;
use super::terrain::relief::{Faces, View};
use super::window::{Stock, StockError};
use crate::color::Rgb;
use crate::math::{Affine3, Vec3};
use crate::scene::{Camera, Object, ObjectId, Place, Scene, SurfaceId};
use dress::{Dress, KEYS, sun};
use land::{Lander, Lists};
use sink::Sink;
use trees::{Eye, Order, Planter};

/// Makes the scene of a frame, again and again.
pub struct Composer<'a> {
    cells: &'a Cells,
    choices: Choices,
    pictures: Pictures,
    terrain: Terrain,
    stock: Stock,
    dress: Dress,
    scene: Scene,
    sink: Sink,
    faces: Faces,
    order: Order,
    lists: Lists,
    map: Option<GroundMap>,
    stood: Stood,
}

impl<'a> Composer<'a> {
    /// Surveys the area.
    ///
    /// # Errors
    /// A choice is no number to work with; the area is empty, too large or cannot be read.
    pub fn new(cells: &'a Cells, pictures: Pictures, choices: Choices) -> Result<Composer<'a>, FrameError> {
        choices.check()?;
        let terrain = Terrain::with_covers(cells, choices.year, &pictures, choices.cover_tolerance)?;
        let head = cells.head();
        let stock = Stock::new(head, choices.year, (choices.horizon, choices.buffer), choices.prefetch);
        let dress = Dress::new(head, &pictures, choices.threshold);
        let scene = Scene {
            files: vec!["forest".to_string()],
            objects: vec![Object {
                name: "forest".to_string(),
                parent_from_local: Affine3::IDENTITY,
                surfaces: Vec::new(),
                children: Vec::new(),
                place: Place::default(),
            }],
            textures: dress.textures.clone(),
            world: vec![ObjectId(0)],
            lights: vec![sun()],
            background: Some(Rgb::new(0.72, 0.82, 0.92)),
            ..Scene::default()
        };
        let (sink, faces, order, lists) = (Sink::default(), Faces::default(), Order::default(), Lists::default());
        let (map, stood) = (None, Stood::default());
        Ok(Composer { cells, choices, pictures, terrain, stock, dress, scene, sink, faces, order, lists, map, stood })
    }

    /// Stands the area's objects on its ground, from now on.
    ///
    /// # Errors
    /// One cannot stand, or a cell cannot be read.
    pub fn stand_objects(&mut self, models: &Models) -> Result<(), FrameError> {
        let (mut heights, mut failed) = (Heights::default(), None);
        let stood = stand(self.cells.head(), models, |place| {
            heights.at(self.cells, place).unwrap_or_else(|error| {
                failed = Some(error);
                None
            })
        });
        if let Some(error) = failed {
            return Err(StockError::from(error).into());
        }
        self.stood = stood?.behind(self.dress.textures.len());
        self.scene.objects.truncate(1);
        self.scene.textures.truncate(self.dress.textures.len());
        self.scene.textures.append(&mut self.stood.scene.textures);
        Ok(())
    }

    /// Lays the view `name` of a map on the ground of all further frames: its shapes, in metres of the area, the lowest first.
    ///
    /// # Errors
    /// Nothing of it lies on the area.
    pub fn lay_map(&mut self, name: &str, shapes: Vec<Shape>, laying: Laying) -> Result<(), FrameError> {
        self.map = Some(GroundMap::new(self.cells, name, shapes, laying)?);
        Ok(())
    }

    /// How sharp the map of the last frame was; `None` where none was drawn, or none of the land was in view.
    #[must_use]
    pub fn map_figures(&self) -> Option<MapFigures> {
        self.map.as_ref()?.figures
    }

    /// The land that it draws.
    #[must_use]
    pub fn terrain(&self) -> &Terrain {
        &self.terrain
    }

    /// What was chosen.
    #[must_use]
    pub fn choices(&self) -> &Choices {
        &self.choices
    }

    /// Chooses the trees, the tolerance and what else needs no other cells anew: year, horizon, buffer and borders of covers stay.
    ///
    /// # Errors
    /// A choice is no number to work with.
    pub fn choose(&mut self, choices: Choices) -> Result<(), FrameError> {
        choices.check()?;
        let Choices { year, horizon, buffer, prefetch, threshold, cover_tolerance, .. } = self.choices;
        self.choices = Choices { year, horizon, buffer, prefetch, threshold, cover_tolerance, ..choices };
        Ok(())
    }

    /// Metres within which every wrong cover of the last frame's near ground is from a border; `None` where no borders are kept.
    #[must_use]
    pub fn border_error(&self) -> Option<f64> {
        self.faces.border_error
    }

    /// Bytes of memory: terrain, cells, pictures, and the scene of the last frame.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let meshes = self.scene.surfaces.iter().map(|surface| {
            let mesh = &surface.mesh;
            24 * (mesh.vertices.capacity() + mesh.normals.capacity() + mesh.texture.capacity() + mesh.colors.capacity())
                + 4 * mesh.outlines.capacity()
                + 16 * mesh.polygons.capacity()
        });
        self.terrain.bytes() + self.stock.bytes() + self.pictures.bytes() + meshes.sum::<usize>()
    }

    /// The scene that `camera` sees, for a picture of `size` pixels.
    ///
    /// # Errors
    /// A cell cannot be read or has too many trees.
    pub fn compose(&mut self, camera: &Camera, size: (u32, u32)) -> Result<(&Scene, FrameCounts), FrameError> {
        let camera = Camera { resolution: size, ..*camera };
        let mut counts = FrameCounts::default();
        self.scene.camera = Some(camera);
        self.take_objects_away();
        self.sink.surfaces = std::mem::take(&mut self.scene.surfaces);
        self.sink.clear(self.dress.pictures() * KEYS);
        // A camera nowhere sees nothing; the plan says what is wrong with it.
        let is_somewhere = camera.from.is_finite() && camera.at.is_finite() && camera.up.is_finite();
        if is_somewhere && camera.angle > 0.0 && camera.angle < 180.0 {
            self.fill(&camera, size, &mut counts)?;
        }
        self.scene.surfaces = std::mem::take(&mut self.sink.surfaces);
        let count = self.scene.surfaces.len() as u32;
        let surfaces = &mut self.scene.objects[0].surfaces;
        surfaces.clear();
        surfaces.extend((0..count).map(SurfaceId));
        self.put_objects(&camera, size);
        counts.surfaces = self.scene.surfaces.len() as u64;
        Ok((&self.scene, counts))
    }

    /// What stands on the area goes behind what was made for this frame, as far as it is in view.
    fn put_objects(&mut self, camera: &Camera, size: (u32, u32)) {
        let Stood { scene, balls, .. } = &mut self.stood;
        let (surfaces, objects) = (self.scene.surfaces.len() as u32, self.scene.objects.len() as u32);
        self.scene.surfaces.append(&mut scene.surfaces);
        for object in &mut scene.objects {
            object.surfaces.iter_mut().for_each(|id| id.0 += surfaces);
            object.children.iter_mut().for_each(|id| id.0 += objects);
        }
        self.scene.objects.append(&mut scene.objects);
        self.scene.facing = scene.facing.iter().map(|id| ObjectId(id.0 + objects)).collect();
        let frustum = Frustum::of_camera(camera, focal(camera, size), size);
        let in_view = scene.world.iter().zip(balls).filter(|(_, (center, radius))| {
            let distance = (*center - camera.from).length() - *radius;
            distance < self.choices.horizon && frustum.sees(*center, *radius)
        });
        self.scene.world.extend(in_view.map(|(id, _)| ObjectId(id.0 + objects)));
    }

    /// The other way round, before the next frame.
    fn take_objects_away(&mut self) {
        let own = self.scene.objects[0].surfaces.len();
        let count = self.scene.objects.len() as u32 - 1;
        let Stood { scene, .. } = &mut self.stood;
        if count > 0 {
            scene.surfaces = self.scene.surfaces.split_off(own);
            scene.objects = self.scene.objects.split_off(1);
            for object in &mut scene.objects {
                object.surfaces.iter_mut().for_each(|id| id.0 -= own as u32);
                object.children.iter_mut().for_each(|id| id.0 -= 1);
            }
        }
        self.scene.world.truncate(1);
        let textures = scene.surfaces.iter().filter_map(|surface| surface.material.texture).map(|id| id.0 + 1).max();
        self.scene.textures.truncate(textures.map_or(0, |count| count as usize).max(self.dress.textures.len()));
    }

    fn fill(&mut self, camera: &Camera, size: (u32, u32), counts: &mut FrameCounts) -> Result<(), FrameError> {
        let head = self.cells.head();
        let eye = camera.from;
        counts.loaded = self.stock.follow(self.cells, &self.terrain, &self.pictures, eye)? as u64;
        counts.cells = self.stock.cells().count() as u64;
        let focal = focal(camera, size);
        if self.choices.trees != Trees::None {
            let right = (camera.at - eye).cross(camera.up).with_z(0.0);
            let eye = Eye {
                at: eye,
                frustum: Frustum::of_camera(camera, focal, size),
                focal,
                right: crate::math::unit(right).unwrap_or(Vec3::X),
            };
            let (choices, terrain, stock, dress) = (&self.choices, &self.terrain, &self.stock, &self.dress);
            let planter = Planter { head, choices, terrain, stock, dress, eye };
            planter.plant(&mut self.order, &mut self.sink, counts);
        }
        let Choices { horizon: near, tolerance, ground: look, .. } = self.choices;
        let view = View { observer: Observer::new(camera, size), tolerance, near };
        self.terrain.faces(&view, &mut self.faces);
        let lander = Lander { head, stock: &self.stock, look, eye: (eye, near) };
        let first = self.sink.surfaces.len();
        lander.add(&self.faces, &mut self.lists, &mut self.sink, &mut self.scene.textures, counts);
        if let Some(map) = &mut self.map {
            map.lay((camera, size, &self.choices), first, &mut self.sink, &mut self.scene.textures);
        }
        Ok(())
    }
}
