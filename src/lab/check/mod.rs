//! Checks: claims about accuracy, each an experiment that prints its figures.
//!
//! `farop check NAME` -> [`Check`] -> [`Report`] -> figures, and misses that make exit code 1
//!
//! A check compares the program with a judge that shares no code with what it judges ([`crate::oracle`], whole numbers, or a
//! relation that must hold between two runs). It also counts how hard its cases were: an experiment in which nothing ever touches says
//! nothing about ties.
//!
//! Cost: seconds with [`Extent::Quick`]; [`Extent::Full`] is for the record and may take many minutes.

mod aa;
mod agree;
mod clip;
mod color;
mod coverage;
mod cts;
mod depth;
mod extremes;
mod fast;
mod fast_textured;
mod fuzz;
mod fuzz_texts;
mod hash;
mod metamorphic;
mod predicates;
mod random;
mod random_meshes;
pub mod random_scenes;
mod random_textured;
mod relief;
mod report;
mod rings;
mod scenes;
mod seams;
mod tally;
mod tess;
mod tri;
mod unsnapped;

pub use random::Random;
pub use report::{Figure, Report, Value};

/// One claim about accuracy and the experiment that tests it.
pub struct Check {
    /// What `farop check` calls it.
    pub name: &'static str,
    /// What holds, in one sentence.
    pub claim: &'static str,
    /// The experiment.
    pub run: fn(&Effort, &mut Report),
}

/// All checks, in the order in which they run.
pub const CHECKS: &[Check] = &[
    Check { name: "predicates", claim: "the turn of three points is exact for every finite f64", run: predicates::run },
    Check {
        name: "coverage",
        claim: "every rasterizer covers exactly the samples that the tie rule names",
        run: coverage::run,
    },
    Check {
        name: "unsnapped",
        claim: "with nothing snapped, corners up to a billion pixels away cover exactly their samples",
        run: unsnapped::run,
    },
    Check {
        name: "seams",
        claim: "polygons that share edges leave no hole and draw nothing twice, clipped and split",
        run: seams::run,
    },
    Check {
        name: "clip",
        claim: "both sides of an edge are cut in the same points, inside every plane, and no area is lost",
        run: clip::run,
    },
    Check {
        name: "tri",
        claim: "splitting gives n - 2 triangles of exactly the polygon's area, without T-junctions",
        run: tri::run,
    },
    Check { name: "cts", claim: "conformance scenes hold sample by sample, with no tolerance", run: cts::run },
    Check {
        name: "hash",
        claim: "pictures have the committed bytes, whatever the threads, the rasterizer and the build",
        run: hash::run,
    },
    Check {
        name: "fuzz",
        claim: "nothing that is read, cut, split or drawn panics or makes a color that is not a number",
        run: fuzz::run,
    },
    Check {
        name: "agree",
        claim: "the z-buffer, Watkins and the exact oracle show the same polygon at every sample",
        run: agree::run,
    },
    Check {
        name: "fast",
        claim: "the fast rasterizer draws the z-buffer's bytes, whatever the threads, tiles and instructions",
        run: fast::run,
    },
    Check {
        name: "depth",
        claim: "the nearer polygon shows wherever it is nearer by 1e-5 of its distance (1e-12 with f64), whatever near, far and order",
        run: depth::run,
    },
    Check { name: "color", claim: "colors run linearly in space, to half a level and 0.0005 more", run: color::run },
    Check {
        name: "aa",
        claim: "A x A samples err as A to the power of -1.5, on axis edges as 1 / (A sqrt 12), never by more than 1 / (2 A)",
        run: aa::run,
    },
    Check {
        name: "extremes",
        claim: "every item of the catalogue of extremes has its stated outcome",
        run: extremes::run,
    },
    Check {
        name: "tess",
        claim: "outlines of shapes are within the asked tolerance, with hardly more segments than needed",
        run: tess::run,
    },
    Check {
        name: "relief",
        claim: "reliefs keep their bound without cracks, from scratch or following the eye; only open T-junctions make pinholes",
        run: relief::run,
    },
    Check {
        name: "metamorphic",
        claim: "what must not change a picture does not, and what moves it moves it exactly",
        run: metamorphic::run,
    },
];

/// The check of that name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Check> {
    CHECKS.iter().find(|check| check.name == name)
}

/// How much an experiment may do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// A hundredth of `Quick`: for tests of the checks themselves.
    Tiny,
    /// All checks together in two minutes on two cores.
    Quick,
    /// As many cases as the claim's record names.
    Full,
}

/// What an experiment is told: how much, and from which seed its cases come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Few or many cases.
    pub extent: Extent,
    /// The same seed gives the same cases.
    pub seed: u64,
}

impl Effort {
    /// `quick` or `full`.
    #[must_use]
    pub fn count(&self, quick: u64, full: u64) -> u64 {
        match self.extent {
            Extent::Tiny => (quick / 100).max(1),
            Extent::Quick => quick,
            Extent::Full => full,
        }
    }

    /// A source of cases for one part of an experiment: parts do not depend on each other's length.
    #[must_use]
    pub fn random(&self, part: u64) -> Random {
        Random::new(self.seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(part))
    }
}

impl Check {
    /// Runs the experiment.
    #[must_use]
    pub fn report(&self, effort: &Effort) -> Report {
        let mut report = Report::new(self.name, self.claim);
        (self.run)(effort, &mut report);
        report
    }
}
