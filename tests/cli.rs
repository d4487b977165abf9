//! Every command of the real program, on small scenes: what it writes, and what must be equal to what.

#[path = "support/command.rs"]
mod command;

use command::{Desk, TRIANGLE, project_scene};
use serde_json::Value;

#[test]
fn render_writes_png_ppm_and_standard_output() {
    let desk = Desk::new();
    let scene = "render spd:balls:1 --size 24x16";
    assert!(desk.made(scene, "a.png").starts_with(b"\x89PNG"));
    let ppm = desk.made(scene, "a.ppm");
    assert!(ppm.starts_with(b"P6\n24 16\n255\n"), "{:?}", &ppm[..16]);
    assert_eq!(desk.done(&format!("{scene} -o -")).stdout, ppm);
    assert_eq!(desk.done("compare a.png a.ppm").code, 0);
    let shown = desk.done(scene);
    assert!(shown.text().contains("24x16 pixels; save it with `-o"), "{}", shown.text());
    assert_eq!(desk.entries(), ["a.png", "a.ppm"]);
}

#[test]
fn stats_as_json_have_the_numbers_of_1996() {
    let desk = Desk::new();
    let stats = |options: &str| -> Value {
        let outcome = desk.done(&format!("render spd:gears:4 --size 1024 -r none --stats=json {options}"));
        serde_json::from_str(outcome.text()).unwrap_or_else(|error| panic!("{error}: {}", outcome.text()))
    };
    let plain = stats("");
    for (key, expected) in [("polygons", 9345), ("backfacing", 4864), ("clipped", 39), ("rendered", 4442)] {
        assert_eq!(plain[key], expected, "{key}");
    }
    assert_eq!(stats("--triangles")["triangles"], 17659);
    let keys = "objects surfaces polygons vertices backfacing clipped cut inside rendered triangles puts overdraw \
                stray_writes peak_bytes";
    for key in keys.split(' ') {
        assert!(plain[key].is_u64(), "{key}: {}", plain[key]);
    }
    for key in ["polygons", "backfacing", "clipped", "rendered"] {
        assert!(plain["tessellated"][key].is_u64(), "tessellated {key}");
    }
    for stage in ["parse", "plan", "geometry", "raster", "write"] {
        for time in ["elapsed", "user", "system"] {
            assert!(plain["times_ms"][stage][time].is_number(), "{stage} {time}");
        }
    }
}

#[test]
fn stats_as_text_follow_the_appendix_of_the_paper() {
    let desk = Desk::new();
    let outcome = desk.done("render spd:gears:1 --size 16 --stats -o pipe.ppm");
    let mut lines = outcome.text().lines();
    for expected in [
        "NFF scene will be imported!",
        "Pipeline: Parsing NFF file, wait...",
        "Pipeline: NFF background loaded",
        "Pipeline: NFF view parameters loaded",
        "Pipeline: NFF light loaded (",
        "Pipeline: NFF surface with ",
        "Pipeline: Imported ",
        "Pipeline: NFF parser done",
        "Pipeline: Hither:",
        "Pipeline: Pipeline creating render data, wait...",
        "Timer started",
        "Pipeline: Image file to be created: 'pipe.ppm'",
        "Pipeline: Objects loaded: ",
        "Pipeline: Surfaces loaded: ",
        "Pipeline: Polygons loaded: ",
        "Pipeline: Polygons ready to be rendered",
        "Timer Stopped (Elapsed: ",
        "Pipeline: zbuffer rendering, wait...",
        "Timer started",
        "Pipeline: Render Mode: Gouraud",
        "Pipeline: zbuffer rasterization done!",
        "Timer Stopped (Elapsed: ",
        "Pipeline: Successful End",
        "Pipeline: Polygons backfacing: ",
        "Pipeline: Polygons totally clipped: ",
        "Pipeline: Polygons split to triangles: ",
        "Pipeline: Polygons rendered: ",
    ] {
        assert!(lines.any(|line| line.starts_with(expected)), "`{expected}` in its place:\n{}", outcome.text());
    }
}

#[test]
fn dump_then_raster_is_render() {
    let desk = Desk::new();
    let glass = project_scene("glass.nff");
    for scene in ["spd:balls:1", &glass] {
        for options in ["-s flat", "-s gouraud", "-s phong", "-s wire", "--samples 2", "--depth f64"] {
            let picture = format!("{scene} --size 40x32 {options}");
            let direct = desk.made(&format!("render {picture}"), "direct.ppm");
            desk.done(&format!("dump {picture} -o a.scr"));
            assert!(desk.made("raster a.scr", "later.ppm") == direct, "{picture}");
            desk.done(&format!("render {picture} --dump b.scr -o c.ppm"));
            assert!(desk.made("raster b.scr", "d.ppm") == direct, "render --dump {picture}");
        }
    }
}

