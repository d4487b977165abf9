//! How many texels of a draped map a pixel gets, by four ways of drawing the map: the table of docs/maps.md.
//!
//! `cargo run --release --example drape_table`
//!
//! Six views of land 4 km wide and 50 m high, from 2, 40 and 650 m above it; 2 km of horizon, an opening of 1 radian, 1024 x 768 pixels, a texture of
//! 1024 x 1024. Each cell: the first percentile and the median of texels a pixel gets in its worst direction.

use farop::forest::drape::{Drape, Method, Texels, View};
use farop::math::{Vec3, cos, radians, sin};
use farop::scene::{Camera, Place};

const SIDE: u32 = 1024;

fn main() {
    println!("| view (pitch) | uniform | thesis | 2004 program | searched n |\n|---|---|---|---|---|");
    let views = [
        (2.0, 5.0, 0.5),
        (40.0, 10.0, 1.0),
        (650.0, 30.0, 5.0),
        (650.0, 50.0, 5.0),
        (650.0, 70.0, 5.0),
        (650.0, 85.0, 5.0),
    ];
    for (above, down, near) in views {
        let view = view(above, down, near);
        let cells =
            [Method::Uniform, Method::Thesis, Method::Program, Method::Searched].map(|method| cell(method, &view));
        println!("| {above} m (-{down}°) | {} |", cells.join(" | "));
    }
}

fn view(above: f64, down: f64, near: f64) -> View {
    let from = Vec3::new(0.0, 0.0, 50.0 + above);
    let ahead = Vec3::new(0.0, cos(radians(down)), -sin(radians(down)));
    let camera = Camera {
        from,
        at: from + ahead,
        up: Vec3::Z,
        angle: 1.0_f64.to_degrees(),
        hither: near,
        yon: None,
        resolution: (1024, 768),
        place: Place::default(),
    };
    View::of_camera(&camera, (1024, 768), 2000.0, [Vec3::new(-2000.0, -2000.0, 0.0), Vec3::new(2000.0, 2000.0, 50.0)])
}

fn cell(method: Method, view: &View) -> String {
    let Some(drape) = Drape::new(method, view) else { return "w <= 0".to_string() };
    let Some(texels) = Texels::of(&drape, view, SIDE) else { return "no land".to_string() };
    let strength = match (method, drape.strength) {
        (Method::Searched, Some(strength)) => format!(" ({strength:.0})"),
        _ => String::new(),
    };
    format!("{:.3}/{:.3}{strength}", texels.first_percentile, texels.median)
}
