//! Snapshot: picture tests for farop and for every crate that uses it.
//!
//! picture -> [`assert_picture!`] -> passes, or fails and shows expected | difference | actual
//!
//! An accepted picture is two files of the calling crate: `tests/images/NAME.png`, which is compared pixel by pixel
//! after decoding (a newer compressor changes bytes, not pixels), and `tests/snapshots/NAME.snap`, which `insta`
//! compares: a [`summary`] of that PNG, so that a review without pictures still sees what changed.
//!
//! Nothing is ever accepted silently: a missing picture fails like a wrong one. `docs/snapshots.md` tells the rest.

pub use super::metrics::Tolerance;
pub use super::summary::{hash, summary};
pub use crate::assert_picture;
#[doc(hidden)]
pub use insta;

use super::metrics::{Comparison, compare, difference_picture, side_by_side};
use super::save::{SaveError, write_whole};
use super::{Image, ImageError, Picture, encode_for, read};
use crate::color::Encoding;
use std::borrow::Cow;
use std::fs;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// Set to `accept`, it makes every tested picture the accepted one; unset, empty or `check`, pictures are compared.
pub const VARIABLE: &str = "FAROP_PICTURES";

/// The picture of a failing test, in the names of files.
const ACTUAL: &str = "actual";
/// Expected | difference | actual, in the names of files.
const DIFFERENCE: &str = "diff";

/// Asserts that a picture is the accepted one, `tests/images/NAME.png` of the calling crate.
///
/// `assert_picture!(name, picture)` or `assert_picture!(name, picture, tolerance = Tolerance { .. })`. The picture is
/// anything [`IntoPicture`]: a `Picture`, or an `Image`, which is encoded as sRGB. Without a tolerance every pixel
/// must be equal. Names are made of letters, digits, `-`, `_` and `.`, and are unique in a crate.
///
/// ```no_run
/// use farop::image::Picture;
/// use farop::snapshot::{Tolerance, assert_picture};
/// let picture = Picture::filled(16, 16, [255, 0, 0]);
/// assert_picture!("red_square", &picture);
/// assert_picture!("red_square", &picture, tolerance = Tolerance { max_diff: 1, max_pixels: 0 });
/// ```
///
/// # Panics
/// When the picture is not the accepted one, or none is accepted yet; the message says how to look at it and how
/// to accept it.
#[macro_export]
macro_rules! assert_picture {
    ($name:expr, $picture:expr $(,)?) => {
        $crate::assert_picture!($name, $picture, tolerance = $crate::snapshot::Tolerance::EXACT)
    };
    // A `match`, because it keeps temporary values alive to its end. A macro and not a function, because folders
    // and source lines must be those of the calling crate.
    ($name:expr, $picture:expr, tolerance = $tolerance:expr $(,)?) => {
        match (::std::string::ToString::to_string(&$name), $crate::snapshot::IntoPicture::to_picture(&$picture)) {
            (name, picture) => {
                $crate::snapshot::Album::of_crate(env!("CARGO_MANIFEST_DIR"), option_env!("CARGO_TARGET_TMPDIR"))
                    .assert(&name, &picture, $tolerance, |text| {
                        $crate::snapshot::insta::assert_snapshot!(name.as_str(), text);
                    })
            }
        }
    };
}

/// What [`assert_picture!`] takes.
pub trait IntoPicture {
    /// The display values to compare.
    fn to_picture(&self) -> Cow<'_, Picture>;
}

impl IntoPicture for Picture {
    fn to_picture(&self) -> Cow<'_, Picture> {
        Cow::Borrowed(self)
    }
}

impl IntoPicture for Image {
    fn to_picture(&self) -> Cow<'_, Picture> {
        Cow::Owned(self.encode(Encoding::Srgb))
    }
}

impl<T: IntoPicture + ?Sized> IntoPicture for &T {
    fn to_picture(&self) -> Cow<'_, Picture> {
        (**self).to_picture()
    }
}

/// Whether pictures are compared or accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Compare; the default.
    Check,
    /// Make the pictures that fail the accepted ones.
    Accept,
}

