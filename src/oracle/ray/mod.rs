//! Ray: one ray a sample against the shapes as the file states them, not as polygons.
//!
//! Scene -RAY-> [`RayPicture`]
//!
//! What the pipeline approximates (spheres and cones by polygons, light between vertices, outlines on a grid) is asked
//! here of the shape itself: a ray is moved into the shape's own space and its equation solved. Shared with the pipeline
//! are the parser, the scene's types and the values of [`Choices`]; view, facing, reflection and blending are written anew
//! from the formulas.
//!
//! Space: rays start in the eye and advance 1 along the view a unit of t, so that t is the depth w of the pipeline.
//! Source: A. Appel, "Some Techniques for Shading Machine Renderings of Solids", AFIPS SJCC 1968 (casting rays).
//! Cost: a tree of boxes is walked a ray; about 1 to 3 microseconds.

mod boxes;
mod camera;
mod light;
mod polygon;
pub mod silhouette;
mod solid;
mod tracer;

pub use tracer::Tracer;

use crate::color::Rgb;
use crate::image::Image;
use crate::math::Vec3;
use crate::plan::Choices;
use crate::scene::{InstanceBudgetExceeded, Scene, SurfaceId};

/// Why a scene cannot be judged.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RayError {
    /// Nobody said where it is seen from.
    #[error("the scene has no camera")]
    NoCamera,
    /// The camera makes no picture.
    #[error("the camera makes no picture: {0}")]
    Camera(&'static str),
    /// The shape has no equation here.
    #[error("{place}: a {shape} is not analytic here")]
    NotAnalytic {
        /// What it is.
        shape: &'static str,
        /// Where it was declared.
        place: String,
    },
    /// Vertices of a surface have colors of their own.
    #[error("{place}: the vertices have colors of their own, which rays do not interpolate")]
    VertexColors {
        /// Where the surface was declared.
        place: String,
    },
    /// Rays know the light of a surface, not its picture or its holes.
    #[error("{place}: a surface with a picture is not analytic here")]
    Picture {
        /// Where it was declared.
        place: String,
    },
    /// Runaway instancing.
    #[error(transparent)]
    TooManyInstances(#[from] InstanceBudgetExceeded),
}

/// What a ray met first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// w: distance along the view.
    pub depth: f64,
    /// The how-manieth object of [`Scene::walk`], from 0.
    pub instance: u32,
    /// The surface.
    pub surface: SurfaceId,
    /// Which part of the surface.
    pub part: Part,
    /// World space.
    pub point: Vec3,
    /// Unit, world space, on the side that the eye sees; given or interpolated normals included.
    pub normal: Vec3,
    /// The eye sees the back.
    pub back: bool,
}

/// A part of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Index into the polygons of its mesh.
    Polygon(u32),
    /// Index into its primitives.
    Primitive(u32),
}

/// The light and the hit of every sample.
#[derive(Clone, Debug, PartialEq)]
pub struct RayPicture {
    /// Samples across.
    pub width: u32,
    /// Samples down.
    pub height: u32,
    /// A: samples of a pixel in each direction.
    pub samples: u32,
    /// Linear light of every sample, row after row from the top, not clamped.
    pub light: Vec<Rgb>,
    /// What each ray met first.
    pub hits: Vec<Option<Hit>>,
}

impl RayPicture {
    /// Where the first hit is one of some kind: of one primitive, of one surface, or any.
    #[must_use]
    pub fn mask(&self, is_of: impl Fn(&Hit) -> bool) -> silhouette::Mask {
        let inside = self.hits.iter().map(|hit| hit.as_ref().is_some_and(&is_of)).collect();
        silhouette::Mask { width: self.width, inside }
    }

    /// The picture: the mean of the A x A samples of each pixel, linear light.
    #[must_use]
    pub fn image(&self) -> Image {
        let mut image = Image::new(self.width as usize, self.height as usize, Rgb::gray(0.0));
        for (pixel, light) in image.pixels_mut().iter_mut().zip(&self.light) {
            *pixel = light.to_f32();
        }
        image.average(self.samples as usize)
    }
}

/// Traces every sample of the picture of `scene` under `choices`: size, samples, angle, culling, transparency, encoding
/// and light levels are obeyed; tessellation, shading, grids and depth formats do not concern rays.
///
/// # Errors
/// [`RayError`] when there is no usable camera, or a shape without an equation.
pub fn trace(scene: &Scene, choices: &Choices) -> Result<RayPicture, RayError> {
    Ok(Tracer::new(scene, choices)?.picture())
}
