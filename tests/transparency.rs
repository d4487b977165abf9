//! Transparency as the user sees it: exact products, any order, polygons that go through each other. Every rasterizer that
//! fills polygons must show the same.

mod support;

use farop::color::{Encoding, Rgb};
use farop::math::Vec3;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Choices, Culling, DepthFormat, Shading, Transparency};
use farop::raster::{Rasterizer, Scanline, Watkins, ZBuffer};
use farop::render::render;
use farop::scene::{Material, Scene};
use farop::screen::DrawList;
use support::draw_over;
use support::mixed::{meet, weights};
use support::random::Random;
use support::scenes::{camera, facets, scene, surface, world};

const RASTERIZERS: [(&str, &dyn Rasterizer); 3] =
    [("zbuffer", &ZBuffer), ("watkins", &Watkins), ("scanline", &Scanline)];
const LEVEL: f64 = 1.0 / 255.0;

/// What layers (opacity, color; front to back) over `behind` show, written from the two rules.
fn exact(layers: &[(f64, f64)], behind: f64, rule: Transparency) -> f64 {
    match rule {
        Transparency::Over => {
            layers.iter().rev().fold(behind, |light, &(opacity, color)| opacity * color + (1.0 - opacity) * light)
        }
        Transparency::Additive => {
            let (mut light, mut sum) = (0.0, 0.0);
            for &(opacity, color) in layers {
                let share = f64::min(opacity, 1.0 - sum);
                light += share * color;
                sum += share;
            }
            light + (1.0 - sum) * behind
        }
    }
}

#[test]
fn a_thousand_layers_are_the_exact_product() {
    let mut random = Random::new(7);
    for scale in [0.0005, 0.003, 0.02] {
        let layers: Vec<[(f64, f64); 3]> =
            (0..1000).map(|_| [1.0, 2.0, 0.5].map(|factor| (random.unit() * scale * factor, random.unit()))).collect();
        // Drawn in a random order: layer i is the i-th from the front.
        let mut order: Vec<usize> = (0..1000).collect();
        order.sort_by_cached_key(|_| random.bits());
        let mut list = DrawList::new(2, 2);
        for (place, &layer) in order.iter().enumerate() {
            let color = layers[layer].map(|(_, color)| color);
            list.push_flat(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], 1.0 - layer as f64 / 2000.0, color);
            let [r, g, b] = layers[layer].map(|(opacity, _)| opacity as f32);
            list.shader.surfaces[place].opacity = Rgb::new(r, g, b);
        }
        let background = [0.9, 0.5, 0.1];
        for &rule in Transparency::ALL {
            for (name, rasterizer) in RASTERIZERS {
                let sky = Rgb::new(background[0] as f32, background[1] as f32, background[2] as f32);
                let shown = draw_over(&list, rasterizer, sky, rule).0.pixel(1, 1).to_f64().to_array();
                for channel in 0..3 {
                    let own: Vec<_> = layers.iter().map(|layer| layer[channel]).collect();
                    let expected = exact(&own, background[channel], rule);
                    let off = (shown[channel] - expected).abs();
                    assert!(off < LEVEL / 100.0, "{name}, {rule:?}, scale {scale}, channel {channel}: {off}");
                }
            }
        }
    }
}

/// Triangles as text, every one with a surface of its own, two of three transparent.
fn triangles(random: &mut Random, count: usize) -> Vec<String> {
    let triangle = |number: usize| {
        let mut at = || random.between(-2.0, 2.0);
        let corners: String = (0..3).map(|_| format!("{} {} {}\n", at(), at(), at())).collect();
        let through = [0.0, 0.5, 0.75][number % 3];
        format!("f {} {} {} 0.9 0 0 {through} 1\np 3\n{corners}", random.unit(), random.unit(), random.unit())
    };
    (0..count).map(triangle).collect()
}

fn read(polygons: &[String]) -> Scene {
    let view = "b 0.2 0.3 0.4\nv\nfrom 0 0 6\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 40 40\nl 3 4 6\n";
    let text = view.to_string() + &polygons.concat();
    read_nff("shuffled", text.as_bytes(), ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).scene
}

#[test]
fn any_order_of_the_polygons_in_the_file_gives_the_same_bytes() {
    for seed in 1..=25 {
        let mut random = Random::new(seed);
        let mut polygons = triangles(&mut random, 18);
        // In f64 no two of these random planes meet exactly at a sample's center.
        let shading = [Shading::Flat, Shading::Gouraud, Shading::Phong][seed as usize % 3];
        let transparency = Transparency::ALL[seed as usize % 2];
        let choices =
            Choices { depth: DepthFormat::F64, shading, transparency, culling: Culling::None, ..Choices::default() };
        let in_order = read(&polygons);
        for round in 0..3 {
            polygons.sort_by_cached_key(|_| random.bits());
            let shuffled = read(&polygons);
            for (name, rasterizer) in RASTERIZERS {
                let picture = |scene: &Scene| render(scene, &choices, Some(rasterizer)).expect("a usable view").image;
                assert!(picture(&in_order) == picture(&shuffled), "{name}, seed {seed}, round {round}");
            }
        }
    }
}

