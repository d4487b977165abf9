//! Reliefs of real tiles: readers, merging, georeferencing and the bound of the error, where the tiles are there.
//!
//! The tiles are in `../shared/data/terrain`, or where `FAROP_TERRAIN` says; without them every test passes with a notice. They are
//! public domain (USGS, NASA), the peaks (c) OpenStreetMap contributors, ODbL; `docs/terrain.md` has the list.

use farop::forest::elevation::{Grid, fill_voids, from_utm, merge, utm};
use farop::forest::relief::mesh::edge_uses;
use farop::forest::relief::{Hierarchy, mesh, quality};
use farop::parse::{GridOptions, load_grid};
use std::io::Read;
use std::path::PathBuf;

/// The file, if the tiles are there.
fn file(name: &str) -> Option<PathBuf> {
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data/terrain");
    let folder = std::env::var_os("FAROP_TERRAIN").map_or(beside, PathBuf::from);
    let path = folder.join(name);
    if path.exists() {
        return Some(path);
    }
    println!("notice: {name} is not there, nothing tested");
    None
}

fn tile(name: &str) -> Option<Grid> {
    let options = GridOptions { heights: (354.0, 3019.0), ..GridOptions::default() };
    Some(load_grid(&file(name)?, &options).unwrap_or_else(|error| panic!("{name}: {error}")))
}

fn dted(name: &str) -> Option<Grid> {
    tile(&format!("dted/{name}_3arc_v2.dt1.gz"))
}

/// The first 1025 x 1025 samples, without voids.
fn crop(mut grid: Grid) -> Grid {
    fill_voids(&mut grid, usize::MAX);
    grid.crop(0..1025, 0..1025).expect("it is larger")
}

#[test]
fn tiles_are_read_as_they_are_described() {
    let described = [
        ("hgt/N42E001.hgt.gz", (1201, 1201), (349.0, 3100.0), 7652, [1.0, 42.0, 2.0, 43.0]),
        ("hgt/N41E001.hgt.gz", (1201, 1201), (-20.0, 1204.0), 134, [1.0, 41.0, 2.0, 42.0]),
        ("hgt/N55W003.hgt.gz", (1201, 1201), (-22.0, 816.0), 0, [-3.0, 55.0, -2.0, 56.0]),
        ("dted/n19_w156_3arc_v2.dt1.gz", (1201, 1201), (-7.0, 4207.0), 0, [-156.0, 19.0, -155.0, 20.0]),
        ("dted/n18_w156_3arc_v2.dt1.gz", (1201, 1201), (0.0, 363.0), 0, [-156.0, 18.0, -155.0, 19.0]),
        ("dted/n20_w156_3arc_v2.dt1.gz", (1201, 1201), (-4.0, 1671.0), 0, [-156.0, 20.0, -155.0, 21.0]),
        ("dted/n19_w155_3arc_v2.dt1.gz", (1201, 1201), (-1.0, 512.0), 0, [-155.0, 19.0, -154.0, 20.0]),
        ("dted/n19_w157_3arc_v2.dt1.gz", (1201, 1201), (-12.0, 249.0), 0, [-157.0, 19.0, -156.0, 20.0]),
    ];
    for (name, size, range, voids, borders) in described {
        let Some(grid) = tile(name) else { return };
        assert_eq!(((grid.columns(), grid.rows()), grid.range(), grid.voids()), (size, Some(range), voids), "{name}");
        let off = grid.borders().iter().zip(borders).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12, "{name}: {:?}", grid.borders());
    }
    let Some(pyrenees) = tile("hgt/N42E001.hgt.gz") else { return };
    let at = |column, row| pyrenees.height(column, row);
    assert_eq!([at(478, 400), at(0, 0), at(1200, 0), at(0, 1200), at(600, 600)], [3100.0, 838.0, 360.0, 828.0, 1095.0]);
    let Some(hawaii) = dted("n19_w156") else { return };
    assert_eq!(hawaii.height(637, 212), 4207.0, "Mauna Kea");
    let Some(colorado) = tile("grid/SRTMGL3_colorado_145x.asc.gz") else { return };
    assert_eq!((colorado.columns(), colorado.rows(), colorado.height(1, 0)), (144, 144, 2586.0));
    let Some(hugo) = tile("grid/hugo_site_nodata.asc.gz") else { return };
    assert!(hugo.columns() == 76 && hugo.rows() == 55 && hugo.voids() > 500, "{}", hugo.voids());
    let Some(jacksboro) = tile("grid/jacksboro_fault_dem.asc.gz") else { return };
    assert_eq!((jacksboro.range(), jacksboro.voids()), (Some((236.0, 1076.0)), 0));
    let Some(gray) = tile("grid/N42E001_257_gray8.png") else { return };
    assert_eq!((gray.columns(), gray.rows(), gray.range()), (257, 257, Some((354.0, 3019.0))));
    // The picture is every 4th sample, to a 255th of its range.
    let step = (3019.0 - 354.0) / 255.0;
    let apart = (at(480, 400) - gray.height(120, 100)).abs();
    assert!(apart <= step, "{apart}");
}

