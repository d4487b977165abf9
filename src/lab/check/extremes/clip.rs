//! Items 61 to 68: clipping.

use super::super::random_scenes::camera;
use super::tools::{SIDE, both_sides, covered, draw, ensure, exact_list, exactly, made, mask, on_screen};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::math::{Vec3, radians, tan};
use crate::oracle::exact::ExactPicture;
use crate::oracle::ray::trace;
use crate::render::Rendered;
use crate::scene::Camera;
use crate::screen::DrawList;

pub(super) const ITEMS: &[Item] = &[
    (61, "a comb against each plane: no leak, the area exact", Run(combs)),
    (62, "a corner exactly on a plane", Run(corner_on_plane)),
    (63, "an edge within a plane", Run(edge_in_plane)),
    (64, "a polygon around the whole view: every sample once", Run(around_everything)),
    (65, "touching one corner of the picture: 0 or 1 sample, by the rule", Run(touching_corner)),
    (66, "2^20 bridges along a plane", Run(bridges)),
    (67, "a corner at w = 0: drawn", Run(corner_at_zero)),
    (68, "w < 0 everywhere: nothing", Run(all_negative)),
];

/// A comb of ten teeth that point to the right, in samples, from (x, 4).
fn comb(x: f64, length: f64) -> Vec<(f64, f64)> {
    let mut places = vec![(x, 4.0)];
    for tooth in 0..10 {
        let y = 4.0 + 5.5 * f64::from(tooth);
        places.extend([(x + length, y), (x + length, y + 2.75), (x + 2.0, y + 2.75), (x + 2.0, y + 5.5)]);
    }
    places.push((x, 59.0));
    places.dedup();
    places
}

fn combs(_: &Effort) -> Outcome {
    let turned = |places: &[(f64, f64)], turn: u32| -> Vec<(f64, f64)> {
        let side = f64::from(SIDE);
        places
            .iter()
            .map(|&(x, y)| [(x, y), (side - y, x), (side - x, side - y), (y, side - x)][turn as usize])
            .collect()
    };
    for turn in 0..4 {
        // Teeth leave the picture, or the back does.
        for (x, length) in [(30.25, 70.0), (-20.0, 44.75)] {
            let places = turned(&comb(x, length), turn);
            let drawn = exactly(&[on_screen(&places, 2.0)], &both_sides())?.0;
            let mut whole = DrawList::new(SIDE, SIDE);
            whole.push_flat(&places, 1.0, [1.0; 3]);
            ensure(drawn.counts.cut == 1 && mask(&drawn.list) == mask(&whole), format!("side {turn}: another area"))?;
        }
    }
    // Hither and yon cross the teeth where a ray says.
    let tilted: Vec<Vec3> =
        comb(0.0, 60.0).iter().map(|&(x, y)| Vec3::new(y / 40.0 - 0.7, x / 90.0 - 0.5, 0.2 + x / 20.0)).collect();
    let mut scene = made(&[tilted]);
    scene.camera.iter_mut().for_each(|camera| camera.yon = Some(2.5));
    let drawn = draw(&scene, &both_sides())?;
    let truth = trace(&scene, &both_sides()).map_err(|error| error.to_string())?;
    let seen = truth.hits.iter().map(Option::is_some);
    let other = mask(&drawn.list).into_iter().zip(seen).filter(|(drawn, seen)| drawn != seen).count();
    ensure(
        drawn.counts.cut == 1 && covered(&drawn.list) > 100 && other == 0,
        format!("{other} samples differ from rays"),
    )
}

/// An opening whose half has the tangent 1/2, to the last digit: the sides of the picture are then exactly x = +-w/2, y = +-w/2. With 90 degrees
/// they are not quite x = +-w, because no `f64` is a quarter of a turn.
fn exact_view() -> Result<f64, String> {
    let near = 53.130_102_354_155_98_f64.to_bits();
    let angles = (near - 200..near + 200).map(f64::from_bits);
    let exact = |angle: &f64| tan(radians(*angle) / 2.0) == 0.5;
    angles.into_iter().find(exact).ok_or("no angle has that tangent".to_string())
}

/// Draws a polygon of places in samples, under the view of [`exact_view`].
fn exactly_placed(places: &[(f64, f64)], w: f64) -> Result<(Rendered, ExactPicture), String> {
    let outline = on_screen(places, w).into_iter().map(|at| Vec3::new(at.x / 2.0, at.y / 2.0, at.z)).collect();
    let mut scene = made(&[outline]);
    scene.camera = Some(Camera { angle: exact_view()?, ..camera(SIDE, SIDE) });
    let drawn = draw(&scene, &both_sides())?;
    let truth = exact_list(&drawn.list)?;
    Ok((drawn, truth))
}

