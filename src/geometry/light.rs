//! Light: what varies over a polygon, at its corners.
//!
//! cull, clip -> LIGHT -> split, project
//!
//! Gouraud: the color at every vertex, computed once per shared vertex and side. Flat: one color, the light at the
//! polygon's first vertex with the face's normal (`--flat sipp`: the first that clipping leaves, the mean normal). Phong: the normal; light is for the rasterizer to compute.
//! A facet (NFF's `p`) has its own normal at all corners, so its vertices are lit per polygon.
//!
//! Space: eye space; normals are turned to the side that the eye sees.
//! Source: Gouraud, "Continuous Shading of Curved Surfaces", IEEE Transactions on Computers C-20(6), 1971.

use super::Part;
use super::cull::Survivor;
use super::project::Corner;
use super::walk::{EyeMesh, Side};
use crate::color::Rgb;
use crate::math::{Vec3, cos, radians, unit};
use crate::plan::{ClipLight, FlatRule, Interpolation, Plan, Shading};
use crate::scene::{Light, LightSource, Material, NormalSource, Place, Reflection, Scene};
use crate::screen::Shader;
use crate::screen::shader::{BRIGHTEST, EyeLight, EyeSource, Spot, SurfaceShading};

/// The choices that lighting depends on.
pub(super) struct Lighting {
    shading: Shading,
    needed: bool,
    /// Surfaces may let light through.
    blending: bool,
    /// Highlights are.
    specular: bool,
    /// Cut vertices are lit anew.
    relight: bool,
    /// One color a polygon, from the mean normal at the first vertex that clipping leaves.
    sipp_flat: bool,
    /// One color a polygon, from the first vertex's own normal.
    vertex_flat: bool,
    /// Where light comes after clipping, and vertices have colors, these are carried beside normals until then.
    carries_factors: bool,
    /// Values run linearly on the screen.
    screen: bool,
    ambient: f64,
    plan: LightPlan,
}

/// What lighting computed; each thread counts for itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct LightWork {
    /// Vertices lit.
    pub vertices: u64,
    /// Highlights computed.
    pub powers: u64,
}

struct LightPlan {
    encoding: crate::color::Encoding,
    terms: crate::plan::LightTerms,
}

impl Lighting {
    pub fn new(plan: &Plan) -> Lighting {
        let choices = &plan.choices;
        let relight = choices.clip_light == ClipLight::Relight && choices.shading == Shading::Gouraud;
        let sipp_flat = choices.flat == FlatRule::Sipp;
        let lit_late = relight || sipp_flat || choices.shading == Shading::Phong;
        Lighting {
            shading: choices.shading,
            needed: plan.needs.light,
            // Lines hide what they cross, whatever they are made of.
            blending: plan.needs.blending && choices.shading != Shading::Wire,
            specular: plan.needs.specular,
            relight,
            sipp_flat,
            vertex_flat: choices.flat == FlatRule::Vertex,
            carries_factors: lit_late && plan.survey.colored_surfaces > 0,
            screen: choices.interpolation != Interpolation::Perspective,
            ambient: plan.ambient,
            plan: LightPlan { encoding: choices.encoding, terms: choices.light_terms },
        }
    }

    /// Puts the lights of the scene into the shader, in eye space.
    pub fn prepare(&self, scene: &Scene, plan: &Plan, shader: &mut Shader) {
        shader.clear();
        shader.specular_everywhere = plan.needs.specular_everywhere;
        // Lines have no color of their own: white on a dark background, black on a bright one.
        let background = scene.background.unwrap_or(Rgb::BLACK);
        let bright = background.r + background.g + background.b > 1.5;
        shader.line_color = Rgb::gray(if bright { 0.0 } else { 1.0 });
        if !self.needed {
            return;
        }
        shader.lights.extend(scene.lights.iter().map(|light| eye_light(light, plan)));
    }

