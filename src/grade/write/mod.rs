//! Writers: a grade as text for the terminal, and as Gradescope, PrairieLearn, GitHub Classroom, JUnit and programs take it.
//!
//! Verdict -RESULTS-> entries -WRITERS-> text, JSON, XML
//!
//! Every writer takes a grade that is not whole yet: results are written anew after every picture, so that a grader that is
//! stopped leaves a file that is valid and counts what was earned.

mod base64;
mod classroom;
mod gradescope;
mod json;
mod junit;
mod prairielearn;
mod results;
mod text;

pub use base64::{base64, png_url};
pub use classroom::{classroom, classroom_json};
pub use gradescope::gradescope;
pub use json::json;
pub use junit::junit;
pub use prairielearn::prairielearn;
pub use results::Results;
pub use text::{aspect_text, hidden_text, text};