fn corner_on_plane(_: &Effort) -> Outcome {
    for places in [
        [(0.0, 20.0), (40.0, 10.0), (30.0, 50.0)],
        [(64.0, 20.0), (40.0, 50.0), (30.0, 10.0)],
        [(20.0, 0.0), (40.0, 50.0), (10.0, 40.0)],
        [(20.0, 64.0), (10.0, 10.0), (40.0, 12.0)],
    ] {
        let drawn = exactly_placed(&places, 2.0)?.0;
        ensure(drawn.counts.inside == 1 && drawn.list.vertices.len() == 3, format!("{places:?} was cut"))?;
    }
    let on_hither = vec![Vec3::new(0.0, 0.0, 1.0), Vec3::new(1.0, 0.0, 3.0), Vec3::new(0.0, 1.0, 3.0)];
    ensure(exactly(&[on_hither], &both_sides())?.0.counts.inside == 1, "cut at hither")
}

fn edge_in_plane(_: &Effort) -> Outcome {
    // All four edges in the sides of the picture, the whole in the plane of hither.
    let sides = [(0.0, 0.0), (64.0, 0.0), (64.0, 64.0), (0.0, 64.0)];
    let (drawn, truth) = exactly_placed(&sides, 1.0)?;
    ensure(drawn.counts.inside == 1 && truth.counts.covered == u64::from(SIDE * SIDE), "the whole view, at hither")?;
    let outside = exactly_placed(&[(64.0, 10.0), (90.0, 20.0), (64.0, 50.0)], 2.0)?.0;
    ensure(covered(&outside.list) == 0, "beyond the right side")
}

fn around_everything(_: &Effort) -> Outcome {
    let far = 1e6;
    let outline = [(-far, -far), (far, -far), (far, far), (-far, far)].map(|(x, y)| Vec3::new(x, y, 3.0 + x * 1e-7));
    let (drawn, truth) = exactly(&[outline.to_vec()], &both_sides())?;
    ensure(truth.covering.iter().all(|&count| count == 1) && drawn.list.len() == 1, "not every sample once")
}

fn touching_corner(_: &Effort) -> Outcome {
    for (places, expected) in [
        ([(-8.0, 8.0), (8.0, -8.0), (-20.0, -20.0)], 0),
        ([(-8.0, 9.0), (9.0, -8.0), (-20.0, -20.0)], 0),
        ([(-8.0, 9.5), (9.5, -8.0), (-20.0, -20.0)], 1),
    ] {
        let drawn = exactly(&[on_screen(&places, 2.0)], &both_sides())?.0;
        let count = covered(&drawn.list);
        ensure(count == expected, format!("{places:?}: {count} samples instead of {expected}"))?;
    }
    Ok(())
}

fn bridges(effort: &Effort) -> Outcome {
    let teeth = effort.count(1 << 14, 1 << 20) as usize;
    let mut places = vec![(-9.0, 1.0), (-9.0, 63.0)];
    let step = 62.0 / teeth as f64;
    for tooth in 0..teeth {
        let y = 63.0 - step * tooth as f64;
        places.extend([(32.0, y), (32.0, y - step / 2.0), (-4.0, y - step / 2.0), (-4.0, y - step)]);
    }
    let drawn = draw(&made(&[on_screen(&places, 2.0)]), &both_sides())?;
    // Half of each row is comb: whether a sample is inside depends on the tooth; some are and none beyond x = 32 is.
    let columns = mask(&drawn.list);
    let beyond = columns.iter().enumerate().filter(|&(at, &covered)| covered && at % SIDE as usize >= 32).count();
    ensure(drawn.counts.cut == 1 && beyond == 0, format!("{beyond} samples beyond the teeth"))
}

fn corner_at_zero(_: &Effort) -> Outcome {
    let outline = vec![Vec3::new(-1.0, -1.0, 3.0), Vec3::new(1.0, -1.0, 3.0), Vec3::new(0.0, 1.0, 0.0)];
    let (drawn, truth) = exactly(&[outline], &both_sides())?;
    ensure(drawn.counts.cut == 1 && truth.counts.covered > 100, "not cut, or nothing left")
}

fn all_negative(_: &Effort) -> Outcome {
    let outline = vec![Vec3::new(-1.0, -1.0, -3.0), Vec3::new(1.0, -1.0, -2.0), Vec3::new(0.0, 1.0, -1e30)];
    let drawn = draw(&made(&[outline]), &both_sides())?;
    ensure(drawn.list.is_empty() && drawn.counts.clipped == 1, "something is left")
}
