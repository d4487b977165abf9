//! Import: polygons of stands, a table of what grows on them and measured heights, as an area.
//!
//! Layer (stands), records (inventory), Grid (relief) -IMPORT-> Area -pack, write::fcell-> `.fpack`, `.fcell`
//!
//! Space: files lie in the projection that they say; the area is on a map of UTM, in cells.

mod cut;
mod ways;

pub use cut::{Tangled, cut, land};
pub use ways::stretches;
