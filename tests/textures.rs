//! Pictures on surfaces, from the scene to the bytes: right places, right sizes, holes that hide nothing.

mod support;

use farop::color::{Encoding, Rgb};
use farop::image::Image;
use farop::image::textures::{FirstRow, Rgba, Texels, Wrap};
use farop::math::Vec3;
use farop::parse::{ParseOptions, load, read_sipp};
use farop::plan::{AlphaRule, Choices, DepthFormat, Interpolation, NeedsMode, Shading, TextureFilter, Varying};
use farop::raster::{Fast, Frame, Rasterizer, Scanline, Watkins, ZBuffer};
use farop::render::{Canvas, draw, list, render};
use farop::scene::{Material, Mesh, Reflection, Scene, Texture, TextureId};
use farop::screen::DrawList;
use farop::screen::file::{Attributes, ReadOptions, Sheet, read, write_v2};
use farop::write::write_sipp;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use support::scenes::{camera, facets, scene, surface, world};

/// A surface that shows the light of its picture alone: white, ambient 1, nothing else.
fn glowing(texture: u32) -> Material {
    let (ambient, diffuse, reflection) = (Some(1.0), 0.0, Reflection::Phong);
    Material { reflection, ambient, diffuse, texture: Some(TextureId(texture)), ..Material::default() }
}

/// A quad of eye-space corners (x right, y up, z along the view), counterclockwise, and u, v at each.
fn quad(corners: [([f64; 3], [f64; 2]); 4]) -> Mesh {
    let mut mesh = facets(&[corners.map(|(eye, _)| world(Vec3::from(eye))).to_vec()]);
    mesh.texture = corners.map(|(_, [u, v])| Vec3::new(u, v, 0.0)).to_vec();
    mesh
}

/// A quad across the whole picture at distance `w`, the picture on it once.
fn screen(w: f64) -> Mesh {
    quad([([-w, -w, w], [0.0, 0.0]), ([w, -w, w], [1.0, 0.0]), ([w, w, w], [1.0, 1.0]), ([-w, w, w], [0.0, 1.0])])
}

fn texels(side: u32, texel: impl Fn(u32, u32) -> Rgba) -> Texels {
    let rgba = (0..side * side).map(|index| texel(index % side, index / side)).collect();
    Texels::new(side, side, rgba, FirstRow::AtV0).expect("a square")
}

/// Levels without any order.
fn motley(x: u32, y: u32) -> Rgba {
    let mixed = (x * 97 + y * 61 + 5).wrapping_mul(0x9E37_79B1);
    [(mixed >> 8) as u8, (mixed >> 16) as u8, (mixed >> 24) as u8, 255]
}

/// A scene without lights, linear all through, of these pictures.
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

fn levels(image: &Image, x: usize, y: usize) -> [u8; 3] {
    image.pixel(x, y).to_array().map(|light| Encoding::Linear.level(light))
}

#[test]
fn a_picture_that_fills_the_screen_is_the_picture() {
    let texels = texels(16, motley);
    let scene = with_pictures(16, vec![(screen(3.0), glowing(0))], vec![Texture::opaque("motley", texels.clone())]);
    for filter in TextureFilter::ALL {
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            let drawn = picture(&scene, &Choices { texture_filter: *filter, shading, ..linear() });
            for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
                let [r, g, b, _] = texels.at(x as u32, 15 - y as u32);
                assert_eq!(levels(&drawn, x, y), [r, g, b], "{} ({x}, {y})", filter.name());
            }
        }
    }
}

#[test]
fn seen_from_afar_it_is_its_mean() {
    let own = texels(16, motley);
    let scene = with_pictures(4, vec![(screen(3.0), glowing(0))], vec![Texture::opaque("motley", own.clone())]);
    let drawn = picture(&scene, &linear());
    for (x, y) in (0..4).flat_map(|y| (0..4).map(move |x| (x, y))) {
        let inside = (0..16).map(|index| own.at(4 * x + index % 4, 4 * (3 - y) + index / 4));
        let sums = inside.fold([0.0; 3], |sum: [f64; 3], texel| [0, 1, 2].map(|c| sum[c] + f64::from(texel[c])));
        let shown = levels(&drawn, x as usize, y as usize);
        // Exactly on level 2: only its rounding to 8 bits is between.
        (0..3).for_each(|c| {
            assert!((f64::from(shown[c]) - sums[c] / 16.0).abs() <= 0.51, "({x}, {y}): {shown:?} {sums:?}")
        });
    }
}

