//! Paints the pictures of `scenes/cutout.sipp` and draws those of docs/textures.md:
//! `cargo run --release --example textures [SCENES [IMAGES]]`.
//!
//! The tree and the grass are drawn by arithmetic alone, so that nobody's photograph is in the project.

use farop::image::encode_for;
use farop::image::textures::{FirstRow, Rgba, Texels, encode_png};
use farop::parse::{ParseOptions, load};
use farop::plan::{AlphaRule, Choices, TextureFilter};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::Scene;
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let scenes = PathBuf::from(arguments.next().unwrap_or_else(|| "scenes".to_string()));
    let images = PathBuf::from(arguments.next().unwrap_or_else(|| "docs/images".to_string()));
    std::fs::write(scenes.join("tree.png"), encode_png(&tree())?)?;
    std::fs::write(scenes.join("grass.png"), encode_png(&grass())?)?;

    let of = |name: &str| -> Result<Scene, Box<dyn Error>> {
        let parsed = load(&scenes.join(name), None, ParseOptions::default()).map_err(|errors| errors.to_string())?;
        Ok(parsed.into_scene())
    };
    let (near, rows) = (of("cutout.sipp")?, of("tree_rows.sipp")?);
    let base = Choices { threads: Some(1), ..Choices::default() };
    let filter = |texture_filter| Choices { texture_filter, ..base.clone() };
    for filter_of in TextureFilter::ALL {
        write(&rows, &filter(*filter_of), &images, filter_of.name())?;
    }
    let alpha = |alpha, samples| Choices { alpha, samples, ..base.clone() };
    for rule in [AlphaRule::Test, AlphaRule::Paper] {
        write(&rows, &alpha(rule, 1), &images, rule.name())?;
    }
    write(&rows, &alpha(AlphaRule::Coverage, 4), &images, "coverage4")?;
    write(&rows, &alpha(AlphaRule::Test, 4), &images, "test4")?;
    for (name, rule) in [("near_repaired", AlphaRule::Test), ("near_paper", AlphaRule::Paper)] {
        write(&near, &Choices { alpha_threshold: Some(0.1), ..alpha(rule, 1) }, &images, name)?;
    }
    Ok(())
}

fn write(scene: &Scene, choices: &Choices, folder: &Path, name: &str) -> Result<(), Box<dyn Error>> {
    let picture = render(scene, choices, Some(&ZBuffer))?.image.encode(choices.encoding);
    let path = folder.join(format!("textures_{name}.png"));
    std::fs::write(&path, encode_for(&path, &picture)?)?;
    println!("{}", path.display());
    Ok(())
}

/// A number from 0 to 1 for a texel: the same every time.
fn noise(x: u32, y: u32) -> f64 {
    let mixed = (x.wrapping_mul(0x9E37_79B1) ^ y.wrapping_mul(0x85EB_CA77)).wrapping_mul(0xC2B2_AE3D);
    f64::from((mixed ^ (mixed >> 15)).wrapping_mul(0x27D4_EB2F) >> 8) / f64::from(1 << 24)
}

/// A spruce of 64 x 64 texels; where nothing is, it is black and alpha is 0, as cut out by hand.
fn tree() -> Texels {
    const SIDE: usize = 64;
    let mut rgba = vec![[0; 4]; SIDE * SIDE];
    let mut put = |x: i32, y: i32, color: [f64; 3]| {
        if (0..SIDE as i32).contains(&x) && (0..SIDE as i32).contains(&y) {
            let [r, g, b] = color.map(|level| (level * (0.8 + 0.4 * noise(x as u32, y as u32))).min(255.0) as u8);
            rgba[y as usize * SIDE + x as usize] = [r, g, b, 255];
        }
    };
    // Twigs one texel wide, from the trunk outward and down, shorter toward the top.
    for (index, start) in (12..62).step_by(4).enumerate() {
        let reach = (62 - start) / 2 + 3;
        for step in 0..reach {
            for side in [-1, 1] {
                let x = 32 + side * step - i32::from(side < 0);
                let y = start - step / 3 + (index as i32 % 2);
                put(x, y, [84.0, 150.0, 60.0]);
                // Needles hang from every second texel.
                if step % 2 == 1 {
                    put(x, y - 1, [60.0, 120.0, 48.0]);
                }
            }
        }
    }
    for y in 0..62 {
        for x in 31 - (62 - y) / 32..33 + (62 - y) / 32 {
            put(x, y, [120.0, 84.0, 50.0]);
        }
    }
    texels(SIDE, rgba)
}

/// A meadow of 32 x 32 texels that goes on without a seam.
fn grass() -> Texels {
    const SIDE: u32 = 32;
    let texel = |index: u32| {
        let (x, y) = (index % SIDE, index / SIDE);
        let light = 0.6 + 0.4 * noise(x, y) + if (x / 16 + y / 16) % 2 == 0 { 0.25 } else { 0.0 };
        let [r, g, b] = [88.0, 128.0, 56.0].map(|level: f64| (level * light).min(255.0) as u8);
        [r, g, b, 255]
    };
    texels(SIDE as usize, (0..SIDE * SIDE).map(texel).collect())
}

fn texels(side: usize, rgba: Vec<Rgba>) -> Texels {
    Texels::new(side as u32, side as u32, rgba, FirstRow::AtV0).expect("a square")
}
