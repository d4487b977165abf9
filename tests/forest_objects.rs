//! Scenes that stand on an area, pictures that stand in a scene, walks that a device steers.

#[path = "support/command.rs"]
mod command;

use command::{Desk, project_scene};
use farop::forest::area::Head;
use farop::forest::objects::{Models, Standing, stand};
use farop::math::Vec3;
use farop::parse::{ParseOptions, load};
use farop::scene::{Place, Scene};
use std::path::Path;

const AREA: &str = "fcell 1
cover 1 paint:grass tile 30
object house.sipp 60 60 30 2
cell 0 0 size 240 seed 7
ground 1
dem 5 5 z0 400 dz 1  0 10 20 10 0  4 24 24 9 5  8 18 30 20 10  0 9 30 20 10  0 5 9 20 40
object house.sipp 150 110
end
";

/// A red box 8 x 6 x 4 whose foot is 3 below its origin.
const HOUSE: &str = "camera { from 0 -20 8  at 0 0 3  up 0 0 1 }
shader wall phong { ambient 1  diffuse 0  specular 0  color 1 0 0 }
world { object { block { size 8 6 4  shader wall }  move 10 0 -1 } }
";

const EYE: &str = "--from 100,-60,470 --at 110,100,420 --size 200x150 --trees none";

fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("area.fcell", AREA);
    desk.write("house.sipp", HOUSE);
    desk
}

fn red(ppm: &[u8]) -> usize {
    ppm[ppm.len() - 200 * 150 * 3..].chunks_exact(3).filter(|pixel| pixel[0] > 200 && pixel[1] < 60).count()
}

#[test]
fn objects_are_drawn_where_they_stand_from_text_and_pack() {
    let desk = desk();
    let both = desk.made(&format!("forest area.fcell {EYE}"), "both.ppm");
    assert!(red(&both) > 100, "{}", red(&both));
    desk.done("forest pack area.fcell -o area.fpack");
    assert_eq!(both, desk.made(&format!("forest area.fpack {EYE}"), "packed.ppm"));
    assert_eq!(both, desk.made(&format!("forest area.fcell {EYE} -r zbuffer --threads 1"), "z.ppm"));
    desk.done("forest unpack area.fpack -o again.fcell");
    let again = String::from_utf8(desk.read("again.fcell")).expect("text");
    assert!(again.contains("object house.sipp 60 60 30 2\nobject house.sipp 150 110 0 1"), "{again}");
    desk.write("bare.fcell", AREA.lines().filter(|line| !line.starts_with("object")).collect::<Vec<_>>().join("\n"));
    assert_eq!(red(&desk.made(&format!("forest bare.fcell {EYE}"), "bare.ppm")), 0);
    // In the one tree of the area, by its own name.
    let told = desk.done("render area.fcell -r none --dump-stage scene").text().to_string();
    assert!(told.contains("house.sipp"), "{told}");
    // One that is beyond the horizon is not drawn.
    assert_eq!(red(&desk.made(&format!("forest area.fcell {EYE} --horizon 50"), "near.ppm")), 0);
}

#[test]
fn who_collides_walks_around_a_house() {
    let desk = desk();
    desk.write("area.fcell", AREA.replace("dz 1 ", "dz 0.1 "));
    // Not through its very middle: there is no way around a wall that is met head on.
    let walk = "forest area.fcell --walk 151,20,1.7,146,220,1.7 --trees none --size 16x12 --record";
    desk.done(&format!("{walk} free.path"));
    desk.done(&format!("{walk} around.path --collide"));
    let inside = |name: &str| {
        let text = String::from_utf8(desk.read(name)).expect("text");
        let lines = text.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
        let places =
            lines.map(|line| line.split_whitespace().map(|word| word.parse().expect("a number")).collect::<Vec<f64>>());
        places.filter(|place| (place[0] - 150.0).abs() < 4.0 && (place[1] - 110.0).abs() < 3.0).count()
    };
    assert!(inside("free.path") > 3);
    assert_eq!(inside("around.path"), 0);
}

