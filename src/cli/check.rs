//! `farop check`: the accuracy checks, by name.

use super::error::{self, CliError};
use crate::lab::check::{CHECKS, Check, Effort, Extent, find};
use clap::Args;
use std::time::Instant;

/// Measure the accuracy that farop claims; exit code 1 where a claim does not hold
#[derive(Args)]
#[command(after_help = "Examples:\n  farop check --quick\n  farop check coverage --seed 7")]
pub(super) struct CheckCommand {
    /// Which check; all without a name (`farop list checks` has the names)
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Fewer cases: all checks in about two minutes
    #[arg(long)]
    quick: bool,
    /// Where the cases come from: the same seed, the same cases
    #[arg(long, value_name = "N", default_value_t = 1996)]
    seed: u64,
    /// The figures as JSON on standard output
    #[arg(long)]
    json: bool,
}

impl CheckCommand {
    pub fn run(self) -> Result<(), CliError> {
        let checks = self.checks()?;
        let extent = if self.quick { Extent::Quick } else { Extent::Full };
        let effort = Effort { extent, seed: self.seed };
        let mut reports = Vec::new();
        for check in checks {
            let start = Instant::now();
            let report = check.report(&effort);
            if !self.json {
                error::print(&format!("{}  {:.1} s\n\n", report.text(), start.elapsed().as_secs_f64()))?;
            }
            reports.push(report);
        }
        if self.json {
            let text = serde_json::to_string_pretty(&reports).map_err(|error| CliError::failed(error.to_string()))?;
            error::print(&(text + "\n"))?;
        }
        let failed: Vec<&str> = reports.iter().filter(|report| !report.holds()).map(|report| report.name).collect();
        if failed.is_empty() {
            return Ok(());
        }
        Err(CliError::Wanting(format!("found wanting: {}", failed.join(", "))))
    }

    fn checks(&self) -> Result<Vec<&'static Check>, CliError> {
        if self.names.is_empty() {
            return Ok(CHECKS.iter().collect());
        }
        let known = |name: &String| {
            find(name).ok_or_else(|| {
                let names: Vec<_> = CHECKS.iter().map(|check| check.name).collect();
                CliError::failed(format!("there is no check `{name}`; there is {}", names.join(", ")))
            })
        };
        self.names.iter().map(known).collect()
    }
}
