//! How a command ends, and text for standard output.

use std::io::Write;

/// Why a command did not end well.
#[derive(Debug)]
pub(super) enum CliError {
    /// Checked and found wanting: exit code 1. The text is what was found.
    Wanting(String),
    /// Could not run: exit code 2. The text says what, where and what to do.
    Failed(String),
    /// Could not run; the text is a whole rendered diagnostic.
    Diagnosed(String),
}

impl CliError {
    /// Could not run, with a message.
    pub fn failed(message: impl std::fmt::Display) -> CliError {
        CliError::Failed(message.to_string())
    }

    /// What the process exits with.
    pub fn exit_code(&self) -> u8 {
        match self {
            CliError::Wanting(_) => 1,
            CliError::Failed(_) | CliError::Diagnosed(_) => 2,
        }
    }

    /// The text for stderr, with its line ends.
    pub fn message(&self) -> String {
        match self {
            CliError::Wanting(text) => format!("{text}\n"),
            CliError::Failed(text) => format!("error: {text}\n"),
            CliError::Diagnosed(text) => format!("{}\n", text.trim_end()),
        }
    }
}

impl From<crate::image::save::SaveError> for CliError {
    fn from(error: crate::image::save::SaveError) -> Self {
        CliError::failed(error)
    }
}

impl From<crate::plan::PlanError> for CliError {
    fn from(error: crate::plan::PlanError) -> Self {
        CliError::failed(error)
    }
}

/// Writes `text` to standard output; a reader that has gone away ends the program quietly.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(CliError::failed(format!("cannot write to standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes a notice to stderr.
pub(super) fn notice(text: &str) {
    // A closed stderr must not stop the work.
    let _ = writeln!(std::io::stderr(), "notice: {text}");
}

/// Writes lines to stderr as they are.
pub(super) fn tell(text: &str) {
    let _ = write!(std::io::stderr(), "{text}");
}

/// Whether messages on stderr may be colored: a terminal, and `NO_COLOR` is not set.
pub(super) fn stderr_has_color() -> bool {
    anstream::AutoStream::choice(&std::io::stderr()) != anstream::ColorChoice::Never
}

/// Whether text on stdout may be colored.
pub(super) fn stdout_has_color() -> bool {
    anstream::AutoStream::choice(&std::io::stdout()) != anstream::ColorChoice::Never
}

/// Writes rendered diagnostics to stderr.
pub(super) fn diagnose(text: &str) {
    let _ = writeln!(std::io::stderr(), "{}", text.trim_end());
}
