//! flake: the sphereflake of the database `balls`, every sphere cut into the same number of triangles, over its floor.
//!
//! Spheres of one color each, shared vertices, radial normals. Camera, lights and sky are those of `balls`.

use super::lens::{color, perspective, single, view};
use crate::math::{PI, Vec3, cos, sin};
use crate::scene::{TriangleKind, TriangleRange, Triangles};
use crate::spd::balls::for_each_ball;

/// Names of the sizes and their triangles, the default first.
pub(super) const SIZES: [(&str, u64); 5] =
    [("10k", 10_194), ("1k", 962), ("100k", 98_402), ("1m", 1_033_342), ("10m", 9_300_202)];

/// Depth of the flake, sectors and zones of a sphere, for each of the sizes.
const CUTS: [(u32, u32, u32); 5] = [(2, 8, 8), (1, 8, 7), (3, 10, 7), (4, 10, 8), (5, 10, 8)];

/// The scene of the size at that place in [`SIZES`].
pub(super) fn make(size: usize) -> Triangles {
    let (depth, sectors, zones) = CUTS[size];
    let from = Vec3::new(2.1, 1.3, 1.7);
    let mut made = Triangles {
        view: view(from, Vec3::ZERO, Vec3::Z),
        projection: perspective(45.0, 0.5, 30.0),
        eye: single(from),
        background: [0.078, 0.361, 0.753],
        material: [0.1, 0.7, 0.5, 20.0],
        lights: [[4.0, 3.0, 2.0], [1.0, -4.0, 4.0], [-3.0, 1.0, 5.0]].map(|at| (at, [0.57; 3])).to_vec(),
        ..Triangles::default()
    };
    let sphere = Sphere::new(sectors, zones);
    let mut number = 0;
    for_each_ball(depth, &mut |center, radius| {
        sphere.append(center, radius, color(number, 0.35), &mut made);
        number += 1;
    });
    floor(&mut made);
    made.texture = vec![[0.0; 2]; made.positions.len()];
    made.ranges = vec![TriangleRange { first: 0, count: made.indices.len() as u32, kind: TriangleKind::Lit }];
    made
}

/// A unit sphere around the origin, poles at +z and -z, outlines counterclockwise from outside.
struct Sphere {
    directions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Sphere {
    fn new(sectors: u32, zones: u32) -> Sphere {
        let mut directions = vec![Vec3::Z];
        for ring in 1..zones {
            let from_pole = PI * f64::from(ring) / f64::from(zones);
            directions.extend((0..sectors).map(|sector| {
                let around = 2.0 * PI * f64::from(sector) / f64::from(sectors);
                let radius = sin(from_pole);
                Vec3::new(radius * cos(around), radius * sin(around), cos(from_pole))
            }));
        }
        directions.push(Vec3::NEG_Z);
        let south = directions.len() as u32 - 1;
        // Ring 0 is the one below the north pole.
        let at = |ring: u32, sector: u32| 1 + ring * sectors + sector % sectors;
        let mut triangles = Vec::new();
        for sector in 0..sectors {
            triangles.push([0, at(0, sector), at(0, sector + 1)]);
            for ring in 0..zones - 2 {
                let [a, b, c, d] =
                    [at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1), at(ring, sector + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
            triangles.push([south, at(zones - 2, sector + 1), at(zones - 2, sector)]);
        }
        Sphere { directions, triangles }
    }

    fn append(&self, center: Vec3, radius: f64, color: [f32; 3], made: &mut Triangles) {
        let first = made.positions.len() as u32;
        made.positions.extend(self.directions.iter().map(|&direction| single(center + direction * radius)));
        made.normals.extend(self.directions.iter().map(|&direction| single(direction)));
        made.colors.resize(made.positions.len(), color);
        made.indices.extend(self.triangles.iter().flatten().map(|index| first + index));
    }
}

/// The square that the flake hovers over, as in `balls`.
fn floor(made: &mut Triangles) {
    let first = made.positions.len() as u32;
    made.positions.extend([(12.0, 12.0), (-12.0, 12.0), (-12.0, -12.0), (12.0, -12.0)].map(|(x, y)| [x, y, -0.5]));
    made.normals.extend([[0.0, 0.0, 1.0]; 4]);
    made.colors.extend([[1.0, 0.75, 0.33]; 4]);
    made.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
}
