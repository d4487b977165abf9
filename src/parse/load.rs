//! Opens scene files: by name or standard input, plain or gzip.
//!
//! path -LOAD-> bytes -input-> Source
//!
//! Gzip is recognized by its first two bytes, whatever the name says: files get renamed, bytes do not.

use super::input::{read_annotated_source, read_source};
use super::{INPUT_LIMIT, ParseOptions, Parsed, fcell, ftri, nff, sipp};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, printable, suggest};
use crate::forest::area::Head;
use crate::forest::cells::Cells;
use crate::forest::objects::Models;
use crate::forest::pack::Pack;
use crate::forest::tree;
use flate2::bufread::MultiGzDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Read, stdin};
use std::path::Path;

/// The scene formats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Eric Haines' Neutral File Format.
    Nff,
    /// farop's language for scenes as SIPP has them.
    Sipp,
    /// Triangles in binary, for measuring.
    Ftri,
    /// An area of forest as text.
    Fcell,
    /// An area of forest in binary, cell by cell.
    Fpack,
}

impl Format {
    /// All formats, by the name that is also their file extension.
    pub const ALL: [(&'static str, Format); 5] = [
        ("nff", Format::Nff),
        ("sipp", Format::Sipp),
        ("ftri", Format::Ftri),
        ("fcell", Format::Fcell),
        ("fpack", Format::Fpack),
    ];

    /// The format of that name, case aside.
    #[must_use]
    pub fn by_name(name: &str) -> Option<Format> {
        Format::ALL.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, format)| format)
    }

    /// The format a file name ends in; `.gz` behind it does not count.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Format> {
        let is_gzip = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("gz"));
        let path = if is_gzip { path.with_extension("") } else { path.to_path_buf() };
        Format::by_name(path.extension()?.to_str()?)
    }
}

/// Reads a scene file; `-` is standard input, whose format must be given. Without `format` the name's ending decides.
///
/// # Errors
/// The file cannot be read, its format is not known, or its text has mistakes.
pub fn load(path: &Path, format: Option<Format>, options: ParseOptions) -> Result<Parsed, Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    if name == "-" {
        let Some(format) = format else {
            let error = Diagnostic::error("standard input has no name that says what format it is");
            return Err(failure(
                error.help("add `--format nff`, `--format sipp`, `--format ftri` or `--format fcell`"),
            ));
        };
        return load_from(("<stdin>", stdin().lock()), Path::new(""), format, options);
    }
    // A file that is not there is told before a format that is not known.
    let file = open(path, &name)?;
    let Some(format) = format.or_else(|| Format::of_path(path)) else {
        let error = Diagnostic::error(format!("`{name}` has no ending that says what format it is"));
        return Err(failure(error.help(
            "known are `.nff`, `.sipp`, `.ftri`, `.fcell` and all with `.gz` behind, and `.fpack`; if it is NFF all the same, add `--format nff`",
        )));
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    if format == Format::Fpack {
        return grown(&Cells::Packed(open_pack(path)?), folder, Diagnostics::default());
    }
    load_from((&name, BufReader::new(file)), folder, format, options)
}

/// Opens an area of forest: all of a `.fcell`, or head and index of a `.fpack`; with what is worth knowing about how it was read.
///
/// # Errors
/// The file cannot be read, is no area, or has mistakes.
pub fn load_cells(path: &Path) -> Result<(Cells, Diagnostics), Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    let file = open(path, &name)?;
    match Format::of_path(path) {
        Some(Format::Fpack) => Ok((Cells::Packed(open_pack(path)?), Diagnostics::default())),
        Some(Format::Fcell) => {
            let source = read_source(&name, unpacked(&name, BufReader::new(file))?)?;
            let (area, notices) = fcell::read(&source, path.parent().unwrap_or(Path::new("")))?;
            Ok((Cells::Loaded(area), notices))
        }
        _ => {
            let error = Diagnostic::error(format!("`{name}` is no area of forest"));
            Err(failure(error.help("areas end in `.fcell`, `.fcell.gz` or `.fpack`")))
        }
    }
}

/// Reads the scenes that stand on an area, each once; their names are relative to `folder`.
///
/// # Errors
/// One of them cannot be read, or has mistakes.
pub fn load_models(head: &Head, folder: &Path) -> Result<Models, Diagnostics> {
    let mut models = Models::new();
    for standing in &head.objects {
        if models.contains_key(&standing.file) {
            continue;
        }
        let path = folder.join(&standing.file);
        let is_area = matches!(Format::of_path(&path), Some(Format::Fcell | Format::Fpack));
        if is_area {
            let error = Diagnostic::error(format!("`{}` is no scene that can stand on an area", standing.file));
            return Err(failure(error.help("scenes are `.nff`, `.sipp` and `.ftri`")));
        }
        let Parsed { mut scene, default_camera, .. } =
            load(&path, None, ParseOptions::default()).map_err(|errors| {
                let file = head.files.get(usize::from(standing.place.file)).map_or("the area", String::as_str);
                let line = standing.place.line;
                let place = if line == 0 { file.to_string() } else { format!("{file}:{line}") };
                errors.named_by(&place)
            })?;
        scene.camera = scene.camera.or(default_camera);
        models.insert(standing.file.clone(), scene);
    }
    Ok(models)
}

/// Opens a pack, whose cells are read where they lie: neither from a pipe nor out of gzip.
fn open_pack(path: &Path) -> Result<Pack, Diagnostics> {
    Pack::open(path).map_err(|error| failure(Diagnostic::error(error.to_string())))
}

