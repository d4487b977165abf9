//! Import of a forest: land of each stand is kept, neighbors share their heights, stands are what they were by year; and bad input is told with its place.
//!
//! Land is counted by an oracle that shares no code with the cutter: rows of a fine raster over the stands, even-odd.

use farop::diagnostic::Diagnostic;
use farop::forest::area::{Area, Ground, Owner};
use farop::forest::elevation::{Frame, Grid, Unit};
use farop::forest::import::{Choices, Growth, Imported, Record, Relief, Sources, What, import};
use farop::forest::vector::{Attribute, Crs, Feature, Geometry, Layer, Rings};
use farop::parse::read_inventory;
use farop::scene::Place;
use std::collections::BTreeMap;

const MAP: Crs = Crs::Utm { zone: 31, south: false };
/// South-west of the relief, no multiple of 240 m.
const CORNER: [f64; 2] = [390_017.0, 4_700_033.0];

/// 61 x 61 samples, 50 m apart, rolling.
fn relief() -> Relief {
    let height = |index: usize| {
        let (column, row) = ((index % 61) as f32, (index / 61) as f32);
        1200.0 + 7.3 * column - 4.1 * row + 60.0 * (column * 0.3).sin() * (row * 0.23).cos()
    };
    let frame = Frame { unit: Unit::Metres, west: CORNER[0], north: CORNER[1] + 3000.0, step: [50.0, 50.0] };
    let grid = Grid::new("hill", (61, 61), (0..61 * 61).map(height).collect(), frame).expect("61 x 61");
    Relief { grid, crs: MAP }
}

/// A star of so many points around a place of the relief.
fn star(center: [f64; 2], reach: [f64; 2], points: usize) -> Vec<[f64; 2]> {
    let corner = |number: usize| {
        let angle = number as f64 / (2 * points) as f64 * std::f64::consts::TAU;
        let far = reach[number % 2];
        [CORNER[0] + center[0] + far * angle.cos(), CORNER[1] + center[1] + far * angle.sin()]
    };
    (0..2 * points).map(corner).collect()
}

fn feature(stand: &str, line: u32, parts: Vec<Rings>) -> Feature {
    let attributes = BTreeMap::from([("stand".to_string(), Attribute::Text(stand.to_string()))]);
    Feature { attributes, geometry: Geometry::Polygons(parts), place: Place { file: 0, line } }
}

/// A stand with a hole over borders, one of two parts, of which one has a hole, and one with a name; together over some 60 cells.
fn stands() -> Layer {
    let holed = Rings {
        outer: star([1100.0, 1500.0], [800.0, 500.0], 9),
        holes: vec![star([1100.0, 1500.0], [330.0, 140.0], 5)],
    };
    let island =
        Rings { outer: star([2300.0, 600.0], [420.0, 300.0], 7), holes: vec![star([2280.0, 640.0], [90.0, 60.0], 4)] };
    let islet = Rings { outer: star([2400.0, 2300.0], [260.0, 120.0], 6), holes: vec![] };
    let small = Rings { outer: star([500.0, 400.0], [90.0, 80.0], 4), holes: vec![] };
    let features = vec![
        feature("12", 3, vec![holed]),
        feature("7", 4, vec![island, islet]),
        feature("north slope", 5, vec![small]),
    ];
    Layer { name: "stands".to_string(), files: vec!["stands.geojson".to_string()], crs: Some(MAP), features }
}

const TABLE: &str = "stand,species,height,sd,crown,density,year,action\n\
    12,PINPR,18.5,2.1,4.6,520,2011,\n12,,,,,,2018,burnt\n12,QUESU,,,,,2020,replanted\n\
    7,QUESU,11,1.5,,220,,\nnorth slope,EUCGL,24,2,4,1000,2011,\nnorth slope,EUCGL,28,2,4.5,950,2018,\n";

fn table(text: &str) -> Vec<Record> {
    read_inventory("table.csv", text.as_bytes(), &BTreeMap::new())
        .unwrap_or_else(|errors| panic!("{}", errors.render(false)))
        .records
}

fn made(layer: &Layer, records: &[Record], choices: &Choices) -> Result<Imported, Vec<Diagnostic>> {
    import(&Sources { relief: &relief(), stands: layer, lines: None, table: records, plan: &[] }, choices)
}

fn area() -> Imported {
    made(&stands(), &table(TABLE), &Choices::default()).expect("an area")
}

