//! Collide: bounding volumes, and an observer who does not walk through trees.
//!
//! trees -COLLIDE-> balls and boxes; a step of the observer -COLLIDE-> where it ends
//!
//! Why volumes and not triangles: where two volumes have no point in common, what is in them has none either, and two balls are
//! compared with one distance. A tree is a thin box (its stem) and a ball (its crown): one ball around all of it, as in the paper, would
//! keep an observer out of every dense stand, because crowns meet above paths.
//!
//! Space: world, metres, z up.
//! Source: S. Caralo, "Billboards", on collision by bounding spheres and boxes. Sliding is ours: the paper only asks for a hit.
//! Cost: a step looks at the volumes within reach, found in squares of [`SQUARE`] metres.

use crate::math::Vec3;
use std::collections::BTreeMap;

/// Side of the squares in which volumes are found, metres.
const SQUARE: f64 = 4.0;
/// An observer is pushed out of this many volumes a step, then it stands still.
const PUSHES: usize = 6;
/// What is nearer than this is pushed this much farther: else it would be found again.
const AIR: f64 = 1e-6;

/// A simple body around a complicated one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Volume {
    /// All points within `radius` of `center`.
    Ball {
        /// World space.
        center: Vec3,
        /// Metres; not negative.
        radius: f64,
    },
    /// All points between two corners.
    Box {
        /// The corner with the smallest numbers.
        low: Vec3,
        /// The corner with the largest.
        high: Vec3,
    },
}

impl Volume {
    /// The ball around the middle of the box of `points`: encloses all of them. `None` without points.
    #[must_use]
    pub fn ball_around(points: &[Vec3]) -> Option<Volume> {
        let Volume::Box { low, high } = Volume::box_around(points)? else { return None };
        let center = (low + high) * 0.5;
        let radius = points.iter().map(|point| point.distance(center)).fold(0.0, f64::max);
        Some(Volume::Ball { center, radius })
    }

    /// The smallest box around `points`; `None` without points.
    #[must_use]
    pub fn box_around(points: &[Vec3]) -> Option<Volume> {
        let (&first, rest) = points.split_first()?;
        let grow = |(low, high): (Vec3, Vec3), point: &Vec3| (low.min(*point), high.max(*point));
        let (low, high) = rest.iter().fold((first, first), grow);
        Some(Volume::Box { low, high })
    }

    /// Whether the two have a point in common; touching counts. `false` proves that what is in them is apart.
    #[must_use]
    pub fn meets(&self, other: &Volume) -> bool {
        match (*self, *other) {
            (Volume::Ball { center, radius }, Volume::Ball { center: c, radius: r }) => {
                center.distance_squared(c) <= (radius + r) * (radius + r)
            }
            (Volume::Box { low, high }, Volume::Box { low: l, high: h }) => low.cmple(h).all() && l.cmple(high).all(),
            (Volume::Ball { center, radius }, Volume::Box { low, high })
            | (Volume::Box { low, high }, Volume::Ball { center, radius }) => {
                center.distance_squared(center.clamp(low, high)) <= radius * radius
            }
        }
    }

    /// The box around it.
    fn bounds(&self) -> (Vec3, Vec3) {
        match *self {
            Volume::Ball { center, radius } => (center - Vec3::splat(radius), center + Vec3::splat(radius)),
            Volume::Box { low, high } => (low, high),
        }
    }

    /// Where the center of a ball goes that must leave this volume by the shortest way; `None` where it is outside.
    fn pushed_out(&self, center: Vec3, radius: f64) -> Option<Vec3> {
        match *self {
            Volume::Ball { center: own, radius: r } => {
                let away = center - own;
                let (distance, reach) = (away.length(), r + radius);
                // Exactly in the middle every way is as short; up is free.
                let way = if distance > 0.0 { away / distance } else { Vec3::Z };
                (distance < reach).then(|| own + way * (reach + AIR))
            }
            Volume::Box { low, high } => {
                let nearest = center.clamp(low, high);
                let away = center - nearest;
                let distance = away.length();
                if distance >= radius {
                    return None;
                }
                Some(if distance > 0.0 {
                    nearest + away / distance * (radius + AIR)
                } else {
                    out_of_the_side(center, radius, low, high)
                })
            }
        }
    }
}

/// From within a box, through its nearest upright side: stems are left to the side, not over the top.
fn out_of_the_side(center: Vec3, radius: f64, low: Vec3, high: Vec3) -> Vec3 {
    let sides = [
        (center.x - low.x, Vec3::new(low.x - radius - AIR, center.y, center.z)),
        (high.x - center.x, Vec3::new(high.x + radius + AIR, center.y, center.z)),
        (center.y - low.y, Vec3::new(center.x, low.y - radius - AIR, center.z)),
        (high.y - center.y, Vec3::new(center.x, high.y + radius + AIR, center.z)),
    ];
    let mut best = sides[0];
    for side in sides {
        if side.0 < best.0 {
            best = side;
        }
    }
    best.1
}

