//! PNG: the marks of a chart as a picture, with a small font of its own: no fonts of the system are needed.

use super::{Mark, font};
use crate::image::Picture;

/// The picture.
pub(super) fn picture((width, height): (f64, f64), marks: &[Mark]) -> Picture {
    let mut picture = Picture::filled(width as usize, height as usize, [255; 3]);
    for mark in marks {
        match mark {
            Mark::Line { from, to, color } => line(&mut picture, *from, *to, color.rgb()),
            Mark::Dot { at, color, filled } => dot(&mut picture, *at, *filled, color.rgb()),
            Mark::Text { at, text, anchor, color } => {
                let start = at.0 - anchor * (text.chars().count() * font::ADVANCE) as f64;
                write(&mut picture, (start, at.1), text, color.rgb());
            }
        }
    }
    picture
}

fn put(picture: &mut Picture, x: f64, y: f64, color: [u8; 3]) {
    if x >= 0.0 && y >= 0.0 && (x as usize) < picture.width() && (y as usize) < picture.height() {
        picture.set_pixel(x as usize, y as usize, color);
    }
}

fn line(picture: &mut Picture, from: (f64, f64), to: (f64, f64), color: [u8; 3]) {
    let steps = (to.0 - from.0).abs().max((to.1 - from.1).abs()).ceil().max(1.0);
    for step in 0..=steps as u32 {
        let share = f64::from(step) / steps;
        put(picture, from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1), color);
    }
}

fn dot(picture: &mut Picture, (x, y): (f64, f64), filled: bool, color: [u8; 3]) {
    for (across, down) in (-4..=4).flat_map(|down| (-4..=4).map(move |across| (f64::from(across), f64::from(down)))) {
        let radius = across.hypot(down);
        if radius < 4.0 {
            let color = if filled || radius > 2.6 { color } else { [255; 3] };
            put(picture, x + across, y + down, color);
        }
    }
}

fn write(picture: &mut Picture, (x, base): (f64, f64), text: &str, color: [u8; 3]) {
    for (index, letter) in text.chars().enumerate() {
        let left = x + (index * font::ADVANCE) as f64;
        for (row, bits) in font::rows(letter).into_iter().enumerate() {
            for column in (0..font::WIDTH).filter(|column| bits >> (font::WIDTH - 1 - column) & 1 == 1) {
                put(picture, left + column as f64, base - 7.0 + row as f64, color);
            }
        }
    }
}
