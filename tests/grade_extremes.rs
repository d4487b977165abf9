//! `--extremes`: the built-in rasterizers pass; numbers that are too short are found, at the size where they end.

use farop::grade::extremes::{Finding, What, kinds, probe, text};
use farop::grade::{InProcess, labs};
use farop::plan::Accepts;
use farop::raster::{PerPolygon, PolygonRasterizer, Rasterizer, Target, Watkins, ZBuffer};
use farop::screen::{DrawList, ScreenPolygon, Shader};

fn found(rasterizer: &dyn Rasterizer, names: &[&str]) -> Vec<Finding> {
    let lab = labs::find("zbuffer").expect("a lab");
    let all = kinds(lab, rasterizer.accepts());
    let wanted = all.iter().filter(|kind| names.is_empty() || names.contains(&kind.name));
    wanted.map(|kind| probe(&InProcess(rasterizer), kind)).collect()
}

#[test]
fn built_in_rasterizers_break_nowhere() {
    for rasterizer in [&ZBuffer as &dyn Rasterizer, &Watkins] {
        let findings = found(rasterizer, &[]);
        assert!(findings.len() > 15);
        assert!(findings.iter().all(|finding| finding.first.is_none()), "{}", text("zbuffer", "x", &findings));
    }
}

/// Edge functions a x + b y + c, in numbers of some kind; triangles only.
struct Edges<N> {
    inside: fn(&[[i64; 2]; 3], [i64; 2]) -> bool,
    kind: std::marker::PhantomData<fn() -> N>,
}

fn edges<N>(inside: fn(&[[i64; 2]; 3], [i64; 2]) -> bool) -> PerPolygon<Edges<N>> {
    PerPolygon(Edges { inside, kind: std::marker::PhantomData })
}

impl<N> PolygonRasterizer for Edges<N> {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let (corners, one) = fixed(polygon);
        let side = |axis: usize, size: i32| {
            let places = || corners.iter().map(|corner| corner[axis]);
            let (low, high) = (places().min().unwrap_or(0) / one, places().max().unwrap_or(0) / one + 1);
            low.max(0) as i32..(high.min(i64::from(size))) as i32
        };
        for y in side(1, target.height()) {
            for x in side(0, target.width()) {
                let center = [x, y].map(|place| i64::from(place) * one + one / 2);
                if (self.inside)(&corners, center) && polygon.depth(x, y) > target.depth(x, y) {
                    target.put(shader.fragment(polygon, x, y));
                }
            }
        }
    }

    fn accepts(&self) -> Accepts {
        Accepts::Triangles
    }
}

/// Corners in half steps of the grid, so that centers are whole on any grid, and how many make a sample.
fn fixed(polygon: &ScreenPolygon<'_>) -> ([[i64; 2]; 3], i64) {
    let one = 2 << polygon.grid().bits;
    let corner = |index: usize| {
        let vertex = &polygon.vertices()[index];
        [vertex.x, vertex.y].map(|place| (place * one as f64) as i64)
    };
    ([0, 1, 2].map(corner), one)
}

/// The three edge functions `a x + b y + c` with the products and sums that `N` has; all of one sign is inside.
macro_rules! inside {
    ($name:ident, $number:ty, $mul:expr, $add:expr, $convert:expr) => {
        fn $name(corners: &[[i64; 2]; 3], at: [i64; 2]) -> bool {
            let (mul, add, convert): (
                fn($number, $number) -> $number,
                fn($number, $number) -> $number,
                fn(i64) -> $number,
            ) = ($mul, $add, $convert);
            let value = |index: usize| {
                let ([ax, ay], [bx, by]) = (corners[index].map(convert), corners[(index + 1) % 3].map(convert));
                let [x, y] = at.map(convert);
                let minus = convert(-1);
                let c = add(mul(ax, by), mul(minus, mul(bx, ay)));
                let by_y = mul(add(bx, mul(minus, ax)), y);
                let by_x = mul(add(ay, mul(minus, by)), x);
                add(add(by_x, by_y), c)
            };
            let zero = convert(0);
            (0..3).all(|index| value(index) > zero) || (0..3).all(|index| value(index) < zero)
        }
    };
}

inside!(exactly, i128, |a, b| a * b, |a, b| a + b, i128::from);
inside!(in_f32, f32, |a, b| a * b, |a, b| a + b, |number| number as f32);
inside!(in_i32, i32, i32::wrapping_mul, i32::wrapping_add, |number| number as i32);