#[test]
fn a_classic_file_is_close() {
    let desk = Desk::new();
    // A classic file says nothing of the background: black. Whole coordinates move the outlines, nothing else.
    desk.done("render spd:tetra:3 --size 64 --background 0,0,0 --subpixel-bits 0 -o direct.png");
    desk.done("dump spd:tetra:3 --size 64 --background 0,0,0 --classic -o a.scr");
    desk.done("raster a.scr -o later.png");
    let compared = desk.run("compare direct.png later.png --max-diff 16 --max-pixels 200");
    assert_eq!(compared.code, 0, "{}{}", compared.text(), compared.stderr);
}

#[test]
fn convert_and_generate_keep_the_picture() {
    let desk = Desk::new();
    let folder = std::fs::read_dir(project_scene("")).expect("scenes are part of the project");
    let mut scenes: Vec<_> = folder.map(|entry| entry.expect("readable").path().display().to_string()).collect();
    // What SIPP's scenes lose on the way is told, and so tested elsewhere.
    scenes.retain(|name| name.ends_with(".nff"));
    scenes.extend(["spd:balls:1".to_string(), "spd:lattice:2".to_string()]);
    for scene in scenes {
        for options in ["--size 32", "--size 32 -s phong"] {
            let direct = desk.made(&format!("render {scene} {options}"), "direct.ppm");
            desk.done(&format!("convert {scene} {options} -o a.nff"));
            assert!(desk.made(&format!("render a.nff {options}"), "later.ppm") == direct, "{scene} {options}");
        }
    }
    desk.done("generate gears --size 1 -o gears.nff");
    let generated = desk.made("render gears.nff --size 32", "a.ppm");
    assert!(generated == desk.made("render spd:gears:1 --size 32", "b.ppm"));
}

#[test]
fn a_scene_converted_to_sipp_keeps_its_tree_and_its_picture() {
    let desk = Desk::new();
    for name in ["arm.sipp", "mobile.sipp", "teapot.sipp", "patches.sipp"] {
        let scene = project_scene(name);
        let expected = desk.made(&format!("render {scene} --size 48x48"), "expected.ppm");
        assert_eq!(desk.done(&format!("convert {scene} --size 48x48 -o again.sipp")).stderr, "", "{name}");
        assert!(desk.made("render again.sipp", "again.ppm") == expected, "{name}");
    }
    let text = |desk: &Desk| String::from_utf8(desk.read("again.sipp")).expect("text");
    desk.done(&format!("convert {} -o again.sipp", project_scene("mobile.sipp")));
    assert!(text(&desk).contains("use fish {") && text(&desk).contains("ellipsoid {"), "{}", text(&desk));
    // Flat and in triangles, as into NFF.
    desk.done(&format!("convert {} --triangles -o again.sipp", project_scene("mobile.sipp")));
    assert!(!text(&desk).contains("ellipsoid"));
    let longest =
        text(&desk).lines().filter(|line| line.contains("polygon {")).map(|line| line.split(' ').count()).max();
    assert_eq!(
        longest,
        text(&desk).lines().find(|line| line.contains("polygon {")).map(|line| line.split(' ').count())
    );
    let notices = desk.done("convert spd:balls:1 -o balls.sipp").stderr;
    assert!(notices.contains("not in the SIPP file: surfaces of NFF's reflection"), "{notices}");
}

#[test]
fn later_scenes_and_the_command_line_win_with_a_notice() {
    let desk = Desk::new();
    desk.write("a.nff", TRIANGLE);
    desk.write("b.nff", TRIANGLE.replace("from 0 0 5", "from 0 0 6").replace("b 0.2", "b 0.5"));
    let outcome = desk.done("render a.nff b.nff --angle-of-view 40 --yon 20 --light 1,2,3 -o a.png");
    insta::assert_snapshot!("cli_notices", outcome.stderr);
}

#[test]
fn what_must_not_change_the_picture() {
    let desk = Desk::new();
    for scene in ["spd:balls:1", "spd:gears:1", "spd:lattice:2"] {
        for shading in ["flat", "gouraud", "phong", "wire"] {
            let drawn = |options: &str| {
                desk.done(&format!("render {scene} --size 40 -s {shading} --threads 3 {options} -o -")).stdout
            };
            assert!(drawn("") == drawn("--needs full"), "{scene} {shading}: needs");
            let alone = desk.done(&format!("render {scene} --size 40 -s {shading} --threads 1 -o -")).stdout;
            assert!(drawn("") == alone, "{scene} {shading}: threads");
        }
    }
}

#[test]
fn only_and_first_draw_a_part() {
    let desk = Desk::new();
    let drawn = |options: &str| desk.done(&format!("render spd:tetra:2 --size 24 {options} -o -")).stdout;
    assert!(drawn("--only 0") == drawn("--first 1"));
    assert!(drawn("--first 0") == drawn("--only 1000000"));
    assert!(drawn("--first 0") != drawn("--first 1"));
    assert!(drawn("--first 1000000") == drawn(""));
}

#[test]
fn every_stage_can_be_printed() {
    let desk = Desk::new();
    desk.write("a.nff", TRIANGLE);
    let texts = ["scene", "plan", "eye", "clip", "screen"].map(|stage| {
        let outcome = desk.done(&format!("render a.nff --dump-stage {stage}"));
        assert!(outcome.text().lines().count() >= 2, "{stage}: {}", outcome.text());
        outcome.text().to_string()
    });
    assert!(texts.windows(2).all(|pair| pair[0] != pair[1]));
}

