//! HTML: a grade as one page that needs no network, for eyes.
//!
//! [`Results`] -REPORT-> page: points, mistakes, pictures, an inspector for any pixel
//!
//! Why one file: it is mailed, put on a course's site, opened from a folder. Pictures are PNGs inside the text; a policy in the head
//! forbids every request. Why readable without scripts: the pictures, the first wrong pixel under the lens and all words are plain
//! HTML; the script adds only that any other pixel can be asked.
//!
//! What students name or print is text between tags and never a tag: `maud` escapes it, and data for the script is written
//! without `<`. What is hidden from students (see [`Results`]) is not in the page at all.
//!
//! Space: pixels and samples of the small pictures, x right, y down.
//! Cost: the size of its pictures; pages larger than [`MOST_BYTES`] leave out inspector data, right pictures first.

mod aspect;
mod class;
mod data;
mod lens;
mod page;
mod sheet;
mod shot;
mod witness;

pub use class::{class_index, write_class_index};
pub use page::page;
pub use sheet::{RULES, sheet};

use super::handout;
use super::rubric::Visibility;
use super::verdict::{AspectVerdict, Cause, Verdict};
use super::write::Results;
use data::Atlas;
use maud::{Markup, PreEscaped, html};

/// Bytes of a page that mail and platforms still take.
pub const MOST_BYTES: usize = 950_000;

/// How much of a grade the page holds, most first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    /// Every picture can be asked about.
    All,
    /// Wrong ones can.
    Wrong,
    /// Four wrong ones of an aspect; the others are counted.
    Few,
    /// One of an aspect.
    One,
}

/// The whole page.
#[must_use]
pub fn report<'a>(results: impl Into<Results<'a>>) -> String {
    let results: Results<'a> = results.into();
    let mut text = String::new();
    // The last one is taken whatever its size.
    for extent in [Extent::All, Extent::Wrong, Extent::Few, Extent::One] {
        text = with_extent(&results, extent);
        if text.len() <= MOST_BYTES {
            break;
        }
    }
    text
}

fn with_extent(results: &Results<'_>, extent: Extent) -> String {
    let verdict = results.visible;
    let mut atlas = Atlas::new(extent);
    let shown = |aspect: &&AspectVerdict| is_shown(results, aspect.name) && aspect.cause.is_some();
    let aspects: Vec<Markup> =
        verdict.aspects.iter().filter(shown).map(|aspect| aspect::section(aspect, verdict, &mut atlas)).collect();
    let right = right_pictures(results, &mut atlas);
    let body = html! {
        (head(results))
        (mistakes(results))
        (table(results))
        (hidden(results))
        @for aspect in &aspects { (aspect) }
        (right)
        (hints(verdict))
        (foot(results))
        (atlas.script())
    };
    page(&format!("{}: {}", verdict.lab, verdict.subject), &body)
}

/// Whether students see an aspect at once; what they see later, or never, is not in the page.
fn is_shown(results: &Results<'_>, aspect: &str) -> bool {
    results.rubric.is_none_or(|rubric| rubric.visibility(aspect) == Visibility::Visible)
}

/// Points as people write them.
pub(super) fn points(points: f64) -> String {
    let text = format!("{points:.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_string()
}

/// A name that can stand in an address.
pub(super) fn anchor(name: &str) -> String {
    name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '-' }).collect()
}

fn head(results: &Results<'_>) -> Markup {
    let verdict = results.visible;
    let aspects = || verdict.aspects.iter().filter(|aspect| is_shown(results, aspect.name));
    let (earned, most) =
        aspects().fold((0.0, 0.0), |(earned, most), aspect| (earned + aspect.earned, most + aspect.most));
    let share = if most > 0.0 { earned / most } else { 1.0 };
    html! {
        header {
            p.lab { "Lab " (verdict.lab) }
            h1 { (verdict.subject) }
            div.score {
                p.points { strong { (points(earned)) } " of " (points(most)) " points" }
                div.bar role="img" aria-label=(format!("{:.0} percent", share * 100.0)) {
                    div style=(format!("width:{:.1}%", share * 100.0)) {}
                }
            }
            @if let Some(reason) = results.refused {
                div.card.bad { h2 { "Nothing could be graded" } pre { (reason) } }
            } @else if !results.is_whole() {
                p.note { "The grader was stopped before its end; what was earned until then counts." }
            }
            @for note in &verdict.notes { p.note { (note) } }
        }
    }
}

