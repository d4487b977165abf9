//! A class with unruly submissions is graded to its end, rightly, and nothing is left behind; a grader that was killed goes on.
#![cfg(target_os = "linux")]

#[path = "support/unruly.rs"]
mod unruly;

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use unruly::{Kind, Places};

fn farop(arguments: &[&str], folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_farop"));
    // Cells of this test alone: others run at the same time.
    command.args(arguments).current_dir(folder).env("TMPDIR", temporary(folder));
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// A folder for cells, which everybody may pass.
fn temporary(folder: &Path) -> PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let temporary = folder.join("cells");
    std::fs::create_dir_all(&temporary).expect("made");
    for open in [folder, &temporary] {
        std::fs::set_permissions(open, std::fs::Permissions::from_mode(0o755)).expect("own folder");
    }
    temporary
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("readable").flatten();
    entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
}

fn run(arguments: &[&str], folder: &Path) -> Output {
    let output = farop(arguments, folder).output().expect("farop starts");
    let code = output.status.code();
    assert_eq!(code, Some(0), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

fn json(path: PathBuf) -> Value {
    let text = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    serde_json::from_slice(&text).expect("whole JSON")
}

/// Whether this machine can hold submissions: it is not the grader's fault when it cannot, and the grader then refuses.
fn is_held(folder: &Path) -> bool {
    let output = farop(&["sandbox"], folder).output().expect("farop starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return true;
    }
    println!("notice: submissions cannot be held on this machine, not tested:\n{text}");
    assert!(text.contains("missing: "), "every layer is there, and a way out is open:\n{text}");
    false
}

/// Processes whose command line names `part`.
fn processes_with(part: &str) -> Vec<String> {
    let lines = std::fs::read_dir("/proc").expect("Linux").flatten().filter_map(|entry| {
        let line = std::fs::read(entry.path().join("cmdline")).ok()?;
        let line = String::from_utf8_lossy(&line).replace('\0', " ");
        (line.contains(part) && !line.contains("__jail")).then_some(line)
    });
    lines.collect()
}

fn chosen<'a>(all: &'a [Kind], names: &[&str]) -> Vec<&'a Kind> {
    names.iter().map(|name| all.iter().find(|kind| kind.name == *name).expect("a kind")).collect()
}

#[test]
fn an_unruly_class_gets_its_grades() {
    let desk = tempfile::tempdir().expect("a folder");
    if !is_held(desk.path()) {
        return;
    }
    let places = Places::new(desk.path());
    let all: Vec<Kind> = unruly::ordinary().into_iter().chain(unruly::unruly(&places)).collect();
    let names = [
        "right_python",
        "right_rust",
        "right_library",
        "empty",
        "new\nline",
        "hangs",
        "crashes",
        "floods_disk",
        "daemon",
        "forges",
        "reads_neighbor",
        "kills_parent",
        "includes",
        "embeds_c",
        "link",
    ];
    let kinds = chosen(&all, &names);
    let keys: Vec<String> =
        kinds.iter().enumerate().map(|(number, kind)| unruly::write(kind, number, &places)).collect();
    let output = run(&["grade", "zbuffer", "--class", "submissions", "--jobs", "3", "--time", "3"], desk.path());
    let class = json(places.results.join("class.json"));
    let rows = class["submissions"].as_array().expect("a list");
    assert_eq!(rows.len(), kinds.len());
    let row = |source: &String| rows.iter().find(|row| row["source"] == source.as_str()).expect("every one has a row");
    let wrong: Vec<_> =
        kinds.iter().zip(&keys).filter_map(|(kind, key)| unruly::complaint(kind, row(key), &places)).collect();
    assert!(wrong.is_empty(), "{}\n{}", wrong.join("\n"), String::from_utf8_lossy(&output.stdout));

    // Nothing is left: no file where attacks wrote, no cell, no process.
    assert_eq!(places.left_behind(), [""; 0]);
    assert!(!desk.path().join("submissions/verdict.json").exists());
    assert_eq!(names_in(&desk.path().join("cells")), [""; 0]);
    assert_eq!(processes_with(&desk.path().display().to_string()), [""; 0]);
    assert!(!places.results.join(".cells").exists());

    // Moodle's worksheet has a row each, and a name with a line end in it makes no second one.
    let csv = std::fs::read_to_string(places.results.join("grades.csv")).expect("written");
    assert_eq!(csv.lines().count(), 1 + kinds.len());
    let layers = class["sandbox"].as_array().expect("a list");
    assert!(layers.contains(&"files".into()) && layers.contains(&"user".into()), "{layers:?}");
}

