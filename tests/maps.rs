//! Maps on the ground: pictures by every way of laying them, and what is said of bad maps.

#[path = "support/command.rs"]
mod command;

use command::Desk;

/// Hilly land of 4 cells, in UTM zone 31.
const AREA: &str = "fcell 1
crs EPSG:32631
origin 380000 4700000
cover 1 paint:grass tile 30
cell 0 0 size 240
ground 1
dem 5 5 z0 400 dz 1  0 10 20 10 0  4 44 24 9 5  8 18 60 20 10  0 9 30 20 10  0 5 9 20 40
cell 1 0
ground 1
dem 5 5 z0 400 dz 1  0 10 0 5 9  5 20 30 10 5  10 40 60 20 9  10 10 30 20 9  40 50 9 20 40
cell 0 1
ground 1
dem 5 5 z0 400 dz 1  9 19 5 5 9  5 9 30 10 5  10 9 20 20 9  10 10 30 20 9  0 10 20 10 0
cell 1 1
ground 1
dem 5 5 z0 400 dz 1  0 10 0 5 9  5 20 30 10 5  10 40 10 20 9  10 10 30 20 9  0 10 0 5 9
end
";

/// A lake with an island, a road and a tower, in the projection of the area.
const MAP: &str = "fmap 1
crs EPSG:32631
layer things
polygon outer 6 380060 4700080 380300 4700060 380420 4700200 380350 4700400 380150 4700420 380040 4700250 hole 4 380180 4700180 380260 4700190 380250 4700280 380170 4700260 is kind lake is depth 12
line 4 380010 4700030 380240 4700030 380460 4700130 380460 4700460 is kind road is lanes 2
point 380100 4700440 is kind tower is height 30
theme lake layer things where kind = lake fill 0.1 0.3 0.9 color 0 0 0.4 width 6 m
theme road layer things where kind = road color 0.9 0.1 0.1
ramp lanes 1 3 width 8 24 m
theme tower layer things where height > 20 color 1 1 0 size 30 m
view all tower road lake
view road road
end
";

const EYE: &str = "--from 230,-220,640 --at 240,260,400 --size 160x120 --trees none";

fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("area.fcell", AREA);
    desk.write("map.fmap", MAP);
    desk
}

fn pixels(desk: &Desk, arguments: &str, name: &str) -> Vec<u8> {
    desk.made(&format!("forest area.fcell {EYE} {arguments}"), name)
}

/// The levels of a PPM.
fn levels(ppm: &[u8]) -> &[u8] {
    &ppm[ppm.len() - 160 * 120 * 3..]
}

fn count(ppm: &[u8], is: impl Fn(&[u8]) -> bool) -> usize {
    levels(ppm).chunks_exact(3).filter(|pixel| is(pixel)).count()
}

fn differing(one: &[u8], other: &[u8]) -> usize {
    let pairs = levels(one).chunks_exact(3).zip(levels(other).chunks_exact(3));
    pairs.filter(|(one, other)| (0..3).any(|channel| one[channel].abs_diff(other[channel]) > 80)).count()
}

#[test]
fn a_map_lies_on_the_ground_in_every_way() {
    let desk = desk();
    let plain = pixels(&desk, "", "plain.ppm");
    let exact = pixels(&desk, "--map map.fmap --drape exact", "exact.ppm");
    let is_blue = |pixel: &[u8]| pixel[2] / 2 > pixel[0].max(pixel[1]);
    assert_eq!(count(&plain, is_blue), 0);
    let lake = count(&exact, is_blue);
    assert!(lake > 2000, "{lake}");
    // More texels come closer to the vectors themselves; the map keeps its place on hills 60 m high.
    let off = |drape: &str, texels: u32| {
        let name = format!("{drape}{texels}.ppm");
        let picture = pixels(&desk, &format!("--map map.fmap --drape {drape} --map-texture {texels}"), &name);
        differing(&picture, &exact)
    };
    let lispsm = [64, 256, 1024].map(|texels| off("lispsm", texels));
    // Beyond as many texels as pixels only edges differ: those of the texture are soft.
    assert!(lispsm[0] > lispsm[1] + 10 && lispsm[2] < 100, "{lispsm:?}");
    assert!(off("uniform", 1024) < 120);
    let roads = pixels(&desk, "--map map.fmap --map-view road --drape exact", "roads.ppm");
    assert!(count(&roads, is_blue) == 0 && differing(&roads, &plain) > 300);
}

