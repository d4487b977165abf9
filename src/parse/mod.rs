//! Text -> scene: readers of scene files; and of files of heights.
//!
//! file -load, input-> Source -tokens, nff or sipp-> SCENE
//!
//! Reading is all or nothing: a file with a mistake gives up to 20 diagnostics and no scene, so nobody draws half a
//! scene and wonders. What can be drawn in spite of an oddity is drawn, and told once in [`Parsed::notices`].
//!
//! Cost: `nff` reads more than 200 MB of text a second of processor time; memory holds the text without comments, and the scene.

mod area;
mod bezier;
pub mod built_in;
mod fcell;
mod fmap;
mod foreign;
mod ftri;
mod grids;
mod input;
mod inventory;
mod load;
mod nff;
mod sipp;
mod statements;
mod tokens;
mod trees;
mod vector;
mod wording;

pub use bezier::Net as BezierNet;
pub use fmap::load_map;
pub use grids::{GridOptions, load_grid, read_grid};
pub use input::{INPUT_LIMIT, LINE_LIMIT};
pub use inventory::{Inventory, check_field, load_inventory, read_inventory};
pub use load::{Format, load, load_cells, load_models};
pub use trees::{ListedTree, TreeList, load_trees};
pub use vector::{Vectors, load_vectors};

use crate::diagnostic::Diagnostics;
use crate::forest::area::Area;
use crate::scene::{Camera, NormalSource, Scene, Triangles};
use std::path::Path;

/// What the formats leave open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ParseOptions {
    /// Which side of a `pp` is its front.
    pub winding: Winding,
    /// What lights NFF's `p`: `Facet` (a flat facet, NFF's meaning) or `Averaged` (smooth over each surface, SIPP's).
    pub polygon_normals: NormalSource,
}

impl Default for ParseOptions {
    fn default() -> Self {
        ParseOptions { winding: Winding::File, polygon_normals: NormalSource::Facet }
    }
}

/// Which side of a polygon with given normals is its front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Winding {
    /// The one from which the file's order of vertices is counterclockwise.
    #[default]
    File,
    /// The one its vertex normals point to: some exporters write the wrong order.
    Auto,
}

/// A scene, and what is worth knowing about how it was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Parsed {
    /// What the file says.
    pub scene: Scene,
    /// What was dropped, replaced or looks odd; may be empty.
    pub notices: Diagnostics,
    /// Where the format says a scene without a camera is seen from; `None` for formats that say nothing, and for scenes
    /// that have one. It stays out of the scene so that merging never lets it win over a camera that somebody wrote.
    pub default_camera: Option<Camera>,
}

impl Parsed {
    /// The scene for a picture of its own: without a camera it gets the format's.
    #[must_use]
    pub fn into_scene(self) -> Scene {
        Scene { camera: self.scene.camera.or(self.default_camera), ..self.scene }
    }
}

/// Reads NFF from memory; `name` is what messages, [`Scene::files`] and the object call it.
///
/// # Errors
/// Up to 20 mistakes of the text, each with its place.
///
/// ```
/// use farop::parse::{ParseOptions, read_nff};
/// let parsed = read_nff("ball.nff", b"f 1 0 0 .8 0 0 0 1\ns 0 0 0 2\n", ParseOptions::default()).expect("it is legal");
/// assert_eq!(parsed.scene.surfaces[0].primitives.len(), 1);
/// let error = read_nff("ball.nff", b"s 0 0 nan 2", ParseOptions::default()).expect_err("it is not");
/// assert!(error.to_string().contains("ball.nff:1:7"));
/// ```
pub fn read_nff(name: &str, text: &[u8], options: ParseOptions) -> Result<Parsed, Diagnostics> {
    nff::read(&input::read_annotated_source(name, text)?, options)
}

