//! Comments for farop: what NFF has no word for, in a line `#farop ...` before the statement it belongs to.
//!
//! Other readers of NFF skip them as they skip any comment. `docs/formats.md` has the syntax, decision 11 the reasons,
//! `parse/nff/annotation.rs` the reader.

use super::number::write_number;
use crate::color::Rgb;
use crate::math::log;
use crate::scene::{Material, Reflection, Surface};
use std::io::{self, Write};

/// The largest cosine power that is written for `basic`: NFF's "no visible highlight".
const LARGEST_POWER: f64 = 100_000.0;

/// Writes the comment before an `l`.
pub(super) fn write_light(out: &mut dyn Write, intensity: f64) -> io::Result<()> {
    write!(out, "#farop light intensity")?;
    write_number(out, intensity)?;
    writeln!(out)
}

/// Writes the comment before the `f` of `surface` and returns whether there is one: `f` alone may say all of it.
pub(super) fn write_surface(out: &mut dyn Write, surface: &Surface) -> io::Result<bool> {
    let material = &surface.material;
    let is_phong = material.reflection != Reflection::Nff;
    let opacity = (!is_said_by_t(material.opacity)).then(|| material.opacity.to_array());
    if !is_phong && material.ambient.is_none() && opacity.is_none() && !surface.two_sided {
        return Ok(false);
    }
    write!(out, "#farop surface{}", if is_phong { " phong" } else { "" })?;
    if let Some(ambient) = material.ambient {
        write!(out, " ambient")?;
        write_number(out, ambient)?;
    }
    if let Some(channels) = opacity {
        write!(out, " opacity")?;
        channels.iter().try_for_each(|&channel| write_number(out, channel))?;
    }
    writeln!(out, "{}", if surface.two_sided { " two_sided" } else { "" })?;
    Ok(true)
}

/// Whether 1 - T gives the opacity back, to the bit: equal channels, and no digit that 1 - opacity rounds away.
fn is_said_by_t(opacity: Rgb) -> bool {
    let Rgb { r, g, b } = opacity;
    r == g && g == b && 1.0 - (1.0 - r) == r
}

/// The material in terms of `f`: what `basic` does, as the `phong` whose highlight is half as bright at the same angle.
pub(super) fn as_phong(material: &Material) -> Material {
    let Reflection::Basic { c3 } = material.reflection else { return *material };
    // c^2 q / (q^2 (c^2 - 1) + 1) = 1/2 at this cosine q; q^n = 1/2 gives n.
    let squared = c3 * c3;
    let half = 1.0 / (squared + (squared * squared - squared + 1.0).sqrt());
    let shine = if half < 1.0 { (log(0.5) / log(half)).min(LARGEST_POWER) } else { LARGEST_POWER };
    Material { reflection: Reflection::Phong, diffuse: 1.0, shine, ..*material }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pow;

    #[test]
    fn basic_becomes_the_phong_of_the_same_half_width() {
        for c3 in [1e-9, 0.01, 0.1, 0.3, 0.7, 1.0] {
            let material = Material { reflection: Reflection::Basic { c3 }, diffuse: 0.0, ..Material::default() };
            let phong = as_phong(&material);
            assert_eq!((phong.reflection, phong.diffuse), (Reflection::Phong, 1.0));
            if phong.shine < LARGEST_POWER {
                let q = pow(0.5, 1.0 / phong.shine);
                let basic = c3 * c3 * q / (q * q * (c3 * c3 - 1.0) + 1.0);
                assert!((basic - 0.5).abs() < 1e-6, "{c3}: {basic}");
            }
        }
        assert_eq!(as_phong(&Material::default()), Material::default());
    }

    #[test]
    fn every_opacity_of_an_nff_file_is_said_by_t() {
        for step in 0..=1000 {
            let transmitted = f64::from(step) / 1000.0;
            assert!(is_said_by_t(Rgb::gray(1.0 - transmitted)), "{transmitted}");
        }
        assert!(!is_said_by_t(Rgb::gray(0.1)), "1 - 0.1 drops a bit of 0.1");
        assert!(!is_said_by_t(Rgb::new(1.0, 0.5, 1.0)));
    }
}