/// Square metres of rings, even-odd, by rows 0.25 m apart: exact in x, the middle of each row in y.
fn counted(rings: &[&Vec<[f64; 2]>]) -> f64 {
    let step = 0.25;
    let ys = || rings.iter().flat_map(|ring| ring.iter()).map(|corner| corner[1]);
    let (low, high) = (ys().fold(f64::INFINITY, f64::min), ys().fold(f64::NEG_INFINITY, f64::max));
    let mut sum = 0.0;
    let mut y = low + step / 2.0;
    while y < high {
        let mut xs = Vec::new();
        for ring in rings {
            for (index, from) in ring.iter().enumerate() {
                let to = ring[(index + 1) % ring.len()];
                if (from[1] <= y) != (to[1] <= y) {
                    xs.push(from[0] + (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1]));
                }
            }
        }
        xs.sort_by(f64::total_cmp);
        sum += xs.chunks(2).map(|pair| pair[1] - pair[0]).sum::<f64>() * step;
        y += step;
    }
    sum
}

fn land_of(area: &Area, number: u32) -> f64 {
    let mut sum = 0.0;
    for cell in area.cells.values() {
        for patch in &cell.patches {
            let Owner::Stand(stand) = patch.owner else { continue };
            if cell.stands[stand as usize].number == number {
                let rings: Vec<&Vec<[f64; 2]>> = std::iter::once(&patch.outer).chain(&patch.holes).collect();
                sum += counted(&rings);
            }
        }
    }
    sum
}

#[test]
fn hectares_of_each_stand_are_kept() {
    let imported = area();
    for (number, feature) in [(12, 0), (7, 1), (13, 2)] {
        let Geometry::Polygons(parts) = &stands().features[feature].geometry else { panic!("polygons") };
        let whole: f64 = parts
            .iter()
            .map(|part| counted(&std::iter::once(&part.outer).chain(&part.holes).collect::<Vec<_>>()))
            .sum();
        let cut = land_of(&imported.area, number);
        assert!((cut - whole).abs() < 5e-4 * whole, "stand {number}: {cut} of {whole}");
        assert!((imported.summary.stands[&number].land - whole).abs() < 5e-4 * whole, "stand {number}");
    }
    let summary = &imported.summary;
    assert_eq!((summary.polygons, summary.multipolygons, summary.holes, summary.stands.len()), (4, 1, 2, 3));
    assert!(imported.notices.is_empty(), "{:?}", imported.notices);
}

#[test]
fn neighbors_have_the_same_heights_on_their_border_and_they_are_the_reliefs() {
    let area = area().area;
    let mut shared = 0;
    for (index, cell) in &area.cells {
        for (step, here, there) in [([1, 0], [8, 0], [0, 0]), ([0, 1], [0, 0], [0, 8])] {
            let Some(next) = area.cells.get(&[index[0] + step[0], index[1] + step[1]]) else { continue };
            for number in 0..9 {
                let along = |at: [usize; 2]| if step[0] == 1 { [at[0], number] } else { [number, at[1]] };
                let ([x, y], [u, v]) = (along(here), along(there));
                let (one, other) = (cell.ground.sample(x, y), next.ground.sample(u, v));
                assert_eq!(one.to_bits(), other.to_bits(), "{index:?} {step:?} {number}");
                shared += usize::from(!one.is_nan());
            }
        }
        let Ground::Lattice { step, .. } = &cell.ground else { panic!("a lattice") };
        let corner = [0, 1].map(|axis| area.head.origin[axis] + f64::from(index[axis]) * 240.0);
        let asked = relief().height(MAP, [corner[0] + 30.0, corner[1] + 240.0]);
        if let Some(asked) = asked {
            assert!((cell.ground.sample(1, 0) - asked).abs() <= step / 2.0, "{index:?}");
        }
    }
    assert!(shared > 1000, "{shared}");
}

#[test]
fn stands_are_what_they_were_by_year() {
    let area = area().area;
    let cell = area.cells.values().find(|cell| cell.stands.iter().any(|stand| stand.number == 12)).expect("a cell");
    let stand = cell.stands.iter().find(|stand| stand.number == 12).expect("stand 12");
    let told = |year: i32| {
        let state = stand.in_year(Some(year)).expect("a state");
        let cover = &area.head.covers[usize::from(state.cover.expect("a ground"))].image;
        (area.head.species[usize::from(state.species)].code.clone(), state.density, cover.clone())
    };
    assert_eq!(told(2011), ("PINPR".to_string(), 520.0, "paint:pine_floor".to_string()));
    assert_eq!((told(2019).1, told(2019).2.as_str()), (0.0, "paint:burnt"));
    let heights = [2020, 2024, 2030, 2050].map(|year| stand.in_year(Some(year)).expect("a state").height.mean);
    assert!(heights.windows(2).all(|pair| pair[0] < pair[1]) && heights[0] < 2.0 && heights[3] > 8.0, "{heights:?}");
    let only =
        made(&stands(), &table(TABLE), &Choices { year: Some(2019), ..Choices::default() }).expect("an area").area;
    assert!(
        only.cells
            .values()
            .flat_map(|cell| &cell.stands)
            .all(|stand| stand.states.len() == 1 && stand.states[0].year.is_none())
    );
}

