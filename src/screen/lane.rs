//! Lane: a number, or several side by side, that planes are evaluated with.
//!
//! Why: the readable rasterizers ask for one sample, a fast one for eight at a time. Both must do the same operations in the same order,
//! so the order is written once, here, for anything that adds, multiplies, divides and compares like an IEEE 754 number in every lane.

use std::ops::{Add, Div, Mul};

/// A number or a vector of numbers.
pub trait Lane: Copy + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    /// `low` where the number is below it, `high` where it is not and is above that, else the number; not-a-number stays.
    #[must_use]
    fn hold(self, low: Self, high: Self) -> Self;
}

macro_rules! number_lane {
    ($number:ty) => {
        impl Lane for $number {
            // Not clamp: that panics on an empty range, which a broken screen file may hold.
            #[inline(always)]
            fn hold(self, low: Self, high: Self) -> Self {
                if self < low {
                    low
                } else if self > high {
                    high
                } else {
                    self
                }
            }
        }
    };
}
number_lane!(f32);
number_lane!(f64);

/// The value of a plane inside a block: `anchor` at the block's first sample, `slope` per sample right and down, `at` samples right and
/// down of the first one. No fused multiply-add, nothing accumulated.
#[inline(always)]
#[must_use]
pub fn in_block<T: Lane>(anchor: T, slope: [T; 2], at: [T; 2]) -> T {
    anchor + (slope[0] * at[0] + slope[1] * at[1])
}
