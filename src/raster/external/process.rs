//! One run of a program that is not farop's: input in, output back, within limits, nothing left over.
//!
//! Why threads: a program may write before it has read everything. Whoever writes all of the input first and reads then
//! waits forever once both pipes are full.
//!
//! The program is the leader of a process group of its own; at the end, whatever the end was, the whole group is killed.
//! Cost: a start (1 ms for C, 20 ms for Python), and a look every few milliseconds.

use super::jail::{NO_START, REPORT};
use super::{Enforced, ExternalFailure, Limits};
use std::ffi::OsString;
use std::io::{Read, Write};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How often a running program is looked at.
const LOOK: Duration = Duration::from_millis(4);
/// Bytes of standard error that are kept, enough for a long traceback; the rest is read and forgotten.
const STDERR_KEPT: usize = 1 << 16;
/// How long pipes may stay open after the whole group was killed.
const DRAIN: Duration = Duration::from_secs(1);

/// What came of a run.
pub struct Run {
    /// Standard output.
    pub stdout: Vec<u8>,
    /// The beginning of standard error, without the jail's own words.
    pub stderr: String,
    /// What was in force.
    pub enforced: Enforced,
    /// Why its output does not count, if it does not.
    pub failure: Option<ExternalFailure>,
}

/// What the program is ended for.
enum End {
    Exited(ExitStatus),
    TimedOut,
    TooMuchOutput,
    TooManyProcesses,
}

/// Runs `words` (through the jail of `host`, if there is one) with `input`.
pub(super) fn run(
    words: &[OsString],
    host: Option<&std::path::Path>,
    input: Vec<u8>,
    limits: &Limits,
) -> Result<Run, ExternalFailure> {
    let mut child = start(words, host, limits)?;
    if let Some(mut stdin) = child.stdin.take() {
        // A program that does not read to the end is told by the answer, not by this.
        std::thread::spawn(move || stdin.write_all(&input));
    }
    let is_full = Arc::new(AtomicBool::new(false));
    let stdout = collect(child.stdout.take(), limits.output as usize, Arc::clone(&is_full));
    let stderr = collect(child.stderr.take(), STDERR_KEPT, Arc::default());
    let (end, peak) = watch(&mut child, limits, &is_full);
    end_group(&mut child);
    let stdout = stdout.recv_timeout(DRAIN).unwrap_or_default();
    let stderr = stderr.recv_timeout(DRAIN).unwrap_or_default();
    let (mut enforced, stderr) = split_report(&String::from_utf8_lossy(&stderr));
    enforced.processes = cfg!(target_os = "linux");
    // A short run may flood and end between two looks.
    let end = if is_full.load(Ordering::Relaxed) { End::TooMuchOutput } else { end };
    let failure = failure_of(&end, limits, &stderr, peak);
    Ok(Run { stdout, stderr, enforced, failure })
}

fn start(words: &[OsString], host: Option<&std::path::Path>, limits: &Limits) -> Result<Child, ExternalFailure> {
    let program = words.first().cloned().unwrap_or_default();
    let mut command = match host {
        // Only where a program can become another one.
        Some(host) if cfg!(unix) => {
            let mut command = Command::new(host);
            command.arg("__jail").args(limits.to_arguments()).arg("--").args(words);
            command
        }
        _ => {
            let mut command = Command::new(&program);
            command.args(words.iter().skip(1));
            command
        }
    };
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().map_err(|error| ExternalFailure::CannotStart {
        program: program.to_string_lossy().into_owned(),
        reason: error.to_string(),
    })
}

/// Reads a pipe to its end in a thread of its own; what is beyond `limit` bytes is dropped, and says so in `is_full`.
fn collect(pipe: Option<impl Read + Send + 'static>, limit: usize, is_full: Arc<AtomicBool>) -> Receiver<Vec<u8>> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let (mut kept, mut buffer) = (Vec::new(), vec![0; 1 << 16]);
        let Some(mut pipe) = pipe else { return };
        while let Ok(count @ 1..) = pipe.read(&mut buffer) {
            let room = limit - kept.len();
            kept.extend_from_slice(&buffer[..count.min(room)]);
            if count > room {
                is_full.store(true, Ordering::Relaxed);
            }
        }
        // Nobody may wait any more.
        let _ = sender.send(kept);
    });
    receiver
}

