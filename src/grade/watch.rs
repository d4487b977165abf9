//! Watch: what is asked besides the picture: no state, every sample once, no look at the whole screen.

use super::case::{Case, Face};
use super::labs::Watch;
use super::paint::paint;
use super::rules::Rules;
use super::subject::Subject;
use super::verdict::{Shot, wrong};
use std::time::Instant;

/// What is wrong with a case besides its pixels.
pub(super) fn complaint(subject: &dyn Subject, shot: &Shot, watch: Watch) -> Option<String> {
    let puts = shot.answer.as_ref().ok()?.puts.as_ref();
    let stray = puts.map_or(0, |puts| puts.stray_writes);
    if stray > 0 {
        return Some(format!("{stray} fragments were put outside of the picture"));
    }
    match watch {
        Watch::State => kept_state(subject, shot),
        Watch::PutOnce => {
            let overdraw = puts.map_or(0, |puts| puts.overdraw);
            (overdraw > 0)
                .then(|| format!("{overdraw} fragments were put where one already was: that is a z-buffer's way"))
        }
        Watch::Picture | Watch::Cost => None,
    }
}

/// The same list again, and in reverse order: the picture must not know.
fn kept_state(subject: &dyn Subject, shot: &Shot) -> Option<String> {
    if !subject.can_draw_anything() {
        return None;
    }
    let first = shot.picture()?;
    let draw = |case: &Case| subject.draw(&case.list(subject.accepts()), &case.sheet()).ok();
    if draw(&shot.case).is_some_and(|again| again.picture != *first) {
        return Some("drawn twice, the same list gave two pictures: something is kept between calls".to_string());
    }
    if !shot.wrong.is_empty() {
        return None;
    }
    let mut turned = shot.case.clone();
    turned.faces.reverse();
    let answer = draw(&turned)?;
    let count = wrong(&answer.picture, &paint(&turned, &Rules::default())).len();
    (count > 0).then(|| format!("with the list reversed, {count} samples are wrong: the picture depends on the order"))
}

/// Small polygons on the larger picture, and how much longer that may take before it is said.
const POLYGONS: usize = 60;
/// Side of the larger picture, and seconds for a small polygon below which nothing is said.
const SIDE: u32 = 256;
const NOTICEABLE: f64 = 25e-6;
const RATIO: f64 = 12.0;

/// Whether a small polygon costs as much as the picture is large: time for each on 32 x 32 and on 256 x 256.
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
        start.elapsed()
    };
    // The least of three: other programs only make it longer.
    let least = |side, count| (0..3).map(|_| time(side, count)).min().unwrap_or_default();
    let each = |side| {
        let (many, one) = (least(side, POLYGONS), least(side, 1));
        many.saturating_sub(one).as_secs_f64() / (POLYGONS - 1) as f64
    };
    // Measured twice: what other programs do to the time once, they seldom do again.
    let is_slow = |(small, large): (f64, f64)| large > RATIO * small && large > NOTICEABLE;
    let measured = || Some((each(32), each(SIDE))).filter(|times| is_slow(*times));
    let (small, large) = measured().and_then(|_| measured())?;
    Some(format!(
        "a polygon of three samples takes {:.0} microseconds on a picture of {SIDE} x {SIDE} and {:.1} on one of 32 x 32: \
         every sample of the picture is asked; look only at the polygon's bounds",
        large * 1e6,
        small * 1e6
    ))
}
