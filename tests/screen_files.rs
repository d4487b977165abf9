//! Screen files: what goes out comes back, what is broken is named with line and column.

use farop::color::{Encoding, Rgb};
use farop::math::{Affine3, Vec3};
use farop::plan::{Choices, ClipLight, DepthFormat, FlatRule, Interpolation, Shading, Transparency, Varying};
use farop::raster::{PerPolygon, Rasterizer, Wire, ZBuffer};
use farop::render::{self, Canvas};
use farop::scene::{Camera, Light, Material, Mesh, NormalSource, Object, Place, Scene, Surface};
use farop::scene::{ObjectId, SurfaceId};
use farop::screen::file::{
    Attributes, ClassicOptions, Kind, ReadOptions, ScreenFile, ScreenFileError, ScreenWriteError, Sheet, read,
    write_classic, write_v2,
};
use farop::screen::shader::SurfaceShading;
use farop::screen::{DrawList, EdgeKind, Plane, PolygonRecord, Precision, ScreenVertex, Source};
use proptest::prelude::*;

// ---- Lists to write -------------------------------------------------------------------------------------------------

/// The list of `docs/screen-files.md`: one triangle, red, green and blue at its corners, the blue one twice as far away.
fn tiny() -> DrawList {
    let mut list = DrawList::new(8, 6);
    let (ambient, diffuse, opacity) = (Rgb::gray(0.125), Rgb::gray(0.5), Rgb::gray(1.0));
    let place = Place { file: 0, line: 3 };
    list.shader.surfaces.push(SurfaceShading { ambient, diffuse, opacity, place, ..SurfaceShading::default() });
    for ((x, y, w), color) in [(1.5, 1.5, 2.0), (5.5, 1.5, 2.0), (1.5, 5.5, 4.0)].into_iter().zip(Vec3::AXES) {
        let homogeneous = Vec3::new(x, y, 1.0) * w;
        list.vertices.push(ScreenVertex { x, y, homogeneous, edge: EdgeKind::Original });
        list.values.extend(color.to_array());
    }
    let plane = |coefficients, range, values| Plane::new(coefficients, range, values, Precision::Single);
    list.planes = vec![
        plane([0.0, -0.0625, 0.59375], (0.25, 0.5), (0.25, 0.5)),
        plane([-0.125, -0.125, 0.875], (0.0, 0.5), (0.0, 1.0)),
        plane([0.125, 0.0, -0.1875], (0.0, 0.5), (0.0, 1.0)),
        plane([0.0, 0.0625, -0.09375], (0.0, 0.25), (0.0, 1.0)),
    ];
    let source = Source { line: 4, number: 0, tessellated: false };
    list.polygons.push(PolygonRecord { first_vertex: 0, vertex_count: 3, first_plane: 0, surface: 0, source });
    list
}

/// A floor that reaches behind the eye, a roof of four corners with four normals, and a pane of glass before both.
fn scene() -> Scene {
    let mut floor = Mesh::default();
    let corners = [(-9.0, 9.0), (9.0, 9.0), (9.0, -30.0), (-9.0, -30.0)];
    let outline: Vec<_> = corners.iter().map(|&(x, z)| floor.push_vertex(Vec3::new(x, -1.0, z))).collect();
    floor.push_polygon(&outline, NormalSource::Facet, 10);
    let mut roof = Mesh::default();
    let corners = [(-1.3, -0.9), (1.4, -0.8), (1.2, 1.1), (-1.1, 0.7)];
    let outline: Vec<_> = corners
        .iter()
        .map(|&(x, y)| roof.push_vertex_with_normal(Vec3::new(x, y, 0.0), Vec3::new(x / 3.0, y / 3.0, 0.8).normalize()))
        .collect();
    roof.push_polygon(&outline, NormalSource::Given, 20);
    let mut glass = Mesh::default();
    let corners = [(-0.4, -0.5), (2.0, -0.3), (0.3, 1.7)];
    let outline: Vec<_> = corners.iter().map(|&(x, y)| glass.push_vertex(Vec3::new(x, y, 0.7))).collect();
    glass.push_polygon(&outline, NormalSource::Facet, 30);
    let paint = |color, specular, opacity| Material {
        color,
        specular,
        shine: 12.5,
        opacity: Rgb::gray(opacity),
        ..Material::default()
    };
    let surface =
        |mesh, material| Surface { material, mesh, primitives: Vec::new(), two_sided: false, place: Place::default() };
    let surfaces = vec![
        surface(floor, paint(Rgb::new(0.1, 0.7, 0.3), 0.0, 1.0)),
        surface(roof, paint(Rgb::new(0.9, 0.2, 0.1), 0.4, 1.0)),
        surface(glass, paint(Rgb::new(0.2, 0.3, 0.9), 0.2, 0.6)),
    ];
    let object = Object {
        name: String::new(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..3).map(SurfaceId).collect(),
        children: Vec::new(),
        place: Place::default(),
    };
    let camera = Camera {
        from: Vec3::new(0.3, 0.4, 4.0),
        at: Vec3::new(0.1, 0.0, 0.0),
        up: Vec3::Y,
        angle: 50.0,
        hither: 0.5,
        yon: None,
        resolution: (40, 32),
        place: Place::default(),
    };
    let light = Light::point(Vec3::new(2.0, 3.0, 5.0), Rgb::WHITE, Place::default());
    Scene {
        facing: Default::default(),
        textures: Vec::new(),
        files: vec!["scene".to_string()],
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![light],
        camera: Some(camera),
        background: Some(Rgb::new(0.2, 0.3, 0.4)),
    }
}