/// Waits until the program ends or breaks a limit; also the most address space it was seen to use.
fn watch(child: &mut Child, limits: &Limits, is_full: &AtomicBool) -> (End, u64) {
    let started = Instant::now();
    let (mut peak, mut looks) = (0, 0_u32);
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return (End::Exited(status), peak),
            _ if is_full.load(Ordering::Relaxed) => return (End::TooMuchOutput, peak),
            _ if started.elapsed() > limits.wall => return (End::TimedOut, peak),
            _ => {}
        }
        peak = peak.max(address_space(child.id()));
        // Looking at all processes costs more than looking at one.
        if looks % 4 == 3 && processes_in_group(child.id()) > limits.processes {
            return (End::TooManyProcesses, peak);
        }
        looks = looks.wrapping_add(1);
        // Short programs are not made to wait for a long look.
        std::thread::sleep(if looks < 10 { LOOK / 4 } else { LOOK });
    }
}

/// Ends the program and everything it started, and waits for it.
fn end_group(child: &mut Child) {
    #[cfg(unix)]
    {
        use nix::sys::signal::{Signal, killpg};
        // An error only says that nobody is left.
        let _ = killpg(nix::unistd::Pid::from_raw(child.id() as i32), Signal::SIGKILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

/// The largest address space process `id` has had, bytes; 0 where the system does not say.
fn address_space(id: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmPeak:"));
    line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok()).unwrap_or(0) * 1024
}

/// Processes of the group that `leader` leads; 0 where the system does not say.
fn processes_in_group(leader: u32) -> u64 {
    let Ok(folder) = std::fs::read_dir("/proc") else { return 0 };
    let is_member = |entry: std::fs::DirEntry| {
        entry.file_name().as_encoded_bytes().first()?.is_ascii_digit().then_some(())?;
        let stat = std::fs::read_to_string(entry.path().join("stat")).ok()?;
        // number (name) state parent group ...; the name may hold anything, parentheses too.
        let group = stat.rsplit_once(')')?.1.split_whitespace().nth(2)?;
        (group.parse() == Ok(leader)).then_some(())
    };
    folder.flatten().filter_map(is_member).count() as u64
}

/// What the jail reported, and the program's own words.
fn split_report(stderr: &str) -> (Enforced, String) {
    let Some(rest) = stderr.strip_prefix(REPORT) else { return (Enforced::default(), stderr.to_string()) };
    let (words, own) = rest.split_once('\n').unwrap_or((rest, ""));
    (Enforced::from_words(words), own.to_string())
}

fn failure_of(end: &End, limits: &Limits, stderr: &str, peak: u64) -> Option<ExternalFailure> {
    let stderr = stderr.to_string();
    let megabytes = limits.memory >> 20;
    let said = ["MemoryError", "bad_alloc", "OutOfMemoryError", "memory allocation of"];
    let out_of_memory = peak > limits.memory / 8 * 7 || said.iter().any(|word| stderr.contains(word));
    match end {
        End::TimedOut => Some(ExternalFailure::TimedOut { seconds: limits.wall.as_secs_f64() }),
        End::TooMuchOutput => Some(ExternalFailure::TooMuchOutput { limit: limits.output, picture: 0 }),
        End::TooManyProcesses => Some(ExternalFailure::TooManyProcesses { limit: limits.processes }),
        End::Exited(status) if status.success() => None,
        End::Exited(_) if out_of_memory => Some(ExternalFailure::OutOfMemory { megabytes, stderr }),
        End::Exited(status) => Some(ended_badly(*status, stderr)),
    }
}

fn ended_badly(status: ExitStatus, stderr: String) -> ExternalFailure {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return ExternalFailure::Crashed { signal, stderr };
    }
    if let Some(reason) = stderr.strip_prefix(NO_START) {
        return ExternalFailure::CannotStart { program: String::new(), reason: reason.trim().to_string() };
    }
    if let Some(reason) = stderr.lines().find_map(|line| line.strip_prefix(super::LIBRARY_ERROR)) {
        return ExternalFailure::Library(reason.to_string());
    }
    ExternalFailure::Exited { code: status.code().unwrap_or(-1), stderr }
}
