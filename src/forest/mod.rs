//! Forest: land as it is measured, and as few triangles of it as a picture needs.
//!
//! grid files -parse::grids-> [`elevation`] -> [`relief`] -> Scene -> plan, geometry, any rasterizer
//! `.fcell` text -parse::fcell-> [`area`] <-[`pack`]-> `.fpack`; [`cells`] -> trees and ground around the observer -> Scene
//! seed -[`invent`]-> [`area`] -[`place`], [`cover`]-> trees, numbers of grounds; [`paint`] -> their pictures
//!
//! Why before the readers: a grid of heights is a value like a scene; `parse` fills it, this room thins it out. A relief ends as an
//! ordinary [`Scene`](crate::scene::Scene), so every rasterizer, lab and check takes it like any other.
//!
//! Space: metres, x east, y north, z up; grids count columns from the west and rows from the north.

pub mod area;
pub mod blend;
pub mod cells;
pub mod collide;
pub mod cover;
pub mod detail;
pub mod drape;
pub mod elevation;
pub mod frame;
pub mod frustum;
pub mod heights;
pub mod import;
pub mod invent;
mod land;
pub mod lattice;
pub mod map;
pub mod objects;
pub mod pack;
pub mod paint;
pub mod pictures;
pub mod place;
pub mod polygon;
pub mod random;
pub mod relief;
pub mod season;
pub mod silhouette;
pub mod solid;
pub mod terrain;
pub mod tree;
pub mod vector;
pub mod window;
