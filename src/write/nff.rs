//! A whole scene as NFF: one list of polygons, spheres and cones in world coordinates.
//!
//! Scene -WRITE NFF-> text
//!
//! Why world coordinates: NFF has no transforms. Numbers keep all their bits, so an untransformed scene reads back as it was;
//! a transformed one as it was placed. What NFF cannot say is returned as notices, never dropped in silence.
//!
//! Source: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987. Cost: linear; memory of the largest surface.

use super::annotation;
use super::losses::Losses;
use super::number::write_number;
use crate::color::Rgb;
use crate::math::{Affine3, Mat3, Vec3, unit};
use crate::model::segments::similarity_scale;
use crate::model::{Detail, mirrors, normals_from, polygon_normal, tessellate, vertex_normals};
use crate::scene::{
    Camera, Light, LightSource, Material, Mesh, NormalSource, Placed, Polygon, Primitive, Reflection, Scene, Shape,
    Surface,
};
use std::io::{self, Write};

/// Segments of spheres and cones that are no longer spheres and cones where they stand and so are written as polygons.
pub const POLYGONIZED_SEGMENTS: u32 = 64;

/// Writes `scene` as NFF and returns, one sentence each, what NFF could not say.
///
/// Order: `b`, `v`, all `l`, then the surfaces of the objects, parents before children, each with its `f` and its polygons and primitives in
/// the order of the file. Polygons with averaged or given normals become `pp`, the others `p`. Opacity becomes T = 1 - opacity.
/// A sphere or cone that its transform stretches unequally becomes polygons of [`POLYGONIZED_SEGMENTS`] segments, and a notice says so;
/// so does a disc that no longer faces +z.
///
/// What farop can draw and NFF cannot say stands in comments that begin with `#farop`, for farop to read back: intensities, `phong`, ambient
/// coefficients, opacity per channel, two sides. Directional lights and spots become point lights, `basic` becomes `phong`.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidData`] for a number that is infinite or not a number and for a scene with too many instances.
pub fn write_nff(scene: &Scene, out: &mut dyn Write) -> io::Result<Vec<String>> {
    let mut writer =
        Writer { out, losses: Losses::default(), normals: Vec::new(), line: Vec::new(), polygonized: Mesh::default() };
    if let Some(background) = scene.background {
        writer.entity("b", &background.to_array())?;
    }
    match &scene.camera {
        Some(camera) => writer.camera(camera)?,
        None => writer.losses.no_camera = true,
    }
    scene.lights.iter().try_for_each(|light| writer.light(light, scene.camera.as_ref()))?;

    // The walk cannot be left early; after an error nothing more is written.
    let mut result = Ok(());
    scene
        .walk(|placed| {
            if result.is_ok() {
                result = writer.object(scene, &placed);
            }
        })
        .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))?;
    result.map(|()| writer.losses.notices())
}

/// How one object instance leads to world space.
struct Placement {
    world_from_local: Affine3,
    /// Carries normals; their length is not kept.
    normals: Mat3,
    mirrored: bool,
    /// The linear part is the identity: normals stay as they are, to the bit.
    unturned: bool,
}

impl Placement {
    fn normal(&self, local: Vec3) -> Vec3 {
        if self.unturned { local } else { unit(self.normals * local).unwrap_or(Vec3::ZERO) }
    }
}

struct Writer<'a> {
    out: &'a mut dyn Write,
    losses: Losses,
    /// Normals that light the vertices of the surface in hand.
    normals: Vec<Vec3>,
    /// The line in hand.
    line: Vec<u8>,
    /// Polygons of the shape in hand.
    polygonized: Mesh,
}

