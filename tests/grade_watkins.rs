//! The lab `watkins`: what the picture does not show. Depth is not read, samples are put once and in scan-line order.

use farop::grade::labs::{self, Aspect};
use farop::grade::subject::{Answer, Failure};
use farop::grade::verdict::Cause;
use farop::grade::{InProcess, Request, Subject, Verdict, grade, write};
use farop::plan::Accepts;
use farop::raster::{Rasterizer, Scanline, Target, Watkins, ZBuffer};
use farop::screen::file::Sheet;
use farop::screen::{DrawList, Fragment};
use std::collections::BTreeMap;

fn graded(subject: &dyn Subject) -> Verdict {
    let points = |aspect: &Aspect| f64::from(aspect.points);
    let request = Request { lab: labs::find("watkins").expect("a lab"), name: "x".into(), seed: 1, points: &points };
    grade(subject, &request, &mut |_| ())
}

/// What is said about the order; and whether anything else is wrong.
fn complaint(rasterizer: &dyn Rasterizer) -> (String, bool) {
    let verdict = graded(&InProcess(rasterizer));
    let is_right = |aspect: &farop::grade::verdict::AspectVerdict| aspect.cause.is_none();
    let others = verdict.aspects.iter().filter(|aspect| aspect.name != "scan-line order").all(is_right);
    let aspect = verdict.aspects.iter().find(|aspect| aspect.name == "scan-line order").expect("an aspect");
    match &aspect.cause {
        Some(Cause::Other(words)) => (words.clone(), others),
        None => (String::new(), others),
        other => panic!("{other:?}\n{}", write::text(&verdict)),
    }
}

/// A z-buffer with a memory of its own, which shows its samples at the end in an order of its own.
struct AtTheEnd {
    key: fn(i32, i32) -> i64,
    twice: bool,
}

impl Rasterizer for AtTheEnd {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        let mut front: BTreeMap<(i64, i32, i32), Fragment> = BTreeMap::new();
        for polygon in list.polygons() {
            for (x, y) in (0..target.height()).flat_map(|y| (0..target.width()).map(move |x| (x, y))) {
                if farop::raster::coverage::covers(polygon.vertices(), list.grid, x, y) {
                    let (fragment, place) = (list.shader.fragment(&polygon, x, y), ((self.key)(x, y), x, y));
                    if front.get(&place).is_none_or(|old| fragment.depth > old.depth) {
                        front.insert(place, fragment);
                    }
                }
            }
        }
        for fragment in front.into_values() {
            target.put(fragment);
            if self.twice {
                target.put(fragment);
            }
        }
    }
}

#[test]
fn watkins_reads_no_depth_and_puts_in_order() {
    let verdict = graded(&InProcess(&Watkins));
    assert!(verdict.is_passed() && verdict.notes.is_empty(), "{}", write::text(&verdict));
}

#[test]
fn a_z_buffer_is_called_one() {
    let (words, others) = complaint(&ZBuffer);
    assert!(
        others && words.contains("near first: reads depth: this is a z-buffer (72 times, first at (1, 1))"),
        "{words}"
    );
    // The picture of `scanline` drifts; its order is that of polygons.
    assert!(complaint(&Scanline).0.contains("reads depth: this is a z-buffer"));
}

#[test]
fn the_order_of_samples_is_seen() {
    let rows = |x: i32, y: i32| i64::from(y) * 1000 + i64::from(x);
    assert_eq!(complaint(&AtTheEnd { key: rows, twice: false }), (String::new(), true));
    let (words, others) = complaint(&AtTheEnd { key: rows, twice: true });
    assert!(
        others && words.contains("puts a sample more than once (") && !words.contains("scan-line order"),
        "{words}"
    );
    let from_the_right = |x: i32, y: i32| i64::from(y) * 1000 - i64::from(x);
    let (words, others) = complaint(&AtTheEnd { key: from_the_right, twice: false });
    assert!(others && words.contains("not in scan-line order (") && words.contains("from (6, 1) to (5, 1)"), "{words}");
    let columns = |x: i32, y: i32| i64::from(x) * 1000 + i64::from(y);
    assert!(complaint(&AtTheEnd { key: columns, twice: false }).0.contains("not in scan-line order"));
}

/// Any rasterizer, seen through a door that shows the picture alone.
struct FromOutside;

impl Subject for FromOutside {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        InProcess(&ZBuffer).draw(list, sheet).map(|answer| Answer { puts: None, ..answer })
    }

    fn accepts(&self) -> Accepts {
        Accepts::AnyPolygon
    }
}

#[test]
fn what_cannot_be_seen_from_outside_is_said() {
    let text = write::text(&graded(&FromOutside));
    assert!(text.contains("note: `scan-line order` was judged by the picture alone"), "{text}");
}
