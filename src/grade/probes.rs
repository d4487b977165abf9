//! The probes: small lists of polygons with the picture they must give, easy ones first.
//!
//! Each asks for one thing, so that what it finds has one reason. The pictures follow from the tie rule alone: a
//! sample is covered when its center is at or right of the left edge, strictly left of the right edge, at or below
//! the top, strictly above the bottom; of equal depths the polygon that comes first keeps the sample.

/// A small list and the picture it must give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probe {
    /// One or two words.
    pub name: &'static str,
    /// What it tests, in one line.
    pub tests: &'static str,
    /// The polygons, in list order.
    pub polygons: &'static [Flat],
    /// The picture, a character a sample: the polygon's number from 1, `.` for background.
    pub expected: &'static [&'static str],
    /// What to look at when the picture is another.
    pub hint: &'static str,
}

/// A polygon that faces the viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flat {
    /// Corners in samples, multiples of 1/256.
    pub corners: &'static [(f64, f64)],
    /// 1/w: larger is nearer.
    pub depth: f64,
}

const fn flat(depth: f64, corners: &'static [(f64, f64)]) -> Flat {
    Flat { corners, depth }
}

const ROUNDED: &str = "Corners lie between samples. Do not round them: compute with x and y as they are.";
const OVERLAP_LEFT: &[(f64, f64)] = &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
const OVERLAP_RIGHT: &[(f64, f64)] = &[(2.0, 1.0), (6.0, 1.0), (6.0, 4.0), (2.0, 4.0)];
const OVERLAP_BOTH: &[(f64, f64)] = &[(1.0, 0.0), (5.0, 0.0), (5.0, 4.0), (1.0, 4.0)];

/// All probes, easy ones first.
#[must_use]
pub fn probes() -> &'static [Probe] {
    PROBES
}

