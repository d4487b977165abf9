//! Land use: what OpenStreetMap calls a piece of land, as a default stand or a ground.
//!
//! attributes of a polygon -LAND USE-> a stand of usual trees, a ground, or nothing
//!
//! `natural=wood`, `landuse=forest` with `leaf_type`; also `key`, `class`, `leaf` of extracts that put tags into columns.
//! What has neither trees nor a ground of its own (houses) is left out, and told.
//!
//! Space: metres, trees a hectare. The numbers are round and ours.
//! Source: the keys are those of <https://wiki.openstreetmap.org/wiki/Map_features>.

use super::record::{Growth, Record, What};
use crate::forest::area::{Form, Plant, Spread};
use crate::forest::vector::{Attribute, Feature};
use std::collections::BTreeMap;

/// What a piece of land is.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Use {
    /// Trees: the name of the default stand.
    Trees(&'static str),
    /// A ground that the program paints.
    Ground(&'static str),
    /// Nothing that is drawn; what the file calls it.
    Nothing(String),
}

/// Name, species, form, height and crown (mean and deviation), trees a hectare, how they stand.
type Usual = (&'static str, &'static str, Form, [f64; 2], [f64; 2], f64, Plant);

/// Default stands.
const STANDS: [Usual; 5] = [
    ("needle-leaved wood", "PIN", Form::Conifer, [16.0, 3.0], [4.0, 0.8], 520.0, Plant::Poisson),
    ("broad-leaved wood", "QUE", Form::Broadleaf, [12.0, 2.5], [6.0, 1.2], 300.0, Plant::Poisson),
    ("wood", "PIN", Form::Conifer, [14.0, 3.0], [4.0, 0.8], 450.0, Plant::Poisson),
    ("scrub", "JUN", Form::Shrub, [1.6, 0.4], [1.8, 0.4], 700.0, Plant::Poisson),
    ("orchard", "MALUS", Form::Broadleaf, [4.0, 0.6], [3.6, 0.5], 280.0, Plant::Rows),
];

/// The row of a default stand.
pub(super) fn usual_stand(name: &str) -> Option<Record> {
    let (name, species, form, height, crown, density, plant) = STANDS.into_iter().find(|stand| stand.0 == name)?;
    let spread = |[mean, deviation]: [f64; 2]| Spread { mean, deviation };
    let growth = Growth {
        species: species.to_string(),
        form: Some(form),
        height: spread(height),
        crown: Some(spread(crown)),
        density,
        crown_base: None,
        plant,
        cover: None,
    };
    let origin = "the default stands".to_string();
    Some(Record { stand: name.to_string(), year: None, what: What::Grows(growth), origin })
}

/// What the polygon is; `map` says what its columns are called.
pub(super) fn of(feature: &Feature, map: &BTreeMap<String, String>) -> Use {
    let text = |name: &str| {
        let name = map.get(name).map_or(name, String::as_str);
        text_of(feature, name).map(|text| text.to_ascii_lowercase()).filter(|text| !text.is_empty())
    };
    let leaf = text("leaf_type").or_else(|| text("leaf")).or_else(|| text("wood")).unwrap_or_default();
    let keys = ["class", "natural", "landuse", "waterway", "fclass"];
    let class = keys.iter().find_map(|key| text(key)).unwrap_or_default();
    match class.as_str() {
        "forest" | "wood" => Use::Trees(match leaf.as_str() {
            "needleleaved" | "coniferous" => STANDS[0].0,
            "broadleaved" | "deciduous" => STANDS[1].0,
            _ => STANDS[2].0,
        }),
        "scrub" => Use::Trees("scrub"),
        "orchard" | "vineyard" => Use::Trees("orchard"),
        "water" | "reservoir" | "riverbank" | "basin" | "bay" => Use::Ground("water"),
        "grassland" | "meadow" | "grass" | "wetland" | "village_green" | "recreation_ground" => Use::Ground("grass"),
        "heath" | "fell" | "moor" => Use::Ground("heath"),
        "farm" | "farmland" | "farmyard" => Use::Ground("field"),
        "rock" | "bare_rock" | "scree" | "cliff" | "quarry" => Use::Ground("rock"),
        "sand" | "beach" | "dune" => Use::Ground("sand"),
        "glacier" => Use::Ground("snow"),
        other => Use::Nothing(if other.is_empty() { "without land use".to_string() } else { other.to_string() }),
    }
}

/// An attribute as text, whichever way its name is written.
pub(super) fn text_of(feature: &Feature, name: &str) -> Option<String> {
    let exact = feature.attributes.get(name);
    let found = exact.or_else(|| {
        feature.attributes.iter().find(|(own, _)| own.eq_ignore_ascii_case(name)).map(|(_, attribute)| attribute)
    });
    found.map(|attribute| match attribute {
        Attribute::Number(number) => number.to_string(),
        Attribute::Text(text) => text.trim().to_string(),
    })
}

/// What a line of a map is, and how wide: OpenStreetMap's classes of roads and waterways.
pub(super) fn line_of(feature: &Feature) -> (&'static str, f64) {
    let keys = ["class", "highway", "waterway", "fclass", "kind"];
    let class = keys.iter().find_map(|key| text_of(feature, key).filter(|text| !text.is_empty())).unwrap_or_default();
    let width = match feature.attributes.get("width") {
        Some(Attribute::Number(width)) if (0.1..=200.0).contains(width) => Some(*width),
        _ => None,
    };
    let (kind, usual) = match class.to_ascii_lowercase().trim_end_matches("_link") {
        "motorway" | "trunk" => ("road", 12.0),
        "primary" => ("road", 9.0),
        "secondary" => ("road", 8.0),
        "tertiary" => ("road", 7.0),
        "river" => ("river", 10.0),
        "canal" => ("river", 6.0),
        "stream" | "drain" | "ditch" => ("river", 2.5),
        "path" | "footway" | "steps" | "pedestrian" | "bridleway" | "cycleway" => ("path", 2.0),
        "track" => ("path", 3.0),
        _ => ("road", 5.0),
    };
    (kind, width.unwrap_or(usual))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::forest::vector::Geometry;
    use crate::scene::Place;

    fn feature(pairs: &[(&str, &str)]) -> Feature {
        let attributes =
            pairs.iter().map(|(name, text)| (name.to_string(), Attribute::Text(text.to_string()))).collect();
        Feature { attributes, geometry: Geometry::Points(vec![[0.0; 2]]), place: Place::default() }
    }

    #[test]
    fn tags_and_columns_say_the_same() {
        let of = |pairs: &[(&str, &str)]| of(&feature(pairs), &BTreeMap::new());
        assert_eq!(of(&[("natural", "wood"), ("leaf_type", "broadleaved")]), Use::Trees("broad-leaved wood"));
        assert_eq!(
            of(&[("key", "landuse"), ("class", "forest"), ("leaf", "coniferous")]),
            Use::Trees("needle-leaved wood")
        );
        assert_eq!(of(&[("landuse", "forest")]), Use::Trees("wood"));
        assert_eq!(of(&[("natural", "water")]), Use::Ground("water"));
        assert_eq!(of(&[("landuse", "residential")]), Use::Nothing("residential".to_string()));
        for (name, ..) in STANDS {
            assert!(usual_stand(name).is_some(), "{name}");
        }
    }

    #[test]
    fn roads_have_a_width_by_their_class() {
        assert_eq!(line_of(&feature(&[("class", "primary_link")])), ("road", 9.0));
        assert_eq!(line_of(&feature(&[("waterway", "stream")])), ("river", 2.5));
        assert_eq!(line_of(&feature(&[("highway", "footway")])), ("path", 2.0));
    }
}
