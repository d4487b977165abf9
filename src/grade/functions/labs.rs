//! Labs about functions: their aspects and points. The questions stand with each lab.

use crate::grade::hidden::Probes;
use crate::grade::labs::{Aspect, Lab, Watch};

const fn aspect(name: &'static str, asks: &'static str, points: u32) -> Aspect {
    Aspect { name, asks, points, cases: |_| Vec::new(), watch: Watch::Picture }
}

/// Labs in which a function is written; they have no pictures.
pub const FUNCTION_LABS: &[Lab] = &[
    Lab {
        name: "clip",
        summary: "a polygon against the view volume, before the division",
        aspects: &[
            aspect("inside", "what is inside comes back as it was, to the bit", 5),
            aspect("outside", "what is outside leaves nothing", 5),
            aspect("one plane", "cut by each of the six planes, at every edge of the outline", 15),
            aspect("winding", "the outline runs on the way it ran", 5),
            aspect("on the plane", "corners and edges on a plane; no corner twice", 10),
            aspect("several planes", "corners of the volume, large polygons, points behind the eye", 15),
            aspect("concave", "what falls into pieces keeps its area and covers nothing else", 10),
            aspect("attributes", "what is linear in space is so at new corners, too", 10),
            aspect("edge marks", "edges that clipping makes are marked, others keep their mark", 5),
            aspect("shared edges", "neighbors cut their common edge in the same point, to the bit", 10),
            aspect("both sides", "before and behind a plane: the same points, and together the whole", 5),
            aspect("last places", "no new corner is outside a plane, not even by a last place", 5),
        ],
        fixes_ties: false,
        probes: Probes::Visible,
    },
    Lab {
        name: "triangulate",
        summary: "a polygon in space into triangles of its corners",
        aspects: &[
            aspect("triangle", "a triangle is itself", 5),
            aspect("convex", "n - 2 triangles that cover a convex outline once", 15),
            aspect("winding", "triangles run the way the outline does, whichever that is", 10),
            aspect("facing", "outlines in every plane of space: the normal says which way to look", 10),
            aspect("concave", "reflex corners anywhere: arrows, combs, stars, spirals", 25),
            aspect("straight corners", "corners in the middle of a straight edge", 10),
            aspect("touching", "a corner exactly on a diagonal: no triangle's edge runs through it", 10),
            aspect("bridges", "outlines that touch themselves: holes on bridges, spikes, doubled corners", 10),
            aspect("sizes", "the same at 2^-300 and 2^300 times the size, and nearly straight corners", 5),
        ],
        fixes_ties: false,
        probes: Probes::Visible,
    },
];
