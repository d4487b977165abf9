//! Fans of triangles by barycentric coordinates in `f64`: a sample in an odd number of triangles of the fan is in the polygon.
//! Depth and color are weighted means of corners. A program of its own: `rustc -O fans.rs`, the slip is its argument.

use std::io::{self, BufRead, Write};

#[derive(Clone, Default)]
struct Corner {
    x: f64,
    y: f64,
    over_w: f64,
    own: Vec<f64>,
}

#[derive(Default)]
struct Face {
    opacity: [f64; 3],
    corners: Vec<Corner>,
}

#[derive(Default)]
struct Sheet {
    width: usize,
    height: usize,
    background: [f64; 3],
    faces: Vec<Face>,
}

struct Fans {
    slip: String,
}

fn main() -> io::Result<()> {
    let fans = Fans { slip: std::env::args().nth(1).unwrap_or_default() };
    let (mut input, mut output) = (io::stdin().lock(), io::stdout().lock());
    while let Some(sheet) = read(&mut input)? {
        let colors = fans.draw(&sheet);
        write!(output, "P6\n{} {}\n255\n", sheet.width, sheet.height)?;
        let levels: Vec<u8> = colors.iter().flatten().map(|v| (v.clamp(0.0, 1.0) * 255.0 + 0.5) as u8).collect();
        output.write_all(&levels)?;
        output.flush()?;
    }
    Ok(())
}

fn three(numbers: &[f64]) -> [f64; 3] {
    std::array::from_fn(|n| numbers.get(n).copied().unwrap_or(0.0))
}

fn read(input: &mut impl BufRead) -> io::Result<Option<Sheet>> {
    let (mut sheet, mut line) = (Sheet::default(), String::new());
    while input.read_line(&mut line)? > 0 {
        let words: Vec<&str> = line.split_whitespace().collect();
        let number = |word: &&str| word.parse::<f64>().unwrap_or(f64::NAN);
        let numbers: Vec<f64> = words.iter().skip(1).map(number).collect();
        match (words.first().copied(), sheet.faces.last_mut()) {
            (Some("size"), _) => (sheet.width, sheet.height) = (numbers[0] as usize, numbers[1] as usize),
            (Some("background"), _) => sheet.background = three(&numbers),
            (Some("polygon"), _) => sheet.faces.push(Face { opacity: three(&numbers[3..]), corners: Vec::new() }),
            (Some("vertex"), Some(face)) => {
                let own = numbers.get(7..).unwrap_or_default().to_vec();
                face.corners.push(Corner { x: numbers[0], y: numbers[1], over_w: numbers[2], own });
            }
            (Some("end"), _) => return Ok(Some(sheet)),
            _ => {}
        }
        line.clear();
    }
    Ok(None)
}

