//! Scene: the relief as surfaces that every rasterizer can draw.
//!
//! Grid, ReliefMesh -SCENE-> Scene
//!
//! Vertices get their place in metres, normals from the faces around them, the larger the more weight (the slope at a single sample
//! would be noise on a coarse relief; and a surface's own mean would break at every band of colors), and colors by height: one surface for every band of heights, because a surface has one color. The colors are a ladder of heights (green,
//! yellow, brown, white), or four grounds that blend as in paper 004: ground i weighs max(0, 1 - |h - c_i| / r_i), and the weights
//! are divided by their sum.
//!
//! Space: world metres, x east, y north, z up; the origin is at sea level below the south-west corner.
//! Source: J. Caralo (paper 004), several textures by height; the formula is ours, the paper has none.

use super::mesh::{Face, ReliefMesh};
use crate::color::Rgb;
use crate::forest::elevation::Grid;
use crate::math::{Affine3, Vec3, newell_normal, radians, tan, unit};
use crate::scene::{
    Camera, Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Polygon, Scene, Surface, SurfaceId,
};

/// What colors a relief.
#[derive(Clone, Debug, PartialEq)]
pub enum Colors {
    /// One gray: only the light shows the form.
    Plain,
    /// The ladder of atlases, from the lowest to the highest sample.
    Ladder,
    /// Grounds that blend by height.
    Blended(Vec<Ground>),
}

/// A ground that shows around one height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Display values.
    pub color: Rgb,
    /// Where it weighs most, in metres.
    pub center: f64,
    /// How far above and below it weighs at all, in metres.
    pub reach: f64,
}

/// Bands of heights, each with a color of its own.
const BANDS: usize = 48;

impl Colors {
    /// Sand, grass, rock and snow, spread evenly over a range of heights.
    #[must_use]
    pub fn four_grounds((low, high): (f64, f64)) -> Colors {
        let colors = [[0.76, 0.70, 0.50], [0.33, 0.50, 0.20], [0.45, 0.42, 0.40], [0.95, 0.96, 0.98]];
        let step = (high - low) / 3.0;
        let ground = |(index, [r, g, b]): (usize, [f64; 3])| Ground {
            color: Rgb::new(r, g, b),
            center: low + step * index as f64,
            reach: step.max(1.0),
        };
        Colors::Blended(colors.into_iter().enumerate().map(ground).collect())
    }

    /// The color at a height within a range.
    #[must_use]
    pub fn at(&self, height: f64, (low, high): (f64, f64)) -> Rgb {
        match self {
            Colors::Plain => Rgb::gray(0.8),
            Colors::Ladder => ladder(if high > low { (height - low) / (high - low) } else { 0.0 }),
            Colors::Blended(grounds) => blended(grounds, height),
        }
    }
}

fn ladder(share: f64) -> Rgb {
    const STEPS: [[f64; 3]; 6] = [
        [0.30, 0.50, 0.28],
        [0.52, 0.65, 0.36],
        [0.85, 0.80, 0.52],
        [0.72, 0.55, 0.36],
        [0.55, 0.45, 0.40],
        [0.97, 0.97, 0.98],
    ];
    let at = share.clamp(0.0, 1.0) * (STEPS.len() - 1) as f64;
    let below = (at as usize).min(STEPS.len() - 2);
    let mix = |channel: usize| {
        let (low, high) = (STEPS[below][channel], STEPS[below + 1][channel]);
        low + (high - low) * (at - below as f64)
    };
    Rgb::new(mix(0), mix(1), mix(2))
}

fn blended(grounds: &[Ground], height: f64) -> Rgb {
    let weight = |ground: &Ground| (1.0 - (height - ground.center).abs() / ground.reach).max(0.0);
    let sum: f64 = grounds.iter().map(weight).sum();
    if sum > 0.0 {
        let mix = |channel: fn(&Rgb) -> f64| grounds.iter().map(|g| weight(g) * channel(&g.color)).sum::<f64>() / sum;
        return Rgb::new(mix(|color| color.r), mix(|color| color.g), mix(|color| color.b));
    }
    // Out of all reaches: the nearest.
    let distance = |ground: &&Ground| (height - ground.center).abs();
    grounds.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map_or(Rgb::gray(0.8), |ground| ground.color)
}

