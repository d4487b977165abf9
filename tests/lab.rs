//! The lab: fronts and metrics by hand, tables that repeat themselves, promises that are kept or refused.

#[path = "support/command.rs"]
mod command;

use command::{Desk, project_scene};
use farop::image::{Picture, flip::flip, ssim::ssim};
use farop::lab::check::Random;
use farop::lab::configurations::{Configuration, Spread, configurations};
use farop::lab::measure::Effort;
use farop::lab::pareto::{Extent, Point, Standing, front, hypervolume, standings};
use farop::lab::promise::{Goal, keep};
use farop::lab::truth::{Source, Truth};
use farop::lab::{Row, run};
use farop::oracle::ray::trace;
use farop::parse::{ParseOptions, read_nff};
use farop::plan::{Choices, Shading};
use farop::raster::{Rasterizer, Registry, ZBuffer};
use farop::render::render;
use farop::scene::{Scene, Shape};
use std::time::Duration;

fn project(name: &str) -> Scene {
    let text = std::fs::read(project_scene(name)).expect("a scene of the project");
    read_nff(name, &text, ParseOptions::default()).expect("a legal scene").scene
}

fn small(side: u32) -> Choices {
    Choices { size: Some((side, side)), threads: Some(1), ..Choices::default() }
}

#[test]
fn the_front_by_hand() {
    let point = |time: f64, spread: f64, error: f64| Point { time, spread, error };
    let points = [
        point(10.0, 0.5, 4.0),
        // Faster and worse; slower and better.
        point(5.0, 0.1, 9.0),
        point(30.0, 1.0, 1.0),
        // Beaten by the first by more than both spreads; by less.
        point(12.0, 0.5, 4.5),
        point(10.8, 0.5, 4.5),
        // As the first, in time and error: the first stands for both.
        point(10.0, 0.5, 4.0),
        // Nothing is known of its error.
        point(1.0, 0.1, f64::INFINITY),
    ];
    let [f, t, d] = [Standing::Front, Standing::Tied, Standing::Dominated];
    assert_eq!(standings(&points), [f, f, f, d, t, t, d]);
    assert_eq!(front(&points), [1, 0, 2]);
    // An error of 0 is beaten by nobody, and beats all that are slower.
    assert_eq!(standings(&[point(2.0, 0.0, 0.0), point(3.0, 0.0, 0.0), point(3.0, 0.0, 1.0)]), [f, d, d]);
}

#[test]
fn the_hypervolume_is_what_counting_cells_finds() {
    const CELLS: u32 = 256;
    let mut random = Random::new(3);
    for round in 0..20 {
        let mut random_point = || {
            let (time, error) = (random.between(0.0, 6.0).exp(), random.between(-4.0, 5.0).exp());
            Point { time, spread: 0.0, error: if random.once_in(9) { 0.0 } else { error } }
        };
        let all: Vec<Point> = (0..12).map(|_| random_point()).collect();
        let extent = Extent::of(&all).expect("times and errors differ");
        let ((fast, right), (slow, wrong)) = (extent.ideal, extent.reference);
        // Logarithmic like the chart; whoever has no logarithm is at its lower end.
        let at = |cell: u32, low: f64, high: f64| low * (high / low).powf((f64::from(cell) + 0.5) / f64::from(CELLS));
        for points in [&all[..], &all[..4], &all[4..5], &[]] {
            let dominated = |across: u32, up: u32| {
                let (time, error) = (at(across, fast, slow), at(up, right, wrong));
                points.iter().any(|point| point.time <= time && point.error <= error)
            };
            let cells: u32 =
                (0..CELLS).flat_map(|x| (0..CELLS).map(move |y| (x, y))).map(|(x, y)| u32::from(dominated(x, y))).sum();
            let counted = f64::from(cells) / f64::from(CELLS * CELLS);
            let found = hypervolume(points, &extent);
            assert!((found - counted).abs() < 4.0 / f64::from(CELLS), "round {round}: {found}, counted {counted}");
        }
    }
}

#[test]
fn the_hypervolume_by_hand() {
    let point = |time: f64, error: f64| Point { time, spread: 0.0, error };
    let points = [point(1.0, 100.0), point(10.0, 10.0), point(100.0, 1.0), point(20.0, f64::INFINITY)];
    let extent = Extent::of(&points).expect("times and errors differ");
    assert_eq!(extent, Extent { ideal: (1.0, 1.0), reference: (100.0, 100.0) });
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
    // The middle one rules a quarter; the ends lie on the border.
    close(hypervolume(&points, &extent), 0.25);
    close(hypervolume(&[point(1.0, 10.0)], &extent), 0.5);
    close(hypervolume(&[point(0.5, 0.5)], &extent), 1.0);
    close(hypervolume(&points[3..], &extent), 0.0);
    // 0 counts as a tenth of the least positive error; without a difference there is no box.
    assert_eq!(Extent::of(&[point(1.0, 0.0), point(2.0, 5.0)]).expect("they differ").ideal, (1.0, 0.5));
    assert_eq!(Extent::of(&[point(1.0, 3.0), point(2.0, 3.0)]), None);
    assert_eq!(Extent::of(&[]), None);
}