#[test]
fn every_rasterizer_draws_it_and_threads_do_not_matter() {
    let desk = desk();
    for drape in ["exact", "lispsm"] {
        let of = |rasterizer: &str, threads: u32| {
            let name = format!("{drape}-{rasterizer}-{threads}.ppm");
            let arguments =
                format!("--map map.fmap --drape {drape} --map-texture 256 -r {rasterizer} --threads {threads}");
            pixels(&desk, &arguments, &name)
        };
        let first = of("zbuffer", 1);
        assert_eq!(first, of("fast", 1), "{drape}");
        assert_eq!(first, of("fast", 3), "{drape}");
        // Its depths differ by rounding: of surfaces in one place either may win only where both are the same.
        let watkins = of("watkins", 1);
        assert!(differing(&watkins, &first) < 60, "{drape}: {}", differing(&watkins, &first));
    }
}

#[test]
fn geojson_and_text_are_the_same_map() {
    let desk = desk();
    desk.write(
        "things.geojson",
        r#"{"type": "FeatureCollection", "crs": {"properties": {"name": "urn:ogc:def:crs:EPSG::32631"}}, "features": [
{"type": "Feature", "properties": {"kind": "lake", "depth": 12}, "geometry": {"type": "MultiPolygon", "coordinates": [[[[380060,4700080],[380300,4700060],[380420,4700200],[380350,4700400],[380150,4700420],[380040,4700250],[380060,4700080]],[[380180,4700180],[380260,4700190],[380250,4700280],[380170,4700260],[380180,4700180]]]]}},
{"type": "Feature", "properties": {"kind": "road", "lanes": "2"}, "geometry": {"type": "LineString", "coordinates": [[380010,4700030],[380240,4700030],[380460,4700130],[380460,4700460]]}},
{"type": "Feature", "properties": {"kind": "tower", "height": 30, "odd": null}, "geometry": {"type": "Point", "coordinates": [380100,4700440,12]}},
{"type": "Feature", "properties": {"kind": "rumor"}, "geometry": null}]}"#,
    );
    let themes = &MAP[MAP.find("theme lake").expect("is there")..];
    desk.write("file.fmap", format!("fmap 1\nlayer things from things.geojson\n{themes}"));
    let of = |map: &str| pixels(&desk, &format!("--map {map}.fmap --drape exact"), &format!("{map}.ppm"));
    assert_eq!(of("map"), of("file"));
    let told = desk.run(&format!("forest area.fcell {EYE} --map file.fmap -o again.ppm")).stderr;
    assert!(told.contains("1 features without a shape"), "{told}");
}

