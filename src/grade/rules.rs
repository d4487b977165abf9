//! Rules: everything a picture of a case is decided by, one field a decision.
//!
//! [`Rules::default`] is the contract. A mutant ([`super::mutants`]) changes one field, and [`super::paint`] draws what a
//! rasterizer with that mistake would. Two mistakes are two changed fields, so mistakes found earlier can be built into what
//! later pictures are held against: one slip does not fail everything after it.

pub use super::area_rules::{
    BlockEnd, BlockStart, Blocks, Border, Bounds, BoundsBy, BoundsOf, Fill, Pieces, Place, Quarters, Rounding, Ties,
    Winding,
};
use super::light_rules::LightRules;
use super::lines::rule::Lines;
pub use super::listed::{Blending, Levels};
use super::listed::{Listed, Mixed, Tone};
pub use super::pixel_rules::{Count, Part, PixelFrom, SampleAt};
pub use super::program_rules::{
    Address, Block, DepthPoint, Dropped, Kept, Memory, Origin, Shape, Slack, Stencil, Turned, Walk,
};
use super::runs::RunRule;
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
    /// Polygons that are left out for what they are.
    pub dropped: Dropped,
    /// Of the columns and of the rows that are looked at every n-th is.
    pub stepped: (i32, i32),
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
    /// What x and y of values are counted from.
    pub origin: Origin,
    /// The same of depth.
    pub depth_origin: Origin,
    /// The channels that the rule of values is about; the others are right.
    pub value_channels: [bool; 3],
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
    /// The shares of glass and of what is behind it.
    pub mixed: Mixed,
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
    /// The same where a pixel has one sample.
    pub pixel_of_one: bool,
    /// How a lit sample gets its light.
    pub light: LightRules,
    /// How lines are drawn.
    pub lines: Lines,
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
    /// The same, and what lies left of an event that was taken before is not drawn again.
    ListOrderOnward,
    /// The face that begins last shows.
    LatestBegun,
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
    /// Each channel's least value of three corners.
    Least,
    /// Each channel's greatest.
    Greatest,
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
            dropped: Dropped::None,
            stepped: (1, 1),
            bounds: Bounds::WHOLE,
            border: Border::None,
            place: Place::Right,
            front: Front::Nearest,
            depth: DepthFrom::Plane,
            depth_point: DepthPoint::Own,
            origin: Origin::Picture,
            depth_origin: Origin::Picture,
            value_channels: [true; 3],
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
            mixed: Mixed::Right,
            blending: Blending::Over,
            background: None,
            sample_at: SampleAt::Own,
            depth_at: SampleAt::Own,
            pixel: PixelFrom::Mean,
            pixel_of_one: false,
            light: LightRules::default(),
            lines: Lines::RIGHT,
        }
    }
}
