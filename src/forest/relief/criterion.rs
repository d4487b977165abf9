//! Criteria: which diamonds are worth halving.
//!
//! Hierarchy, observer -CRITERION-> score of a diamond; above 1 it is halved
//!
//! Every score here grows from children to parents. That is what makes the mesh without cracks unique: the diamonds with a score above 1 are
//! closed upwards, whoever collects them, from scratch or from the mesh of the last frame.
//!
//! To make a score that depends on the eye grow, every diamond has a sphere around its middle that holds its triangles and
//! the spheres of its children: no child is nearer to the eye, or more within the view, than its parents.
//!
//! Space: world metres, as [`super::scene`] places the relief. Sources: P. Lindstrom, V. Pascucci, "Visualization of Large Terrains Made
//! Easy", IEEE Visualization 2001, 363-370 (nested spheres); M. Cifuentes et al. (the three factors).
//! Cost: one visit of every diamond to build, a square root a score.

use super::hierarchy::Hierarchy;
use super::lattice::{Field, Lattice, Point, level};
use super::scan::rows;
use crate::math::{Vec3, radians, tan};
use crate::scene::Camera;

/// Says what is worth halving.
pub trait Criterion {
    /// Above 1: the diamond of `middle` is to be halved. Never below the score of a child; not negative, not NaN.
    fn score(&self, middle: Point) -> f64;
}

/// The same error in metres everywhere.
#[derive(Clone, Copy, Debug)]
pub struct ByError<'a> {
    /// The bounds.
    pub hierarchy: &'a Hierarchy<'a>,
    /// Metres, above 0.
    pub error: f64,
}

impl Criterion for ByError<'_> {
    fn score(&self, middle: Point) -> f64 {
        f64::from(self.hierarchy.bound(middle)) / self.error
    }
}

/// Spheres around middles that hold all below.
#[derive(Clone, Debug)]
pub struct Spheres<'a> {
    hierarchy: &'a Hierarchy<'a>,
    spacing: [f64; 2],
    radii: Field<f32>,
}

impl<'a> Spheres<'a> {
    /// The spheres of every diamond.
    #[must_use]
    pub fn new(hierarchy: &'a Hierarchy<'a>) -> Spheres<'a> {
        let lattice = hierarchy.lattice;
        let mut spheres = Spheres { hierarchy, spacing: hierarchy.grid.spacing(), radii: Field::new(&lattice, 0.0) };
        lattice.from_the_smallest(|middle| {
            let center = spheres.center(middle);
            let corners = lattice.triangles(middle).flat_map(|triangle| [triangle.a, triangle.b, triangle.apex]);
            let own = corners.map(|corner| (spheres.center(corner) - center).length()).fold(0.0, f64::max);
            let below = lattice
                .children(middle)
                .map(|child| (spheres.center(child) - center).length() + f64::from(spheres.radii.at(child)));
            // Rounded up: sums of rounded roots must not leave a child outside by a last bit.
            let radius = below.fold(own, f64::max) as f32;
            spheres.radii.set(middle, radius.next_up().next_up());
        });
        spheres
    }

    /// Where a point of the relief is, in world metres; a void is at sea level.
    #[must_use]
    pub fn center(&self, point: Point) -> Vec3 {
        let Lattice { south, .. } = self.hierarchy.lattice;
        let height = self.hierarchy.height(point);
        let (x, y) = (f64::from(point.x), f64::from(south) - f64::from(point.y));
        Vec3::new(x * self.spacing[0], y * self.spacing[1], if height.is_nan() { 0.0 } else { height })
    }

    /// The radius of the sphere around a middle.
    #[must_use]
    pub fn radius(&self, middle: Point) -> f64 {
        f64::from(self.radii.at(middle))
    }

    /// The radii alone, for whoever keeps the grid himself.
    #[must_use]
    pub fn into_radii(self) -> Field<f32> {
        self.radii
    }

    /// How far the sphere of a middle is from a place; 0 within.
    fn distance(&self, middle: Point, place: Vec3) -> f64 {
        ((self.center(middle) - place).length() - self.radius(middle)).max(0.0)
    }
}

