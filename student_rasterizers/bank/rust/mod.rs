//! Rasterizers of the bank that are written in Rust: one file an algorithm, each right unless its slip says otherwise.

mod edge_table;
mod half_plane;
mod lamp;
mod lines;
mod samples;
mod spans;

use farop::grade::{InProcess, Subject};
use farop::raster::{PerPolygon, Rasterizer};

/// The one small change that makes a rasterizer wrong; `none` for a right one.
#[derive(Clone, Debug)]
pub struct Slip(pub String);

impl Slip {
    /// Whether it is the one of that name.
    fn is(&self, name: &str) -> bool {
        self.0 == name
    }
}

/// What draws: a rasterizer, or a program of its own that also averages samples.
pub enum Drawer {
    /// In the driver's hands.
    Rasterizer(Box<dyn Rasterizer>),
    /// The whole way from list to picture.
    Whole(Box<dyn Subject>),
}

impl Drawer {
    /// The source of that name with a slip; `None` when there is no such source.
    pub fn new(source: &str, slip: &str) -> Option<Drawer> {
        let slip = Slip(slip.to_string());
        let rasterizer: Box<dyn Rasterizer> = match source {
            "half_plane" => Box::new(half_plane::HalfPlane::new(slip)),
            "edge_table" => Box::new(PerPolygon(edge_table::EdgeTable { slip })),
            "spans" => Box::new(spans::Spans { slip }),
            "lamp" => Box::new(PerPolygon(lamp::Lamp { slip })),
            "lines" => Box::new(PerPolygon(lines::Lines { slip })),
            "samples" => return Some(Drawer::Whole(Box::new(samples::Samples { slip }))),
            _ => return None,
        };
        Some(Drawer::Rasterizer(rasterizer))
    }

    /// Calls `then` with it as something that can be graded.
    pub fn with_subject<T>(&self, then: impl FnOnce(&dyn Subject) -> T) -> T {
        match self {
            Drawer::Rasterizer(rasterizer) => then(&InProcess(rasterizer.as_ref())),
            Drawer::Whole(subject) => then(subject.as_ref()),
        }
    }
}
