//! Items 88 to 96: trees of objects.

use super::super::random_scenes::{camera, facets, scene, surface};
use super::tools::{SIDE, both_sides, covered, draw, ensure, mask, on_screen};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::math::{Affine3, Mat3, PI, Vec3, cos, sin, unit};
use crate::model::normals_from;
use crate::parse::{ParseOptions, read_sipp};
use crate::plan::Choices;
use crate::scene::{Material, Object, ObjectId, Place, Scene, SurfaceId};

pub(super) const ITEMS: &[Item] = &[
    (88, "100,000 nested objects: walked and dropped", Run(nested)),
    (89, "a million siblings", Run(siblings)),
    (90, "an object within itself: refused", Run(cycle)),
    (91, "children shared 2^60 times: refused by budget", Run(doubling)),
    (92, "a singular matrix: skipped and counted", Run(singular)),
    (93, "a mirroring matrix: outlines and normals turn together", Run(mirroring)),
    (94, "scale (1, 1, 1e-8): normals right to 4 last digits", Run(flat_scale)),
    (95, "10,000 chained rotations: drift below 1e-12", Run(chained)),
    (96, "a perspective row in an object's matrix: refused", Run(perspective_row)),
];

/// The scene language takes matrices of four rows of three; what has a fourth column is refused, perspective or not.
fn perspective_row(_: &Effort) -> Outcome {
    let text = b"shader s phong {} world { cube { size 1 shader s } matrix 1 0 0 0  0 1 0 0  0 0 1 .5  0 0 0 1 }";
    match read_sipp("x.sipp", text, ParseOptions::default()) {
        Ok(_) => Err("it was read".to_string()),
        Err(errors) if errors.to_string().contains("x.sipp:1:") => Ok(()),
        Err(errors) => Err(format!("no place is named: {errors}")),
    }
}

/// Objects of a given placement and children, the first of them the world's; a triangle belongs to the last.
fn tree(objects: Vec<(Affine3, Vec<u32>)>) -> Scene {
    let triangle = on_screen(&[(4.0, 60.0), (60.0, 60.0), (30.0, 4.0)], 2.0);
    let mut scene = scene(camera(SIDE, SIDE), vec![surface(Material::default(), facets(&[triangle]))]);
    let last = objects.len() - 1;
    scene.objects = objects
        .into_iter()
        .enumerate()
        .map(|(number, (parent_from_local, children))| Object {
            name: String::new(),
            parent_from_local,
            surfaces: if number == last { vec![SurfaceId(0)] } else { Vec::new() },
            children: children.into_iter().map(ObjectId).collect(),
            place: Place::default(),
        })
        .collect();
    scene
}

fn nested(_: &Effort) -> Outcome {
    let count = 100_000;
    let objects = (0..count).map(|i| (Affine3::IDENTITY, if i + 1 < count { vec![i + 1] } else { vec![] })).collect();
    let drawn = draw(&tree(objects), &both_sides())?;
    ensure(drawn.counts.objects == u64::from(count) && covered(&drawn.list) > 1000, "the innermost is not drawn")
}

fn siblings(effort: &Effort) -> Outcome {
    let count = effort.count(100_000, 1_000_000) as u32;
    let mut objects = vec![(Affine3::IDENTITY, (1..=count).collect())];
    objects.extend((0..count).map(|_| (Affine3::IDENTITY, vec![])));
    let drawn = draw(&tree(objects), &both_sides())?;
    ensure(drawn.counts.objects == u64::from(count) + 1 && covered(&drawn.list) > 1000, "not all are walked")
}

fn cycle(_: &Effort) -> Outcome {
    let drawn = draw(&tree(vec![(Affine3::IDENTITY, vec![0])]), &both_sides());
    ensure(drawn.is_err_and(|error| error.contains("instances")), "it was drawn")
}

fn doubling(_: &Effort) -> Outcome {
    let objects = (0..60).map(|i| (Affine3::IDENTITY, vec![i + 1, i + 1])).chain([(Affine3::IDENTITY, vec![])]);
    let drawn = draw(&tree(objects.collect()), &both_sides());
    ensure(drawn.is_err_and(|error| error.contains("instances")), "it was drawn")
}

fn singular(_: &Effort) -> Outcome {
    for scale in [Vec3::new(1.0, 1.0, 0.0), Vec3::ZERO, Vec3::new(f64::NAN, 1.0, 1.0)] {
        let drawn = draw(&tree(vec![(Affine3::from_scale(scale), vec![])]), &both_sides())?;
        ensure(drawn.list.is_empty() && drawn.counts.skipped == 1, format!("scale {scale}: not counted"))?;
    }
    Ok(())
}

fn mirroring(_: &Effort) -> Outcome {
    // The triangle mirrored twice by nested objects is the triangle; mirrored once, it is where its mirror image is, front first.
    let mirror = Affine3::from_scale(Vec3::new(-1.0, 1.0, 1.0));
    let plain = draw(&tree(vec![(Affine3::IDENTITY, vec![])]), &Choices::default())?;
    let twice = draw(&tree(vec![(mirror, vec![1]), (mirror, vec![])]), &Choices::default())?;
    ensure(plain.image == twice.image && covered(&plain.list) > 1000, "twice mirrored, another picture")?;
    let once = draw(&tree(vec![(mirror, vec![])]), &Choices::default())?;
    let flipped: Vec<bool> = mask(&once.list).chunks(SIDE as usize).flat_map(|row| row.iter().rev().copied()).collect();
    ensure(flipped == mask(&plain.list), "mirrored, another outline")?;
    ensure(once.counts.backfacing == 0, "mirrored, it faces away")
}

fn flat_scale(_: &Effort) -> Outcome {
    let map = Affine3::from_scale(Vec3::new(1.0, 1.0, 1e-8));
    let matrix = normals_from(&map).ok_or("refused as singular")?;
    for normal in [Vec3::new(0.6, 0.0, 0.8), Vec3::new(1.0, 1.0, 1e-8), Vec3::new(0.0, -0.28, 0.96)] {
        let found = unit(matrix * normal).ok_or("no direction")?;
        // The inverse transpose: divided by the scale.
        let expected = unit(Vec3::new(normal.x, normal.y, normal.z / 1e-8)).ok_or("no direction")?;
        let off = (found - expected).abs().max_element();
        ensure(off <= 4.0 * f64::EPSILON, format!("{found} instead of {expected}"))?;
    }
    Ok(())
}

fn chained(_: &Effort) -> Outcome {
    let count = 10_000;
    let angle = 2.0 * PI / f64::from(count);
    let turn =
        Mat3::from_cols(Vec3::new(cos(angle), sin(angle), 0.0), Vec3::new(-sin(angle), cos(angle), 0.0), Vec3::Z);
    let objects =
        (0..count).map(|i| (Affine3::from_mat3(turn), if i + 1 < count { vec![i + 1] } else { vec![] })).collect();
    let mut last = Affine3::IDENTITY;
    tree(objects).walk(|placed| last = placed.world_from_local).map_err(|error| error.to_string())?;
    let off = last.matrix3 - Mat3::IDENTITY;
    let drift =
        [off.x_axis, off.y_axis, off.z_axis].iter().fold(0.0_f64, |most, axis| most.max(axis.abs().max_element()));
    ensure(drift < 1e-12, format!("{drift:e}"))
}
