//! Single: one submission, compiled and run as those of a class are, for whoever grades one at a time: a platform.
//!
//! file or folder -COLLECT, BUILD-> program in a cell -CONFINED-> subject -> whatever the caller does with it

use super::confined::Confined;
use super::{Built, Class, Sandbox, Store, Tools, build, collect};
use crate::grade::labs::Lab;
use crate::grade::rubric::Rubric;
use crate::grade::subject::Subject;
use std::path::Path;

/// Hands the submission in `path` to `grade`; the cell it lies in is gone afterwards.
///
/// # Errors
/// In words: why there is nothing to run, or what the compiler says.
pub fn with_submission<R>(
    lab: &Lab,
    path: &Path,
    (sandbox, tools): (&Sandbox, &Tools),
    grade: &mut dyn FnMut(&dyn Subject) -> R,
) -> Result<R, String> {
    if !path.exists() {
        return Err(format!("cannot read {}: it is not there", path.display()));
    }
    let rubric = Rubric::default();
    let class = Class { lab, seed: 0, rubric: &rubric, sandbox, tools, jobs: 1 };
    if class.is_about_function() {
        return Err(format!("lab {} is about a function: grade such submissions with --class", lab.name));
    }
    let home = tempfile::tempdir().map_err(|error| error.to_string())?;
    let store = Store::open(home.path(), true)?;
    let cells = store.cells()?;
    let cell = cells.open(sandbox)?;
    let files = collect::copy(path, cell.path());
    match build::build(&files, cell.path(), &class) {
        Ok(Built::Function(_)) => Err("a function is no rasterizer".to_string()),
        Ok(built) => Ok(grade(&Confined::new(built, sandbox, cell.path()))),
        Err(build::NotBuilt::Nothing(words) | build::NotBuilt::Refused(words)) => Err(words),
    }
}