#[test]
fn an_imported_area_is_read_back_from_its_text() {
    let imported = area();
    let cells = farop::forest::cells::Cells::Loaded(imported.area);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("area.fcell");
    let mut text = Vec::new();
    farop::write::write_fcell(&cells, &mut text).expect("memory");
    std::fs::write(&path, &text).expect("a file");
    let (back, notices) = farop::parse::load_cells(&path).unwrap_or_else(|errors| panic!("{}", errors.render(false)));
    assert!(notices.is_empty(), "{}", notices.render(false));
    let mut again = Vec::new();
    farop::write::write_fcell(&back, &mut again).expect("memory");
    assert!(text == again);
}

#[test]
fn a_plan_goes_before_the_table() {
    let plan =
        [Record { stand: "north slope".to_string(), year: Some(2015), what: What::Cut, origin: "`--cut`".to_string() }];
    let records = table(TABLE);
    let (relief, layer) = (relief(), stands());
    let sources = Sources { relief: &relief, stands: &layer, lines: None, table: &records, plan: &plan };
    let imported = import(&sources, &Choices::default()).expect("an area");
    let stand =
        imported.area.cells.values().flat_map(|cell| &cell.stands).find(|stand| stand.number == 13).expect("stand 13");
    assert_eq!(
        stand.states.iter().map(|state| (state.year, state.density)).collect::<Vec<_>>(),
        [(Some(2011), 1000.0), (Some(2015), 0.0)]
    );
    assert!(imported.notices[0].message.contains("before 1 rows"), "{:?}", imported.notices);
}

/// `name:line:column: message` of everything that is wrong with a table.
fn faults(text: &str) -> Vec<String> {
    let errors = read_inventory("t.csv", text.as_bytes(), &BTreeMap::new()).expect_err("mistakes");
    errors.list.iter().map(|error| format!("{}: {}", errors.place(error).unwrap_or_default(), error.message)).collect()
}

#[test]
fn mistakes_of_a_table_are_told_with_line_and_column() {
    assert_eq!(faults("stand,species,height\n1,P,2\n"), ["t.csv:1:1: the table has no column `density`"]);
    let head = "stand,species,height,density,year,action";
    let told = |rows: &str| faults(&format!("{head}\n{rows}"));
    assert_eq!(
        told("1,P,tall,300,,\n2,P,12,300,,\n3,P,12,-4,,\n"),
        ["t.csv:2:5: `tall` is no number", "t.csv:4:8: density -4 is not within 0 to 20000"]
    );
    assert_eq!(told("1,P,12,300,2011,\n\n1,P,14,290,2011,\n"), ["t.csv:4:1: stand `1` is in the table twice in 2011"]);
    assert_eq!(
        told("1,P,12,300,,\n1,P,14,290,2011,\n"),
        ["t.csv:2:1: stand `1` has a row without a year and rows with one"]
    );
    assert_eq!(told("1,P,,300,,\n"), ["t.csv:2:1: a row without height"]);
    assert_eq!(told("1,P,12,300,2011,fell\n"), ["t.csv:2:17: `fell` is nothing that is done to a stand"]);
    assert_eq!(told("1,P,12,300,,cut\n"), ["t.csv:2:13: since when is the stand cut?"]);
    assert_eq!(told("1,P,12,300,2011,,9\n"), ["t.csv:2:18: 7 fields, and 6 columns"]);
    assert_eq!(told("1,\"P,12,300,2011,\n"), ["t.csv:2:3: a quote is never closed"]);
    assert_eq!(faults("stand,species,height,density,h\n1,P,2,3,4\n"), ["t.csv:1:30: two columns hold the height"]);
    assert!(faults("")[0].contains("no rows") && faults(head)[0].contains("no rows below"));
    assert_eq!(told(&"1,P,x,300,,\n".repeat(50)).len(), 20);
}

/// The one error of an import.
fn refused(layer: &Layer, choices: &Choices) -> (String, String) {
    let errors = made(layer, &table(TABLE), choices).expect_err("an error");
    (errors[0].message.clone(), errors[0].help.clone().unwrap_or_default())
}

