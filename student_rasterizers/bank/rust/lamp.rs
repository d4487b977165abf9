//! Phong's light at every sample; coverage by counting crossings left of the center, sample by sample. A z-buffer.

use super::Slip;
use farop::color::Rgb;
use farop::math::Vec3;
use farop::raster::{PolygonRasterizer, Target};
use farop::screen::shader::EyeSource;
use farop::screen::{Fragment, ScreenPolygon, Shader};

pub struct Lamp {
    pub slip: Slip,
}

fn is_covered(polygon: &ScreenPolygon<'_>, x: i32, y: i32) -> bool {
    let (px, py) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let corners = polygon.vertices();
    let mut inside = false;
    for (n, a) in corners.iter().enumerate() {
        let b = &corners[(n + 1) % corners.len()];
        if (a.y <= py) != (b.y <= py) {
            let side = (b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y);
            if (b.y > a.y && side <= 0.0) || (b.y < a.y && side >= 0.0) {
                inside = !inside;
            }
        }
    }
    inside
}

/// How much the first three corners count at the center of a sample, on the screen.
fn weights(polygon: &ScreenPolygon<'_>, x: i32, y: i32) -> [f64; 3] {
    let c = polygon.vertices();
    let (px, py) = (f64::from(x) + 0.5 - c[0].x, f64::from(y) + 0.5 - c[0].y);
    let (ux, uy, vx, vy) = (c[1].x - c[0].x, c[1].y - c[0].y, c[2].x - c[0].x, c[2].y - c[0].y);
    let area = ux * vy - uy * vx;
    let (second, third) = ((px * vy - py * vx) / area, (ux * py - uy * px) / area);
    [1.0 - second - third, second, third]
}

fn vector(numbers: &[f64]) -> Vec3 {
    Vec3::new(numbers[0], numbers[1], numbers[2])
}

impl Lamp {
    fn light(&self, shader: &Shader, surface: usize, normal: Vec3, eye: Vec3) -> Vec3 {
        let surface = &shader.surfaces[surface];
        let color = |rgb: Rgb| Vec3::new(rgb.r, rgb.g, rgb.b);
        let n = if self.slip.is("normal_not_unit") { normal } else { normal / normal.length() };
        let mut sum = if self.slip.is("no_ambient") { Vec3::ZERO } else { color(surface.ambient) };
        for lamp in &shader.lights {
            let EyeSource::Point { position } = lamp.source else { continue };
            let mut to_lamp = position - eye;
            if self.slip.is("lamp_vector_reversed") {
                to_lamp = -to_lamp;
            }
            if self.slip.is("lamp_is_a_direction") {
                to_lamp = position;
            }
            let l = if self.slip.is("lamp_vector_not_unit") { to_lamp } else { to_lamp / to_lamp.length() };
            let mut v = -eye / eye.length();
            if self.slip.is("view_is_fixed") {
                v = Vec3::new(0.0, 0.0, -1.0);
            }
            if self.slip.is("view_reversed") {
                v = -v;
            }
            let mut cosine = n.dot(l);
            if self.slip.is("absolute_cosine") {
                cosine = cosine.abs();
            }
            if self.slip.is("half_lambert") {
                cosine = cosine * 0.5 + 0.5;
            }
            let gated = !self.slip.is("highlight_on_the_night_side");
            let can_be_dark = self.slip.is("negative_light");
            if cosine <= 0.0 && gated && !can_be_dark {
                continue;
            }
            let diffuse = if can_be_dark { cosine } else { cosine.max(0.0) };
            if !self.slip.is("no_diffuse") {
                sum += color(surface.diffuse) * color(lamp.color) * diffuse;
            }
            let r = match self.slip.0.as_str() {
                "mirrored_wrongly" => l - n * (2.0 * n.dot(l)),
                "mirror_without_two" => n * n.dot(l) - l,
                _ => n * (2.0 * n.dot(l)) - l,
            };
            let mut shine = r.dot(v).max(0.0);
            if self.slip.is("half_vector") {
                let h = l + v;
                shine = n.dot(h / h.length()).max(0.0);
            }
            let power = if self.slip.is("power_forgotten") { 1.0 } else { surface.shine };
            if !(self.slip.is("no_highlight") || can_be_dark && cosine <= 0.0) {
                let tint = if self.slip.is("highlight_tinted") { color(surface.diffuse) } else { Vec3::ONE };
                sum += color(lamp.color) * tint * surface.specular * shine.powf(power);
            }
            if self.slip.is("first_lamp_only") {
                break;
            }
        }
        sum
    }

    fn shade(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, (x, y): (i32, i32)) -> Vec3 {
        let surface = polygon.surface() as usize;
        let values = polygon.values(x, y);
        let (mut normal, mut eye) = (vector(&values), vector(&values[3..]));
        let at_corner = |n: usize| (vector(polygon.vertex_values(n)), vector(&polygon.vertex_values(n)[3..]));
        let part = weights(polygon, x, y);
        let sum = |of: &dyn Fn(usize) -> Vec3| of(0) * part[0] + of(1) * part[1] + of(2) * part[2];
        match self.slip.0.as_str() {
            "gouraud" => {
                let w = |n: usize| 1.0 / polygon.vertices()[n].homogeneous.z;
                let lit = |n: usize| self.light(shader, surface, at_corner(n).0, at_corner(n).1) * w(n);
                return sum(&lit) / (part[0] * w(0) + part[1] * w(1) + part[2] * w(2));
            }
            "flat" => {
                let (normal, eye) = at_corner(0);
                return self.light(shader, surface, normal, eye);
            }
            "normal_of_first_corner" => normal = at_corner(0).0,
            "mean_normal" => normal = at_corner(0).0 + at_corner(1).0 + at_corner(2).0,
            "normals_on_the_screen" => normal = sum(&|n| at_corner(n).0),
            "normal_reversed" => normal = -normal,
            "eye_point_of_first_corner" => eye = at_corner(0).1,
            _ => {}
        }
        self.light(shader, surface, normal, eye)
    }
}

impl PolygonRasterizer for Lamp {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let rows = polygon.vertices().iter().map(|corner| corner.y as i32);
        let (top, bottom) = (rows.clone().min().unwrap_or(0), rows.max().unwrap_or(0));
        let columns = polygon.vertices().iter().map(|corner| corner.x as i32);
        let (left, right) = (columns.clone().min().unwrap_or(0), columns.max().unwrap_or(0));
        for y in top..=bottom.min(target.height() - 1) {
            for x in left..=right.min(target.width() - 1) {
                if !is_covered(polygon, x, y) || polygon.depth(x, y) <= target.depth(x, y) {
                    continue;
                }
                let fragment = shader.fragment(polygon, x, y);
                if polygon.values(x, y).len() < 6 {
                    target.put(fragment);
                    continue;
                }
                let mut light = self.shade(polygon, shader, (x, y));
                if self.slip.is("wraps_above_one") {
                    light = light.map(|channel| (channel * 255.0).round().rem_euclid(256.0) / 255.0);
                }
                if self.slip.is("halved") {
                    light *= 0.5;
                }
                let color = Rgb::new(light.x as f32, light.y as f32, light.z as f32);
                target.put(Fragment { color, ..fragment });
            }
        }
    }
}
