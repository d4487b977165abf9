//! What farop says about bad NFF: every message is a snapshot, next to the text that provokes it.
//!
//! Read the snapshots as a user would: is the place right, does the last line say what to do?

use farop::diagnostic::Diagnostics;
use farop::parse::{Format, ParseOptions, Winding, load, read_nff};
use farop::scene::NormalSource;
use proptest::prelude::*;
use std::io::Write;
use std::path::Path;

const VIEW: &str = "v\nfrom 0 -5 1\nat 0 0 0\nup 0 0 1\nangle 40\nhither 0.1\nresolution 64 64\n";

/// A view whose lines are replaced where one of `fields` starts with the same word.
fn view(fields: &[&str]) -> String {
    let word = |line: &str| line.split(' ').next().map(str::to_string);
    let line_of =
        |line: &str| fields.iter().find(|field| word(field) == word(line)).map_or(line.to_string(), |f| f.to_string());
    VIEW.lines().map(|line| line_of(line) + "\n").collect()
}

fn message(text: &[u8]) -> String {
    match read_nff("scene.nff", text, ParseOptions::default()) {
        Ok(parsed) => format!("(read)\n{}", parsed.notices),
        Err(errors) => errors.to_string(),
    }
}

/// All cases of a group below each other: the text, then what is said about it.
fn transcript(cases: &[impl AsRef<[u8]>]) -> String {
    let mut transcript = String::new();
    for text in cases {
        let shown = String::from_utf8_lossy(text.as_ref()).escape_debug().to_string().replace("\\n", "\n");
        let shown = if shown.len() > 600 { format!("{}[...]\n", &shown[..200]) } else { shown };
        transcript += &format!("======== text\n{}\n-------- says\n{}\n", shown.trim_end(), message(text.as_ref()));
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

#[test]
fn comments_for_farop() {
    let triangle = "f 1 0 0 .8 0 0 0 1\np 3 0 0 0 1 0 0 1 1 0\n";
    assert_messages!(
        "nff_comments_for_farop",
        [
            "#farop lihgt intensity 1\nl 1 2 3\n".to_string() + triangle,
            "#farop light intensity\nl 1 2 3\n".to_string() + triangle,
            "#farop light intensity -1\nl 1 2 3\n".to_string() + triangle,
            "#farop light\nl 1 2 3\n".to_string() + triangle,
            "#farop light intensity 1\n\n# a comment between\n".to_string() + triangle,
            "#farop surface phong ambeint 0.4\n".to_string() + triangle,
            "#farop surface phong phong\n".to_string() + triangle,
            "#farop surface opacity 1 0.5 2\n".to_string() + triangle,
            "#farop surface opacity 1 0.5\n".to_string() + triangle,
            "#farop surface\n".to_string() + triangle,
            "#farop \n".to_string() + triangle,
            "#farop surface phong\n#farop surface two_sided\n".to_string() + triangle,
            triangle.to_string() + "#farop surface phong\n",
            "f 1 0 0 .8 0 0 0 1\np 3 0 0 0\n#farop surface phong\n1 0 0 1 1 0".to_string(),
            "# farop light\n#farop\n#faropage 7\n##farop x\n#FAROP y\n".to_string() + triangle,
            "#farop surface phong two_sided # and why\n".to_string() + triangle,
        ]
    );
}

#[test]
fn numbers() {
    assert_messages!(
        "nff_numbers",
        [
            "s 0 0 nan 1",
            "s 0 0 0 -INF",
            "s 1e999 0 0 1",
            "s 0 0 0 -1e400",
            "s 1d5 0 0 1",
            "s 0x1F 0 0 1",
            "s 0,5 0 0 1",
            "s 0,0,0 1",
            "s 0 0 0 1.5f",
            "s 0 0 . 1",
            "s 0 0 1_000 1",
            "s 0 0 O 1",
            "s 1e-400 0 0 1\ns 0 -1e-500 0 1",
            "s 1. +.5 -0 1e+0",
        ]
    );
}

#[test]
fn polygons() {
    assert_messages!(
        "nff_polygons",
        [
            "p 4\n0 0 0\n1 0 0\n1 1 0\nf 1 0.2 0.2 1 0 100000 0 0",
            "p 1000000000\n0 0 0\n1 0 0\n1 1 0\n",
            "p 3\n0 0 0\n1 0 0\n1 1",
            "p 3\n0 0 0\n1 0\nf 1 1 1 1 0 0 0 0",
            "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0\n",
            "pp 4\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n",
            "p 3\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n",
            "p 3\n0 0 0\n1 0 0\n1 1 0\n0 1\n",
            "pp 3 0 0 0 0 0 1 1 0 0 0 0 1 1 1 0 0 0 1 7",
            "p -3\n0 0 0\n1 0 0\n1 1 0\n",
            "p 3.5\n0 0 0\n1 0 0\n1 1 0\n",
            "p 99999999999999999999\n0 0 0\n",
            "p\n",
            "p",
            "p 3\n0 0 0\n1 x 0\n1 1 0\n",
            "p 0\np 1 0 0 0\np 2 0 0 0 1 1 1\ns 0 0 0 1",
            "p 3 1 1 1 1 1 1 1 1 1\np 4 0 0 0 1 2 3 2 4 6 4 8 12\ns 0 0 0 1",
            "p 4 0 0 0 1 0 0 2 0 0 2 2 0",
            "pp 3 0 0 0 0 0 0 1 0 0 0 0 1 1 1 0 0 0 -0",
        ]
    );
}

#[test]
fn other_statements() {
    assert_messages!(
        "nff_statements",
        [
            "l 1 2",
            "l 1 2 3 4\ns 0 0 0 1",
            "l 1 2 3 4 5\ns 0 0 0 1",
            "l 1 2 3 .4 .5 .6 7",
            "l 1 2 3 1 -1 1",
            "l 1 2 3 1 nan 1",
            "b 0 0 -1",
            "b 0 0",
            "b SkyBlue",
            "b 0 0 2",
            "f red 0.8 0 0 0 1",
            "f 1 0 0 .8 0 0 0",
            "f 1 0 0 .8 0 0 0 1 .2",
            "f 1 0 0 .8 0 0 0 1 wood",
            "f 1 -1 0 .8 0 0 0 1",
            "f 1 1 0 -.8 0 0 0 1",
            "f 1 1 0 .8 -1 0 0 1",
            "f 1 1 0 .8 0 -5 0 1",
            "f 1 1 0 .8 0 0 -.5 1",
            "f 1 1 0 .8 0 0 1.5 1",
            "f 2 1 1 .8 0 0 0 1\nf 1 3 1 .8 0 0 0 1",
            "s 0 0 0",
            "s 0 0 0 1 2",
            "s 0 0 0 0\ns 1 1 1 0\nc 0 0 0 0 1 1 1 0",
            "c 0 0 0 1 0 0 1",
            "c 0 0 0 1 0 0 1 -1",
            "c 0 0 0\n-2\n0 0 1 1",
            "c 0 0 0 1 0 0 0 2\nc 0 0 0 2 0 0 0 2",
        ]
    );
}

#[test]
fn views() {
    let cases: Vec<String> = vec![
        view(&["from 1 2 3", "at 1 2 3"]),
        view(&["up 0 0 0"]),
        view(&["angle 0"]),
        view(&["angle -20"]),
        view(&["angle 180"]),
        view(&["resolution 0 64"]),
        view(&["resolution 64 -64"]),
        view(&["resolution 64.5 64"]),
        view(&["resolution 99999999999 64"]),
        view(&["hither 0"]),
        view(&["hither -1"]),
        view(&["up 0 -5 1"]),
        VIEW.replace("hither", "hihter"),
        VIEW.replace("angle", "fov"),
        VIEW.replace("from", "FROM"),
        VIEW.replace("at 0 0 0\nup 0 0 1", "up 0 0 1\nat 0 0 0"),
        VIEW.replace("at 0 0 0", "at 0 0 0 0"),
        VIEW.replace("resolution 64 64", ""),
        VIEW.replace("resolution 64 64", "resolution 64"),
        VIEW.replace("resolution 64 64", "resolution 64 64 64"),
        VIEW.replace("hither 0.1\n", ""),
        format!("{VIEW}{VIEW}b 0 0 0\n{VIEW}"),
        format!("s 0 0 0 1\n{VIEW}"),
        format!("{VIEW}f 1 1 1 1 0 0 0 0\nl 1 1 1\n\n# a comment\np 3 0 0 0 1 0 0 1 1 0\nl 2 2 2\n"),
    ];
    assert_messages!("nff_views", cases);
}

#[test]
fn what_is_not_nff() {
    let mut cases: Vec<Vec<u8>> = [
        "",
        "  \n# only a comment",
        "x moving { }",
        "fm 1 1 1 1 1 1 1 1 1 5 0 1",
        "am 0.2",
        "la sun 1 2 3",
        "% a comment of AFF",
        "k 1 2 3",
        "tpp 3",
        "tess 5",
        "dod 1 2 3",
        "nff\nversion 2.1\nviewpos 0 0 0",
        "NFF2",
        "polygon 3\n0 0 0\n1 0 0\n1 1 0",
        "P 3\n0 0 0\n1 0 0\n1 1 0",
        "shpere 0 0 0 1",
        "p3 0 0 0 1 0 0 1 1 0",
        "ppp 3",
        "frobnicate",
        "1 2 3",
        "s 0 0 0 1\nthis is prose of some length, without a keyword in it, and a \u{e9}",
    ]
    .iter()
    .map(|text| text.as_bytes().to_vec())
    .collect();
    cases.push(b"s 0 0 0 1 \xE9t\xE9".to_vec());
    cases.push(b"s 0 0 \x1B[31m 1".to_vec());
    cases.push(b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR p 5 s 3".to_vec());
    cases.push(b"s\t0 0\t0 x\t1\r\n# \xE9 \0\r\n".to_vec());
    cases.push(b"\xEF\xBB\xBFs 0 0 0 x".to_vec());
    cases.push(b"\xFF\xFEs\0 \0".to_vec());
    cases.push(format!("s 0 0 0 1\n{}", "0123456789 ".repeat(1_000_000)).into_bytes());
    cases.push(format!("{}x 1 s 0 0 0 1", "s 0 0 0 1 ".repeat(1000)).into_bytes());
    cases.push(format!("s 0 0 0 {}", "x".repeat(1000)).into_bytes());
    cases.push("s 0 0 x 1\n".repeat(30).into_bytes());
    cases.push(format!("{}s 0 0 x 1", "\n# lines left out are counted\n".repeat(500)).into_bytes());
    assert_messages!("nff_foreign", cases);
}

#[test]
fn files() {
    let folder = tempfile::tempdir().expect("a folder");
    let say = |path: &Path| match load(path, None, ParseOptions::default()) {
        Ok(_) => "(read)\n".to_string(),
        Err(errors) => errors.to_string().replace(&*folder.path().display().to_string(), "FOLDER").replace('\\', "/"),
    };
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).expect("writable");
    let gzip = |bytes: &[u8]| {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(bytes).expect("in memory");
        encoder.finish().expect("in memory")
    };
    write("teapot.nff", b"s 0 0 0 1");
    write("packed.nff.gz", &gzip(b"s 0 0 0 1"));
    write("packed_all_the_same.nff", &gzip(b"s 0 0 0 1"));
    write("not_packed.nff.gz", b"s 0 0 0 1");
    write("mistake.nff.gz", &gzip(b"s 0 0 0 x"));
    write("cut.nff.gz", &gzip(b"s 0 0 0 1")[..20]);
    write("bomb.nff.gz", &gzip(&vec![b'0'; 30_000_000]));
    write("scene.obj", b"v 0 0 0");
    write("scene", b"s 0 0 0 1");
    let mut transcript = String::new();
    for name in [
        "teapot.nff",
        "packed.nff.gz",
        "packed_all_the_same.nff",
        "not_packed.nff.gz",
        "mistake.nff.gz",
        "cut.nff.gz",
        "bomb.nff.gz",
        "scene.obj",
        "scene",
        "",
        "teatop.nff",
        "nothing_like_it.nff",
        "no_folder/teapot.nff",
    ] {
        transcript += &format!("======== {name}\n{}\n", say(&folder.path().join(name)));
    }
    transcript += &format!("======== -\n{}", say(Path::new("-")));
    insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("nff_files", transcript);
    });
}

