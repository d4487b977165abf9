//! Triangles by three half planes, in whole numbers; depth and color by areas of the three parts. A z-buffer.

use super::Slip;
use farop::color::Rgb;
use farop::plan::Accepts;
use farop::raster::{Rasterizer, Target};
use farop::screen::{DrawList, Fragment, ScreenPolygon};
use std::sync::{Mutex, PoisonError};

pub struct HalfPlane {
    slip: Slip,
    /// For the slip that forgets to clear.
    old_depths: Mutex<Vec<f64>>,
}

/// A corner: place in half steps of the grid, 1/w, value / w.
#[derive(Clone, Copy)]
struct Corner {
    x: i64,
    y: i64,
    inverse_w: f64,
    value: [f64; 3],
}

/// Twice the area of a, b, (x, y); positive when that runs clockwise on the screen.
fn half(a: &Corner, b: &Corner, x: i64, y: i64) -> i64 {
    (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)
}

impl HalfPlane {
    pub fn new(slip: Slip) -> HalfPlane {
        HalfPlane { slip, old_depths: Mutex::new(Vec::new()) }
    }

    fn corners(&self, polygon: &ScreenPolygon<'_>) -> Vec<Corner> {
        let step = |snapped: f64| {
            let snapped = if self.slip.is("truncated_corners") {
                snapped.trunc()
            } else if self.slip.is("rounded_corners") {
                snapped.round()
            } else {
                snapped
            };
            polygon.grid().fixed(snapped) * 2
        };
        let corner = |(number, vertex): (usize, &farop::screen::ScreenVertex)| Corner {
            x: step(vertex.x),
            y: step(vertex.y),
            inverse_w: 1.0 / vertex.homogeneous.z,
            value: [0, 1, 2].map(|channel| polygon.vertex_values(number)[channel]),
        };
        polygon.vertices().iter().enumerate().map(corner).collect()
    }

    /// Whether a value of an edge function is on the polygon's side.
    fn is_in(&self, value: i64, a: &Corner, b: &Corner) -> bool {
        if self.slip.is("ties_to_all") {
            return value >= 0;
        }
        if self.slip.is("ties_to_none") {
            return value > 0;
        }
        let (mut top, mut left) = (a.y == b.y && b.x > a.x, b.y < a.y);
        if self.slip.is("bottom_right") {
            (top, left) = (a.y == b.y && b.x < a.x, b.y > a.y);
        }
        if self.slip.is("left_only") {
            top = false;
        }
        if self.slip.is("top_forgets_bottom") {
            top = a.y == b.y;
        }
        if self.slip.is("left_sign") {
            left = b.y > a.y;
        }
        value > 0 || (value == 0 && (top || left))
    }

    fn depth(&self, corners: &[Corner], [_, second, third]: [f64; 3]) -> f64 {
        let d: Vec<f64> = corners.iter().map(|corner| corner.inverse_w).collect();
        if self.slip.is("depth_of_first_corner") {
            return d[0];
        }
        if self.slip.is("depth_of_nearest_corner") {
            return d[0].max(d[1]).max(d[2]);
        }
        if self.slip.is("mean_depth") {
            return (d[0] + d[1] + d[2]) / 3.0;
        }
        if self.slip.is("w_on_the_screen") {
            let w = 1.0 / d[0] + second * (1.0 / d[1] - 1.0 / d[0]) + third * (1.0 / d[2] - 1.0 / d[0]);
            return f64::from((1.0 / w) as f32);
        }
        let depth = f64::from((d[0] + second * (d[1] - d[0]) + third * (d[2] - d[0])) as f32);
        if self.slip.is("depth_in_a_byte") { (depth * 255.0).floor() / 255.0 } else { depth }
    }

    fn color(&self, corners: &[Corner], [first, second, third]: [f64; 3], depth: f64) -> Rgb<f32> {
        let flat = |value: [f64; 3]| Rgb::new(value[0] as f32, value[1] as f32, value[2] as f32);
        if self.slip.is("color_of_first_corner") {
            return flat(corners[0].value);
        }
        if self.slip.is("mean_color") {
            return flat([0, 1, 2].map(|c| corners.iter().map(|corner| corner.value[c]).sum::<f64>() / 3.0));
        }
        let (mut second, mut third) = (second, third);
        if self.slip.is("weights_exchanged") {
            (second, third) = (third, second);
        }
        if self.slip.is("weights_turned") {
            (second, third) = (first, second);
        }
        let spread = |channel: usize| {
            let v = [0, 1, 2].map(|n| corners[n].value[channel]);
            let affine = v[0] + second * (v[1] - v[0]) + third * (v[2] - v[0]);
            if self.slip.is("affine") || v[0] == v[1] && v[0] == v[2] && !self.slip.is("not_times_w") {
                return affine;
            }
            let o = [0, 1, 2].map(|n| corners[n].value[channel] * corners[n].inverse_w);
            let over_w = o[0] + second * (o[1] - o[0]) + third * (o[2] - o[0]);
            if self.slip.is("not_times_w") {
                return over_w;
            }
            if self.slip.is("divided_twice") {
                return over_w / depth / depth;
            }
            over_w / depth
        };
        let mut color = [0, 1, 2].map(spread);
        if self.slip.is("bgr") {
            color.swap(0, 2);
        }
        if self.slip.is("truncated_levels") {
            color = color.map(|light| (light * 255.0).floor() / 255.0);
        }
        if self.slip.is("levels_of_256") {
            color = color.map(|light| (light * 256.0).floor() / 255.0);
        }
        if self.slip.is("gamma") {
            color = color.map(|light| light.powf(1.0 / 2.2));
        }
        if self.slip.is("wraps") {
            color = color.map(|light| f64::from((light * 256.0 + 0.5) as i64 as u8) / 255.0);
        }
        if self.slip.is("gray") {
            color = [(color[0] + color[1] + color[2]) / 3.0; 3];
        }
        flat(color)
    }

