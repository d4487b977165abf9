//! A class of submissions to lab zbuffer, good ones and those that a grader must survive, with what each of them is worth.
//!
//! Every attack is built around a right z-buffer where that makes sense: then the right grade is all points, with the attack refused.

#![allow(dead_code, reason = "a test and an example use a part each")]

use std::fs;
use std::path::{Path, PathBuf};

const RUST: &str = include_str!("../../student_rasterizers/src/solved_example.rs");
const SKELETON: &str = include_str!("../../student_rasterizers/src/my_zbuffer.rs");
const PYTHON: &str = include_str!("../../student_rasterizers/other_languages/python/zbuffer.py");
const C: &str = include_str!("../../student_rasterizers/other_languages/c/zbuffer.c");
const C_LIBRARY: &str = include_str!("../../student_rasterizers/other_languages/c/zbuffer_lib.c");

/// What a submission is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Worth {
    /// All points; in other languages but for glass, which the examples draw opaque.
    All,
    /// None, for this cause.
    None(&'static str),
    /// Something between, for this cause among others.
    Some(&'static str),
}

/// A kind of submission: its name, what it is worth, its files.
pub struct Kind {
    pub name: &'static str,
    pub worth: Worth,
    /// What the first aspect's report must have in it: an attack must fail for the reason that is tested.
    says: &'static str,
    files: Vec<(&'static str, String)>,
}

/// Places that attacks know: `secret` is readable by everybody, `loot` writable by everybody.
pub struct Places {
    pub secret: PathBuf,
    pub header: PathBuf,
    pub loot: PathBuf,
    pub class: PathBuf,
    pub results: PathBuf,
}

impl Places {
    /// In `root`, which everybody may pass.
    pub fn new(root: &Path) -> Places {
        let places = Places {
            secret: root.join("secret.py"),
            header: root.join("secret.h"),
            loot: root.join("loot"),
            class: root.join("submissions"),
            results: root.join("submissions.graded"),
        };
        fs::create_dir_all(&places.loot).expect("made");
        fs::create_dir_all(&places.class).expect("made");
        fs::write(&places.secret, PYTHON).expect("written");
        fs::write(&places.header, "enum { SECRET = 1 };\n").expect("written");
        #[cfg(unix)]
        for (path, mode) in [(root, 0o755), (&places.loot, 0o777), (&places.secret, 0o644), (&places.header, 0o644)] {
            use std::os::unix::fs::PermissionsExt;
            fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("own file");
        }
        places
    }

    /// Files that attacks left.
    pub fn left_behind(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.loot).expect("readable");
        entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
    }
}

/// Python that tries `attack` first, and draws rightly whatever came of it.
fn python(attack: &str) -> String {
    let tried: String = attack.lines().map(|line| format!("    {line}\n")).collect();
    format!("import os, sys\ntry:\n{tried}except BaseException as error:\n    print(error, file=sys.stderr)\n{PYTHON}")
}

/// Rust that does `attack` at every polygon, and draws rightly.
fn rust(attack: &str) -> String {
    RUST.replace("        let reach = ", &format!("        {attack}\n        let reach = "))
}

fn one(name: &'static str, worth: Worth, file: &'static str, text: String) -> Kind {
    Kind { name, worth, says: "", files: vec![(file, text)] }
}

fn says(says: &'static str, kind: Kind) -> Kind {
    Kind { says, ..kind }
}

/// Submissions that do what students do.
pub fn ordinary() -> Vec<Kind> {
    let corners = PYTHON.replace("row + 0.5", "row").replace("column - 0.5 - x", "column - 1 - x");
    let corners = corners.replace("column + 0.5 - x", "column - x").replace("dx / dy - 0.5", "dx / dy");
    let last = RUST.replace(" && polygon.depth(x, y) > target.depth(x, y)", "");
    let program = vec![("zbuffer.c", C.to_string()), ("zbuffer_lib.c", C_LIBRARY.to_string())];
    vec![
        one("right_python", Worth::All, "zbuffer.py", PYTHON.to_string()),
        one("right_rust", Worth::All, "my_zbuffer.rs", RUST.to_string()),
        one("right_library", Worth::All, "zbuffer.c", C_LIBRARY.to_string()),
        Kind { name: "right_c", worth: Worth::All, says: "", files: program },
        one("skeleton", Worth::Some(""), "my_zbuffer.rs", SKELETON.to_string()),
        one("corners", Worth::Some("samples at the corner"), "zbuffer.py", corners),
        one("last", Worth::Some(""), "my_zbuffer.rs", last),
        one("misspelled", Worth::None("does not compile"), "my_zbuffer.rs", RUST.replace("fold(", "folded(")),
        one("typo", Worth::None("exit-code"), "zbuffer.py", PYTHON.replace("def draw", "deff draw")),
        one(
            "panics",
            Worth::None("exit-code"),
            "my_zbuffer.rs",
            rust("let none: Vec<i32> = Vec::new(); let _ = none[x_of(polygon)];")
                + "\nfn x_of(polygon: &ScreenPolygon<'_>) -> usize { polygon.vertices().len() }\n",
        ),
        one("empty", Worth::None("nothing to run"), "notes.txt", "I was ill.".to_string()),
        one("new\nline", Worth::All, "zbuf\nfer.py", PYTHON.to_string()),
    ]
}

/// Submissions that hang, crash, flood, start things, and cheat.
pub fn unruly(places: &Places) -> Vec<Kind> {
    let Places { secret, header, loot, class, results } = places;
    let [secret, header, loot] = [secret, header, loot].map(|path| path.display().to_string());
    let neighbor = class.join("000_right_python/zbuffer.py").display().to_string();
    let forged = "import os, sys, json\nreport = json.dumps({'score': 125, 'points': 125.0, 'passed': True})\n";
    let forge = format!(
        "{forged}for place in ['../verdict.json', '{0}/class.json', '{0}/submissions/999/verdict.json', '{loot}/verdict.json']:\n    \
         try: open(place, 'w').write(report)\n    except OSError: pass\nprint(report)\n",
        results.display()
    );
    let read = |path: &str| format!("exec(open({path:?}).read())\n");
    let refused = Worth::None("does not compile");
    let build_script = format!("fn main() {{ std::fs::write(\"{loot}/build_script\", \"x\").unwrap(); }}");
    vec![
        one("hangs", Worth::None("time-out"), "zbuffer.py", "while True: pass\n".to_string()),
        one("hangs_rust", Worth::None("time-out"), "my_zbuffer.rs", rust("loop { std::hint::spin_loop(); }")),
        one(
            "sleeps",
            Worth::None("time-out"),
            "zbuffer.c",
            "#include <unistd.h>\nint main() { for (;;) pause(); }".to_string(),
        ),
        one("crashes", Worth::None("crash"), "zbuffer.c", "int main() { *(volatile int *)8 = 1; }".to_string()),
        one(
            "floods_stdout",
            Worth::None("too-much-output"),
            "zbuffer.py",
            "import sys\nwhile True: sys.stdout.write('x' * 65536)\n".to_string(),
        ),
        one("floods_stderr", Worth::All, "zbuffer.py", python("for _ in range(64): sys.stderr.write('x' * 65536)")),
        one(
            "floods_memory",
            Worth::None("memory"),
            "zbuffer.py",
            "kept = []\nwhile True: kept.append(bytearray(1 << 27))\n".to_string(),
        ),
        one(
            "floods_disk",
            Worth::All,
            "zbuffer.py",
            python(&format!(
                "for place in ['.', '/tmp', '/dev/shm', '/var/tmp', {loot:?}]:\n    try:\n        with open(place + '/big', 'wb') as out:\n            \
             for _ in range(4096): out.write(b'x' * (1 << 20))\n    except OSError: pass"
            )),
        ),
        one("forks", Worth::All, "zbuffer.py", python("while True: os.fork()")),
        one(
            "daemon",
            Worth::All,
            "zbuffer.py",
            python(&format!(
                "if os.fork() == 0:\n    os.setsid()\n    import time\n    while True: time.sleep(0.1); open('{loot}/daemon', 'a').write('x')"
            )),
        ),
        one(
            "starts_rust",
            Worth::All,
            "my_zbuffer.rs",
            rust("let _ = std::process::Command::new(\"/bin/sleep\").arg(\"1000\").spawn();"),
        ),
        one("forges", Worth::None("bad-picture"), "zbuffer.py", forge),
        one("prints_report", Worth::All, "my_zbuffer.rs", rust("println!(\"{{\\\"score\\\": 125}}\");")),
        one(
            "leaves_early",
            Worth::None("no-output"),
            "my_zbuffer.rs",
            rust("if polygon.vertices().len() < 99 { std::process::exit(0) }"),
        ),
        says("PermissionError", one("reads_secret", Worth::None("exit-code"), "zbuffer.py", read(&secret))),
        says("PermissionError", one("reads_neighbor", Worth::None("exit-code"), "zbuffer.py", read(&neighbor))),
        one(
            "socket",
            Worth::All,
            "zbuffer.py",
            python(&format!(
                "import socket\nsocket.socket(socket.AF_UNIX).bind('{loot}/socket')\nsocket.create_connection(('127.0.0.1', 22))"
            )),
        ),
        one("kills_parent", Worth::All, "zbuffer.py", python("os.kill(os.getppid(), 9)\nos.kill(-1, 9)")),
        says(
            "couldn't read",
            one("includes", refused, "my_zbuffer.rs", format!("{RUST}\nconst S: &str = include_str!({secret:?});\n")),
        ),
        says("Permission denied", one("includes_c", refused, "zbuffer.c", format!("#include {header:?}\n{C_LIBRARY}"))),
        says(
            "secret.py",
            one("embeds_c", refused, "zbuffer.c", format!("__asm__(\".incbin \\\"{secret}\\\"\");\n{C_LIBRARY}")),
        ),
        Kind {
            name: "build_script",
            worth: Worth::All,
            says: "",
            files: vec![
                ("my_zbuffer.rs", RUST.to_string()),
                ("build.rs", build_script),
                ("Cargo.toml", "[package]\nname = \"x\"\nversion = \"1.0.0\"\nbuild = \"build.rs\"\n".to_string()),
            ],
        },
        // The link is made by `write`.
        Kind { name: "link", worth: Worth::None("nothing to run"), says: "it is empty", files: Vec::new() },
    ]
}

/// Writes submission `number` of that kind into the class; the name of its folder.
pub fn write(kind: &Kind, number: usize, places: &Places) -> String {
    let name = format!("{number:03}_{}", kind.name);
    let folder = places.class.join(&name);
    fs::create_dir_all(&folder).expect("made");
    for (file, text) in &kind.files {
        fs::write(folder.join(file), text).expect("written");
    }
    #[cfg(unix)]
    if kind.name == "link" {
        std::os::unix::fs::symlink(&places.secret, folder.join("zbuffer.py")).expect("linked");
    }
    name
}

/// What is wrong with a grade, if anything: a row of `class.json`, and the verdict it names.
pub fn complaint(kind: &Kind, row: &serde_json::Value, places: &Places) -> Option<String> {
    let (points, most) = (row["points"].as_f64().unwrap_or(-1.0), row["most"].as_f64().unwrap_or(-1.0));
    let causes: Vec<&str> = row["causes"].as_array().into_iter().flatten().filter_map(|cause| cause.as_str()).collect();
    let is_opaque = row["door"] != "rust" && causes == ["transparency ignored"] && points == most - 5.0;
    let is_right = match kind.worth {
        Worth::All => (points == most && causes.is_empty()) || is_opaque,
        Worth::None(cause) => points == 0.0 && causes.contains(&cause),
        Worth::Some(cause) => points > 0.0 && points < most && (cause.is_empty() || causes.contains(&cause)),
    };
    let verdict = fs::read(places.results.join(row["verdict"].as_str().unwrap_or_default())).unwrap_or_default();
    let verdict: serde_json::Value = serde_json::from_slice(&verdict).unwrap_or_default();
    let said = verdict["aspects"][0]["text"].as_str().unwrap_or_default();
    if !said.contains(kind.says) {
        return Some(format!("{}: the report says {said:?}, not {:?}", kind.name, kind.says));
    }
    (!is_right).then(|| format!("{}: {:?} expected, {points} of {most} for {causes:?}", kind.name, kind.worth))
}
