//! NFF: the entities of a scene as lines of text, in the order the scene file names them.
//!
//! scene file -> surface, polygon, sphere, cone -> NFF -> bytes of a file
//!
//! Why not through `Scene` and the `write` room: a scene of 10 million polygons then needs no more memory than one
//! polygon, and the text equals the published files byte for byte.
//!
//! Scene units, right-handed world, degrees for the angle of view.
//! Source: E. Haines, the Neutral File Format, SPD 3.14.
//! Cost: linear in the text; 64 KiB of buffer.

use super::Curves;
use super::tessellate::{self, Cone, Patch, SphereGrid, Torus};
use super::text::write_g;
use crate::math::Vec3;
use std::io::{self, Write};

/// The sky behind most of the scenes.
pub(super) const SKY: [f64; 3] = [0.078, 0.361, 0.753];
/// The exponent that stands for "no visible highlight".
pub(super) const NO_HIGHLIGHT: f64 = 100_000.0;

/// What stands before the objects: background, camera and lights.
pub(super) struct View {
    pub background: [f64; 3],
    pub from: Vec3,
    pub at: Vec3,
    pub up: Vec3,
    pub angle: f64,
    pub hither: f64,
    pub resolution: u32,
    pub lights: Vec<Vec3>,
}

/// A scene being written.
pub(super) struct Nff<'out> {
    lines: Lines<'out>,
    curves: Curves,
    sphere_grid: Option<SphereGrid>,
}

impl<'out> Nff<'out> {
    /// Starts an empty text that goes to `out` piece by piece.
    pub fn new(out: &'out mut dyn Write, curves: Curves) -> Self {
        Nff { lines: Lines { out, text: Vec::with_capacity(Lines::FULL + 4096) }, curves, sphere_grid: None }
    }

    /// Whether spheres and cones are written as such.
    pub fn keeps_curves(&self) -> bool {
        self.curves == Curves::Kept
    }

    /// The resolution of shapes that become polygons in any case.
    fn resolution(&self) -> u32 {
        match self.curves {
            Curves::Kept => Curves::DEFAULT_RESOLUTION,
            Curves::Patches(n) => n,
        }
    }

    /// `b`, `v` and all `l`.
    pub fn view(&mut self, view: &View) -> io::Result<()> {
        let lines = &mut self.lines;
        lines.line("b", &view.background)?;
        lines.line("v", &[])?;
        lines.line("from", view.from.as_ref())?;
        lines.line("at", view.at.as_ref())?;
        lines.line("up", view.up.as_ref())?;
        lines.line("angle", &[view.angle])?;
        lines.line("hither", &[view.hither])?;
        lines.line("resolution", &[f64::from(view.resolution); 2])?;
        view.lights.iter().try_for_each(|light| lines.line("l", light.as_ref()))
    }

    /// `f`: the surface of all that follows. `finish` is Kd, Ks, shine, transmittance, index of refraction.
    pub fn surface(&mut self, color: [f64; 3], finish: [f64; 5]) -> io::Result<()> {
        let ([r, g, b], [kd, ks, shine, t, ior]) = (color, finish);
        self.lines.line("f", &[r, g, b, kd, ks, shine, t, ior])
    }

    /// `p`: a polygon, without vertices that fall together; nothing if fewer than three are left.
    pub fn polygon(&mut self, outline: &[Vec3]) -> io::Result<()> {
        self.lines.polygon(outline)
    }

    /// `pp`: a triangle with a normal at each vertex.
    pub fn patch(&mut self, patch: Patch) -> io::Result<()> {
        self.lines.patch(patch)
    }

    /// `s`, or its triangles.
    pub fn sphere(&mut self, center: Vec3, radius: f64) -> io::Result<()> {
        match self.curves {
            Curves::Kept => self.lines.line("s", &[center.x, center.y, center.z, radius]),
            Curves::Patches(n) => {
                let grid = self.sphere_grid.get_or_insert_with(|| SphereGrid::new(n));
                grid.sphere(center, radius, |patch| self.lines.patch(patch))
            }
        }
    }