impl Writer<'_> {
    fn entity(&mut self, keyword: &str, numbers: &[f64]) -> io::Result<()> {
        write!(self.out, "{keyword}")?;
        self.numbers(numbers)
    }

    /// Blank-separated numbers up to the end of the line.
    fn numbers(&mut self, numbers: &[f64]) -> io::Result<()> {
        numbers.iter().try_for_each(|&number| write_number(self.out, number))?;
        writeln!(self.out)
    }

    fn camera(&mut self, camera: &Camera) -> io::Result<()> {
        self.losses.yon = camera.yon.is_some();
        writeln!(self.out, "v")?;
        self.entity("from", &camera.from.to_array())?;
        self.entity("at", &camera.at.to_array())?;
        self.entity("up", &camera.up.to_array())?;
        self.entity("angle", &[camera.angle])?;
        self.entity("hither", &[camera.hither])?;
        let (width, height) = camera.resolution;
        writeln!(self.out, "resolution {width} {height}")
    }

    fn light(&mut self, light: &Light, camera: Option<&Camera>) -> io::Result<()> {
        let position = match light.source {
            LightSource::Point { position } => position,
            LightSource::Spot { position, .. } => {
                self.losses.spots += 1;
                position
            }
            LightSource::Directional { to_light } => {
                self.losses.directional_lights += 1;
                far_away(to_light, camera)
            }
        };
        if let Some(intensity) = light.intensity {
            self.losses.lights_in_comments += 1;
            annotation::write_light(self.out, intensity)?;
        }
        let ([x, y, z], [r, g, b]) = (position.to_array(), light.color.to_array());
        if light.color == Rgb::WHITE { self.entity("l", &[x, y, z]) } else { self.entity("l", &[x, y, z, r, g, b]) }
    }

    fn object(&mut self, scene: &Scene, placed: &Placed<'_>) -> io::Result<()> {
        let world_from_local = placed.world_from_local;
        self.losses.objects += 1;
        self.losses.names += usize::from(!placed.object.name.is_empty());
        self.losses.placed_objects += usize::from(world_from_local != Affine3::IDENTITY);
        let Some(normals) = normals_from(&world_from_local) else {
            self.losses.flattened_objects += 1;
            return Ok(());
        };
        let mirrored = mirrors(&world_from_local);
        let unturned = world_from_local.matrix3 == Mat3::IDENTITY;
        let placement = Placement { world_from_local, normals, mirrored, unturned };
        placed.object.surfaces.iter().try_for_each(|&id| self.surface(scene.surface(id), &placement))
    }

    fn surface(&mut self, surface: &Surface, placement: &Placement) -> io::Result<()> {
        if surface.mesh.polygons.is_empty() && surface.primitives.is_empty() {
            return Ok(());
        }
        self.losses.colored_surfaces += usize::from(!surface.mesh.colors.is_empty());
        self.losses.textured_surfaces += usize::from(!surface.mesh.texture.is_empty());
        self.losses.surfaces_in_comments += usize::from(annotation::write_surface(self.out, surface)?);
        self.material(&surface.material)?;
        // Merge polygons and primitives back into the order of the file. Primitives stand in the order of `before`.
        vertex_normals(&surface.mesh, &[NormalSource::Averaged], &mut self.normals);
        let mut primitives = surface.primitives.iter().peekable();
        for (index, polygon) in surface.mesh.polygons.iter().enumerate() {
            while let Some(primitive) = primitives.next_if(|primitive| primitive.before as usize <= index) {
                self.primitive(primitive, placement)?;
            }
            self.polygon(&surface.mesh, polygon, placement)?;
        }
        primitives.try_for_each(|primitive| self.primitive(primitive, placement))
    }

    fn material(&mut self, material: &Material) -> io::Result<()> {
        let Rgb { r, g, b } = material.opacity;
        // One T: equal channels are taken as they are, the sum of three thirds would round.
        let opacity = if r == g && g == b { r } else { (r + g + b) / 3.0 };
        self.losses.basic_surfaces += usize::from(matches!(material.reflection, Reflection::Basic { .. }));
        let material = annotation::as_phong(material);
        let [red, green, blue] = material.color.to_array();
        let reflection = [material.diffuse, material.specular, material.shine, 1.0 - opacity, material.refraction];
        write!(self.out, "f")?;
        [red, green, blue].iter().try_for_each(|&channel| write_number(self.out, channel))?;
        self.numbers(&reflection)
    }

    fn polygon(&mut self, mesh: &Mesh, polygon: &Polygon, placement: &Placement) -> io::Result<()> {
        let own = placement.normal(polygon_normal(mesh, polygon).unwrap_or(Vec3::ZERO));
        let keyword = if polygon.normals == NormalSource::Facet { "p" } else { "pp" };
        writeln!(self.out, "{keyword} {}", polygon.count)?;
        let outline = mesh.outline(polygon);
        for step in 0..outline.len() {
            // A mirror turns the outline about; its first vertex stays the first.
            let index =
                outline[if placement.mirrored { (outline.len() - step) % outline.len() } else { step }] as usize;
            let normal = match polygon.normals {
                NormalSource::Facet => None,
                NormalSource::Averaged | NormalSource::Given => Some(self.normals.get(index)),
            };
            let position = placement.world_from_local.transform_point3(mesh.vertices[index]);
            self.vertex(
                position,
                normal.map(|given| match given {
                    Some(&given) if given != Vec3::ZERO => placement.normal(given),
                    _ => own,
                }),
            )?;
        }
        Ok(())
    }

    fn vertex(&mut self, position: Vec3, normal: Option<Vec3>) -> io::Result<()> {
        // A line starts with a number, not with the blank before it.
        self.line.clear();
        let numbers = position.to_array().into_iter().chain(normal.into_iter().flat_map(|normal| normal.to_array()));
        for number in numbers {
            write_number(&mut self.line, number)?;
        }
        self.line.push(b'\n');
        self.out.write_all(&self.line[1..])
    }

    fn primitive(&mut self, primitive: &Primitive, placement: &Placement) -> io::Result<()> {
        let Some(shape) = moved(&primitive.shape, placement) else {
            return self.polygonized(primitive, placement);
        };
        let sign = if primitive.inside { -1.0 } else { 1.0 };
        match shape {
            Shape::Sphere { center, radius } => self.entity("s", &[center.x, center.y, center.z, sign * radius]),
            Shape::Cone { base, base_radius, apex, apex_radius } => {
                let ends = [(base, base_radius), (apex, apex_radius)];
                let [base, apex] = ends.map(|(center, radius)| [center.x, center.y, center.z, sign * radius]);
                self.entity("c", &[base, apex].concat())
            }
            _ => self.polygonized(primitive, placement),
        }
    }

    fn polygonized(&mut self, primitive: &Primitive, placement: &Placement) -> io::Result<()> {
        self.losses.polygonized_shapes += 1;
        let mut mesh = std::mem::take(&mut self.polygonized);
        mesh.clear();
        let detail = Detail::Segments(POLYGONIZED_SEGMENTS);
        tessellate(&primitive.shape, primitive.inside, detail, primitive.line, &mut mesh);
        // The shape's normals take the place of the surface's until it is written.
        let of_surface = std::mem::take(&mut self.normals);
        vertex_normals(&mesh, &[NormalSource::Averaged], &mut self.normals);
        let result = mesh.polygons.iter().try_for_each(|polygon| self.polygon(&mesh, polygon, placement));
        self.normals = of_surface;
        self.polygonized = mesh;
        result
    }
}