/// The scene of an area; what the area has to tell is in `notices`, and how many trees it has is added.
fn grown(cells: &Cells, folder: &Path, mut notices: Diagnostics) -> Result<Parsed, Diagnostics> {
    let models = load_models(cells.head(), folder)?;
    let grown =
        tree::scene(cells, (folder, &models), None).map_err(|error| failure(Diagnostic::error(error.to_string())))?;
    let count = cells.indices().len();
    let message = format!("{} trees in {count} cells, each an object of the scene", grown.trees);
    notices.list.push(Diagnostic::notice(message));
    Ok(Parsed { scene: grown.scene, notices, default_camera: Some(grown.camera) })
}

/// Reads a scene; `folder` is where files named in it are looked for.
fn load_from(
    (name, reader): (&str, impl BufRead),
    folder: &Path,
    format: Format,
    options: ParseOptions,
) -> Result<Parsed, Diagnostics> {
    let reader = unpacked(name, reader)?;
    match format {
        // What farop has to add to NFF stands in comments.
        Format::Nff => nff::read(&read_annotated_source(name, reader)?, options),
        Format::Sipp => sipp::read(&read_source(name, reader)?, folder, options),
        Format::Ftri => ftri::read(name, &read_bytes(name, reader)?),
        Format::Fcell => {
            let (area, notices) = fcell::read(&read_source(name, reader)?, folder)?;
            grown(&Cells::Loaded(area), folder, notices)
        }
        Format::Fpack => {
            let error = Diagnostic::error("a pack is read cell by cell, which standard input cannot");
            Err(failure(error.help("give its file: `farop render AREA.fpack`")))
        }
    }
}

/// Reads a file that a scene names and that is no scene itself, plain or gzip.
pub(super) fn source(path: &Path) -> Result<Source, Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    read_source(&name, unpacked(&name, BufReader::new(open(path, &name)?))?)
}

/// Reads a file that is no text of farop's, plain or gzip, as it is: `#` begins no comment.
pub(super) fn whole_source(path: &Path) -> Result<Source, Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    let text = read_bytes(&name, unpacked(&name, BufReader::new(open(path, &name)?))?)?;
    Ok(Source { name, text, ..Source::default() })
}

/// The reader itself, or what unpacks it.
fn unpacked<'a>(name: &str, mut reader: impl BufRead + 'a) -> Result<Box<dyn Read + 'a>, Diagnostics> {
    let start = reader.fill_buf();
    let start = start.map_err(|error| unreadable(name, &error))?;
    let is_packed = start.starts_with(b"\x1F\x8B");
    Ok(if is_packed { Box::new(MultiGzDecoder::new(reader)) } else { Box::new(reader) })
}

/// Everything up to [`INPUT_LIMIT`].
fn read_bytes(name: &str, reader: impl Read) -> Result<Vec<u8>, Diagnostics> {
    let mut bytes = Vec::new();
    reader.take(INPUT_LIMIT + 1).read_to_end(&mut bytes).map_err(|error| unreadable(name, &error))?;
    if bytes.len() as u64 > INPUT_LIMIT {
        let error = Diagnostic::error(format!("`{name}` is larger than {INPUT_LIMIT} bytes (4 GiB)"));
        return Err(failure(error.help("split the scene into several files: they merge")));
    }
    Ok(bytes)
}

fn unreadable(name: &str, error: &std::io::Error) -> Diagnostics {
    failure(Diagnostic::error(format!("cannot read `{name}`: {error}")))
}

/// Opens a file, or says what to do.
fn open(path: &Path, name: &str) -> Result<File, Diagnostics> {
    if path.is_dir() {
        let error = Diagnostic::error(format!("`{name}` is a folder, not a scene file"));
        return Err(failure(error.help("name a file in it")));
    }
    File::open(path).map_err(|error| {
        failure(match error.kind() {
            ErrorKind::NotFound => not_found(path, name),
            ErrorKind::PermissionDenied => Diagnostic::error(format!("no permission to read `{name}`"))
                .help("make the file readable for you, or copy it to where it is"),
            _ => Diagnostic::error(format!("cannot open `{name}`: {error}")),
        })
    })
}

/// Names the file next to it that was probably meant.
fn not_found(path: &Path, name: &str) -> Diagnostic {
    let error = Diagnostic::error(format!("there is no file `{name}`"));
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let Ok(entries) = folder.read_dir() else {
        return error.help(format!("there is no folder `{}` either", printable(folder.as_os_str().as_encoded_bytes())));
    };
    let most_names = 10_000;
    let names = entries.take(most_names).flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let mut scenes: Vec<String> = names.filter(|name| Format::of_path(Path::new(name)).is_some()).collect();
    scenes.sort();
    let scenes: Vec<&str> = scenes.iter().map(String::as_str).collect();
    let wanted = path.file_name().and_then(|wanted| wanted.to_str()).unwrap_or_default();
    match suggest(wanted, &scenes) {
        Some(similar) => error.help(format!("did you mean `{}`?", folder.join(similar).display())),
        None => error.help("built-in scenes need no file: `spd:gears`"),
    }
}

fn failure(error: Diagnostic) -> Diagnostics {
    Diagnostics::without_source(error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_say_the_format() {
        for name in ["a.nff", "a.b/c.NFF", "a.nff.gz", "a.NFF.GZ"] {
            assert_eq!(Format::of_path(Path::new(name)), Some(Format::Nff), "{name}");
        }
        assert_eq!(Format::of_path(Path::new("a.sipp.gz")), Some(Format::Sipp));
        for name in ["a", "nff", "a.gz", ".nff", "a.nff.txt", ""] {
            assert_eq!(Format::of_path(Path::new(name)), None, "{name}");
        }
    }
}
