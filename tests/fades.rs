//! Fades and mosaics, from the scene to the bytes: nothing twice and nothing missing, every place its own picture.

mod support;

use farop::color::{Encoding, Rgb};
use farop::image::Image;
use farop::image::textures::{FirstRow, Mosaic, Rgba, Texels, Tile, Wrap};
use farop::math::Vec3;
use farop::plan::{AlphaRule, Choices, DepthFormat, Interpolation, Shading, TextureFilter};
use farop::raster::{Fast, Rasterizer, Watkins, ZBuffer};
use farop::render::{Canvas, draw, list, render};
use farop::scene::{Fade, Material, Mesh, NormalSource, Reflection, Scene, Texture, TextureId};
use farop::screen::DrawList;
use farop::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use farop::snapshot::assert_picture;
use farop::write::write_sipp;
use std::path::Path;
use std::sync::Arc;
use support::scenes::{camera, scene, surface, world};

fn glowing(texture: u32) -> Material {
    let (ambient, diffuse, reflection) = (Some(1.0), 0.0, Reflection::Phong);
    Material { reflection, ambient, diffuse, texture: Some(TextureId(texture)), ..Material::default() }
}

/// A quad of eye-space corners, counterclockwise from the one at u, v = 0; `line` is the number of the thing it stands for.
fn quad(mesh: &mut Mesh, corners: [[f64; 3]; 4], line: u32) {
    let indices = corners.map(|eye| mesh.push_vertex(world(Vec3::from(eye))));
    mesh.texture.resize(mesh.vertices.len(), Vec3::ZERO);
    for (index, place) in indices.into_iter().zip([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]) {
        mesh.texture[index as usize] = Vec3::new(place.0, place.1, 0.0);
    }
    mesh.push_polygon(&indices, NormalSource::Facet, line);
}

fn screen(w: f64, line: u32) -> Mesh {
    let mut mesh = Mesh::default();
    quad(&mut mesh, [[-w, -w, w], [w, -w, w], [w, w, w], [-w, w, w]], line);
    mesh
}

fn even(color: Rgba) -> Texels {
    Texels::new(1, 1, vec![color], FirstRow::AtV0).expect("a texel")
}

fn with_pictures(side: u32, meshes: Vec<(Mesh, Material)>, textures: Vec<Texture>) -> Scene {
    let surfaces = meshes.into_iter().map(|(mesh, material)| surface(material, mesh)).collect();
    Scene { lights: Vec::new(), textures, ..scene(camera(side, side), surfaces) }
}

fn linear() -> Choices {
    Choices { encoding: Encoding::Linear, threads: Some(1), ..Choices::default() }
}

fn picture(scene: &Scene, choices: &Choices) -> Image {
    render(scene, choices, Some(&ZBuffer)).unwrap_or_else(|error| panic!("{error}")).image
}

const RED: Rgba = [255, 0, 0, 255];
const GREEN: Rgba = [0, 255, 0, 255];

/// A red and a green quad that stand for one thing, at different distances, and a blue one behind.
fn crossing(side: u32, k: u8, line: u32, cut_out: bool) -> Scene {
    let make = |color| {
        let texels = even(color);
        if cut_out { Texture::cut_out("even", texels, 0.5) } else { Texture::opaque("even", texels) }
    };
    let blue = Material { texture: None, color: Rgb::new(0.0, 0.0, 1.0), ..glowing(0) };
    let meshes = vec![(screen(3.0, line), glowing(0)), (screen(2.0, line), glowing(1)), (screen(5.0, 1), blue)];
    with_pictures(side, meshes, vec![make(RED).faded(0, k), make(GREEN).faded(k, 16)])
}

#[test]
fn two_that_cross_cover_every_sample_once() {
    for (k, line, cut_out) in (0..=16).flat_map(|k| [(k, 77, false), (k, u32::from(k) + 3, true)]) {
        let scene = crossing(8, k, line, cut_out);
        for samples in [1, 2, 4] {
            let drawn = picture(&scene, &Choices { samples, alpha: AlphaRule::Test, ..linear() });
            let mut reds = 0.0;
            for pixel in drawn.pixels() {
                assert!(pixel.b == 0.0 && (pixel.r + pixel.g - 1.0).abs() < 1e-6, "{k} {samples}: {pixel:?}");
                reds += pixel.r;
                // A pixel of 4 x 4 samples has every rank.
                let exact = samples < 4 || (pixel.r - f32::from(k) / 16.0).abs() < 1e-6;
                assert!(exact, "{k}: {pixel:?}");
            }
            assert!((reds / 64.0 - f32::from(k) / 16.0).abs() < 1e-6, "{k} {samples}: {reds}");
        }
    }
}

