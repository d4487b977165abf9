//! Planes: what varies at eight samples, from the planes of one polygon or of eight.
//!
//! owner, depth, list -PLANES-> values in lanes, and which lanes are to be asked for otherwise
//!
//! The order of operations is that of [`crate::screen::Plane`] and [`crate::screen::ScreenPolygon::values`]: `f64` at the block's first
//! sample, rounded once, `f32` inside the block, divided by 1/w, held within the range.
//!
//! Space: samples. Cost: five numbers fetched a plane; where one polygon goes on in a block, none.

use super::lanes::{counting, rounded, widened};
use super::layout::LANES;
use super::shown::Shown;
use super::tile::NOBODY;
use crate::plan::Interpolation;
use crate::screen::lane::{Lane, in_block};
use crate::screen::{BLOCK, DrawList, Evaluation, Plane};
use fearless_simd::{Select, Simd, SimdBase, SimdMask, f32x8, f64x8, mask32x8};

const COUNT: usize = LANES as usize;

/// One number's plane in one block.
#[derive(Clone, Copy, Debug, Default)]
struct Channel {
    anchor: f32,
    slope: [f32; 2],
    range: [f32; 2],
    /// The plane is that of value / w.
    over_w: bool,
}

/// What the values of one polygon in one block need.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ready<const N: usize> {
    pub polygon: u32,
    block: (i32, i32),
    /// Its planes are a matter of `f32`.
    single: bool,
    /// All values are the same everywhere.
    constant: bool,
    channels: [Channel; N],
}

impl<const N: usize> Ready<N> {
    pub fn nothing() -> Self {
        let channels = [Channel::default(); N];
        Ready { polygon: NOBODY, block: (0, 0), single: false, constant: false, channels }
    }

    /// The polygon in the block of sample (x, y).
    #[inline(always)]
    pub fn new((list, shown): (&DrawList, &Shown), polygon: u32, (x, y): (i32, i32)) -> Self {
        let planes = light_planes(shown.planes(list, polygon), N);
        let block = (x & !(BLOCK - 1), y & !(BLOCK - 1));
        let mut ready = Ready { polygon, block, single: planes.len() == N, constant: true, ..Ready::nothing() };
        let mut number = 0;
        while number < N && number < planes.len() {
            let (plane, channel) = (&planes[number], &mut ready.channels[number]);
            ready.single &= plane.fits_single();
            ready.constant &= plane.evaluation == Evaluation::Constant;
            let range = [plane.low as f32, plane.high as f32];
            let anchor = plane.anchor(block.0, block.1);
            let over_w = runs_in_space(list, number) && plane.evaluation != Evaluation::Constant;
            *channel = Channel { anchor, slope: plane.slope(), range, over_w };
            number += 1;
        }
        ready
    }

    /// What varies at eight samples from (x, y) on, where 1/w is `depth`, and which of the `shown` lanes are to be asked for otherwise.
    #[inline(always)]
    pub fn eight<S: Simd>(&self, simd: S, (x, y): (i32, i32), depth: f32x8<S>, shown: u64) -> ([f32x8<S>; N], u64) {
        let mut values = [depth; N];
        if !self.single {
            return (values, shown);
        }
        let dx = counting(simd) + f32x8::splat(simd, (x - self.block.0) as f32);
        let at = [dx, f32x8::splat(simd, (y - self.block.1) as f32)];
        let mut number = 0;
        while number < N {
            let channel = &self.channels[number];
            let range = [f32x8::splat(simd, channel.range[0]), f32x8::splat(simd, channel.range[1])];
            let anchor = f32x8::splat(simd, channel.anchor);
            let value = if self.constant {
                anchor
            } else {
                let [a, b] = [f32x8::splat(simd, channel.slope[0]), f32x8::splat(simd, channel.slope[1])];
                in_block(anchor, [a, b], at)
            };
            let value = if channel.over_w { value / depth } else { value };
            values[number] = value.hold(range[0], range[1]);
            number += 1;
        }
        (values, 0)
    }
}

/// Eight samples, each of a polygon of its own.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Eight {
    pub polygons: [u32; COUNT],
    pub depth: [f32; COUNT],
    /// The center of the first sample of each one's block.
    center: [[f64; COUNT]; 2],
    /// Samples from there.
    at: [[f32; COUNT]; 2],
}

impl Eight {
    /// Eight samples of a row, from (x, y) on.
    #[inline(always)]
    pub fn of_step(owner: &[u32], depth: &[f32], (x, y): (i32, i32)) -> Eight {
        let mut eight = Eight::default();
        let mut lane = 0;
        while lane < COUNT {
            (eight.polygons[lane], eight.depth[lane]) = (owner[lane], depth[lane]);
            eight.set(lane, (x + lane as i32, y));
            lane += 1;
        }
        eight
    }

    /// Says which sample a lane has.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, (x, y): (i32, i32)) {
        let block = [x & !(BLOCK - 1), y & !(BLOCK - 1)];
        (self.center[0][lane], self.center[1][lane]) = (f64::from(block[0]) + 0.5, f64::from(block[1]) + 0.5);
        (self.at[0][lane], self.at[1][lane]) = ((x - block[0]) as f32, (y - block[1]) as f32);
    }
}

