//! Board: what the window shows, before there is a window: pixels to draw lines, dots and letters on.
//!
//! picture, overlays -BOARD-> window, PNG
//!
//! Why not an `Image`: overlays are display values laid over finished levels; light has been encoded by then. A pixel is
//! one `u32`, 0x00RRGGBB, because that is what windows take.
//!
//! Space: pixels, x right, y down; points between pixels are allowed and everything outside is dropped.

use crate::color::Rgb;
use crate::image::{Image, Picture};
use crate::lab::chart::font;

/// Display colors of overlays, 0x00RRGGBB.
pub mod ink {
    /// Text, outlines in hand.
    pub const WHITE: u32 = 0xFF_FF_FF;
    /// Plates behind text.
    pub const BLACK: u32 = 0;
    /// Outlines.
    pub const GRAY: u32 = 0x90_90_90;
    /// Back faces, losing samples, differences.
    pub const RED: u32 = 0xE0_40_30;
    /// Front faces, winning samples.
    pub const GREEN: u32 = 0x50_C0_60;
    /// The view volume, edges that clipping made.
    pub const BLUE: u32 = 0x50_A0_FF;
    /// What is in hand.
    pub const YELLOW: u32 = 0xFF_D0_40;
    /// Colors of planes, ears and other things that are counted.
    pub const WHEEL: [u32; 6] = [0xE0_40_30, 0xF0_90_30, 0xE0_D0_40, 0x50_C0_60, 0x40_B0_D0, 0xB0_60_E0];
}

/// A point on the board, in pixels.
pub type Point = (f64, f64);

/// Pixels of the window.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Board {
    width: usize,
    height: usize,
    pixels: Vec<u32>,
}

impl Board {
    /// A board of one color.
    #[must_use]
    pub fn new(width: usize, height: usize, color: u32) -> Board {
        Board { width, height, pixels: vec![color; width * height] }
    }

    /// The picture as it stands.
    #[must_use]
    pub fn of_picture(picture: &Picture) -> Board {
        let pixels = picture.colors().map(packed).collect();
        Board { width: picture.width(), height: picture.height(), pixels }
    }

    /// The levels of `image`, as [`Image::encode`] gives them, on as many threads as there are; keeps the memory of the board.
    pub fn show(&mut self, image: &Image, encoding: crate::color::Encoding, threads: u32) {
        (self.width, self.height) = (image.width(), image.height());
        self.pixels.resize(self.width * self.height, 0);
        let each = self.pixels.len().div_ceil(threads.max(1) as usize).max(1);
        std::thread::scope(|scope| {
            for (pixels, lights) in self.pixels.chunks_mut(each).zip(image.pixels().chunks(each)) {
                scope.spawn(move || {
                    let encode = |light: Rgb<f32>| packed(light.to_array().map(|channel| encoding.level(channel)));
                    let (mut last, mut shown) = (Rgb::gray(0.0), encode(Rgb::gray(0.0)));
                    for (pixel, &light) in pixels.iter_mut().zip(lights) {
                        // Neighbors are often equal, and comparing is cheaper than encoding.
                        if light != last {
                            (last, shown) = (light, encode(light));
                        }
                        *pixel = shown;
                    }
                });
            }
        });
    }

    /// Pixels across.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Pixels down.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// All pixels, row after row from the top, 0x00RRGGBB.
    #[must_use]
    pub fn pixels(&self) -> &[u32] {
        &self.pixels
    }

    /// The board as a picture to save.
    #[must_use]
    pub fn picture(&self) -> Picture {
        let mut picture = Picture::filled(self.width, self.height, [0; 3]);
        for (index, &pixel) in self.pixels.iter().enumerate() {
            picture.set_pixel(index % self.width, index / self.width, unpacked(pixel));
        }
        picture
    }

    /// The color at column `x` of row `y`; `None` outside.
    #[must_use]
    pub fn pixel(&self, x: i64, y: i64) -> Option<u32> {
        self.index(x, y).map(|index| self.pixels[index])
    }

