//! What placement promises.

use super::*;
use crate::forest::area::{Form, MeasuredTree, Patch, Plant, Species, Spread, Stand};
use crate::forest::random::mix64;
use crate::scene::Place;

fn state(density: f64, plant: Plant, cover: Option<u8>) -> StandState {
    StandState {
        year: None,
        species: 0,
        height: Spread { mean: 14.0, deviation: 2.0 },
        crown: Spread { mean: 4.6, deviation: 0.8 },
        density,
        crown_base: None,
        plant,
        picture: None,
        cover,
    }
}

fn patch(owner: Owner, outer: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Patch {
    Patch {
        owner,
        outer: outer.to_vec(),
        holes: holes.iter().map(|hole| hole.to_vec()).collect(),
        place: Place::default(),
    }
}

/// A cell with three stands, one of each kind of planting, that share outlines; a hole, an overlap, a lake; corners on whole odd metres.
pub fn fixture() -> (Head, Cell) {
    let species = Species { code: "PINPN".into(), form: Form::Umbrella, images: vec![], place: Place::default() };
    let cover = |number: u32| crate::forest::area::Cover {
        number,
        image: "paint:grass".into(),
        tile: 30.0,
        place: Place::default(),
    };
    let head =
        Head { side: 240.0, seed: 7, species: vec![species], covers: (0..4).map(cover).collect(), ..Head::default() };
    let stand = |number, state| Stand { number, states: vec![state], place: Place::default() };
    let stands = vec![
        stand(12, state(520.0, Plant::Poisson, Some(1))),
        stand(13, state(900.0, Plant::Jittered, Some(2))),
        stand(14, state(400.0, Plant::Rows, None)),
    ];
    let patches = vec![
        patch(
            Owner::Stand(0),
            &[[0.0, 0.0], [101.0, 0.0], [131.0, 121.0], [0.0, 161.0]],
            &[&[[21.0, 21.0], [21.0, 61.0], [71.0, 41.0]]],
        ),
        patch(Owner::Stand(1), &[[101.0, 0.0], [240.0, 0.0], [240.0, 121.0], [131.0, 121.0]], &[]),
        patch(Owner::Stand(2), &[[0.0, 161.0], [131.0, 121.0], [240.0, 121.0], [240.0, 240.0], [0.0, 240.0]], &[]),
        patch(Owner::Cover(3), &[[91.0, 91.0], [161.0, 101.0], [151.0, 151.0]], &[]),
    ];
    let ground = Ground::Lattice { size: [2, 2], base: 400.0, step: 0.5, counts: vec![0, 40, 80, 20] };
    let place = Place::default();
    let trees = vec![MeasuredTree { species: 0, at: [120.0, 110.0], height: 21.0, crown: 7.0, turn: 90.0, place }];
    (head, Cell { index: [3, -2], seed: 99, cover: Some(0), ground, stands, patches, trees, lines: vec![], place })
}

/// One stand of this planting over a whole cell.
fn full(density: f64, plant: Plant, index: [i32; 2]) -> (Head, Cell) {
    let (head, mut cell) = fixture();
    cell.stands.truncate(1);
    cell.stands[0].states = vec![state(density, plant, None)];
    cell.patches = vec![patch(Owner::Stand(0), &[[0.0, 0.0], [240.0, 0.0], [240.0, 240.0], [0.0, 240.0]], &[])];
    cell.index = index;
    cell.trees.clear();
    (head, cell)
}

fn slope(at: [f64; 2]) -> f64 {
    410.0 + 0.1 * at[0] - 0.05 * at[1]
}

fn trees(head: &Head, cell: &Cell) -> Vec<Tree> {
    grow(head, cell, None, Placement::Lattice, &slope).expect("a small wood")
}

#[test]
fn order_and_threads_change_no_byte() {
    let (head, cell) = fixture();
    let at = |index: i32| Cell { index: [index, 5 - index], ..cell.clone() };
    let forward: Vec<_> = (0..6).map(|index| trees(&head, &at(index))).collect();
    let backward: Vec<_> = (0..6).rev().map(|index| trees(&head, &at(index))).collect();
    assert!(forward.iter().eq(backward.iter().rev()));
    let threads: Vec<_> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..6)
            .map(|index| {
                scope.spawn({
                    let (head, at) = (&head, &at);
                    move || trees(head, &at(index))
                })
            })
            .collect();
        all.into_iter().map(|thread| thread.join().expect("no panic")).collect()
    });
    assert_eq!(forward, threads);
    assert_ne!(forward[0], forward[1], "cells differ");
    // On disk or in a log: a change of any number of the chain would move all forests that people know.
    let sum = forward[0]
        .iter()
        .fold(0, |sum, tree| mix64(sum ^ u64::from(tree.x) << 32 ^ u64::from(tree.y) << 16 ^ u64::from(tree.kind)));
    assert_eq!((forward[0].len(), sum), (3079, 11_274_642_935_928_904_903), "the trees of this cell");
}

