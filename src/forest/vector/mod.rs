//! Vector: what a map is made of before anybody draws it: points, lines and polygons with attributes.
//!
//! GeoJSON, shapefile, `.fmap` -parse-> LAYER -style, drape-> a map on the ground
//!                                      LAYER -attributes-> stands of an area
//!
//! Why one value for all: a road of a GeoJSON file and one of a shapefile are the same road. Readers fill it, and whoever draws a map or
//! plants a forest asks it without knowing where it came from.
//!
//! Space: the layer's [`Crs`]; without one, metres of the area's own world.
//! Source: the terms are those of paper 001 (a layer is a projection and objects; an object is attributes and a geometry).

mod crs;

pub use crs::Crs;

use super::polygon::Point;
use crate::scene::Place;
use std::collections::BTreeMap;

/// Objects of one kind, in one projection.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layer {
    /// What themes call it.
    pub name: String,
    /// Names of the files it came from; [`Place::file`] points here.
    pub files: Vec<String>,
    /// What its numbers mean; `None`: metres of the area's world.
    pub crs: Option<Crs>,
    /// In the order of the file.
    pub features: Vec<Feature>,
}

/// An object of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// What is known of it, by name.
    pub attributes: BTreeMap<String, Attribute>,
    /// Where it is and what shape it has.
    pub geometry: Geometry,
    /// Where it was read.
    pub place: Place,
}

/// A thing that is known of an object.
#[derive(Clone, Debug, PartialEq)]
pub enum Attribute {
    /// A number; never NaN.
    Number(f64),
    /// A text, as written.
    Text(String),
}

/// The shape of an object. The parts of a multi-geometry stay together.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// Positions, one at least.
    Points(Vec<Point>),
    /// Lines of two or more positions each.
    Lines(Vec<Vec<Point>>),
    /// Polygons with holes.
    Polygons(Vec<Rings>),
}

/// A polygon: its outer ring, then its holes. No ring repeats its first position at the end; each has three positions or more. Whichever way they turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Rings {
    /// What surrounds it.
    pub outer: Vec<Point>,
    /// What is cut out of it.
    pub holes: Vec<Vec<Point>>,
}
