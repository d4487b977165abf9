//! The bank: rasterizers with one known fault each, and right ones, to judge the grader by. README.md says why it stands here.

pub mod judge;
pub mod kept;
pub mod rust;
pub mod table;
