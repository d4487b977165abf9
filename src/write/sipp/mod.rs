//! A whole scene in the language of `.sipp` files: the tree as it is, with what is shared said once.
//!
//! Scene -sharing, shaders-> names -WRITE SIPP-> text -parse-> the same Scene
//!
//! Parsing what was written gives the tree again: names, transforms, surfaces, to the bit. Objects that stand in several places become
//! definitions, and `use` stands where they stood, so a scene of 2^20 leaves that 20 objects say is 20 objects long.
//!
//! Why a list of steps instead of functions that call each other: 100,000 nested objects are a legal scene. For the same reason the
//! indentation ends at a few levels; else such a file would be 20 GB of blanks.
//!
//! Space: as the scene's. Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", for what the words mean. Cost: linear in the scene.

mod losses;
mod shaders;
mod shapes;
mod sharing;
mod view;

use super::number::write_number;
use crate::math::{Affine3, Mat3, Vec3};
use crate::scene::{Mesh, NormalSource, ObjectId, Polygon, Scene, Surface, SurfaceId};
use losses::Losses;
use shaders::Shaders;
use sharing::Sharing;
use std::io::{self, Write};

/// Deeper levels are not indented further.
const DEEPEST_INDENTATION: usize = 12;

/// Writes `scene` as `.sipp` and returns, one sentence each, what the language could not say.
///
/// Order: picture size, camera, background, lights, shaders (one for all surfaces of equal material), objects that stand in several places,
/// the world. Surfaces that show nothing are left out. What comes from NFF and has no word here is written as the nearest that has:
/// see [`crate::scene::Reflection::Nff`].
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::InvalidData`] for a number that is infinite or not a number and for an object inside itself.
pub fn write_sipp(scene: &Scene, out: &mut dyn Write) -> io::Result<Vec<String>> {
    let mut losses = Losses { facing: scene.facing.len(), ..Losses::default() };
    let sharing = Sharing::of(scene, &mut losses)?;
    let shaders = Shaders::of(scene, &sharing, &mut losses);
    let default_two_sided = sharing.surfaces().all(|id| scene.surface(id).two_sided) && sharing.surfaces().count() > 0;
    let mut printer = Printer { scene, sharing, shaders, default_two_sided, losses, out, depth: 0 };
    printer.view()?;
    if default_two_sided {
        writeln!(printer.out, "two_sided on")?;
    }
    printer.shaders.write(printer.out)?;
    printer.definitions()?;
    printer.world()?;
    Ok(printer.losses.notices())
}

/// What is left to write of the tree.
enum Step {
    /// An object where it stands.
    Place(ObjectId),
    /// The end of a block.
    Close,
}

/// Writes statements, indented.
struct Printer<'a> {
    scene: &'a Scene,
    sharing: Sharing,
    shaders: Shaders,
    /// The file says `two_sided on` for all.
    default_two_sided: bool,
    losses: Losses,
    out: &'a mut dyn Write,
    depth: usize,
}

impl Printer<'_> {
    /// Starts a line.
    fn indent(&mut self) -> io::Result<()> {
        let blanks = 2 * self.depth.min(DEEPEST_INDENTATION);
        write!(self.out, "{:blanks$}", "")
    }

    /// One line: words, then numbers.
    fn line(&mut self, words: &str, numbers: &[f64]) -> io::Result<()> {
        self.indent()?;
        self.out.write_all(words.as_bytes())?;
        self.numbers(numbers)?;
        writeln!(self.out)
    }

    /// Numbers, each behind a blank.
    fn numbers(&mut self, numbers: &[f64]) -> io::Result<()> {
        numbers.iter().try_for_each(|&number| write_number(self.out, number))
    }

    fn open(&mut self, words: &str) -> io::Result<()> {
        self.line(&format!("{words} {{"), &[])?;
        self.depth += 1;
        Ok(())
    }

    fn close(&mut self) -> io::Result<()> {
        self.depth -= 1;
        self.line("}", &[])
    }

    /// Objects that stand in several places, without the transforms they have there.
    fn definitions(&mut self) -> io::Result<()> {
        for index in 0..self.sharing.definitions.len() {
            let id = self.sharing.definitions[index];
            writeln!(self.out)?;
            self.open(&format!("object {}", self.sharing.name(id)))?;
            let mut steps = vec![Step::Close];
            self.contents(id, &mut steps)?;
            self.run(steps)?;
        }
        Ok(())
    }

    fn world(&mut self) -> io::Result<()> {
        if self.scene.world.is_empty() {
            return Ok(());
        }
        writeln!(self.out)?;
        self.open("world")?;
        let places = self.scene.world.iter().rev().map(|&id| Step::Place(id));
        self.run([Step::Close].into_iter().chain(places).collect())
    }

    /// Takes steps from the end of the list until none is left.
    fn run(&mut self, mut steps: Vec<Step>) -> io::Result<()> {
        while let Some(step) = steps.pop() {
            match step {
                Step::Close => self.close()?,
                Step::Place(id) => self.place(id, &mut steps)?,
            }
        }
        Ok(())
    }

    fn place(&mut self, id: ObjectId, steps: &mut Vec<Step>) -> io::Result<()> {
        let (scene, is_shared) = (self.scene, self.sharing.is_shared(id));
        let object = scene.object(id);
        let name = self.sharing.name(id);
        let is_moved = object.parent_from_local != Affine3::IDENTITY;
        match (is_shared, is_moved) {
            (true, false) => return self.line(&format!("use {name}"), &[]),
            (true, true) => self.open(&format!("use {name}"))?,
            (false, _) if name.is_empty() => self.open("object")?,
            (false, _) => self.open(&format!("object {name}"))?,
        }
        steps.push(Step::Close);
        self.transform(&object.parent_from_local)?;
        if is_shared { Ok(()) } else { self.contents(id, steps) }
    }

    /// The surfaces of an object, and its children as further steps.
    fn contents(&mut self, id: ObjectId, steps: &mut Vec<Step>) -> io::Result<()> {
        let object = self.scene.object(id);
        object.surfaces.iter().try_for_each(|&surface| self.surface(surface))?;
        steps.extend(object.children.iter().rev().map(|&child| Step::Place(child)));
        Ok(())
    }

    /// `move` and `scale` where they say it all, else a matrix.
    fn transform(&mut self, parent_from_local: &Affine3) -> io::Result<()> {
        let Affine3 { matrix3: Mat3 { x_axis, y_axis, z_axis }, translation } = *parent_from_local;
        let diagonal = Vec3::new(x_axis.x, y_axis.y, z_axis.z);
        if Mat3::from_diagonal(diagonal) == parent_from_local.matrix3 {
            if diagonal != Vec3::ONE {
                self.line("scale", &diagonal.to_array())?;
            }
            return if translation == Vec3::ZERO { Ok(()) } else { self.line("move", &translation.to_array()) };
        }
        // Row vectors there, column vectors here: rows are columns.
        let rows = [x_axis, y_axis, z_axis, translation].map(|row| row.to_array());
        self.line("matrix", rows.as_flattened())
    }

    fn surface(&mut self, id: SurfaceId) -> io::Result<()> {
        let surface = self.scene.surface(id);
        // A shape is a surface of its own in this language: polygons between shapes stay together.
        let is_mixed = !surface.mesh.polygons.is_empty() && !surface.primitives.is_empty();
        self.losses.mixed_surfaces += usize::from(is_mixed);
        let split = surface.primitives.iter().position(|primitive| primitive.before > 0);
        let (first, rest) = surface.primitives.split_at(split.unwrap_or(surface.primitives.len()));
        first.iter().try_for_each(|primitive| self.primitive(id, primitive))?;
        if !surface.mesh.polygons.is_empty() {
            self.mesh(id, surface)?;
        }
        rest.iter().try_for_each(|primitive| self.primitive(id, primitive))
    }

    fn mesh(&mut self, id: SurfaceId, surface: &Surface) -> io::Result<()> {
        self.open(&format!("surface {}", self.shaders.name(id)))?;
        if surface.two_sided && !self.default_two_sided {
            self.line("two_sided on", &[])?;
        }
        self.losses.colored_surfaces += usize::from(!surface.mesh.colors.is_empty());
        (0..surface.mesh.vertices.len()).try_for_each(|index| self.vertex(&surface.mesh, index))?;
        surface.mesh.polygons.iter().try_for_each(|polygon| self.polygon(&surface.mesh, polygon))?;
        self.close()
    }

    fn vertex(&mut self, mesh: &Mesh, index: usize) -> io::Result<()> {
        self.indent()?;
        write!(self.out, "v")?;
        self.numbers(&mesh.vertices[index].to_array())?;
        if let Some(normal) = mesh.normals.get(index).filter(|&&normal| normal != Vec3::ZERO) {
            write!(self.out, " n")?;
            self.numbers(&normal.to_array())?;
        }
        if let Some(texture) = mesh.texture.get(index) {
            write!(self.out, " t")?;
            self.numbers(&texture.to_array())?;
        }
        writeln!(self.out)
    }

    fn polygon(&mut self, mesh: &Mesh, polygon: &Polygon) -> io::Result<()> {
        self.losses.given_normals += usize::from(polygon.normals == NormalSource::Given);
        let keyword = if polygon.normals == NormalSource::Facet { "facet" } else { "polygon" };
        self.indent()?;
        write!(self.out, "{keyword} {{")?;
        mesh.outline(polygon).iter().try_for_each(|index| write!(self.out, " {}", index + 1))?;
        writeln!(self.out, " }}")
    }
}
