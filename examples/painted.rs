//! All pictures that the program paints, on two sheets: trees as wide as they are painted for, a form a column; grounds, each
//! laid two by two.
//!
//! `cargo run --example painted -- FOLDER` writes `trees.png` and `grounds.png` there.

use farop::forest::area::Form;
use farop::forest::paint::{GROUNDS, SIDE, VARIANTS, aspect, named, tree};
use farop::image::textures::Texels;
use farop::image::{Picture, encode_for};

/// A sheet of pixels, white at first.
struct Sheet {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
}

impl Sheet {
    fn new(width: usize, height: usize) -> Sheet {
        Sheet { width, height, rgb: [200, 214, 230].repeat(width * height) }
    }

    /// Pastes a picture, `width` pixels wide and `height` high.
    fn paste(&mut self, texels: &Texels, at: [usize; 2], size: [usize; 2]) {
        for y in 0..size[1] {
            for x in 0..size[0] {
                let texel = texels.at((x * SIDE / size[0]) as u32, (SIDE - 1 - y * SIDE / size[1]) as u32);
                let index = 3 * ((at[1] + y) * self.width + at[0] + x);
                for channel in 0..3 {
                    let (over, under) = (u32::from(texel[channel]), u32::from(self.rgb[index + channel]));
                    let alpha = u32::from(texel[3]);
                    self.rgb[index + channel] = ((over * alpha + under * (255 - alpha)) / 255) as u8;
                }
            }
        }
    }

    fn save(self, path: &std::path::Path) -> Result<(), Box<dyn std::error::Error>> {
        let picture = Picture::from_rgb(self.width, self.height, self.rgb)?;
        Ok(std::fs::write(path, encode_for(path, &picture)?)?)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::path::PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| ".".to_string()));
    let mut trees = Sheet::new(5 * 150, VARIANTS as usize * 170);
    for (column, (_, form)) in Form::ALL.into_iter().enumerate() {
        let height = if form == Form::Shrub { 110 } else { 164 };
        let width = (height as f64 * aspect(form)) as usize;
        for variant in 0..VARIANTS {
            let at = [column * 150 + 75 - width / 2, variant as usize * 170 + 168 - height];
            trees.paste(&tree(form, variant), at, [width, height]);
        }
    }
    trees.save(&folder.join("trees.png"))?;
    let mut grounds = Sheet::new(5 * 150 - 6, 2 * 150 - 6);
    for (index, name) in GROUNDS.into_iter().enumerate() {
        let texels = named(name)?;
        for part in 0..4 {
            let at = [index % 5 * 150 + part % 2 * 72, index / 5 * 150 + part / 2 * 72];
            grounds.paste(&texels, at, [72, 72]);
        }
    }
    grounds.save(&folder.join("grounds.png"))?;
    Ok(())
}
