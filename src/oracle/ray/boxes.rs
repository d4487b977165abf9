//! Boxes: a tree of boxes around everything a ray may meet.
//!
//! Half of the items on each side, by the middle of their boxes along the longest side, down to four. Built and walked
//! without recursion: a scene may hold millions of items.
//!
//! Space: world space, the eye at the origin: all rays start there.
//! Source: Rubin and Whitted, "A 3-Dimensional Representation for Fast Rendering of Complex Scenes", SIGGRAPH 1980; Kay
//! and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986 (slabs).

use crate::math::Vec3;

/// Two opposite corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub low: Vec3,
    pub high: Vec3,
}

impl Bounds {
    /// The smallest box around points, and a little more: rounding must not hide what touches it.
    pub fn around(points: impl Iterator<Item = Vec3>) -> Bounds {
        let nothing = Bounds { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };
        let tight = points.fold(nothing, |all, point| Bounds { low: all.low.min(point), high: all.high.max(point) });
        let more = Vec3::splat(tight.low.abs().max(tight.high.abs()).max_element() * 1e-12);
        Bounds { low: tight.low - more, high: tight.high + more }
    }

    fn with(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Where the ray is within the box, if between `from` and `to`.
    fn is_met(&self, per_direction: Vec3, (from, to): (f64, f64)) -> bool {
        let (mut enter, mut leave) = (from, to);
        for axis in 0..3 {
            let (a, b) = (self.low[axis] * per_direction[axis], self.high[axis] * per_direction[axis]);
            // 0 times infinity, a ray within a side, is not a number: `max` and `min` pass it over.
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        enter <= leave
    }
}

/// A box, and what is in it: a range of items, or two boxes at neighboring places.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    Items(u32, u32),
    Nodes(u32),
}

/// The tree.
#[derive(Debug, Default)]
pub(super) struct Boxes {
    nodes: Vec<Node>,
    /// Items in the order of the leaves.
    order: Vec<u32>,
}

/// Boxes with no more items than this are not divided.
const FEW: usize = 4;

impl Boxes {
    /// The tree of items with the given boxes.
    pub fn new(bounds: &[Bounds]) -> Boxes {
        let mut order: Vec<u32> = (0..bounds.len() as u32).collect();
        let around = |items: &[u32]| items.iter().map(|&item| bounds[item as usize]).reduce(Bounds::with);
        let Some(all) = around(&order) else { return Boxes::default() };
        let mut nodes = vec![Node { bounds: all, content: Content::Items(0, order.len() as u32) }];
        let mut next = 0;
        while next < nodes.len() {
            let Node { bounds: whole, content } = nodes[next];
            if let Content::Items(first, end) = content
                && (end - first) as usize > FEW
            {
                let items = &mut order[first as usize..end as usize];
                let half = items.len() / 2;
                let size = whole.high - whole.low;
                let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
                let middle = |item: &u32| bounds[*item as usize].low[axis] + bounds[*item as usize].high[axis];
                items.select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)).then(a.cmp(b)));
                let cut = first + half as u32;
                let children = nodes.len() as u32;
                for range in [(first, cut), (cut, end)] {
                    let bounds = around(&order[range.0 as usize..range.1 as usize]).unwrap_or(whole);
                    nodes.push(Node { bounds, content: Content::Items(range.0, range.1) });
                }
                nodes[next].content = Content::Nodes(children);
            }
            next += 1;
        }
        Boxes { nodes, order }
    }

    /// Calls `visit` with every item whose box the ray may meet between `near` and the t that `visit` returned last.
    pub fn walk(&self, direction: Vec3, (near, far): (f64, f64), mut visit: impl FnMut(u32) -> f64) {
        let per_direction = direction.recip();
        let mut limit = far;
        // Two a level; 2^32 items are 30 levels.
        let mut stack = Vec::with_capacity(64);
        stack.extend((!self.nodes.is_empty()).then_some(0));
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index as usize];
            if !node.bounds.is_met(per_direction, (near, limit)) {
                continue;
            }
            match node.content {
                Content::Nodes(first) => stack.extend([first, first + 1]),
                Content::Items(first, end) => {
                    for &item in &self.order[first as usize..end as usize] {
                        limit = visit(item);
                    }
                }
            }
        }
    }
}
