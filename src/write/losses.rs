//! What NFF could not say: counted while writing, told in one sentence a kind.
//!
//! Why two sorts: what stands in a comment for farop is lost for other readers only; everything else is lost.

use super::nff::POLYGONIZED_SEGMENTS;

/// What NFF could not say so far.
#[derive(Default)]
pub(super) struct Losses {
    pub no_camera: bool,
    pub yon: bool,
    pub directional_lights: usize,
    pub spots: usize,
    pub basic_surfaces: usize,
    /// Lights and surfaces with a comment that only farop reads.
    pub lights_in_comments: usize,
    pub surfaces_in_comments: usize,
    pub textured_surfaces: usize,
    pub colored_surfaces: usize,
    pub objects: usize,
    pub placed_objects: usize,
    pub names: usize,
    pub flattened_objects: usize,
    pub polygonized_shapes: usize,
}

impl Losses {
    /// One sentence a kind.
    pub fn notices(&self) -> Vec<String> {
        let counted = |count: usize, what: &str| (count > 0).then(|| format!("{what}: {count}"));
        let tree = self.objects > 1 || self.placed_objects > 0;
        let polygonized = format!(
            "spheres and cones that NFF's `s` and `c` cannot say where they stand, written as polygons of {POLYGONIZED_SEGMENTS} segments"
        );
        [
            self.no_camera.then(|| "the scene has no camera: no `v` was written".to_string()),
            self.yon.then(|| "the far plane (yon) was left out: in NFF it is infinitely far".to_string()),
            counted(self.directional_lights, "directional lights, written as point lights far away in their direction"),
            counted(self.spots, "spots without their cone, written as point lights that shine everywhere"),
            counted(self.basic_surfaces, "surfaces of `basic`, written as `phong` with a highlight of the same width"),
            self.in_comments(),
            counted(self.textured_surfaces, "surfaces without their texture coordinates"),
            counted(self.colored_surfaces, "surfaces without the colors of their vertices"),
            counted(
                if tree { self.objects } else { 0 },
                "objects moved into one list in world coordinates, without their nesting",
            ),
            counted(if tree { self.names } else { 0 }, "names of objects left out"),
            counted(self.flattened_objects, "objects left out because their transform flattens them to nothing"),
            counted(self.polygonized_shapes, &polygonized),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn in_comments(&self) -> Option<String> {
        let (lights, surfaces) = (self.lights_in_comments, self.surfaces_in_comments);
        (lights + surfaces > 0).then(|| {
            let what = "light intensities, ambient coefficients, reflection models, opacity per channel and two-sidedness";
            format!(
                "for readers other than farop, which skip `#farop` comments: {what} of {lights} lights and {surfaces} surfaces"
            )
        })
    }
}
