//! The smallest case on the page: what to draw, where it fails, and the file to try it with.

use super::{anchor, lens, shot};
use crate::grade::pictures;
use crate::grade::witness::Witness;
use crate::grade::write::base64;
use maud::{Markup, html};

/// The panel of a witness.
pub(super) fn panel(witness: &Witness, aspect: &str) -> Markup {
    let case = &witness.case;
    let right = pictures::right(case);
    let all = ((0, right.width()), (0, right.height()));
    let count = case.faces.len();
    let (shown, expected) = witness.levels;
    html! {
        div.witness {
            h3 { "The smallest case" }
            p {
                (count) @if count == 1 { " polygon on " } @else { " polygons on " } (case.width) " × " (case.height) " samples; "
                (witness.wrong) " wrong, the first at (" (witness.first.0) ", " (witness.first.1) "): "
                (shot::level(shown)) " instead of " (shot::level(expected))
            }
            div.lens {
                div { (lens::view(case, &[], (&right, None), all, Some(witness.first))) span.label { "as it is right" } }
                div {
                    pre aria-label="the picture in letters" { @for row in &witness.rows { (row) "\n" } }
                    p.quiet { "# right, . background, ! extra, ? missing, z a polygon behind, ~ another color" }
                    @if !case.lines && !witness.edges.is_empty() {
                        p { "Edges, and where the center of that sample lies:" }
                        ul { @for edge in &witness.edges { li { (edge) } } }
                    }
                }
            }
            (file(witness, aspect))
        }
    }
}

fn file(witness: &Witness, aspect: &str) -> Markup {
    // The writer fails only where the disk does.
    let Ok(bytes) = witness.screen_file() else { return html! {} };
    let name = format!("{}.scr", anchor(aspect));
    let text = String::from_utf8_lossy(&bytes);
    html! {
        details {
            summary { "Its screen file, to draw it alone" }
            p {
                a download=(name) href=(format!("data:text/plain;base64,{}", base64(&bytes))) { "Save as " (name) }
                " and run " code { "farop raster " (name) " -r mine -o small.png" } " "
                button.copy type="button" hidden { "Copy" }
            }
            pre.file { (text) }
        }
    }
}
