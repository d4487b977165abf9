//! Y4M: uncompressed film that encoders read, a line of text before each frame.
//!
//! red, green, blue -Y4M-> brightness and two differences, a byte each, plane after plane
//!
//! Colors: BT.601 (what readers take where nothing is said), every pixel its own color (4:4:4), studio range: black is 16, white 235,
//! differences 16 to 240 about 128. The header says both.
//!
//! Why whole numbers: the products below are exact, so every machine writes the same bytes.
//! Source: YUV4MPEG2 as mjpegtools read it; Rec. ITU-R BT.601.

use crate::image::Picture;
use std::io::{self, Write};

/// Each row of the matrix in 1/65536, gray sums to 219/255 (brightness) or to 0 (differences).
const ROWS: [([i32; 3], i32); 3] =
    [([16_829, 33_039, 6_416], 16), ([-9_714, -19_070, 28_784], 128), ([28_784, -24_103, -4_681], 128)];

/// The line before all frames.
pub(super) fn write_header(out: &mut dyn Write, (width, height): (usize, usize), rate: u32) -> io::Result<()> {
    writeln!(out, "YUV4MPEG2 W{width} H{height} F{rate}:1 Ip A1:1 C444 XCOLORRANGE=LIMITED")
}

/// One frame.
pub(super) fn write_frame(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    out.write_all(b"FRAME\n")?;
    let mut plane = Vec::with_capacity(picture.width() * picture.height());
    for (weights, zero) in ROWS {
        plane.clear();
        plane.extend(picture.colors().map(|color| {
            let sum: i32 = weights.iter().zip(color).map(|(weight, level)| weight * i32::from(level)).sum();
            // Rounded to the nearest; the shift rounds down, also below zero.
            (zero + ((sum + (1 << 15)) >> 16)) as u8
        }));
        out.write_all(&plane)?;
    }
    Ok(())
}
