//! Shapefiles: shapes in `.shp`, their attributes in `.dbf`, their projection in `.prj`, all three in a `.zip` or side by side.
//!
//! bytes -crate `shapefile`-> shapes and records -SHAPEFILE-> Layer
//!
//! Source: ESRI, "Shapefile Technical Description", 1998. Cost: the files once.

use super::Vectors;
use super::rings::polygon;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::forest::polygon::{Point, contains};
use crate::forest::vector::{Attribute, Crs, Feature, Geometry, Layer};
use crate::scene::Place;
use shapefile::dbase::{self, FieldValue};
use shapefile::{PolygonRing, Shape, ShapeReader};
use std::collections::BTreeMap;
use std::io::Cursor;

/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// The files of a shapefile.
pub(super) struct Files {
    pub name: String,
    pub shp: Vec<u8>,
    pub dbf: Option<Vec<u8>>,
    pub prj: Option<Vec<u8>>,
}

fn refused(name: &str, what: impl std::fmt::Display, help: &str) -> Diagnostics {
    Diagnostics::without_source(Diagnostic::error(format!("`{name}`: {what}")).help(help))
}

/// Reads a layer.
pub(super) fn read(files: &Files) -> Result<Vectors, Diagnostics> {
    let whole = "are all of its files there and whole? `.shp`, `.dbf` and `.prj` belong together";
    let broken =
        |error: shapefile::Error| refused(&files.name, format!("no shapefile, or not all of one: {error}"), whole);
    let crs = crs(files)?;
    let mut shapes = ShapeReader::new(Cursor::new(&files.shp)).map_err(broken)?;
    let records = match &files.dbf {
        None => Vec::new(),
        Some(dbf) => {
            let reader = dbase::Reader::new(Cursor::new(dbf));
            let read = reader.and_then(|mut reader| reader.read());
            read.map_err(|error| refused(&files.name, format!("its `.dbf` cannot be read: {error}"), whole))?
        }
    };
    let mut layer = Layer { files: vec![files.name.clone()], crs: Some(crs), ..Layer::default() };
    let (mut errors, mut empty, mut kinds) = (Vec::new(), 0, BTreeMap::new());
    for (number, shape) in shapes.iter_shapes().enumerate() {
        let shape = shape.map_err(|error| refused(&files.name, format!("record {}: {error}", number + 1), whole))?;
        let kind = shape.shapetype().to_string();
        match geometry(shape, crs) {
            Ok(Some(geometry)) => {
                *kinds.entry(kind).or_default() += 1;
                let attributes = records.get(number).map(attributes).unwrap_or_default();
                layer.features.push(Feature { attributes, geometry, place: Place::default() });
            }
            Ok(None) => empty += 1,
            Err(what) if errors.len() < MOST_ERRORS => {
                errors.push(Diagnostic::error(format!("`{}`: record {}: {what}", files.name, number + 1)));
            }
            Err(_) => {}
        }
    }
    let count = layer.features.len() + empty;
    if files.dbf.is_some() && records.len() != count && errors.is_empty() {
        let what = format!("{count} shapes and {} records of attributes", records.len());
        return Err(refused(&files.name, what, whole));
    }
    let mut told = Diagnostics::default();
    if errors.is_empty() {
        let notice = |text: String| Diagnostic::notice(format!("`{}`: {text}", files.name));
        told.list.extend((empty > 0).then(|| notice(format!("{empty} records without a shape are left out"))));
        told.list.extend(
            files.dbf.is_none().then(|| notice("no `.dbf` beside it: its objects have no attributes".to_string())),
        );
        return Ok(Vectors { layer, kinds, notices: told });
    }
    told.list = errors;
    Err(told)
}

/// The projection in words: degrees on WGS 84, or a zone of UTM on it.
fn crs(files: &Files) -> Result<Crs, Diagnostics> {
    let help =
        "known are degrees on WGS 84 and zones of UTM on it: convert the file, with `ogr2ogr -t_srs EPSG:4326`, say";
    let Some(prj) = &files.prj else { return Err(refused(&files.name, "no `.prj` says what its numbers mean", help)) };
    let text = String::from_utf8_lossy(prj).to_uppercase().replace([' ', '_', '/'], "");
    let is_wgs = text.contains("WGS84") || text.contains("WGS1984");
    let zone = text.split("UTMZONE").nth(1).map(|tail| {
        let digits: String = tail.chars().take_while(char::is_ascii_digit).collect();
        (digits.parse::<u32>().unwrap_or_default(), tail[digits.len()..].starts_with('S'))
    });
    match zone {
        Some((zone @ 1..=60, south)) if is_wgs => Ok(Crs::Utm { zone, south }),
        None if is_wgs && text.starts_with("GEOGCS") => Ok(Crs::Degrees),
        _ => {
            let name = String::from_utf8_lossy(prj);
            let name = name.split('"').nth(1).unwrap_or("nothing").to_string();
            Err(refused(&files.name, format!("the projection `{name}` is not known"), help))
        }
    }
}

