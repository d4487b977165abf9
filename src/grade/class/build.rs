//! Build: from copied files to something that draws; compilers run in the jail.
//!
//! files -BUILD-> program or library in the cell, or why there is none
//!
//! Why a Rust submission is compiled by `rustc` alone: cargo would run its build script and its macros, which are programs. `rustc` runs none
//! of the student's code; it reads files (`include_str!`), which is why it is in the jail, too. The library it is compiled against is the one
//! this program was built with, found beside it.

use super::{Class, Sandbox, collect};
use crate::raster::external::{self, ExternalFailure};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// What compiles submissions.
#[derive(Clone, Debug)]
pub struct Tools {
    rust: Result<Rust, String>,
}

#[derive(Clone, Debug)]
struct Rust {
    /// The tool chain's folder.
    sysroot: PathBuf,
    /// The folder with `libfarop.rlib` and `deps`.
    library: PathBuf,
    /// The library itself.
    farop: PathBuf,
}

impl Tools {
    /// Looks for `rustc` and for the library that this program was built with: in `library`, or beside the program.
    #[must_use]
    pub fn find(library: Option<&Path>) -> Tools {
        Tools { rust: find_rust(library) }
    }

    /// Why no Rust submission can be compiled, if none can.
    #[must_use]
    pub fn trouble(&self) -> Option<&str> {
        self.rust.as_ref().err().map(String::as_str)
    }
}

fn find_rust(library: Option<&Path>) -> Result<Rust, String> {
    let program = std::env::current_exe().unwrap_or_default();
    // `cargo build` puts the library beside the program, `cargo test` only into `deps`.
    let has_library = |folder: &Path| newest(folder).is_some_and(|library| library.is_file());
    let folder = match library {
        Some(named) => Some(named).filter(|named| has_library(named)),
        None => program.ancestors().skip(1).take(3).find(|folder| has_library(folder)),
    };
    let Some(folder) = folder else {
        return Err(format!(
            "Rust submissions are compiled against libfarop.rlib and the folder deps beside it, and {} has none\n\
             help: run `cargo build` in the folder that farop was cloned into and grade with that program (target/debug/farop), \
             or name the folder with --library",
            library.or(program.parent()).unwrap_or(&program).display()
        ));
    };
    let asked = std::process::Command::new("rustc").args(["--print", "sysroot"]).output();
    let sysroot = asked.ok().filter(|output| output.status.success());
    let sysroot = sysroot.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_string());
    let Some(sysroot) = sysroot.map(PathBuf::from).filter(|sysroot| sysroot.join("bin/rustc").is_file()) else {
        return Err(
            "Rust submissions need `rustc`, and none can be started\nhelp: install the tool chain that farop was \
                    built with, and have it in PATH"
                .to_string(),
        );
    };
    let library = folder.canonicalize().map_err(|error| format!("{}: {error}", folder.display()))?;
    let farop = newest(&library).unwrap_or_else(|| library.join("libfarop.rlib"));
    Ok(Rust { sysroot, library, farop })
}

/// The library that was built last: cargo gives only some builds the short name.
fn newest(library: &Path) -> Option<PathBuf> {
    let inside = std::fs::read_dir(library.join("deps")).ok()?.flatten().map(|entry| entry.path());
    let is_farop = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        name.starts_with("libfarop-") && name.ends_with(".rlib")
    };
    let all = inside.filter(is_farop).chain([library.join("libfarop.rlib")]);
    all.max_by_key(|path| path.metadata().and_then(|about| about.modified()).ok())
}

/// Something that draws.
#[derive(Clone, Debug)]
pub(super) enum Built {
    /// A Rust submission behind [`crate::grade::harness`].
    Rust(PathBuf),
    /// A clip or triangulation behind [`crate::grade::remote`].
    Function(PathBuf),
    /// A shared library with `farop_draw`.
    Library(PathBuf),
    /// A program and its arguments.
    Program(Vec<OsString>, &'static str),
}

impl Built {
    /// What stands for the door of a submission without one.
    pub const NO_DOOR: &'static str = "";

    pub fn door(&self) -> &'static str {
        match self {
            Built::Rust(_) | Built::Function(_) => "rust",
            Built::Library(_) => "c library",
            Built::Program(_, door) => door,
        }
    }
}

/// Why nothing draws.
pub(super) enum NotBuilt {
    /// There is nothing that could.
    Nothing(String),
    /// What the compiler says, or that it was stopped.
    Refused(String),
}

/// What is made in a cell, beside the student's files.
const MAIN: &str = "__graded.rs";
const PROGRAM: &str = "__graded";

