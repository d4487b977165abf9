//! Choices and counts of a frame.

use crate::forest::map::MapError;
use crate::forest::objects::ObjectError;
use crate::forest::terrain::TerrainError;
use crate::forest::window::StockError;
use serde::Serialize;

/// What stands for trees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Trees {
    /// By their height in the picture ([`detail`](crate::forest::detail)).
    #[default]
    Auto,
    /// Two crossed pictures each, near and far, as in the paper of Falcão and Próspero dos Santos. No tree is left out: this is
    /// what others are compared with.
    Crossed,
    /// One picture each that faces the eye, near and far, as in Caralo's paper.
    Billboards,
    /// Meshes, near and far: what the other looks are compared with.
    Solids,
    /// No trees.
    None,
}

/// What wears the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GroundLook {
    /// Pictures by cover nearby, colors from afar.
    #[default]
    Pictures,
    /// One color a sample, everywhere.
    Colors,
}

/// What a frame shows and how exactly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choices {
    /// The year of the stands; `None`: their first state.
    pub year: Option<i32>,
    /// Metres to the farthest tree; land goes on behind it.
    pub horizon: f64,
    /// Cells kept beyond the horizon.
    pub buffer: u16,
    /// Cells loaded a frame before they are needed.
    pub prefetch: usize,
    /// Error of the relief that may show, in pixels.
    pub tolerance: f64,
    /// What stands for trees.
    pub trees: Trees,
    /// Pixels above which a tree of [`Trees::Auto`] is a mesh; `None`: none is.
    pub solid_above: Option<f64>,
    /// What wears the ground.
    pub ground: GroundLook,
    /// `Some`: nearby, every triangle of the ground wears one cover, and no wrong one is farther than so many metres from a border.
    pub cover_tolerance: Option<f64>,
    /// Trees behind land are left out; it changes no picture.
    pub hiding: bool,
    /// Alpha of a tree's picture above which something is there.
    pub threshold: f64,
}

impl Default for Choices {
    fn default() -> Self {
        Choices {
            year: None,
            horizon: 2000.0,
            buffer: 1,
            prefetch: 3,
            tolerance: 1.0,
            trees: Trees::default(),
            solid_above: None,
            ground: GroundLook::default(),
            cover_tolerance: None,
            hiding: true,
            threshold: 0.5,
        }
    }
}

/// What one frame showed and left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct FrameCounts {
    /// Trees of the loaded cells.
    pub trees: u64,
    /// Those whose square or foot is out of view, or beyond the horizon.
    pub out_of_view: u64,
    /// Those whose square land hides.
    pub hidden: u64,
    /// Those in view: all that follow.
    pub submitted: u64,
    /// Those that others stand for.
    pub thinned: u64,
    /// Those that are meshes.
    pub solid: u64,
    /// Triangles of these.
    pub solid_triangles: u64,
    /// Those with crossed pictures; near a limit a tree counts twice.
    pub crossed: u64,
    /// Those with a picture that faces the eye.
    pub facing: u64,
    /// Those that are a triangle.
    pub narrow: u64,
    /// Polygons of all trees.
    pub tree_polygons: u64,
    /// Polygons of the ground.
    pub terrain_polygons: u64,
    /// Cells in memory.
    pub cells: u64,
    /// Cells that came with this frame.
    pub loaded: u64,
    /// Surfaces of the scene.
    pub surfaces: u64,
}

/// Why there is no frame.
#[derive(Debug, thiserror::Error)]
pub enum FrameError {
    /// The area cannot be surveyed.
    #[error(transparent)]
    Terrain(#[from] TerrainError),
    /// A cell cannot be loaded.
    #[error(transparent)]
    Stock(#[from] StockError),
    /// An object cannot stand.
    #[error(transparent)]
    Object(#[from] ObjectError),
    /// A map cannot lie on the area.
    #[error(transparent)]
    Map(#[from] MapError),
    /// A choice is no number to work with.
    #[error("{what} is {value}, which must be {expected}")]
    Choice {
        /// Which.
        what: &'static str,
        /// What it is.
        value: f64,
        /// What it must be.
        expected: &'static str,
    },
}

/// Metres of the farthest horizon: more would be loaded than memory takes.
const FARTHEST: f64 = 100_000.0;
/// Pixels; lower ones would fade while crossed pictures do.
const LOWEST_SOLID: f64 = 60.0;

impl Choices {
    /// Refuses what makes no frame.
    pub(super) fn check(&self) -> Result<(), FrameError> {
        let of = |what, value: f64, expected, is_good: bool| {
            if is_good { Ok(()) } else { Err(FrameError::Choice { what, value, expected }) }
        };
        of("the horizon", self.horizon, "0 to 100,000 metres", (0.0..=FARTHEST).contains(&self.horizon))?;
        of("the tolerance", self.tolerance, "above 0 pixels", self.tolerance > 0.0 && self.tolerance.is_finite())?;
        let covers = self.cover_tolerance.unwrap_or(1.0);
        of("the cover tolerance", covers, "above 0 metres", covers > 0.0 && covers.is_finite())?;
        let solid = self.solid_above.unwrap_or(LOWEST_SOLID);
        let is_good = solid >= LOWEST_SOLID && solid.is_finite();
        of("the height of meshes", solid, "60 pixels or more", is_good)?;
        of("the threshold", self.threshold, "0 to 1", (0.0..=1.0).contains(&self.threshold))
    }
}
