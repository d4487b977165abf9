//! Order: in which order fragments are put, and whether depth is read. Only of a target that is watched, for the grader.
//!
//! Target -watched-> ORDER -> `farop grade watkins`
//!
//! A scan-line algorithm decides each sample before it puts it: it puts every sample once, line by line from the left, and need not
//! know what is there. A z-buffer asks. The picture cannot tell one from the other; the order can.
//!
//! Space: samples. Cost: one look into a table of a byte a sample, for every fragment and every depth that is read.

use std::sync::{Mutex, PoisonError};

/// A sample: column and row.
type Sample = (i32, i32);

/// What came of watching one drawing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Order {
    /// How often [`super::Target::depth`] was asked about a sample of the picture.
    pub depth_reads: u64,
    /// The first sample it was asked about.
    pub first_read: Option<Sample>,
    /// Opaque fragments put where an opaque one already was.
    pub repeats: u64,
    /// The first of these samples.
    pub first_repeat: Option<Sample>,
    /// Opaque fragments above, or in the same line left of, the one before.
    pub steps_back: u64,
    /// The first of them: the sample before, and the sample.
    pub first_step_back: Option<[Sample; 2]>,
}

impl Order {
    /// Adds what was seen in another part of the picture; of two first places, the one known stays.
    pub(super) fn add(&mut self, other: Order) {
        self.depth_reads += other.depth_reads;
        self.repeats += other.repeats;
        self.steps_back += other.steps_back;
        self.first_read = self.first_read.or(other.first_read);
        self.first_repeat = self.first_repeat.or(other.first_repeat);
        self.first_step_back = self.first_step_back.or(other.first_step_back);
    }
}

/// The eyes of a watched target. Behind a lock because reading depth does not need the target for oneself.
#[derive(Debug)]
pub(super) struct Watch(Mutex<Seen>);

#[derive(Debug)]
struct Seen {
    order: Order,
    width: usize,
    /// Samples that hold an opaque fragment.
    filled: Vec<bool>,
    last: Option<Sample>,
}

impl Watch {
    /// Over a picture of that size.
    pub fn new((width, height): (u32, u32)) -> Watch {
        let samples = width as usize * height as usize;
        Watch(Mutex::new(Seen {
            order: Order::default(),
            width: width as usize,
            filled: vec![false; samples],
            last: None,
        }))
    }

    /// Depth of a sample inside the picture was asked for.
    pub fn read(&self, sample: Sample) {
        let mut seen = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        seen.order.depth_reads += 1;
        seen.order.first_read.get_or_insert(sample);
    }

    /// A fragment is put inside the picture. Layers of glass may lie over each other, so only opaque ones have an order.
    pub fn put(&self, sample: Sample, is_opaque: bool) {
        if is_opaque {
            self.0.lock().unwrap_or_else(PoisonError::into_inner).put(sample);
        }
    }

    /// What was seen.
    pub fn order(&self) -> Order {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).order
    }
}

impl Seen {
    fn put(&mut self, sample: Sample) {
        let (x, y) = sample;
        if std::mem::replace(&mut self.filled[y as usize * self.width + x as usize], true) {
            self.order.repeats += 1;
            self.order.first_repeat.get_or_insert(sample);
        }
        // The same sample again is a repetition, no step back.
        if let Some(last) = self.last.filter(|&(last_x, last_y)| (y, x) < (last_y, last_x)) {
            self.order.steps_back += 1;
            self.order.first_step_back.get_or_insert([last, sample]);
        }
        self.last = Some(sample);
    }
}

#[cfg(test)]
mod tests {
    use crate::color::Rgb;
    use crate::plan::Transparency;
    use crate::raster::{Frame, Order, Target};
    use crate::screen::Fragment;

    fn fragment(x: i32, y: i32, opacity: f32) -> Fragment {
        Fragment { x, y, depth: 0.5, color: Rgb::gray(0.25), opacity: Rgb::gray(opacity), polygon: 3 }
    }

    fn watched(draw: impl Fn(&mut Target<'_>)) -> (Frame, Order) {
        let mut frame = Frame::default();
        let mut target = frame.target((4, 3), 0..3, Rgb::gray(0.0), Transparency::Over).watched();
        draw(&mut target);
        let order = target.finish().order.expect("it was watched");
        (frame, order)
    }

    #[test]
    fn scan_line_order_is_nothing_to_speak_of() {
        let (_, order) = watched(|target| {
            for (x, y) in [(1, 0), (3, 0), (0, 1), (1, 1), (2, 2)] {
                target.put(fragment(x, y, 1.0));
            }
            // Glass may lie anywhere and twice; what is outside is counted elsewhere.
            target.put(fragment(0, 0, 0.5));
            target.put(fragment(0, 0, 0.5));
            target.put(fragment(9, 0, 1.0));
            assert_eq!(target.depth(9, 9), 0.0);
        });
        assert_eq!(order, Order::default());
    }

    #[test]
    fn what_is_out_of_order_is_counted_with_its_first_place() {
        let (frame, order) = watched(|target| {
            for (x, y) in [(1, 1), (2, 1), (2, 1), (0, 1), (3, 0)] {
                target.put(fragment(x, y, 1.0));
            }
            assert_eq!((target.depth(2, 1), target.depth(0, 0), target.width()), (0.5, 0.0, 4));
        });
        assert_eq!((order.repeats, order.first_repeat), (1, Some((2, 1))));
        assert_eq!((order.steps_back, order.first_step_back), (2, Some([(2, 1), (0, 1)])));
        assert_eq!((order.depth_reads, order.first_read), (2, Some((2, 1))));
        // The picture is that of a target that nobody watches.
        assert_eq!(frame.sample(6).0, Some(3));
    }

    #[test]
    fn bands_are_watched_too() {
        let (_, order) = watched(|target| {
            target.bands(3, |band| {
                let row = band.row_range().start;
                band.put(fragment(2, row, 1.0));
                band.put(fragment(1, row, 1.0));
            });
        });
        assert_eq!((order.steps_back, order.repeats), (3, 0));
    }

    #[test]
    fn who_is_not_watched_has_no_order() {
        let mut frame = Frame::default();
        let mut target = frame.target((4, 3), 0..3, Rgb::gray(0.0), Transparency::Over);
        target.put(fragment(1, 1, 1.0));
        assert_eq!(target.finish().order, None);
    }
}