/// Makes of `files`, which lie in `cell`, what can be run; the first of these that fits.
pub(super) fn build(files: &[String], cell: &Path, class: &Class<'_>) -> Result<Built, NotBuilt> {
    let text = |name: &str| text_of(cell, name);
    let ending = |ending: &'static str| files.iter().filter(move |name| name.ends_with(ending));
    let (own, lab) = (format!("my_{}.rs", class.lab.name), class.lab.name);
    let is_own = |name: &&String| name.rsplit('/').next() == Some(&own);
    let is_function = class.is_about_function();
    let rust = ending(".rs")
        .find(is_own)
        .or_else(|| ending(".rs").find(|name| !is_function && rasterizer_in(&text(name), lab).is_some()));
    if let Some(name) = rust {
        return build_rust(name, &text(name), cell, class);
    }
    if is_function {
        return Err(NotBuilt::Nothing(format!("There is no {own}: the function `{lab}` is expected in it.")));
    }
    build_other(files, cell, class)
}

/// In any other language.
fn build_other(files: &[String], cell: &Path, class: &Class<'_>) -> Result<Built, NotBuilt> {
    let ending = |ending: &'static str| files.iter().filter(move |name| name.ends_with(ending));
    for (kind, compiler) in [(".c", "cc"), (".cpp", "c++")] {
        let sources: Vec<&String> = ending(kind).collect();
        if sources.is_empty() {
            continue;
        }
        let texts: Vec<String> = sources.iter().map(|name| text_of(cell, name)).collect();
        let is_library =
            texts.iter().any(|text| text.contains("farop_draw")) && !texts.iter().any(|text| has_main(text));
        return build_c((&sources, compiler, is_library), cell, class.sandbox);
    }
    let lab = class.lab.name;
    if let Some(name) = ending(".py").find(|name| name.contains(lab)).or_else(|| ending(".py").next()) {
        return Ok(Built::Program(vec!["python3".into(), "-B".into(), cell.join(name).into()], "python"));
    }
    if let Some(name) = files.iter().find(|name| is_executable(&cell.join(name))) {
        return Ok(Built::Program(vec![cell.join(name).into()], "program"));
    }
    let seen = if files.is_empty() { "it is empty".to_string() } else { format!("there is {}", files.join(", ")) };
    Err(NotBuilt::Nothing(format!(
        "There is nothing to run: a my_{lab}.rs, a .c, .cpp or .py file, or an executable is expected; {seen}."
    )))
}

fn text_of(cell: &Path, name: &str) -> String {
    String::from_utf8_lossy(&std::fs::read(cell.join(name)).unwrap_or_default()).into_owned()
}

fn has_main(text: &str) -> bool {
    text.split("main").skip(1).any(|rest| rest.trim_start().starts_with('('))
}

