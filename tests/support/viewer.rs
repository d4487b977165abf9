//! Viewers for tests: scenes of the project, keys, no window.

#![allow(dead_code, reason = "every test binary uses a part")]

use farop::parse::{ParseOptions, load, read_nff};
use farop::plan::Choices;
use farop::raster::{Fast, Rasterizer, Watkins, ZBuffer};
use farop::scene::Scene;
use farop::view::made::Named;
use farop::view::{Action, Viewer, read_keys};
use std::path::Path;
use std::sync::LazyLock;

/// A scene of the project, or a built-in one.
pub fn scene(name: &str) -> Scene {
    if let Some(built_in) = name.strip_prefix("spd:") {
        let text = farop::parse::built_in::text(built_in, farop::spd::Curves::Kept).expect("a built-in scene");
        return read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene;
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    let mut scene = load(&path, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).into_scene();
    // Not where the tests happen to be.
    scene.files = vec![name.to_string()];
    scene
}

/// The rasterizers that tests choose from: z-buffer, fast, Watkins.
pub fn rasterizers() -> Vec<Named<'static>> {
    static FAST: LazyLock<Fast> = LazyLock::new(Fast::default);
    let named = |name: &str, rasterizer: &'static dyn Rasterizer| (name.to_string(), rasterizer);
    vec![named("zbuffer", &ZBuffer), named("fast", &*FAST), named("watkins", &Watkins)]
}

/// A viewer of `side` x `side` pixels, drawn by the z-buffer.
pub fn viewer(name: &str, side: u32) -> Viewer<'static> {
    let choices = Choices { size: Some((side, side)), ..Choices::default() };
    Viewer::new(scene(name), &choices, rasterizers()).expect("the scene has a camera")
}

/// Presses keys and returns what they ask of the shell.
pub fn press(viewer: &mut Viewer<'_>, keys: &str) -> Vec<Action> {
    let events = read_keys(keys).unwrap_or_else(|error| panic!("{error}"));
    events.iter().filter_map(|event| viewer.handle(event)).collect()
}

/// Presses keys, draws, and returns the text.
pub fn told(viewer: &mut Viewer<'_>, keys: &str) -> String {
    press(viewer, keys);
    viewer.draw();
    assert_eq!(viewer.trouble(), None, "{keys}");
    viewer.text().join("\n")
}
