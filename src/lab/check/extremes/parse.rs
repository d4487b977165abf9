//! Items 1 to 18: texts.

use super::tools::{TRIANGLE, VIEW, ensure, noticed, picture, read, refused};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::parse::{ParseOptions, load};
use std::io::Write;

pub(super) const ITEMS: &[Item] = &[
    (1, "nan: refused with its line", Run(|_| refused("s 0 0 nan 1", &["x.nff:1:7"]))),
    (2, "inf: refused with its line", Run(|_| refused("s 0 0 0 -INF", &["x.nff:1:9"]))),
    (3, "1e999: refused with its line", Run(|_| refused("s 1e999 0 0 1", &["x.nff:1:3", "too large"]))),
    (4, "1e-400: 0 and a warning", Run(too_small)),
    (5, "-0: the picture of 0", Run(negative_zero)),
    (6, "1d5: refused with its line", Run(|_| refused("\ns 1d5 0 0 1", &["x.nff:2:3"]))),
    (7, "`1.` and `+.5`: numbers", Run(|_| read("s 1. +.5 -0 1e+0").map(|_| ()))),
    (8, "a file of 0 bytes: refused, no view", Run(nothing)),
    (9, "cut off within a vertex: refused", Run(|_| refused("p 3\n0 0 0\n1 0 0\n1 1", &["x.nff:1:1", "2 follow"]))),
    (10, "p 0: skipped and counted", Run(|_| degenerate("p 0\n"))),
    (11, "p 1: skipped and counted", Run(|_| degenerate("p 1 0 0 0\n"))),
    (12, "p 2: skipped and counted", Run(|_| degenerate("p 2 0 0 0 1 1 1\n"))),
    (13, "p -3, or 1e9 declared with 3 given: refused before memory is asked for", Run(counts)),
    (14, "CRLF, NUL, byte order mark, Latin-1: read or refused", Run(foreign)),
    (15, "a gigabyte of comments: constant memory", Run(comments)),
    (16, "objects before v: refused", Run(|_| refused(format!("s 0 0 0 1\n{VIEW}"), &["x.nff:2:1", "view"]))),
    (17, "a second v: the last counts, with a warning", Run(second_view)),
    (18, "a line of 1e8 characters: refused at the limit", Run(long_line)),
];

fn too_small(_: &Effort) -> Outcome {
    let parsed = noticed("l 1e-400 1 1\ns 0 0 0 1", "too small")?;
    ensure(parsed.scene.lights[0].source.position().x == 0.0, "it is not 0")
}

fn negative_zero(_: &Effort) -> Outcome {
    let text = format!("{VIEW}{TRIANGLE}");
    let negative = text.replace(" 0\n", " -0\n");
    ensure(negative != text && picture(&text)?.image == picture(&negative)?.image, "another picture")
}

fn nothing(_: &Effort) -> Outcome {
    match picture("") {
        Ok(_) => Err("it was drawn".to_string()),
        Err(_) => Ok(()),
    }
}

fn degenerate(statement: &str) -> Outcome {
    let parsed = noticed(format!("{VIEW}{statement}{TRIANGLE}").replace("l 3 4 6\n", ""), "dropped")?;
    let polygons: usize = parsed.scene.surfaces.iter().map(|surface| surface.mesh.polygons.len()).sum();
    ensure(polygons == 1, format!("{polygons} polygons"))
}

fn counts(_: &Effort) -> Outcome {
    refused("p -3\n0 0 0\n1 0 0\n1 1 0\n", &["x.nff:1:"])?;
    refused("p 1000000000\n0 0 0\n1 0 0\n1 1 0\n", &["x.nff:1:1", "only 3 follow"])
}

fn foreign(_: &Effort) -> Outcome {
    let text = format!("{VIEW}{TRIANGLE}");
    let crlf = text.replace('\n', "\r\n");
    let marked = format!("\u{feff}{text}");
    let expected = picture(&text)?.image;
    ensure(picture(crlf)?.image == expected && picture(marked)?.image == expected, "line ends change the picture")?;
    let comment = [b"# caf\xE9 \0\n".as_slice(), text.as_bytes()].concat();
    ensure(picture(comment)?.image == expected, "a comment changes the picture")?;
    refused(b"s 0 0 0 1 \xE9\n", &["x.nff:1:"])?;
    refused(b"s 0 0 0\0 1\n", &["x.nff:1:"])?;
    refused(b"\xFF\xFEs\0 \0", &["UTF-16"])
}

/// Packed, so that the disk need not hold them; read through the same door as any file.
fn comments(effort: &Effort) -> Outcome {
    let megabytes = effort.count(32, 1024);
    let file = tempfile::Builder::new().suffix(".nff.gz").tempfile().map_err(|error| error.to_string())?;
    let line = [b"# ".as_slice(), &[b'c'; 61], b"\n"].concat();
    let megabyte = line.repeat((1 << 20) / line.len());
    let mut packer = flate2::write::GzEncoder::new(&file, flate2::Compression::fast());
    let mut write = |bytes: &[u8]| packer.write_all(bytes).map_err(|error| error.to_string());
    for _ in 0..megabytes {
        write(&megabyte)?;
    }
    write(b"s 0 0 0 1\n")?;
    packer.finish().map_err(|error| error.to_string())?;
    let before = peak_kilobytes();
    let parsed = load(file.path(), None, ParseOptions::default()).map_err(|errors| errors.to_string())?;
    ensure(parsed.scene.surfaces.len() == 1, "the sphere is not there")?;
    let grown = peak_kilobytes().saturating_sub(before);
    ensure(grown < 16 << 10, format!("memory grew by {grown} kilobytes"))
}

/// Most memory this process ever had; 0 where the system does not tell.
fn peak_kilobytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap_or_default();
    line.split_whitespace().next().and_then(|number| number.parse().ok()).unwrap_or(0)
}

fn second_view(_: &Effort) -> Outcome {
    let parsed = noticed(format!("{VIEW}{}", VIEW.replace("32 32", "8 4")), "replaced by a later one")?;
    ensure(parsed.scene.camera.is_some_and(|camera| camera.resolution == (8, 4)), "the first counts")
}

fn long_line(effort: &Effort) -> Outcome {
    let line = "7".repeat(effort.count(12_000_000, 100_000_000).max(11_000_000) as usize);
    refused(format!("# one\np {line}"), &["x.nff:2:1", "10000000"])
}