fn choices() -> Choices {
    Choices::default()
}

/// Choices that change what a list holds.
fn all_choices() -> Vec<Choices> {
    vec![
        choices(),
        Choices { shading: Shading::Flat, samples: 2, ..choices() },
        Choices { shading: Shading::Phong, ..choices() },
        Choices { shading: Shading::Phong, samples: 3, triangles: true, ..choices() },
        Choices { shading: Shading::Wire, ..choices() },
        Choices { depth: DepthFormat::F64, shading: Shading::Phong, ..choices() },
        Choices { interpolation: Interpolation::Screen, subpixel_bits: 4, ..choices() },
        Choices { interpolation: Interpolation::ScanLine, ..choices() },
        Choices { interpolation: Interpolation::ScanLine, shading: Shading::Phong, ..choices() },
        Choices { flat: FlatRule::Sipp, shading: Shading::Flat, ..choices() },
        Choices { transparency: Transparency::Additive, encoding: Encoding::Linear, ..choices() },
    ]
}

fn sheet(canvas: &Canvas, encoding: Encoding) -> Sheet {
    Sheet { samples: canvas.samples, background: canvas.background, transparency: canvas.transparency, encoding }
}

fn v2(list: &DrawList, sheet: &Sheet, attributes: Attributes) -> String {
    let mut bytes = Vec::new();
    write_v2(list, sheet, attributes, &mut bytes).expect("memory takes everything");
    String::from_utf8(bytes).expect("screen files are ASCII")
}

fn classic(list: &DrawList, options: &ClassicOptions) -> String {
    let mut bytes = Vec::new();
    write_classic(list, options, &mut bytes).expect("memory takes everything");
    String::from_utf8(bytes).expect("screen files are ASCII")
}