fn attributes(record: &dbase::Record) -> BTreeMap<String, Attribute> {
    let attribute = |value: &FieldValue| match value {
        FieldValue::Character(text) => text.clone().map(Attribute::Text),
        FieldValue::Numeric(number) => number.filter(|number| number.is_finite()).map(Attribute::Number),
        FieldValue::Float(number) => {
            number.filter(|number| number.is_finite()).map(|it| Attribute::Number(f64::from(it)))
        }
        FieldValue::Double(number) => Some(Attribute::Number(*number)),
        FieldValue::Integer(number) => Some(Attribute::Number(f64::from(*number))),
        FieldValue::Logical(yes) => yes.map(|yes| Attribute::Text(yes.to_string())),
        FieldValue::Date(date) => date.as_ref().map(|date| Attribute::Text(date.to_string())),
        _ => None,
    };
    record.as_ref().iter().filter_map(|(name, value)| Some((name.clone(), attribute(value)?))).collect()
}

/// A shape; `None`: it has none.
fn geometry(shape: Shape, crs: Crs) -> Result<Option<Geometry>, String> {
    let lines = |parts: Vec<Vec<Point>>| {
        parts.iter().try_for_each(|part| {
            if part.len() < 2 { Err("a line of less than two positions".to_string()) } else { Ok(()) }
        })?;
        Ok::<_, String>(Geometry::Lines(parts))
    };
    // Only x and y count; heights and measures do not.
    macro_rules! plain {
        ($points:expr) => {
            $points.iter().map(|point| [point.x, point.y]).collect::<Vec<Point>>()
        };
    }
    macro_rules! rings {
        ($polygon:expr) => {
            $polygon.rings().iter().map(|ring| (matches!(ring, PolygonRing::Outer(_)), plain!(ring.points()))).collect()
        };
    }
    let geometry = match shape {
        Shape::NullShape => return Ok(None),
        Shape::Point(point) => Geometry::Points(plain!([point])),
        Shape::PointM(point) => Geometry::Points(plain!([point])),
        Shape::PointZ(point) => Geometry::Points(plain!([point])),
        Shape::Multipoint(points) => Geometry::Points(plain!(points.points())),
        Shape::MultipointM(points) => Geometry::Points(plain!(points.points())),
        Shape::MultipointZ(points) => Geometry::Points(plain!(points.points())),
        Shape::Polyline(line) => lines(line.parts().iter().map(|part| plain!(part)).collect())?,
        Shape::PolylineM(line) => lines(line.parts().iter().map(|part| plain!(part)).collect())?,
        Shape::PolylineZ(line) => lines(line.parts().iter().map(|part| plain!(part)).collect())?,
        Shape::Polygon(polygon) => polygons(rings!(polygon))?,
        Shape::PolygonM(polygon) => polygons(rings!(polygon))?,
        Shape::PolygonZ(polygon) => polygons(rings!(polygon))?,
        Shape::Multipatch(_) => return Err("a multipatch: known are points, lines and polygons".to_string()),
    };
    check(&geometry, crs).map(|()| Some(geometry))
}

/// Each hole goes to the outline that surrounds it.
fn polygons(rings: Vec<(bool, Vec<Point>)>) -> Result<Geometry, String> {
    let (outer, holes): (Vec<_>, Vec<_>) = rings.into_iter().partition(|(is_outer, _)| *is_outer);
    let mut groups: Vec<Vec<Vec<Point>>> = outer.into_iter().map(|(_, ring)| vec![ring]).collect();
    for (number, (_, hole)) in holes.into_iter().enumerate() {
        let Some(&first) = hole.first() else { continue };
        // On its edge counts, too: then any corner that is inside tells.
        let around = |group: &&mut Vec<Vec<Point>>| hole.iter().any(|&corner| contains(&group[0], &[], corner));
        match groups.iter_mut().find(around) {
            Some(group) => group.push(hole),
            None => return Err(format!("hole {} at {first:?} is within no outline", number + 1)),
        }
    }
    Ok(Geometry::Polygons(groups.into_iter().map(polygon).collect::<Result<_, _>>()?))
}

fn check(geometry: &Geometry, crs: Crs) -> Result<(), String> {
    let (points, lines, polygons) = match geometry {
        Geometry::Points(points) => (points.as_slice(), [].as_slice(), [].as_slice()),
        Geometry::Lines(lines) => ([].as_slice(), lines.as_slice(), [].as_slice()),
        Geometry::Polygons(polygons) => ([].as_slice(), [].as_slice(), polygons.as_slice()),
    };
    let outlines = polygons.iter().map(|rings| &rings.outer);
    let wrong = points
        .iter()
        .chain(lines.iter().chain(outlines).flatten())
        .find(|[x, y]| !(x.is_finite() && y.is_finite()) || crs == Crs::Degrees && (x.abs() > 180.0 || y.abs() > 90.0));
    match wrong {
        None => Ok(()),
        Some(&[x, y]) if crs == Crs::Degrees && x.abs() <= 90.0 && y.abs() <= 180.0 => {
            Err(format!("[{x}, {y}] is no longitude and latitude: are the axes swapped? longitude comes first"))
        }
        Some(&[x, y]) => Err(format!("[{x}, {y}] is no position in its projection")),
    }
}
