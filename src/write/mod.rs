//! Writing scenes: what was read or generated, as files that others can read.
//!
//! Scene -WRITE-> text. The opposite direction of `parse`; it knows nothing of the view's pixels.

mod annotation;
mod fcell;
mod ftri;
mod losses;
mod nff;
mod number;
mod sipp;

pub use fcell::write_fcell;
pub use ftri::write_ftri;
pub use nff::{POLYGONIZED_SEGMENTS, write_nff};
pub use sipp::write_sipp;
