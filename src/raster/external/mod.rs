//! Rasterizers outside farop: a program in any language (`exec:COMMAND`) or a C library (`lib:PATH`).
//!
//! DrawList -v2 screen file-> program's standard input; its standard output -picture-> target
//!
//! Submissions that are graded come by the same doors, held more tightly: [`Strict`].
//!
//! One contract for both: the list goes out as a v2 screen file with `encoding linear`, one picture comes back. A library
//! is loaded by a second farop (`farop __host lib:PATH`) that speaks the same protocol, so one jail serves both, and no crash and no
//! endless loop of a student's code ever ends this process. `docs/doors.md` is the student's page.
//!
//! Why a picture and not fragments: a picture is what every language can write with three lines of code. What it costs: farop does
//! not know which polygon was put where, so blending is the program's own work.
//!
//! Pictures on surfaces do not go out: programs get the light of the surfaces alone ([`DrawList::without_texture`]), and say with
//! `--stats` how many polygons that were.
//!
//! Space: samples. With A x A samples a pixel the program draws the picture A times larger, as every rasterizer does.
//! Cost: the text of the list, a start of the program, and the bytes of the picture; for every band of a picture that is drawn in bands.

mod answer;
#[cfg(target_os = "linux")]
mod confine;
mod failure;
mod jail;
mod library;
mod limits;
mod misbehave;
mod process;
mod strict;

pub use answer::{write_floats, write_remarked};
pub use failure::ExternalFailure;
pub use jail::enter as enter_jail;
pub use library::{layout as library_layout, serve as serve_library};
pub use limits::{Confinement, Enforced, Limits};
pub use misbehave::misbehave;
pub use process::Run;
pub use strict::{Strict, Work};

use super::{Rasterizer, Target};
use crate::color::{Encoding, Rgb};
use crate::image::Image;
use crate::screen::DrawList;
use crate::screen::file::{Attributes, Sheet, write_v2};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// What the host of a library writes before it gives up.
const LIBRARY_ERROR: &str = "farop-host: ";

/// The program that answers to `__jail` and `__host`.
static HOST: OnceLock<PathBuf> = OnceLock::new();

/// Says that this very program answers to `__jail` and `__host`: its `main` is farop's command line.
pub fn this_program_is_host() {
    if let Ok(path) = std::env::current_exe() {
        let _ = HOST.set(path);
    }
}

/// The program that answers to `__jail` and `__host`, if this process has one.
#[must_use]
pub fn host() -> Option<&'static Path> {
    HOST.get().map(PathBuf::as_path)
}

/// Runs a program of other people, a compiler for example, within `limits`, with nothing on standard input.
///
/// # Errors
/// [`ExternalFailure::CannotStart`]; all else is in the result.
pub fn run(words: &[OsString], limits: &Limits) -> Result<Run, ExternalFailure> {
    ask(words, Vec::new(), limits)
}

/// As [`run`], with `input` on standard input.
///
/// # Errors
/// As [`run`].
pub fn ask(words: &[OsString], input: Vec<u8>, limits: &Limits) -> Result<Run, ExternalFailure> {
    process::run(words, host(), input, limits)
}

/// A rasterizer outside farop.
#[derive(Clone, Debug)]
pub struct External {
    name: String,
    door: Door,
    limits: Limits,
    host: Option<PathBuf>,
}

#[derive(Clone, Debug)]
enum Door {
    /// A program and its arguments.
    Command(Vec<OsString>),
    /// A shared library.
    Library(PathBuf),
}

/// A picture from outside, and what was in force while it was drawn.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Linear light, the size of the list.
    pub image: Image,
    /// Which limits the system enforced.
    pub enforced: Enforced,
    /// What a program of ours says besides: see [`write_remarked`].
    pub remark: Option<String>,
}

impl External {
    /// The rasterizer that `exec:COMMAND` or `lib:PATH` names; `None` for any other name.
    ///
    /// Words of a command are separated by blanks; quotes `"` and `'` keep blanks. There is no shell.
    #[must_use]
    pub fn from_name(name: &str) -> Option<External> {
        let door = match name.split_once(':')? {
            ("exec", command) => Door::Command(words(command)),
            ("lib", path) => Door::Library(path.into()),
            _ => return None,
        };
        Some(External::behind(name, door))
    }

