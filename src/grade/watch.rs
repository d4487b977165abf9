//! Watch: what is asked besides the picture: no state, every sample once and in order, no look at the whole screen.

use super::case::{Case, Face};
use super::labs::{Lab, Watch};
use super::paint::paint;
use super::rules::Rules;
use super::subject::Subject;
use super::verdict::{Shot, wrong};
use crate::raster::Order;
use std::time::Instant;

/// In the complaints about fragments outside, about what is kept, and about a list that is reversed.
pub(super) const STRAY: &str = "fragments were put outside";
pub(super) const KEPT: &str = "something is kept between calls";
/// Why nobody who never drew is quick.
pub(super) const NOTHING: &str = "nothing was drawn, so there is no time to measure";
pub(super) const ORDER: &str = "the picture depends on the order";

/// What is wrong with a case besides its pixels.
pub(super) fn complaint(subject: &dyn Subject, shot: &mut Shot, watch: Watch) -> Option<String> {
    let puts = shot.answer.as_ref().ok()?.puts.as_ref();
    let stray = puts.map_or(0, |puts| puts.stray_writes);
    if stray > 0 {
        return Some(format!("{stray} {STRAY} of the picture"));
    }
    match watch {
        Watch::State => kept_state(subject, shot),
        Watch::PutOnce => {
            let case = &shot.case;
            subject.order(&case.list(subject.accepts()), &case.sheet()).as_ref().and_then(out_of_order)
        }
        Watch::Picture | Watch::Cost => None,
    }
}

/// What is not a scan-line algorithm's order, the telling thing first.
fn out_of_order(order: &Order) -> Option<String> {
    let mut words = Vec::new();
    if let Some((x, y)) = order.first_read {
        let reads = order.depth_reads;
        words.push(format!("reads depth: this is a z-buffer ({reads} times, first at ({x}, {y}))"));
    }
    if let Some((x, y)) = order.first_repeat {
        let repeats = order.repeats;
        words.push(format!("puts a sample more than once ({repeats} times, first at ({x}, {y}))"));
    }
    if let Some([(last_x, last_y), (x, y)]) = order.first_step_back {
        let steps = order.steps_back;
        words.push(format!("not in scan-line order ({steps} times, first from ({last_x}, {last_y}) to ({x}, {y}))"));
    }
    (!words.is_empty()).then(|| words.join("; "))
}

/// What a report on `lab` must say when nobody could watch: the picture alone does not show it.
pub(super) fn unseen(subject: &dyn Subject, lab: &Lab) -> Option<String> {
    let aspect = lab.aspects.iter().find(|aspect| aspect.watch == Watch::PutOnce)?;
    (!subject.can_be_watched()).then(|| {
        format!(
            "`{}` was judged by the picture alone: in which order samples are put, and whether depth is read, shows only \
             in a rasterizer that is part of this program",
            aspect.name
        )
    })
}

/// The same list again, and in reverse order: the picture must not know.
fn kept_state(subject: &dyn Subject, shot: &mut Shot) -> Option<String> {
    if !subject.can_draw_anything() {
        return None;
    }
    let first = shot.picture()?;
    let mut turned = shot.case.clone();
    turned.faces.reverse();
    let lists = [&shot.case, &turned].map(|case| case.list(subject.accepts()));
    let mut answers = subject.draw_all(&lists, &shot.case.sheet()).into_iter().map(Result::ok);
    if answers.next()?.is_some_and(|again| again.picture != *first) {
        return Some(format!("drawn twice, the same list gave two pictures: {KEPT}"));
    }
    if !shot.wrong.is_empty() {
        return None;
    }
    let answer = answers.next()??;
    let count = wrong(&answer.picture, &paint(&turned, &Rules::default())).len();
    if count == 0 {
        return None;
    }
    shot.turned = Some((turned, answer.picture));
    Some(format!("with the list reversed, {count} samples are wrong: {ORDER}"))
}

/// Small polygons on a picture, and how much longer one may take on a large picture before it is said.
const POLYGONS: usize = 200;
const RATIO: f64 = 30.0;
/// Side of the larger picture, and seconds for a small polygon below which nothing is said.
const SIDE: u32 = 256;
const NOTICEABLE: f64 = 40e-6;
/// The least time that is believed for a small polygon, in seconds: what a clock says of less is chance.
const LEAST: f64 = 1e-6;
/// Measurements that must all be slow: what other programs do to the time once, they seldom do again.
const MEASUREMENTS: usize = 8;

/// Whether a small polygon costs as much as the picture is large: time for each on 32 x 32 and on 256 x 256.
///
/// Every time is the least of all measurements so far, and the first measurement that is not slow ends it: a rasterizer that
/// looks at the polygon's bounds would have to be interrupted in each.
pub(super) fn cost(subject: &dyn Subject) -> Option<String> {
    if !subject.can_draw_anything() {
        return None;
    }
    let time = |side: u32, count: usize| {
        let face = Face::flat(&[(1.25, 1.25), (3.75, 1.5), (1.5, 3.75)], 0.5, [0.5; 3]);
        let case = Case::new("cost", (side, side), vec![face; count]);
        let (list, sheet) = (case.list(subject.accepts()), case.sheet());
        let start = Instant::now();
        let _ = subject.draw(&list, &sheet);
        start.elapsed().as_secs_f64()
    };
    // One polygon and many, on a small picture and on a large one.
    let mut least = [f64::INFINITY; 4];
    let (mut small, mut large) = (LEAST, LEAST);
    for _ in 0..MEASUREMENTS {
        let now = [time(32, 1), time(32, POLYGONS), time(SIDE, 1), time(SIDE, POLYGONS)];
        let each = |one: f64, many: f64| ((many - one) / (POLYGONS - 1) as f64).max(LEAST);
        if each(now[2], now[3]) <= NOTICEABLE {
            return None;
        }
        least = [0, 1, 2, 3].map(|at: usize| least[at].min(now[at]));
        (small, large) = (each(least[0], least[1]), each(least[2], least[3]));
        if large <= RATIO * small || large <= NOTICEABLE {
            return None;
        }
    }
    Some(format!(
        "a polygon of three samples takes {:.0} microseconds on a picture of {SIDE} x {SIDE} and {:.1} on one of 32 x 32: \
         every sample of the picture is asked; look only at the polygon's bounds",
        large * 1e6,
        small * 1e6
    ))
}
