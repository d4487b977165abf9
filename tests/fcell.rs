//! Areas of forest: text and pack give back what was written, broken packs lose only what is broken, and a small area is a scene.

use farop::forest::area::{
    Area, Cell, Cover, Form, Ground, Head, Line, Mark, MeasuredTree, Owner, Patch, Plant, Species, Spread, Stand,
    StandState,
};
use farop::forest::cells::Cells;
use farop::forest::pack::{self, Pack, PackError};
use farop::forest::tree;
use farop::math::Vec3;
use farop::parse::{Format, ParseOptions, load, load_cells, read_fcell};
use farop::scene::Place;
use farop::write::write_fcell;
use std::path::{Path, PathBuf};

/// Numbers that look like chance.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 32
    }

    fn below(&mut self, count: usize) -> usize {
        self.bits() as usize % count
    }

    fn once_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() as f64 / f64::from(u32::MAX))
    }

    fn position(&mut self, side: f64) -> [f64; 2] {
        let mut metres = || if self.once_in(8) { [0.0, side][self.below(2)] } else { self.between(0.0, side) };
        [metres(), metres()]
    }
}

fn area(random: &mut Random) -> Area {
    let side = [240.0, 100.5, 30.0][random.below(3)];
    let place = Place::default();
    let head = Head {
        objects: Vec::new(),
        files: vec!["area.fcell".to_string()],
        crs: ["", "EPSG:32629", "a map of ours"][random.below(3)].to_string(),
        origin: [random.between(-1e6, 1e6), random.between(0.0, 1e7)],
        side,
        seed: random.bits() << 32 | random.bits(),
        species: (0..1 + random.below(3))
            .map(|index| Species {
                code: format!("SP{index}"),
                form: Form::ALL[random.below(5)].1,
                images: (0..random.below(3)).map(|image| format!("tree {index} {image}.png")).collect(),
                place,
            })
            .collect(),
        covers: (0..1 + random.below(4))
            .map(|index| Cover {
                number: 7 + 3 * index as u32,
                image: "paint:grass".to_string(),
                tile: random.between(1.0, 50.0),
                place,
            })
            .collect(),
        marks: vec![Mark { name: "Foia \u{e9}".to_string(), at: [random.between(-1e4, 1e4), 3.0], place }],
    };
    let mut area = Area { head, cells: Default::default() };
    for _ in 0..1 + random.below(5) {
        let index = [random.below(7) as i32 - 3, random.below(5) as i32 - 2];
        let cell = cell(&area.head, index, random);
        area.cells.insert(index, cell);
    }
    area
}

