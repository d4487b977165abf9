//! What invented landscapes promise.

use super::*;
use crate::forest::area::Form;
use crate::forest::cover::raster;
use crate::forest::place::{Placement, grow};
use crate::forest::polygon::{self, area, contains, self_crossing};
use crate::forest::random::{mix64, unit};

/// The cells around the lake: there is a bit of everything.
fn around_the_lake(land: &Invented) -> Vec<Cell> {
    let [x, y] = land.relief.lake.center.map(|metres| (metres / SIDE) as i32);
    let cells = (-4..=4).flat_map(|row| (-4..=4).map(move |column| [x + column, y + row]));
    cells.filter_map(|index| land.cell(index)).collect()
}

#[test]
fn sizes_are_as_asked() {
    let sizes = [1.0, 5.76, 5.77, 1000.0, 95_000.0].map(|hectares| invent(hectares, 1).expect("a size").len());
    assert_eq!(sizes, [1, 1, 2, 174, 16_494]);
    for hectares in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e12] {
        assert!(invent(hectares, 1).is_err());
    }
    let small = invent(60.0, 3).expect("a size");
    assert_eq!((small.cells().count(), small.size()), (11, [4, 3]));
    assert!(small.cell([3, 2]).is_none() && small.cell([-1, 0]).is_none() && small.cell([2, 2]).is_some());
}

#[test]
fn neighbors_share_their_border_bit_for_bit() {
    let land = invent(95_000.0, 7).expect("a size");
    for cell in around_the_lake(&land) {
        let east = land.cell([cell.index[0] + 1, cell.index[1]]).expect("within");
        let north = land.cell([cell.index[0], cell.index[1] + 1]).expect("within");
        for step in 0..9 {
            assert_eq!(cell.ground.sample(8, step).to_bits(), east.ground.sample(0, step).to_bits());
            assert_eq!(cell.ground.sample(step, 0).to_bits(), north.ground.sample(step, 8).to_bits());
        }
        // Corners of patches on the border, too.
        let on = |cell: &Cell, axis: usize, at: f64| {
            let corners = cell.patches.iter().flat_map(|patch| patch.outer.iter()).filter(|corner| corner[axis] == at);
            let mut all: Vec<u64> = corners.map(|corner| corner[1 - axis].to_bits()).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        assert_eq!(on(&cell, 0, 240.0), on(&east, 0, 0.0), "east of {:?}", cell.index);
        assert_eq!(on(&cell, 1, 240.0), on(&north, 1, 0.0), "north of {:?}", cell.index);
    }
}

#[test]
fn patches_leave_no_gap() {
    let land = invent(95_000.0, 7).expect("a size");
    for cell in around_the_lake(&land) {
        let is_lake = |patch: &&Patch| patch.owner == Owner::Cover(stands::WATER);
        let regions: Vec<&Patch> = cell.patches.iter().filter(|patch| !is_lake(patch)).collect();
        let sum: f64 = regions.iter().map(|patch| area(&patch.outer)).sum();
        assert!((sum - SIDE * SIDE).abs() < 1e-6, "{:?}: {sum}", cell.index);
        for index in 0..300 {
            let at = [mix64(2 * index), mix64(2 * index + 1)].map(|bits| (unit(bits) * 240.0 * 64.0).floor() / 64.0);
            let owners = regions.iter().filter(|patch| contains(&patch.outer, &[], at)).count();
            assert_eq!(owners, 1, "{at:?} in {:?}", cell.index);
        }
        for patch in &cell.patches {
            assert_eq!(self_crossing(&patch.outer, &[]), None);
            assert!(
                area(&patch.outer) > 0.0 && patch.outer.iter().flatten().all(|metres| (0.0..=SIDE).contains(metres))
            );
        }
    }
}

#[test]
fn stands_keep_number_and_plan_over_borders() {
    let land = invent(95_000.0, 7).expect("a size");
    let mut known = std::collections::BTreeMap::new();
    let mut again = 0;
    for stand in around_the_lake(&land).into_iter().flat_map(|cell| cell.stands) {
        let years: Vec<_> = stand.states.iter().filter_map(|state| state.year).collect();
        assert_eq!(years, YEARS);
        match known.insert(stand.number, stand.clone()) {
            Some(before) => {
                assert_eq!(before, stand);
                again += 1;
            }
            None => {
                let [first, last] = [&stand.states[0], &stand.states[2]];
                assert_ne!(first.height, last.height, "it has grown, or was cut");
            }
        }
    }
    assert!(known.len() > 10 && again > 20, "{} stands, {again} of them met again", known.len());
}

#[test]
fn there_is_something_of_everything() {
    let land = invent(20_000.0, 11).expect("a size");
    let mut heights = (f64::MAX, f64::MIN);
    let (mut forms, mut covers, mut kinds) = (vec![], vec![0_usize; 9], std::collections::BTreeSet::new());
    for cell in land.cells().step_by(5).chain(around_the_lake(&land)) {
        let Ground::Lattice { counts, .. } = &cell.ground else { panic!("a lattice") };
        for count in counts {
            heights = (heights.0.min(f64::from(*count) * STEP), heights.1.max(f64::from(*count) * STEP));
        }
        forms.extend(cell.stands.iter().map(|stand| land.head.species[usize::from(stand.states[0].species)].form));
        raster(&land.head, &cell, Some(2018), 12).into_iter().for_each(|number| covers[usize::from(number)] += 1);
        kinds.extend(cell.lines.iter().map(|line| line.kind.clone()));
    }
    assert!(heights.0 >= 0.0 && heights.1 <= 900.0 && heights.1 - heights.0 > 350.0, "{heights:?}");
    assert!(Form::ALL.iter().all(|(_, form)| forms.contains(form)));
    assert!(covers[0] == 0 && covers[1..=6].iter().filter(|count| **count > 0).count() >= 5, "{covers:?}");
    assert!(kinds.contains("road") && kinds.contains("river"), "{kinds:?}");
    assert!(
        land.head.marks.len() == 7
            && land.head.marks.iter().all(|mark| land.cell(land.head.cell_at(mark.at)).is_some())
    );
}

#[test]
fn trees_grow_on_it_and_not_in_the_lake() {
    let land = invent(95_000.0, 7).expect("a size");
    let mut count = 0;
    for cell in around_the_lake(&land).iter().step_by(4) {
        let trees = grow(&land.head, cell, Some(2018), Placement::Lattice, &|_| 100.0).expect("a wood");
        let lakes: Vec<&Patch> =
            cell.patches.iter().filter(|patch| patch.owner == Owner::Cover(stands::WATER)).collect();
        assert!(!trees.iter().any(|tree| lakes.iter().any(|lake| polygon::contains(&lake.outer, &[], tree.at(SIDE)))));
        count += trees.len();
    }
    assert!(count > 5000, "{count}");
}
