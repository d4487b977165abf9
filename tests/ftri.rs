//! `.ftri` files: read what was written, drawn as their matrices and their light formula say, refused where they are broken.

mod support;

use farop::color::Encoding;
use farop::image::Image;
use farop::parse::{read_ftri, scene_of_triangles};
use farop::plan::{Choices, FlatRule, Interpolation, NeedsMode, Shading};
use farop::raster::{Fast, Rasterizer, Registry, Watkins, ZBuffer};
use farop::render::{list, render};
use farop::scene::{Scene, TriangleKind, TriangleRange, Triangles};
use farop::screen::file::{self, Attributes, ReadOptions, Sheet, write_v2};
use farop::spd::bench;
use farop::write::write_ftri;
use support::random::Random;

fn triangles(name: &str) -> Triangles {
    bench::triangles(name).expect("it is built in")
}

fn bytes(triangles: &Triangles) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_ftri(triangles, &mut bytes).expect("memory takes it");
    bytes
}

fn scene(triangles: &Triangles) -> Scene {
    scene_of_triangles("made", triangles).expect("a camera").scene
}

fn choices(shading: Shading) -> Choices {
    let flat = if shading == Shading::Flat { FlatRule::Vertex } else { FlatRule::Face };
    Choices { size: Some((96, 64)), shading, flat, encoding: Encoding::Linear, ..Choices::default() }
}

/// A tetrahedron that stands a little askew before the eye; every vertex has a color of its own.
fn small() -> Triangles {
    let mut made = triangles("fill_b2f");
    made.positions = vec![[-1.0, -1.0, -3.5], [1.2, -0.9, -3.0], [0.1, 1.1, -3.2], [0.2, 0.1, -2.0]];
    made.normals = vec![[-0.7, -0.5, 0.5], [0.8, -0.3, 0.6], [0.0, 0.9, 0.4], [0.0, 0.0, 2.0]];
    made.colors = vec![[1.0, 0.2, 0.1], [0.1, 0.9, 0.3], [0.2, 0.3, 1.0], [0.8, 0.8, 0.7]];
    made.texture = vec![[0.0; 2]; 4];
    made.indices = vec![0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 2, 1];
    made.ranges = vec![TriangleRange { first: 0, count: 12, kind: TriangleKind::Lit }];
    made
}

#[test]
fn a_file_says_what_its_triangles_say() {
    for name in ["flake:1k", "fill_f2b"] {
        let made = triangles(name);
        let read = read_ftri("made", &bytes(&made)).expect("just written");
        assert_eq!(read, scene_of_triangles("made", &made).expect("a camera"));
        assert!(read.notices.list.is_empty());
    }
    // One surface a sphere, and the floor: their colors need not be carried anywhere.
    let flake = scene(&triangles("flake:1k"));
    assert_eq!(flake.surfaces.len(), 11);
    assert!(flake.surfaces.iter().all(|surface| surface.mesh.colors.is_empty()));
    assert_eq!(scene(&small()).surfaces[0].mesh.colors.len(), 4);
}

/// The oracle: the file's matrices, edge functions in f64, the file's own light formula. It shares nothing with farop.
mod oracle {
    use super::{Shading, Triangles};

    type V = [f64; 3];

    fn dot(a: V, b: V) -> f64 {
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    }

    fn unit(a: V) -> V {
        let length = dot(a, a).sqrt();
        a.map(|x| x / length)
    }

