//! Picture files: which format, and what may be wrong with one.
//!
//! file -> READ -> `Picture`, and `Picture` -> ENCODE -> bytes (`save::write_whole` puts them on disk)
//!
//! Reading looks at the first bytes, because names lie; writing looks at the extension, because there is nothing
//! else to look at.

use super::{MAX_PIXELS, Picture, png, ppm};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Longest picture file that is read: 16-bit color for every one of [`MAX_PIXELS`] pixels, and some more.
const MAX_FILE_BYTES: u64 = (MAX_PIXELS as u64) * 6 + 65_536;

/// What can be wrong with a picture file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImageError {
    /// The file cannot be opened or read.
    #[error("cannot read picture `{}`: {source}", path.display())]
    Read {
        /// The file as the caller named it.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Something is wrong inside a file; `error` says what.
    #[error("`{}`: {error}", path.display())]
    InFile {
        /// The file as the caller named it.
        path: PathBuf,
        /// What is wrong, and where.
        error: Box<ImageError>,
    },
    /// The first bytes belong to no format that is read.
    #[error("not a picture farop can read: it begins with {begins}; PNG, P6 (binary PPM) and P3 (text PPM) are read")]
    UnknownFormat {
        /// The first bytes, printable.
        begins: String,
    },
    /// The extension names no format that is written.
    #[error("cannot tell the picture format of `{}`: name the file `.png` or `.ppm`", path.display())]
    UnknownExtension {
        /// The file as the caller named it.
        path: PathBuf,
    },
    /// A PPM file breaks the format.
    #[error("broken PPM at byte {offset}: {what}")]
    Ppm {
        /// Position in the file, from 0.
        offset: usize,
        /// What was expected and what was found.
        what: String,
    },
    /// A PNG file breaks the format, or its reader gave up.
    #[error("broken PNG: {what}")]
    Png {
        /// The reader's own words.
        what: String,
    },
    /// A frame of a GIF cannot be written.
    #[error("cannot write the GIF: {what}")]
    Gif {
        /// The writer's own words.
        what: String,
    },
    /// More pixels than [`MAX_PIXELS`].
    #[error("{width} x {height} is too large: at most {MAX_PIXELS} pixels are read")]
    TooLarge {
        /// Columns, as the file says.
        width: u64,
        /// Rows, as the file says.
        height: u64,
    },
    /// A picture without pixels, which no format here can hold.
    #[error("a picture of {width} x {height} has no pixels: there is nothing to write")]
    Empty {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// Bytes and size do not belong together.
    #[error("a picture of {width} x {height} needs 3 bytes a pixel, but there are {bytes} bytes in all")]
    Length {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Bytes there are.
        bytes: usize,
    },
}

/// Reads a picture file; its first bytes say which format it is (PNG, P6, P3).
///
/// # Errors
/// When the file cannot be read, is no picture, is broken, or is larger than [`MAX_PIXELS`]. The message names the file.
pub fn read(path: &Path) -> Result<Picture, ImageError> {
    let failed = |source| ImageError::Read { path: path.to_path_buf(), source };
    let mut file = File::open(path).map_err(failed)?.take(MAX_FILE_BYTES);

    // Look at the beginning before reading on: a device or a huge file of another kind must not fill the memory.
    let mut bytes = Vec::new();
    file.by_ref().take(8).read_to_end(&mut bytes).map_err(failed)?;
    let known = Format::of(&bytes).map(|_| ());
    let decoded = known.and_then(|()| {
        file.read_to_end(&mut bytes).map_err(failed)?;
        decode(&bytes)
    });
    decoded.map_err(|error| match error {
        ImageError::Read { .. } => error,
        error => ImageError::InFile { path: path.to_path_buf(), error: Box::new(error) },
    })
}

/// The picture in the bytes of a PNG, P6 or P3 file.
///
/// # Errors
/// When the bytes are no picture, are broken, or say a size larger than [`MAX_PIXELS`].
pub fn decode(bytes: &[u8]) -> Result<Picture, ImageError> {
    match Format::of(bytes)? {
        Format::Png => png::decode(bytes),
        Format::Ppm => ppm::decode(bytes),
    }
}

/// The bytes of a picture file; the extension of `path` says which format (`.png`, `.ppm`, in any case).
///
/// # Errors
/// [`ImageError::UnknownExtension`] for any other extension, [`ImageError::Empty`] for a picture without pixels.
pub fn encode_for(path: &Path, picture: &Picture) -> Result<Vec<u8>, ImageError> {
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let encode = match extension.as_deref() {
        Some("png") => png::encode,
        Some("ppm") => ppm::encode,
        _ => return Err(ImageError::UnknownExtension { path: path.to_path_buf() }),
    };
    if picture.rgb().is_empty() {
        return Err(ImageError::Empty { width: picture.width(), height: picture.height() });
    }
    encode(picture)
}

enum Format {
    Png,
    Ppm,
}

impl Format {
    fn of(bytes: &[u8]) -> Result<Format, ImageError> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Ok(Format::Png),
            [b'P', b'3' | b'6', ..] => Ok(Format::Ppm),
            [] => Err(ImageError::UnknownFormat { begins: "nothing (the file is empty)".to_string() }),
            _ => {
                let begins = format!("`{}`", bytes[..bytes.len().min(8)].escape_ascii());
                Err(ImageError::UnknownFormat { begins })
            }
        }
    }
}

