//! Rasterizers outside farop: right ones draw the z-buffer's picture, wrong and hostile ones get a name, and farop goes on.
#![cfg(target_os = "linux")]

use farop::color::{Encoding, Rgb};
use farop::image::Picture;
use farop::plan::{Choices, Transparency};
use farop::raster::external::{Enforced, External, ExternalFailure, Limits, library_layout};
use farop::raster::{Rasterizer, ZBuffer};
use farop::render::{Canvas, draw, list};
use farop::screen::DrawList;
use farop::screen::file::Sheet;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

const EXAMPLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/student_rasterizers/other_languages");
const CANVAS: Canvas = Canvas { samples: 1, background: Rgb::gray(0.25), transparency: Transparency::Over, threads: 1 };

fn door(name: &str) -> External {
    External::from_name(name).expect("the name of a door").with_host(env!("CARGO_BIN_EXE_farop"))
}

/// Runs a tool; `None`, with a notice, where it is missing.
fn tool(program: &str, arguments: &[&str]) -> Option<Output> {
    match Command::new(program).args(arguments).output() {
        Ok(output) => Some(output),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            println!("notice: `{program}` is not installed, its door is not tested");
            None
        }
        Err(error) => panic!("{program}: {error}"),
    }
}

/// Builds; `None` where the compiler is missing.
fn build(program: &str, arguments: &[&str]) -> Option<()> {
    let output = tool(program, arguments)?;
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.is_empty(), "{program} {arguments:?}: {said}");
    Some(())
}

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).to_str().expect("a plain path").to_string()
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a place for files")
}

/// Ties, holes, shared edges, and a Gouraud scene with perspective.
fn lists() -> Vec<DrawList> {
    let mut flat = DrawList::new(24, 17);
    flat.push_flat(&[(0.5, 0.5), (20.5, 0.5), (20.5, 12.5), (0.5, 12.5)], 0.5, [1.0, 0.5, 0.25]);
    flat.push_flat(&[(4.5, 2.5), (24.0, 9.125), (10.25, 17.0), (12.0, 9.0)], 0.5, [0.1, 0.9, 0.7]);
    flat.push_flat(&[(10.25, 17.0), (24.0, 9.125), (24.0, 17.0)], 0.75, [0.2, 0.3, 0.501]);
    vec![flat, teapot(40)]
}

fn teapot(side: u32) -> DrawList {
    let text = farop::parse::built_in::text("teapot:3", farop::spd::Curves::Kept).expect("a built-in scene");
    let parsed = farop::parse::read_nff("teapot", &text, farop::parse::ParseOptions::default()).expect("it is right");
    let choices = Choices { size: Some((side, side)), encoding: Encoding::Linear, ..Choices::default() };
    list(&parsed.scene, &choices, None).expect("it has a view")
}

fn drawn_by(rasterizer: &dyn Rasterizer, list: &DrawList) -> Picture {
    let (image, puts) = draw(list, Some(rasterizer), &CANVAS);
    assert_eq!(puts.failure, None);
    image.encode(Encoding::Linear)
}

fn draws_like_the_zbuffer(door: &External) {
    for list in lists() {
        assert!(drawn_by(door, &list) == drawn_by(&ZBuffer, &list), "{} draws something else", door.name());
    }
}

#[test]
fn a_python_program_draws_the_same_picture() {
    if tool("python3", &["--version"]).is_some() {
        draws_like_the_zbuffer(&door(&format!("exec:python3 '{EXAMPLES}/python/zbuffer.py'")));
    }
}

#[test]
fn a_c_program_and_a_c_library_draw_the_same_picture() {
    let folder = folder();
    let (program, library) = (path(folder.path(), "zbuffer"), path(folder.path(), "zbuffer.so"));
    let [main, functions] = ["zbuffer.c", "zbuffer_lib.c"].map(|name| format!("{EXAMPLES}/c/{name}"));
    let flags = ["-O1", "-std=c11", "-Wall", "-Wextra", "-ffp-contract=off"];
    let program_arguments = [&flags[..], &["-o", &program, &main, &functions, "-lm"]].concat();
    if build("gcc", &program_arguments).is_none() {
        return;
    }
    build("gcc", &[&flags[..], &["-shared", "-fPIC", "-o", &library, &functions, "-lm"]].concat());
    draws_like_the_zbuffer(&door(&format!("exec:'{program}'")));
    draws_like_the_zbuffer(&door(&format!("lib:{library}")));
}