/// Whether any center of a list's triangles is judged otherwise than by whole numbers of 128 digits.
fn differs(list: &DrawList, inside: fn(&[[i64; 2]; 3], [i64; 2]) -> bool) -> bool {
    list.polygons().any(|polygon| {
        let (corners, one) = fixed(&polygon);
        let places = |axis: usize| {
            let all = || corners.iter().map(move |corner| corner[axis]);
            all().min().unwrap_or(0) / one..=all().max().unwrap_or(0) / one
        };
        let centers = places(1).flat_map(|y| places(0).map(move |x| [x, y].map(|place| place * one + one / 2)));
        let (width, height) = (i64::from(list.width) * one, i64::from(list.height) * one);
        centers.filter(|&[x, y]| x < width && y < height).any(|at| inside(&corners, at) != exactly(&corners, at))
    })
}

/// Names of the steps at which numbers of a kind must fail.
fn expected(kind: &str, inside: fn(&[[i64; 2]; 3], [i64; 2]) -> bool) -> Vec<String> {
    let lab = labs::find("coverage").expect("a lab");
    let all = kinds(lab, Accepts::Triangles);
    let kind = all.iter().find(|found| found.name == kind).expect("a kind");
    (kind.steps)().into_iter().filter(|step| differs(&step.list, inside)).map(|step| step.name).collect()
}

#[test]
fn the_same_program_in_long_numbers_breaks_nowhere() {
    let findings =
        found(&edges::<i128>(exactly), &["offset to the right", "size", "sub-pixel bits", "slivers", "1 row"]);
    assert!(findings.iter().all(|finding| finding.first.is_none()), "{}", text("zbuffer", "x", &findings));
}

#[test]
fn edge_functions_in_f32_break_where_f32_ends() {
    for kind in ["offset to the right", "offset down", "sub-pixel bits"] {
        let finding = &found(&edges::<f32>(in_f32), &[kind])[0];
        assert_eq!(finding.wrong, expected(kind, in_f32), "{kind}");
        assert!(!finding.wrong.is_empty() && finding.wrong[0] != finding.tried[0], "{kind}: {:?}", finding.wrong);
        let report = text("zbuffer", "x", std::slice::from_ref(finding));
        assert!(report.contains(&format!("BREAKS  {kind}: from {} on", finding.wrong[0])), "{report}");
    }
}

#[test]
fn edge_functions_in_i32_break_where_they_overflow() {
    for kind in ["size", "width", "sub-pixel bits"] {
        let finding = &found(&edges::<i32>(in_i32), &[kind])[0];
        assert_eq!(finding.wrong, expected(kind, in_i32), "{kind}");
        assert!(!finding.wrong.is_empty() && finding.wrong[0] != finding.tried[0], "{kind}: {:?}", finding.wrong);
    }
}

/// Depth kept in 16 bits.
struct SixteenBits;

impl Rasterizer for SixteenBits {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        let mut coarse = list.clone();
        for plane in &mut coarse.planes {
            // Depths and colors alike; colors are whole levels, so nothing is seen of that.
            let rounded = (plane.c * 65535.0).round() / 65535.0;
            (plane.c, plane.low, plane.high) = (rounded, rounded, rounded);
        }
        ZBuffer.draw(&coarse, target);
    }
}

#[test]
fn depth_in_16_bits_ends_at_16_bits() {
    let findings = found(&SixteenBits, &["depths near each other", "far away", "layers"]);
    // 0.01 is 655.35 steps: the next one is reached as long as a part of 2^-k of them is more than 0.15.
    let first = (1..).find(|&k| (655.35_f64 * (1.0 + 0.5_f64.powi(k))).round() == 655.0).expect("one");
    assert_eq!(findings[0].wrong.first(), Some(&format!("2^-{first}")), "{:?}", findings[0].wrong);
    assert_eq!(findings[1].wrong.first().map(String::as_str), Some("2^-16"), "{:?}", findings[1].wrong);
    assert!(findings[2].first.is_none());
}

/// Right, until there are many polygons; then nothing but a panic.
struct GivesUp;

impl Rasterizer for GivesUp {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        assert!(list.len() <= 1000, "too many polygons");
        ZBuffer.draw(list, target);
    }
}

#[test]
fn a_panic_is_found_and_ends_its_kind_only() {
    let findings = found(&GivesUp, &["number of polygons", "layers"]);
    assert_eq!((findings[0].wrong.as_slice(), findings[0].tried.len()), (["2^10".to_string()].as_slice(), 11));
    let what = findings[0].first.as_ref().map(|first| first.what.clone());
    assert!(matches!(what, Some(What::NoPicture(failure)) if failure.message.contains("too many polygons")));
    assert_eq!(findings[1].wrong, ["2^10"]);
}

#[test]
fn labs_are_asked_what_they_are_about() {
    let names = |lab: &str| kinds(labs::find(lab).expect("a lab"), Accepts::AnyPolygon).len();
    assert_eq!((names("wire"), names("zbuffer") - names("coverage")), (0, 5));
}