/// The eye, and what it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer {
    /// World metres.
    pub eye: Vec3,
    /// Pixels that a length of 1 has at distance 1.
    pub focal: f64,
    /// Unit normals of the planes through the eye that bound the view, pointing inward; zero normals bound nothing.
    pub sides: [Vec3; 4],
}

impl Observer {
    /// The observer of a camera with a picture of `size` pixels. Looking straight along `up`, all directions are seen.
    #[must_use]
    pub fn new(camera: &Camera, (width, height): (u32, u32)) -> Observer {
        let (width, height) = (f64::from(width.max(1)), f64::from(height.max(1)));
        let half = tan(radians(camera.angle) / 2.0);
        let per_pixel = 2.0 * half / width.min(height);
        let ahead = (camera.at - camera.from).normalize_or_zero();
        let right = ahead.cross(camera.up).normalize_or_zero();
        let above = right.cross(ahead);
        let (across, upward) = (per_pixel * width / 2.0, per_pixel * height / 2.0);
        let side = |outward: Vec3, slope: f64| (ahead * slope - outward).normalize_or_zero();
        let sides = [side(right, across), side(-right, across), side(above, upward), side(-above, upward)];
        let sides = if right == Vec3::ZERO { [Vec3::ZERO; 4] } else { sides };
        Observer { eye: camera.from, focal: 1.0 / per_pixel, sides }
    }

    /// Whether a sphere reaches into the view.
    #[must_use]
    pub fn sees(&self, center: Vec3, radius: f64) -> bool {
        self.sides.iter().all(|side| side.dot(center - self.eye) >= -radius)
    }
}

/// The error as the eye sees it, in pixels; what is not in view stays coarse.
#[derive(Clone, Copy, Debug)]
pub struct FromEye<'a> {
    /// The bounds.
    pub hierarchy: &'a Hierarchy<'a>,
    /// Where the diamonds are.
    pub spheres: &'a Spheres<'a>,
    /// Who looks.
    pub observer: Observer,
    /// Pixels, above 0.
    pub tolerance: f64,
}

impl Criterion for FromEye<'_> {
    fn score(&self, middle: Point) -> f64 {
        let bound = f64::from(self.hierarchy.bound(middle));
        let radius = self.spheres.radius(middle);
        if bound == 0.0 || !self.observer.sees(self.spheres.center(middle), radius) {
            return 0.0;
        }
        // An upright error of `bound` looks at most this large; within its sphere it may look any size.
        bound * self.observer.focal / (self.spheres.distance(middle, self.observer.eye) * self.tolerance)
    }
}

/// The paper's three factors, as shares of the largest there is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors {
    /// Triangles with a hypotenuse below this share of the terrain's diagonal stay whole.
    pub size: f64,
    /// So do those farther from the observer than this share of the farthest point.
    pub distance: f64,
    /// And those less curved than this share of the most curved of their size; the share falls towards the observer.
    pub curvature: f64,
}

impl Default for Factors {
    /// Those of the paper's figure 6.
    fn default() -> Self {
        Factors { size: 0.01, distance: 0.8, curvature: 0.2 }
    }
}

/// The paper's criterion: halve what is close *and* large enough *and* not plane.
///
/// Curvature is the sum of |Laplacian| times cell area over a triangle, in metres. The paper leaves its formula and the maximum
/// it is compared with open: here it is compared with the most curved triangle of the same size, and grows towards the roots.
#[derive(Clone, Debug)]
pub struct ThreeFactors<'a> {
    spheres: &'a Spheres<'a>,
    /// Curvature as a share of the largest at its level, or that of a child if larger.
    shares: Field<f32>,
    factors: Factors,
    eye: Vec3,
    /// The farthest corner of the terrain from the eye.
    farthest: f64,
    /// Length of the terrain's diagonal, in metres.
    diagonal: f64,
}