#[cfg(unix)]
fn is_executable(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    std::fs::metadata(path).is_ok_and(|about| about.is_file() && about.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_executable(_: &Path) -> bool {
    false
}

/// The expression that makes the rasterizer of a Rust file, without its module: the one named after the lab, or the first.
fn rasterizer_in(text: &str, lab: &str) -> Option<String> {
    let code: Vec<&str> = text.lines().map(str::trim).filter(|line| !line.starts_with("//")).collect();
    let letters = |rest: &str| rest.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect();
    let implemented = |line: &&str| {
        let (front, rest) = line.split_once("Rasterizer for ")?;
        let (name, is_each): (String, bool) = (letters(rest), front.ends_with("Polygon"));
        (front.starts_with("impl") && !name.is_empty()).then_some((name, is_each))
    };
    let all: Vec<(String, bool)> = code.iter().filter_map(implemented).collect();
    let named = |(name, _): &&(String, bool)| name.to_lowercase() == format!("my{lab}");
    let (name, is_each) = all.iter().find(named).or(all.first())?;
    let is_unit = code.iter().any(|line| line.ends_with(&format!("struct {name};")));
    let value = if is_unit { format!("graded::{name}") } else { format!("<graded::{name} as Default>::default()") };
    Some(if *is_each { format!("farop::raster::PerPolygon({value})") } else { value })
}

fn build_rust(name: &str, text: &str, cell: &Path, class: &Class<'_>) -> Result<Built, NotBuilt> {
    let rust = class.tools.rust.as_ref().map_err(|words| NotBuilt::Refused(words.clone()))?;
    let lab = class.lab.name;
    let serve = match rasterizer_in(text, lab) {
        _ if class.is_about_function() => format!("remote::serve_{lab}(&graded::{lab})"),
        Some(rasterizer) => format!("harness::serve(&{rasterizer})"),
        None => {
            return Err(NotBuilt::Nothing(format!(
                "{name} has no line `impl PolygonRasterizer for NAME` or `impl Rasterizer for NAME`: there is nothing to draw with."
            )));
        }
    };
    let main = format!(
        "#[path = {name:?}]\nmod graded;\npub use farop::grade::harness::reach;\n\
         fn main() -> std::process::ExitCode {{\n    farop::grade::{serve}\n}}\n"
    );
    put(cell, MAIN, &main)?;
    let program = cell.join(PROGRAM);
    let deps = format!("dependency={}", rust.library.join("deps").display());
    let farop = format!("farop={}", rust.farop.display());
    let mut words: Vec<OsString> =
        vec![rust.sysroot.join("bin/rustc").into(), "--sysroot".into(), rust.sysroot.clone().into()];
    let options = ["--edition=2024", "--crate-name=graded", "--cap-lints=allow", "--color=never", "-Copt-level=1"];
    words.extend(options.map(OsString::from));
    words.extend(["-Cstrip=debuginfo", "-L", &deps, "--extern", &farop, MAIN, "-o"].map(OsString::from));
    words.push(program.clone().into());
    if class.sandbox.user().is_some() && cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        // The tool chain's own linker is looked for where the compiler lies, which this user may not see.
        words.push("-Clinker-features=-lld".into());
    }
    compile(&words, cell, class.sandbox, vec![rust.sysroot.clone(), rust.library.clone()])?;
    Ok(if class.is_about_function() { Built::Function(program) } else { Built::Rust(program) })
}

fn build_c(
    (sources, compiler, is_library): (&[&String], &str, bool),
    cell: &Path,
    sandbox: &Sandbox,
) -> Result<Built, NotBuilt> {
    if !cell.join("farop.h").exists() {
        put(cell, "farop.h", include_str!("../../../student_rasterizers/other_languages/c/farop.h"))?;
    }
    let program = cell.join(if is_library { "__graded.so" } else { PROGRAM });
    let standard = if compiler == "cc" { "-std=gnu11" } else { "-std=gnu++17" };
    let mut words: Vec<OsString> =
        [compiler, "-O2", standard, "-ffp-contract=off", "-pipe", "-I."].map(OsString::from).to_vec();
    words.extend(is_library.then_some(["-shared", "-fPIC"]).into_iter().flatten().map(OsString::from));
    words.extend([OsString::from("-o"), program.clone().into()]);
    // A name may begin with a dash: it is a file all the same.
    words.extend(sources.iter().map(|name| OsString::from(format!("./{name}"))));
    words.push("-lm".into());
    compile(&words, cell, sandbox, Vec::new())?;
    let language = if compiler == "cc" { "c program" } else { "c++ program" };
    Ok(if is_library { Built::Library(program) } else { Built::Program(vec![program.into()], language) })
}

fn put(cell: &Path, name: &str, text: &str) -> Result<(), NotBuilt> {
    collect::put(cell, name, text).map_err(|error| NotBuilt::Refused(format!("{name} cannot be written: {error}")))
}

fn compile(words: &[OsString], cell: &Path, sandbox: &Sandbox, lent: Vec<PathBuf>) -> Result<(), NotBuilt> {
    let run =
        external::run(words, &sandbox.build(cell, lent)).map_err(|failure| NotBuilt::Refused(failure.to_string()))?;
    match run.failure {
        None => Ok(()),
        Some(ExternalFailure::Exited { .. }) => {
            // The name of a cell is chance, and two runs must say the same.
            let said = run.stderr.replace(&format!("{}/", cell.display()), "");
            Err(NotBuilt::Refused(format!("It does not compile.\n{}", shown(&said))))
        }
        Some(failure) => Err(NotBuilt::Refused(format!("The compiler was stopped: {failure}"))),
    }
}

/// The beginning of what a compiler said, without the words of the linker's whole command.
fn shown(stderr: &str) -> String {
    let plain = |letter: &char| !letter.is_control() || matches!(letter, '\n' | '\t');
    let lines = stderr.lines().filter(|line| line.len() < 400).take(30);
    lines.flat_map(|line| ["  ", line, "\n"]).flat_map(str::chars).filter(plain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rasterizer_is_found_by_its_name() {
        let text = "// impl Rasterizer for Comment\npub struct MyZBuffer;\nimpl Other for X {}\nimpl PolygonRasterizer for Helper {\n\
                    impl farop::raster::PolygonRasterizer for MyZBuffer {";
        assert_eq!(rasterizer_in(text, "zbuffer").as_deref(), Some("farop::raster::PerPolygon(graded::MyZBuffer)"));
        let text = "#[derive(Default)]\nstruct Mine { n: u8 }\nimpl Rasterizer for Mine {";
        assert_eq!(rasterizer_in(text, "watkins").as_deref(), Some("<graded::Mine as Default>::default()"));
        assert_eq!(rasterizer_in("fn main() {}", "zbuffer"), None);
    }

    #[test]
    fn a_main_is_a_function() {
        assert!(has_main("int main (void)") && !has_main("int domain;"));
    }
}
