//! Items 47 to 60: polygons that are hardly any.

use super::tools::{
    VIEW, both_sides, covered, draw, ensure, exact_list, exactly, made, noticed, on_screen, picture, read,
};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::geometry::split::{SplitScratch, split};
use crate::math::{PI, Vec3, cos, sin};
use crate::oracle::exact::{Rules, judge};
use crate::plan::{Choices, Culling};
use crate::raster::ZBuffer;
use crate::screen::DrawList;
use std::time::Instant;

pub(super) const ITEMS: &[Item] = &[
    (47, "no area: culled and counted", Run(no_area)),
    (48, "samples on edges and corners: one owner each", Run(on_edges)),
    (49, "a polygon of 1e6 corners: n - 2 triangles in less than 2 s", Run(many_corners)),
    (50, "all corners the same: skipped", Run(|_| dropped("p 3 1 1 1 1 1 1 1 1 1"))),
    (51, "all corners on a line: skipped", Run(|_| dropped("p 4 0 0 0 1 2 3 2 4 6 4 8 12"))),
    (52, "a spike a, b, a: drawn, an ear without area", Run(spike)),
    (53, "a bow-tie: even-odd, and flagged", Run(bow_tie)),
    (54, "a spiral: exact", Run(spiral)),
    (55, "a quad that is not planar: drawn, its residual told", Run(not_planar)),
    (56, "the same polygon twice: the first shows everywhere", Run(twice)),
    (57, "one plane, two colors: the same in every frame", Run(coplanar)),
    (58, "two that pierce each other: the line of the oracle", Run(piercing)),
    (59, "wound the other way: culled", Run(reversed)),
    (60, "first three corners on a line: Newell's normal, with a warning", Run(straight_start)),
];

fn no_area(_: &Effort) -> Outcome {
    for outline in [
        vec![Vec3::new(-1.0, 0.0, 3.0), Vec3::new(0.0, 0.5, 3.0), Vec3::new(1.0, 1.0, 3.0)],
        vec![Vec3::new(0.5, 0.5, 3.0); 4],
    ] {
        let drawn = draw(&made(&[outline]), &Choices::default())?;
        ensure(drawn.list.is_empty() && drawn.counts.skipped + drawn.counts.backfacing == 1, "not counted")?;
    }
    Ok(())
}

fn on_edges(_: &Effort) -> Outcome {
    // Fans and squares whose corners and edges run through sample centers.
    let mut list = DrawList::new(16, 16);
    for row in 0..4 {
        for column in 0..4 {
            let at = |x: i32, y: i32| (f64::from(column * 3 + x) + 1.5, f64::from(row * 3 + y) + 1.5);
            let middle = (at(1, 1).0, at(2, 1).1);
            let corners = [at(0, 0), at(3, 0), at(3, 3), at(0, 3)];
            for (&a, &b) in crate::math::edges(&corners) {
                list.push_flat(&[a, b, middle], 1.0, [1.0; 3]);
            }
        }
    }
    let truth = exact_list(&list)?;
    ensure(truth.covering.iter().all(|&count| count <= 1), "a sample has two owners")?;
    let inside = truth.covering.iter().filter(|&&count| count == 1).count();
    ensure(inside == 144 && truth.counts.on_outline > 200, format!("{inside} samples of 144"))
}

fn many_corners(effort: &Effort) -> Outcome {
    let count = effort.count(50_000, 1_000_000) as usize;
    let corner = |i: usize| {
        let angle = i as f64 / count as f64 * 2.0 * PI;
        let radius = if i.is_multiple_of(2) { 1.0 } else { 0.9 };
        Vec3::new(cos(angle) * radius, sin(angle) * radius, 3.0)
    };
    let outline: Vec<Vec3> = (0..count).map(corner).collect();
    let mut triangles = Vec::new();
    let start = Instant::now();
    let report = split(&outline, Vec3::Z, &mut SplitScratch::default(), &mut triangles);
    let seconds = start.elapsed().as_secs_f64();
    ensure(triangles.len() == count - 2 && report.forced == 0, format!("{} triangles", triangles.len()))?;
    // Unoptimized builds are judged by the result alone.
    ensure(seconds < 2.0 || cfg!(debug_assertions), format!("{seconds:.2} s"))
}

fn dropped(statement: &str) -> Outcome {
    let parsed = noticed(format!("{statement}\ns 0 0 0 1"), "dropped")?;
    ensure(parsed.scene.surfaces.iter().all(|surface| surface.mesh.polygons.is_empty()), "it is still there")
}

fn spike(_: &Effort) -> Outcome {
    let square = [(8.25, 8.25), (40.5, 8.25), (40.5, 40.75), (8.25, 40.75)];
    let spiked = [square[0], square[1], square[2], (55.0, 60.0), square[2], square[3]];
    let choices = [both_sides(), Choices { triangles: true, ..both_sides() }];
    let plain = exactly(&[on_screen(&square, 2.0)], &choices[0])?.0;
    for choices in choices {
        let drawn = exactly(&[on_screen(&spiked, 2.0)], &choices)?.0;
        ensure(drawn.image == plain.image, "the spike changes the picture")?;
    }
    let mut triangles = Vec::new();
    let report = split(&on_screen(&spiked, 2.0), Vec3::NEG_Z, &mut SplitScratch::default(), &mut triangles);
    ensure(triangles.len() == 4 && report.flat == 2, format!("{report:?}, {} triangles", triangles.len()))
}

