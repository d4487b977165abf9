//! Keys: what each of them does, in the words of the help; the one list that help, documents and tests read.

/// A group of keys: its title, and each key with what it does.
pub type Group = (&'static str, &'static [(&'static str, &'static str)]);

/// All keys. A capital letter goes through the same choices backwards.
pub const GROUPS: &[Group] = &[
    (
        "What is shown",
        &[
            ("1", "the picture"),
            ("2", "eye space from outside"),
            ("3", "clip planes, and what they cut"),
            ("4", "ears, in the order of cutting"),
            ("5", "polygons on the screen"),
            ("6", "the rasterizer, step by step"),
            ("7", "depth"),
            ("8", "normals"),
            ("9", "overdraw"),
            ("0", "polygons by number"),
        ],
    ),
    (
        "How it is made",
        &[
            ("s", "shading"),
            ("a", "samples a pixel"),
            ("b", "back faces: culling"),
            ("r", "rasterizer"),
            ("g", "grid: sub-pixel bits"),
            ("x", "yours, reference, difference"),
            ("e", "edges over the picture"),
        ],
    ),
    (
        "Step by step (2 to 6)",
        &[(". ,", "one on, one back"), ("> <", "ten on, ten back"), ("home", "the first"), ("end", "all at once")],
    ),
    (
        "Moving",
        &[
            ("drag", "turn"),
            ("left right", "turn"),
            ("up down", "turn; faster, slower"),
            ("pgup pgdn", "higher, lower"),
            ("+ -", "nearer, farther"),
            ("c", "orbit, fly, walk"),
            ("space", "stop"),
            ("v", "the scene's own view"),
            ("n", "compass, landmarks"),
        ],
    ),
    ("One pixel", &[("i", "why does it show what it shows"), ("arrows", "another pixel"), ("+ -", "zoom")]),
    (
        "Paths and files",
        &[
            ("p", "record a path, stop"),
            ("o", "play it"),
            ("w", "write it"),
            ("l", "load it"),
            ("m", "every frame to a file"),
            ("f", "picture to a file"),
            ("t", "text on, off"),
            ("h", "this help"),
            ("q", "quit"),
        ],
    ),
];

/// The help, a line a key, groups with a title; as many columns as `width` letters hold.
#[must_use]
pub fn help(width: usize) -> Vec<String> {
    const COLUMN: usize = 44;
    let blocks: Vec<Vec<String>> = GROUPS
        .iter()
        .map(|(title, keys)| {
            let line = |(key, what): &(&str, &str)| format!("  {key:<11}{what}");
            std::iter::once((*title).to_string()).chain(keys.iter().map(line)).collect()
        })
        .collect();
    if width < 2 * COLUMN {
        return blocks.concat();
    }
    let (left, right) = blocks.split_at(3);
    let (left, right) = (left.concat(), right.concat());
    let line = |number: usize| {
        let of = |lines: &[String]| lines.get(number).cloned().unwrap_or_default();
        format!("{:<COLUMN$}{}", of(&left), of(&right)).trim_end().to_string()
    };
    (0..left.len().max(right.len())).map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn help_fits_and_names_every_key() {
        let (narrow, wide) = (help(20), help(100));
        assert!(narrow.len() > wide.len() && wide.len() < 36, "{}", wide.len());
        assert!(narrow.iter().all(|line| line.len() <= 46) && wide.iter().all(|line| line.len() <= 90));
        for (key, what) in GROUPS.iter().flat_map(|group| group.1) {
            assert!([&narrow, &wide].iter().all(|lines| lines.iter().any(|line| line.contains(what))), "{key}");
        }
    }
}