#[test]
fn a_cpp_library_draws_the_same_picture() {
    let folder = folder();
    let (library, source) = (path(folder.path(), "zbuffer.so"), format!("{EXAMPLES}/cpp/zbuffer.cpp"));
    let flags = ["-O1", "-std=c++17", "-Wall", "-Wextra", "-ffp-contract=off", "-shared", "-fPIC"];
    if build("g++", &[&flags[..], &["-o", &library, &source]].concat()).is_some() {
        draws_like_the_zbuffer(&door(&format!("lib:{library}")));
    }
}

#[test]
fn a_java_program_draws_the_same_picture() {
    let folder = folder();
    let classes = path(folder.path(), "classes");
    if build("javac", &["-d", &classes, &format!("{EXAMPLES}/java/ZBuffer.java")]).is_some() {
        let small = "-Xmx64m -XX:+UseSerialGC -XX:ReservedCodeCacheSize=32m -XX:CompressedClassSpaceSize=32m";
        draws_like_the_zbuffer(&door(&format!("exec:java {small} -cp '{classes}' ZBuffer")));
    }
}

#[test]
fn the_header_has_the_layout_of_the_host() {
    let folder = folder();
    let checks =
        library_layout().into_iter().map(|(what, value)| format!("_Static_assert({what} == {value}, \"{what}\");\n"));
    let text = format!(
        "#include <stddef.h>\n#include \"farop.h\"\n{}int main(void) {{ return 0; }}\n",
        checks.collect::<String>()
    );
    let source = path(folder.path(), "layout.c");
    std::fs::write(&source, text).expect("room for a file");
    build("gcc", &["-std=c11", "-fsyntax-only", &format!("-I{EXAMPLES}/c"), &source]);
}

const HEAD: &str =
    "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n#include <sys/socket.h>\n";

/// Builds a C program from the body of `main`, runs it with short limits; what came of it, and how long it took.
fn attack(body: &str) -> Option<Result<Picture, ExternalFailure>> {
    let folder = folder();
    let (source, program) = (path(folder.path(), "attack.c"), path(folder.path(), "attack"));
    std::fs::write(&source, format!("{HEAD}int main(void) {{ {body} }}\n")).expect("room for a file");
    build("gcc", &["-o", &program, &source])?;
    let limits = Limits { wall: Duration::from_secs(3), output: 1 << 20, memory: 256 << 20, ..Limits::default() };
    let started = Instant::now();
    let answer =
        door(&format!("exec:'{program}'")).with_limits(limits).picture(&DrawList::new(3, 2), &Sheet::default());
    assert!(started.elapsed() < Duration::from_secs(30), "{body} took {:?}", started.elapsed());
    assert_eq!(processes_with(&program), Vec::<PathBuf>::new(), "left over from {body}");
    Some(answer.map(|answer| answer.image.encode(Encoding::Linear)))
}

/// Processes whose command line has `word` in it.
fn processes_with(word: &str) -> Vec<PathBuf> {
    let alive = |path: &PathBuf| std::fs::read_to_string(path.join("cmdline")).is_ok_and(|line| line.contains(word));
    let all = std::fs::read_dir("/proc").expect("Linux").flatten().map(|entry| entry.path());
    all.filter(alive).collect()
}

fn is_named(expected: &str, body: &str) {
    let Some(answer) = attack(body) else { return };
    let failure = answer.expect_err(body);
    assert_eq!(failure.name(), expected, "{body}: {failure}");
}

/// Whether a protection is in force here; a notice where it is not: an old kernel, or a container.
fn is_enforced(what: &str, protected: impl Fn(Enforced) -> bool) -> bool {
    let answer = door("exec:printf 'P6 2 2 255             '").picture(&DrawList::new(2, 2), &Sheet::default());
    let enforced = answer.expect("a picture of blanks").enforced;
    if !protected(enforced) {
        println!("notice: {what} cannot be tested here: {enforced}");
    }
    protected(enforced)
}

