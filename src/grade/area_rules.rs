//! Area rules: which samples a polygon covers, where they land, and what of the picture is left out.
//!
//! Part of [`super::rules`]; [`super::covered`], [`super::scan`], [`super::quarters`] and [`super::place`] compute with them.
//!
//! Space: samples.

use super::program_rules::Slack;
use super::scan::Scan;

/// Rounding of a coordinate to whole samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// Corners stay as they are.
    None,
    /// To the sample on the left, above.
    Down,
    /// To the nearest whole number.
    Nearest,
    /// To the right, down.
    Up,
    /// Down to a part of a sample: one over this.
    DownTo(u16),
    /// To the nearest of such parts.
    NearestTo(u16),
}

/// Who gets a center exactly on an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ties {
    /// As if the center lay a little to one side: signs of the step in x and y, and whether x decides first.
    Consistent {
        /// 1: a little to the right, -1: to the left.
        x: i8,
        /// 1: a little down, -1: up.
        y: i8,
        /// x decides where both could.
        x_first: bool,
    },
    /// Whoever it is a left, right, upper, lower edge of, as said: rules that leave or share some.
    Sides {
        /// Left edges belong to the polygon.
        left: bool,
        /// Right ones do.
        right: bool,
        /// Level edges above it do.
        top: bool,
        /// Level edges below it do.
        bottom: bool,
    },
    /// Everybody who touches it.
    All,
    /// Nobody.
    Nobody,
}

impl Ties {
    /// The contract's: left and top.
    pub const LEFT_TOP: Ties = Ties::Consistent { x: 1, y: 1, x_first: true };

    /// All eight rules that give every center to exactly one of the polygons around it, the contract's first.
    #[must_use]
    pub fn consistent() -> [Ties; 8] {
        let rule = |number: i32| {
            let sign = |bit: i32| if number & bit == 0 { 1 } else { -1 };
            Ties::Consistent { x: sign(1), y: sign(2), x_first: number & 4 == 0 }
        };
        [0, 1, 2, 3, 4, 5, 6, 7].map(rule)
    }

    /// In words: which edges belong to a polygon.
    #[must_use]
    pub fn words(self) -> String {
        match self {
            Ties::Consistent { x, y, x_first } => format!(
                "{} and {} edges belong to the polygon{}",
                if x > 0 { "left" } else { "right" },
                if y > 0 { "upper" } else { "lower" },
                if x_first { "" } else { ", the upper or lower side deciding first" }
            ),
            Ties::Sides { .. } => "some edges belong to both sides or to none".to_string(),
            Ties::All => "every edge belongs to the polygon".to_string(),
            Ties::Nobody => "no edge belongs to the polygon".to_string(),
        }
    }
}

/// What "inside" means.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fill {
    /// Even-odd.
    Outline,
    /// Everything between the leftmost and the rightmost crossing of the row.
    Hull,
    /// Left or right of all edges: right for convex outlines only.
    AllEdges,
    /// The bounding box.
    Box,
    /// Edges own both their ends: parity is wrong where a corner lies on a scan line.
    BothEnds,
    /// The samples that hold a corner.
    Corners,
    /// Nothing at all.
    Nothing,
    /// The bounding box without the inside.
    Outside,
    /// On one side of all edges, or a little beyond.
    Slack(Slack),
    /// Edge functions of 16-bit differences, in steps of a sample: one over this.
    Narrow(u16),
    /// Spans of an edge table.
    Scan(Scan),
    /// Boxes that are quartered until no edge comes near.
    Quarters(Quarters),
}

/// The parts an outline is cut into before it is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pieces {
    /// None: it is filled whole.
    Whole,
    /// Its first corners, this many.
    FirstCorners(usize),
    /// Triangles from a corner, counted from the first: right for convex outlines.
    Fan {
        /// The corner they meet in.
        from: usize,
        /// Triangles left out at the beginning.
        skipped: usize,
        /// Triangles left out at the end.
        lost: usize,
        /// Samples in two of them are outside again: right for all outlines.
        toggles: bool,
        /// Triangles of a polygon that is one are left out, too.
        of_all: bool,
    },
    /// Triangles of three corners in a row.
    Strip {
        /// Samples in two of them are outside again.
        toggles: bool,
    },
}

