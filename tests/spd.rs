//! The procedural scenes against the original programs: hashes of whole files, counts, and entity by entity.
//!
//! The tokenizer here is a dozen lines of its own, so that a fault of farop's parser cannot hide one of the generators.
//! Where the published files lie beside the checkout (`../shared/data/spd`), they are compared number by number.

use farop::spd::{Counts, Curves, SCENES, SpdScene, counts, find, generate};
use sha2::{Digest, Sha256};
use std::io::Read;
use std::path::{Path, PathBuf};

fn scene(name: &str) -> &'static SpdScene {
    find(name).expect("one of the thirteen")
}

fn text(name: &str, size: u32, curves: Curves) -> String {
    let mut bytes = Vec::new();
    generate(scene(name), size, curves, &mut bytes).expect("memory takes it");
    String::from_utf8(bytes).expect("ASCII")
}

/// The first 12 hexadecimal digits.
fn hash(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().take(6).map(|byte| format!("{byte:02x}")).collect()
}

/// Name, size, resolution (0 keeps curves), lines, last line, hash: measured on the output of SPD 3.14.
///
/// `sample` is not among them: 18 of its lines differ from the original in noise around zero (`-1.66533e-16` for
/// `-2.22045e-16`), which the comparison by entities below allows.
const PUBLISHED: [(&str, u32, u32, usize, &str, &str); 30] = [
    ("tetra", 3, 0, 266, "1 1 1", "357b7fe911ca"),
    ("tetra", 6, 0, 16394, "1 1 1", "6bb2da0228e0"),
    ("sombrero", 1, 0, 7698, "4 -3.00164 4", "d52225d46987"),
    ("sombrero", 2, 0, 31762, "4 -3.00414 4", "c77e81fb5bd5"),
    ("mount", 4, 0, 2063, "-1 0.875 0.0897349", "9e9b0b7da644"),
    ("mount", 6, 0, 32783, "-1 0.96875 0.0514796", "c48f8bdbcc7f"),
    ("balls", 2, 0, 109, "s 0.471405 -0.471405 -0.222222 0.0555556", "889986d6c46a"),
    ("balls", 4, 0, 7399, "s 0.436486 -0.541242 -0.222222 0.00617284", "ca9559197291"),
    ("balls", 1, 3, 4338, "0.513165 -0.513165 0.155852 0.250563 -0.250563 0.935113", "34e507622ecc"),
    ("gears", 1, 0, 1030, "0.898767 0.0471024 0.9", "f76119e960f4"),
    ("gears", 4, 0, 64723, "0.971751 0.772794 0.15", "888b3b7f3573"),
    ("rings", 2, 0, 347, "s 1 4.7368 0.208049 0.07412", "dcfdd996f42b"),
    ("rings", 7, 0, 9257, "s 6 17.8024 5.20805 0.07412", "e0f31dca3489"),
    ("tree", 4, 0, 84, "s -0.282123 0.440267 2.64633 0.0202519", "b2aee0130af1"),
    ("tree", 11, 0, 8212, "s -0.306913 0.537715 3.13626 0.00122741", "57ae111e5e70"),
    ("lattice", 2, 0, 176, "s 1 1 1 0.125", "9a35f8daa2f1"),
    ("lattice", 12, 0, 16576, "s 1 1 1 0.0208333", "768ec7e5327a"),
    ("shells", 1, 0, 371, "s -1.24194e-14 16.902 -33.804 16.902", "465e7fbcaf60"),
    ("shells", 5, 0, 5771, "s -1.24194e-14 16.902 -33.804 16.902", "587328171896"),
    ("jacks", 1, 0, 19, "s 0.256515 -0.352385 -0.610348 0.15", "070a6ba5f7f9"),
    ("jacks", 3, 0, 667, "s 0.512383 1.04207 0.30491 0.0375", "082caed085ab"),
    ("teapot", 2, 0, 993, "0.911906 -0.911906 0.046875 0.0996006 -0.0996006 -0.99003", "4725dda5415f"),
    ("teapot", 6, 0, 9217, "1.4355 -0.399515 0.112847 0.743044 -0.200299 -0.638566", "bf83a1dda1d4"),
    ("nurbtst", 1, 0, 6010, "0.624761 1.56426e-06 -2.91788 -0.787596 0.415839 0.45472", "8efe5c315c55"),
    // The rest from the list of published files; their last lines are checked with the files themselves.
    ("balls", 2, 3, 0, "", "e7c8eff988aa"),
    ("lattice", 2, 3, 0, "", "cccc15684eae"),
    ("teapot", 12, 0, 0, "", "5b193fa580d6"),
    ("jacks", 1, 3, 0, "", "0c64d7ae47ca"),
    ("gears", 4, 3, 64723, "0.971751 0.772794 0.15", "888b3b7f3573"),
    ("nurbtst", 9, 7, 6010, "0.624761 1.56426e-06 -2.91788 -0.787596 0.415839 0.45472", "8efe5c315c55"),
];

#[test]
fn texts_equal_the_published_ones() {
    let mut differing = Vec::new();
    for (name, size, resolution, lines, last, expected) in PUBLISHED {
        let curves = if resolution == 0 { Curves::Kept } else { Curves::Patches(resolution) };
        let text = text(name, size, curves);
        if lines > 0 {
            assert_eq!(text.lines().count(), lines, "{name} {size}");
            assert_eq!(text.lines().next_back(), Some(last), "{name} {size}");
        }
        if hash(&text) != expected {
            differing.push(format!("{name} {size} {curves:?}"));
        }
    }
    assert!(differing.is_empty(), "not byte-equal: {differing:#?}");
}

