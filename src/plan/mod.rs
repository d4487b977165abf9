//! The plan: what a scene needs and what the user chose, decided once, read by every later stage.
//!
//! Scene + choices + what the rasterizer takes -PLAN-> geometry, rasterizer, target
//!
//! Why a stage of its own: "model only what a scene requires" is only honest when it is said in one place, with its
//! reason, and when doing everything all the same (`--needs full`) is proven to give the same bytes.
//! Source: FAROP's diagnostics (appendix A.3 of the paper) told what had been done; the plan tells it before.

mod choices;
mod error;
mod explain;
mod needs;
mod view;

pub use choices::{
    AlphaRule, AngleSpan, Choices, ClipLight, Culling, DepthFormat, EXACT_SUBPIXELS, FlatRule, Interpolation,
    LightTerms, NeedsMode, Shading, TextureFilter, Transparency,
};
pub use error::PlanError;
pub use explain::PlanRow;
pub use needs::{ClipPlane, Needs, Split, Survey, is_outside};
pub use view::View;

use crate::scene::Scene;

/// The polygons a rasterizer can take; the plan splits the others into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accepts {
    /// Any simple polygon, convex or not.
    AnyPolygon,
    /// Triangles only.
    Triangles,
}

/// What numbers that interpolation carries from the vertices into a polygon; chosen once per list.
///
/// Whatever there is of it stands in this order: color, or normal and point in eye space; a factor on the color; u and v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Varying {
    /// Nothing: wire.
    Nothing,
    /// Red, green, blue: flat and Gouraud.
    Color,
    /// Unit normal and point in eye space, three numbers each: Phong.
    NormalEye,
    /// The same, and a color that the light of the surface is multiplied with: Phong where vertices have colors.
    NormalEyeColor,
    /// As `Color`, then u and v: the list has surfaces with pictures.
    ColorTexture,
    /// As `NormalEye`, then u and v.
    NormalEyeTexture,
    /// As `NormalEyeColor`, then u and v.
    NormalEyeColorTexture,
}

impl Varying {
    /// How many numbers that is.
    #[must_use]
    pub fn count(self) -> usize {
        self.light_count() + self.texture_count()
    }

    /// How many of them, from the first on, come from light: color, or normal and eye point and what goes with them.
    #[must_use]
    #[inline]
    pub fn light_count(self) -> usize {
        match self.without_texture() {
            Varying::Nothing => 0,
            Varying::Color => 3,
            Varying::NormalEye => 6,
            _ => 9,
        }
    }

    /// How many of them, behind those, are texture coordinates: 2 or none.
    #[must_use]
    #[inline]
    pub fn texture_count(self) -> usize {
        if self == self.without_texture() { 0 } else { 2 }
    }

    /// Whether number `index` is a coordinate of the eye point: a length in space, whatever interpolation was chosen.
    #[must_use]
    #[inline]
    pub fn is_eye_point(self, index: usize) -> bool {
        self.has_normals() && (3..6).contains(&index)
    }

    /// Whether normals and eye points vary, and light is for the rasterizer to compute.
    #[must_use]
    #[inline]
    pub fn has_normals(self) -> bool {
        !matches!(self.without_texture(), Varying::Nothing | Varying::Color)
    }

    /// Whether a factor on the color varies beside normals.
    #[must_use]
    #[inline]
    pub fn has_factor(self) -> bool {
        self.without_texture() == Varying::NormalEyeColor
    }

    /// The same without texture coordinates.
    #[must_use]
    #[inline]
    pub fn without_texture(self) -> Varying {
        match self {
            Varying::ColorTexture => Varying::Color,
            Varying::NormalEyeTexture => Varying::NormalEye,
            Varying::NormalEyeColorTexture => Varying::NormalEyeColor,
            other => other,
        }
    }
}

/// Everything later stages read: the view, the choices, the needs, the light levels.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Eye space and the scale to samples.
    pub view: View,
    /// What the user chose.
    pub choices: Choices,
    /// What the scene needs under these choices.
    pub needs: Needs,
    /// What was counted in the scene to derive the needs.
    pub survey: Survey,
    /// Intensity of the ambient light.
    pub ambient: f64,
    /// Intensity of every light that has none of its own.
    pub light_intensity: f64,
    /// What the rasterizer takes.
    pub accepts: Accepts,
}