    /// Adds a surface to the shader, its colors decoded and multiplied, and returns its index there.
    pub fn push_surface(&self, material: &Material, place: Place, shader: &mut Shader) -> u32 {
        let color = self.plan.encoding.decode(material.color).map(|light| light.min(BRIGHTEST));
        let terms = self.plan.terms;
        let on = |term: bool, value: f64| if term { value.min(BRIGHTEST) } else { 0.0 };
        let ambient = material.ambient.unwrap_or(self.ambient * material.diffuse);
        // SIPP's `basic` has no diffuse coefficient.
        let is_basic = matches!(material.reflection, Reflection::Basic { .. });
        let diffuse = if is_basic { 1.0 } else { material.diffuse };
        shader.surfaces.push(SurfaceShading {
            reflection: material.reflection,
            ambient: color * on(terms.ambient, ambient),
            diffuse: color * on(terms.diffuse, diffuse),
            specular: on(terms.specular && self.specular, material.specular),
            shine: material.shine,
            // Where nothing needs blending the target never keeps a list.
            texture: None,
            opacity: if self.blending { material.opacity.to_f32() } else { Rgb::gray(1.0) },
            place,
        });
        (shader.surfaces.len() - 1) as u32
    }

    /// Whether the light of a vertex is one for all polygons around it: computed once, by [`EyeMesh::ask`].
    pub fn lights_vertices(&self) -> bool {
        self.needed && !self.is_one_color() && !self.carries_normals()
    }

    /// Whether corners carry factors on the color beside what varies.
    pub fn carries_factors(&self) -> bool {
        self.carries_factors
    }

    /// What the color of the surface is multiplied with at a vertex, if the mesh says so; linear light.
    #[inline]
    pub fn factor(&self, part: Part<'_>, vertex: u32) -> Option<Rgb> {
        part.mesh.colors.get(vertex as usize).map(|&color| self.plan.encoding.decode(color))
    }