/// The volumes of a tree: its stem up to the crown, and its crown.
///
/// * `foot`: where it stands; `height`, `crown`: metres, the crown's diameter; `crown_base`: height of the lowest branches.
///
/// A stem is a fiftieth of the height wide. The crown's ball hangs from the top; where the crown is higher than wide, its lower
/// part is left to the stem.
#[must_use]
pub fn of_tree(foot: Vec3, height: f64, crown: f64, crown_base: Option<f64>) -> [Volume; 2] {
    let half = height / 100.0;
    let radius = (crown / 2.0).min(height / 2.0);
    let base = crown_base.unwrap_or(height - 2.0 * radius).clamp(0.0, height);
    let stem = Volume::Box { low: foot - Vec3::new(half, half, 0.0), high: foot + Vec3::new(half, half, base) };
    [stem, Volume::Ball { center: foot + Vec3::new(0.0, 0.0, height - radius), radius }]
}

/// What an observer does at an obstacle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Response {
    /// Goes on along it.
    #[default]
    Slide,
    /// Stands still.
    Stop,
}

/// Where a step ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The observer.
    pub to: Vec3,
    /// The first volume that was in the way, by its number.
    pub hit: Option<usize>,
}

/// Volumes that are found by where they are.
#[derive(Clone, Debug, Default)]
pub struct Obstacles {
    volumes: Vec<Volume>,
    squares: BTreeMap<[i64; 2], Vec<u32>>,
}

impl Obstacles {
    /// Obstacles, numbered as they come.
    #[must_use]
    pub fn new(volumes: Vec<Volume>) -> Obstacles {
        let mut squares: BTreeMap<[i64; 2], Vec<u32>> = BTreeMap::new();
        for (number, volume) in volumes.iter().enumerate() {
            for square in squares_of(volume.bounds()) {
                squares.entry(square).or_default().push(number as u32);
            }
        }
        Obstacles { volumes, squares }
    }

    /// The obstacles, by number.
    #[must_use]
    pub fn volumes(&self) -> &[Volume] {
        &self.volumes
    }

    /// The first obstacle that a ball has a point in common with.
    #[must_use]
    pub fn met_by(&self, center: Vec3, radius: f64) -> Option<usize> {
        let ball = Volume::Ball { center, radius };
        self.near(ball.bounds()).find(|&number| self.volumes[number].meets(&ball))
    }

    /// Moves an observer, a ball of `radius`, from `from` towards `to`.
    ///
    /// Goes in short steps, so nothing is jumped over. An observer that begins outside all obstacles ends outside all of them; where it
    /// cannot be pushed out of one without coming into the next, it stays.
    #[must_use]
    pub fn advance(&self, (from, to): (Vec3, Vec3), radius: f64, response: Response) -> Step {
        let way = to - from;
        let steps = (way.length() / (radius * 0.5).max(0.05)).ceil().clamp(1.0, 100_000.0);
        let mut step = Step { to: from, hit: None };
        for _ in 0..steps as u32 {
            let wanted = step.to + way / steps;
            let (settled, hit) = self.settle(wanted, radius);
            step.hit = step.hit.or(hit);
            match (hit, settled, response) {
                (None, _, _) => step.to = wanted,
                (Some(_), Some(settled), Response::Slide) => step.to = settled,
                _ => break,
            }
        }
        step
    }

    /// A place outside all obstacles near `center`, if pushing finds one, and the first obstacle in the way.
    fn settle(&self, mut center: Vec3, radius: f64) -> (Option<Vec3>, Option<usize>) {
        let mut hit = None;
        for _ in 0..PUSHES {
            let bounds = Volume::Ball { center, radius }.bounds();
            let pushed = self
                .near(bounds)
                .find_map(|number| self.volumes[number].pushed_out(center, radius).map(|place| (number, place)));
            let Some((number, place)) = pushed else { return (Some(center), hit) };
            hit = hit.or(Some(number));
            center = place;
        }
        (None, hit)
    }

    /// Numbers of what may be within bounds, in order.
    fn near(&self, bounds: (Vec3, Vec3)) -> impl Iterator<Item = usize> {
        let mut numbers: Vec<u32> =
            squares_of(bounds).filter_map(|square| self.squares.get(&square)).flatten().copied().collect();
        numbers.sort_unstable();
        numbers.dedup();
        numbers.into_iter().map(|number| number as usize)
    }
}

