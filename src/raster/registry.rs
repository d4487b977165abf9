//! The registry: rasterizers by name.
//!
//! Why an explicit list: a student adds one line to the `main` of the own crate, and the whole command line works with
//! it. Nothing is found by magic, so nothing is mysteriously missing.

use super::functions::{ClipFunction, Named, TriangulateFunction, ears, sutherland};
use super::{Fast, Rasterizer, Scanline, Watkins, Wire, ZBuffer};
use crate::geometry::clip::{ClipVertex, ClipVolume};
use crate::math::Vec3;

/// A rasterizer that can be asked for by name.
pub struct Registered {
    /// What follows `-r`.
    pub name: String,
    /// One line for `farop list rasterizers`.
    pub summary: String,
    /// The algorithm.
    pub rasterizer: Box<dyn Rasterizer + Send + Sync>,
}

/// All rasterizers that the command line knows.
#[derive(Default)]
pub struct Registry {
    entries: Vec<Registered>,
    clips: Vec<Named<ClipFunction>>,
    triangulations: Vec<Named<TriangulateFunction>>,
}

impl Registry {
    /// The rasterizers that come with farop.
    #[must_use]
    pub fn built_in() -> Registry {
        let none = Registry::default();
        none.add("zbuffer", "keeps the depth of the nearest polygon at every sample; the readable reference", ZBuffer)
            .add("fast", "tile by tile, the z-buffer's bytes at the speed of the machine", Fast::default())
            .add("watkins", "scan line by scan line, span by span; every sample is put once", Watkins)
            .add(
                "scanline",
                "polygon by polygon, every value one addition from the last: fast, and it drifts",
                Scanline,
            )
            .add("wire", "edges only, no hidden-line removal", Wire)
            .add_clip("sutherland", "Sutherland and Hodgman, plane by plane", Box::new(sutherland))
            .add_triangulate("ears", "ears, the shortest diagonal first", Box::new(ears))
    }

    /// Adds a rasterizer; one that is already there under this name is replaced.
    #[must_use]
    pub fn with(self, name: &str, rasterizer: impl Rasterizer + Send + Sync + 'static) -> Registry {
        self.add(name, "plugged in", rasterizer)
    }

    /// Adds a clip for `farop grade clip`; one that is already there under this name is replaced.
    #[must_use]
    pub fn with_clip(
        self,
        name: &str,
        clip: impl Fn(&[ClipVertex], &ClipVolume, usize) -> Vec<ClipVertex> + Send + Sync + 'static,
    ) -> Registry {
        self.add_clip(name, "plugged in", Box::new(clip))
    }

    /// Adds a triangulation for `farop grade triangulate`; one that is already there under this name is replaced.
    #[must_use]
    pub fn with_triangulate(
        self,
        name: &str,
        triangulate: impl Fn(&[Vec3], Vec3) -> Vec<[u32; 3]> + Send + Sync + 'static,
    ) -> Registry {
        self.add_triangulate(name, "plugged in", Box::new(triangulate))
    }

    fn add_clip(mut self, name: &str, summary: &str, function: Box<ClipFunction>) -> Registry {
        self.clips.retain(|entry| entry.name != name);
        self.clips.push(Named { name: name.to_string(), summary: summary.to_string(), function });
        self
    }

    fn add_triangulate(mut self, name: &str, summary: &str, function: Box<TriangulateFunction>) -> Registry {
        self.triangulations.retain(|entry| entry.name != name);
        self.triangulations.push(Named { name: name.to_string(), summary: summary.to_string(), function });
        self
    }

    /// All clips, the built-in one first.
    #[must_use]
    pub fn clips(&self) -> &[Named<ClipFunction>] {
        &self.clips
    }

    /// All triangulations, the built-in one first.
    #[must_use]
    pub fn triangulations(&self) -> &[Named<TriangulateFunction>] {
        &self.triangulations
    }

    fn add(mut self, name: &str, summary: &str, rasterizer: impl Rasterizer + Send + Sync + 'static) -> Registry {
        self.entries.retain(|entry| entry.name != name);
        let (name, summary) = (name.to_string(), summary.to_string());
        self.entries.push(Registered { name, summary, rasterizer: Box::new(rasterizer) });
        self
    }

    /// The rasterizer of that name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Registered> {
        self.entries.iter().find(|entry| entry.name == name)
    }

    /// All of them, built-in ones first.
    pub fn iter(&self) -> impl Iterator<Item = &Registered> {
        self.entries.iter()
    }
}