    /// Colors one pixel.
    pub fn put(&mut self, x: i64, y: i64, color: u32) {
        if let Some(index) = self.index(x, y) {
            self.pixels[index] = color;
        }
    }

    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let inside = (0..self.width as i64).contains(&x) && (0..self.height as i64).contains(&y);
        inside.then(|| y as usize * self.width + x as usize)
    }

    /// Colors the pixels from (left, top) to before (right, bottom).
    pub fn fill(&mut self, (left, top): (i64, i64), (right, bottom): (i64, i64), color: u32) {
        for y in top.max(0)..bottom.min(self.height as i64) {
            for x in left.max(0)..right.min(self.width as i64) {
                self.put(x, y, color);
            }
        }
    }

    /// Every pixel in the rectangle, `share` of 256 of the way to `color`.
    pub fn tint(&mut self, (left, top): (i64, i64), (right, bottom): (i64, i64), color: u32, share: u32) {
        for y in top.max(0)..bottom.min(self.height as i64) {
            for x in left.max(0)..right.min(self.width as i64) {
                self.blend(x, y, color, share);
            }
        }
    }

    /// One pixel, `share` of 256 of the way to `color`.
    pub fn blend(&mut self, x: i64, y: i64, color: u32, share: u32) {
        if let Some(index) = self.index(x, y) {
            self.pixels[index] = mixed(self.pixels[index], color, share);
        }
    }

    /// The whole board, `share` of 256 of the way to black.
    pub fn dim(&mut self, share: u32) {
        self.pixels.iter_mut().for_each(|pixel| *pixel = mixed(*pixel, ink::BLACK, share));
    }

    /// A line one pixel wide, whatever the zoom.
    pub fn line(&mut self, from: Point, to: Point, color: u32) {
        let (width, height) = (self.width as f64, self.height as f64);
        let Some((from, to)) = within(from, to, (-1.0, -1.0), (width + 1.0, height + 1.0)) else { return };
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let steps = dx.abs().max(dy.abs()).ceil().max(1.0);
        for step in 0..=steps as i64 {
            let share = step as f64 / steps;
            self.put((from.0 + dx * share).floor() as i64, (from.1 + dy * share).floor() as i64, color);
        }
    }

    /// A closed outline.
    pub fn outline(&mut self, corners: &[Point], color: u32) {
        crate::math::edges(corners).for_each(|(&from, &to)| self.line(from, to, color));
    }

    /// All pixels whose center is inside a closed outline (even-odd), `share` of 256 of the way to `color`.
    pub fn area(&mut self, corners: &[Point], color: u32, share: u32) {
        let rows = corners.iter().map(|corner| corner.1);
        let top = rows.clone().fold(f64::INFINITY, f64::min).max(0.0) as i64;
        let bottom = rows.fold(0.0, f64::max).min(self.height as f64) as i64;
        let mut marks = Vec::new();
        for y in top..=bottom {
            let center = y as f64 + 0.5;
            let crossed = |(a, b): &(&Point, &Point)| (a.1 <= center) != (b.1 <= center);
            marks.clear();
            let crossing = |(a, b): (&Point, &Point)| a.0 + (b.0 - a.0) * (center - a.1) / (b.1 - a.1);
            marks.extend(crate::math::edges(corners).filter(crossed).map(crossing));
            marks.sort_by(f64::total_cmp);
            for pair in marks.chunks_exact(2) {
                let columns = (pair[0] - 0.5).ceil().max(0.0)..(pair[1] - 0.5).ceil().min(self.width as f64);
                (columns.start as i64..columns.end as i64).for_each(|x| self.blend(x, y, color, share));
            }
        }
    }

    /// A square dot of `side` pixels around a point.
    pub fn dot(&mut self, at: Point, side: i64, color: u32) {
        let (left, top) = (at.0.floor() as i64 - side / 2, at.1.floor() as i64 - side / 2);
        self.fill((left, top), (left + side, top + side), color);
    }

    /// A line of text, its upper left corner at (x, y), `scale` pixels a dot.
    pub fn text(&mut self, (x, y): (i64, i64), text: &str, scale: i64, color: u32) {
        for (number, letter) in text.chars().enumerate() {
            let left = x + number as i64 * font::ADVANCE as i64 * scale;
            for (row, bits) in font::rows(letter).into_iter().enumerate() {
                for column in (0..font::WIDTH).filter(|column| bits >> (font::WIDTH - 1 - column) & 1 == 1) {
                    let (left, top) = (left + column as i64 * scale, y + row as i64 * scale);
                    self.fill((left, top), (left + scale, top + scale), color);
                }
            }
        }
    }
}

