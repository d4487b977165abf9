//! Color: what the samples of a tile show, eight at a time.
//!
//! depth, owner, planes -COLOR-> light
//!
//! Samples of a step that show the same polygon are computed together; a step on which eight polygons meet takes eight turns. What a
//! polygon's planes need in a block is made ready once for as long as the same polygon goes on. Values that vary (colors; or normal and
//! eye point, which the shader makes light of) come from lanes; light is the shader's own function.
//!
//! Space: samples; light is linear. Cost: N planes and quotients a step and polygon.

use super::cover::STEP;
use super::lanes::counting;
use super::layout::{Area, LANES};
use super::tile::NOBODY;
use crate::color::Rgb;
use crate::plan::{DepthFormat, Interpolation, Varying};
use crate::screen::lane::{Lane, in_block};
use crate::screen::{BLOCK, DrawList, Evaluation, Plane, Precision};
use fearless_simd::{Level, Simd, SimdBase, SimdMask, dispatch, f32x8, u32x8};

/// Numbers that vary, in one lane or eight.
type Numbers<T, const N: usize> = [T; N];

/// Whether depths of a tile are 1/w, and what varies comes from planes: then what is here applies.
pub(super) fn applies(list: &DrawList) -> bool {
    matches!(list.varying, Varying::Color | Varying::NormalEye)
        && list.precision == Precision::Single
        && list.depth_mapping.format == DepthFormat::F32
        && list.interpolation != Interpolation::ScanLine
}

/// The samples of a finished tile.
pub(super) struct Finished<'a> {
    pub list: &'a DrawList,
    pub background: Rgb<f32>,
    pub area: &'a Area,
    pub stride: usize,
    pub depth: &'a [f32],
    pub owner: &'a [u32],
    pub light: &'a mut [Rgb<f32>],
    /// Samples that show a polygon.
    pub shown: u64,
    /// Highlights.
    pub powers: u64,
}

/// Finds the light of every sample.
pub(super) fn shade(level: Level, tile: &mut Finished<'_>) {
    match tile.list.varying {
        Varying::Nothing => {}
        Varying::Color => dispatch!(level, simd => shade_blocks::<_, 3>(simd, tile)),
        Varying::NormalEye => dispatch!(level, simd => shade_blocks::<_, 6>(simd, tile)),
        Varying::NormalEyeColor => dispatch!(level, simd => shade_blocks::<_, 9>(simd, tile)),
        // Not here: [`applies`], [`super::textured`].
        Varying::ColorTexture | Varying::NormalEyeTexture | Varying::NormalEyeColorTexture => {}
    }
}

/// The light of one sample of `polygon`, where 1/w is `depth`.
pub(super) fn of_sample(list: &DrawList, polygon: u32, sample: (i32, i32), depth: f32) -> Rgb<f32> {
    let mut powers = 0;
    let light = match list.varying {
        Varying::Nothing => list.shader.line_color,
        Varying::Color => one::<3>(list, polygon, sample, depth, &mut powers),
        Varying::NormalEye => one::<6>(list, polygon, sample, depth, &mut powers),
        Varying::NormalEyeColor => one::<9>(list, polygon, sample, depth, &mut powers),
        Varying::ColorTexture | Varying::NormalEyeTexture | Varying::NormalEyeColorTexture => {
            list.shader.fragment(&list.polygon(polygon as usize), sample.0, sample.1).color
        }
    };
    list.shader.add_powers(powers);
    light
}

/// As [`of_sample`], of N numbers, with nothing made ready: for polygons that show on this sample alone.
#[inline(always)]
fn one<const N: usize>(list: &DrawList, polygon: u32, (x, y): (i32, i32), depth: f32, powers: &mut u64) -> Rgb<f32> {
    let view = list.polygon(polygon as usize);
    let planes = view.varying_planes();
    let block = (x & !(BLOCK - 1), y & !(BLOCK - 1));
    let at = [(x - block.0) as f32, (y - block.1) as f32];
    let mut values = [0.0; N];
    let mut single = planes.len() == N;
    for (number, (value, plane)) in values.iter_mut().zip(planes).enumerate() {
        single &= plane.fits_single();
        let over = in_block(plane.anchor(block.0, block.1), plane.slope(), at);
        let range = [plane.low as f32, plane.high as f32];
        *value = f64::from(from_plane(over, view.is_over_w(number, plane), depth, range));
    }
    if single {
        list.shader.color_counting(view.surface(), &values, powers)
    } else {
        list.shader.fragment(&view, x, y).color
    }
}