    /// The light of a vertex of `part` that was asked for, at this point with this normal.
    #[inline]
    pub fn vertex_light(
        &self,
        (part, shader): (Part<'_>, &Shader),
        vertex: u32,
        point: (Vec3, Vec3),
        work: &mut LightWork,
    ) -> [f64; 3] {
        work.light(shader, part.shading, point, self.factor(part, vertex)).to_array()
    }

    /// One color a polygon, by the normal of its face or of its first vertex.
    pub fn is_one_color(&self) -> bool {
        self.shading == Shading::Flat && !self.sipp_flat
    }

    /// Whether triangles may be shared: light belongs to the vertices of the scene, and there is some.
    pub fn can_share(&self) -> bool {
        self.needed && !(self.relight || self.sipp_flat)
    }

    /// Corners carry normals through clipping: light is for later.
    pub fn carries_normals(&self) -> bool {
        self.relight || self.sipp_flat || self.shading == Shading::Phong
    }

    /// Writes what varies at the corners of a polygon, `outline` in its mesh, into `corners`.
    #[inline(always)]
    pub fn light_corners(
        &self,
        (part, mesh, shader): (Part<'_>, &EyeMesh, &Shader),
        survivor: &Survivor,
        (outline, corners): (&[u32], &mut [Corner]),
        work: &mut LightWork,
    ) {
        if !self.needed {
            return;
        }
        let facing = survivor.facing;
        let mut light = |vertex: u32, normal| {
            self.vertex_light((part, shader), vertex, (mesh.positions[vertex as usize], normal), work)
        };
        // SIPP knows no facets: polygons of one surface share their normals.
        let is_facet = part.mesh.polygons[survivor.polygon as usize].normals == NormalSource::Facet && !self.sipp_flat;
        let (carries_normals, side) = (self.carries_normals(), Side::of(survivor));
        if self.is_one_color() {
            let own = if self.vertex_flat && !is_facet { mesh.normal(outline[0]) } else { None };
            let normal = own.map_or_else(|| facing.normal_towards_eye(), |normal| side.turn(normal));
            let color = light(outline[0], normal);
            corners.iter_mut().for_each(|corner| corner.values = color);
            return;
        }
        let mut face_normal = None;
        for (corner, &index) in corners.iter_mut().zip(outline) {
            let own = if is_facet { None } else { mesh.normal(index) };
            let mut normal = || match own {
                Some(normal) => side.turn(normal),
                None => *face_normal.get_or_insert_with(|| facing.normal_towards_eye()),
            };
            corner.values = match own {
                _ if carries_normals => normal().to_array(),
                Some(_) => mesh.light(index, side),
                None => light(index, normal()),
            };
            if self.carries_factors {
                corner.factor = self.factor(part, index).unwrap_or(Rgb::WHITE).to_array();
            }
        }
    }

    /// How many numbers a vertex carries through clipping: factors stand behind the place of texture coordinates.
    pub fn carried(&self) -> usize {
        match (self.needed, self.carries_factors) {
            (false, _) => 0,
            (true, false) => 3,
            (true, true) => 8,
        }
    }

    /// FAROP's order: lights the corners that are left after clipping, from their normals; SIPP's flat shading the first.
    #[inline]
    pub fn relight(&self, surface: u32, clipped: &mut [Corner], shader: &Shader, work: &mut LightWork) {
        if !(self.relight || self.sipp_flat) || !self.needed {
            return;
        }
        let mut light = |corner: &Corner| {
            let normal = unit(Vec3::from_array(corner.values)).unwrap_or(Vec3::NEG_Z);
            let factor = self.carries_factors.then(|| corner.factor.into());
            work.light(shader, surface, (corner.ready.eye, normal), factor).to_array()
        };
        if self.sipp_flat {
            let color = light(&clipped[0]);
            clipped.iter_mut().for_each(|corner| corner.values = color);
        } else {
            clipped.iter_mut().for_each(|corner| corner.values = light(corner));
        }
    }

    /// Whether values belong to the clipped vertices rather than to those of the scene.
    pub fn belongs_to_clipped(&self) -> bool {
        self.relight || self.sipp_flat || self.screen
    }

    /// Whether what varies is linear over the polygon: all values equal, or three vertices before clipping.
    #[inline(always)]
    pub fn is_affine(&self, before: &[Corner], clipped: &[Corner]) -> bool {
        // Lit anew, or linear on the screen, the pieces of a triangle are not; else clipping changes nothing.
        let decided_on = if self.belongs_to_clipped() { clipped } else { before };
        let numbers = |corner: &Corner| (corner.values, corner.place, corner.factor);
        decided_on.len() == 3 || decided_on.windows(2).all(|pair| numbers(&pair[0]) == numbers(&pair[1]))
    }
}

impl LightWork {
    /// The light of a point with a normal, eye space, where the color of the surface is multiplied with `factor`.
    #[inline]
    fn light(&mut self, shader: &Shader, surface: u32, point: (Vec3, Vec3), factor: Option<Rgb>) -> Rgb {
        self.vertices += 1;
        shader.light_at(surface, point, factor, &mut self.powers)
    }
}

/// A light of the scene in eye space, its color times its own intensity or else the plan's.
fn eye_light(light: &Light, plan: &Plan) -> EyeLight {
    let view = &plan.view;
    // A direction that is none points along the view: it lights what the eye sees.
    let direction = |world: Vec3| unit(view.eye_from_world * world).unwrap_or(Vec3::Z);
    let source = match light.source {
        LightSource::Point { position } => EyeSource::Point { position: view.to_eye(position) },
        LightSource::Directional { to_light } => EyeSource::Directional { to_light: direction(to_light) },
        LightSource::Spot { position, at, opening, edge } => EyeSource::Spot(Spot {
            position: view.to_eye(position),
            axis: direction(at - position),
            cosine: cos(radians(opening) / 2.0),
            edge,
        }),
    };
    let color = light.color * light.intensity.unwrap_or(plan.light_intensity);
    EyeLight { source, color: color.map(|light| light.min(BRIGHTEST)) }
}