#[test]
fn metrics_against_hand_computed_values() {
    let (black, white) = (Picture::filled(16, 16, [0; 3]), Picture::filled(16, 16, [255; 3]));
    assert!((flip(&black, &white)[0] - 0.967_38).abs() < 1e-5);
    let expected = 6.5025 / (255.0 * 255.0 + 6.5025);
    assert!((ssim(&black, &white) - expected).abs() < 1e-9);
}

/// All rows of `scene` at `side` pixels, timed as little as can be.
fn rows(scene: &Scene, side: u32, spread: Spread) -> Vec<Row> {
    let registry = Registry::built_in();
    let rasterizers: Vec<(&str, &dyn Rasterizer)> = registry
        .iter()
        .filter(|entry| entry.name != "wire")
        .map(|entry| (entry.name.as_str(), &*entry.rasterizer as &dyn Rasterizer))
        .collect();
    let base = small(side);
    let list = configurations(scene, &base, &rasterizers, spread).expect("a usable view");
    let with = |of: Configuration| {
        let found = rasterizers.iter().find(|entry| entry.0 == of.rasterizer).expect("it was given").1;
        (of, found)
    };
    let list: Vec<_> = list.into_iter().map(with).collect();
    let truth = Truth::new(scene, &base, None).expect("a usable view");
    let effort = Effort { rounds: 1, budget: Duration::ZERO, seed: 1 };
    run(scene, (&base, &truth), &list, (&effort, &|_, _, _| ())).expect("all make plans")
}

fn row<'a>(rows: &'a [Row], name: &str) -> &'a Row {
    rows.iter().find(|row| row.configuration.name == name).unwrap_or_else(|| {
        panic!("{name} is not among {:?}", rows.iter().map(|row| &row.configuration.name).collect::<Vec<_>>())
    })
}

#[test]
fn errors_are_those_of_the_last_run_and_fall_with_the_work() {
    let scene = project("highlight.nff");
    let first = rows(&scene, 32, Spread::Sensible);
    let again = rows(&scene, 32, Spread::Sensible);
    assert!(first.iter().zip(&again).all(|(a, b)| a.errors == b.errors && a.configuration == b.configuration));
    let rms = |name: &str| row(&first, name).errors.rms_levels;
    assert!(rms("phong A4 tol 0.0625") < rms("gouraud A1 tol 0.25"));
    assert!(rms("gouraud A1 tol 0.25") < rms("flat A1 tol 4"));
    assert!(rms("phong A4 tol 0.25") < rms("phong A1 tol 0.25"));
    let outline = |name: &str| row(&first, name).errors.silhouette_px.expect("a sphere has an equation");
    assert!(outline("gouraud A1 tol 0.25") <= 0.26 && outline("gouraud A1 tol 4") > 0.5);
    // Fewer sub-pixel bits get more edge pixels wrong, and watkins draws what the z-buffer draws.
    let coverage = |name: &str| row(&first, name).errors.wrong_coverage_ppm.expect("there are edges");
    assert!(coverage("gouraud A1 tol 0.25 bits 0") > coverage("gouraud A1 tol 0.25"));
    assert_eq!(row(&first, "gouraud A1 tol 0.25 -r watkins").errors, row(&first, "gouraud A1 tol 0.25").errors);
}

#[test]
fn knobs_without_effect_are_left_out() {
    let registry = Registry::built_in();
    let zbuffer = &*registry.find("zbuffer").expect("built in").rasterizer as &dyn Rasterizer;
    let count = |name: &str, spread| {
        configurations(&project(name), &small(16), &[("zbuffer", zbuffer)], spread).expect("a view")
    };
    // No shapes: no tolerance. No yon: no integer depth.
    let flat = count("star.nff", Spread::Sensible);
    assert!(
        flat.iter()
            .all(|of| !of.name.contains("tol") && !of.name.contains("depth int") && !of.name.contains("additive")),
        "{flat:?}"
    );
    assert!(count("highlight.nff", Spread::Sensible).len() > flat.len());
    assert!(count("star.nff", Spread::All).len() > flat.len());
    for all in [&flat, &count("highlight.nff", Spread::All)] {
        let names: std::collections::BTreeSet<&str> = all.iter().map(|of| of.name.as_str()).collect();
        assert_eq!(names.len(), all.len(), "two of one name: {names:?}");
    }
}

