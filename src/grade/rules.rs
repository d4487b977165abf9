//! Rules: everything a picture of a case is decided by, one field a decision.
//!
//! [`Rules::default`] is the contract. A mutant ([`super::mutants`]) changes one field, and [`super::paint`] draws what a
//! rasterizer with that mistake would. Two mistakes are two changed fields, so mistakes found earlier can be built into what
//! later pictures are held against: one slip does not fail everything after it.

use super::light_rules::LightRules;
use super::lines::rule::Lines;
pub use super::listed::{Blending, Levels};
use super::listed::{Listed, Tone};
pub use super::pixel_rules::{Count, Part, PixelFrom, SampleAt};
pub use super::program_rules::{Address, Block, DepthPoint, Kept, Memory, Shape, Slack, Stencil, Turned, Walk};
use super::runs::RunRule;
use super::scan::Scan;
pub use super::summed::Summed;

/// Everything a picture is decided by.
#[derive(Clone, Debug, PartialEq)]
pub struct Rules {
    /// Where in a sample coverage is asked for.
    pub cover_at: (f64, f64),
    /// Where in a sample depth and values are taken.
    pub value_at: (f64, f64),
    /// Rounding of corners before anything else.
    pub corners: Rounding,
    /// Who gets a center exactly on an edge.
    pub ties: Ties,
    /// How the polygon is changed before anything else.
    pub shape: Shape,
    /// What "inside" means.
    pub fill: Fill,
    /// What of one polygon's samples is left to the next.
    pub stencil: Stencil,
    /// What is decided for several samples at once.
    pub block: Block,
    /// The parts an outline is cut into before it is filled.
    pub pieces: Pieces,
    /// How the faces of a line are told apart span by span.
    pub line: LineSpans,
    /// Which way round an outline may go.
    pub winding: Winding,
    /// Polygons of a smaller area in samples are not drawn.
    pub least_area: f64,
    /// Which columns and rows of the polygon's bounds are looked at.
    pub bounds: Bounds,
    /// Which part of the picture is never drawn.
    pub border: Border,
    /// Where samples land.
    pub place: Place,
    /// Which polygon of several keeps a sample.
    pub front: Front,
    /// Where the depth that is compared comes from.
    pub depth: DepthFrom,
    /// Where it is taken.
    pub depth_point: DepthPoint,
    /// Which depth is kept for those that come later.
    pub kept: Kept,
    /// Where depth and color of a sample are kept.
    pub memory: Memory,
    /// So many polygons are looked at at a sample.
    pub most_at_sample: usize,
    /// 1/w that the depth memory starts with: what is not nearer is not shown.
    pub clear: f64,
    /// What is nearer than this is never shown.
    pub limit: f64,
    /// Depths are cut to this before anything else.
    pub capped: f64,
    /// By how much a face must be nearer than what is there.
    pub margin: f64,
    /// Of equal depths the later one wins.
    pub later_wins_ties: bool,
    /// How values get from corners to samples.
    pub values: Interpolation,
    /// Values that are the same at all corners stay what they are.
    pub spares_constants: bool,
    /// Those alone that are so to the last digit.
    pub spares_exact: bool,
    /// Value / w is divided by the depth that is compared, whatever is wrong with that.
    pub divides_by_kept: bool,
    /// Values, and depth, are kept between the least and the greatest of the corners.
    pub clamps: bool,
    /// Which corner's value goes to which corner.
    pub carried: Carried,
    /// What of 1/w is carried with it.
    pub over_w: OverW,
    /// Which channel is written first, second, third.
    pub channels: [usize; 3],
    /// The same of the polygons alone: the background stays as it is.
    pub face_channels: [usize; 3],
    /// What becomes of colors.
    pub tone: Tone,
    /// The same of the polygons alone.
    pub face_tone: Tone,
    /// Which polygons are drawn.
    pub listed: Listed,
    /// From light to 0..255.
    pub levels: Levels,
    /// The same of the polygons alone.
    pub face_levels: Option<Levels>,
    /// What transparency does.
    pub blending: Blending,
    /// Which color is behind everything; `None` for the case's own.
    pub background: Option<f64>,
    /// Where the samples of a pixel are.
    pub sample_at: SampleAt,
    /// At which sample of a pixel depth is taken.
    pub depth_at: SampleAt,
    /// How samples become a pixel.
    pub pixel: PixelFrom,
    /// How a lit sample gets its light.
    pub light: LightRules,
    /// How lines are drawn.
    pub lines: Lines,
}

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