    /// The rasterizer that `words`, a program and its arguments, start; `name` stands in reports.
    #[must_use]
    pub fn program(name: &str, words: Vec<OsString>) -> External {
        External::behind(name, Door::Command(words))
    }

    /// The rasterizer in the shared library at `path`; `name` stands in reports.
    #[must_use]
    pub fn library(name: &str, path: PathBuf) -> External {
        External::behind(name, Door::Library(path))
    }

    fn behind(name: &str, door: Door) -> External {
        External { name: name.to_string(), door, limits: Limits::default(), host: HOST.get().cloned() }
    }

    /// The same with other limits.
    #[must_use]
    pub fn with_limits(self, limits: Limits) -> External {
        External { limits, ..self }
    }

    /// The same with `host` as the program that answers to `__jail` and `__host`. Needed where the program that runs is not
    /// farop or a student's lab program, as in tests; without one, a program runs with limits on time and output only.
    #[must_use]
    pub fn with_host(self, host: impl Into<PathBuf>) -> External {
        External { host: Some(host.into()), ..self }
    }

    /// What was asked for: `exec:...` or `lib:...`.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its limits.
    #[must_use]
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// The picture of `list` on `sheet`: `list.width` x `list.height` samples of linear light.
    ///
    /// # Errors
    /// [`ExternalFailure`] for everything that may go wrong; nothing the program does reaches further.
    pub fn picture(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, ExternalFailure> {
        let text = text_of(list, sheet)?;
        let run = process::run(&self.words()?, self.host.as_deref(), text, &self.limits)?;
        match run.failure {
            Some(failure) => Err(self.complete(failure, list)),
            None => {
                let image = answer::read(&run.stdout, (list.width, list.height), &run.stderr)?;
                Ok(Answer { image, enforced: run.enforced, remark: answer::remark(&run.stdout) })
            }
        }
    }

    /// The pictures of many lists: from one run of a program that goes on to the next file, from a run each of one that does not.
    ///
    /// In the one run a slow picture, a crash, or pictures that are not exactly those asked for decide nothing: then each list gets
    /// its own run and its own verdict.
    #[must_use]
    pub fn pictures(&self, lists: &[DrawList], sheet: &Sheet) -> Vec<Result<Answer, ExternalFailure>> {
        match self.at_once(lists, sheet) {
            Some(answers) => answers.into_iter().map(Ok).collect(),
            None => lists.iter().map(|list| self.picture(list, sheet)).collect(),
        }
    }

    /// The pictures of many lists from one run; `None` where there is fault with any of them, or the program draws only one.
    #[must_use]
    pub fn at_once(&self, lists: &[DrawList], sheet: &Sheet) -> Option<Vec<Answer>> {
        if lists.len() < 2 {
            return None;
        }
        let texts = lists.iter().map(|list| text_of(list, sheet)).collect::<Result<Vec<_>, _>>().ok()?;
        let run = process::run(&self.words().ok()?, self.host.as_deref(), texts.concat(), &self.limits).ok()?;
        if run.failure.is_some() {
            return None;
        }
        let images = answer::read_all(&run.stdout, lists.iter().map(|list| (list.width, list.height)))?;
        let answer = |(image, remark)| Answer { image, enforced: run.enforced, remark };
        Some(images.into_iter().map(answer).collect())
    }

    /// The command to start.
    fn words(&self) -> Result<Vec<OsString>, ExternalFailure> {
        match (&self.door, &self.host) {
            (Door::Command(words), _) if !words.is_empty() => Ok(words.clone()),
            (Door::Command(_), _) => Err(ExternalFailure::CannotStart {
                program: self.name.clone(),
                reason: "a command follows `exec:`, as in exec:\"python3 zbuffer.py\"".to_string(),
            }),
            (Door::Library(path), Some(host)) => {
                let mut name = OsString::from("lib:");
                name.push(path);
                Ok(vec![host.clone().into(), "__host".into(), name])
            }
            (Door::Library(_), None) => Err(ExternalFailure::Library("this program cannot host one".to_string())),
        }
    }

    /// Fills in what only this place knows.
    fn complete(&self, failure: ExternalFailure, list: &DrawList) -> ExternalFailure {
        match failure {
            ExternalFailure::TooMuchOutput { limit, .. } => {
                let picture = u64::from(list.width) * u64::from(list.height) * 3;
                ExternalFailure::TooMuchOutput { limit, picture }
            }
            ExternalFailure::CannotStart { program, reason } if program.is_empty() => {
                let program = match &self.door {
                    Door::Command(words) => words.first().map(|word| word.to_string_lossy().into_owned()),
                    Door::Library(path) => Some(path.display().to_string()),
                };
                ExternalFailure::CannotStart { program: program.unwrap_or_default(), reason }
            }
            other => other,
        }
    }
}

impl Rasterizer for External {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        let (background, transparency) = (target.background(), target.transparency());
        let sheet = Sheet { background, transparency, ..Sheet::default() };
        if list.has_texture() {
            target.count("textured polygons sent in colors alone", list.textured_polygons() as u64);
        }
        match self.picture(list, &sheet) {
            Ok(answer) => {
                target.confined(Confinement { limits: self.limits.clone(), enforced: answer.enforced });
                show(&answer.image, target);
            }
            Err(failure) => target.fail(format!("{}: {failure}", self.name)),
        }
    }
}

