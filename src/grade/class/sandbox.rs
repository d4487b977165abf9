//! Sandbox: what every submission of a class is compiled and run in, and whether this machine can hold it.
//!
//! settings -SANDBOX-> limits of a compiler, limits of a run; a probe -> layers
//!
//! Not as root: for root the number of processes is not limited, and files are closed to nobody. Where the grader is root, the child becomes
//! `nobody` (65534), who owns nothing. Where a layer is missing, a class is not graded, unless that was asked for; the verdicts say it then.

use crate::raster::external::{Enforced, External, Limits, Strict, Work};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The user without files.
const NOBODY: u32 = 65534;

/// What holds submissions.
#[derive(Clone, Debug)]
pub struct Sandbox {
    /// Whom a submission runs as; none: as the grader.
    user: Option<u32>,
    /// Submissions are run even where layers are missing.
    may_miss: bool,
    /// What was found in force.
    pub enforced: Enforced,
    /// Time for a picture, or for an answer of a function.
    time: Duration,
}

/// Time for a picture where nobody says otherwise: those of labs are small.
const TIME: Duration = Duration::from_secs(5);

impl Sandbox {
    /// The sandbox of this machine, tried out with a harmless program.
    ///
    /// * `as_root`: where the grader is root, submissions are, too.
    /// * `may_miss`: a missing layer is no error.
    ///
    /// # Errors
    /// In words, which layer is missing and what to do.
    pub fn new(as_root: bool, may_miss: bool) -> Result<Sandbox, String> {
        let user = (is_root() && !as_root).then_some(NOBODY);
        let mut sandbox = Sandbox { user, may_miss: may_miss || as_root, enforced: Enforced::default(), time: TIME };
        sandbox.enforced = sandbox.probe()?;
        let missing: Vec<_> = sandbox.missing().into_iter().filter(|name| !(as_root && *name == "user")).collect();
        if missing.is_empty() || may_miss {
            return Ok(sandbox);
        }
        Err(format!(
            "submissions cannot be held safely here; missing: {}\nhelp: {}",
            missing.join(", "),
            advice(&missing)
        ))
    }

    /// The same with that much time for a picture.
    #[must_use]
    pub fn with_time(self, time: Duration) -> Sandbox {
        Sandbox { time, ..self }
    }

    /// The layers that are missing.
    #[must_use]
    pub fn missing(&self) -> Vec<&'static str> {
        let (all, processes) = (self.enforced.layers(), ("processes", self.enforced.processes));
        all.into_iter().chain([processes]).filter(|(_, on)| !on).map(|(name, _)| name).collect()
    }

    /// The layers that are in force.
    #[must_use]
    pub fn layers(&self) -> Vec<&'static str> {
        let (all, processes) = (self.enforced.layers(), ("processes", self.enforced.processes));
        all.into_iter().chain([processes]).filter(|(_, on)| *on).map(|(name, _)| name).collect()
    }

    /// Whom submissions run as, where that is somebody else.
    #[must_use]
    pub fn user(&self) -> Option<u32> {
        self.user
    }

    /// Limits of a compiler that works in `cell`.
    #[must_use]
    pub fn build(&self, cell: &Path, lent: Vec<PathBuf>) -> Limits {
        Limits {
            wall: Duration::from_secs(60),
            memory: 4 << 30,
            output: 1 << 20,
            file: 256 << 20,
            strict: Some(Box::new(self.strict(cell, Work::Build, lent))),
            ..Limits::default()
        }
    }

    /// Limits of a submission that lies in `cell`.
    #[must_use]
    pub fn run(&self, cell: &Path, lent: Vec<PathBuf>) -> Limits {
        let strict = Some(Box::new(self.strict(cell, Work::Run, lent)));
        Limits { wall: self.time, strict, ..Limits::default() }
    }

    fn strict(&self, cell: &Path, work: Work, lent: Vec<PathBuf>) -> Strict {
        Strict { folder: cell.to_path_buf(), work, lent, user: self.user, may_miss: self.may_miss }
    }

    /// What is in force while farop itself behaves as `kind` says in a cell of its own; see [`crate::raster::external::misbehave`].
    ///
    /// # Errors
    /// In words, when this program cannot start itself.
    pub fn try_out(&self, kind: &str) -> Result<(Enforced, bool), String> {
        let folder = tempfile::Builder::new().prefix("farop-sandbox-").tempdir().map_err(|error| error.to_string())?;
        open_folder(folder.path())?;
        let host = crate::raster::external::host().ok_or("this program cannot start itself in a jail")?;
        let held = Sandbox { may_miss: true, ..self.clone() };
        let limits = held.run(folder.path(), vec![host.to_path_buf()]);
        let words = vec![host.into(), "__misbehave".into(), kind.into()];
        let run = crate::raster::external::run(&words, &limits).map_err(|failure| failure.to_string())?;
        Ok((run.enforced, run.failure.is_none()))
    }

    fn probe(&self) -> Result<Enforced, String> {
        External::misbehaving("picture", Limits::default()).ok_or("this program cannot start itself in a jail")?;
        Ok(self.try_out("picture")?.0)
    }
}

/// Lets others through a folder, and into nothing that they do not know the name of.
pub(super) fn open_folder(path: &Path) -> Result<(), String> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = std::fs::Permissions::from_mode(0o711);
        std::fs::set_permissions(path, mode).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    let _ = path;
    Ok(())
}

#[cfg(unix)]
fn is_root() -> bool {
    nix::unistd::geteuid().is_root()
}

#[cfg(not(unix))]
fn is_root() -> bool {
    false
}

fn advice(missing: &[&str]) -> String {
    let layer = |name: &str| match name {
        "files" => "files need Landlock: Linux 5.19 or newer, `landlock` among the modules of security at start",
        "network" | "calls" => "network and calls need seccomp: a kernel, or a container, that allows filters",
        "user" => "grade as an ordinary user (as root, the child must be able to become `nobody`), or say --as-root",
        "resources" => "resources need setrlimit: leave limits of the shell alone",
        _ => "Linux is needed; elsewhere grade in a container or a virtual machine with Linux",
    };
    let mut lines: Vec<_> = missing.iter().map(|name| layer(name)).collect();
    lines.dedup();
    format!("{}\n      or, where no submission is worse than wrong: --unsafe-no-sandbox", lines.join("\n      "))
}