#[test]
fn neighbors_share_their_rows_and_columns() {
    let (Some(north), Some(south)) = (tile("hgt/N42E001.hgt.gz"), tile("hgt/N41E001.hgt.gz")) else { return };
    let joint = merge(vec![south.clone(), north.clone()]).expect("neighbors");
    assert_eq!((joint.grid.columns(), joint.grid.rows(), joint.differing), (1201, 2401, 0));
    let same = |a: &[f32], b: &[f32]| a.iter().zip(b).all(|(a, b)| a == b || (a.is_nan() && b.is_nan()));
    assert!(same(joint.grid.row(1200), north.row(1200)) && same(joint.grid.row(1200), south.row(0)));
    assert!(same(joint.grid.row(1199), north.row(1199)) && same(joint.grid.row(1201), south.row(1)));

    let names = ["n19_w156", "n18_w156", "n20_w156", "n19_w155", "n19_w157"];
    let Some(cross) = names.iter().map(|name| dted(name)).collect::<Option<Vec<_>>>() else { return };
    let joint = merge(cross).expect("a cross");
    assert_eq!((joint.grid.columns(), joint.grid.rows()), (3601, 3601));
    assert_eq!((joint.shared, joint.differing, joint.resampled), (4 * 1201, 0, 0));
    assert_eq!(joint.grid.voids(), 3601 * 3601 - 5 * 1201 * 1201 + 4 * 1201, "the four corners are void");
}

#[test]
fn a_finer_tile_beside_a_coarser_one() {
    let Some(mut coarse) = tile("hgt/N42E001.hgt.gz") else { return };
    // A third of the resolution, from the southern tile's own samples.
    let Some(fine) = tile("hgt/N41E001.hgt.gz") else { return };
    fill_voids(&mut coarse, usize::MAX);
    let thinned: Vec<f32> = (0..=400)
        .flat_map(|row| (0..=400).map(move |column| (column, row)))
        .map(|(x, y)| coarse.height(3 * x, 3 * y))
        .collect();
    let mut frame = coarse.frame;
    frame.step = [1.0 / 400.0, 1.0 / 400.0];
    let thinned = Grid::new("thin", (401, 401), thinned, frame).expect("401 x 401");
    let joint = merge(vec![thinned.clone(), fine.clone()]).expect("neighbors");
    assert_eq!((joint.grid.columns(), joint.grid.rows(), joint.resampled), (1201, 2401, 1));
    assert!(joint.grid.row(1200) == fine.row(0), "the finer tile wins on the seam");
    assert_eq!(joint.grid.height(300, 600), thinned.height(100, 200), "samples stay where they are");
}

#[test]
fn peaks_are_highest_where_they_should_be() {
    let (Some(grid), Some(path)) = (tile("hgt/N42E001.hgt.gz"), file("vector/andorra_places.geojson.gz")) else {
        return;
    };
    let mut text = String::new();
    let bytes = std::fs::read(path).expect("it is there");
    flate2::read::GzDecoder::new(&bytes[..]).read_to_string(&mut text).expect("gzip");
    let places: serde_json::Value = serde_json::from_str(&text).expect("GeoJSON");
    let peaks: Vec<(f64, f64, f64)> = places["features"]
        .as_array()
        .expect("features")
        .iter()
        .filter(|place| place["properties"]["class"] == "peak")
        .filter_map(|place| {
            let height = place["properties"]["ele"].as_str()?.replace(',', ".").parse().ok()?;
            let at = &place["geometry"]["coordinates"];
            let (column, row) = grid.place(at[0].as_f64()?, at[1].as_f64()?);
            grid.sample(column, row).map(|_| (column, row, height))
        })
        .collect();
    assert!((88..=106).contains(&peaks.len()), "{} peaks", peaks.len());
    let rmse = |dx: f64, dy: f64| {
        let squares = peaks.iter().filter_map(|&(x, y, height)| Some((grid.sample(x + dx, y + dy)? - height).powi(2)));
        let (sum, count) = squares.fold((0.0, 0.0), |(sum, count), square| (sum + square, count + 1.0));
        f64::sqrt(sum / count)
    };
    let here = rmse(0.0, 0.0);
    assert!((here - 43.0).abs() < 1.0, "{here}");
    for (dx, dy) in [(0.5, 0.0), (-0.5, 0.0), (0.0, 0.5), (0.0, -0.5), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)]
    {
        let there = rmse(dx, dy);
        println!("RMSE to {} peaks at {dx}, {dy}: {there:.1} m; at zero {here:.1} m", peaks.len());
        assert!(there > here + 2.0, "{dx} {dy}: {there}, not above {here}");
    }
}