impl Mode {
    /// What the environment variable [`VARIABLE`] asks for, given its value.
    ///
    /// # Errors
    /// [`SnapshotError::UnknownMode`] for a value that means nothing: a mistyped `accept` must not pass for a check.
    pub fn of_variable(value: Option<&str>) -> Result<Mode, SnapshotError> {
        match value {
            None | Some("" | "check") => Ok(Mode::Check),
            Some("accept") => Ok(Mode::Accept),
            Some(other) => Err(SnapshotError::UnknownMode { value: other.to_string() }),
        }
    }
}

/// Why a picture does not pass.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SnapshotError {
    /// The name cannot be a file name everywhere.
    #[error(
        "`{name}` is no name for a picture: use letters, digits, `-`, `_` and `.`, and begin with a letter or digit"
    )]
    BadName {
        /// The name.
        name: String,
    },
    /// The variable has a value that means nothing.
    #[error("{VARIABLE} is `{value}`: set it to `accept` to accept pictures, or leave it unset to check them")]
    UnknownMode {
        /// Its value.
        value: String,
    },
    /// There is no accepted picture.
    #[error(
        "no picture is accepted yet for `{name}`: there is no `{}`.\n  actual   {shown}\nIf it is right, accept it: {}",
        golden.display(), accept_command()
    )]
    Missing {
        /// The picture's name.
        name: String,
        /// Where the accepted picture should be.
        golden: PathBuf,
        /// Where the actual one was written.
        shown: String,
    },
    /// The picture is not the accepted one.
    #[error(
        "picture `{name}` is not the accepted one.\n{comparison}\n  expected {}\n  actual   {actual}\n  \
         look at  {difference} (expected | difference | actual)\nIf the new one is right, accept it: {}",
        golden.display(), accept_command()
    )]
    Differs {
        /// The picture's name.
        name: String,
        /// Where and by how much it differs.
        comparison: Box<Comparison>,
        /// The accepted picture.
        golden: PathBuf,
        /// Where the actual one was written.
        actual: String,
        /// Where expected | difference | actual was written.
        difference: String,
    },
    /// The picture passes, but the text beside it is missing or tells of another one.
    #[error(
        "picture `{name}` is the accepted one, but `{}` is missing or does not describe it (see above).\n\
         If the PNG is right, write the text anew: {}",
        snap.display(), accept_command()
    )]
    Stale {
        /// The picture's name.
        name: String,
        /// The text.
        snap: PathBuf,
    },
    /// The accepted picture cannot be read.
    #[error("the accepted picture cannot be used: {error}\nTo replace it: {}", accept_command())]
    Golden {
        /// What is wrong with it.
        error: ImageError,
    },
    /// The picture cannot be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A file cannot be written.
    #[error(transparent)]
    Save(#[from] SaveError),
}

/// What to type to accept the picture of the running test.
fn accept_command() -> String {
    // The test harness names the thread after the test; with one thread it is the main one.
    let thread = std::thread::current();
    let test = thread.name().filter(|&name| name != "main").map(|name| format!(" {name}")).unwrap_or_default();
    format!("{VARIABLE}=accept cargo test{test}")
}

/// The folders of a crate's picture tests.
#[derive(Clone, Debug)]
pub struct Album {
    /// Accepted pictures.
    pub goldens: PathBuf,
    /// Their summaries.
    pub snaps: PathBuf,
    /// What failing tests leave behind to look at.
    pub failures: PathBuf,
}

impl Album {
    /// The folders of the crate whose `Cargo.toml` is in `manifest_folder`: `tests/images`, `tests/snapshots`, and
    /// `farop-pictures` in its target folder.
    ///
    /// `target_temporary` is cargo's `CARGO_TARGET_TMPDIR`, which only some tests know; where the target folder
    /// cannot be found, failures go to the system's temporary folder.
    #[must_use]
    pub fn of_crate(manifest_folder: &str, target_temporary: Option<&str>) -> Album {
        let manifest_folder = Path::new(manifest_folder);
        // Cargo marks the folder it builds in; the test that is running was built there.
        let is_target =
            |folder: &&Path| folder.join("CACHEDIR.TAG").exists() || folder.join(".rustc_info.json").exists();
        let program = std::env::current_exe().unwrap_or_default();
        let target = program.ancestors().skip(1).find(is_target).map(Path::to_path_buf);
        let target = target
            .or_else(|| target_temporary.and_then(|folder| Path::new(folder).parent()).map(Path::to_path_buf))
            .or_else(|| Some(manifest_folder.join("target")).filter(|folder| folder.is_dir()))
            .unwrap_or_else(std::env::temp_dir);
        Album {
            goldens: manifest_folder.join("tests/images"),
            snaps: manifest_folder.join("tests/snapshots"),
            failures: target.join("farop-pictures"),
        }
    }