fn cell(head: &Head, index: [i32; 2], random: &mut Random) -> Cell {
    let place = Place { file: 0, line: 1 + random.below(100) as u32 };
    let cover = |random: &mut Random| random.below(head.covers.len()) as u8;
    let species = |random: &mut Random| random.below(head.species.len()) as u16;
    let some_cover = |random: &mut Random| if random.once_in(2) { Some(cover(random)) } else { None };
    let stands: Vec<Stand> = (0..random.below(4))
        .map(|number| {
            let years: Vec<Option<i32>> =
                [vec![None], vec![Some(2011)], vec![Some(-5), Some(2018), Some(2026)]][random.below(3)].clone();
            let spread =
                |random: &mut Random| Spread { mean: random.between(1.0, 30.0), deviation: random.between(0.0, 3.0) };
            let states = years.into_iter().map(|year| StandState {
                year,
                species: species(random),
                height: spread(random),
                crown: spread(random),
                density: random.between(0.0, 2000.0),
                crown_base: random.once_in(2).then(|| random.between(0.0, 0.9)),
                plant: Plant::ALL[random.below(3)].1,
                picture: random.once_in(2).then(|| random.below(256) as u8),
                cover: some_cover(random),
            });
            Stand { number: 10 + number as u32, states: states.collect(), place }
        })
        .collect();
    let owner = |random: &mut Random| match random.below(1 + stands.len()) {
        0 => Owner::Cover(cover(random)),
        stand => Owner::Stand(stand as u32 - 1),
    };
    let square = |x: f64, y: f64, size: f64| vec![[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
    let patches = (0..random.below(4)).map(|_| {
        let size = random.between(0.2, 0.5) * head.side;
        let at = [random.between(0.0, head.side - size), random.between(0.0, head.side - size)];
        let mut hole = square(at[0] + size / 4.0, at[1] + size / 3.0, size / 3.0);
        hole[1..].reverse();
        let holes = if random.once_in(2) { vec![hole] } else { Vec::new() };
        Patch { owner: owner(random), outer: square(at[0], at[1], size), holes, place }
    });
    let patches: Vec<Patch> = patches.collect();
    Cell {
        index,
        seed: random.bits(),
        cover: some_cover(random),
        ground: ground(head, random),
        patches,
        trees: (0..random.below(3))
            .map(|_| MeasuredTree {
                species: species(random),
                at: random.position(head.side),
                height: random.between(1.0, 40.0),
                crown: random.between(1.0, 9.0),
                turn: random.between(-360.0, 360.0),
                place,
            })
            .collect(),
        lines: (0..random.below(3))
            .map(|_| Line {
                kind: ["road", "river"][random.below(2)].to_string(),
                width: random.between(1.0, 9.0),
                points: (0..2 + random.below(4)).map(|_| random.position(head.side)).collect(),
                place,
            })
            .collect(),
        stands,
        place,
    }
}

fn ground(head: &Head, random: &mut Random) -> Ground {
    if random.once_in(3) {
        let corner =
            |x: f64, y: f64, random: &mut Random| Vec3::new(x * head.side, y * head.side, random.between(-9.0, 2000.0));
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        let vertices = corners.map(|(x, y)| corner(x, y, random)).to_vec();
        let cover = random.once_in(2).then_some(0);
        return Ground::Mesh { vertices, triangles: vec![([0, 1, 2], cover), ([0, 2, 3], None)] };
    }
    let size = [2 + random.below(8) as u16, 2 + random.below(8) as u16];
    let count = usize::from(size[0]) * usize::from(size[1]);
    let height = |random: &mut Random| if random.once_in(20) { Ground::VOID } else { random.bits() as u16 as i16 / 2 };
    let (base, step) = (random.between(-100.0, 3000.0), random.between(0.01, 1.0));
    Ground::Lattice { size, base, step, counts: (0..count).map(|_| height(random)).collect() }
}

/// Without where it was declared, which a text says in its own way.
fn placeless(mut area: Area) -> Area {
    let nowhere = Place::default();
    area.head.files.clear();
    area.head.marks.iter_mut().for_each(|mark| mark.place = nowhere);
    area.head.species.iter_mut().for_each(|species| species.place = nowhere);
    area.head.covers.iter_mut().for_each(|cover| cover.place = nowhere);
    for cell in area.cells.values_mut() {
        cell.place = nowhere;
        cell.stands.iter_mut().for_each(|stand| stand.place = nowhere);
        cell.patches.iter_mut().for_each(|patch| patch.place = nowhere);
        cell.trees.iter_mut().for_each(|tree| tree.place = nowhere);
        cell.lines.iter_mut().for_each(|line| line.place = nowhere);
    }
    area
}

fn text_of(area: &Area) -> Vec<u8> {
    let mut text = Vec::new();
    write_fcell(&Cells::Loaded(area.clone()), &mut text).expect("an area that can be written");
    text
}

fn all_cells(pack: &Pack) -> Area {
    let load = |index| (index, pack.load(index).expect("whole").expect("it is in the index"));
    Area { head: pack.head().clone(), cells: pack.indices().into_iter().map(load).collect() }
}

fn packed(area: &Area, path: &Path) -> Pack {
    pack::write(&area.head, area.cells.values().rev().cloned(), path).expect("can be packed");
    Pack::open(path).expect("whole")
}

#[test]
fn text_gives_back_what_was_written() {
    for seed in 0..300 {
        let area = area(&mut Random(seed));
        let text = text_of(&area);
        let read = read_fcell("area.fcell", &text);
        let (read, _) =
            read.unwrap_or_else(|errors| panic!("seed {seed}: {errors}\n{}", String::from_utf8_lossy(&text)));
        assert_eq!(placeless(read), placeless(area), "seed {seed}");
    }
}

#[test]
fn packs_lose_millimetres_once_and_nothing_after_that() {
    let folder = tempfile::tempdir().expect("a folder");
    for seed in 0..100 {
        let area = area(&mut Random(seed));
        let [first, second] = ["a.fpack", "b.fpack"].map(|name| folder.path().join(name));
        let once = all_cells(&packed(&area, &first));
        let twice = all_cells(&packed(&once, &second));
        assert_eq!(once, twice, "seed {seed}");
        assert_eq!(std::fs::read(&first).expect("there"), std::fs::read(&second).expect("there"), "seed {seed}");
        assert_eq!((&once.head, once.cells.len()), (&area.head, area.cells.len()));
        let step = area.head.side / 65_535.0;
        for (cell, original) in once.cells.values().zip(area.cells.values()) {
            assert_eq!((cell.seed, cell.cover, cell.place), (original.seed, original.cover, original.place));
            for (patch, before) in cell.patches.iter().zip(&original.patches) {
                assert_eq!((patch.owner, patch.outer.len()), (before.owner, before.outer.len()));
                let pairs = patch.outer.iter().flatten().zip(before.outer.iter().flatten());
                pairs.for_each(|(after, before)| assert!((after - before).abs() <= 0.5001 * step));
            }
            for (tree, before) in cell.trees.iter().zip(&original.trees) {
                assert_eq!(
                    tree.at.map(|at| at == area.head.side),
                    before.at.map(|at| at == area.head.side),
                    "borders stay"
                );
                assert!((tree.height - before.height).abs() < 1e-5);
            }
            if let Ground::Lattice { .. } = cell.ground {
                assert_eq!(cell.ground, original.ground, "heights are kept to the bit");
            }
        }
    }
}

#[test]
fn cells_lie_in_any_order_and_twice_is_an_error() {
    let area = area(&mut Random(3));
    let folder = tempfile::tempdir().expect("a folder");
    let [first, second] = ["a.fpack", "b.fpack"].map(|name| folder.path().join(name));
    pack::write(&area.head, area.cells.values().cloned(), &first).expect("can be packed");
    pack::write(&area.head, area.cells.values().rev().cloned(), &second).expect("can be packed");
    assert_eq!(std::fs::read(&first).expect("there"), std::fs::read(&second).expect("there"));
    let cells = || area.cells.values().chain(area.cells.values()).cloned();
    let error = pack::write(&area.head, cells(), &folder.path().join("c.fpack")).expect_err("twice");
    assert!(error.to_string().contains("comes twice"), "{error}");
    assert!(!folder.path().join("c.fpack").exists(), "a file appears only whole");
    assert_eq!(std::fs::read_dir(folder.path()).expect("there").count(), 2, "nothing is left beside");
    let far =
        area.cells.values().flat_map(|cell| [cell.clone(), Cell { index: [2_000_000_000, 9], ..cell.clone() }]).take(2);
    let error = pack::write(&area.head, far, &second).expect_err("too far apart");
    assert!(error.to_string().contains("make several packs"), "{error}");
    assert_eq!(
        std::fs::read(&first).expect("there"),
        std::fs::read(&second).expect("there"),
        "the old one is left as it was"
    );
}

/// Every cell that can be loaded; messages are put into words.
fn loadable(path: &Path) -> Option<usize> {
    let pack = match Pack::open(path) {
        Ok(pack) => pack,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return None;
        }
    };
    let loaded = |index: &[i32; 2]| match pack.load(*index) {
        Ok(cell) => cell.is_some(),
        Err(error) => {
            assert!(matches!(error, PackError::Cell { .. }), "{error}");
            false
        }
    };
    Some(pack.indices().iter().filter(|index| loaded(index)).count())
}

#[test]
fn mutilated_packs_are_told_and_lose_only_what_is_broken() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("whole.fpack");
    let area = (0..).map(|seed| area(&mut Random(seed))).find(|area| area.cells.len() > 3).expect("some are large");
    packed(&area, &path);
    let whole = std::fs::read(&path).expect("there");
    let (count, broken) = (area.cells.len(), folder.path().join("broken.fpack"));
    assert_eq!(loadable(&path), Some(count));
    let mut random = Random(11);
    let (mut opened, mut one_lost) = (0, 0);
    for round in 0..2000 {
        let mut bytes = whole.clone();
        match round % 4 {
            0 => bytes.truncate(random.below(whole.len())),
            1 => drop(bytes.splice(
                random.below(whole.len())..,
                (0..random.below(99)).map(|_| random.bits() as u8).collect::<Vec<_>>(),
            )),
            2 => {
                let at = random.below(whole.len());
                bytes[at] ^= 1 << random.below(8);
            }
            // Lengths and counts that cannot be.
            _ => {
                let at = random.below(whole.len() - 4);
                bytes[at..at + 4].copy_from_slice(&[0xFF, 0xFF, 0xFF, 0x7F]);
            }
        }
        std::fs::write(&broken, &bytes).expect("a folder of ours");
        if let Some(left) = loadable(&broken) {
            opened += 1;
            // One byte is in one cell, or in one entry of the index.
            if round % 4 == 2 && bytes[20..36] == whole[20..36] {
                assert!(left + 1 >= count, "round {round}: {left} of {count} cells are left");
                one_lost += usize::from(left + 1 == count);
            }
        }
    }
    assert!(opened > 500 && one_lost > 100, "{opened} opened, {one_lost} lost one cell");
    for (bytes, expected) in [
        (&b""[..], "is no pack"),
        (&b"FPACK\n"[..], "is no pack"),
        (&whole[..30], "cut off after 30 bytes"),
        (&whole[..60], "cut off"),
        (&[&whole[..8], &[2, 0, 0, 0], &whole[12..]].concat(), "version 2"),
    ] {
        std::fs::write(&broken, bytes).expect("a folder of ours");
        let error = Pack::open(&broken).expect_err(expected).to_string();
        assert!(error.contains(expected) && error.contains("broken.fpack"), "{error}");
    }
}

