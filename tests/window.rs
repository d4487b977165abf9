//! The real window, on a virtual display: opens, takes keys, answers, records, plays, ends. Needs `Xvfb` and `xdotool`;
//! without them it says so and passes.

#![cfg(all(target_os = "linux", feature = "window"))]

#[path = "support/command.rs"]
mod command;

use command::{Desk, project_scene};
use farop::image::Picture;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// The longest wait for something that should happen at once; the machine may be busy.
const PATIENCE: Duration = Duration::from_secs(60);

/// A process that ends with the test.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn is_there(program: &str) -> bool {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&paths).any(|folder| folder.join(program).is_file())
}

/// Waits until `ask` answers.
fn wait_for<T>(what: &str, mut ask: impl FnMut() -> Option<T>) -> T {
    let start = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(start.elapsed() < PATIENCE, "waited in vain for {what}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// A virtual display of its own, which the server numbers itself.
fn display(folder: &Path) -> (Running, String) {
    let number = folder.join("display");
    let file = std::fs::File::create(&number).expect("the folder is writable");
    let mut server = Command::new("Xvfb");
    // -noreset: a server without clients starts anew and turns away whoever comes just then. -r: on a busy machine even a
    // tap may last so long that the key repeats.
    server.args(["-displayfd", "1", "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset", "-r"]);
    let server = server.stdout(file).stderr(Stdio::null()).spawn().expect("Xvfb starts");
    let server = Running(server);
    let display = wait_for("the display", || {
        let text = std::fs::read_to_string(&number).ok()?;
        text.ends_with('\n').then(|| format!(":{}", text.trim()))
    });
    // The number is there before the server answers.
    wait_for("an answer of the display", || xdotool(&display, &["getmouselocation"]).contains("x:").then_some(()));
    (server, display)
}

fn xdotool(display: &str, arguments: &[&str]) -> String {
    let output = Command::new("xdotool").args(arguments).env("DISPLAY", display).output().expect("xdotool starts");
    String::from_utf8_lossy(&output.stdout).trim().to_string()
}

/// Types keys, each a short tap.
fn tap(display: &str, keys: &[&str]) {
    xdotool(display, &[&["key", "--delay", "12"], keys].concat());
}

#[test]
fn a_real_window_does_what_the_keys_say() {
    if !(is_there("Xvfb") && is_there("xdotool")) {
        return println!("notice: no Xvfb or no xdotool here: the real window is not tried");
    }
    let desk = Desk::new();
    let scene = desk.path("scene.nff");
    let text = std::fs::read_to_string(project_scene("depth_overlap.nff")).expect("a scene of the project");
    std::fs::write(&scene, &text).expect("the folder is writable");
    let (_server, display) = display(&desk.path(""));
    let mut farop = Command::new(env!("CARGO_BIN_EXE_farop"));
    farop.args(["view", "scene.nff", "--size", "320x240"]).current_dir(desk.path("")).env("DISPLAY", &display);
    let mut farop = Running(farop.stdin(Stdio::null()).spawn().expect("the program starts"));
    let window = wait_for("the window", || {
        let found = xdotool(&display, &["search", "--name", "farop: scene.nff"]);
        found.lines().next().map(String::from)
    });
    // Nobody manages windows here, so nobody gives them the keyboard.
    xdotool(&display, &["windowfocus", "--sync", &window]);
    let saved = || saved_next(&desk, &display);

    // Taps of 12 ms change the shading; the picture is what `--shot` gives.
    tap(&display, &["t"]);
    let gouraud = saved();
    assert_eq!((gouraud.width(), gouraud.height()), (320, 240));
    tap(&display, &["s", "s", "s"]);
    let wire = saved();
    assert!(gouraud != wire);
    desk.done("view scene.nff --size 320x240 --keys tsss --shot wire.png");
    assert!(farop::image::read(&desk.path("wire.png")).expect("a picture") == wire);

    // The lens is over the pixel under the pointer. (The text is left out: in a window it also has the frames a second.)
    xdotool(&display, &["mousemove", "--window", &window, "150", "110"]);
    tap(&display, &["s", "i"]);
    desk.done("view scene.nff --size 320x240 --keys t<at:150,110>i --shot lens.png");
    let lens = farop::image::read(&desk.path("lens.png")).expect("a picture");
    // The display tells of keys and of the pointer in its own time.
    wait_for("the lens", || (saved() == lens).then_some(()));

    // A path is recorded, written and played. Every picture that is saved took a frame at least.
    tap(&display, &["i", "c", "Up", "Up", "p"]);
    for _ in 0..3 {
        saved();
    }
    // Stands before the recording ends: the last pose of the path is where it stands.
    tap(&display, &["space"]);
    let stood = saved();
    tap(&display, &["p", "w"]);
    let path = wait_for("the path", || std::fs::read_to_string(desk.path("farop-path.txt")).ok());
    let poses = farop::view::path::read_path(&path).expect("a path");
    assert!(poses.len() > 1 && poses[0].from != poses[poses.len() - 1].from, "{} poses", poses.len());
    tap(&display, &["v"]);
    assert!(saved() != stood);
    tap(&display, &["o"]);
    // It ends where the path does.
    wait_for("the end of the path", || (saved() == stood).then_some(()));

    // A broken scene is told over the last good picture, the window stays; a good one is taken again.
    std::fs::write(&scene, text.replace("p 4", "p 5")).expect("the folder is writable");
    wait_for("the message", || (saved() != stood).then_some(()));
    std::fs::write(&scene, &text).expect("the folder is writable");
    wait_for("the scene", || (saved() == stood).then_some(()));

    // Another size.
    xdotool(&display, &["windowsize", "--sync", &window, "400", "200"]);
    wait_for("the new size", || {
        let picture = saved();
        ((picture.width(), picture.height()) == (400, 200)).then_some(())
    });

    // q ends it, with exit code 0.
    tap(&display, &["q"]);
    let status = wait_for("the end", || farop.0.try_wait().expect("it can be asked"));
    assert!(status.success(), "{status}");
}

/// Saves once more, under the next free number, and reads that picture.
fn saved_next(desk: &Desk, display: &str) -> Picture {
    let pictures = |name: &&String| name.starts_with("farop-") && name.ends_with(".png");
    let number = desk.entries().iter().filter(pictures).count() + 1;
    let name = desk.path(&format!("farop-{number:03}.png"));
    tap(display, &["f"]);
    wait_for("a saved picture", || farop::image::read(&name).ok())
}
