//! What a plan refuses, in sentences a user can act on.

/// Why no plan could be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// No file and no option said where the scene is seen from.
    #[error("the scene has no view: add a `v` block to the file, or --from, --at, --up, --angle-of-view and --size")]
    NoCamera,
    /// `from` and `at` coincide.
    #[error("from and at are the same point: the view has no direction; move one of them")]
    NoDirection,
    /// `up` is zero.
    #[error("up is zero: give a direction, for example --up 0,0,1")]
    NoUp,
    /// The opening angle is out of range.
    #[error("the opening angle is {0} degrees: it must be above 0 and below 180")]
    Angle(f64),
    /// The far plane is not behind the near plane.
    #[error("yon {yon} must be greater than hither {hither}")]
    YonNotBehindHither {
        /// Distance of the near plane.
        hither: f64,
        /// Distance of the far plane.
        yon: f64,
    },
    /// A picture without pixels.
    #[error("a picture of {width}x{height} has no pixels: both numbers must be at least 1")]
    EmptyPicture {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// More pixels than allowed.
    #[error("a picture of {width}x{height} exceeds {limit} pixels: choose a smaller --size, or raise --max-pixels")]
    PictureTooLarge {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// The limit in force.
        limit: u64,
    },
    /// A out of range.
    #[error("{0} samples a pixel: A must be from 1 to 64")]
    Samples(u32),
    /// The sample grid is wider than coordinates can be exact.
    #[error("{width}x{height} with {samples} x {samples} samples a pixel is more than 4194304 samples across")]
    TooManySamples {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// Samples per pixel and direction.
        samples: u32,
    },
    /// More sub-pixel bits than coordinates can be exact for.
    #[error("{0} sub-pixel bits: choose 0 to 16, or exact")]
    SubpixelBits(u32),
    /// Integer depth needs a far plane.
    #[error("--depth {0} counts steps between hither and yon: give --yon")]
    IntegerDepthNeedsYon(&'static str),
    /// A tolerance that is not a positive number of pixels.
    #[error("a tolerance of {0} pixels: it must be above 0")]
    Tolerance(f64),
    /// A threshold that no alpha can be on both sides of.
    #[error("an alpha threshold of {0}: it must be from 0 to 1")]
    AlphaThreshold(f64),
    /// A tessellation without segments.
    #[error("a resolution of {0}: it must be from 1 to 1000")]
    Resolution(u32),
    /// A rule for flat shading (the first name) under another shading (the second).
    #[error("--flat {0} is a rule for flat shading, and the shading is {1}: add -s flat, or leave --flat out")]
    FlatRuleWithoutFlat(&'static str, &'static str),
    /// Scan-line interpolation where nothing varies.
    #[error("--interpolation scanline has nothing to interpolate with {0} shading: choose -s gouraud or -s phong")]
    NothingToInterpolate(&'static str),
    /// Scan-line interpolation without polygons to run over.
    #[error(
        "--interpolation scanline runs over whole polygons, and {0}; over a triangle it is --interpolation screen: choose that"
    )]
    ScanLineNeedsPolygons(&'static str),
    /// Objects that use each other multiply.
    #[error(transparent)]
    TooManyInstances(#[from] crate::scene::InstanceBudgetExceeded),
}
