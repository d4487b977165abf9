//! Program rules: what programs do to whole polygons and pictures, right or with a slip: shapes, masks, blocks, memory.
//!
//! Part of [`super::rules`]; [`super::shape`], [`super::covering`], [`super::memory`] and [`super::stack`] compute with them.
//!
//! Space: samples.

use super::case::Face;
use super::summed::span;

/// How a polygon is changed before it is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// It is cut into triangles from its first corner, each with its own depth: right for convex outlines.
    pub is_fan: bool,
    /// Depth and values go with corners that were rounded or turned.
    pub planes_follow: bool,
    /// Corners are turned; unless planes follow, they stay.
    pub turned: Turned,
}

impl Shape {
    /// It stays.
    pub const RIGHT: Shape = Shape { is_fan: false, planes_follow: false, turned: Turned::No };
}

/// How corners are turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turned {
    /// Not at all.
    No,
    /// y runs up.
    UpsideDown,
    /// x runs to the left.
    Mirrored,
    /// Both.
    Half,
    /// x and y are exchanged.
    Transposed,
}

/// What of one polygon's samples is left to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stencil {
    /// Nothing.
    Cleared,
    /// A mask that is turned over.
    Toggled,
    /// A mask that is added to.
    Added,
    /// First and last column of every row.
    Rows,
}

/// What is decided for a block of samples at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// Its sides.
    pub size: (i32, i32),
    /// The sample of it that decides, counted from its first.
    pub at: (i32, i32),
    /// Blocks begin at the polygon's bounds, not at those of the picture.
    pub from_bounds: bool,
    /// It decides coverage.
    pub of_cover: bool,
    /// Values.
    pub of_values: bool,
    /// Depth.
    pub of_depth: bool,
}

impl Block {
    /// Nothing is.
    pub const ONE: Block =
        Block { size: (1, 1), at: (0, 0), from_bounds: false, of_cover: false, of_values: false, of_depth: false };

    /// The sample that decides about another.
    pub(super) fn of(self, face: &Face, (x, y): (i32, i32)) -> (i32, i32) {
        let least =
            |pick: fn(&(f64, f64)) -> f64| face.corners.iter().map(pick).fold(f64::INFINITY, f64::min).floor() as i32;
        let (left, top) = if self.from_bounds { (least(|corner| corner.0), least(|corner| corner.1)) } else { (0, 0) };
        (x - (x - left).rem_euclid(self.size.0) + self.at.0, y - (y - top).rem_euclid(self.size.1) + self.at.1)
    }
}

/// Where the depth of a sample is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DepthPoint {
    /// Where values are.
    Own,
    /// So far beside that.
    Beside(f64, f64),
    /// At this x.
    AtX(f64),
    /// At this y.
    AtY(f64),
    /// At one place.
    At(f64, f64),
}

impl DepthPoint {
    pub(super) fn of(self, (x, y): (f64, f64)) -> (f64, f64) {
        match self {
            DepthPoint::Own => (x, y),
            DepthPoint::Beside(dx, dy) => (x + dx, y + dy),
            DepthPoint::AtX(fixed) => (fixed, y),
            DepthPoint::AtY(fixed) => (x, fixed),
            DepthPoint::At(x, y) => (x, y),
        }
    }
}

/// What x and y are counted from, where a plane is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The picture's upper left corner.
    Picture,
    /// x from the first sample of the span.
    Span,
    /// Both from the upper left sample of the polygon's bounds.
    Bounds,
    /// Both from the first corner.
    FirstCorner,
}

impl Origin {
    /// A point of the picture as it is counted.
    pub(super) fn of(self, face: &Face, (x, y): (f64, f64)) -> (f64, f64) {
        let least = |pick: fn(&(f64, f64)) -> f64| face.corners.iter().map(pick).fold(f64::INFINITY, f64::min).floor();
        match self {
            Origin::Picture => (x, y),
            Origin::Span => (x - span(face, (x, y)).map_or(0.0, |span| span.0.floor()), y),
            Origin::Bounds => (x - least(|corner| corner.0), y - least(|corner| corner.1)),
            Origin::FirstCorner => (x - face.corners[0].0, y - face.corners[0].1),
        }
    }
}

/// Which depth is kept at a sample for those that come later.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kept {
    /// That of what is shown.
    Shown,
    /// That of what was shown first.
    First,
    /// That of whatever came last, shown or not.
    Latest,
    /// The sum of all that were shown.
    Sum,
    /// The farthest that was shown.
    Farthest,
    /// That of what is shown, cut down to so many steps a unit.
    Cut(f64),
    /// The same, rounded.
    Rounded(f64),
    /// That of what is shown, and this.
    More(f64),
}

