//! Items 101 and 102: what is written, and rasterizers of others.

use super::tools::ensure;
use super::{Effort, Item, Outcome, Trial::Run, misbehaving};
use crate::image::save::{SaveError, write_streamed, write_whole};
use std::io::{Error, ErrorKind};
use std::path::Path;

pub(super) const ITEMS: &[Item] = &[
    (101, "disk full, closed pipe, no memory: refused, no partial file", Run(writing)),
    (102, "a student's rasterizer that misbehaves: contained and told", Run(|_| misbehaving::outcome())),
];

fn writing(_: &Effort) -> Outcome {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let path = folder.path().join("out.png");
    std::fs::write(&path, "old").map_err(|error| error.to_string())?;
    for kind in [ErrorKind::StorageFull, ErrorKind::BrokenPipe, ErrorKind::OutOfMemory] {
        let half = write_streamed(&path, |out| {
            out.write_all(&[7; 100_000])?;
            Err(Error::from(kind))
        });
        ensure(half.is_err(), format!("{kind}: it was written"))?;
        let kept = std::fs::read(&path).map_err(|error| error.to_string())?;
        ensure(kept == b"old", format!("{kind}: the old file is gone"))?;
        let left = std::fs::read_dir(folder.path()).map_err(|error| error.to_string())?.count();
        ensure(left == 1, format!("{kind}: {left} files are left"))?;
    }
    let full = Path::new("/dev/full");
    let refused = !full.exists() || matches!(write_whole(full, b"bytes"), Err(SaveError::DiskFull { .. }));
    ensure(refused, "a full disk was not told")
}
