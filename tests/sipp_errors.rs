//! What farop says about bad `.sipp` scenes: every message is a snapshot, next to the text that provokes it.
//!
//! Read the snapshots as a user would: is the place right, does the last line say what to do?

use farop::diagnostic::Diagnostics;
use farop::parse::{ParseOptions, Parsed, load, read_sipp};
use proptest::prelude::*;

/// A scene that uses every construct once; mutations of it are tried.
const EVERYTHING: &str = include_str!("data/everything.sipp");

fn read(text: &[u8]) -> Result<Parsed, Diagnostics> {
    read_sipp("scene.sipp", text, ParseOptions::default())
}

/// All cases of a group below each other: the text, then what is said about it.
fn transcript(cases: &[impl AsRef<[u8]>]) -> String {
    let mut transcript = String::new();
    for text in cases {
        let shown = String::from_utf8_lossy(text.as_ref()).escape_debug().to_string().replace("\\n", "\n");
        let shown = if shown.len() > 600 { format!("{}[...]\n", &shown[..200]) } else { shown.replace("\\\"", "\"") };
        let said = match read(text.as_ref()) {
            Ok(parsed) => format!("(read)\n{}", parsed.notices),
            Err(errors) => errors.to_string(),
        };
        transcript += &format!("======== text\n{}\n-------- says\n{said}\n", shown.trim_end());
    }
    transcript
}

macro_rules! assert_messages {
    ($name:literal, $cases:expr) => {
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
            insta::assert_snapshot!($name, transcript(&$cases));
        });
    };
}

/// Items in a world that draws them, and a shader to draw with.
fn world(items: &str) -> String {
    format!("shader red phong {{}}\nworld {{\n{items}\n}}\n")
}

#[test]
fn shapes() {
    let cases = [
        "sphere { radius -1 shader red }",
        "sphere { radius 0 shader red }",
        "sphere { radius nan shader red }",
        "sphere { radius 1e999 shader red }",
        "sphere { radius 1,5 shader red }",
        "sphere { radius 1 2 shader red }",
        "sphere { radius shader red }",
        "sphere { radius 1 }",
        "sphere { shader red }",
        "sphere { raduis 1 shader red }",
        "sphere { radius 1 radius 2 shader red }",
        "sphere { radius 1 shader rde }",
        "sphere { radius 1 shader red res 0 }",
        "sphere { radius 1 shader red res 2.5 }",
        "sphere { radius 1 shader red res 8 9 }",
        "sphere { radius 1 shader red texture wordl }",
        "sphere { radius 1 shader red two_sided yes }",
        "sphere { radius 1 shader red 7 }",
        "sphere radius 1 shader red",
        "sphere",
        "cone { bottom 0 top 0 length 1 shader red }",
        "cone { bottom -1 top 1 length 0 shader red }",
        "open_cone { base 0 0 0 1 apex 0 0 0 1 shader red }",
        "open_cone { base 0 0 0 1 apex 0 0 1 -1 shader red }",
        "open_cone { base 0 0 0 apex 0 0 1 1 shader red }",
        "prism { outline 0 0 1 0 height 1 shader red }",
        "prism { outline 0 0 1 0 1 1 0 height 1 shader red }",
        "prism { outline 0 0 2 2 2 0 0 2 height 1 shader red }",
        "prism { outline 0 0 1 1 2 2 height 1 shader red }",
        "prism { outline 0 0 0 1 1 1\n1 0 height 1 shader red }",
        "sphear { radius 1 shader red }",
        "ball { radius 1 { deep } } cube { size 1 shader red }",
        "teapot { radius 1 shader red }",
        "bezier { shader red }",
        "bezier { shader red file \"no.bez\" v 0 0 0 }",
        "bezier { shader red v 0 0 0 v 1 0 0 curve 1 2 3 1 }",
        "bezier { shader red v 0 0 0 v 1 0 0 curve 1 2 1 }",
        "bezier { shader red v 0 0 0 curve 1 1 1 1 patch 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 }",
        "bezier { shader red file no.bez }",
        "bezier { shader red file \"no.bez\" }",
    ];
    assert_messages!("sipp_shapes", cases.map(world));
}