/// The checksum of a pack, by its definition.
fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xEDB8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0_u32, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

#[test]
fn unknown_chunks_are_skipped() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.fpack");
    let mut area = area(&mut Random(5));
    area.cells = area.cells.into_iter().take(1).collect();
    let before = all_cells(&packed(&area, &path));
    let mut bytes = std::fs::read(&path).expect("there");
    // One cell: its entry ends the index, its bytes end the file.
    let number = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]) as usize;
    let entry = 40 + number(12);
    let (offset, length) = (number(entry), number(entry + 8));
    assert_eq!((offset + length, crc32(&bytes[offset..])), (bytes.len(), number(entry + 12) as u32));
    bytes.extend(b"SOIL\x03\0\0\0abc");
    let (length, crc) = ((length + 11) as u32, crc32(&bytes[offset..]));
    bytes[entry + 8..entry + 12].copy_from_slice(&length.to_le_bytes());
    bytes[entry + 12..entry + 16].copy_from_slice(&crc.to_le_bytes());
    std::fs::write(&path, bytes).expect("a folder of ours");
    assert_eq!(all_cells(&Pack::open(&path).expect("whole")), before);
}

fn teaching_area() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes/forest.fcell")
}

#[test]
fn a_cell_of_nine_by_nine_heights_is_small() {
    let folder = tempfile::tempdir().expect("a folder");
    let (cells, notices) = load_cells(&teaching_area()).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(notices.is_empty(), "{notices}");
    let Cells::Loaded(area) = cells else { panic!("text is loaded whole") };
    let pack = packed(&area, &folder.path().join("forest.fpack"));
    for index in pack.indices() {
        println!("cell {} {}: {} bytes", index[0], index[1], pack.bytes_of(index));
        assert!(pack.bytes_of(index) < 1024);
    }
}

