//! Fades: which of two surfaces that stand for one thing a sample belongs to.
//!
//! sample, number of the thing -RANK-> 0 to 15 -> is it among those that this surface shows?
//!
//! Why ranks and not opacity: blending needs lists of fragments and an order, and two half-transparent trees in one place let a quarter of
//! what is behind them through. Ranks are a partition: where one tree leaves a sample out, the other has it.
//!
//! Why 4 x 4 samples: with A = 4 a pixel has all sixteen, and its mean is the exact share; with A = 1 it is the ordered dither of old.
//! Why turned: two trees one behind the other, both half gone, must not leave out the same samples.
//!
//! Space: samples of the picture. Source: Bayer, "An Optimum Method for Two-Level Rendition of Continuous-Tone Pictures", ICC 1973.
//! Cost: a hash of one number a sample, only where there is a fade.

use super::texture::mixed;
use crate::scene::Fade;

/// The first k of 16, whatever k, lie as far apart as can be.
const RANKS: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// Whether `fade` shows sample (x, y) of the thing with that number.
#[inline]
pub(super) fn shows(fade: Fade, (x, y): (i32, i32), number: u32) -> bool {
    let rank = u32::from(RANKS[(y & 3) as usize][(x & 3) as usize]);
    let turned = (rank + mixed(u64::from(number))) % u32::from(Fade::RANKS);
    (u32::from(fade.from)..u32::from(fade.to)).contains(&turned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_that_share_leave_nothing_and_nothing_twice() {
        for number in [0, 1, 7, 812, u32::MAX] {
            for k in 0..=16 {
                let (near, far) = (Fade { from: 0, to: k }, Fade { from: k, to: 16 });
                let mut shown = 0;
                for sample in (-4..12).flat_map(|y| (-8..8).map(move |x| (x, y))) {
                    let both = [near, far].map(|fade| shows(fade, sample, number));
                    assert!(both[0] != both[1], "{number} {k} {sample:?}");
                    shown += u32::from(both[0]);
                }
                assert_eq!(shown, 16 * u32::from(k), "{number} {k}");
            }
        }
    }

    #[test]
    fn half_is_half_of_every_small_square() {
        // What a pixel with A = 2 shows must not depend on where it is.
        for number in 0..20 {
            for corner in (0..4).flat_map(|y| (0..4).map(move |x| (2 * x, 2 * y))) {
                let square = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| (corner.0 + x, corner.1 + y));
                let shown = square.iter().filter(|&&sample| shows(Fade { from: 0, to: 8 }, sample, number)).count();
                assert_eq!(shown, 2, "{number} {corner:?}");
            }
        }
    }

    #[test]
    fn things_are_turned() {
        let mask = |number| {
            let samples = (0..16).map(|index| (index % 4, index / 4));
            samples.map(|sample| shows(Fade { from: 3, to: 9 }, sample, number)).collect::<Vec<_>>()
        };
        let masks: std::collections::BTreeSet<_> = (0..200).map(mask).collect();
        assert_eq!(masks.len(), 16);
        assert!((0..16).all(|index| !shows(Fade { from: 9, to: 9 }, (index % 4, index / 4), 5)), "nothing");
    }
}