    fn minus(a: V, b: V) -> V {
        [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
    }

    /// `c ka + sum (c kd (N.L) + ks (R.V)^n) light`, terms only where N.L > 0 and R.V > 0.
    fn light(of: &Triangles, place: V, normal: V, color: V) -> V {
        let [ka, kd, ks, shine] = of.material.map(f64::from);
        let (normal, view) = (unit(normal), unit(minus(of.eye.map(f64::from), place)));
        let mut sum = color.map(|c| c * ka);
        for (position, emitted) in &of.lights {
            let to_light = unit(minus(position.map(f64::from), place));
            let cosine = dot(normal, to_light);
            if cosine > 0.0 {
                let mirrored = minus(normal.map(|n| n * 2.0 * cosine), to_light);
                let highlight = ks * dot(mirrored, view).max(0.0).powf(shine);
                for k in 0..3 {
                    sum[k] += (color[k] * kd * cosine + highlight) * f64::from(emitted[k]);
                }
            }
        }
        sum
    }

    fn times(matrix: &[f32; 16], v: [f64; 4]) -> [f64; 4] {
        std::array::from_fn(|row| (0..4).map(|column| f64::from(matrix[4 * column + row]) * v[column]).sum())
    }

    /// Levels of a picture of `width` x `height` pixels.
    pub fn draw(of: &Triangles, (width, height): (usize, usize), shading: Shading) -> Vec<u8> {
        let mut nearest = vec![f64::MAX; width * height];
        let mut picture: Vec<V> = vec![of.background.map(f64::from); width * height];
        for corners in of.indices.chunks(3) {
            let at = |list: &[[f32; 3]]| -> [V; 3] { [0, 1, 2].map(|k| list[corners[k] as usize].map(f64::from)) };
            let (places, normals, colors) = (at(&of.positions), at(&of.normals).map(unit), at(&of.colors));
            let lit = [0, 1, 2].map(|k| light(of, places[k], normals[k], colors[k]));
            let clip = places.map(|p| {
                let mut c = times(&of.projection, times(&of.view, [p[0], p[1], p[2], 1.0]));
                c[0] /= width as f64 / height as f64;
                c
            });
            assert!(clip.iter().all(|c| c[3] > 0.1), "the oracle does not clip");
            let screen =
                clip.map(|c| [(c[0] / c[3] + 1.0) / 2.0 * width as f64, (1.0 - c[1] / c[3]) / 2.0 * height as f64]);
            let edge =
                |a: [f64; 2], b: [f64; 2], p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            // Counterclockwise in the world is clockwise with y down: negative here.
            let area = edge(screen[0], screen[1], screen[2]);
            if area >= 0.0 {
                continue;
            }
            for y in 0..height {
                for x in 0..width {
                    let p = [x as f64 + 0.5, y as f64 + 0.5];
                    let weights = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| edge(screen[a], screen[b], p) / area);
                    if weights.iter().any(|&w| w < 0.0) {
                        continue;
                    }
                    let over_w = [0, 1, 2].map(|k| weights[k] / clip[k][3]);
                    let inverse_w: f64 = over_w.iter().sum();
                    let depth: f64 = (0..3).map(|k| weights[k] * clip[k][2] / clip[k][3]).sum();
                    let pixel = y * width + x;
                    if depth >= nearest[pixel] {
                        continue;
                    }
                    nearest[pixel] = depth;
                    let mix = |list: [V; 3]| -> V {
                        std::array::from_fn(|axis| (0..3).map(|k| over_w[k] * list[k][axis]).sum::<f64>() / inverse_w)
                    };
                    picture[pixel] = match shading {
                        Shading::Flat => lit[0],
                        Shading::Phong => light(of, mix(places), mix(normals), mix(colors)),
                        _ => mix(lit),
                    };
                }
            }
        }
        picture.into_iter().flatten().map(|c| (c * 255.0).round().clamp(0.0, 255.0) as u8).collect()
    }
}

/// Pixels that differ by more than two levels, and the mean square of the others.
fn compare(image: &Image, expected: &[u8]) -> (usize, f64) {
    let picture = image.encode(Encoding::Linear);
    let (mut far, mut squares) = (0, 0.0);
    for (own, other) in picture.rgb().chunks(3).zip(expected.chunks(3)) {
        let differences = [0, 1, 2].map(|k| f64::from(own[k]) - f64::from(other[k]));
        if differences.iter().any(|d| d.abs() > 2.0) {
            far += 1;
        } else {
            squares += differences.iter().map(|d| d * d).sum::<f64>();
        }
    }
    (far, squares / expected.len() as f64)
}

#[test]
fn pictures_are_those_of_the_matrices_and_the_light_formula() {
    for (name, made) in [("small", small()), ("flake", triangles("flake:1k"))] {
        let mut made = made;
        if name == "flake" {
            // The floor reaches behind the eye, and the oracle does not clip.
            made.indices.truncate(made.indices.len() - 6);
            made.ranges[0].count -= 6;
        }
        for shading in [Shading::Gouraud, Shading::Phong, Shading::Flat] {
            let drawn = render(&scene(&made), &choices(shading), Some(&ZBuffer)).expect("a view").image;
            let (far, squares) = compare(&drawn, &oracle::draw(&made, (96, 64), shading));
            // Snapping moves an outline by 1/512 pixel at most: some pixel centers change hands.
            assert!(far <= 6, "{name} {shading:?}: {far} pixels are off by more than 2 levels");
            // 50 dB is a mean square of 0.65.
            assert!(squares < 0.65, "{name} {shading:?}: mean square {squares}");
        }
    }
}

