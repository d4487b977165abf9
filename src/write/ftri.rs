//! Triangles -> `.ftri`: the binary file that other renderers are measured with.
//!
//! Little endian; layout and meaning: `docs/formats.md`. Cost: one pass, nothing kept.

use crate::scene::{MAGIC, Triangles};
use std::io::{self, BufWriter, Write};

/// Writes `triangles` as a `.ftri` file and flushes it.
///
/// # Errors
/// Whatever `out` says; [`io::ErrorKind::InvalidInput`] when a list has more than 2^32 - 1 entries or not one for each vertex.
pub fn write_ftri(triangles: &Triangles, out: &mut dyn Write) -> io::Result<()> {
    let vertices = triangles.positions.len();
    let lengths = [triangles.normals.len(), triangles.colors.len(), triangles.texture.len()];
    if lengths.iter().any(|&length| length != vertices) {
        return Err(invalid("a list of the triangles has not one entry for each vertex"));
    }
    let counts = [vertices, triangles.indices.len(), triangles.lights.len(), triangles.ranges.len()];
    let mut out = BufWriter::with_capacity(1 << 16, out);
    out.write_all(MAGIC)?;
    for count in counts {
        let count = u32::try_from(count).map_err(|_| invalid("a list of the triangles is too long for the file"))?;
        out.write_all(&count.to_le_bytes())?;
    }
    let (width, height) = triangles.texture_size;
    words(&[width, height, 0, 0], &mut out)?;
    floats(&triangles.view, &mut out)?;
    floats(&triangles.projection, &mut out)?;
    floats(&triangles.eye, &mut out)?;
    floats(&triangles.background, &mut out)?;
    floats(&triangles.material, &mut out)?;
    for (position, color) in &triangles.lights {
        floats(position, &mut out)?;
        floats(color, &mut out)?;
    }
    for range in &triangles.ranges {
        words(&[range.first, range.count, range.kind.number(), 0], &mut out)?;
    }
    for vectors in [&triangles.positions, &triangles.normals, &triangles.colors] {
        floats(vectors.as_flattened(), &mut out)?;
    }
    floats(triangles.texture.as_flattened(), &mut out)?;
    words(&triangles.indices, &mut out)?;
    out.write_all(&triangles.texels)?;
    out.flush()
}

fn floats(numbers: &[f32], out: &mut impl Write) -> io::Result<()> {
    numbers.iter().try_for_each(|number| out.write_all(&number.to_le_bytes()))
}

fn words(numbers: &[u32], out: &mut impl Write) -> io::Result<()> {
    numbers.iter().try_for_each(|number| out.write_all(&number.to_le_bytes()))
}

fn invalid(message: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, message)
}