    /// What [`assert_picture!`] does: compares or accepts as the environment says, then lets `insta` compare the text.
    ///
    /// `assert_text` asserts that its argument is the snapshot called `name`, in the calling crate.
    ///
    /// # Panics
    /// With a [`SnapshotError`] in words.
    #[track_caller]
    pub fn assert(&self, name: &str, picture: &Picture, tolerance: Tolerance, assert_text: impl FnOnce(&str)) {
        let variable = std::env::var(VARIABLE).ok();
        let outcome = Mode::of_variable(variable.as_deref()).and_then(|mode| {
            if mode == Mode::Accept {
                self.accept(name, picture, tolerance)?;
            }
            let golden = self.check(name, picture, tolerance)?;
            self.check_text(name, &golden, assert_text)
        });
        if let Err(error) = outcome {
            panic!("{error}");
        }
    }

    /// Compares `picture` with the accepted one and returns the accepted one.
    ///
    /// On failure the picture is left in the folder `failures`, alone and as expected | difference | actual.
    ///
    /// # Errors
    /// [`SnapshotError`] when they differ by more than the tolerance, or nothing is accepted yet.
    pub fn check(&self, name: &str, picture: &Picture, tolerance: Tolerance) -> Result<Picture, SnapshotError> {
        check_name(name)?;
        let path = self.golden(name);
        let golden = match read(&path) {
            Ok(golden) => golden,
            Err(ImageError::Read { source, .. }) if source.kind() == io::ErrorKind::NotFound => {
                let shown = self.show(name, ACTUAL, picture);
                return Err(SnapshotError::Missing { name: name.to_string(), golden: path, shown });
            }
            Err(error) => return Err(SnapshotError::Golden { error }),
        };
        let comparison = compare(&golden, picture, tolerance);
        if comparison.passes() {
            // What an earlier failure left to look at would now mislead; most often there is nothing.
            for kind in [ACTUAL, DIFFERENCE] {
                let _ = fs::remove_file(self.failure(name, kind));
            }
            return Ok(golden);
        }
        let difference = side_by_side(&[&golden, &difference_picture(&golden, picture), picture]);
        Err(SnapshotError::Differs {
            name: name.to_string(),
            comparison: Box::new(comparison),
            golden: path,
            actual: self.show(name, ACTUAL, picture),
            difference: self.show(name, DIFFERENCE, &difference),
        })
    }

    /// Makes `picture` the accepted one and writes its summary; an accepted picture that passes already is kept.
    ///
    /// # Errors
    /// [`SnapshotError`] when a file cannot be written.
    pub fn accept(&self, name: &str, picture: &Picture, tolerance: Tolerance) -> Result<(), SnapshotError> {
        check_name(name)?;
        let path = self.golden(name);
        let golden = match read(&path) {
            Ok(golden) if compare(&golden, picture, tolerance).passes() => golden,
            _ => {
                write_in_folder(&path, &encode_for(&path, picture)?)?;
                picture.clone()
            }
        };
        // The format of `insta`, written here and not by it: whether `insta` writes depends on its own settings
        // and on where the test runs. `check_text` then lets it read what it would have written.
        let text = format!("---\ndescription: {}\n---\n{}", description(name), summary(&golden));
        let path = self.snap(name);
        if fs::read(&path).is_ok_and(|there| there == text.as_bytes()) {
            return Ok(());
        }
        Ok(write_in_folder(&path, text.as_bytes())?)
    }