#[test]
fn a_fade_comes_before_alpha_and_leaves_depth_alone() {
    // Half is there by alpha, half by the fade: together a quarter, on average over things.
    let mut shown = 0.0;
    for line in 0..64 {
        let veil = Texture::cut_out("veil", even([255, 255, 255, 128]), 0.5).faded(0, 8);
        let scene = with_pictures(4, vec![(screen(2.0, line), glowing(0))], vec![veil]);
        let drawn = picture(&scene, &Choices { samples: 4, ..linear() });
        shown += drawn.pixels().iter().map(|pixel| pixel.r).sum::<f32>() / 16.0 / 64.0;
    }
    assert!((shown - 0.25).abs() < 0.03, "{shown}");
    // What is not shown hides nothing behind it, in either order.
    for first in [false, true] {
        let (near, far) = ((screen(2.0, 9), glowing(0)), (screen(4.0, 9), glowing(1)));
        let meshes = if first { vec![near, far] } else { vec![far, near] };
        let textures = vec![Texture::opaque("near", even(RED)).faded(4, 12), Texture::opaque("far", even(GREEN))];
        let drawn = picture(&with_pictures(4, meshes, textures), &Choices { samples: 4, ..linear() });
        drawn.pixels().iter().for_each(|pixel| assert_eq!(pixel.to_array(), [0.5, 0.5, 0.0]));
    }
}

#[test]
fn all_ranks_are_no_fade() {
    let of = |texture: Texture| {
        let scene = with_pictures(8, vec![(screen(2.0, 9), glowing(0))], vec![texture]);
        list(&scene, &linear(), None).expect("a view")
    };
    let plain = Texture::opaque("red", even(RED));
    assert!(of(plain.clone().faded(0, 16)) == of(plain.clone()));
    assert!(!of(plain.clone()).polygon(0).is_cut_out() && of(plain.clone().faded(0, 15)).polygon(0).is_cut_out());
    assert!(plain.clone().faded(3, 16).has_holes() && !plain.faded(0, 16).has_holes());
}

fn stripes(side: u32, a: Rgba, b: Rgba) -> Arc<Texels> {
    let rgba = (0..side * side).map(|index| if index % side < side / 2 { a } else { b }).collect();
    Arc::new(Texels::new(side, side, rgba, FirstRow::AtV0).expect("a square"))
}

#[test]
fn every_place_shows_its_own_tile() {
    let tiles = vec![
        Tile { texels: Arc::new(even(RED)), repeat: [1.0, 1.0] },
        Tile { texels: stripes(4, GREEN, [0, 0, 255, 255]), repeat: [2.0, 2.0] },
    ];
    let mosaic = Mosaic::new((4, 2), vec![0, 1, 0, 1, 1, 1, 0, 0], FirstRow::Top, tiles).expect("legal");
    let scene = with_pictures(16, vec![(screen(2.0, 1), glowing(0))], vec![Texture::mosaic("land", mosaic)]);
    for texture_filter in TextureFilter::ALL.iter().copied() {
        let drawn = picture(&scene, &Choices { texture_filter, ..linear() });
        for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
            let striped = [[false, true, false, true], [true, true, false, false]][y / 8][x / 4];
            // The stripes repeat twice: 8 pixels each, and the colors change in their middle.
            let stripe = [0.0, if x % 8 < 4 { 1.0 } else { 0.0 }, if x % 8 < 4 { 0.0 } else { 1.0 }];
            let expected = if striped { stripe } else { [1.0, 0.0, 0.0] };
            let near_edge = texture_filter != TextureFilter::Nearest && (x % 4 == 0 || x % 4 == 3);
            let shown = drawn.pixel(x, y).to_array();
            // Between two stripes other filters mix them, never another tile.
            let (red, rest) = (shown[0], shown[1] + shown[2]);
            let is_right =
                if near_edge && striped { red == 0.0 && (rest - 1.0).abs() < 1e-5 } else { shown == expected };
            assert!(is_right, "{} ({x}, {y}): {shown:?}", texture_filter.name());
        }
    }
}