/// Text in, words that must be in the message.
const WRONG: [(&str, &str, &[&str]); 17] = [
    ("fmap 1", "fmap 2", &["version 2", "map.fmap:1:6"]),
    ("crs EPSG:32631", "crs EPSG:3763", &["`EPSG:3763` is not known", "map.fmap:2:5", "EPSG:326zz"]),
    ("crs EPSG:32631", "crs EPSG:4326", &["no longitude and latitude", "map.fmap:4:17", "metres"]),
    ("outer 6", "outer 7", &["not a number", "map.fmap:4"]),
    ("380300 4700060 380420 4700200", "380420 4700200 380300 4700060", &["crosses or touches itself", "map.fmap:4"]),
    ("380180 4700180 380260", "380980 4700180 380260", &["hole 1", "map.fmap:4"]),
    ("is kind road", "is kind road is kind path", &["`kind` is said twice", "map.fmap:5"]),
    ("line 4 380010 4700030", "line 4 380010 NaN", &["`NaN` is not a number", "map.fmap:5:15"]),
    (
        "theme lake layer things",
        "theme lake layer thing",
        &["no layer `thing`", "map.fmap:7:18", "did you mean `things`"],
    ),
    (
        "where kind = road",
        "where knid = road",
        &["no object of layer `things` has an attribute `knid`", "map.fmap:8", "did you mean `kind`"],
    ),
    ("where kind = road", "where kind ~ road", &["`~` is no comparison", "map.fmap:8:36"]),
    ("where height > 20", "where height > tall", &["not larger or smaller", "map.fmap:10"]),
    ("width 6 m", "width 6 feet", &["`feet` is no unit", "map.fmap:7"]),
    ("fill 0.1 0.3 0.9", "fill 0.1 0.3 9", &["blue cannot be 9", "map.fmap:7"]),
    (
        "view all tower road lake",
        "view all tower rode lake",
        &["no theme `rode`", "map.fmap:11:16", "known are lake, road, tower"],
    ),
    ("layer things", "layer things from missing.geojson", &["missing.geojson", "map.fmap:3:19"]),
    ("\nend\n", "\n", &["ends without `end`"]),
];

#[test]
fn what_is_wrong_has_its_place() {
    let desk = desk();
    for (right, wrong, parts) in WRONG {
        assert!(MAP.contains(right), "{right}");
        desk.write("map.fmap", MAP.replacen(right, wrong, 1));
        let outcome = desk.run(&format!("forest area.fcell {EYE} --map map.fmap -o no.ppm"));
        assert_eq!(outcome.code, 2, "{wrong}\n{}", outcome.stderr);
        for part in parts {
            assert!(outcome.stderr.contains(part), "{wrong}: no {part} in\n{}", outcome.stderr);
        }
    }
    assert!(!desk.entries().iter().any(|name| name == "no.ppm"));
}

#[test]
fn a_map_of_somewhere_else_is_refused() {
    let desk = desk();
    let told = |area: &str, map: &str| {
        desk.write("area.fcell", area);
        desk.write("map.fmap", map);
        let outcome = desk.run(&format!("forest area.fcell {EYE} --map map.fmap -o no.ppm"));
        assert_eq!(outcome.code, 2);
        outcome.stderr
    };
    let swapped = "fmap 1\ncrs EPSG:32631\nlayer a\npoint 4700100 380100\ntheme t layer a\nview v t\nend\n";
    let text = told(AREA, swapped);
    assert!(text.contains("nothing of the map's view `v`"), "{text}");
    let text = told(&AREA.replace("crs EPSG:32631\n", ""), MAP);
    assert!(text.contains("does not say in which projection"), "{text}");
    let text = told(
        AREA,
        &MAP.replace("where kind = lake", "where kind = sea").replace("view all tower road lake", "view all lake"),
    );
    assert!(text.contains("no object fits"), "{text}");
    desk.write("area.fcell", AREA);
    desk.write("map.fmap", MAP);
    let outcome = desk.run(&format!("forest area.fcell {EYE} --map map.fmap --map-view none -o no.ppm"));
    assert!(outcome.stderr.contains("no view `none`: it has all, road"), "{}", outcome.stderr);
}

