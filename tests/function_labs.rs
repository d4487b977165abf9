//! Labs about functions: right ones pass, however built; mistakes as students make them are found and named.

use farop::geometry::clip::{ClipVertex, ClipVolume};
use farop::grade::functions::{FUNCTION_LABS, grade_clip, grade_triangulate};
use farop::grade::labs::{Aspect, Lab};
use farop::grade::{Request, Verdict, write};
use farop::math::Vec3;
use farop::raster::Registry;

fn lab(name: &str) -> &'static Lab {
    FUNCTION_LABS.iter().find(|lab| lab.name == name).expect("a lab")
}

type Polygon = Vec<ClipVertex>;

fn clip_graded(clip: impl Fn(&[ClipVertex], &ClipVolume, usize) -> Polygon + Send + Sync + 'static) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab: lab("clip"), name: "planted".to_string(), seed: 1, points: &points };
    grade_clip(&clip, &request, &mut |_| ())
}

fn split_graded(split: impl Fn(&[Vec3], Vec3) -> Vec<[u32; 3]> + Send + Sync + 'static) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab: lab("triangulate"), name: "planted".to_string(), seed: 1, points: &points };
    grade_triangulate(&split, &request, &mut |_| ())
}

#[test]
fn built_in_functions_pass() {
    let registry = Registry::built_in();
    let points = |aspect: &Aspect| f64::from(aspect.points);
    for seed in [1, 2, 3] {
        let request = |name: &'static str| Request { lab: lab(name), name: name.to_string(), seed, points: &points };
        let clip = &registry.clips()[0];
        let verdict = grade_clip(&*clip.function, &request("clip"), &mut |_| ());
        assert!(verdict.is_passed() && verdict.faults.is_empty(), "{}", write::text(&verdict));
        let split = &registry.triangulations()[0];
        let verdict = grade_triangulate(&*split.function, &request("triangulate"), &mut |_| ());
        assert!(verdict.is_passed() && verdict.faults.is_empty(), "{}", write::text(&verdict));
    }
    assert!(FUNCTION_LABS.iter().all(|lab| lab.aspects.iter().map(|aspect| aspect.points).sum::<u32>() == 100));
}
