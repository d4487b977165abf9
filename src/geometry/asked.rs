//! Asked: what survivors asked for, brought to the screen and lit.
//!
//! EyeMesh -ASKED-> vertices made ready, corners of shared triangles, light
//!
//! Space: eye space in; samples out. Cost: `eight` does it for eight vertices at a time, where it can.

use super::eight::{self, Lit};
use super::project::{Projector, Ready};
use super::walk::Side;
use crate::math::Vec3;
use crate::screen::{EdgeKind, Shader, SharedCorner};
use fearless_simd::Level;

/// Some of what was asked for: what one thread computes.
pub(super) struct Asked<'a> {
    pub positions: &'a [Vec3],
    pub normals: &'a [Vec3],
    pub asked: &'a [u32],
    pub ready: &'a mut [Ready],
    pub places: &'a mut [[i32; 2]],
    pub corners: &'a mut [SharedCorner],
    pub uv: &'a mut [[f64; 2]],
    pub asked_light: &'a [(u32, Side)],
    pub lit: &'a mut [[f64; 3]],
    pub factors: &'a mut [[f64; 3]],
}

impl<'a> Asked<'a> {
    /// The same in `count` parts.
    pub fn parts(self, count: usize) -> Vec<Asked<'a>> {
        let Asked { positions, normals, asked, ready, places, corners, uv, asked_light, lit, factors } = self;
        let (each, each_light) = (asked.len().div_ceil(count).max(1), asked_light.len().div_ceil(count).max(1));
        let (mut asked, mut asked_light) = (asked.chunks(each), asked_light.chunks(each_light));
        let (mut ready, mut lit) = (ready.chunks_mut(each), lit.chunks_mut(each_light));
        // One or the other is missing.
        let (mut places, mut corners) = (places.chunks_mut(each), corners.chunks_mut(each));
        let mut uv = uv.chunks_mut(each);
        let mut factors = factors.chunks_mut(each_light);
        let part = |_| Asked {
            positions,
            normals,
            asked: asked.next().unwrap_or_default(),
            ready: ready.next().unwrap_or_default(),
            places: places.next().unwrap_or_default(),
            corners: corners.next().unwrap_or_default(),
            uv: uv.next().unwrap_or_default(),
            asked_light: asked_light.next().unwrap_or_default(),
            lit: lit.next().unwrap_or_default(),
            factors: factors.next().unwrap_or_default(),
        };
        (0..count).map(part).collect()
    }

    /// Brings the vertices to the screen.
    pub fn project(&mut self, projector: &Projector, level: Level) {
        for (place, &vertex) in self.ready.iter_mut().zip(self.asked) {
            let position = self.positions[vertex as usize];
            *place = projector.ready(projector.clip_space(position), EdgeKind::Original);
        }
        if !self.places.is_empty() {
            eight::corners(level, projector, (self.positions, self.asked), (self.places, self.corners));
        }
    }

    /// Keeps where in pictures the vertices are.
    pub fn keep_uv(&mut self, place: impl Fn(u32) -> [f64; 2]) {
        for (uv, &vertex) in self.uv.iter_mut().zip(self.asked) {
            *uv = place(vertex);
        }
    }

    /// Keeps the normals, turned to the side that is seen, in place of light.
    pub fn keep_normals(&mut self) {
        for (lit, &(vertex, side)) in self.lit.iter_mut().zip(self.asked_light) {
            *lit = side.turn(self.normals[vertex as usize]).to_array();
        }
    }

    /// Keeps what colors are multiplied with.
    pub fn keep_factors(&mut self, factor: impl Fn(u32) -> [f64; 3]) {
        for (place, &(vertex, _)) in self.factors.iter_mut().zip(self.asked_light) {
            *place = factor(vertex);
        }
    }

    /// Lights the vertices of a surface of the shader; returns how many, and highlights.
    pub fn light(
        &mut self,
        (shader, surface): (&Shader, u32),
        factor: Option<&dyn Fn(u32) -> [f64; 3]>,
        level: Level,
    ) -> (u64, u64) {
        let lit = Lit { shader, surface, positions: self.positions, normals: self.normals, factor };
        (self.lit.len() as u64, lit.light(level, self.asked_light, self.lit))
    }
}
