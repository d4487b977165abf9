//! Words for the mistakes about lines: name, cause, rule, page.

const PAGE: &str = "docs/conventions.md";
const DIAMOND: &str = "A line shows the samples whose diamond |dx| + |dy| < 1/2 it leaves.";
const CENTERS: &str = "Ask for the row where the line passes the middle of the column, and cut it to a whole number.";
const ONCE: &str =
    "Every edge of an outline is drawn once, from each corner to the next and from the last to the first.";

pub(super) const WHOLE: [&str; 4] = [
    "line ends made whole",
    "Line ends are made whole (cut or rounded) before the line is stepped.",
    "A line shows the samples whose diamond |dx| + |dy| < 1/2 it leaves; ends lie between samples.",
    PAGE,
];
pub(super) const LAST: [&str; 4] = [
    "last sample of lines drawn",
    "A line shows the sample it ends in, which belongs to the next line.",
    "A line shows the samples whose diamond it leaves, not the one it ends in.",
    PAGE,
];
pub(super) const ENDS_DRAWN: [&str; 4] = [
    "end samples always drawn",
    "The samples that hold the ends of a line are drawn even where the line does not leave their diamonds.",
    DIAMOND,
    PAGE,
];
pub(super) const ENDS_LOST: [&str; 4] = [
    "end samples left out",
    "The samples at the ends of a line are left out, at the start as well as at the end.",
    DIAMOND,
    PAGE,
];
pub(super) const MIDDLES: [&str; 4] = [
    "line ends cut at columns",
    "A line begins and ends where it passes the middle of a column, not where it leaves a diamond.",
    DIAMOND,
    PAGE,
];
pub(super) const TRIMMED: [&str; 4] = [
    "first or last column of lines lost",
    "The first or last column (or row) of every line is lost.",
    "Step from the first column to the last, both included, and ask for the diamonds at the ends.",
    PAGE,
];
pub(super) const SIZE: [&str; 4] = [
    "diamonds of another size",
    "The diamond around a center is larger or smaller than |dx| + |dy| < 1/2.",
    DIAMOND,
    PAGE,
];
pub(super) const SQUARE: [&str; 4] = [
    "squares for diamonds",
    "A square is used for the diamond: every sample that the line touches is shown.",
    DIAMOND,
    PAGE,
];
pub(super) const CIRCLE: [&str; 4] =
    ["distance for diamonds", "Every sample nearer to the line than a fixed distance is shown.", DIAMOND, PAGE];
