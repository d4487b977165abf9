//! What can go wrong with a rasterizer outside farop: every case a value with a name and a sentence.
//!
//! Why values: `farop render` prints the sentence and ends with 2; the grader makes a finding of it. Neither ever crashes.

use thiserror::Error;

/// Why a program or library gave no picture.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ExternalFailure {
    /// The list cannot be written as a screen file.
    #[error("the draw list cannot be sent as a screen file: {0}")]
    CannotSend(String),
    /// Not a command, or no such program.
    #[error("`{program}` cannot be started: {reason}")]
    CannotStart {
        /// What was to be started.
        program: String,
        /// What the system says.
        reason: String,
    },
    /// The shared library cannot be used.
    #[error("the library cannot be used: {0}")]
    Library(String),
    /// No answer within the time.
    #[error("no picture after {seconds} s: an endless loop, or much too slow")]
    TimedOut {
        /// Wall-clock limit.
        seconds: f64,
    },
    /// Ended by a signal.
    #[error("it crashed: {}{}", signal_words(*.signal), last_words(.stderr))]
    Crashed {
        /// The signal's number.
        signal: i32,
        /// The beginning of what it wrote to standard error.
        stderr: String,
    },
    /// Ended with another code than 0.
    #[error("it ended with exit code {code}{}", last_words(.stderr))]
    Exited {
        /// The code.
        code: i32,
        /// The beginning of what it wrote to standard error.
        stderr: String,
    },
    /// It asked for more memory than it may have.
    #[error("it ran out of memory: it may have {megabytes} MB{}", last_words(.stderr))]
    OutOfMemory {
        /// The limit.
        megabytes: u64,
        /// The beginning of what it wrote to standard error.
        stderr: String,
    },
    /// It started more and more processes.
    #[error("it started more than {limit} processes and was stopped")]
    TooManyProcesses {
        /// The limit.
        limit: u64,
    },
    /// It wrote and wrote.
    #[error("it wrote more than {limit} bytes to standard output and was stopped: a picture has {picture}")]
    TooMuchOutput {
        /// The limit.
        limit: u64,
        /// Bytes of a picture of this size.
        picture: u64,
    },
    /// It wrote nothing.
    #[error("it wrote nothing to standard output{}", last_words(.stderr))]
    NoPicture {
        /// The beginning of what it wrote to standard error.
        stderr: String,
    },
    /// The picture ends early.
    #[error(
        "the picture ends early: its pixels need {expected} bytes, {got} came; is the output closed or flushed at the end?"
    )]
    TooShort {
        /// Bytes of all pixels.
        expected: u64,
        /// Bytes that came.
        got: u64,
    },
    /// Something stands before the picture.
    #[error(
        "standard output must hold the picture and nothing else, but before it stands `{shown}`: print messages to standard error"
    )]
    TextBefore {
        /// Its beginning.
        shown: String,
    },
    /// Something stands behind the picture.
    #[error(
        "{bytes} bytes follow the last pixel, beginning with `{shown}`: standard output must hold the picture and nothing else"
    )]
    TextAfter {
        /// How many.
        bytes: u64,
        /// Their beginning.
        shown: String,
    },
    /// P3.
    #[error("the picture is a P3 (numbers as text); write a P6: the same head, then three bytes a pixel")]
    TextPicture,
    /// Written as text: bytes were changed on the way.
    #[error("the picture is damaged: {damage}; standard output must be written as bytes")]
    TextMode {
        /// Which change, recognized by undoing it.
        damage: &'static str,
    },
    /// Height and width exchanged.
    #[error("width and height are exchanged: the picture is {} x {}, it should be {} x {}", .drawn.0, .drawn.1, .drawn.1, .drawn.0)]
    SwappedSize {
        /// Width and height that came.
        drawn: (u64, u64),
    },
    /// Another size.
    #[error("the picture is {} x {} samples, it should be {} x {}: record `size` of the screen file", .drawn.0, .drawn.1, .expected.0, .expected.1)]
    WrongSize {
        /// What was asked for.
        expected: (u64, u64),
        /// What came.
        drawn: (u64, u64),
    },
    /// No picture file that farop knows.
    #[error("the output is no P6 picture: {0}")]
    BadPicture(String),
}

impl ExternalFailure {
    /// A short name that does not change, for reports and tests.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            ExternalFailure::CannotSend(_) => "cannot-send",
            ExternalFailure::CannotStart { .. } => "cannot-start",
            ExternalFailure::Library(_) => "library",
            ExternalFailure::TimedOut { .. } => "time-out",
            ExternalFailure::Crashed { .. } => "crash",
            ExternalFailure::Exited { .. } => "exit-code",
            ExternalFailure::OutOfMemory { .. } => "memory",
            ExternalFailure::TooManyProcesses { .. } => "processes",
            ExternalFailure::TooMuchOutput { .. } => "too-much-output",
            ExternalFailure::NoPicture { .. } => "no-output",
            ExternalFailure::TooShort { .. } => "too-short",
            ExternalFailure::TextBefore { .. } => "text-before-picture",
            ExternalFailure::TextAfter { .. } => "text-after-picture",
            ExternalFailure::TextPicture => "p3",
            ExternalFailure::TextMode { .. } => "text-mode",
            ExternalFailure::SwappedSize { .. } => "swapped-size",
            ExternalFailure::WrongSize { .. } => "wrong-size",
            ExternalFailure::BadPicture(_) => "bad-picture",
        }
    }
}

/// What a signal means to somebody who has not met it.
fn signal_words(signal: i32) -> String {
    let meaning = match signal {
        4 => "SIGILL, an instruction that does not exist",
        6 => "SIGABRT, it gave up: an assertion, or memory it found damaged",
        7 => "SIGBUS, an address that cannot be",
        8 => "SIGFPE, a whole number divided by 0",
        9 => "SIGKILL, stopped from outside",
        11 => {
            "SIGSEGV, it used memory that is not its own: an index outside an array, a null pointer, endless recursion"
        }
        24 => "SIGXCPU, more processor time than it may have",
        25 => "SIGXFSZ, it wrote to a file, which it may not",
        31 => "SIGSYS, a system call that it may not use",
        _ => return format!("signal {signal}"),
    };
    format!("signal {signal} ({meaning})")
}

/// The last line a program wrote to standard error is where Python and Java name the error.
fn last_words(stderr: &str) -> String {
    match stderr.lines().rev().map(str::trim).find(|line| !line.is_empty()) {
        // Control characters could do things to the terminal they are printed on.
        Some(line) => {
            let line: String = line.chars().filter(|letter| !letter.is_control()).take(200).collect();
            format!("; it says: {line}")
        }
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_line_is_shown_and_harmless() {
        let stderr = "Traceback:\n  line 3\nIndexError: \u{1b}[2Jout of range\n\n".to_string();
        let said = ExternalFailure::Exited { code: 1, stderr }.to_string();
        assert_eq!(said, "it ended with exit code 1; it says: IndexError: [2Jout of range");
        let crash = ExternalFailure::Crashed { signal: 11, stderr: String::new() }.to_string();
        assert!(crash.starts_with("it crashed: signal 11 (SIGSEGV"), "{crash}");
    }
}
