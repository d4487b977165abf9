//! Instructions: for which the loops over lanes are compiled, chosen when the program runs.
//!
//! Every level computes the same bytes: an addition, a product and a quotient are rounded alike in one lane and in eight, and nothing is
//! fused. So a level is a matter of time only, and tests run all of them.

use fearless_simd::Level;

/// Instructions for the inner loops.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Instructions {
    /// None but those of the language: eight lanes are a loop.
    Plain,
    /// What every processor of this kind has: SSE2, NEON.
    Baseline,
    /// Eight lanes: AVX2 (x86-64-v3), if the processor has it.
    Avx2,
    /// The best there is.
    #[default]
    Best,
}

/// The environment variable that says which instructions `-r fast` is to use: for measuring, and for looking for a difference.
pub const VARIABLE: &str = "FAROP_INSTRUCTIONS";

impl Instructions {
    /// All of them, slowest first.
    pub const ALL: [Instructions; 4] =
        [Instructions::Plain, Instructions::Baseline, Instructions::Avx2, Instructions::Best];

    /// What [`VARIABLE`] calls them.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Instructions::Plain => "plain",
            Instructions::Baseline => "sse2",
            Instructions::Avx2 => "avx2",
            Instructions::Best => "best",
        }
    }

    /// What [`VARIABLE`] asks for; the best without it.
    ///
    /// # Errors
    /// What is wrong, if it is no name.
    pub fn asked() -> Result<Instructions, String> {
        let Some(asked) = std::env::var_os(VARIABLE) else { return Ok(Instructions::Best) };
        let found = Instructions::ALL.into_iter().find(|instructions| asked == instructions.name());
        found.ok_or_else(|| {
            let names = Instructions::ALL.map(Instructions::name).join(", ");
            format!("the environment variable {VARIABLE} is `{}`; it is one of {names}, or unset", asked.display())
        })
    }

    /// What this processor does with it: a choice that it does not have is the best there is.
    #[must_use]
    pub fn here(self) -> String {
        let level = format!("{:?}", self.level());
        level.split(['(', ' ', '{']).next().unwrap_or_default().to_lowercase()
    }

    /// A level that this processor has.
    pub(crate) fn level(self) -> Level {
        let best = Level::new();
        match self {
            Instructions::Plain => Level::fallback(),
            Instructions::Baseline => baseline(best),
            Instructions::Avx2 => avx2(best),
            Instructions::Best => best,
        }
    }
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn baseline(best: Level) -> Level {
    best.as_sse2().map_or(best, Level::Sse2)
}

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn avx2(best: Level) -> Level {
    best.as_avx2().map_or(best, Level::Avx2)
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn baseline(best: Level) -> Level {
    best
}

#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
fn avx2(best: Level) -> Level {
    best
}