fn read_back(text: &str) -> ScreenFile {
    read(text, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Equal in everything a rasterizer can see; only the sharing of planes may differ.
fn assert_same(a: &DrawList, b: &DrawList) {
    let without_polygons = |list: &DrawList| {
        let mut list = list.clone();
        list.planes.clear();
        list.polygons.clear();
        list
    };
    assert_eq!(without_polygons(a), without_polygons(b));
    assert_eq!(a.len(), b.len());
    for (a, b) in a.polygons().zip(b.polygons()) {
        assert_eq!(PolygonRecord { first_plane: 0, ..*a.record() }, PolygonRecord { first_plane: 0, ..*b.record() });
        assert_eq!((a.depth_plane(), a.varying_planes()), (b.depth_plane(), b.varying_planes()));
    }
}

// ---- v2 -------------------------------------------------------------------------------------------------------------

#[test]
fn only_what_varies_may_run_along_scan_lines_and_only_if_the_head_says_so() {
    let choices = Choices { interpolation: Interpolation::ScanLine, ..choices() };
    let canvas = Canvas::new(&scene(), &choices);
    let text = v2(
        &render::list(&scene(), &choices, Some(&ZBuffer)).expect("a fine scene"),
        &sheet(&canvas, choices.encoding),
        Attributes::default(),
    );
    assert!(text.lines().any(|line| line.starts_with("plane red") && line.ends_with(" scanline")), "{text}");
    let refused = |text: String| read(&text, &ReadOptions::default()).expect_err("is refused").to_string();
    let under_another_head = refused(text.replace("interpolation scanline", "interpolation screen"));
    let of_depth = text.lines().map(|line| match line.starts_with("plane depth") {
        true => line.replace(" blocks", " scanline") + "\n",
        false => line.to_string() + "\n",
    });
    let of_depth = refused(of_depth.collect());
    for message in [under_another_head, of_depth] {
        assert!(message.contains("how it is evaluated") && message.contains("scanline"), "{message}");
    }
}

#[test]
fn dump_then_raster_draws_the_bytes_of_render() {
    for choices in all_choices() {
        let rasterizer: &dyn Rasterizer = if choices.shading == Shading::Wire { &PerPolygon(Wire) } else { &ZBuffer };
        let scene = scene();
        let rendered = render::render(&scene, &choices, Some(rasterizer)).expect("a fine scene");
        assert!(rendered.list.len() >= 3, "{choices:?}");
        let canvas = Canvas::new(&scene, &choices);
        let text = v2(&rendered.list, &sheet(&canvas, choices.encoding), Attributes::default());
        let file = read_back(&text);
        assert_eq!(file.kind, Kind::V2);
        assert_same(&file.list, &rendered.list);
        assert_eq!(file.sheet, sheet(&canvas, choices.encoding));
        let Sheet { samples, background, transparency, .. } = file.sheet;
        let (image, puts) =
            render::draw(&file.list, Some(rasterizer), &Canvas { samples, background, transparency, threads: 1 });
        assert!(puts.puts > 0);
        assert_eq!(image, rendered.image, "{choices:?}");
        // And the file of the file is the file.
        assert_eq!(v2(&file.list, &file.sheet, Attributes::default()), text);
    }
}

#[test]
fn triangles_of_one_polygon_share_their_planes_again() {
    let choices = Choices { triangles: true, shading: Shading::Flat, ..choices() };
    let list = render::render(&scene(), &choices, Some(&ZBuffer)).expect("a fine scene").list;
    let file = read_back(&v2(&list, &Sheet::default(), Attributes::default()));
    assert_eq!(file.list, list);
    assert!(list.planes.len() < 4 * list.len());
}

#[test]
fn a_phong_file_can_carry_colors_besides() {
    let choices = Choices { shading: Shading::Phong, ..choices() };
    let list = render::render(&scene(), &choices, Some(&ZBuffer)).expect("a fine scene").list;
    let attributes = Attributes::from_names("color,phong").expect("both are names");
    let text = v2(&list, &Sheet::default(), attributes);
    assert!(text.contains("edge normal_x normal_y normal_z eye_x eye_y eye_z red green blue\n"));
    assert_same(&read_back(&text).list, &list);
    // The color of a vertex is the one that the shader gives it.
    let color = list.shader.color(&list.polygon(0), list.polygon(0).vertex_values(0));
    let vertex = text.lines().find(|line| line.starts_with("vertex ")).expect("a vertex");
    assert!(vertex.ends_with(&format!(" {} {} {}", color.r, color.g, color.b)), "{vertex}");
}

#[test]
fn attributes_that_a_list_lacks_are_refused() {
    let mut list = tiny();
    let refused = |list: &DrawList, names| {
        let attributes = Attributes::from_names(names).expect("a name");
        write_v2(list, &Sheet::default(), attributes, &mut Vec::new()).expect_err("not in the list")
    };
    assert!(matches!(refused(&list, "phong"), ScreenWriteError::NoNormals));
    assert!(matches!(refused(&list, "color,texture"), ScreenWriteError::NoTexture));
    list.varying = Varying::Nothing;
    assert!(matches!(refused(&list, "color"), ScreenWriteError::NoColors));
    assert_eq!(Attributes::from_names("colour"), None);
}

#[test]
fn a_full_disk_is_an_error() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("no space left"))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let error = write_v2(&tiny(), &Sheet::default(), Attributes::default(), &mut Full).expect_err("full");
    assert!(error.to_string().contains("no space left"));
    assert!(write_classic(&tiny(), &ClassicOptions::default(), &mut Full).is_err());
}

// ---- Classic --------------------------------------------------------------------------------------------------------