#[test]
fn a_file_of_any_name_is_read_when_its_format_is_given() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.txt");
    std::fs::write(&path, "s 0 0 0 1").expect("writable");
    let parsed = load(&path, Format::by_name("NFF"), ParseOptions::default()).expect("legal");
    assert_eq!(parsed.scene.objects[0].name, "scene.txt");
}

#[test]
fn color_is_only_there_when_asked_for() {
    let errors = read_nff("a.nff", b"s x", ParseOptions::default()).expect_err("a mistake");
    assert!(!errors.render(false).contains('\x1B'));
    assert!(errors.render(true).contains('\x1B'));
}

/// Texts that are nearly NFF.
fn mangled() -> impl Strategy<Value = Vec<u8>> {
    let words = prop::sample::select(vec![
        "v",
        "from",
        "at",
        "up",
        "angle",
        "hither",
        "resolution",
        "b",
        "l",
        "f",
        "c",
        "s",
        "p",
        "pp",
        "0",
        "1",
        "-1",
        "3",
        "0.5",
        "1e999",
        "nan",
        "1e-400",
        "p 3",
        "pp 3",
        "1 2 3",
        "0 0 1",
        "#",
        "\n",
        "1000000000",
        "x",
        "\u{e9}",
        "1d5",
        "v\nfrom 0 -5 1\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 64 64\n",
        "p 3 0 0 0 1 0 0 0 1 0",
        "f 1 1 1 1 0 0 0 0",
        "1e308",
        "5e-324",
        "-",
    ]);
    let text = prop::collection::vec(words, 0..60).prop_map(|words| words.join(" ").into_bytes());
    let holes = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..4);
    (text, holes).prop_map(|(mut text, holes)| {
        if !text.is_empty() {
            holes.iter().for_each(|(at, byte)| *at.get_mut(&mut text) = *byte);
        }
        text
    })
}

