//! Handouts: what a lab asks, as text, and the hints in it.
//!
//! docs/labs/NAME.md -HANDOUT-> hint 1, 2, 3
//!
//! Why the documents themselves are in the program: a second copy of a hint would drift away from the first.

/// The handouts by lab.
pub const HANDOUTS: [(&str, &str); 9] = [
    ("wire", include_str!("../../docs/labs/wire.md")),
    ("coverage", include_str!("../../docs/labs/coverage.md")),
    ("zbuffer", include_str!("../../docs/labs/zbuffer.md")),
    ("gouraud", include_str!("../../docs/labs/gouraud.md")),
    ("watkins", include_str!("../../docs/labs/watkins.md")),
    ("phong", include_str!("../../docs/labs/phong.md")),
    ("supersampling", include_str!("../../docs/labs/supersampling.md")),
    ("clip", include_str!("../../docs/labs/clip.md")),
    ("triangulate", include_str!("../../docs/labs/triangulate.md")),
];

/// Hints a handout has: a question, the idea, nearly the code.
pub const HINTS: u32 = 3;

/// The handout of a lab.
#[must_use]
pub fn handout(lab: &str) -> Option<&'static str> {
    HANDOUTS.iter().find(|(name, _)| *name == lab).map(|(_, text)| *text)
}

/// Hint `number` of a lab, from 1: what stands below `### Hint N` in its handout.
///
/// ```
/// assert!(farop::grade::handout::hint("clip", 1).is_some_and(|text| text.contains('?')));
/// assert_eq!(farop::grade::handout::hint("clip", 4), None);
/// ```
#[must_use]
pub fn hint(lab: &str, number: u32) -> Option<&'static str> {
    let heading = format!("\n### Hint {number}\n");
    let (_, below) = handout(lab)?.split_once(heading.as_str())?;
    let end = below.find("\n#").unwrap_or(below.len());
    Some(below[..end].trim())
}