/// The level of detail of a tile counts its repeats: seen from afar it is its mean, as a picture that repeats so itself.
#[test]
fn tiles_are_means_from_afar() {
    let texels = stripes(16, [200, 40, 80, 255], [0, 120, 20, 255]);
    let tiles = vec![Tile { texels: texels.clone(), repeat: [6.0, 3.0] }];
    let mosaic = Mosaic::new((1, 1), vec![0], FirstRow::AtV0, tiles).expect("legal");
    let mut repeated = screen(2.0, 1);
    repeated.texture.iter_mut().for_each(|place| *place = Vec3::new(6.0 * place.x, 3.0 * place.y, 0.0));
    let draw = |mesh, texture| picture(&with_pictures(24, vec![(mesh, glowing(0))], vec![texture]), &linear());
    let (by_mosaic, by_hand) = (
        draw(screen(2.0, 1), Texture::mosaic("land", mosaic)),
        draw(repeated, Texture { texels, ..Texture::opaque("land", even(RED)) }),
    );
    for (a, b) in by_mosaic.pixels().iter().zip(by_hand.pixels()) {
        assert!((a.r - b.r).abs() < 1e-4 && (a.g - b.g).abs() < 1e-4, "{a:?} {b:?}");
    }
}

/// A map on the ground, and a row of trees between two of its kinds, each half a quad and half another.
fn landscape() -> Scene {
    let read = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
        farop::image::textures::read(&path).unwrap_or_else(|error| panic!("{error}"))
    };
    let tiles = vec![
        Tile { texels: Arc::new(read("grass.png")), repeat: [12.0, 12.0] },
        Tile { texels: stripes(8, [150, 110, 60, 255], [120, 85, 45, 255]), repeat: [20.0, 8.0] },
        Tile { texels: Arc::new(even([150, 150, 160, 255])), repeat: [1.0, 1.0] },
    ];
    // A field in the meadow, and a road around it.
    let id = |x: u32, y: u32| match (x, y) {
        (5..=10, 3..=6) => 1,
        (4..=11, 2..=7) => 2,
        _ => 0,
    };
    let ids = (0..256).map(|index| id(index % 16, index / 16)).collect();
    let mosaic = Mosaic::new((16, 16), ids, FirstRow::AtV0, tiles).expect("legal");
    let mut ground = Mesh::default();
    quad(&mut ground, [[-12.0, -2.0, 2.0], [12.0, -2.0, 2.0], [12.0, -2.0, 26.0], [-12.0, -2.0, 26.0]], 1);
    let mut textures = vec![Texture::mosaic("land", mosaic)];
    let mut meshes = vec![(ground, glowing(0))];
    let tree = Texture::cut_out("tree.png", read("tree.png"), 0.5);
    for step in 0..5_u8 {
        let (x, z, k) = (f64::from(step) * 2.2 - 4.4, 6.0, step * 4);
        for (fade, leaning) in [((0, k), 0.0), ((k, 16), 0.5)] {
            let mut mesh = Mesh::default();
            let corner = |dx: f64, y: f64| [x + dx, y, z + dx * leaning];
            quad(
                &mut mesh,
                [corner(-1.0, -2.0), corner(1.0, -2.0), corner(1.0, 1.5), corner(-1.0, 1.5)],
                90 + u32::from(step),
            );
            meshes.push((
                mesh,
                Material {
                    color: [Rgb::WHITE, Rgb::new(1.0, 0.5, 0.25)][usize::from(leaning > 0.0)],
                    ..glowing(textures.len() as u32)
                },
            ));
            textures.push(tree.clone().faded(fade.0, fade.1));
        }
    }
    let mut scene = with_pictures(128, meshes, textures);
    // Integer depth needs a far plane.
    scene.camera = scene.camera.map(|camera| farop::scene::Camera { yon: Some(100.0), ..camera });
    Scene { background: Some(Rgb::new(0.5, 0.65, 0.85)), ..scene }
}

#[test]
fn rasterizers_draw_the_same_bytes() {
    let scene = landscape();
    let base = || Choices { size: Some((72, 72)), ..Choices::default() };
    let mut all = vec![base()];
    all.extend([Shading::Flat, Shading::Phong].map(|shading| Choices { shading, samples: 2, ..base() }));
    all.extend([AlphaRule::Test, AlphaRule::Paper].map(|alpha| Choices { alpha, samples: 2, ..base() }));
    all.extend(
        [TextureFilter::Nearest, TextureFilter::Bilinear].map(|texture_filter| Choices { texture_filter, ..base() }),
    );
    all.extend([DepthFormat::F64, DepthFormat::Int16].map(|depth| Choices { depth, samples: 3, ..base() }));
    all.extend(
        [Interpolation::Screen, Interpolation::ScanLine].map(|interpolation| Choices { interpolation, ..base() }),
    );
    all.extend([Some(1), Some(3)].map(|threads| Choices { threads, samples: 4, ..base() }));
    for choices in &all {
        let by = |rasterizer: &dyn Rasterizer| render(&scene, choices, Some(rasterizer)).expect("a view").image;
        let expected = by(&ZBuffer);
        assert!(by(&Watkins) == expected, "watkins: {choices:?}");
        assert!(by(&Fast::default()) == expected, "fast: {choices:?}");
    }
}

