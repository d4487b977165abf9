//! `student new` makes a whole crate, or nothing.

use farop::cli::student::{StudentError, create};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A folder with the least that makes a farop workspace, and a folder inside it.
fn workspace() -> (TempDir, PathBuf) {
    let root = tempfile::tempdir().expect("a temporary folder");
    let inside = root.path().join("docs/labs");
    fs::create_dir_all(&inside).expect("writable");
    fs::write(root.path().join("Cargo.toml"), "[workspace]\nmembers = [\"student_*\"]\n").expect("writable");
    // A manifest on the way up that is no workspace must be passed by.
    fs::write(root.path().join("docs/Cargo.toml"), "[package]\nname = \"docs\"\n").expect("writable");
    (root, inside)
}

/// Names of everything in a folder, hidden entries too.
fn entries(folder: &Path) -> Vec<String> {
    let names = fs::read_dir(folder).expect("readable").map(|entry| entry.expect("readable").file_name());
    let mut names: Vec<_> = names.map(|name| name.to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_crate_is_made_at_the_top_of_the_workspace_under_its_own_name() {
    let (root, inside) = workspace();
    let created = create(&inside, "ana").expect("made");
    assert_eq!(created.package, "student_ana");
    assert_eq!(created.folder, root.path().join("student_ana"));
    assert_eq!(entries(root.path()), ["Cargo.toml", "docs", "student_ana"]);
    assert_eq!(entries(&created.folder), ["Cargo.toml", "README.md", "src"]);
    // Every source of the lab crate is there: none was forgotten.
    let original = Path::new(env!("CARGO_MANIFEST_DIR")).join("student_rasterizers/src");
    let sources = entries(&original);
    assert_eq!(entries(&created.folder.join("src")), sources);
    let sources = sources.iter().map(|name| format!("src/{name}"));
    for file in ["Cargo.toml", "README.md"].map(str::to_string).into_iter().chain(sources) {
        let text = fs::read_to_string(created.folder.join(&file)).expect("readable");
        assert!(!text.contains("student_rasterizers"), "{file} still has the old name");
    }
    let manifest = fs::read_to_string(created.folder.join("Cargo.toml")).expect("readable");
    assert!(manifest.contains("name = \"student_ana\"") && manifest.contains("name = \"lab_ana\""), "{manifest}");
    assert!(manifest.contains("farop = { path = \"..\" }"), "{manifest}");
    let next = created.to_string();
    assert!(next.contains("cargo run -p student_ana -- render spd:gears -r mine"), "{next}");
    assert!(next.contains("cargo test -p student_ana -- --ignored"), "{next}");
}

#[test]
fn unfit_names_are_refused() {
    let (root, _) = workspace();
    for name in ["", "Ana", "1ana", "_ana", "ana-maria", "joão", "../ana", "a b", "ana\n"] {
        let error = create(root.path(), name).expect_err(name);
        assert!(matches!(error, StudentError::Name(_)), "{name}: {error}");
    }
    assert_eq!(entries(root.path()), ["Cargo.toml", "docs"]);
}

#[test]
fn what_is_there_is_left_alone() {
    let (root, _) = workspace();
    let own = root.path().join("student_ana");
    fs::create_dir(&own).expect("writable");
    let error = create(root.path(), "ana").expect_err("taken");
    assert!(matches!(error, StudentError::Exists(_)), "{error}");
    assert!(entries(&own).is_empty());
    assert_eq!(entries(root.path()), ["Cargo.toml", "docs", "student_ana"]);
}

#[test]
fn outside_of_a_workspace_nothing_is_made() {
    let outside = tempfile::tempdir().expect("a temporary folder");
    // A workspace that does not take in student crates is not farop's.
    fs::write(outside.path().join("Cargo.toml"), "[workspace]\nmembers = [\"other\"]\n").expect("writable");
    let error = create(outside.path(), "ana").expect_err("no workspace");
    assert!(matches!(error, StudentError::NoWorkspace(_)), "{error}");
    assert_eq!(entries(outside.path()), ["Cargo.toml"]);
}

#[test]
fn a_failure_leaves_nothing_behind() {
    let (root, _) = workspace();
    // No file system takes a name this long, but the draft has another: the failure comes late.
    let error = create(root.path(), &"a".repeat(300)).expect_err("too long");
    assert!(matches!(error, StudentError::Write { .. }), "{error}");
    assert_eq!(entries(root.path()), ["Cargo.toml", "docs"]);
}
