//! Skeletons: each lab has one that compiles, draws or returns something, and is found wanting.

use farop::grade::functions::{FUNCTION_LABS, grade_clip, grade_triangulate};
use farop::grade::labs::{Aspect, Lab};
use farop::grade::{InProcess, LABS, Request, Verdict, grade, handout, write};
use farop::raster::Registry;

/// The name of a lab's skeleton.
fn skeleton(lab: &str) -> String {
    if ["zbuffer", "clip", "triangulate"].contains(&lab) { "mine".to_string() } else { format!("my_{lab}") }
}

fn graded(lab: &'static Lab, name: &str, registry: &Registry) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab, name: name.to_string(), seed: 1, points: &points };
    match lab.name {
        "clip" => {
            let clip = registry.clips().iter().find(|entry| entry.name == name).expect("a clip");
            grade_clip(&*clip.function, &request, &mut |_| ())
        }
        "triangulate" => {
            let split = registry.triangulations().iter().find(|entry| entry.name == name).expect("a triangulation");
            grade_triangulate(&*split.function, &request, &mut |_| ())
        }
        _ => {
            let entry = registry.find(name).expect("a rasterizer");
            grade(&InProcess(entry.rasterizer.as_ref()), &request, &mut |_| ())
        }
    }
}

#[test]
fn each_skeleton_draws_something_and_is_found_wanting() {
    let registry = student_rasterizers::registry();
    for lab in LABS {
        let verdict = graded(lab, &skeleton(lab.name), &registry);
        let text = write::text(&verdict);
        assert!(!verdict.is_passed() && verdict.earned() < verdict.most(), "{text}");
        let mut shots = verdict.aspects.iter().flat_map(|aspect| &aspect.shots);
        assert!(shots.all(|shot| shot.answer.is_ok()), "{text}");
        let puts =
            |shot: &farop::grade::verdict::Shot| shot.answer.as_ref().ok().and_then(|answer| answer.puts.clone());
        let first = &verdict.aspects[0].shots[0];
        assert!(puts(first).is_some_and(|puts| puts.puts > 0 && puts.stray_writes == 0), "{text}");
    }
    for (lab, cause) in FUNCTION_LABS.iter().zip(["nothing is cut", "one triangle only"]) {
        let verdict = graded(lab, &skeleton(lab.name), &registry);
        assert_eq!(verdict.faults[0].name, cause, "{}", write::text(&verdict));
        assert!(verdict.earned() > 0.0 && verdict.earned() < 40.0, "{}", write::text(&verdict));
    }
}

#[test]
fn handouts_name_the_skeletons() {
    for lab in LABS.iter().chain(FUNCTION_LABS) {
        let text = handout::handout(lab.name).expect("a handout");
        assert!(text.contains(&format!("-- grade {} -r {}\n", lab.name, skeleton(lab.name))), "{}", lab.name);
        assert!(text.contains(&format!("src/my_{}.rs", lab.name)), "{}", lab.name);
    }
}
