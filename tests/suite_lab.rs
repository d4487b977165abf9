//! The suite of a lab: complete, the same every time, hidden where it should be, and right: what a program draws from its files is what it
//! expects and what the grader accepts.

#[path = "support/command.rs"]
mod command;

use command::Desk;
use farop::raster::Watkins;
use farop::render::{self, Canvas};
use farop::screen::file::{READERS, ReadOptions, read};
use serde_json::Value;
use sha2::{Digest, Sha256};

fn manifest(desk: &Desk, folder: &str) -> Value {
    serde_json::from_slice(&desk.read(&format!("{folder}/manifest.json"))).expect("JSON")
}

fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn files(manifest: &Value) -> &[Value] {
    manifest["files"].as_array().expect("files")
}

fn word<'a>(value: &'a Value, name: &str) -> &'a str {
    value[name].as_str().unwrap_or_else(|| panic!("{name} in {value}"))
}

#[test]
fn a_suite_has_files_pictures_readers_a_manifest_and_a_sheet() {
    let desk = Desk::new();
    desk.done("suite gouraud --seed 3 -o one");
    desk.done("suite gouraud --seed 3 -o two");
    let about = manifest(&desk, "one");
    assert_eq!((word(&about, "lab"), word(&about, "probes"), &about["seed"]), ("gouraud", "visible", &3.into()));
    for rule in ["samples", "coverage", "depth", "equal depth", "levels", "pictures"] {
        assert!(word(&about["rules"], rule).len() > 20, "{rule}");
    }
    assert!(files(&about).len() >= 20);
    for file in files(&about) {
        let (text, png) =
            (desk.read(&format!("one/{}", word(file, "file"))), desk.read(&format!("one/{}", word(file, "expected"))));
        assert_eq!(hash(&text), word(file, "sha256"));
        let picture = farop::image::decode(&png).expect("a picture");
        assert_eq!(hash(picture.rgb()), word(file, "picture_sha256"));
        assert_eq!(
            (file["width"].as_u64(), file["height"].as_u64()),
            (Some(picture.width() as u64), Some(picture.height() as u64))
        );
        assert!(!word(file, "aspect").is_empty());
    }
    assert_eq!(word(&files(&about)[0], "aspect"), "first picture");
    for (name, text) in READERS {
        assert_eq!(desk.read(&format!("one/{name}")), text.as_bytes());
    }
    let sheet = String::from_utf8(desk.read("one/sheet.html")).expect("text");
    assert_eq!(sheet.matches("<svg").count(), files(&about).len());
    assert!(sheet.contains("at or right of the left edge") && sheet.contains("default-src 'none'"));
    // The same bytes every time.
    for name in desk.entries().iter().filter(|name| *name == "one") {
        for entry in
            std::fs::read_dir(desk.path(name)).expect("a folder").flatten().filter(|entry| entry.path().is_file())
        {
            let name = entry.file_name().to_string_lossy().into_owned();
            assert!(desk.read(&format!("one/{name}")) == desk.read(&format!("two/{name}")), "{name}");
        }
    }
}

/// Draws all files of a suite, as somebody else would, into `pictures`; the pictures are those that it expects, but for a level between two.
fn draw(desk: &Desk, folder: &str, pictures: &str) {
    std::fs::create_dir_all(desk.path(pictures)).expect("a folder");
    for file in files(&manifest(desk, folder)) {
        let text = String::from_utf8(desk.read(&format!("{folder}/{}", word(file, "file")))).expect("text");
        let read = read(&text, &ReadOptions::default()).expect("a screen file");
        let canvas = Canvas { threads: 1, ..Canvas::of_sheet(&read.sheet) };
        let drawn = render::draw(&read.list, Some(&Watkins), &canvas).0.encode(read.sheet.encoding);
        let path = desk.path(pictures).join(word(file, "file").replace(".scr", ".png"));
        std::fs::write(&path, farop::image::encode_for(&path, &drawn).expect("a PNG")).expect("room for a picture");
        let expected =
            farop::image::decode(&desk.read(&format!("{folder}/{}", word(file, "expected")))).expect("a PNG");
        let off =
            drawn.rgb().iter().zip(expected.rgb()).filter(|(drawn, expected)| drawn.abs_diff(**expected) > 1).count();
        assert_eq!(off, 0, "{file}");
    }
}

#[test]
fn what_is_drawn_from_its_files_is_what_it_expects_and_the_grader_accepts() {
    let desk = Desk::new();
    desk.done("suite supersampling --seed 4 -o visible");
    desk.done("suite supersampling --seed 99 --hidden -o secret");
    let (visible, secret) = (manifest(&desk, "visible"), manifest(&desk, "secret"));
    assert_eq!(word(&secret, "probes"), "hidden");
    assert_eq!(files(&visible).len(), files(&secret).len());
    // No hidden file is handed out, by whatever name.
    let seen: Vec<&str> = files(&visible).iter().map(|file| word(file, "sha256")).collect();
    assert!(files(&secret).iter().all(|file| !seen.contains(&word(file, "sha256"))));
    assert!(files(&secret).iter().all(|file| word(file, "file").starts_with("hidden-")));
    draw(&desk, "visible", "drawn");
    let outcome = desk.run("grade supersampling --pictures drawn --seed 4 --hidden 99");
    assert_eq!(outcome.code, 1, "hidden pictures are missing");
    draw(&desk, "secret", "drawn");
    desk.done("grade supersampling --pictures drawn --seed 4 --hidden 99");
    // Another seed asks for other pictures.
    assert_eq!(desk.run("grade supersampling --pictures drawn --seed 4 --hidden 98").code, 1);
}

#[test]
fn triangles_and_classic_files_are_as_they_say() {
    let desk = Desk::new();
    desk.done("suite coverage --triangles -o triangles");
    let about = manifest(&desk, "triangles");
    assert_eq!(about["triangles"], true);
    for file in files(&about) {
        let text = String::from_utf8(desk.read(&format!("triangles/{}", word(file, "file")))).expect("text");
        assert!(
            text.lines()
                .filter(|line| line.starts_with("polygon "))
                .all(|line| line.starts_with("polygon 0 3") || line.split(' ').nth(2) == Some("3")),
            "{text}"
        );
    }
    draw(&desk, "triangles", "of_triangles");
    desk.done("grade coverage --pictures of_triangles");

    desk.done("suite zbuffer --classic -o classic");
    let about = manifest(&desk, "classic");
    assert_eq!(word(&about, "format"), "classic");
    let first = String::from_utf8(desk.read(&format!("classic/{}", word(&files(&about)[0], "file")))).expect("text");
    assert!(first.starts_with(|letter: char| letter.is_ascii_digit()), "{first}");
    for lab in ["wire", "phong", "supersampling"] {
        let outcome = desk.run(&format!("suite {lab} --classic -o none"));
        assert!(outcome.code == 2 && outcome.stderr.contains("leave --classic out"), "{}", outcome.stderr);
    }
    let outcome = desk.run("suite spd:balls:1 --hidden -o none");
    assert!(outcome.code == 2 && outcome.stderr.contains("name of a lab"), "{}", outcome.stderr);
    assert!(!desk.entries().contains(&"none".to_string()));
}
