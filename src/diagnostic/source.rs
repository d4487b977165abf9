//! The text of a scene as it is kept in memory: without comments and blank lines, yet with true line numbers.
//!
//! bytes of a file -parse::input-> SOURCE -parse-> Scene
//!
//! Why not the bytes as they are: a file may hold a gigabyte of comments and ten polygons, and must cost the memory
//! of ten polygons. Leaving out whole lines costs one [`Gap`] for each run of them, so what is kept is bounded by
//! what the scene says. Columns need no care: a comment reaches to the end of its line, so nothing stands behind it.
//!
//! Units: offsets are bytes into the kept text, lines and columns count from 1.
//! Cost: a line number is a count of line breaks; [`Lines`] counts each stretch of text once.

/// A range of bytes of a [`Source`]. `u32`, because no source is larger than 4 GiB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The first byte.
    pub start: u32,
    /// One past the last byte; equal to `start` where something is missing.
    pub end: u32,
}

impl Span {
    /// Bytes `start..end`.
    #[must_use]
    pub fn new(start: usize, end: usize) -> Span {
        Span { start: start as u32, end: end as u32 }
    }
}

/// Text that was read, its name, and which lines were left out of it.
#[derive(Clone, Debug, Default)]
pub struct Source {
    /// What messages call it: a path, or `<stdin>`.
    pub name: String,
    /// The lines that say something, in order, comments cut off.
    pub text: Vec<u8>,
    /// Where lines are missing in `text`, in order.
    pub gaps: Vec<Gap>,
}

/// Lines that were read and not kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gap {
    /// They stood before this byte of [`Source::text`], which starts a line.
    pub before: u32,
    /// How many.
    pub lines: u32,
}

impl Source {
    /// A source that keeps `text` as it is.
    #[must_use]
    pub fn verbatim(name: &str, text: &[u8]) -> Source {
        Source { name: name.to_string(), text: text.to_vec(), gaps: Vec::new() }
    }

    /// Starts counting lines at the top.
    #[must_use]
    pub fn lines(&self) -> Lines<'_> {
        Lines { source: self, offset: 0, line: 1, gaps_passed: 0 }
    }

    /// The 1-based line of the file that holds byte `offset`.
    #[must_use]
    pub fn line(&self, offset: u32) -> u32 {
        self.lines().at(offset)
    }

    /// The bytes of the line around `offset`, without its line break, and the offset of the first of them.
    #[must_use]
    pub fn line_text(&self, offset: u32) -> (&[u8], u32) {
        let offset = (offset as usize).min(self.text.len());
        let start = self.text[..offset].iter().rposition(|&byte| byte == b'\n').map_or(0, |newline| newline + 1);
        let rest = &self.text[start..];
        let length = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        (rest[..length].trim_ascii_end(), start as u32)
    }
}

/// Tells the line of offsets that mostly grow: it counts on from the last one asked for.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    source: &'a Source,
    offset: u32,
    line: u32,
    gaps_passed: usize,
}

impl Lines<'_> {
    /// The 1-based line of the file that holds byte `offset`.
    #[must_use]
    pub fn at(&mut self, offset: u32) -> u32 {
        if offset < self.offset {
            *self = self.source.lines();
        }
        let stretch = &self.source.text[self.offset as usize..offset as usize];
        self.line += line_breaks(stretch);
        self.offset = offset;
        while let Some(gap) = self.source.gaps.get(self.gaps_passed).filter(|gap| gap.before <= offset) {
            self.line += gap.lines;
            self.gaps_passed += 1;
        }
        self.line
    }
}

/// How many line breaks there are. Counted in bytes, so that a compiler can count many at a time.
fn line_breaks(bytes: &[u8]) -> u32 {
    let few = |bytes: &[u8]| bytes.iter().fold(0_u8, |count, &byte| count + u8::from(byte == b'\n'));
    bytes.chunks(255).map(|chunk| u32::from(few(chunk))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_left_out_are_counted() {
        let gaps = vec![Gap { before: 0, lines: 2 }, Gap { before: 4, lines: 10 }];
        let source = Source { name: String::new(), text: b"a\nb\nc\n".to_vec(), gaps };
        let mut lines = source.lines();
        assert_eq!([0, 2, 4, 5].map(|offset| lines.at(offset)), [3, 4, 15, 15]);
        assert_eq!(lines.at(2), 4, "going back starts again");
        assert_eq!(source.line_text(3), (&b"b"[..], 2));
        assert_eq!(source.line_text(6), (&b""[..], 6), "after the last line break");
    }
}
