//! Bad input at the command line: a clear message, exit code 2, and nothing left behind.

#[path = "support/command.rs"]
mod command;

use command::{Desk, TRIANGLE};

/// One way to go wrong: its name, the arguments, the files beforehand.
struct Case {
    name: &'static str,
    arguments: String,
}

fn case(name: &'static str, arguments: impl Into<String>) -> Case {
    Case { name, arguments: arguments.into() }
}

/// Runs every case on `desk`; each must end with 2, print nothing on standard output and leave no file. The messages.
fn refusals(desk: &Desk, cases: &[Case]) -> String {
    let before = desk.entries();
    let mut messages = String::new();
    for Case { name, arguments } in cases {
        let outcome = desk.run(arguments);
        assert_eq!(outcome.code, 2, "{name}: farop {arguments}\n{}", outcome.stderr);
        assert!(outcome.stdout.is_empty(), "{name}: {}", String::from_utf8_lossy(&outcome.stdout));
        assert!(outcome.stderr.len() > 20 && outcome.stderr.ends_with('\n'), "{name}: {:?}", outcome.stderr);
        assert!(!outcome.stderr.contains("panicked"), "{name}: {}", outcome.stderr);
        assert_eq!(desk.entries(), before, "{name} left something behind");
        messages += &format!("### {name}: farop {arguments}\n{}\n", outcome.stderr.replace("farop.exe", "farop"));
    }
    messages
}

#[test]
fn broken_scene_files() {
    let desk = Desk::new();
    let broken = [
        ("empty", String::new()),
        ("truncated_vertex", TRIANGLE.replace("-0.4 1.5 0\n", "-0.4 1.5")),
        ("negative_count", TRIANGLE.replace("p 3", "p -3")),
        ("huge_count", TRIANGLE.replace("p 3", "p 1000000000")),
        ("unknown_keyword", TRIANGLE.replace("p 3", "polygon 3")),
        ("nan", TRIANGLE.replace("1.2 -1.4 0", "nan -1.4 0")),
        ("overflow", TRIANGLE.replace("1.2 -1.4 0", "1.2 1e999 0")),
        ("from_is_at", TRIANGLE.replace("from 0 0 5", "from 0 0 0")),
        ("resolution_0", TRIANGLE.replace("resolution 8 8", "resolution 0 8")),
    ];
    for (name, text) in &broken {
        desk.write(&format!("{name}.nff"), text);
    }
    let cases: Vec<_> = broken.iter().map(|(name, _)| case(name, format!("render {name}.nff -o out.png"))).collect();
    let messages = refusals(&desk, &cases);
    // Every command that reads scenes says the same.
    for command in ["dump -o out.scr", "convert -o out.nff", "suite -o out", "why --pixel 1,1", "plan"] {
        for (name, _) in &broken {
            refusals(&desk, &[case(name, format!("{command} {name}.nff"))]);
        }
    }
    insta::assert_snapshot!("cli_broken_scenes", messages);
}

#[test]
fn hither_0_is_a_notice_and_the_picture_is_written() {
    let desk = Desk::new();
    desk.write("scene.nff", TRIANGLE.replace("hither 1", "hither 0"));
    let outcome = desk.done("render scene.nff -o out.png");
    assert!(desk.read("out.png").starts_with(b"\x89PNG"));
    assert_eq!(desk.entries(), ["out.png", "scene.nff"]);
    insta::assert_snapshot!("cli_hither_0", outcome.stderr);
}

#[test]
fn places_that_cannot_be_read_or_written() {
    let desk = Desk::new();
    desk.write("scene.nff", TRIANGLE);
    std::fs::create_dir(desk.path("folder")).expect("writable");
    let mut messages = refusals(
        &desk,
        &[
            case("a directory as scene", "render folder -o out.png"),
            case("a missing file", "render missing.nff -o out.png"),
            case("no output folder", "render scene.nff -o missing/out.png"),
            case("no folder for the screen file", "dump scene.nff -o missing/out.scr"),
            case("no folder for the converted scene", "convert scene.nff -o missing/out.nff"),
            case("no folder for the generated scene", "generate gears --size 1 -o missing/out.nff"),
            case("no folder for the set", "suite scene.nff -o missing/out"),
            case("a directory as output", "render scene.nff -o folder"),
            case("unknown ending", "render scene.nff -o out.xyz"),
            case("no ending", "render scene.nff -o out"),
        ],
    );
    // The wording of the system's own messages differs from one to the next.
    for foreign in ["No such file or directory (os error 2)", "Is a directory (os error 21)"] {
        messages = messages.replace(foreign, "<system>");
    }
    if cfg!(unix) {
        insta::assert_snapshot!("cli_places", messages);
    }
}

