//! Items 39 to 46: coordinates at the ends of what `f64` can say.

use super::super::random_scenes::camera;
use super::tools::{SIDE, VIEW, both_sides, covered, draw, ensure, exact_list, exactly, made, mask, on_screen, read};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::math::Vec3;
use crate::oracle::Vertices;
use crate::oracle::exact::{Rules, covers, judge};
use crate::scene::Camera;
use crate::screen::DrawList;

pub(super) const ITEMS: &[Item] = &[
    (39, "coordinates of 1e30: the picture of 1", Run(|_| scaled(1e30))),
    (40, "coordinates of 1e-30: the picture of 1", Run(|_| scaled(1e-30))),
    (41, "subnormal coordinates: kept, nothing flushed", Run(subnormal)),
    (42, "1e30 and 1e-30 in one polygon: exact or skipped", Run(mixed)),
    (43, "a corner 1e9 pixels off the screen: an exact edge", Run(far_off)),
    (44, "the largest numbers: drawn up to a sixteenth, skipped and counted beyond", Run(largest)),
    (45, "the world 1e8 away with detail 1: at most one step of the grid off", Run(offset_world)),
    (46, "a sliver 1e-7 pixels wide: exact, no crack beside it", Run(sliver)),
];

/// Where the test polygons stand, in samples.
const PLACES: [(f64, f64); 4] = [(5.3, 8.1), (57.9, 3.2), (40.2, 30.0), (25.7, 60.4)];

fn scaled(factor: f64) -> Outcome {
    let plain = exactly(&[on_screen(&PLACES, 4.0)], &both_sides())?.0;
    let outline = on_screen(&PLACES, 4.0).into_iter().map(|corner| corner * factor).collect();
    let mut scene = made(&[outline]);
    scene.camera = Some(Camera { hither: factor, ..camera(SIDE, SIDE) });
    let list = draw(&scene, &both_sides())?.list;
    exact_list(&list)?;
    ensure(mask(&list) == mask(&plain.list), "other samples are covered")
}

fn subnormal(_: &Effort) -> Outcome {
    let scene = read("l 5e-324 -1e-310 2e-308\ns 0 0 0 1")?.scene;
    let position = scene.lights[0].source.position();
    ensure(position == Vec3::new(5e-324, -1e-310, 2e-308), format!("read as {position}"))?;
    // Coordinates that are nothing beside the others change nothing, and are no zero either.
    let plain = on_screen(&PLACES, 4.0);
    let moved: Vec<Vec3> = plain.iter().map(|&corner| corner + Vec3::new(5e-324, 5e-324, 0.0)).collect();
    let masks = [plain, moved].map(|outline| exactly(&[outline], &both_sides()).map(|drawn| mask(&drawn.0.list)));
    ensure(masks[0].is_ok() && masks[0] == masks[1], "another picture")?;
    // A whole scene of them.
    scaled(2.0_f64.powi(-1035))
}

fn mixed(_: &Effort) -> Outcome {
    let outlines = [
        vec![Vec3::new(-1e30, -1e-30, 2.0), Vec3::new(1e30, -1e-30, 2.0), Vec3::new(1e-30, 1e30, 2.0)],
        vec![Vec3::new(-1e-30, 1e-30, 1e30), Vec3::new(1e30, 1e-30, 1e30), Vec3::new(1.0, 1.0, 1.5)],
        vec![Vec3::new(1e-30, 1e-30, 1e-30), Vec3::new(1e30, 1e-30, 1e30), Vec3::new(-1.0, 1.0, 1.5)],
    ];
    for (number, outline) in outlines.into_iter().enumerate() {
        let counts = exactly(&[outline], &both_sides())?.0.counts;
        let told = counts.skipped + counts.clipped + counts.rendered;
        ensure(told == 1, format!("outline {number} is neither drawn, clipped nor counted"))?;
    }
    Ok(())
}

