//! The answer of a rasterizer outside farop: bytes of a picture, read with suspicion.
//!
//! bytes on standard output -ANSWER-> light, or an [`ExternalFailure`] with a name
//!
//! Two kinds are read: P6 with largest value 255, where level v is light v / 255 (so a program writes round(255 c)); and PF, the
//! portable float map, where nothing is rounded. Anything else is not just "broken": the usual accidents are recognized.
//!
//! Source: J. Poskanzer, Netpbm, `ppm(5)`, 1989; P. Debevec's PFM as in `pfm(5)` (rows from the bottom up; a negative scale is
//! little-endian).
//! Cost: one pass; no memory is asked for before the size was compared with the one expected.

use super::ExternalFailure;
use crate::color::Rgb;
use crate::image::Image;

/// How far into the output a picture is looked for behind text that does not belong there.
const SEARCHED: usize = 1 << 16;

/// The light in `bytes`: a picture of `size`.
pub(super) fn read(bytes: &[u8], size: (u32, u32), stderr: &str) -> Result<Image, ExternalFailure> {
    if bytes.is_empty() {
        return Err(ExternalFailure::NoPicture { stderr: stderr.to_string() });
    }
    let head = match Head::read(bytes) {
        Ok(head) => head,
        Err(what) => return Err(not_a_picture(bytes, what)),
    };
    let expected = (u64::from(size.0), u64::from(size.1));
    if head.size != expected {
        let swapped = head.size == (expected.1, expected.0);
        return Err(if swapped {
            ExternalFailure::SwappedSize { drawn: head.size }
        } else {
            ExternalFailure::WrongSize { expected, drawn: head.size }
        });
    }
    let (needed, pixels) = (head.pixel_bytes(), &bytes[head.length..]);
    if let Some(damage) = text_mode(bytes, head.length + needed) {
        return Err(ExternalFailure::TextMode { damage });
    }
    if pixels.len() < needed {
        return Err(ExternalFailure::TooShort { expected: needed as u64, got: pixels.len() as u64 });
    }
    let (pixels, rest) = pixels.split_at(needed);
    // A line end behind the picture is no harm.
    if !rest.iter().all(u8::is_ascii_whitespace) {
        return Err(ExternalFailure::TextAfter { bytes: rest.len() as u64, shown: shown(rest) });
    }
    Ok(head.light(pixels))
}

/// What a remark begins with: a comment in the head of a PF, in which a program of ours says more than the picture.
const REMARK: &str = "PF\n# farop ";

/// The remark in the head of a picture, if there is one.
pub(super) fn remark(bytes: &[u8]) -> Option<String> {
    let rest = bytes.strip_prefix(REMARK.as_bytes())?;
    let end = rest.iter().position(|&byte| byte == b'\n')?;
    String::from_utf8(rest[..end].to_vec()).ok()
}

/// The pictures in `bytes` with their remarks, one of each of `sizes`; `None` unless exactly these are there.
pub(super) fn read_all(bytes: &[u8], sizes: impl Iterator<Item = (u32, u32)>) -> Option<Vec<(Image, Option<String>)>> {
    let mut rest = bytes;
    let mut next = |size: (u32, u32)| {
        let picture = rest.trim_ascii_start();
        let head = Head::read(picture).ok()?;
        if head.size != (u64::from(size.0), u64::from(size.1)) {
            return None;
        }
        let end = head.length + head.pixel_bytes();
        rest = picture.get(end..)?;
        Some((head.light(&picture[head.length..end]), remark(picture)))
    };
    let images = sizes.map(&mut next).collect::<Option<Vec<_>>>()?;
    rest.trim_ascii_start().is_empty().then_some(images)
}

/// The PF picture of rows of light, `width` samples each: what the host of a library answers.
///
/// ```
/// let mut out = Vec::new();
/// farop::raster::external::write_floats(1, &[0.0, 0.5, 1.0], &mut out);
/// assert!(out.starts_with(b"PF\n1 1\n-1\n"));
/// ```
pub fn write_floats(width: usize, rgb: &[f32], out: &mut Vec<u8>) {
    let row = width * 3;
    let height = rgb.len().checked_div(row).unwrap_or(0);
    out.extend_from_slice(format!("PF\n{width} {height}\n-1\n").as_bytes());
    for row in rgb.chunks_exact(row.max(1)).rev() {
        row.iter().for_each(|channel| out.extend_from_slice(&channel.to_le_bytes()));
    }
}

