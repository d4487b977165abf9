//! forest: trees as two crossed quads with one picture that has holes, on hills, seen from among the tops of the nearest.
//!
//! Trees stand at random in a sector of 2 km, evenly per area, and come cell by cell as on a map (cells of 240 m), the way a program that reads
//! cells draws them. Most samples are covered many times over, and half of what covers them is air.
//!
//! World space: z up, metres; the eye looks along +y. Own design; sizes and cells as in the forests of Landscaper (2004).

use super::lens::{color, perspective, single, view};
use crate::math::{Vec3, cos, radians, sin};
use crate::scene::{TriangleKind, TriangleRange, Triangles};

/// Names of the sizes (trees) and their triangles, the default first.
pub(super) const SIZES: [(&str, u64); 3] = [("10k", 42_368), ("1k", 6_368), ("125k", 502_368)];

/// Trees of each of the sizes.
const TREES: [u32; 3] = [10_000, 1_000, 125_000];
/// How far trees stand, metres.
const HORIZON: f64 = 2000.0;
/// Half of the sector, degrees: a little more than a square picture sees.
const HALF_SECTOR: f64 = 45.0;
/// Metres of a cell's side.
const CELL: f64 = 240.0;
/// Strips of the ground around the eye, and rings from it on.
const GROUND: (u32, u32) = (32, 37);
/// Texels of a side of the picture.
const TEXELS: u32 = 128;

/// The scene of the size at that place in [`SIZES`].
pub(super) fn make(size: usize) -> Triangles {
    let from = Vec3::new(0.0, 0.0, height(0.0, 0.0) + 14.0);
    let mut made = Triangles {
        view: view(from, from + Vec3::new(0.0, 300.0, -24.0), Vec3::Z),
        projection: perspective(80.0, 1.0, 2500.0),
        eye: single(from),
        background: [0.62, 0.74, 0.88],
        material: [0.35, 0.65, 0.0, 1.0],
        lights: vec![([3000.0, -2000.0, 6000.0], [1.0; 3])],
        texture_size: (TEXELS, TEXELS),
        texels: tree_picture(),
        ..Triangles::default()
    };
    ground(&mut made);
    let first = made.indices.len() as u32;
    trees(TREES[size], &mut made);
    made.ranges = vec![
        TriangleRange { first: 0, count: first, kind: TriangleKind::Lit },
        TriangleRange { first, count: made.indices.len() as u32 - first, kind: TriangleKind::Textured },
    ];
    made
}

/// Height of the hills.
fn height(x: f64, y: f64) -> f64 {
    14.0 * sin(x / 170.0 + 0.4) * cos(y / 240.0) + 5.0 * sin(y / 90.0)
}

/// Rings around the eye, each wider than the one before.
fn ground(made: &mut Triangles) {
    let (strips, rings) = GROUND;
    for ring in 0..=rings {
        let share = f64::from(ring) / f64::from(rings);
        let distance = 1.0 + (HORIZON + 200.0) * share * share;
        for strip in 0..=strips {
            let angle = radians(2.0 * HALF_SECTOR * (f64::from(strip) / f64::from(strips) - 0.5) * 1.2);
            let (x, y) = (distance * sin(angle), distance * cos(angle));
            let slope = |dx: f64, dy: f64| height(x + dx, y + dy) - height(x - dx, y - dy);
            made.positions.push(single(Vec3::new(x, y, height(x, y))));
            made.normals.push(single(Vec3::new(-slope(1.0, 0.0), -slope(0.0, 1.0), 2.0).normalize()));
            let [r, g, b] = color(u64::from(ring * 64 + strip), 0.7);
            made.colors.push([0.35 * r, 0.45 * g, 0.2 * b]);
            made.texture.push([0.0; 2]);
        }
    }
    for ring in 0..rings {
        for strip in 0..strips {
            let a = ring * (strips + 1) + strip;
            let (b, c, d) = (a + 1, a + strips + 2, a + strips + 1);
            made.indices.extend([a, b, c, a, c, d]);
        }
    }
}

/// A tree before it has vertices.
struct Tree {
    foot: Vec3,
    height: f64,
    /// Half of its width, to the right.
    aside: Vec3,
    tint: [f32; 3],
}

fn trees(count: u32, made: &mut Triangles) {
    let mut all: Vec<Tree> = (0..u64::from(count)).map(tree).collect();
    // As on a map: by rows of cells; what is in one cell stays as it came.
    let cell = |along: f64| (along / CELL).floor() as i64;
    all.sort_by_key(|tree| (cell(tree.foot.y), cell(tree.foot.x)));
    for Tree { foot, height, aside, tint } in all {
        let up = Vec3::new(0.0, 0.0, height);
        for aside in [aside, Vec3::new(-aside.y, aside.x, 0.0)] {
            let first = made.positions.len() as u32;
            let corners = [foot - aside, foot + aside, foot + aside + up, foot - aside + up];
            made.positions.extend(corners.map(single));
            made.normals.extend([[0.0, 0.0, 1.0]; 4]);
            made.colors.extend([tint; 4]);
            made.texture.extend([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
            made.indices.extend([0, 1, 2, 0, 2, 3].map(|corner| first + corner));
        }
    }
}

fn tree(number: u64) -> Tree {
    let [angle, distance, turn] = color(3 * number + 1_000_000, 0.0).map(f64::from);
    let [tall, wide, _] = color(3 * number + 1_000_001, 0.0).map(f64::from);
    let angle = radians(HALF_SECTOR * (2.0 * angle - 1.0));
    // The root spreads trees evenly over the area.
    let distance = 6.0 + (HORIZON - 6.0) * distance.sqrt();
    let (x, y) = (distance * sin(angle), distance * cos(angle));
    let tree_height = 8.0 + 8.0 * tall;
    let (half, turn) = (0.5 * tree_height * (0.4 + 0.15 * wide), radians(180.0 * turn));
    Tree {
        foot: Vec3::new(x, y, height(x, y)),
        height: tree_height,
        aside: Vec3::new(half * cos(turn), half * sin(turn), 0.0),
        tint: color(3 * number + 1_000_002, 0.75),
    }
}

/// A fir: a trunk, and branches that get shorter upward, with air between the needles. Rows from the foot.
fn tree_picture() -> Vec<u8> {
    let texel = |index: u32| -> [u8; 4] {
        let (column, row) = (index % TEXELS, index / TEXELS);
        let along = |texel: u32| (f64::from(texel) + 0.5) / f64::from(TEXELS);
        let (aside, up) = ((2.0 * along(column) - 1.0).abs(), along(row));
        let [needles, shade, _] = color(u64::from(index), 0.0);
        let whorl = (up * 11.0).fract();
        let reach = 0.95 * (1.0 - up) * (1.0 - 0.45 * whorl);
        let light = |level: f32| (level * (0.7 + 0.3 * shade)) as u8;
        if up > 0.1 && aside < reach && needles > 0.2 {
            [light(60.0), light(120.0), light(50.0), 255]
        } else if aside < 0.05 * (1.0 - up) {
            [light(110.0), light(80.0), light(50.0), 255]
        } else {
            [0; 4]
        }
    };
    (0..TEXELS * TEXELS).flat_map(texel).collect()
}
