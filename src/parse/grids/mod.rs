//! Grids: files of measured heights -> [`Grid`].
//!
//! file, plain or gzip -GRIDS-> Grid -> forest::elevation
//!
//! | Ending | What it is | Says where it lies |
//! |---|---|---|
//! | `.hgt` | SRTM: big-endian whole metres, 1201 or 3601 a side | by its name, `N42E001` |
//! | `.dt0 .dt1 .dt2` | DTED: records with checksums | in its header |
//! | `.asc` | ESRI ASCII grid | in its header |
//! | `.tif .tiff` | GeoTIFF: strips or tiles of any kind of number; with the feature `gis` | in its keys |
//! | `.png` | gray levels as heights, or heights in red, green and blue | not at all |
//!
//! Why own readers: together they are shorter than the glue of a library, and a truncated tile is told with what was expected.
//! No file is believed about its size before there are bytes for it.
//!
//! Cost: linear; memory of the file and of the grid.

mod ascii;
mod dted;
#[cfg(feature = "gis")]
mod geotiff;
mod hgt;
mod png;

use crate::diagnostic::{Diagnostic, Diagnostics, printable};
use crate::forest::elevation::{Grid, Unit};
use flate2::bufread::MultiGzDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader, ErrorKind, Read};
use std::path::Path;

/// The most bytes of a grid file after decompression: an ASCII grid of 8000 x 8000 samples.
const MOST_BYTES: u64 = 1 << 29;

/// What grid files leave open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// What the numbers of an ASCII grid count in; `None`: degrees where the whole grid fits on the globe in steps below a tenth.
    pub unit: Option<Unit>,
    /// Metres from one pixel to the next.
    pub spacing: f64,
    /// Heights of black and white, in metres.
    pub heights: (f64, f64),
    /// A colored PNG is read as heights: -10,000 m + 0.1 m (65536 R + 256 G + B). Without it, it is refused.
    pub colored: bool,
}

impl Default for GridOptions {
    fn default() -> Self {
        GridOptions { unit: None, spacing: 30.0, heights: (0.0, 255.0), colored: false }
    }
}

/// Reads a file of heights; its ending says what it is, `.gz` behind it does not count.
///
/// # Errors
/// The file cannot be read, its ending is not known, or something in it is wrong: what, where, what was expected.
pub fn load_grid(path: &Path, options: &GridOptions) -> Result<Grid, Diagnostics> {
    let name = printable(path.as_os_str().as_encoded_bytes());
    let bytes = read(path, &name)?;
    read_grid(path, &bytes, options)
}

/// As [`load_grid`], for bytes in memory that are called `path`.
///
/// # Errors
/// As [`load_grid`].
pub fn read_grid(path: &Path, bytes: &[u8], options: &GridOptions) -> Result<Grid, Diagnostics> {
    let file = GridFile { name: printable(path.as_os_str().as_encoded_bytes()), stem: stem(path), bytes };
    match ending(path).as_str() {
        "hgt" => hgt::read(&file),
        "dt0" | "dt1" | "dt2" => dted::read(&file),
        "asc" => ascii::read(&file, options),
        "png" => png::read(&file, options),
        #[cfg(feature = "gis")]
        "tif" | "tiff" => geotiff::read(&file),
        #[cfg(not(feature = "gis"))]
        "tif" | "tiff" => Err(file.refused(
            format!("`{}` is a GeoTIFF, and this farop was built without GIS", file.name),
            "build it with `cargo build --release --features gis`",
        )),
        _ => Err(file.refused(
            format!("`{}` has no ending that says what grid it is", file.name),
            "known are `.hgt`, `.dt0`, `.dt1`, `.dt2`, `.asc`, `.png`, `.tif`, each also with `.gz` behind",
        )),
    }
}

/// A file that is being read.
struct GridFile<'a> {
    /// The path, printable.
    name: String,
    /// The file's name up to its first point.
    stem: String,
    bytes: &'a [u8],
}

impl GridFile<'_> {
    /// The one diagnostic of a file that cannot be used.
    fn refused(&self, message: String, help: impl Into<String>) -> Diagnostics {
        Diagnostics::without_source(Diagnostic::error(message).help(help))
    }

    /// A grid, or what is wrong with its size.
    fn grid(
        &self,
        size: (usize, usize),
        heights: Vec<f32>,
        frame: crate::forest::elevation::Frame,
    ) -> Result<Grid, Diagnostics> {
        Grid::new(&self.stem, size, heights, frame).map_err(|error| {
            self.refused(format!("`{}`: {error}", self.name), "name a file with at least 2 rows of 2 heights")
        })
    }
}

/// The ending in small letters, `.gz` aside.
fn ending(path: &Path) -> String {
    let lower = |path: &Path| path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
    if lower(path) == "gz" { lower(&path.with_extension("")) } else { lower(path) }
}

fn stem(path: &Path) -> String {
    let name = path.file_name().map(|name| printable(name.as_encoded_bytes())).unwrap_or_default();
    name.split('.').next().unwrap_or_default().to_string()
}

/// Opens a file, or says what to do.
fn open(path: &Path, name: &str) -> Result<File, Diagnostics> {
    let refused = |message: String, help: &str| Diagnostics::without_source(Diagnostic::error(message).help(help));
    if path.is_dir() {
        return Err(refused(format!("`{name}` is a folder, not a grid"), "name a file in it"));
    }
    File::open(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => {
            refused(format!("there is no file `{name}`"), "is it in another folder, or has it `.gz` behind?")
        }
        ErrorKind::PermissionDenied => {
            refused(format!("no permission to read `{name}`"), "make the file readable for you")
        }
        _ => refused(format!("cannot open `{name}`: {error}"), "is it a file?"),
    })
}

/// All bytes of a file, decompressed.
fn read(path: &Path, name: &str) -> Result<Vec<u8>, Diagnostics> {
    let mut reader = BufReader::new(open(path, name)?);
    let failed = |error: std::io::Error| {
        Diagnostics::without_source(
            Diagnostic::error(format!("cannot read `{name}`: {error}")).help("is the file whole? Get it again"),
        )
    };
    let is_gzip = reader.fill_buf().map_err(failed)?.starts_with(b"\x1F\x8B");
    let mut bytes = Vec::new();
    let reader: Box<dyn Read> = if is_gzip { Box::new(MultiGzDecoder::new(reader)) } else { Box::new(reader) };
    reader.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(Diagnostics::without_source(
            Diagnostic::error(format!("`{name}` is larger than {MOST_BYTES} bytes (512 MiB)"))
                .help("cut it into tiles: they merge"),
        ));
    }
    Ok(bytes)
}