/// As [`write_floats`], with a remark (one line) in the head, which the reader hands on as [`super::Answer::remark`].
pub fn write_remarked(width: usize, rgb: &[f32], remark: &str, out: &mut Vec<u8>) {
    let mut picture = Vec::new();
    write_floats(width, rgb, &mut picture);
    out.extend_from_slice(REMARK.as_bytes());
    out.extend(remark.bytes().map(|byte| if byte == b'\n' { b' ' } else { byte }));
    // What follows the two letters of the kind.
    out.extend_from_slice(&picture[2..]);
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// P6.
    Levels,
    /// PF; whether little-endian.
    Floats { little: bool },
}

struct Head {
    kind: Kind,
    size: (u64, u64),
    /// Bytes before the first pixel.
    length: usize,
}

impl Head {
    fn read(bytes: &[u8]) -> Result<Head, String> {
        let mut at = 2;
        let magic = bytes.get(..2).unwrap_or(bytes);
        if magic != b"P6" && magic != b"PF" {
            return Err(format!("it begins with `{}`", shown(bytes)));
        }
        let mut number = |what: &str| {
            let word = next_word(bytes, &mut at);
            word.parse::<f64>().map_err(|_| format!("{what} should be a number, it is `{word}`"))
        };
        let (width, height) = (number("the width")?, number("the height")?);
        let last = number("the largest value")?;
        let kind = match (magic, last) {
            (b"P6", 255.0) => Kind::Levels,
            (b"P6", _) => return Err(format!("its largest value is {last}, it should be 255")),
            _ => Kind::Floats { little: last < 0.0 },
        };
        Ok(Head { kind, size: (width as u64, height as u64), length: (at + 1).min(bytes.len()) })
    }

    /// Bytes of all pixels; the size has been compared with the one expected.
    fn pixel_bytes(&self) -> usize {
        let channels = self.size.0 as usize * self.size.1 as usize * 3;
        if self.kind == Kind::Levels { channels } else { channels * 4 }
    }

    fn light(&self, pixels: &[u8]) -> Image {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let mut image = Image::new(width, height, Rgb::gray(0.0));
        let channel = |number: usize| match self.kind {
            Kind::Levels => f32::from(pixels[number]) / 255.0,
            Kind::Floats { little } => {
                let [a, b, c, d] = [0, 1, 2, 3].map(|byte| pixels[number * 4 + byte]);
                if little { f32::from_le_bytes([a, b, c, d]) } else { f32::from_be_bytes([a, b, c, d]) }
            }
        };
        for y in 0..height {
            let row = if self.kind == Kind::Levels { y } else { height - 1 - y };
            for x in 0..width {
                let first = (row * width + x) * 3;
                image.set_pixel(x, y, Rgb::new(channel(first), channel(first + 1), channel(first + 2)));
            }
        }
        image
    }
}

/// The next word of a head; `#` starts a comment to the end of the line.
fn next_word(bytes: &[u8], at: &mut usize) -> String {
    while let Some(byte) = bytes.get(*at) {
        match byte {
            b'#' => *at += bytes[*at..].iter().take_while(|&&byte| byte != b'\n').count(),
            byte if byte.is_ascii_whitespace() => *at += 1,
            _ => break,
        }
    }
    let start = (*at).min(bytes.len());
    let length = bytes[start..].iter().take(16).take_while(|byte| !byte.is_ascii_whitespace()).count();
    *at = start + length;
    String::from_utf8_lossy(&bytes[start..start + length]).into_owned()
}

/// Which accident made this of a picture.
fn not_a_picture(bytes: &[u8], what: String) -> ExternalFailure {
    if bytes.starts_with(b"P3") {
        return ExternalFailure::TextPicture;
    }
    let searched = &bytes[..bytes.len().min(SEARCHED)];
    let behind = (1..searched.len()).find(|&at| is_picture(&searched[at..]));
    match behind {
        Some(at) => ExternalFailure::TextBefore { shown: shown(&bytes[..at]) },
        None => ExternalFailure::BadPicture(what),
    }
}

/// Whether a picture begins here: a head that can be read, or that of a P3.
fn is_picture(bytes: &[u8]) -> bool {
    let is_text = bytes.starts_with(b"P3") && bytes.get(2).is_some_and(u8::is_ascii_whitespace);
    is_text || Head::read(bytes).is_ok()
}

/// Names the change that makes a whole picture of `length` bytes out of `bytes` when it is undone.
fn text_mode(bytes: &[u8], length: usize) -> Option<&'static str> {
    if bytes.len() <= length {
        return None;
    }
    // Text mode spares no line feed, so one without a carriage return before it acquits.
    let line_feeds = bytes.iter().filter(|&&byte| byte == b'\n').count();
    let pairs = bytes.windows(2).filter(|pair| pair == b"\r\n").count();
    if pairs > 0 && pairs == line_feeds {
        return Some("a carriage return stands before every line feed, as Windows' text mode puts it");
    }
    let text = std::str::from_utf8(bytes).ok()?;
    let one_byte_each = text.chars().all(|letter| u32::from(letter) < 256) && !bytes.is_ascii();
    (one_byte_each && (length..=length + 1).contains(&text.chars().count()))
        .then_some("bytes above 127 were written as UTF-8 text, two bytes each")
}

