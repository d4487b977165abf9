//! What the language of `.sipp` files could not say so far.

/// Counts, by kind.
#[derive(Default)]
pub(super) struct Losses {
    pub no_camera: bool,
    /// Lights whose intensity was left to the renderer, or was not 1.
    pub light_intensities: usize,
    /// Surfaces of NFF's reflection model.
    pub nff_surfaces: usize,
    /// Surfaces of SIPP's models without an ambient coefficient.
    pub no_ambient: usize,
    pub colored_surfaces: usize,
    pub given_normals: usize,
    pub mixed_surfaces: usize,
    /// Shaders with a picture.
    pub pictures: usize,
    /// Shaders whose picture fades, is a mosaic or a map.
    pub fades: usize,
    /// Objects that turn to the camera.
    pub facing: usize,
    /// Objects that got another name, or one at all.
    pub names: usize,
}

impl Losses {
    pub fn notices(&self) -> Vec<String> {
        let counted = |count: usize, what: &str| (count > 0).then(|| format!("{what}: {count}"));
        [
            self.no_camera.then(|| "the scene has no camera: read again, it gets SIPP's own".to_string()),
            counted(self.light_intensities, "light intensities multiplied into the colors of the lights"),
            counted(
                self.nff_surfaces,
                "surfaces of NFF's reflection written as `phong`, which clamps its sums and shows highlights on the far side too",
            ),
            counted(self.no_ambient, "surfaces that got an ambient coefficient, as the renderer would have chosen"),
            counted(
                self.given_normals,
                "polygons with given normals, averaged where none is given instead of the polygon's own",
            ),
            counted(self.colored_surfaces, "surfaces without the colors of their vertices"),
            counted(self.mixed_surfaces, "surfaces of polygons and shapes, taken apart: the polygons of each stay together"),
            counted(self.pictures, "shaders with a picture, named as in the scene and not copied: keep it beside the file"),
            counted(self.fades, "shaders whose picture is shown whole, without its fade, its mosaic or its map"),
            counted(self.facing, "objects that turn to the camera, written as they stand without it"),
            counted(self.names, "names of objects changed or made up: what stands in several places needs a name of its own"),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}
