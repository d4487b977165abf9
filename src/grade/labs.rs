//! Labs: what a student builds, by name, and the aspects it is graded by, easy ones first.
//!
//! Each aspect is a handful of [`Case`]s that ask for one thing. Aspects of all labs come from the same lists, so that a z-buffer
//! and a Watkins that draw the same picture get the same words.

use super::case::Case;
use super::cases::{color, coverage, depth, light, lines, samples};
use super::hidden::{self, Probes};

/// Something to build.
#[derive(Clone, Copy)]
pub struct Lab {
    /// What follows `farop grade`.
    pub name: &'static str,
    /// One line for `farop list labs`.
    pub summary: &'static str,
    /// Easy ones first.
    pub aspects: &'static [Aspect],
    /// Left and upper edges belong to a polygon; else any rule does that gives every center to one polygon.
    pub fixes_ties: bool,
    /// Which of its probes are asked: those that students have, or those that only the grader has.
    pub probes: Probes,
}

impl Lab {
    /// The same lab asked with its hidden probes.
    #[must_use]
    pub fn hidden(&self) -> Lab {
        Lab { probes: Probes::Hidden, ..*self }
    }

    /// The cases that one of its aspects is asked with; `seed` picks the random ones.
    #[must_use]
    pub fn cases(&self, aspect: &Aspect, seed: u64) -> Vec<Case> {
        match self.probes {
            Probes::Visible => (aspect.cases)(seed),
            Probes::Hidden => hidden::cases(aspect, seed),
        }
    }
}

/// One thing that is graded.
#[derive(Clone, Copy)]
pub struct Aspect {
    /// Its name in reports and rubrics.
    pub name: &'static str,
    /// What is asked, in one line.
    pub asks: &'static str,
    /// Points without a rubric.
    pub points: u32,
    /// The cases it is asked with; the number picks the random ones.
    pub cases: fn(u64) -> Vec<Case>,
    /// What is watched besides the picture.
    pub watch: Watch,
}

/// What is watched besides the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watch {
    /// Nothing.
    Picture,
    /// The same list twice, and in another order.
    State,
    /// Every sample put once.
    PutOnce,
    /// Time for a small polygon on a large picture.
    Cost,
}

const fn aspect(name: &'static str, asks: &'static str, points: u32, cases: fn(u64) -> Vec<Case>) -> Aspect {
    Aspect { name, asks, points, cases, watch: Watch::Picture }
}

const FIRST: Aspect =
    aspect("first picture", "something is drawn where it belongs, none of it elsewhere", 5, coverage::first);
const PLACE: Aspect =
    aspect("orientation", "up is up and left is left, on a picture that is not square", 5, coverage::orientation);
const CHANNELS: Aspect =
    aspect("channels", "red, green and blue in this order, on the background of the sheet", 5, color::channels);
const LEVELS: Aspect = aspect("levels", "light becomes the nearest level", 5, color::levels);
const POSITION: Aspect = aspect("sample position", "samples are asked for at their centers", 10, coverage::position);
const TIES: Aspect = aspect("ties", "a center on an edge belongs to one polygon", 10, coverage::ties);
const SHARED: Aspect = aspect("shared edges", "fans and meshes without cracks", 10, coverage::shared);
const WINDING: Aspect = aspect("winding", "clockwise and counterclockwise outlines", 5, coverage::winding);
const CONCAVE: Aspect = aspect("concave", "notches stay open, corners on scan lines", 5, coverage::concave);
const BORDERS: Aspect =
    aspect("borders", "the first and the last row and column, and nothing beyond", 5, coverage::borders);
const TINY: Aspect =
    aspect("small polygons", "polygons about as large as a sample, and without area", 5, coverage::tiny);
const SLIVERS: Aspect = aspect("slivers", "polygons thinner than a sample, long ones", 5, coverage::slivers);
const DEPTH: Aspect = aspect("depth", "the nearer polygon hides the farther, in any order", 15, depth::order);
const PIERCING: Aspect =
    aspect("piercing", "polygons that pierce each other or overlap in a ring", 10, depth::piercing);
