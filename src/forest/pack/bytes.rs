//! Bytes: numbers in and out of a pack, each time with a look at how many bytes are left.
//!
//! Why no byte is believed: a pack may be cut off, or may be something else under a good name. A count is compared with the bytes that
//! are there before memory is asked for, so the largest lie costs what the file is long.
//!
//! Little endian. Cost: one comparison a number.

/// Bytes that are being read, and what messages call them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reader<'a> {
    rest: &'a [u8],
    what: &'static str,
}

impl<'a> Reader<'a> {
    /// Reads `bytes`, which messages call `what`: "the heights".
    pub fn new(bytes: &'a [u8], what: &'static str) -> Reader<'a> {
        Reader { rest: bytes, what }
    }

    /// Whether nothing is left.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// The next `count` bytes.
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let Some((bytes, rest)) = self.rest.split_at_checked(count) else {
            return Err(format!("{} are cut off: {count} bytes expected, {} are left", self.what, self.rest.len()));
        };
        self.rest = rest;
        Ok(bytes)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    pub fn u8(&mut self) -> Result<u8, String> {
        self.array().map(u8::from_le_bytes)
    }

    pub fn u16(&mut self) -> Result<u16, String> {
        self.array().map(u16::from_le_bytes)
    }

    pub fn u32(&mut self) -> Result<u32, String> {
        self.array().map(u32::from_le_bytes)
    }

    pub fn i32(&mut self) -> Result<i32, String> {
        self.array().map(i32::from_le_bytes)
    }

    pub fn u64(&mut self) -> Result<u64, String> {
        self.array().map(u64::from_le_bytes)
    }

    /// A finite number of 8 bytes.
    pub fn f64(&mut self) -> Result<f64, String> {
        self.finite(f64::from_le_bytes)
    }

    /// A finite number of 4 bytes.
    pub fn f32(&mut self) -> Result<f64, String> {
        self.finite(|bytes: [u8; 4]| f64::from(f32::from_le_bytes(bytes)))
    }

    fn finite<const N: usize>(&mut self, number: impl Fn([u8; N]) -> f64) -> Result<f64, String> {
        let value = number(self.array()?);
        if value.is_finite() { Ok(value) } else { Err(format!("{} have a number that is {value}", self.what)) }
    }

    /// Text behind its length.
    pub fn text(&mut self) -> Result<String, String> {
        let length = usize::from(self.u16()?);
        let text = String::from_utf8(self.take(length)?.to_vec());
        text.map_err(|_| format!("{} have text that is not UTF-8", self.what))
    }

    /// A count of things that take at least `bytes` each: not more than there can be.
    pub fn count(&mut self, bytes: usize) -> Result<usize, String> {
        let count = self.u32()? as usize;
        if count > self.rest.len() / bytes {
            let most = self.rest.len() / bytes;
            return Err(format!("{} claim to be {count}, and there are bytes for {most}", self.what));
        }
        Ok(count)
    }

    /// `read`, as often as the count says that stands first; each takes at least `bytes`.
    pub fn list<T>(
        &mut self,
        bytes: usize,
        mut read: impl FnMut(&mut Self) -> Result<T, String>,
    ) -> Result<Vec<T>, String> {
        let count = self.count(bytes)?;
        (0..count).map(|_| read(self)).collect()
    }
}

/// A tag and what it stands before.
pub(super) type Chunk<'a> = ([u8; 4], &'a [u8]);

/// The chunks of some bytes, in order.
pub(super) fn chunks(bytes: &[u8]) -> Result<Vec<Chunk<'_>>, String> {
    let mut reader = Reader::new(bytes, "chunks");
    let mut found = Vec::new();
    while !reader.is_empty() {
        let tag = reader.array()?;
        let length = reader.u32()? as usize;
        found.push((tag, reader.take(length)?));
    }
    Ok(found)
}

/// The contents of the chunk of that tag; `None` where there is none.
pub(super) fn chunk<'a>(chunks: &[Chunk<'a>], tag: &[u8; 4]) -> Option<&'a [u8]> {
    chunks.iter().find(|(found, _)| found == tag).map(|&(_, contents)| contents)
}

/// Appends a chunk whose contents `write` gives; one without contents is left out.
pub(super) fn push_chunk(
    bytes: &mut Vec<u8>,
    tag: &[u8; 4],
    write: impl FnOnce(&mut Vec<u8>) -> Result<(), String>,
) -> Result<(), String> {
    bytes.extend_from_slice(tag);
    let at = bytes.len();
    bytes.extend([0; 4]);
    write(bytes)?;
    let length = bytes.len() - at - 4;
    if length == 0 {
        bytes.truncate(at - 4);
        return Ok(());
    }
    let length = u32::try_from(length).map_err(|_| "a part of it is longer than 4 GiB".to_string())?;
    bytes[at..at + 4].copy_from_slice(&length.to_le_bytes());
    Ok(())
}

/// Appends text behind its length.
pub(super) fn push_text(bytes: &mut Vec<u8>, text: &str) -> Result<(), String> {
    let length = u16::try_from(text.len()).map_err(|_| format!("a name of {} bytes is too long", text.len()))?;
    bytes.extend(length.to_le_bytes());
    bytes.extend_from_slice(text.as_bytes());
    Ok(())
}

/// Appends a count.
pub(super) fn push_count(bytes: &mut Vec<u8>, count: usize) -> Result<(), String> {
    let count = u32::try_from(count).map_err(|_| format!("{count} are too many"))?;
    bytes.extend(count.to_le_bytes());
    Ok(())
}

/// Appends a number as 4 bytes; one that has no finite `f32` is refused.
pub(super) fn push_f32(bytes: &mut Vec<u8>, number: f64) -> Result<(), String> {
    let short = number as f32;
    if !short.is_finite() {
        return Err(format!("a number in it is {number}, and a pack holds numbers up to 3e38"));
    }
    bytes.extend(short.to_le_bytes());
    Ok(())
}

/// Appends a number as 8 bytes.
pub(super) fn push_f64(bytes: &mut Vec<u8>, number: f64) -> Result<(), String> {
    if !number.is_finite() {
        return Err(format!("a number in it is {number}"));
    }
    bytes.extend(number.to_le_bytes());
    Ok(())
}
