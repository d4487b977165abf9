//! Statements -> scene: what the numbers mean, and which of them are refused.
//!
//! Statement -BUILD-> Scene
//!
//! One file becomes one object with one surface for each `f` that has something to show. Its local space is the
//! file's. Colors are kept as display values, as written.
//!
//! Source: E. Haines, NFF.TXT 3.9. Cost: one look-up a vertex, one cross product a polygon.

use super::annotation::{Annotation, SurfaceNote};
use super::camera::camera;
use super::grammar::{Corners, Statement};
use super::nonsense::{Nonsense, refuse};
use super::notices::{Notices, Oddity};
use super::weld::Weld;
use crate::color::Rgb;
use crate::diagnostic::Span;
use crate::math::{Affine3, Vec3, newell_normal};
use crate::parse::area::{is_collinear, out_of_plane, unit_normal};
use crate::parse::{ParseOptions, Winding};
use crate::scene::{
    Light, Material, Mesh, NormalSource, Object, ObjectId, Place, Primitive, Reflection, Scene, Shape, Surface,
    SurfaceId,
};

/// The scene as far as it was read.
pub(super) struct Builder {
    options: ParseOptions,
    scene: Scene,
    surface: Surface,
    surfaces: Vec<SurfaceId>,
    weld: Weld,
    outline: Vec<u32>,
    first_view: Option<Span>,
    /// What a comment for farop says about the next statement.
    pub(super) annotation: Option<Annotation>,
    pub(super) notices: Notices,
}

impl Builder {
    pub(super) fn new(name: &str, options: ParseOptions) -> Builder {
        Builder {
            options,
            scene: Scene { files: vec![name.to_string()], ..Scene::default() },
            surface: empty_surface(Material::default(), Place::default()),
            surfaces: Vec::new(),
            weld: Weld::default(),
            outline: Vec::new(),
            first_view: None,
            annotation: None,
            notices: Notices::default(),
        }
    }

    /// Adds a statement; `keyword` is where it starts, `line` its line in the file.
    pub(super) fn add(
        &mut self,
        statement: Statement,
        corners: &mut Corners,
        (keyword, line): (Span, u32),
    ) -> Result<(), Nonsense> {
        let place = Place { file: 0, line };
        match statement {
            Statement::Polygon | Statement::Patch => {
                self.polygon(statement == Statement::Patch, corners, (keyword, line))
            }
            Statement::View(view) => {
                self.scene.camera = Some(camera(&view, place, |oddity| self.notices.note(oddity, keyword))?);
                match self.first_view {
                    Some(first) => self.notices.note(Oddity::ViewReplaced, first),
                    None => self.first_view = Some(keyword),
                }
            }
            Statement::Background(color) => {
                self.check_color(color, 1, keyword)?;
                self.scene.background = Some(color);
            }
            Statement::Light { position, color } => {
                if color.is_some_and(is_negative) {
                    return refuse(
                        4..=6,
                        "a light cannot be negative",
                        "write three numbers from 0 up, or none: white",
                    );
                }
                let color = color.unwrap_or(Rgb::WHITE);
                let intensity = match self.annotation.take() {
                    Some(Annotation::Light { intensity }) => Some(intensity),
                    _ => None,
                };
                self.scene.lights.push(Light { intensity, ..Light::point(position, color, place) });
            }
            Statement::Surface { color, diffuse, specular, shine, transmitted, refraction } => {
                self.check_color(color, 1, keyword)?;
                check_coefficients([diffuse, specular, shine, transmitted])?;
                let opacity = Rgb::gray(1.0 - transmitted);
                let material = Material { color, diffuse, specular, shine, opacity, refraction, ..Material::default() };
                self.start_surface(material, place);
                if let Some(Annotation::Surface(note)) = self.annotation.take() {
                    annotate(&mut self.surface, note);
                }
            }
            Statement::Sphere { center, radius } => {
                let shape = Shape::Sphere { center, radius: radius.abs() };
                self.primitive(shape, radius < 0.0, radius == 0.0, (keyword, line));
            }
            Statement::Cone { .. } => self.cone(statement, (keyword, line))?,
        }
        Ok(())
    }

    /// The scene, and what was odd in it.
    pub(super) fn finish(mut self) -> (Scene, Notices) {
        self.start_surface(Material::default(), Place::default());
        if !self.surfaces.is_empty() {
            let path = self.scene.files[0].clone();
            let name = path.rsplit(['/', '\\']).next().unwrap_or_default().to_string();
            let (parent_from_local, place) = (Affine3::IDENTITY, Place::default());
            self.scene.objects.push(Object {
                name,
                parent_from_local,
                surfaces: self.surfaces,
                children: Vec::new(),
                place,
            });
            self.scene.world.push(ObjectId(0));
        }
        (self.scene, self.notices)
    }

    /// Puts the current surface into the scene, if it has anything to show, and starts the next.
    fn start_surface(&mut self, material: Material, place: Place) {
        let surface = std::mem::replace(&mut self.surface, empty_surface(material, place));
        if !surface.mesh.polygons.is_empty() || !surface.primitives.is_empty() {
            self.surfaces.push(SurfaceId(self.scene.surfaces.len() as u32));
            self.scene.surfaces.push(surface);
        }
        self.weld.clear();
    }

