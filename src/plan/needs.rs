//! What a scene needs: derived from a survey of the scene, never chosen, and without effect on the picture.
//!
//! Space: boxes and spheres are tested in eye space, with a margin far above rounding: a plane is left out only when
//! nothing comes near it.

use super::{Accepts, Choices, Interpolation, PlanError, Shading, View};
use crate::math::{Affine3, Vec3};
use crate::model::bounding_ball;
use crate::scene::{Mesh, Reflection, Scene, Shape, Surface};

/// The planes of the view volume, in the order of clipping.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipPlane {
    /// The near plane.
    Hither,
    /// The left side of the picture.
    Left,
    /// The right side.
    Right,
    /// The lower side.
    Bottom,
    /// The upper side.
    Top,
    /// The far plane.
    Yon,
}

impl ClipPlane {
    /// All planes, in the order of clipping.
    pub const ALL: [ClipPlane; 6] =
        [ClipPlane::Hither, ClipPlane::Left, ClipPlane::Right, ClipPlane::Bottom, ClipPlane::Top, ClipPlane::Yon];

    /// The plane's name in messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["hither", "left", "right", "bottom", "top", "yon"][self as usize]
    }

    /// Its bit in an outcode.
    #[must_use]
    pub fn bit(self) -> u8 {
        1 << self as u8
    }

    /// Signed distance of an eye-space point, in no particular unit: 0 on the plane, above 0 inside.
    #[must_use]
    pub fn distance(self, eye: Vec3, view: &View) -> f64 {
        let (kx, ky) = view.clip_from_eye();
        match self {
            ClipPlane::Hither => eye.z - view.hither,
            ClipPlane::Left => eye.z + kx * eye.x,
            ClipPlane::Right => eye.z - kx * eye.x,
            ClipPlane::Bottom => eye.z + ky * eye.y,
            ClipPlane::Top => eye.z - ky * eye.y,
            ClipPlane::Yon => view.yon - eye.z,
        }
    }
}

/// When polygons are split into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Split {
    /// Never.
    None,
    /// Where a varying is not affine over a polygon.
    NotAffine,
    /// Always.
    All,
}

/// What the stages compute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// Bits of the planes that polygons are tested against, [`ClipPlane::bit`].
    pub clip: u8,
    /// Light is computed, and normals for it.
    pub light: bool,
    /// Highlights are computed on surfaces that have none, too.
    pub specular_everywhere: bool,
    /// Any highlight is computed at all.
    pub specular: bool,
    /// Fragments may be transparent: the target keeps lists.
    pub blending: bool,
    /// Depth planes are computed.
    pub depth: bool,
    /// Which polygons are split.
    pub split: Split,
    /// Polygons carry texture coordinates.
    pub texture: bool,
    /// Shapes outside the view are tessellated, too.
    pub shapes_outside: bool,
}

impl Needs {
    /// What `survey` asks for under `choices`.
    #[must_use]
    pub fn derive(survey: &Survey, choices: &Choices, accepts: Accepts) -> Needs {
        let wire = choices.shading == Shading::Wire;
        Needs {
            clip: survey.crossed,
            light: !wire,
            specular_everywhere: false,
            specular: !wire && survey.shiny_surfaces > 0 && choices.light_terms.specular,
            blending: !wire && survey.transparent_surfaces > 0,
            depth: !wire,
            split: split(choices, accepts, survey.textured_surfaces > 0),
            texture: !wire && survey.textured_surfaces > 0,
            shapes_outside: false,
        }
    }

    /// Everything, whether the scene needs it or not.
    #[must_use]
    pub fn full(choices: &Choices, accepts: Accepts) -> Needs {
        Needs {
            clip: 0b11_1111,
            light: true,
            specular_everywhere: true,
            specular: choices.light_terms.specular,
            blending: true,
            depth: true,
            // Where nothing has a picture all coordinates are 0, and nothing more is split.
            split: split(choices, accepts, true),
            texture: choices.shading != Shading::Wire,
            shapes_outside: true,
        }
    }
}