/// The oracle: a ray through the pixel's center meets the plane of the quad, and there u and v are linear.
#[test]
fn places_are_those_that_rays_meet() {
    const SIDE: u32 = 48;
    let own = texels(16, motley);
    // A leaning parallelogram: P = o + a u + b v, across the picture, four times as deep at one end.
    let (o, a, b) = (Vec3::new(-2.0, -2.5, 2.2), Vec3::new(9.0, 0.5, 5.0), Vec3::new(-1.0, 8.0, 3.0));
    let at = |u: f64, v: f64| ((o + a * u + b * v).to_array(), [u, v]);
    let mesh = quad([at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]);
    let scene = with_pictures(SIDE, vec![(mesh, glowing(0))], vec![Texture::opaque("motley", own.clone())]);
    let drawn =
        |interpolation| picture(&scene, &Choices { texture_filter: TextureFilter::Nearest, interpolation, ..linear() });
    let (right, wrong) = (drawn(Interpolation::Perspective), drawn(Interpolation::Screen));
    let (mut met, mut differing) = (0, 0);
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let along = |pixel: u32| (f64::from(pixel) + 0.5) / f64::from(SIDE) * 2.0 - 1.0;
        let ray = Vec3::new(along(x), -along(y), 1.0);
        // o + a u + b v = t ray, by Cramer's rule.
        let solve = |p: Vec3, q: Vec3, r: Vec3| p.dot(q.cross(r));
        let whole = solve(a, b, -ray);
        let (u, v) = (solve(-o, b, -ray) / whole, solve(a, -o, -ray) / whole);
        let (column, row) = (u * 16.0, v * 16.0);
        let is_clear = |along: f64| along > 0.01 && along < 15.99 && (along - along.round()).abs() > 0.01;
        if !is_clear(column) || !is_clear(row) {
            continue;
        }
        let [r, g, b, _] = own.at(column as u32, row as u32);
        assert_eq!(levels(&right, x as usize, y as usize), [r, g, b], "({x}, {y}) shows ({u}, {v})");
        met += 1;
        differing += u32::from(levels(&wrong, x as usize, y as usize) != [r, g, b]);
    }
    assert!(met > 700 && differing > met / 4, "{met} {differing}");
}

fn own_scene(name: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    load(&path, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).into_scene()
}

#[test]
fn rasterizers_draw_the_same_bytes() {
    let fast = Fast::default();
    let (cutout, rows) = (own_scene("cutout.sipp"), own_scene("tree_rows.sipp"));
    let base = || Choices { size: Some((60, 45)), ..Choices::default() };
    let mut all = vec![base()];
    all.extend([Shading::Flat, Shading::Phong].map(|shading| Choices { shading, ..base() }));
    all.extend([AlphaRule::Test, AlphaRule::Paper].map(|alpha| Choices { alpha, samples: 2, ..base() }));
    all.extend(
        [TextureFilter::Nearest, TextureFilter::Bilinear].map(|texture_filter| Choices { texture_filter, ..base() }),
    );
    all.extend([DepthFormat::F64, DepthFormat::Int16].map(|depth| Choices { depth, samples: 3, ..base() }));
    all.extend(
        [Interpolation::Screen, Interpolation::ScanLine].map(|interpolation| Choices { interpolation, ..base() }),
    );
    all.extend([Some(1), Some(3)].map(|threads| Choices { threads, samples: 4, ..base() }));
    for (scene, name) in [(&cutout, "cutout"), (&rows, "rows")] {
        let scene = far_plane(scene);
        for choices in &all {
            let by = |rasterizer: &dyn Rasterizer| render(&scene, choices, Some(rasterizer)).expect("a view").image;
            let expected = by(&ZBuffer);
            assert!(by(&Watkins) == expected, "watkins: {name} {choices:?}");
            assert!(by(&fast) == expected, "fast: {name} {choices:?}");
            // Its values drift by design (docs/scanline.md): a texel or a hole now and then is another one.
            let drifted = by(&Scanline);
            let pairs = drifted.pixels().iter().zip(expected.pixels());
            let unlike = pairs.filter(|(a, b)| (a.g - b.g).abs() > 0.05).count();
            assert!(unlike * 50 < expected.pixels().len(), "scanline: {name} {choices:?}: {unlike}");
        }
    }
}

