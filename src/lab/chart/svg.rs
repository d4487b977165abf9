//! SVG: the marks of a chart as a text that browsers draw.
//!
//! Source: W3C, "Scalable Vector Graphics (SVG) 1.1", 2011.

use super::Mark;
use std::fmt::Write;

/// The file.
pub(super) fn text((width, height): (f64, f64), marks: &[Mark]) -> String {
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    for mark in marks {
        let _ = match mark {
            Mark::Line { from, to, color } => writeln!(
                text,
                "<line x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\" stroke=\"{}\"/>",
                from.0,
                from.1,
                to.0,
                to.1,
                hex(color.rgb())
            ),
            Mark::Dot { at, color, filled } => {
                let color = hex(color.rgb());
                let fill = if *filled { color.as_str() } else { "#ffffff" };
                let place = format!("cx=\"{:.1}\" cy=\"{:.1}\"", at.0, at.1);
                writeln!(text, "<circle {place} r=\"3.5\" stroke=\"{color}\" fill=\"{fill}\"/>")
            }
            Mark::Text { at, text: words, anchor, color } => {
                let anchor = ["start", "middle", "end"][(anchor * 2.0) as usize];
                let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
                let (place, fill) = (format!("x=\"{:.1}\" y=\"{:.1}\"", at.0, at.1), hex(color.rgb()));
                writeln!(text, "<text {place} text-anchor=\"{anchor}\" fill=\"{fill}\">{words}</text>")
            }
        };
    }
    text + "</svg>\n"
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
