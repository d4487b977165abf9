//! Tree: a stem, branches and some thousand leaves in space, lit from the upper left and painted from the back to the front.
//!
//! form, variant -TREE-> branches and leaves -CANVAS-> Texels
//!
//! Why in space: what makes a crown look like one is that its left is lit and its inside dark, and that near leaves hide far ones. So leaves have a place and a
//! normal, as if they were to be rendered, and the painter's order does the rest. Forms differ in their skeleton: whorls for conifers, clouds of
//! leaves at the ends of branches for all others.
//!
//! Space: heights of the tree; x right, y up from the foot, z toward whoever looks.
//! Cost: 5,000 leaves of 50 samples.

use super::canvas::{Canvas, Paint};
use super::chance::Chance;
use super::forms::Plan;
use crate::math::{cos, sin};

/// Where light comes from: left, above, before.
const LIGHT: [f64; 3] = [-0.55, 0.66, 0.51];

pub(super) type Space = [f64; 3];

/// A leaf, or a tuft of needles.
pub(super) struct Leaf {
    pub(super) at: Space,
    /// Which way it faces; the light asks.
    pub(super) normal: Space,
    /// Along the leaf on the picture.
    pub(super) along: [f64; 2],
    /// Half its length and half its width.
    pub(super) axes: [f64; 2],
    /// 0 deep in the crown, 1 outside.
    pub(super) open: f64,
    /// Lighter or darker than its neighbors, -1 to 1.
    pub(super) tone: f64,
}

/// A piece of stem or branch.
pub(super) struct Branch {
    pub(super) from: Space,
    pub(super) to: Space,
    pub(super) widths: [f64; 2],
}

/// All that is painted.
#[derive(Default)]
pub(super) struct Skeleton {
    pub(super) leaves: Vec<Leaf>,
    pub(super) branches: Vec<Branch>,
}

impl Skeleton {
    /// A branch in a few pieces that bends upward (or down) by `lift`, and wavers.
    pub(super) fn bough(&mut self, from: Space, to: Space, widths: [f64; 2], lift: f64, chance: &mut Chance) {
        const PIECES: usize = 6;
        let length = (0..3).map(|axis| (to[axis] - from[axis]) * (to[axis] - from[axis])).sum::<f64>().sqrt();
        let mut last = from;
        for piece in 1..=PIECES {
            let share = piece as f64 / PIECES as f64;
            let bend = 4.0 * share * (1.0 - share);
            let waver = if piece < PIECES { 0.03 * length } else { 0.0 };
            let mut next = [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * share + waver * chance.around());
            next[1] += lift * bend;
            let width = |share: f64| widths[0] + (widths[1] - widths[0]) * share;
            self.branches.push(Branch {
                from: last,
                to: next,
                widths: [width(share - 1.0 / PIECES as f64), width(share)],
            });
            last = next;
        }
    }

    /// A cloud of leaves around a point: half axes `size`, denser toward its surface.
    pub(super) fn cloud(&mut self, at: Space, size: Space, count: usize, plan: &Plan, chance: &mut Chance) {
        for _ in 0..count {
            let out = chance.normal();
            let radius = 1.0 - 0.75 * chance.share() * chance.share();
            let place = [0, 1, 2].map(|axis| at[axis] + size[axis] * out[axis] * radius);
            let leaf = chance.between(0.7, 1.3);
            let angle = plan.hang + plan.spread * chance.around();
            self.leaves.push(Leaf {
                at: place,
                normal: [0, 1, 2].map(|axis| out[axis] + 0.35 * chance.around()),
                along: [sin(angle), -cos(angle)],
                axes: plan.leaf.map(|half| half * leaf),
                open: radius,
                tone: chance.around(),
            });
        }
    }

    /// Paints everything from the back to the front.
    pub(super) fn paint(&self, plan: &Plan, canvas: &mut Canvas) {
        enum Part<'a> {
            Leaf(&'a Leaf),
            Branch(&'a Branch),
        }
        let leaves = self.leaves.iter().map(|leaf| (leaf.at[2], Part::Leaf(leaf)));
        let branches = self.branches.iter().map(|branch| (0.5 * (branch.from[2] + branch.to[2]), Part::Branch(branch)));
        let mut parts: Vec<(f64, Part)> = branches.chain(leaves).collect();
        parts.sort_by(|one, other| one.0.total_cmp(&other.0));
        for (_, part) in parts {
            match part {
                Part::Leaf(leaf) => {
                    canvas.ellipse([leaf.at[0], leaf.at[1]], leaf.along, leaf.axes, plan.leaf_color(leaf))
                }
                Part::Branch(branch) => {
                    let flat = |at: Space| [at[0], at[1]];
                    let goes_up = branch.to[1] >= branch.from[1];
                    let shade = |across: f64| plan.bark_color(if goes_up { across } else { -across });
                    canvas.stroke(flat(branch.from), flat(branch.to), branch.widths, shade);
                }
            }
        }
    }
}

impl Plan {
    fn leaf_color(&self, leaf: &Leaf) -> Paint {
        let length = leaf.normal.iter().map(|part| part * part).sum::<f64>().sqrt().max(1e-9);
        let lit = (0..3).map(|axis| leaf.normal[axis] * LIGHT[axis]).sum::<f64>() / length;
        // Leaves let light through: the dark side is not black, and the light side is more yellow.
        let light = (0.36 + 0.64 * (0.5 + 0.5 * lit)) * (0.45 + 0.55 * leaf.open) * (1.0 + 0.16 * leaf.tone);
        let [dark, bright] = [self.leaf_colors[0], self.leaf_colors[1]];
        let share = (0.5 + 0.5 * lit + 0.2 * leaf.tone).clamp(0.0, 1.0);
        [0, 1, 2].map(|channel| (dark[channel] + (bright[channel] - dark[channel]) * share) * (0.35 + light))
    }

    /// A round stem: light on its left side.
    fn bark_color(&self, across: f64) -> Paint {
        let light = 0.45 + 0.55 * (0.5 + 0.5 * across) * (1.15 - 0.35 * across.max(0.0));
        self.bark.map(|channel| channel * light)
    }
}
