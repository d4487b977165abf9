//! One algorithm, every door: the same mistakes and the same points, whether pictures come from files, from a program that is
//! started for each, from one that keeps running, or from a library.
#![cfg(target_os = "linux")]

use bank::judge::{self, Clock, Entry};
use bank::kept::{self, Kept};
use farop::grade::folder::Pictures;
use farop::grade::{Outside, Subject, Verdict, labs};
use farop::raster::external::External;
use std::ffi::OsString;
use std::fs::File;
use std::path::Path;
use std::process::Command;

#[path = "../student_rasterizers/bank/mod.rs"]
#[allow(dead_code, reason = "other users of the bank use the rest")]
mod bank;

const LAB: &str = "zbuffer";

fn entry(slip: &str) -> Entry {
    let (language, source, truth) = (String::new(), String::new(), String::new());
    let (slip, lab) = (slip.to_string(), LAB.to_string());
    Entry { language, source, slip, lab, truth, names: Vec::new(), right: false, set: None }
}

/// What must be the same: names of mistakes, and aspect by aspect the points.
fn said(subject: &dyn Subject, slip: &str) -> (Vec<&'static str>, Vec<(&'static str, f64)>) {
    let verdict: Verdict = judge::verdict_of(&entry(slip), subject, Clock::Unused).expect("a verdict");
    let names = verdict.faults.iter().map(|fault| fault.name).collect();
    (names, verdict.aspects.iter().map(|aspect| (aspect.name, aspect.earned)).collect())
}

/// Pictures of the lab's files, drawn by a command.
fn draw_suite(words: &[OsString], folder: &Path) {
    let suite = Command::new(env!("CARGO_BIN_EXE_farop")).args(["suite", LAB, "-o"]).arg(folder).output();
    assert!(suite.expect("farop starts").status.success());
    let entries = std::fs::read_dir(folder).expect("a folder");
    for file in entries.map(|entry| entry.expect("readable").path()) {
        if file.extension().is_some_and(|ending| ending == "scr") {
            let picture = File::create(file.with_extension("ppm")).expect("writable");
            let scene = File::open(&file).expect("readable");
            let status = Command::new(&words[0]).args(&words[1..]).stdin(scene).stdout(picture).status();
            assert!(status.expect("the program starts").success());
        }
    }
}

/// The verdicts on a command by file, by program, and kept running; they must be one. Returns it.
fn same_verdict(words: &[OsString], slip: &str) -> (Vec<&'static str>, Vec<(&'static str, f64)>) {
    let folder = tempfile::tempdir().expect("a folder");
    draw_suite(words, folder.path());
    let lab = labs::find(LAB).expect("a lab");
    let by_file = said(&Pictures::new(folder.path(), lab, 1), slip);
    let kept = said(&Kept::start(words).expect("the program starts"), slip);
    assert_eq!(by_file, kept, "file, kept: {slip}");
    let command: Vec<String> = words.iter().map(|word| format!("'{}'", word.to_string_lossy())).collect();
    let by_program = said(&outside(&format!("exec:{}", command.join(" "))), slip);
    assert_eq!(by_file, by_program, "file, program: {slip}");
    by_file
}

fn outside(name: &str) -> Outside {
    Outside::new(External::from_name(name).expect("a door").with_host(env!("CARGO_BIN_EXE_farop")))
}

#[test]
fn c_gets_one_verdict_through_file_program_and_library() {
    if !kept::is_there("cc") {
        return println!("notice: there is no `cc`");
    }
    let folder = tempfile::tempdir().expect("a folder");
    for (slip, names) in [("none", vec![]), ("or_for_xor", vec!["convex outlines only"])] {
        let program = kept::compile("stencil", slip, folder.path()).expect("it builds");
        let found = same_verdict(&[program.into()], slip);
        assert_eq!(found.0, names);
        let library = kept::compile_library("stencil", slip, folder.path()).expect("it builds");
        assert_eq!(found, said(&outside(&format!("lib:{}", library.display())), slip), "library: {slip}");
    }
}

#[test]
fn python_gets_one_verdict_through_file_and_program() {
    if !kept::is_there("python3") {
        return println!("notice: there is no `python3`");
    }
    let script = kept::folder().join("python/sorting.py");
    for (slip, names) in [("none", vec![]), ("list_turned_round", vec!["the later of equals"])] {
        let words = ["python3".into(), "-S".into(), "-B".into(), script.clone().into(), slip.into()];
        assert_eq!(same_verdict(&words, slip).0, names);
    }
}
