//! What the user chooses: every trade of speed against accuracy, and the historic rules, as plain values.
//!
//! Needs are derived and change no bit of a picture; choices change pictures and are the user's. The names and
//! values are those of the command line.

use crate::color::Encoding;

/// In the place of sub-pixel bits: screen coordinates keep all of theirs, nothing is snapped.
pub const EXACT_SUBPIXELS: u32 = u32::MAX;

/// All choices of one picture. `Default` is what the command line does without options.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// Width and height in pixels; `None`: the scene's own.
    pub size: Option<(u32, u32)>,
    /// How light spreads over a polygon.
    pub shading: Shading,
    /// A: every pixel is the mean of A x A samples; at least 1.
    pub samples: u32,
    /// Silhouette error of tessellated shapes, in pixels, where the file does not say how finely.
    pub tolerance: f64,
    /// Fixed tessellation instead of `tolerance`: n of the standard procedural databases, SIPP's `res` for other shapes. The file's own number wins.
    pub resolution: Option<u32>,
    /// Bits of a sample that screen coordinates keep: 0 (FAROP's integers) to 16, or [`EXACT_SUBPIXELS`].
    pub subpixel_bits: u32,
    /// How depth is kept.
    pub depth: DepthFormat,
    /// Which faces are dropped.
    pub culling: Culling,
    /// Where cut vertices get their light from.
    pub clip_light: ClipLight,
    /// How colors run between vertices.
    pub interpolation: Interpolation,
    /// Where flat shading takes its one normal from.
    pub flat: FlatRule,
    /// How transparent layers add up.
    pub transparency: Transparency,
    /// How pictures on surfaces are looked up.
    pub texture_filter: TextureFilter,
    /// What is there of a surface with holes.
    pub alpha: AlphaRule,
    /// In place of the thresholds of the scene: what alpha must be above.
    pub alpha_threshold: Option<f64>,
    /// What scene colors and picture levels mean.
    pub encoding: Encoding,
    /// Intensity of the ambient light for surfaces without an ambient coefficient; `None`: sqrt(n) / (2 n) of n lights.
    pub ambient: Option<f64>,
    /// Intensity of every light that has none of its own; `None`: sqrt(n) / (2 n) of n lights.
    pub light_intensity: Option<f64>,
    /// Which terms of the reflection model are added up.
    pub light_terms: LightTerms,
    /// Split every polygon into triangles, even where nothing needs it.
    pub triangles: bool,
    /// What the opening angle is measured between.
    pub angle: AngleSpan,
    /// Compute only what the scene needs, or everything.
    pub needs: NeedsMode,
    /// Threads the geometry stage and a rasterizer may use; `None`: as many as the machine has. The picture does not depend on it.
    pub threads: Option<u32>,
    /// Larger pictures are refused.
    pub max_pixels: u64,
}

impl Default for Choices {
    fn default() -> Self {
        Choices {
            size: None,
            shading: Shading::Gouraud,
            samples: 1,
            tolerance: 0.25,
            resolution: None,
            subpixel_bits: 8,
            depth: DepthFormat::F32,
            culling: Culling::Back,
            clip_light: ClipLight::Interpolate,
            interpolation: Interpolation::Perspective,
            flat: FlatRule::Face,
            transparency: Transparency::Over,
            texture_filter: TextureFilter::Trilinear,
            alpha: AlphaRule::Coverage,
            alpha_threshold: None,
            encoding: Encoding::Srgb,
            ambient: None,
            light_intensity: None,
            light_terms: LightTerms::default(),
            triangles: false,
            angle: AngleSpan::Edges,
            needs: NeedsMode::Derived,
            threads: None,
            max_pixels: 1 << 28,
        }
    }
}

/// Declares an enum whose variants have the names of the command line.
macro_rules! named_choice {
    ($(#[$doc:meta])* $name:ident { $($(#[$variant_doc:meta])* $variant:ident = $text:literal),+ $(,)? }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[$variant_doc])* $variant),+ }

        impl $name {
            /// All values, the default first.
            pub const ALL: &'static [$name] = &[$($name::$variant),+];

            /// The value's name on the command line and in files.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $($name::$variant => $text),+ }
            }

        }

        impl std::str::FromStr for $name {
            type Err = String;

            /// The value of that name; else a message that lists the names there are.
            fn from_str(name: &str) -> Result<$name, String> {
                let names = || $name::ALL.iter().map(|value| value.name()).collect::<Vec<_>>().join(", ");
                let known = $name::ALL.iter().copied().find(|value| value.name() == name);
                known.ok_or_else(|| format!("there is {}", names()))
            }
        }
    };
}