#[test]
fn a_killed_grader_goes_on_and_points_can_change() {
    let desk = tempfile::tempdir().expect("a folder");
    if !is_held(desk.path()) {
        return;
    }
    let places = Places::new(desk.path());
    let all: Vec<Kind> = unruly::ordinary().into_iter().chain(unruly::unruly(&places)).collect();
    let kinds = chosen(&all, &["right_python", "typo", "forges", "right_python", "sleeps", "right_library"]);
    for (number, kind) in kinds.iter().enumerate() {
        unruly::write(kind, number, &places);
    }
    let usual = ["grade", "zbuffer", "--class", "submissions", "--jobs", "1", "--time", "3"];
    run(&usual, desk.path());
    let text =
        |folder: &str, file: &str| std::fs::read_to_string(desk.path().join(folder).join(file)).expect("written");
    let expected = ["class.json", "grades.csv"].map(|file| text("submissions.graded", file));

    // Kill it while a submission that hangs is being waited for.
    let elsewhere: Vec<&str> = usual.iter().copied().chain(["--results", "other"]).collect();
    let mut killed = farop(&elsewhere, desk.path()).spawn().expect("farop starts");
    let started = Instant::now();
    let hung = desk.path().join("other/submissions");
    while std::fs::read_dir(&hung).map_or(0, Iterator::count) < 4 && started.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(20));
    }
    std::thread::sleep(Duration::from_millis(500));
    killed.kill().expect("killed");
    killed.wait().expect("gone");
    let cells = PathBuf::from(text("other", ".cells"));
    assert!(cells.is_dir(), "it was killed too late to test anything");
    let name = cells.file_name().expect("a name").to_string_lossy().into_owned();
    let patience = Instant::now();
    while !processes_with(&name).is_empty() && patience.elapsed() < Duration::from_secs(5) {
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(processes_with(&name), [""; 0], "they go on without the grader");

    // Without --resume results are not mixed; with it the end is the same, and the cells of the killed one are gone.
    let refused = farop(&elsewhere, desk.path()).output().expect("farop starts");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--resume"));
    let again: Vec<&str> = elsewhere.iter().copied().chain(["--resume"]).collect();
    run(&again, desk.path());
    assert_eq!(["class.json", "grades.csv"].map(|file| text("other", file)), expected);
    assert!(!cells.exists());

    // Other points, with nothing there that could be run.
    std::fs::remove_dir_all(&places.class).expect("removed");
    std::fs::write(desk.path().join("rubric.toml"), "[points]\nties = 100\n").expect("written");
    run(&["grade", "zbuffer", "--class", "submissions", "--rescore", "rubric.toml"], desk.path());
    let (old, new): (Value, Value) =
        (serde_json::from_str(&expected[0]).expect("JSON"), json(desk.path().join("submissions.graded/class.json")));
    let points = |class: &Value, row: usize| class["submissions"][row]["points"].as_f64().expect("a number");
    assert_eq!((points(&new, 0) - points(&old, 0), points(&new, 1)), (90.0, 0.0));
    std::fs::write(desk.path().join("own.toml"), "[points]\nties = 10\n").expect("written");
    run(&["grade", "zbuffer", "--class", "submissions", "--rescore", "own.toml"], desk.path());
    assert_eq!(["class.json", "grades.csv"].map(|file| text("submissions.graded", file)), expected);
}

#[test]
fn functions_are_asked_across_the_border() {
    let desk = tempfile::tempdir().expect("a folder");
    if !is_held(desk.path()) {
        return;
    }
    let class = desk.path().join("class");
    let right = "use farop::math::Vec3;\npub fn triangulate(outline: &[Vec3], normal: Vec3) -> Vec<[u32; 3]> {\n    \
                 println!(\"debugging\");\n    farop::raster::functions::ears(outline, normal)\n}\n";
    let wrong = right
        .replace("farop::raster::functions::ears(outline, normal)", "let _ = normal; panic!(\"{}\", outline.len())");
    for (name, text) in [("lab-triangulate-ana", right), ("lab-triangulate-rui", &wrong)] {
        std::fs::create_dir_all(class.join(name)).expect("made");
        std::fs::write(class.join(name).join("my_triangulate.rs"), text).expect("written");
    }
    run(&["grade", "triangulate", "--class", "class", "--jobs", "2"], desk.path());
    let graded = json(desk.path().join("class.graded/class.json"));
    let rows = &graded["submissions"];
    assert_eq!([&rows[0]["name"], &rows[1]["name"]], ["ana", "rui"]);
    assert_eq!((&rows[0]["passed"], &rows[1]["points"]), (&true.into(), &0.0.into()));
    let verdict = json(desk.path().join("class.graded").join(rows[1]["verdict"].as_str().expect("a path")));
    let said = verdict["aspects"][0]["text"].to_string();
    assert!(said.contains("panicked at my_triangulate.rs:"), "{said}");
}