/// `width` and `height` as a size in memory, if a picture that large is read at all.
pub(super) fn checked_size(width: u64, height: u64) -> Result<(usize, usize), ImageError> {
    let fits = width.checked_mul(height).is_some_and(|count| count <= MAX_PIXELS as u64);
    match (usize::try_from(width), usize::try_from(height)) {
        (Ok(columns), Ok(rows)) if fits => Ok((columns, rows)),
        _ => Err(ImageError::TooLarge { width, height }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_chooses_what_is_written_and_the_content_what_is_read() {
        let picture = Picture::filled(3, 2, [1, 2, 3]);
        for name in ["a.png", "a.PNG", "a.ppm", "dir.x/a.Ppm"] {
            let bytes = encode_for(Path::new(name), &picture).expect(name);
            assert_eq!(decode(&bytes).expect(name), picture);
        }
        let error = encode_for(Path::new("a.jpeg"), &picture).expect_err("jpeg is not written").to_string();
        assert!(error.contains("a.jpeg") && error.contains(".png") && error.contains(".ppm"), "{error}");
        assert!(encode_for(Path::new("png"), &picture).is_err());
    }

    #[test]
    fn a_lying_name_is_read_by_content() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("really-a-ppm.png");
        let picture = Picture::filled(1, 1, [9, 8, 7]);
        std::fs::write(&path, ppm::encode(&picture).expect("one pixel")).expect("write");
        assert_eq!(read(&path).expect("P6"), picture);
    }

    #[test]
    fn errors_name_the_file() {
        let folder = tempfile::tempdir().expect("temporary folder");
        let path = folder.path().join("x.png");
        assert!(read(&path).expect_err("missing").to_string().contains("x.png"));
        assert!(read(folder.path()).is_err());
        for (content, expected) in [("", "empty"), ("GIF89a....", "`GIF89a..`"), ("P6 1 x", "byte 5")] {
            std::fs::write(&path, content).expect("write");
            let error = read(&path).expect_err(content).to_string();
            assert!(error.contains("x.png") && error.contains(expected), "{error}");
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn an_endless_device_is_no_picture() {
        assert!(read(Path::new("/dev/zero")).is_err());
    }

    #[test]
    fn a_picture_without_pixels_is_not_written() {
        for name in ["a.png", "a.ppm"] {
            assert!(matches!(
                encode_for(Path::new(name), &Picture::filled(0, 5, [0; 3])),
                Err(ImageError::Empty { width: 0, height: 5 })
            ));
        }
    }
}