const EQUAL: Aspect = aspect("equal depth", "of equal depths the first in the list", 5, depth::equal);
const RANGE: Aspect = aspect("depth range", "very near and very far polygons", 5, depth::range);
const GLASS: Aspect = aspect("transparency", "what is behind glass shows through", 5, depth::glass);
const GOURAUD: Aspect = aspect("interpolation", "values spread from the corners", 15, color::interpolation);
const CORNERS: Aspect =
    aspect("corner order", "every corner keeps its own value, in any order", 10, color::corner_order);
const PERSPECTIVE: Aspect = aspect("perspective", "values spread in space, not on the screen", 15, color::perspective);
const LIGHT: Aspect = aspect("light", "the light of every sample, from its own normal", 25, light::light);
const SAMPLES: Aspect = aspect("samples", "a pixel is the mean of its samples", 25, samples::samples);
const LINES: Aspect = aspect("lines", "lines in all directions", 30, lines::directions);
const OUTLINES: Aspect = aspect("outlines", "closed outlines, lines that meet", 20, lines::outlines);
const SHORT_LINES: Aspect =
    aspect("short lines", "lines about as long as a sample, ends between samples", 10, lines::short);
const STATE: Aspect = Aspect {
    watch: Watch::State,
    ..aspect("state", "the same list gives the same picture, in any order", 5, depth::state)
};
const ONCE: Aspect = Aspect {
    watch: Watch::PutOnce,
    ..aspect(
        "scan-line order",
        "every sample put once, in scan-line order, without looking at the depth kept",
        20,
        depth::once,
    )
};
const COST: Aspect =
    Aspect { watch: Watch::Cost, ..aspect("cost", "a small polygon costs as much as it covers", 5, |_| Vec::new()) };

/// All labs.
pub const LABS: &[Lab] = &[
    Lab {
        name: "wire",
        summary: "edges by the diamond-exit rule",
        aspects: &[LINES, OUTLINES, SHORT_LINES],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "coverage",
        summary: "which samples a polygon covers, with the tie rule",
        aspects: &[
            FIRST, PLACE, CHANNELS, LEVELS, POSITION, TIES, SHARED, WINDING, CONCAVE, BORDERS, TINY, SLIVERS, STATE,
            COST,
        ],
        fixes_ties: true,
        probes: Probes::Visible,
    },
    Lab {
        name: "zbuffer",
        summary: "coverage and depth: the nearest polygon at every sample",
        aspects: &[
            FIRST, PLACE, CHANNELS, LEVELS, POSITION, TIES, SHARED, WINDING, CONCAVE, BORDERS, TINY, SLIVERS, DEPTH,
            EQUAL, PIERCING, RANGE, GLASS, STATE, COST,
        ],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "gouraud",
        summary: "a z-buffer with colors interpolated in perspective",
        aspects: &[FIRST, PLACE, CHANNELS, LEVELS, POSITION, TIES, DEPTH, GOURAUD, CORNERS, PERSPECTIVE, STATE],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "watkins",
        summary: "scan line by scan line, every sample put once",
        aspects: &[
            FIRST, PLACE, CHANNELS, LEVELS, POSITION, TIES, SHARED, WINDING, CONCAVE, BORDERS, TINY, SLIVERS, DEPTH,
            EQUAL, PIERCING, RANGE, ONCE, STATE,
        ],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "phong",
        summary: "light at every sample, from interpolated normals",
        aspects: &[FIRST, PLACE, LEVELS, POSITION, TIES, DEPTH, LIGHT, STATE],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "supersampling",
        summary: "several samples a pixel, averaged",
        aspects: &[FIRST, PLACE, LEVELS, POSITION, TIES, DEPTH, SAMPLES, STATE],
        fixes_ties: false,
        probes: Probes::Visible,
    },
];

/// The lab of that name, in which pictures are drawn; labs about functions stand in [`super::functions`].
#[must_use]
pub fn find(name: &str) -> Option<&'static Lab> {
    LABS.iter().find(|lab| lab.name == name)
}
