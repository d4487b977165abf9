//! The grader: built-in rasterizers pass their labs, planted mistakes are named with small witnesses, results outlive a panic.

use farop::grade::folder::{Pictures, files};
use farop::grade::labs::{self, Aspect};
use farop::grade::paint::paint;
use farop::grade::rubric::Rubric;
use farop::grade::rules::Rules;
use farop::grade::verdict::Cause;
use farop::grade::{InProcess, LABS, Request, Subject, Verdict, grade, mutants, write};
use farop::oracle::exact::{self, Rules as Exact};
use farop::plan::Accepts;
use farop::raster::{PerPolygon, PolygonRasterizer, Rasterizer, Target, Watkins, Wire, ZBuffer};
use farop::screen::{DrawList, Fragment, ScreenPolygon, Shader};

fn graded(lab: &str, rasterizer: &dyn Rasterizer) -> Verdict {
    let lab = labs::find(lab).expect("a lab");
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab, name: "planted".to_string(), seed: 1, points: &points };
    grade(&InProcess(rasterizer), &request, &mut |_| ())
}

fn names(verdict: &Verdict) -> Vec<&'static str> {
    verdict.faults.iter().map(|fault| fault.name).collect()
}

#[test]
fn built_in_rasterizers_pass_the_labs_they_belong_to() {
    for lab in LABS {
        let rasterizers: Vec<(&str, Box<dyn Rasterizer>)> = match lab.name {
            "wire" => vec![("wire", Box::new(PerPolygon(Wire)))],
            "watkins" => vec![("watkins", Box::new(Watkins))],
            _ => vec![("zbuffer", Box::new(ZBuffer)), ("watkins", Box::new(Watkins))],
        };
        for (name, rasterizer) in rasterizers {
            let verdict = graded(lab.name, rasterizer.as_ref());
            assert!(verdict.is_passed() && verdict.faults.is_empty(), "{} {name}\n{}", lab.name, write::text(&verdict));
        }
    }
}

#[test]
fn a_z_buffer_is_no_watkins() {
    let verdict = graded("watkins", &ZBuffer);
    let once = verdict.aspects.iter().find(|aspect| aspect.name == "scan-line order").expect("an aspect");
    assert!(matches!(&once.cause, Some(Cause::Other(words)) if words.contains("z-buffer")), "{:?}", once.cause);
}

#[test]
fn under_the_contract_the_paint_is_the_exact_oracles() {
    for lab in LABS.iter().filter(|lab| lab.name != "wire") {
        for case in lab.aspects.iter().flat_map(|aspect| (aspect.cases)(3)).filter(|case| case.samples == 1) {
            let (painted, list) = (paint(&case, &Rules::default()), case.list(Accepts::AnyPolygon));
            let judged = exact::judge(&list, &Exact::TRUE_DEPTH);
            for (at, owner) in judged.owner.iter().enumerate().filter(|(at, _)| !judged.disputed[*at]) {
                let painted = painted.front[at].map(|face| face as u32);
                assert_eq!(painted, *owner, "{} {} sample {at}", lab.name, case.name);
            }
        }
    }
}

#[test]
fn there_are_mutants_enough_and_each_changes_a_picture() {
    let mutants = mutants::all();
    let mut names: Vec<_> = mutants.iter().map(|mutant| mutant.name).collect();
    names.dedup();
    assert!(names.len() >= 30, "{}", names.len());
    let cases: Vec<_> = LABS.iter().flat_map(|lab| lab.aspects.iter().flat_map(|aspect| (aspect.cases)(1))).collect();
    let right: Vec<_> = cases.iter().map(|case| paint(case, &Rules::default())).collect();
    let changes = |rules: &Rules| cases.iter().zip(&right).any(|(case, right)| paint(case, rules) != *right);
    let number = |mutant: &mutants::Mutant| mutant.with.map(|with| with.1);
    let idle = mutants.iter().filter(|mutant| !changes(&mutant.applied_to(&Rules::default())));
    let idle: Vec<_> = idle.map(|mutant| (mutant.name, number(mutant), mutant.is_plain())).collect();
    assert!(idle.is_empty(), "{idle:?}");
}

/// A z-buffer by half planes, with one mistake. It shares nothing with the grader's rules.
#[derive(Clone, Copy)]
struct Planted {
    center: f64,
    far_wins: bool,
    swaps_channels: bool,
    upside_down: bool,
    inclusive: bool,
    affine: bool,
    panics_after: u32,
}

const RIGHT: Planted = Planted {
    center: 0.5,
    far_wins: false,
    swaps_channels: false,
    upside_down: false,
    inclusive: false,
    affine: false,
    panics_after: u32::MAX,
};

