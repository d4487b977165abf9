//! The keywords of `.fcell`, and how each statement is written.

use crate::parse::statements::Vocabulary;

/// Every keyword and the statement it begins.
pub(super) static STATEMENTS: Vocabulary = Vocabulary(&[
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
    ("object", "object FILE X Y [TURN [SCALE]]"),
    ("end", "end"),
]);

/// How a statement is written, as a line of help.
pub(super) fn shape(keyword: &str) -> String {
    STATEMENTS.shape(keyword)
}
