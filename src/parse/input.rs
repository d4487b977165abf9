//! Bytes of a file -> [`Source`]: comments and blank lines are dropped while reading, except for comments for farop.
//!
//! file, pipe, gzip -> INPUT -> Source -> nff
//!
//! Why here and not in the grammar: what never enters memory cannot fill it. A gigabyte of comments, in one line or in
//! ten million, costs one buffer; a gigabyte without a line break is refused after [`LINE_LIMIT`] characters.
//!
//! A comment that begins with `#farop` and a blank is for farop ([`super::nff`]) and stays, wherever the buffer ends within it.
//!
//! Units: bytes. Cost: one pass; memory for the lines that say something.

use crate::diagnostic::{Diagnostic, Diagnostics, Gap, Source, Span};
use std::io::{self, Read};

/// The longest line, in bytes outside comments.
pub const LINE_LIMIT: usize = 10_000_000;
/// The most bytes that are read, comments included and after decompression: what `u32` offsets and lines can count.
pub const INPUT_LIMIT: u64 = u32::MAX as u64;

/// How a comment begins that is kept in NFF.
const MARK: &[u8] = b"#farop ";

/// As [`read_source`]; comments that begin with `#farop` and a blank are kept, as words like any others.
///
/// # Errors
/// As [`read_source`].
pub fn read_annotated_source(name: &str, reader: impl Read) -> Result<Source, Diagnostics> {
    read_filtered(name, reader, Filter { keeps_marked: true, ..Filter::default() })
}

/// Reads everything up to [`INPUT_LIMIT`].
///
/// A byte order mark of UTF-8 is skipped. `\n` ends a line; `\r` is white space, and also ends a comment.
///
/// # Errors
/// The reader fails, the input or a line is too long, or it is UTF-16.
pub fn read_source(name: &str, reader: impl Read) -> Result<Source, Diagnostics> {
    read_filtered(name, reader, Filter::default())
}

fn read_filtered(name: &str, mut reader: impl Read, mut filter: Filter) -> Result<Source, Diagnostics> {
    let mut source = Source { name: name.to_string(), ..Source::default() };
    let mut buffer = vec![0; 1 << 16];
    let mut bytes_read = 0;
    loop {
        let count = fill(&mut reader, &mut buffer).map_err(|error| unreadable(name, &error))?;
        let mut chunk = &buffer[..count];
        if bytes_read == 0 {
            chunk = chunk.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(chunk);
            if chunk.starts_with(b"\xFF\xFE") || chunk.starts_with(b"\xFE\xFF") {
                let error = Diagnostic::error(format!("`{name}` is UTF-16 text"));
                return Err(Diagnostics::without_source(error.help("save it as UTF-8 or plain ASCII")));
            }
        }
        bytes_read += count as u64;
        if bytes_read > INPUT_LIMIT {
            let error = Diagnostic::error(format!("`{name}` is larger than {INPUT_LIMIT} bytes (4 GiB)"));
            return Err(Diagnostics::without_source(error.help("split the scene into several files: they merge")));
        }
        filter.keep(chunk, &mut source).map_err(|LineTooLong| too_long(&mut source, &filter))?;
        if count < buffer.len() {
            return Ok(source);
        }
    }
}