/// How the faces of a line are told apart span by span.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineSpans {
    /// Sample by sample.
    None,
    /// The face in front at the left end of a span is shown on all of it.
    LeftEnd,
    /// That at the right end.
    RightEnd,
    /// That in the middle.
    Middle,
    /// A span whose ends differ is halved once.
    HalvedOnce,
    /// A span whose ends differ is halved, and the sample in the middle is in neither half.
    MiddleLost,
    /// Spans are cut where a face begins, not where one ends.
    EndsCutNothing,
    /// Spans are cut where a face ends, not where one begins.
    BeginningsCutNothing,
    /// The last span of a line is lost.
    LastLost,
    /// The first span of a line is lost.
    FirstLost,
    /// The last sample of every span is lost.
    LastSampleLost,
    /// The first sample of every span is lost.
    FirstSampleLost,
    /// Where the face in front ends, nothing shows until another begins.
    NothingBehind,
    /// The same, and what begins is compared with all that are there.
    NothingUntilNext,
    /// Beginnings and ends are taken face by face, not from left to right.
    ListOrder,
    /// The face that begins last shows.
    LatestBegun,
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
}

impl Bounds {
    /// All of them.
    pub const WHOLE: Bounds = Bounds { lost: [0; 4], by: BoundsBy::Floor };
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

/// Which polygon of several keeps a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Front {
    /// The nearest.
    Nearest,
    /// The farthest.
    Farthest,
    /// The last of the list.
    Last,
    /// The first of the list.
    First,
    /// The nearest but one.
    Second,
}

/// Where the compared depth comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DepthFrom {
    /// The plane of 1/w, at the sample.
    Plane,
    /// That corner, or the last.
    Corner(usize),
    /// The nearest corner.
    NearestCorner,
    /// The farthest corner.
    FarthestCorner,
    /// The mean of the corners.
    MeanCorner,
    /// One over the mean of their distances.
    MeanDistance,
    /// The mean of the nearest and the farthest corner.
    Ends,
    /// w, interpolated on the screen.
    LinearW,
    /// 1/w cut to a whole number.
    Whole,
    /// 1/w cut down to so many steps a unit.
    Steps(f64),
    /// 1/w rounded to so many steps a unit.
    RoundSteps(f64),
    /// 1/w cut down to so many steps a unit, which begin anew at a number.
    Wraps(f64, f64),
    /// w cut down to so many steps a unit.
    DistanceSteps(f64),
    /// w times this, as a text.
    AsText(f64),
    /// 1/w added up along a span.
    Summed(Summed),
    /// Along edges, then along rows.
    Runs(RunRule),
}