#[test]
fn surfaces() {
    let cases = [
        "surface red { v 0 0 0 v 1 0 0 v 0 1 0 polygon { 1 2 } }",
        "surface red { v 0 0 0 v 1 0 0 v 0 1 0 polygon { 0 1 2 } }",
        "surface red { polygon { 1 2 4 } v 0 0 0 v 1 0 0 v 0 1 0 }",
        "surface red { polygon { 1 2 3 } }",
        "surface red { v 0 0 0 polygon { 1 1.5 1 } }",
        "surface red { v 0 0 0 v 1 0 0 v 0 1 0 polygon { 1 2 v 0 1 0 } polygon { 1 2 } }",
        "surface red { v 0 0 0 v 1 0 0 v 0 1 0 polygon { 1 2 x } polygon { 1 2 3 } }",
        "surface red { polygon { v 0 0 0 v 1 0 0 v 2 0 0 } facet { v 0 0 0 v 0 0 0 v 0 0 0 } }",
        "surface red { v 0 0 0 n 0 0 0 v 1 0 0 v 0 1 0 polygon { 1 2 3 } }",
        "surface red { v 0 0 v 1 0 0 }",
        "surface red { v 0 0 0 0 }",
        "surface red { v 0 0 0 n 1 0 }",
        "surface red { winding left }",
        "surface red { two_sided }",
        "surface red { triangle { 1 2 3 } }",
        "surface red { polygn { 1 2 3 } }",
        "surface red 1 2 3",
        "surface { polygon { v 0 0 0 v 1 0 0 v 0 1 0 } }",
        "surface blue { polygon { v 0 0 0 v 1 0 0 v 0 1 0 } }",
        "surface red { polygon { v 0 0 0 v 1 0 0 v 0 1 0 }\nsphere { radius 1 shader red }",
    ];
    assert_messages!("sipp_surfaces", cases.map(world));
}

#[test]
fn transforms() {
    let cases = [
        "rotate x 30",
        "rotate x 30 deg",
        "rotate x thirty",
        "rotate w 30deg",
        "rotate 30deg",
        "rotate x 30deg 5",
        "rotate point 0 0 0 axis 0 0 0 30deg",
        "rotate point 0 0 0 30deg",
        "rotate x 0",
        "scale 2",
        "scale 1e200 1 1 scale 1e200 1 1",
        "move 1 2",
        "move 1 2 3 4",
        "mirror point 0 0 0 normal 0 0 0",
        "mirror 0 0 1",
        "matrix 1 0 0  0 1 0  0 0 1  0 0",
        "matrix 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1",
        "translate 1 2 3",
        "rotat x 30deg",
        "rotate",
    ];
    assert_messages!("sipp_transforms", cases.map(world));
}

#[test]
fn lights_cameras_and_shaders() {
    let cases = [
        "shader a strauss { smoothness .5 }",
        "shader a marble { } shader b planet",
        "shader a phng { }",
        "shader a { color 1 0 0 }",
        "shader a phong { color red }",
        "shader a phong { color 1 0 }",
        "shader a phong { color 1 -1 0 }",
        "shader a phong { color 1 2 0 }",
        "shader a phong { opacity 2 }",
        "shader a phong { opacity .5 .5 }",
        "shader a phong { exponent -1 }",
        "shader a phong { shine 5 }",
        "shader a basic { c3 0 }",
        "shader a basic { c3 1.5 diffuse 1 }",
        "shader a phong {}\nshader a basic {}",
        "light sun directional { to 0 0 0 }",
        "light directional { from 0 0 0 }",
        "light sun { to 1 1 1 }",
        "light lamp area { at 1 1 1 }",
        "light point { color 1 1 1 }",
        "light spot { from 0 0 1 at 0 0 0 opening 200 }",
        "light spot { from 0 0 1 at 0 0 1 opening 20 }",
        "light spot { from 0 0 1 at 0 0 0 opening 20 edge fuzzy }",
        "light spot { from 0 0 1 at 0 0 0 opening 20 edge soft shadow on }",
        "camera { from 1 2 3 at 1 2 3 }",
        "camera { focal .25 angle 30 }",
        "camera { angle 180 }",
        "camera { focal 0 }",
        "camera { up 0 0 0 }",
        "camera { up 0 0 1 hither 0 }",
        "camera { hither 2 yon 1 }",
        "camera { resolution 64 64 }",
        "camera main { }\ncamera { }\nbackground 0 0 0 background 1 1 1 image 4 4 image 5 5 two_sided on two_sided off",
        "background 0 0",
        "background SkyBlue",
        "background -1 0 0",
        "image 0 5",
        "image 512",
        "image 10.5 10",
        "two_sided maybe",
    ];
    assert_messages!("sipp_statements", cases);
}

