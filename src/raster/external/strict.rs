//! Strict: what holds a submission that is graded, beyond what holds any program outside.
//!
//! grader -STRICT-> farop __jail -becomes-> compiler or submission
//!
//! A program that a user starts for himself may read his files: they are his. One that is graded may not: the results, the other
//! submissions and the right pictures are on the same disk. So it sees the system's programs and libraries, its own folder, and
//! what is lent to it by name. A compiler may write into that folder and start its parts; a submission may do neither.
//!
//! Where the grader is root, the child becomes another user. What is lent may lie in folders closed to that user (a tool chain in
//! `/root`): so it is opened before, and reached as `/proc/self/fd/N`, which asks nobody about the folders above.

use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// Where the system keeps programs and libraries, and the few files that they ask for.
#[cfg(target_os = "linux")]
pub(super) const SYSTEM: [&str; 14] = [
    "/usr",
    "/bin",
    "/lib",
    "/lib32",
    "/lib64",
    "/etc/ld.so.cache",
    "/etc/alternatives",
    "/etc/localtime",
    "/dev/null",
    "/dev/zero",
    "/dev/urandom",
    "/proc/self",
    "/proc/cpuinfo",
    "/proc/meminfo",
];

/// What is confined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A compiler: it may write into its folder, and start its parts.
    Build,
    /// A submission: it may write nothing, start nothing, and signal nobody.
    Run,
}

/// How a graded submission is held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Strict {
    /// Its own folder, absolute: where it starts, and what `HOME` and `TMPDIR` say.
    pub folder: PathBuf,
    /// What it does there.
    pub work: Work,
    /// Folders and files that it may read besides its own and the system's.
    pub lent: Vec<PathBuf>,
    /// The number of the user that it becomes; none, and it stays who the grader is.
    pub user: Option<u32>,
    /// It is started even where a protection is missing.
    pub may_miss: bool,
}

impl Strict {
    /// What stands behind the numbers of the limits, and the paths behind that.
    pub(super) fn to_arguments(&self) -> (String, impl Iterator<Item = OsString>) {
        let work = if self.work == Work::Build { "build" } else { "run" };
        let user = self.user.map_or("-".to_string(), |user| user.to_string());
        let missing = if self.may_miss { "some" } else { "all" };
        let paths = std::iter::once(&self.folder).chain(&self.lent);
        (format!(",{work},{user},{missing}"), paths.map(|path| path.clone().into()))
    }

    /// What [`Strict::to_arguments`] wrote.
    pub(super) fn from_arguments(words: &[&str], paths: &[OsString]) -> Option<Strict> {
        let ([work, user, missing], [folder, lent @ ..]) = (words, paths) else { return None };
        Some(Strict {
            folder: folder.into(),
            work: if *work == "build" { Work::Build } else { Work::Run },
            lent: lent.iter().map(PathBuf::from).collect(),
            user: if *user == "-" { None } else { Some(user.parse().ok()?) },
            may_miss: *missing == "some",
        })
    }

    /// All that the program finds in its environment.
    pub(super) fn environment(&self) -> Vec<(&'static str, OsString)> {
        let libraries: Vec<_> = self.lent.iter().map(|folder| folder.join("lib")).collect();
        let mut all = vec![
            ("PATH", "/usr/local/bin:/usr/bin:/bin".into()),
            ("LANG", "C.UTF-8".into()),
            ("HOME", self.folder.clone().into()),
            ("TMPDIR", self.folder.clone().into()),
        ];
        if self.work == Work::Build {
            // A tool chain that is reached through an open folder does not find its own libraries beside it.
            all.push(("LD_LIBRARY_PATH", std::env::join_paths(libraries).unwrap_or_default()));
        }
        all
    }
}

/// Open folders and files, with the names under which they are reached.
#[derive(Default)]
pub(super) struct Lent {
    names: Vec<(PathBuf, String)>,
    /// Closed only when this process ends or becomes another one, which inherits them.
    _open: Vec<std::fs::File>,
}

impl Lent {
    /// Opens all that can be opened; only for a process that is about to become another user.
    #[cfg(target_os = "linux")]
    pub fn open(strict: &Strict) -> Lent {
        use nix::fcntl::{FcntlArg, FdFlag, fcntl};
        use std::os::fd::AsRawFd;
        let mut lent = Lent::default();
        for path in strict.lent.iter().filter(|_| strict.user.is_some()) {
            let Ok(file) = std::fs::File::open(path) else { continue };
            if fcntl(&file, FcntlArg::F_SETFD(FdFlag::empty())).is_ok() {
                lent.names.push((path.clone(), format!("/proc/self/fd/{}", file.as_raw_fd())));
                lent._open.push(file);
            }
        }
        lent
    }

    /// Elsewhere nothing is lent.
    #[cfg(not(target_os = "linux"))]
    pub fn open(_: &Strict) -> Lent {
        Lent::default()
    }

    /// `word` with the names of what is lent in place of its path.
    pub fn renamed(&self, word: &OsStr) -> OsString {
        let Some(text) = word.to_str() else { return word.to_os_string() };
        let rename = |text: String, (path, name): &(PathBuf, String)| match path.to_str() {
            Some(path) => text.replace(path, name),
            None => text,
        };
        self.names.iter().fold(text.to_string(), rename).into()
    }
}
