//! Items 81 to 87: spheres and cones.

use super::super::random_scenes::{camera, scene, surface};
use super::tools::{VIEW, covered, draw, ensure, noticed, picture, refused};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::math::{PI, Vec3, sin};
use crate::model::segments::sphere_segments;
use crate::plan::Choices;
use crate::scene::{Material, Mesh, Primitive, Shape};

pub(super) const ITEMS: &[Item] = &[
    (81, "a sphere of radius 0: skipped", Run(no_radius)),
    (82, "a negative radius: its inside is visible", Run(inside)),
    (83, "a cone whose ends coincide: a disc", Run(disc)),
    (84, "one negative radius of a cone: refused", Run(|_| refused("c 0 0 0 1 0 0 1 -1", &["x.nff:1:17"]))),
    (85, "a cylinder 1e9 long, 1e-9 thick: drawn", Run(needle)),
    (86, "a sphere around the eye", Run(around_the_eye)),
    (87, "1e6 spheres: segments by the formula", Run(many_spheres)),
];

fn no_radius(_: &Effort) -> Outcome {
    let parsed = noticed(format!("{VIEW}s 0 0 0 0\n"), "radius 0: dropped")?;
    ensure(parsed.scene.surfaces.iter().all(|surface| surface.primitives.is_empty()), "it is still there")
}

fn inside(_: &Effort) -> Outcome {
    let outside = picture(format!("{VIEW}l 0 0 5\ns 0 0 0 1\n"))?;
    let inside = picture(format!("{VIEW}l 0 0 5\ns 0 0 0 -1\n"))?;
    // Seen from outside, the far wall stands where the near one does, and farther away.
    let (near, far) = (covered(&outside.list), covered(&inside.list));
    ensure(near > 100 && near.abs_diff(far) < near / 10, format!("{near} and {far} samples"))?;
    let nearest = |list: &crate::screen::DrawList| list.vertices.iter().fold(f64::MAX, |w, v| w.min(v.homogeneous.z));
    ensure(nearest(&outside.list) < 4.1 && nearest(&inside.list) > 4.5, "the near wall shows")
}

fn disc(_: &Effort) -> Outcome {
    let drawn = picture(format!("{VIEW}l 0 0 5\nc 0 0 0 1 0 0 0 0\n"))?;
    // Radius 1 at distance 5 with 45 degrees over 32 samples: 7.7 samples.
    let expected = std::f64::consts::PI * (16.0 / crate::math::tan(crate::math::radians(22.5)) / 5.0_f64).powi(2);
    let found = covered(&drawn.list) as f64;
    ensure((found / expected - 1.0).abs() < 0.1, format!("{found} samples of {expected}"))
}

fn needle(_: &Effort) -> Outcome {
    let drawn = picture(format!("{VIEW}l 0 0 5\nc -5e8 0 0 1e-9 5e8 0 0 1e-9\n"))?;
    ensure(drawn.counts.tessellated.polygons >= 3, "not made into polygons")?;
    ensure(drawn.list.vertices.iter().all(|vertex| vertex.homogeneous.is_finite()), "a corner is not finite")
}

fn around_the_eye(_: &Effort) -> Outcome {
    let none = picture(format!("{VIEW}l 0 0 5\ns 0 0 5 9\n"))?;
    ensure(covered(&none.list) == 0, "the outside shows from within")?;
    let all = picture(format!("{VIEW}l 0 0 5\ns 0 0 5 -9\n"))?;
    ensure(covered(&all.list) == 32 * 32, format!("{} of 1024 samples", covered(&all.list)))?;
    // The wall passes through the eye.
    let wall = picture(format!("{VIEW}l 0 0 5\ns 0 0 0 -5\n"))?;
    ensure(covered(&wall.list) == 32 * 32, "the wall at the eye has holes")
}

fn many_spheres(effort: &Effort) -> Outcome {
    let side = effort.count(40, 1000).max(20);
    let mut one = surface(Material::default(), Mesh::default());
    for number in 0..side * side {
        let place = |at: u64| (at as f64 + 0.5) / side as f64 * 1.8 - 0.9;
        let center = Vec3::new(place(number % side) * 10.0, place(number / side) * 10.0, -10.0);
        one.primitives.push(Primitive::new(Shape::Sphere { center, radius: 6.0 / side as f64 }, 0, 1));
    }
    let of = scene(camera(512, 512), vec![one]);
    let drawn = draw(&of, &Choices::default())?;
    // In the middle of the picture: radius in pixels at distance 10, 256 pixels a unit of tangent.
    let segments = u64::from(sphere_segments(6.0 / side as f64 / 10.0 * 256.0, 0.25));
    let each = drawn.counts.tessellated.polygons / (side * side);
    // Beside the middle they are seen at a slant and are larger.
    let least = segments * segments / 2;
    ensure(each >= least && each <= 4 * least, format!("{each} polygons a sphere, {least} in the middle"))?;
    // Their discs are a ninth of pi of a square of 460.8 pixels; outlines of few corners lie inside them, and have less.
    let turn = 2.0 * PI / segments as f64;
    let least = 460.8 * 460.8 * PI / 9.0 * sin(turn) / turn * 0.95;
    ensure(covered(&drawn.list) as f64 > least, format!("{} samples, not {least:.0}", covered(&drawn.list)))
}