#[test]
fn every_tree_stands_on_its_own_land() {
    let (head, cell) = fixture();
    let mut counts = [0; 3];
    for tree in trees(&head, &cell) {
        let at = tree.at(head.side);
        let z = tree.height_above_sea(base_of(&cell));
        assert!((z - slope(at)).abs() <= 1.0 / 32.0 + 1e-9);
        let inside = |patch: &&Patch| polygon::contains(&patch.outer, &patch.holes, at);
        let owner = cell.patches.iter().rev().find(inside).map(|patch| patch.owner);
        match tree.stand() {
            Some(stand) => {
                assert_eq!(owner, Some(Owner::Stand(stand as u32)));
                counts[stand] += 1;
            }
            None => assert_eq!((tree.measured(), size_of(&head, &cell, None, tree).height), (Some(0), 21.0)),
        }
    }
    assert!(counts.iter().all(|&count| count > 300), "{counts:?}");
}

/// Mean and variance of the number of trees over 400 cells, and chi square of their places in 8 x 8 fields.
fn statistics(density: f64, plant: Plant) -> (f64, f64, f64) {
    const CELLS: i32 = 400;
    let mut counts = Vec::new();
    let mut fields = [0.0; 64];
    for index in 0..CELLS {
        let (head, cell) = full(density, plant, [index, 3 * index]);
        let trees = trees(&head, &cell);
        for tree in &trees {
            // Fields that are not the blocks: shifted by half a block.
            let field = |steps: u16| usize::from(steps.wrapping_add(4096) >> 13);
            fields[field(tree.y) * 8 + field(tree.x)] += 1.0;
        }
        counts.push(trees.len() as f64);
    }
    let mean = counts.iter().sum::<f64>() / f64::from(CELLS);
    let variance = counts.iter().map(|count| (count - mean) * (count - mean)).sum::<f64>() / f64::from(CELLS - 1);
    let expected = mean * f64::from(CELLS) / 64.0;
    let chi = fields.iter().map(|count| (count - expected) * (count - expected) / expected).sum();
    (mean, variance, chi)
}

#[test]
fn as_many_trees_as_the_inventory_says() {
    // 25 a hectare on 5.76 ha: 144 trees. The variance of a variance over n cells is about 2 v^2 / n.
    let expected: f64 = 25.0 * 5.76;
    let (mean, variance, chi) = statistics(25.0, Plant::Poisson);
    assert!((mean - expected).abs() < 4.0 * (expected / 400.0).sqrt(), "mean {mean}");
    assert!((variance - expected).abs() < 4.0 * expected * (2.0_f64 / 400.0).sqrt(), "variance {variance}");
    // 63 degrees of freedom: mean 63, deviation 11.2.
    assert!((63.0 - chi).abs() < 4.0 * 11.3, "chi square {chi}");
    // One in each square: the mean is the same, the variance much smaller.
    for plant in [Plant::Jittered, Plant::Rows] {
        let (mean, variance, chi) = statistics(25.0, plant);
        assert!((mean - expected).abs() < 4.0 * (expected / 400.0).sqrt(), "{plant:?}: mean {mean}");
        assert!(variance < 0.7 * expected, "{plant:?}: variance {variance}");
        assert!(chi < 63.0 + 4.0 * 11.3, "{plant:?}: chi square {chi}");
    }
}