#[test]
fn text_and_pack_of_the_teaching_area_are_one_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("forest.fpack");
    let (cells, _) = load_cells(&teaching_area()).unwrap_or_else(|errors| panic!("{errors}"));
    let Cells::Loaded(area) = cells else { panic!("text is loaded whole") };
    // Positions of the teaching area are no 65,535ths: rounded once, the area is the same in both.
    let rounded = all_cells(&packed(&area, &path));
    let mut text = Vec::new();
    write_fcell(&Cells::Loaded(rounded), &mut text).expect("written");
    let file = folder.path().join("forest.fcell");
    std::fs::write(&file, text).expect("a folder of ours");
    let [mut from_text, mut from_pack] = [&file, &path]
        .map(|path| load(path, None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}")).into_scene());
    for scene in [&mut from_text, &mut from_pack] {
        scene.files.clear();
        scene.objects.iter_mut().for_each(|object| object.place = Place::default());
        for surface in &mut scene.surfaces {
            surface.place = Place::default();
            surface.mesh.polygons.iter_mut().for_each(|polygon| polygon.line = 0);
        }
    }
    assert_eq!(from_text.objects.len(), from_pack.objects.len());
    assert!(from_text == from_pack, "the scenes differ");
}

#[test]
fn the_scene_of_an_area_is_a_tree() {
    let parsed = load(&teaching_area(), None, ParseOptions::default()).unwrap_or_else(|errors| panic!("{errors}"));
    let told = parsed.notices.list.iter().map(|notice| notice.message.clone()).collect::<Vec<_>>();
    assert!(told.len() == 1 && told[0].contains("trees in 4 cells"), "{told:?}");
    let scene = &parsed.scene;
    let names =
        |ids: &[farop::scene::ObjectId]| ids.iter().map(|&id| scene.object(id).name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&scene.world), ["area"]);
    let area = scene.object(scene.world[0]);
    assert_eq!(names(&area.children), ["cell 0 0", "cell 0 1", "cell 1 0", "cell 1 1", "Picota"]);
    let mark = scene.object(area.children[4]);
    let foot = mark.parent_from_local.translation;
    assert!(mark.surfaces.is_empty() && foot.x == 130.0 && foot.y == 350.0 && foot.z > 440.0, "{foot}");
    let cell = scene.object(area.children[0]);
    assert_eq!(names(&cell.children), ["road", "stand 12", "measured trees"]);
    let oak = scene.object(scene.object(cell.children[2]).children[0]);
    assert_eq!(oak.name, "QUESU");
    assert_eq!(oak.parent_from_local.matrix3.z_axis.z, 16.0);
    // Trees that wear one picture share one surface.
    assert!(
        scene.surfaces.len() < 60 && scene.objects.len() > 1000,
        "{} {}",
        scene.surfaces.len(),
        scene.objects.len()
    );
    // Neighbors meet: where two cells share a border, the ground has the same heights.
    assert!(parsed.default_camera.is_some() && scene.camera.is_none());
}

