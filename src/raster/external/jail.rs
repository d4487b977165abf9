//! The jail: `farop __jail LIMITS [READABLE...] -- PROGRAM ...` takes rights from itself, then becomes PROGRAM.
//!
//! farop -starts-> farop __jail -restricts itself, exec-> the student's program
//!
//! Why a process in between: rights can be dropped only from inside. Doing it between fork and exec in the parent needs unsafe code;
//! a second start of farop does not, and costs about a millisecond.
//!
//! Resource limits, then Landlock (files), then seccomp (system calls), in [`super::confine`]: each of them may be missing in an old kernel or inside a
//! container. What is missing is left out and not claimed: the first line on standard error says what is in force.
//! A submission that is graded is not started then, unless that was asked for ([`super::strict`]).
//!
//! Source: man pages setrlimit(2), landlock(7), seccomp(2).

use super::Enforced;
use super::limits::Limits;
use super::strict::Lent;
use std::ffi::OsString;
use std::io::Write;
use std::process::Command;

/// What the line on standard error begins with that says what is in force.
pub(super) const REPORT: &str = "farop-jail: enforced ";
/// What it begins with when the program cannot be started.
pub(super) const NO_START: &str = "farop-jail: cannot start ";

/// Drops rights and becomes the program behind `--`; comes back only when that fails, with an exit code.
#[must_use]
pub fn enter(arguments: &[OsString]) -> u8 {
    let split = arguments.iter().position(|argument| argument == "--");
    let parts = split.and_then(|at| Some((Limits::from_arguments(&arguments[..at])?, &arguments[at + 1..])));
    let Some((limits, [program, rest @ ..])) = parts else {
        let _ = writeln!(std::io::stderr(), "{NO_START}: `__jail` is farop's own and has no other use");
        return 2;
    };
    // What is lent must be open before this process is somebody else.
    let lent = limits.strict.as_deref().map(Lent::open).unwrap_or_default();
    let enforced = restrict(&limits);
    let _ = writeln!(std::io::stderr(), "{REPORT}{}", enforced.words());
    let mut command = Command::new(lent.renamed(program));
    command.args(rest.iter().map(|word| lent.renamed(word)));
    if let Some(strict) = &limits.strict {
        if let Some(missing) = enforced.first_missing().filter(|_| !strict.may_miss) {
            let _ = writeln!(std::io::stderr(), "{NO_START}: {missing} cannot be confined here");
            return 126;
        }
        let environment = strict.environment();
        command.env_clear().envs(environment.iter().map(|(name, value)| (name, lent.renamed(value))));
        command.current_dir(&strict.folder);
    }
    let _ = writeln!(std::io::stderr(), "{NO_START}{}", become_program(&mut command));
    126
}

#[cfg(unix)]
fn become_program(command: &mut Command) -> std::io::Error {
    std::os::unix::process::CommandExt::exec(command)
}

#[cfg(not(unix))]
fn become_program(_: &mut Command) -> std::io::Error {
    std::io::ErrorKind::Unsupported.into()
}

#[cfg(not(target_os = "linux"))]
fn restrict(_: &Limits) -> Enforced {
    Enforced::default()
}

#[cfg(target_os = "linux")]
fn restrict(limits: &Limits) -> Enforced {
    use super::confine;
    let strict = limits.strict.as_deref();
    // In this order: who is no longer root cannot open all that is lent, and the last filter ends it.
    Enforced {
        resources: confine::resources(limits).is_ok(),
        files: confine::files(limits).unwrap_or(false),
        user: strict.is_some_and(confine::user),
        network: confine::system_calls().is_some(),
        calls: strict.is_some_and(|strict| confine::calls_of(strict.work).is_some()),
        processes: false,
    }
}
