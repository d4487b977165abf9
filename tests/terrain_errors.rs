//! What `farop terrain` says about bad grids and bad options: every message is a snapshot, exit code 2, nothing left behind.

#[path = "support/command.rs"]
mod command;

use command::Desk;

/// A small DTED tile of 2 columns and 3 rows, level ground of 7 m.
fn dted() -> Vec<u8> {
    let mut bytes = b"UHL10010000E0420000N18001800NA  U              00020003 ".to_vec();
    bytes.resize(80 + 648 + 2700, b' ');
    for column in 0..2u8 {
        let mut record = vec![0xAA, 0, 0, column, 0, column, 0, 0, 0, 7, 0x80, 7, 0, 7];
        let sum: u32 = record.iter().map(|&byte| u32::from(byte)).sum();
        record.extend(sum.to_be_bytes());
        bytes.extend(record);
    }
    bytes
}

/// A gray or colored PNG.
fn png(color: image::ExtendedColorType, samples: &[u8]) -> Vec<u8> {
    use image::ImageEncoder;
    let mut bytes = Vec::new();
    image::codecs::png::PngEncoder::new(&mut bytes).write_image(samples, 2, 2, color).expect("2 x 2");
    bytes
}

const HEADER: &str = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9999\n";

fn desk() -> Desk {
    let desk = Desk::new();
    let asc = |name: &str, text: String| desk.write(&format!("{name}.asc"), text);
    asc("good", HEADER.to_string() + "1 2 3\n4 5 6\n");
    asc("few", HEADER.to_string() + "1 2 3\n4 5\n");
    asc("many", HEADER.to_string() + "1 2 3\n4 5 6\n7\n");
    asc("comma", HEADER.to_string() + "1 2,5 3\n4 5 6\n");
    asc("nan", HEADER.to_string() + "1 nan 3\n4 5 6\n");
    asc("nodata", HEADER.to_string() + "-9999 -9999 -9999\n-9999 -9999 -9999\n");
    asc("forgotten", HEADER.replace("NODATA_value -9999\n", "") + "1 2 3\n-3.4028235e+38 5 6\n");
    asc("unknown", HEADER.replace("cellsize", "cellsise") + "1 2 3\n4 5 6\n");
    asc("no_size", HEADER.replace("cellsize 10\n", "") + "1 2 3\n4 5 6\n");
    asc("zero", HEADER.replace("cellsize 10", "cellsize 0") + "1 2 3\n4 5 6\n");
    asc("huge", HEADER.replace("ncols 3", "ncols 100000000") + "1 2 3\n4 5 6\n");
    asc("line", HEADER.replace("nrows 2", "nrows 1") + "1 2 3\n");
    asc("twice", format!("ncols 3\n{HEADER}1 2 3\n4 5 6\n"));
    asc("far", HEADER.replace("xllcorner 0", "xllcorner 9e9") + "1 2 3\n4 5 6\n");
    asc("degrees", HEADER.replace("cellsize 10", "cellsize 0.01") + "1 2 3\n4 5 6\n");
    asc("empty", String::new());
    desk.write("N42E001.hgt", [0; 1000]);
    desk.write("N42X001.hgt", vec![0; 2 * 1201 * 1201]);
    desk.write("N00E000.hgt", [0x80, 0].repeat(1201 * 1201));
    desk.write("good.dt1", dted());
    desk.write("cut.dt1", &dted()[..dted().len() - 5]);
    desk.write("short.dt1", b"UHL1");
    let mut broken = dted();
    broken[3428 + 9] = 8;
    desk.write("broken.dt1", broken);
    let mut columns = dted();
    columns[47..51].copy_from_slice(b"00x2");
    desk.write("columns.dt1", columns);
    desk.write("gray.png", png(image::ExtendedColorType::L8, &[0, 50, 100, 255]));
    desk.write("color.png", png(image::ExtendedColorType::Rgb8, &[0; 12]));
    desk.write("cut.png", &png(image::ExtendedColorType::L8, &[0, 50, 100, 255])[..40]);
    desk.write("heights.txt", "1 2 3");
    desk.write("cut.asc.gz", [0x1F, 0x8B, 8, 0, 0]);
    desk
}

/// The messages of commands that must end with 2, print nothing on standard output and leave no file.
fn refusals(desk: &Desk, cases: &[&str]) -> String {
    let before = desk.entries();
    let mut messages = String::new();
    for arguments in cases {
        let outcome = desk.run(&format!("terrain {arguments}"));
        assert_eq!(outcome.code, 2, "{arguments}\n{}", outcome.stderr);
        assert!(outcome.stdout.is_empty() && !outcome.stderr.contains("panicked"), "{arguments}\n{}", outcome.stderr);
        assert_eq!(desk.entries(), before, "{arguments} left something behind");
        messages += &format!("### farop terrain {arguments}\n{}\n", outcome.stderr.replace("farop.exe", "farop"));
    }
    messages
}

#[test]
fn good_ones_are_read() {
    let desk = desk();
    for (file, extra) in
        [("good.asc", ""), ("good.dt1", "1 x 1"), ("gray.png", "--heights 100,355"), ("color.png", "--colored")]
    {
        let options = if extra.starts_with('-') { extra } else { "" };
        desk.done(&format!("terrain {file} {options}"));
    }
    let told = String::from_utf8(desk.done("terrain good.dt1").stdout).expect("text");
    assert!(told.contains("2 x 3 samples") && told.contains("-7 to 7 m"), "{told}");
    let told = String::from_utf8(desk.done("terrain gray.png --heights 100,355 --spacing 5").stdout).expect("text");
    assert!(told.contains("100 to 355 m") && told.contains("5.00 x 5.00"), "{told}");
}

#[test]
fn bad_grids() {
    let cases = [
        "missing.hgt",
        "heights.txt",
        "N42E001.hgt",
        "N42X001.hgt",
        "N00E000.hgt",
        "short.dt1",
        "cut.dt1",
        "broken.dt1",
        "columns.dt1",
        "color.png",
        "cut.png",
        "cut.asc.gz",
        "empty.asc",
        "few.asc",
        "many.asc",
        "comma.asc",
        "nan.asc",
        "nodata.asc",
        "forgotten.asc",
        "unknown.asc",
        "no_size.asc",
        "zero.asc",
        "huge.asc",
        "line.asc",
        "twice.asc",
        "good.asc far.asc",
        "good.asc degrees.asc",
        ".",
    ];
    insta::assert_snapshot!("terrain_bad_grids", refusals(&desk(), &cases.map(|case| case)));
}

#[test]
fn bad_options() {
    let cases = [
        "good.asc -o relief.doc",
        "good.asc -o nowhere/relief.nff",
        "good.asc --error -1",
        "good.asc --error 5 --triangles 10",
        "good.asc --triangles 1",
        "good.asc --criterion view --error 5",
        "good.asc --criterion view --tolerance 0",
        "good.asc --walk 1,2,3",
        "good.asc --open",
        "good.asc --spacing 0",
        "good.asc --from 1,2",
        "good.asc -r crayon -o a.png",
        "good.asc --from 5,5,5 --at 5,5,5 -o a.png",
    ];
    insta::assert_snapshot!("terrain_bad_options", refusals(&desk(), &cases));
}
