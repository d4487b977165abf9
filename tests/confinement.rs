//! What holds a program outside farop is in the statistics, and `farop check extremes` sees misbehaving programs contained.
//! The program is farop itself: no compiler is needed.

#[path = "support/command.rs"]
mod command;

use command::Desk;
use serde_json::Value;
use std::process::Command;

fn json(arguments: &[&str]) -> (i32, Value) {
    let output = Command::new(env!("CARGO_BIN_EXE_farop")).args(arguments).output().expect("farop starts");
    let text = String::from_utf8_lossy(&output.stdout);
    let value = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    (output.status.code().unwrap_or(-1), value)
}

#[test]
fn statistics_have_what_was_enforced() {
    let program = format!("exec:'{}' __misbehave picture", env!("CARGO_BIN_EXE_farop"));
    let (code, stats) = json(&["render", "spd:tetra:1", "--size", "1", "-r", &program, "--stats=json"]);
    let limits = &stats["enforced"]["limits"];
    assert_eq!((code, &limits["time_s"], &limits["output_bytes"]), (0, &10.0.into(), &(64 << 20).into()));
    for protection in ["network_denied", "writes_denied", "reads_confined"] {
        assert!(stats["enforced"][protection].is_boolean(), "{protection}");
    }
    if cfg!(target_os = "linux") {
        assert_eq!((&limits["memory_bytes"], &limits["processes"]), (&(512 << 20).into(), &16.into()));
        assert_eq!(limits["processor_time_s"], 40);
    }
    // What is part of the program is not confined.
    let (_, stats) = json(&["render", "spd:tetra:1", "--size", "1", "--stats=json"]);
    assert!(stats.as_object().is_some_and(|all| all.get("enforced").is_some_and(Value::is_null)));
}

#[test]
fn misbehaving_programs_are_contained_and_named() {
    let (_, reports) = json(&["check", "extremes", "--quick", "--json"]);
    let misses = reports[0]["misses"].as_array().expect("a list");
    assert!(!misses.iter().any(|miss| miss.as_str().is_some_and(|miss| miss.starts_with("102"))), "{misses:?}");
    let figures: Vec<String> =
        reports[0]["figures"].as_array().expect("a list").iter().map(|figure| figure["name"].to_string()).collect();
    assert!(!figures.iter().any(|name| name.contains("not yet: 102")), "{figures:?}");
    // It was tried with programs, not only with rasterizers of this one.
    assert!(!figures.iter().any(|name| name.contains("of this program only")), "{figures:?}");
    figures.iter().filter(|name| name.contains("notice")).for_each(|name| println!("{name}"));
}

#[test]
fn extremes_of_a_program_end_where_it_does() {
    let desk = Desk::new();
    // A lab without polygons has no extremes.
    assert_eq!(desk.run("grade wire -r wire --extremes").code, 2);
    let program = format!("exec:'{}' __misbehave picture", env!("CARGO_BIN_EXE_farop"));
    let (code, report) = json(&["grade", "coverage", "-r", &program, "--extremes", "--json"]);
    let finding = |kind: &str| {
        let all = report["extremes"].as_array().expect("a list");
        all.iter().find(|finding| finding["kind"] == kind).cloned().unwrap_or_else(|| panic!("no {kind}"))
    };
    // One black sample is right for an empty list of one, and for nothing else.
    assert_eq!((code, &report["passed"]), (1, &false.into()));
    assert_eq!(finding("empty list")["tried"].as_array().map(Vec::len), Some(2));
    let what = finding("width")["first"]["what"].to_string();
    assert!(what.contains("no picture: the picture is 1 x 1 samples, it should be 8 x 12"), "{what}");
}
