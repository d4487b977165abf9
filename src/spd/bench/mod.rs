//! Scenes for measuring: computed, so that nobody needs a file, and written by `farop generate` for other renderers.
//!
//! name -BENCH-> Triangles -> Scene (`bench:flake:10k`) or `.ftri`
//!
//! `flake` has many small triangles: the sphereflake of [`super::balls`], every sphere cut up. `fill_b2f` and `fill_f2b` have few
//! that fill the picture four times over, far to near and near to far: one costs vertices, the other samples. `forest` has pictures with
//! holes, many of them behind each other.
//!
//! World space, right-handed. Deterministic: the same bytes everywhere.

mod fill;
mod flake;
mod forest;
mod lens;

use crate::scene::Triangles;

/// A family of scenes for measuring.
#[derive(Debug)]
pub struct BenchScene {
    /// What follows `bench:`.
    pub name: &'static str,
    /// What may follow behind another colon, and how many triangles that is; the first is the default. Empty: no sizes.
    pub sizes: &'static [(&'static str, u64)],
    /// What there is to see, in one line.
    pub summary: &'static str,
    /// Makes the scene of a size, by its place in `sizes`.
    make: fn(size: usize) -> Triangles,
}

/// All families.
pub const BENCH_SCENES: &[BenchScene] = &[
    BenchScene {
        name: "flake",
        sizes: &flake::SIZES,
        summary: "the sphereflake in 1k to 10m triangles, three lights: small triangles",
        make: flake::make,
    },
    BenchScene {
        name: "fill_b2f",
        sizes: &[],
        summary: "four tilted layers over the whole picture, far to near: 32 triangles, every sample four times",
        make: |_| fill::make(fill::Order::FarToNear),
    },
    BenchScene {
        name: "fill_f2b",
        sizes: &[],
        summary: "the same layers near to far: three of four are hidden when they come",
        make: |_| fill::make(fill::Order::NearToFar),
    },
    BenchScene {
        name: "forest",
        sizes: &forest::SIZES,
        summary: "1k to 125k trees, each two crossed pictures with holes, on hills: overdraw and alpha",
        make: forest::make,
    },
];

/// Why there is no such scene.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BenchError {
    /// No family of that name.
    #[error("there is no bench scene `{name}`; there is {known}")]
    Unknown {
        /// What was asked for.
        name: String,
        /// All names.
        known: String,
    },
    /// The family has no such size.
    #[error("bench:{name} has no size `{size}`; {help}")]
    Size {
        /// The family.
        name: &'static str,
        /// What was asked for.
        size: String,
        /// Which there are.
        help: String,
    },
}

/// The scene called `NAME` or `NAME:SIZE`.
///
/// # Errors
/// [`BenchError`]: there is none.
///
/// ```
/// use farop::spd::bench;
/// assert_eq!(bench::triangles("flake:10k")?.len(), 10_194);
/// assert!(bench::triangles("flake:7").is_err());
/// # Ok::<(), bench::BenchError>(())
/// ```
pub fn triangles(name: &str) -> Result<Triangles, BenchError> {
    let (family, size) = find(name)?;
    Ok((family.make)(size))
}

/// Whether `NAME` or `NAME:SIZE` starts with the name of a family.
#[must_use]
pub fn is_family(name: &str) -> bool {
    let name = name.split(':').next().unwrap_or_default();
    BENCH_SCENES.iter().any(|scene| scene.name == name)
}

/// The family of `NAME[:SIZE]`, and the place of the size in its list.
fn find(text: &str) -> Result<(&'static BenchScene, usize), BenchError> {
    let (name, size) = text.split_once(':').map_or((text, None), |(name, size)| (name, Some(size)));
    let Some(family) = BENCH_SCENES.iter().find(|scene| scene.name == name) else {
        let known = BENCH_SCENES.iter().map(|scene| scene.name).collect::<Vec<_>>().join(", ");
        return Err(BenchError::Unknown { name: name.to_string(), known });
    };
    let Some(size) = size else { return Ok((family, 0)) };
    let known = family.sizes.iter().position(|(known, _)| known.eq_ignore_ascii_case(size));
    known.map(|place| (family, place)).ok_or_else(|| {
        let names: Vec<_> = family.sizes.iter().map(|(name, _)| *name).collect();
        let help = if names.is_empty() {
            format!("write bench:{}", family.name)
        } else {
            format!("there is {}", names.join(", "))
        };
        BenchError::Size { name: family.name, size: size.to_string(), help }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_say_how_many_triangles_there_are() {
        for (size, triangles) in &flake::SIZES[..3] {
            let made = super::triangles(&format!("flake:{size}")).expect("a listed size");
            assert_eq!(made.len() as u64, *triangles, "{size}");
            assert!(made.indices.iter().all(|&index| (index as usize) < made.positions.len()));
        }
        for (size, triangles) in &forest::SIZES[..2] {
            let made = super::triangles(&format!("forest:{size}")).expect("a listed size");
            assert_eq!(made.len() as u64, *triangles, "{size}");
            assert!(made.indices.iter().all(|&index| (index as usize) < made.positions.len()));
            let (width, height) = made.texture_size;
            assert_eq!(made.texels.len(), 4 * (width * height) as usize);
            assert_eq!(made.ranges.iter().map(|range| range.count as usize).sum::<usize>(), made.indices.len());
        }
        assert_eq!(super::triangles("fill_b2f").map(|made| made.len()), Ok(32));
    }

    #[test]
    fn the_two_orders_hold_the_same_layers() {
        let [far_first, near_first] = ["fill_b2f", "fill_f2b"].map(|name| triangles(name).expect("it is there"));
        let depths = |made: &Triangles| made.positions.chunks(9).map(|layer| layer[4][2]).collect::<Vec<_>>();
        assert_eq!(depths(&far_first), [-8.0, -6.0, -4.0, -2.0]);
        assert_eq!(depths(&near_first), [-2.0, -4.0, -6.0, -8.0]);
    }

    #[test]
    fn what_is_not_there_is_told() {
        let message = |name: &str| triangles(name).expect_err(name).to_string();
        assert_eq!(message("flak"), "there is no bench scene `flak`; there is flake, fill_b2f, fill_f2b, forest");
        assert!(message("flake:2").contains("10k, 1k, 100k, 1m, 10m"));
        assert!(message("fill_b2f:2").contains("write bench:fill_b2f"));
    }
}