impl Planted {
    fn is_inside(&self, corners: &[(f64, f64); 3], (px, py): (f64, f64)) -> bool {
        let area = edge(corners[0], corners[1], corners[2]);
        (0..3).all(|index| {
            let (mut a, mut b) = (corners[index], corners[(index + 1) % 3]);
            if area < 0.0 {
                (a, b) = (b, a);
            }
            let value = edge(a, b, (px, py));
            let top_left = (a.1 == b.1 && b.0 > a.0) || b.1 < a.1;
            area != 0.0 && (value > 0.0 || (value == 0.0 && (self.inclusive || top_left)))
        })
    }

    fn color(&self, polygon: &ScreenPolygon<'_>, corners: &[(f64, f64); 3], at: (f64, f64)) -> Option<[f32; 3]> {
        let area = edge(corners[0], corners[1], corners[2]);
        let weight = |index: usize| edge(corners[(index + 1) % 3], corners[(index + 2) % 3], at) / area;
        let values = |channel: usize| (0..3).map(|c| weight(c) * polygon.vertex_values(c)[channel]).sum::<f64>() as f32;
        self.affine.then(|| [values(0), values(1), values(2)])
    }
}

fn edge(a: (f64, f64), b: (f64, f64), p: (f64, f64)) -> f64 {
    (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)
}

impl PolygonRasterizer for Planted {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        assert!((target.width() as u32) < self.panics_after, "on purpose");
        let corner = |index: usize| (polygon.vertices()[index].x, polygon.vertices()[index].y);
        let corners = [corner(0), corner(1), corner(2)];
        for y in 0..target.height() {
            for x in 0..target.width() {
                let at = (f64::from(x) + self.center, f64::from(y) + self.center);
                let row = if self.upside_down { target.height() - 1 - y } else { y };
                let (new, old) = (polygon.depth(x, y), target.depth(x, row));
                let is_shown = if self.far_wins { old == 0.0 || new < old } else { new > old };
                if !self.is_inside(&corners, at) || !is_shown {
                    continue;
                }
                let mut fragment = Fragment { y: row, ..shader.fragment(polygon, x, y) };
                if let Some([r, g, b]) = self.color(polygon, &corners, at) {
                    fragment.color = farop::color::Rgb { r, g, b };
                }
                if self.swaps_channels {
                    std::mem::swap(&mut fragment.color.r, &mut fragment.color.b);
                }
                target.put(fragment);
            }
        }
    }

    fn accepts(&self) -> Accepts {
        Accepts::Triangles
    }
}

#[test]
fn a_rasterizer_built_differently_passes() {
    let verdict = graded("gouraud", &PerPolygon(RIGHT));
    assert!(verdict.is_passed(), "{}", write::text(&verdict));
    let verdict = graded("zbuffer", &PerPolygon(RIGHT));
    assert_eq!(names(&verdict), [""; 0]);
    // It walks the whole picture for every polygon, and is told so where the clock can see it: on a busy machine it may not.
    let cost = verdict.aspects.last().expect("an aspect");
    let is_told = |cause: &Cause| matches!(cause, Cause::Other(words) if words.contains("bounds"));
    assert!(cost.cause.as_ref().is_none_or(is_told), "{}", write::text(&verdict));
}

#[test]
fn planted_mistakes_are_named_with_small_witnesses() {
    let planted = [
        ("coverage", "samples at the corner", Planted { center: 0.0, ..RIGHT }),
        ("zbuffer", "far wins", Planted { far_wins: true, ..RIGHT }),
        ("zbuffer", "channels exchanged", Planted { swaps_channels: true, ..RIGHT }),
        ("zbuffer", "upside down", Planted { upside_down: true, ..RIGHT }),
        ("coverage", "every edge is inside", Planted { inclusive: true, ..RIGHT }),
        ("gouraud", "affine interpolation", Planted { affine: true, ..RIGHT }),
    ];
    for (lab, name, rasterizer) in planted {
        let verdict = graded(lab, &PerPolygon(rasterizer));
        let text = write::text(&verdict);
        assert_eq!(names(&verdict), [name], "{text}");
        assert!(!verdict.is_passed(), "{text}");
        let aspect = &verdict.aspects[verdict.faults[0].aspect];
        let witness = aspect.witness.as_ref().unwrap_or_else(|| panic!("{name}: no witness\n{text}"));
        let case = &witness.case;
        assert!(case.faces.len() <= 2 && case.width <= 16 && case.height <= 16, "{name}\n{text}");
        assert!(witness.screen_file().is_ok_and(|text| text.starts_with(b"farop-screen")));
        // Nothing is charged twice.
        let charged = verdict.aspects.iter().filter(|aspect| aspect.earned < aspect.most && aspect.name != "cost");
        assert_eq!(charged.count(), 1, "{text}");
    }
}

#[test]
fn two_mistakes_are_told_apart() {
    let verdict = graded("zbuffer", &PerPolygon(Planted { swaps_channels: true, far_wins: true, ..RIGHT }));
    let mut found = names(&verdict);
    found.sort_unstable();
    assert_eq!(found, ["channels exchanged", "far wins"], "{}", write::text(&verdict));
}

