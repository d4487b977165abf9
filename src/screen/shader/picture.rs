//! Pictures made ready for lookups, and which of them a place shows.
//!
//! scene's texture -PICTURE-> pyramids, holes, fade; (u, v), slopes -LOOK-> pyramid, place, level of detail
//!
//! Why means are looked for before they are made: a forest has a texture for each of 17 steps of fading of every kind of tree, and all
//! steps of a kind share one picture.
//!
//! Space: texture space; slopes are changes of u and v from sample to sample. Cost: means of a picture once.

use crate::color::{Encoding, Rgb};
use crate::image::textures::{Alpha, Filter, Lookup, Mosaic, Pyramid, Sample, Texels, Wrap, level_of_detail};
use crate::plan::TextureFilter;
use crate::scene::{Fade, Texture};
use std::sync::Arc;

/// A picture made ready.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureShading {
    /// Where it came from.
    pub name: String,
    /// The picture as it was given.
    pub texels: Arc<Texels>,
    /// It and its means, made ready.
    pub pyramid: Arc<Pyramid>,
    /// Pictures chosen place by place, instead of that one.
    pub mosaic: Option<MosaicShading>,
    /// How it is found from u and v; `None`: it lies there as it is.
    pub lookup: Option<Lookup>,
    /// What its colors mean.
    pub encoding: Encoding,
    /// What alpha must be above where the surface has holes; `None`: it has none.
    pub threshold: Option<f32>,
    /// Which samples are shown; `None`: all.
    pub fade: Option<Fade>,
}

/// A mosaic made ready.
#[derive(Clone, Debug, PartialEq)]
pub struct MosaicShading {
    /// As it was given.
    pub mosaic: Arc<Mosaic>,
    /// One for each of its tiles.
    pub pyramids: Vec<Arc<Pyramid>>,
    /// How its numbers go on beyond its edges.
    pub wrap: Wrap,
}

/// A picture to make ready.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// Where it came from.
    pub name: &'a str,
    /// The picture.
    pub texels: &'a Arc<Texels>,
    /// Pictures chosen place by place, instead of that one.
    pub mosaic: Option<&'a Arc<Mosaic>>,
    /// How it is found from u and v; `None`: it lies there as it is.
    pub lookup: Option<&'a Lookup>,
    /// What its colors mean.
    pub encoding: Encoding,
    /// The surface has holes where alpha is not above it; `None`: alpha means nothing.
    pub threshold: Option<f32>,
    /// Which samples are shown; `None`: all.
    pub fade: Option<Fade>,
    /// How it goes on beyond its edges.
    pub wrap: Wrap,
}

impl<'a> Picture<'a> {
    /// The picture of a scene's texture, its colors display values of sRGB.
    #[must_use]
    pub fn of(texture: &'a Texture) -> Picture<'a> {
        Picture {
            name: &texture.name,
            texels: &texture.texels,
            mosaic: texture.mosaic.as_ref(),
            lookup: texture.lookup.as_ref(),
            encoding: Encoding::Srgb,
            threshold: texture.cut_out.map(|cut_out| cut_out.threshold as f32),
            fade: texture.fade,
            wrap: texture.wrap,
        }
    }
}

impl TextureShading {
    /// Makes a picture ready; alpha means what `alpha` says. Means that stand in the lists `known` are used again.
    pub(super) fn new(picture: &Picture<'_>, alpha: Alpha, known: [&[TextureShading]; 2]) -> TextureShading {
        let mut made: Vec<(Arc<Texels>, Arc<Pyramid>)> = Vec::new();
        let mut pyramid = |texels: &Arc<Texels>, wrap: Wrap| {
            let is_same = |(of, pyramid): &(&Arc<Texels>, &Arc<Pyramid>)| {
                Arc::ptr_eq(of, texels) && pyramid.is_made_for(picture.encoding, alpha, wrap)
            };
            let known = known.into_iter().flatten().flat_map(TextureShading::pyramids);
            if let Some((_, pyramid)) = known.chain(made.iter().map(|(of, made)| (of, made))).find(is_same) {
                return pyramid.clone();
            }
            let new = Arc::new(Pyramid::new(texels, picture.encoding, alpha, wrap));
            made.push((texels.clone(), new.clone()));
            new
        };
        let mosaic = picture.mosaic.map(|mosaic| {
            let pyramids = mosaic.tiles().iter().map(|tile| pyramid(&tile.texels, Wrap::Repeat)).collect();
            MosaicShading { mosaic: mosaic.clone(), pyramids, wrap: picture.wrap }
        });
        TextureShading {
            name: picture.name.to_string(),
            texels: picture.texels.clone(),
            pyramid: pyramid(picture.texels, picture.wrap),
            mosaic,
            lookup: picture.lookup.cloned(),
            encoding: picture.encoding,
            threshold: picture.threshold,
            fade: picture.fade.filter(|fade| !fade.shows_all()),
        }
    }

