//! What was found, in words and as JSON.

use super::{Break, Finding, Shown, What};
use crate::screen::DrawList;
use serde_json::{Value, json};
use std::fmt::{self, Write};

/// All findings as text: one line a kind, and below it what is known of the first step that is wrong.
#[must_use]
pub fn text(lab: &str, subject: &str, findings: &[Finding]) -> String {
    let mut text = format!("{lab}, pushed to extremes: {subject}\n\n");
    for finding in findings {
        // Writing to a String cannot fail.
        let _ = line(finding, &mut text);
    }
    let broken = findings.iter().filter(|finding| finding.first.is_some()).count();
    let _ = writeln!(text, "\n{broken} of {} kinds break", findings.len());
    text
}

fn line(finding: &Finding, text: &mut String) -> fmt::Result {
    let ends = [finding.tried.first(), finding.tried.last()].map(|name| name.map_or("", String::as_str));
    let Some(first) = &finding.first else {
        return writeln!(text, "  right   {}: {} to {}", finding.kind, ends[0], ends[1]);
    };
    writeln!(text, "  BREAKS  {}: from {} on ({})", finding.kind, first.step.name, finding.draws)?;
    writeln!(text, "          {}", first.what)?;
    writeln!(text, "          {}", lasting(finding))?;
    if let (What::Wrong { .. }, Some(digits)) = (&first.what, Digits::of(&first.step.list)) {
        writeln!(text, "          {digits}")?;
    }
    Ok(())
}

/// Whether what is wrong stays wrong.
fn lasting(finding: &Finding) -> String {
    let behind = finding.tried.iter().skip_while(|name| Some(*name) != finding.wrong.first()).count();
    let last = finding.tried.last().map_or("", String::as_str);
    if matches!(&finding.first, Some(Break { what: What::NoPicture(_), .. })) {
        return "nothing beyond was tried".to_string();
    }
    match (finding.wrong.len(), behind) {
        (_, 1) => "that is the last one tried".to_string(),
        (wrong, behind) if wrong == behind => format!("and at all others up to {last}"),
        (wrong, behind) => format!("and at {} of the {} others up to {last}", wrong - 1, behind - 1),
    }
}

impl fmt::Display for What {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            What::Wrong { count, samples, first: (x, y), shown, expected } => {
                let shown = shown.map_or("a color of no polygon".to_string(), |shown| shown.to_string());
                write!(
                    f,
                    "{count} of {samples} samples are wrong, the first at ({x}, {y}): {shown} instead of {expected}"
                )
            }
            What::Stray(count) => write!(f, "the picture is right, but {count} fragments were put outside of it"),
            What::NoPicture(failure) => write!(f, "no picture: {}", failure.message),
        }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Shown::Background => write!(f, "background"),
            Shown::Polygon(number) => write!(f, "polygon {number}"),
        }
    }
}

/// How many binary digits the numbers of a list have, counted in steps of its grid.
struct Digits {
    bits: u32,
    coordinate: u32,
    product: u32,
    difference_product: u32,
}

impl Digits {
    fn of(list: &DrawList) -> Option<Digits> {
        let fixed = |x: f64| i128::from(list.grid.fixed(x));
        let all = |of: fn(&crate::screen::ScreenVertex) -> f64| {
            list.vertices.iter().map(move |vertex| fixed(of(vertex)).abs()).max()
        };
        let (x, y) = (all(|vertex| vertex.x)?, all(|vertex| vertex.y)?);
        let extent = |of: &dyn Fn(&crate::screen::ScreenVertex) -> f64| {
            let of_polygon = |polygon: crate::screen::ScreenPolygon<'_>| {
                let places = || polygon.vertices().iter().map(|vertex| fixed(of(vertex)));
                places().max().zip(places().min()).map_or(0, |(high, low)| high - low)
            };
            list.polygons().map(of_polygon).max()
        };
        let (dx, dy) = (extent(&|vertex| vertex.x)?, extent(&|vertex| vertex.y)?);
        let digits = |number: i128| 128 - number.leading_zeros();
        let (coordinate, product, difference_product) = (digits(x.max(y)), digits(x * y), digits(dx * dy));
        Some(Digits { bits: list.grid.bits, coordinate, product, difference_product })
    }
}

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Digits { bits, coordinate, product, difference_product } = self;
        write!(
            f,
            "in steps of 2^-{bits} a coordinate has up to {coordinate} binary digits there, x y of a corner {product}, width times height of \
             a polygon {difference_product}; f32 holds 24, i32 31, f64 53, i64 63"
        )
    }
}

/// All findings for programs.
#[must_use]
pub fn json(lab: &str, subject: &str, findings: &[Finding]) -> Value {
    let finding = |finding: &Finding| {
        let first =
            finding.first.as_ref().map(|first| json!({"step": first.step.name, "what": first.what.to_string()}));
        json!({"kind": finding.kind, "draws": finding.draws, "tried": finding.tried, "wrong": finding.wrong, "first": first})
    };
    let all: Vec<_> = findings.iter().map(finding).collect();
    let passed = findings.iter().all(|finding| finding.first.is_none());
    json!({"schema": 1, "lab": lab, "subject": subject, "passed": passed, "extremes": all})
}