#[test]
fn an_endless_loop_is_stopped() {
    is_named("time-out", "for (volatile int i = 0; ; i++);");
}

#[test]
fn a_null_write_is_a_crash_with_its_signal() {
    is_named("crash", "volatile int *nowhere = 0; *nowhere = 1; return 0;");
}

#[test]
fn memory_has_an_end() {
    is_named("memory", "char *p; while ((p = malloc(1 << 20))) memset(p, 1, 1 << 20); usleep(100000); abort();");
}

#[test]
fn a_flood_of_output_is_cut() {
    is_named("too-much-output", "for (;;) puts(\"and again\");");
}

#[test]
fn many_processes_are_ended_together() {
    // Bounded, so that a farop without limits would fail this test and nothing else.
    is_named("processes", "for (int i = 0; i < 40; i++) if (!fork()) { sleep(60); return 0; } sleep(60); return 0;");
}

#[test]
fn a_process_in_the_background_does_not_outlive_the_run() {
    let body =
        "if (!fork()) { setsid(); setpgid(0, 0); sleep(60); return 0; } printf(\"P6 3 2 255 %18s\", \"\"); return 0;";
    if let Some(answer) = attack(body) {
        assert_eq!(answer.expect("a picture").pixel(2, 1), [32; 3]);
    }
}

#[test]
fn files_cannot_be_written() {
    if !is_enforced("writing files", |enforced| enforced.files) {
        return;
    }
    let trace = std::env::temp_dir().join(format!("farop_doors_{}", std::process::id()));
    let body = format!(
        "FILE *f = fopen(\"{}\", \"w\"); if (!f) return 7; fputs(\"x\", f); fclose(f); return 0;",
        trace.display()
    );
    is_named("exit-code", &body);
    assert!(!trace.exists());
}

#[test]
fn there_is_no_network() {
    if is_enforced("the network", |enforced| enforced.network) {
        is_named("exit-code", "return socket(AF_INET, SOCK_STREAM, 0) < 0 ? 7 : 0;");
    }
}

#[test]
fn accidents_with_the_picture_have_names() {
    is_named("p3", "puts(\"P3 3 2 255\"); for (int i = 0; i < 18; i++) puts(\"1\"); return 0;");
    is_named("text-before-picture", "puts(\"3 polygons read\"); printf(\"P6 3 2 255 %18s\", \"\"); return 0;");
    is_named("swapped-size", "printf(\"P6 2 3 255 %18s\", \"\"); return 0;");
    is_named("too-short", "printf(\"P6 3 2 255 %7s\", \"\"); return 0;");
    is_named("no-output", "return 0;");
    is_named("exit-code", "fputs(\"IndexError: list index out of range\", stderr); return 1;");
}

#[test]
fn a_program_that_reads_nothing_does_not_block() {
    if tool("true", &[]).is_none() {
        return;
    }
    // More text than a pipe holds.
    let failure = door("exec:true").picture(&teapot(400), &Sheet::default()).expect_err("no picture");
    assert_eq!(failure.name(), "no-output");
}

#[test]
fn a_library_that_crashes_is_told_from_one_that_is_none() {
    let folder = folder();
    let (source, library) = (path(folder.path(), "bad.c"), path(folder.path(), "bad.so"));
    std::fs::write(&source, "void farop_draw(void *list, float *target) { (void)list; *(volatile int *)0 = 1; }")
        .expect("room for a file");
    if build("gcc", &["-w", "-shared", "-fPIC", "-o", &library, &source]).is_none() {
        return;
    }
    let ask = |name: &str| door(name).picture(&DrawList::new(2, 2), &Sheet::default()).expect_err("no picture");
    let crash = ask(&format!("lib:{library}"));
    assert!(matches!(crash, ExternalFailure::Crashed { signal: 11, .. }), "{crash}");
    assert_eq!(ask(&format!("lib:{source}")).name(), "library");
    assert_eq!(ask("lib:/nowhere/z.so").name(), "library");
    assert_eq!(ask("exec:/nowhere/z").name(), "cannot-start");
}

