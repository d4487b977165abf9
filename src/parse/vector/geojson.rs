//! GeoJSON: objects with properties, one `Feature` each.
//!
//! Source -GEOJSON-> Layer
//!
//! The text is taken apart by `serde_json`; where each feature begins is found by counting brackets, so that a mistake in a shape has its line.
//! Positions are longitude and latitude in degrees on WGS 84, as RFC 7946 has it, unless the older member `crs` says otherwise.
//!
//! Source: RFC 7946, "The GeoJSON Format", 2016. Cost: the text once as values.

use super::Vectors;
use super::rings::polygon;
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span};
use crate::forest::polygon::Point;
use crate::forest::vector::{Attribute, Crs, Feature, Geometry, Layer};
use crate::scene::Place;
use serde_json::Value;
use std::collections::BTreeMap;

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// Reads a whole source.
pub(super) fn read(source: &Source) -> Result<Vectors, Diagnostics> {
    let text: Value = serde_json::from_slice(&source.text).map_err(|error| no_json(source, &error))?;
    let fail = |error: Diagnostic| Diagnostics::new(source, vec![error.at(Span::new(0, 1), "here")]);
    let crs = crs(&text).map_err(fail)?;
    let features = match (text.get("type").and_then(Value::as_str), text.get("features")) {
        (Some("FeatureCollection"), Some(Value::Array(features))) => features.as_slice(),
        (Some("Feature"), _) => std::slice::from_ref(&text),
        (found, _) => {
            let found = found.map_or("no `type`".to_string(), |found| format!("the type `{found}`"));
            let error = Diagnostic::error(format!("this is no GeoJSON of features: it has {found}"));
            return Err(fail(error.help("expected an object of the type `FeatureCollection` with `features`")));
        }
    };
    let (starts, mut lines) = (starts(&source.text), source.lines());
    let mut layer = Layer { files: vec![source.name.clone()], crs: Some(crs), ..Layer::default() };
    let (mut errors, mut empty, mut kinds) = (Vec::new(), 0, BTreeMap::new());
    for (number, feature) in features.iter().enumerate() {
        let start = starts.get(number).copied().unwrap_or_default();
        let line = lines.at(start as u32);
        match shape(feature, crs) {
            Ok(Some(geometry)) => {
                let kind = feature.pointer("/geometry/type").and_then(Value::as_str).unwrap_or_default();
                *kinds.entry(kind.to_string()).or_default() += 1;
                let (attributes, place) = (attributes(feature), Place { file: 0, line });
                layer.features.push(Feature { attributes, geometry, place });
            }
            Ok(None) => empty += 1,
            Err(what) if errors.len() < MOST_ERRORS => {
                let error = Diagnostic::error(format!("feature {}: {what}", number + 1));
                errors.push(error.at(Span::new(start, start + 1), "begins here"));
            }
            Err(_) => {}
        }
    }
    if !errors.is_empty() {
        return Err(Diagnostics::new(source, errors));
    }
    let notice = (empty > 0).then(|| Diagnostic::notice(format!("{empty} features without a shape are left out")));
    Ok(Vectors { layer, kinds, notices: Diagnostics::new(source, notice.into_iter().collect()) })
}

fn no_json(source: &Source, error: &serde_json::Error) -> Diagnostics {
    let before = source.text.split_inclusive(|&byte| byte == b'\n').take(error.line().saturating_sub(1));
    let at = before.map(<[u8]>::len).sum::<usize>() + error.column().saturating_sub(1);
    let at = at.min(source.text.len().saturating_sub(1));
    let wrong = Diagnostic::error("this is no JSON").at(Span::new(at, at + 1), error.to_string());
    Diagnostics::new(source, vec![wrong.help("is the file whole?")])
}

/// What positions mean.
fn crs(text: &Value) -> Result<Crs, Diagnostic> {
    let Some(crs) = text.get("crs").filter(|crs| !crs.is_null()) else { return Ok(Crs::Degrees) };
    let name = crs.pointer("/properties/name").and_then(Value::as_str).unwrap_or_default();
    Crs::named(name).ok_or_else(|| {
        let error = Diagnostic::error(format!("the projection `{name}` is not known"));
        error.help("known are EPSG:4326 (degrees) and EPSG:326zz, 327zz (zones of UTM): convert the file, with `ogr2ogr -t_srs EPSG:4326`, say")
    })
}

