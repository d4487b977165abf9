//! The page about a class: its mistakes, ranked, and a table of students with their points.
//!
//! class.json -INDEX-> index.html beside it
//!
//! Names, ids and causes are what others wrote: every one of them is text and escaped. A field that is missing is shown as nothing, because
//! the file may be of a grader of another year.

use super::{page, points};
use crate::image::save;
use maud::{Markup, html};
use serde_json::Value;
use std::path::Path;

/// The page; `link` knows the address of a submission's report, by its key, where there is one.
#[must_use]
pub fn class_index(class: &Value, link: &dyn Fn(&str) -> Option<String>) -> String {
    let (lab, submissions) = (text(class, "lab"), list(class, "submissions"));
    let body = html! {
        header {
            p.lab { "Lab " (lab) }
            h1 { "The class of " (submissions.len()) }
            (summary(&class["points"]))
        }
        (causes(class, link))
        (aspects(class))
        (students(submissions, link))
        footer { p.quiet { "Made from class.json, which has every number of this page." } }
    };
    page(&format!("{lab}: a class of {}", submissions.len()), &body)
}

/// Writes `index.html` beside the `class.json` of `folder`, with links to the reports that are there.
///
/// # Errors
/// In words: what cannot be read, understood or written.
pub fn write_class_index(folder: &Path) -> Result<(), String> {
    let path = folder.join("class.json");
    let bytes = std::fs::read(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let class: Value = serde_json::from_slice(&bytes).map_err(|error| format!("{}: {error}", path.display()))?;
    let report = |key: &str| {
        let addresses = ["report.html", "verdict.json"].map(|name| format!("submissions/{key}/{name}"));
        addresses.into_iter().find(|address| folder.join(address).is_file())
    };
    let page = class_index(&class, &report);
    save::write_whole(&folder.join("index.html"), page.as_bytes()).map_err(|error| error.to_string())
}

fn text<'a>(value: &'a Value, name: &str) -> &'a str {
    value[name].as_str().unwrap_or_default()
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value[name].as_array().map_or(&[], Vec::as_slice)
}

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or(0.0)
}

fn summary(about: &Value) -> Markup {
    let (all, passed) = (number(about, "submissions"), number(about, "passed"));
    let share = if all > 0.0 { passed / all } else { 0.0 };
    html! {
        div.score {
            p.points { strong { (points(passed)) } " of " (points(all)) " have all points" }
            div.bar role="img" aria-label=(format!("{:.0} percent", share * 100.0)) { div style=(format!("width:{:.1}%", share * 100.0)) {} }
            p.quiet {
                "Points: least " (points(number(about, "least"))) ", median " (points(number(about, "median")))
                ", mean " (points(number(about, "mean"))) ", of at most " (points(number(about, "most"))) "."
            }
        }
    }
}

/// What to talk about in the next lecture, first things first.
fn causes(class: &Value, link: &dyn Fn(&str) -> Option<String>) -> Markup {
    let (causes, all) = (list(class, "causes"), list(class, "submissions").len().max(1));
    html! {
        section {
            h2 { "Mistakes, most frequent first" }
            @if causes.is_empty() { p { "There are none." } }
            ol.causes {
                @for cause in causes {
                    @let who = list(cause, "submissions");
                    @let share = 100.0 * who.len() as f64 / all as f64;
                    li.card.bad {
                        div.rank {
                            h3 { (text(cause, "cause")) }
                            p.number { strong { (who.len()) } " of " (all) }
                        }
                        div.bar role="img" aria-label=(format!("{share:.0} percent of the class")) { div.loss style=(format!("width:{share:.1}%")) {} }
                        @if !text(cause, "why").is_empty() { p { (text(cause, "why")) } }
                        @if !text(cause, "rule").is_empty() { p.rule { (text(cause, "rule")) } }
                        p.quiet {
                            (points(number(cause, "points_lost"))) " points lost"
                            @if !text(cause, "aspect").is_empty() { ", in " (text(cause, "aspect")) }
                            @if !text(cause, "read").is_empty() { "; read " code { (text(cause, "read")) } }
                        }
                        details {
                            summary { "Who" }
                            ul { @for key in who.iter().filter_map(Value::as_str) { li { (linked(key, name_of(class, key), link)) } } }
                        }
                    }
                }
            }
        }
    }
}

fn name_of<'a>(class: &'a Value, key: &'a str) -> &'a str {
    let found = list(class, "submissions").iter().find(|submission| text(submission, "key") == key);
    found.map(|submission| text(submission, "name")).filter(|name| !name.is_empty()).unwrap_or(key)
}

fn linked(key: &str, name: &str, link: &dyn Fn(&str) -> Option<String>) -> Markup {
    html! { @match link(key) { Some(address) => { a href=(address) { (name) } }, None => { (name) } } }
}

fn aspects(class: &Value) -> Markup {
    html! {
        section {
            h2 { "Aspects" }
            div.scroll {
                table {
                    thead { tr { th scope="col" { "Aspect" } th.number scope="col" { "Mean" } th.number scope="col" { "Right" } th.number scope="col" { "Wanting" } } }
                    tbody {
                        @for aspect in list(class, "aspects") {
                            tr {
                                th scope="row" { (text(aspect, "name")) }
                                td.number { (points(number(aspect, "mean"))) " / " (points(number(aspect, "most"))) }
                                td.number { (points(number(aspect, "right"))) }
                                td.number { (points(number(aspect, "wanting"))) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn students(submissions: &[Value], link: &dyn Fn(&str) -> Option<String>) -> Markup {
    html! {
        section {
            h2 { "Students" }
            div.scroll {
                table {
                    thead { tr { th scope="col" { "Name" } th scope="col" { "Id" } th.number scope="col" { "Points" } th scope="col" { "Causes" } } }
                    tbody {
                        @for one in submissions {
                            @let causes: Vec<&str> = list(one, "causes").iter().filter_map(Value::as_str).collect();
                            @let name = if text(one, "name").is_empty() { text(one, "key") } else { text(one, "name") };
                            tr {
                                th scope="row" { (linked(text(one, "key"), name, link)) }
                                td { (text(one, "id")) }
                                td.number { (points(number(one, "points"))) " / " (points(number(one, "most"))) }
                                td class=(if one["passed"] == true { "right" } else { "wrong" }) {
                                    @if one["passed"] == true { "right" } @else if causes.is_empty() { (text(one, "status")) } @else { (causes.join(", ")) }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
