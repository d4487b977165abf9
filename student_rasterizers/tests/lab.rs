//! The lab itself is tested: its pictures are right, its skeleton is found wanting, right rasterizers pass, and every
//! mistake that students make is caught by the probe that is there for it.

use farop::grade::{Finding, Probe, check, probes};
use farop::raster::coverage::covers;
use farop::raster::{PerPolygon, PolygonRasterizer, Target, Wire, ZBuffer};
use farop::screen::{Grid, ScreenPolygon, ScreenVertex, Shader};

/// Whether the center of sample (x, y) is covered: edges at or left of the center that span its row, counted by the sign of a
/// cross product in whole numbers. Shares nothing with the rasterizers.
fn is_covered(corners: &[(f64, f64)], x: usize, y: usize) -> bool {
    let whole = |number: f64| (number * 512.0) as i64;
    let (center_x, center_y) = (whole(x as f64 + 0.5), whole(y as f64 + 0.5));
    let mut crossings = 0;
    for (index, &(ax, ay)) in corners.iter().enumerate() {
        let (bx, by) = corners[(index + 1) % corners.len()];
        let ((ax, ay), (bx, by)) = ((whole(ax), whole(ay)), (whole(bx), whole(by)));
        let ((ax, ay), (bx, by)) = if ay <= by { ((ax, ay), (bx, by)) } else { ((bx, by), (ax, ay)) };
        let spans_row = ay <= center_y && center_y < by;
        let right_of_edge = (center_x - ax) * (by - ay) - (center_y - ay) * (bx - ax);
        crossings += i32::from(spans_row && right_of_edge >= 0);
    }
    crossings % 2 == 1
}

/// What a probe must show at a sample: of the polygons that cover it, the nearest, of equals the first.
fn expected_at(probe: &Probe, x: usize, y: usize) -> char {
    let mut shown = ('.', 0.0);
    for (polygon, symbol) in probe.polygons.iter().zip('1'..) {
        if polygon.depth > shown.1 && is_covered(polygon.corners, x, y) {
            shown = (symbol, polygon.depth);
        }
    }
    shown.0
}

#[test]
fn the_pictures_of_the_probes_follow_from_the_tie_rule() {
    for probe in probes() {
        for (y, row) in probe.expected.iter().enumerate() {
            let computed: String = (0..row.len()).map(|x| expected_at(probe, x, y)).collect();
            assert_eq!(*row, computed, "{}, row {y}", probe.name);
        }
    }
}

#[test]
fn the_skeleton_draws_something_and_is_found_wanting() {
    let registry = student_rasterizers::registry();
    let mine = registry.find("mine").expect("registered");
    let findings = check(mine.rasterizer.as_ref());
    assert!(findings.len() > probes().len() / 2, "{findings:?}");
    let inside = &findings[0];
    assert!(inside.drawn.iter().any(|row| row.contains('1')), "{inside}");
    assert!(findings.iter().all(|finding| !finding.message.contains("outside")), "{findings:?}");
}

#[test]
fn right_rasterizers_pass() {
    let registry = student_rasterizers::registry();
    for name in ["zbuffer", "ten_lines"] {
        let findings = check(registry.find(name).expect("registered").rasterizer.as_ref());
        assert!(findings.is_empty(), "{name}: {}", findings[0]);
    }
    assert!(check(&ZBuffer).is_empty());
    assert!(!check(&PerPolygon(Wire)).is_empty());
}

#[derive(Clone, Copy)]
enum Ties {
    LeftAndTop,
    All,
    None,
}

/// A z-buffer with one mistake.
#[derive(Clone, Copy)]
struct Mistaken {
    /// Moves corners before coverage is asked for.
    corner: fn(f64) -> f64,
    /// Whether the new depth (first) hides the old one.
    hides: fn(f64, f64) -> bool,
    /// Changes the depth that is kept.
    keeps: fn(f64) -> f64,
    /// Drawn beyond the picture's last row and column, or left out there.
    columns_more: i32,
    /// Which centers on the outline belong to the polygon.
    ties: Ties,
    /// Columns from the first to the last edge are filled.
    fills_notches: bool,
    /// Only counterclockwise outlines (on the screen) are drawn.
    one_way: bool,
}

const RIGHT: Mistaken = Mistaken {
    corner: |x| x,
    hides: |new, old| new > old,
    keeps: |depth| depth,
    columns_more: 0,
    ties: Ties::LeftAndTop,
    fills_notches: false,
    one_way: false,
};

