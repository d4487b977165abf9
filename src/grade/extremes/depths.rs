//! Kinds about which polygon is in front: depths near each other, very near and very far, and many of them.

use super::kinds::powers;
use super::{Kind, Step, push};
use crate::grade::cases::Random;
use crate::screen::DrawList;

const fn kind(name: &'static str, draws: &'static str, steps: fn() -> Vec<Step>) -> Kind {
    Kind { name, draws, is_about_depth: true, has_polygons: false, steps }
}

pub(super) const KINDS: &[Kind] = &[
    kind("depths near each other", "pairs of 1/w that differ by that part of themselves, in both orders", || {
        (1..=23)
            .map(|k| Step {
                name: format!("2^-{k}"),
                list: pairs(&[(1.0, 1.0 + power(-k)), (0.01, 0.01 * (1.0 + power(-k)))]),
            })
            .collect()
    }),
    kind("far away", "pairs with a 1/w of that size", || {
        (0..=100)
            .step_by(4)
            .map(|k| Step { name: format!("2^-{k}"), list: pairs(&[(power(-k), 1.5 * power(-k))]) })
            .collect()
    }),
    kind("near the eye", "pairs with a 1/w of that size", || {
        (0..=100)
            .step_by(4)
            .map(|k| Step { name: format!("2^{k}"), list: pairs(&[(power(k), 1.5 * power(k))]) })
            .collect()
    }),
    kind("near and far", "a 1/w of 1 beside one of that size", || {
        (1..=100).step_by(3).map(|k| Step { name: format!("2^-{k}"), list: pairs(&[(power(-k), 1.0)]) }).collect()
    }),
    kind("layers", "that many triangles behind each other, in any order", || powers(1..=10, layers)),
];

fn power(exponent: i32) -> f64 {
    crate::math::pow(2.0, f64::from(exponent))
}

/// For each pair of depths four triangles: the nearer one before and behind the farther one in the list.
fn pairs(depths: &[(f64, f64)]) -> DrawList {
    let mut list = DrawList::new(20, 10 * depths.len() as u32);
    for (row, &(far, near)) in depths.iter().enumerate() {
        let y = 10.0 * row as f64;
        for (x, [first, second]) in [(0.0, [far, near]), (10.0, [near, far])] {
            push(&mut list, &[(x + 0.25, y + 0.75), (x + 9.25, y + 1.25), (x + 3.25, y + 9.5)], first);
            push(&mut list, &[(x + 1.25, y + 9.25), (x + 2.75, y + 0.25), (x + 9.75, y + 7.25)], second);
        }
    }
    list
}

/// Large triangles at different depths, shuffled.
fn layers(count: u32) -> DrawList {
    let (mut list, mut random) = (DrawList::new(24, 24), Random(u64::from(count)));
    let mut order: Vec<u32> = (0..count).collect();
    for last in (1..order.len()).rev() {
        order.swap(last, (random.next() % (last as u64 + 1)) as usize);
    }
    let mut pen = super::outlines::Pen::new(8, u64::from(count) + 9);
    for number in order {
        let corners = pen.triangle((0, 0), (24, 24));
        push(&mut list, &corners, 0.25 + f64::from(number) / 4096.0);
    }
    list
}