pub(super) const AT_CORNER: [&str; 4] = [
    "samples at the corner",
    "Centers of samples are taken for their corners (x, y).",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
pub(super) const AT_FAR_CORNER: [&str; 4] = [
    "samples at the far corner",
    "Centers of samples are taken for their corners (x + 1, y + 1).",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
pub(super) const HALF_BESIDE: [&str; 4] = [
    "samples half beside the center",
    "The center of a sample is half a sample beside its place, in x or in y.",
    "The center is (x + 1/2, y + 1/2).",
    PAGE,
];
pub(super) const GAPS: [&str; 4] = [
    "steep lines with gaps",
    "Lines are stepped along x only, so steep ones have gaps.",
    "Step along the longer direction.",
    PAGE,
];
pub(super) const FLAT_GAPS: [&str; 4] = [
    "shallow lines with gaps",
    "Lines are stepped along y only, so shallow ones have gaps.",
    "Step along the longer direction.",
    PAGE,
];
pub(super) const EXCHANGED: [&str; 4] = [
    "steep test turned round",
    "Steep lines are stepped along x and shallow ones along y: all have gaps.",
    "Step along the longer direction.",
    PAGE,
];
pub(super) const WHOLE_SLOPE: [&str; 4] = [
    "slope made whole",
    "The slope of a line is a whole number: dy / dx loses its fraction.",
    "Divide as floating point numbers, or keep the remainder.",
    PAGE,
];
pub(super) const SIGN: [&str; 4] = [
    "sign of the slope lost",
    "The slope has always the same sign: lines that should rise fall, or the other way round.",
    "The slope is (y2 - y1) / (x2 - x1), with its sign.",
    PAGE,
];
pub(super) const OPPOSITE: [&str; 4] = [
    "slope reversed",
    "The slope has the wrong sign: lines that should rise fall, and those that should fall rise.",
    "The slope is (y2 - y1) / (x2 - x1).",
    PAGE,
];
pub(super) const TURNED: [&str; 4] =
    ["slope turned over", "The slope is dx / dy for dy / dx.", "A row is passed on by dy / dx for every column.", PAGE];
pub(super) const DIAGONAL: [&str; 4] = [
    "all lines at 45 degrees",
    "Every step goes a row further: the error term is never set back.",
    "Take a whole row off the error when the row changes.",
    PAGE,
];
pub(super) const NO_SLOPE: [&str; 4] = [
    "slope forgotten",
    "All samples of a line are in the row of its start: the slope is not used.",
    "The row grows by dy / dx for every column.",
    PAGE,
];
pub(super) const HALVED: [&str; 4] =
    ["slope halved", "The row grows by half of what it should.", "The row grows by dy / dx for every column.", PAGE];
pub(super) const ROUNDED: [&str; 4] = [
    "rows of lines rounded",
    "Rows of lines (columns of steep ones) are rounded where they should be cut: half a sample beside.",
    CENTERS,
    PAGE,
];
pub(super) const BESIDE: [&str; 4] =
    ["rows of lines one beside", "Rows of lines (columns of steep ones) are one too high or too low.", CENTERS, PAGE];
pub(super) const ERROR: [&str; 4] = [
    "error term starts wrong",
    "The error of a line starts at the wrong value: rows change half a sample too late or too early.",
    "Rows change where the line is halfway between two centers.",
    PAGE,
];
pub(super) const FROM_END: [&str; 4] = [
    "lines stepped from their ends",
    "Rows are asked for beside the middle of columns: stepping starts at the end of the line, or at a side of the column.",
    CENTERS,
    PAGE,
];
pub(super) const DIRECTION: [&str; 4] = [
    "lines of one direction lost",
    "Lines that run one way (to the left, up, right or down) are lost.",
    "Outlines run in all directions: step from the smaller column to the larger, whichever end that is.",
    PAGE,
];
pub(super) const UNSIGNED: [&str; 4] = [
    "direction of steps lost",
    "Lines that should run to the left (or up) are drawn to the right (or down).",
    "The step along a line has the sign of its extent, in x and in y.",
    PAGE,
];
pub(super) const HALVES: [&str; 4] = [
    "ends exchanged by halves",
    "Where the ends of a line are exchanged only x (or only y) is: it is drawn mirrored.",
    "Exchange both coordinates of the ends, or none.",
    PAGE,
];
pub(super) const NOT_BACK: [&str; 4] = [
    "steep lines not turned back",
    "x and y are exchanged to step along a steep line, and not exchanged again where samples are put.",
    "Whatever was exchanged for stepping is exchanged again for the sample.",
    PAGE,
];
pub(super) const ONLY_TRIANGLES: [&str; 4] = [
    "triangles only",
    "Only polygons with three corners are drawn.",
    "A polygon may have any number of corners.",
    PAGE,
];
pub(super) const NO_TRIANGLES: [&str; 4] =
    ["triangles lost", "Polygons with three corners are not drawn.", "A polygon has three corners or more.", PAGE];
pub(super) const THRESHOLD: [&str; 4] = [
    "test for bright backgrounds wrong",
    "Another test than red + green + blue > 1.5 decides that lines are black.",
    "Lines are black where red + green + blue of the background is above 1.5.",
    PAGE,
];
pub(super) const LEVEL: [&str; 4] = ["level lines lost", "Horizontal lines are lost.", "A line may have dy = 0.", PAGE];
pub(super) const UPRIGHT: [&str; 4] =
    ["upright lines lost", "Vertical lines are lost.", "A line may have dx = 0.", PAGE];
pub(super) const STRAIGHT: [&str; 4] = [
    "level and upright lines lost",
    "Horizontal and vertical lines are lost.",
    "A line may have dx = 0 or dy = 0.",
    PAGE,
];
pub(super) const NO_DIAGONAL: [&str; 4] =
    ["diagonal lines lost", "Lines at 45 degrees are lost.", "A line may have |dx| = |dy|.", PAGE];
pub(super) const STEEP: [&str; 4] =
    ["steep lines lost", "Steep lines are lost.", "A line with |dy| > |dx| is stepped along y.", PAGE];
pub(super) const SHALLOW: [&str; 4] =
    ["shallow lines lost", "Shallow lines are lost.", "A line with |dx| > |dy| is stepped along x.", PAGE];
pub(super) const LEANING: [&str; 4] = [
    "rising or falling lines lost",
    "Of the lines that rise to the right and those that fall, one kind is lost.",
    "The slope may have either sign.",
    PAGE,
];
pub(super) const OPEN: [&str; 4] =
    ["outline not closed", "The first or the last edge of an outline is missing.", ONCE, PAGE];
pub(super) const ONE_EDGE: [&str; 4] =
    ["an edge missing", "One edge of an outline that is not its last is missing.", ONCE, PAGE];
pub(super) const FIRST_EDGE: [&str; 4] = ["first edge only", "Only the first edge of an outline is drawn.", ONCE, PAGE];
pub(super) const OTHER: [&str; 4] =
    ["every other edge", "Every other edge is drawn, as if corners came in pairs.", ONCE, PAGE];
pub(super) const STAR: [&str; 4] =
    ["edges from the first corner", "All edges start (or end) at the first corner.", ONCE, PAGE];
pub(super) const SKIPPING: [&str; 4] =
    ["edges to the next but one", "Edges go to the next corner but one.", ONCE, PAGE];
pub(super) const TRIANGLE: [&str; 4] =
    ["edges of the first triangle only", "Only the first three corners have edges.", ONCE, PAGE];
pub(super) const FAN: [&str; 4] =
    ["inner edges drawn", "Outlines are cut into triangles, and the cuts are drawn as well.", ONCE, PAGE];
pub(super) const BOUNDS: [&str; 4] = ["boxes for outlines", "The sides of the bounding box are drawn.", ONCE, PAGE];
pub(super) const BOX: [&str; 4] = ["boxes filled", "The whole bounding box is filled.", "Draw the edges only.", PAGE];
pub(super) const FILLED: [&str; 4] = ["filled, not outlined", "Polygons are filled.", "Draw the edges only.", PAGE];
pub(super) const CORNERS: [&str; 4] = ["corners only", "Only the samples that hold a corner are drawn.", ONCE, PAGE];
pub(super) const FIRST_FACE: [&str; 4] = [
    "first polygon lost",
    "The first polygon of the list is not drawn.",
    "The list goes from 0 to its length - 1.",
    PAGE,
];
pub(super) const LAST_FACE: [&str; 4] = [
    "last polygon lost",
    "The last polygon of the list is not drawn.",
    "The list goes from 0 to its length - 1.",
    PAGE,
];
pub(super) const ONE_FACE: [&str; 4] =
    ["one polygon only", "Only one polygon of the list is drawn.", "The list goes from 0 to its length - 1.", PAGE];
pub(super) const WIDE: [&str; 4] = ["lines too wide", "Lines are two or three samples wide.", DIAMOND, PAGE];
pub(super) const DASHED: [&str; 4] =
    ["lines dashed", "Lines leave samples out: only every second or third is drawn.", "Step by one sample.", PAGE];
pub(super) const DIM: [&str; 4] = [
    "light of lines wrong",
    "Lines have not their full light, or not in all channels.",
    "Lines are white on a dark background and black on a bright one.",
    PAGE,
];
pub(super) const ONE_INK: [&str; 4] = [
    "lines always white",
    "Lines are white (or gray) on every background, on a bright one, too.",
    "Lines are black where red + green + blue of the background is above 1.5.",
    PAGE,
];
pub(super) const BLACK_INK: [&str; 4] = [
    "lines black for white",
    "Lines are black where they should be white.",
    "Lines are black where red + green + blue of the background is above 1.5, and white elsewhere.",
    PAGE,
];
pub(super) const EXCLUSIVE: [&str; 4] = [
    "samples of two lines erased",
    "A sample that two lines show is empty again: lines are drawn by exclusive or.",
    "A sample is shown when any line shows it.",
    PAGE,
];
