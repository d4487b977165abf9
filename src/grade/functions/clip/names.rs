//! Names: the mistakes of a clip that are told apart.

use super::mutants::{Edges, Emits, Marks, Mixed, Partly, RIGHT, Rules};
use crate::grade::functions::Mistake;

/// How a mistake is recognized.
pub(super) enum Kind {
    /// By the answers of a clip with these rules.
    Rules(Rules),
    /// The neighbor's points differ in last places.
    Cracks,
    /// The other side's points differ in last places.
    OneSided,
    /// New corners are outside by a last place.
    LastPlace,
    /// Corners come twice.
    Doubles,
    /// Everything is off by what 24 bits are off by.
    Single,
}

/// A mistake and how it is recognized.
pub(super) struct Known {
    pub mistake: Mistake,
    pub kind: Kind,
}

const INSIDE_RULE: &str = "a point is inside a plane when its distance, w + x for the left one, is at least 0";
const STEP_RULE: &str =
    "for each edge a -> b: put a if it is inside; put the crossing if just one of a and b is inside";
const MIX_RULE: &str =
    "with distances p > 0 and q < 0 of the ends, everything at the crossing is (p outer - q inner) / (p - q)";
const MARK_RULE: &str = "the edge that starts where the outline leaves is Cut; the one that starts where it enters keeps the old edge's mark";
const ALL_RULE: &str =
    "hither, left, right, bottom, top, yon, one after another; the result of each goes on to the next";

const fn rules(name: &'static str, cause: &'static str, rule: &'static str, rules: Rules) -> Known {
    Known { mistake: Mistake { name, cause, rule, is_forgiven: true, special: 0 }, kind: Kind::Rules(rules) }
}

/// The step is not there: what follows from that earns nothing.
const fn undone(name: &'static str, cause: &'static str, rule: &'static str, changed: Rules) -> Known {
    let Known { mistake, kind } = rules(name, cause, rule, changed);
    Known { mistake: Mistake { is_forgiven: false, ..mistake }, kind }
}

const fn symptom(name: &'static str, cause: &'static str, rule: &'static str, kind: Kind) -> Known {
    Known { mistake: Mistake { name, cause, rule, is_forgiven: true, special: 0 }, kind }
}

/// All of them.
pub(super) fn all() -> Vec<Known> {
    let mut known = whole();
    known.extend(planes());
    known.extend(steps());
    known.extend(values());
    known.extend(symptoms());
    known
}

fn whole() -> Vec<Known> {
    use Partly::{Dropped, Kept, NeedsCorner};
    vec![
        undone(
            "nothing comes back",
            "every polygon is dropped; the signs of all planes may be turned",
            INSIDE_RULE,
            Rules { empties: true, ..RIGHT },
        ),
        undone("nothing is cut", "the polygon comes back as it was", ALL_RULE, Rules { untouched: true, ..RIGHT }),
        undone(
            "what is partly outside is dropped",
            "one corner outside is enough to drop the polygon",
            STEP_RULE,
            Rules { partly: Dropped, ..RIGHT },
        ),
        undone(
            "what is partly inside is kept whole",
            "one corner inside is enough to keep all of the polygon",
            STEP_RULE,
            Rules { partly: Kept, ..RIGHT },
        ),
        undone(
            "corners are moved onto the planes",
            "coordinates are limited to -w and w: edges change their direction",
            MIX_RULE,
            Rules { clamps: true, ..RIGHT },
        ),
        rules(
            "no corner inside: dropped",
            "a polygon without a corner in the volume is taken for outside, but it may cover the middle",
            "outside is what has all corners outside of one and the same plane",
            Rules { partly: NeedsCorner, ..RIGHT },
        ),
        rules(
            "orientation turned",
            "the corners come back in the other order",
            "put corners in the order of the walk",
            Rules { reversed: true, ..RIGHT },
        ),
        rules(
            "divides by w",
            "corners come back divided by w",
            "clip coordinates stay homogeneous; the division comes after the clip",
            Rules { divides: true, ..RIGHT },
        ),
    ]
}

fn planes() -> Vec<Known> {
    const SKIPPED: [(&str, &str); 6] = [
        ("hither is not cut", "the near plane is missing, or taken for w = 0: what is nearer goes on"),
        ("left is not cut", "the left plane is missing"),
        ("right is not cut", "the right plane is missing"),
        ("bottom is not cut", "the lower plane is missing"),
        ("top is not cut", "the upper plane is missing"),
        ("yon is not cut", "the far plane is missing"),
    ];
    const TURNED: [&str; 6] = [
        "the other side of hither",
        "the other side of left",
        "the other side of right",
        "the other side of bottom",
        "the other side of top",
        "the other side of yon",
    ];
    let mut known = vec![
        rules(
            "clips against the other side",
            "what is outside is kept, and what is inside cut away",
            INSIDE_RULE,
            Rules { turned_sides: true, ..RIGHT },
        ),
        rules(
            "the sides are compared with 1",
            "x and y are compared with 1, as after the division, not with w",
            INSIDE_RULE,
            Rules { unit_sides: true, ..RIGHT },
        ),
        rules(
            "the sides are not cut",
            "only hither and yon are there",
            ALL_RULE,
            Rules { all_sides_skipped: true, ..RIGHT },
        ),
        rules(
            "only the first plane cuts",
            "after one cut nothing more is looked at",
            ALL_RULE,
            Rules { only_first_plane: true, ..RIGHT },
        ),
        rules(
            "every plane cuts the original",
            "each plane starts from the given polygon: only the last cut is left",
            ALL_RULE,
            Rules { each_from_original: true, ..RIGHT },
        ),
    ];
    for (plane, (name, cause)) in SKIPPED.into_iter().enumerate() {
        known.push(rules(name, cause, ALL_RULE, Rules { skipped: Some(plane), ..RIGHT }));
        let cause = "this plane's sign is turned: what is outside of it is kept";
        known.push(rules(TURNED[plane], cause, INSIDE_RULE, Rules { turned_plane: Some(plane), ..RIGHT }));
    }
    known
}

