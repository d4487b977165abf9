//! The verdict as text: points by aspect, then what is wrong, how much of it, why, and the smallest case that shows it.

use crate::grade::diagnose::Fault;
use crate::grade::verdict::{AspectVerdict, Cause, Verdict};
use crate::grade::witness::Witness;
use std::fmt::Write;

/// All of it.
#[must_use]
pub fn text(verdict: &Verdict) -> String {
    let mut text = format!("{}: {}\n\n", verdict.lab, verdict.subject);
    for aspect in &verdict.aspects {
        let status = status(aspect, verdict);
        let _ =
            writeln!(text, "  {:>5} /{:>3}  {:<16} {status}", points(aspect.earned), points(aspect.most), aspect.name);
    }
    let _ = writeln!(text, "  {:>5} /{:>3}  in all\n", points(verdict.earned()), points(verdict.most()));
    for aspect in verdict.aspects.iter().filter(|aspect| aspect.cause.is_some()) {
        if !matches!(aspect.cause, Some(Cause::FollowsFrom(_))) && !is_accepted(aspect, verdict) {
            text += &aspect_text(aspect, verdict);
            text.push('\n');
        }
    }
    for note in &verdict.notes {
        let _ = writeln!(text, "note: {note}");
    }
    if verdict.is_whole && !verdict.is_passed() {
        let lab = verdict.lab;
        let _ = writeln!(text, "what is asked: docs/labs/{lab}.md   a hint: farop grade {lab} --hint 1, then 2 and 3");
    }
    let _ = writeln!(text, "{:.2} s", verdict.seconds);
    text
}

fn points(points: f64) -> String {
    // One digit behind the point, none where there is nothing to say.
    let text = format!("{points:.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_string()
}

fn is_accepted(aspect: &AspectVerdict, verdict: &Verdict) -> bool {
    matches!(aspect.cause, Some(Cause::Named(fault)) if verdict.faults[fault].is_accepted)
}

fn status(aspect: &AspectVerdict, verdict: &Verdict) -> String {
    match &aspect.cause {
        None if aspect.shots.is_empty() && !verdict.is_whole => "not yet".to_string(),
        None => "right".to_string(),
        Some(Cause::Named(fault)) if verdict.faults[*fault].is_accepted => "another tie rule, accepted".to_string(),
        Some(Cause::Named(fault)) => verdict.faults[*fault].name.to_string(),
        Some(Cause::FollowsFrom(fault)) => format!("follows from: {}", verdict.faults[*fault].name),
        Some(Cause::Unexplained { .. }) => "wrong, unexplained".to_string(),
        Some(Cause::Other(_)) => "wrong".to_string(),
    }
}

/// What is to say about one aspect.
#[must_use]
pub fn aspect_text(aspect: &AspectVerdict, verdict: &Verdict) -> String {
    let mut text = format!("{}: {}\n", aspect.name, aspect.asks);
    let (wrong, judged, unit) = (aspect.wrong(), aspect.judged(), aspect.unit());
    match &aspect.cause {
        None => {}
        Some(Cause::Named(fault)) => text += &named(&verdict.faults[*fault], (wrong, judged), unit),
        Some(Cause::FollowsFrom(fault)) => {
            let _ = writeln!(
                text,
                "  {wrong} of {judged} {unit} are wrong: that follows from \"{}\".",
                verdict.faults[*fault].name
            );
        }
        Some(Cause::Unexplained { closest, explained, next, next_explained }) => {
            let _ = writeln!(
                text,
                "  {wrong} of {judged} samples are wrong, and no single mistake explains them: \"{closest}\" explains {explained}, \
                 \"{next}\" {next_explained}."
            );
        }
        Some(Cause::Other(words)) => {
            let _ = writeln!(text, "  {words}");
        }
    }
    if let Some(witness) = &aspect.witness {
        text += &witness_text(witness);
    }
    text + aspect.answers.as_ref().map_or("", |answers| &answers.witness)
}

fn named(fault: &Fault, (wrong, judged): (usize, usize), unit: &str) -> String {
    format!(
        "  {wrong} of {judged} {unit} are wrong here; one mistake explains {} of {} wrong {unit}: {}\n  why:   {}\n  rule:  {}\n  \
         read:  {}\n",
        fault.explained, fault.total, fault.name, fault.cause, fault.rule, fault.read
    )
}

fn witness_text(witness: &Witness) -> String {
    let case = &witness.case;
    let mut text = format!(
        "  smallest case: {} {}, {} x {} samples; {} wrong, the first at ({}, {}): {} instead of {}\n",
        case.faces.len(),
        if case.faces.len() == 1 { "polygon" } else { "polygons" },
        case.width,
        case.height,
        witness.wrong,
        witness.first.0,
        witness.first.1,
        color(witness.levels.0),
        color(witness.levels.1),
    );
    for face in &case.faces {
        let corners: Vec<_> = face.corners.iter().map(|(x, y)| format!("({x}, {y})")).collect();
        let depths: Vec<f64> = face.corners.iter().map(|&corner| face.inverse_w_at(corner)).collect();
        let depth = if depths.iter().all(|depth| *depth == depths[0]) {
            format!("{}", depths[0])
        } else {
            depths.iter().map(|depth| format!("{depth:.4}")).collect::<Vec<_>>().join(", ")
        };
        let _ = writeln!(text, "    {}  1/w {depth}", corners.join(" "));
    }
    for row in &witness.rows {
        let _ = writeln!(text, "      {row}");
    }
    text += "    # right, . background, ! extra, ? missing, z a polygon behind, ~ another color\n";
    if !case.lines && !witness.edges.is_empty() {
        text += "    edges, and where the center of that sample lies:\n";
        witness.edges.iter().for_each(|edge| text += &format!("      {edge}\n"));
    }
    text
}

fn color([r, g, b]: [u8; 3]) -> String {
    format!("{r},{g},{b}")
}

/// How hidden probes ended, for whoever has their seed: points and names, no picture of them.
#[must_use]
pub fn hidden_text(verdict: &Verdict) -> String {
    let mut text = "hidden probes\n".to_string();
    for aspect in verdict.aspects.iter().filter(|aspect| aspect.most > 0.0) {
        let (earned, most) = (points(aspect.earned), points(aspect.most));
        let _ = writeln!(text, "  {earned:>5} /{most:>5}  {:<16} {}", aspect.name, status(aspect, verdict));
    }
    let _ = writeln!(text, "  {:>5} /{:>5}  in all\n", points(verdict.earned()), points(verdict.most()));
    text
}
