//! Needs change no bit of a picture, what is not needed is not done, and a false "not needed" would be seen.

mod support;

use farop::geometry;
use farop::plan::{Accepts, Choices, ClipPlane, NeedsMode, Plan, Shading};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::{Canvas, draw, render};
use farop::scene::Scene;
use farop::screen::DrawList;
use farop::spd::{Curves, SMALL};
use support::built_in::{built_in, geometry_of};

const SIZE: Option<(u32, u32)> = Some((96, 80));

fn rasterizer(shading: Shading) -> &'static dyn Rasterizer {
    if shading == Shading::Wire { &PerPolygon(Wire) } else { &ZBuffer }
}

#[test]
fn full_and_derived_needs_give_the_same_bytes() {
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        for &shading in Shading::ALL {
            let picture = |needs| {
                let choices = Choices { size: SIZE, shading, needs, ..Choices::default() };
                render(&scene, &choices, Some(rasterizer(shading))).unwrap_or_else(|error| panic!("{error}")).image
            };
            assert!(picture(NeedsMode::Derived) == picture(NeedsMode::Full), "{name}, {}", shading.name());
        }
    }
}

#[test]
fn what_is_not_needed_is_not_done() {
    let teapot = built_in("teapot", 4, Curves::Kept);
    let wire = Choices { shading: Shading::Wire, ..Choices::default() };
    let (list, counts) = geometry_of(&teapot, &wire);
    let work = counts.work;
    assert_eq!((work.normals, work.vertices_lit, work.specular_powers), (0, 0, 0), "wire has no light");
    assert!(list.planes.is_empty() && list.shader.lights.is_empty(), "wire has no depth and no lights");
    let full = Choices { needs: NeedsMode::Full, ..wire };
    assert!(geometry_of(&teapot, &full).1.work.normals > 0, "the counter counts");

    // Ks = 0 everywhere: not one cosine power, at vertices or at samples.
    let gears = built_in("tetra", 3, Curves::Kept);
    for shading in [Shading::Gouraud, Shading::Phong] {
        let choices = Choices { size: SIZE, shading, ..Choices::default() };
        let rendered = render(&gears, &choices, Some(&ZBuffer)).expect("it renders");
        assert_eq!(rendered.counts.work.specular_powers, 0);
        let full = Choices { needs: NeedsMode::Full, ..choices };
        let rendered = render(&gears, &full, Some(&ZBuffer)).expect("it renders");
        assert!(rendered.counts.work.specular_powers > 0, "the counter counts");
    }

    // The eye stands inside the lattice: most of its spheres and rods are never turned into polygons.
    let lattice = built_in("lattice", 3, Curves::Kept);
    let derived = geometry_of(&lattice, &Choices::default()).1.work;
    let full = geometry_of(&lattice, &Choices { needs: NeedsMode::Full, ..Choices::default() }).1.work;
    assert!(derived.shapes_outside > 50, "{} shapes were left out", derived.shapes_outside);
    assert_eq!(full.shapes_outside, 0);
    assert!(derived.shape_vertices < full.shape_vertices / 2, "{} of {}", derived.shape_vertices, full.shape_vertices);
}

/// Draws with a plan somebody has tampered with.
fn tampered(scene: &Scene, choices: &Choices, tamper: impl Fn(&mut Plan)) -> farop::image::Image {
    let mut plan = Plan::new(scene, choices, Accepts::AnyPolygon).expect("a plan");
    tamper(&mut plan);
    let mut list = DrawList::new(0, 0);
    geometry::run(scene, &plan, &mut list);
    draw(&list, Some(&ZBuffer), &Canvas::new(scene, choices)).0
}

#[test]
fn a_false_not_needed_changes_the_picture() {
    let choices = Choices { size: SIZE, ..Choices::default() };
    let teapot = built_in("teapot", 4, Curves::Kept);
    let honest = tampered(&teapot, &choices, |_| ());
    let unclipped = tampered(&teapot, &choices, |plan| plan.needs.clip &= !ClipPlane::Left.bit());
    assert!(honest != unclipped, "leaving out a plane that is crossed must show");

    let gears = built_in("gears", 1, Curves::Kept);
    let honest = tampered(&gears, &choices, |_| ());
    assert!(honest != tampered(&gears, &choices, |plan| plan.needs.blending = false), "leaving out blending must show");

    let balls = built_in("balls", 1, Curves::Patches(2));
    let honest = tampered(&balls, &choices, |_| ());
    assert!(honest != tampered(&balls, &choices, |plan| plan.needs.light = false), "leaving out light must show");
}

#[test]
fn every_need_has_a_reason() {
    for (name, size) in SMALL {
        let scene = built_in(name, size, Curves::Kept);
        let plan = Plan::new(&scene, &Choices::default(), Accepts::AnyPolygon).expect("a plan");
        let rows = plan.explain();
        assert!(rows.len() >= 6 && rows.iter().all(|row| !row.reason.is_empty() && !row.decision.is_empty()), "{name}");
    }
}
