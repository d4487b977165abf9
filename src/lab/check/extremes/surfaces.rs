//! Items 69 to 80: materials and lights.

use super::super::random_scenes::world;
use super::tools::{VIEW, both_sides, draw, ensure, made, noticed, on_screen, picture, read, refused};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::color::{Encoding, Rgb};
use crate::math::Vec3;
use crate::plan::Choices;
use crate::scene::{Light, Material, Mesh, NormalSource, Place, Scene};
use crate::screen::Shader;
use crate::screen::shader::{EyeLight, SurfaceShading};

pub(super) const ITEMS: &[Item] = &[
    (69, "shininess 0: a highlight only where the light is above the surface", Run(shine_of_zero)),
    (70, "shininess 1e6: no noise of tiny numbers", Run(large_shine)),
    (71, "negative or nan coefficients: refused", Run(coefficients)),
    (72, "1,000 layers of transparency 0, 1, 1/2: exact to a level", Run(layers)),
    (73, "transparency outside 0 to 1: refused", Run(no_transparency)),
    (74, "a normal of zero: the face's own, counted", Run(zero_normal)),
    (75, "normals that cancel at a shared corner: finite", Run(cancelling)),
    (76, "a light at the corner: finite", Run(light_at_corner)),
    (77, "no lights: ambient light", Run(no_lights)),
    (78, "10,000 lights: drawn, the sum exact", Run(many_lights)),
    (79, "negative color of a light: refused", Run(|_| refused("l 1 2 3 1 -1 1", &["x.nff:1:"]))),
    (80, "Kd + Ks above 1: cut once, at the end", Run(too_bright)),
];

/// A surface lit by one white light that stands at the eye, or beyond the surface.
fn lit(specular: f64, shine: f64, (place, normal): (Vec3, Vec3), light: Vec3) -> Rgb {
    let (ambient, diffuse, opacity) = (Rgb::gray(0.125), Rgb::gray(0.5), Rgb::gray(1.0));
    let surface = SurfaceShading { ambient, diffuse, specular, shine, opacity, ..SurfaceShading::default() };
    let mut shader = Shader::default();
    shader.lights.push(EyeLight::point(light, Rgb::WHITE));
    shader.surfaces.push(surface);
    shader.light(0, place, normal)
}

fn shine_of_zero(_: &Effort) -> Outcome {
    let place = Vec3::new(0.0, 0.0, 4.0);
    let front = lit(0.25, 0.0, (place, Vec3::NEG_Z), Vec3::new(3.0, 0.0, 0.0));
    let behind = lit(0.25, 0.0, (place, Vec3::NEG_Z), Vec3::new(3.0, 0.0, 9.0));
    ensure((front.r - (0.125 + 0.5 * 0.8 + 0.25)).abs() < 1e-12 && behind.r == 0.125, format!("{front:?}, {behind:?}"))
}

fn large_shine(_: &Effort) -> Outcome {
    let at = |x: f64| lit(0.25, 1e6, (Vec3::new(x, 0.0, 4.0), Vec3::NEG_Z), Vec3::ZERO).r;
    let beside = 0.125 + 0.5 * 4.0 / (16.0_f64 + 0.04).sqrt();
    ensure(at(0.0) == 0.875, format!("{} in the middle", at(0.0)))?;
    ensure((at(0.2) - beside).abs() < 1e-12, format!("{} beside it, not {beside}", at(0.2)))
}

fn coefficients(_: &Effort) -> Outcome {
    for surface in
        ["1 -1 0 .8 0 0 0 1", "1 1 0 -.8 0 0 0 1", "1 1 0 .8 -1 0 0 1", "1 1 0 .8 0 -5 0 1", "1 1 nan .8 0 0 0 1"]
    {
        refused(format!("f {surface}"), &["x.nff:1:"])?;
    }
    Ok(())
}

fn no_transparency(_: &Effort) -> Outcome {
    refused("f 1 1 0 .8 0 0 -.5 1", &["x.nff:1:"])?;
    refused("f 1 1 0 .8 0 0 1.5 1", &["x.nff:1:"])
}

/// Layers over each other, given from the nearest, drawn in the order given or the other.
fn stack(opacities: &[f64], turned: bool) -> Result<Rgb<f32>, String> {
    let mut scene = made(&[]);
    let mut surfaces: Vec<_> = opacities
        .iter()
        .enumerate()
        .map(|(number, &opacity)| {
            let color = if number % 2 == 0 { Rgb::new(1.0, 0.25, 0.0) } else { Rgb::new(0.0, 0.5, 1.0) };
            let material = Material { color, opacity: Rgb::gray(opacity), diffuse: 1.0, ..Material::default() };
            let square = on_screen(&[(0.0, 64.0), (64.0, 64.0), (64.0, 0.0), (0.0, 0.0)], 2.0 + number as f64 / 64.0);
            super::super::random_scenes::surface(material, super::super::random_scenes::facets(&[square]))
        })
        .collect();
    if turned {
        surfaces.reverse();
    }
    scene.objects[0].surfaces = (0..surfaces.len() as u32).map(crate::scene::SurfaceId).collect();
    scene.surfaces = surfaces;
    scene.lights.clear();
    scene.background = Some(Rgb::gray(0.75));
    let choices = Choices { size: Some((4, 4)), encoding: Encoding::Linear, ..both_sides() };
    Ok(draw(&scene, &choices)?.image.pixel(1, 1))
}