    /// `c`, or its triangles.
    pub fn cone(&mut self, cone: &Cone) -> io::Result<()> {
        match self.curves {
            Curves::Kept => {
                let Cone { base, base_radius, apex, apex_radius } = *cone;
                self.lines.line("c", &[base.x, base.y, base.z, base_radius, apex.x, apex.y, apex.z, apex_radius])
            }
            Curves::Patches(n) => tessellate::cone(cone, n, |patch| self.lines.patch(patch)),
        }
    }

    /// The triangles of a torus: NFF has no such entity.
    pub fn torus(&mut self, torus: &Torus) -> io::Result<()> {
        tessellate::torus(torus, self.resolution(), |patch| self.lines.patch(patch))
    }

    /// The 4 n triangles of a disc: NFF has no such entity.
    pub fn disc(&mut self, disc: (Vec3, Vec3, f64), n: u32) -> io::Result<()> {
        tessellate::disc(disc, n, |outline| self.lines.polygon(outline))
    }

    /// Hands over what is still in the buffer.
    pub fn finish(mut self) -> io::Result<()> {
        self.lines.hand_over()?;
        self.lines.out.flush()
    }
}

/// The text itself, and where it goes when the buffer is full.
struct Lines<'out> {
    out: &'out mut dyn Write,
    text: Vec<u8>,
}

impl Lines<'_> {
    /// Bytes that make the buffer worth a call of the operating system.
    const FULL: usize = 1 << 16;

    /// A keyword (may be empty) and numbers, one blank between.
    fn line(&mut self, keyword: &str, numbers: &[f64]) -> io::Result<()> {
        self.text.extend_from_slice(keyword.as_bytes());
        for (place, &number) in numbers.iter().enumerate() {
            if place > 0 || !keyword.is_empty() {
                self.text.push(b' ');
            }
            write_g(&mut self.text, number);
        }
        self.text.push(b'\n');
        if self.text.len() < Self::FULL { Ok(()) } else { self.hand_over() }
    }

    fn polygon(&mut self, outline: &[Vec3]) -> io::Result<()> {
        // Almost every outline is clean as it is.
        if outline.len() < 3 || crate::math::edges(outline).any(|(&a, &b)| coincide(a, b)) {
            let outline = cleaned(outline);
            return if outline.len() < 3 { Ok(()) } else { self.outline(&outline) };
        }
        self.outline(outline)
    }

    fn outline(&mut self, outline: &[Vec3]) -> io::Result<()> {
        self.line("p", &[outline.len() as f64])?;
        outline.iter().try_for_each(|vertex| self.line("", vertex.as_ref()))
    }

    fn patch(&mut self, patch: Patch) -> io::Result<()> {
        self.line("pp", &[3.0])?;
        let mut vertices = patch.points.iter().zip(&patch.normals);
        vertices.try_for_each(|(p, n)| self.line("", &[p.x, p.y, p.z, n.x, n.y, n.z]))
    }

    fn hand_over(&mut self) -> io::Result<()> {
        self.out.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }
}

/// Whether two vertices are the same for the clean-up.
fn coincide(a: Vec3, b: Vec3) -> bool {
    (b - a).length() < 1e-6
}

/// The outline without every vertex that coincides with its successor, around the end as well.
fn cleaned(outline: &[Vec3]) -> Vec<Vec3> {
    let mut kept = outline.to_vec();
    let mut place = 0;
    while place < kept.len() && kept.len() >= 3 {
        let next = kept[(place + 1) % kept.len()];
        if coincide(kept[place], next) {
            kept.remove(place);
        } else {
            place += 1;
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(outline: &[(f64, f64)]) -> String {
        let outline: Vec<_> = outline.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
        let mut text = Vec::new();
        let mut nff = Nff::new(&mut text, Curves::Kept);
        nff.polygon(&outline).and_then(|()| nff.finish()).expect("memory takes it");
        String::from_utf8(text).expect("ASCII")
    }

    #[test]
    fn coinciding_vertices_are_dropped() {
        let triangle = "p 3\n0 0 0\n1 0 0\n0 1 0\n";
        assert_eq!(written(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]), triangle);
        assert_eq!(written(&[(0.0, 0.0), (1.0, 1e-7), (1.0, 0.0), (0.0, 1.0)]), triangle);
        // The last vertex meets the first around the end.
        assert_eq!(written(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.0, 1e-7)]), triangle);
        assert_eq!(written(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0)]), "");
    }
}
