//! Hash: the SHA-256 of pictures is committed; no thread count, rasterizer, band height or build profile may change it.
//!
//! Hashed is the linear light of every pixel (three `f32`, little-endian, row by row) before anything is encoded. The z-buffer
//! goes polygon by polygon, Watkins scan line by scan line: two orders of work, one picture. The committed values were written
//! by a release build on x86-64; a debug build, another machine or another operating system must print the same.
//!
//! When a picture is meant to change, the message of the miss has the new value.

use super::{Effort, Report};
use crate::image::Image;
use crate::parse::{ParseOptions, read_nff};
use crate::plan::{Choices, Shading, Transparency};
use crate::raster::{Rasterizer, Watkins, ZBuffer};
use crate::render::render;
use crate::scene::Scene;
use crate::spd::{Curves, find, generate};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;

/// A scene of the standard procedural databases, how it is drawn, and the first 16 digits of its picture's hash.
struct Picture {
    scene: &'static str,
    size: u32,
    choices: fn() -> Choices,
    hash: &'static str,
}

const PICTURES: [Picture; 8] = [
    Picture { scene: "teapot", size: 4, choices: gouraud, hash: "7f92e124e7973783" },
    Picture { scene: "balls", size: 2, choices: phong, hash: "a086e2cae008582d" },
    Picture { scene: "gears", size: 1, choices: flat, hash: "305b8f0744888a1b" },
    Picture { scene: "mount", size: 4, choices: gouraud, hash: "b1ef70ea40df7a9d" },
    Picture { scene: "tetra", size: 4, choices: flat, hash: "3657278c1f445ef4" },
    Picture { scene: "tree", size: 3, choices: phong, hash: "8f71e6179865252f" },
    Picture { scene: "rings", size: 2, choices: supersampled, hash: "2c11fad7340fb51e" },
    Picture { scene: "jacks", size: 1, choices: unrounded, hash: "0bc044c0cd9dac50" },
];

const SIDE: u32 = 96;

const RASTERIZERS: [&dyn Rasterizer; 2] = [&ZBuffer, &Watkins];

fn gouraud() -> Choices {
    Choices { size: Some((SIDE, SIDE)), ..Choices::default() }
}

fn phong() -> Choices {
    Choices { shading: Shading::Phong, transparency: Transparency::Additive, ..gouraud() }
}

fn flat() -> Choices {
    Choices { shading: Shading::Flat, triangles: true, ..gouraud() }
}

fn supersampled() -> Choices {
    Choices { samples: 3, subpixel_bits: 4, ..gouraud() }
}

fn unrounded() -> Choices {
    Choices { depth: crate::plan::DepthFormat::F64, subpixel_bits: 16, ..gouraud() }
}

/// Draws every scene in every way and compares hashes.
pub(super) fn run(effort: &Effort, report: &mut Report) {
    let few: &[u32] = &[1, 2, 3, 8, 64];
    let many: Vec<u32> = (1..=64).collect();
    let threads = if effort.extent == super::Extent::Full { &many } else { few };
    let (mut pictures, mut different, mut lit) = (0, 0, 0);
    for picture in &PICTURES {
        let Some(scene) = read(picture) else {
            report.miss(format!("scene {} cannot be read", picture.scene));
            continue;
        };
        let mut hashes = BTreeSet::new();
        for (&threads, rasterizer) in threads.iter().flat_map(|threads| RASTERIZERS.map(|one| (threads, one))) {
            let choices = Choices { threads: Some(threads), ..(picture.choices)() };
            let image = render(&scene, &choices, Some(rasterizer)).map(|rendered| rendered.image);
            let hash = image.as_ref().map_or_else(|error| error.to_string(), hash);
            lit += u64::from(image.is_ok_and(|image| image.pixels().windows(2).any(|pair| pair[0] != pair[1])));
            pictures += 1;
            different += u64::from(hash != picture.hash);
            hashes.insert(hash);
        }
        let found: Vec<String> = hashes.into_iter().collect();
        let found = found.join(" and ");
        if found != picture.hash {
            report.miss(format!("{} is {found}, not {}", picture.scene, picture.hash));
        }
        report.count(format!("ways of drawing {}: {found}", picture.scene), 2 * threads.len() as u64);
    }
    report.count("pictures", pictures);
    report.some("of them that show something", lit);
    report.none("pictures with another hash", different);
}

fn read(picture: &Picture) -> Option<Scene> {
    let mut text = Vec::new();
    generate(find(picture.scene)?, picture.size, Curves::Kept, &mut text).ok()?;
    Some(read_nff(picture.scene, &text, ParseOptions::default()).ok()?.scene)
}

/// The first 16 digits.
fn hash(image: &Image) -> String {
    let mut sha = Sha256::new();
    for pixel in image.pixels() {
        pixel.to_array().iter().for_each(|channel| sha.update(channel.to_le_bytes()));
    }
    sha.finalize().iter().take(8).map(|byte| format!("{byte:02x}")).collect()
}