#[test]
fn utm_meets_the_control_points() {
    let Some(path) = file("check/utm_control.csv") else { return };
    let text = std::fs::read_to_string(path).expect("it is there");
    let mut points = 0;
    for line in text.lines().skip(1) {
        let fields: Vec<f64> = line.split(',').map(|field| field.trim().parse().expect("a number")).collect();
        let zone = fields[2] as u32 % 100;
        let place = utm(fields[0], fields[1], zone);
        assert_eq!(place.south, fields[2] as u32 / 100 == 327, "{line}");
        assert!((place.east - fields[3]).abs() < 6e-5 && (place.north - fields[4]).abs() < 6e-5, "{line}: {place:?}");
        let (longitude, latitude) = from_utm(&place);
        assert!((longitude - fields[0]).abs() < 1e-11 && (latitude - fields[1]).abs() < 1e-11, "{line}");
        points += 1;
    }
    assert_eq!(points, 17);
}

#[test]
fn voids_of_half_a_tile_stay_and_small_ones_go() {
    let Some(mut pyrenees) = tile("hgt/N42E001.hgt.gz") else { return };
    let filled = fill_voids(&mut pyrenees, 1405);
    assert_eq!((filled.samples, filled.left), (7652 - 1406, 1406), "the largest has 1406 samples");
    let filled = fill_voids(&mut pyrenees, 1406);
    assert_eq!((filled.samples, filled.voids, pyrenees.voids()), (1406, 1, 0));
    assert_eq!(pyrenees.range(), Some((349.0, 3100.0)), "no new peaks, no new pits");
    let Some(coast) = tile("hgt/N48W125.srtm1.hgt.gz") else { return };
    assert_eq!((coast.columns(), coast.voids()), (3601, 6_483_876));
    let mut part = coast.crop(1500..2100, 1500..2100).expect("inside");
    let left = fill_voids(&mut part, 1000).left;
    let hierarchy = Hierarchy::new(&part);
    let mesh = mesh::within(&hierarchy, 20.0);
    let found = quality(&part, &mesh);
    assert!(left > 1000 && found.largest <= 20.0 && found.samples > 50_000, "{left} {found:?}");
    // Only samples in the teeth of the coast lie under no triangle.
    assert!(found.uncovered < part.columns() * 4, "{found:?}");
}

#[test]
fn the_bound_holds_on_every_tile() {
    let (Some(pyrenees), Some(hawaii)) = (tile("hgt/N42E001.hgt.gz"), dted("n19_w156")) else { return };
    let Some(scotland) = tile("hgt/N55W003.hgt.gz") else { return };
    // At most so many triangles at 50 m.
    for (grid, most) in [(crop(pyrenees), 165_000), (crop(hawaii), 10_300), (scotland, 100_000)] {
        let hierarchy = Hierarchy::new(&grid);
        for error in [50.0, 200.0] {
            let mesh = mesh::within(&hierarchy, error);
            let found = quality(&grid, &mesh);
            println!("{}: {error} m: {found:?}", grid.name);
            assert!(found.largest <= error && found.triangles <= most && found.uncovered == 0, "{found:?}");
            let (east, south) = (grid.columns() as u32 - 1, grid.rows() as u32 - 1);
            for ((from, to), uses) in edge_uses(&mesh) {
                let [p, q] = [from, to].map(|index| mesh.vertices[index as usize].point);
                let along = (p.x == q.x && (p.x == 0 || p.x == east)) || (p.y == q.y && (p.y == 0 || p.y == south));
                assert_eq!(uses, if along { 1 } else { 2 }, "{p:?} {q:?}");
            }
        }
    }
}