/// Where each feature begins: objects in the list of the member `features`, or the whole text.
fn starts(text: &[u8]) -> Vec<usize> {
    let (mut depth, mut is_text, mut is_escaped) = (0, false, false);
    let (mut starts, mut key, mut list) = (Vec::new(), None, None);
    for (at, &byte) in text.iter().enumerate() {
        if is_text {
            is_text = is_escaped || byte != b'"';
            is_escaped = byte == b'\\' && !is_escaped;
            continue;
        }
        match byte {
            b'"' => {
                is_text = true;
                key = (depth == 1).then_some(at);
            }
            b'{' | b'[' => {
                let is_features = key.is_some_and(|key| text[key..].starts_with(b"\"features\""));
                if byte == b'[' && depth == 1 && is_features {
                    list = Some(depth + 1);
                }
                if byte == b'{' && list == Some(depth) {
                    starts.push(at);
                }
                depth += 1;
            }
            b'}' | b']' => {
                depth -= 1;
                if list.is_some_and(|list| depth < list) {
                    list = None;
                }
            }
            _ => {}
        }
    }
    starts
}

fn attributes(feature: &Value) -> BTreeMap<String, Attribute> {
    let Some(Value::Object(properties)) = feature.get("properties") else { return BTreeMap::new() };
    let attribute = |value: &Value| match value {
        Value::Number(number) => number.as_f64().map(Attribute::Number),
        Value::String(text) => Some(Attribute::Text(text.clone())),
        Value::Bool(yes) => Some(Attribute::Text(yes.to_string())),
        _ => None,
    };
    properties.iter().filter_map(|(name, value)| Some((name.clone(), attribute(value)?))).collect()
}

/// The shape of a feature; `None`: it has none.
fn shape(feature: &Value, crs: Crs) -> Result<Option<Geometry>, String> {
    let Some(geometry) = feature.get("geometry").filter(|geometry| !geometry.is_null()) else { return Ok(None) };
    let kind = geometry.get("type").and_then(Value::as_str).unwrap_or_default();
    let coordinates = geometry.get("coordinates").unwrap_or(&Value::Null);
    let parts = |value: &Value| value.as_array().cloned().ok_or_else(|| "`coordinates` is no list".to_string());
    let line = |value: &Value| {
        let line = positions(value, crs)?;
        if line.len() < 2 { Err(format!("a line of {} positions: it has two or more", line.len())) } else { Ok(line) }
    };
    let rings =
        |value: &Value| polygon(parts(value)?.iter().map(|ring| positions(ring, crs)).collect::<Result<_, _>>()?);
    let geometry = match kind {
        "Point" => Geometry::Points(vec![position(coordinates, crs)?]),
        "MultiPoint" => Geometry::Points(positions(coordinates, crs)?),
        "LineString" => Geometry::Lines(vec![line(coordinates)?]),
        "MultiLineString" => Geometry::Lines(parts(coordinates)?.iter().map(line).collect::<Result<_, _>>()?),
        "Polygon" => Geometry::Polygons(vec![rings(coordinates)?]),
        "MultiPolygon" => Geometry::Polygons(parts(coordinates)?.iter().map(rings).collect::<Result<_, _>>()?),
        _ => {
            return Err(format!(
                "a shape of the type `{kind}`: known are Point, LineString, Polygon and their Multi forms"
            ));
        }
    };
    let is_empty = match &geometry {
        Geometry::Points(points) => points.is_empty(),
        Geometry::Lines(lines) => lines.is_empty(),
        Geometry::Polygons(polygons) => polygons.is_empty(),
    };
    Ok((!is_empty).then_some(geometry))
}

fn positions(value: &Value, crs: Crs) -> Result<Vec<Point>, String> {
    let list = value.as_array().ok_or("`coordinates` is no list of positions")?;
    list.iter().map(|value| position(value, crs)).collect()
}

fn position(value: &Value, crs: Crs) -> Result<Point, String> {
    let number = |index: usize| value.get(index).and_then(Value::as_f64).filter(|number| number.is_finite());
    let (Some(x), Some(y)) = (number(0), number(1)) else {
        return Err(format!("{value} is no position of two numbers"));
    };
    if crs == Crs::Degrees && (x.abs() > 180.0 || y.abs() > 90.0) {
        let advice = if x.abs() <= 90.0 && y.abs() <= 180.0 {
            "are the axes swapped? longitude comes first"
        } else {
            "are these metres? then the file must say its projection, in `crs`"
        };
        return Err(format!("[{x}, {y}] is no longitude and latitude: {advice}"));
    }
    Ok([x, y])
}