/// Names and bytes of the files of a set.
fn set(desk: &Desk, name: &str, options: &str) -> Vec<(String, Vec<u8>)> {
    desk.done(&format!("suite spd:gears:1 spd:balls:1 --size 24 {options} -o {name}"));
    let mut files = Vec::new();
    for folder in [desk.path(name), desk.path(name).join("expected")] {
        for entry in std::fs::read_dir(folder).expect("made").map(|entry| entry.expect("readable").path()) {
            if entry.is_file() {
                let file = entry.strip_prefix(desk.path(name)).expect("inside").display().to_string();
                files.push((file, std::fs::read(&entry).expect("readable")));
            }
        }
    }
    files.sort();
    files
}

#[test]
fn convert_writes_the_size_that_the_shapes_were_cut_for() {
    let desk = Desk::new();
    desk.done("convert spd:balls:1 --size 40x30 -o balls.nff");
    desk.done("render balls.nff -o written.png");
    desk.done("render spd:balls:1 --size 40x30 -o direct.png");
    assert!(desk.read("written.png") == desk.read("direct.png"), "without --size, the file's own size counts");
}

#[test]
fn a_set_depends_on_its_seed_alone() {
    let desk = Desk::new();
    let first = set(&desk, "one", "--seed 5");
    assert!(first.iter().any(|(name, _)| name == "manifest.json"));
    assert!(first == set(&desk, "two", "--seed 5"));
    // The manifest names the seed and so always differs; what the seed is for is which few polygons are picked.
    let other = set(&desk, "three", "--seed 6");
    let picked = |files: &[(String, Vec<u8>)]| -> Vec<(String, Vec<u8>)> {
        files.iter().filter(|(name, _)| name.ends_with("-few.scr")).cloned().collect()
    };
    assert!(!picked(&first).is_empty() && picked(&first) != picked(&other), "another seed picks other polygons");
}

#[test]
fn why_names_the_winner_and_the_rule() {
    let desk = Desk::new();
    let scene = std::fs::read(project_scene("depth_overlap.nff")).expect("a scene of the project");
    desk.write("overlap.nff", scene);
    insta::assert_snapshot!("cli_why", desk.done("why overlap.nff --pixel 48,48").text());
}

#[test]
fn compare_ends_with_0_1_or_2() {
    let desk = Desk::new();
    desk.write("a.nff", TRIANGLE);
    desk.done("render a.nff -o a.png");
    desk.done("render a.nff --light 0,0,9 -o b.png");
    assert_eq!(desk.run("compare a.png a.png").code, 0);
    let different = desk.run("compare a.png b.png --diff diff.png");
    assert_eq!(different.code, 1);
    assert!(desk.read("diff.png").starts_with(b"\x89PNG"));
    insta::assert_snapshot!("cli_compare", format!("{}{}", different.text(), different.stderr));
    assert_eq!(desk.run("compare a.png b.png --max-diff 255").code, 0);
    assert_eq!(desk.run("compare a.png b.png --max-pixels 64").code, 0);
    assert_eq!(desk.run("compare a.png missing.png").code, 2);
}

#[test]
fn lists_completions_and_first_steps() {
    let desk = Desk::new();
    for (what, expected) in
        [("scenes", "gears"), ("rasterizers", "zbuffer"), ("labs", "shared edge"), ("checks", "predicates")]
    {
        let listed = desk.done(&format!("list {what}"));
        assert!(listed.text().contains(expected) && listed.text().ends_with('\n'), "{what}: {}", listed.text());
    }
    assert!(desk.done("completions bash").text().contains("_farop()"));
    insta::assert_snapshot!("cli_first_steps", desk.done("").text());
    assert!(desk.done("").text().ends_with('\n'));
}

#[test]
fn a_student_crate_is_made() {
    let desk = Desk::new();
    desk.write("Cargo.toml", "[workspace]\nmembers = [\"student_*\"]\n");
    let outcome = desk.done("student new ana");
    assert!(outcome.text().contains("cargo run -p student_ana"), "{}", outcome.text());
    assert_eq!(desk.entries(), ["Cargo.toml", "student_ana"]);
    assert_eq!(desk.run("student new ana").code, 2, "it is there already");
}

#[test]
fn short_help_fits_and_ends_with_two_examples() {
    let desk = Desk::new();
    let commands = "render dump raster suite compare convert generate grade bench plan why list completions";
    for command in commands.split(' ').chain(["", "student new"]) {
        let help = desk.done(&format!("{command} -h"));
        for line in help.text().lines() {
            assert!(line.chars().count() <= 80, "{command}: {line}");
        }
        let (_, examples) = help.text().split_once("\nExamples:\n").unwrap_or_else(|| panic!("{command}: examples"));
        let lines: Vec<_> = examples.trim_end().lines().collect();
        assert!(lines.len() == 2 && lines.iter().all(|line| line.starts_with("  ")), "{command}: {examples}");
    }
}
