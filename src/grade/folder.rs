//! Folder: pictures that were drawn elsewhere from the files of `farop suite LAB`.
//!
//! file name of the case -FOLDER-> PPM or PNG -> picture, or what is wrong with the file before any pixel is looked at
//!
//! This is the paper's own way of testing (FAROP 1996, appendix A): any machine, any language, files in, pictures out.

use super::case::Case;
use super::hidden::Probes;
use super::labs::Lab;
use super::subject::{Answer, Failure, Subject};
use crate::image::{Picture, decode};
use crate::plan::Accepts;
use crate::screen::DrawList;
use crate::screen::file::Sheet;
use std::path::{Path, PathBuf};

/// Every case of `lab` with the name of its file, without an ending: `07-ties-square_on_centers`, and `hidden-07-...` of hidden
/// probes, so that pictures of both may lie in one folder.
#[must_use]
pub fn files(lab: &Lab, seed: u64) -> Vec<(String, Case)> {
    let plain = |text: &str| -> String {
        text.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect()
    };
    let set = if lab.probes == Probes::Hidden { "hidden-" } else { "" };
    let mut files = Vec::new();
    for aspect in lab.aspects {
        for case in lab.cases(aspect, seed) {
            files.push((format!("{set}{:02}-{}-{}", files.len() + 1, plain(aspect.name), plain(&case.name)), case));
        }
    }
    files
}

/// A folder of pictures.
pub struct Pictures {
    folder: PathBuf,
    /// The list and the name of its file.
    lists: Vec<(DrawList, String)>,
}

impl Pictures {
    /// Pictures of `lab` in `folder`, named as the screen files are.
    #[must_use]
    pub fn new(folder: &Path, lab: &Lab, seed: u64) -> Pictures {
        let lists = files(lab, seed).into_iter().map(|(name, case)| (case.list(Accepts::AnyPolygon), name));
        Pictures { folder: folder.to_path_buf(), lists: lists.collect() }
    }

    /// The same with pictures of another set of probes beside them.
    #[must_use]
    pub fn and(mut self, lab: &Lab, seed: u64) -> Pictures {
        self.lists.extend(Pictures::new(&self.folder, lab, seed).lists);
        self
    }
}

impl Subject for Pictures {
    fn draw(&self, list: &DrawList, _: &Sheet) -> Result<Answer, Failure> {
        let named = self.lists.iter().find(|(other, _)| other == list);
        let Some((_, name)) = named else {
            return Err(failure("there is no such file in the suite", "Make the suite anew with `farop suite`."));
        };
        let found = ["ppm", "png", "PPM", "PNG"].iter().find_map(|ending| {
            let path = self.folder.join(format!("{name}.{ending}"));
            path.is_file().then_some(path)
        });
        let Some(path) = found else {
            return Err(failure(
                &format!("there is no picture {name}.ppm or {name}.png"),
                "A picture has the name of its screen file, with another ending.",
            ));
        };
        let bytes =
            std::fs::read(&path).map_err(|error| failure(&format!("cannot read {}: {error}", path.display()), ""))?;
        picture(&bytes).map(|picture| Answer { picture, puts: None })
    }

    fn can_draw_anything(&self) -> bool {
        false
    }
}

fn failure(message: &str, hint: &str) -> Failure {
    Failure { message: message.to_string(), hint: hint.to_string() }
}

/// The picture in these bytes, or what was done to them.
fn picture(bytes: &[u8]) -> Result<Picture, Failure> {
    if bytes.starts_with(b"P3") {
        return Err(failure(
            "the file is P3, numbers written as text, not P6",
            "Write `P6` in the head and every level as one byte behind it.",
        ));
    }
    let start = [&b"P6"[..], b"\x89PNG"]
        .iter()
        .filter_map(|magic| bytes.windows(magic.len()).position(|part| part == *magic))
        .min();
    match start {
        Some(0) => {}
        Some(extra) => {
            return Err(failure(
                &format!("{extra} bytes stand before the picture: something was printed first"),
                "Print messages to standard error; the picture alone belongs on standard output.",
            ));
        }
        None => return Err(failure("the file is neither a P6 nor a PNG", "A P6 begins with the two letters P6.")),
    }
    if bytes.starts_with(b"P6") && returns_doubled(bytes) {
        return Err(failure(
            "every line feed has become two bytes, carriage return and line feed: the file was written in text mode",
            "Open it in binary mode: \"wb\" in C and Python, _setmode(_fileno(stdout), _O_BINARY) on Windows.",
        ));
    }
    decode(bytes).map_err(|error| {
        failure(&error.to_string(), "A P6 is `P6 width height 255`, one white space, and 3 bytes a pixel.")
    })
}

/// Whether no line feed of the file stands without a carriage return before it.
fn returns_doubled(bytes: &[u8]) -> bool {
    let feeds = bytes.iter().filter(|&&byte| byte == b'\n').count();
    feeds > 0 && bytes.windows(2).filter(|pair| *pair == b"\r\n").count() == feeds
}
