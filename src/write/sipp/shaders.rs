//! Materials as shaders with names: one for all surfaces of equal material.

use super::losses::Losses;
use super::sharing::{Sharing, sayable as sayable_text};
use crate::color::Rgb;
use crate::image::textures::Wrap;
use crate::scene::{Material, Reflection, Scene, SurfaceId, Texture};
use crate::write::number::write_number;
use std::collections::HashMap;
use std::io::{self, Write};

/// Which shader each surface has.
pub(super) struct Shaders {
    /// For each surface of the scene an index into `list`; `None` where nothing shows it.
    of_surface: Vec<Option<u32>>,
    list: Vec<Shader>,
}

struct Shader {
    /// `phong3`: the model and a number.
    name: String,
    material: Material,
    /// The words for its picture; empty without one.
    texture: String,
}

impl Shaders {
    /// Collects the materials of what is written, in that order.
    pub fn of(scene: &Scene, sharing: &Sharing, losses: &mut Losses) -> Shaders {
        let mut shaders = Shaders { of_surface: vec![None; scene.surfaces.len()], list: Vec::new() };
        let mut known: HashMap<([u64; 12], u64), u32> = HashMap::new();
        for id in sharing.surfaces() {
            let surface = scene.surface(id);
            if surface.mesh.polygons.is_empty() && surface.primitives.is_empty() {
                continue;
            }
            let material = sayable(&surface.material, scene, losses);
            let texture = scene.picture_on(surface).map_or(u64::MAX, |(id, _)| u64::from(id.0));
            let index = *known.entry((bits(&material), texture)).or_insert(shaders.list.len() as u32);
            if index as usize == shaders.list.len() {
                let model = if material.reflection == Reflection::Phong { "phong" } else { "basic" };
                let texture = scene.picture_on(surface).map(|(_, texture)| texture_words(texture)).unwrap_or_default();
                losses.pictures += usize::from(!texture.is_empty());
                let worn = scene.picture_on(surface);
                losses.fades += usize::from(
                    worn.is_some_and(|(_, it)| it.fade.is_some() || it.mosaic.is_some() || it.lookup.is_some()),
                );
                shaders.list.push(Shader { name: format!("{model}{}", index + 1), material, texture });
            }
            shaders.of_surface[id.0 as usize] = Some(index);
        }
        shaders
    }

    /// The name of the shader of a surface that shows something.
    pub fn name(&self, id: SurfaceId) -> &str {
        self.of_surface[id.0 as usize].map_or("", |index| &self.list[index as usize].name)
    }

    /// Writes all of them.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        if !self.list.is_empty() {
            writeln!(out)?;
        }
        self.list.iter().try_for_each(|shader| shader.write(out))
    }
}

impl Shader {
    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let Material { reflection, color, ambient, diffuse, specular, shine, opacity, .. } = self.material;
        let one = |word: &'static str, number: f64| (word, vec![number]);
        let mut parameters = vec![one("ambient", ambient.unwrap_or_default())];
        match reflection {
            Reflection::Basic { c3 } => parameters.extend([one("specular", specular), one("c3", c3)]),
            Reflection::Phong | Reflection::Nff => {
                parameters.extend([one("diffuse", diffuse), one("specular", specular), one("exponent", shine)]);
            }
        }
        parameters.push(("color", color.to_array().to_vec()));
        if opacity == Rgb::gray(opacity.r) {
            parameters.extend((opacity != Rgb::WHITE).then(|| one("opacity", opacity.r)));
        } else {
            parameters.push(("opacity", opacity.to_array().to_vec()));
        }
        let model = if matches!(reflection, Reflection::Basic { .. }) { "basic" } else { "phong" };
        write!(out, "shader {} {model} {{", self.name)?;
        for (word, numbers) in parameters {
            write!(out, " {word}")?;
            numbers.iter().try_for_each(|&number| write_number(out, number))?;
        }
        writeln!(out, "{} }}", self.texture)
    }
}

/// What a shader says about its picture.
fn texture_words(texture: &Texture) -> String {
    let mut words = format!(" texture \"{}\"", sayable_text(&texture.name));
    words.extend(texture.cut_out.map(|cut_out| format!(" cutout {}", cut_out.threshold)));
    if let Some(key) = texture.key {
        words += " key";
        words.extend(key.map(|level| format!(" {}", f64::from(level) / 255.0)));
    }
    // As the reader assumes where nothing is said.
    let assumed = if texture.cut_out.is_some() { Wrap::Clamp } else { Wrap::Repeat };
    if texture.wrap != assumed {
        words += if texture.wrap == Wrap::Clamp { " wrap clamp" } else { " wrap repeat" };
    }
    words
}

/// The nearest material that a shader can say.
fn sayable(material: &Material, scene: &Scene, losses: &mut Losses) -> Material {
    let is_nff = material.reflection == Reflection::Nff;
    losses.nff_surfaces += usize::from(is_nff);
    losses.no_ambient += usize::from(!is_nff && material.ambient.is_none());
    let reflection = if is_nff { Reflection::Phong } else { material.reflection };
    // Without a coefficient of its own a surface reflects the ambient light as it does diffuse light.
    let ambient = material.ambient.unwrap_or(scene.suggested_intensity() * material.diffuse);
    Material { reflection, ambient: Some(ambient), ..*material }
}

/// What of a material the file says, as bits. Both zeros are one.
fn bits(material: &Material) -> [u64; 12] {
    let Material { color, opacity, ambient, diffuse, specular, shine, .. } = *material;
    let ([r, g, b], [red, green, blue]) = (color.to_array(), opacity.to_array());
    let ambient = ambient.unwrap_or_default();
    // `basic` says neither `diffuse` nor `exponent`.
    let own = match material.reflection {
        Reflection::Basic { c3 } => [1.0, c3, 0.0, 0.0],
        Reflection::Phong | Reflection::Nff => [0.0, 0.0, diffuse, shine],
    };
    let [kind, c3, diffuse, shine] = own;
    let all = [kind, c3, diffuse, shine, ambient, specular, r, g, b, red, green, blue];
    all.map(|number| (number + 0.0).to_bits())
}