#[test]
fn names_and_copies() {
    let doubling: String = (0..60).map(|i| format!("object d{i} {{ use d{0} use d{0} }}\n", i + 1)).collect();
    let copies: String = (0..21).map(|i| format!("object d{i} {{ copy d{0} copy d{0} }}\n", i + 1)).collect();
    let cases = [
        "object arm {}\nworld { use amr }".to_string(),
        "object hand {}\nworld { use foot }".to_string(),
        "world { use arm }".to_string(),
        "object arm { use arm }".to_string(),
        "object arm {\n  object hand {\n    use arm\n  }\n}".to_string(),
        "object a { use b }\nobject b { copy c }\nobject c { clone a }\nworld { use a }".to_string(),
        "object a {}\nobject a {}".to_string(),
        "object a { object hand {} }\nobject b { object hand {} }\nworld { use hand }".to_string(),
        "object a { rotate x 30deg }\nworld { use a use a { move 1 0 0 } }".to_string(),
        "object a {}\nworld { use a { shader red } }".to_string(),
        "object a {}\nworld { clone a { shader red } }".to_string(),
        "object a {}\nworld { clone a { sharder red } }".to_string(),
        "object a {}\nworld { use a { sphere { radius 1 } } }".to_string(),
        "object {}".to_string(),
        "object 3d {}".to_string(),
        "object \"\" {}".to_string(),
        "object \"my arm {}\nworld {}".to_string(),
        "object \"number #1\" {}".to_string(),
        "world { use 5 }".to_string(),
        format!("{doubling}object d60 {{}}\nworld {{ use d0 }}"),
        format!("{copies}object d21 {{}}\nworld {{ use d0 }}"),
        "world { import gears.nff }".to_string(),
        "world { import \"no.nff\" }".to_string(),
        "world {\n import \"no/no.nff\" { turn 5 } }".to_string(),
        "world { import \"other.sipp\" }".to_string(),
        "world { import \"spd:gaers\" }".to_string(),
        "world { import \"spd:gears:x\" }".to_string(),
        "world { import \"spd:balls:20\" }".to_string(),
        "world { import \"spd:tetra:1\" { scale 2 2 2 } }".to_string(),
        String::new(),
        "world {}".to_string(),
        "object a {}".to_string(),
    ];
    assert_messages!("sipp_names", cases);
}

#[test]
fn structure() {
    let mut cases: Vec<Vec<u8>> = [
        "# only a comment",
        "world {",
        "shader red phong {}\nworld {\n  object arm {\n    sphere { radius 1",
        "world { object a {",
        "shader red phong { color 1 0",
        "shader red",
        "camera {}\n}\nworld {}",
        "world {} } } }",
        "object a {\n  move 1 0 0\nworld {\n  use a\n}",
        "shader red phong {\n  color 1 0 0\nworld { sphere { radius 1 shader red } }",
        "sphere { radius 1 }",
        "wrold { }",
        "polygon { v 0 0 0 }",
        "{ }",
        "\"text\"",
        "12 13",
        "v\nfrom 0 0 5",
        "SippObjectCreate",
        "set a [SippShaderPhong .1 .2 .3 4 {1 0 0}]",
        "shadows on size 512",
        "world { light point { at 0 0 0 } }",
        "world { camera }",
        "World {}",
        "object a ( move 1 1 1 )",
    ]
    .iter()
    .map(|text| text.as_bytes().to_vec())
    .collect();
    cases.push(b"world { \xE9t\xE9 }".to_vec());
    cases.push(b"world { \x1B[31m }".to_vec());
    cases.push(b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR".to_vec());
    cases.push(b"camera { from 1e-400 1 1 }".to_vec());
    cases.push("sphere\n".repeat(30).into_bytes());
    cases.push(world(&"sphere { radius x }\n".repeat(30)).into_bytes());
    assert_messages!("sipp_structure", cases);
}

/// Mistakes of imported files are told at the import, with the place in the other file.
#[test]
fn imports() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("writable");
    write("bad.nff", "b 0 0 0\ns 0 0 0 x\ns y 0 0 1\n");
    write("good.nff", "b 0 0 1\nl 1 1 1\ns 0 0 0 1\ns 0 0 0 0\n");
    write("bad.bez", "bezier_curves: vertices: 1 vertex_list: 0 0");
    write("a.sipp", "world {\n import \"bad.nff\"\n}");
    write("b.sipp", "world {\n import \"good.nff\" { move 1 0 0 }\n import \"good.nff\"\n}");
    write("c.sipp", "shader red phong {}\nworld { bezier { shader red file \"bad.bez\" } }");
    write("d.sipp", "world { import \"missing.nff\" }");
    write("e.sipp", "world { import \"b.sipp\" import \".\" }");
    let mut transcript = String::new();
    for name in ["a.sipp", "b.sipp", "c.sipp", "d.sipp", "e.sipp"] {
        let said = match load(&folder.path().join(name), None, ParseOptions::default()) {
            Ok(parsed) => format!("(read)\n{}", parsed.notices),
            Err(errors) => errors.to_string(),
        };
        let said = said.replace(&*folder.path().display().to_string(), "FOLDER").replace('\\', "/");
        transcript += &format!("======== {name}\n{said}\n");
    }
    insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("sipp_imports", transcript);
    });
}

