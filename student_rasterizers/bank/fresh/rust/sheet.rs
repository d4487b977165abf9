//! Screen files in, P6 pictures out, for the Rust programs of the fresh set. The slip is the program's argument.
#![allow(dead_code)]

use std::io::{BufRead, Write};

/// A plane over the picture, and how it is evaluated.
#[derive(Clone, Default)]
pub struct Plane {
    pub a: f64,
    pub b: f64,
    pub c: f64,
    pub low: f64,
    pub high: f64,
    pub rule: String,
}

/// A corner: where, 1/w, w, whether clipping made its edge, and what varies.
#[derive(Clone, Default)]
pub struct Corner {
    pub x: f64,
    pub y: f64,
    pub inverse_w: f64,
    pub w: f64,
    pub is_cut: bool,
    pub values: Vec<f64>,
}

/// A polygon; the first plane is that of depth.
#[derive(Clone, Default)]
pub struct Polygon {
    pub opacity: [f64; 3],
    pub planes: Vec<Plane>,
    pub corners: Vec<Corner>,
}

/// A screen file.
#[derive(Default)]
pub struct Sheet {
    pub width: usize,
    pub height: usize,
    pub samples: usize,
    pub background: [f64; 3],
    pub line_color: [f64; 3],
    pub polygons: Vec<Polygon>,
}

/// A picture: rows from the top, linear light.
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub colors: Vec<[f64; 3]>,
}

/// Whether this is the slip that was asked for.
pub fn is(name: &str) -> bool {
    std::env::args().nth(1).is_some_and(|word| word == name)
}

impl Plane {
    /// The value at the center of a sample, to the last bit.
    pub fn at(&self, x: usize, y: usize) -> f64 {
        let exact = |x: usize, y: usize| self.a * (x as f64 + 0.5) + self.b * (y as f64 + 0.5) + self.c;
        match self.rule.as_str() {
            "constant" => self.c,
            "double" => exact(x, y),
            "samples" => f64::from(exact(x, y) as f32),
            _ => {
                let start = exact(x & !15, y & !15) as f32;
                f64::from(start + (self.a as f32 * (x & 15) as f32 + self.b as f32 * (y & 15) as f32))
            }
        }
    }

    pub fn within(&self, value: f64) -> f64 {
        value.max(self.low).min(self.high)
    }
}

impl Polygon {
    /// 1/w at the center of a sample.
    pub fn depth(&self, x: usize, y: usize) -> f64 {
        self.planes[0].within(self.planes[0].at(x, y))
    }

    /// Color at the center of a sample, by the planes.
    pub fn color(&self, x: usize, y: usize) -> [f64; 3] {
        let depth = self.depth(x, y);
        std::array::from_fn(|channel| {
            let plane = &self.planes[1 + channel];
            match plane.rule.as_str() {
                "constant" => plane.c,
                "double" => plane.within(plane.at(x, y) / depth),
                _ => plane.within(f64::from((plane.at(x, y) / depth) as f32)),
            }
        })
    }

    pub fn is_opaque(&self) -> bool {
        self.opacity.iter().all(|&share| share >= 1.0)
    }
}

fn floats(words: &[&str]) -> Vec<f64> {
    words.iter().map_while(|word| word.parse().ok()).collect()
}

fn three(words: &[&str]) -> [f64; 3] {
    let numbers = floats(words);
    std::array::from_fn(|i| numbers.get(i).copied().unwrap_or(0.0))
}

/// One record.
fn take(sheet: &mut Sheet, words: &[&str]) {
    match words[0] {
        "samples" => sheet.samples = words[1].parse().unwrap_or(1),
        "size" => (sheet.width, sheet.height) = (words[1].parse().unwrap_or(0), words[2].parse().unwrap_or(0)),
        "background" => sheet.background = three(&words[1..]),
        "line_color" => sheet.line_color = three(&words[1..]),
        "polygon" => sheet.polygons.push(Polygon { opacity: three(&words[4..]), ..Polygon::default() }),
        "plane" => {
            let n = floats(&words[2..7]);
            let plane = Plane { a: n[0], b: n[1], c: n[2], low: n[3], high: n[4], rule: words[7].into() };
            sheet.polygons.last_mut().into_iter().for_each(|polygon| polygon.planes.push(plane.clone()));
        }
        "vertex" => {
            let (n, values) = (floats(&words[1..7]), floats(&words[8..]));
            let corner = Corner { x: n[0], y: n[1], inverse_w: n[2], w: n[5], is_cut: words[7] != "original", values };
            sheet.polygons.last_mut().into_iter().for_each(|polygon| polygon.corners.push(corner.clone()));
        }
        _ => {}
    }
}

/// Draws sheet after sheet.
pub fn serve(mut draw: impl FnMut(&Sheet) -> Picture) {
    let mut sheet = Sheet::default();
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.first() {
            Some(&"end") => {
                write(&draw(&sheet));
                sheet = Sheet::default();
            }
            Some(word) if !word.starts_with('#') => take(&mut sheet, &words),
            _ => {}
        }
    }
}

fn write(picture: &Picture) {
    let mut bytes = format!("P6\n{} {}\n255\n", picture.width, picture.height).into_bytes();
    bytes.extend(picture.colors.iter().flatten().map(|&light| (light.clamp(0.0, 1.0) * 255.0 + 0.5) as u8));
    let mut out = std::io::stdout().lock();
    let _ = out.write_all(&bytes).and_then(|()| out.flush());
}
