//! The sheet of a suite: the rules of the lab and every picture as it is right, to be printed and handed out.
//!
//! lab, cases -SHEET-> one page, no script needed

use super::{lens, page, points};
use crate::grade::case::Case;
use crate::grade::labs::Lab;
use crate::grade::pictures;
use maud::{Markup, html};

/// The rules by which every picture of every lab is judged: what about, and the rule.
pub const RULES: [(&str, &str); 9] = [
    ("Samples", "Sample (x, y) counts from the upper left, x to the right, y down; its center is (x + 0.5, y + 0.5)."),
    (
        "Coverage",
        "A polygon covers a sample when its center is at or right of the left edge, strictly left of the right edge, at or below \
         the top, strictly above the bottom; even-odd, whatever its orientation.",
    ),
    ("Depth", "Depth is 1/w: larger is nearer, 0 is infinitely far. The nearest polygon shows."),
    ("Equal depth", "Of equal depths the polygon that comes first in the file keeps the sample."),
    ("Values", "What a vertex carries is interpolated in perspective: value/w and 1/w are linear on the screen."),
    (
        "Transparency",
        "What is behind glass shows through: nearest last, color times opacity plus the rest of what is behind.",
    ),
    ("Pixels", "With A x A samples a pixel, a pixel is the mean of its samples' light."),
    ("Levels", "A level is round(255 c), c from 0 to 1; the files say `encoding linear`."),
    (
        "Pictures",
        "P6: the letters P6, width, height, 255, one white space, then 3 bytes a pixel, rows from the top. PNG is read as well. A \
         picture has the name of its screen file.",
    ),
];

/// The page; `files` are the cases with the names of their files, without an ending.
#[must_use]
pub fn sheet(lab: &Lab, files: &[(String, Case)], seed: u64) -> String {
    let total: f64 = lab.aspects.iter().map(|aspect| f64::from(aspect.points)).sum();
    let body = html! {
        header {
            p.lab { "Lab " (lab.name) }
            h1 { (lab.summary) }
            p { (files.len()) " pictures, " (points(total)) " points in all. Draw NAME.scr as NAME.ppm." }
        }
        section {
            h2 { "Rules" }
            dl { @for (about, rule) in RULES { dt { (about) } dd { (rule) } } }
            @if !lab.fixes_ties { p.quiet { "Another rule for edges is accepted when it gives every center to exactly one polygon." } }
        }
        section {
            h2 { "What is asked" }
            div.scroll { table { tbody { @for aspect in lab.aspects { tr { th scope="row" { (aspect.name) } td { (aspect.asks) } td.number { (aspect.points) } } } } } }
        }
        section {
            h2 { "As it is right" }
            p.quiet { "White lines are edges, dots are the centers of samples." }
            div.sheet { @for (name, case) in files { (entry(name, case)) } }
        }
        footer { p { "To have them judged: " code { "farop grade " (lab.name) " --pictures DIR --seed " (seed) } } }
    };
    page(&format!("Lab {}: {}", lab.name, lab.summary), &body)
}

fn entry(name: &str, case: &Case) -> Markup {
    let right = pictures::right(case);
    let all = ((0, right.width()), (0, right.height()));
    html! {
        figure.thumb {
            (lens::view(case, &[], (&right, None), all, None))
            figcaption { (name) }
        }
    }
}
