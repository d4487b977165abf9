//! The words of the language, and what belongs in which block.

use super::table::{Parameter, Range, Takes, numbers, other};

/// Words that start a statement at the level of the file.
pub(super) const FILE_WORDS: &[&str] =
    &["shader", "object", "world", "light", "camera", "background", "two_sided", "image"];

/// Words that start an item of an object or world.
pub(super) const ITEM_WORDS: &[&str] = &[
    "object",
    "use",
    "copy",
    "clone",
    "import",
    "surface",
    "rotate",
    "scale",
    "move",
    "mirror",
    "matrix",
    "cube",
    "block",
    "prism",
    "sphere",
    "ellipsoid",
    "cylinder",
    "cone",
    "torus",
    "teapot",
    "teapot_body",
    "teapot_lid",
    "teapot_handle",
    "teapot_spout",
    "open_cone",
    "bezier",
    "billboard",
    "crossed",
];

/// Words that start a transform.
pub(super) const TRANSFORM_WORDS: &[&str] = &["rotate", "scale", "move", "mirror", "matrix"];

/// Words inside a `surface`.
pub(super) const SURFACE_WORDS: &[&str] = &["v", "polygon", "facet", "two_sided", "winding"];

pub(super) const ON_OFF: &[&str] = &["on", "off"];

const COLOR: Parameter = numbers("color", "color R G B", &[3], Range::From0);
const OPACITY: Parameter = numbers("opacity", "opacity N or opacity R G B", &[1, 3], Range::Fraction);
const AMBIENT: Parameter = numbers("ambient", "ambient N", &[1], Range::From0);
const SPECULAR: Parameter = numbers("specular", "specular N", &[1], Range::From0);

const TEXTURE: Parameter = other("texture", "texture \"FILE\"", Takes::Text);
const CUTOUT: Parameter = numbers("cutout", "cutout N", &[1], Range::Fraction);
const KEY: Parameter = numbers("key", "key R G B", &[3], Range::Fraction);
const WRAP: Parameter = other("wrap", "wrap repeat or wrap clamp", Takes::OneOf(&["repeat", "clamp"]));

/// What `billboard` and `crossed` may have between braces.
pub(super) const STANDING: &[Parameter] = &[CUTOUT, KEY];

pub(super) const PHONG: &[Parameter] = &[
    AMBIENT,
    numbers("diffuse", "diffuse N", &[1], Range::From0),
    SPECULAR,
    numbers("exponent", "exponent N", &[1], Range::From0),
    COLOR,
    OPACITY,
    TEXTURE,
    CUTOUT,
    KEY,
    WRAP,
];

pub(super) const BASIC: &[Parameter] = &[
    AMBIENT,
    SPECULAR,
    numbers("c3", "c3 N", &[1], Range::PositiveFraction),
    COLOR,
    OPACITY,
    TEXTURE,
    CUTOUT,
    KEY,
    WRAP,
];

pub(super) const DIRECTIONAL: &[Parameter] = &[numbers("to", "to X Y Z", &[3], Range::Direction).required(), COLOR];

pub(super) const POINT: &[Parameter] = &[numbers("at", "at X Y Z", &[3], Range::Any).required(), COLOR];

pub(super) const SPOT: &[Parameter] = &[
    numbers("from", "from X Y Z", &[3], Range::Any).required(),
    numbers("at", "at X Y Z", &[3], Range::Any).required(),
    numbers("opening", "opening DEGREES", &[1], Range::Opening).required(),
    other("edge", "edge sharp or edge soft", Takes::OneOf(&["sharp", "soft"])),
    COLOR,
    other("shadow", "shadow on", Takes::OneOf(ON_OFF)),
];

pub(super) const CAMERA: &[Parameter] = &[
    numbers("from", "from X Y Z", &[3], Range::Any),
    numbers("at", "at X Y Z", &[3], Range::Any),
    numbers("up", "up X Y Z", &[3], Range::Direction),
    numbers("focal", "focal F", &[1], Range::Above0),
    numbers("angle", "angle DEGREES", &[1], Range::Opening),
    numbers("hither", "hither N", &[1], Range::Any),
    numbers("yon", "yon N", &[1], Range::Above0),
];

