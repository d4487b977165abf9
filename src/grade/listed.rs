//! Listed: which faces of a list are drawn, and what becomes of colors and glass on the way to a level.
//!
//! Slips of loops and of channel arithmetic, one variant each; the contract is the first of every list.

/// Which faces are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Listed {
    /// All.
    All,
    /// All but the first.
    WithoutFirst,
    /// All but the last.
    WithoutLast,
    /// The first alone.
    OnlyFirst,
    /// The last alone.
    OnlyLast,
    /// The first, the third, and so on.
    EveryOther,
}

impl Listed {
    /// Whether face `index` of `count` is drawn.
    #[must_use]
    pub fn has(self, index: usize, count: usize) -> bool {
        match self {
            Listed::All => true,
            Listed::WithoutFirst => index > 0,
            Listed::WithoutLast => index + 1 < count,
            Listed::OnlyFirst => index == 0,
            Listed::OnlyLast => index + 1 == count,
            Listed::EveryOther => index.is_multiple_of(2),
        }
    }
}

/// What becomes of a color.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// It stays.
    Own,
    /// The mean of its channels, three times.
    Mean,
    /// Luma by Rec. 601, three times.
    Luma,
    /// 1 - c.
    Inverted,
    /// Only this channel is left, the others are 0.
    Only(usize),
    /// This channel is 0.
    Without(usize),
}

impl Tone {
    /// `color`, changed.
    #[must_use]
    pub fn of(self, color: [f64; 3]) -> [f64; 3] {
        let [r, g, b] = color;
        match self {
            Tone::Own => color,
            Tone::Mean => [(r + g + b) / 3.0; 3],
            Tone::Luma => [0.299 * r + 0.587 * g + 0.114 * b; 3],
            Tone::Inverted => color.map(|light| 1.0 - light),
            Tone::Only(channel) => [0, 1, 2].map(|at: usize| if at == channel { color[at] } else { 0.0 }),
            Tone::Without(channel) => [0, 1, 2].map(|at: usize| if at == channel { 0.0 } else { color[at] }),
        }
    }
}

/// From light to a level.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// Up to the next.
    Up,
    /// round(256 c), and 256 is 0.
    Wraps,
    /// round(n c) of n, brought to 255.
    Of(f64),
    /// round(n c).
    Scaled(f64),
    /// floor(n c) of n, brought to 255.
    CutOf(f64),
    /// round(n c) of n, brought to 255 in whole numbers.
    OfCut(f64),
    /// round(255 c) and this.
    More(f64),
    /// The same in a byte.
    MoreInByte(f64),
    /// A power of c.
    Power(f64),
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
    /// Each with what has been drawn so far.
    AtOnce,
    /// The same, and glass hides what comes later behind it.
    AtOnceKept,
    /// Each with what has been drawn so far, whatever its depth.
    AtOnceUntested,
    /// Also what is behind the opaque face.
    Everywhere,
    /// The same, in the order of the list turned round.
    EverywhereTurned,
    /// The same, the farthest first.
    EverywhereSorted,
    /// The farthest first, what is nearer than what is kept in the end.
    AtEnd,
    /// The nearest first.
    NearestFirst,
    /// The farthest first, and glass keeps its depth, so that what comes later behind it is lost.
    OverKept,
    /// What is farther than the opaque face, the nearest first.
    Turned,
}

/// The shares of glass and of what is behind it, where opacity is o.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mixed {
    /// o and 1 - o.
    Right,
    /// o and 1.
    Added,
    /// 1 and 1 - o.
    Whole,
    /// o and 0.
    NothingBehind,
    /// 1 and 1.
    Sum,
    /// o and o.
    Alike,
    /// Half and half.
    Half,
    /// o and 1 - o, times each other.
    Filtered,
}

impl Mixed {
    /// Light of glass over light that is behind it.
    #[must_use]
    pub fn of(self, own: [f64; 3], behind: [f64; 3], opacity: f64) -> [f64; 3] {
        let (first, second) = match self {
            Mixed::Right => (opacity, 1.0 - opacity),
            Mixed::Added => (opacity, 1.0),
            Mixed::Whole => (1.0, 1.0 - opacity),
            Mixed::NothingBehind => (opacity, 0.0),
            Mixed::Sum => (1.0, 1.0),
            Mixed::Alike => (opacity, opacity),
            Mixed::Half => (0.5, 0.5),
            Mixed::Filtered => return [0, 1, 2].map(|c| behind[c] * (1.0 - opacity + opacity * own[c])),
        };
        [0, 1, 2].map(|c| own[c] * first + behind[c] * second)
    }
}
