//! Streams of halvings through the command line: written, cut anywhere, measured; damaged ones refused.

#[path = "support/command.rs"]
mod command;

use command::Desk;

/// Rough land as an ASCII grid; with `voids`, a hole in it.
fn asc(voids: bool) -> String {
    let mut text = "ncols 60\nnrows 45\nxllcorner 1000\nyllcorner 2000\ncellsize 30\nNODATA_value -9999\n".to_string();
    for row in 0..45_u32 {
        for column in 0..60_u32 {
            let hills = f64::from((column * 7 + row * 5) % 40 * (row % 17)) / 2.0;
            let is_void = voids && (10..20).contains(&row) && (10..20).contains(&column);
            text += &if is_void { "-9999 ".to_string() } else { format!("{hills} ") };
        }
        text += "\n";
    }
    text
}

/// The number before `unit` behind `words`.
fn number(text: &str, words: &str) -> f64 {
    let (_, behind) = text.split_once(words).unwrap_or_else(|| panic!("no `{words}` in\n{text}"));
    behind.split_whitespace().next().expect("a word").parse().expect("a number")
}

#[test]
fn a_stream_may_end_anywhere() {
    let desk = Desk::new();
    desk.write("land.asc", asc(false));
    let told = String::from_utf8(desk.done("terrain land.asc --progressive -o land.frel").stdout).expect("text");
    assert!(told.contains("rounded to 0.015625 m"), "{told}");
    let bytes = std::fs::read(desk.path("land.frel")).expect("it was written");
    let mut last = f64::INFINITY;
    for percent in [5, 10, 50, 99, 100] {
        desk.write("cut.frel", &bytes[..bytes.len() * percent / 100]);
        let outcome = desk.done("terrain cut.frel --against land.asc -o cut.ppm --size 40x32");
        let told = String::from_utf8(outcome.stdout).expect("text");
        let (promised, measured) = (number(&told, "no sample farther than "), number(&told, "error      largest "));
        // Heights were rounded by up to half a step before; both numbers are printed with two digits.
        assert!(measured <= promised + 0.0079 + 0.011 && promised <= last, "{percent} %\n{told}");
        assert_eq!(told.contains(", whole:"), percent == 100, "{told}");
        last = promised;
    }
    assert_eq!(last, 0.0);
    let whole = desk.made("terrain land.frel --size 40x32", "whole.ppm");
    let straight = desk.made("terrain land.asc --error 0 --size 40x32", "straight.ppm");
    let differing = whole.iter().zip(&straight).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    assert!(differing * 100 < whole.len(), "{differing} of {} bytes differ", whole.len());
    assert!(String::from_utf8(desk.done("terrain cut.frel").stdout).expect("text").contains("not measured"));
    desk.done("terrain cut.frel -o cut.nff");
    desk.done("render cut.nff --size 16 -o cut.png");
}

#[test]
fn what_is_no_stream_is_told() {
    let desk = Desk::new();
    desk.write("land.asc", asc(false));
    desk.write("holes.asc", asc(true));
    desk.done("terrain land.asc --progressive -o land.frel");
    let bytes = std::fs::read(desk.path("land.frel")).expect("it was written");
    desk.write("head.frel", &bytes[..60]);
    desk.write("other.frel", b"P6 1 1 255\n...");
    let mut damaged = bytes.clone();
    damaged[bytes.len() / 2] ^= 1;
    desk.write("damaged.frel", damaged);
    let before = desk.entries();
    for (arguments, expected) in [
        ("terrain head.frel", "byte 60: the file ends within its head"),
        ("terrain other.frel", "begins with FRELIEF1"),
        ("terrain damaged.frel -o x.png", "bytes are a relief of their own"),
        ("terrain missing.frel", "missing.frel"),
        ("terrain land.frel land.asc", "name it alone"),
        ("terrain land.asc --against land.asc", "--against measures a .frel"),
        ("terrain land.asc --progressive", "--output"),
        ("terrain land.asc --progressive -o land.nff", "ends in .frel"),
        ("terrain holes.asc --fill 0 --progressive -o holes.frel", "100 samples are voids"),
    ] {
        let outcome = desk.run(arguments);
        assert_eq!(outcome.code, 2, "{arguments}");
        assert!(outcome.stderr.contains(expected), "{arguments}: {}", outcome.stderr);
        assert_eq!(desk.entries(), before, "{arguments}");
    }
    desk.write("small.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n1 2\n3 4\n");
    let outcome = desk.run("terrain land.frel --against small.asc");
    assert!(outcome.code == 2 && outcome.stderr.contains("was not made of this grid"), "{}", outcome.stderr);
}