fn split(choices: &Choices, accepts: Accepts, textured: bool) -> Split {
    match (choices.triangles || accepts == Accepts::Triangles, choices.shading) {
        (true, _) => Split::All,
        // Values run along scan lines, over outlines of any number of corners.
        (false, _) if choices.interpolation == Interpolation::ScanLine => Split::None,
        (false, Shading::Gouraud | Shading::Phong) => Split::NotAffine,
        (false, Shading::Flat) if textured => Split::NotAffine,
        (false, Shading::Flat | Shading::Wire) => Split::None,
    }
}

/// What was counted in a scene, seen from a view.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Survey {
    /// Bits of the planes that some box or sphere comes near to or lies beyond.
    pub crossed: u8,
    /// How many boxes and spheres cross each plane.
    pub crossing: [usize; 6],
    /// Boxes of surfaces and spheres around shapes.
    pub volumes: usize,
    /// Placed surfaces with Ks > 0.
    pub shiny_surfaces: usize,
    /// Placed surfaces that are not opaque.
    pub transparent_surfaces: usize,
    /// Placed surfaces with a picture and polygons to wear it.
    pub textured_surfaces: usize,
    /// Those of them that have holes.
    pub cut_out_surfaces: usize,
    /// Placed surfaces that keep their back faces, whatever the culling.
    pub two_sided_surfaces: usize,
    /// Placed surfaces of SIPP's `phong`.
    pub phong_surfaces: usize,
    /// Placed surfaces of SIPP's `basic`.
    pub basic_surfaces: usize,
    /// Placed surfaces whose vertices have colors of their own.
    pub colored_surfaces: usize,
    /// Placed surfaces.
    pub surfaces: usize,
    /// Placed objects.
    pub objects: usize,
    /// Polygons of the files.
    pub polygons: usize,
    /// Those with more than three vertices.
    pub many_sided: usize,
    /// Vertices of the files, shared ones once.
    pub vertices: usize,
    /// Vertices of surfaces without a highlight.
    pub matte_vertices: usize,
    /// Shapes: spheres, cones and what SIPP has besides.
    pub shapes: usize,
    /// Those whose file says how finely they are cut up.
    pub shapes_with_resolution: usize,
    /// Those that lie outside the view.
    pub shapes_outside: usize,
    /// Lights.
    pub lights: usize,
    /// Lights with an intensity of their own.
    pub own_intensities: usize,
}

impl Survey {
    /// Walks the tree once and looks at every surface's box and every shape's sphere.
    ///
    /// # Errors
    /// [`PlanError::TooManyInstances`] for runaway instancing.
    pub fn new(scene: &Scene, view: &View) -> Result<Survey, PlanError> {
        let own_intensities = scene.lights.iter().filter(|light| light.intensity.is_some()).count();
        let mut survey = Survey { lights: scene.lights.len(), own_intensities, ..Survey::default() };
        scene.walk(|placed| {
            survey.objects += 1;
            for &id in &placed.object.surfaces {
                let surface = scene.surface(id);
                survey.count_surface(surface);
                survey.count_texture(surface, scene);
                survey.count_mesh(&surface.mesh, surface.material.specular > 0.0);
                survey.look_at_box(&surface.mesh, &placed.world_from_local, view);
                for primitive in &surface.primitives {
                    survey.shapes_with_resolution += usize::from(primitive.resolution.is_some());
                    survey.look_at_shape(&primitive.shape, &placed.world_from_local, view);
                }
            }
        })?;
        if view.yon.is_infinite() {
            survey.crossed &= !ClipPlane::Yon.bit();
        }
        Ok(survey)
    }

    fn count_surface(&mut self, surface: &Surface) {
        let material = &surface.material;
        self.surfaces += 1;
        self.shiny_surfaces += usize::from(material.specular > 0.0);
        self.transparent_surfaces += usize::from(!material.is_opaque());
        self.colored_surfaces += usize::from(!surface.mesh.colors.is_empty());
        self.two_sided_surfaces += usize::from(surface.two_sided);
        self.phong_surfaces += usize::from(material.reflection == Reflection::Phong);
        self.basic_surfaces += usize::from(matches!(material.reflection, Reflection::Basic { .. }));
    }

