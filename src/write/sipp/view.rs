//! Picture size, camera, background and lights.

use super::Printer;
use crate::scene::{Camera, Light, LightSource, SpotEdge};
use std::io;

impl Printer<'_> {
    /// Everything that is not an object.
    pub(super) fn view(&mut self) -> io::Result<()> {
        match &self.scene.camera {
            Some(camera) => self.camera(camera)?,
            None => self.losses.no_camera = true,
        }
        if let Some(background) = self.scene.background {
            self.line("background", &background.to_array())?;
        }
        self.scene.lights.iter().try_for_each(|light| self.light(light))
    }

    fn camera(&mut self, camera: &Camera) -> io::Result<()> {
        let (width, height) = camera.resolution;
        writeln!(self.out, "image {width} {height}")?;
        self.open("camera")?;
        self.line("from", &camera.from.to_array())?;
        self.line("at", &camera.at.to_array())?;
        self.line("up", &camera.up.to_array())?;
        self.line("angle", &[camera.angle])?;
        self.line("hither", &[camera.hither])?;
        if let Some(yon) = camera.yon {
            self.line("yon", &[yon])?;
        }
        self.close()
    }

    fn light(&mut self, light: &Light) -> io::Result<()> {
        let intensity = light.intensity.unwrap_or(self.scene.suggested_intensity());
        self.losses.light_intensities += usize::from(light.intensity != Some(1.0));
        let kind = match light.source {
            LightSource::Point { .. } => "point",
            LightSource::Directional { .. } => "directional",
            LightSource::Spot { .. } => "spot",
        };
        write!(self.out, "light {kind} {{")?;
        match light.source {
            LightSource::Point { position } => self.parameter("at", &position.to_array())?,
            LightSource::Directional { to_light } => self.parameter("to", &to_light.to_array())?,
            LightSource::Spot { position, at, opening, edge } => {
                self.parameter("from", &position.to_array())?;
                self.parameter("at", &at.to_array())?;
                self.parameter("opening", &[opening])?;
                self.parameter(if edge == SpotEdge::Soft { "edge soft" } else { "edge sharp" }, &[])?;
            }
        }
        self.parameter("color", &(light.color * intensity).to_array())?;
        writeln!(self.out, " }}")
    }

    /// A parameter on the line in hand.
    pub(super) fn parameter(&mut self, words: &str, numbers: &[f64]) -> io::Result<()> {
        write!(self.out, " {words}")?;
        self.numbers(numbers)
    }
}
