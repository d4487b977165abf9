//! Label: where the names of a front's points find room.
//!
//! places, names, all dots -LABEL-> where each name starts
//!
//! A name that covers a point hides what the chart is for, so names give way: they move up, down, or to the left, with a thin line back
//! where that is far; what still finds no room is left to the table. Ends and large steps are named first.
//!
//! Space: pixels of the chart. Boxes are left, top, right, bottom. Cost: steps x boxes a name.

use super::LETTER;

/// How high a line is taken to be.
const LINE: f64 = 12.0;
/// A name stands less than so many steps of four pixels away from its place.
const MOST_STEPS: i32 = 16;

/// A name in its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Label {
    /// Which point of the front.
    pub index: usize,
    /// Where the text starts, on its base line.
    pub start: (f64, f64),
    /// Where the line from the point ends, if the name is not right beside it.
    pub line: Option<(f64, f64)>,
}

/// Names for the points of a front at `places`, clear of all `dots`, the staircase and each other, within `panel`.
pub(super) fn labels(places: &[(f64, f64)], names: &[&str], dots: &[(f64, f64)], panel: [f64; 4]) -> Vec<Label> {
    let mut taken: Vec<[f64; 4]> = dots.iter().map(|&(x, y)| [x - 4.0, y - 4.0, x + 4.0, y + 4.0]).collect();
    for pair in places.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        taken.extend([[x0, y0, x1, y0], [x1, y0.min(y1), x1, y0.max(y1)]]);
    }
    let (mut words, mut labels): (Vec<[f64; 4]>, Vec<Label>) = (Vec::new(), Vec::new());
    for index in by_gain(places) {
        let at = places[index];
        let free = |(word, line): &(_, Option<(f64, f64)>)| {
            is_within(*word, panel)
                && !taken.iter().chain(&words).any(|other| overlap(*word, *other))
                && !line.is_some_and(|end| words.iter().any(|other| overlap(around(at, end), *other)))
        };
        let Some((word, line)) = ways(at, names[index].chars().count() as f64 * LETTER).find(free) else { continue };
        words.push(word);
        taken.extend(line.map(|end| around(at, end)));
        labels.push(Label { index, start: (word[0], word[3] - 2.0), line });
    }
    labels
}

/// Boxes for a name `width` wide beside a point, the nearest first, above before below, right before left; and where a line would end.
fn ways((x, y): (f64, f64), width: f64) -> impl Iterator<Item = ([f64; 4], Option<(f64, f64)>)> {
    let (right, left) = (x + 9.0, x - 9.0 - width);
    let steps = (0..MOST_STEPS).flat_map(move |step| [(-step, right), (step, right), (-step, left), (step, left)]);
    steps.map(move |(step, start)| {
        let base = y - 5.0 + f64::from(step) * 4.0;
        let word = [start, base - LINE + 2.0, start + width, base + 2.0];
        let end = (if start > x { start - 2.0 } else { word[2] + 2.0 }, base - 3.0);
        (word, (step.abs() > 3).then_some(end))
    })
}

fn around(a: (f64, f64), b: (f64, f64)) -> [f64; 4] {
    [a.0.min(b.0), a.1.min(b.1), a.0.max(b.0), a.1.max(b.1)]
}

/// The points of a front: both ends, then those that lie lowest under the one before.
fn by_gain(places: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    let gain = |index: usize| {
        let is_end = index == 0 || index + 1 == places.len();
        if is_end { f64::INFINITY } else { places[index].1 - places[index - 1].1 }
    };
    order.sort_by(|&a, &b| gain(b).total_cmp(&gain(a)));
    order
}

fn overlap(a: [f64; 4], b: [f64; 4]) -> bool {
    a[2] >= b[0] && a[0] <= b[2] && a[3] >= b[1] && a[1] <= b[3]
}

fn is_within(inner: [f64; 4], outer: [f64; 4]) -> bool {
    inner[0] > outer[0] && inner[1] > outer[1] && inner[2] < outer[2] && inner[3] < outer[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A front of `count` points close together in a panel of 300 x 200, with gray points around.
    fn crowded(count: usize) -> (Vec<[f64; 4]>, Vec<(f64, f64)>) {
        let places: Vec<(f64, f64)> = (0..count).map(|i| (150.0 + 5.0 * i as f64, 60.0 + 3.0 * i as f64)).collect();
        let mut dots: Vec<(f64, f64)> = (0..20).map(|i| (20.0 + 13.0 * f64::from(i), 50.0)).collect();
        dots.extend(&places);
        let names = vec!["gouraud A4"; count];
        let labels = labels(&places, &names, &dots, [0.0, 0.0, 300.0, 200.0]);
        let word = |label: Label| {
            let (x, base) = label.start;
            [x, base - LINE + 4.0, x + 10.0 * LETTER, base + 1.0]
        };
        (labels.into_iter().map(word).collect(), dots)
    }

    #[test]
    fn names_cover_neither_points_nor_each_other() {
        let (words, dots) = crowded(9);
        assert!(words.len() >= 5, "{words:?}");
        for (index, &word) in words.iter().enumerate() {
            assert!(is_within(word, [0.0, 0.0, 300.0, 200.0]));
            assert!(!words[..index].iter().any(|&other| overlap(word, other)), "{words:?}");
            let covers = |&(x, y): &(f64, f64)| overlap(word, [x - 3.0, y - 3.0, x + 3.0, y + 3.0]);
            assert!(!dots.iter().any(covers), "{word:?}");
        }
    }

    #[test]
    fn ends_and_large_steps_are_named_first() {
        assert_eq!(by_gain(&[(0.0, 0.0), (1.0, 2.0), (2.0, 50.0), (3.0, 51.0), (4.0, 53.0)]), [0, 4, 2, 1, 3]);
    }
}
