//! Everything the picture of lines is decided by, one field a decision.

pub use super::step_rule::{At, Axis, Slope, Step, StepEnds, StepLost};

/// How the edges of faces are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Which faces of the list.
    pub faces: Faces,
    /// What of a face.
    pub shape: Shape,
    /// What becomes of the ends of a line before it is drawn.
    pub ends: Ends,
    /// Lines that are not drawn.
    pub lost: Lost,
    /// How samples of a line are found.
    pub walk: Walk,
    /// What is put on a sample of a line.
    pub pen: Pen,
    /// Its light.
    pub ink: Ink,
    /// A sample that is shown twice is empty again.
    pub is_exclusive: bool,
}

/// Which faces of the list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Faces {
    /// All.
    All,
    /// Not the first.
    FirstLost,
    /// Not the last.
    LastLost,
    /// The first alone.
    OnlyFirst,
    /// The last alone.
    OnlyLast,
}

/// What of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// All edges.
    Outline,
    /// All but the last.
    LastLost,
    /// All but the first.
    FirstLost,
    /// All but the second.
    SecondLost,
    /// The first alone.
    FirstAlone,
    /// Edges 0, 2, 4: corners in pairs.
    Even,
    /// Edges 1, 3, 5.
    Odd,
    /// From the first corner to every other.
    FromFirst,
    /// From every corner to the first.
    ToFirst,
    /// From every corner to the next but one.
    Skipping,
    /// The outline of the first three corners.
    FirstTriangle,
    /// The outlines of faces with three corners, no others.
    TrianglesOnly,
    /// The outlines of faces with more.
    TrianglesLost,
    /// The outlines of a fan of triangles.
    Fan,
    /// The sides of the bounding box.
    Bounds,
    /// The bounding box, filled.
    FilledBounds,
    /// The face filled, nothing of its outline.
    Filled,
    /// The face filled, and its outline.
    FilledOutline,
    /// The samples that hold corners.
    Corners,
    /// Nothing.
    Nothing,
}

/// What becomes of the ends of a line before it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// Nothing.
    Kept,
    /// The center of the sample floor(x + this).
    Center(f64),
    /// floor(x + this).
    Whole(f64),
    /// The line is moved by so many columns and rows.
    Moved(f64, f64),
    /// As [`Ends::Center`], in x alone.
    CenterX(f64),
    /// In y alone.
    CenterY(f64),
    /// The line runs to the right (and down), whichever way it should: by x, by y.
    Unsigned(bool, bool),
    /// Ends of lines that run back in x (or y) are exchanged by halves: x alone is.
    HalfExchanged(Backward),
}

/// Which lines have their ends exchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backward {
    /// Those that run to the left.
    Left,
    /// Those that run up.
    Up,
    /// Those that run back along the longer direction.
    Along,
}

/// Lines that are not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lost {
    /// None.
    None,
    /// Those that run to the left.
    Left,
    /// Those that run to the right.
    Right,
    /// Those that run up.
    Up,
    /// Those that run down.
    Down,
    /// Those that run back along their longer direction.
    Backward,
    /// Those that run forward along it.
    Forward,
    /// Those that run back along both.
    LeftOrUp,
    /// Those that run back along x and y.
    LeftAndUp,
    /// Steep ones that run up.
    SteepUp,
    /// Steep ones that run down.
    SteepDown,
    /// Shallow ones that run to the left.
    ShallowLeft,
    /// Shallow ones that run to the right.
    ShallowRight,
    /// Horizontal ones.
    Level,
    /// Vertical ones.
    Upright,
    /// Both of them.
    Straight,
    /// Those at 45 degrees.
    Diagonal,
    /// Steeper ones than 45 degrees.
    Steep,
    /// Shallower ones.
    Shallow,
    /// Those where x and y grow against each other.
    Rising,
    /// Those where both grow together.
    Falling,
}

/// How samples of a line are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Walk {
    /// Every sample is asked.
    Ask(Ask),
    /// Column by column, or row by row.
    Step(Step),
    /// By equal shares of the line, as many as the longer side is long.
    Share {
        /// The number of shares: floor(longer side + this).
        more: f64,
        /// Added before coordinates are cut to samples.
        shift: f64,
        /// The last is shown.
        last: bool,
    },
}

/// What every sample is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ask {
    /// What lies around its center.
    pub around: Around,
    /// Half the size of that.
    pub half: f64,
    /// What the line has to do with it.
    pub when: When,
}

/// What lies around a center.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Around {
    /// |dx| + |dy| < half.
    Diamond,
    /// max(|dx|, |dy|) < half.
    Square,
    /// The points nearer than half.
    Circle,
}

/// What a line has to do with what lies around a center.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Leave it.
    Leaves,
    /// Enter it.
    Enters,
    /// Touch it.
    Touches,
    /// Enter and leave it.
    Crosses,
}

/// What is put on a sample of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pen {
    /// It alone.
    One,
    /// It and its neighbors, by (columns, rows).
    Wide(&'static [(i64, i64)]),
    /// It and its neighbors across the longer direction.
    Across(&'static [i64]),
    /// Every n-th of a line, beginning with one.
    Dashed(usize, usize),
    /// Every n-th column of a line, from its start.
    Stride(i64),
    /// All of a line but so many first and last ones.
    Trimmed(usize, usize),
    /// The same, counted from the left, or from above of steep ones.
    TrimmedFromLeft(usize, usize),
}

/// The light of lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// White on dark, black on bright.
    Right,
    /// The right one times this, by channel.
    Times([f64; 3]),
    /// The same on every background.
    Always(f64),
    /// Black on dark, white on bright.
    Opposite,
    /// Black where the sum of the background's channels times these is greater than the number.
    BlackAbove([f64; 3], f64),
}

impl Lines {
    /// The contract.
    pub const RIGHT: Lines = Lines {
        faces: Faces::All,
        shape: Shape::Outline,
        ends: Ends::Kept,
        lost: Lost::None,
        walk: Walk::Ask(Ask::RIGHT),
        pen: Pen::One,
        ink: Ink::Right,
        is_exclusive: false,
    };

    /// Whether face `index` of `count` is drawn.
    #[must_use]
    pub fn draws(&self, index: usize, count: usize) -> bool {
        match self.faces {
            Faces::All => true,
            Faces::FirstLost => index > 0,
            Faces::LastLost => index + 1 < count,
            Faces::OnlyFirst => index == 0,
            Faces::OnlyLast => index + 1 == count,
        }
    }
}

impl Ask {
    /// The contract: which diamond the line leaves.
    pub const RIGHT: Ask = Ask { around: Around::Diamond, half: 0.5, when: When::Leaves };
}

impl Ink {
    /// The light of lines on a background.
    #[must_use]
    pub fn on(self, background: [f64; 3]) -> [f64; 3] {
        let above = |factors: [f64; 3], most: f64| {
            let sum: f64 = (0..3).map(|channel| factors[channel] * background[channel]).sum();
            if sum > most { 0.0 } else { 1.0 }
        };
        let right = above([1.0; 3], 1.5);
        match self {
            Ink::Right => [right; 3],
            Ink::Times(factors) => factors.map(|factor| factor * right),
            Ink::Always(light) => [light; 3],
            Ink::Opposite => [1.0 - right; 3],
            Ink::BlackAbove(factors, most) => [above(factors, most); 3],
        }
    }
}