impl<'a> ThreeFactors<'a> {
    /// Measures the curvature of every diamond.
    #[must_use]
    pub fn new(spheres: &'a Spheres<'a>, factors: Factors, eye: Vec3) -> ThreeFactors<'a> {
        let hierarchy = spheres.hierarchy;
        let lattice = hierarchy.lattice;
        let sums = curvature_sums(hierarchy);
        let mut own = Field::new(&lattice, 0.0_f32);
        let mut largest = [0.0_f32; 64];
        lattice.from_the_smallest(|middle| {
            let triangles = lattice.triangles(middle).map(|triangle| {
                let mut sum = 0.0;
                rows(&triangle, (lattice.east, lattice.south), |y, first, last| {
                    let row = &sums[y as usize];
                    sum += row[last as usize + 1] - row[first as usize];
                });
                sum
            });
            let curvature = triangles.fold(0.0, f64::max) as f32;
            own.set(middle, curvature);
            largest[level(middle)] = largest[level(middle)].max(curvature);
        });
        let mut shares = Field::new(&lattice, 0.0_f32);
        lattice.from_the_smallest(|middle| {
            let share = own.at(middle) / largest[level(middle)].max(f32::MIN_POSITIVE);
            let below = lattice.children(middle).map(|child| shares.at(child));
            let share = below.fold(share, f32::max);
            shares.set(middle, share);
        });
        let mut this = ThreeFactors { spheres, shares, factors, eye, farthest: 0.0, diagonal: 0.0 };
        let [width, height] = hierarchy.grid.extent();
        this.diagonal = (width * width + height * height).sqrt();
        this.move_to(eye);
        this
    }

    /// Moves the observer.
    pub fn move_to(&mut self, eye: Vec3) {
        let lattice = self.spheres.hierarchy.lattice;
        let corners = [(0, 0), (lattice.east, 0), (0, lattice.south), (lattice.east, lattice.south)];
        let distance = |(x, y)| (self.spheres.center(Point { x, y }) - eye).length();
        self.farthest = corners.map(distance).into_iter().fold(0.0, f64::max);
        self.eye = eye;
    }

    /// Length of the hypotenuse of a diamond on the map, in metres.
    fn size(&self, middle: Point) -> f64 {
        let Some(diamond) = self.spheres.hierarchy.lattice.diamond(middle) else { return 0.0 };
        let [dx, dy] = self.spheres.spacing;
        let across = f64::from(diamond.a.x.abs_diff(diamond.b.x)) * dx;
        let along = f64::from(diamond.a.y.abs_diff(diamond.b.y)) * dy;
        (across * across + along * along).sqrt()
    }
}

impl Criterion for ThreeFactors<'_> {
    fn score(&self, middle: Point) -> f64 {
        let distance = self.spheres.distance(middle, self.eye);
        let is_close = distance <= self.factors.distance * self.farthest;
        if !is_close || self.size(middle) < self.factors.size * self.diagonal {
            return 0.0;
        }
        let share = f64::from(self.shares.at(middle));
        let limit = self.factors.curvature * distance / self.farthest.max(f64::MIN_POSITIVE);
        if share == 0.0 { 0.0 } else { share / limit }
    }
}

/// Sums along every row of |Laplacian| times cell area, in metres: entry i is the sum of the first i samples. Voids are plane.
fn curvature_sums(hierarchy: &Hierarchy<'_>) -> Vec<Vec<f64>> {
    let grid = hierarchy.grid;
    let [dx, dy] = grid.spacing();
    let (columns, rows) = (grid.columns(), grid.rows());
    let height = |x: usize, y: usize| f64::from(grid.height(x, y));
    // One-sided at the border: the nearest second difference there is.
    let second = |at: usize, count: usize, value: &dyn Fn(usize) -> f64| {
        if count < 3 {
            return 0.0;
        }
        let middle = at.clamp(1, count - 2);
        value(middle - 1) - 2.0 * value(middle) + value(middle + 1)
    };
    let at = |x: usize, y: usize| {
        let across = second(x, columns, &|x| height(x, y)) / (dx * dx);
        let along = second(y, rows, &|y| height(x, y)) / (dy * dy);
        let curvature = (across + along).abs() * dx * dy;
        if curvature.is_nan() { 0.0 } else { curvature }
    };
    let sums = |y: usize| {
        let mut sums = vec![0.0; columns + 1];
        (0..columns).for_each(|x| sums[x + 1] = sums[x] + at(x, y));
        sums
    };
    (0..rows).map(sums).collect()
}