/// Twice the area of a triangle, with its sign. Corners have few digits, so products are exact.
fn area(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> f64 {
    (b.0 - a.0) * (c.1 - a.1) - (c.0 - a.0) * (b.1 - a.1)
}

impl Fans {
    fn is(&self, slip: &str) -> bool {
        self.slip == slip
    }

    fn place(&self, corner: &Corner) -> (f64, f64) {
        if self.is("corners_rounded") {
            return (corner.x.round(), corner.y.round());
        }
        (corner.x, corner.y)
    }

    /// The three corners of each triangle of the fan.
    fn fan(&self, corners: usize) -> Vec<[usize; 3]> {
        let last = if self.is("last_triangle_lost") && corners > 3 { corners - 2 } else { corners - 1 };
        let third = |n| if self.is("strip_not_fan") { [n - 1, n, n + 1] } else { [0, n, n + 1] };
        (1..last).map(third).collect()
    }

    /// Whether a center is in a triangle; on an edge, when it is a left or a top one.
    fn is_in(&self, [a, b, c]: [(f64, f64); 3], p: (f64, f64)) -> bool {
        let all = area(a, b, c);
        if all == 0.0 || self.is("one_winding_only") && all < 0.0 {
            return false;
        }
        let (a, b, c) = if all > 0.0 { (a, b, c) } else { (a, c, b) };
        // Clockwise on the screen now: edges go right at the top, up at the left.
        [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let weight = area(from, to, p);
            if self.is("slack_of_a_hundredth") {
                return weight >= -0.01 * all.abs();
            }
            let is_top = from.1 == to.1 && to.0 > from.0 && !self.is("top_edges_outside");
            let is_left = to.1 < from.1;
            weight > 0.0 || weight == 0.0 && (is_top || is_left)
        })
    }

    /// Weights of the three corners at a point.
    fn weights(&self, face: &Face, p: (f64, f64)) -> ([usize; 3], [f64; 3]) {
        let count = face.corners.len();
        let at = |n: usize| (face.corners[n].x, face.corners[n].y);
        // The largest triangle of the fan has the fewest rounding errors.
        let size = |t: &[usize; 3]| area(at(t[0]), at(t[1]), at(t[2])).abs();
        let of = (1..count - 1).map(|n| [0, n, n + 1]).max_by(|s, t| size(s).total_cmp(&size(t))).unwrap_or([0, 1, 2]);
        let [a, b, c] = of.map(at);
        let all = area(a, b, c);
        let weights = [area(b, c, p) / all, area(c, a, p) / all, area(a, b, p) / all];
        if self.is("weights_of_the_next_corner") {
            return (of, [weights[1], weights[2], weights[0]]);
        }
        if self.is("third_weight_not_the_rest") {
            // Areas without sign.
            return (of, weights.map(f64::abs));
        }
        (of, weights)
    }

    fn depth(&self, face: &Face, p: (f64, f64)) -> f64 {
        let (of, weights) = self.weights(face, p);
        let sum: f64 = of.iter().zip(weights).map(|(&n, weight)| weight * face.corners[n].over_w).sum();
        if self.is("depth_over_w_is_w") {
            return of.iter().zip(weights).map(|(&n, weight)| weight / face.corners[n].over_w).sum();
        }
        let all = || face.corners.iter().map(|corner| corner.over_w);
        sum.clamp(all().fold(f64::MAX, f64::min), all().fold(0.0, f64::max)) as f32 as f64
    }

    fn color(&self, face: &Face, p: (f64, f64)) -> [f64; 3] {
        let (of, mut weights) = self.weights(face, p);
        if face.corners[0].own.len() < 3 {
            return [1.0; 3];
        }
        for (weight, n) in weights.iter_mut().zip(of) {
            match self.slip.as_str() {
                "linear_on_the_screen" => {}
                "weighted_by_w" => *weight /= face.corners[n].over_w,
                _ => *weight *= face.corners[n].over_w,
            }
        }
        let sum: f64 = if self.is("not_divided_by_the_sum") { 1.0 } else { weights.iter().sum() };
        std::array::from_fn(|channel| {
            let own = |n: usize| face.corners[n].own[channel];
            if self.is("mean_of_the_corners") {
                return face.corners.iter().map(|corner| corner.own[channel]).sum::<f64>() / face.corners.len() as f64;
            }
            of.iter().zip(weights).map(|(&n, weight)| weight * own(n)).sum::<f64>() / sum
        })
    }

    /// The samples of a face.
    fn covered(&self, face: &Face, sheet: &Sheet) -> Vec<(usize, usize)> {
        let places: Vec<(f64, f64)> = face.corners.iter().map(|corner| self.place(corner)).collect();
        let fan = self.fan(places.len());
        let ends = |of: fn(&(f64, f64)) -> f64, limit: usize| {
            let (low, high) = places.iter().map(of).fold((f64::MAX, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
            low.floor().max(0.0) as usize..(high.ceil() as usize + 1).min(limit)
        };
        let mut samples = Vec::new();
        for y in ends(|p| p.1, sheet.height) {
            for x in ends(|p| p.0, sheet.width) {
                let down = if self.is("half_only_across") { 0.0 } else { 0.5 };
                let p = (x as f64 + 0.5, y as f64 + down);
                let is_in = |of: &&[usize; 3]| self.is_in(of.map(|n| places[n]), p);
                let hits = fan.iter().filter(is_in).count();
                if hits % 2 == 1 || self.is("any_triangle_counts") && hits > 0 {
                    samples.push((x, y));
                }
            }
        }
        samples
    }

    fn draw(&self, sheet: &Sheet) -> Vec<[f64; 3]> {
        let mut colors = vec![sheet.background; sheet.width * sheet.height];
        let mut depths = vec![0.0; colors.len()];
        let mut panes = Vec::new();
        for (number, face) in sheet.faces.iter().enumerate() {
            for (x, y) in self.covered(face, sheet) {
                let (at, p) = (y * sheet.width + x, (x as f64 + 0.5, y as f64 + 0.5));
                let depth = self.depth(face, p);
                if face.opacity != [1.0; 3] {
                    panes.push((at, depth, number, self.color(face, p)));
                } else if depth > depths[at] || self.is("first_comes_first") && depths[at] == 0.0 {
                    if self.is("first_comes_first") && depths[at] > 0.0 {
                        continue;
                    }
                    (depths[at], colors[at]) = (depth, self.color(face, p));
                }
            }
        }
        panes.sort_by(|a, b| a.1.total_cmp(&b.1).then(b.2.cmp(&a.2)));
        for (at, depth, number, front) in panes {
            if depth > depths[at] {
                let opacity = sheet.faces[number].opacity;
                for c in 0..3 {
                    colors[at][c] = colors[at][c] * (1.0 - opacity[c]) + front[c] * opacity[c];
                }
            }
        }
        colors
    }
}
