//! Pixel rules: where the samples of a pixel are, and how they become its light.
//!
//! Part of [`super::rules`]; [`super::pixels`] computes with them.
//!
//! Space: samples; A is the side of a pixel in samples.

/// Where samples of a pixel are asked for; parts are of the pixel's side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SampleAt {
    /// Each at its own center.
    Own,
    /// All at one place of the pixel: 0.5 is its center, 0 its corner.
    Block(f64),
    /// x alone is.
    BlockX(f64),
    /// y alone is.
    BlockY(f64),
    /// Spread over this part of the pixel, around its center.
    Spread(f64),
    /// In x alone.
    SpreadX(f64),
    /// In y alone.
    SpreadY(f64),
    /// Spread over this part of the pixel, from its corner.
    FromCorner(f64),
}

/// How samples become a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PixelFrom {
    /// Their mean.
    Mean,
    /// Their sum, divided by another number.
    Divided(Count),
    /// Their mean, times this.
    Times(f64),
    /// One of them: column and row, 0 first, 1 and 2 around the middle, 3 last.
    One(u8, u8),
    /// Some of them, divided by a number.
    Part(Part, Count),
    /// The mean of those that a face covers.
    Covered,
    /// The sum of those, divided by all.
    CoveredOfAll,
    /// The face where more than this part (or as much) is covered, else what is behind.
    Threshold((f64, bool)),
    /// The first that a face covers.
    FirstCovered,
    /// The last that a face covers.
    LastCovered,
    /// The brightest.
    Most,
    /// The darkest.
    Least,
    /// The mean of both.
    Extremes,
    /// The middle one by brightness, the upper or lower of two.
    Median(bool),
    /// The root of the mean of powers.
    MeanOfPowers(f64),
    /// A power of the mean.
    Root(f64),
    /// Each mixed half and half with what is there: from the first, or from black.
    Running(bool),
    /// Weighted to the middle.
    Tent,
    /// The mean of levels, made by cutting after this was added.
    MeanOfLevels(f64),
    /// The same, cut to a level again.
    LevelsCut(f64),
    /// The sum of levels that were divided before.
    DividedFirst(f64),
    /// The same, divided again.
    DividedTwice(f64),
    /// The sum of levels in a byte, divided.
    SumInByte(f64),
    /// The same, in whole numbers.
    SumInByteCut(f64),
    /// The sum of levels in a byte.
    SumWraps,
    /// The sum of levels in a byte with a sign, divided.
    SignedByte,
    /// Face by face, each mixed with what is there by its share of the pixel: of equal depths the later counts, or does not.
    MixedByFace(bool),
}

/// Some of a pixel's samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A row: 0 first, 1 and 2 around the middle, 3 last.
    Row(u8),
    /// A column.
    Column(u8),
    /// From the upper left to the lower right.
    Diagonal,
    /// The other diagonal.
    OtherDiagonal,
    /// The four corners.
    Corners,
    /// The first and the last.
    Ends,
    /// A square of this side in the upper left.
    Square(usize),
    /// All but the first.
    WithoutFirst,
    /// All but the last.
    WithoutLast,
    /// All but the first row.
    WithoutFirstRow,
    /// All but the last row.
    WithoutLastRow,
    /// All but the first column.
    WithoutFirstColumn,
    /// All but the last column.
    WithoutLastColumn,
    /// All but the last column and row.
    WithoutLastBoth,
    /// All but the first column and row.
    WithoutFirstBoth,
    /// Every other one.
    Checkered,
    /// The first half of them.
    FirstHalf,
    /// The middle row and column.
    Cross,
}

/// What a sum of samples is divided by; A is the side of the pixel in samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Count {
    /// A * A.
    All,
    /// As many as were added.
    Kept,
    /// 1.
    One,
    /// A.
    Side,
    /// A and this.
    SideMore(f64),
    /// 2 A.
    TwoSides,
    /// A * A and this.
    AllMore(f64),
    /// (A + 1) * (A + 1).
    NextSquare,
    /// This.
    Fixed(f64),
    /// A * A * A.
    Cube,
    /// A * A * A * A.
    Fourth,
}
