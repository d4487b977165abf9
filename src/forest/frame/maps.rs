//! Maps: a map on the ground of a frame, as surfaces of its own.
//!
//! ground surfaces, shapes -MAPS-> the same surfaces again, wearing the map, in front of them in the list
//!
//! Why the land twice: ground has pictures or colors of its own, and a map hides them where it has something to show. A surface on the same
//! corners has the same depth to the last bit, and of two equal depths the first in the list is kept; where the map has a hole, the ground shows. So every
//! rasterizer draws maps, and none knows it.
//!
//! Space: world metres; u and v from 0 to 1 over a square around the area. Cost: the polygons of the ground once more, and the drawing of the map.

use super::dress::ground_material;
use super::sink::Sink;
use super::{Choices, FrameError};
use crate::forest::area::Head;
use crate::forest::cells::Cells;
use crate::forest::drape::{Drape, Method, Texels, View};
use crate::forest::map::{Exact, MapError, Shape, draw};
use crate::image::textures::{self, FirstRow, Lookup};
use crate::math::{Mat3, Vec3};
use crate::scene::{Camera, CutOut, Material, Mesh, Scene, Surface, SurfaceId, Texture, TextureId};
use std::sync::Arc;

/// How a map lies on the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Laying {
    /// By a texture of so many texels each way, drawn anew for every frame.
    Drawn(Method, u32),
    /// Asked at every sample.
    Exact,
}

/// What a frame's map was like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapFigures {
    /// How many texels a pixel got.
    pub texels: Texels,
    /// How far behind what can be seen the map's perspective had its center; `None`: it had none.
    pub strength: Option<f64>,
}

/// A map that lies on the ground of all frames.
pub struct GroundMap {
    shapes: Vec<Shape>,
    laying: Laying,
    /// A square around the area: south-west corner and side.
    square: ([f64; 2], f64),
    exact: Option<Lookup>,
    /// Of the last frame; `None`: nothing was drawn.
    pub figures: Option<MapFigures>,
}

/// The cells of an area, from corner to corner in metres.
fn reach(cells: &Cells) -> Option<[[f64; 2]; 2]> {
    let head: &Head = cells.head();
    let corners = cells.indices().into_iter().map(|index| head.corner(index));
    let (low, high) = corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), corner| {
        (low.min(corner), high.max(corner + Vec3::new(head.side, head.side, 0.0)))
    });
    (low.x < high.x).then_some([[low.x, low.y], [high.x, high.y]])
}

impl GroundMap {
    /// Shapes of the view `name`, the lowest first, on the area of `cells`.
    pub(super) fn new(cells: &Cells, name: &str, shapes: Vec<Shape>, laying: Laying) -> Result<GroundMap, FrameError> {
        let Some(reach) = reach(cells) else { return Err(FrameError::Map(elsewhere(name, [[0.0; 2]; 2], &[]))) };
        GroundMap::within(reach, name, shapes, laying).map_err(FrameError::Map)
    }