#[test]
fn a_full_disk() {
    if !cfg!(target_os = "linux") {
        println!("notice: there is no /dev/full here, a full disk is not tested");
        return;
    }
    let desk = Desk::new();
    desk.write("scene.nff", TRIANGLE);
    let messages = refusals(
        &desk,
        &[
            case("picture", "render scene.nff -o /dev/full"),
            case("screen file", "dump scene.nff -o /dev/full"),
            case("classic screen file", "dump scene.nff --classic -o /dev/full"),
            case("converted", "convert scene.nff -o /dev/full"),
            case("generated", "generate balls --size 2 -o /dev/full"),
        ],
    );
    insta::assert_snapshot!("cli_full_disk", messages);
}

#[test]
fn a_line_of_100_megabytes() {
    let desk = Desk::new();
    let chunk = vec![b'7'; 1 << 20];
    let outcome = desk.run_with_input("render - --format nff -o out.png", |stdin| {
        let _ = stdin.write_all(b"p ");
        for _ in 0..100 {
            if stdin.write_all(&chunk).is_err() {
                break;
            }
        }
    });
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    assert!(outcome.stderr.len() < 2000, "a short message, not {} bytes", outcome.stderr.len());
    assert!(desk.entries().is_empty(), "{:?}", desk.entries());
    insta::assert_snapshot!("cli_long_line", outcome.stderr);
}

#[test]
fn options_out_of_range() {
    let desk = Desk::new();
    desk.write("scene.nff", TRIANGLE);
    desk.write("broken.scr", "farop screen 2\nwidth eight\n");
    desk.write("text.png", "this is no picture");
    let render = |options: &str| format!("render scene.nff -o out.png {options}");
    let messages = refusals(
        &desk,
        &[
            case("unknown rasterizer", render("-r mine")),
            case("no width", render("--size 0x5")),
            case("size is no number", render("--size big")),
            case("too large a picture", render("--size 100000x100000")),
            case("no samples", render("--samples 0")),
            case("too many samples", render("--samples 1000")),
            case("angle 0", render("--angle-of-view 0")),
            case("angle 180", render("--angle-of-view 180")),
            case("yon below hither", render("--hither 5 --yon 2")),
            case("half a light", render("--light 1,2")),
            case("background nan", render("--background nan")),
            case("background of nans", render("--background nan,nan,nan")),
            case("infinite hither", render("--hither inf")),
            case("tolerance 0", render("--tolerance 0")),
            case("sub-pixel bits", render("--subpixel-bits 17")),
            case("integer depth without yon", render("--depth int16")),
            case("unknown shading", render("--shading toon")),
            case("unknown stage", render("--dump-stage light")),
            case("no threads", render("--threads 0")),
            case("from is at", render("--from 1,2,3 --at 1,2,3")),
            case("up is zero", render("--up 0,0,0")),
            case("unknown built-in scene", "render spd:cogs -o out.png"),
            case("gears of size 0", "render spd:gears:0 -o out.png"),
            case("balls of size 40", "render spd:balls:40 -o out.png"),
            case("size that is no number", "render spd:gears:big -o out.png"),
            case("generate size 0", "generate gears --size 0 -o out.nff"),
            case("generate unknown", "generate cogs -o out.nff"),
            case("pixel outside", "why scene.nff --pixel 8,0"),
            case("pixel of one number", "why scene.nff --pixel 8"),
            case("broken screen file", "raster broken.scr -o out.png"),
            case("scene for a screen file", "raster scene.nff -o out.png"),
            case("missing screen file", "raster missing.scr -o out.png"),
            case("no picture", "compare text.png text.png --diff out.png"),
            case("missing picture", "compare missing.png text.png"),
            case("student name", "student new Ana"),
            case("unknown command", "rendre scene.nff"),
        ],
    );
    let messages = messages.replace("No such file or directory (os error 2)", "<system>");
    if cfg!(unix) {
        insta::assert_snapshot!("cli_options", messages);
    }
}

#[test]
fn an_old_picture_survives_a_failure() {
    let desk = Desk::new();
    desk.write("scene.nff", TRIANGLE.replace("p 3", "p -3"));
    desk.write("out.png", "old");
    let outcome = desk.run("render scene.nff -o out.png");
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    assert_eq!(desk.read("out.png"), b"old");
    assert_eq!(desk.entries(), ["out.png", "scene.nff"]);
}