#[test]
fn what_cannot_stand_is_told_with_its_place() {
    let desk = desk();
    let told = |area: String, house: &str| {
        desk.write("area.fcell", area);
        desk.write("house.sipp", house);
        let outcome = desk.run(&format!("forest area.fcell {EYE} -o no.ppm"));
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        outcome.stderr
    };
    for (area, house, parts) in [
        (AREA.replace("house.sipp 60", "hut.sipp 60"), HOUSE, ["hut.sipp", "area.fcell:3"]),
        (AREA.to_string(), "world { sphere { radius 1 } }", ["house.sipp:1", "area.fcell:3"]),
        (AREA.to_string(), "world { }", ["neither polygons nor shapes", "area.fcell:3"]),
        (AREA.replace("60 60 30 2", "-60 60 30 2"), HOUSE, ["no ground for `house.sipp` at -60 60", "area.fcell:3"]),
        (AREA.replace("house.sipp 60", "other.fcell 60"), HOUSE, ["no scene that can stand", "area.fcell:3:8"]),
        (AREA.replace("60 60 30 2", "60 60 30 0"), HOUSE, ["the scale cannot be 0", "area.fcell:3:28"]),
        (AREA.replace("60 60 30 2", "60 60 30 2 5"), HOUSE, ["number too many", "area.fcell:3:30"]),
        (AREA.replace("60 60 30 2", "60 north"), HOUSE, ["not a number", "area.fcell:3:22"]),
        (AREA.replace("150 110", "350 110"), HOUSE, ["the object", "area.fcell:7"]),
    ] {
        let text = told(area.clone(), house);
        for part in parts {
            assert!(text.contains(part), "{area}: no {part} in\n{text}");
        }
    }
}

fn scene(name: &str, text: &str) -> Scene {
    let desk = Desk::new();
    desk.write(name, text);
    let parsed = load(&desk.path(name), None, ParseOptions::default()).expect("a scene");
    let mut scene = parsed.scene;
    scene.camera = scene.camera.or(parsed.default_camera);
    scene
}

/// The corners of all that stands, world space.
fn corners(scene: &Scene) -> Vec<Vec3> {
    let mut corners = Vec::new();
    scene
        .walk(|placed| {
            for &id in &placed.object.surfaces {
                let mesh = &scene.surface(id).mesh;
                corners.extend(mesh.vertices.iter().map(|&vertex| placed.world_from_local.transform_point3(vertex)));
            }
        })
        .expect("small");
    corners
}

