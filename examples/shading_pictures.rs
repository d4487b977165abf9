//! Draws the pictures of docs/shading.md that show SIPP's lights and models: `cargo run --release --example shading_pictures [FOLDER]`.
//!
//! The scenes are built here, without a file: this is also an example of how to build one.

use farop::color::Rgb;
use farop::image::encode_for;
use farop::math::{Affine3, Vec3};
use farop::plan::{Choices, Shading};
use farop::raster::ZBuffer;
use farop::render::render;
use farop::scene::{
    Camera, Light, LightSource, Material, Mesh, NormalSource, Object, ObjectId, Place, Primitive, Reflection, Scene,
    Shape, SpotEdge, Surface, SurfaceId,
};
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| "docs/images".to_string());
    let place = |name: &str| Path::new(&folder).join(format!("shading_{name}.png"));

    // One bright light and three models; then four highlights of `basic`.
    let sun = LightSource::Directional { to_light: Vec3::new(-3.0, -5.0, 4.0) };
    let basic = |c3| Reflection::Basic { c3 };
    let models = [Reflection::Nff, Reflection::Phong, basic(0.3)];
    write(&row_of_balls(&models, light(sun, 2.5)), (240, 80), place("models"))?;
    let widths = [basic(0.05), basic(0.15), basic(0.4), basic(1.0)];
    write(&row_of_balls(&widths, light(sun, 1.0)), (256, 64), place("c3"))?;

    // A ball on a floor under each kind of light.
    let position = Vec3::new(-3.0, -2.0, 6.0);
    let spot = |edge| LightSource::Spot { position, at: Vec3::ZERO, opening: 35.0, edge };
    let kinds = [
        ("point", LightSource::Point { position }),
        ("directional", LightSource::Directional { to_light: position }),
        ("spot_sharp", spot(SpotEdge::Sharp)),
        ("spot_soft", spot(SpotEdge::Soft)),
    ];
    for (name, source) in kinds {
        write(&ball_on_a_floor(light(source, 1.0)), (128, 128), place(name))?;
    }
    Ok(())
}

/// Draws `scene`, light at every sample, and writes the picture.
fn write(scene: &Scene, size: (u32, u32), path: PathBuf) -> Result<(), Box<dyn Error>> {
    let choices = Choices { size: Some(size), shading: Shading::Phong, samples: 4, ..Choices::default() };
    let picture = render(scene, &choices, Some(&ZBuffer))?.image.encode(choices.encoding);
    std::fs::write(&path, encode_for(&path, &picture)?)?;
    println!("{}", path.display());
    Ok(())
}

fn light(source: LightSource, intensity: f64) -> Light {
    Light { source, color: Rgb::WHITE, intensity: Some(intensity), place: Place::default() }
}

fn material(reflection: Reflection, color: Rgb) -> Material {
    let (ambient, diffuse, specular, shine) = (Some(0.1), 0.8, 0.5, 20.0);
    Material { reflection, color, ambient, diffuse, specular, shine, ..Material::default() }
}

fn surface(material: Material, mesh: Mesh, shapes: &[Shape]) -> Surface {
    let primitives = shapes.iter().map(|shape| Primitive::new(shape.clone(), 0, 0)).collect();
    Surface { material, mesh, primitives, two_sided: false, place: Place::default() }
}

/// Balls of radius 0.45 side by side, one a model.
fn row_of_balls(models: &[Reflection], light: Light) -> Scene {
    let middle = (models.len() as f64 - 1.0) / 2.0;
    let ball = |(index, &model): (usize, &Reflection)| {
        let center = Vec3::new(index as f64 - middle, 0.0, 0.0);
        surface(material(model, Rgb::new(0.9, 0.45, 0.2)), Mesh::default(), &[Shape::Sphere { center, radius: 0.45 }])
    };
    let surfaces = models.iter().enumerate().map(ball).collect();
    scene(surfaces, light, (Vec3::new(0.0, -20.0, 0.0), Vec3::ZERO, 2.9))
}

fn ball_on_a_floor(light: Light) -> Scene {
    let mut floor = Mesh::default();
    let corners = [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)];
    let outline = corners.map(|(x, y)| floor.push_vertex(Vec3::new(x, y, 0.0)));
    floor.push_polygon(&outline, NormalSource::Facet, 0);
    let ball = Shape::Sphere { center: Vec3::new(0.3, 0.3, 0.8), radius: 0.8 };
    let (gray, orange) = (Rgb::new(0.75, 0.8, 0.85), Rgb::new(0.9, 0.45, 0.2));
    let surfaces = vec![
        surface(material(Reflection::Phong, gray), floor, &[]),
        surface(material(Reflection::Basic { c3: 0.2 }, orange), Mesh::default(), &[ball]),
    ];
    scene(surfaces, light, (Vec3::new(1.5, -8.0, 5.0), Vec3::new(0.0, 0.0, 0.3), 40.0))
}

/// One object of `surfaces`, seen from a point, towards a point, with an opening angle.
fn scene(surfaces: Vec<Surface>, light: Light, (from, at, angle): (Vec3, Vec3, f64)) -> Scene {
    let object = Object {
        name: "all".to_string(),
        parent_from_local: Affine3::IDENTITY,
        surfaces: (0..surfaces.len() as u32).map(SurfaceId).collect(),
        children: Vec::new(),
        place: Place::default(),
    };
    let (resolution, place) = ((256, 256), Place::default());
    Scene {
        objects: vec![object],
        surfaces,
        world: vec![ObjectId(0)],
        lights: vec![light],
        camera: Some(Camera { from, at, up: Vec3::Z, angle, hither: 0.1, yon: None, resolution, place }),
        background: Some(Rgb::new(0.08, 0.1, 0.15)),
        ..Scene::default()
    }
}
