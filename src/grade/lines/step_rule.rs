//! Everything that is decided where a line is stepped column by column.

/// A line column by column. Of a steep line rows are the columns here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What is stepped along.
    pub axis: Axis,
    /// What the row grows by.
    pub slope: Slope,
    /// Rows are counted from the left end, not from the first.
    pub from_left: bool,
    /// Where in a column the row is asked for.
    pub at: At,
    /// Added to the row before it is cut.
    pub shift: f64,
    /// The same in the direction in which the rows grow.
    pub lead: f64,
    /// Which columns at the ends are shown.
    pub ends: StepEnds,
    /// Columns left out on the left and on the right.
    pub trim: (i64, i64),
    /// Of the columns whose middle is reached, one at an end is lost.
    pub lost: StepLost,
}

/// Which of the columns whose middle a line reaches is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepLost {
    /// One is.
    pub is_one: bool,
    /// The first, not the last.
    pub is_first: bool,
    /// From left to right, whichever way the line runs.
    pub from_left: bool,
    /// And all beyond it.
    pub beyond: bool,
}

impl StepLost {
    /// None is.
    pub const NONE: StepLost = StepLost { is_one: false, is_first: false, from_left: false, beyond: false };
}

/// What is stepped along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The longer side.
    Longer,
    /// The shorter side.
    Shorter,
    /// Always x.
    X,
    /// Always y.
    Y,
    /// The longer side, and steep lines are not turned back.
    NotTurnedBack,
}

/// What the row grows by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slope {
    /// dv / du.
    Right,
    /// That cut to a whole number.
    Cut,
    /// That rounded down.
    Down,
    /// That rounded.
    Rounded,
    /// Its size.
    Positive,
    /// Its size, negative.
    Negative,
    /// Its opposite.
    Opposite,
    /// du / dv.
    TurnedOver,
    /// 1 or -1.
    One,
    /// 0.
    Zero,
    /// Half of it.
    Half,
    /// That of ends cut to whole numbers.
    OfWholeEnds,
    /// Right, but rows always grow from that of the first column on.
    RowsGrow,
    /// Right, but they always fall.
    RowsFall,
    /// Right, but rows always grow from that of the start on.
    RowsGrowFromStart,
}

/// Where in a column the row is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// In the middle, or at the end of the line that falls short of it.
    Middle,
    /// At this part of the column.
    Part(f64),
    /// As far within every column as the start is within its own.
    Start,
    /// As if the start were the middle of the first column whose middle is reached.
    FirstMiddle,
}

/// Which columns at the ends are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepEnds {
    /// By the diamonds of the samples that are drawn.
    Diamonds,
    /// By the diamonds of the samples that should be.
    RightDiamonds,
    /// All.
    All,
    /// All, but none of a line that stays in its column.
    AllOfLong,
    /// All but that of the start.
    NotFirst,
    /// All but that of the end.
    NotLast,
    /// All but both.
    Neither,
    /// Those whose middle the line reaches before its end.
    Middles,
    /// Those whose middle it reaches, its end as well.
    MiddlesClosed,
}

impl Step {
    /// The contract, but for points on the border of a diamond.
    pub const RIGHT: Step = Step {
        axis: Axis::Longer,
        slope: Slope::Right,
        from_left: false,
        at: At::Middle,
        shift: 0.0,
        lead: 0.0,
        ends: StepEnds::Diamonds,
        trim: (0, 0),
        lost: StepLost::NONE,
    };
}