    fn count_texture(&mut self, surface: &Surface, scene: &Scene) {
        let Some((_, texture)) = scene.picture_on(surface) else { return };
        self.textured_surfaces += 1;
        self.cut_out_surfaces += usize::from(texture.has_holes());
    }

    fn count_mesh(&mut self, mesh: &Mesh, shiny: bool) {
        self.polygons += mesh.polygons.len();
        self.many_sided += mesh.polygons.iter().filter(|polygon| polygon.count > 3).count();
        self.vertices += mesh.vertices.len();
        self.matte_vertices += if shiny { 0 } else { mesh.vertices.len() };
    }

    fn look_at_box(&mut self, mesh: &Mesh, world_from_local: &Affine3, view: &View) {
        let Some(&first) = mesh.vertices.first() else { return };
        let (low, high) = mesh.vertices.iter().fold((first, first), |(low, high), &v| (low.min(v), high.max(v)));
        let corners: [Vec3; 8] = std::array::from_fn(|corner| {
            let pick = |bit: usize, low: f64, high: f64| if corner & bit == 0 { low } else { high };
            let local = Vec3::new(pick(1, low.x, high.x), pick(2, low.y, high.y), pick(4, low.z, high.z));
            view.to_eye(world_from_local.transform_point3(local))
        });
        self.volumes += 1;
        for plane in ClipPlane::ALL {
            // The margin is far above the rounding of a distance. Its negation also catches NaN.
            let clear = corners.iter().all(|&eye| plane.distance(eye, view) > margin(eye, view));
            self.note(plane, !clear);
        }
    }

    fn look_at_shape(&mut self, shape: &Shape, world_from_local: &Affine3, view: &View) {
        self.shapes += 1;
        self.volumes += 1;
        let (center, radius) = placed_bound(shape, world_from_local, view);
        let mut outside = false;
        for plane in ClipPlane::ALL {
            let (distance, reach) = distance_and_reach(plane, center, radius, view);
            let clear = distance - reach > margin(center, view);
            outside |= distance + reach < -margin(center, view);
            self.note(plane, !clear);
        }
        self.shapes_outside += usize::from(outside);
    }

    fn note(&mut self, plane: ClipPlane, crossing: bool) {
        self.crossing[plane as usize] += usize::from(crossing);
        self.crossed |= if crossing { plane.bit() } else { 0 };
    }
}

/// Whether a placed shape lies wholly beyond one plane of the view volume, by more than rounding.
#[must_use]
pub fn is_outside(shape: &Shape, world_from_local: &Affine3, view: &View) -> bool {
    let (center, radius) = placed_bound(shape, world_from_local, view);
    ClipPlane::ALL.into_iter().any(|plane| {
        let (distance, reach) = distance_and_reach(plane, center, radius, view);
        distance + reach < -margin(center, view)
    })
}

/// A sphere around a placed shape, eye space.
fn placed_bound(shape: &Shape, world_from_local: &Affine3, view: &View) -> (Vec3, f64) {
    let ball = bounding_ball(shape).transformed(world_from_local);
    (view.to_eye(ball.center), ball.radius)
}

/// The signed distance of a sphere's center and how far the sphere reaches, in the same unit.
fn distance_and_reach(plane: ClipPlane, center: Vec3, radius: f64, view: &View) -> (f64, f64) {
    let (kx, ky) = view.clip_from_eye();
    let gradient = match plane {
        ClipPlane::Hither | ClipPlane::Yon => 1.0,
        ClipPlane::Left | ClipPlane::Right => (1.0 + kx * kx).sqrt(),
        ClipPlane::Bottom | ClipPlane::Top => (1.0 + ky * ky).sqrt(),
    };
    (plane.distance(center, view), radius * gradient)
}

/// A distance below this counts as near: 2^-30 of the numbers the distance was computed from.
fn margin(eye: Vec3, view: &View) -> f64 {
    let (kx, ky) = view.clip_from_eye();
    (eye.x.abs() * kx + eye.y.abs() * ky + eye.z.abs() + view.hither) * 1e-9
}