    fn polygon(&mut self, is_patch: bool, corners: &mut Corners, (keyword, line): (Span, u32)) {
        // Without area there is nothing to draw and no normal.
        if corners.positions.len() < 3 {
            return self.notices.note(Oddity::TooFewVertices, keyword);
        }
        if is_collinear(&corners.positions) {
            return self.notices.note(Oddity::NoArea, keyword);
        }
        let disagrees = corners.positions.len() > 3 && !first_corner_agrees(&corners.positions);
        if disagrees {
            self.notices.note(Oddity::FirstCorner, keyword);
        }
        if corners.positions.len() > 3 {
            self.notices.note_residual(out_of_plane(&corners.positions), keyword);
        }

        if is_patch {
            self.make_unit(&mut corners.normals, keyword);
            if self.options.winding == Winding::Auto && is_inside_out(corners) {
                // The first vertex stays the first: it gives the color of flat shading.
                corners.positions[1..].reverse();
                corners.normals[1..].reverse();
                self.notices.note(Oddity::TurnedOver, keyword);
            }
        }

        self.outline.clear();
        for (index, &position) in corners.positions.iter().enumerate() {
            let normal = if is_patch { corners.normals[index] } else { Vec3::ZERO };
            self.outline.push(self.weld.vertex(&mut self.surface.mesh, position, normal));
        }
        let normals = if is_patch { NormalSource::Given } else { self.options.polygon_normals };
        self.surface.mesh.push_polygon(&self.outline, normals, line);
    }

    /// Gives normals length 1; what has no direction becomes zero.
    fn make_unit(&mut self, normals: &mut [Vec3], keyword: Span) {
        for normal in normals {
            *normal = unit_normal(*normal);
            if *normal == Vec3::ZERO {
                self.notices.note(Oddity::ZeroNormal, keyword);
            }
        }
    }

    fn cone(&mut self, cone: Statement, (keyword, line): (Span, u32)) -> Result<(), Nonsense> {
        let Statement::Cone { base, base_radius, apex, apex_radius } = cone else { return Ok(()) };
        if base_radius.min(apex_radius) < 0.0 && base_radius.max(apex_radius) > 0.0 {
            let words = if base_radius < 0.0 { 4..=4 } else { 8..=8 };
            let help = "make both radii negative to show the inside, or both positive to show the outside";
            return refuse(words, "a cone cannot have one negative and one positive radius", help);
        }
        let is_flat = base == apex;
        let nothing = if is_flat { base_radius == apex_radius } else { base_radius == 0.0 && apex_radius == 0.0 };
        if is_flat && !nothing {
            self.notices.note(Oddity::FlatCone, keyword);
        }
        let shape = Shape::Cone { base, base_radius: base_radius.abs(), apex, apex_radius: apex_radius.abs() };
        self.primitive(shape, base_radius.min(apex_radius) < 0.0, nothing, (keyword, line));
        Ok(())
    }

    fn primitive(&mut self, shape: Shape, inside: bool, nothing: bool, (keyword, line): (Span, u32)) {
        if nothing {
            return self.notices.note(Oddity::NoRadius, keyword);
        }
        let before = self.surface.mesh.polygons.len() as u32;
        self.surface.primitives.push(Primitive { inside, ..Primitive::new(shape, before, line) });
    }

    /// Display colors: negative is refused, above 1 is worth a notice.
    fn check_color(&mut self, color: Rgb, first_word: usize, keyword: Span) -> Result<(), Nonsense> {
        if is_negative(color) {
            let help = "red, green and blue are numbers from 0 to 1";
            return refuse(first_word..=first_word + 2, "a color cannot be negative", help);
        }
        if color.to_array().iter().any(|&channel| channel > 1.0) {
            self.notices.note(Oddity::BrightColor, keyword);
        }
        Ok(())
    }
}

/// What `f` could not say.
fn annotate(surface: &mut Surface, note: SurfaceNote) {
    let material = &mut surface.material;
    material.reflection = if note.is_phong { Reflection::Phong } else { Reflection::Nff };
    material.ambient = note.ambient;
    material.opacity = note.opacity.unwrap_or(material.opacity);
    surface.two_sided = note.two_sided;
}

fn empty_surface(material: Material, place: Place) -> Surface {
    Surface { material, mesh: Mesh::default(), primitives: Vec::new(), two_sided: false, place }
}

fn is_negative(color: Rgb) -> bool {
    color.to_array().iter().any(|&channel| channel < 0.0)
}

/// Kd, Ks, shine and T of an `f`: words 4 to 7.
fn check_coefficients([diffuse, specular, shine, transmitted]: [f64; 4]) -> Result<(), Nonsense> {
    for (word, name, value) in [(4, "Kd", diffuse), (5, "Ks", specular), (6, "shine", shine), (7, "T", transmitted)] {
        if value < 0.0 {
            let message = format!("`{name}` of a surface cannot be negative, and is {value}");
            return refuse(word..=word, message, "`f red green blue Kd Ks shine T index-of-refraction`");
        }
    }
    if transmitted > 1.0 {
        let message = format!("`T` is the fraction of light that passes, 0 to 1, and is {transmitted}");
        return refuse(7..=7, message, "write 0 for an opaque surface, 1 for an invisible one");
    }
    Ok(())
}

/// NFF promises that the first three vertices give the normal; Newell's normal does not need that.
fn first_corner_agrees(outline: &[Vec3]) -> bool {
    let corner = (outline[1] - outline[0]).cross(outline[2] - outline[1]);
    corner.dot(newell_normal(outline)) > 0.0
}

/// The outline of a patch goes round its normals the wrong way.
fn is_inside_out(corners: &Corners) -> bool {
    let mean: Vec3 = corners.normals.iter().sum();
    newell_normal(&corners.positions).dot(mean) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Else a scene that was written and read again would differ in the last bit.
    #[test]
    fn what_was_made_unit_stays_as_it_is() {
        let mut builder = Builder::new("", ParseOptions::default());
        let mut state = 1u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for _ in 0..200_000 {
            let mut once = [Vec3::new(random(), random(), random())];
            builder.make_unit(&mut once, Span::default());
            let mut twice = once;
            builder.make_unit(&mut twice, Span::default());
            assert_eq!(once, twice);
        }
    }
}