struct Nothing;

impl Rasterizer for Nothing {
    fn draw(&self, _: &DrawList, _: &mut Target<'_>) {}
}

#[test]
fn who_draws_nothing_earns_next_to_nothing() {
    let verdict = graded("zbuffer", &Nothing);
    assert_eq!(names(&verdict), ["nothing drawn"]);
    assert!(verdict.earned() < 0.2 * verdict.most(), "{}", write::text(&verdict));
}

#[test]
fn results_are_written_after_every_picture_and_outlive_a_panic() {
    let rasterizer = PerPolygon(Planted { panics_after: 16, ..RIGHT });
    let lab = labs::find("coverage").expect("a lab");
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab, name: "panics".to_string(), seed: 1, points: &points };
    let mut kept = Vec::new();
    let verdict = grade(&InProcess(&rasterizer), &request, &mut |so_far| kept.push(write::gradescope(so_far)));
    assert!(kept.len() > 30);
    let early = &kept[5]["tests"];
    assert_eq!(early.as_array().map(Vec::len), Some(lab.aspects.len()));
    assert!(early[0]["score"].as_f64().is_some_and(|score| score > 0.0), "{early}");
    let whole = kept.last().expect("results");
    let fields = ["score", "max_score", "name", "number", "output", "status", "output_format", "visibility"];
    assert!(fields.iter().all(|field| !whole["tests"][0][field].is_null()), "{whole}");
    assert!(whole.to_string().contains("on purpose"), "{whole}");
    assert!(verdict.earned() > 0.5 * verdict.most(), "{}", write::text(&verdict));
}

#[test]
fn junit_and_json_are_well_formed() {
    let verdict = graded("zbuffer", &PerPolygon(Planted { far_wins: true, ..RIGHT }));
    let xml = write::junit(&verdict);
    assert_eq!(xml.matches("<testcase").count(), verdict.aspects.len());
    assert_eq!(xml.matches("<failure").count(), xml.matches("</failure>").count());
    assert!(!xml.replace("&lt;", "").contains(" < "), "{xml}");
    let json = write::json(&verdict);
    assert_eq!(json["faults"][0]["name"], "far wins");
    assert_eq!(json["passed"], false);
}

#[test]
fn a_rubric_changes_points_and_knows_the_aspects() {
    let lab = labs::find("zbuffer").expect("a lab");
    let rubric = Rubric::parse("[points]\n\"sample position\" = 20\nties = 0\n", lab).expect("a rubric");
    let of = |name: &str| lab.aspects.iter().find(|aspect| aspect.name == name).map(|aspect| rubric.points(aspect));
    assert_eq!([of("sample position"), of("ties"), of("depth")], [Some(20.0), Some(0.0), Some(15.0)]);
    assert!(Rubric::parse("[points]\ntiles = 3\n", lab).is_err_and(|text| text.contains("no aspect `tiles`")));
    assert!(Rubric::parse("[points]\nties = -3\n", lab).is_err());
}

#[test]
fn pictures_made_elsewhere_get_the_same_verdict_and_damage_has_a_name() {
    let (lab, folder) = (labs::find("zbuffer").expect("a lab"), tempfile::tempdir().expect("a folder"));
    let mut paths = Vec::new();
    for (name, case) in files(lab, 1) {
        let answer = InProcess(&ZBuffer).draw(&case.list(Accepts::AnyPolygon), &case.sheet()).expect("a picture");
        let path = folder.path().join(name + ".ppm");
        let bytes = farop::image::encode_for(&path, &answer.picture).expect("a file");
        std::fs::write(&path, &bytes).expect("written");
        paths.push((path, bytes));
    }
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab, name: "pictures".to_string(), seed: 1, points: &points };
    let judged = || grade(&Pictures::new(folder.path(), lab, 1), &request, &mut |_| ());
    let verdict = judged();
    assert!(verdict.is_passed(), "{}", write::text(&verdict));

    let text_mode =
        paths[0].1.iter().flat_map(|&byte| if byte == b'\n' { vec![b'\r', byte] } else { vec![byte] }).collect();
    let chatty = [b"drawing...\n", paths[1].1.as_slice()].concat();
    let turned = String::from_utf8_lossy(&paths[2].1[..9]).replace("15 10", "10 15").into_bytes();
    let turned = [turned.as_slice(), &paths[2].1[9..]].concat();
    let damages: [(usize, Vec<u8>, &str); 4] = [
        (0, text_mode, "text mode"),
        (1, chatty, "printed first"),
        (2, turned, "exchanged"),
        (4, b"P3\n1 1\n255\n0 0 0\n".to_vec(), "P3"),
    ];
    for (index, bytes, words) in damages {
        std::fs::write(&paths[index].0, bytes).expect("written");
        let text = write::text(&judged());
        assert!(text.contains(words), "{words}\n{text}");
        std::fs::write(&paths[index].0, &paths[index].1).expect("written");
    }
}
