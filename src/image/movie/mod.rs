//! Movie: pictures one after another, in one file or in a folder.
//!
//! `Picture`, `Picture`, ... -MOVIE-> OUT.gif, OUT.y4m, or DIR/frame-00000.png and on
//!
//! Why three forms: a GIF is seen everywhere and has 256 colors a frame; Y4M is what every encoder of films reads and is large;
//! numbered PNG lose nothing. A frame is written when it comes, so a film of any length needs the memory of one frame.
//!
//! A film appears under its final name only when it is whole (see [`save`](super::save)): also a folder of frames.

mod gif;
mod numbered;
mod palette;
mod y4m;

use super::save::{SaveError, WholeFile};
use super::{ImageError, Picture};
use std::path::{Path, PathBuf};

/// Why a movie cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MovieError {
    /// The file or folder cannot be written.
    #[error(transparent)]
    Save(#[from] SaveError),
    /// A frame cannot be written.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// The name says no form that is known.
    #[error("cannot tell the form of the movie `{}`: name it `.gif` or `.y4m`, or give a folder, without an ending, for numbered PNG", path.display())]
    UnknownExtension {
        /// As the caller named it.
        path: PathBuf,
    },
    /// There are files in the folder that frames would mix with.
    #[error("cannot write frames to `{}`: it is there and not empty; empty it, or name another folder", path.display())]
    FolderInUse {
        /// As the caller named it.
        path: PathBuf,
    },
    /// A size that the form does not know.
    #[error("a movie of {width} x {height} cannot be: 1 to 65535 pixels each way")]
    Size {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// A frame of another size than the first.
    #[error("frame {frame} is {width} x {height}, unlike those before it: all frames of a movie have one size")]
    Changed {
        /// Counted from 0.
        frame: u64,
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// Nobody pushed a frame.
    #[error("a movie without frames is not written")]
    Empty,
}

/// A movie in the making. It gets its name by [`Movie::finish`]; dropped before, nothing of it stays.
#[derive(Debug)]
pub struct Movie {
    size: (usize, usize),
    frames: u64,
    form: Form,
}

#[derive(Debug)]
enum Form {
    Gif(Box<gif::Gif>),
    Y4m(WholeFile),
    Numbered(numbered::Numbered),
}

/// The forms, told by the name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Gif,
    Y4m,
    Numbered,
}

impl Kind {
    fn of(path: &Path) -> Result<Kind, MovieError> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
        match ending.as_deref() {
            Some("gif") => Ok(Kind::Gif),
            Some("y4m") => Ok(Kind::Y4m),
            None => Ok(Kind::Numbered),
            Some(_) if path.is_dir() => Ok(Kind::Numbered),
            Some(_) => Err(MovieError::UnknownExtension { path: path.to_path_buf() }),
        }
    }
}

impl Movie {
    /// Begins a movie of `rate` frames a second; the ending of `path` says its form: `.gif`, `.y4m`, none for a folder.
    ///
    /// A GIF counts hundredths of a second between frames: 25 is exact, 30 becomes 33.
    ///
    /// # Errors
    /// [`MovieError`] where the name, the size or the place do not do.
    pub fn create(path: &Path, (width, height): (usize, usize), rate: u32) -> Result<Movie, MovieError> {
        let kind = Kind::of(path)?;
        if !(1..=65_535).contains(&width) || !(1..=65_535).contains(&height) {
            return Err(MovieError::Size { width, height });
        }
        let form = match kind {
            Kind::Gif => Form::Gif(Box::new(gif::Gif::new(WholeFile::create(path)?, rate))),
            Kind::Numbered => Form::Numbered(numbered::Numbered::create(path)?),
            Kind::Y4m => {
                let mut file = WholeFile::create(path)?;
                y4m::write_header(&mut file, (width, height), rate).map_err(|error| SaveError::at(path, error))?;
                Form::Y4m(file)
            }
        };
        Ok(Movie { size: (width, height), frames: 0, form })
    }

    /// Whether `path` names a form that is known: asked before minutes of work.
    ///
    /// # Errors
    /// [`MovieError::UnknownExtension`].
    pub fn check_name(path: &Path) -> Result<(), MovieError> {
        Kind::of(path).map(|_| ())
    }

    /// The next frame.
    ///
    /// # Errors
    /// [`MovieError`] when it has another size than the movie, or cannot be written.
    pub fn push(&mut self, picture: &Picture) -> Result<(), MovieError> {
        let (width, height) = (picture.width(), picture.height());
        if (width, height) != self.size {
            return Err(MovieError::Changed { frame: self.frames, width, height });
        }
        match &mut self.form {
            Form::Gif(gif) => gif.push(picture)?,
            Form::Y4m(file) => {
                y4m::write_frame(file, picture).map_err(|error| SaveError::at(file.path(), error))?;
            }
            Form::Numbered(folder) => folder.push(self.frames, picture)?,
        }
        self.frames += 1;
        Ok(())
    }

    /// Gives the movie its name; returns how many frames it has.
    ///
    /// # Errors
    /// [`MovieError`] when there is no frame, or the last bytes cannot be written; then nothing is left behind.
    pub fn finish(self) -> Result<u64, MovieError> {
        if self.frames == 0 {
            return Err(MovieError::Empty);
        }
        match self.form {
            Form::Gif(gif) => gif.finish()?,
            Form::Y4m(file) => file.commit()?,
            Form::Numbered(folder) => folder.finish()?,
        }
        Ok(self.frames)
    }
}

#[cfg(test)]
mod tests;