/// The beginning of some bytes, safe to print.
fn shown(bytes: &[u8]) -> String {
    let first_line = bytes.split(|&byte| byte == b'\n').find(|line| !line.is_empty()).unwrap_or(bytes);
    first_line[..first_line.len().min(40)].escape_ascii().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fails(bytes: &[u8]) -> &'static str {
        read(bytes, (3, 2), "").map(|_| "none").unwrap_or_else(|failure| failure.name())
    }

    #[test]
    fn levels_and_floats_are_the_same_light() {
        let levels: Vec<u8> = (0..18).map(|number| number * 15).collect();
        let image = read(&[b"P6 3 2 255\n", &levels[..]].concat(), (3, 2), "").expect("a picture");
        assert_eq!(image.pixel(1, 1), Rgb::new(180.0 / 255.0, 195.0 / 255.0, 210.0 / 255.0));
        let floats: Vec<f32> = levels.iter().map(|&level| f32::from(level) / 255.0).collect();
        let mut bytes = Vec::new();
        write_floats(3, &floats, &mut bytes);
        assert_eq!(read(&bytes, (3, 2), "").expect("a picture"), image);
    }

    #[test]
    fn remarks_come_with_their_pictures() {
        let mut bytes = Vec::new();
        write_remarked(1, &[0.0; 3], "two\nlines", &mut bytes);
        write_floats(1, &[0.5; 3], &mut bytes);
        assert_eq!(remark(&bytes).as_deref(), Some("two lines"));
        let both = read_all(&bytes, [(1, 1), (1, 1)].into_iter()).expect("two pictures");
        assert_eq!(both.iter().map(|(_, remark)| remark.as_deref()).collect::<Vec<_>>(), [Some("two lines"), None]);
    }

    #[test]
    fn several_pictures_are_all_there_or_none() {
        let two = b"P6 1 1 255\n   \nP6 2 1 255\nabcdef".as_slice();
        let sizes = |all: &'static [(u32, u32)]| read_all(two, all.iter().copied()).map(|images| images.len());
        assert_eq!(sizes(&[(1, 1), (2, 1)]), Some(2));
        assert_eq!(sizes(&[(1, 1)]), None);
        assert_eq!(sizes(&[(1, 1), (1, 2)]), None);
        assert_eq!(sizes(&[(1, 1), (2, 1), (1, 1)]), None);
    }

    #[test]
    fn every_accident_has_its_name() {
        let pixels = [200, 10, 13, 10, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12];
        let with_head = |head: &str| [head.as_bytes(), &pixels].concat();
        assert_eq!(fails(&with_head("P6\n# by hand\n3 2\n255\n")), "none");
        assert_eq!(fails(&[&with_head("P6 3 2 255\n")[..], b"\n"].concat()), "none");
        // A carriage return and a line feed among the pixels are no damage.
        assert_eq!(fails(&[&with_head("P6\n3 2\n255\n")[..], b"more"].concat()), "text-after-picture");
        assert_eq!(fails(b""), "no-output");
        assert_eq!(fails(b"hello"), "bad-picture");
        assert_eq!(fails(b"P6 3 2 65535\n"), "bad-picture");
        assert_eq!(fails(b"P3 3 2 255 1 2 3"), "p3");
        assert_eq!(fails(&with_head("P6 2 3 255\n")), "swapped-size");
        assert_eq!(fails(&with_head("P6 9 9 255\n")), "wrong-size");
        assert_eq!(fails(&with_head("reading\ndone P6\nP6 3 2 255\n")), "text-before-picture");
        assert_eq!(fails(b"debug 1\nP3\n3 2\n255\n"), "text-before-picture");
        assert_eq!(fails(&with_head("P6 3 2 255\n")[..20]), "too-short");
        assert_eq!(fails(&[&with_head("P6 3 2 255\n")[..], b"done"].concat()), "text-after-picture");
    }

    #[test]
    fn damage_by_text_mode_is_recognized() {
        let good =
            [b"P6\n3 2\n255\n".as_slice(), &[200, 10, 1, 10, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]].concat();
        let windows: Vec<u8> =
            good.iter().flat_map(|&byte| if byte == 10 { vec![13, 10] } else { vec![byte] }).collect();
        assert_eq!(fails(&windows), "text-mode");
        let utf8: String = good.iter().map(|&byte| char::from(byte)).collect();
        assert_eq!(fails(utf8.as_bytes()), "text-mode");
    }
}