/// What the program reads: the list in linear light and without pictures on surfaces, for a picture of its own samples.
fn text_of(list: &DrawList, sheet: &Sheet) -> Result<Vec<u8>, ExternalFailure> {
    let sheet = Sheet { samples: 1, encoding: Encoding::Linear, ..*sheet };
    let mut text = Vec::new();
    let plain;
    let list = if list.has_texture() {
        plain = list.without_texture();
        &plain
    } else {
        list
    };
    let written = write_v2(list, &sheet, Attributes::default(), &mut text);
    written.map(|()| text).map_err(|error| ExternalFailure::CannotSend(error.to_string()))
}

fn show(image: &Image, target: &mut Target<'_>) {
    for y in target.row_range() {
        for (x, &light) in image.row(y as usize).iter().enumerate() {
            target.show(x as i32, y, light);
        }
    }
}

/// The words of a command: separated by blanks, quotes keep blanks.
fn words(command: &str) -> Vec<OsString> {
    let (mut words, mut word, mut quote) = (Vec::new(), None::<String>, None);
    for letter in command.chars() {
        match (letter, quote) {
            (_, Some(open)) if letter == open => quote = None,
            (_, Some(_)) => word.get_or_insert_default().push(letter),
            ('"' | '\'', None) => {
                quote = Some(letter);
                word.get_or_insert_default();
            }
            (' ', None) => words.extend(word.take()),
            (_, None) => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words.into_iter().map(OsString::from).collect()
}

/// The light behind everything, as three numbers.
fn background(sheet: &Sheet) -> [f32; 3] {
    let Rgb { r, g, b } = sheet.background;
    [r, g, b]
}

/// Whether `path` names a file that is there, or what to say.
fn existing(path: &Path) -> Result<PathBuf, String> {
    // The loader searches system folders for a bare name; a path with a folder is taken as it is.
    path.canonicalize().map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_keep_blanks() {
        assert_eq!(words(r#" python3  "my zbuffer.py" 'a"b' "" "#), ["python3", "my zbuffer.py", "a\"b", ""]);
        assert_eq!(words(""), Vec::<OsString>::new());
    }

    #[test]
    fn other_names_are_no_doors() {
        assert!(External::from_name("zbuffer").is_none() && External::from_name("spd:gears").is_none());
        let empty = External::from_name("exec:").expect("a door").picture(&DrawList::new(2, 2), &Sheet::default());
        assert_eq!(empty.expect_err("nothing to start").name(), "cannot-start");
    }
}
