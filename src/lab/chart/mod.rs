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
mod font;
mod png;
mod svg;

use self::axis::Axis;
use super::pareto::{Standing, front, standings};
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
/// How wide a letter is taken to be, and how high a line, when labels make room for each other.
const LETTER: f64 = 6.0;
const LINE: f64 = 12.0;

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

        // What is worth least lies below.
        let marks = standings(&points);
        for (standing, color) in [(Standing::Dominated, Color::Dominated), (Standing::Tied, Color::Tied)] {
            for at in (0..points.len()).filter(|&at| marks[at] == standing && points[at].error.is_finite()) {
                let at = (x.place(points[at].time), y.place(points[at].error));
                self.marks.push(Mark::Dot { at, color, filled: standing == Standing::Dominated });
            }
        }
        let front = front(&points);
        let places: Vec<(f64, f64)> =
            front.iter().map(|&at| (x.place(points[at].time), y.place(points[at].error))).collect();
        for pair in places.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            self.line(a, (b.0, a.1), Color::Front);
            self.line((b.0, a.1), b, Color::Front);
        }
        places.iter().for_each(|&at| self.marks.push(Mark::Dot { at, color: Color::Front, filled: true }));
        let names = front.iter().map(|&at| rows[at].configuration.name.as_str());
        self.labels(&places, &names.collect::<Vec<_>>(), (right, bottom));
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

    /// Names beside points, moved up or down where they would cover another one or leave the panel.
    fn labels(&mut self, places: &[(f64, f64)], names: &[&str], (right, bottom): (f64, f64)) {
        let mut taken: Vec<[f64; 4]> = places.iter().map(|&(x, y)| [x - 4.0, y - 4.0, x + 4.0, y + 4.0]).collect();
        // The staircase, too.
        for pair in places.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            taken.extend([[x0, y0, x1, y0], [x1, y0.min(y1), x1, y0.max(y1)]]);
        }
        for (&(x, y), name) in places.iter().zip(names) {
            let width = name.chars().count() as f64 * LETTER;
            let box_at = |step: i32| {
                let start = if x + 9.0 + width > right { x - 9.0 - width } else { x + 9.0 };
                let base = y - 5.0 + f64::from(step) * 4.0;
                [start, base - LINE + 2.0, start + width, base + 2.0]
            };
            let free = |step: &i32| {
                let own = box_at(*step);
                own[3] < bottom
                    && taken.iter().all(|b| own[2] < b[0] || own[0] > b[2] || own[3] < b[1] || own[1] > b[3])
            };
            // The nearest free place, above before below.
            let step = (0..80).flat_map(|step| [-step, step]).find(free).unwrap_or(0);
            let own = box_at(step);
            taken.push(own);
            self.text((own[0], own[3] - 2.0), name, 0.0, Color::Ink);
            if step.abs() > 3 {
                self.line(
                    (x, y),
                    (if own[0] > x { own[0] - 2.0 } else { own[2] + 2.0 }, own[3] - 5.0),
                    Color::Dominated,
                );
            }
        }
    }

    fn line(&mut self, from: (f64, f64), to: (f64, f64), color: Color) {
        self.marks.push(Mark::Line { from, to, color });
    }

    fn text(&mut self, at: (f64, f64), text: &str, anchor: f64, color: Color) {
        self.marks.push(Mark::Text { at, text: text.to_string(), anchor, color });
    }
}