#[test]
fn thinning_leaves_a_part_and_growth_adds_to_it() {
    for plant in [Plant::Poisson, Plant::Jittered] {
        let (head, dense) = full(900.0, plant, [1, 1]);
        let dense = trees(&head, &dense);
        let mut last = 0;
        for density in [10.0, 300.0, 520.0] {
            let (_, thin) = full(density, plant, [1, 1]);
            let thin = trees(&head, &thin);
            assert!(thin.iter().all(|tree| dense.contains(tree)) && thin.len() > last, "{plant:?} {density}");
            last = thin.len();
        }
    }
    // Rows keep theirs between the years of a stand.
    let (head, mut cell) = full(900.0, Plant::Rows, [1, 1]);
    cell.stands[0].states = [(2011, 900.0), (2026, 350.0)]
        .map(|(year, density)| StandState { year: Some(year), ..state(density, Plant::Rows, None) })
        .to_vec();
    let [dense, thin] =
        [2011, 2026].map(|year| grow(&head, &cell, Some(year), Placement::Lattice, &slope).expect("a wood"));
    assert!(thin.iter().all(|tree| dense.contains(tree)) && thin.len() > 1500 && dense.len() > 4500);
}

#[test]
fn trees_of_squares_keep_their_distance() {
    let (head, cell) = full(711.0, Plant::Jittered, [0, 0]);
    let trees = trees(&head, &cell);
    // 711 a hectare are the full squares of 30 / 8 m; a quarter of their side is promised.
    let at: Vec<_> = trees.iter().map(|tree| tree.at(240.0)).collect();
    let distance = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
    let nearest = at
        .iter()
        .enumerate()
        .flat_map(|(index, a)| at[..index].iter().map(move |b| distance(a, b)))
        .fold(f64::MAX, f64::min);
    assert!(nearest >= 30.0 / 8.0 / 4.0 - 0.01, "{nearest}");
}

#[test]
fn rows_go_on_over_borders_and_no_tree_stands_twice() {
    let (head, west) = full(400.0, Plant::Rows, [0, 0]);
    let (_, east) = full(400.0, Plant::Rows, [1, 0]);
    let world = |cell: &Cell| -> Vec<[f64; 2]> {
        let corner = head.corner(cell.index);
        trees(&head, cell).iter().map(|tree| [corner.x + tree.at(240.0)[0], corner.y + tree.at(240.0)[1]]).collect()
    };
    let all = [world(&west), world(&east)].concat();
    let step = (1e4_f64 / 400.0 / 1.5).sqrt();
    let near_border =
        all.iter().enumerate().filter(|(_, at)| (at[0] - 240.0).abs() < 20.0 && (at[1] - 120.0).abs() < 90.0);
    for (index, at) in near_border {
        let distance = |other: &[f64; 2]| (other[0] - at[0]).hypot(other[1] - at[1]);
        let nearest = all
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index)
            .map(|(_, other)| distance(other))
            .fold(f64::MAX, f64::min);
        assert!(nearest > 0.6 * step && nearest < 1.3 * step, "{at:?}: {nearest}, {step}");
    }
}