    /// Shapes of the view `name`, the lowest first, on land between two corners.
    ///
    /// # Errors
    /// [`MapError::Elsewhere`].
    pub fn within(
        [low, high]: [[f64; 2]; 2],
        name: &str,
        shapes: Vec<Shape>,
        laying: Laying,
    ) -> Result<GroundMap, MapError> {
        let is_near = |[x, y]: [f64; 2]| x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1];
        if !shapes.iter().any(|shape| spans(shape, [low, high]) || shape.positions().any(is_near)) {
            return Err(elsewhere(name, [low, high], &shapes));
        }
        let square = (low, (high[0] - low[0]).max(high[1] - low[1]));
        let exact =
            (laying == Laying::Exact).then(|| Lookup::Computed(Arc::new(Exact::new(&shapes, square.0, square.1))));
        Ok(GroundMap { shapes, laying, square, exact, figures: None })
    }

    /// Puts the ground's surfaces, those from number `first` on, behind the same ones that wear the map.
    pub(super) fn lay(
        &mut self,
        (camera, size, choices): (&Camera, (u32, u32), &Choices),
        first: usize,
        sink: &mut Sink,
        textures: &mut Vec<Texture>,
    ) {
        let ground = sink.surfaces.split_off(first);
        if let Some(texture) = self.texture(camera, size, (choices.horizon, &ground)) {
            let id = TextureId(textures.len() as u32);
            textures.push(texture);
            for surface in &ground {
                let mesh = sink.surface(ground_material(Some(id)), surface.two_sided);
                mesh.clone_from(&surface.mesh);
                self.put_on(mesh);
            }
        }
        sink.surfaces.extend(ground);
    }

    /// Puts all surfaces of a scene of one object, a relief, behind the same ones that wear the map.
    pub fn wear(&mut self, scene: &mut Scene, camera: &Camera) {
        let Some([low, high]) = land(&scene.surfaces) else { return };
        let corner =
            |axis: fn(Vec3) -> f64| (axis(low) - axis(camera.from)).abs().max((axis(high) - axis(camera.from)).abs());
        let horizon = Vec3::new(corner(|at| at.x), corner(|at| at.y), corner(|at| at.z)).length();
        let Some(texture) = self.texture(camera, camera.resolution, (horizon, &scene.surfaces)) else { return };
        let id = TextureId(scene.textures.len() as u32);
        scene.textures.push(texture);
        let material = Material { diffuse: 1.0, texture: Some(id), ..Material::default() };
        let worn = scene.surfaces.iter().map(|surface| {
            let mut worn = Surface { material, ..surface.clone() };
            self.put_on(&mut worn.mesh);
            worn
        });
        let worn: Vec<Surface> = worn.collect();
        scene.surfaces.splice(0..0, worn);
        let count = scene.surfaces.len() as u32;
        scene.objects.iter_mut().for_each(|object| object.surfaces = (0..count).map(SurfaceId).collect());
    }

    /// Places on the map for the vertices of a mesh, in place of whatever it wore.
    fn put_on(&self, mesh: &mut Mesh) {
        mesh.colors.clear();
        mesh.texture.clear();
        let (corner, side) = (Vec3::new(self.square.0[0], self.square.0[1], 0.0), self.square.1);
        mesh.texture.extend(mesh.vertices.iter().map(|vertex| ((*vertex - corner) / side).with_z(0.0)));
    }

    fn texture(&mut self, camera: &Camera, size: (u32, u32), ground: (f64, &[Surface])) -> Option<Texture> {
        let worn = |texels, lookup| Texture {
            lookup: Some(lookup),
            cut_out: Some(CutOut { threshold: 0.5 }),
            ..Texture::cut_out("map", texels, 0.5)
        };
        let (method, side) = match self.laying {
            Laying::Exact => return Some(worn(one_texel()?, self.exact.clone()?)),
            Laying::Drawn(method, side) => (method, side),
        };
        let view = View::of_camera(camera, size, ground.0, land(ground.1)?);
        let outlines = ground.1.iter().flat_map(|Surface { mesh, .. }| {
            mesh.polygons
                .iter()
                .map(|polygon| mesh.outline(polygon).iter().map(|&at| mesh.vertices[at as usize]).collect())
        });
        let faces: Vec<Vec<Vec3>> = outlines.collect();
        let (drape, texels) = Drape::on_land(method, &view, side, faces.iter().map(Vec::as_slice))?;
        self.figures = Some(MapFigures { texels, strength: drape.strength });
        let texels = draw(&self.shapes, &drape, side, &|place| view.metres_a_pixel(place))?;
        let ([x, y], width) = self.square;
        let ground_from_place = Mat3::from_cols(Vec3::X * width, Vec3::Y * width, Vec3::new(x, y, 1.0));
        Some(worn(texels, Lookup::Projected(drape.texture_from_ground * ground_from_place)))
    }
}

/// The box around the land that is drawn.
fn land(ground: &[Surface]) -> Option<[Vec3; 2]> {
    let vertices = ground.iter().flat_map(|surface| &surface.mesh.vertices);
    let (low, high) =
        vertices.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), &vertex| (low.min(vertex), high.max(vertex)));
    // A plain has a height, too.
    (low.x < high.x && low.y < high.y).then_some([low - Vec3::Z, high + Vec3::Z])
}

fn one_texel() -> Option<textures::Texels> {
    textures::Texels::new(1, 1, vec![[0; 4]], FirstRow::AtV0)
}

/// Whether the box around a shape and that of the area have something in common.
fn spans(shape: &Shape, [low, high]: [[f64; 2]; 2]) -> bool {
    let (from, to) = bounds(std::slice::from_ref(shape));
    (0..2).all(|axis| from[axis] <= high[axis] && to[axis] >= low[axis])
}

fn bounds(shapes: &[Shape]) -> ([f64; 2], [f64; 2]) {
    let positions = shapes.iter().flat_map(Shape::positions);
    positions.fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), |(low, high), [x, y]| {
        ([low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)])
    })
}

fn elsewhere(name: &str, [low, high]: [[f64; 2]; 2], shapes: &[Shape]) -> MapError {
    let (map_low, map_high) = bounds(shapes);
    let whole = |place: [f64; 2]| place.map(|along| along.round() as i64);
    let is_swapped = (0..2).all(|axis| map_low[1 - axis] <= high[axis] && map_high[1 - axis] >= low[axis]);
    let advice = match (shapes.is_empty(), is_swapped) {
        (true, _) => "; no object fits its themes",
        (false, true) => "; are its axes swapped?",
        (false, false) => "; is its `crs` the right one, and the area's `crs` and `origin`?",
    };
    MapError::Elsewhere {
        view: name.to_string(),
        from: whole(low),
        to: whole(high),
        map_from: whole(map_low),
        map_to: whole(map_high),
        advice,
    }
}
