//! Lanes: eight numbers side by side, for what is written once for any number of them.

use crate::screen::lane::Lane;
use fearless_simd::{Select, Simd, SimdBase, f32x8};

impl<S: Simd> Lane for f32x8<S> {
    #[inline(always)]
    fn hold(self, low: Self, high: Self) -> Self {
        // The lower bound is looked at last, so it wins where the range is empty, and not-a-number passes both.
        let below_high = self.simd_gt(high).select(high, self);
        self.simd_lt(low).select(low, below_high)
    }
}

/// 0, 1, ... 7.
#[inline(always)]
pub(super) fn counting<S: Simd>(simd: S) -> f32x8<S> {
    f32x8::from_slice(simd, &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0])
}
