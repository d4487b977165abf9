//! A whole little renderer: A x A samples a pixel, a z-buffer of samples, the mean at the end.

use super::Slip;
use farop::grade::Subject;
use farop::grade::subject::{Answer, Failure};
use farop::image::decode;
use farop::screen::file::Sheet;
use farop::screen::{DrawList, ScreenPolygon};

pub struct Samples {
    pub slip: Slip,
}

/// Even-odd at a point; on the outline: left and upper edges.
fn covers(polygon: &ScreenPolygon<'_>, (px, py): (f64, f64)) -> bool {
    let corners = polygon.vertices();
    let mut left_of_it = 0;
    for n in 0..corners.len() {
        let (mut a, mut b) = (&corners[n], &corners[(n + 1) % corners.len()]);
        if a.y > b.y {
            std::mem::swap(&mut a, &mut b);
        }
        if a.y <= py && py < b.y && (px - a.x) * (b.y - a.y) >= (py - a.y) * (b.x - a.x) {
            left_of_it += 1;
        }
    }
    left_of_it % 2 == 1
}

impl Samples {
    /// Where sample (x, y) is asked for, in samples.
    fn place(&self, (x, y): (i32, i32), a: i32) -> (f64, f64) {
        let middle = |s: i32| match self.slip.0.as_str() {
            "all_at_the_pixels_center" => f64::from(s / a * a) + f64::from(a) / 2.0,
            "all_at_the_pixels_corner" => f64::from(s / a * a),
            "samples_at_corners" => f64::from(s),
            "spread_over_half_a_pixel" => f64::from(s / a * a) + f64::from(a) / 4.0 + (f64::from(s % a) + 0.5) / 2.0,
            _ => f64::from(s) + 0.5,
        };
        (middle(x), middle(y))
    }

    /// Light of every sample.
    fn light(&self, list: &DrawList, sheet: &Sheet) -> (Vec<[f32; 3]>, Vec<bool>) {
        let (width, height, a) = (list.width as i32, list.height as i32, sheet.samples as i32);
        let background = sheet.background.to_array();
        let mut light = vec![background; (width * height) as usize];
        let mut depths = vec![0.0; light.len()];
        let mut is_hit = vec![false; light.len()];
        for polygon in list.polygons() {
            for y in 0..height {
                for x in 0..width {
                    let at = (y * width + x) as usize;
                    let depth = match self.slip.0.as_str() {
                        "one_depth_a_pixel" => polygon.depth(x / a * a + a / 2, y / a * a + a / 2),
                        _ => polygon.depth(x, y),
                    };
                    if !covers(&polygon, self.place((x, y), a)) || depth <= depths[at] {
                        continue;
                    }
                    depths[at] = depth;
                    is_hit[at] = true;
                    light[at] = list.shader.fragment(&polygon, x, y).color.to_array();
                }
            }
        }
        (light, is_hit)
    }

    /// Polygon by polygon, each mixed with what is there by the share of the pixel that it covers.
    fn mixed(&self, list: &DrawList, sheet: &Sheet) -> Vec<[f32; 3]> {
        let a = sheet.samples as i32;
        let (width, height) = (list.width as i32 / a, list.height as i32 / a);
        let mut pixels = vec![sheet.background.to_array(); (width * height) as usize];
        let mut depths = vec![0.0; pixels.len()];
        for polygon in list.polygons() {
            for at in 0..pixels.len() as i32 {
                let (x, y) = (at % width * a, at / width * a);
                let inside = |&(i, j): &(i32, i32)| covers(&polygon, (f64::from(x + i) + 0.5, f64::from(y + j) + 0.5));
                let own: Vec<_> = (0..a * a).map(|n| (n % a, n / a)).filter(inside).collect();
                let Some(&(i, j)) = own.first() else { continue };
                let depth = polygon.depth(x + i, y + j);
                if depth < depths[at as usize] {
                    continue;
                }
                depths[at as usize] = depth;
                let share = own.len() as f32 / (a * a) as f32;
                let color = list.shader.fragment(&polygon, x + i, y + j).color.to_array();
                let old = pixels[at as usize];
                pixels[at as usize] = [0, 1, 2].map(|c| old[c] * (1.0 - share) + color[c] * share);
            }
        }
        pixels
    }

    fn averaged(&self, list: &DrawList, sheet: &Sheet) -> Vec<[f32; 3]> {
        if self.slip.is("mixed_too_early") {
            return self.mixed(list, sheet);
        }
        let a = sheet.samples as usize;
        let (width, height) = (list.width as usize, list.height as usize);
        let (light, is_hit) = self.light(list, sheet);
        let mut pixels = Vec::new();
        for y in 0..height / a {
            for x in 0..width / a {
                let mut block: Vec<usize> = (0..a * a).map(|n| (y * a + n / a) * width + x * a + n % a).collect();
                match self.slip.0.as_str() {
                    "one_sample" => block.truncate(1),
                    "last_sample_lost" if a > 1 => {
                        block.pop();
                    }
                    "one_row_of_samples" => block.truncate(a),
                    "block_moved" => block.iter_mut().for_each(|at| *at = (*at + 1).min(light.len() - 1)),
                    "background_left_out" if block.iter().any(|&at| is_hit[at]) => block.retain(|&at| is_hit[at]),
                    _ => {}
                }
                let divisor = match self.slip.0.as_str() {
                    "sum" => 1.0,
                    "divided_by_a" => a as f32,
                    "last_sample_lost" => (a * a) as f32,
                    _ => block.len() as f32,
                };
                let level = |light: f32| match self.slip.0.as_str() {
                    "levels_before_mean" => (light * 255.0).floor() / 255.0,
                    "mean_of_squares" => light * light,
                    _ => light,
                };
                let mut mean = [0, 1, 2].map(|c| block.iter().map(|&at| level(light[at][c])).sum::<f32>() / divisor);
                if self.slip.is("mean_of_squares") {
                    mean = mean.map(f32::sqrt);
                }
                if self.slip.is("brightest_sample") {
                    mean = [0, 1, 2].map(|c| block.iter().map(|&at| light[at][c]).fold(0.0, f32::max));
                }
                if self.slip.is("half_or_nothing") {
                    let hits = block.iter().filter(|&&at| is_hit[at]).count();
                    let hit = block.iter().find(|&&at| is_hit[at] == (2 * hits >= block.len()));
                    mean = hit.map_or(mean, |&at| light[at]);
                }
                pixels.push(mean);
            }
        }
        pixels
    }
}

impl Subject for Samples {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let (width, height) = (list.width / sheet.samples, list.height / sheet.samples);
        let mut ppm = format!("P6\n{width} {height}\n255\n").into_bytes();
        for pixel in self.averaged(list, sheet) {
            ppm.extend(pixel.map(|light| (light * 255.0).round().clamp(0.0, 255.0) as u8));
        }
        let failure = |message: String| Failure { message, hint: String::new() };
        let picture = decode(&ppm).map_err(|error| failure(error.to_string()))?;
        Ok(Answer { picture, puts: None })
    }
}
