//! The page `docs/first-ten-minutes.md`, Python's part: every command is run, and what the page shows is seen.
//! Rust's part is run by `student_rasterizers/tests/first_ten_minutes.rs`.

#[path = "support/walk.rs"]
mod walk;

use std::path::Path;
use std::process::Command;

const PAGE: &str = include_str!("../docs/first-ten-minutes.md");
const PROGRAM: &str = "student_rasterizers/other_languages/python/zbuffer.py";

#[test]
fn the_walk_in_python() {
    let has = |program: &str, argument: &str| Command::new(program).arg(argument).output().is_ok();
    if !has("python3", "--version") || !has("sh", "-c") {
        println!("notice: there is no python3, or no sh: the walk in Python is not tried");
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let copy = folder.path().join(PROGRAM);
    std::fs::create_dir_all(copy.parent().expect("a folder")).expect("it can be made");
    std::fs::copy(Path::new(env!("CARGO_MANIFEST_DIR")).join(PROGRAM), copy).expect("it can be copied");
    let steps = walk::steps(PAGE, "In Python");
    assert!(steps.len() >= 6, "{}", steps.len());
    for step in steps {
        let mut printed = String::new();
        for (number, command) in step.commands.iter().enumerate() {
            let (code, text) = run(folder.path(), command);
            let is_last = number + 1 == step.commands.len();
            assert_eq!(code, if is_last { step.code } else { 0 }, "{command}\n{text}");
            printed = text;
        }
        walk::assert_seen(&step, &printed);
    }
}

/// Runs one command line as a shell does, `farop` being the program under test.
fn run(folder: &Path, command: &str) -> (i32, String) {
    let programs = Path::new(env!("CARGO_BIN_EXE_farop")).parent().expect("a folder");
    let mut path = std::ffi::OsString::from(programs);
    path.push(":");
    path.push(std::env::var_os("PATH").unwrap_or_default());
    let mut shell = Command::new("sh");
    shell.args(["-c", command]).current_dir(folder).env("PATH", path).env("NO_COLOR", "1").env("COLUMNS", "80");
    let output = shell.output().expect("the shell starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    (output.status.code().unwrap_or(-1), text)
}
