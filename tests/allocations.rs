//! The geometry stage allocates nothing per polygon, and `fast` nothing per polygon, tile or sample: a counting allocator, in a test binary of its own.

#![allow(unsafe_code, reason = "an allocator cannot be written without; this one only counts and passes on")]

mod support;

use farop::geometry::Stage;
use farop::image::Image;
use farop::math::Vec3;
use farop::plan::{Accepts, Choices, Plan, Shading};
use farop::raster::fast::Fast;
use farop::render::{Canvas, draw_pixels};
use farop::scene::{Primitive, Scene, Shape};
use farop::screen::DrawList;
use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicU64, Ordering};
use support::mixed::Mix;

struct Counting;

static ALLOCATIONS: AtomicU64 = AtomicU64::new(0);

// SAFETY: every call goes on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the caller's promise is the system's.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        ALLOCATIONS.fetch_add(1, Ordering::Relaxed);
        // SAFETY: as above.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of the second run over a list that the first run has warmed; polygons with 4 to 6 corners, a third cut.
fn second_run(polygons: usize, choices: &Choices) -> u64 {
    let mix = Mix { polygons, corners: (4, 6), distance: (0.5, 9.0), spread: 1.0, transparent: true, ..Mix::default() };
    let scene = mix.scene(64);
    let plan = Plan::new(&scene, choices, Accepts::AnyPolygon).expect("has a view");
    let mut list = DrawList::new(0, 0);
    let counts = farop::geometry::run(&scene, &plan, &mut list);
    assert!(counts.cut * 8 > polygons as u64 && counts.polygons == polygons as u64, "{counts:?}");
    let before = ALLOCATIONS.load(Ordering::Relaxed);
    farop::geometry::run(&scene, &plan, &mut list);
    ALLOCATIONS.load(Ordering::Relaxed) - before
}

/// Allocations of frames that a stage makes after its first two, while the camera moves through polygons with shared vertices and shapes.
fn later_frames(choices: &Choices) -> u64 {
    let mix = Mix { polygons: 2000, corners: (3, 6), distance: (0.5, 9.0), spread: 1.0, ..Mix::default() };
    let mut scene = mix.scene(64);
    let sphere = Shape::Sphere { center: Vec3::NEG_Z * 3.0, radius: 0.5 };
    scene.surfaces[1].primitives.push(Primitive::new(sphere, 100, 1));
    let walk = |scene: &mut Scene, step: u32| {
        let camera = scene.camera.as_mut().expect("has one");
        // To and fro, so that the first two frames are the largest there will be.
        camera.from.x = [0.0, 0.25][step as usize % 2];
        Plan::new(scene, choices, Accepts::AnyPolygon).expect("has a view")
    };
    let (mut stage, mut list, mut allocations) = (Stage::default(), DrawList::new(0, 0), 0);
    for step in 0..6 {
        let plan = walk(&mut scene, step);
        let before = ALLOCATIONS.load(Ordering::Relaxed);
        let counts = stage.run(&scene, &plan, &mut list);
        assert!(counts.cut > 200 && counts.tessellated.rendered > 10, "{counts:?}");
        allocations += if step < 2 { 0 } else { ALLOCATIONS.load(Ordering::Relaxed) - before };
    }
    allocations
}

/// Allocations of the third picture that `fast` draws of one list; the first two have warmed its memory.
fn third_picture(polygons: usize, side: u32, threads: u32) -> u64 {
    let mix = Mix { polygons, corners: (3, 6), ..Mix::default() };
    let scene = mix.scene(side);
    let choices = Choices { threads: Some(threads), shading: Shading::Phong, ..Choices::default() };
    let (fast, canvas) = (Fast::default(), Canvas::new(&scene, &choices));
    let list = farop::render::list(&scene, &choices, Some(&fast)).expect("has a view");
    let mut image = Image::new(side as usize, side as usize, canvas.background);
    let mut allocations = 0;
    for _ in 0..3 {
        let before = ALLOCATIONS.load(Ordering::Relaxed);
        draw_pixels(&list, &fast, &canvas, &mut image).expect("fast draws pixels");
        allocations = ALLOCATIONS.load(Ordering::Relaxed) - before;
    }
    allocations
}

fn pictures_of_fast_allocate_nothing_for_what_is_in_them() {
    // One for the locks of the picture's bands and those for the counts by name; a thread costs a few more to start, twice a picture.
    let alone = [(10, 64), (300, 64), (300, 500)].map(|(polygons, side)| third_picture(polygons, side, 1));
    println!("fast on one thread: {alone:?} allocations");
    assert!(alone.iter().all(|&count| count <= 4), "{alone:?}");
    let [few, many] = [10, 300].map(|polygons| third_picture(polygons, 200, 2));
    println!("fast on two threads: {few} and {many} allocations");
    assert!(few.max(many) <= 40, "{few} {many}");
}

/// One test: others would run beside it and be counted.
#[test]
fn nothing_is_allocated_per_polygon() {
    pictures_of_fast_allocate_nothing_for_what_is_in_them();
    for shading in [Shading::Gouraud, Shading::Phong, Shading::Flat, Shading::Wire] {
        for triangles in [false, true] {
            let choices = Choices { shading, triangles, threads: Some(1), ..Choices::default() };
            let [few, many] = [100, 10_000].map(|polygons| second_run(polygons, &choices));
            println!("{shading:?}, triangles {triangles}: {few} and {many} allocations");
            // Buffers that grow to the largest polygon may double once more among many.
            assert!(many <= few + 8 && many < 80, "{shading:?}: {few} for 100 polygons, {many} for 10,000");
            assert_eq!(later_frames(&choices), 0, "{shading:?}: a stage that has its memory takes no more");
        }
    }
}