    /// Lets `assert_text` compare the summary of the accepted picture with its `.snap`.
    fn check_text(&self, name: &str, golden: &Picture, assert_text: impl FnOnce(&str)) -> Result<(), SnapshotError> {
        // The summary of the accepted picture, not of the actual one: within a tolerance they may differ.
        let text = summary(golden);
        let mut settings = insta::Settings::new();
        settings.set_snapshot_path(&self.snaps);
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.set_description(description(name));
        catch_unwind(AssertUnwindSafe(|| settings.bind(|| assert_text(&text))))
            .map_err(|_| SnapshotError::Stale { name: name.to_string(), snap: self.snap(name) })
    }

    fn golden(&self, name: &str) -> PathBuf {
        self.goldens.join(format!("{name}.png"))
    }

    fn snap(&self, name: &str) -> PathBuf {
        self.snaps.join(format!("{name}.snap"))
    }

    fn failure(&self, name: &str, kind: &str) -> PathBuf {
        self.failures.join(format!("{name}.{kind}.png"))
    }

    /// Writes a picture of a failing test and says where it is, or why not: the failure itself must still be told.
    fn show(&self, name: &str, kind: &str, picture: &Picture) -> String {
        let path = self.failure(name, kind);
        let written = encode_for(&path, picture)
            .map_err(SnapshotError::from)
            .and_then(|bytes| Ok(write_in_folder(&path, &bytes)?));
        match written {
            Ok(()) => path.display().to_string(),
            Err(error) => format!("(not shown: {error})"),
        }
    }
}

fn description(name: &str) -> String {
    format!("what tests/images/{name}.png shows")
}

fn check_name(name: &str) -> Result<(), SnapshotError> {
    let allowed = |letter: char| letter.is_ascii_alphanumeric() || "-_.".contains(letter);
    if name.starts_with(|letter: char| letter.is_ascii_alphanumeric()) && name.chars().all(allowed) {
        return Ok(());
    }
    Err(SnapshotError::BadName { name: name.to_string() })
}