#[test]
fn triangles_of_the_relief_hold_their_share() {
    // The whole cell as two triangles and as 200: the mean is the same, the trees are others.
    let corner = |x: f64, y: f64| Vec3::new(x, y, slope([x, y]));
    let fine: Vec<[Vec3; 3]> = (0..100)
        .flat_map(|index| {
            let (x, y) = (f64::from(index % 10) * 24.0, f64::from(index / 10) * 24.0);
            let [a, b, c, d] = [corner(x, y), corner(x + 24.0, y), corner(x + 24.0, y + 24.0), corner(x, y + 24.0)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    let [a, b, c, d] = [corner(0.0, 0.0), corner(240.0, 0.0), corner(240.0, 240.0), corner(0.0, 240.0)];
    let coarse = vec![[a, b, c], [a, c, d]];
    for triangles in [fine, coarse] {
        let mut count = 0;
        for index in 0..20 {
            let (head, cell) = full(300.0, Plant::Poisson, [index, 0]);
            let trees = grow(&head, &cell, None, Placement::Triangles(&triangles), &|_| f64::NAN).expect("a wood");
            let base = base_of(&cell);
            let off = |tree: &Tree| (tree.height_above_sea(base) - slope(tree.at(240.0))).abs() > 1.0 / 16.0;
            assert!(!trees.iter().any(off), "on the triangle, not on the ground given");
            count += trees.len();
        }
        let expected: f64 = 300.0 * 5.76 * 20.0;
        assert!((count as f64 - expected).abs() < 4.0 * expected.sqrt(), "{count} of {expected}");
    }
}

#[test]
fn a_billion_trees_are_refused() {
    for density in [1e9, f64::INFINITY, f64::NAN] {
        let (head, cell) = full(density, Plant::Poisson, [0, 0]);
        let error = grow(&head, &cell, None, Placement::Lattice, &slope).expect_err("too many");
        assert!(matches!(error, PlaceError::TooManyTrees { stand: 12, .. }), "{error}");
    }
    let (head, mut cell) = full(10.0, Plant::Poisson, [0, 0]);
    cell.stands = vec![cell.stands[0].clone(); MOST_STANDS + 1];
    let error = grow(&head, &cell, None, Placement::Lattice, &slope).expect_err("too many stands");
    assert_eq!(error.to_string(), "cell 0 0 has 2049 stands, at most 2048 are possible: make cells smaller");
}

#[test]
fn sizes_stay_with_their_trees() {
    let (head, cell) = fixture();
    let sizes: Vec<Size> = trees(&head, &cell)
        .iter()
        .filter(|tree| tree.stand().is_some())
        .map(|&tree| size_of(&head, &cell, None, tree))
        .collect();
    let count = sizes.len() as f64;
    let mean = sizes.iter().map(|size| size.height).sum::<f64>() / count;
    assert!((mean - 14.0).abs() < 4.0 * 2.0 / count.sqrt(), "{mean}");
    assert!(sizes.iter().all(|size| (9.0..=19.0).contains(&size.height) && (2.6..=6.6).contains(&size.crown)));
    // Beside a stand of other means the same tree is tall again.
    let mut older = cell.clone();
    older.stands.iter_mut().for_each(|stand| stand.states[0].height = Spread { mean: 20.0, deviation: 3.0 });
    let tree = trees(&head, &cell)[5];
    let [now, then] = [&cell, &older].map(|cell| size_of(&head, cell, None, tree));
    assert!(((now.height - 14.0) / 2.0 - (then.height - 20.0) / 3.0).abs() < 1e-9 && now.turn == then.turn);
}

#[test]
fn roads_stay_free() {
    let (head, mut cell) = full(900.0, Plant::Poisson, [0, 0]);
    let before = trees(&head, &cell);
    let points = vec![[0.0, 30.0], [100.0, 130.0], [240.0, 120.0]];
    cell.lines.push(crate::forest::area::Line {
        kind: "road".into(),
        width: 7.0,
        points: points.clone(),
        place: Place::default(),
    });
    let after = trees(&head, &cell);
    assert!(after.iter().all(|tree| before.contains(tree)), "no tree has moved");
    let distance = |tree: &Tree| {
        let at = tree.at(240.0);
        let from = |pair: &[[f64; 2]]| {
            // Close enough: the nearest of many points.
            let point = |step: u32| {
                [0, 1].map(|axis| pair[0][axis] + (pair[1][axis] - pair[0][axis]) * f64::from(step) / 1000.0)
            };
            (0..=1000).map(point).map(|p| (p[0] - at[0]).hypot(p[1] - at[1])).fold(f64::MAX, f64::min)
        };
        points.windows(2).map(from).fold(f64::MAX, f64::min)
    };
    assert!(after.iter().all(|tree| distance(tree) > 3.99));
    assert!(before.iter().filter(|tree| !after.contains(tree)).all(|tree| distance(tree) < 4.02));
    // 281 m of road, 8 m free: 0.225 ha of 900.
    assert!((150..260).contains(&(before.len() - after.len())), "{}", before.len() - after.len());
}
