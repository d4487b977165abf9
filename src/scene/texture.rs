//! Pictures on surfaces.
//!
//! Space: texture space, (u, v) from 0 to 1 over the picture, v upward ([`crate::image::textures`]). Coordinates stand in
//! [`Mesh::texture`](super::Mesh::texture); its third number is kept and not looked at.

use crate::image::textures::{Lookup, Mosaic, Texels, Wrap};
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
    /// Pictures chosen place by place, shown instead of `texels`.
    pub mosaic: Option<Arc<Mosaic>>,
    /// How it is found from u and v; `None`: it lies there as it is.
    pub lookup: Option<Lookup>,
    /// Some of the surface is not there.
    pub cut_out: Option<CutOut>,
    /// Some samples of the surface are left to another that stands in the same place.
    pub fade: Option<Fade>,
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

/// Which samples of a surface are its own: those whose rank, of 16, is at least `from` and below `to`.
///
/// Ranks are spread evenly over 4 x 4 samples and turned by a number of what the polygon is a picture of: the line of the polygon
/// ([`Polygon::line`](super::Polygon::line)), where programs that make scenes put a number of the tree. Two surfaces that stand for one
/// tree and have that number share all samples between them when one shows ranks 0 to k and the other k to 16: neither a
/// sample too many nor one too few, whatever k, so one fades into the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Fade {
    /// The first rank that is shown, 0 to 16.
    pub from: u8,
    /// The first one above that is not, 0 to 16; nothing is shown where it is not above `from`.
    pub to: u8,
}

impl Fade {
    /// How many ranks there are.
    pub const RANKS: u8 = 16;

    /// Whether every sample is shown.
    #[must_use]
    pub fn shows_all(self) -> bool {
        self.from == 0 && self.to >= Fade::RANKS
    }
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
        Texture::of(name, Arc::new(texels))
    }

    fn of(name: &str, texels: Arc<Texels>) -> Texture {
        let name = name.to_string();
        Texture { name, texels, mosaic: None, lookup: None, cut_out: None, fade: None, wrap: Wrap::Repeat, key: None }
    }

    /// Pictures chosen place by place; they hide everything, and the outermost places go on beyond the edges.
    #[must_use]
    pub fn mosaic(name: &str, mosaic: Mosaic) -> Texture {
        let texels = mosaic.tiles()[0].texels.clone();
        Texture { mosaic: Some(Arc::new(mosaic)), wrap: Wrap::Clamp, ..Texture::of(name, texels) }
    }

    /// The same texture, of which only the samples with ranks from `from` to below `to` are shown ([`Fade`]).
    #[must_use]
    pub fn faded(self, from: u8, to: u8) -> Texture {
        Texture { fade: Some(Fade { from, to }), ..self }
    }

    /// Whether some samples of what wears it are not there: alpha or a fade takes them out.
    #[must_use]
    pub fn has_holes(&self) -> bool {
        self.cut_out.is_some() || self.fade.is_some_and(|fade| !fade.shows_all())
    }

    /// A picture whose alpha cuts the surface out, above `threshold`; its outermost texels go on beyond its edges.
    #[must_use]
    pub fn cut_out(name: &str, texels: Texels, threshold: f64) -> Texture {
        Texture { cut_out: Some(CutOut { threshold }), wrap: Wrap::Clamp, ..Texture::opaque(name, texels) }
    }
}
