//! What is odd in a `.sipp` file and drawn all the same: counted, and told once for each kind.

use crate::diagnostic::{Diagnostic, Span};

/// One kind of thing worth a notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Oddity {
    NumberVanished,
    NoArea,
    ZeroNormal,
    BrightColor,
    CameraReplaced,
    BackgroundReplaced,
    ImageReplaced,
    TwoSidedReplaced,
    NoHither,
    UpAlongView,
    NoShadows,
    TransformsLeft,
    OutlineTurned,
    PictureWithoutPlaces,
}

/// All oddities of a file.
#[derive(Default)]
pub(super) struct Notices {
    /// Kind, how many, the first.
    found: Vec<(Oddity, usize, Span)>,
    /// Those that are told one by one.
    pub told: Vec<Diagnostic>,
}

impl Notices {
    /// Counts one more.
    pub fn note(&mut self, oddity: Oddity, span: Span) {
        self.note_many(oddity, 1, span);
    }

    /// Counts `count` more, the first of them at `span`.
    pub fn note_many(&mut self, oddity: Oddity, count: usize, span: Span) {
        match self.found.iter_mut().find(|(known, ..)| *known == oddity) {
            Some((_, total, _)) => *total += count,
            None => self.found.push((oddity, count, span)),
        }
    }

    /// One notice a kind, in the order the kinds appeared, then those of their own.
    pub fn list(self) -> Vec<Diagnostic> {
        let counted = self.found.iter().map(|&(oddity, count, span)| tell(oddity, count, span));
        counted.chain(self.told).collect()
    }
}

fn tell(oddity: Oddity, count: usize, span: Span) -> Diagnostic {
    let (one, many) = subject(oddity);
    let (subject, label) = if count == 1 { (one, "here") } else { (many, "the first") };
    let notice = Diagnostic::notice(format!("{count} {subject} {}", predicate(oddity))).at(span, label);
    match oddity {
        Oddity::NoHither => notice.help("write how far from the eye the near plane is: `hither 0.1`"),
        Oddity::UpAlongView => notice.help("choose an `up` that points across the view"),
        Oddity::TransformsLeft => notice.help("put the transforms into the braces of the `use`, as SIPP would"),
        _ => notice,
    }
}

fn subject(oddity: Oddity) -> (&'static str, &'static str) {
    match oddity {
        Oddity::NumberVanished => ("number is", "numbers are"),
        Oddity::NoArea => ("polygon has", "polygons have"),
        Oddity::ZeroNormal => ("vertex has", "vertices have"),
        Oddity::BrightColor => ("color is", "colors are"),
        Oddity::CameraReplaced => ("camera was", "cameras were"),
        Oddity::BackgroundReplaced => ("background was", "backgrounds were"),
        Oddity::ImageReplaced => ("`image` was", "`image`s were"),
        Oddity::TwoSidedReplaced => ("`two_sided` was", "`two_sided`s were"),
        Oddity::NoHither | Oddity::UpAlongView => ("camera has", "cameras have"),
        Oddity::NoShadows => ("light asks", "lights ask"),
        Oddity::TransformsLeft => ("use starts", "uses start"),
        Oddity::OutlineTurned => ("outline was", "outlines were"),
        Oddity::PictureWithoutPlaces => ("surface has", "surfaces have"),
    }
}

fn predicate(oddity: Oddity) -> &'static str {
    match oddity {
        Oddity::NumberVanished => "too small and read as 0",
        Oddity::NoArea => "no area, all vertices are on one line: dropped",
        Oddity::ZeroNormal => "the normal 0 0 0: as if none were given",
        Oddity::BrightColor => "brighter than 1: kept, and cut off in the picture",
        Oddity::CameraReplaced | Oddity::BackgroundReplaced | Oddity::ImageReplaced | Oddity::TwoSidedReplaced => {
            "replaced by a later one: the last counts"
        }
        Oddity::NoHither => "no `hither` above 0: a thousandth of the distance from `from` to `at` is used",
        Oddity::UpAlongView => "`up` along the line of sight: another axis is used",
        Oddity::NoShadows => "for shadows: farop draws none",
        Oddity::TransformsLeft => {
            "from the identity: the transforms at the top of the object that is used do not count"
        }
        Oddity::PictureWithoutPlaces => {
            "a picture and no texture coordinates: drawn without it; write `t U V 0` behind the vertices of polygons"
        }
        Oddity::OutlineTurned => "clockwise: turned round, the first point stays the first",
    }
}
