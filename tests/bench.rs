//! `farop bench` at the command line: what it prints, never how long anything took.

#[path = "support/command.rs"]
mod command;

use command::{Desk, TRIANGLE};
use serde_json::Value;

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("it is JSON")
}

#[test]
fn json_has_every_rasterizer_and_every_stage() {
    let desk = Desk::new();
    desk.write("a.nff", TRIANGLE);
    let outcome = desk.done("bench a.nff bench:fill_b2f --size 24x16 --rounds 2 --threads 1,2 --json");
    let document = json(outcome.text());
    let scenes = document["scenes"].as_array().expect("scenes");
    assert_eq!(scenes.len(), 2);
    assert_eq!(scenes[0]["file_bytes"], TRIANGLE.len());
    assert_eq!((&scenes[1]["triangles"], &scenes[1]["size"]), (&Value::from(32), &serde_json::json!([24, 16])));
    for scene in scenes {
        let rows = scene["rows"].as_array().expect("rows");
        let names: Vec<_> =
            rows.iter().map(|row| (row["rasterizer"].as_str().unwrap_or(""), &row["threads"])).collect();
        assert_eq!(names.len(), 8, "{names:?}");
        assert_eq!((names[0].0, names[1].0, names[2].0), ("zbuffer", "zbuffer", "fast"));
        for row in rows {
            assert_eq!(row["rounds"], 2);
            for stage in ["plan", "geometry", "raster", "levels", "write"] {
                let of = |time: &str| row["stages_ms"][stage]["elapsed"][time].as_f64().expect("a time");
                assert!(0.0 <= of("least") && of("least") <= of("low") && of("low") <= of("median"));
                assert!(of("median") <= of("high"));
            }
            // Watkins and the fast one draw the bytes of the z-buffer.
            if row["rasterizer"] != "scanline" {
                assert_eq!(row["differing_pixels"], 0, "{row}");
            }
        }
        // The z-buffer keeps 24 bytes a sample besides picture and list. The fast one needs none; its list has another form.
        let bytes = |index: usize| rows[index]["bytes_per_pixel"].as_f64().expect("a number");
        assert!(bytes(0) > bytes(2), "{} {}", bytes(0), bytes(2));
    }
}

#[test]
fn tables_fit_a_hundred_columns() {
    let desk = Desk::new();
    let outcome = desk.done("bench bench:flake:1k --size 16 --rounds 1 -r fast -r zbuffer -s phong");
    let lines: Vec<&str> = outcome.text().lines().collect();
    assert!(lines.iter().all(|line| line.chars().count() <= 100), "{}", outcome.text());
    assert!(lines[0].starts_with("bench:flake:1k: 16x16, phong"), "{}", lines[0]);
    assert!(lines[1].starts_with("962 triangles"), "{}", lines[1]);
    assert!(lines[3].starts_with("fast") && lines[4].starts_with("zbuffer"), "{}", outcome.text());
}

/// The words and names of scripts that measure other renderers with the same command.
#[test]
fn one_line_is_what_scripts_read() {
    let desk = Desk::new();
    desk.done("generate fill_f2b -o fill.ftri");
    let options = "--threads 2 --one-line --size 32x24 --mode phong --aa 2 --filter nearest --frames 3";
    let outcome = desk.done(&format!("bench fill.ftri {options}"));
    let text = outcome.text();
    assert_eq!(text.lines().count(), 1, "{text}");
    for part in
        ["farop-fast fill.ftri mode=phong size=32x24 aa=2 threads=2 tris=32", " min_ms=", " cpu_ms=", " median_ms="]
    {
        assert!(text.contains(part), "{part} is not in {text}");
    }
}

#[test]
fn scaling_tells_exponents() {
    let desk = Desk::new();
    let outcome = desk.done("bench --scaling=10k --size 16 --max-pixels 20000 --rounds 1 -r fast --json");
    let document = json(outcome.text());
    let curves = document["scenes"].as_array().expect("curves");
    let of: Vec<_> = curves.iter().map(|curve| curve["of"].as_str().unwrap_or("")).collect();
    assert_eq!(of, ["triangles", "pixels"]);
    assert_eq!(curves[0]["size_and_ms"][1][0], 10194.0);
    assert_eq!(
        curves[1]["size_and_ms"],
        serde_json::json!([[4096.0, curves[1]["size_and_ms"][0][1]], [16384.0, curves[1]["size_and_ms"][1][1]]])
    );
    assert!(curves.iter().all(|curve| curve["exponent"].is_f64()));
}

#[test]
fn a_generated_file_is_the_scene_of_that_name() {
    let desk = Desk::new();
    desk.done("generate flake:1k -o flake.ftri");
    let by_name = desk.made("render bench:flake:1k --size 32 --encoding linear", "a.png");
    assert_eq!(desk.made("render flake.ftri --size 32 --encoding linear -r fast", "b.png"), by_name);
    assert!(desk.done("plan flake.ftri").text().contains("specular"));
    desk.done("dump flake.ftri --size 16 -o flake.scr");
    assert!(desk.done("list scenes").text().contains("fill_b2f"));
}

#[test]
fn what_cannot_be_measured_is_told() {
    let desk = Desk::new();
    desk.write("a.ftri", "FTRI2");
    for (arguments, part) in [
        ("bench --one-line", "name one"),
        ("bench a.ftri", "byte 0"),
        ("bench bench:flake:9", "there is 10k"),
        ("bench bench:flak", "there is flake"),
        ("bench spd:tetra -r none", "draws nothing"),
        ("bench spd:tetra -r nobody", "there is no rasterizer"),
        ("bench spd:tetra --threads 0", "0 is not in 1..=1024"),
        ("bench spd:tetra --scaling", "its own scenes"),
        ("bench spd:tetra --json --one-line", "cannot be used with"),
        ("generate flake:1k -o a.nff", "does not end in `.ftri`"),
        ("generate flake --size 4 -o b.ftri", "behind its name"),
        ("generate flake:3 -o b.ftri", "there is 10k"),
    ] {
        let outcome = desk.run(arguments);
        assert_eq!(outcome.code, 2, "{arguments}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(part), "{arguments}: {}", outcome.stderr);
        assert!(outcome.stdout.is_empty() && !desk.entries().contains(&"b.ftri".to_string()));
    }
}