fn bow_tie(_: &Effort) -> Outcome {
    let outline = on_screen(&[(4.0, 4.0), (60.0, 50.0), (60.0, 4.0), (4.0, 60.0)], 2.0);
    let (drawn, truth) = exactly(std::slice::from_ref(&outline), &both_sides())?;
    // Two triangles that meet at (34.74, 29.25): areas 581 and 861.
    let covered = truth.counts.covered;
    ensure(covered.abs_diff(1442) < 30, format!("{covered} samples of 1442"))?;
    ensure(drawn.list.len() == 1, "it was split")?;
    let split = draw(&made(&[outline]), &Choices { triangles: true, ..both_sides() })?;
    ensure(split.counts.forced_ears > 0, "nothing is flagged")
}

fn spiral(_: &Effort) -> Outcome {
    let arm = |inner: f64| {
        (0..200).map(move |i| {
            let angle = f64::from(i) / 200.0 * 8.0 * PI;
            let radius = 2.0 + inner + f64::from(i) * 0.13;
            (32.0 + cos(angle) * radius, 32.0 + sin(angle) * radius)
        })
    };
    let mut places: Vec<(f64, f64)> = arm(0.0).collect();
    places.extend(arm(2.0).collect::<Vec<_>>().into_iter().rev());
    let outline = on_screen(&places, 2.0);
    let (drawn, _) = exactly(std::slice::from_ref(&outline), &both_sides())?;
    let split = exactly(&[outline], &Choices { triangles: true, ..both_sides() })?.0;
    ensure(split.list.len() == 398 && split.counts.forced_ears == 0, format!("{} triangles", split.list.len()))?;
    ensure(covered(&drawn.list) == covered(&split.list) && covered(&drawn.list) > 500, "other samples when split")
}

fn not_planar(_: &Effort) -> Outcome {
    let text = format!("{VIEW}p 4\n-1 -1 0\n1 -1 0.5\n1 1 0\n-1 1 0.5\n");
    ensure(covered(&picture(&text)?.list) > 100, "not drawn")?;
    noticed(text, "planar").map(|_| ())
}

fn twice(_: &Effort) -> Outcome {
    let outline = vec![Vec3::new(-1.0, -0.9, 2.0), Vec3::new(1.3, -0.4, 3.1), Vec3::new(0.2, 1.4, 2.2)];
    let truth = exactly(&[outline.clone(), outline], &both_sides())?.1;
    let first = truth.owner.iter().flatten().all(|&owner| owner == 0);
    ensure(first && truth.counts.depth_ties == truth.counts.covered && truth.counts.covered > 0, "the second shows")
}

fn coplanar(_: &Effort) -> Outcome {
    let at = |x: f64, y: f64| Vec3::new(x, y, 3.0 + 0.3 * x - 0.2 * y);
    let outlines =
        [vec![at(-1.0, -1.0), at(1.0, -1.0), at(0.0, 1.5)], vec![at(-0.7, 1.0), at(-0.9, -1.3), at(1.4, 0.2)]];
    let scene = made(&outlines);
    let frames: Result<Vec<_>, String> =
        [1, 2, 3].iter().map(|&n| draw(&scene, &Choices { threads: Some(n), ..both_sides() })).collect();
    let frames = frames?;
    exact_list(&frames[0].list)?;
    ensure(frames.iter().all(|frame| frame.image == frames[0].image), "frames differ")
}

fn piercing(_: &Effort) -> Outcome {
    let one = vec![Vec3::new(-1.5, -1.5, 2.0), Vec3::new(1.5, -1.5, 4.0), Vec3::new(0.0, 2.0, 3.0)];
    let other = vec![Vec3::new(-1.5, -1.0, 4.0), Vec3::new(1.5, -1.2, 2.0), Vec3::new(0.1, 2.0, 3.2)];
    let list = exactly(&[one, other], &both_sides())?.0.list;
    let truth = judge(&list, &Rules::TRUE_DEPTH);
    let (wrong, _) = truth.differences(&super::super::agree::owners(&list, &ZBuffer));
    ensure(truth.counts.piercing == 1 && wrong == 0, format!("{wrong} samples on the wrong side"))
}

fn reversed(_: &Effort) -> Outcome {
    let text = "p 3\n-1.6 -1.4 0\n-0.4 1.5 0\n1.2 -1.4 0\n";
    let scene = read(format!("{VIEW}{text}"))?.scene;
    let drawn = draw(&scene, &Choices::default())?;
    ensure(drawn.list.is_empty() && drawn.counts.backfacing == 1, "not culled")?;
    let both = draw(&scene, &Choices { culling: Culling::None, ..Choices::default() })?;
    ensure(covered(&both.list) > 100, "not there with both sides")
}

fn straight_start(_: &Effort) -> Outcome {
    let text = format!("{VIEW}p 4 -1 -1 0 0 -1 0 1 -1 0 1 1 0\n");
    let parsed = noticed(text, "normal is that of the whole outline")?;
    ensure(covered(&draw(&parsed.scene, &Choices::default())?.list) > 50, "not drawn")
}