#[test]
fn large_areas_are_refused_with_what_to_do() {
    let flat = |cells: usize, density: u32| {
        let mut text = format!("fcell 1\nspecies A\nstand 1 species A h 9 crown 4 dens {density}\n");
        for index in 0..cells {
            text += &format!("cell {index} 0\ndem 2 2 0 0 0 0\npoly 1 stand 1 outer 4 0 0 240 0 240 240 0 240\n");
        }
        read_fcell("large", (text + "end").as_bytes()).expect("legal").0
    };
    let refused = |area: Area| {
        tree::scene(&Cells::Loaded(area), (Path::new(""), &std::collections::BTreeMap::new()), None)
            .expect_err("too large")
            .to_string()
    };
    let trees = refused(flat(6, 20_000));
    assert!(trees.contains("500000") && trees.contains("farop forest"), "{trees}");
    let cells = refused(flat(2001, 0));
    assert!(cells.contains("2001 cells") && cells.contains("farop forest"), "{cells}");
}

#[test]
fn heights_come_out_of_grids_by_position() {
    let folder = tempfile::tempdir().expect("a folder");
    let grid =
        "ncols 3\nnrows 3\nxllcenter 1000\nyllcenter 2000\ncellsize 240\nNODATA_value -9999\n1 2 3\n4 5 6\n7 8 -9999\n";
    std::fs::write(folder.path().join("g.asc"), grid).expect("a folder of ours");
    let read = |head: &str, cells: &str| {
        let path = folder.path().join("a.fcell");
        std::fs::write(&path, format!("fcell 1\n{head}\n{cells}end\n")).expect("a folder of ours");
        load_cells(&path).map(|(cells, _)| cells)
    };
    let two =
        "cell 0 0\ndemref g.asc lattice 3 3\ncell 0 1\ndemref g.asc lattice 3 2\ncell 1 0\ndemref g.asc lattice 2 2\n";
    let cells = read("origin 1000 2000", two).unwrap_or_else(|errors| panic!("{errors}"));
    let ground = |index| cells.load(index).expect("in memory").expect("there").ground;
    let south_west = ground([0, 0]);
    assert_eq!([0, 1, 2].map(|column| south_west.sample(column, 0)), [4.0, 4.5, 5.0]);
    assert_eq!(south_west.sample(0, 2), 7.0);
    assert_eq!([ground([0, 1]).sample(2, 0), ground([0, 1]).sample(2, 1)], [2.0, 5.0]);
    let with_void = ground([1, 0]);
    assert!(with_void.sample(1, 1).is_nan() && with_void.sample(0, 1) == 8.0);
    let said = |head: &str| read(head, "cell 0 0\ndemref g.asc\n").expect_err("outside").to_string();
    assert!(said("origin 90000 2000").contains("has no height in cell 0 0"));
    std::fs::write(
        folder.path().join("g.asc"),
        grid.replace("1000", "8").replace("2000", "37").replace("240", "0.001"),
    )
    .expect("ours");
    assert!(said("origin 1000 2000").contains("counts degrees"));
    assert!(said("crs EPSG:3763").contains("is no UTM"));
    // 8.0005 E 37.0005 N, in zone 32.
    let there = farop::forest::elevation::utm(8.0001, 37.0001, 32);
    let cells = read(
        &format!("crs EPSG:32632\norigin {} {}\nside 60", there.east, there.north),
        "cell 0 0\ndemref g.asc lattice 2 2\n",
    );
    let cells = cells.unwrap_or_else(|errors| panic!("{errors}"));
    let height = cells.load([0, 0]).expect("in memory").expect("there").ground.sample(0, 1);
    assert!((height - (7.0 + 0.1 - 0.3)).abs() < 0.04, "{height}");
}

#[test]
fn endings_and_gzip() {
    assert_eq!(Format::of_path(Path::new("a.fcell.gz")), Some(Format::Fcell));
    assert_eq!(Format::of_path(Path::new("a.FPACK")), Some(Format::Fpack));
}
