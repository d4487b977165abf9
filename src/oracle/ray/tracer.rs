//! Tracer: finds what a ray meets, and the light that comes along it.
//!
//! Every object of the scene's tree is placed once. Polygons are kept in world space with the eye at the origin, shapes
//! where the file has them: there the ray is moved instead, which keeps its t.
//!
//! Facing: the front of a polygon is where its corners run counterclockwise; of a shape, the outside, or the inside where
//! the file says so. What faces away is not there, unless its surface is two-sided; then it is lit from the viewer's side.

use super::boxes::{Bounds, Boxes};
use super::camera::Eye;
use super::light::{Lighting, Point};
use super::solid::{Ray, bounds, cross, unknown};
use super::{Hit, Part, RayError, RayPicture, polygon};
use crate::color::Rgb;
use crate::math::{Affine3, Mat3, Vec3, edges, newell_normal};
use crate::plan::{Choices, Culling, Transparency};
use crate::scene::{Mesh, NormalSource, Primitive, Scene, SurfaceId};

/// A scene made ready for rays.
pub struct Tracer<'a> {
    scene: &'a Scene,
    choices: &'a Choices,
    eye: Eye,
    lighting: Lighting<'a>,
    placed: Vec<Placed>,
    items: Vec<Item>,
    boxes: Boxes,
    /// Something lets light through.
    has_layers: bool,
}

/// A surface of an object instance.
struct Placed {
    instance: u32,
    surface: SurfaceId,
    /// Corners of its mesh, world space, the eye at the origin.
    corners: Vec<Vec3>,
    /// Their unit normals on the front side; zero where there is none.
    normals: Vec<Vec3>,
    /// Leads from world directions to local ones.
    local_from_world: Mat3,
    /// Leads from local normals to world ones.
    world_normals: Mat3,
    /// The eye, local space.
    local_eye: Vec3,
    shows_backs: bool,
}

/// Something that a ray may meet.
struct Item {
    placed: u32,
    part: Part,
    /// Of a polygon: the normal of its front, world space.
    normal: Vec3,
}

/// A place where the ray meets an item.
#[derive(Clone, Copy)]
struct Met {
    t: f64,
    item: u32,
    /// Of the front, world space, not unit.
    normal: Vec3,
    back: bool,
}

