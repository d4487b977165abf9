//! Forms: how conifers, oaks, stone pines, eucalypts and heather are built.
//!
//! [`Form`], chance -FORMS-> [`Skeleton`]
//!
//! Space: heights of the tree; the crown is as wide as the picture, the top at its upper edge.

use super::canvas::Paint;
use super::chance::Chance;
use super::tree::{Leaf, Skeleton, Space};
use crate::forest::area::Form;
use crate::math::{PI, cos, sin};

/// What the trees of a form have in common.
pub(super) struct Plan {
    /// Width of the crown.
    pub(super) width: f64,
    /// Dark and bright leaves.
    pub(super) leaf_colors: [Paint; 2],
    pub(super) bark: Paint,
    /// Half length and half width of a leaf.
    pub(super) leaf: [f64; 2],
    /// Where leaves point, radians from straight down, and how far they differ.
    pub(super) hang: f64,
    pub(super) spread: f64,
}

impl Plan {
    pub(super) fn of(form: Form) -> Plan {
        match form {
            Form::Conifer => CONIFER,
            Form::Broadleaf => BROADLEAF,
            Form::Umbrella => UMBRELLA,
            Form::Column => COLUMN,
            Form::Shrub => SHRUB,
        }
    }
}

const CONIFER: Plan = Plan {
    width: 0.42,
    leaf_colors: [[0.08, 0.14, 0.09], [0.28, 0.37, 0.20]],
    bark: [0.38, 0.28, 0.20],
    leaf: [0.013, 0.0035],
    hang: 0.0,
    spread: 0.9,
};
const BROADLEAF: Plan = Plan {
    width: 0.85,
    leaf_colors: [[0.11, 0.19, 0.07], [0.39, 0.47, 0.20]],
    bark: [0.40, 0.34, 0.27],
    leaf: [0.0105, 0.0075],
    hang: 0.0,
    spread: PI,
};
const UMBRELLA: Plan = Plan {
    width: 0.70,
    leaf_colors: [[0.10, 0.18, 0.09], [0.36, 0.45, 0.22]],
    bark: [0.52, 0.35, 0.24],
    leaf: [0.012, 0.0040],
    hang: PI,
    spread: 1.3,
};
const COLUMN: Plan = Plan {
    width: 0.32,
    leaf_colors: [[0.16, 0.25, 0.17], [0.47, 0.56, 0.40]],
    bark: [0.72, 0.66, 0.58],
    leaf: [0.013, 0.0036],
    hang: 0.0,
    spread: 0.7,
};
const SHRUB: Plan = Plan {
    width: 1.25,
    leaf_colors: [[0.17, 0.22, 0.10], [0.50, 0.52, 0.27]],
    bark: [0.36, 0.28, 0.21],
    leaf: [0.016, 0.0075],
    hang: PI,
    spread: 1.4,
};

/// Builds a tree.
pub(super) fn build(form: Form, plan: &Plan, chance: &mut Chance) -> Skeleton {
    let mut tree = Skeleton::default();
    match form {
        Form::Conifer => conifer(&mut tree, plan, chance),
        Form::Broadleaf => broadleaf(&mut tree, plan, chance),
        Form::Umbrella => umbrella(&mut tree, plan, chance),
        Form::Column => column(&mut tree, plan, chance),
        Form::Shrub => shrub(&mut tree, plan, chance),
    }
    tree
}

/// A straight stem with whorls of branches, the lower the longer; needles hang from them.
fn conifer(tree: &mut Skeleton, plan: &Plan, chance: &mut Chance) {
    tree.bough([0.0; 3], [0.0, 0.97, 0.0], [0.030, 0.004], 0.0, chance);
    let base = chance.between(0.06, 0.14);
    let whorls = 30 + (chance.share() * 8.0) as usize;
    for whorl in 0..whorls {
        let share = whorl as f64 / whorls as f64;
        let y = base + (0.975 - base) * share;
        let longest = 0.55
            * plan.width
            * (1.0 - share).max(0.0).sqrt()
            * (1.0 - 0.58 * share)
            * if whorl < 2 { 0.8 } else { 1.0 };
        let branches = 9;
        let turn = chance.between(0.0, PI);
        for branch in 0..branches {
            let angle = turn + 2.0 * PI * (branch as f64 + 0.5 * chance.around()) / branches as f64;
            let length = longest * chance.between(0.72, 1.0);
            // Old branches hang, young ones rise.
            let drop = length * (0.55 - 0.75 * share) + 0.02 * chance.around();
            let out = [cos(angle), sin(angle)];
            let end = [out[0] * length, y - drop, out[1] * length];
            tree.bough([0.0, y, 0.0], end, [0.006, 0.002], 0.08 * length, chance);
            needles(tree, [0.0, y, 0.0], end, plan, chance);
        }
    }
}

/// Needles along a branch, more and longer toward the outside.
fn needles(tree: &mut Skeleton, from: Space, to: Space, plan: &Plan, chance: &mut Chance) {
    let length = (0..3).map(|axis| (to[axis] - from[axis]) * (to[axis] - from[axis])).sum::<f64>().sqrt();
    let out = [to[0] - from[0], 0.0, to[2] - from[2]].map(|part| part / length.max(1e-9));
    for _ in 0..(12.0 + 160.0 * length) as usize {
        let share = chance.share().sqrt();
        let aside = 0.30 * length * (1.05 - share) + 0.006;
        let place = [0, 1, 2].map(|axis| {
            from[axis] + (to[axis] - from[axis]) * share + aside * chance.around() * [1.0, 0.30, 1.0][axis]
        });
        let angle = 0.8 * out[0] + plan.spread * chance.around();
        tree.leaves.push(Leaf {
            at: place,
            normal: [out[0] + 0.3 * chance.around(), 0.55 + 0.5 * chance.around(), out[2] + 0.2],
            along: [sin(angle), -cos(angle)],
            axes: plan.leaf.map(|half| half * (0.7 + 0.5 * chance.share())),
            open: 0.15 + 0.85 * share,
            tone: chance.around(),
        });
    }
}