#[test]
fn feet_are_on_the_lowest_ground_below_and_up_is_up() {
    let with = |up: &str, low: [f64; 3], high: [f64; 3]| {
        let v = |corner: usize| {
            let at = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
            format!("v {} {} {} ", at(0), at(1), at(2))
        };
        let faces =
            [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4]].map(|face| format!("facet {{ {} }}", face.map(v).join(" ")));
        let text = format!(
            "camera {{ from 9 9 9 at 0 0 0 up {up} }} shader a phong {{ }} world {{ object {{ surface a {{ {} }} }} }}",
            faces.join(" ")
        );
        scene("box.sipp", &text)
    };
    // A tower 2 x 4 and 10 high, in scenes with each of their axes up.
    let towers = [
        with("0 0 1", [5.0, 1.0, -3.0], [7.0, 5.0, 7.0]),
        with("0 1 0", [5.0, -3.0, -5.0], [7.0, 7.0, -1.0]),
        with("1 0 0", [-3.0, 5.0, 1.0], [7.0, 7.0, 5.0]),
        with("0 0 -1", [5.0, -5.0, -7.0], [7.0, -1.0, 3.0]),
    ];
    for (number, tower) in towers.into_iter().enumerate() {
        for (turn, scale) in [(0.0, 1.0), (90.0, 2.0), (37.0, 0.5)] {
            let ground = |[x, y]: [f64; 2]| Some(100.0 + 0.3 * x - 0.7 * y);
            let standing = Standing { file: "tower".into(), at: [40.0, 50.0], turn, scale, place: Place::default() };
            let head = Head { objects: vec![standing], side: 240.0, ..Head::default() };
            let models: Models = [("tower".to_string(), tower.clone())].into();
            let stood = stand(&head, &models, ground).expect("stands");
            let corners = corners(&stood.scene);
            let (low, high) = corners.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), corner| {
                (low.min(corner.z), high.max(corner.z))
            });
            assert!((high - low - 10.0 * scale).abs() < 1e-9, "{number} {turn}: {low} {high}");
            // No corner hangs in the air, and one touches.
            let gaps = corners
                .iter()
                .filter(|corner| corner.z < low + 1e-9)
                .map(|foot| foot.z - ground([foot.x, foot.y]).expect("plain"));
            let highest = gaps.fold(f64::NEG_INFINITY, f64::max);
            assert!(highest.abs() < 1e-9, "{number} {turn}: {highest}");
            let middle = corners.iter().fold(Vec3::ZERO, |sum, corner| sum + *corner) / corners.len() as f64;
            assert!((middle - Vec3::new(40.0, 50.0, middle.z)).length() < 1.5 * scale, "{number} {turn}: {middle}");
            let ball = stood.balls[0];
            assert!(corners.iter().all(|corner| corner.distance(ball.0) < ball.1 + 1e-9));
            let [low, high] = stood.boxes[0];
            assert!(corners.iter().all(|corner| corner.cmpge(low - 1e-9).all() && corner.cmple(high + 1e-9).all()));
        }
    }
}