#[test]
fn bad_geojson_names_feature_and_line() {
    let desk = desk();
    desk.write("map.fmap", "fmap 1\nlayer a from a.geojson\ntheme t layer a\nview v t\nend\n");
    let of = |geometry: &str| {
        format!(
            "{{\"type\": \"FeatureCollection\", \"features\": [\n{{\"type\": \"Feature\", \"properties\": {{\"n\": \"a [ \\\" {{\"}}, \"geometry\": {{\"type\": \"Point\", \"coordinates\": [1, 42]}}}},\n{{\"type\": \"Feature\", \"geometry\": {geometry}}}]}}"
        )
    };
    let polygon = |ring: &str| of(&format!("{{\"type\": \"Polygon\", \"coordinates\": [[{ring}]]}}"));
    for (text, parts) in [
        (polygon("[1,42],[1,43],[2,43],[2,42]"), ["feature 2: the outline is not closed", "a.geojson:3:1"]),
        (polygon("[1,42],[2,43],[1,43],[2,42],[1,42]"), ["feature 2: the outline crosses or touches itself", "a.geojson:3:1"]),
        (polygon("[1,42],[1,43],[1,42]"), ["has 3 positions", "a.geojson:3:1"]),
        (of("{\"type\": \"Point\", \"coordinates\": [42.5, 101.5]}"), ["are the axes swapped", "a.geojson:3:1"]),
        (of("{\"type\": \"Circle\", \"coordinates\": [1, 2]}"), ["`Circle`", "a.geojson:3:1"]),
        (of("{\"type\": \"LineString\", \"coordinates\": [[1, 2]]}"), ["two or more", "a.geojson:3:1"]),
        (of("{\"type\": \"Point\", \"coordinates\": [\"1\", 2]}"), ["no position of two numbers", "a.geojson:3:1"]),
        ("{\"type\": \"FeatureCollection\",\n\"features\": [".to_string(), ["no JSON", "a.geojson:2"]),
        ("{\"type\": \"Topology\"}".to_string(), ["`Topology`", "a.geojson:1:1"]),
        ("{\"type\": \"FeatureCollection\", \"crs\": {\"properties\": {\"name\": \"EPSG:27572\"}}, \"features\": []}".to_string(), ["`EPSG:27572` is not known", "a.geojson:1:1"]),
    ] {
        desk.write("a.geojson", &text);
        let outcome = desk.run(&format!("forest area.fcell {EYE} --map map.fmap -o no.ppm"));
        assert_eq!(outcome.code, 2, "{text}");
        for part in parts {
            assert!(outcome.stderr.contains(part), "{text}: no {part} in\n{}", outcome.stderr);
        }
    }
}

/// 9 x 9 heights, 30 m apart; `corner` is where they lie.
fn grid(desk: &Desk, name: &str, corner: &str) {
    let row = "400 410 425 410 400 404 420 430 410\n";
    desk.write(name, format!("ncols 9\nnrows 9\n{corner}\nNODATA_value -9999\n{}", row.repeat(9)));
}

#[test]
fn a_map_lies_on_a_relief_as_well() {
    let desk = desk();
    grid(&desk, "metres.asc", "xllcorner 380000\nyllcorner 4700000\ncellsize 60");
    let from_above = "terrain metres.asc --units metres --error 1 --size 160x160 --colors plain";
    let bare = desk.made(from_above, "b.ppm");
    for drape in ["lispsm", "uniform", "exact"] {
        let map = format!("{from_above} --map map.fmap --grid-crs EPSG:32631 --drape {drape}");
        let worn = desk.made(&map, "m.ppm");
        let blue = worn[worn.len() - 160 * 160 * 3..].chunks(3).filter(|it| it[2] > 100 && it[0] < it[2] / 2).count();
        assert!(blue > 1000 && worn != bare, "{drape}: {blue} pixels of the lake");
    }
}

#[test]
fn maps_that_lie_on_no_relief_are_refused() {
    let desk = desk();
    grid(&desk, "metres.asc", "xllcorner 380000\nyllcorner 4700000\ncellsize 60");
    for (options, expected) in [
        ("-o no.ppm", "say it, as in --grid-crs"),
        ("--grid-crs EPSG:32630 -o no.ppm", "nothing of the map's view `all` lies within"),
        ("--grid-crs EPSG:3763 -o no.ppm", "expected a zone of UTM"),
        ("--grid-crs EPSG:32631 -o no.nff", "no scene file can hold the map"),
        ("--grid-crs EPSG:32631 --map-view none -o no.ppm", "has no view `none`"),
    ] {
        let outcome = desk.run(&format!("terrain metres.asc --units metres --map map.fmap {options}"));
        assert_eq!(outcome.code, 2, "{options}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(expected), "{options}: {}", outcome.stderr);
    }
    assert!(!desk.entries().iter().any(|name| name.starts_with("no.")));
}
