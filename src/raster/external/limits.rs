//! Limits for programs that are not farop's, and which of them the system really enforced.

use super::strict::Strict;
use std::fmt;
use std::path::PathBuf;
use std::time::Duration;

/// What a program may use to draw one picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Wall-clock time a picture.
    pub wall: Duration,
    /// Address space of a process, bytes.
    pub memory: u64,
    /// Bytes on standard output.
    pub output: u64,
    /// Bytes it may write into a file; 0: it may not write files at all.
    pub file: u64,
    /// Processes at a time.
    pub processes: u64,
    /// Folders and files it may read; empty: all of them.
    pub readable: Vec<PathBuf>,
    /// How a submission that is graded is held; none for programs that users start for themselves.
    pub strict: Option<Box<Strict>>,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            wall: Duration::from_secs(10),
            memory: 512 << 20,
            output: 64 << 20,
            file: 0,
            processes: 16,
            readable: Vec::new(),
            strict: None,
        }
    }
}

impl Limits {
    /// Processor time: of several threads together it may be more than the wall-clock time.
    fn processor_seconds(&self) -> u64 {
        self.wall.as_secs().max(1) * 4
    }

    /// As arguments of `farop __jail`; the other limits are the parent's business.
    pub(super) fn to_arguments(&self) -> Vec<std::ffi::OsString> {
        let numbers = format!("{},{},{},{}", self.processor_seconds(), self.memory, self.file, self.processes);
        match &self.strict {
            Some(strict) => {
                let (words, paths) = strict.to_arguments();
                std::iter::once((numbers + &words).into()).chain(paths).collect()
            }
            None => {
                let readable = self.readable.iter().map(|path| path.clone().into());
                std::iter::once(numbers.into()).chain(readable).collect()
            }
        }
    }

    /// What [`Limits::to_arguments`] wrote, with the wall-clock limit still four times too long: it bounds processor time.
    pub(super) fn from_arguments(arguments: &[std::ffi::OsString]) -> Option<Limits> {
        let (words, paths) = arguments.split_first()?;
        let words: Vec<&str> = words.to_str()?.split(',').collect();
        let (numbers, strict) = words.split_at_checked(4)?;
        let numbers: Option<Vec<u64>> = numbers.iter().map(|number| number.parse().ok()).collect();
        let [seconds, memory, file, processes] = numbers?[..] else { return None };
        let limits = Limits { wall: Duration::from_secs(seconds), memory, file, processes, ..Limits::default() };
        if strict.is_empty() {
            return Some(Limits { readable: paths.iter().map(PathBuf::from).collect(), ..limits });
        }
        Some(Limits { strict: Some(Box::new(Strict::from_arguments(strict, paths)?)), ..limits })
    }
}

/// Which protections were in force while a program ran.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Enforced {
    /// Memory, file sizes, open files, processor time (`setrlimit`).
    pub resources: bool,
    /// No file can be written, and only the allowed ones can be read (Landlock).
    pub files: bool,
    /// No network, no new sessions or process groups (seccomp).
    pub network: bool,
    /// The number of processes is watched, and all of them are ended together.
    pub processes: bool,
    /// No new processes, no signals to others, no memory of others (seccomp); only of a submission that is graded.
    pub calls: bool,
    /// It does not run as root; only known of a submission that is graded.
    pub user: bool,
}

