//! Chart: time against error, one panel a kind of error, every configuration a point.
//!
//! rows -CHART-> marks -svg, png-> file
//!
//! Both axes are logarithmic: a configuration twice as slow and one half as wrong are equally far away, wherever they are. Gray
//! points are dominated, hollow ones tied, filled ones the front, joined by a staircase: between two of its points nothing
//! better was measured. An error of 0 has no logarithm and stands on the lowest line, which says so.
//!
//! Space: pixels of the chart, x right, y down. A panel is laid out as marks first, so that SVG and PNG show the same.

mod axis;
pub mod font;
mod label;
mod png;
mod svg;

use self::axis::Axis;
use super::pareto::{Point, Standing, front, standings};
use super::{Kind, Row, points};
use crate::image::Picture;

/// Something drawn.
#[derive(Clone, Debug, PartialEq)]
enum Mark {
    Line {
        from: (f64, f64),
        to: (f64, f64),
        color: Color,
    },
    Dot {
        at: (f64, f64),
        color: Color,
        filled: bool,
    },
    /// `anchor`: 0 the text starts at `at`, 0.5 it is in the middle, 1 it ends there. `at` is on the base line.
    Text {
        at: (f64, f64),
        text: String,
        anchor: f64,
        color: Color,
    },
}

/// The few colors of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Color {
    Ink,
    Grid,
    Dominated,
    Tied,
    Front,
}

impl Color {
    fn rgb(self) -> [u8; 3] {
        match self {
            Color::Ink => [40, 40, 40],
            Color::Grid => [228, 228, 228],
            Color::Dominated => [175, 175, 175],
            Color::Tied => [60, 110, 190],
            Color::Front => [200, 50, 30],
        }
    }
}

/// Size of a panel, and the room around its axes: left, top, right, bottom.
const PANEL: (f64, f64) = (720.0, 460.0);
const ROOM: [f64; 4] = [78.0, 46.0, 20.0, 46.0];
/// How wide a letter is taken to be.
const LETTER: f64 = 6.0;

/// A chart: marks on a white sheet.
#[derive(Clone, Debug)]
pub struct Chart {
    size: (f64, f64),
    marks: Vec<Mark>,
}

impl Chart {
    /// One panel for every kind of error that is known of these rows, two side by side.
    #[must_use]
    pub fn new(title: &str, rows: &[Row]) -> Chart {
        let known = |kind: &Kind| rows.iter().any(|row| kind.of(&row.errors).is_finite());
        let kinds: Vec<Kind> = Kind::ALL.into_iter().filter(known).collect();
        let columns = kinds.len().clamp(1, 2);
        let size = (PANEL.0 * columns as f64, PANEL.1 * kinds.len().div_ceil(columns) as f64);
        let mut chart = Chart { size, marks: Vec::new() };
        for (index, &kind) in kinds.iter().enumerate() {
            let corner = ((index % columns) as f64 * PANEL.0, (index / columns) as f64 * PANEL.1);
            chart.panel(corner, title, rows, kind);
        }
        chart
    }

    /// The chart as the text of an SVG file.
    #[must_use]
    pub fn svg(&self) -> String {
        svg::text(self.size, &self.marks)
    }

    /// The chart as a picture.
    #[must_use]
    pub fn picture(&self) -> Picture {
        png::picture(self.size, &self.marks)
    }

    fn panel(&mut self, corner: (f64, f64), title: &str, rows: &[Row], kind: Kind) {
        let points = points(rows, kind);
        let finite = points.iter().filter(|point| point.error.is_finite());
        let (times, errors): (Vec<f64>, Vec<f64>) = finite.map(|point| (point.time, point.error)).unzip();
        let (left, right) = (corner.0 + ROOM[0], corner.0 + PANEL.0 - ROOM[2]);
        let (top, bottom) = (corner.1 + ROOM[1], corner.1 + PANEL.1 - ROOM[3]);
        let (x, y) = (Axis::new(&times, (left, right)), Axis::new(&errors, (bottom, top)));
        self.frame((&x, &y), (left, right), (top, bottom));
        self.text((left, corner.1 + 18.0), title, 0.0, Color::Ink);
        self.text(
            (left, corner.1 + 34.0),
            &format!("{} against milliseconds a frame (median)", kind.title()),
            0.0,
            Color::Ink,
        );

        self.legend((right, corner.1 + 18.0));

        self.points(rows, &points, (&x, &y), [left, top, right, bottom]);
    }

    /// All points, what is worth least below; the front with its names.
    fn points(&mut self, rows: &[Row], points: &[Point], (x, y): (&Axis, &Axis), panel: [f64; 4]) {
        let at = |point: &Point| (x.place(point.time), y.place(point.error));
        let (marks, mut dots) = (standings(points), Vec::new());
        for (standing, color) in [(Standing::Dominated, Color::Dominated), (Standing::Tied, Color::Tied)] {
            let known = points.iter().zip(&marks).filter(|(point, _)| point.error.is_finite());
            for (point, _) in known.filter(|(_, mark)| **mark == standing) {
                dots.push(at(point));
                self.marks.push(Mark::Dot { at: at(point), color, filled: standing == Standing::Dominated });
            }
        }
        let front = front(points);
        let places: Vec<(f64, f64)> = front.iter().map(|&index| at(&points[index])).collect();
        for pair in places.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            self.line(a, (b.0, a.1), Color::Front);
            self.line((b.0, a.1), b, Color::Front);
        }
        places.iter().for_each(|&at| self.marks.push(Mark::Dot { at, color: Color::Front, filled: true }));
        dots.extend(&places);
        let names: Vec<&str> = front.iter().map(|&index| rows[index].configuration.name.as_str()).collect();
        for label in label::labels(&places, &names, &dots, panel) {
            self.text(label.start, names[label.index], 0.0, Color::Ink);
            if let Some(end) = label.line {
                self.line(places[label.index], end, Color::Dominated);
            }
        }
    }

    fn frame(&mut self, (x, y): (&Axis, &Axis), (left, right): (f64, f64), (top, bottom): (f64, f64)) {
        for tick in &x.ticks {
            let at = x.place(tick.value);
            self.line((at, top), (at, bottom), Color::Grid);
            self.text((at, bottom + 16.0), &tick.label, 0.5, Color::Ink);
        }
        for tick in &y.ticks {
            let at = y.place(tick.value);
            self.line((left, at), (right, at), Color::Grid);
            self.text((left - 6.0, at + 4.0), &tick.label, 1.0, Color::Ink);
        }
        self.line((left, bottom), (right, bottom), Color::Ink);
        self.line((left, top), (left, bottom), Color::Ink);
        self.text(((left + right) / 2.0, bottom + 34.0), "milliseconds", 0.5, Color::Ink);
    }

    /// Which color means what, ending at `right`.
    fn legend(&mut self, (right, base): (f64, f64)) {
        let mut end = right;
        for (word, color) in [("dominated", Color::Dominated), ("tied", Color::Tied), ("front", Color::Front)] {
            self.text((end, base), word, 1.0, Color::Ink);
            let start = end - word.len() as f64 * LETTER - 8.0;
            self.marks.push(Mark::Dot { at: (start, base - 4.0), color, filled: color != Color::Tied });
            end = start - 16.0;
        }
    }

    fn line(&mut self, from: (f64, f64), to: (f64, f64), color: Color) {
        self.marks.push(Mark::Line { from, to, color });
    }

    fn text(&mut self, at: (f64, f64), text: &str, anchor: f64, color: Color) {
        self.marks.push(Mark::Text { at, text: text.to_string(), anchor, color });
    }
}