impl Plan {
    /// Decides what `scene` needs under `choices` for a rasterizer that takes `accepts`.
    ///
    /// # Errors
    /// [`PlanError`] when the scene has no usable view or the choices contradict each other.
    pub fn new(scene: &Scene, choices: &Choices, accepts: Accepts) -> Result<Plan, PlanError> {
        check(choices)?;
        check_history(choices, accepts)?;
        let camera = scene.camera.as_ref().ok_or(PlanError::NoCamera)?;
        let view = View::new(camera, choices)?;
        if matches!(choices.depth, DepthFormat::Int16 | DepthFormat::Int24) && view.yon.is_infinite() {
            return Err(PlanError::IntegerDepthNeedsYon(choices.depth.name()));
        }
        let suggested = scene.suggested_intensity();
        let survey = Survey::new(scene, &view)?;
        let needs = match choices.needs {
            NeedsMode::Derived => Needs::derive(&survey, choices, accepts),
            NeedsMode::Full => Needs::full(choices, accepts),
        };
        Ok(Plan {
            view,
            choices: choices.clone(),
            needs,
            survey,
            ambient: choices.ambient.unwrap_or(suggested),
            light_intensity: choices.light_intensity.unwrap_or(suggested),
            accepts,
        })
    }

    /// Whether nothing is snapped, and so nothing clipped at the sides of the picture. Lines always lie on a grid.
    #[must_use]
    pub fn is_unsnapped(&self) -> bool {
        self.choices.subpixel_bits == EXACT_SUBPIXELS && self.choices.shading != Shading::Wire
    }

    /// How many threads the stages may use; at least 1. No bit of a list or a picture depends on it.
    #[must_use]
    pub fn threads(&self) -> usize {
        let available = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        self.choices.threads.map_or_else(available, |threads| threads as usize).max(1)
    }

    /// What interpolation carries under this shading.
    #[must_use]
    pub fn varying(&self) -> Varying {
        let (texture, colors) = (self.needs.texture, self.survey.colored_surfaces > 0);
        match self.choices.shading {
            Shading::Gouraud | Shading::Flat if texture => Varying::ColorTexture,
            Shading::Gouraud | Shading::Flat => Varying::Color,
            Shading::Phong if texture && colors => Varying::NormalEyeColorTexture,
            Shading::Phong if texture => Varying::NormalEyeTexture,
            Shading::Phong if colors => Varying::NormalEyeColor,
            Shading::Phong => Varying::NormalEye,
            Shading::Wire => Varying::Nothing,
        }
    }
}

fn check(choices: &Choices) -> Result<(), PlanError> {
    if choices.subpixel_bits > 16 && choices.subpixel_bits != EXACT_SUBPIXELS {
        return Err(PlanError::SubpixelBits(choices.subpixel_bits));
    }
    if !(choices.tolerance > 0.0 && choices.tolerance.is_finite()) {
        return Err(PlanError::Tolerance(choices.tolerance));
    }
    if let Some(threshold) = choices.alpha_threshold.filter(|threshold| !(0.0..=1.0).contains(threshold)) {
        return Err(PlanError::AlphaThreshold(threshold));
    }
    if let Some(resolution) = choices.resolution.filter(|&resolution| resolution == 0 || resolution > 1000) {
        return Err(PlanError::Resolution(resolution));
    }
    Ok(())
}

/// Historic rules that the other choices leave nothing to do for: an error rather than silence.
fn check_history(choices: &Choices, accepts: Accepts) -> Result<(), PlanError> {
    let shading = choices.shading;
    if choices.flat != FlatRule::Face && shading != Shading::Flat {
        return Err(PlanError::FlatRuleWithoutFlat(choices.flat.name(), shading.name()));
    }
    if choices.interpolation != Interpolation::ScanLine {
        return Ok(());
    }
    if matches!(shading, Shading::Flat | Shading::Wire) {
        return Err(PlanError::NothingToInterpolate(shading.name()));
    }
    if choices.triangles {
        return Err(PlanError::ScanLineNeedsPolygons("--triangles splits all"));
    }
    if accepts == Accepts::Triangles {
        return Err(PlanError::ScanLineNeedsPolygons("the rasterizer takes triangles only"));
    }
    Ok(())
}