/// Fills the buffer as far as the input goes: short reads of a pipe do not look like the end.
fn fill(reader: &mut impl Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut filled = 0;
    while filled < buffer.len() {
        match reader.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(count) => filled += count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(filled)
}

/// What must be remembered from one chunk to the next.
#[derive(Debug, Default)]
struct Filter {
    /// Where the current line starts in the kept text.
    line_start: usize,
    /// The current line has something other than white space.
    speaks: bool,
    in_comment: bool,
    /// Comments that begin with [`MARK`] are kept.
    keeps_marked: bool,
    /// How much of [`MARK`] was seen, of a comment that may still become a kept one.
    marked: usize,
    /// Lines dropped since the last one that was kept.
    dropped: u32,
}

struct LineTooLong;

impl Filter {
    /// Appends to the source what `chunk` says.
    fn keep(&mut self, chunk: &[u8], source: &mut Source) -> Result<(), LineTooLong> {
        let mut rest = chunk;
        while !rest.is_empty() {
            if self.marked > 0 {
                rest = self.compare_mark(rest, source)?;
                continue;
            }
            if self.in_comment {
                let Some(end) = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r') else { return Ok(()) };
                self.in_comment = false;
                rest = &rest[end..];
            }
            if source.text.len() == self.line_start {
                let plain = plain_lines(rest);
                self.keep_plain(&rest[..plain], source);
                rest = &rest[plain..];
            }
            let end = rest.iter().position(|&byte| byte == b'\n' || byte == b'#').unwrap_or(rest.len());
            self.keep_words(&rest[..end], source)?;
            match rest.get(end) {
                Some(b'#') if self.keeps_marked => self.marked = 1,
                Some(b'#') => self.in_comment = true,
                Some(_) => self.end_line(source),
                None => {}
            }
            rest = rest.get(end + 1..).unwrap_or_default();
        }
        Ok(())
    }

    /// Goes on comparing the beginning of a comment with [`MARK`], and returns what is left of the chunk.
    fn compare_mark<'a>(&mut self, rest: &'a [u8], source: &mut Source) -> Result<&'a [u8], LineTooLong> {
        let same = MARK[self.marked..].iter().zip(rest).take_while(|(mark, byte)| mark == byte).count();
        self.marked += same;
        if self.marked == MARK.len() {
            self.marked = 0;
            self.keep_words(MARK, source)?;
        } else if same < rest.len() {
            self.marked = 0;
            self.in_comment = true;
        }
        Ok(&rest[same..])
    }

    /// Keeps lines that all say something, as they are.
    fn keep_plain(&mut self, lines: &[u8], source: &mut Source) {
        if lines.is_empty() {
            return;
        }
        if self.dropped > 0 {
            source.gaps.push(Gap { before: self.line_start as u32, lines: self.dropped });
            self.dropped = 0;
        }
        source.text.extend_from_slice(lines);
        self.line_start = source.text.len();
        self.speaks = false;
    }

    fn keep_words(&mut self, words: &[u8], source: &mut Source) -> Result<(), LineTooLong> {
        source.text.extend_from_slice(words);
        if source.text.len() - self.line_start > LINE_LIMIT {
            return Err(LineTooLong);
        }
        if !self.speaks && words.iter().any(|byte| !super::tokens::is_space(*byte)) {
            self.speaks = true;
            if self.dropped > 0 {
                source.gaps.push(Gap { before: self.line_start as u32, lines: self.dropped });
                self.dropped = 0;
            }
        }
        Ok(())
    }

    fn end_line(&mut self, source: &mut Source) {
        if self.speaks {
            source.text.push(b'\n');
        } else {
            source.text.truncate(self.line_start);
            self.dropped += 1;
        }
        self.speaks = false;
        self.line_start = source.text.len();
    }
}

/// How many bytes whole lines take, from the start of a line on, that need no care: no comment in them, and no white space in front,
/// which might be all there is. Shorter than a chunk, and so than [`LINE_LIMIT`].
fn plain_lines(bytes: &[u8]) -> usize {
    if bytes.first().is_none_or(|&byte| byte <= b' ') {
        return 0;
    }
    let needs_care = |byte: u8, next: u8| (byte == b'#') | ((byte == b'\n') & (next <= b' '));
    // Blocks are looked at whole, which a compiler can do many bytes at a time.
    const BLOCK: usize = 64;
    let mut start = 0;
    while let Some(block) = bytes.get(start..start + BLOCK + 1) {
        let pairs = block[..BLOCK].iter().zip(&block[1..]);
        if pairs.fold(false, |found, (&byte, &next)| found | needs_care(byte, next)) {
            break;
        }
        start += BLOCK;
    }
    let pairs = bytes[start..].windows(2);
    let found = pairs.into_iter().position(|pair| needs_care(pair[0], pair[1]));
    // The line before a blank one is whole.
    let end = found.map_or(bytes.len(), |at| start + at + usize::from(bytes[start + at] == b'\n'));
    bytes[..end].iter().rposition(|&byte| byte == b'\n').map_or(0, |newline| newline + 1)
}