#[test]
fn counts_agree_with_what_is_written() {
    for scene in &SCENES {
        for size in 1..=3 {
            for curves in [Curves::Kept, Curves::Patches(1), Curves::Patches(3)] {
                let expected = counts(scene, size, curves);
                // Debug builds are not for millions of triangles.
                if expected.total() < 200_000 {
                    let counted = count(&text(scene.name, size, curves));
                    assert_eq!(counted, expected, "{} {size} {curves:?}", scene.name);
                }
            }
        }
    }
}

/// Counts entities by keyword and checks that every one has as many lines as it declares.
fn count(text: &str) -> Counts {
    let mut counts = Counts::default();
    for entity in entities(text) {
        let vertices = entity.numbers.first().map_or(0, |&declared| declared as usize);
        let (counter, expected) = match entity.keyword {
            "p" => (&mut counts.p, 1 + 3 * vertices),
            "pp" => (&mut counts.pp, 1 + 6 * vertices),
            "s" => (&mut counts.s, 4),
            "c" => (&mut counts.c, 8),
            "l" => (&mut counts.l, 3),
            "f" => (&mut counts.f, 8),
            _ => continue,
        };
        *counter += 1;
        assert_eq!(entity.numbers.len(), expected, "{}", entity.keyword);
    }
    counts
}

/// A keyword and all numbers up to the next keyword.
#[derive(Debug)]
struct Entity<'a> {
    keyword: &'a str,
    numbers: Vec<f64>,
}

fn entities(text: &str) -> Vec<Entity<'_>> {
    let mut entities: Vec<Entity> = Vec::new();
    for token in text.split_ascii_whitespace() {
        match token.parse() {
            Ok(number) => entities.last_mut().expect("a file begins with a keyword").numbers.push(number),
            Err(_) => entities.push(Entity { keyword: token, numbers: Vec::new() }),
        }
    }
    entities
}

/// One step of the sixth digit; numbers around zero are noise whatever their digits.
fn agree(a: f64, b: f64) -> bool {
    (a.abs() < 1e-12 && b.abs() < 1e-12) || (a - b).abs() <= 1e-5 * a.abs().max(b.abs())
}

#[test]
fn entities_agree_with_the_published_files() {
    let Some(folder) = published_files() else {
        println!("skipped: no ../shared/data/spd beside the checkout");
        return;
    };
    for (file, name, size, curves) in [
        ("balls-s2-c.nff", "balls", 2, Curves::Kept),
        ("balls-s2-t.nff.gz", "balls", 2, Curves::Patches(3)),
        ("gears-s1.nff", "gears", 1, Curves::Kept),
        ("gears-s4.nff.gz", "gears", 4, Curves::Kept),
        ("jacks-c.nff", "jacks", 1, Curves::Kept),
        ("jacks-t.nff", "jacks", 1, Curves::Patches(3)),
        ("lattice-s2-c.nff", "lattice", 2, Curves::Kept),
        ("lattice-s2-t.nff.gz", "lattice", 2, Curves::Patches(3)),
        ("mount-s4-c.nff", "mount", 4, Curves::Kept),
        ("mount-s6-c.nff.gz", "mount", 6, Curves::Kept),
        ("nurbtst-def.nff", "nurbtst", 1, Curves::Kept),
        ("rings-s2-c.nff", "rings", 2, Curves::Kept),
        ("sample-c.nff", "sample", 1, Curves::Kept),
        ("shells-s1-c.nff", "shells", 1, Curves::Kept),
        ("sombrero-def.nff", "sombrero", 1, Curves::Kept),
        ("teapot-s12.nff.gz", "teapot", 12, Curves::Kept),
        ("teapot-s6.nff.gz", "teapot", 6, Curves::Kept),
        ("tetra-s3.nff", "tetra", 3, Curves::Kept),
        ("tetra-s6.nff", "tetra", 6, Curves::Kept),
        ("tree-s4-c.nff", "tree", 4, Curves::Kept),
    ] {
        let path = folder.join(file);
        if path.exists() {
            compare(file, &text(name, size, curves), &read(&path));
        } else {
            println!("skipped: {file} is not there");
        }
    }
}

fn compare(file: &str, ours: &str, published: &str) {
    let (ours_entities, published_entities) = (entities(ours), entities(published));
    assert_eq!(ours_entities.len(), published_entities.len(), "{file}");
    for (place, (a, b)) in ours_entities.iter().zip(&published_entities).enumerate() {
        let same = a.keyword == b.keyword
            && a.numbers.len() == b.numbers.len()
            && a.numbers.iter().zip(&b.numbers).all(|(&a, &b)| agree(a, b));
        assert!(same, "{file}, entity {place}:\n{a:?}\n{b:?}");
    }
    let differing = ours.lines().zip(published.lines()).filter(|(a, b)| a != b).count();
    println!("{file}: {differing} lines differ in text, all within tolerance");
}

/// The folder of published files: a copy of `shared` lies beside the checkout, here and in CI.
fn published_files() -> Option<PathBuf> {
    let checkout = Path::new(env!("CARGO_MANIFEST_DIR"));
    // A second working tree may stand one level deeper than the first.
    ["../shared/data/spd", "../../shared/data/spd"].map(|place| checkout.join(place)).into_iter().find(|p| p.is_dir())
}

fn read(path: &Path) -> String {
    let bytes = std::fs::read(path).expect("it exists");
    if path.extension().is_none_or(|extension| extension != "gz") {
        return String::from_utf8(bytes).expect("ASCII");
    }
    let mut text = String::new();
    flate2::read::GzDecoder::new(&bytes[..]).read_to_string(&mut text).expect("a whole gzip file of ASCII");
    text
}
