//! Confine: the layers of the jail on Linux, each of them taken on by the process itself.
//!
//! Limits -CONFINE-> setrlimit, Landlock, another user, seccomp
//!
//! Which calls are refused, not which are allowed: programs of any language run here, and their libraries ask for things that no
//! list foresees. What is refused is what reaches out of the process: sockets, sessions, other processes, memory of others.
//!
//! Source: man pages setrlimit(2), landlock(7), seccomp(2), prctl(2).

use super::limits::Limits;
use super::strict::{SYSTEM, Strict, Work};
use landlock::{
    ABI, Access, AccessFs, Ruleset, RulesetAttr, RulesetCreatedAttr, RulesetStatus, Scope, path_beneath_rules,
};
use nix::libc;
use nix::sys::resource::{Resource, setrlimit};
use nix::unistd::{Gid, Uid};
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
    apply_filter,
};
use std::collections::BTreeMap;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

pub(super) fn resources(limits: &Limits) -> nix::Result<()> {
    let is_build = limits.strict.as_ref().is_some_and(|strict| strict.work == Work::Build);
    let all = [
        (Resource::RLIMIT_CPU, limits.wall.as_secs()),
        (Resource::RLIMIT_AS, limits.memory),
        (Resource::RLIMIT_FSIZE, limits.file),
        // A linker holds many libraries open.
        (Resource::RLIMIT_NOFILE, if is_build { 512 } else { 64 }),
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
pub(super) fn files(limits: &Limits) -> Result<bool, landlock::RulesetError> {
    // Version 3 knows all ways of changing files; newer ones add what is no matter of files.
    let all = AccessFs::from_all(ABI::V3);
    let reads_all = limits.readable.is_empty() && limits.strict.is_none();
    let handled = if reads_all { AccessFs::from_write(ABI::V3) } else { all };
    let mut ruleset = Ruleset::default().handle_access(handled)?;
    if limits.strict.is_some() {
        // Signals and abstract sockets stay inside, where the system knows how.
        ruleset = ruleset.scope(Scope::from_all(ABI::V6))?;
    }
    let mut ruleset = ruleset.create()?;
    let devices = AccessFs::WriteFile | AccessFs::ReadFile;
    ruleset = ruleset.add_rules(path_beneath_rules(["/dev/null"], devices & handled))?;
    if !reads_all {
        ruleset = ruleset.add_rules(path_beneath_rules(&limits.readable, AccessFs::from_read(ABI::V3)))?;
    }
    if let Some(strict) = &limits.strict {
        let read = AccessFs::from_read(ABI::V3);
        let own = if strict.work == Work::Build { all } else { read };
        ruleset = ruleset.add_rules(path_beneath_rules(SYSTEM, read))?;
        ruleset = ruleset.add_rules(path_beneath_rules(&strict.lent, read))?;
        ruleset = ruleset.add_rules(path_beneath_rules([&strict.folder], own))?;
    }
    Ok(ruleset.restrict_self()?.ruleset != RulesetStatus::NotEnforced)
}

/// Becomes the user that was asked for; whether this is not root in the end.
pub(super) fn user(strict: &Strict) -> bool {
    if let Some(user) = strict.user {
        let (user, group) = (Uid::from_raw(user), Gid::from_raw(user));
        let changed = nix::unistd::setgroups(&[])
            .and_then(|()| nix::unistd::setresgid(group, group, group))
            .and_then(|()| nix::unistd::setresuid(user, user, user));
        if changed.is_err() {
            return false;
        }
    }
    // When the grader is killed, what it started must not go on. Asked for now: another user would have undone it.
    let _ = nix::sys::prctl::set_pdeathsig(nix::sys::signal::Signal::SIGKILL);
    !nix::unistd::geteuid().is_root()
}

/// Denies what no rasterizer needs: the network, and leaving the group of processes that is ended together.
pub(super) fn system_calls() -> Option<()> {
    let denied = [libc::SYS_socket, libc::SYS_io_uring_setup, libc::SYS_ptrace, libc::SYS_setsid, libc::SYS_setpgid];
    refuse(denied.into_iter().map(|call| (call, Vec::new())).collect(), libc::EPERM)
}

/// Memory of others, name spaces, keys, and memory that outlives the process.
const ALWAYS: [libc::c_long; 20] = [
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_pidfd_open,
    libc::SYS_pidfd_getfd,
    libc::SYS_pidfd_send_signal,
    libc::SYS_unshare,
    libc::SYS_setns,
    libc::SYS_mount,
    libc::SYS_bpf,
    libc::SYS_perf_event_open,
    libc::SYS_userfaultfd,
    libc::SYS_keyctl,
    libc::SYS_add_key,
    libc::SYS_request_key,
    libc::SYS_shmget,
    libc::SYS_msgget,
    libc::SYS_semget,
    libc::SYS_mq_open,
    libc::SYS_rt_sigqueueinfo,
    libc::SYS_rt_tgsigqueueinfo,
];

/// Denies what reaches out of a graded process; for a submission also new processes, and signals to others.
pub(super) fn calls_of(work: Work) -> Option<()> {
    let mut rules: BTreeMap<i64, Vec<SeccompRule>> = ALWAYS.into_iter().map(|call| (call, Vec::new())).collect();
    if work == Work::Run {
        #[cfg(target_arch = "x86_64")]
        rules.extend([libc::SYS_fork, libc::SYS_vfork].map(|call| (call, Vec::new())));
        // Threads are processes that share everything; only those may be made.
        let thread = libc::CLONE_THREAD as u64;
        rules.insert(libc::SYS_clone, vec![rule(0, SeccompCmpOp::MaskedEq(thread), 0)?]);
        // A program may end itself (`abort`), nobody else: its number stays when this process becomes it.
        let own = u64::from(std::process::id());
        for call in [libc::SYS_kill, libc::SYS_tkill, libc::SYS_tgkill] {
            rules.insert(call, vec![rule(0, SeccompCmpOp::Ne, own)?]);
        }
    }
    refuse(rules, libc::EPERM)?;
    if work == Work::Run {
        // Its arguments lie in memory, where no filter can look. Told that it is not there, libraries use `clone`.
        refuse(BTreeMap::from([(libc::SYS_clone3, Vec::new())]), libc::ENOSYS)?;
    }
    Some(())
}

fn rule(argument: u8, operator: SeccompCmpOp, value: u64) -> Option<SeccompRule> {
    let condition = SeccompCondition::new(argument, SeccompCmpArgLen::Dword, operator, value).ok()?;
    SeccompRule::new(vec![condition]).ok()
}

fn refuse(mut rules: BTreeMap<i64, Vec<SeccompRule>>, error: i32) -> Option<()> {
    // The second set of numbers of this machine leads to the same calls.
    if cfg!(target_arch = "x86_64") {
        let again: Vec<_> = rules.iter().map(|(call, rules)| (call | 0x4000_0000, rules.clone())).collect();
        rules.extend(again);
    }
    let action = SeccompAction::Errno(error as u32);
    let filter = SeccompFilter::new(rules, SeccompAction::Allow, action, std::env::consts::ARCH.try_into().ok()?);
    let program: BpfProgram = filter.ok()?.try_into().ok()?;
    apply_filter(&program).ok()
}
