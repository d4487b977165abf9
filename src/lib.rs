//! farop: scenes in, a geometry stage that students can read, any rasterizer plugged in, honest answers out.
//!
//! ```text
//! text -parse-> Scene --+-> Plan -+
//!                       +---------+-> geometry::run -> DrawList -Rasterizer-> Fragment -Target-> Image -> file
//!    EyePolygon -cull,clip-> ClippedPolygon -light,split,project-> ScreenPolygon
//! ```
//!
//! Data goes one way: a room uses only rooms that stand before it in this list, which is also a good order to read them.
//!
//! | Room | What happens there |
//! |---|---|
//! | [`math`], [`color`] | vectors, and what display values have to do with light |
//! | [`image`](mod@image) | pictures, their files, comparing them, [`snapshot`] tests |
//! | [`diagnostic`], [`report`] | messages with places; counts and times |
//! | [`scene`] | the tree of objects, surfaces, lights, the camera |
//! | [`model`], [`spd`] | shapes as polygons; the standard procedural databases |
//! | [`forest`] | grids of heights, reliefs of few triangles; areas of forest, stands, trees, and what an observer sees of them |
//! | [`parse`], [`write`](mod@write) | NFF and SIPP scenes and areas of forest in and out; grids of heights in |
//! | [`plan`] | what the scene needs and what the user chose |
//! | [`screen`] | screen polygons, planes, lights and reflection models, screen files |
//! | [`geometry`] | cull, clip, light, split, project: FAROP's figure 4 |
//! | [`raster`] | the contract, the target, the z-buffer, Watkins, scan line, wire; doors for other languages |
//! | [`oracle`] | what the picture ought to be, found by other means |
//! | [`render`] | the driver; why a sample shows what it shows |
//! | [`lab`] | how accurate all this is, and what more would cost, measured |
//! | [`grade`] | probes that find a rasterizer's mistakes |
//! | [`view`] | what the window shows, without a window |
//! | [`cli`] | the command line |
//!
//! `docs/tour.md` follows one polygon through all of them.

pub mod cli;
pub mod color;
pub mod diagnostic;
pub mod forest;
pub mod geometry;
pub mod grade;
pub mod image;
pub mod lab;
pub mod math;
pub mod model;
pub mod oracle;
pub mod parse;
pub mod plan;
pub mod raster;
pub mod render;
pub mod report;
pub mod scene;
pub mod screen;
pub mod spd;
pub mod view;
pub mod write;

pub use self::image::snapshot;

/// The code in the documents and the README is compiled and run with the tests.
#[cfg(doctest)]
mod documents {
    #[doc = include_str!("../README.md")]
    struct Readme;
    #[doc = include_str!("../docs/tour.md")]
    struct Tour;
    #[doc = include_str!("../docs/accuracy.md")]
    struct Accuracy;
    #[doc = include_str!("../docs/conventions.md")]
    struct Conventions;
    #[doc = include_str!("../docs/glossary.md")]
    struct Glossary;
    #[doc = include_str!("../docs/shading.md")]
    struct Shading;
    #[doc = include_str!("../docs/snapshots.md")]
    struct Snapshots;
    #[doc = include_str!("../docs/formats.md")]
    struct Formats;
    #[doc = include_str!("../docs/screen-files.md")]
    struct ScreenFiles;
    #[doc = include_str!("../docs/watkins.md")]
    struct Watkins;
    #[doc = include_str!("../docs/scanline.md")]
    struct Scanline;
    #[doc = include_str!("../docs/transparency.md")]
    struct Transparency;
    #[doc = include_str!("../docs/lab.md")]
    struct Lab;
    #[doc = include_str!("../docs/view.md")]
    struct View;
    #[doc = include_str!("../docs/forest-growing.md")]
    struct ForestGrowing;
}