#[test]
fn classic_loses_what_it_says_and_no_more() {
    let list = render::render(&scene(), &choices(), Some(&ZBuffer)).expect("a fine scene").list;
    let options = ClassicOptions::default();
    let mut bytes = Vec::new();
    let report = write_classic(&list, &options, &mut bytes).expect("memory takes everything");
    assert_eq!((report.polygons, report.z_clamped, report.transparent), (list.len(), 0, 1));
    let text = String::from_utf8(bytes).expect("ASCII");
    let file = read_back(&text);
    assert_eq!((file.kind, file.list.len()), (Kind::Classic, list.len()));
    let (nearest, farthest) = (list.depth_mapping.nearest, 1.0 / report.yon);
    for (back, vertex) in file.list.vertices.iter().zip(&list.vertices) {
        assert!((back.x - vertex.x).abs() <= 0.5 && (back.y - vertex.y).abs() <= 0.5, "{back:?} {vertex:?}");
        let share = (nearest - 1.0 / vertex.homogeneous.z) / (nearest - farthest);
        let back_share = (1.0 - 1.0 / back.homogeneous.z) * 65536.0 / 65535.0;
        assert!((share - back_share).abs() <= 0.5 / 65535.0 + 1e-12);
    }
    for (back, value) in file.list.values.iter().zip(&list.values) {
        let level = |light: f64| Encoding::Srgb.encode(Rgb::gray(light.min(1.0))).r * 255.0;
        assert!((level(*back) - level(*value)).abs() <= 0.5 + 1e-9);
    }
    // Nothing is lost twice: with the same resolutions the file of the file is the file.
    assert_eq!(classic(&file.list, &options), text);
}

#[test]
fn classic_resolutions_from_1_to_2_to_the_31() {
    let list = render::render(&scene(), &choices(), Some(&ZBuffer)).expect("a fine scene").list;
    for (z_resolution, color_resolution) in [(1, 1), (2, 1 << 31), (1 << 31, 2), ((1 << 31) - 1, 3), (1 << 24, 255)] {
        let options = ClassicOptions { z_resolution, color_resolution, ..ClassicOptions::default() };
        let text = classic(&list, &options);
        assert_eq!(classic(&read_back(&text).list, &options), text);
    }
    let refused =
        |options: ClassicOptions| write_classic(&list, &options, &mut Vec::new()).expect_err("refused").to_string();
    let base = ClassicOptions::default();
    assert!(refused(ClassicOptions { z_resolution: 0, ..base }).starts_with("z-resolution is 0"));
    assert!(refused(ClassicOptions { color_resolution: 0, ..base }).starts_with("color-resolution is 0"));
    assert!(refused(ClassicOptions { z_resolution: (1 << 31) + 1, ..base }).contains("2147483649"));
    assert!(refused(ClassicOptions { yon: Some(0.25), ..base }).starts_with("yon is 0.25"));
    assert!(refused(ClassicOptions { yon: Some(f64::INFINITY), ..base }).starts_with("yon is inf"));
}

#[test]
fn yon_is_the_option_or_the_lists_own_or_the_farthest_vertex() {
    let report = |list: &DrawList, yon| {
        let options = ClassicOptions { yon, ..ClassicOptions::default() };
        write_classic(list, &options, &mut Vec::new()).expect("memory takes everything")
    };
    let mut list = tiny();
    assert_eq!((report(&list, None).yon, report(&list, None).z_clamped), (4.0, 0));
    assert_eq!((report(&list, Some(2.5)).yon, report(&list, Some(2.5)).z_clamped), (2.5, 1));
    list.depth_mapping.farthest = 0.125;
    assert_eq!(report(&list, None).yon, 8.0);
}

#[test]
fn classic_draws_phong_corners_lit_and_wire_lines_white() {
    let clip_light = ClipLight::Relight;
    let phong = Choices { shading: Shading::Phong, clip_light, triangles: true, ..choices() };
    let relit = Choices { shading: Shading::Gouraud, ..phong.clone() };
    let list = |choices: &Choices| render::render(&scene(), choices, Some(&ZBuffer)).expect("a fine scene").list;
    let options = ClassicOptions::default();
    // FAROP's own order lights cut vertices anew, from their normals: what Phong's corners show.
    assert_eq!(classic(&list(&phong), &options), classic(&list(&relit), &options));
    let wire = classic(&list(&Choices { shading: Shading::Wire, ..choices() }), &options);
    assert!(wire.lines().filter(|line| line.split(' ').count() == 6).all(|line| line.ends_with(" 255 255 255")));
}

