//! Shapes: what a view shows, each object with its look, in the metres of the area.
//!
//! Map, view, projection of the area -SHAPES-> shapes, the lowest first
//!
//! Space: each layer's projection in, the area's metres out. Cost: one projection a position.

use super::{Length, Map, MapView, Style, Unit};
use crate::forest::polygon::Point;
use crate::forest::vector::{Crs, Geometry, Rings};

/// An object as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Where, in metres of the area.
    pub geometry: Geometry,
    /// Lines, outlines.
    pub pen: Option<Pen>,
    /// The inside of polygons; points.
    pub fill: Option<[u8; 3]>,
    /// Diameter of points.
    pub size: Length,
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Display values.
    pub color: [u8; 3],
    /// From side to side.
    pub width: Length,
    /// Metres that are drawn, and left out.
    pub dash: Option<[f64; 2]>,
}

/// Why a map cannot lie on an area.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MapError {
    /// The area has no projection that is known here.
    #[error(
        "layer `{layer}` is in EPSG:{code}, and the area does not say in which projection it is (`{area}`): write `crs EPSG:326zz` or `EPSG:327zz`, a zone of UTM, in the area"
    )]
    AreaUnknown {
        /// Whose.
        layer: String,
        /// Of the layer.
        code: u32,
        /// What the area says.
        area: String,
    },
    /// Nothing of it lies on the area.
    #[error(
        "nothing of the map's view `{view}` lies within the area: from {from:?} to {to:?} metres, and the map from {map_from:?} to {map_to:?}{advice}"
    )]
    Elsewhere {
        /// Which view.
        view: String,
        /// South-west corner of the area, in its metres.
        from: [i64; 2],
        /// North-east corner.
        to: [i64; 2],
        /// South-west corner of the map.
        map_from: [i64; 2],
        /// North-east corner.
        map_to: [i64; 2],
        /// What may be wrong.
        advice: &'static str,
    },
}

/// A black line one pixel wide, points of six: where nobody says how.
const USUAL_WIDTH: Length = Length { value: 1.0, unit: Unit::Pixels };
const USUAL_SIZE: Length = Length { value: 6.0, unit: Unit::Pixels };

/// What `view` shows, the lowest first, on an area whose projection and origin are these.
///
/// # Errors
/// [`MapError::AreaUnknown`].
pub fn shapes(map: &Map, view: &MapView, (crs, origin): (&str, [f64; 2])) -> Result<Vec<Shape>, MapError> {
    let Some(area) = Crs::named(crs) else {
        return match first_placed(map, view) {
            Some((layer, of)) => {
                Err(MapError::AreaUnknown { layer: layer.to_string(), code: of.code(), area: crs.to_string() })
            }
            None => Ok(shapes_by(map, view, &|_, point| point)),
        };
    };
    let to_area = |of: Crs, point: Point| {
        let [east, north] = of.to(area, point);
        [east - origin[0], north - origin[1]]
    };
    Ok(shapes_by(map, view, &to_area))
}

/// The first layer of `view`, the lowest first, that has a projection.
#[must_use]
pub fn first_placed<'a>(map: &'a Map, view: &MapView) -> Option<(&'a str, Crs)> {
    let layers = view.themes.iter().rev().map(|&theme| &map.layers[map.themes[theme].layer]);
    layers.filter_map(|layer| Some((layer.name.as_str(), layer.crs?))).next()
}

/// What `view` shows, the lowest first; `to_land` takes positions of a projection to metres of the land. Layers without one are in these metres.
#[must_use]
pub fn shapes_by(map: &Map, view: &MapView, to_land: &dyn Fn(Crs, Point) -> Point) -> Vec<Shape> {
    let mut shapes = Vec::new();
    for theme in view.themes.iter().rev().map(|&theme| &map.themes[theme]) {
        let layer = &map.layers[theme.layer];
        let place = |point: Point| layer.crs.map_or(point, |of| to_land(of, point));
        let shown = layer.features.iter().filter(|feature| theme.conditions.iter().all(|it| it.holds(feature)));
        shapes.extend(shown.map(|feature| {
            let style = theme.style.of(&theme.cases, feature);
            looking(moved(&feature.geometry, place), style)
        }));
    }
    shapes
}

/// A shape with its look: polygons have an outline only where a color says so, lines and points are black where none does.
fn looking(geometry: Geometry, style: Style) -> Shape {
    let width = style.width.unwrap_or(USUAL_WIDTH);
    let pen = |color| Pen { color, width, dash: style.dash };
    let color = style.color.unwrap_or([0; 3]);
    let (pen, fill) = match &geometry {
        Geometry::Points(_) => (None, Some(style.color.or(style.fill).unwrap_or([0; 3]))),
        Geometry::Lines(_) => (Some(pen(color)), None),
        Geometry::Polygons(_) if style.color.is_none() && style.fill.is_none() => (Some(pen(color)), None),
        Geometry::Polygons(_) => (style.color.map(pen), style.fill),
    };
    Shape { geometry, pen, fill, size: style.size.unwrap_or(USUAL_SIZE) }
}

/// A geometry with every position moved.
fn moved(geometry: &Geometry, place: impl Fn(Point) -> Point) -> Geometry {
    let all = |points: &[Point]| points.iter().map(|&point| place(point)).collect::<Vec<_>>();
    match geometry {
        Geometry::Points(points) => Geometry::Points(all(points)),
        Geometry::Lines(lines) => Geometry::Lines(lines.iter().map(|line| all(line)).collect()),
        Geometry::Polygons(polygons) => Geometry::Polygons(
            polygons
                .iter()
                .map(|rings| Rings {
                    outer: all(&rings.outer),
                    holes: rings.holes.iter().map(|hole| all(hole)).collect(),
                })
                .collect(),
        ),
    }
}

impl Shape {
    /// Its positions, one behind the other.
    pub fn positions(&self) -> impl Iterator<Item = Point> + '_ {
        let (points, lines, polygons) = match &self.geometry {
            Geometry::Points(points) => (points.as_slice(), [].as_slice(), [].as_slice()),
            Geometry::Lines(lines) => ([].as_slice(), lines.as_slice(), [].as_slice()),
            Geometry::Polygons(polygons) => ([].as_slice(), [].as_slice(), polygons.as_slice()),
        };
        let rings = polygons.iter().flat_map(|rings| std::iter::once(&rings.outer).chain(&rings.holes));
        points.iter().chain(lines.iter().chain(rings).flatten()).copied()
    }
}