/// The relief as a scene with a sun in the north-west and a camera that sees all of it from above, north up.
#[must_use]
pub fn to_scene(grid: &Grid, mesh: &ReliefMesh, colors: &Colors) -> Scene {
    let range = grid.range().map_or((0.0, 0.0), |(low, high)| (f64::from(low), f64::from(high)));
    let bands = if *colors == Colors::Plain { 1 } else { BANDS };
    let mut by_band: Vec<Vec<&Face>> = vec![Vec::new(); bands];
    for face in &mesh.faces {
        by_band[band(mesh, face, range, bands)].push(face);
    }
    let color = |band: usize| colors.at(range.0 + (range.1 - range.0) * (band as f64 + 0.5) / bands as f64, range);
    of_groups(grid, mesh, by_band, color)
}

/// The relief with one color a face: `group` says which of `colors`; beyond the last one, gray.
#[must_use]
pub fn to_scene_by(grid: &Grid, mesh: &ReliefMesh, colors: &[Rgb], group: impl Fn(&Face) -> usize) -> Scene {
    let mut groups: Vec<Vec<&Face>> = vec![Vec::new(); colors.len() + 1];
    for face in &mesh.faces {
        groups[group(face).min(colors.len())].push(face);
    }
    of_groups(grid, mesh, groups, |group| colors.get(group).copied().unwrap_or(Rgb::gray(0.8)))
}

