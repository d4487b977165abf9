//! What the reader dropped, replaced or found odd: counted, and told once for each kind.
//!
//! Why counted: a scene with ten thousand zero-area polygons deserves one line, not ten thousand.

use crate::diagnostic::{Diagnostic, Span};

/// One kind of thing worth a notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Oddity {
    /// A number that is not 0 and rounds to 0.
    NumberVanished,
    /// A polygon of 0, 1 or 2 vertices.
    TooFewVertices,
    /// All vertices of a polygon on one line.
    NoArea,
    /// A vertex normal of a `pp` that is 0 0 0.
    ZeroNormal,
    /// A `pp` whose order of vertices says the opposite of its normals, turned over.
    TurnedOver,
    /// The first corner of a polygon does not give the polygon's normal.
    FirstCorner,
    /// A polygon whose corners do not lie in one plane.
    NotPlanar,
    /// A sphere or cone of radius 0.
    NoRadius,
    /// A cone whose ends coincide.
    FlatCone,
    /// A color above 1.
    BrightColor,
    /// A `v` after another `v`.
    ViewReplaced,
    /// No distance to the near plane.
    NoHither,
    /// `up` points along the view.
    UpAlongView,
}

/// All oddities of a file.
#[derive(Clone, Debug, Default)]
pub(super) struct Notices {
    /// Kind, how many, the first.
    found: Vec<(Oddity, usize, Span)>,
    /// How far the worst polygon is from its plane, as a part of its size.
    residual: f64,
}

/// Text of six digits is this rough, and a little more.
const PLANAR: f64 = 1e-5;

impl Notices {
    /// Counts one more.
    pub(super) fn note(&mut self, oddity: Oddity, span: Span) {
        self.note_many(oddity, 1, span);
    }

    /// Counts `count` more, the first of them at `span`.
    pub(super) fn note_many(&mut self, oddity: Oddity, count: usize, span: Span) {
        match self.found.iter_mut().find(|(known, ..)| *known == oddity) {
            Some((_, total, _)) => *total += count,
            None => self.found.push((oddity, count, span)),
        }
    }

    /// Counts a polygon that is out of its plane by `residual` of its size, where that is more than text is rough.
    pub(super) fn note_residual(&mut self, residual: f64, span: Span) {
        if residual > PLANAR {
            self.residual = self.residual.max(residual);
            self.note(Oddity::NotPlanar, span);
        }
    }

    /// One notice a kind, in the order the kinds appeared.
    pub(super) fn list(&self) -> Vec<Diagnostic> {
        let tell = |&(oddity, count, span): &(Oddity, usize, Span)| {
            let notice = tell(oddity, count, span);
            if oddity != Oddity::NotPlanar {
                return notice;
            }
            notice.help(format!(
                "the worst is out of its plane by {:.2e} of its size; triangles are always planar",
                self.residual
            ))
        };
        self.found.iter().map(tell).collect()
    }
}

fn tell(oddity: Oddity, count: usize, span: Span) -> Diagnostic {
    let (one, many, help) = match oddity {
        Oddity::NumberVanished => ("number is", "numbers are", None),
        Oddity::TooFewVertices => ("polygon has", "polygons have", None),
        Oddity::NoArea => ("polygon has", "polygons have", None),
        Oddity::ZeroNormal => ("vertex has", "vertices have", None),
        Oddity::TurnedOver => ("patch was", "patches were", Some("`--winding file` keeps the order of the file")),
        Oddity::FirstCorner => ("polygon has", "polygons have", None),
        Oddity::NotPlanar => ("polygon is", "polygons are", None),
        Oddity::NoRadius => ("shape has", "shapes have", None),
        Oddity::FlatCone => ("cone has", "cones have", None),
        Oddity::BrightColor => ("color is", "colors are", None),
        Oddity::ViewReplaced => ("view was", "views were", None),
        Oddity::NoHither => {
            ("view has", "views have", Some("write how far from the eye the near plane is: `hither 0.1`"))
        }
        Oddity::UpAlongView => ("view has", "views have", Some("choose an `up` that points across the view")),
    };
    let rest = match oddity {
        Oddity::NumberVanished => "too small and read as 0",
        Oddity::TooFewVertices => "fewer than 3 vertices: dropped",
        Oddity::NoArea => "no area, all vertices are on one line: dropped",
        Oddity::ZeroNormal => "the normal 0 0 0: the polygon's own normal is used there",
        Oddity::TurnedOver => "turned over: the order of the vertices and their normals disagreed",
        Oddity::FirstCorner => "a first corner that is straight or reflex: the normal is that of the whole outline",
        Oddity::NotPlanar => "not planar: drawn in the plane of the whole outline",
        Oddity::NoRadius => "radius 0: dropped",
        Oddity::FlatCone => "both ends at the same point: drawn as a disc or ring that faces +z",
        Oddity::BrightColor => "brighter than 1: kept, and cut off in the picture",
        Oddity::ViewReplaced => "replaced by a later one: the last counts",
        Oddity::NoHither => "no `hither` above 0: a thousandth of the distance from `from` to `at` is used",
        Oddity::UpAlongView => "`up` along the line of sight: another axis is used",
    };
    let subject = if count == 1 { one } else { many };
    let label = if count == 1 { "here" } else { "the first" };
    let notice = Diagnostic::notice(format!("{count} {subject} {rest}")).at(span, label);
    match help {
        Some(help) => notice.help(help),
        None => notice,
    }
}