impl Mistaken {
    fn is_covered(&self, outline: &[ScreenVertex], (x, y): (i32, i32)) -> bool {
        let at = |x| covers(outline, Grid { bits: 10 }, x, y);
        // An outline moved right and down by less than a grid step covers the centers on its right and lower edges.
        let (right, down) = (2.0 / 1024.0, 1.0 / 1024.0);
        let moved: Vec<_> =
            outline.iter().map(|&corner| ScreenVertex { x: corner.x + right, y: corner.y + down, ..corner }).collect();
        let between = self.fills_notches && (0..x).any(at) && (x..99).any(at);
        let (own, other) = (at(x), covers(&moved, Grid { bits: 10 }, x, y));
        between
            || match self.ties {
                Ties::LeftAndTop => own,
                Ties::All => own || other,
                Ties::None => own && other,
            }
    }
}

impl PolygonRasterizer for Mistaken {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let moved =
            |&corner: &ScreenVertex| ScreenVertex { x: (self.corner)(corner.x), y: (self.corner)(corner.y), ..corner };
        let outline: Vec<_> = polygon.vertices().iter().map(moved).collect();
        let twice_area: f64 = farop::math::edges(&outline).map(|(a, b)| a.x * b.y - b.x * a.y).sum();
        if self.one_way && twice_area < 0.0 {
            return;
        }
        for y in target.row_range() {
            for x in 0..target.width() + self.columns_more {
                let beyond = self.columns_more > 0 && x >= target.width();
                let covered = beyond || self.is_covered(&outline, (x, y));
                if covered && (self.hides)(polygon.depth(x, y), target.depth(x, y)) {
                    let fragment = shader.fragment(polygon, x, y);
                    target.put(farop::screen::Fragment { depth: (self.keeps)(fragment.depth), ..fragment });
                }
            }
        }
    }
}

/// The probes that find `mistake`.
fn found_by(mistake: Mistaken) -> Vec<&'static str> {
    check(&PerPolygon(mistake)).iter().map(|finding: &Finding| finding.probe).collect()
}

#[test]
fn planted_mistakes_are_each_caught() {
    assert_eq!(found_by(RIGHT), [""; 0]);
    let caught = |probe: &str, mistake: Mistaken| {
        let found = found_by(mistake);
        assert!(found.contains(&probe), "{probe}: {found:?}");
    };
    // Sampling at corners is coverage of an outline moved by half a sample.
    caught("inside", Mistaken { corner: |x| x + 0.5, ..RIGHT });
    caught("slanted", Mistaken { corner: f64::round, ..RIGHT });
    caught("slanted", Mistaken { corner: f64::trunc, ..RIGHT });
    caught("on centers", Mistaken { ties: Ties::All, ..RIGHT });
    caught("shared edge", Mistaken { ties: Ties::All, hides: |new, old| new >= old, ..RIGHT });
    caught("fan", Mistaken { ties: Ties::None, ..RIGHT });
    caught("near first", Mistaken { hides: |_, _| true, ..RIGHT });
    caught("far first", Mistaken { hides: |new, old| old == 0.0 || new < old, ..RIGHT });
    caught("three depths", Mistaken { keeps: |_| 0.125, ..RIGHT });
    caught("equal depth", Mistaken { hides: |new, old| new >= old, ..RIGHT });
    caught("either way", Mistaken { one_way: true, ..RIGHT });
    caught("concave", Mistaken { fills_notches: true, ..RIGHT });
    caught("borders", Mistaken { columns_more: -1, ..RIGHT });
    caught("borders", Mistaken { columns_more: 1, ..RIGHT });
    caught("slivers", Mistaken { corner: f64::round, ..RIGHT });
}

#[test]
fn the_ten_lines_of_the_readme_are_the_ten_lines_that_run() {
    let readme = include_str!("../../README.md");
    let source = include_str!("../src/solved_example.rs");
    let start = source.find("use farop").expect("imports");
    let block = readme.split("```rust\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a rust block");
    assert_eq!(block.trim_end(), source[start..].trim_end());
    let body = source.split("target: &mut Target<'_>) {\n").nth(1).expect("a body");
    assert_eq!(body.lines().take_while(|line| *line != "    }").count(), 10);
}

#[test]
fn the_grader_says_what_the_skeleton_does() {
    use farop::grade::{InProcess, Request, grade, labs};
    let registry = student_rasterizers::registry();
    let mine = registry.find("mine").expect("registered");
    let lab = labs::find("zbuffer").expect("a lab");
    let points = |aspect: &labs::Aspect| f64::from(aspect.points);
    let request = Request { lab, name: "mine".to_string(), seed: 1, points: &points };
    let verdict = grade(&InProcess(mine.rasterizer.as_ref()), &request, &mut |_| ());
    assert_eq!(verdict.faults[0].name, "corners only", "{}", farop::grade::write::text(&verdict));
    assert!(!verdict.is_passed() && verdict.earned() < 0.3 * verdict.most(), "{}", verdict.earned());
}
