//! The page `docs/first-ten-minutes.md`, Rust's part: what the page shows is what this crate's program prints. In place of building a crate
//! anew, `mine` stands for the first minute, `ten_lines` for the last, and the step between is compiled here.

#[path = "../../tests/support/walk.rs"]
mod walk;

use farop::grade::{InProcess, Request, grade, labs, write};
use farop::raster::coverage::covers;
use farop::raster::{PerPolygon, PolygonRasterizer, Target};
use farop::screen::{ScreenPolygon, Shader};
use std::process::Command;

const PAGE: &str = include_str!("../../docs/first-ten-minutes.md");

/// Steps 1 and 2 of the lab, as on the page.
struct Filled;

impl PolygonRasterizer for Filled {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let reach = |(low, high): (i32, i32), along: f64| (low.min(along as i32), high.max(along as i32));
        let (left, right) = polygon.vertices().iter().fold((i32::MAX, 0), |range, corner| reach(range, corner.x));
        let (top, bottom) = polygon.vertices().iter().fold((i32::MAX, 0), |range, corner| reach(range, corner.y));
        for y in top..=bottom {
            for x in left..=right {
                if covers(polygon.vertices(), polygon.grid(), x, y) {
                    target.put(shader.fragment(polygon, x, y));
                }
            }
        }
    }
}

#[test]
fn the_walk_in_rust() {
    let steps = walk::steps(PAGE, "In Rust");
    assert!(steps.len() >= 5, "{}", steps.len());
    let mut has_graded = false;
    for step in steps {
        for command in &step.commands {
            // Cloning and making a crate are `tests/student_new.rs`.
            let Some(arguments) = command.strip_prefix("cargo run -p student_ana -- ") else { continue };
            // The first grade is of what the crate draws at first; then the student has worked.
            let solved = if has_graded { arguments.replace("-r mine", "-r ten_lines") } else { arguments.to_string() };
            has_graded |= arguments.starts_with("grade");
            let mut program = Command::new(env!("CARGO_BIN_EXE_lab"));
            program.args(solved.split_whitespace()).current_dir(env!("CARGO_TARGET_TMPDIR")).env("NO_COLOR", "1");
            let output = program.output().expect("the program starts");
            let text = String::from_utf8_lossy(&output.stdout).replace("ten_lines", "mine");
            let said = String::from_utf8_lossy(&output.stderr);
            assert_eq!(output.status.code(), Some(step.code), "{solved}\n{text}{said}");
            walk::assert_seen(&step, &text);
        }
    }
}

#[test]
fn the_step_between_is_that_of_the_page_and_has_its_name() {
    let start = PAGE.find("```rust\n").expect("a block of Rust") + "```rust\n".len();
    let block = &PAGE[start..start + PAGE[start..].find("```").expect("its end")];
    assert!(include_str!("first_ten_minutes.rs").contains(block), "{block}");
    let lab = labs::find("zbuffer").expect("a lab");
    let points = |aspect: &labs::Aspect| f64::from(aspect.points);
    let request = Request { lab, name: "mine".to_string(), seed: 1, points: &points };
    let verdict = grade(&InProcess(&PerPolygon(Filled)), &request, &mut |_| ());
    let names: Vec<_> = verdict.faults.iter().map(|fault| fault.name).collect();
    assert_eq!(names, ["last wins"], "{}", write::text(&verdict));
}
