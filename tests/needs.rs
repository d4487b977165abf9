//! What a scene does not need is not done, and doing it all the same changes no byte.

mod support;

use farop::image::Image;
use farop::plan::{Accepts, Choices, ClipPlane, Culling, DepthFormat, Needs, NeedsMode, Plan, Shading, Split};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::render;
use farop::scene::Scene;
use farop::screen::DrawList;
use support::draw;
use support::mixed::Mix;

const SHADINGS: [Shading; 4] = [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wire];

fn rasterizer(shading: Shading) -> &'static dyn Rasterizer {
    if shading == Shading::Wire { &PerPolygon(Wire) } else { &ZBuffer }
}

/// With and without light, transparency, highlights, parts outside and behind; triangles and polygons.
fn mixes() -> Vec<Mix> {
    let plain = Mix { corners: (3, 6), shiny: false, ..Mix::default() };
    vec![
        plain,
        Mix { lights: 0, ..plain },
        Mix { shiny: true, ..plain },
        Mix { transparent: true, shiny: true, distance: (0.5, 9.0), spread: 1.0, ..plain },
        // Small, in the middle: no plane is near.
        Mix { spread: 0.2, distance: (3.0, 9.0), ..plain },
        // Most of it far outside, some behind the eye.
        Mix { spread: 4.0, distance: (-4.0, 9.0), polygons: 80, ..plain },
    ]
}

#[test]
fn full_and_derived_needs_give_the_same_bytes() {
    let mut not_needed = [0; 4];
    for mix in mixes() {
        let scene = mix.scene(80);
        for shading in SHADINGS {
            for culling in [Culling::Back, Culling::Nff, Culling::None] {
                let choices = |needs| Choices { shading, culling, needs, ..Choices::default() };
                let draw = |needs| render(&scene, &choices(needs), Some(rasterizer(shading))).expect("has a view");
                let (derived, full) = (draw(NeedsMode::Derived), draw(NeedsMode::Full));
                assert_eq!(derived.image, full.image, "{shading:?} {culling:?} {mix:?}");
                assert_eq!(derived.puts, full.puts);
                // Full needs carry u and v, too: nothing has a picture, so all of them are 0.
                let unlike = |a: &DrawList, b: &DrawList| a.vertices != b.vertices || a.values != b.values;
                assert!(!unlike(&derived.list, &full.list.without_texture()), "{shading:?} {culling:?} {mix:?}");
                assert_eq!((derived.list.has_texture(), full.list.has_texture()), (false, shading != Shading::Wire));
                // The work that was saved is zero, not little.
                let (needs, work) = (derived.plan.needs, derived.counts.work);
                assert!(needs.light || (work.normals, work.vertices_lit) == (0, 0));
                assert!(needs.specular || work.specular_powers == 0, "{}", work.specular_powers);
                assert!(needs.clip != 0 || work.plane_tests == 0);
                let full_work = full.counts.work;
                let saved = [!needs.light, !needs.specular, needs.clip == 0, !needs.blending];
                (0..4).for_each(|i| not_needed[i] += u32::from(saved[i]));
                assert!(
                    full_work.normals > 0 && full_work.vertices_lit + full_work.specular_powers > 0 || mix.lights == 0
                );
            }
        }
    }
    assert!(not_needed.iter().all(|&count| count >= 9), "{not_needed:?}");
}

/// The picture, and the list it is drawn from, when the plan is told something about its needs.
fn with_needs(scene: &Scene, choices: &Choices, change: impl FnOnce(&mut Needs)) -> Option<(Image, DrawList)> {
    let mut plan = Plan::new(scene, choices, Accepts::AnyPolygon).expect("has a view");
    change(&mut plan.needs);
    let mut list = DrawList::new(0, 0);
    farop::geometry::run(scene, &plan, &mut list);
    let is_whole = list.vertices.iter().all(|vertex| vertex.x.is_finite() && vertex.y.is_finite());
    is_whole.then(|| (draw(&list, rasterizer(choices.shading)).0, list))
}

#[test]
fn a_false_not_needed_changes_the_picture() {
    let mix = Mix { corners: (3, 6), distance: (0.5, 9.0), spread: 1.0, shiny: true, ..Mix::default() };
    let scene = mix.scene(80);
    let gouraud = Choices { culling: Culling::None, ..Choices::default() };
    let honest = with_needs(&scene, &gouraud, |_| ()).expect("finite").0;
    let caught = |name: &str, change: fn(&mut Needs)| {
        let told = with_needs(&scene, &gouraud, change).map(|(image, _)| image);
        assert!(told.as_ref() != Some(&honest), "`{name}` is a lie that nobody notices");
    };
    caught("clip", |needs| needs.clip = 0);
    caught("light", |needs| needs.light = false);
    caught("depth", |needs| needs.depth = false);
    caught("specular", |needs| needs.specular = false);
    caught("split", |needs| needs.split = Split::None);
    // Each plane by itself.
    for plane in [ClipPlane::Left, ClipPlane::Right, ClipPlane::Bottom, ClipPlane::Top] {
        let told = with_needs(&scene, &gouraud, |needs| needs.clip = plane.bit()).map(|(image, _)| image);
        assert!(told.as_ref() != Some(&honest), "{plane:?} is not all");
    }
}

#[test]
fn depth_formats_and_samples_need_the_same() {
    let scene = Mix { corners: (3, 6), distance: (0.5, 9.0), spread: 1.0, ..Mix::default() }.scene(40);
    let mut scene = scene;
    scene.camera.iter_mut().for_each(|camera| camera.yon = Some(8.0));
    for depth in [DepthFormat::F32, DepthFormat::F64, DepthFormat::Int24, DepthFormat::Int16] {
        for samples in [1, 3] {
            let image = |needs| {
                let choices = Choices { depth, samples, needs, ..Choices::default() };
                render(&scene, &choices, Some(&ZBuffer)).expect("has a view").image
            };
            assert_eq!(image(NeedsMode::Derived), image(NeedsMode::Full), "{depth:?}, {samples} samples");
        }
    }
}
