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

use super::clip::ClipVertex;
use super::walk::EyeMesh;
use super::wear::place_of;
use super::{Corners, Facing, Part};
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
    /// Values run linearly on the screen.
    screen: bool,
    ambient: f64,
    plan: LightPlan,
    /// How many vertices were lit.
    pub vertices_lit: u64,
}

struct LightPlan {
    encoding: crate::color::Encoding,
    terms: crate::plan::LightTerms,
}

impl Lighting {
    pub fn new(plan: &Plan) -> Lighting {
        let choices = &plan.choices;
        Lighting {
            shading: choices.shading,
            needed: plan.needs.light,
            // Lines hide what they cross, whatever they are made of.
            blending: plan.needs.blending && choices.shading != Shading::Wire,
            specular: plan.needs.specular,
            relight: choices.clip_light == ClipLight::Relight && choices.shading == Shading::Gouraud,
            sipp_flat: choices.flat == FlatRule::Sipp,
            screen: choices.interpolation != Interpolation::Perspective,
            ambient: plan.ambient,
            plan: LightPlan { encoding: choices.encoding, terms: choices.light_terms },
            vertices_lit: 0,
        }
    }

    /// Puts the lights of the scene into the shader, in eye space.
    pub fn prepare(&self, scene: &Scene, plan: &Plan, shader: &mut Shader) {
        *shader = Shader::default();
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
            opacity: if self.blending { material.opacity.to_f32() } else { Rgb::gray(1.0) },
            texture: None,
            place,
        });
        (shader.surfaces.len() - 1) as u32
    }

    /// Writes what varies at the corners into `corners.clip`, and tells how many numbers clipping must carry along.
    pub fn light_corners(
        &mut self,
        part: Part<'_>,
        eye_mesh: &mut EyeMesh,
        (source, facing): (NormalSource, Facing),
        corners: &mut Corners,
        shader: &mut Shader,
    ) -> usize {
        corners.clip.clear();
        corners.clip.resize(corners.eye.len(), ClipVertex::default());
        if !self.needed {
            return 0;
        }
        let face_normal = facing.normal_towards_eye();
        if self.shading == Shading::Flat && !self.sipp_flat {
            let color = self.light(shader, part.shading, corners.eye[0], face_normal);
            corners.clip.iter_mut().for_each(|vertex| write(vertex, color.to_array()));
            return 3;
        }
        for (corner, vertex) in corners.clip.iter_mut().enumerate() {
            let index = corners.outline[corner] as usize;
            let own = eye_mesh.normals.get(index).copied().filter(|&normal| normal != Vec3::ZERO);
            // SIPP knows no facets: polygons of one surface share their normals.
            let shared = own.filter(|_| source != NormalSource::Facet || self.sipp_flat);
            let normal = shared.map_or(face_normal, |normal| if facing.is_back() { -normal } else { normal });
            if self.relight || self.sipp_flat || self.shading == Shading::Phong {
                write(vertex, normal.to_array());
                continue;
            }
            // Light a shared vertex once for each side it is seen from.
            let side = usize::from(facing.is_back());
            let known = shared.and_then(|_| eye_mesh.lit[side][index]);
            let color = known.unwrap_or_else(|| self.light(shader, part.shading, corners.eye[corner], normal));
            if shared.is_some() {
                eye_mesh.lit[side][index] = Some(color);
            }
            write(vertex, color.to_array());
        }
        3
    }

    /// FAROP's order: lights the vertices that are left after clipping, from their normals; SIPP's flat shading the first.
    pub fn relight(&mut self, surface: u32, clipped: &mut [ClipVertex], (kx, ky): (f64, f64), shader: &mut Shader) {
        if !(self.relight || self.sipp_flat) || !self.needed {
            return;
        }
        let only_first = self.sipp_flat;
        let mut light = |vertex: &ClipVertex| {
            let eye = Vec3::new(vertex.position.x / kx, vertex.position.y / ky, vertex.position.z);
            let [x, y, z, ..] = vertex.attributes;
            let normal = unit(Vec3::new(x, y, z)).unwrap_or(Vec3::NEG_Z);
            self.light(shader, surface, eye, normal).to_array()
        };
        if only_first {
            let color = light(&clipped[0]);
            clipped.iter_mut().for_each(|vertex| write(vertex, color));
        } else {
            clipped.iter_mut().for_each(|vertex| write(vertex, light(vertex)));
        }
    }

    /// Whether values belong to the clipped vertices rather than to those of the scene.
    pub fn belongs_to_clipped(&self) -> bool {
        self.relight || self.sipp_flat || self.screen
    }

    /// Whether what varies is linear over the polygon: all values equal, or three vertices before clipping.
    pub fn is_affine(&self, corners: &[ClipVertex], clipped: &[ClipVertex]) -> bool {
        let values = |vertex: &ClipVertex| {
            let [a, b, c, ..] = vertex.attributes;
            ([a, b, c], place_of(vertex))
        };
        let equal = |vertices: &[ClipVertex]| vertices.windows(2).all(|pair| values(&pair[0]) == values(&pair[1]));
        // Lit anew, or linear on the screen, the pieces of a triangle are not; else clipping changes nothing.
        let decided_on = if self.belongs_to_clipped() { clipped } else { corners };
        decided_on.len() == 3 || equal(decided_on)
    }

    fn light(&mut self, shader: &Shader, surface: u32, eye: Vec3, normal: Vec3) -> Rgb {
        self.vertices_lit += 1;
        shader.light(surface, eye, normal)
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

/// What varies at a vertex: the first three of its attributes.
fn write(vertex: &mut ClipVertex, values: [f64; 3]) {
    vertex.attributes[..3].copy_from_slice(&values);
}