/// The first `count` planes of what varies: those behind them are u and v, which [`super::textured`] looks at.
#[inline(always)]
fn light_planes(planes: &[Plane], count: usize) -> &[Plane] {
    &planes[..count.min(planes.len())]
}

/// What varies at eight samples, and which lanes are to be asked for otherwise.
#[inline(never)]
pub(super) fn gather<S: Simd, const N: usize>(simd: S, of: (&DrawList, &Shown), eight: &Eight) -> ([f32x8<S>; N], u64) {
    simd.vectorize(
        #[inline(always)]
        || gather_all(simd, of, eight),
    )
}

#[inline(always)]
fn gather_all<S: Simd, const N: usize>(
    simd: S,
    (list, shown): (&DrawList, &Shown),
    eight: &Eight,
) -> ([f32x8<S>; N], u64) {
    let mut planes = [[].as_slice(); COUNT];
    let mut odd = 0;
    let mut lane = 0;
    while lane < COUNT {
        planes[lane] = light_planes(shown.planes(list, eight.polygons[lane]), N);
        if planes[lane].len() != N {
            return ([f32x8::splat(simd, 0.0); N], 0xFF);
        }
        lane += 1;
    }
    if N == 3 && planes[0][0].evaluation == Evaluation::Constant && are_constant(&planes) {
        return (constants(simd, &planes), 0);
    }
    let depth = f32x8::from_slice(simd, &eight.depth);
    let mut values = [depth; N];
    let mut number = 0;
    while number < N {
        let in_space = runs_in_space(list, number);
        let (value, is_odd) = one_number(simd, &planes, number, eight, (depth, in_space));
        values[number] = value;
        odd |= is_odd;
        number += 1;
    }
    (values, odd)
}

/// Whether a number that is not the same everywhere has a plane of value / w, in lists without scan lines.
#[inline(always)]
fn runs_in_space(list: &DrawList, number: usize) -> bool {
    list.interpolation == Interpolation::Perspective || list.varying.is_eye_point(number)
}

/// Whether nothing varies over any of eight polygons: flat shading.
#[inline(always)]
fn are_constant(planes: &[&[Plane]; COUNT]) -> bool {
    let mut constant = true;
    let mut lane = 0;
    while lane < COUNT {
        let mut number = 0;
        while number < planes[lane].len() {
            constant &= planes[lane][number].evaluation == Evaluation::Constant;
            number += 1;
        }
        lane += 1;
    }
    constant
}

/// Colors that are the same all over a polygon, as the shader has them.
#[inline(always)]
fn constants<S: Simd, const N: usize>(simd: S, planes: &[&[Plane]; COUNT]) -> [f32x8<S>; N] {
    let mut values = [f32x8::splat(simd, 0.0); N];
    let mut number = 0;
    while number < N {
        let mut colors = [0.0; COUNT];
        let mut lane = 0;
        while lane < COUNT {
            let plane = &planes[lane][number];
            colors[lane] = plane.clamp(plane.c) as f32;
            lane += 1;
        }
        values[number] = f32x8::from_slice(simd, &colors);
        number += 1;
    }
    values
}

/// One number at eight samples, each from its own plane.
#[inline(always)]
fn one_number<S: Simd>(
    simd: S,
    planes: &[&[Plane]; COUNT],
    number: usize,
    eight: &Eight,
    (depth, in_space): (f32x8<S>, bool),
) -> (f32x8<S>, u64) {
    let [mut a, mut b, mut c, mut low, mut high] = [[0.0; COUNT]; 5];
    let (mut constant, mut odd) = (0_u64, 0_u64);
    let mut lane = 0;
    while lane < COUNT {
        let plane = &planes[lane][number];
        (a[lane], b[lane], c[lane]) = (plane.a, plane.b, plane.c);
        (low[lane], high[lane]) = (plane.low, plane.high);
        match plane.evaluation {
            Evaluation::Blocks => {}
            Evaluation::Constant => constant |= 1 << lane,
            Evaluation::Samples | Evaluation::Double | Evaluation::ScanLine => odd |= 1 << lane,
        }
        lane += 1;
    }
    let mut rest = constant;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        odd |= u64::from(!planes[lane][number].fits_single()) << lane;
        rest &= rest - 1;
    }
    let [a, b, c] = [f64x8::from_slice(simd, &a), f64x8::from_slice(simd, &b), f64x8::from_slice(simd, &c)];
    let [low, high] = [f64x8::from_slice(simd, &low), f64x8::from_slice(simd, &high)];
    let range = [rounded(low), rounded(high)];
    let kept = widened(range[0]).simd_eq(low) & widened(range[1]).simd_eq(high);
    odd |= !kept.to_bitmask() & 0xFF;

    let [x, y] = [f64x8::from_slice(simd, &eight.center[0]), f64x8::from_slice(simd, &eight.center[1])];
    let anchor = rounded(a * x + b * y + c);
    let at = [f32x8::from_slice(simd, &eight.at[0]), f32x8::from_slice(simd, &eight.at[1])];
    let value = in_block(anchor, [rounded(a), rounded(b)], at);
    let value = if in_space {
        // A quotient by 1 is exact.
        let by = mask32x8::from_bitmask(simd, constant).select(f32x8::splat(simd, 1.0), depth);
        value / by
    } else {
        value
    };
    (value.hold(range[0], range[1]), odd)
}