/// What `billboard` and `crossed` say in short, in full; all rasterizers see the same.
#[test]
fn standing_pictures_are_what_their_quads_are() {
    let desk = Desk::new();
    let tree = Path::new(&project_scene("tree.png")).to_path_buf();
    desk.write("tree.png", std::fs::read(tree).expect("the picture"));
    let scene = |items: &str| {
        format!(
            "image 120 90 camera {{ from 0 -12 3 at 0 0 2.5 up 0 0 1 angle 50 }} background .5 .6 .7 light directional {{ to 1 -2 3 }}
shader tree phong {{ ambient 1 diffuse 0 specular 0 texture \"tree.png\" cutout .4 }} world {{ {items} }}"
        )
    };
    let quad = "two_sided on v -2 0 0 t 0 0 0 v 2 0 0 t 1 0 0 v 2 0 5 t 1 1 0 v -2 0 5 t 0 1 0 facet { 1 2 3 4 }";
    let cross = "v 0 -2 0 t 0 0 0 v 0 2 0 t 1 0 0 v 0 2 5 t 1 1 0 v 0 -2 5 t 0 1 0 facet { 5 6 7 8 }";
    let pairs = [
        (
            "object { billboard \"tree.png\" 4 5 { cutout .4 } move 0 1 0 }",
            format!("object {{ surface tree {{ {quad} }} move 0 1 0 }}"),
        ),
        (
            "object { crossed tree.png 4 5 { cutout .4 } rotate z 30deg }",
            format!("object {{ surface tree {{ {quad} {cross} }} rotate z 30deg }}"),
        ),
        // From wherever it stands it shows the eye its front.
        (
            "object { billboard \"tree.png\" 4 5 { cutout .4 } rotate z 77deg move 0 2 0 }",
            format!("object {{ surface tree {{ {quad} }} move 0 2 0 }}"),
        ),
    ];
    for (short, long) in pairs {
        desk.write("short.sipp", scene(short));
        desk.write("long.sipp", scene(&long));
        for rasterizer in ["zbuffer", "fast", "watkins"] {
            let of = |name: &str| desk.made(&format!("render {name}.sipp -r {rasterizer}"), &format!("{name}.ppm"));
            let (one, other) = (of("short"), of("long"));
            // Turned by hand and turned by the program differ in the last digit of a corner.
            let differing = one.iter().zip(&other).filter(|(one, other)| one != other).count();
            assert!(differing <= if short.contains("77deg") { 30 } else { 0 }, "{short} {rasterizer}: {differing}");
        }
    }
    let first = desk.read("short.ppm");
    assert!(first.windows(3).any(|pixel| pixel[1] > pixel[0] && pixel[1] > pixel[2]), "something green");
    // Told when it is lost.
    let told = desk.run("convert short.sipp -o out.sipp");
    assert!(told.stderr.contains("turn to the camera"), "{}", told.stderr);
}

#[test]
fn standing_pictures_that_are_none() {
    let desk = Desk::new();
    for (item, parts) in [
        ("billboard \"no.png\" 4 5", ["no texture `no.png`", "s.sipp:1:29"]),
        ("billboard \"no.png\" 0 5", ["cannot be 0 wide or high", "s.sipp:1:37"]),
        ("crossed \"no.png\" 4", ["s.sipp:1:", "number"]),
        ("crossed 4 5", ["`4` is not a name", "s.sipp:1:26"]),
        ("billboard \"no.png\" 4 5 { wrap clamp }", ["wrap", "s.sipp:1:"]),
    ] {
        desk.write("s.sipp", format!("world {{ object {{ {item} }} }}"));
        let outcome = desk.run("render s.sipp -o no.ppm");
        assert_eq!(outcome.code, 2, "{item}");
        for part in parts {
            assert!(outcome.stderr.contains(part), "{item}: no {part} in\n{}", outcome.stderr);
        }
    }
}

#[test]
fn a_device_steers() {
    let desk = desk();
    desk.write("stick.txt", "# heading pitch speed\n0 0 50\n0 0 50\n90 -5 50\n180 0 -50\n");
    let from = "--from 100,50,0 --height 2 --size 16x12 --rate 10";
    desk.done(&format!("forest area.fcell --input stick.txt {from} --record walk.path"));
    let text = String::from_utf8(desk.read("walk.path")).expect("text");
    let places: Vec<(f64, f64)> = text
        .lines()
        .skip(2)
        .map(|line| {
            let mut words = line.split_whitespace().map(|word| word.parse().expect("a number"));
            (words.next().expect("x"), words.next().expect("y"))
        })
        .collect();
    let near = |(x, y): (f64, f64), (a, b): (f64, f64)| (x - a).abs() < 1e-9 && (y - b).abs() < 1e-9;
    let expected = [(100.0, 50.0), (100.0, 55.0), (100.0, 60.0), (105.0, 60.0)];
    assert!(
        places.len() == 4 && places.iter().zip(expected).all(|(&place, expected)| near(place, expected)),
        "{places:?}"
    );
    // The same through a pipe; a device that is pulled out loses its last line alone.
    let of = |text: &str| {
        let text = text.as_bytes().to_vec();
        desk.run_with_input(&format!("forest area.fcell --input - {from} --trees none --hash"), move |input| {
            input.write_all(&text).expect("written");
        })
    };
    let whole = of("0 0 50\n0 0 50\n90 -5 50\n180 0 -50\n");
    let cut = of("0 0 50\n0 0 50\n90 -5 50\n180 0 -50\n45 0");
    assert_eq!((whole.code, cut.code), (0, 0), "{}", whole.stderr);
    assert_eq!(whole.stdout, cut.stdout);
    assert!(cut.stderr.contains("middle of a line"), "{}", cut.stderr);
    let bad = of("0 0 50\n0 fast 50\n");
    assert!(bad.code == 2 && bad.stderr.contains("line 2, column 3: `fast`"), "{}", bad.stderr);
    let empty = of("# nothing\n");
    assert!(empty.code == 2 && empty.stderr.contains("a line a frame"), "{}", empty.stderr);
}
