//! The example readers in C, C++, Java, Python, Rust and JavaScript: short enough to hand out, and right.

use farop::color::Rgb;
use farop::math::Vec3;
use farop::plan::{DepthFormat, Varying};
use farop::scene::{Reflection, SpotEdge};
use farop::screen::DrawList;
use farop::screen::file::{Attributes, READERS, Sheet, write_v2};
use farop::screen::shader::{EyeLight, EyeSource, Spot};
use std::path::Path;
use std::process::{Command, Output};

/// Triangles in several places, as a v2 file.
fn example() -> (String, String) {
    let mut list = DrawList::new(64, 48);
    list.push_flat(&[(1.25, 2.5), (40.0, 3.0), (20.5, 30.75)], 0.5, [1.0, 0.5, 0.25]);
    list.push_flat(&[(10.0, 0.125), (63.5, 20.0), (50.0, 47.5), (12.0, 40.0)], 0.25, [0.1, 1e-9, 0.7]);
    assert_eq!((list.varying, list.depth_mapping.format), (Varying::Color, DepthFormat::F32));
    // What only light is made of is nothing to a reader of colors.
    let towards = EyeSource::Directional { to_light: Vec3::Y };
    let spot = Spot { position: Vec3::ONE, axis: Vec3::Z, cosine: 0.75, edge: SpotEdge::Soft };
    list.shader.lights =
        [towards, EyeSource::Spot(spot)].map(|source| EyeLight { source, color: Rgb::gray(0.5) }).to_vec();
    list.shader.surfaces[0].reflection = Reflection::Basic { c3: 0.25 };
    list.shader.surfaces[1].reflection = Reflection::Phong;
    let sheet = Sheet { background: Rgb::gray(0.1), ..Sheet::default() };
    let mut bytes = Vec::new();
    write_v2(&list, &sheet, Attributes::default(), &mut bytes).expect("memory takes everything");
    let expected = "size 64 48\npolygons 2\nvertices 7\nx 1.250000 63.500000\ny 0.125000 47.500000\n";
    (String::from_utf8(bytes).expect("ASCII"), expected.to_string())
}

/// Runs a command in `folder`; `None`, with a notice, where the tool is missing.
fn run(folder: &Path, command: &[&str]) -> Option<Output> {
    // What was built here is started by its whole path: where `./` leads differs between systems.
    let program = command[0].strip_prefix("./").map_or_else(|| command[0].into(), |name| folder.join(name));
    let started = Command::new(program).args(&command[1..]).current_dir(folder).output();
    match started {
        Ok(output) => Some(output),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            println!("notice: `{}` is not installed, its reader is not tested", command[0]);
            None
        }
        Err(error) => panic!("{command:?}: {error}"),
    }
}

/// Writes reader and file into a folder, builds, runs, and compares what it prints.
fn check(name: &str, build: Option<&[&str]>, start: &[&str]) {
    let (text, expected) = example();
    let folder = tempfile::tempdir().expect("a place for files");
    let (_, source) = READERS.iter().find(|(reader, _)| *reader == name).expect("the reader is there");
    std::fs::write(folder.path().join(name), source).expect("room for a file");
    std::fs::write(folder.path().join("list.scr"), text).expect("room for a file");
    for command in build.into_iter().chain([start]) {
        let Some(output) = run(folder.path(), command) else { return };
        let (printed, said) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        assert!(output.status.success(), "{command:?}: {printed}{said}");
        if command == start {
            assert_eq!(printed.replace("\r\n", "\n"), expected, "{name}");
        } else {
            assert_eq!(said, "", "{command:?} warns");
        }
    }
}

#[test]
fn readers_are_short() {
    for (name, text) in READERS {
        assert!(text.lines().count() <= 40, "{name} has {} lines", text.lines().count());
        assert!(text.lines().all(|line| line.len() <= 120), "{name}");
    }
}

#[test]
fn c() {
    check("reader.c", Some(&["gcc", "-O1", "-Wall", "-o", "reader", "reader.c"]), &["./reader", "list.scr"]);
}

#[test]
fn cpp() {
    check("reader.cpp", Some(&["g++", "-std=c++11", "-Wall", "-o", "reader", "reader.cpp"]), &["./reader", "list.scr"]);
}

#[test]
fn java() {
    check("Reader.java", Some(&["javac", "Reader.java"]), &["java", "Reader", "list.scr"]);
}

#[test]
fn python() {
    check("reader.py", None, &["python3", "reader.py", "list.scr"]);
}

#[test]
fn rust() {
    check("reader.rs", Some(&["rustc", "-O", "--edition=2021", "reader.rs"]), &["./reader", "list.scr"]);
}

#[test]
fn javascript() {
    check("reader.js", None, &["node", "reader.js", "list.scr"]);
}
