//! Files of others: what is in those beside the project, and what is said of broken ones. Shapefiles and GeoTIFF need the feature `gis`.

#[path = "support/command.rs"]
mod command;

use command::Desk;
use std::path::{Path, PathBuf};

/// A real file, or `None` and a notice where the data is not there.
fn real(name: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/terrain").join(name);
    let is_there = path.is_file();
    if !is_there {
        eprintln!("notice: {name} is not there; its counts are not checked");
    }
    is_there.then_some(path)
}

fn told(desk: &Desk, path: &Path) -> String {
    desk.done(&format!("forest {}", path.display())).text().to_string()
}

/// The figures are those of the data's own manifest.
#[test]
fn real_files_have_what_their_manifest_says() {
    let desk = Desk::new();
    let mut files = vec![
        ("vector/andorra_roads.geojson.gz", ["1613 objects", "lines 1613", "LineString 1613", "EPSG:4326"]),
        ("vector/andorra_waterways.geojson.gz", ["109 objects", "lines 109", "class (109)", "EPSG:4326"]),
        (
            "vector/andorra_landcover.geojson.gz",
            ["213 objects", "holes 11", "MultiPolygon 7, Polygon 206", "leaf (213)"],
        ),
        ("vector/andorra_places.geojson.gz", ["192 objects", "points 192", "Point 192", "ele (192)"]),
        ("trees/osu526_001.svs", ["181 trees", "181 with places", "Year=2011", "0 left out"]),
        ("trees/osu526_005.svs", ["128 trees", "128 with places", "Year=2031", "35 left out"]),
        ("trees/pnt01.tre", ["27 trees", "0 with places", "DF 8", "3 left out"]),
    ];
    if cfg!(feature = "gis") {
        files.push(("vector/andorra_roads.shp.zip", ["1613 objects", "lines 1613", "EPSG:4326", "40469 positions"]));
        files.push(("vector/andorra_landcover.shp.zip", ["213 objects", "holes 11", "EPSG:4326", "13461 positions"]));
    }
    for (name, parts) in files {
        let Some(path) = real(name) else { continue };
        let told = told(&desk, &path);
        for part in parts {
            assert!(told.contains(part), "{name}: no {part} in\n{told}");
        }
    }
}

#[test]
fn without_the_feature_it_is_said_how_to_get_it() {
    if cfg!(feature = "gis") {
        return;
    }
    let desk = Desk::new();
    desk.write("a.shp", "x");
    desk.write("a.tif", "x");
    for command in ["forest a.shp", "terrain a.tif"] {
        let outcome = desk.run(command);
        assert!(outcome.code == 2 && outcome.stderr.contains("--features gis"), "{}", outcome.stderr);
    }
}

/// 3 x 2 heights, one of them not measured, by hand: little-endian, one strip, keys for metres.
#[cfg(feature = "gis")]
fn tiff(model: u16, raster: u16) -> Vec<u8> {
    let mut bytes = b"II*\0\x08\0\0\0".to_vec();
    let data_at = 8 + 2 + 12 * 13 + 4;
    let scale_at = data_at + 12;
    let (tie_at, keys_at) = (scale_at + 24, scale_at + 24 + 48);
    let nodata_at = keys_at + 24;
    let entries: [(u16, u16, u32, u32); 13] = [
        (256, 3, 1, 3),
        (257, 3, 1, 2),
        (258, 3, 1, 16),
        (259, 3, 1, 1),
        (262, 3, 1, 1),
        (273, 4, 1, data_at),
        (277, 3, 1, 1),
        (278, 3, 1, 2),
        (279, 4, 1, 12),
        (339, 3, 1, 2),
        (33550, 12, 3, scale_at),
        (33922, 12, 6, tie_at),
        (34735, 3, 12, keys_at),
    ];
    bytes.extend(13_u16.to_le_bytes());
    for (tag, kind, count, value) in entries {
        bytes.extend(tag.to_le_bytes());
        bytes.extend(kind.to_le_bytes());
        bytes.extend(count.to_le_bytes());
        bytes.extend(value.to_le_bytes());
    }
    bytes.extend(0_u32.to_le_bytes());
    [100_i16, 110, 120, 130, 140, 150].iter().for_each(|height| bytes.extend(height.to_le_bytes()));
    [30.0_f64, 20.0, 0.0].iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    [0.0_f64, 0.0, 0.0, 500_000.0, 4_700_000.0, 0.0].iter().for_each(|number| bytes.extend(number.to_le_bytes()));
    [1, 1, 0, 2, 1024, 0, 1, model, 1025, 0, 1, raster].iter().for_each(|key: &u16| bytes.extend(key.to_le_bytes()));
    assert_eq!(bytes.len() as u32, nodata_at);
    bytes
}

