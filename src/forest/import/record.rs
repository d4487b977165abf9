//! Record: a row of an inventory: what grows on a stand from a year on, or what is done to it.
//!
//! table, attributes of a polygon, `--cut STAND:YEAR` -> RECORD -states-> the states of a stand
//!
//! Space: metres, trees a hectare of the map.
//! Source: the fields hold those of SVS and EnVision (stand, species, DBH, height, live-crown ratio, trees an area) and the ones of `.fcell`.

use crate::forest::area::{Form, Plant, Spread};

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// What the inventory calls the stand: a number or a name.
    pub stand: String,
    /// From this year on; `None`: always.
    pub year: Option<i32>,
    /// What is there then.
    pub what: What,
    /// `file:line:column`, or the option that said it: what messages say.
    pub origin: String,
}

/// What becomes of a stand.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// It was measured.
    Grows(Growth),
    /// All trees are felled.
    Cut,
    /// All trees are burnt.
    Burnt,
    /// Small trees of a species are planted, and grow.
    Replanted {
        /// Which.
        species: String,
        /// What they look like, where it is said.
        form: Option<Form>,
    },
}

/// Trees as they were measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Growth {
    /// Code of the species.
    pub species: String,
    /// What they look like, where it is said.
    pub form: Option<Form>,
    /// Metres.
    pub height: Spread,
    /// Diameter of the crowns in metres; `None`: as usual for the form.
    pub crown: Option<Spread>,
    /// Trees a hectare.
    pub density: f64,
    /// Height of the lowest branches in metres.
    pub crown_base: Option<f64>,
    /// How they stand.
    pub plant: Plant,
    /// The ground below: a ground that the program paints, or a picture; `None`: as usual for the form.
    pub cover: Option<String>,
}