#[test]
fn all_rasterizers_and_full_needs_draw_the_same_colors() {
    let scene = scene(&small());
    for shading in [Shading::Gouraud, Shading::Phong, Shading::Flat] {
        let base = choices(shading);
        let picture = |choices: &Choices, rasterizer: &dyn Rasterizer| {
            render(&scene, choices, Some(rasterizer)).expect("a view").image
        };
        let expected = picture(&base, &ZBuffer);
        assert_eq!(picture(&base, &Watkins), expected, "watkins, {shading:?}");
        assert_eq!(picture(&base, &Fast::default()), expected, "fast, {shading:?}");
        let full = Choices { needs: NeedsMode::Full, ..base.clone() };
        assert_eq!(picture(&full, &ZBuffer), expected, "full needs, {shading:?}");
        let relit = Choices { clip_light: farop::plan::ClipLight::Relight, ..base };
        // Nothing is cut, so light before and after clipping is the same.
        assert_eq!(picture(&relit, &ZBuffer), expected, "relit, {shading:?}");
    }
}

#[test]
fn colors_at_vertices_pass_through_screen_files() {
    let scene = scene(&small());
    let choices = choices(Shading::Phong);
    let drawn = list(&scene, &choices, Some(&ZBuffer)).expect("a view");
    let sheet = Sheet {
        samples: 1,
        encoding: Encoding::Linear,
        background: farop::color::Rgb::gray(0.0),
        transparency: farop::plan::Transparency::Over,
    };
    let mut text = Vec::new();
    write_v2(&drawn, &sheet, Attributes::default(), &mut text).expect("memory takes it");
    let text = String::from_utf8(text).expect("it is text");
    let read = file::read(&text, &ReadOptions::default()).expect("just written");
    assert_eq!(read.list, drawn);
}

#[test]
fn what_is_cut_off_is_told_with_the_byte() {
    let whole = bytes(&small());
    for length in 0..whole.len() {
        let error = read_ftri("cut.ftri", &whole[..length]).expect_err("it is cut off").to_string();
        let byte = if length < 8 { "byte 0:".to_string() } else { format!("byte {length}:") };
        assert!(error.contains("`cut.ftri`") && error.contains(&byte), "{length}: {error}");
    }
    assert!(read_ftri("whole", &whole).is_ok());
}

#[test]
fn one_wrong_field_is_named() {
    let whole = bytes(&small());
    let head = 208 + 2 * 24 + 16;
    let cases: [(usize, u32, &str); 11] = [
        (8, 0xFFFF_FFFF, "the positions reach from byte 272 to byte 51539607"),
        (12, 13, "byte 12: expected a number of indices that is a multiple of 3, found 13"),
        (16, 9, "byte 16: expected at most 8 lights, found 9"),
        (24, 5, "width and height of the texture, both or none of them 0"),
        (32, 7, "byte 32: expected 0, found 7"),
        (40, f32::NAN.to_bits(), "byte 40: expected a finite number among the view matrix"),
        (44, 1.0f32.to_bits(), "byte 40: expected a view matrix that turns and moves"),
        (104, 2.5f32.to_bits(), "byte 104: expected a perspective"),
        (196, (-1.0f32).to_bits(), "byte 196: a coefficient of the material cannot be negative, and is -1"),
        (head - 8, 2, "expected 0 or 1 and a 0, found 2, 0"),
        (head + 3 * 48 + 32 + 4, 4, "expected the index of one of 4 vertices, found 4"),
    ];
    for (at, value, expected) in cases {
        let mut broken = whole.clone();
        broken[at..at + 4].copy_from_slice(&value.to_le_bytes());
        let error = read_ftri("a.ftri", &broken).expect_err(expected).to_string();
        assert!(error.contains(expected), "{at}: {error}");
    }
    let error = read_ftri("a.ftri", &[&whole[..], b"more"].concat()).expect_err("too long").to_string();
    assert!(error.contains("expected the end of the file, found 4 more bytes"), "{error}");
}

fn below(random: &mut Random, most: u64) -> u64 {
    random.bits() % most
}

