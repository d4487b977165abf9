//! `--dump-stage`: the values between the stages, as text.

use super::error::CliError;
use super::lighting::{light_words, surface_words};
use crate::geometry::{self, Trace};
use crate::plan::{Accepts, Choices, Plan};
use crate::raster::Rasterizer;
use crate::scene::Scene;
use crate::screen::{DrawList, Source};
use std::fmt::Write;

/// A stage whose values can be printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum StageName {
    /// What was read.
    Scene,
    /// What is needed and chosen.
    Plan,
    /// Polygons in eye space, as culling sees them.
    Eye,
    /// What clipping left.
    Clip,
    /// Polygons on the screen.
    Screen,
}

impl std::str::FromStr for StageName {
    type Err = String;
    fn from_str(name: &str) -> Result<StageName, String> {
        match name {
            "scene" => Ok(StageName::Scene),
            "plan" => Ok(StageName::Plan),
            "eye" => Ok(StageName::Eye),
            "clip" => Ok(StageName::Clip),
            "screen" => Ok(StageName::Screen),
            _ => Err("there is scene, plan, eye, clip, screen".to_string()),
        }
    }
}

impl StageName {
    /// The values of this stage for `scene`, one a line.
    pub fn text(
        self,
        scene: &Scene,
        choices: &Choices,
        rasterizer: Option<&dyn Rasterizer>,
    ) -> Result<String, CliError> {
        let accepts = rasterizer.map_or(Accepts::AnyPolygon, Rasterizer::accepts);
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = match self {
            StageName::Scene => scene_text(scene, &mut text),
            StageName::Plan => write!(text, "{}", super::plan::text(&Plan::new(scene, choices, accepts)?)),
            StageName::Eye | StageName::Clip | StageName::Screen => {
                let plan = Plan::new(scene, choices, accepts)?;
                let (mut list, mut trace) = (DrawList::new(0, 0), Trace::default());
                let _ = geometry::run_traced(scene, &plan, &mut list, &mut trace);
                if list.unit != 1.0 {
                    let _ = writeln!(text, "unit of eye space: {} scene units", list.unit);
                }
                match self {
                    StageName::Eye => eye_text(&trace, &mut text),
                    StageName::Clip => clip_text(&trace, &mut text),
                    _ => screen_text(&list, &mut text),
                }
            }
        };
        Ok(text)
    }
}

fn scene_text(scene: &Scene, text: &mut String) -> std::fmt::Result {
    if let Some(camera) = &scene.camera {
        writeln!(
            text,
            "camera from {} at {} up {} angle {} hither {}",
            camera.from, camera.at, camera.up, camera.angle, camera.hither
        )?;
    }
    for light in &scene.lights {
        let (position, color) = (light.source.position(), light.color.to_array());
        writeln!(text, "light {position} color {color:?}{}", light_words(light))?;
    }
    let mut depths = vec![0usize; scene.objects.len()];
    let mut result = Ok(());
    let walked = scene.walk(|placed| {
        let depth = depths[placed.id.0 as usize];
        placed.object.children.iter().for_each(|child| depths[child.0 as usize] = depth + 1);
        result = result.and(object_text(scene, placed.object, depth, text));
    });
    if let Err(error) = walked {
        writeln!(text, "{error}")?;
    }
    result
}

fn object_text(scene: &Scene, object: &crate::scene::Object, depth: usize, text: &mut String) -> std::fmt::Result {
    let indent = "  ".repeat(depth.min(40));
    writeln!(text, "{indent}object {} ({})", object.name, scene.describe(object.place))?;
    for &id in &object.surfaces {
        let surface = scene.surface(id);
        let (mesh, material) = (&surface.mesh, &surface.material);
        writeln!(
            text,
            "{indent}  surface color {:?} Kd {} Ks {} shine {}: {} polygons, {} vertices, {} shapes{}",
            material.color.to_array(),
            material.diffuse,
            material.specular,
            material.shine,
            mesh.polygons.len(),
            mesh.vertices.len(),
            surface.primitives.len(),
            surface_words(surface)
        )?;
    }
    Ok(())
}

fn name(source: Source) -> String {
    let kind = if source.tessellated { "piece" } else { "polygon" };
    format!("{kind} {} of line {}", source.number, source.line)
}

fn eye_text(trace: &Trace, text: &mut String) -> std::fmt::Result {
    for polygon in &trace.eye {
        writeln!(text, "{}: {:?}", name(polygon.source), polygon.facing)?;
        for corner in &polygon.corners {
            writeln!(text, "  {} {} {}", corner.x, corner.y, corner.z)?;
        }
    }
    Ok(())
}

fn clip_text(trace: &Trace, text: &mut String) -> std::fmt::Result {
    for polygon in &trace.clipped {
        writeln!(text, "{}", name(polygon.source))?;
        for vertex in &polygon.vertices {
            let [a, b, c, ..] = vertex.attributes;
            let position = vertex.position;
            writeln!(
                text,
                "  x {} y {} w {}, varies {a} {b} {c}, edge {:?}",
                position.x, position.y, position.z, vertex.edge
            )?;
        }
    }
    Ok(())
}

fn screen_text(list: &DrawList, text: &mut String) -> std::fmt::Result {
    for polygon in list.polygons() {
        writeln!(text, "{}: {}, surface {}", polygon.index, name(polygon.record().source), polygon.surface())?;
        if let Some(plane) = polygon.depth_plane() {
            writeln!(text, "  1/w = {} x + {} y + {}, {:?}", plane.a, plane.b, plane.c, plane.evaluation)?;
        }
        for (corner, vertex) in polygon.vertices().iter().enumerate() {
            let (values, w) = (polygon.vertex_values(corner), vertex.homogeneous.z);
            writeln!(text, "  x {} y {} w {w}, varies {values:?}, edge {:?}", vertex.x, vertex.y, vertex.edge)?;
        }
    }
    Ok(())
}
