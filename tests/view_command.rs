//! `farop view` as a command: pictures without a window, paths, frames, and messages where something is missing.

#[path = "support/command.rs"]
mod command;
#[path = "support/viewer.rs"]
mod support;

use command::{Desk, TRIANGLE, project_scene};
use farop::view::path::{read_path, write_path};
use std::process::{Command, Stdio};
use support::{press, viewer};

#[test]
fn a_shot_is_what_the_viewer_shows() {
    let desk = Desk::new();
    let scene = project_scene("star.nff");
    desk.done(&format!("view {scene} --size 48 -r zbuffer --keys t4.. --shot star.png"));
    let shot = farop::image::read(&desk.path("star.png")).expect("a picture");
    let mut viewer = viewer("star.nff", 48);
    press(&mut viewer, "t4..");
    assert!(viewer.draw().picture() == shot);
    // Without overlays it is the picture of `render`, whichever the rasterizer.
    desk.done(&format!("view {scene} --size 48 --keys t --shot view.png"));
    desk.done(&format!("render {scene} --size 48 -o render.png"));
    desk.done("compare view.png render.png");
}

#[test]
fn the_inspector_has_the_words_of_why() {
    let desk = Desk::new();
    let scene = project_scene("star.nff");
    let why = desk.done(&format!("why {scene} --size 48 --pixel 20,20")).text().to_string();
    let mut viewer = viewer("star.nff", 48);
    viewer.state.text = false;
    press(&mut viewer, "<at:20,20>i");
    viewer.draw();
    let told = viewer.text().join("\n");
    let told = &told[told.find("sample 20,20").expect("it answers")..];
    // The command was given a longer name of the same file.
    assert_eq!(told.trim(), why.replace(&scene, "star.nff").trim());
}

#[test]
fn a_path_plays_the_same_everywhere() {
    let walk = "cc<up*3>p<time:0.1*5><right*4><time:0.1*5>p";
    let mut walker = viewer("depth_overlap.nff", 32);
    press(&mut walker, walk);
    let poses = walker.state.path.clone();
    assert_eq!(poses.len(), 11);
    assert!(poses[0].from != poses[5].from && poses[5].at != poses[10].at);
    // Playing shows pose after pose, whatever the time between frames, and then stays.
    let play = |seconds: &str| {
        let mut player = viewer("depth_overlap.nff", 32);
        player.state.path = read_path(&write_path(&poses)).expect("its own text");
        press(&mut player, "to");
        let frame = |number: usize| {
            press(&mut player, &format!("<time:{seconds}>"));
            assert_eq!(player.state.eye.pose, poses[number.min(10)], "frame {number}");
            player.draw().clone()
        };
        let frames: Vec<_> = (0..12).map(frame).collect();
        assert_eq!((player.state.playing, player.state.eye.pose), (None, poses[10]));
        frames
    };
    let frames = play("0.01");
    assert!(frames == play("3") && frames[0] != frames[10]);
}

#[test]
fn paths_and_frames_go_through_files() {
    let desk = Desk::new();
    let scene = project_scene("depth_overlap.nff");
    let view = format!("view {scene} --size 32 --shot last.png");
    desk.done(&format!("{view} --keys tc<up*4>p<time:0.1*3>pw --path walk.txt"));
    let path = String::from_utf8(desk.read("walk.txt")).expect("text");
    assert_eq!(read_path(&path).map(|poses| poses.len()), Ok(4));
    for folder in ["one", "two"] {
        desk.done(&format!("{view} --keys tlom<time:0.05*4> --path walk.txt --frames {folder}"));
        assert!(desk.path(folder).join("frame-00003.png").exists());
    }
    let frame = |folder: &str, number: u32| desk.read(&format!("{folder}/frame-{number:05}.png"));
    assert!((0..4).all(|number| frame("one", number) == frame("two", number)));
    assert!(frame("one", 0) != frame("one", 3));
    // f saves what is shown under the first free name.
    desk.done(&format!("{view} --keys tff"));
    assert_eq!(desk.read("farop-001.png"), desk.read("farop-002.png"));
}

#[test]
fn what_cannot_be_done_is_said() {
    let desk = Desk::new();
    desk.write("triangle.nff", TRIANGLE);
    let failed = |arguments: &str| {
        let outcome = desk.run(arguments);
        assert_eq!(outcome.code, 2, "{arguments}: {}", outcome.stderr);
        outcome.stderr
    };
    assert!(failed("view triangle.nff --keys <rihgt> --shot a.png").contains("`<rihgt>` is no key"));
    assert!(failed("view triangle.nff --shot a.gif").contains("a.gif"));
    assert!(failed("view triangle.nff -r none --shot a.png").contains("nothing to look at"));
    assert!(failed("view triangle.nff --subpixel-bits 40 --shot a.png").contains("40"));
    assert!(failed("view triangle.nff --size 300000 --shot a.png").contains("300000x300000"));
    desk.write("dark.nff", "f 1 0 0 .8 0 0 0 1\n");
    assert!(failed("view dark.nff --shot a.png").contains("--from"));
    assert_eq!(desk.entries(), ["dark.nff", "triangle.nff"]);
    // A path that is not there, or is none, is a message in the picture, not the end.
    desk.write("walk.txt", "farop-path 1\n1 2 3\n");
    desk.done("view triangle.nff --size 200 --keys l --path walk.txt --shot a.png");
    desk.done("view triangle.nff --size 200 --keys l --path missing.txt --shot b.png");
    assert!(desk.read("a.png") != desk.read("b.png"));
}

#[test]
fn without_a_display_the_way_without_one_is_told() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_farop"));
    command.args(["view", "spd:tetra:1", "--keys", "2"]).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
    if cfg!(any(windows, target_os = "macos")) {
        return println!("notice: windows here need no DISPLAY; not tried");
    }
    let output = command.stdin(Stdio::null()).output().expect("the program starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("farop view spd:tetra:1 --keys \"2\" --shot picture.png"), "{said}");
}

/// The commands of `docs/view.md` that make its pictures: name of the picture, and arguments.
fn pictures_of_the_page() -> Vec<(String, String)> {
    let page = include_str!("../docs/view.md");
    let commands = page.lines().filter_map(|line| line.strip_prefix("farop "));
    let made = commands.filter(|line| line.contains("--shot view_"));
    made.map(|line| {
        let name = line.rsplit(' ').next().expect("it ends with the picture").to_string();
        let words = line.split(' ').map(|word| match word.strip_prefix("scenes/") {
            Some(scene) => project_scene(scene),
            None => word.replace('"', ""),
        });
        (name, words.collect::<Vec<_>>().join(" "))
    })
    .collect()
}

#[test]
fn the_page_shows_what_its_commands_make() {
    let images = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/images");
    let desk = Desk::new();
    let pictures = pictures_of_the_page();
    assert!(pictures.len() >= 10);
    for (name, arguments) in pictures {
        desk.done(&arguments);
        let made = farop::image::read(&desk.path(&name)).expect("it was made");
        let shown = farop::image::read(&images.join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(made == shown, "docs/images/{name} is not what `farop {arguments}` makes");
    }
}
