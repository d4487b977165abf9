//! Misbehave: `farop __misbehave KIND` does what a student's program may do, so that `farop check extremes` sees it contained.
//!
//! farop -starts-> farop __jail -becomes-> farop __misbehave KIND
//!
//! Why farop itself and not a script: it is there wherever farop is; no compiler and no shell is asked for.

use super::{Door, External, HOST, Limits};
use std::ffi::OsStr;
use std::io::Write;

/// More than any limit of the check; where memory has none, this is the end.
const MEMORY: usize = 1 << 30;

impl External {
    /// A program of that kind (`picture` is a good one: one black sample); `None` where this program cannot start itself.
    #[must_use]
    pub fn misbehaving(kind: &str, limits: Limits) -> Option<External> {
        let host = HOST.get()?;
        let words = vec![host.clone().into(), "__misbehave".into(), kind.into()];
        Some(External {
            name: format!("__misbehave {kind}"),
            door: Door::Command(words),
            limits,
            host: Some(host.clone()),
        })
    }
}

/// Behaves as `kind` says; the exit code where there is one.
#[must_use]
pub fn misbehave(kind: &OsStr) -> u8 {
    let mut out = std::io::stdout().lock();
    let written = match kind.to_str().unwrap_or_default() {
        "picture" => out.write_all(b"P6\n1 1\n255\n\0\0\0"),
        "talk" => out.write_all(b"drawing polygon 1 of 1\nP6\n1 1\n255\n\0\0\0"),
        "flood" => std::iter::repeat_with(|| out.write_all(&[b'x'; 1 << 16])).find(Result::is_err).unwrap_or(Ok(())),
        "memory" => {
            let mut kept: Vec<Vec<u8>> = Vec::new();
            while kept.len() << 24 < MEMORY {
                kept.push(vec![1; 1 << 24]);
            }
            Ok(())
        }
        "loop" => loop {
            std::hint::spin_loop();
        },
        "crash" => std::process::abort(),
        other => return reach(other).unwrap_or(0),
    };
    u8::from(written.is_err())
}

/// Reaches out of a jail for graded submissions in one way; 0 where that worked, 1 where it was refused, none for an unknown way.
fn reach(way: &str) -> Option<u8> {
    let is_done = match way {
        "read" => std::fs::read("/etc/passwd").is_ok(),
        "write" => std::env::temp_dir().parent().is_some_and(|above| {
            let file = above.join("farop-was-here");
            std::fs::write(&file, "x").map(|()| std::fs::remove_file(&file)).is_ok()
        }),
        "keep" => std::fs::write("farop-was-here", "x").is_ok(),
        "socket" => std::net::UdpSocket::bind("127.0.0.1:0").is_ok(),
        "start" => std::process::Command::new("/bin/true").status().is_ok(),
        #[cfg(unix)]
        "leave" => nix::unistd::setsid().is_ok(),
        #[cfg(unix)]
        "signal" => nix::sys::signal::kill(nix::unistd::getppid(), None).is_ok(),
        #[cfg(unix)]
        "root" => nix::unistd::geteuid().is_root(),
        _ => return None,
    };
    Some(u8::from(!is_done))
}
