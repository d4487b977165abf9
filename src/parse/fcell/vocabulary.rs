//! The keywords of `.fcell`, and how each statement is written.

/// Every keyword and the statement it begins.
const STATEMENTS: [(&str, &str); 19] = [
    ("fcell", "fcell 1"),
    ("crs", "crs NAME"),
    ("origin", "origin EAST NORTH"),
    ("side", "side METRES"),
    ("seed", "seed NUMBER"),
    ("species", "species CODE [form WORD] [image FILE]..."),
    ("cover", "cover NUMBER IMAGE [tile METRES]"),
    (
        "stand",
        "stand NUMBER species CODE h MEAN [SD] crown MEAN [SD] dens TREES_PER_HECTARE [hcb METRES] [year YEAR] [plant WORD] [tex NUMBER] [cover NUMBER]",
    ),
    ("cell", "cell COLUMN ROW [size METRES] [seed NUMBER]"),
    ("ground", "ground COVER"),
    ("dem", "dem COLUMNS ROWS [z0 METRES] [dz METRES] then COLUMNS x ROWS counts, rows from the north"),
    ("demref", "demref FILE [lattice COLUMNS ROWS] [black METRES white METRES]"),
    ("v", "v X Y Z"),
    ("t", "t I J K [cover NUMBER]"),
    ("poly", "poly NUMBER stand NUMBER | cover NUMBER, outer N X Y ... [hole N X Y ...]..."),
    ("tree", "tree CODE X Y HEIGHT CROWN [TURN]"),
    ("line", "line KIND w METRES N X Y ..."),
    ("mark", "mark \"NAME\" X Y"),
    ("end", "end"),
];

/// Whether `word` begins a statement where it is the first on its line.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    STATEMENTS.iter().any(|(keyword, _)| keyword.as_bytes() == word)
}

/// The keywords.
pub(super) fn keywords() -> impl Iterator<Item = &'static str> {
    STATEMENTS.iter().map(|&(keyword, _)| keyword)
}

/// How a statement is written, as a line of help.
pub(super) fn shape(keyword: &str) -> String {
    let known = STATEMENTS.iter().find(|(name, _)| *name == keyword);
    known.map_or_else(String::new, |(_, shape)| format!("write `{shape}`"))
}