/// Integer depth needs one.
fn far_plane(scene: &Scene) -> Scene {
    let camera = scene.camera.map(|camera| farop::scene::Camera { yon: Some(400.0), ..camera });
    Scene { camera, ..scene.clone() }
}

/// Left half a hole, right half there.
fn half() -> Texture {
    Texture::cut_out("half", texels(8, |x, _| [250, 100, 50, if x < 4 { 0 } else { 255 }]), 0.5)
}

#[test]
fn holes_hide_nothing_and_leave_depth_alone() {
    let back = || (screen(5.0), Material { texture: None, color: Rgb::new(0.0, 0.0, 1.0), ..glowing(0) });
    // In front and behind in both orders of the list, and at the same depth.
    for (near, first) in [(2.0, true), (2.0, false), (5.0, true), (5.0, false), (9.0, true), (9.0, false)] {
        let front = (screen(near), glowing(0));
        let meshes = if first { vec![front, back()] } else { vec![back(), front] };
        let scene = with_pictures(8, meshes, vec![half()]);
        let polygons = list(&scene, &linear(), None).expect("a view");
        for rasterizer in [&ZBuffer as &dyn Rasterizer, &Watkins, &Fast::default(), &Scanline] {
            let mut frame = Frame::default();
            let target = frame.target((8, 8), 0..8, Rgb::gray(0.0), farop::plan::Transparency::Over);
            let mut target = target.with_threads(1);
            rasterizer.draw(&polygons, &mut target);
            let counts = target.finish();
            let (hole, solid) = (frame.sample(8), frame.sample(15));
            let wins = near < 5.0 || (near == 5.0 && first);
            let near_enough = |depth: f64, expected: f64| (depth - expected).abs() < 1e-6;
            assert!(near_enough(hole.1, 0.2) && hole.2 == Rgb::new(0.0, 0.0, 1.0), "{near} {first}: {hole:?}");
            assert!(near_enough(solid.1, if wins { 1.0 / near } else { 0.2 }), "{near} {first}: {solid:?}");
            assert_eq!(solid.2.r > 0.9, wins, "{near} {first}: {solid:?}");
            assert!(counts.puts >= 64, "{counts:?}");
        }
    }
}

#[test]
fn the_mean_of_samples_is_alpha() {
    for (alpha, threshold) in [(64_u8, 0.5), (128, 0.5), (200, 0.5), (128, 0.25)] {
        let own = Texture::cut_out("veil", texels(4, |_, _| [255, 255, 255, alpha]), threshold);
        let scene = with_pictures(8, vec![(screen(2.0), glowing(0))], vec![own]);
        let share = |choices: &Choices| picture(&scene, choices).pixel(3, 5).r;
        let covered = share(&Choices { samples: 8, ..linear() });
        let alpha = f32::from(alpha) / 255.0;
        let centered = if threshold == 0.5 { alpha } else { 0.5 + 0.5 * (alpha - 0.25) / 0.75 };
        assert!((covered - centered).abs() <= 1.0 / 64.0, "{alpha} {threshold}: {covered}");
        let test = |samples, alpha| share(&Choices { samples, alpha, ..linear() });
        let there = if f64::from(alpha) > threshold { 1.0 } else { 0.0 };
        assert_eq!([test(1, AlphaRule::Coverage), test(4, AlphaRule::Test), test(3, AlphaRule::Paper)], [there; 3]);
        // The command line's threshold wins.
        let always = Choices { alpha: AlphaRule::Test, alpha_threshold: Some(0.1), ..linear() };
        assert_eq!(share(&always), 1.0);
    }
    let beyond = Choices { alpha_threshold: Some(1.5), ..linear() };
    assert!(render(&own_scene("cutout.sipp"), &beyond, None).is_err());
}

