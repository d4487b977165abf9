//! Palette: the 256 colors that stand for all of a frame.
//!
//! Picture -counts-> 32,768 boxes of 8 x 8 x 8 levels -halved-> 256 groups -mean-> colors
//!
//! Why median cut: it looks at where colors are, in whole numbers and in one order, so a frame has the same palette on every
//! machine. Why no dithering: grain that changes from frame to frame looks like noise and costs twice the bytes.
//!
//! Source: P. Heckbert, "Color Image Quantization for Frame Buffer Display", SIGGRAPH 1982.
//! Cost: one pass over the pixels to count, one to replace.

use crate::image::Picture;
use std::collections::BTreeSet;

/// Most colors a frame may have.
pub(super) const MOST: usize = 256;

/// Colors that share the five highest bits of every channel.
#[derive(Clone, Copy)]
struct Bin {
    count: u64,
    sum: [u64; 3],
}

/// The bytes of `picture` with at most [`MOST`] colors; unchanged where it has no more.
pub(super) fn few_colors(picture: &Picture) -> Vec<u8> {
    if has_few(picture) {
        return picture.rgb().to_vec();
    }
    let mut bins = vec![Bin { count: 0, sum: [0; 3] }; 1 << 15];
    for color in picture.colors() {
        let bin = &mut bins[number(color)];
        bin.count += 1;
        for (sum, level) in bin.sum.iter_mut().zip(color) {
            *sum += u64::from(level);
        }
    }
    let replaced = replacements(&bins);
    picture.colors().flat_map(|color| replaced[number(color)]).collect()
}

fn has_few(picture: &Picture) -> bool {
    let mut seen = BTreeSet::new();
    picture.colors().all(|color| {
        seen.insert(color);
        seen.len() <= MOST
    })
}

/// The number of a color's bin.
fn number([red, green, blue]: [u8; 3]) -> usize {
    usize::from(red >> 3) << 10 | usize::from(green >> 3) << 5 | usize::from(blue >> 3)
}

/// A bin's place along a channel, 0 to 31.
fn level(bin: u16, channel: usize) -> u16 {
    bin >> (10 - 5 * channel) & 31
}

/// For each bin, the mean color of its group.
fn replacements(bins: &[Bin]) -> Vec<[u8; 3]> {
    let used: Vec<u16> = (0..=0x7FFF).filter(|&bin| bins[usize::from(bin)].count > 0).collect();
    let mut groups = vec![used];
    while groups.len() < MOST {
        // The first of those with the most pixels times the square of their width: what is seen most.
        let urgent = |group: &Vec<u16>| {
            let (_, width) = widest(group);
            total(bins, group) * u64::from(width) * u64::from(width)
        };
        let urgencies: Vec<u64> = groups.iter().map(urgent).collect();
        let Some(&most) = urgencies.iter().max().filter(|&&most| most > 0) else { break };
        let at = urgencies.iter().position(|&urgency| urgency == most).unwrap_or(0);
        let upper = halve(bins, &mut groups[at]);
        groups.push(upper);
    }
    let mut replaced = vec![[0; 3]; bins.len()];
    for group in &groups {
        let color = mean(bins, group);
        for &bin in group {
            replaced[usize::from(bin)] = color;
        }
    }
    replaced
}

fn total(bins: &[Bin], group: &[u16]) -> u64 {
    group.iter().map(|&bin| bins[usize::from(bin)].count).sum()
}

/// The channel along which a group reaches farthest, and how far; green before red before blue, as eyes see them.
fn widest(group: &[u16]) -> (usize, u16) {
    let width = |channel: usize| {
        let levels = group.iter().map(|&bin| level(bin, channel));
        levels.clone().max().unwrap_or(0) - levels.min().unwrap_or(0)
    };
    let mut found = (1, width(1));
    for channel in [0, 2] {
        if width(channel) > found.1 {
            found = (channel, width(channel));
        }
    }
    found
}

/// Takes the upper half of the pixels out of `group`, along its widest channel; both halves keep at least one bin.
fn halve(bins: &[Bin], group: &mut Vec<u16>) -> Vec<u16> {
    let (channel, _) = widest(group);
    group.sort_by_key(|&bin| (level(bin, channel), bin));
    let half = total(bins, group) / 2;
    let mut below = 0;
    let mut middle = 0;
    for &bin in group.iter() {
        below += bins[usize::from(bin)].count;
        if below > half {
            break;
        }
        middle += 1;
    }
    group.split_off(middle.clamp(1, group.len() - 1))
}

/// The mean of all pixels of a group, rounded.
fn mean(bins: &[Bin], group: &[u16]) -> [u8; 3] {
    let count = total(bins, group).max(1);
    std::array::from_fn(|channel| {
        let sum: u64 = group.iter().map(|&bin| bins[usize::from(bin)].sum[channel]).sum();
        ((sum + count / 2) / count) as u8
    })
}
