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
//! | `dress` | textures and materials |
//! | `sink` | surfaces in memory that frames share |
//!
//! Space: world metres, x east, y north, z up, from the south-west corner of cell (0, 0).
//! Source: A. Falcão, M. Próspero dos Santos, "Visualização de paisagens florestais"; `docs/forest-frames.md` teaches each step and has
//! the figures.

mod choices;
mod dress;
mod land;
mod sink;
mod trees;

pub use choices::{Choices, FrameCounts, FrameError, GroundLook, Trees};
pub use dress::SUN;

use super::cells::Cells;
use super::frustum::{Frustum, focal};
use super::pictures::Pictures;
use super::relief::criterion::Observer;
use super::terrain::Terrain;
use super::terrain::relief::{Faces, View};
use super::window::Stock;
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
        Ok(Composer { cells, choices, pictures, terrain, stock, dress, scene, sink, faces, order, lists })
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
        self.sink.surfaces = std::mem::take(&mut self.scene.surfaces);
        self.sink.clear(self.dress.pictures() * KEYS);
        self.scene.textures.truncate(self.dress.textures.len());
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
        counts.surfaces = u64::from(count);
        Ok((&self.scene, counts))
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
        lander.add(&self.faces, &mut self.lists, &mut self.sink, &mut self.scene.textures, counts);
        Ok(())
    }
}