    fn triangle(&self, polygon: &ScreenPolygon<'_>, list: &DrawList, target: &mut Target<'_>, depths: &mut [f64]) {
        let mut corners = self.corners(polygon);
        let mut area = half(&corners[0], &corners[1], corners[2].x, corners[2].y);
        if area < 0 && !self.slip.is("one_winding") {
            corners.swap(1, 2);
            area = -area;
        }
        let scale = polygon.grid().steps();
        if area <= 0 || (self.slip.is("small_left_out") && area < 4 * scale * scale) {
            return;
        }
        let width = target.width();
        let reach = |of: fn(&Corner) -> i64| {
            let of = |n: usize| of(&corners[n]);
            let (low, high) = (of(0).min(of(1)).min(of(2)), of(0).max(of(1)).max(of(2)));
            ((low / (2 * scale)) as i32, (high / (2 * scale)) as i32)
        };
        let ((mut left, mut right), (mut top, mut bottom)) = (reach(|c| c.x), reach(|c| c.y));
        if self.slip.is("whole_screen") {
            (left, right, top, bottom) = (0, width, 0, target.height());
        }
        if self.slip.is("box_ends_early") {
            right -= 1;
        }
        if self.slip.is("box_starts_late") {
            left += 1;
        }
        if self.slip.is("last_row_lost") {
            bottom = bottom.min(target.height() - 2);
        }
        if self.slip.is("border_left_out") {
            (left, top) = (left.max(1), top.max(1));
            (right, bottom) = (right.min(width - 2), bottom.min(target.height() - 2));
        }
        for y in top..=bottom.min(target.height() - 1) {
            for x in left..=right.min(width - 1) {
                let center = if self.slip.is("corner_sample") {
                    0
                } else if self.slip.is("far_corner_sample") {
                    2 * scale
                } else {
                    scale
                };
                let (px, py) = (i64::from(x) * 2 * scale + center, i64::from(y) * 2 * scale + center);
                let parts = [(1, 2), (2, 0), (0, 1)].map(|(a, b)| (half(&corners[a], &corners[b], px, py), a, b));
                if !parts.iter().all(|&(value, a, b)| self.is_in(value, &corners[a], &corners[b])) {
                    continue;
                }
                let weights = parts.map(|(value, _, _)| value as f64 / area as f64);
                let depth = self.depth(&corners, weights);
                let (mut at_x, mut at_y) = (x, y);
                if self.slip.is("y_up") {
                    at_y = target.height() - 1 - y;
                }
                if self.slip.is("mirrored") {
                    at_x = width - 1 - x;
                }
                if self.slip.is("x_and_y_exchanged") {
                    (at_x, at_y) = (y, x);
                }
                if self.slip.is("one_to_the_right") {
                    at_x += 1;
                }
                let index = (at_y * width + at_x) as usize;
                let old = if self.slip.is("depth_not_cleared") { depths[index] } else { target.depth(at_x, at_y) };
                let shown = match self.slip.0.as_str() {
                    "far_wins" => old == 0.0 || depth < old,
                    "no_depth_test" => true,
                    "first_stays" => old == 0.0,
                    "last_of_equals" => depth >= old,
                    "bias" => depth > old + 0.05,
                    "cleared_to_one" => depth < 1.0 && depth > old,
                    _ => depth > old,
                };
                if !shown {
                    continue;
                }
                if let Some(kept) = depths.get_mut(index) {
                    *kept = depth;
                }
                let opacity =
                    if self.slip.is("glass_is_opaque") { Rgb::gray(1.0) } else { list.shader.opacity(polygon) };
                let color = self.color(&corners, weights, depth);
                let kept = if self.slip.is("depth_not_written") { 0.0 } else { depth };
                target.put(Fragment { x: at_x, y: at_y, depth: kept, color, opacity, polygon: polygon.index });
            }
        }
    }
}

impl Rasterizer for HalfPlane {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        let mut depths = self.old_depths.lock().unwrap_or_else(PoisonError::into_inner);
        let samples = (target.width() * target.height()) as usize;
        if !self.slip.is("depth_not_cleared") || depths.len() != samples {
            *depths = vec![0.0; samples];
        }
        let mut polygons: Vec<_> = list.polygons().collect();
        if self.slip.is("last_polygon_lost") {
            polygons.pop();
        }
        if self.slip.is("first_polygon_lost") {
            polygons.remove(0);
        }
        if self.slip.is("last_to_first") {
            polygons.reverse();
        }
        for polygon in &polygons {
            self.triangle(polygon, list, target, &mut depths);
        }
    }

    fn accepts(&self) -> Accepts {
        Accepts::Triangles
    }
}
