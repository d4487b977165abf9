//! Texts for [`super::fuzz`]: legal ones that use every statement of their format, and ways to spoil them.
//!
//! A text is mangled by bytes changed, dropped, repeated, by its end cut off, by lines exchanged, and by words replaced with numbers
//! that hurt or with other words of the same text. Statements that read further files are left out: nothing here touches the disk.

use super::Random;
use crate::screen::DrawList;
use crate::screen::file::{Attributes, ClassicOptions, Sheet, write_classic, write_v2};

/// NFF, with what farop adds to it in comments.
pub(super) const SCENE: &str = "v\nfrom 0 0 -5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 24 16\nb .1 .2 .3\n\
    l 4 5 -3\n#farop light intensity .5\nl -4 5 -3 1 .5 .25\n\
    f 1 .5 .2 .7 .3 8 0 1\np 4\n-1 -1 0\n1 -1 0\n1 1 .5\n-1 1 .5\n#farop surface phong ambient .4 opacity 1 .5 0 two_sided\n\
    f .2 .9 .4 .8 .1 3 .5 1\npp 3\n-2 0 1 0 0 -1\n0 2 1 0 .6 -.8\n2 0 1 .6 0 -.8\ns 0 0 1 .5\nc\n0 -1 0 .3\n0 1 0 .1\n\
    p 6\n0 0 -1\n2 0 -1\n2 1 -1\n1 .2 -1\n.5 1 -1\n0 1 -1\n";

/// A `.sipp` scene: objects in objects, uses, all shapes, lights and transforms.
pub(super) const TREE: &str = "shader s phong { ambient .3 diffuse .6 specular .2 exponent 9 color 1 .5 .2 } shader t basic { c3 .2 opacity .5 \
    color .2 .4 .8 }\nobject arm {\n cylinder { radius .1 length 2 shader s }\n rotate x 30deg move 0 0 1\n use hand { scale 1 1 -1 } }\n\
    object hand {\n sphere { radius .4 res 6 shader t }\n surface s { v 0 0 0 v 1 0 0 n 0 0 1 v 0 1 0 polygon { 1 2 3 } } }\n\
    world {\n use arm\n clone arm { shader t matrix 1 0 0 0 1 0 0 0 1 3 0 0 }\n copy hand { mirror point 0 0 0 normal 0 1 0 }\n\
    prism { outline 0 0 1 0 0 1 height 2 shader s }\n object { cube { size 1 shader s } rotate point 0 1 0 axis 1 1 0 30deg }\n\
    block { size 1 2 .5 shader t } ellipsoid { radii .6 .2 .3 shader t }\n cone { bottom .5 top .1 length 1 shader s }\n\
    torus { ring .5 tube .2 res 4 2 shader s }\n open_cone { base 0 0 0 .3 apex 0 0 .9 0 shader t two_sided on }\n\
    teapot_lid { shader s res 2 inside }\n bezier { v -1 0 0 v 0 1 0 v 1 0 0 v 1 0 1 curve 1 2 3 4 res 3 shader s } }\n\
    light a spot { from 3 3 9 at 0 0 0 opening 40 edge soft color 1 .9 .8 }\nlight point { at 4 -3 3 }\n\
    light directional { to 1 1 2 color .5 .5 .5 }\ncamera { from 0 0 9 at 0 0 0 up 0 1 0 angle 30 hither .1 yon 99 }\n\
    background .1 .2 .3 image 24 16\n";

/// A Bezier file of SIPP's.
pub(super) const CURVES: &str = "# a cup\nbezier_curves:\nvertices: 5\nvertex_list:\n0.5 0 2.2\n0.2 0 1.9\n0.3 0 1\n1 0 0.3\n0.4 0 0\n\
    curves: 2\ncurve_list:\n1 2 3 4\n2 3 4 5\n";

/// A screen file of some polygons, of either kind; empty if none can be written.
pub(super) fn screen_text(random: &mut Random) -> String {
    let mut list = DrawList::new(12, 10);
    list.push_flat(&[(1.0, 1.0), (9.0, 2.5), (4.0, 8.25)], 1.0, [0.5, 0.25, 1.0]);
    list.push_flat(&[(0.0, 0.0), (12.0, 0.0), (12.0, 10.0), (6.0, 5.0), (0.0, 10.0)], 0.5, [1.0; 3]);
    let mut text = Vec::new();
    let written = if random.once_in(3) {
        write_classic(&list, &ClassicOptions::default(), &mut text).is_ok()
    } else {
        let attributes = Attributes { color: true, ..Attributes::default() };
        write_v2(&list, &Sheet::default(), attributes, &mut text).is_ok()
    };
    if written { String::from_utf8_lossy(&text).into_owned() } else { String::new() }
}

/// Words that hurt.
const WORDS: [&str; 26] = [
    "nan",
    "-inf",
    "1e999",
    "-0",
    "1e-320",
    "1e308",
    "-1e30",
    "0",
    "3",
    "-3",
    "1e9",
    "4294967296",
    "18446744073709551616",
    "1.",
    "+.5",
    "p",
    "v",
    "f",
    "pp",
    "#",
    "#farop",
    "{",
    "}",
    "\"",
    "\0",
    "\u{e9}\u{20ac}",
];

/// `text` after up to three changes; never empty.
pub(super) fn mangled(text: &str, random: &mut Random) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + random.below(3) {
        spoil(&mut bytes, random);
        if bytes.is_empty() {
            bytes.push(b' ');
        }
    }
    bytes
}

/// One change.
fn spoil(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len() as u64) as usize;
    let end = (at + 1 + random.below(12) as usize).min(bytes.len());
    match random.below(12) {
        0 => bytes[at] = random.bits() as u8,
        1 => drop(bytes.drain(at..end)),
        2 => {
            let again = bytes[at..end].to_vec();
            bytes.splice(at..at, again);
        }
        3 if random.once_in(4) => bytes.truncate(at),
        4 => exchange_lines(bytes, random),
        5 | 6 => {
            let other = random.below(bytes.len() as u64) as usize;
            let other = bytes[word_around(bytes, other)].to_vec();
            bytes.splice(word_around(bytes, at), other);
        }
        _ => {
            let word = WORDS[random.below(WORDS.len() as u64) as usize];
            bytes.splice(word_around(bytes, at), word.bytes());
        }
    }
}

/// Where the word at or behind `at` is.
fn word_around(bytes: &[u8], at: usize) -> std::ops::Range<usize> {
    let is_space = |byte: &u8| byte.is_ascii_whitespace();
    let start = bytes[..at].iter().rposition(is_space).map_or(0, |space| space + 1);
    let end = bytes[at..].iter().position(is_space).map_or(bytes.len(), |space| at + space);
    start.min(end)..end
}

fn exchange_lines(bytes: &mut Vec<u8>, random: &mut Random) {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|&byte| byte == b'\n').collect();
    let [a, b] = [0; 2].map(|_| random.below(lines.len() as u64) as usize);
    lines.swap(a, b);
    *bytes = lines.concat();
}
