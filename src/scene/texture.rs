//! Pictures on surfaces.
//!
//! Space: texture space, (u, v) from 0 to 1 over the picture, v upward ([`crate::image::textures`]). Coordinates stand in
//! [`Mesh::texture`](super::Mesh::texture); its third number is kept and not looked at.

use crate::image::textures::{Texels, Wrap};
use std::sync::Arc;

/// Points at one of [`Scene::textures`](super::Scene::textures).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureId(pub u32);

/// A picture, and how a surface wears it: light is multiplied by its color.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// Where it came from, as the scene names it: a file beside the scene, relative to its folder.
    pub name: String,
    /// The picture; shared by all who use it.
    pub texels: Arc<Texels>,
    /// Some of the surface is not there.
    pub cut_out: Option<CutOut>,
    /// How the picture goes on beyond 0 to 1.
    pub wrap: Wrap,
    /// The color that means "nothing here", already taken out of `texels`: kept for the printer.
    pub key: Option<[u8; 3]>,
}

/// Where a surface has holes: a sample is there when alpha is above the threshold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutOut {
    /// 0 to 1; 0.5 unless the scene says otherwise.
    pub threshold: f64,
}

impl Default for CutOut {
    fn default() -> Self {
        CutOut { threshold: 0.5 }
    }
}

impl Texture {
    /// A picture that repeats and hides everything, whatever its alpha.
    #[must_use]
    pub fn opaque(name: &str, texels: Texels) -> Texture {
        let texels = Arc::new(texels);
        Texture { name: name.to_string(), texels, cut_out: None, wrap: Wrap::Repeat, key: None }
    }

    /// A picture whose alpha cuts the surface out, above `threshold`; its outermost texels go on beyond its edges.
    #[must_use]
    pub fn cut_out(name: &str, texels: Texels, threshold: f64) -> Texture {
        Texture { cut_out: Some(CutOut { threshold }), wrap: Wrap::Clamp, ..Texture::opaque(name, texels) }
    }
}
