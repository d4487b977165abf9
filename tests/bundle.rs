//! The bundle, unpacked and run as the platform would: its folders, its scripts, a file of results whatever happens.

#![cfg(unix)]

#[path = "support/command.rs"]
mod command;

use command::Desk;
use flate2::read::DeflateDecoder;
use serde_json::Value;
use std::io::Read;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const PYTHON: &str = include_str!("../student_rasterizers/other_languages/python/zbuffer.py");

/// Unpacks a zip by its directory: names, permissions, bytes.
fn unpacked(bytes: &[u8]) -> Vec<(String, u32, Vec<u8>)> {
    let half = |at: usize| usize::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    let word = |at: usize| half(at) | half(at + 2) << 16;
    let end = bytes.len() - 22;
    assert_eq!(&bytes[end..end + 4], b"PK\x05\x06");
    let (count, mut at) = (half(end + 10), word(end + 16));
    assert_eq!(at + word(end + 12), end);
    let mut files = Vec::new();
    for _ in 0..count {
        assert_eq!(&bytes[at..at + 4], b"PK\x01\x02");
        let (crc, packed, size, name_length, mode, start) =
            (word(at + 16), word(at + 20), word(at + 24), half(at + 28), word(at + 38) >> 16, word(at + 42));
        let name = String::from_utf8(bytes[at + 46..at + 46 + name_length].to_vec()).expect("UTF-8");
        // The record before the bytes says the same.
        assert_eq!(&bytes[start..start + 4], b"PK\x03\x04");
        assert_eq!(bytes[start + 6..start + 26], bytes[at + 8..at + 28], "{name}");
        let data = start + 30 + half(start + 26) + half(start + 28);
        let mut content = Vec::new();
        DeflateDecoder::new(&bytes[data..data + packed]).read_to_end(&mut content).expect("deflated bytes");
        let mut sum = flate2::Crc::new();
        sum.update(&content);
        assert_eq!((content.len(), sum.sum() as usize), (size, crc), "{name}");
        files.push((name, mode as u32, content));
        at += 46 + name_length + half(at + 30) + half(at + 32);
    }
    files
}

/// The platform's folders below `base`, with the bundle unpacked and a submission in place.
fn platform(base: &Path, bundle: &[u8], submission: &[(&str, &str)]) {
    for folder in ["source", "submission", "results"] {
        std::fs::create_dir_all(base.join(folder)).expect("a folder");
    }
    for (name, mode, content) in unpacked(bundle) {
        let path = base.join("source").join(name);
        std::fs::write(&path, content).expect("a file");
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(mode & 0o777)).expect("permissions");
    }
    // Submissions run as somebody else, who must find the way to farop, as on the platform.
    for folder in base.ancestors().take(2) {
        std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o755)).expect("permissions");
    }
    // The platform copies it next to the folders.
    std::fs::copy(base.join("source/run_autograder"), base.join("run_autograder")).expect("a file");
    for (name, text) in submission {
        std::fs::write(base.join("submission").join(name), text).expect("a file");
    }
}

fn run(base: &Path) -> Command {
    let mut command = Command::new("bash");
    command.arg(base.join("run_autograder")).current_dir(base).env("FAROP_AUTOGRADER", base);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn results(base: &Path) -> Value {
    let text = std::fs::read(base.join("results/results.json")).expect("a file of results");
    serde_json::from_slice(&text).expect("whole JSON")
}

fn points(value: &Value) -> (f64, f64) {
    let tests = value["tests"].as_array().expect("tests");
    let sum = |field: &str| tests.iter().filter_map(|test| test[field].as_f64()).sum();
    (sum("score"), sum("max_score"))
}

fn is_there(program: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success());
    if !there {
        println!("notice: `{program}` is not installed, the test passes without it");
    }
    there
}