fn all_lines_are_there(errors: &Diagnostics, text: &[u8]) {
    let rendered = errors.render(true);
    let lines = text.iter().filter(|&&byte| byte == b'\n').count() + 1;
    for place in rendered.split("m.nff:").skip(1) {
        let line: usize = place.split(':').next().and_then(|line| line.parse().ok()).expect("a line");
        assert!((1..=lines).contains(&line), "{rendered}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn mangled_text_never_panics(text in mangled(), auto in any::<bool>()) {
        let winding = if auto { Winding::Auto } else { Winding::File };
        match read_nff("m.nff", &text, ParseOptions { winding, polygon_normals: NormalSource::Averaged }) {
            Ok(parsed) => {
                all_lines_are_there(&parsed.notices, &text);
                for surface in &parsed.scene.surfaces {
                    let mesh = &surface.mesh;
                    prop_assert!(mesh.outlines.iter().all(|&index| (index as usize) < mesh.vertices.len()));
                    prop_assert!(mesh.normals.is_empty() || mesh.normals.len() == mesh.vertices.len());
                    prop_assert!(mesh.normals.iter().all(|n| n.is_finite()));
                }
            }
            Err(errors) => {
                prop_assert!(errors.has_errors());
                prop_assert!(errors.list.len() <= 21);
                all_lines_are_there(&errors, &text);
            }
        }
    }

    /// The number scanner says what the standard library says, to the last bit.
    #[test]
    fn numbers_are_read_exactly(text in "[-+]?([0-9]{1,25}\\.?[0-9]{0,25}|\\.[0-9]{1,25})([eE][-+]?[0-9]{1,3})?") {
        let expected: f64 = text.parse().expect("the pattern gives numbers");
        match read_nff("m.nff", format!("l {text} 1 1").as_bytes(), ParseOptions::default()) {
            Ok(parsed) => prop_assert_eq!(parsed.scene.lights[0].source.position().x.to_bits(), expected.to_bits()),
            Err(errors) => {
                prop_assert!(expected.is_infinite(), "{}", errors);
                prop_assert!(errors.list[0].message.contains("too large"));
            }
        }
    }
}
