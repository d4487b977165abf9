//! Writers: a verdict as text for the terminal, as Gradescope's results, as JUnit, as JSON.

mod gradescope;
mod json;
mod junit;
mod text;

pub use gradescope::gradescope;
pub use json::json;
pub use junit::junit;
pub use text::{aspect_text, text};