fn unreadable(name: &str, error: &io::Error) -> Diagnostics {
    Diagnostics::without_source(Diagnostic::error(format!("cannot read `{name}`: {error}")))
}

/// The message, with the beginning of the line in question.
fn too_long(source: &mut Source, filter: &Filter) -> Diagnostics {
    // Dropped lines above this one are only counted once it is kept.
    if filter.dropped > 0 {
        source.gaps.push(Gap { before: filter.line_start as u32, lines: filter.dropped });
    }
    let error = Diagnostic::error(format!("a line is longer than {LINE_LIMIT} characters"))
        .at(Span::new(filter.line_start, filter.line_start + 1), "this line")
        .help("is this a scene? If so, break the line: numbers may stand on lines of their own");
    Diagnostics::new(source, vec![error])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives out `bytes` again and again, `times` times.
    struct Repeated {
        bytes: Vec<u8>,
        times: usize,
        at: usize,
    }

    impl Read for Repeated {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            if self.times == 0 {
                return Ok(0);
            }
            let count = buffer.len().min(self.bytes.len() - self.at);
            buffer[..count].copy_from_slice(&self.bytes[self.at..self.at + count]);
            self.at = (self.at + count) % self.bytes.len();
            self.times -= usize::from(self.at == 0);
            Ok(count)
        }
    }

    #[test]
    fn endless_comments_cost_nothing() {
        let comments = |bytes: &[u8], times| Repeated { bytes: bytes.to_vec(), times, at: 0 };
        let many = b"# nothing\n  \t # to\n\n".repeat(1000);
        for (endless, lines) in [(comments(&many, 1000), 3_000_000), (comments(b"#one long line ", 2_000_000), 0)] {
            let reader = endless.chain(&b"\n  s 0 0 0 1 # here\n\n"[..]);
            let source = read_source("", reader).expect("comments are legal");
            assert_eq!(source.text, b"  s 0 0 0 1 \n");
            assert!(source.text.capacity() < 1000);
            assert_eq!(source.line(2), lines + 2);
        }
    }

    #[test]
    fn lines_and_marks() {
        let source = read_source("", &b"\xEF\xBB\xBFs 1\r\n\r\n# a\rb\r\n#\n  c # \0\xFF\nd"[..]).expect("short");
        assert_eq!(source.text, b"s 1\r\n\rb\r\n  c \nd");
        assert_eq!([0, 6, 11, 15].map(|offset| source.line(offset)), [1, 3, 5, 6]);
    }

    #[test]
    fn comments_for_farop_stay_wherever_a_buffer_ends() {
        let text = b"#farop light intensity 1 # why\n#farope\n#farop\n# farop light\n#fa\rl 1 2 3 #farop surface phong\n##farop a\n#far";
        let kept = b"#farop light intensity 1 \n\rl 1 2 3 #farop surface phong\n";
        let whole = read_annotated_source("", &text[..]).expect("short");
        assert_eq!(String::from_utf8_lossy(&whole.text), String::from_utf8_lossy(kept));
        assert_eq!([0, 26].map(|offset| whole.line(offset)), [1, 5]);
        for cut in 0..=text.len() {
            let (mut source, mut filter) = (Source::default(), Filter { keeps_marked: true, ..Filter::default() });
            for chunk in [&text[..cut], &text[cut..]] {
                assert!(filter.keep(chunk, &mut source).is_ok());
            }
            assert_eq!((source.text, source.gaps), (whole.text.clone(), whole.gaps.clone()), "cut at {cut}");
        }
        // Elsewhere it is a comment.
        assert_eq!(read_source("", &b"#farop light\nl"[..]).expect("short").text, b"l");
    }

    #[test]
    fn a_long_line_is_refused_early() {
        let endless = Repeated { bytes: b"1 2 3 ".to_vec(), times: usize::MAX, at: 0 };
        let error = read_source("long.nff", (&b"#\ns 1\n#\n"[..]).chain(endless)).expect_err("a line without end");
        assert!(error.to_string().contains("long.nff:4:1"), "{error}");
        assert!(error.to_string().contains("10000000"), "{error}");
    }
}