impl Enforced {
    const NAMES: [&'static str; 5] = ["resources", "files", "network", "calls", "user"];

    /// What a graded submission must be held by, in the words of reports, and whether it is.
    #[must_use]
    pub fn layers(self) -> [(&'static str, bool); 5] {
        let Enforced { resources, files, network, calls, user, .. } = self;
        let mut all = Self::NAMES.into_iter().zip([resources, files, network, calls, user]);
        std::array::from_fn(|_| all.next().unwrap_or_default())
    }

    /// The first of [`Enforced::layers`] that is missing.
    pub(super) fn first_missing(self) -> Option<&'static str> {
        self.layers().into_iter().find(|(_, on)| !on).map(|(name, _)| name)
    }

    /// One word for each protection that the jail itself sets up.
    pub(super) fn words(self) -> String {
        self.layers().into_iter().filter(|(_, on)| *on).map(|(name, _)| name).collect::<Vec<_>>().join(" ")
    }

    /// What [`Enforced::words`] wrote.
    pub(super) fn from_words(words: &str) -> Enforced {
        let on = Self::NAMES.map(|name| words.split(' ').any(|word| word == name));
        let [resources, files, network, calls, user] = on;
        Enforced { resources, files, network, processes: false, calls, user }
    }
}

/// Limits, and which of them were in force while a picture was drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Confinement {
    /// What was asked for.
    pub limits: Limits,
    /// What the system enforced of it.
    pub enforced: Enforced,
}

impl Confinement {
    /// For programs: `null` in place of a limit that was not in force.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let Confinement { limits, enforced } = self;
        let resources = |limit: u64| enforced.resources.then_some(limit);
        serde_json::json!({
            "limits": {
                "time_s": limits.wall.as_secs_f64(),
                "output_bytes": limits.output,
                "memory_bytes": resources(limits.memory),
                "processor_time_s": resources(limits.processor_seconds()),
                "processes": enforced.processes.then_some(limits.processes),
            },
            "network_denied": enforced.network,
            "writes_denied": enforced.files,
            "reads_confined": enforced.files && !limits.readable.is_empty(),
        })
    }
}

impl fmt::Display for Enforced {
    /// In one sentence, what was enforced and what was not.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all = [
            (self.resources, "memory and processor time"),
            (self.files, "files"),
            (self.network, "no network"),
            (self.processes, "processes"),
        ];
        let named = |wanted: bool| {
            all.iter().filter(|(on, _)| *on == wanted).map(|(_, name)| *name).collect::<Vec<_>>().join(", ")
        };
        write!(f, "enforced: time, output")?;
        let (on, off) = (named(true), named(false));
        if !on.is_empty() {
            write!(f, ", {on}")?;
        }
        if !off.is_empty() {
            write!(f, "; NOT enforced here: {off}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::strict::Work;
    use super::*;

    #[test]
    fn limits_survive_the_command_line() {
        let limits = Limits { memory: 7, readable: vec!["/usr".into(), "/lib".into()], ..Limits::default() };
        let read = Limits::from_arguments(&limits.to_arguments()).expect("our own words");
        assert_eq!(read, Limits { wall: limits.wall * 4, ..limits });
        assert_eq!(Limits::from_arguments(&["1,2".into()]), None);
        let (folder, lent) = ("/tmp/a b".into(), vec!["/opt/x".into()]);
        let strict = Strict { folder, work: Work::Build, lent, user: Some(9), may_miss: false };
        let limits = Limits { strict: Some(Box::new(strict)), ..Limits::default() };
        let read = Limits::from_arguments(&limits.to_arguments()).expect("our own words");
        assert_eq!(read, Limits { wall: limits.wall * 4, ..limits });
    }

    #[test]
    fn a_limit_that_is_not_in_force_is_null() {
        let enforced = Enforced { resources: true, files: true, ..Enforced::default() };
        let json = Confinement { limits: Limits::default(), enforced }.json();
        assert_eq!(
            (&json["limits"]["memory_bytes"], &json["limits"]["processor_time_s"]),
            (&(512 << 20).into(), &40.into())
        );
        assert!(json["limits"]["processes"].is_null());
        assert_eq!([&json["network_denied"], &json["writes_denied"], &json["reads_confined"]], [false, true, false]);
    }

    #[test]
    fn what_is_not_enforced_is_said() {
        let some = Enforced::from_words("resources network");
        assert_eq!(some, Enforced { resources: true, network: true, ..Enforced::default() });
        assert_eq!(some.words(), "resources network");
        assert!(some.to_string().ends_with("NOT enforced here: files, processes"), "{some}");
    }
}
