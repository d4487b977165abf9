//! Place: where drawn samples land in the picture, and which part of it is left out.

use super::rules::{Border, Place};

/// Empties what lies in a border that is never drawn.
pub(super) fn keep_inside_border<T: Copy>(
    samples: &mut [T],
    (width, height): (usize, usize),
    border: Border,
    empty: T,
) {
    let is_lost = |x: usize, y: usize| match border {
        Border::None => false,
        Border::LastColumn => x + 1 == width,
        Border::LastRow => y + 1 == height,
        Border::LastBoth => x + 1 == width || y + 1 == height,
        Border::FirstColumn => x == 0,
        Border::FirstRow => y == 0,
        Border::Sides([left, right, top, bottom]) => {
            (left && x == 0) || (right && x + 1 == width) || (top && y == 0) || (bottom && y + 1 == height)
        }
        Border::BeyondSquare => x >= width.min(height) || y >= width.min(height),
    };
    for (at, sample) in samples.iter_mut().enumerate() {
        if is_lost(at % width, at / width) {
            *sample = empty;
        }
    }
}

/// The samples at the places where they land.
pub(super) fn placed<T: Copy>(samples: &[T], (width, height): (usize, usize), place: Place, empty: T) -> Vec<T> {
    let from = |x: usize, y: usize| match place {
        Place::Right => Some((x, y)),
        Place::UpsideDown => Some((x, height - 1 - y)),
        Place::Mirrored => Some((width - 1 - x, y)),
        Place::HalfTurn => Some((width - 1 - x, height - 1 - y)),
        Place::Transposed => (y < width && x < height).then_some((y, x)),
        Place::OneRight => x.checked_sub(1).map(|x| (x, y)),
        Place::OneDown => y.checked_sub(1).map(|y| (x, y)),
        Place::OneLeft => (x + 1 < width).then_some((x + 1, y)),
        Place::OneUp => (y + 1 < height).then_some((x, y + 1)),
        Place::NextInMemory => {
            let at = (y * width + x + 1).min(width * height - 1);
            Some((at % width, at / width))
        }
        Place::LastInMemory => {
            let at = (y * width + x).saturating_sub(1);
            Some((at % width, at / width))
        }
        Place::ByColumns => {
            let at = y * width + x;
            Some((at / height, at % height))
        }
        Place::SizeExchanged => {
            let at = y * width + x;
            let (x, y) = (at % height, at / height);
            (x < width && y < height).then_some((x, y))
        }
    };
    (0..width * height).map(|at| from(at % width, at / width).map_or(empty, |(x, y)| samples[y * width + x])).collect()
}