/// Reads `.fcell` text from memory: an area of forest; `name` is what messages and [`Head::files`](crate::forest::area::Head::files) call it.
///
/// With the area comes what is worth knowing about how it was read. Grids that it names are looked for in the current folder;
/// [`load_cells`] looks beside the file it reads.
///
/// # Errors
/// Up to 20 mistakes of the text, each with its place.
///
/// ```
/// let text = b"fcell 1\ncell 0 0 size 240\ndem 2 2 z0 400 dz 0.5\n 0 0 10 -\nend\n";
/// let (area, _) = farop::parse::read_fcell("hill.fcell", text).expect("it is legal");
/// assert_eq!(area.cells[&[0, 0]].ground.sample(0, 1), 405.0);
/// let error = farop::parse::read_fcell("hill.fcell", b"fcell 1\ncel 0 0").expect_err("a mistake");
/// assert!(error.to_string().contains("did you mean `cell`?"));
/// ```
pub fn read_fcell(name: &str, text: &[u8]) -> Result<(Area, Diagnostics), Diagnostics> {
    fcell::read(&input::read_source(name, text)?, Path::new(""))
}

/// Reads `.ftri` triangles from memory; `name` is what messages and [`Scene::files`] call them.
///
/// # Errors
/// The mistake of the bytes, with its place: a file that is cut off, a size or an index that cannot be, matrices of no camera.
///
/// ```
/// let error = farop::parse::read_ftri("a.ftri", b"FTRI1\0\0\0\x03").expect_err("it is cut off");
/// assert!(error.to_string().contains("byte 9"));
/// ```
pub fn read_ftri(name: &str, bytes: &[u8]) -> Result<Parsed, Diagnostics> {
    ftri::read(name, bytes)
}

/// The scene of `triangles`, the same as that of their file; `name` is what [`Scene::files`] calls it.
///
/// # Errors
/// The matrices are none of a camera.
pub fn scene_of_triangles(name: &str, triangles: &Triangles) -> Result<Parsed, Diagnostics> {
    ftri::scene(name, triangles)
}

/// Reads a `.sipp` scene from memory; `name` is what messages and [`Scene::files`] call it.
///
/// Files that it imports are looked for in the current folder; [`load`] looks beside the file it reads.
///
/// # Errors
/// Up to 20 mistakes of the text, each with its place.
///
/// ```
/// use farop::parse::{ParseOptions, read_sipp};
/// let text = b"shader red phong { color 1 0 0 }  world { object ball { move 0 0 2  sphere { radius 1 shader red } } }";
/// let parsed = read_sipp("ball.sipp", text, ParseOptions::default()).expect("it is legal");
/// assert_eq!(parsed.scene.objects[0].name, "ball");
/// assert_eq!(parsed.into_scene().camera.map(|camera| camera.from.z), Some(10.0), "SIPP's default camera");
/// let error = read_sipp("ball.sipp", b"world { use bull }", ParseOptions::default()).expect_err("there is none");
/// assert!(error.to_string().contains("ball.sipp:1:13"));
/// ```
pub fn read_sipp(name: &str, text: &[u8], options: ParseOptions) -> Result<Parsed, Diagnostics> {
    sipp::read(&input::read_source(name, text)?, Path::new(""), options)
}

/// Reads SIPP's Bezier file from memory; `name` is what messages call it.
///
/// # Errors
/// The mistakes of the text, each with its place.
///
/// ```
/// use farop::parse::{BezierNet, read_bezier};
/// let text = b"bezier_curves: vertices: 2 vertex_list: 1 0 0  1 0 2  curves: 1 curve_list: 2 2 1 1";
/// let Ok(BezierNet::Curves(net)) = read_bezier("tube.bez", text) else { panic!("it is legal") };
/// assert_eq!(net.curves, [[0, 0, 1, 1]]);
/// ```
pub fn read_bezier(name: &str, text: &[u8]) -> Result<BezierNet, Diagnostics> {
    bezier::read(&input::read_source(name, text)?)
}