/// Where a point light stands for a directional one: a billion times as far from the middle of the picture as the eye is, so that over
/// anything in the picture its direction changes by less than the last digit of a color.
fn far_away(to_light: Vec3, camera: Option<&Camera>) -> Vec3 {
    let (middle, distance) = camera.map_or((Vec3::ZERO, 1.0), |camera| (camera.at, (camera.at - camera.from).length()));
    middle + unit(to_light).unwrap_or(Vec3::Z) * (distance.max(f64::MIN_POSITIVE) * 1e9)
}

/// The shape in world space; `None` where it is none that NFF has a word for.
fn moved(shape: &Shape, placement: &Placement) -> Option<Shape> {
    let scale = if placement.unturned { 1.0 } else { similarity_scale(&placement.world_from_local)? };
    let point = |local: Vec3| placement.world_from_local.transform_point3(local);
    match *shape {
        Shape::Sphere { center, radius } => Some(Shape::Sphere { center: point(center), radius: radius * scale }),
        Shape::Cone { base, base_radius, apex, apex_radius } => {
            // A disc faces +z in every file: turned elsewhere it has no word. Two ends that only rounding joins are a disc too.
            let (base_in_world, apex_in_world) = (point(base), point(apex));
            let faces_up = (placement.normal(Vec3::Z) - Vec3::Z).length() < 1e-9;
            let says_the_same = if base == apex { faces_up } else { base_in_world != apex_in_world };
            says_the_same.then_some(Shape::Cone {
                base: base_in_world,
                base_radius: base_radius * scale,
                apex: apex_in_world,
                apex_radius: apex_radius * scale,
            })
        }
        _ => None,
    }
}

#[cfg(test)]
#[path = "nff_tests.rs"]
mod tests;