named_choice! {
    /// How light spreads over a polygon.
    Shading {
        /// Light at the vertices, color interpolated (Gouraud 1971).
        Gouraud = "gouraud",
        /// One color: the light at the polygon's first vertex with the face's normal.
        Flat = "flat",
        /// Normals interpolated, light at every sample (Phong 1975).
        Phong = "phong",
        /// Edges only.
        Wire = "wire",
    }
}

named_choice! {
    /// How depth is kept: 1/w, larger is nearer.
    DepthFormat {
        /// 1/w in single precision.
        F32 = "f32",
        /// Everything in double precision, depth and colors.
        F64 = "f64",
        /// 24-bit integers between hither and yon, as in hardware.
        Int24 = "int24",
        /// 16-bit integers between hither and yon.
        Int16 = "int16",
    }
}

named_choice! {
    /// Which faces are dropped before anything else is computed.
    Culling {
        /// All back faces, except of surfaces that the scene calls two-sided.
        Back = "back",
        /// As `back`, and transparent surfaces, which NFF calls two-sided, keep theirs, too.
        Nff = "nff",
        /// None: surfaces are two-sided, back faces are lit from the viewer's side.
        None = "none",
    }
}

named_choice! {
    /// Where a vertex made by clipping gets its light from.
    ClipLight {
        /// From the two ends of the cut edge: colors do not depend on where the camera stands.
        Interpolate = "interpolate",
        /// Lit anew, FAROP's own order.
        Relight = "relight",
    }
}

named_choice! {
    /// How colors and normals run between vertices.
    Interpolation {
        /// Linearly on the polygon in space.
        Perspective = "perspective",
        /// Linearly on the screen, triangle by triangle: wrong where depth varies.
        Screen = "screen",
        /// Along the edges on the screen, then along the scan line, over whole polygons (Gouraud 1971): turns with the camera.
        ScanLine = "scanline",
    }
}

named_choice! {
    /// Where flat shading takes its one normal from.
    FlatRule {
        /// The face's own, at the polygon's first vertex in the file: the same wherever the camera stands.
        Face = "face",
        /// The first vertex's own, if it has one: what graphics hardware does.
        Vertex = "vertex",
        /// SIPP's: the mean of the faces around it, at the first vertex that clipping leaves.
        Sipp = "sipp",
    }
}

named_choice! {
    /// How transparent layers add up, front to back.
    Transparency {
        /// Each layer covers its share of what the layers before it let through.
        Over = "over",
        /// SIPP's rule: shares add up until the sum is 1.
        Additive = "additive",
    }
}

named_choice! {
    /// How a picture on a surface is looked up.
    TextureFilter {
        /// Between the texels of the two sizes nearest to the sample's.
        Trilinear = "trilinear",
        /// Between the four texels around the place, of the full picture.
        Bilinear = "bilinear",
        /// The texel that the place is in.
        Nearest = "nearest",
    }
}

named_choice! {
    /// Which samples of a surface with holes are there. One sample a pixel: alpha above the threshold, for all three.
    AlphaRule {
        /// Of A x A samples of a pixel as many as alpha says.
        Coverage = "coverage",
        /// Those with alpha above the threshold; smaller pictures keep the share that is.
        Test = "test",
        /// As `test`, with pictures as they were before anybody repaired them: rims and vanishing twigs.
        Paper = "paper",
    }
}

named_choice! {
    /// What NFF's opening angle is measured between.
    AngleSpan {
        /// The outer edges of the picture.
        Edges = "edges",
        /// The centers of the first and last pixel, as NFF's text says.
        Centers = "centers",
    }
}

named_choice! {
    /// Whether work that the scene does not need is left out. The picture is the same.
    NeedsMode {
        /// Left out.
        Derived = "derived",
        /// Done all the same.
        Full = "full",
    }
}

/// Which terms of the reflection model are added up; all, unless somebody wants to see them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightTerms {
    /// Light from everywhere.
    pub ambient: bool,
    /// Light scattered evenly (Lambert).
    pub diffuse: bool,
    /// The highlight.
    pub specular: bool,
}

impl Default for LightTerms {
    fn default() -> Self {
        LightTerms { ambient: true, diffuse: true, specular: true }
    }
}
