//! What several test files share: built-in scenes as values, and pictures of them.

use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Accepts, Choices, Plan};
use farop::report::Counts;
use farop::scene::Scene;
use farop::screen::DrawList;
use farop::spd::{self, Curves};

/// A built-in scene, read from its own text.
pub fn built_in(name: &str, size: u32, curves: Curves) -> Scene {
    let scene = spd::find(name).unwrap_or_else(|| panic!("no scene {name}"));
    let mut text = Vec::new();
    spd::generate(scene, size, curves, &mut text).expect("memory takes it");
    read_nff(name, &text, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene
}

/// The draw list and the counts of a scene.
pub fn geometry_of(scene: &Scene, choices: &Choices) -> (DrawList, Counts) {
    let plan = Plan::new(scene, choices, Accepts::AnyPolygon).unwrap_or_else(|error| panic!("{error}"));
    let mut list = DrawList::new(0, 0);
    let counts = farop::geometry::run(scene, &plan, &mut list);
    (list, counts)
}
