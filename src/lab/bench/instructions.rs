//! Instructions: how many a frame takes, counted by valgrind.
//!
//! Why: times on a shared machine move by a tenth from minute to minute, counts by next to nothing. They are no times: an instruction
//! that waits for memory costs a hundred that do not. valgrind knows no AVX-512, so what is counted is the path for AVX2.
//!
//! How: the same command draws a few frames and a few more under valgrind; the difference is the frames alone, without start, parsing
//! and warm-up.

use std::ffi::OsString;
use std::process::Command;

/// Frames of the short run, and how many more the long run draws.
const FRAMES: (u64, u64) = (1, 2);

/// Instructions of one frame of `program` with `arguments`, which draw the frames that `--rounds` behind them says.
///
/// # Errors
/// A message: there is no valgrind, or it could not run the program.
pub fn of_a_frame(program: &std::path::Path, arguments: &[OsString]) -> Result<u64, String> {
    let short = count(program, arguments, FRAMES.0)?;
    let long = count(program, arguments, FRAMES.0 + FRAMES.1)?;
    Ok(long.saturating_sub(short) / FRAMES.1)
}

fn count(program: &std::path::Path, arguments: &[OsString], frames: u64) -> Result<u64, String> {
    let mut command = Command::new("valgrind");
    command.args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]);
    command.arg(program).args(arguments).arg("--rounds").arg(frames.to_string());
    let output = command.output().map_err(|error| format!("valgrind does not start ({error}): install it"))?;
    let said = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        let last = said.lines().rev().find(|line| !line.starts_with("==")).unwrap_or("no message");
        return Err(format!("the program does not run under valgrind: {last}"));
    }
    total(&said).ok_or_else(|| "valgrind does not tell the instructions".to_string())
}

/// The number in valgrind's line `I refs: 1,234`.
fn total(said: &str) -> Option<u64> {
    let line = said.lines().find(|line| line.contains("refs:"))?;
    let digits: String = line.split("refs:").nth(1)?.chars().filter(char::is_ascii_digit).collect();
    digits.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_is_found_in_what_valgrind_says() {
        assert_eq!(total("==7== Cachegrind\n==7== I refs:        1,234,567\n"), Some(1_234_567));
        assert_eq!(total("==7== I   refs:      89\n"), Some(89));
        assert_eq!(total("nothing"), None);
    }
}