fn far_off(_: &Effort) -> Outcome {
    let places = [(20.25, 70.5), (40.75, 70.5), (1e9 + 0.125, -7e8)];
    let list = exactly(&[on_screen(&places, 2.0)], &both_sides())?.0.list;
    let drawn = mask(&list);
    // The whole triangle, not clipped; the oracle takes corners as they are.
    let mut whole = DrawList::new(SIDE, SIDE);
    whole.push_flat(&places, 1.0, [1.0; 3]);
    let (mut inside, mut wrong) = (0, 0);
    for (at, &covered) in drawn.iter().enumerate() {
        let sample = ((at % SIDE as usize) as i32, (at / SIDE as usize) as i32);
        let truth = covers(&whole.polygon(0), Vertices::Raw, sample) == Some(true);
        inside += u64::from(truth);
        wrong += u64::from(truth != covered && distance(&places, sample) > 1.0 / 256.0);
    }
    ensure(inside > 100 && wrong == 0, format!("{wrong} of {inside} samples wrong by more than a step of the grid"))
}

/// From a sample center to the nearest line of the outline.
fn distance(places: &[(f64, f64)], (x, y): (i32, i32)) -> f64 {
    let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let to_line = |(a, b): (&(f64, f64), &(f64, f64))| {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        (dx * (py - a.1) - dy * (px - a.0)).abs() / (dx * dx + dy * dy).sqrt()
    };
    crate::math::edges(places).map(to_line).fold(f64::MAX, f64::min)
}

fn largest(_: &Effort) -> Outcome {
    scaled(f64::from(f32::MAX) / 16.0)?;
    let sixteenth = f64::MAX / 16.0;
    let outline = vec![Vec3::new(-1.0, -1.0, 2.0), Vec3::new(1.0, -1.0, 2.0), Vec3::new(0.0, sixteenth, 2.0)];
    let drawn = draw(&made(&[outline]), &both_sides())?;
    exact_list(&drawn.list)?;
    let told = drawn.counts.skipped as usize + covered(&drawn.list);
    ensure(told > 0, "a corner at a sixteenth of the largest number: neither drawn nor counted")?;
    let outline = vec![Vec3::new(-f64::MAX, -1.0, 2.0), Vec3::new(f64::MAX, -1.0, 2.0), Vec3::new(0.0, f64::MAX, 2.0)];
    let drawn = draw(&made(&[outline]), &both_sides())?;
    exact_list(&drawn.list)?;
    let told = drawn.counts.skipped as usize + covered(&drawn.list);
    ensure(told > 0, "the largest numbers are neither drawn nor counted")
}

fn offset_world(_: &Effort) -> Outcome {
    let text = |offset: f64| {
        let at = |x: f64, y: f64, z: f64| format!("{} {} {}", x + offset, y - offset, z + offset);
        let corners = [at(-1.625, -1.4375, 0.0), at(1.3125, -1.25, 0.5), at(-0.40625, 1.5, -0.25)].join("\n");
        let view = VIEW.replace("from 0 0 5", &format!("from {}", at(0.0, 0.0, 5.0)));
        format!("{}p 3\n{corners}\n", view.replace("at 0 0 0", &format!("at {}", at(0.0, 0.0, 0.0))))
    };
    let here = draw(&read(text(0.0))?.scene, &both_sides())?.list;
    let there = draw(&read(text(1e8))?.scene, &both_sides())?.list;
    let pairs = here.vertices.iter().zip(&there.vertices);
    let off = pairs.fold(0.0_f64, |most, (a, b)| most.max((a.x - b.x).abs()).max((a.y - b.y).abs()));
    ensure(here.vertices.len() == 3 && there.vertices.len() == 3, "not drawn")?;
    ensure(off <= 1.0 / 256.0, format!("{off} samples off"))
}

fn sliver(_: &Effort) -> Outcome {
    let width = 1e-7;
    for left in [20.0, 20.5, 20.5 - width / 2.0, 31.127] {
        let (a, b) = (left, left + width);
        let strips = [(4.0, a), (a, b), (b, 60.0)]
            .map(|(l, r)| on_screen(&[(l, 4.0), (r, 4.0), (r + 0.3, 60.0), (l + 0.3, 60.0)], 2.0));
        let (drawn, truth) = exactly(&strips, &both_sides())?;
        let whole = exactly(&[on_screen(&[(4.0, 4.0), (60.0, 4.0), (60.3, 60.0), (4.3, 60.0)], 2.0)], &both_sides())?.0;
        ensure(mask(&drawn.list) == mask(&whole.list), "a crack, or a sample too many")?;
        ensure(truth.covering.iter().all(|&count| count <= 1), "a sample covered twice")?;
        let raw = judge(&drawn.list, &Rules::UNSNAPPED);
        ensure(raw.covering.iter().all(|&count| count <= 1), "covered twice before snapping")?;
    }
    Ok(())
}