#[inline(always)]
fn shade_blocks<S: Simd, const N: usize>(simd: S, tile: &mut Finished<'_>) {
    let Area { columns, rows } = tile.area.clone();
    let mut ready = Ready::<N>::nothing();
    let mut y = rows.start;
    while y < rows.end {
        let y_end = ((y & !(BLOCK - 1)) + BLOCK).min(rows.end);
        let mut x = columns.start;
        while x < columns.end {
            let x_end = ((x & !(BLOCK - 1)) + BLOCK).min(columns.end);
            ready.polygon = NOBODY;
            let mut row = y;
            while row < y_end {
                let mut column = x;
                while column < x_end {
                    shade_step(simd, tile, &mut ready, (column, row));
                    column += STEP;
                }
                row += 1;
            }
            x = x_end;
        }
        y = y_end;
    }
}

/// Shades up to eight samples of a row.
#[inline(always)]
fn shade_step<S: Simd, const N: usize>(simd: S, tile: &mut Finished<'_>, ready: &mut Ready<N>, (x, y): (i32, i32)) {
    let index = (y - tile.area.rows.start) as usize * tile.stride + (x - tile.area.columns.start) as usize;
    let range = index..index + LANES as usize;
    let (owner, depth) = (&tile.owner[range.clone()], &tile.depth[range.clone()]);
    let light = &mut tile.light[range];
    let owners = u32x8::from_slice(simd, owner);
    let nobody = owners.simd_eq(u32x8::splat(simd, NOBODY)).to_bitmask();
    if nobody != 0 {
        light.fill(tile.background);
    }
    // Lanes beside the picture show nothing.
    let lanes = STEP.min(tile.area.columns.end - x);
    let mut rest = !nobody & ((1 << lanes) - 1);
    tile.shown += u64::from(rest.count_ones());
    while rest != 0 {
        let first = rest.trailing_zeros() as usize;
        let polygon = owner[first];
        let same = owners.simd_eq(u32x8::splat(simd, polygon)).to_bitmask() & rest;
        rest &= !same;
        let alone = same & (same - 1) == 0;
        if alone && ready.polygon != polygon {
            light[first] = one::<N>(tile.list, polygon, (x + first as i32, y), depth[first], &mut tile.powers);
            continue;
        }
        if ready.polygon != polygon {
            *ready = Ready::new(tile.list, polygon, (x, y));
        }
        if let Kind::Constant(color) = ready.kind {
            put_constant(light, same, color);
        } else if alone || matches!(ready.kind, Kind::Other) {
            let mut lanes = same;
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize;
                light[lane] = ready.one(tile.list, (x + lane as i32, y), depth[lane], &mut tile.powers);
                lanes &= lanes - 1;
            }
        } else {
            let values = ready.eight(simd, (x, y), f32x8::from_slice(simd, depth));
            put_values(tile.list, ready, (light, same), &values, &mut tile.powers);
        }
    }
}

#[inline(always)]
fn put_constant(light: &mut [Rgb<f32>], lanes: u64, color: Rgb<f32>) {
    if lanes == 0xFF {
        light.fill(color);
        return;
    }
    let mut rest = lanes;
    while rest != 0 {
        light[rest.trailing_zeros() as usize] = color;
        rest &= rest - 1;
    }
}

/// Makes light of eight values and writes the lanes asked for.
#[inline(always)]
fn put_values<S: Simd, const N: usize>(
    list: &DrawList,
    ready: &Ready<N>,
    (light, lanes): (&mut [Rgb<f32>], u64),
    values: &Numbers<f32x8<S>, N>,
    powers: &mut u64,
) {
    let mut rest = lanes;
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        let mut numbers = [0.0; N];
        let mut number = 0;
        while number < N {
            numbers[number] = values[number].as_slice()[lane];
            number += 1;
        }
        light[lane] = ready.light(list, numbers, powers);
        rest &= rest - 1;
    }
}