fn steps() -> Vec<Known> {
    let emits = |name, cause, emits| rules(name, cause, STEP_RULE, Rules { emits, ..RIGHT });
    vec![
        rules(
            "the last edge is forgotten",
            "the edge from the last corner back to the first is not walked",
            "n corners have n edges: the last runs back to the first",
            Rules { edges: Edges::NotLast, ..RIGHT },
        ),
        rules(
            "the last edge is forgotten",
            "the walk begins at the second corner: the edge from the last corner to the first is missing, and so is the first corner",
            "n corners have n edges: the last runs back to the first",
            Rules { edges: Edges::NotLastNorFirstCorner, ..RIGHT },
        ),
        emits("no crossing where the outline leaves", "only entering edges make a corner", Emits::NoLeaving),
        emits("no crossing where the outline enters", "only leaving edges make a corner", Emits::NoEntering),
        emits("no crossings", "corners outside are left out, and nothing takes their place", Emits::NoCrossing),
        emits(
            "the corner behind an entering edge is lost",
            "where the outline enters, the crossing is put, but not the corner it leads to",
            Emits::NotBehindEntering,
        ),
        emits("drops the first corner", "the first corner is never put", Emits::NotFirst),
        emits("drops the last corner", "the last corner of every step is missing", Emits::NotLast),
        emits("drops the last corner", "the last corner of every step is missing", Emits::NotLastEnd),
        rules(
            "a corner on a plane is lost",
            "a corner on a plane counts as outside, and as no crossing either",
            INSIDE_RULE,
            Rules { strict: true, ..RIGHT },
        ),
    ]
}

fn values() -> Vec<Known> {
    let position = |name, cause, position| rules(name, cause, MIX_RULE, Rules { position, ..RIGHT });
    let attributes = |name, cause, attributes| rules(name, cause, MIX_RULE, Rules { attributes, ..RIGHT });
    let copied = "attributes not interpolated";
    let some = "only the first attribute is interpolated";
    let marks = |name, cause, marks| rules(name, cause, MARK_RULE, Rules { marks, ..RIGHT });
    vec![
        position(
            "the proportion is turned round",
            "t is that of the other end: the crossing is as far from the wrong one",
            Mixed::Turned,
        ),
        position("the middle for the crossing", "every crossing is put in the middle of its edge", Mixed::Middle),
        position("the outer end for the crossing", "the corner outside is put in place of the crossing", Mixed::Outer),
        attributes(copied, "a new corner has the attributes of the inner end", Mixed::Inner),
        attributes(copied, "a new corner has the attributes of the outer end", Mixed::Outer),
        attributes(copied, "a new corner has the attributes of the corner where its edge begins", Mixed::Start),
        attributes(copied, "a new corner has the attributes of the corner where its edge ends", Mixed::End),
        attributes(copied, "a new corner has no attributes: they are 0", Mixed::Nothing),
        attributes(copied, "a new corner has the mean of both ends", Mixed::Middle),
        attributes(some, "the others are copied", Mixed::FirstThenInner),
        attributes(some, "the others stay 0", Mixed::FirstThenNothing),
        attributes(
            "attributes mixed the other way round",
            "t counts from the other end than for the place",
            Mixed::Turned,
        ),
        attributes("attributes mixed as on the screen", "t is the proportion after the division by w", Mixed::Screen),
        marks("new edges are not marked", "edges that run along a plane are taken for the object's own", Marks::None),
        marks(
            "the edge before is marked",
            "the mark is on the edge that leads to the plane, not on the one along it",
            Marks::Before,
        ),
        marks("entering edges are marked, too", "both crossings start a marked edge", Marks::Both),
        marks(
            "the wrong crossing is marked",
            "the edge that enters is marked, not the one along the plane",
            Marks::Entering,
        ),
    ]
}

fn symptoms() -> Vec<Known> {
    vec![
        symptom(
            "cracks: computed from the end where the walk begins",
            "neighbors walk their edge in opposite directions, and rounding makes two points of one crossing",
            "compute from the inner end to the outer one, whichever way the edge is walked",
            Kind::Cracks,
        ),
        symptom(
            "the crossing depends on the side that is kept",
            "a + t (b - a) rounds otherwise when a and b change places",
            "(p outer - q inner) / (p - q) has the same operands from both sides",
            Kind::OneSided,
        ),
        symptom(
            "new corners miss their plane by a last place",
            "rounding pushes a fifth of all crossings just outside",
            "set the coordinate that the plane determines: x = w on the right one; a plane passed before must stay kept, too",
            Kind::LastPlace,
        ),
        symptom(
            "a corner on a plane comes twice",
            "a corner on the plane is put, and a crossing in the same place",
            "a corner on the plane is its own crossing",
            Kind::Doubles,
        ),
        symptom(
            "computed in f32",
            "places are off by what 24 bits are off by",
            "keep f64 up to the screen",
            Kind::Single,
        ),
    ]
}