fn write_in_folder(path: &Path, bytes: &[u8]) -> Result<(), SaveError> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| SaveError::at(path, error))?;
    }
    write_whole(path, bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An album in a temporary folder, which vanishes with the first of the two.
    fn album() -> (tempfile::TempDir, Album) {
        let folder = tempfile::tempdir().expect("temporary folder");
        let inside = |name: &str| folder.path().join(name);
        let album = Album { goldens: inside("images"), snaps: inside("snapshots"), failures: inside("failures") };
        (folder, album)
    }

    fn square() -> Picture {
        Picture::filled(16, 16, [40, 50, 60])
    }

    fn square_with_a_fault() -> Picture {
        let mut picture = square();
        picture.set_pixel(3, 5, [43, 50, 60]);
        picture
    }

    #[test]
    fn a_missing_picture_fails_and_is_not_made() {
        let (_folder, album) = album();
        let error = album.check("new", &square(), Tolerance::EXACT).expect_err("nothing is accepted").to_string();
        assert!(error.contains("no picture is accepted yet for `new`"), "{error}");
        assert!(error.contains("FAROP_PICTURES=accept cargo test"), "{error}");
        assert!(!album.goldens.exists() && !album.snaps.exists());
        assert_eq!(read(&album.failures.join("new.actual.png")).expect("shown"), square());
    }

    #[test]
    fn an_accepted_picture_passes_and_its_text_is_what_insta_expects() {
        let (_folder, album) = album();
        album.accept("a.b-c_1", &square(), Tolerance::EXACT).expect("accepted");
        let golden = album.check("a.b-c_1", &square(), Tolerance::EXACT).expect("passes");
        album.check_text("a.b-c_1", &golden, |text| insta::assert_snapshot!("a.b-c_1", text)).expect("insta agrees");
        assert!(!album.failures.exists());
    }

    #[test]
    fn a_text_of_another_picture_is_stale() {
        let (_folder, album) = album();
        album.accept("x", &square(), Tolerance::EXACT).expect("accepted");
        // The comparison is insta's; what it does on a mismatch depends on its environment, so a panic stands in for it.
        let error =
            album.check_text("x", &square(), |_| panic!("planted: insta refuses")).expect_err("stale").to_string();
        assert!(error.contains("x.snap` is missing or does not describe it"), "{error}");
    }

    #[test]
    fn a_wrong_pixel_is_told_and_shown() {
        let (_folder, album) = album();
        album.accept("x", &square(), Tolerance::EXACT).expect("accepted");
        let error = album.check("x", &square_with_a_fault(), Tolerance::EXACT).expect_err("differs").to_string();
        for part in [
            "picture `x` is not the accepted one",
            "1 of 256 pixels differs",
            "x 3, y 5: expected (40, 50, 60), found (43, 50, 60)",
            "x 3 to 3, y 5 to 5",
            "x.diff.png (expected | difference | actual)",
            "FAROP_PICTURES=accept cargo test",
        ] {
            assert!(error.contains(part), "{part} is missing in: {error}");
        }
        let shown = read(&album.failures.join("x.diff.png")).expect("shown");
        assert_eq!((shown.width(), shown.height()), (16 * 3 + 2 * 2, 16));
        assert_eq!(read(&album.failures.join("x.actual.png")).expect("shown"), square_with_a_fault());

        album.check("x", &square(), Tolerance::EXACT).expect("passes");
        assert_eq!(
            fs::read_dir(&album.failures).expect("is there").count(),
            0,
            "a passing picture leaves nothing to look at"
        );
    }

    #[test]
    fn accepting_replaces_what_fails_and_keeps_what_passes() {
        let (_folder, album) = album();
        let loose = Tolerance { max_diff: 3, max_pixels: 0 };
        album.accept("x", &square(), Tolerance::EXACT).expect("accepted");
        album.accept("x", &square_with_a_fault(), loose).expect("passes");
        assert_eq!(album.check("x", &square_with_a_fault(), loose).expect("within"), square());
        album.accept("x", &square_with_a_fault(), Tolerance::EXACT).expect("accepted");
        let golden = album.check("x", &square_with_a_fault(), Tolerance::EXACT).expect("the new one");
        let text = fs::read_to_string(album.snap("x")).expect("written");
        assert!(text.ends_with(&summary(&golden)), "{text}");
    }

    #[test]
    fn a_broken_picture_file_is_told_and_can_be_replaced() {
        let (_folder, album) = album();
        write_in_folder(&album.golden("x"), b"no picture").expect("written");
        let error = album.check("x", &square(), Tolerance::EXACT).expect_err("broken").to_string();
        assert!(error.contains("x.png") && error.contains("not a picture"), "{error}");
        album.accept("x", &square(), Tolerance::EXACT).expect("accepted");
        album.check("x", &square(), Tolerance::EXACT).expect("passes");
    }

    #[test]
    fn a_failure_is_told_even_where_it_cannot_be_shown() {
        let (folder, mut album) = album();
        fs::write(folder.path().join("file"), "").expect("write");
        album.failures = folder.path().join("file/failures");
        let error = album.check("x", &square(), Tolerance::EXACT).expect_err("missing").to_string();
        assert!(error.contains("no picture is accepted yet") && error.contains("(not shown: cannot write"), "{error}");
    }

    #[test]
    fn names_stay_inside_the_folder() {
        let (_folder, album) = album();
        for name in ["", "../x", "a/b", ".hidden", "a b", "C:x", "\u{e9}"] {
            let checked = album.check(name, &square(), Tolerance::EXACT);
            assert!(matches!(checked, Err(SnapshotError::BadName { .. })), "{name}");
            assert!(matches!(album.accept(name, &square(), Tolerance::EXACT), Err(SnapshotError::BadName { .. })));
        }
    }

    #[test]
    fn a_mistyped_mode_is_an_error() {
        assert_eq!(Mode::of_variable(None).expect("unset"), Mode::Check);
        assert_eq!(Mode::of_variable(Some("accept")).expect("known"), Mode::Accept);
        assert!(Mode::of_variable(Some("acept")).expect_err("mistyped").to_string().contains("`acept`"));
    }

    #[test]
    fn failures_go_to_the_target_folder() {
        let album = Album::of_crate(env!("CARGO_MANIFEST_DIR"), None);
        let target = album.failures.parent().expect("below target");
        assert!(std::env::current_exe().expect("running").starts_with(target), "{album:?}");
    }

    #[test]
    fn light_is_encoded_as_srgb() {
        let image = Image::new(1, 1, crate::color::Rgb::gray(0.5));
        assert_eq!(image.to_picture().pixel(0, 0), [188; 3]);
    }
}
