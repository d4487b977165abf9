//! Bundle: what a platform wants uploaded so that it grades by itself.
//!
//! lab, rubric, seeds, this program -BUNDLE-> files -zip-> upload
//!
//! Why this very program goes in: the same bytes give the same verdict at home and on the platform, and nothing has to be built or fetched there
//! but the languages of submissions.
//!
//! Source of the layout: gradescope/autograder_samples, docs/specs.md.

mod zip;

pub use zip::{Packed, zip};

/// What a bundle is made for.
pub struct Order<'a> {
    /// Name of the lab.
    pub lab: &'a str,
    /// Picks the random visible probes.
    pub seed: u64,
    /// Picks the hidden ones, if any are asked.
    pub hidden: Option<u64>,
    /// Text of the rubric, if there is one.
    pub rubric: Option<&'a str>,
    /// Whether there is a leaderboard.
    pub leaderboard: bool,
}

const SETUP: &str = include_str!("setup.sh");
const RUN: &str = include_str!("run_autograder.sh");
const ABOUT: &str = include_str!("about.txt");

/// The files of Gradescope's zip; `program` is farop, or a student crate's program with the course's own rasterizers.
#[must_use]
pub fn gradescope(order: &Order<'_>, program: Vec<u8>) -> Vec<Packed> {
    let mut options = format!("--seed {}", order.seed);
    if let Some(seed) = order.hidden {
        options += &format!(" --hidden {seed}");
    }
    if order.rubric.is_some() {
        options += " --rubric \"$base/source/rubric.toml\"";
    }
    if order.leaderboard {
        options += " --leaderboard";
    }
    let run = RUN.replace("@LAB@", order.lab).replace("@OPTIONS@", &options);
    let text = |name: &str, is_program, text: &str| Packed { name: name.into(), is_program, bytes: text.into() };
    let mut files = vec![
        text("setup.sh", true, SETUP),
        text("run_autograder", true, &run),
        text("about.txt", false, &ABOUT.replace("@LAB@", order.lab)),
        Packed { name: "farop".into(), is_program: true, bytes: program },
    ];
    files.extend(order.rubric.map(|rubric| text("rubric.toml", false, rubric)));
    files
}
