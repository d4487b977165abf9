//! Plain: a list without its pictures.
//!
//! DrawList with u and v -PLAIN-> the DrawList that the scene would give without pictures on its surfaces
//!
//! For those who know colors only: programs and libraries behind the doors, classic files, labs.
//!
//! Cost: a copy of the list.

use super::DrawList;

impl DrawList {
    /// Whether polygons carry texture coordinates.
    #[must_use]
    pub fn has_texture(&self) -> bool {
        self.varying.texture_count() > 0
    }

    /// How many polygons show a picture.
    #[must_use]
    pub fn textured_polygons(&self) -> usize {
        self.polygons.iter().filter(|polygon| self.shader.texture_of(polygon.surface).is_some()).count()
    }

    /// The same polygons in the light of their surfaces alone: no u, v, pictures or holes.
    #[must_use]
    pub fn without_texture(&self) -> DrawList {
        if !self.has_texture() {
            return self.clone();
        }
        let (all, light) = (self.varying.count(), self.varying.light_count());
        let mut plain = DrawList { varying: self.varying.without_texture(), ..self.clone() };
        plain.values = self.values.chunks_exact(all).flat_map(|values| &values[..light]).copied().collect();
        if self.has_depth {
            // Depth, then what varies.
            plain.planes = self.planes.chunks_exact(1 + all).flat_map(|planes| &planes[..=light]).copied().collect();
            for polygon in &mut plain.polygons {
                polygon.first_plane = polygon.first_plane / (1 + all as u32) * (1 + light as u32);
            }
        }
        plain.shader.textures = super::shader::Textures::default();
        plain.shader.surfaces.iter_mut().for_each(|surface| surface.texture = None);
        plain
    }
}