#[test]
fn only_scenes_with_pictures_carry_coordinates() {
    let (plain, textured) = (own_scene("glass.sipp"), own_scene("cutout.sipp"));
    let of = |scene: &Scene, shading, needs| {
        let choices = Choices { shading, needs, size: Some((48, 48)), ..Choices::default() };
        render(scene, &choices, Some(&ZBuffer)).expect("a view")
    };
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let derived = of(&plain, shading, NeedsMode::Derived);
        assert!(!derived.list.has_texture() && !derived.plan.explain().iter().any(|row| row.need == "texture"));
        let full = of(&plain, shading, NeedsMode::Full);
        assert!(full.list.has_texture() && derived.image == full.image, "{shading:?}");
        let (derived, full) = (of(&textured, shading, NeedsMode::Derived), of(&textured, shading, NeedsMode::Full));
        assert!(derived.list.has_texture() && derived.image == full.image, "{shading:?}");
        let row = derived.plan.explain().into_iter().find(|row| row.need == "texture").expect("it is told");
        assert!(
            row.decision == "yes" && row.reason.contains("2 of 3 surfaces have a picture, 1 of these with holes"),
            "{row:?}"
        );
    }
    let wire = of(&textured, Shading::Wire, NeedsMode::Derived);
    assert_eq!((wire.list.varying, wire.plan.needs.texture), (Varying::Nothing, false));
}

#[test]
fn means_are_made_once_and_used_again() {
    let (scene, choices) = (own_scene("cutout.sipp"), Choices::default());
    let plan = farop::plan::Plan::new(&scene, &choices, farop::plan::Accepts::AnyPolygon).expect("a view");
    let mut list = DrawList::new(0, 0);
    let mut made = || {
        farop::geometry::run(&scene, &plan, &mut list);
        list.shader.textures.list.iter().map(|texture| texture.pyramid.clone()).collect::<Vec<_>>()
    };
    let (first, second) = (made(), made());
    assert_eq!(first.len(), 2, "the tree's and the ground's");
    assert!(first.iter().zip(&second).all(|(a, b)| Arc::ptr_eq(a, b)));
}

#[test]
fn screen_files_hold_the_pictures() {
    for shading in [Shading::Gouraud, Shading::Phong] {
        let choices = Choices { shading, samples: 2, size: Some((32, 32)), threads: Some(1), ..Choices::default() };
        let scene = own_scene("cutout.sipp");
        let own = list(&scene, &choices, None).expect("a view");
        let sheet = Sheet { samples: 2, ..Sheet::default() };
        let text = |attributes| {
            let mut out = Vec::new();
            write_v2(&own, &sheet, attributes, &mut out).unwrap_or_else(|error| panic!("{error}"));
            String::from_utf8(out).expect("text")
        };
        let back = |text: &str| read(text, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        let of = |names| Attributes::from_names(names).expect("names");
        for attributes in [Attributes::default(), of("texture"), of("color,texture")] {
            let file = back(&text(attributes));
            assert!(file.list == own, "{shading:?} {attributes:?}");
            let drawn = |list| draw(list, Some(&ZBuffer), &Canvas::of_sheet(&sheet)).0;
            assert!(drawn(&file.list) == drawn(&own));
        }
        // Whoever asks for colors alone gets a file that knows nothing of pictures.
        let names = if shading == Shading::Phong { "phong" } else { "color" };
        let plain = text(of(names));
        assert!(["texture", "texels", " u v"].iter().all(|word| !plain.contains(word)), "{names}");
        let drawn = |list: &DrawList| draw(list, Some(&ZBuffer), &Canvas::of_sheet(&sheet)).0;
        assert!(drawn(&back(&plain).list) == drawn(&own.without_texture()));
        assert!(drawn(&own.without_texture()) != drawn(&own));
        assert_eq!(own.without_texture().textured_polygons(), 0);

        let whole = text(Attributes::default());
        let wrong = |from: &str, to: &str| {
            read(&whole.replacen(from, to, 1), &ReadOptions::default()).expect_err(to).to_string()
        };
        assert!(wrong("textures 2", "textures 3").contains("texture"));
        assert!(wrong(" texture 0\n", " texture 7\n").contains("a picture, 0 to 1"));
        assert!(wrong("texels ", "texels 0").contains("hexadecimal"));
        assert!(wrong("clamp 0.5", "clamp 2").contains("opaque"));
        assert!(wrong("texture 0 32 32", "texture 0 4000 4000").contains("texels"));
    }
    let plain = list(&own_scene("glass.sipp"), &Choices::default(), None).expect("a view");
    let attributes = Attributes::from_names("texture").expect("a name");
    assert!(write_v2(&plain, &Sheet::default(), attributes, &mut Vec::new()).is_err());
}

/// A folder with a picture in it.
fn folder() -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let png = farop::image::textures::encode_png(&texels(4, motley)).expect("encodes");
    std::fs::write(folder.path().join("motley.png"), png).expect("writes");
    let path = folder.path().join("a.sipp");
    (folder, path)
}

