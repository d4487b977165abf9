//! The fields of a `.ftri` file, one behind the other, each checked.
//!
//! bytes -FIELDS-> Triangles

use crate::diagnostic::Diagnostic;
use crate::scene::{MAGIC, MOST_LIGHTS, TriangleKind, TriangleRange, Triangles};

/// Reads all fields.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Triangles, Diagnostic> {
    let mut fields = Fields { name, bytes, at: 0 };
    if !bytes.starts_with(MAGIC) {
        let error = fields.error(0, "expected the letters FTRI1 and three zero bytes");
        return Err(error.help("this is no `.ftri` file; if it is another format, say `--format nff` or `sipp`"));
    }
    fields.at = MAGIC.len();
    let [vertices, indices, lights, ranges, width, height, ..] = fields.head()?;
    let mut triangles = Triangles {
        view: fields.floats("the view matrix")?,
        projection: fields.floats("the projection matrix")?,
        eye: fields.floats("the eye")?,
        background: fields.floats("the background")?,
        material: fields.floats("the material")?,
        texture_size: (width, height),
        ..Triangles::default()
    };
    for at in 0..4 {
        fields.not_negative(fields.at - 16 + 4 * at, triangles.material[at], "a coefficient of the material")?;
    }
    triangles.lights = fields
        .vectors::<6>(lights, "the lights")?
        .into_iter()
        .map(|[x, y, z, r, g, b]| ([x, y, z], [r, g, b]))
        .collect();
    triangles.ranges = fields.ranges(ranges, indices)?;
    triangles.positions = fields.vectors(vertices, "the positions")?;
    triangles.normals = fields.vectors(vertices, "the normals")?;
    triangles.colors = fields.vectors(vertices, "the colors")?;
    triangles.texture = fields.vectors(vertices, "the texture coordinates")?;
    triangles.indices = fields.indices(indices, vertices)?;
    triangles.texels = fields.take(u64::from(width) * u64::from(height) * 4, "the texels")?.to_vec();
    match bytes.len() - fields.at {
        0 => Ok(triangles),
        more => {
            let error = fields.error(fields.at, format!("expected the end of the file, found {more} more bytes"));
            Err(error.help("the sizes in the first 40 bytes say that the file ends here: write it anew"))
        }
    }
}