/// A surface for every group of faces that is not empty.
fn of_groups(grid: &Grid, mesh: &ReliefMesh, groups: Vec<Vec<&Face>>, color: impl Fn(usize) -> Rgb) -> Scene {
    let (placer, place) = (Placer::new(grid, mesh), Place::default());
    let surface = |(group, faces): (usize, Vec<&Face>)| {
        let material = Material { color: color(group), diffuse: 1.0, ..Material::default() };
        Surface { material, mesh: placer.mesh(mesh, &faces), primitives: Vec::new(), two_sided: false, place }
    };
    let filled = groups.into_iter().enumerate().filter(|(_, faces)| !faces.is_empty());
    let surfaces: Vec<Surface> = filled.map(surface).collect();
    let object = Object {
        name: "relief".to_string(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: Vec::new(),
        place,
    };
    Scene {
        facing: std::collections::BTreeSet::new(),
        textures: Vec::new(),
        files: vec![grid.name.clone()],
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![sun(grid)],
        camera: Some(from_above(grid)),
        background: Some(Rgb::new(0.72, 0.82, 0.92)),
    }
}

/// A lamp so far in the north-west, 30 degrees high, that its rays are parallel to a thousandth: NFF has no other sun.
fn sun(grid: &Grid) -> Light {
    let [width, height] = grid.extent();
    let far = 1000.0 * width.max(height);
    Light::point(Vec3::new(-far, far, 0.82 * far), Rgb::WHITE, Place::default())
}

/// Which band of heights a face belongs to, by the mean of its corners.
fn band(mesh: &ReliefMesh, face: &Face, (low, high): (f64, f64), bands: usize) -> usize {
    let outline = mesh.outline(face);
    let mean = outline.iter().map(|&at| mesh.vertices[at as usize].height).sum::<f64>() / outline.len() as f64;
    let share = if high > low { (mean - low) / (high - low) } else { 0.0 };
    ((share * bands as f64) as usize).min(bands - 1)
}

/// The camera that [`to_scene`] gives: above the middle, far enough to see all, north up.
#[must_use]
pub fn from_above(grid: &Grid) -> Camera {
    let [width, height] = grid.extent();
    let top = grid.range().map_or(0.0, |(_, high)| f64::from(high));
    let angle = 20.0;
    let (wide, high) = (width.max(1.0), height.max(1.0));
    // The picture has the map's own proportions, 512 pixels along the longer side.
    let resolution = if wide >= high {
        (512, ((512.0 * high / wide).round() as u32).max(1))
    } else {
        (((512.0 * wide / high).round() as u32).max(1), 512)
    };
    let distance = 1.02 * (wide.min(high) / 2.0) / tan(radians(angle) / 2.0);
    let middle = Vec3::new(width / 2.0, height / 2.0, 0.0);
    Camera {
        from: middle + Vec3::Z * (top + distance),
        at: middle,
        up: Vec3::Y,
        angle,
        hither: distance / 100.0,
        yon: None,
        resolution,
        place: Place::default(),
    }
}

/// A camera south of the relief that looks north across it, half as high above it as it is wide.
#[must_use]
pub fn from_south(grid: &Grid) -> Camera {
    let [width, height] = grid.extent();
    let top = grid.range().map_or(0.0, |(_, high)| f64::from(high));
    let large = width.max(height);
    Camera {
        from: Vec3::new(width / 2.0, -0.55 * height, top + 0.5 * large),
        at: Vec3::new(width / 2.0, 0.42 * height, 0.0),
        up: Vec3::Z,
        angle: 40.0,
        hither: large / 1000.0,
        yon: None,
        resolution: (640, 480),
        place: Place::default(),
    }
}

/// Where vertices of the mesh are in the world.
struct Placer {
    places: Vec<Vec3>,
    normals: Vec<Vec3>,
}

impl Placer {
    fn new(grid: &Grid, mesh: &ReliefMesh) -> Placer {
        let [dx, dy] = grid.spacing();
        let last = (grid.rows() - 1) as f64;
        let place = |vertex: &super::mesh::Vertex| {
            Vec3::new(f64::from(vertex.point.x) * dx, (last - f64::from(vertex.point.y)) * dy, vertex.height)
        };
        let places: Vec<Vec3> = mesh.vertices.iter().map(place).collect();
        let mut sums = vec![Vec3::ZERO; places.len()];
        for face in &mesh.faces {
            let outline: Vec<Vec3> = mesh.outline(face).iter().map(|&at| places[at as usize]).collect();
            let normal = newell_normal(&outline);
            mesh.outline(face).iter().for_each(|&at| sums[at as usize] += normal);
        }
        let normals = sums.into_iter().map(|sum| unit(sum).unwrap_or(Vec3::Z)).collect();
        Placer { places, normals }
    }

    /// Faces as the polygons of one surface, over the vertices that they use.
    fn mesh(&self, mesh: &ReliefMesh, faces: &[&Face]) -> Mesh {
        let mut index = std::collections::HashMap::new();
        let mut made = Mesh::default();
        for face in faces {
            let start = made.outlines.len() as u32;
            for &at in mesh.outline(face) {
                let own = *index.entry(at).or_insert_with(|| {
                    made.vertices.push(self.places[at as usize]);
                    made.normals.push(self.normals[at as usize]);
                    (made.vertices.len() - 1) as u32
                });
                made.outlines.push(own);
            }
            made.polygons.push(Polygon { start, count: face.count, line: 0, normals: NormalSource::Given });
        }
        made
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{grid, hills};
    use super::super::{Hierarchy, mesh};
    use super::*;

    #[test]
    fn faces_look_up_and_lie_where_the_samples_are() {
        let grid = hills(20, 13);
        let mesh = mesh::within(&Hierarchy::new(&grid), 12.0);
        let scene = to_scene(&grid, &mesh, &Colors::Ladder);
        let mut polygons = 0;
        for surface in &scene.surfaces {
            for polygon in &surface.mesh.polygons {
                let outline: Vec<Vec3> =
                    surface.mesh.outline(polygon).iter().map(|&at| surface.mesh.vertices[at as usize]).collect();
                assert!(crate::math::newell_normal(&outline).z > 0.0);
                polygons += 1;
            }
            assert!(surface.mesh.normals.iter().all(|normal| normal.z > 0.0));
        }
        assert_eq!(polygons, mesh.faces.len());
        let corner =
            scene.surfaces.iter().flat_map(|surface| &surface.mesh.vertices).find(|v| v.x == 0.0 && v.y == 0.0);
        assert_eq!(corner.map(|corner| corner.z), Some(f64::from(grid.height(0, 12))), "the south-west corner");
    }

    #[test]
    fn a_slope_to_the_east_leans_its_normal_west() {
        let grid = grid(9, 9, |x, _| 30.0 * x as f32);
        let mesh = mesh::within(&Hierarchy::new(&grid), 1.0);
        let scene = to_scene(&grid, &mesh, &Colors::Plain);
        let half = 0.5_f64.sqrt();
        assert!(
            scene.surfaces[0]
                .mesh
                .normals
                .iter()
                .all(|normal| (*normal - Vec3::new(-half, 0.0, half)).length() < 1e-12)
        );
    }

    #[test]
    fn four_grounds_blend_and_never_vanish() {
        let colors = Colors::four_grounds((0.0, 3000.0));
        assert_eq!(colors.at(1000.0, (0.0, 3000.0)), Rgb::new(0.33, 0.50, 0.20), "in the middle of a ground");
        let between = colors.at(1500.0, (0.0, 3000.0));
        assert!((between.g - 0.46).abs() < 1e-9, "{between:?}");
        assert_eq!(colors.at(9000.0, (0.0, 3000.0)), Rgb::new(0.95, 0.96, 0.98));
    }
}