    /// Everything that is ready, and what it was made of.
    fn pyramids(&self) -> impl Iterator<Item = (&Arc<Texels>, &Arc<Pyramid>)> {
        let tiles = self.mosaic.iter().flat_map(|shading| {
            let texels = shading.mosaic.tiles().iter().map(|tile| &tile.texels);
            texels.zip(&shading.pyramids)
        });
        std::iter::once((&self.texels, &self.pyramid)).chain(tiles)
    }

    /// Whether some samples of a surface that wears it are not there.
    #[must_use]
    #[inline]
    pub fn has_holes(&self) -> bool {
        self.threshold.is_some() || self.fade.is_some()
    }

    /// What shows at (u, v), where they change by `slopes` from sample to sample.
    #[inline]
    pub(crate) fn sample(&self, filter: TextureFilter, uv: [f64; 2], slopes: impl FnOnce() -> [[f32; 2]; 2]) -> Sample {
        if let Some(lookup) = &self.lookup {
            return self.found(lookup, filter, uv, slopes());
        }
        let (pyramid, place, level) = self.look(filter, uv, slopes);
        pyramid.sample(place, level, kind(filter))
    }

    /// The alpha of [`TextureShading::sample`] alone, to the last bit.
    #[inline]
    pub(crate) fn alpha(&self, filter: TextureFilter, uv: [f64; 2], slopes: impl FnOnce() -> [[f32; 2]; 2]) -> f32 {
        if let Some(lookup) = &self.lookup {
            return self.found(lookup, filter, uv, slopes()).alpha;
        }
        let (pyramid, place, level) = self.look(filter, uv, slopes);
        pyramid.alpha(place, level, kind(filter))
    }

    #[inline(never)]
    fn found(&self, lookup: &Lookup, filter: TextureFilter, uv: [f64; 2], slopes: [[f32; 2]; 2]) -> Sample {
        match lookup {
            Lookup::Computed(field) => Lookup::sample(&**field, uv, slopes, self.encoding),
            Lookup::Projected(matrix) => {
                let (place, slopes) = Lookup::place(matrix, uv, slopes);
                // What lies beside the map is not on it.
                if place.iter().any(|along| !(0.0..=1.0).contains(along)) {
                    return Sample { color: Rgb::gray(0.0), alpha: 0.0 };
                }
                let is_sized = filter == TextureFilter::Trilinear;
                let level = if is_sized { level_of_detail(slopes, self.pyramid.size()) } else { 0.0 };
                self.pyramid.sample(place, level, kind(filter))
            }
        }
    }

    /// Which picture shows at (u, v), at which place of it, and in which size: where u and v change by `slopes` from sample to sample.
    #[inline]
    fn look(
        &self,
        filter: TextureFilter,
        uv: [f64; 2],
        slopes: impl FnOnce() -> [[f32; 2]; 2],
    ) -> (&Pyramid, [f64; 2], f32) {
        let (pyramid, place, repeat) = match &self.mosaic {
            None => (&self.pyramid, uv, [1.0; 2]),
            Some(shading) => {
                let (id, place) = shading.mosaic.at(uv, shading.wrap);
                let repeat = shading.mosaic.tiles()[id].repeat.map(|repeat| repeat as f32);
                (&shading.pyramids[id], place, repeat)
            }
        };
        let level = match filter {
            // A factor of 1 changes no bit.
            TextureFilter::Trilinear => {
                let [right, down] = slopes();
                let slopes = [right, down].map(|slope| [slope[0] * repeat[0], slope[1] * repeat[1]]);
                level_of_detail(slopes, pyramid.size())
            }
            TextureFilter::Nearest | TextureFilter::Bilinear => 0.0,
        };
        (pyramid, place, level)
    }
}

fn kind(filter: TextureFilter) -> Filter {
    match filter {
        TextureFilter::Nearest => Filter::Nearest,
        TextureFilter::Bilinear => Filter::Bilinear,
        TextureFilter::Trilinear => Filter::Trilinear,
    }
}