/// How values get from corners to samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interpolation {
    /// Linear in space.
    Perspective,
    /// Linear on the screen.
    Affine,
    /// Value / w, as it is.
    NotMultipliedBack,
    /// Value / w, divided by 1/w twice.
    MultipliedTwice,
    /// Value / w, times 1/w.
    TimesDepth,
    /// The value, divided by 1/w.
    AffineDivided,
    /// The value, times 1/w.
    AffineTimes,
    /// Value / w, divided by another 1/w.
    DividedBy(Divisor),
    /// Value times w, divided by w.
    ByW,
    /// The limits of the value are put on value / w.
    LimitsOnOverW,
    /// That corner does not count.
    Without(usize),
    /// Times this.
    Times(f64),
    /// The plane of value / w without its x.
    WithoutX,
    /// Without its y.
    WithoutY,
    /// Weights are the inverses of distances.
    Distances,
    /// That corner's value.
    Corner(usize),
    /// The value of the corner nearest to the eye.
    NearestToEye,
    /// The mean of three corners.
    Mean,
    /// The value at the middle of three corners.
    Middle,
    /// The value of the corner with the greatest weight.
    Heaviest,
    /// The value of the closest corner on the screen.
    Closest,
    /// Along edges, then along rows.
    Runs(RunRule),
    /// The value, added up along a span.
    Summed(Summed),
    /// Value / w, added up along a span, divided by 1/w.
    SummedOverW(Summed),
}

/// What value / w is divided by instead of the sample's 1/w.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Divisor {
    /// That of a corner.
    Corner(usize),
    /// That of the nearest corner.
    Nearest,
    /// That of the farthest.
    Farthest,
    /// The mean of the corners'.
    Mean,
    /// One over w drawn out straight.
    LinearW,
}

/// Which corner's values go to which corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// Its own.
    Right,
    /// The next one's.
    Rotated,
    /// The one's before.
    RotatedBack,
    /// The second and third exchanged.
    LastTwoSwapped,
    /// The first and second exchanged.
    FirstTwoSwapped,
    /// The first and third exchanged.
    OuterSwapped,
    /// The next one's, going round clockwise.
    TurnedRight,
    /// The next one's, going round counterclockwise.
    TurnedLeft,
    /// The first and second exchanged after all were turned clockwise.
    FirstTwoByTurn,
    /// The first and third exchanged after all were turned clockwise.
    OuterByTurn,
    /// Another order of triangles that run clockwise.
    Clockwise([usize; 3]),
    /// Of those that run counterclockwise.
    CounterClockwise([usize; 3]),
    /// Corners sorted by y, values not.
    SortedByY,
    /// From the lowest up.
    SortedByYDown,
    /// Sorted by x.
    SortedByX,
}

/// What of 1/w is carried with a value to another corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverW {
    /// Nothing.
    Stays,
    /// Value / w is carried.
    WithValue,
    /// So is the 1/w that it is divided by.
    WithDivisor,
}

impl Default for Rules {
    /// The contract.
    fn default() -> Self {
        Rules {
            cover_at: (0.5, 0.5),
            value_at: (0.5, 0.5),
            corners: Rounding::None,
            ties: Ties::LEFT_TOP,
            shape: Shape::RIGHT,
            fill: Fill::Outline,
            stencil: Stencil::Cleared,
            block: Block::ONE,
            pieces: Pieces::Whole,
            line: LineSpans::None,
            winding: Winding::Both,
            least_area: 0.0,
            bounds: Bounds::WHOLE,
            border: Border::None,
            place: Place::Right,
            front: Front::Nearest,
            depth: DepthFrom::Plane,
            depth_point: DepthPoint::Own,
            kept: Kept::Shown,
            memory: Memory::RIGHT,
            most_at_sample: usize::MAX,
            clear: 0.0,
            limit: f64::INFINITY,
            capped: f64::INFINITY,
            margin: 0.0,
            later_wins_ties: false,
            values: Interpolation::Perspective,
            spares_constants: false,
            spares_exact: false,
            divides_by_kept: false,
            clamps: false,
            carried: Carried::Right,
            over_w: OverW::Stays,
            channels: [0, 1, 2],
            face_channels: [0, 1, 2],
            tone: Tone::Own,
            face_tone: Tone::Own,
            listed: Listed::All,
            levels: Levels::Round,
            face_levels: None,
            blending: Blending::Over,
            background: None,
            sample_at: SampleAt::Own,
            depth_at: SampleAt::Own,
            pixel: PixelFrom::Mean,
            light: LightRules::default(),
            lines: Lines::RIGHT,
        }
    }
}