/// What every shape takes.
pub(super) const SHAPE: &[Parameter] = &[
    other("shader", "shader NAME", Takes::Name).required(),
    numbers("res", "res N", &[1, 2], Range::Resolution),
    other("texture", "texture MODE", Takes::OneOf(&["natural", "cylindrical", "spherical", "world"])),
    other("inside", "inside", Takes::Nothing),
    other("two_sided", "two_sided on", Takes::OneOf(ON_OFF)),
];

const LENGTH: Parameter = numbers("length", "length L", &[1], Range::Above0).required();
const RADIUS: Parameter = numbers("radius", "radius R", &[1], Range::Above0).required();

/// What a shape takes besides; `None` for words that are no shape.
pub(super) fn shape_parameters(word: &[u8]) -> Option<&'static [Parameter]> {
    Some(match word {
        b"cube" => const { &[numbers("size", "size S", &[1], Range::Above0).required()] },
        b"block" => const { &[numbers("size", "size X Y Z", &[3], Range::Above0).required()] },
        b"prism" => {
            const {
                &[
                    other("outline", "outline X Y X Y X Y ...", Takes::Pairs).required(),
                    numbers("height", "height H", &[1], Range::Above0).required(),
                ]
            }
        }
        b"sphere" => const { &[RADIUS, numbers("center", "center X Y Z", &[3], Range::Any)] },
        b"ellipsoid" => const { &[numbers("radii", "radii X Y Z", &[3], Range::Above0).required()] },
        b"cylinder" => const { &[RADIUS, LENGTH] },
        b"cone" => {
            const {
                &[
                    numbers("bottom", "bottom R", &[1], Range::From0).required(),
                    numbers("top", "top R", &[1], Range::From0).required(),
                    LENGTH,
                ]
            }
        }
        b"torus" => {
            const {
                &[
                    numbers("ring", "ring R", &[1], Range::Above0).required(),
                    numbers("tube", "tube R", &[1], Range::Above0).required(),
                ]
            }
        }
        b"open_cone" => {
            const {
                &[
                    numbers("base", "base X Y Z R", &[4], Range::Any).required(),
                    numbers("apex", "apex X Y Z R", &[4], Range::Any).required(),
                ]
            }
        }
        b"bezier" => {
            const {
                &[
                    other("file", "file \"NAME\"", Takes::Text),
                    numbers("v", "v X Y Z", &[3], Range::Any).repeats(),
                    numbers("patch", "patch and 16 indices", &[16], Range::Any).repeats(),
                    numbers("curve", "curve and 4 indices", &[4], Range::Any).repeats(),
                ]
            }
        }
        b"teapot" | b"teapot_body" | b"teapot_lid" | b"teapot_handle" | b"teapot_spout" => &[],
        _ => return None,
    })
}

/// Words of SIPP and its kin that farop has no use for, and what to do.
pub(super) fn foreign(word: &[u8]) -> Option<(&'static str, &'static str)> {
    Some(match word {
        b"strauss" | b"marble" | b"granite" | b"wood" | b"bozo" | b"planet" | b"bumpy" | b"mask" => {
            ("a shader of SIPP that is not in farop", "the nearest are `phong` and `basic`")
        }
        b"shadows" => ("SIPP's switch for shadows, and farop draws none", "remove it"),
        [b'S', b'i', b'p', b'p', ..] | b"set" | b"proc" => (
            "a command of TSIPP, and a `.sipp` file is no program",
            "write what the scene *is*: `shader`, `object`, `world`, `light`, `camera`",
        ),
        b"v" | b"b" | b"l" | b"f" | b"s" | b"c" | b"p" | b"pp" => {
            ("NFF, and this is read as SIPP", "name the file `.nff` or add `--format nff`")
        }
        _ => return None,
    })
}