/// A triangle in eye space with what it shows.
struct Pane {
    corners: [Vec3; 3],
    color: [f64; 3],
    opacity: [f64; 3],
}

/// Triangles that go through each other around one point.
fn panes(random: &mut Random) -> Vec<Pane> {
    let mut three =
        |low: f64, high: f64| [random.between(low, high), random.between(low, high), random.between(low, high)];
    let pane = |number: usize| {
        let mut corner = || Vec3::from_array(three(-1.8, 1.8)) + Vec3::new(0.0, 0.0, 3.5);
        let corners = [corner(), corner(), corner()];
        let opacity = if number % 4 == 3 { [1.0; 3] } else { three(0.1, 0.9) };
        Pane { corners, color: three(0.1, 1.0), opacity }
    };
    (0..9).map(pane).collect()
}

/// What the ray through a sample shows by sorting its meetings in `f64`; `None` too close to an edge or to a meeting of two.
fn by_ray(panes: &[Pane], at: (i32, i32), side: u32, rule: Transparency) -> Option<[f64; 3]> {
    let mut hits: Vec<(f64, &Pane)> = Vec::new();
    for pane in panes {
        let point = meet(pane.corners, at, side);
        let weights = weights(pane.corners, point);
        let least = weights.iter().copied().fold(f64::INFINITY, f64::min);
        if least.abs() < 0.01 {
            return None;
        }
        if least > 0.0 {
            hits.push((point.z, pane));
        }
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    if hits.windows(2).any(|pair| (pair[1].0 - pair[0].0) < 1e-4) {
        return None;
    }
    let wall = hits.iter().position(|hit| hit.1.opacity == [1.0; 3]);
    let behind = wall.map_or(BACKGROUND, |place| hits[place].1.color);
    hits.truncate(wall.unwrap_or(hits.len()));
    let channel = |channel: usize| {
        let layers: Vec<_> = hits.iter().map(|hit| (hit.1.opacity[channel], hit.1.color[channel])).collect();
        exact(&layers, behind[channel], rule)
    };
    Some([0, 1, 2].map(channel))
}

const BACKGROUND: [f64; 3] = [0.25, 0.5, 0.75];

#[test]
fn intersecting_transparent_polygons_are_right_at_each_pixel() {
    let (mut judged, mut skipped, mut deep) = (0, 0, 0);
    let side = 48;
    for seed in 1..=30 {
        let panes = panes(&mut Random::new(seed));
        let surfaces = panes.iter().map(|pane| {
            let [color, opacity] = [pane.color, pane.opacity].map(|[r, g, b]| Rgb::new(r, g, b));
            // Ambient light of 1, reflected whole, and no lamp: the surface shows its color.
            let material = Material { color, opacity, diffuse: 0.0, ambient: Some(1.0), ..Material::default() };
            surface(material, facets(&[pane.corners.map(world).to_vec()]))
        });
        let mut scene = scene(camera(side, side), surfaces.collect());
        scene.lights.clear();
        let [r, g, b] = BACKGROUND;
        scene.background = Some(Rgb::new(r, g, b));
        let transparency = Transparency::ALL[seed as usize % 2];
        let choices =
            Choices { transparency, culling: Culling::None, encoding: Encoding::Linear, ..Choices::default() };
        for (name, rasterizer) in RASTERIZERS {
            let image = render(&scene, &choices, Some(rasterizer)).expect("a usable view").image;
            for (x, y) in (0..side as i32).flat_map(|y| (0..side as i32).map(move |x| (x, y))) {
                let Some(expected) = by_ray(&panes, (x, y), side, transparency) else {
                    skipped += 1;
                    continue;
                };
                let shown = image.pixel(x as usize, y as usize).to_f64().to_array();
                let off = (0..3).map(|channel| (shown[channel] - expected[channel]).abs()).fold(0.0, f64::max);
                assert!(off < LEVEL / 100.0, "{name}, seed {seed}, ({x}, {y}): {shown:?}, by ray {expected:?}");
                judged += 1;
                deep += u32::from(expected != BACKGROUND);
            }
        }
    }
    assert!(judged > 4 * skipped && deep > 20_000, "{judged} judged, {skipped} skipped, {deep} of them with layers");
}
