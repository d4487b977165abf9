//! Wear: pictures on surfaces, and the coordinates that polygons carry for them.
//!
//! Scene, Plan -WEAR-> shader's textures; mesh -> u, v at the corners -> clip, project
//!
//! Only where the plan says that some surface has a picture: else nothing carries anything, and nothing is made ready.
//!
//! Space: texture space, v upward. Cost: means of a picture once, not once a frame.

use super::Part;
use super::project::Corner;
use crate::color::Encoding;
use crate::plan::{Choices, Plan};
use crate::scene::{Scene, Surface};
use crate::screen::Shader;
use crate::screen::shader::{Picture, Textures};

/// Which pictures are ready, and whether polygons carry coordinates.
pub(super) struct Wardrobe {
    needed: bool,
    encoding: Encoding,
    threshold: Option<f64>,
    /// Of each texture of the scene: its index in the shader, once a surface wears it.
    ready: Vec<Option<u32>>,
    /// The last frame's.
    before: Textures,
}

impl Wardrobe {
    /// `before` are the textures of the last frame.
    pub fn new(plan: &Plan, before: Textures) -> Wardrobe {
        let Choices { encoding, alpha_threshold: threshold, .. } = plan.choices;
        Wardrobe { needed: plan.needs.texture, encoding, threshold, ready: Vec::new(), before }
    }

    /// Gives the shader an empty list of textures.
    pub fn prepare(&mut self, scene: &Scene, plan: &Plan, shader: &mut Shader) {
        if !self.needed {
            return;
        }
        let Choices { texture_filter, alpha, samples, .. } = plan.choices;
        self.ready.resize(scene.textures.len(), None);
        shader.textures = Textures::new(texture_filter, alpha, samples);
    }

    /// The index in the shader of the picture that `surface` wears.
    pub fn picture(&mut self, scene: &Scene, surface: &Surface, shader: &mut Shader) -> Option<u32> {
        let (id, texture) = scene.picture_on(surface).filter(|_| self.needed)?;
        let ready = &mut self.ready[id.0 as usize];
        if ready.is_none() {
            let own = texture.cut_out.map(|cut_out| self.threshold.unwrap_or(cut_out.threshold) as f32);
            let picture = Picture { encoding: self.encoding, threshold: own, ..Picture::of(texture) };
            *ready = Some(shader.textures.push(&picture, &self.before));
        }
        *ready
    }
}

/// Writes u and v of the vertices of `outline` into its corners.
pub(super) fn dress(part: Part<'_>, outline: &[u32], corners: &mut [Corner]) {
    for (corner, &index) in corners.iter_mut().zip(outline) {
        corner.place = place(part, index);
    }
}

/// u and v of a vertex; 0 where it has none.
#[inline]
pub(super) fn place(part: Part<'_>, vertex: u32) -> [f64; 2] {
    if !part.surface.primitives.is_empty() {
        return [0.0; 2];
    }
    part.mesh.texture.get(vertex as usize).map_or([0.0; 2], |place| [place.x, place.y])
}
