//! Map: layers of vectors, how they look, and what of them is shown; drawn into a texture, or asked place by place.
//!
//! `.fmap`, GeoJSON, shapefile -parse-> MAP -SHAPES-> shapes in the area's metres -DRAW-> texels -`drape`-> the ground
//!                                                                            -FIELD-> the exact picture, sample by sample
//!
//! Why a texture and not polygons on the relief: a road that is cut along the triangles of the land must be cut anew whenever triangles change,
//! and floats or sinks where they are coarse. A texture lies on whatever land is drawn.
//! Why the exact picture too: a texture has as many texels as it has. What it blurs is seen beside the picture that asks the vectors themselves at every sample.
//!
//! Space: metres of the area, x east, y north, from the south-west corner of cell (0, 0). Source: paper 001. Text is not drawn.

mod draw;
mod field;
mod fill;
mod shapes;
mod style;

pub use draw::draw;
pub use field::Exact;
pub use shapes::{MapError, Pen, Shape, first_placed, shapes, shapes_by};
pub use style::{Case, Condition, Length, Operator, Ramp, Style, Unit};

use super::vector::Layer;
use crate::scene::Place;

/// Everything that a `.fmap` says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map {
    /// Names of the files it came from; [`Place::file`] points here.
    pub files: Vec<String>,
    /// Vectors.
    pub layers: Vec<Layer>,
    /// How some of them look.
    pub themes: Vec<Theme>,
    /// What is shown together.
    pub views: Vec<MapView>,
}

/// Objects of a layer, and how they look.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// What views call it.
    pub name: String,
    /// Index of its layer.
    pub layer: usize,
    /// What an object must be to be shown; all of them.
    pub conditions: Vec<Condition>,
    /// How objects look that no case says more of.
    pub style: Style,
    /// Looks by attribute, the first that fits.
    pub cases: Vec<Case>,
    /// Where it was declared.
    pub place: Place,
}

/// Themes that are shown together.
#[derive(Clone, Debug, PartialEq)]
pub struct MapView {
    /// What the command line calls it.
    pub name: String,
    /// Indices of its themes, the one on top first.
    pub themes: Vec<usize>,
    /// Where it was declared.
    pub place: Place,
}

impl Map {
    /// The view of that name, or the first; `None` where there is none.
    #[must_use]
    pub fn view(&self, name: Option<&str>) -> Option<&MapView> {
        match name {
            Some(name) => self.views.iter().find(|view| view.name == name),
            None => self.views.first(),
        }
    }
}

#[cfg(test)]
mod tests;