fn said(output: &Output) -> String {
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

#[test]
fn the_zip_has_what_the_platform_asks_for_and_the_same_bytes_every_time() {
    let desk = Desk::new();
    desk.write("rubric.toml", "[points]\nties = 20\n[hidden]\nshare = 0.25\n");
    let options = "--rubric rubric.toml --seed 4 --hidden 99 --leaderboard";
    desk.done(&format!("grade coverage {options} --bundle gradescope one.zip"));
    desk.done(&format!("grade coverage {options} --bundle gradescope two.zip"));
    let zip = desk.read("one.zip");
    assert!(zip == desk.read("two.zip"));
    let files = unpacked(&zip);
    let names: Vec<_> = files.iter().map(|(name, mode, _)| (name.as_str(), mode & 0o111 != 0)).collect();
    let expected =
        [("setup.sh", true), ("run_autograder", true), ("about.txt", false), ("farop", true), ("rubric.toml", false)];
    assert_eq!(names, expected);
    let script = String::from_utf8_lossy(&files[1].2);
    assert!(script.starts_with("#!/usr/bin/env bash\n") && !script.contains('@'), "{script}");
    assert!(script.contains("--seed 4 --hidden 99") && script.contains("--leaderboard"), "{script}");
    // Others read it, too.
    if is_there("python3") {
        let output = Command::new("python3").args(["-m", "zipfile", "-t"]).arg(desk.path("one.zip")).output();
        let output = output.expect("python3 starts");
        assert!(output.status.success() && !said(&output).contains("error"), "{}", said(&output));
    }
    // As a folder it is the same.
    desk.done(&format!("grade coverage {options} --bundle gradescope folder"));
    for (name, mode, content) in files {
        let path = desk.path("folder").join(&name);
        assert!(std::fs::read(&path).expect("a file") == content, "{name}");
        let is_program = std::fs::metadata(&path).expect("a file").permissions().mode() & 0o111 != 0;
        assert_eq!(is_program, mode & 0o111 != 0, "{name}");
    }
}

#[test]
fn it_grades_as_the_platform_would_run_it() {
    if !is_there("python3") {
        return;
    }
    let desk = Desk::new();
    desk.done("grade coverage --hidden 7 --bundle gradescope bundle.zip");
    let bundle = desk.read("bundle.zip");
    let wrong = PYTHON.replace("row + 0.5", "row + 0.0");
    assert_ne!(wrong, PYTHON);
    let crash = "import sys\nsys.exit('<b>nothing works</b>')\n";
    for (name, program, is_full) in [("right", PYTHON, true), ("wrong", &wrong, false), ("crash", crash, false)] {
        let base = desk.path(name);
        platform(&base, &bundle, &[("zbuffer.py", program), ("notes.txt", "by Ana")]);
        let output = run(&base).output().expect("bash starts");
        assert!(output.status.success(), "{name}: {}", said(&output));
        let (score, most) = points(&results(&base));
        assert_eq!((score >= most, most > 0.0), (is_full, true), "{name}: {score} of {most}: {}", said(&output));
        assert_eq!(name == "crash", score == 0.0, "{name}: {score}");
        let tests = results(&base)["tests"].as_array().cloned().expect("tests");
        assert!(tests.iter().any(|test| test["visibility"] == "hidden"));
    }
    // What does not even start has a file as well.
    let base = desk.path("nothing");
    platform(&base, &bundle, &[("notes.txt", "I was ill")]);
    assert!(run(&base).output().expect("bash starts").status.success());
    let value = results(&base);
    assert!(value["output"].as_str().is_some_and(|text| text.contains("nothing to run")), "{value}");
    assert_eq!(points(&value).0, 0.0);
}

#[test]
fn a_grader_that_is_stopped_leaves_what_was_earned() {
    if !is_there("python3") {
        return;
    }
    let desk = Desk::new();
    desk.done("grade coverage --bundle gradescope bundle.zip");
    let base = desk.path("slow");
    // Fast at first, and from the sixth picture on for ever: only the limit of every run would end it.
    let slow = PYTHON.replace(
        "    while (read := read_list(sys.stdin)) is not None:",
        "    import os, time\n    while (read := read_list(sys.stdin)) is not None:\n        if read[0]['size'] == ['8', '8'] and len(read[1]) == 8:\n            time.sleep(1000)",
    );
    assert_ne!(slow, PYTHON);
    platform(&base, &desk.read("bundle.zip"), &[("zbuffer.py", &slow)]);
    let mut grader = run(&base).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("bash starts");
    let (start, path) = (Instant::now(), base.join("results/results.json"));
    // Whenever somebody looks, the file is whole.
    let mut earned = 0.0;
    while earned < 15.0 && start.elapsed() < Duration::from_secs(120) {
        if path.exists() {
            earned = points(&results(&base)).0;
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    // The script and what it started: the platform removes the whole container.
    let _ = Command::new("pkill").args(["-KILL", "-P", &grader.id().to_string()]).status();
    grader.kill().expect("it can be stopped");
    grader.wait().expect("it ends");
    let value = results(&base);
    assert!(points(&value).0 >= 15.0, "{value}");
    assert!(value["output"].as_str().is_some_and(|text| text.contains("stopped before its end")), "{value}");
}

#[test]
fn wrong_orders_are_explained() {
    let desk = Desk::new();
    for (arguments, words) in [
        ("grade coverage --bundle moodle a.zip", "there is gradescope"),
        ("grade clip --bundle gradescope a.zip", "about a function"),
        ("grade coverage --bundle gradescope no/where.zip", "no folder"),
        ("grade coverage --submission missing", "cannot read missing"),
    ] {
        let outcome = desk.run(arguments);
        assert_eq!(outcome.code, 2, "{arguments}");
        assert!(outcome.stderr.contains(words), "{arguments}: {}", outcome.stderr);
    }
    assert_eq!(desk.entries(), [""; 0]);
    desk.write("a.c", "int main(void) { return x; }");
    let outcome = desk.run("grade coverage --submission a.c --prairielearn p.json");
    assert!(outcome.code == 2 && outcome.stderr.contains("does not compile"), "{}", outcome.stderr);
    let value: Value = serde_json::from_slice(&desk.read("p.json")).expect("JSON");
    assert!(
        value["gradable"] == false
            && value["format_errors"][0].as_str().is_some_and(|text| text.contains("undeclared")),
        "{value}"
    );
}