/// How a polygon's values are found.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// The same color everywhere.
    Constant(Rgb<f32>),
    /// By planes in `f32`, from anchors.
    Planes,
    /// By the shader's own function.
    Other,
}

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
struct Ready<const N: usize> {
    polygon: u32,
    surface: u32,
    block: (i32, i32),
    kind: Kind,
    channels: [Channel; N],
}

impl<const N: usize> Ready<N> {
    fn nothing() -> Self {
        let channels = [Channel::default(); N];
        Ready { polygon: NOBODY, surface: 0, block: (0, 0), kind: Kind::Other, channels }
    }

    /// The polygon in the block of sample (x, y).
    #[inline(always)]
    fn new(list: &DrawList, polygon: u32, (x, y): (i32, i32)) -> Self {
        let view = list.polygon(polygon as usize);
        let planes = view.varying_planes();
        let block = (x & !(BLOCK - 1), y & !(BLOCK - 1));
        let mut ready = Ready { polygon, surface: view.surface(), block, ..Ready::nothing() };
        if planes.len() != N || !planes.iter().all(Plane::fits_single) {
            return ready;
        }
        if let [r, g, b] = planes
            && planes.iter().all(|plane| plane.evaluation == Evaluation::Constant)
        {
            ready.kind = Kind::Constant(Rgb::new(r.c, g.c, b.c).to_f32());
            return ready;
        }
        ready.kind = Kind::Planes;
        for (number, (channel, plane)) in ready.channels.iter_mut().zip(planes).enumerate() {
            let range = [plane.low as f32, plane.high as f32];
            let anchor = plane.anchor(block.0, block.1);
            *channel = Channel { anchor, slope: plane.slope(), range, over_w: view.is_over_w(number, plane) };
        }
        ready
    }

    /// What varies at eight samples from (x, y) on, where 1/w is `depth`.
    #[inline(always)]
    fn eight<S: Simd>(&self, simd: S, (x, y): (i32, i32), depth: f32x8<S>) -> Numbers<f32x8<S>, N> {
        let dx = counting(simd) + f32x8::splat(simd, (x - self.block.0) as f32);
        let at = [dx, f32x8::splat(simd, (y - self.block.1) as f32)];
        let mut values = [depth; N];
        let mut number = 0;
        while number < N {
            let channel = &self.channels[number];
            let [a, b] = [f32x8::splat(simd, channel.slope[0]), f32x8::splat(simd, channel.slope[1])];
            let range = [f32x8::splat(simd, channel.range[0]), f32x8::splat(simd, channel.range[1])];
            let value = in_block(f32x8::splat(simd, channel.anchor), [a, b], at);
            values[number] = from_plane(value, channel.over_w, depth, range);
            number += 1;
        }
        values
    }

    /// The light of sample (x, y), where 1/w is `depth`.
    #[inline(always)]
    fn one(&self, list: &DrawList, (x, y): (i32, i32), depth: f32, powers: &mut u64) -> Rgb<f32> {
        match self.kind {
            Kind::Constant(color) => color,
            Kind::Planes => {
                let at = [(x - self.block.0) as f32, (y - self.block.1) as f32];
                let mut values = [0.0; N];
                for (value, channel) in values.iter_mut().zip(&self.channels) {
                    let plane = in_block(channel.anchor, channel.slope, at);
                    *value = from_plane(plane, channel.over_w, depth, channel.range);
                }
                self.light(list, values, powers)
            }
            Kind::Other => list.shader.fragment(&list.polygon(self.polygon as usize), x, y).color,
        }
    }

    /// The light of interpolated values.
    #[inline(always)]
    fn light(&self, list: &DrawList, values: Numbers<f32, N>, powers: &mut u64) -> Rgb<f32> {
        let mut wide = [0.0; N];
        let mut number = 0;
        while number < N {
            wide[number] = f64::from(values[number]);
            number += 1;
        }
        list.shader.color_counting(self.surface, &wide, powers)
    }
}

/// A value from its plane: divided by 1/w where the plane is that of value / w, within its range.
#[inline(always)]
fn from_plane<T: Lane>(plane: T, over_w: bool, inverse_w: T, [low, high]: [T; 2]) -> T {
    let value = if over_w { plane / inverse_w } else { plane };
    value.hold(low, high)
}