impl Kept {
    /// What is kept when a face at some depth came, and showed or not.
    pub(super) fn after(self, kept: Option<f64>, (depth, is_shown): (f64, bool)) -> Option<f64> {
        let shown = if is_shown { Some(depth) } else { kept };
        match self {
            Kept::Shown => shown,
            Kept::First => kept.or(shown),
            Kept::Latest => Some(depth),
            Kept::Sum if is_shown => Some(kept.unwrap_or(0.0) + depth),
            Kept::Sum => kept,
            Kept::Farthest if is_shown => Some(kept.map_or(depth, |kept| kept.min(depth))),
            Kept::Farthest => kept,
            Kept::Cut(steps) if is_shown => Some((depth * steps).floor() / steps),
            Kept::Rounded(steps) if is_shown => Some((depth * steps).round() / steps),
            Kept::More(more) if is_shown => Some(depth + more),
            Kept::Cut(_) | Kept::Rounded(_) | Kept::More(_) => kept,
        }
    }
}

/// Where depth and color of a sample are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Memory {
    /// Depth.
    pub depth_at: Address,
    /// Color; it is read at its own place.
    pub color_at: Address,
    /// The order in which samples of a polygon are drawn.
    pub walk: Walk,
    /// Columns and rows from a sample to that whose depth is looked up.
    pub read_beside: (i32, i32),
    /// To that whose depth is written.
    pub written_beside: (i32, i32),
}

/// The order in which samples of a polygon are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Walk {
    /// Row by row.
    Rows,
    /// Column by column.
    Columns,
    /// Block by block of the picture.
    Blocks(i32),
    /// Block by block from the polygon's bounds on.
    BlocksOfBounds(i32),
}

impl Walk {
    /// Sorts a polygon's samples.
    pub(super) fn sort(self, face: &Face, samples: &mut [(i32, i32)]) {
        let block = |size: i32, from_bounds: bool| Block { size: (size, size), from_bounds, ..Block::ONE };
        match self {
            Walk::Rows => {}
            Walk::Columns => samples.sort_unstable(),
            Walk::Blocks(size) | Walk::BlocksOfBounds(size) => {
                let block = block(size, matches!(self, Walk::BlocksOfBounds(_)));
                samples.sort_by_key(|&(x, y)| {
                    let (left, top) = block.of(face, (x, y));
                    (top, left, y, x)
                });
            }
        }
    }
}

impl Memory {
    /// Each at its own place.
    pub const RIGHT: Memory = Memory {
        depth_at: Address::Own,
        color_at: Address::Own,
        walk: Walk::Rows,
        read_beside: (0, 0),
        written_beside: (0, 0),
    };
}

/// The address of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Address {
    /// y * width + x.
    Own,
    /// y * height + x.
    TimesHeight,
    /// x * height + y.
    ByColumns,
    /// x * width + y.
    ColumnTimesWidth,
    /// y * (width + this) + x.
    Stride(i32),
    /// One for all samples of a pixel.
    Pixel,
    /// One for all samples of a row.
    Row,
    /// One for all samples of a column.
    Column,
    /// One for all.
    One,
}

/// By how much a sample may lie outside and still be inside; less than nothing makes polygons smaller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Slack {
    /// Each weight of a triangle may be so small.
    Weight(f64),
    /// Each cross product may.
    Cross(f64),
    /// Each distance to an edge may.
    Distance(f64),
}

/// Polygons that are left out for what they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dropped {
    /// None.
    None,
    /// Those with more corners than this.
    MoreCorners(usize),
    /// Those with fewer.
    FewerCorners(usize),
    /// Those that reach a side of the picture.
    AtBorder,
    /// Those that reach the left or upper side.
    AtFirst,
    /// Those that reach the right or lower side.
    AtLast,
    /// Those that are less than this wide or high.
    Thin(f64),
    /// Those that are less than this wide and high.
    Small(f64),
    /// Those whose bounds have more samples than this.
    Large(f64),
}

impl Dropped {
    /// Whether a polygon is left out.
    pub(super) fn has(self, corners: &[(f64, f64)], (low, high): ((f64, f64), (f64, f64)), size: (i32, i32)) -> bool {
        let (width, height) = (high.0 - low.0, high.1 - low.1);
        let at_first = low.0 <= 0.0 || low.1 <= 0.0;
        let at_last = high.0 >= f64::from(size.0) || high.1 >= f64::from(size.1);
        match self {
            Dropped::None => false,
            Dropped::MoreCorners(most) => corners.len() > most,
            Dropped::FewerCorners(least) => corners.len() < least,
            Dropped::AtBorder => at_first || at_last,
            Dropped::AtFirst => at_first,
            Dropped::AtLast => at_last,
            Dropped::Thin(least) => width < least || height < least,
            Dropped::Small(least) => width < least && height < least,
            Dropped::Large(most) => width * height > most,
        }
    }
}