/// A stem that parts into boughs, each with a cloud of leaves at its end and smaller ones around it.
fn broadleaf(tree: &mut Skeleton, plan: &Plan, chance: &mut Chance) {
    let fork = [0.03 * chance.around(), chance.between(0.24, 0.30), 0.0];
    tree.bough([0.0; 3], fork, [0.062, 0.044], 0.0, chance);
    let half = 0.5 * plan.width;
    let middle = [0.0, 0.63, 0.0];
    for index in 0..26 {
        let mut out = chance.normal();
        if index < 9 {
            // The rim of the crown is filled evenly, so that no tree has lost a side.
            let angle = 2.0 * PI * (index as f64 + 0.4 * chance.around()) / 9.0;
            out = [sin(angle), cos(angle), 0.3 * chance.around()];
        }
        let radius = chance.between(0.60, 0.74);
        let size = chance.between(0.085, 0.125);
        let y = middle[1] + 0.36 * out[1] * radius - if out[1] < -0.4 { -0.06 } else { 0.0 };
        let at = [half * out[0] * radius * 1.02, y, half * out[2] * radius];
        tree.bough(fork, at, [0.026, 0.005], 0.04, chance);
        tree.cloud(at, [size * 1.15, size * 0.85, size], 210, plan, chance);
    }
    tree.cloud(middle, [half * 0.55, 0.24, half * 0.5], 700, plan, chance);
}

/// A bare stem, boughs like the ribs of an umbrella, a flat roof of needles.
fn umbrella(tree: &mut Skeleton, plan: &Plan, chance: &mut Chance) {
    let lean = 0.05 * chance.around();
    let fork = [lean, chance.between(0.50, 0.58), 0.0];
    tree.bough([0.0; 3], fork, [0.046, 0.032], 0.0, chance);
    let half = 0.5 * plan.width;
    // Six boughs carry it; each parts once more below the roof.
    let ribs: Vec<Space> = (0..6)
        .map(|rib| {
            let angle = 2.0 * PI * (f64::from(rib) + 0.3 * chance.around()) / 6.0;
            let reach = half * chance.between(0.32, 0.46);
            [lean + reach * cos(angle), chance.between(0.70, 0.75), reach * sin(angle)]
        })
        .collect();
    for rib in &ribs {
        tree.bough(fork, *rib, [0.026, 0.014], -0.02, chance);
    }
    for index in 0..34 {
        let angle = 2.0 * PI * (index as f64 * 0.381_966 + 0.1 * chance.around());
        let radius = ((index as f64 + 0.5) / 34.0).sqrt() * 0.82;
        let roof = 0.885 - 0.16 * radius * radius * radius + 0.035 * chance.around();
        let at = [half * radius * cos(angle) + lean * (1.0 - radius), roof, half * radius * sin(angle)];
        let distance = |rib: &&Space| (rib[0] - at[0]) * (rib[0] - at[0]) + (rib[2] - at[2]) * (rib[2] - at[2]);
        let from = ribs.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).copied().unwrap_or(fork);
        tree.bough(from, [at[0], at[1] - 0.02, at[2]], [0.012, 0.004], -0.02, chance);
        let size = chance.between(0.060, 0.085);
        tree.cloud(at, [size * 1.15, size * 0.95, size * 1.15], 190, plan, chance);
    }
}

/// A high pale stem; loose clouds of hanging leaves on steep boughs over its upper two thirds.
fn column(tree: &mut Skeleton, plan: &Plan, chance: &mut Chance) {
    let top = [0.02 * chance.around(), 0.95, 0.0];
    tree.bough([0.0; 3], top, [0.026, 0.005], 0.0, chance);
    let half = 0.5 * plan.width;
    let clouds = 30;
    for index in 0..clouds {
        let share = (index as f64 + 0.5 * chance.share()) / clouds as f64;
        let y = 0.36 + 0.585 * share;
        // Slim below, widest above the middle, pointed at the top.
        let wide = half * (0.40 + 1.35 * share - 1.45 * share * share).min(0.78);
        let angle = 2.0 * PI * (index as f64 * 0.381_966 + 0.15 * chance.around());
        let reach = wide * chance.between(0.75, 1.05);
        let at = [reach * cos(angle), y, reach * sin(angle)];
        let from = [top[0] * y, y - 0.10 - 0.05 * chance.share(), 0.0];
        tree.bough(from, at, [0.008, 0.002], -0.015, chance);
        let size = chance.between(0.030, 0.046);
        tree.cloud(at, [size, size * 1.15, size], 115, plan, chance);
    }
}

/// Many thin stems from one foot, and leaves from the ground on.
fn shrub(tree: &mut Skeleton, plan: &Plan, chance: &mut Chance) {
    let half = 0.5 * plan.width;
    for index in 0..30 {
        let across = 1.7 * ((index as f64 + 0.5) / 30.0 - 0.5) + 0.1 * chance.around();
        let roof = (1.0 - across * across).max(0.05).sqrt();
        let y = 0.16 + 0.66 * roof * chance.between(0.35, 1.0);
        let at = [half * 0.86 * across, y, 0.4 * roof * chance.around()];
        tree.bough([0.10 * chance.around(), 0.0, 0.0], at, [0.020, 0.006], 0.05, chance);
        let size = chance.between(0.11, 0.17);
        tree.cloud(at, [size * 1.1, size, size], 170, plan, chance);
    }
}