#[cfg(feature = "gis")]
#[test]
fn a_geotiff_says_where_it_lies() {
    use farop::forest::elevation::{Frame, Unit};
    use farop::parse::{GridOptions, read_grid};
    let read = |bytes: &[u8]| read_grid(Path::new("a.tif"), bytes, &GridOptions::default());
    let area = read(&tiff(1, 1)).expect("a grid");
    let frame = Frame { unit: Unit::Metres, west: 500_015.0, north: 4_699_990.0, step: [30.0, 20.0] };
    assert_eq!((area.frame, area.columns(), area.rows()), (frame, 3, 2));
    assert_eq!(area.heights(), [100.0, 110.0, 120.0, 130.0, 140.0, 150.0]);
    let point = read(&tiff(1, 2)).expect("a grid").frame;
    assert_eq!((point.west, point.north), (500_000.0, 4_700_000.0));
    assert!(read(&tiff(3, 1)).is_err(), "a model that is neither");
    let whole = tiff(1, 1);
    for length in 0..whole.len() {
        let _ = read(&whole[..length]);
    }
    for place in 0..whole.len() {
        let mut broken = whole.clone();
        broken[place] ^= 0xFF;
        let _ = read(&broken);
    }
    let errors = read(&whole[..60]).expect_err("cut off").render(false);
    assert!(errors.contains("a.tif") && errors.contains("copied whole"), "{errors}");
}

#[cfg(feature = "gis")]
#[test]
fn the_real_geotiff_is_read() {
    use farop::parse::{GridOptions, load_grid};
    let Some(path) = real("grid/bigtujunga_srtm30m_utm11.tif.gz") else { return };
    let grid = load_grid(&path, &GridOptions::default()).expect("a grid");
    assert_eq!((grid.columns(), grid.rows()), (1197, 643));
}

#[cfg(feature = "gis")]
#[test]
fn broken_shapefiles_do_no_harm_and_are_told() {
    let Some(path) = real("vector/andorra_landcover.shp.zip") else { return };
    let whole = std::fs::read(path).expect("read");
    let desk = Desk::new();
    for length in [0, 10, whole.len() / 2, whole.len() - 30] {
        desk.write("cut.zip", &whole[..length]);
        let outcome = desk.run("forest cut.zip");
        assert!(outcome.code == 2 && outcome.stderr.contains("cut.zip"), "{length}: {}", outcome.stderr);
    }
    // In a file of its own without the two beside it.
    desk.write("alone.shp", b"nothing");
    let outcome = desk.run("forest alone.shp");
    assert!(outcome.code == 2 && outcome.stderr.contains(".prj"), "{}", outcome.stderr);
    desk.write("alone.prj", "PROJCS[\"NTF (Paris) / Lambert zone II\", GEOGCS[\"NTF\"]]");
    let outcome = desk.run("forest alone.shp");
    assert!(outcome.stderr.contains("`NTF (Paris) / Lambert zone II` is not known"), "{}", outcome.stderr);
    desk.write("alone.prj", "GEOGCS[\"WGS 84\"]");
    let outcome = desk.run("forest alone.shp");
    assert!(outcome.code == 2 && outcome.stderr.contains("no shapefile"), "{}", outcome.stderr);
}

#[test]
fn dted_with_a_wrong_checksum_names_the_column() {
    use farop::parse::{GridOptions, read_grid};
    // Two columns of two heights.
    let mut tile = b"UHL10010000E0420000N00300030".to_vec();
    tile.resize(47, b' ');
    tile.extend(b"00020002");
    tile.resize(80 + 648 + 2700, b' ');
    for column in 0..2_u8 {
        let mut record = vec![0xAA, 0, 0, column, 0, column, 0, 0, 0, 7, 0, 9];
        let sum: u32 = record.iter().map(|&byte| u32::from(byte)).sum();
        record.extend(sum.to_be_bytes());
        tile.extend(record);
    }
    let read = |tile: &[u8]| read_grid(Path::new("a.dt0"), tile, &GridOptions::default());
    assert!(read(&tile).is_ok());
    let last = tile.len() - 1;
    tile[last] ^= 1;
    let errors = read(&tile).expect_err("it is damaged").to_string();
    assert!(errors.contains("column 1: its bytes add up"), "{errors}");
}