/// The mistakes that have a name, in one place.
fn mistakes(results: &Results<'_>) -> Markup {
    let verdict = results.visible;
    let named = |fault: &&super::Fault| {
        !fault.is_accepted && verdict.aspects.get(fault.aspect).is_some_and(|aspect| is_shown(results, aspect.name))
    };
    let faults: Vec<_> = verdict.faults.iter().filter(named).collect();
    let unexplained = verdict
        .aspects
        .iter()
        .filter(|aspect| is_shown(results, aspect.name))
        .any(|aspect| matches!(aspect.cause, Some(Cause::Unexplained { .. } | Cause::Other(_))));
    html! {
        @if faults.is_empty() && !unexplained && verdict.is_whole && results.refused.is_none() {
            section.card.good { h2 { "Nothing is wrong" } p { "Every picture is right, to the pixel." } }
        }
        @for fault in &faults {
            section.card.bad {
                h2 { (fault.name) }
                p.lead { (fault.cause) }
                dl {
                    dt { "How many" } dd { "It explains " strong { (fault.explained) } " of " (fault.total) " wrong answers." }
                    dt { "The rule" } dd { (fault.rule) }
                    @if let Some(aspect) = verdict.aspects.get(fault.aspect) {
                        dt { "Where" } dd { a href=(format!("#{}", anchor(aspect.name))) { (aspect.name) } ", and read " code { (fault.read) } }
                    }
                }
            }
        }
    }
}

fn table(results: &Results<'_>) -> Markup {
    let verdict = results.visible;
    html! {
        section {
            h2 { "Points" }
            div.scroll {
                table {
                    thead { tr { th scope="col" { "Aspect" } th.wide scope="col" { "What is asked" } th.number scope="col" { "Points" } th scope="col" { "Verdict" } } }
                    tbody {
                        @for aspect in &verdict.aspects {
                            @if is_shown(results, aspect.name) { (row(aspect, verdict)) }
                            @else { tr { th scope="row" { (aspect.name) } td.wide { (aspect.asks) } td.number { "–" } td.quiet { "shown later" } } }
                        }
                    }
                }
            }
        }
    }
}

fn row(aspect: &AspectVerdict, verdict: &Verdict) -> Markup {
    let (class, words) = aspect::status(aspect, verdict);
    html! {
        tr {
            th scope="row" {
                @if aspect.cause.is_some() { a href=(format!("#{}", anchor(aspect.name))) { (aspect.name) } } @else { (aspect.name) }
            }
            td.wide { (aspect.asks) }
            td.number { (points(aspect.earned)) " / " (points(aspect.most)) }
            td class=(class) { (words) }
        }
    }
}

/// How hidden probes ended, where students see that at once: counts.
fn hidden(results: &Results<'_>) -> Markup {
    let Some(hidden) = results.hidden else { return html! {} };
    let is_shown = results.rubric.is_some_and(|rubric| rubric.hidden().visibility == Visibility::Visible);
    html! {
        section {
            h2 { "Hidden probes" }
            @if is_shown {
                p { strong { (points(hidden.earned())) } " of " (points(hidden.most())) " points by pictures that are not handed out." }
            } @else {
                p { "There are more points by pictures that are not handed out." }
            }
        }
    }
}

fn right_pictures(results: &Results<'_>, atlas: &mut Atlas) -> Markup {
    let aspects = results.visible.aspects.iter().filter(|aspect| is_shown(results, aspect.name));
    let shots: Vec<_> =
        aspects.flat_map(|aspect| &aspect.shots).filter(|shot| shot.is_right() && shot.picture().is_some()).collect();
    html! {
        @if !shots.is_empty() {
            section {
                details {
                    summary { (shots.len()) " pictures are right" }
                    div.thumbs { @for shot in shots { (shot::thumb(shot, atlas)) } }
                }
            }
        }
    }
}

fn hints(verdict: &Verdict) -> Markup {
    let hints: Vec<_> = (1..=handout::HINTS).filter_map(|number| handout::hint(verdict.lab, number)).collect();
    let titles = ["Hint 1: a question", "Hint 2: the idea", "Hint 3: nearly the code"];
    html! {
        @if verdict.is_whole && !verdict.is_passed() && !hints.is_empty() {
            section {
                h2 { "Hints" }
                p.quiet { "Open one at a time, and try before you open the next." }
                @for (title, hint) in titles.iter().zip(hints) { details { summary { (title) } pre.words { (hint) } } }
            }
        }
    }
}

fn foot(results: &Results<'_>) -> Markup {
    let verdict = results.visible;
    html! {
        footer {
            p { "The same at home: " code { "farop grade " (verdict.lab) " -r " (verdict.subject) } }
            @if !results.layers.is_empty() { p.quiet { "The submission was held by: " (results.layers.join(", ")) "." } }
            p.quiet { "Every pixel is held against exact arithmetic. Where two levels are both honest, both are right." }
        }
    }
}

/// The bytes of a picture, red, green and blue of each pixel, for the script.
pub(super) fn pictures_base64(picture: &crate::image::Picture) -> String {
    super::write::base64(picture.rgb())
}

/// Text of the project itself, as it is.
pub(super) fn plain(text: &str) -> PreEscaped<&str> {
    PreEscaped(text)
}
