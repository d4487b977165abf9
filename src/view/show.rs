//! Show: what the window can show, by name.

/// What is shown. The number is that of the key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// The finished picture.
    Picture,
    /// Eye space from outside, with the view volume; back faces marked.
    Eye,
    /// The same, with what the planes cut.
    Clip,
    /// Triangles of every polygon with more than three corners, in the order of cutting.
    Split,
    /// Polygons on the screen.
    Screen,
    /// The rasterizer at work: scan line by scan line, or polygon by polygon.
    Raster,
    /// Depth of every pixel.
    Depth,
    /// Normals.
    Normals,
    /// How many polygons cover a sample.
    Overdraw,
    /// Which polygon is in front.
    Polygons,
}

impl Show {
    /// All, in the order of the keys 1 to 9 and 0.
    pub const ALL: [Show; 10] = [
        Show::Picture,
        Show::Eye,
        Show::Clip,
        Show::Split,
        Show::Screen,
        Show::Raster,
        Show::Depth,
        Show::Normals,
        Show::Overdraw,
        Show::Polygons,
    ];

    /// What the key of that digit shows.
    #[must_use]
    pub fn of_digit(digit: char) -> Show {
        let number = digit.to_digit(10).unwrap_or(1) as usize;
        Show::ALL[(number + 9) % 10]
    }

    /// What the window calls it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Show::Picture => "picture",
            Show::Eye => "eye space",
            Show::Clip => "clip",
            Show::Split => "split",
            Show::Screen => "screen",
            Show::Raster => "rasterizer",
            Show::Depth => "depth",
            Show::Normals => "normals",
            Show::Overdraw => "overdraw",
            Show::Polygons => "polygons",
        }
    }

    /// Whether it is seen from outside: keys and pointer then move the one who looks.
    #[must_use]
    pub fn is_outside(self) -> bool {
        matches!(self, Show::Eye | Show::Clip)
    }

    /// Whether one can step through it.
    #[must_use]
    pub fn has_steps(self) -> bool {
        matches!(self, Show::Eye | Show::Clip | Show::Split | Show::Screen | Show::Raster)
    }
}

/// Which picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compare {
    /// What the chosen rasterizer draws.
    Yours,
    /// What the z-buffer draws.
    Reference,
    /// Where they differ.
    Difference,
}

impl Compare {
    /// All, in the order of the key.
    pub const ALL: [Compare; 3] = [Compare::Yours, Compare::Reference, Compare::Difference];
}

/// What helps to find the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Guide {
    /// Nothing.
    Nothing,
    /// A compass.
    Compass,
    /// A compass, and the names of objects where they are.
    Landmarks,
}

impl Guide {
    /// All, in the order of the key.
    pub const ALL: [Guide; 3] = [Guide::Nothing, Guide::Compass, Guide::Landmarks];
}