#[test]
fn sipp_says_which_picture() {
    let (_folder, path) = folder();
    let read_back = |text: &str| {
        std::fs::write(&path, text).expect("writes");
        load(&path, None, ParseOptions::default())
    };
    let of = |words: &str| {
        let body = "world { surface s { facet { v 0 0 0 t 0 0 0  v 1 0 0 t 1 0 0  v 1 1 0 t 1 1 0 } } }";
        read_back(&format!("shader s phong {{ {words} }} {body}"))
    };
    for (words, cut_out, wrap, key) in [
        ("texture \"motley.png\"", None, Wrap::Repeat, None),
        ("texture \"motley.png\" cutout .25", Some(0.25), Wrap::Clamp, None),
        ("texture \"motley.png\" wrap clamp key 1 0 .2", None, Wrap::Clamp, Some([255, 0, 51])),
        ("cutout 1 wrap repeat texture \"motley.png\"", Some(1.0), Wrap::Repeat, None),
    ] {
        let parsed = of(words).unwrap_or_else(|errors| panic!("{errors}"));
        let texture = &parsed.scene.textures[0];
        assert_eq!((texture.cut_out.map(|cut| cut.threshold), texture.wrap, texture.key), (cut_out, wrap, key));
        assert_eq!(texture.texels.size(), (4, 4));
        // Printed and read again it is the same.
        let mut text = Vec::new();
        let notices = write_sipp(&parsed.scene, &mut text).expect("memory");
        assert!(notices.iter().any(|notice| notice.contains("keep it beside")), "{notices:?}");
        let again = read_back(&String::from_utf8(text).expect("text")).unwrap_or_else(|errors| panic!("{errors}"));
        assert_eq!(again.scene.textures, parsed.scene.textures);
        assert_eq!(
            again.scene.surfaces[0].mesh,
            Mesh { polygons: again.scene.surfaces[0].mesh.polygons.clone(), ..parsed.scene.surfaces[0].mesh.clone() }
        );
    }
    for (words, message) in [
        ("texture \"none.png\"", "no texture `none.png`"),
        ("texture \"a.sipp\"", "no picture farop can read"),
        ("cutout .5", "there is none"),
        ("texture \"motley.png\" cutout 2", "must be from 0 to 1"),
        ("texture motley.png", "a quoted string"),
        ("texture \"motley.png\" wrap mirror", "`repeat` or `clamp`"),
    ] {
        let errors = of(words).expect_err(words).to_string();
        assert!(errors.contains(message), "{words}: {errors}");
    }
    // Nothing to wear it.
    let ball = "shader s phong { texture \"motley.png\" } world { sphere { radius 1 shader s } }";
    let notices = read_back(ball).unwrap_or_else(|errors| panic!("{errors}")).notices.to_string();
    assert!(notices.contains("no texture coordinates"), "{notices}");
    assert!(read_sipp("m", b"shader s phong { texture \"\" } world { use a }", ParseOptions::default()).is_err());
}

#[test]
fn merged_scenes_keep_their_pictures() {
    let (mut first, mut second) = (own_scene("cutout.sipp"), own_scene("tree_rows.sipp"));
    second.textures.iter_mut().for_each(|texture| texture.name += " of the second");
    let count = first.textures.len();
    let _ = first.merge(second.clone());
    let textured = |scene: &Scene, from: usize| -> Vec<String> {
        let surfaces = scene.surfaces[from..].iter();
        surfaces.filter_map(|surface| scene.picture_on(surface)).map(|(_, texture)| texture.name.clone()).collect()
    };
    assert_eq!(first.textures.len(), count + second.textures.len());
    let behind = first.surfaces.len() - second.surfaces.len();
    assert_eq!(textured(&first, behind), textured(&second, 0));
}
