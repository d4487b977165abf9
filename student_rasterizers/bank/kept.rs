//! A program of the bank, kept running: v2 screen files in, P6 pictures out, one after another.
//!
//! Why not the door `exec:`, which starts a program anew for every picture: a grade draws some hundred, and Python alone needs a
//! second for twenty starts. `tests/bank_doors.rs` checks that the doors come to the same verdict.

use super::judge::Entry;
use farop::color::Encoding;
use farop::grade::Subject;
use farop::grade::subject::{Answer, Failure};
use farop::image::{Picture, decode};
use farop::screen::DrawList;
use farop::screen::file::{Attributes, Sheet, write_v2};
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A running program.
pub struct Kept {
    words: Vec<OsString>,
    child: RefCell<Child>,
    pipes: RefCell<Pipes>,
}

impl Kept {
    /// Starts a command.
    pub fn start(words: &[OsString]) -> Result<Kept, String> {
        let (child, pipes) = spawn(words)?;
        Ok(Kept { words: words.to_vec(), child: RefCell::new(child), pipes: RefCell::new(pipes) })
    }

    /// Starts it again: one picture that it crashed over must not spoil the next.
    fn start_again(&self) {
        if let Ok((child, pipes)) = spawn(&self.words) {
            *self.pipes.borrow_mut() = pipes;
            let _ = self.child.replace(child).wait();
        }
    }

    fn ask(&self, text: &[u8]) -> std::io::Result<Vec<u8>> {
        let (input, output) = &mut *self.pipes.borrow_mut();
        input.write_all(text)?;
        input.flush()?;
        let mut ppm = Vec::new();
        for _ in 0..3 {
            output.read_until(b'\n', &mut ppm)?;
        }
        let head = String::from_utf8_lossy(&ppm).into_owned();
        let numbers: Vec<usize> = head.split_whitespace().skip(1).filter_map(|word| word.parse().ok()).collect();
        let [width, height, _] = numbers[..] else { return Err(std::io::Error::other("no head of a P6")) };
        let start = ppm.len();
        ppm.resize(start + width * height * 3, 0);
        output.read_exact(&mut ppm[start..])?;
        Ok(ppm)
    }
}

type Pipes = (ChildStdin, BufReader<ChildStdout>);

fn spawn(words: &[OsString]) -> Result<(Child, Pipes), String> {
    let (program, arguments) = words.split_first().ok_or("an empty command")?;
    let started = Command::new(program).args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
    let mut child = started.map_err(|error| format!("{}: {error}", program.display()))?;
    let (input, output) = (child.stdin.take().ok_or("no input")?, child.stdout.take().ok_or("no output")?);
    Ok((child, (input, BufReader::new(output))))
}

impl Drop for Kept {
    fn drop(&mut self) {
        let child = &mut *self.child.borrow_mut();
        let _ = child.kill();
        let _ = child.wait();
    }
}

impl Subject for Kept {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let failure = |message: String| Failure { message, hint: String::new() };
        let mut text = Vec::new();
        let sheet = Sheet { encoding: Encoding::Linear, ..*sheet };
        write_v2(list, &sheet, Attributes::default(), &mut text).map_err(|error| failure(error.to_string()))?;
        let answer = self.ask(&text);
        if answer.is_err() {
            self.start_again();
        }
        let ppm = answer.map_err(|error| failure(format!("the program: {error}")))?;
        let picture = decode(&ppm).map_err(|error| failure(error.to_string()))?;
        let is_samples = sheet.samples > 1 && picture.width() == list.width as usize;
        let picture = if is_samples { mean(&picture, sheet.samples as usize) } else { Ok(picture) };
        Ok(Answer { picture: picture.map_err(failure)?, puts: None })
    }
}

/// The mean of a x a samples, for programs that leave that to farop.
fn mean(samples: &Picture, a: usize) -> Result<Picture, String> {
    let (width, height) = (samples.width() / a, samples.height() / a);
    let level = |x: usize, y: usize, channel: usize| {
        let sum: usize = (0..a * a).map(|n| usize::from(samples.pixel(x * a + n % a, y * a + n / a)[channel])).sum();
        ((sum + a * a / 2) / (a * a)) as u8
    };
    let rgb = (0..width * height * 3).map(|at| level(at / 3 % width, at / 3 / width, at % 3)).collect();
    Picture::from_rgb(width, height, rgb).map_err(|error| error.to_string())
}

/// The folder of the bank.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("student_rasterizers/bank")
}

/// Whether a program answers to `--version`.
pub fn is_there(program: &str) -> bool {
    let quiet = Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    quiet.is_ok_and(|status| status.success())
}

/// Compiles a C source of the bank with a slip into `into`; the program's path.
pub fn compile(source: &str, slip: &str, into: &Path) -> Result<PathBuf, String> {
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    // A number, because two threads may build the same one.
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    build(source, slip, &into.join(format!("{source}-{slip}-{number}")), &[])
}

/// The same as a shared library.
#[allow(dead_code, reason = "only the test of the doors builds libraries")]
pub fn compile_library(source: &str, slip: &str, into: &Path) -> Result<PathBuf, String> {
    build(source, slip, &into.join(format!("{source}-{slip}.so")), &["-shared", "-fPIC", "-DLIBRARY"])
}

fn build(source: &str, slip: &str, program: &Path, flags: &[&str]) -> Result<PathBuf, String> {
    build_file(&folder().join("c").join(format!("{source}.c")), slip, program, flags)
}

fn build_file(file: &Path, slip: &str, program: &Path, flags: &[&str]) -> Result<PathBuf, String> {
    let mut cc = Command::new("cc");
    cc.args(["-O1", "-std=c11", "-ffp-contract=off"]).args(flags).arg(format!("-DSLIP_{slip}"));
    cc.arg("-I").arg(folder().join("../other_languages/c")).arg("-o").arg(program).arg(file).arg("-lm");
    done(&mut cc, file).map(|()| program.to_path_buf())
}

/// Runs a compiler to its end.
fn done(compiler: &mut Command, file: &Path) -> Result<(), String> {
    let run = compiler.output().map_err(|error| format!("{}: {error}", compiler.get_program().display()))?;
    if run.status.success() {
        return Ok(());
    }
    Err(format!("{}: {}", file.display(), String::from_utf8_lossy(&run.stderr)))
}

/// How a program of a set with a folder of its own is started; what has to be built is built into `into`. Those in Rust are programs of their
/// own, too.
pub fn held_command(entry: &Entry, into: &Path) -> Result<Vec<OsString>, String> {
    let (source, slip) = (&entry.source, &entry.slip);
    let file = |ending: &str| {
        folder().join(entry.set.unwrap_or("held")).join(&entry.language).join(format!("{source}.{ending}"))
    };
    let program = into.join(format!("{source}-{slip}-{}", entry.lab));
    match entry.language.as_str() {
        "rust" => {
            let mut rustc = Command::new("rustc");
            rustc.args(["--edition", "2024", "-O", "-o"]).arg(&program).arg(file("rs"));
            done(&mut rustc, &file("rs"))?;
            Ok(vec![program.into(), slip.into()])
        }
        "c" => Ok(vec![build_file(&file("c"), slip, &program, &[])?.into()]),
        _ => Ok(vec!["python3".into(), "-S".into(), "-B".into(), file("py").into(), slip.into()]),
    }
}