/// Every beginning of a scene that stops inside a block says so.
#[test]
fn cut_files_name_the_block() {
    assert!(read(EVERYTHING.as_bytes()).is_ok(), "{}", read(EVERYTHING.as_bytes()).expect_err("a mistake"));
    let mut depth = 0usize;
    let mut comment = false;
    for (at, byte) in EVERYTHING.bytes().enumerate() {
        comment = (comment || byte == b'#') && byte != b'\n';
        match byte {
            b'{' if !comment => depth += 1,
            b'}' if !comment => depth -= 1,
            _ => {}
        }
        if depth > 0 && byte == b'\n' {
            let errors = read(&EVERYTHING.as_bytes()[..=at]).expect_err("cut");
            let last = &errors.list.last().expect("one").message;
            assert!(last.starts_with("the file ends inside"), "{errors}");
            assert_eq!(errors.list.len(), 1, "nothing else is wrong: {errors}");
        }
    }
}

/// Words of the language, numbers and rubbish.
fn soup() -> impl Strategy<Value = Vec<u8>> {
    let mut words: Vec<String> = EVERYTHING.split_whitespace().map(str::to_string).collect();
    words.sort();
    words.dedup();
    let rubbish = ["{", "}", "{", "}", "\"", "#", "\n", ";", "1e999", "nan", "-1", "0", "1e-400", "\u{e9}", "\0", "x{"];
    words.extend(rubbish.map(str::to_string));
    let text = prop::collection::vec(prop::sample::select(words), 0..80);
    text.prop_map(|words| words.join(" ").into_bytes())
}

/// The scene that uses everything, with words lost, doubled and swapped, and bytes overwritten.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let words: Vec<String> = EVERYTHING
        .lines()
        .flat_map(|line| line.split('#').next().unwrap_or_default().split_whitespace().map(str::to_string))
        .collect();
    let change = (any::<prop::sample::Index>(), any::<prop::sample::Index>(), 0..3u8);
    let bytes = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..3);
    (prop::collection::vec(change, 0..6), bytes).prop_map(move |(changes, bytes)| {
        let mut words = words.clone();
        for (at, other, kind) in changes {
            let (at, other) = (at.index(words.len()), other.index(words.len()));
            match kind {
                0 => _ = words.remove(at),
                1 => words.insert(at, words[other].clone()),
                _ => words.swap(at, other),
            }
        }
        let mut text = words.join("\n").into_bytes();
        bytes.iter().for_each(|(at, byte)| *at.get_mut(&mut text) = *byte);
        text
    })
}

fn is_sound(text: &[u8]) {
    let lines = text.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let all_lines_are_there = |said: &Diagnostics| {
        for diagnostic in &said.list {
            let Some(place) = said.place(diagnostic) else { continue };
            let line: usize = place.split(':').nth(1).and_then(|line| line.parse().ok()).expect("a line");
            assert!((1..=lines).contains(&line), "{place}");
        }
        assert!(said.list.is_empty() || !said.render(true).is_empty());
    };
    match read(text) {
        Ok(parsed) => {
            all_lines_are_there(&parsed.notices);
            let scene = parsed.scene;
            scene
                .walk(|placed| assert!(placed.object.surfaces.iter().all(|id| (id.0 as usize) < scene.surfaces.len())))
                .expect("within the budget");
            for mesh in scene.surfaces.iter().map(|surface| &surface.mesh) {
                assert!(mesh.outlines.iter().all(|&index| (index as usize) < mesh.vertices.len()));
                assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.vertices.len());
                assert!(mesh.texture.is_empty() || mesh.texture.len() == mesh.vertices.len());
            }
        }
        Err(errors) => {
            assert!(errors.has_errors() && errors.list.len() <= 21);
            all_lines_are_there(&errors);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn word_soup_never_panics(text in soup()) {
        is_sound(&text);
    }

    #[test]
    fn mutated_scenes_never_panic(text in mutated()) {
        is_sound(&text);
    }
}