/// The squares under bounds; at most a thousand each way: what is larger stands nowhere.
fn squares_of((low, high): (Vec3, Vec3)) -> impl Iterator<Item = [i64; 2]> {
    let square = |number: f64| (number / SQUARE).floor() as i64;
    let (west, south) = (square(low.x), square(low.y));
    let (east, north) = (square(high.x).min(west.saturating_add(999)), square(high.y).min(south.saturating_add(999)));
    (west..=east).flat_map(move |x| (south..=north).map(move |y| [x, y]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ball(x: f64, y: f64, z: f64, radius: f64) -> Volume {
        Volume::Ball { center: Vec3::new(x, y, z), radius }
    }

    #[test]
    fn volumes_meet_where_they_have_a_point_in_common() {
        let cube = Volume::Box { low: Vec3::ZERO, high: Vec3::splat(2.0) };
        assert!(ball(0.0, 0.0, 0.0, 1.0).meets(&ball(2.0, 0.0, 0.0, 1.0)), "touching counts");
        assert!(!ball(0.0, 0.0, 0.0, 1.0).meets(&ball(2.0, 0.1, 0.0, 1.0)));
        assert!(ball(3.0, 1.0, 1.0, 1.0).meets(&cube) && cube.meets(&ball(1.0, 1.0, 1.0, 0.1)));
        // A corner is farther than the sides it joins.
        assert!(!ball(2.8, 2.8, 1.0, 1.0).meets(&cube) && ball(2.7, 2.7, 1.0, 1.0).meets(&cube));
        assert!(cube.meets(&Volume::Box { low: Vec3::splat(2.0), high: Vec3::splat(3.0) }));
        assert!(!cube.meets(&Volume::Box { low: Vec3::new(0.0, 0.0, 2.1), high: Vec3::splat(3.0) }));
    }

    #[test]
    fn disjoint_volumes_hold_disjoint_points() {
        // Two clouds of points, moved past each other: whenever a point of one is at a point of the other, their volumes meet.
        let cloud: Vec<Vec3> =
            (0..40).map(|n| Vec3::new(f64::from(n * 7 % 11), f64::from(n * 5 % 13), f64::from(n % 3))).collect();
        for step in -30..30 {
            let moved: Vec<Vec3> = cloud.iter().map(|point| *point + Vec3::new(f64::from(step), 1.0, 0.0)).collect();
            let shares = cloud.iter().any(|point| moved.contains(point));
            for of in [Volume::ball_around, Volume::box_around] {
                let meets = of(&cloud).expect("points").meets(&of(&moved).expect("points"));
                assert!(meets || !shares, "step {step}");
            }
        }
    }

    /// A hundred stems, two metres apart.
    fn stand() -> Obstacles {
        let foot = |n: i32| Vec3::new(f64::from(n % 10) * 2.0, f64::from(n / 10) * 2.0, 0.0);
        Obstacles::new((0..100).flat_map(|n| of_tree(foot(n), 12.0, 1.5, Some(5.0))).collect())
    }

    #[test]
    fn an_observer_passes_between_stems_and_never_into_one() {
        let stand = stand();
        let mut hits = 0;
        for n in 0..60 {
            // From the south through the whole stand, also straight at stems.
            let mut eye = Vec3::new(-1.0 + f64::from(n) * 0.35, -3.0, 1.7);
            for _ in 0..120 {
                let step = stand.advance((eye, eye + Vec3::new(0.02, 0.4, 0.0)), 0.3, Response::Slide);
                hits += u32::from(step.hit.is_some());
                eye = step.to;
                assert_eq!(stand.met_by(eye, 0.3), None, "{eye}");
            }
            assert!(eye.y > 20.0, "sliding leads through: {eye}");
        }
        assert!(hits > 20, "{hits}");
    }

    #[test]
    fn stopping_stops_and_nothing_is_jumped_over() {
        let stand = stand();
        let (from, to) = (Vec3::new(0.0, -3.0, 1.7), Vec3::new(0.0, 1000.0, 1.7));
        let step = stand.advance((from, to), 0.3, Response::Stop);
        assert!(step.hit == Some(0) && step.to.y < -0.4 && step.to.y > -0.7, "{step:?}");
        let free = stand.advance((from, Vec3::new(1.0, 1000.0, 1.7)), 0.3, Response::Stop);
        assert_ne!(free.hit, None, "the way is not straight");
        let aside = Vec3::new(1.0, -3.0, 1.7);
        let step = stand.advance((aside, aside + Vec3::new(0.0, 30.0, 0.0)), 0.3, Response::Stop);
        assert_eq!((step.hit, step.to.y.round()), (None, 27.0));
    }

    #[test]
    fn who_stands_in_a_tree_is_led_out_and_who_is_enclosed_stays() {
        let stand = stand();
        let inside = Vec3::new(2.0, 2.0, 1.0);
        let step = stand.advance((inside, inside), 0.3, Response::Slide);
        assert_eq!(stand.met_by(step.to, 0.3), None);
        // Two walls with no room between them.
        let wall = |x: f64| Volume::Box { low: Vec3::new(x, -9.0, -9.0), high: Vec3::new(x + 0.5, 9.0, 9.0) };
        let trap = Obstacles::new(vec![wall(0.0), wall(0.9)]);
        let step = trap.advance((Vec3::new(0.7, 0.0, 0.0), Vec3::new(0.8, 0.0, 0.0)), 0.3, Response::Slide);
        assert_eq!(step.to, Vec3::new(0.7, 0.0, 0.0));
        let nowhere = Obstacles::default().advance((Vec3::ZERO, Vec3::X), 0.0, Response::Stop);
        assert_eq!((nowhere.to.x.round(), nowhere.hit), (1.0, None));
    }
}