#[test]
fn mangled_files_never_end_the_program() {
    let whole = bytes(&small());
    let mut random = Random::new(27);
    let mut legal = 0;
    for _ in 0..20_000 {
        let mut mangled = whole.clone();
        for _ in 0..=below(&mut random, 3) {
            let at = below(&mut random, mangled.len() as u64) as usize;
            mangled[at] = below(&mut random, 256) as u8;
        }
        mangled.truncate(mangled.len() - if below(&mut random, 8) == 0 { below(&mut random, 60) as usize } else { 0 });
        if let Ok(parsed) = read_ftri("mangled", &mangled) {
            legal += 1;
            // What is accepted can be drawn, or says why not.
            if legal % 64 == 0 {
                let _ = render(&parsed.scene, &choices(Shading::Gouraud), Some(&ZBuffer));
            }
        }
    }
    assert!(legal > 1000, "{legal} were legal: the others hardly got far");
    let noise: Vec<u8> = (0..4000).map(|_| below(&mut random, 256) as u8).collect();
    assert!(read_ftri("noise", &noise).is_err());
    assert!(read_ftri("noise", &[&b"FTRI1\0\0\0"[..], &noise].concat()).is_err());
}

/// The small scene with its last two triangles textured by two texels, side by side.
fn textured(texels: &[[u8; 4]]) -> Triangles {
    let mut made = small();
    made.ranges = vec![
        TriangleRange { first: 0, count: 6, kind: TriangleKind::Lit },
        TriangleRange { first: 6, count: 6, kind: TriangleKind::Textured },
    ];
    (made.texture_size, made.texels) = ((texels.len() as u32, u32::from(!texels.is_empty())), texels.concat());
    made
}

#[test]
fn textured_triangles_wear_the_picture() {
    let mut made = textured(&[[255; 4]; 2]);
    made.texture[3] = [0.25, 0.75];
    let parsed = read_ftri("made", &bytes(&made)).expect("legal");
    assert_eq!(parsed.notices.to_string(), "");
    assert_eq!(parsed.scene.surfaces.len(), 2);
    assert!(parsed.scene.surfaces[1].two_sided && !parsed.scene.surfaces[0].two_sided);
    let mesh = &parsed.scene.surfaces[1].mesh;
    let third = mesh.vertices.iter().position(|vertex| vertex.z == -2.0).expect("it is used");
    assert_eq!(mesh.texture[third].to_array(), [0.25, 0.75, 0.0]);
}

#[test]
fn alpha_below_one_half_is_not_there() {
    let picture = |made: &Triangles| {
        let scene = read_ftri("made", &bytes(made)).expect("legal").scene;
        render(&scene, &choices(Shading::Gouraud), Some(&ZBuffer)).expect("a view").image
    };
    let (there, not_there) = (picture(&textured(&[[255, 255, 255, 128]])), picture(&textured(&[[255, 255, 255, 127]])));
    let mut without = textured(&[[255; 4]]);
    without.ranges.pop();
    assert_ne!(there, not_there);
    assert_eq!(not_there, picture(&without), "holes show what is behind");
    let mut whole = textured(&[[255; 4]]);
    assert_eq!(there, picture(&whole), "alpha only decides");
    // Black texels take all light.
    whole.texels = vec![0, 0, 0, 255];
    assert_ne!(there, picture(&whole));
}

#[test]
fn textured_triangles_without_a_texture_are_told() {
    let parsed = read_ftri("made", &bytes(&textured(&[]))).expect("legal");
    assert!(parsed.notices.to_string().contains("2 textured triangles"), "{}", parsed.notices);
}

/// The readable and the fast rasterizer on a scene of the families, for all that the registry has.
#[test]
fn families_are_drawn_alike() {
    let registry = Registry::built_in();
    for name in ["flake:1k", "fill_b2f", "fill_f2b"] {
        let scene = scene(&triangles(name));
        let picture = |rasterizer: &str| {
            let entry = registry.find(rasterizer).expect("it is built in");
            render(&scene, &choices(Shading::Phong), Some(&*entry.rasterizer)).expect("a view").image
        };
        assert_eq!(picture("fast"), picture("zbuffer"), "{name}");
        // Factors on colors run on the screen where colors do; eye points never.
        let choices = Choices { interpolation: Interpolation::Screen, ..choices(Shading::Phong) };
        let on_screen = |rasterizer: &dyn Rasterizer| render(&scene, &choices, Some(rasterizer)).expect("a view").image;
        assert_eq!(on_screen(&Fast::default()), on_screen(&ZBuffer), "{name}, on the screen");
    }
}