#[test]
fn a_concave_classic_polygon_keeps_its_notch() {
    let text = "8 8 10 1\n1\n1\n5 7 0\n0 0 5 1 1 1\n7 0 5 1 1 1\n7 7 5 1 1 1\n3 2 5 1 1 1\n0 7 5 1 1 1\n1\n127\n";
    let file = read_back(text);
    let canvas = Canvas { samples: 1, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };
    let (image, _) = render::draw(&file.list, Some(&ZBuffer), &canvas);
    let row = |y| (0..8).map(|x| if image.pixel(x, y).r > 0.0 { '#' } else { '.' }).collect::<String>();
    assert_eq!([row(1), row(4), row(7)], ["#######.", "##...##.", "........"]);
}

#[test]
fn the_farthest_polygon_is_drawn_and_a_nearer_one_hides_it() {
    // z = zmax behind z = 0, in both orders.
    let far = "1\n3 3 0\n0 0 9 1 0 0\n3 0 9 1 0 0\n0 3 9 1 0 0\n";
    let near = "1\n3 3 0\n0 0 0 0 1 0\n3 0 0 0 1 0\n0 3 0 0 1 0\n";
    let canvas = Canvas { samples: 1, background: Rgb::gray(0.0), transparency: Transparency::Over, threads: 1 };
    let drawn = |body: &str, count| {
        let file = read_back(&format!("4 4 9 1\n{count}\n{body}1\n127\n"));
        render::draw(&file.list, Some(&ZBuffer), &canvas).0.pixel(0, 0).to_array()
    };
    assert_eq!(drawn(far, 1), [1.0, 0.0, 0.0]);
    assert_eq!(drawn(&format!("{far}{near}"), 2), [0.0, 1.0, 0.0]);
    assert_eq!(drawn(&format!("{near}{far}"), 2), [0.0, 1.0, 0.0]);
}

#[test]
fn a_polygon_of_127_corners_is_no_end_of_file() {
    let corners: String = (0..127).map(|corner| format!("{} {} 0 0 0 0\n", corner, corner * corner % 128)).collect();
    let rows = (0..127).map(|corner| corner * corner % 128);
    let text = format!("128 128 1 1\n1\n1\n127 {} {}\n{corners}1\n127\n", rows.clone().max().unwrap_or(0), 0);
    assert_eq!(read_back(&text).list.polygon(0).vertices().len(), 127);
}

/// The example of FAROP's paper, appendix A.2, with its count made true.
#[test]
fn the_papers_example_is_read_and_written_back() {
    let text = "512 512 512 128\n2\n1\n3 100 50\n40 100 89 30 128 30\n50 80 89 30 128 30\n60 50 89 30 128 30\n1\n\
                4 110 40\n40 40 89 30 128 30\n50 110 89 30 128 30\n60 50 89 30 128 30\n55 60 89 30 128 30\n1\n127\n";
    let file = read_back(text);
    let options = ClassicOptions { z_resolution: 512, color_resolution: 128, ..ClassicOptions::default() };
    assert_eq!(classic(&file.list, &options), text);
}

// ---- The documentation ----------------------------------------------------------------------------------------------

/// The block of `docs/screen-files.md` behind the line ```` ```text NAME ````.
fn documented(name: &str) -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/screen-files.md");
    let text = std::fs::read_to_string(path).expect("the documentation is there").replace("\r\n", "\n");
    let start = format!("```text {name}\n");
    let (_, rest) = text.split_once(&start).unwrap_or_else(|| panic!("no block `{name}`"));
    rest.split_once("```").expect("the block ends").0.to_string()
}

#[test]
fn the_documented_files_are_what_the_code_writes_and_reads() {
    let v2 = v2(&tiny(), &Sheet::default(), Attributes::default());
    assert_eq!(documented("v2"), v2, "docs/screen-files.md should show:\n{v2}");
    assert_same(&read_back(&documented("v2")).list, &tiny());
    let options = ClassicOptions { z_resolution: 100, ..ClassicOptions::default() };
    let classic = classic(&tiny(), &options);
    assert_eq!(documented("classic"), classic, "docs/screen-files.md should show:\n{classic}");
    assert_eq!(read_back(&documented("classic")).list.len(), 1);
}

