//! The grammar of NFF, in nom combinators.
//!
//! words, numbers -GRAMMAR-> Statement -build-> Scene
//!
//! ```text
//! v   from x y z  at x y z  up x y z  angle a  hither h  resolution w h
//! b   r g b                       l   x y z [r g b]
//! f   r g b Kd Ks shine T index   s   x y z radius
//! c   x y z radius  x y z radius  p n (x y z)*n      pp n (x y z nx ny nz)*n
//! ```
//! What the numbers may be is not its business: it says what stands where, [`super::build`] says what it means.
//!
//! A parser's input is the rest of the text ([`crate::parse::tokens`]). Vertices go into lists that are used again
//! for every polygon: nothing is allocated for a polygon, and `p 1000000000` allocates only what follows it.
//! Source: E. Haines, "Neutral File Format", NFF.TXT 3.9, in the Standard Procedural Databases.

use crate::color::Rgb;
use crate::math::Vec3;
use crate::parse::tokens;
use nom::error::{ErrorKind, ParseError};
use nom::multi::fold;
use nom::sequence::preceded;
use nom::{IResult, Parser, combinator::opt};
use std::cell::Cell;

/// The words that start a statement.
pub(in crate::parse) const KEYWORDS: [&str; 8] = ["v", "b", "l", "f", "c", "s", "p", "pp"];
/// The fields of a view, in their order.
pub(super) const VIEW_FIELDS: [&str; 6] = ["from", "at", "up", "angle", "hither", "resolution"];

/// What was expected where the text goes on otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    Number,
    WholeNumber,
    Field(&'static str),
}

/// The text does not match the grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Mismatch {
    /// Length of the tail that starts with the word in question (0: the text ends).
    pub(super) tail_length: usize,
    pub(super) wanted: Wanted,
}

impl ParseError<&[u8]> for Mismatch {
    fn from_error_kind(tail: &[u8], _: ErrorKind) -> Self {
        Mismatch { tail_length: tail.len(), wanted: Wanted::Number }
    }

    // The innermost mismatch says most.
    fn append(_: &[u8], _: ErrorKind, inner: Self) -> Self {
        inner
    }
}

/// The tail behind what was read, and what was read.
pub(super) type Read<'a, T> = IResult<&'a [u8], T, Mismatch>;

/// One statement, as written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Statement {
    View(View),
    Background(Rgb),
    Light {
        position: Vec3,
        color: Option<Rgb>,
    },
    Surface {
        color: Rgb,
        diffuse: f64,
        specular: f64,
        shine: f64,
        transmitted: f64,
        refraction: f64,
    },
    Cone {
        base: Vec3,
        base_radius: f64,
        apex: Vec3,
        apex_radius: f64,
    },
    Sphere {
        center: Vec3,
        radius: f64,
    },
    /// A `p`: its vertices are in [`Corners`].
    Polygon,
    /// A `pp`: its vertices and normals are in [`Corners`].
    Patch,
}

/// A view, as written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct View {
    pub(super) from: Vec3,
    pub(super) at: Vec3,
    pub(super) up: Vec3,
    pub(super) angle: f64,
    pub(super) hither: f64,
    pub(super) resolution: (i64, i64),
}

/// The vertices of the polygon read last, also if it ended too early.
#[derive(Clone, Debug, Default)]
pub(super) struct Corners {
    /// How many it says it has; `None` until that is read.
    pub(super) declared: Option<i64>,
    pub(super) positions: Vec<Vec3>,
    /// As many as `positions` for a `pp`, none for a `p`.
    pub(super) normals: Vec<Vec3>,
}

/// The parsers, and what they have to tell besides what they read.
#[derive(Debug, Default)]
pub(super) struct Grammar {
    /// How many numbers were too small, and the length of the tail at the first.
    pub(super) vanished: Cell<Option<(usize, usize)>>,
}