/// What is wrong with quartering boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quarters {
    /// The edge that closes the outline, or the first, is not looked at.
    EdgeForgotten {
        /// The last one; else the first.
        closing: bool,
    },
    /// Corners are looked for, not edges.
    CornersOnly,
    /// Boxes of that many samples a side are not quartered.
    Smallest(i32),
    /// Halves of odd sizes are cut.
    OddCut,
    /// One of the quarters is forgotten.
    Lost(u8),
}

/// Which way round an outline may go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Winding {
    /// Either way.
    Both,
    /// Clockwise on the screen.
    Clockwise,
    /// Counterclockwise on the screen.
    CounterClockwise,
}

/// How much of the bounds is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bounds {
    /// Columns lost on the left and right, rows lost above and below.
    pub lost: [i32; 4],
    /// What the bounds are.
    pub by: BoundsBy,
    /// The corners that they are taken from.
    pub of: BoundsOf,
}

/// The corners that bounds are taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundsOf {
    /// All.
    All,
    /// The first three.
    FirstThree,
    /// The first and the third: right for some rectangles.
    FirstAndThird,
    /// All but the last.
    AllButLast,
    /// All, but this side (left, right, top, bottom) is that of the first corner.
    SideOfFirst(usize),
    /// The same, of the last corner.
    SideOfLast(usize),
    /// The same, of the second corner.
    SideOfSecond(usize),
}

impl Bounds {
    /// All of them.
    pub const WHOLE: Bounds = Bounds { lost: [0; 4], by: BoundsBy::Floor, of: BoundsOf::All };
}

/// What the bounds of a polygon are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundsBy {
    /// From floor(least) to floor(greatest).
    Floor,
    /// The same, cut to the picture.
    Clipped,
    /// From the first to the last center between them.
    Centers,
    /// From ceil(least) to floor(greatest) - 1: whole samples only.
    Inner,
    /// From round(least) to round(greatest), without that.
    Rounded,
    /// As many whole blocks as there are.
    Blocks(Blocks),
}

/// Bounds that are walked in whole blocks of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Blocks {
    /// Samples a side.
    pub side: i32,
    /// Rows are not walked in blocks.
    pub across_only: bool,
    /// Where they begin.
    pub start: BlockStart,
    /// Where the bounds end.
    pub end: BlockEnd,
}

/// Where whole blocks begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockStart {
    /// At floor(least).
    Floor,
    /// At the first center.
    Center,
    /// At the block of the picture that floor(least) is in.
    BlockBefore,
    /// At the next block of the picture.
    BlockBehind,
}

/// Where bounds end, that sample not included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockEnd {
    /// At floor(greatest) + 1.
    Floor,
    /// At ceil(greatest).
    Ceil,
    /// Behind the last center.
    Center,
}

/// Which part of the picture is never drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border {
    /// All is drawn.
    None,
    /// The last column is not.
    LastColumn,
    /// The last row is not.
    LastRow,
    /// Neither of both is.
    LastBoth,
    /// The first column is not.
    FirstColumn,
    /// The first row is not.
    FirstRow,
    /// What lies beyond the smaller side is not.
    BeyondSquare,
    /// The first or last columns, and the first or last rows, are not.
    Sides([bool; 4]),
}

/// Where samples land.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Where they belong.
    Right,
    /// Row 0 below.
    UpsideDown,
    /// Column 0 on the right.
    Mirrored,
    /// Both.
    HalfTurn,
    /// Rows and columns exchanged.
    Transposed,
    /// One column to the right.
    OneRight,
    /// One row down.
    OneDown,
    /// One column to the left.
    OneLeft,
    /// One row up.
    OneUp,
    /// Each shows what the next in memory should: to the left, the first of a row at the end of the row above.
    NextInMemory,
    /// The one before: to the right, the last of a row at the start of the row below.
    LastInMemory,
    /// Written column after column.
    ByColumns,
    /// Drawn with width and height exchanged.
    SizeExchanged,
}