impl<'a> Tracer<'a> {
    /// Makes `scene` ready.
    ///
    /// # Errors
    /// [`RayError`] when there is no usable camera, or a shape without an equation.
    pub fn new(scene: &'a Scene, choices: &'a Choices) -> Result<Tracer<'a>, RayError> {
        let eye = Eye::new(scene.camera.as_ref().ok_or(RayError::NoCamera)?, choices)?;
        let has_layers = scene.surfaces.iter().any(|surface| !surface.material.is_opaque());
        let lighting = Lighting::new(scene, choices);
        let (placed, items, boxes) = (Vec::new(), Vec::new(), Boxes::default());
        let mut tracer = Tracer { scene, choices, eye, lighting, placed, items, boxes, has_layers };
        let mut around = Vec::new();
        let (mut instance, mut unknown) = (0, None);
        scene.walk(|object| {
            for &surface in &object.object.surfaces {
                unknown = unknown.take().or(tracer.place(surface, instance, &object.world_from_local, &mut around));
            }
            instance += 1;
        })?;
        tracer.boxes = Boxes::new(&around);
        unknown.map_or(Ok(tracer), Err)
    }

    /// Adds a surface and the boxes around its parts, in the order of the file.
    fn place(&mut self, id: SurfaceId, instance: u32, at: &Affine3, around: &mut Vec<Bounds>) -> Option<RayError> {
        let surface = self.scene.surface(id);
        if !surface.mesh.colors.is_empty() {
            return Some(RayError::VertexColors { place: self.scene.describe(surface.place) });
        }
        if self.scene.picture_on(surface).is_some() {
            return Some(RayError::Picture { place: self.scene.describe(surface.place) });
        }
        let placed = Placed::new(self, id, instance, at);
        let number = self.placed.len() as u32;
        let mirror = if at.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        for index in 0..surface.mesh.polygons.len() as u32 {
            let corners: Vec<Vec3> = placed.outline(&surface.mesh, index).collect();
            let normal = newell_normal(&corners) * mirror;
            self.items.push(Item { placed: number, part: Part::Polygon(index), normal });
            around.push(Bounds::around(corners.into_iter()));
        }
        let solid = at.matrix3.determinant() != 0.0;
        for (index, primitive) in surface.primitives.iter().enumerate().filter(|_| solid) {
            if let Some(shape) = unknown(&primitive.shape) {
                let place = self.scene.describe(crate::scene::Place { line: primitive.line, ..surface.place });
                return Some(RayError::NotAnalytic { shape, place });
            }
            let (low, high) = bounds(&primitive.shape);
            let corner =
                |axes: u32| Vec3::from_array([0, 1, 2].map(|axis| [low, high][axes as usize >> axis & 1][axis]));
            let to_eye = |local: Vec3| at.matrix3 * local + (at.translation - self.eye.position);
            around.push(Bounds::around((0..8).map(|axes| to_eye(corner(axes)))));
            self.items.push(Item { placed: number, part: Part::Primitive(index as u32), normal: Vec3::ZERO });
        }
        self.placed.push(placed);
        None
    }

    /// Width and height of the picture in samples.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        self.eye.size
    }

    /// What the ray through the place (x, y), in samples, meets first; sample (i, j) has its center at (i + .5, j + .5).
    #[must_use]
    pub fn hit(&self, x: f64, y: f64) -> Option<Hit> {
        let direction = self.eye.ray(x, y);
        self.first(direction).map(|met| self.finish(&met, direction))
    }

    /// The light that comes through the place (x, y), transparent layers included, and what is met first.
    #[must_use]
    pub fn light(&self, x: f64, y: f64) -> (Rgb, Option<Hit>) {
        let direction = self.eye.ray(x, y);
        let met = if self.has_layers { self.all(direction) } else { self.first(direction).into_iter().collect() };
        let mut layers = Layers::new(self.choices.transparency);
        let mut nearest = None;
        for met in &met {
            let hit = self.finish(met, direction);
            nearest = nearest.or(Some(hit));
            let material = &self.scene.surface(hit.surface).material;
            let point = Point { place: hit.point, normal: hit.normal, to_eye: -direction.normalize() };
            layers.add(self.lighting.reflected(material, &point), material.opacity);
            if material.is_opaque() {
                return (layers.sum, nearest);
            }
        }
        layers.add(self.choices.encoding.decode(self.scene.background.unwrap_or(Rgb::BLACK)), Rgb::WHITE);
        (layers.sum, nearest)
    }

    /// Every sample.
    #[must_use]
    pub fn picture(&self) -> RayPicture {
        let (width, height) = self.eye.size;
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (f64::from(x) + 0.5, f64::from(y) + 0.5)));
        let (light, hits) = places.map(|(x, y)| self.light(x, y)).unzip();
        RayPicture { width, height, samples: self.choices.samples, light, hits }
    }

    fn first(&self, direction: Vec3) -> Option<Met> {
        let mut nearest: Option<Met> = None;
        self.boxes.walk(direction, (self.eye.hither, self.eye.yon), |item| {
            self.meet(item, direction, &mut |met| {
                // Equally near: the first in the file.
                if nearest.is_none_or(|nearest| (met.t, met.item) < (nearest.t, nearest.item)) {
                    nearest = Some(met);
                }
            });
            nearest.map_or(self.eye.yon, |nearest| nearest.t)
        });
        nearest
    }

    fn all(&self, direction: Vec3) -> Vec<Met> {
        let mut all = Vec::new();
        self.boxes.walk(direction, (self.eye.hither, self.eye.yon), |item| {
            self.meet(item, direction, &mut |met| all.push(met));
            self.eye.yon
        });
        all.sort_by(|a: &Met, b: &Met| a.t.total_cmp(&b.t).then(a.item.cmp(&b.item)));
        all
    }

    /// Calls `found` where the ray meets a visible side of an item, between hither and yon.
    fn meet(&self, index: u32, direction: Vec3, found: &mut dyn FnMut(Met)) {
        let item = &self.items[index as usize];
        let placed = &self.placed[item.placed as usize];
        let surface = self.scene.surface(placed.surface);
        let mut offer = |t: f64, normal: Vec3| {
            let towards = normal.dot(direction);
            // Seen exactly edge-on it covers nothing.
            let is_seen = towards < 0.0 || (towards > 0.0 && placed.shows_backs);
            if is_seen && t >= self.eye.hither && t <= self.eye.yon {
                found(Met { t, item: index, normal, back: towards > 0.0 });
            }
        };
        match item.part {
            Part::Polygon(number) => {
                let corners = placed.outline(&surface.mesh, number);
                if let Some(t) = polygon::meet(corners, item.normal, direction) {
                    offer(t, item.normal);
                }
            }
            Part::Primitive(number) => {
                let Primitive { shape, inside, .. } = &surface.primitives[number as usize];
                let ray = Ray { origin: placed.local_eye, direction: placed.local_from_world * direction };
                cross(shape, &ray, &mut |crossing| {
                    let front = if *inside { -crossing.normal } else { crossing.normal };
                    offer(crossing.t, placed.world_normals * front);
                });
            }
        }
    }

    fn finish(&self, met: &Met, direction: Vec3) -> Hit {
        let item = &self.items[met.item as usize];
        let placed = &self.placed[item.placed as usize];
        let mut normal = met.normal.normalize();
        if let Part::Polygon(number) = item.part {
            let mesh = &self.scene.surface(placed.surface).mesh;
            let smooth = placed.smooth_normal(mesh, number, met, direction);
            normal = smooth.and_then(Vec3::try_normalize).unwrap_or(normal);
        }
        Hit {
            depth: met.t,
            instance: placed.instance,
            surface: placed.surface,
            part: item.part,
            point: self.eye.position + direction * met.t,
            normal: if met.back { -normal } else { normal },
            back: met.back,
        }
    }
}

