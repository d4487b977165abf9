//! The registry: rasterizers by name.
//!
//! Why an explicit list: a student adds one line to the `main` of the own crate, and the whole command line works with
//! it. Nothing is found by magic, so nothing is mysteriously missing.

use super::{Fast, PerPolygon, Rasterizer, Scanline, Watkins, Wire, ZBuffer};

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
            .add("wire", "edges only, no hidden-line removal", PerPolygon(Wire))
    }

    /// Adds a rasterizer; one that is already there under this name is replaced.
    #[must_use]
    pub fn with(self, name: &str, rasterizer: impl Rasterizer + Send + Sync + 'static) -> Registry {
        self.add(name, "plugged in", rasterizer)
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