#[test]
fn the_documented_sample_has_the_documented_numbers() {
    let list = tiny();
    let polygon = list.polygon(0);
    assert_eq!(polygon.inverse_w(2, 2), 0.4375);
    let values = polygon.values(2, 2);
    assert_eq!(values.iter().map(|value| format!("{value:.4}")).collect::<Vec<_>>(), ["0.5714", "0.2857", "0.1429"]);
}

// ---- Bad input ------------------------------------------------------------------------------------------------------

fn error(text: &str) -> ScreenFileError {
    read(text, &ReadOptions::default()).expect_err("broken")
}

/// Breaks the good file in each of the ways (from, to) and compares what the reader says.
fn assert_messages(good: &str, cases: &[(&str, &str, &str)]) {
    let mut wrong = Vec::new();
    for (from, to, expected) in cases {
        assert!(good.contains(from), "`{from}` is not in\n{good}");
        let message = error(&good.replacen(from, to, 1)).to_string();
        if message != *expected {
            wrong.push(format!("`{from}` -> `{to}`\n  expected {expected}\n  said     {message}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn broken_v2_files_are_refused_with_line_and_column() {
    let good = v2(&tiny(), &Sheet::default(), Attributes::default());
    let _ = read_back(&good);
    let cases = [
        ("farop-screen 2", "farop-screen 3", "line 1, column 14: expected the version of the format, 2, found `3`"),
        ("samples 1", "sample 1", "line 3, column 1: expected `samples`, found `sample`"),
        (
            "samples 1",
            "samples 3",
            "line 4, column 8: expected a width of whole pixels, a multiple of 3 samples, found `6`",
        ),
        (
            "size 8 6",
            "size 8",
            "line 4, column 7: expected the height in samples, a whole number from 1 to 4194304, found the end of the line",
        ),
        (
            "size 8 6",
            "size 0 6",
            "line 4, column 6: expected the width in samples, a whole number from 1 to 4194304, found `0`",
        ),
        (
            "size 8 6",
            "size 4194304 4194304",
            "line 4, column 14: expected a picture of at most 268435456 pixels, found `4194304`",
        ),
        ("size 8 6", "size 8 6 7", "line 4, column 10: expected the end of the line, found `7`"),
        ("y_axis down", "y_axis up", "line 6, column 8: expected `down`, found `up`"),
        ("f32 1 0", "f32 1 2", "line 11, column 20: expected 1 / yon, at least 0 and below 1 / hither, found `2`"),
        (
            "depth_format f32",
            "depth_format f16",
            "line 11, column 14: expected how depth is kept, `f32` or `f64` or `int24` or `int16`, found `f16`",
        ),
        (
            "subpixel_bits 8",
            "subpixel_bits 17",
            "line 12, column 15: expected sub-pixel bits, a whole number from 0 to 16, found `17`",
        ),
        (
            "background 0 0 0",
            "background 0 nan 0",
            "line 17, column 14: expected green of the background, a finite number, found `nan`",
        ),
        ("edge red", "edge rod", "line 22, column 42: expected `red`, found `rod`"),
        (
            "polygons 1",
            "polygons 4000000000",
            "line 25, column 10: expected the number of polygons, a whole number from 0 to 536870911, found `4000000000`",
        ),
        (
            "vertices 3",
            "vertices 4",
            "line 37, column 1: expected 4 vertices, as the head says, found the end of the file",
        ),
        ("surface 0 ", "surface 1 ", "line 27, column 9: expected the number of the surface, 0, found `1`"),
        (
            "polygon 0 3",
            "polygon 0 2",
            "line 28, column 11: expected how many vertices it has, a whole number from 3 to 536870911, found `2`",
        ),
        (
            "polygon 0 3",
            "polygon 0 9",
            "line 28, column 11: expected at most 3 vertices, which is what is left of those that the head declares, found `9`",
        ),
        ("polygon 0 3 0", "polygon 0 3 1", "line 28, column 13: expected the number of its surface, 0, found `1`"),
        ("0 3 0 1 1 1", "0 3 0 1 0.5 1", "line 28, column 15: expected the opacity of surface 0, 1 1 1, found `1`"),
        ("plane red", "plane blue", "line 30, column 7: expected the plane's name, `red`, found `blue`"),
        ("-0.0625", "1e999", "line 29, column 15: expected change per sample down, a finite number, found `1e999`"),
        (
            "0.25 0.5 blocks",
            "0.25 0.125 blocks",
            "line 29, column 36: expected the greatest value at the vertices, not below the least, found `0.125`",
        ),
        ("vertex 5.5", "vertex 8.5", "line 34, column 8: expected x, a number from 0 to 8, found `8.5`"),
        ("vertex 5.5", "vertex -0.5", "line 34, column 8: expected x, a number from 0 to 8, found `-0.5`"),
        ("vertex 5.5", "vertex 5.501", "line 34, column 8: expected x, a multiple of 1/256, found `5.501`"),
        ("vertex 5.5", "vertex NaN", "line 34, column 8: expected x, a number from 0 to 8, found `NaN`"),
        (
            "11 3 2 original",
            "11 3 -2 original",
            "line 34, column 25: expected w, above 0, of which 1 / w stands before, found `-2`",
        ),
        (
            "11 3 2 original",
            "11 3 2 own",
            "line 34, column 27: expected the edge that starts here, `original` or `cut` or `diagonal`, found `own`",
        ),
        ("end\n", "", "line 36, column 1: expected `end`, found the end of the file"),
        ("end\n", "end\nmore", "line 37, column 1: expected the end of the file, found `more`"),
    ];
    assert_messages(&good, &cases);
    let transparent =
        good.replace("0.5 0.5 0.5 0 0 1 1 1", "0.5 0.5 0.5 0 0 0 0 0").replace("0 3 0 1 1 1", "0 3 0 0 0 0");
    assert_eq!(
        error(&transparent).to_string(),
        "line 28, column 15: expected opacity 1 1 1, because of `blending no`, found `0`"
    );
}

#[test]
fn broken_classic_files_are_refused_with_line_and_column() {
    let good = classic(&tiny(), &ClassicOptions { z_resolution: 100, ..ClassicOptions::default() });
    let cases = [
        ("8 6 100 255", "8 6 0 255", "line 1, column 5: expected zmax, a whole number from 1 to 2147483648, found `0`"),
        (
            "8 6 100 255",
            "8 6 100 2147483649",
            "line 1, column 9: expected cmax, a whole number from 1 to 2147483648, found `2147483649`",
        ),
        (
            "8 6 100 255",
            "8 6 100.5 255",
            "line 1, column 5: expected zmax, a whole number from 1 to 2147483648, found `100.5`",
        ),
        (
            "\n1\n1\n",
            "\n1000000\n1\n",
            "line 2, column 1: expected the number of polygons, at most 1 in a file of this length, found `1000000`",
        ),
        ("\n1\n3 ", "\n2\n3 ", "line 3, column 1: expected the separator before a polygon, 1, found `2`"),
        (
            "3 5 1",
            "-3 5 1",
            "line 4, column 1: expected the number of vertices, a whole number from 3 to 536870911, found `-3`",
        ),
        (
            "3 5 1",
            "1000000000 5 1",
            "line 4, column 1: expected the number of vertices, a whole number from 3 to 536870911, found `1000000000`",
        ),
        (
            "3 5 1",
            "900 5 1",
            "line 4, column 1: expected the number of vertices, at most 4 in a file of this length, found `900`",
        ),
        ("3 5 1", "3 4 1", "line 4, column 3: expected ymax, the largest y of the polygon, 5, found `4`"),
        ("3 5 1", "3 5 0", "line 4, column 5: expected ymin, the smallest y of the polygon, 1, found `0`"),
        ("\n5 1 67", "\n8 1 67", "line 6, column 1: expected x, a whole number from 0 to 7, found `8`"),
        ("\n5 1 67", "\n5 1 101", "line 6, column 5: expected z, a whole number from 0 to 100, found `101`"),
        ("67 255 0 0", "67 256 0 0", "line 5, column 8: expected red, a whole number from 0 to 255, found `256`"),
        ("1\n127\n", "1\n128\n", "line 9, column 1: expected the end mark, 127, found `128`"),
        ("1\n127\n", "", "line 8, column 1: expected the separator before the end, 1, found the end of the file"),
        ("1\n127\n", "1\n127\n0\n", "line 10, column 1: expected the end of the file, found `0`"),
    ];
    assert_messages(&good, &cases);
    let early = error("8 6 100 255\n1\n1\n127\n                                           ");
    assert!(early.help.as_deref().unwrap_or_default().contains("behind the last"), "{early:?}");
}

#[test]
fn other_files_are_not_taken_for_screen_files() {
    for (text, found) in
        [("", "the end of the file"), ("P6\n1 1", "`P6`"), ("\0\0\0", "`\\0\\0\\0`"), ("# só\nv", "`v`")]
    {
        let error = error(text);
        assert!(error.expected.starts_with("`farop-screen 2`, or the four"), "{error}");
        assert_eq!(error.found, found);
    }
}

#[test]
fn line_ends_comments_and_marks_of_other_systems_do_not_matter() {
    let good = v2(&tiny(), &Sheet::default(), Attributes::default());
    let foreign = good.replace('\n', "   # a note\r\n\r\n");
    assert_same(&read_back(&format!("\u{feff}{foreign}")).list, &tiny());
}

// ---- Mangled input --------------------------------------------------------------------------------------------------

/// Draws what was read: whatever a reader lets through must not hurt a rasterizer.
fn draw(file: &ScreenFile) {
    let Sheet { samples, background, transparency, .. } = file.sheet;
    if u64::from(file.list.width) * u64::from(file.list.height) > 1 << 16 {
        return;
    }
    let canvas = Canvas { samples, background, transparency, threads: 1 };
    let _ = render::draw(&file.list, Some(&ZBuffer), &canvas);
    let _ = render::draw(&file.list, Some(&PerPolygon(Wire)), &canvas);
}

fn originals() -> Vec<String> {
    let list = |choices: &Choices| render::render(&scene(), choices, Some(&ZBuffer)).expect("a fine scene").list;
    let phong = list(&Choices { shading: Shading::Phong, ..choices() });
    vec![
        v2(&tiny(), &Sheet::default(), Attributes::default()),
        v2(&phong, &Sheet::default(), Attributes { color: true, ..Attributes::default() }),
        classic(&list(&choices()), &ClassicOptions::default()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    /// Words are replaced, dropped, doubled, and the text is cut: an error, or a list that can be drawn. Never a panic.
    #[test]
    fn mangled_files_never_panic(
        which in 0usize..3,
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0usize..16), 1..4),
        cut in prop::option::of(any::<prop::sample::Index>()),
    ) {
        const WORDS: [&str; 13] = ["0", "1", "3", "-1", "nan", "1e308", "-1e308", "5e-324", "4294967295", "0.5", "end", "#", "é\u{0}"];
        let mut words: Vec<String> = originals()[which].split_inclusive([' ', '\n']).map(str::to_string).collect();
        for (place, edit) in edits {
            let place = place.index(words.len());
            let end = if words[place].ends_with('\n') { "\n" } else { " " };
            match edit {
                13 => words[place].clear(),
                14 => words[place] = words[place].repeat(2),
                15 => words[place] = words[place].trim_end().to_string(),
                edit => words[place] = format!("{}{end}", WORDS[edit]),
            }
        }
        let mut text = words.concat();
        if let Some(cut) = cut {
            let at = cut.index(text.len() + 1);
            text.truncate((0..=at).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0));
        }
        match read(&text, &ReadOptions::default()) {
            Ok(file) => draw(&file),
            Err(error) => {
                prop_assert!(error.line >= 1 && error.column >= 1);
                prop_assert!(text.get(error.span.clone()).is_some(), "{error:?}");
            }
        }
    }

    /// Any triangle of any list, at the extremes of its numbers, comes back bit for bit.
    #[test]
    fn any_numbers_come_back(bits in prop::collection::vec(any::<u64>(), 5), color in prop::collection::vec(any::<f64>(), 9)) {
        let finite = |number: &f64| if number.is_finite() { *number } else { 0.25 };
        let mut list = tiny();
        list.values = color.iter().map(finite).collect();
        let [a, b, c, low, high] = [0, 1, 2, 3, 4].map(|index| finite(&f64::from_bits(bits[index])));
        list.planes[1] = Plane { a, b, c, low: low.min(high), high: low.max(high), ..list.planes[1] };
        let file = read_back(&v2(&list, &Sheet::default(), Attributes::default()));
        assert_same(&file.list, &list);
        let sign = |list: &DrawList| list.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        prop_assert_eq!(sign(&file.list), sign(&list));
    }
}