impl Placed {
    fn new(tracer: &Tracer<'_>, id: SurfaceId, instance: u32, at: &Affine3) -> Placed {
        let surface = tracer.scene.surface(id);
        // World minus eye first: both may be large and the detail small.
        let offset = at.translation - tracer.eye.position;
        let local_from_world = at.matrix3.inverse();
        // Perpendicular to a plane of mapped points, and on the same side of it also where the map mirrors.
        let world_normals = local_from_world.transpose();
        let normals =
            normals(&surface.mesh).into_iter().map(|n| (world_normals * n).try_normalize().unwrap_or(Vec3::ZERO));
        let shows_backs = surface.two_sided
            || match tracer.choices.culling {
                Culling::Back => false,
                Culling::Nff => !surface.material.is_opaque(),
                Culling::None => true,
            };
        Placed {
            instance,
            surface: id,
            corners: surface.mesh.vertices.iter().map(|&local| at.matrix3 * local + offset).collect(),
            normals: normals.collect(),
            local_from_world,
            world_normals,
            local_eye: -(local_from_world * offset),
            shows_backs,
        }
    }

    fn outline<'b>(&'b self, mesh: &'b Mesh, polygon: u32) -> impl Iterator<Item = Vec3> + Clone + 'b {
        mesh.outline(&mesh.polygons[polygon as usize]).iter().map(|&corner| self.corners[corner as usize])
    }

    /// The normal between those of the corners; `None` where the polygon's own counts. Corners without one have that, too.
    fn smooth_normal(&self, mesh: &Mesh, number: u32, met: &Met, direction: Vec3) -> Option<Vec3> {
        let polygon = &mesh.polygons[number as usize];
        if polygon.normals == NormalSource::Facet || self.normals.is_empty() {
            return None;
        }
        let face = met.normal.normalize();
        let own = |&corner: &u32| Some(self.normals[corner as usize]).filter(|&n| n != Vec3::ZERO).unwrap_or(face);
        let normals: Vec<Vec3> = mesh.outline(polygon).iter().map(own).collect();
        let corners: Vec<Vec3> = self.outline(mesh, number).collect();
        Some(polygon::blend(&corners, &normals, direction * met.t, newell_normal(&corners)))
    }
}

/// Local normals at the vertices of a mesh: given ones, else the mean of the faces around (SIPP's rule), else zero.
fn normals(mesh: &Mesh) -> Vec<Vec3> {
    let is_mean = |polygon: &crate::scene::Polygon| polygon.normals == NormalSource::Averaged;
    if mesh.normals.is_empty() && !mesh.polygons.iter().any(is_mean) {
        return Vec::new();
    }
    let mut sums = vec![Vec3::ZERO; mesh.vertices.len()];
    if mesh.polygons.iter().any(is_mean) {
        for polygon in &mesh.polygons {
            let outline = mesh.outline(polygon);
            let corners: Vec<Vec3> = outline.iter().map(|&corner| mesh.vertices[corner as usize]).collect();
            let face = newell_normal(&corners).try_normalize().unwrap_or(Vec3::ZERO);
            edges(outline).for_each(|(&corner, _)| sums[corner as usize] += face);
        }
    }
    for (sum, &given) in sums.iter_mut().zip(&mesh.normals) {
        if given != Vec3::ZERO {
            *sum = given;
        }
    }
    sums
}

/// Light of layers, the nearest first.
struct Layers {
    rule: Transparency,
    sum: Rgb,
    /// What shines through from behind, per channel.
    left: Rgb,
}

impl Layers {
    fn new(rule: Transparency) -> Layers {
        Layers { rule, sum: Rgb::BLACK, left: Rgb::WHITE }
    }

    fn add(&mut self, light: Rgb, opacity: Rgb) {
        // Over: a layer covers its part of what is left. SIPP: parts add up until nothing is left.
        let part = match self.rule {
            Transparency::Over => self.left * opacity,
            Transparency::Additive => {
                Rgb::new(opacity.r.min(self.left.r), opacity.g.min(self.left.g), opacity.b.min(self.left.b))
            }
        };
        self.sum += light * part;
        self.left = self.left - part;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn layers_by_hand() {
        for (rule, expected) in [(Transparency::Over, 0.5 + 0.25 * 2.0 + 0.25 * 4.0), (Transparency::Additive, 1.5)] {
            let mut layers = Layers::new(rule);
            layers.add(Rgb::gray(1.0), Rgb::gray(0.5));
            layers.add(Rgb::gray(2.0), Rgb::gray(0.5));
            layers.add(Rgb::gray(4.0), Rgb::WHITE);
            assert_eq!(layers.sum, Rgb::gray(expected));
        }
    }
}
