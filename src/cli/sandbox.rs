//! `farop sandbox`: what holds a submission on this machine, tried out.

use super::error::{self, CliError};
use crate::grade::class::Sandbox;
use clap::Args;

/// What holds graded submissions on this machine, layer by layer, tried out
#[derive(Args)]
#[command(after_help = "Examples:\n  farop sandbox\n  farop sandbox --as-root")]
pub(super) struct SandboxCommand {
    /// As root: submissions run as root, too
    #[arg(long)]
    as_root: bool,
}

/// Ways out of the jail, and what they are called.
const WAYS: [(&str, &str); 8] = [
    ("read", "read a file that is not its own"),
    ("write", "write outside its folder"),
    ("keep", "write into its folder"),
    ("socket", "open a socket"),
    ("start", "start a process"),
    ("leave", "leave the group of processes"),
    ("signal", "signal the grader"),
    ("root", "be root"),
];

impl SandboxCommand {
    pub fn run(&self) -> Result<(), CliError> {
        let sandbox = Sandbox::new(self.as_root, true).map_err(CliError::failed)?;
        let mut text = format!("layers: {}\n", sandbox.layers().join(", "));
        let missing = sandbox.missing();
        if !missing.is_empty() {
            text += &format!("missing: {}\n", missing.join(", "));
        }
        if let Some(user) = sandbox.user() {
            text += &format!("submissions run as user {user}\n");
        }
        let mut open = 0;
        for (way, words) in WAYS {
            let (_, succeeded) = sandbox.try_out(way).map_err(CliError::failed)?;
            open += usize::from(succeeded);
            text += &format!("  {:<34} {}\n", words, if succeeded { "POSSIBLE" } else { "refused" });
        }
        error::print(&text)?;
        if open == 0 && missing.is_empty() {
            return Ok(());
        }
        Err(CliError::Wanting(format!(
            "a submission is not held here: {open} ways out, {} layers missing",
            missing.len()
        )))
    }
}