#[test]
fn where_rays_have_no_answer_the_finest_picture_stands_in() {
    let mut scene = project("highlight.nff");
    let surface = scene.surfaces.iter_mut().find(|surface| !surface.primitives.is_empty()).expect("a sphere");
    surface.primitives[0].shape = Shape::Torus { ring_radius: 1.2, tube_radius: 0.4 };
    let truth = Truth::new(&scene, &small(24), None).expect("a usable view");
    assert!(matches!(truth.source, Source::OwnFinest(_)));
    assert!(
        keep(&scene, &small(24), &ZBuffer, Goal::Pixels(0.5)).expect_err("no outline").to_string().contains("torus")
    );
}

#[test]
fn the_command_writes_what_programs_read() {
    let desk = Desk::new();
    let scene = project_scene("star.nff");
    let made = desk.done(&format!("lab {scene} --size 24 --runs 1 --csv a.csv --json a.json --plot a.svg"));
    let table = made.text();
    assert!(table.lines().all(|line| line.chars().count() <= 125), "{table}");
    assert!(table.contains("truth: rays") && table.lines().any(|line| line.starts_with("* ")), "{table}");
    assert!(made.stderr.is_empty(), "{}", made.stderr);

    let json: serde_json::Value = serde_json::from_slice(&desk.read("a.json")).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let csv = String::from_utf8(desk.read("a.csv")).expect("text");
    assert_eq!(csv.lines().count(), rows.len() + 1);
    let columns = csv.lines().next().expect("a head").split(',').count();
    assert!(csv.lines().all(|line| line.split(',').count() == columns));
    assert!(rows.iter().all(|row| row["times_ms"]["median"].as_f64().is_some_and(|time| time > 0.0)));
    let svg = String::from_utf8(desk.read("a.svg")).expect("text");
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n") && svg.matches("<circle").count() >= rows.len());

    // A picture of the same chart; an unknown ending and lines are refused.
    desk.done(&format!("lab {scene} --size 8 --runs 1 -r watkins --plot a.png"));
    assert!(desk.read("a.png").starts_with(b"\x89PNG"));
    for refused in ["--plot a.pdf", "-r wire", "-r nobody"] {
        assert_eq!(desk.run(&format!("lab {scene} --size 8 {refused}")).code, 2, "{refused}");
    }
}

#[test]
fn promises_are_kept() {
    for (name, levels) in [("highlight.nff", 30.0), ("shared_edge.nff", 40.0)] {
        let (scene, base) = (project(name), small(40));
        let promise =
            keep(&scene, &base, &ZBuffer, Goal::Levels(levels)).unwrap_or_else(|error| panic!("{name}: {error}"));
        // Judged by other rays than the search's, and on the bytes: rounding adds half a level.
        let rays = trace(&scene, &Choices { samples: 12, ..base.clone() }).expect("rays").image().encode(base.encoding);
        let drawn = render(&scene, &promise.choices, Some(&ZBuffer)).expect("drawn").image.encode(base.encoding);
        let wrong =
            rays.rgb().iter().zip(drawn.rgb()).filter(|(a, b)| f64::from(a.abs_diff(**b)) > levels + 1.0).count();
        assert!(wrong <= 1, "{name}: {wrong} of 1600 pixels\n{}", promise.text());
        assert!(promise.attempts.last().is_some_and(|_| promise.error <= levels));
    }
    let outline = keep(&project("highlight.nff"), &small(64), &ZBuffer, Goal::Pixels(0.5)).expect("a sphere");
    assert!(outline.error <= 0.5 && outline.choices.tolerance > 0.25, "{}", outline.text());
    // What a coarse picture keeps is not bought dearly.
    let loose = keep(&project("star.nff"), &small(40), &ZBuffer, Goal::Levels(254.0)).expect("anything holds");
    assert_eq!((loose.choices.shading, loose.choices.samples), (Shading::Flat, 1));
}

#[test]
fn the_impossible_is_refused_with_the_best_there_is() {
    let desk = Desk::new();
    let scene = project_scene("highlight.nff");
    let refused = desk.run(&format!("render {scene} --size 24 --max-error 0.001 -o a.png"));
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("cannot be promised: the best found is"), "{}", refused.stderr);
    assert!(!desk.path("a.png").exists());

    let kept = desk.done(&format!("render {scene} --size 24 --max-error 60 -o a.png"));
    assert!(kept.stderr.contains("max-error  60 levels") && kept.stderr.contains("the search took"), "{}", kept.stderr);
    let plan = desk.done(&format!("plan {scene} --size 24 --max-error 0.5px"));
    assert!(plan.text().contains("max-error  0.5 px") && plan.text().contains("picture "), "{}", plan.text());
    for wrong in ["--max-error 0", "--max-error 3pt", "--max-error 4 -s flat", "--max-error 4 -r wire"] {
        assert_eq!(desk.run(&format!("render {scene} --size 8 {wrong} -o b.png")).code, 2, "{wrong}");
    }
}

