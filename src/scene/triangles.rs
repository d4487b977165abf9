//! Triangles: what a `.ftri` file holds, as it is written there.
//!
//! bytes -parse::ftri-> TRIANGLES -parse::ftri-> Scene; a generator (`spd::bench`) makes them, `write` writes them.
//!
//! Why a type beside [`super::Scene`]: the file is made for measuring renderers side by side, and says more than a scene (matrices,
//! one list of indices) and less (one material, no tree). What a generator makes and what a file holds become a scene by one
//! function, so a generated scene and its file draw the same bytes.
//!
//! Space: world space, right-handed; matrices are column-major, for column vectors, clip space as in OpenGL. Colors are numbers as
//! written, 0 to 1. Layout and meaning of the file: `docs/formats.md`.

/// The first bytes of a file.
pub const MAGIC: &[u8; 8] = b"FTRI1\0\0\0";
/// The most lights a file may have.
pub const MOST_LIGHTS: usize = 8;

/// The contents of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// Eye space from world space: a turn and a move.
    pub view: [f32; 16],
    /// Clip space from eye space, for a picture as wide as high.
    pub projection: [f32; 16],
    /// The eye, world space.
    pub eye: [f32; 3],
    /// Color behind everything.
    pub background: [f32; 3],
    /// ka, kd, ks and the cosine power, of everything in the file.
    pub material: [f32; 4],
    /// Position (world space) and color of each light; none fades with distance.
    pub lights: Vec<([f32; 3], [f32; 3])>,
    /// Which triangles are drawn how, in the order they are drawn.
    pub ranges: Vec<TriangleRange>,
    /// World space.
    pub positions: Vec<[f32; 3]>,
    /// One a vertex; not necessarily unit.
    pub normals: Vec<[f32; 3]>,
    /// One a vertex.
    pub colors: Vec<[f32; 3]>,
    /// One a vertex; v = 0 is the first row of texels.
    pub texture: Vec<[f32; 2]>,
    /// Three a triangle.
    pub indices: Vec<u32>,
    /// Width and height of the texture; 0 0: there is none.
    pub texture_size: (u32, u32),
    /// Red, green, blue, alpha of each texel, row by row.
    pub texels: Vec<u8>,
}

/// Triangles that are drawn alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleRange {
    /// Index of the first index.
    pub first: u32,
    /// How many indices; a multiple of 3.
    pub count: u32,
    /// What is drawn.
    pub kind: TriangleKind,
}

/// How triangles of a file are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TriangleKind {
    /// Lit and opaque; faces seen from behind (clockwise) are dropped.
    Lit,
    /// Texture times lit color, cut out where alpha is below one half; both sides are drawn.
    Textured,
}

impl TriangleKind {
    /// Its number in the file.
    #[must_use]
    pub fn number(self) -> u32 {
        self as u32
    }

    /// The kind of that number, if there is one.
    #[must_use]
    pub fn of_number(number: u32) -> Option<TriangleKind> {
        [TriangleKind::Lit, TriangleKind::Textured].into_iter().find(|kind| kind.number() == number)
    }
}

impl Triangles {
    /// How many triangles its ranges draw.
    #[must_use]
    pub fn len(&self) -> usize {
        self.ranges.iter().map(|range| range.count as usize / 3).sum()
    }

    /// Whether it draws nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
