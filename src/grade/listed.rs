//! Listed: which faces of a list are drawn, and what becomes of colors on the way to a channel.
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
    /// Half of it.
    Halved,
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
            Tone::Halved => color.map(|light| light / 2.0),
            Tone::Only(channel) => [0, 1, 2].map(|at: usize| if at == channel { color[at] } else { 0.0 }),
            Tone::Without(channel) => [0, 1, 2].map(|at: usize| if at == channel { 0.0 } else { color[at] }),
        }
    }
}
