//! One aspect on the page: what, how many, why, where; its pictures; its smallest case.

use super::data::Atlas;
use super::{Extent, anchor, points, shot, witness};
use crate::grade::verdict::{AspectVerdict, Cause, Shot, Verdict};
use maud::{Markup, html};

/// The class of a verdict, and its words.
pub(super) fn status(aspect: &AspectVerdict, verdict: &Verdict) -> (&'static str, String) {
    match &aspect.cause {
        None if aspect.shots.is_empty() && aspect.answers.is_none() && !verdict.is_whole => {
            ("quiet", "not yet".to_string())
        }
        None => ("right", "right".to_string()),
        Some(Cause::Named(fault)) if verdict.faults[*fault].is_accepted => {
            ("right", "another tie rule, accepted".to_string())
        }
        Some(Cause::Named(fault)) => ("wrong", verdict.faults[*fault].name.to_string()),
        Some(Cause::FollowsFrom(fault)) => ("follows", format!("follows from: {}", verdict.faults[*fault].name)),
        Some(Cause::Unexplained { .. }) => ("wrong", "wrong, unexplained".to_string()),
        Some(Cause::Other(_)) => ("wrong", "wrong".to_string()),
    }
}

/// The section of an aspect that has a cause.
pub(super) fn section(aspect: &AspectVerdict, verdict: &Verdict, atlas: &mut Atlas) -> Markup {
    let (class, words) = status(aspect, verdict);
    html! {
        section.aspect id=(anchor(aspect.name)) {
            h2 { (aspect.name) }
            p { span class=(format!("badge {class}")) { (words) } " " span.quiet { (points(aspect.earned)) " of " (points(aspect.most)) " points" } }
            dl {
                dt { "What" } dd { (aspect.asks) }
                dt { "How many" } dd { (how_many(aspect)) }
                dt { "Why" } dd { (why(aspect, verdict)) }
                @if let Some(place) = first_place(aspect) { dt { "Where" } dd { (place) } }
            }
            (pictures(aspect, atlas))
            @if let Some(answers) = &aspect.answers {
                @if !answers.witness.is_empty() { h3 { "The smallest case" } pre { (answers.witness) } }
            }
            @if let Some(found) = &aspect.witness { (witness::panel(found, aspect.name)) }
        }
    }
}

fn how_many(aspect: &AspectVerdict) -> Markup {
    let (wrong, judged, unit) = (aspect.wrong(), aspect.judged(), aspect.unit());
    let failing = aspect.shots.iter().filter(|shot| !shot.is_right()).count();
    html! {
        strong { (wrong) } " of " (judged) " " (unit)
        @if !aspect.shots.is_empty() { ", in " (failing) " of " (aspect.shots.len()) " pictures" }
    }
}

fn why(aspect: &AspectVerdict, verdict: &Verdict) -> Markup {
    match &aspect.cause {
        None => html! {},
        Some(Cause::Named(fault)) => {
            let fault = &verdict.faults[*fault];
            html! { (fault.cause) " " span.rule { (fault.rule) } }
        }
        Some(Cause::FollowsFrom(fault)) => {
            html! { "That follows from \"" (verdict.faults[*fault].name) "\" and costs nothing more where nothing else is wrong." }
        }
        Some(Cause::Unexplained { closest, explained, next, next_explained }) => html! {
            "No single mistake explains them: \"" (closest) "\" explains " (explained) ", \"" (next) "\" " (next_explained) "."
        },
        Some(Cause::Other(words)) => html! { span.said { (words) } },
    }
}

/// The first wrong pixel, in words.
fn first_place(aspect: &AspectVerdict) -> Option<Markup> {
    let shot = aspect.shots.iter().find(|shot| !shot.wrong.is_empty())?;
    let (picture, right) = (shot.picture()?, crate::grade::pictures::right(&shot.case));
    let (x, y) = shot::place(shot, shot.wrong[0]);
    Some(html! {
        "first at pixel (" (x) ", " (y) ") of \"" (shot.case.name) "\": "
        (shot::level(picture.pixel(x, y))) " instead of " (shot::level(right.pixel(x, y)))
    })
}

fn pictures(aspect: &AspectVerdict, atlas: &mut Atlas) -> Markup {
    let failing: Vec<&Shot> = aspect.shots.iter().filter(|shot| !shot.is_right()).collect();
    let most = match atlas.extent() {
        Extent::All | Extent::Wrong => usize::MAX,
        Extent::Few => 4,
        Extent::One => 1,
    };
    let left_out = failing.len().saturating_sub(most);
    // What follows from another mistake is there to be looked at, and does not stand in the way.
    let open = if matches!(aspect.cause, Some(Cause::FollowsFrom(_))) { 0 } else { 2 };
    let figures: Vec<Markup> = failing.iter().take(most).map(|shot| shot::figure(shot, atlas)).collect();
    let (first, more) = figures.split_at(open.min(figures.len()));
    html! {
        @for figure in first { (figure) }
        @if !more.is_empty() {
            details {
                summary { (more.len()) @if open > 0 { " more" } @if more.len() == 1 { " picture that is wrong" } @else { " pictures that are wrong" } }
                @for figure in more { (figure) }
            }
        }
        @if left_out > 0 { p.quiet { (left_out) " more are left out: the page would be too large." } }
    }
}
