//! Runs the real `farop` in an empty folder of its own, and says what came of it.

#![allow(dead_code, reason = "every test binary uses a part")]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use tempfile::TempDir;

/// A triangle that fills most of an 8 x 8 picture; tests replace parts of it.
pub const TRIANGLE: &str = "b 0.2 0.3 0.4\nv\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 8 8\n\
                            l 3 4 6\nf 0.9 0.2 0.1 0.9 0 0 0 1\np 3\n-1.6 -1.4 0\n1.2 -1.4 0\n-0.4 1.5 0\n";

/// A folder that commands run in; gone with its files at the end of the test.
pub struct Desk {
    folder: TempDir,
}

/// What a command left: exit code, standard output, standard error.
pub struct Outcome {
    pub code: i32,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

impl Desk {
    pub fn new() -> Desk {
        Desk { folder: tempfile::tempdir().expect("a temporary folder") }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), text).expect("the folder is writable");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Names of everything in the folder, hidden entries too.
    pub fn entries(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder is readable");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_farop"));
        command.args(arguments.split_whitespace()).current_dir(self.folder.path());
        command.env("NO_COLOR", "1").env("COLUMNS", "80");
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Runs `farop` with arguments that have no blanks in them.
    pub fn run(&self, arguments: &str) -> Outcome {
        self.run_with_input(arguments, |_| ())
    }

    /// Runs `farop` and writes its standard input; a program that stops reading is no error here.
    pub fn run_with_input(&self, arguments: &str, input: impl FnOnce(&mut dyn Write) + Send) -> Outcome {
        let mut child = self.command(arguments).spawn().expect("the program starts");
        let mut stdin = child.stdin.take().expect("it is piped");
        let output = std::thread::scope(|scope| {
            scope.spawn(move || input(&mut stdin));
            child.wait_with_output().expect("the program ends")
        });
        let stderr = String::from_utf8(output.stderr).expect("messages are text").replace('\r', "");
        let code = output.status.code().unwrap_or_else(|| panic!("{arguments}: ended by a signal\n{stderr}"));
        Outcome { code, stdout: output.stdout, stderr }
    }

    /// Runs `farop` and expects exit code 0.
    pub fn done(&self, arguments: &str) -> Outcome {
        let outcome = self.run(arguments);
        assert_eq!(outcome.code, 0, "farop {arguments}\n{}", outcome.stderr);
        outcome
    }

    /// The file `name` written by `farop ARGUMENTS -o name`.
    pub fn made(&self, arguments: &str, name: &str) -> Vec<u8> {
        self.done(&format!("{arguments} -o {name}"));
        self.read(name)
    }
}

impl Outcome {
    pub fn text(&self) -> &str {
        std::str::from_utf8(&self.stdout).expect("standard output is text")
    }
}

/// A scene of the project, as an argument.
pub fn project_scene(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name).display().to_string()
}