/// Glass in pictures: fragments are kept apart, and wear them like anything else.
#[test]
fn transparent_surfaces_wear_pictures() {
    let checked = stripes(4, RED, GREEN);
    let textures = vec![
        Texture { texels: checked.clone(), ..Texture::opaque("pane", even(RED)) },
        Texture { texels: checked, ..Texture::cut_out("holes", even(RED), 0.5) }.faded(2, 13),
    ];
    let glass = |texture| Material { opacity: Rgb::gray(0.5), ..glowing(texture) };
    let meshes = vec![(screen(4.0, 3), glowing(0)), (screen(3.0, 4), glass(0)), (screen(2.0, 5), glass(1))];
    let scene = with_pictures(24, meshes, textures);
    for (samples, shading) in [(1, Shading::Gouraud), (2, Shading::Phong), (3, Shading::Flat)] {
        let choices = Choices { samples, shading, ..linear() };
        let by = |rasterizer: &dyn Rasterizer| render(&scene, &choices, Some(rasterizer)).expect("a view").image;
        let expected = by(&ZBuffer);
        assert!(expected.pixels().iter().all(|pixel| pixel.b < 1e-6), "no light of their own shows");
        assert!(by(&Fast::default()) == expected && by(&Watkins) == expected, "{shading:?}");
    }
}

#[test]
fn the_landscape_looks_so() {
    let choices = Choices { samples: 2, ..Choices::default() };
    assert_picture!("fades_mosaic", picture(&landscape(), &choices).encode(choices.encoding));
}

#[test]
fn screen_files_hold_fades_and_mosaics() {
    let choices = Choices { size: Some((32, 32)), threads: Some(1), ..Choices::default() };
    let own = list(&landscape(), &choices, None).expect("a view");
    let mut text = Vec::new();
    write_v2(&own, &Sheet::default(), Attributes::default(), &mut text).expect("memory");
    let text = String::from_utf8(text).expect("text");
    let back = |text: &str| read(text, &ReadOptions::default());
    let file = back(&text).unwrap_or_else(|error| panic!("{error}"));
    assert!(file.list.shader == own.shader);
    let drawn = |list: &DrawList| draw(list, Some(&ZBuffer), &Canvas::of_sheet(&Sheet::default())).0;
    assert!(drawn(&file.list) == drawn(&own));
    let wrong = |from: &str, to: &str| back(&text.replacen(from, to, 1)).expect_err(to).to_string();
    assert!(wrong(" fade 4 16", " fade 4 17").contains("rank"));
    assert!(wrong(" mosaic 16 16 3", " mosaic 16 16 2").contains("below 2"));
    assert!(wrong(" mosaic 16 16 3", " mosaic 4000 4000 3").contains("numbers"));
    assert!(wrong("\nids 00", "\nids 0").contains("hexadecimal"));
    assert!(wrong("\ntile 1 8 8", "\ntile 2 8 8").contains("the number of the tile"));
}

#[test]
fn means_are_shared_by_all_steps_of_a_fade() {
    let own = list(&landscape(), &Choices::default(), None).expect("a view");
    let textures = &own.shader.textures.list;
    let trees: Vec<_> = textures.iter().filter(|texture| texture.name == "tree.png").collect();
    // Whatever step: nothing shown of one of the two at the ends.
    assert_eq!(trees.len(), 10);
    assert!(trees.windows(2).all(|pair| Arc::ptr_eq(&pair[0].pyramid, &pair[1].pyramid)));
    assert_eq!(trees[2].fade, Some(Fade { from: 0, to: 4 }));
    let mut text = Vec::new();
    let notices = write_sipp(&landscape(), &mut text).expect("memory");
    assert!(notices.iter().any(|notice| notice.contains("without its fade, its mosaic or its map: 11")), "{notices:?}");
}

#[test]
fn nothing_is_shown_of_nothing() {
    let textures = vec![Texture { wrap: Wrap::Repeat, ..Texture::opaque("none", even(RED)).faded(7, 7) }];
    let scene = with_pictures(4, vec![(screen(2.0, 3), glowing(0))], textures);
    let drawn: DrawList = list(&scene, &linear(), None).expect("a view");
    assert_eq!(drawn.len(), 2, "two triangles, and not a sample of them");
    assert!(picture(&scene, &linear()).pixels().iter().all(|pixel| pixel.r == 0.0));
}