/// Programs and libraries are rows like any other; one that gives no picture is a row with its reason.
#[cfg(target_os = "linux")]
#[test]
fn rasterizers_outside_take_part() {
    const C: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/student_rasterizers/other_languages/c");
    let desk = Desk::new();
    let compiled = ["zb", "zb.so"].map(|name| desk.path(name).display().to_string());
    let compile = |arguments: &[&str]| std::process::Command::new("cc").args(arguments).status();
    let (main, functions) = (format!("{C}/zbuffer.c"), format!("{C}/zbuffer_lib.c"));
    let flags = &["-O1", "-std=c11", "-ffp-contract=off"][..];
    let has_compiler = match compile(&[flags, &["-o", &compiled[0], &main, &functions, "-lm"]].concat()) {
        Ok(status) => status.success(),
        Err(_) => false,
    };
    if has_compiler {
        let built = compile(&[flags, &["-shared", "-fPIC", "-o", &compiled[1], &functions, "-lm"]].concat());
        assert!(built.is_ok_and(|status| status.success()));
    } else {
        println!("notice: no C compiler, only programs that fail are tested");
    }
    let doors = if has_compiler { "-r exec:./zb -r lib:./zb.so" } else { "" };
    let scene = project_scene("star.nff");
    let arguments = format!(
        "lab {scene} --size 24 --encoding linear --runs 1 -r zbuffer {doors} -r exec:./missing -r exec:/bin/false"
    );
    let made = desk.done(&format!("{arguments} --csv a.csv --json a.json --plot a.svg"));
    let table = made.text();
    assert!(table.lines().all(|line| line.chars().count() <= 125), "{table}");
    let failed: Vec<&str> = table.lines().filter(|line| line.starts_with("! ")).collect();
    assert_eq!(failed.len(), 2 + 1, "two rows and the legend: {table}");
    assert!(failed[0].contains("-r exec:./missing") && failed[0].contains("`./missing` cannot be"), "{table}");

    let json: serde_json::Value = serde_json::from_slice(&desk.read("a.json")).expect("JSON");
    let rows = json["rows"].as_array().expect("rows");
    let of = |name: &str| {
        let row = rows.iter().find(|row| row["rasterizer"] == name && row["configuration"] != rows[0]["configuration"]);
        row.unwrap_or_else(|| panic!("no row of {name}: {table}"))
    };
    for name in ["exec:./missing", "exec:/bin/false"] {
        let row = of(name);
        assert!(row["errors"].is_null() && row["times_ms"].is_null() && row["failure"].is_string(), "{row}");
    }
    for name in ["exec:./zb", "lib:./zb.so"].into_iter().filter(|_| has_compiler) {
        let row = of(name);
        // It draws the z-buffer's picture in levels of linear light, half a level off at most; who owns a sample it does not say.
        for kind in ["worst_levels", "rms_levels"] {
            let [own, base] = [&row["errors"], &rows[0]["errors"]].map(|errors| errors[kind].as_f64().expect("known"));
            assert!((own - base).abs() < 0.51, "{name} {kind}: {own}, the z-buffer {base}");
        }
        assert!(row["errors"]["wrong_coverage_ppm"].is_null() && !rows[0]["errors"]["wrong_coverage_ppm"].is_null());
        assert!(row["times_ms"]["median"].as_f64().is_some_and(|time| time > 0.0) && row["failure"].is_null());
        assert!(json["hypervolumes"]["rms"]["of"][name].is_number(), "{json}");
    }
    let csv = String::from_utf8(desk.read("a.csv")).expect("text");
    assert!(csv.lines().any(|line| line.contains("exec:./missing") && line.contains(",,,")), "{csv}");
}

/// A program that always fails is not run for every one of its configurations.
#[cfg(target_os = "linux")]
#[test]
fn a_hopeless_program_is_not_tried_for_ever() {
    let desk = Desk::new();
    let scene = project_scene("star.nff");
    let table = desk.done(&format!("lab {scene} --size 8 --runs 1 -r exec:/bin/false -r zbuffer")).text().to_string();
    let [tried, left] = [false, true].map(|left| {
        table
            .lines()
            .filter(|line| line.starts_with("! ") && line.contains("not tried after 3 failures") == left)
            .count()
    });
    assert_eq!(tried, 3 + 1, "three rows and the legend: {table}");
    assert!(left > 10 && table.lines().any(|line| line.contains("-r zbuffer") && !line.starts_with('!')), "{table}");
}
