//! The jail: `farop __jail LIMITS [READABLE...] -- PROGRAM ...` takes rights from itself, then becomes PROGRAM.
//!
//! farop -starts-> farop __jail -restricts itself, exec-> the student's program
//!
//! Why a process in between: rights can be dropped only from inside. Doing it between fork and exec in the parent needs unsafe code;
//! a second start of farop does not, and costs about a millisecond.
//!
//! Resource limits, then Landlock (files), then seccomp (system calls): each of them may be missing in an old kernel or inside a
//! container. What is missing is left out and not claimed: the first line on standard error says what is in force.
//!
//! Source: man pages setrlimit(2), landlock(7), seccomp(2).

use super::Enforced;
use super::limits::Limits;
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
    let enforced = restrict(&limits);
    let _ = writeln!(std::io::stderr(), "{REPORT}{}", enforced.words());
    let _ = writeln!(std::io::stderr(), "{NO_START}{}", become_program(Command::new(program).args(rest)));
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
    Enforced {
        resources: linux::resources(limits).is_ok(),
        files: linux::files(limits).unwrap_or(false),
        network: linux::system_calls().is_some(),
        processes: false,
    }
}

#[cfg(target_os = "linux")]
mod linux {
    use super::Limits;
    use landlock::{
        ABI, Access, AccessFs, Ruleset, RulesetAttr, RulesetCreatedAttr, RulesetStatus, path_beneath_rules,
    };
    use nix::libc;
    use nix::sys::resource::{Resource, setrlimit};
    use seccompiler::{BpfProgram, SeccompAction, SeccompFilter, apply_filter};
    use std::collections::BTreeMap;
    use std::os::unix::fs::MetadataExt;
    use std::path::Path;

    pub fn resources(limits: &Limits) -> nix::Result<()> {
        let all = [
            (Resource::RLIMIT_CPU, limits.wall.as_secs()),
            (Resource::RLIMIT_AS, limits.memory),
            (Resource::RLIMIT_FSIZE, limits.file),
            (Resource::RLIMIT_NOFILE, 64),
            (Resource::RLIMIT_CORE, 0),
            // It counts all that the user runs, threads too, and is ignored for root: the parent counts as well.
            (Resource::RLIMIT_NPROC, tasks_of_this_user() + limits.processes * 4),
        ];
        all.into_iter().try_for_each(|(resource, limit)| setrlimit(resource, limit, limit))
    }

    fn tasks_of_this_user() -> u64 {
        let owner = |path: &Path| std::fs::metadata(path).ok().map(|data| data.uid());
        let (own, folder) = (owner(Path::new("/proc/self")), std::fs::read_dir("/proc"));
        let threads = |process: std::fs::DirEntry| {
            let mine = owner(&process.path()) == own;
            mine.then(|| std::fs::read_dir(process.path().join("task")).map_or(0, |tasks| tasks.count() as u64))
        };
        folder.map_or(0, |folder| folder.flatten().filter_map(threads).sum())
    }

    /// Whether writing (and reading, if so wished) is confined.
    pub fn files(limits: &Limits) -> Result<bool, landlock::RulesetError> {
        // Version 3 knows all ways of changing files; newer ones add what is no matter of files.
        let all = AccessFs::from_all(ABI::V3);
        let handled = if limits.readable.is_empty() { AccessFs::from_write(ABI::V3) } else { all };
        let mut ruleset = Ruleset::default().handle_access(handled)?.create()?;
        let devices = AccessFs::WriteFile | AccessFs::ReadFile;
        ruleset = ruleset.add_rules(path_beneath_rules(["/dev/null"], devices & handled))?;
        if !limits.readable.is_empty() {
            ruleset = ruleset.add_rules(path_beneath_rules(&limits.readable, AccessFs::from_read(ABI::V3)))?;
        }
        Ok(ruleset.restrict_self()?.ruleset != RulesetStatus::NotEnforced)
    }

    /// Denies what no rasterizer needs: the network, and leaving the group of processes that is ended together.
    pub fn system_calls() -> Option<()> {
        let denied =
            [libc::SYS_socket, libc::SYS_io_uring_setup, libc::SYS_ptrace, libc::SYS_setsid, libc::SYS_setpgid];
        let rules: BTreeMap<i64, Vec<_>> = denied.into_iter().map(|call| (call, Vec::new())).collect();
        let refuse = SeccompAction::Errno(libc::EPERM as u32);
        let filter = SeccompFilter::new(rules, SeccompAction::Allow, refuse, std::env::consts::ARCH.try_into().ok()?);
        let program: BpfProgram = filter.ok()?.try_into().ok()?;
        apply_filter(&program).ok()
    }
}
