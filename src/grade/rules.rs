//! Rules: everything a picture of a case is decided by, one field a decision.
//!
//! [`Rules::default`] is the contract. A mutant ([`super::mutants`]) changes one field, and [`super::paint`] draws what a
//! rasterizer with that mistake would. Two mistakes are two changed fields, so mistakes found earlier can be built into what
//! later pictures are held against: one slip does not fail everything after it.

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
    /// Which samples a line shows.
    pub lines: Lines,
}

/// Rounding of a coordinate to whole samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding { None, Down, Nearest, Up }

/// Who gets a center exactly on an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ties {
    /// As if the center lay a little to one side: signs of the step in x and y, and whether x decides first.
    Consistent { x: i8, y: i8, x_first: bool },
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
pub enum Winding { Both, Clockwise, CounterClockwise }

/// How much of the bounds is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounds { Whole, ColumnShort, RowShort, BothShort, FirstColumnLost, FirstRowLost }

/// Which part of the picture is never drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Border { None, LastColumn, LastRow, LastBoth, FirstColumn, FirstRow, BeyondSquare }

/// Where samples land.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place { Right, UpsideDown, Mirrored, HalfTurn, Transposed, OneRight, OneDown, OneLeft, OneUp }

/// Which polygon of several keeps a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Front { Nearest, Farthest, Last, First }

/// Where the compared depth comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthFrom { Plane, FirstCorner, NearestCorner, MeanCorner, LinearW, Whole }

/// How values get from corners to samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation { Perspective, Affine, NotMultipliedBack, MultipliedTwice, FirstCorner, LastCorner, Mean, NearestCorner }

/// Which corner's values go to which corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried { Right, Rotated, RotatedBack, LastTwoSwapped, FirstTwoSwapped, OuterSwapped, SortedByY }

/// From light to a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Levels { Round, Down, Times256, Srgb, Gamma22, Unscaled, Squared }

/// What transparency does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Blending { Over, Ignored, Invisible, Swapped, ListOrder }

/// How samples become a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelFrom { Mean, FirstSample, MiddleSample, Most, MeanOfLevels }

/// How a lit sample gets its light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Light { Right, AtCorners, AtFirstCorner, NormalNotUnit, LampNotUnit, BothSides, NoAmbient, NoHighlight, HalfwayHighlight, HighlightEverywhere, ExponentOne }

/// Which samples a line shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines { DiamondExit, Truncated, ColumnsOnly, WithLastSample, Open, Nothing }

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
            levels: Levels::Round,
            blending: Blending::Over,
            background: None,
            pixel: PixelFrom::Mean,
            light: Light::Right,
            lines: Lines::DiamondExit,
        }
    }
}