#[test]
fn stands_that_are_nowhere_are_told_with_what_to_do() {
    let choices = Choices::default();
    let mut layer = stands();
    layer.crs = None;
    let (message, help) = refused(&layer, &choices);
    assert!(message.contains("does not say its projection") && help.contains("--stands-crs"), "{message} {help}");

    let swapped = |layer: &mut Layer| {
        for feature in &mut layer.features {
            let Geometry::Polygons(parts) = &mut feature.geometry else { panic!("polygons") };
            parts
                .iter_mut()
                .flat_map(|part| std::iter::once(&mut part.outer).chain(&mut part.holes))
                .flatten()
                .for_each(|corner| corner.swap(0, 1));
        }
    };
    let mut layer = stands();
    swapped(&mut layer);
    let (message, help) = refused(&layer, &choices);
    assert!(message.contains("outside of the relief `hill`") && help.contains("axes are swapped"), "{message} {help}");

    let mut layer = stands();
    layer.features[0].attributes = BTreeMap::from([("stnd".to_string(), Attribute::Number(12.0))]);
    let (message, help) = refused(&layer, &choices);
    assert!(
        message.starts_with("stands.geojson:3: feature 1: no attribute") && help.contains("--map stnd=stand"),
        "{message} {help}"
    );

    let mut layer = stands();
    layer.features.truncate(0);
    assert!(refused(&layer, &choices).0.contains("no polygon"));

    let mut layer = stands();
    layer.crs = Some(Crs::Degrees);
    assert!(refused(&layer, &choices).0.starts_with("stands.geojson:3: feature 1: longitude"));

    let mut layer = stands();
    layer.features.push(feature("12", 9, vec![Rings { outer: star([9e6, 0.0], [50.0, 30.0], 5), holes: vec![] }]));
    assert!(refused(&layer, &choices).0.contains("more than 250000"));
}

#[test]
fn what_has_no_match_is_a_notice_with_its_place() {
    let records = table("stand,species,height,density\n12,P,9,300\n\n8,P,9,300\n");
    let imported = made(&stands(), &records, &Choices::default()).expect("an area");
    let messages: Vec<&str> = imported.notices.iter().map(|notice| notice.message.as_str()).collect();
    assert_eq!(
        messages[0],
        "2 stands have polygons and no row in the table: `7` (stands.geojson:4: feature 2), `north slope` (stands.geojson:5: feature 3)"
    );
    assert_eq!(messages[1], "1 stands are in the table and have no polygon: `8` (table.csv:4:1)");
    let mut layer = stands();
    layer.features.push(feature(
        "12",
        9,
        vec![Rings { outer: star([3000.0, 1000.0], [400.0, 300.0], 5), holes: vec![] }],
    ));
    let imported = made(&layer, &table(TABLE), &Choices::default()).expect("an area");
    assert!(imported.notices[0].message.starts_with("stands.geojson:9: feature 4: "), "{:?}", imported.notices);
}

#[test]
fn land_use_makes_default_stands_and_grounds() {
    let with = |pairs: &[(&str, &str)], center: [f64; 2]| {
        let attributes =
            pairs.iter().map(|(name, text)| (name.to_string(), Attribute::Text(text.to_string()))).collect();
        Feature { attributes, ..feature("", 1, vec![Rings { outer: star(center, [200.0, 150.0], 6), holes: vec![] }]) }
    };
    let features = vec![
        with(&[("natural", "wood"), ("leaf_type", "broadleaved")], [600.0, 600.0]),
        with(&[("landuse", "forest")], [1200.0, 600.0]),
        with(&[("natural", "water")], [1800.0, 600.0]),
        with(&[("landuse", "residential")], [2400.0, 600.0]),
    ];
    let layer = Layer { features, ..stands() };
    let choices = Choices { has_defaults: true, ..Choices::default() };
    let imported = made(&layer, &[], &choices).expect("an area");
    let names: Vec<&str> = imported.summary.stands.values().map(|stand| stand.name.as_str()).collect();
    assert_eq!(names, ["broad-leaved wood", "wood"]);
    assert_eq!(imported.summary.grounds.keys().collect::<Vec<_>>(), ["water"]);
    assert_eq!(imported.summary.dropped.len(), 1);
    // A row for what a column says goes before the defaults.
    let map = BTreeMap::from([("stand".to_string(), "landuse".to_string())]);
    let growth = Growth {
        species: "FAGSY".to_string(),
        form: None,
        height: farop::forest::area::Spread { mean: 20.0, deviation: 2.0 },
        crown: None,
        density: 300.0,
        crown_base: None,
        plant: farop::forest::area::Plant::Poisson,
        cover: None,
    };
    let rows = [Record { stand: "forest".to_string(), year: None, what: What::Grows(growth), origin: String::new() }];
    let imported = made(&layer, &rows, &Choices { map, ..choices }).expect("an area");
    assert_eq!(imported.summary.species, ["QUE", "FAGSY"]);
}