#[test]
fn render_ends_with_2_and_leaves_no_file() {
    let folder = folder();
    let picture = path(folder.path(), "picture.png");
    let arguments = ["render", "spd:tetra:1", "--size", "8", "-o", &picture, "-r", "exec:false"];
    let output = Command::new(env!("CARGO_BIN_EXE_farop")).args(arguments).output().expect("farop starts");
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("exec:false: it ended with exit code 1"), "{said}");
    assert!(!Path::new(&picture).exists());
}

/// What `program` (the body of `main` in C) gives for two lists at once.
fn pictures_of(body: &str) -> Option<Vec<Result<u8, &'static str>>> {
    let folder = folder();
    let (source, program) = (path(folder.path(), "twice.c"), path(folder.path(), "twice"));
    std::fs::write(&source, format!("{HEAD}int main(void) {{ char line[4096]; {body} }}\n")).expect("room for a file");
    build("gcc", &["-o", &program, &source])?;
    let answers =
        door(&format!("exec:'{program}'")).pictures(&[DrawList::new(1, 1), DrawList::new(2, 1)], &Sheet::default());
    let red = |answer: farop::raster::external::Answer| answer.image.encode(Encoding::Linear).pixel(0, 0)[0];
    Some(answers.into_iter().map(|answer| answer.map(red).map_err(|failure| failure.name())).collect())
}

/// C: draws the picture of a size, its first byte the number of files read so far.
const DRAW: &str = "int w; if (sscanf(line, \"size %d 1\", &w) == 1) \
                    printf(\"P6 %d 1 255\\n%c%*s\", w, ++files, w * 3 - 1, \"\");";

#[test]
fn a_program_that_goes_on_is_started_once() {
    let body = format!("int files = 0; while (fgets(line, sizeof line, stdin)) {{ {DRAW} }} return 0;");
    let Some(answers) = pictures_of(&body) else { return };
    assert_eq!(answers, [Ok(1), Ok(2)]);
}

#[test]
fn a_program_that_draws_one_picture_is_started_for_each() {
    let body = format!("int files = 0; while (!files && fgets(line, sizeof line, stdin)) {{ {DRAW} }} return 0;");
    let Some(answers) = pictures_of(&body) else { return };
    assert_eq!(answers, [Ok(1), Ok(1)]);
    // One picture is right, and the other's failure is its own.
    let body = format!(
        "int files = 0; while (fgets(line, sizeof line, stdin)) {{ if (!strncmp(line, \"size 2\", 6)) abort(); {DRAW} }} return 0;"
    );
    assert_eq!(pictures_of(&body), Some(vec![Ok(1), Err("crash")]));
}

#[test]
fn statistics_say_what_was_enforced() {
    let folder = folder();
    let picture = path(folder.path(), "picture.png");
    let blanks = format!("exec:printf 'P6 4 4 255 {:48}'", "");
    let arguments = ["render", "spd:tetra:1", "--size", "4", "--stats", "-o", &picture, "-r", &blanks];
    let output = Command::new(env!("CARGO_BIN_EXE_farop")).args(arguments).output().expect("farop starts");
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(printed.contains(": enforced: time, output"), "{printed}");
}

#[test]
fn more_samples_a_pixel_are_a_larger_picture() {
    if tool("python3", &["--version"]).is_none() {
        return;
    }
    let door = door(&format!("exec:python3 '{EXAMPLES}/python/zbuffer.py'"));
    let canvas = Canvas { samples: 2, ..CANVAS };
    let list = teapot(32);
    let (outside, _) = draw(&list, Some(&door), &canvas);
    let (own, _) = draw(&list, Some(&ZBuffer), &canvas);
    let farthest = |pair: (&Rgb<f32>, &Rgb<f32>)| (pair.0.r - pair.1.r).abs().max((pair.0.g - pair.1.g).abs());
    let difference = outside.pixels().iter().zip(own.pixels()).map(farthest).fold(0.0, f32::max);
    assert_eq!((outside.width(), outside.height()), (16, 16));
    // Each sample was rounded to a level.
    assert!(difference <= 0.5 / 255.0 + 1e-6, "{difference}");
}