const PROBES: &[Probe] = &[
    Probe {
        name: "inside",
        tests: "samples whose centers are inside show the polygon, no others",
        polygons: &[flat(1.0, &[(1.25, 1.25), (4.75, 1.25), (4.75, 3.75), (1.25, 3.75)])],
        expected: &["......", ".1111.", ".1111.", ".1111.", "......"],
        hint: "Ask at the center of the sample, (x + 0.5, y + 0.5), not at its corner (x, y).",
    },
    Probe {
        name: "slanted",
        tests: "slanted edges between corners that lie between samples",
        polygons: &[flat(1.0, &[(0.375, 0.25), (6.625, 3.5), (2.5, 6.375)])],
        expected: &["1......", ".11....", ".1111..", "..11111", "..111..", "..11...", "......."],
        hint: ROUNDED,
    },
    Probe {
        name: "on centers",
        tests: "edges through centers: left and top belong to the polygon, right and bottom do not",
        polygons: &[flat(1.0, &[(1.5, 1.5), (4.5, 1.5), (4.5, 4.5), (1.5, 4.5)])],
        expected: &["......", ".111..", ".111..", ".111..", "......", "......"],
        hint: "Compare with <= at left and upper edges, and with < at right and lower ones.",
    },
    Probe {
        name: "shared edge",
        tests: "two triangles that share an edge through centers: every sample once",
        polygons: &[flat(1.0, &[(1.0, 1.0), (5.0, 1.0), (5.0, 5.0)]), flat(1.0, &[(1.0, 1.0), (5.0, 5.0), (1.0, 5.0)])],
        expected: &["......", ".1111.", ".2111.", ".2211.", ".2221.", "......"],
        hint: "A center exactly on the edge belongs to the polygon on its right; the other must leave it out.",
    },
    Probe {
        name: "fan",
        tests: "eight triangles around one center: no hole, no sample twice",
        polygons: &[
            flat(1.0, &[(3.5, 3.5), (0.5, 0.5), (3.5, 0.5)]),
            flat(1.0, &[(3.5, 3.5), (3.5, 0.5), (6.5, 0.5)]),
            flat(1.0, &[(3.5, 3.5), (6.5, 0.5), (6.5, 3.5)]),
            flat(1.0, &[(3.5, 3.5), (6.5, 3.5), (6.5, 6.5)]),
            flat(1.0, &[(3.5, 3.5), (6.5, 6.5), (3.5, 6.5)]),
            flat(1.0, &[(3.5, 3.5), (3.5, 6.5), (0.5, 6.5)]),
            flat(1.0, &[(3.5, 3.5), (0.5, 6.5), (0.5, 3.5)]),
            flat(1.0, &[(3.5, 3.5), (0.5, 3.5), (0.5, 0.5)]),
        ],
        expected: &["111222.", "811223.", "881233.", "777444.", "776544.", "766554.", "......."],
        hint: "The corner in the middle lies on a center: exactly one of the eight triangles may show it.",
    },
    Probe {
        name: "near first",
        tests: "a nearer polygon that comes first stays in front",
        polygons: &[flat(0.5, OVERLAP_LEFT), flat(0.25, OVERLAP_RIGHT)],
        expected: &["1111..", "111122", "111122", "..2222"],
        hint: "Put a fragment only where its depth is larger (nearer) than target.depth(x, y).",
    },
    Probe {
        name: "far first",
        tests: "a nearer polygon that comes later hides what is there",
        polygons: &[flat(0.25, OVERLAP_LEFT), flat(0.5, OVERLAP_RIGHT)],
        expected: &["1111..", "112222", "112222", "..2222"],
        hint: "Depth is 1/w: larger is nearer, and 0, what a target starts with, is infinitely far.",
    },
    Probe {
        name: "three depths",
        tests: "the middle one of three comes last, behind one and in front of the other",
        polygons: &[flat(0.25, OVERLAP_LEFT), flat(1.0, OVERLAP_RIGHT), flat(0.5, OVERLAP_BOTH)],
        expected: &["13333.", "132222", "132222", ".32222"],
        hint: "The fragment that is put must carry the depth it was compared by.",
    },
    Probe {
        name: "equal depth",
        tests: "of equal depths the polygon that comes first keeps the sample",
        polygons: &[flat(0.5, OVERLAP_LEFT), flat(0.5, OVERLAP_RIGHT)],
        expected: &["1111..", "111122", "111122", "..2222"],
        hint: "Compare depths with >, not >=.",
    },
    Probe {
        name: "either way",
        tests: "clockwise and counterclockwise outlines",
        polygons: &[flat(1.0, &[(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]), flat(1.0, &[(4.0, 4.0), (8.0, 4.0), (4.0, 0.0)])],
        expected: &["111.....", "11..2...", "1...22..", "....222."],
        hint: "Which side is inside must not depend on the way round: facing was decided before.",
    },
    Probe {
        name: "concave",
        tests: "a polygon with notches from above and below",
        polygons: &[flat(
            1.0,
            &[(0.0, 0.0), (3.5, 3.0), (7.0, 0.0), (7.0, 7.0), (5.25, 4.0), (3.5, 7.0), (1.75, 4.0), (0.0, 7.0)],
        )],
        expected: &["1.....1", "11...11", "111.111", "1111111", "1.111.1", "1..1..1", "...1..."],
        hint: "Count the edges left of the center: odd is inside. Or ask for triangles: fn accepts() of the trait.",
    },
    Probe {
        name: "borders",
        tests: "a polygon as large as the picture, which is not square",
        polygons: &[flat(1.0, &[(0.0, 0.0), (7.0, 0.0), (7.0, 4.0), (0.0, 4.0)])],
        expected: &["1111111", "1111111", "1111111", "1111111"],
        hint: "The last column is width - 1, the last row height - 1; nothing may be put beyond.",
    },
    Probe {
        name: "slivers",
        tests: "polygons thinner than a sample show only the centers they cover, which may be none",
        polygons: &[
            flat(1.0, &[(0.75, 0.0), (1.25, 0.0), (1.25, 6.0), (0.75, 6.0)]),
            flat(1.0, &[(2.0, 0.0), (2.375, 0.0), (5.0, 6.0), (4.625, 6.0)]),
        ],
        expected: &["..2...", "......", "......", "......", "......", "....2."],
        hint: ROUNDED,
    },
];