impl Grammar {
    /// Reads what follows a keyword; `None` where the word is not a keyword.
    pub(super) fn statement<'a>(
        &self,
        keyword: &[u8],
        tail: &'a [u8],
        corners: &mut Corners,
    ) -> Option<Read<'a, Statement>> {
        let number = |tail| self.number(tail);
        let point = |tail| self.point(tail);
        let color = |tail| self.color(tail);
        Some(match keyword {
            b"p" => self.polygon(tail, corners),
            b"pp" => self.patch(tail, corners),
            b"v" => self.view(tail),
            b"b" => color.map(Statement::Background).parse(tail),
            b"l" => (point, opt(color)).map(|(position, color)| Statement::Light { position, color }).parse(tail),
            b"f" => self.surface(tail),
            b"s" => (point, number).map(|(center, radius)| Statement::Sphere { center, radius }).parse(tail),
            b"c" => (point, number, point, number)
                .map(|(base, base_radius, apex, apex_radius)| Statement::Cone { base, base_radius, apex, apex_radius })
                .parse(tail),
            _ => return None,
        })
    }

    fn view<'a>(&self, tail: &'a [u8]) -> Read<'a, Statement> {
        let number = |tail| self.number(tail);
        let point = |tail| self.point(tail);
        (
            preceded(field("from"), point),
            preceded(field("at"), point),
            preceded(field("up"), point),
            preceded(field("angle"), number),
            preceded(field("hither"), number),
            preceded(field("resolution"), (whole_number, whole_number)),
        )
            .map(|(from, at, up, angle, hither, resolution)| View { from, at, up, angle, hither, resolution })
            .map(Statement::View)
            .parse(tail)
    }

    fn surface<'a>(&self, tail: &'a [u8]) -> Read<'a, Statement> {
        let number = |tail| self.number(tail);
        (|tail| self.color(tail), number, number, number, number, number)
            .map(|(color, diffuse, specular, shine, transmitted, refraction)| Statement::Surface {
                color,
                diffuse,
                specular,
                shine,
                transmitted,
                refraction,
            })
            .parse(tail)
    }

    fn polygon<'a>(&self, tail: &'a [u8], corners: &mut Corners) -> Read<'a, Statement> {
        let (tail, count) = corners.start(tail)?;
        let vertex = |tail| self.point(tail);
        let (tail, ()) =
            fold(count..=count, vertex, || (), |(), position| corners.positions.push(position)).parse(tail)?;
        Ok((tail, Statement::Polygon))
    }

    fn patch<'a>(&self, tail: &'a [u8], corners: &mut Corners) -> Read<'a, Statement> {
        let (tail, count) = corners.start(tail)?;
        let vertex = (|tail| self.point(tail), |tail| self.point(tail));
        let keep = |(), (position, normal)| {
            corners.positions.push(position);
            corners.normals.push(normal);
        };
        let (tail, ()) = fold(count..=count, vertex, || (), keep).parse(tail)?;
        Ok((tail, Statement::Patch))
    }

    #[inline]
    fn point<'a>(&self, tail: &'a [u8]) -> Read<'a, Vec3> {
        let number = |tail| self.number(tail);
        (number, number, number).map(|(x, y, z)| Vec3::new(x, y, z)).parse(tail)
    }

    fn color<'a>(&self, tail: &'a [u8]) -> Read<'a, Rgb> {
        let number = |tail| self.number(tail);
        (number, number, number).map(|(r, g, b)| Rgb::new(r, g, b)).parse(tail)
    }

    #[inline(always)]
    fn number<'a>(&self, tail: &'a [u8]) -> Read<'a, f64> {
        let tail = tokens::skip_space(tail);
        match tokens::number(tail) {
            Ok(number) => {
                if number.vanished {
                    let (count, first) = self.vanished.get().unwrap_or((0, tail.len()));
                    self.vanished.set(Some((count + 1, first)));
                }
                Ok((&tail[number.length..], number.value))
            }
            Err(_) => Err(mismatch(tail, Wanted::Number)),
        }
    }
}

impl Corners {
    /// Empties the lists and reads how many vertices follow.
    fn start<'a>(&mut self, tail: &'a [u8]) -> Read<'a, usize> {
        self.declared = None;
        self.positions.clear();
        self.normals.clear();
        let (rest, declared) = whole_number(tail)?;
        self.declared = Some(declared);
        match usize::try_from(declared) {
            Ok(count) => Ok((rest, count)),
            Err(_) => Err(mismatch(tokens::skip_space(tail), Wanted::WholeNumber)),
        }
    }
}

/// An integer: the sizes of pictures and polygons.
fn whole_number(tail: &[u8]) -> Read<'_, i64> {
    let tail = tokens::skip_space(tail);
    let word = tokens::word(tail);
    match str::from_utf8(word).ok().and_then(|digits| digits.parse().ok()) {
        Some(value) => Ok((&tail[word.len()..], value)),
        None => Err(mismatch(tail, Wanted::WholeNumber)),
    }
}

/// The name of a field of `v`.
fn field<'a>(name: &'static str) -> impl Parser<&'a [u8], Output = (), Error = Mismatch> {
    move |tail| {
        let tail = tokens::skip_space(tail);
        let word = tokens::word(tail);
        if word == name.as_bytes() { Ok((&tail[word.len()..], ())) } else { Err(mismatch(tail, Wanted::Field(name))) }
    }
}

#[cold]
fn mismatch(tail: &[u8], wanted: Wanted) -> nom::Err<Mismatch> {
    let mismatch = Mismatch { tail_length: tail.len(), wanted };
    // `l` may end before its color, but not in a number that is badly written.
    if tokens::looks_numeric(tokens::word(tail)) { nom::Err::Failure(mismatch) } else { nom::Err::Error(mismatch) }
}