/// One color, `share` of 256 of the way to another.
#[must_use]
pub fn mixed(from: u32, to: u32, share: u32) -> u32 {
    let channel = |shift: u32| {
        let (from, to) = (from >> shift & 0xFF, to >> shift & 0xFF);
        (from * (256 - share) + to * share) >> 8
    };
    channel(16) << 16 | channel(8) << 8 | channel(0)
}

/// Red, green and blue as one number.
#[must_use]
pub fn packed([red, green, blue]: [u8; 3]) -> u32 {
    u32::from(red) << 16 | u32::from(green) << 8 | u32::from(blue)
}

/// Red, green and blue of a color.
#[must_use]
pub fn unpacked(color: u32) -> [u8; 3] {
    [(color >> 16) as u8, (color >> 8) as u8, color as u8]
}

/// The part of a line inside a rectangle; `None` where there is none, or a coordinate is not finite.
///
/// Source: Liang and Barsky, "A New Concept and Method for Line Clipping", ACM TOG 3(1), 1984.
fn within(from: Point, to: Point, low: Point, high: Point) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    let walls = [(-dx, from.0 - low.0), (dx, high.0 - from.0), (-dy, from.1 - low.1), (dy, high.1 - from.1)];
    for (towards, room) in walls {
        if !(towards.is_finite() && room.is_finite()) || towards == 0.0 && room < 0.0 {
            return None;
        }
        if towards < 0.0 {
            first = first.max(room / towards);
        } else if towards > 0.0 {
            last = last.min(room / towards);
        }
    }
    let at = |share: f64| (from.0 + dx * share, from.1 + dy * share);
    (first <= last).then(|| (at(first), at(last)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(board: &Board) -> Vec<String> {
        let letter = |&pixel: &u32| if pixel == 0 { '.' } else { '#' };
        board.pixels().chunks(board.width()).map(|row| row.iter().map(letter).collect()).collect()
    }

    #[test]
    fn lines_are_cut_at_the_border_and_keep_their_place() {
        let mut board = Board::new(4, 3, 0);
        board.line((-1e9, 1.5), (1e9, 1.5), ink::WHITE);
        board.line((2.5, f64::NAN), (2.5, 9.0), ink::WHITE);
        assert_eq!(shown(&board), ["....", "####", "...."]);
        let walls = ((-1.0, -1.0), (5.0, 4.0));
        assert_eq!(within((-1e9, 1.5), (1e9, 1.5), walls.0, walls.1), Some(((-1.0, 1.5), (5.0, 1.5))));
        assert_eq!(within((-9.0, 1.0), (-2.0, 9.0), walls.0, walls.1), None);
        let mut board = Board::new(4, 4, 0);
        board.line((0.0, 0.0), (3.9, 3.9), ink::WHITE);
        assert_eq!(shown(&board), ["#...", ".#..", "..#.", "...#"]);
    }

    #[test]
    fn areas_hold_the_pixels_whose_centers_are_inside() {
        let mut board = Board::new(5, 3, 0);
        board.area(&[(0.5, 0.0), (4.0, 0.0), (4.0, 3.0), (0.5, 1.6)], ink::WHITE, 256);
        assert_eq!(shown(&board), ["####.", "####.", "...#."]);
    }

    #[test]
    fn text_and_colors_come_back() {
        let mut board = Board::new(6, 9, 0);
        board.text((0, 0), "p", 1, ink::WHITE);
        assert_eq!(shown(&board)[2..5], ["####..", "#...#.", "#...#."]);
        assert_eq!(packed(unpacked(0x12_34_56)), 0x12_34_56);
        assert_eq!((mixed(0, 0xFF_FF_FF, 256), mixed(0x80_80_80, 0, 128)), (0xFF_FF_FF, 0x40_40_40));
        assert_eq!(Board::of_picture(&board.picture()), board);
    }
}