fn layers(_: &Effort) -> Outcome {
    let sets: [(&str, Vec<f64>); 3] = [
        ("half", vec![0.5; 1000]),
        ("thin", vec![0.002; 1000]),
        ("mixed", (0..1000).map(|i| [0.0, 0.5, 0.01, 1.0][if i < 900 { i % 3 } else { 3 }]).collect()),
    ];
    for (name, opacities) in sets {
        let (mut light, mut passed) = (0.0, 1.0);
        for (number, opacity) in opacities.iter().enumerate() {
            light += passed * opacity * if number % 2 == 0 { 1.0 } else { 0.0 };
            passed *= 1.0 - opacity;
        }
        let expected = light + passed * 0.75;
        let (found, turned) = (stack(&opacities, false)?, stack(&opacities, true)?);
        let off = (f64::from(found.r) - expected).abs() * 255.0;
        ensure(off < 1.0, format!("{name}: {} instead of {expected}", found.r))?;
        ensure(found == turned, format!("{name}: the order of drawing changes it"))?;
    }
    Ok(())
}

fn zero_normal(_: &Effort) -> Outcome {
    let corners = "-1.6 -1.4 0 N 1.2 -1.4 0 N -0.4 1.5 0 N\n";
    let text = |statement: &str, normal: &str| {
        format!("{VIEW}l 3 4 6\nf 0.9 0.2 0.1 0.9 0 0 0 1\n{statement} 3 {}", corners.replace('N', normal))
    };
    let parsed = noticed(text("pp", "0 0 0"), "normal 0 0 0")?;
    let drawn = draw(&parsed.scene, &Choices::default())?;
    ensure(drawn.image == picture(text("p", ""))?.image, "another picture than with the face's own")
}

fn cancelling(_: &Effort) -> Outcome {
    // Front and back of one triangle over the same corners: their mean normal is nothing.
    let mut mesh = Mesh::default();
    let corners = on_screen(&[(4.0, 60.0), (60.0, 60.0), (30.0, 4.0)], 2.0);
    let [a, b, c] = [0, 1, 2].map(|i| mesh.push_vertex(world(corners[i])));
    mesh.push_polygon(&[a, b, c], NormalSource::Averaged, 1);
    mesh.push_polygon(&[a, c, b], NormalSource::Averaged, 2);
    let mut scene = made(&[]);
    scene.surfaces[0].mesh = mesh;
    for shading in [crate::plan::Shading::Gouraud, crate::plan::Shading::Phong] {
        let drawn = draw(&scene, &Choices { shading, ..Choices::default() })?;
        let background = drawn.image.pixels().iter().filter(|light| **light == Rgb::gray(0.0)).count();
        ensure(background < 64 * 64, "nothing is lit")?;
    }
    Ok(())
}

fn with_lights(lights: impl IntoIterator<Item = Vec3>) -> Scene {
    let mut scene = made(&[on_screen(&[(4.0, 60.0), (60.0, 60.0), (30.0, 4.0)], 2.0)]);
    scene.lights =
        lights.into_iter().map(|position| Light::point(world(position), Rgb::WHITE, Place::default())).collect();
    scene
}

fn light_at_corner(_: &Effort) -> Outcome {
    let corner = on_screen(&[(4.0, 60.0)], 2.0)[0];
    for shading in [crate::plan::Shading::Flat, crate::plan::Shading::Gouraud, crate::plan::Shading::Phong] {
        draw(&with_lights([corner]), &Choices { shading, ..Choices::default() })?;
    }
    Ok(())
}

fn no_lights(_: &Effort) -> Outcome {
    let drawn = draw(&with_lights([]), &Choices { encoding: Encoding::Linear, ..Choices::default() })?;
    // Kd 0.8 of a full ambient light.
    let light = drawn.image.pixel(30, 40).r;
    ensure((light - 0.8).abs() < 1e-6, format!("{light}"))
}

fn many_lights(_: &Effort) -> Outcome {
    let of = |count: usize| -> Result<f64, String> {
        let scene = with_lights(std::iter::repeat_n(Vec3::new(0.0, 0.0, -1.0), count));
        let choices =
            Choices { encoding: Encoding::Linear, light_intensity: Some(1.0 / count as f64), ..Choices::default() };
        let choices = Choices { ambient: Some(0.0), ..choices };
        let list = draw(&scene, &choices)?.list;
        Ok(list.values[0])
    };
    let (one, many) = (of(1)?, of(10_000)?);
    // Summed one by one, 10,000 lights may lose as many last digits.
    ensure((many / one - 1.0).abs() < 1e-12, format!("{many} instead of {one}"))
}

fn too_bright(_: &Effort) -> Outcome {
    let text = format!("{VIEW}l 0 0 5\nf 1 1 1 1 1 1 0 1\np 3\n-2 -2 0\n2 -2 0\n0 2 0\n");
    let scene = read(text)?.scene;
    let drawn = draw(&scene, &Choices { light_intensity: Some(1.0), ..Choices::default() })?;
    let most = drawn.list.values.iter().fold(0.0_f64, |most, &value| most.max(value));
    let brightest = drawn.image.pixels().iter().fold(0.0_f32, |most, light| most.max(light.r));
    ensure(most > 1.5 && brightest > 1.5, format!("cut before the end: {most}, {brightest}"))?;
    ensure(Encoding::Linear.level(brightest) == 255, "the level is not 255")
}