/// Where the reader is.
struct Fields<'a> {
    name: &'a str,
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Fields<'a> {
    /// Eight sizes: vertices, indices, lights, ranges, width and height of the texture, two zeros.
    fn head(&mut self) -> Result<[u32; 8], Diagnostic> {
        let start = self.at;
        let bytes = self.take(32, "the sizes")?;
        let mut sizes = [0; 8];
        sizes.iter_mut().zip(bytes.chunks_exact(4)).for_each(|(size, bytes)| *size = word(bytes));
        let [_, indices, lights, _, width, height, zeros @ ..] = sizes;
        let wrong = |number: usize, expected: &str| {
            let error = self.error(start + 4 * number, format!("expected {expected}, found {}", sizes[number]));
            Err(error.help("write the file anew: a size that is wrong moves everything behind it"))
        };
        if !indices.is_multiple_of(3) {
            return wrong(1, "a number of indices that is a multiple of 3");
        }
        if lights as usize > MOST_LIGHTS {
            return wrong(2, "at most 8 lights");
        }
        if (width == 0) != (height == 0) {
            return wrong(if width == 0 { 4 } else { 5 }, "width and height of the texture, both or none of them 0");
        }
        match zeros.iter().position(|&zero| zero != 0) {
            Some(number) => wrong(6 + number, "0"),
            None => Ok(sizes),
        }
    }

    /// The next `count` bytes; allocates nothing.
    fn take(&mut self, count: u64, what: &str) -> Result<&'a [u8], Diagnostic> {
        let rest = &self.bytes[self.at..];
        match usize::try_from(count).ok().and_then(|count| rest.get(..count)) {
            Some(bytes) => {
                self.at += bytes.len();
                Ok(bytes)
            }
            None => {
                let end = u128::from(count) + self.at as u128;
                let expected = format!("the file ends here, but {what} reach from byte {} to byte {end}", self.at);
                Err(self
                    .error(self.bytes.len(), expected)
                    .help("the file was cut off or its sizes are wrong: copy it again"))
            }
        }
    }

    /// N finite numbers.
    fn floats<const N: usize>(&mut self, what: &str) -> Result<[f32; N], Diagnostic> {
        let start = self.at;
        let bytes = self.take(4 * N as u64, what)?;
        self.vector(bytes, start, what)
    }

    /// `count` times N finite numbers.
    fn vectors<const N: usize>(&mut self, count: u32, what: &str) -> Result<Vec<[f32; N]>, Diagnostic> {
        let start = self.at;
        let bytes = self.take(u64::from(count) * 4 * N as u64, what)?;
        let vectors = bytes.chunks_exact(4 * N).enumerate();
        vectors.map(|(index, bytes)| self.vector(bytes, start + 4 * N * index, what)).collect()
    }

    fn vector<const N: usize>(&self, bytes: &[u8], start: usize, what: &str) -> Result<[f32; N], Diagnostic> {
        let mut numbers = [0.0; N];
        for (number, bytes) in numbers.iter_mut().zip(bytes.chunks_exact(4)) {
            *number = f32::from_bits(word(bytes));
        }
        match numbers.iter().position(|number| !number.is_finite()) {
            None => Ok(numbers),
            Some(index) => {
                let found = format!("expected a finite number among {what}, found {}", numbers[index]);
                Err(self
                    .error(start + 4 * index, found)
                    .help("what is not finite cannot be drawn: write the file anew"))
            }
        }
    }

    /// The ranges, of a file with so many `indices`.
    fn ranges(&mut self, count: u32, indices: u32) -> Result<Vec<TriangleRange>, Diagnostic> {
        let start = self.at;
        let bytes = self.take(u64::from(count) * 16, "the ranges")?;
        let mut ranges = Vec::new();
        for (index, bytes) in bytes.chunks_exact(16).enumerate() {
            let at = start + 16 * index;
            let [first, count, kind, zero] = [0, 4, 8, 12].map(|at| word(&bytes[at..at + 4]));
            let help = "a range is its first index, how many indices, its kind (0 or 1) and a zero";
            if !count.is_multiple_of(3) || u64::from(first) + u64::from(count) > u64::from(indices) {
                let found =
                    format!("expected a range of whole triangles within {indices} indices, found {first}, {count}");
                return Err(self.error(at, found).help(help));
            }
            let Some(kind) = TriangleKind::of_number(kind).filter(|_| zero == 0) else {
                return Err(self.error(at + 8, format!("expected 0 or 1 and a 0, found {kind}, {zero}")).help(help));
            };
            ranges.push(TriangleRange { first, count, kind });
        }
        Ok(ranges)
    }

    /// The indices, of a file with so many `vertices`.
    fn indices(&mut self, count: u32, vertices: u32) -> Result<Vec<u32>, Diagnostic> {
        let start = self.at;
        let bytes = self.take(u64::from(count) * 4, "the indices")?;
        let indices: Vec<u32> = bytes.chunks_exact(4).map(word).collect();
        match indices.iter().position(|&index| index >= vertices) {
            None => Ok(indices),
            Some(at) => {
                let found = format!("expected the index of one of {vertices} vertices, found {}", indices[at]);
                Err(self.error(start + 4 * at, found).help("indices count from 0"))
            }
        }
    }

    fn not_negative(&self, at: usize, number: f32, what: &str) -> Result<(), Diagnostic> {
        if number >= 0.0 {
            return Ok(());
        }
        Err(self
            .error(at, format!("{what} cannot be negative, and is {number}"))
            .help("ka, kd, ks and shininess are from 0 up"))
    }

    /// A mistake at byte `at`.
    fn error(&self, at: usize, message: impl std::fmt::Display) -> Diagnostic {
        Diagnostic::error(format!("`{}`, byte {at}: {message}", self.name))
    }
}

/// Four bytes as a number.
fn word(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |number, &byte| number << 8 | u32::from(byte))
}
