//! Rules: everything a picture of a case is decided by, one field a decision.
//!
//! [`Rules::default`] is the contract. A mutant ([`super::mutants`]) changes one field, and [`super::paint`] draws what a
//! rasterizer with that mistake would. Two mistakes are two changed fields, so mistakes found earlier can be built into what
//! later pictures are held against: one slip does not fail everything after it.

use super::lines::rule::Lines;

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
    /// What "inside" means.
    pub fill: Fill,
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
    /// 1/w that the depth memory starts with: what is not nearer is not shown.
    pub clear: f64,
    /// Of equal depths the later one wins.
    pub later_wins_ties: bool,
    /// How values get from corners to samples.
    pub values: Interpolation,
    /// Which corner's value goes to which corner.
    pub carried: Carried,
    /// Which channel is written first, second, third.
    pub channels: [usize; 3],
    /// The same of the polygons alone: the background stays as it is.
    pub face_channels: [usize; 3],
    /// From light to 0..255.
    pub levels: Levels,
    /// What transparency does.
    pub blending: Blending,
    /// Which color is behind everything; `None` for the case's own.
    pub background: Option<f64>,
    /// How samples become a pixel.
    pub pixel: PixelFrom,
    /// How a lit sample gets its light.
    pub light: Light,
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
    /// A fan of triangles from the first corner: right for convex outlines only.
    Fan,
    /// Edges own both their ends: parity is wrong where a corner lies on a scan line.
    BothEnds,
    /// The samples that hold a corner.
    Corners,
    /// The first triangle only.
    FirstTriangle,
    /// Nothing at all.
    Nothing,
    /// Rounded scan-line spans.
    Spans(SpanRule),
}

/// How a scan line's span is rounded to columns: offsets added before rounding down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpanRule {
    /// Which line inside a row is looked at: 0.5 is right.
    pub row: f64,
    /// First column: floor(x + first).
    pub first: f64,
    /// Column after the last: floor(x + end).
    pub end: f64,
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
pub enum Bounds {
    /// All of them.
    Whole,
    /// Without the last column.
    ColumnShort,
    /// Without the last row.
    RowShort,
    /// Without both.
    BothShort,
    /// Without the first column.
    FirstColumnLost,
    /// Without the first row.
    FirstRowLost,
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
}

/// Where the compared depth comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFrom {
    /// The plane of 1/w, at the sample.
    Plane,
    /// The first corner.
    FirstCorner,
    /// The nearest corner.
    NearestCorner,
    /// The mean of the corners.
    MeanCorner,
    /// w, interpolated on the screen.
    LinearW,
    /// 1/w cut to a whole number.
    Whole,
}

/// How values get from corners to samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Linear in space.
    Perspective,
    /// Linear on the screen.
    Affine,
    /// Value / w, as it is.
    NotMultipliedBack,
    /// Value / w, divided by 1/w twice.
    MultipliedTwice,
    /// The first corner's value.
    FirstCorner,
    /// The last corner's value.
    LastCorner,
    /// The mean of three corners.
    Mean,
    /// The value of the corner with the greatest weight.
    NearestCorner,
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
    /// Corners sorted by y, values not.
    SortedByY,
}

/// From light to a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels {
    /// round(255 c).
    Round,
    /// floor(255 c).
    Down,
    /// floor(256 c).
    Times256,
    /// The curve of sRGB.
    Srgb,
    /// The power 1/2.2.
    Gamma22,
    /// floor(c).
    Unscaled,
    /// round(255 c c).
    Squared,
}

/// What transparency does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blending {
    /// The farthest first, each over what is behind.
    Over,
    /// Everything is opaque.
    Ignored,
    /// Transparent faces are not drawn.
    Invisible,
    /// Opacity is taken for transparency.
    Swapped,
    /// In the order of the list.
    ListOrder,
}

/// How samples become a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelFrom {
    /// Their mean.
    Mean,
    /// The first.
    FirstSample,
    /// The one in the middle.
    MiddleSample,
    /// The brightest.
    Most,
    /// The mean of samples cut to levels.
    MeanOfLevels,
}

/// How a lit sample gets its light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Light {
    /// At the sample.
    Right,
    /// At the corners, interpolated.
    AtCorners,
    /// At the first corner.
    AtFirstCorner,
    /// With the normal as interpolated.
    NormalNotUnit,
    /// With the vector to the lamp as long as it is.
    LampNotUnit,
    /// From behind as well.
    BothSides,
    /// Without ambient light.
    NoAmbient,
    /// Without a highlight.
    NoHighlight,
    /// Highlight by the halfway vector.
    HalfwayHighlight,
    /// Highlight even where N.L < 0.
    HighlightEverywhere,
    /// Highlight without exponent.
    ExponentOne,
}

impl Default for Rules {
    /// The contract.
    fn default() -> Self {
        Rules {
            cover_at: (0.5, 0.5),
            value_at: (0.5, 0.5),
            corners: Rounding::None,
            ties: Ties::LEFT_TOP,
            fill: Fill::Outline,
            winding: Winding::Both,
            least_area: 0.0,
            bounds: Bounds::Whole,
            border: Border::None,
            place: Place::Right,
            front: Front::Nearest,
            depth: DepthFrom::Plane,
            clear: 0.0,
            later_wins_ties: false,
            values: Interpolation::Perspective,
            carried: Carried::Right,
            channels: [0, 1, 2],
            face_channels: [0, 1, 2],
            levels: Levels::Round,
            blending: Blending::Over,
            background: None,
            pixel: PixelFrom::Mean,
            light: Light::Right,
            lines: Lines::RIGHT,
        }
    }
}
