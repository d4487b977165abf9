//! Reads a farop v2 screen file into lists and says what is in it. rustc -O reader.rs && ./reader FILE.scr
//! Samples: x right, y down, centers at (i + 0.5, j + 0.5). See docs/screen-files.md.
use std::{collections::HashMap, env, error::Error, fs};

#[allow(dead_code)] // until your rasterizer reads all of it
#[derive(Default)]
struct Polygon {
    surface: usize,
    planes: HashMap<String, Vec<f64>>, // value = a * x + b * y + c; a b c low high
    vertices: Vec<(f64, f64, f64, Vec<f64>)>, // x y 1/w, then what varies
}

fn main() -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(env::args().nth(1).ok_or("usage: reader FILE.scr")?)?;
    let (mut width, mut height) = (0_usize, 0_usize);
    let mut polygons: Vec<Polygon> = Vec::new();
    for line in text.lines() {
        let word: Vec<&str> = line.split('#').next().unwrap_or("").split_whitespace().collect();
        let numbers = |from: usize| word.iter().skip(from).map_while(|text| text.parse().ok()).collect::<Vec<f64>>();
        match (word.first(), polygons.last_mut()) {
            (Some(&"size"), _) => (width, height) = (word[1].parse()?, word[2].parse()?),
            (Some(&"polygon"), _) => polygons.push(Polygon { surface: word[3].parse()?, ..Polygon::default() }),
            (Some(&"plane"), Some(last)) => drop(last.planes.insert(word[1].to_string(), numbers(2))),
            (Some(&"vertex"), Some(last)) => {
                let at = numbers(1); // x y 1/w xw yw w, then a word about the edge, then values
                last.vertices.push((at[0], at[1], at[2], numbers(8)));
            }
            _ => {}
        }
    }
    // Here begins your rasterizer: one color and one depth (1/w, larger is nearer) a sample.
    let all: Vec<_> = polygons.iter().flat_map(|polygon| &polygon.vertices).collect();
    let low = |of: fn(&(f64, f64, f64, Vec<f64>)) -> f64| all.iter().map(|v| of(v)).reduce(f64::min).unwrap_or(0.0);
    let high = |of: fn(&(f64, f64, f64, Vec<f64>)) -> f64| all.iter().map(|v| of(v)).reduce(f64::max).unwrap_or(0.0);
    println!("size {width} {height}\npolygons {}\nvertices {}", polygons.len(), all.len());
    println!("x {:.6} {:.6}\ny {:.6} {:.6}", low(|v| v.0), high(|v| v.0), low(|v| v.1), high(|v| v.1));
    Ok(())
}
