//! Color: what the samples of a tile show, eight at a time.
//!
//! depth, owner, planes -COLOR-> light
//!
//! Where the samples of a step show one polygon, what its planes need in a block is made ready once for as long as the same polygon goes
//! on. Where several meet, every lane takes the planes of its own. Then all lanes are lit together, surface by surface, by the
//! shader's own lines.
//!
//! Space: samples; light is linear, red, green and blue apart. Cost: N planes and quotients a step, one light a step and surface.

use super::lanes::{rounded, widened};
use super::layout::{Area, LANES};
use super::planes::{Eight, Ready, gather};
use super::shown::Shown;
use super::tile::NOBODY;
use crate::color::Rgb;
use crate::plan::{DepthFormat, Interpolation, Varying};
use crate::screen::{BLOCK, DrawList, Fragment, Precision, Whole};
use fearless_simd::{Level, Select, Simd, SimdBase, SimdMask, dispatch, f32x8, f64x8, mask32x8, mask64x8, u32x8};

/// Samples of a step.
const STEP: i32 = LANES as i32;

/// Red, green and blue of samples.
pub(super) type Light<'a> = [&'a mut [f32]; 3];

/// Whether depths of a tile are 1/w, and what varies comes from planes: then what is here applies.
pub(super) fn applies(list: &DrawList) -> bool {
    list.varying.without_texture() != Varying::Nothing
        && list.precision == Precision::Single
        && list.depth_mapping.format == DepthFormat::F32
        && list.interpolation != Interpolation::ScanLine
}

/// The samples of a finished tile.
pub(super) struct Finished<'a> {
    pub list: &'a DrawList,
    pub planes: &'a Shown,
    pub background: Rgb<f32>,
    pub area: &'a Area,
    pub stride: usize,
    pub depth: &'a [f32],
    pub owner: &'a [u32],
    pub light: Light<'a>,
    /// Samples that show a polygon.
    pub shown: u64,
    /// Highlights.
    pub powers: u64,
}

/// Finds the light of every sample, without pictures.
pub(super) fn shade(level: Level, tile: &mut Finished<'_>) {
    match tile.list.varying.light_count() {
        3 => dispatch!(level, simd => shade_blocks::<_, 3>(simd, tile)),
        6 => dispatch!(level, simd => shade_blocks::<_, 6>(simd, tile)),
        9 => dispatch!(level, simd => shade_blocks::<_, 9>(simd, tile)),
        // Nothing varies: [`applies`].
        _ => {}
    }
}

/// Finds the colors of fragments, each of any polygon at any sample, without pictures; depths are 1/w.
pub(super) fn shade_fragments(level: Level, (list, shown): (&DrawList, &Shown), fragments: &mut [Fragment]) {
    let (mut powers, of) = (0, (list, shown));
    match list.varying.light_count() {
        3 => dispatch!(level, simd => shade_each::<_, 3>(simd, of, fragments, &mut powers)),
        6 => dispatch!(level, simd => shade_each::<_, 6>(simd, of, fragments, &mut powers)),
        9 => dispatch!(level, simd => shade_each::<_, 9>(simd, of, fragments, &mut powers)),
        _ => fragments.iter_mut().for_each(|fragment| fragment.color = list.shader.line_color),
    }
    list.shader.add_powers(powers);
}

#[inline(always)]
fn shade_each<S: Simd, const N: usize>(
    simd: S,
    (list, shown): (&DrawList, &Shown),
    fragments: &mut [Fragment],
    powers: &mut u64,
) {
    for fragments in fragments.chunks_mut(LANES as usize) {
        let mut eight = Eight::default();
        for lane in 0..LANES as usize {
            let fragment = &fragments[lane.min(fragments.len() - 1)];
            eight.polygons[lane] = fragment.polygon;
            eight.depth[lane] = fragment.depth as f32;
            eight.set(lane, (fragment.x, fragment.y));
        }
        let asked = (1 << fragments.len()) - 1;
        let (values, odd) = gather::<S, N>(simd, (list, shown), &eight);
        let light = light(simd, (list, &eight.polygons), values, asked & !odd, powers);
        for (lane, fragment) in fragments.iter_mut().enumerate() {
            fragment.color = if odd >> lane & 1 == 0 {
                Rgb::new(light[0][lane], light[1][lane], light[2][lane])
            } else {
                let mut room = Whole::default();
                let polygon = list.polygon_in(fragment.polygon as usize, &mut room);
                list.shader.color(&polygon, &polygon.values(fragment.x, fragment.y))
            };
        }
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
    let owners = u32x8::from_slice(simd, owner);
    // Lanes beside the picture show nothing.
    let lanes = STEP.min(tile.area.columns.end - x);
    let shown = !owners.simd_eq(u32x8::splat(simd, NOBODY)).to_bitmask() & ((1 << lanes) - 1);
    if shown == 0 {
        return put_background(tile, range);
    }
    tile.shown += u64::from(shown.count_ones());
    let polygon = owner[shown.trailing_zeros() as usize];
    let one_polygon = !owners.simd_eq(u32x8::splat(simd, polygon)).to_bitmask() & shown == 0;
    let mut polygons = [polygon; LANES as usize];
    let (values, odd) = if one_polygon {
        if ready.polygon != polygon {
            *ready = Ready::new((tile.list, tile.planes), polygon, (x, y));
        }
        ready.eight(simd, (x, y), f32x8::from_slice(simd, depth), shown)
    } else {
        let mut eight = Eight::of_step(owner, depth, (x, y));
        let mut missing = !shown & 0xFF;
        while missing != 0 {
            let lane = missing.trailing_zeros() as usize;
            (eight.polygons[lane], eight.depth[lane]) = (polygon, depth[shown.trailing_zeros() as usize]);
            missing &= missing - 1;
        }
        polygons = eight.polygons;
        gather::<S, N>(simd, (tile.list, tile.planes), &eight)
    };
    let light = light(simd, (tile.list, &polygons), values, shown & !odd, &mut tile.powers);
    put(simd, tile, range, (light, shown));
    put_odd(tile, index, shown & odd, (x, y));
}

/// Lanes that show nothing.
#[inline(always)]
fn put_background(tile: &mut Finished<'_>, range: std::ops::Range<usize>) {
    let background = tile.background.to_array();
    let mut channel = 0;
    while channel < 3 {
        tile.light[channel][range.clone()].fill(background[channel]);
        channel += 1;
    }
}

#[inline(always)]
fn put<S: Simd>(simd: S, tile: &mut Finished<'_>, range: std::ops::Range<usize>, (light, shown): ([f32x8<S>; 3], u64)) {
    let (background, mask) = (tile.background.to_array(), mask32x8::from_bitmask(simd, shown));
    let mut channel = 0;
    while channel < 3 {
        let behind = f32x8::splat(simd, background[channel]);
        mask.select(light[channel], behind).store_slice(&mut tile.light[channel][range.clone()]);
        channel += 1;
    }
}

/// The lanes whose planes are no matter of `f32`, by the shader's own function.
#[inline(always)]
fn put_odd(tile: &mut Finished<'_>, index: usize, odd: u64, (x, y): (i32, i32)) {
    let (mut rest, mut room) = (odd, Whole::default());
    while rest != 0 {
        let lane = rest.trailing_zeros() as usize;
        let polygon = tile.list.polygon_in(tile.owner[index + lane] as usize, &mut room);
        let color = tile.list.shader.color(&polygon, &polygon.values(x + lane as i32, y));
        let [red, green, blue] = &mut tile.light;
        (red[index + lane], green[index + lane], blue[index + lane]) = (color.r, color.g, color.b);
        rest &= rest - 1;
    }
}

/// Makes light of eight values; where `wanted` has no bit, whatever it is.
#[inline(always)]
fn light<S: Simd, const N: usize>(
    simd: S,
    (list, polygons): (&DrawList, &[u32; LANES as usize]),
    values: [f32x8<S>; N],
    wanted: u64,
    powers: &mut u64,
) -> [f32x8<S>; 3] {
    if N == 3 { [values[0], values[1], values[2]] } else { light_of(simd, (list, polygons), &values, wanted, powers) }
}

/// The light of eight normals and eye points, and factors on the color behind them if N is 9, surface by surface.
///
/// Not inlined: it is large, and everything it calls is.
#[inline(never)]
fn light_of<S: Simd, const N: usize>(
    simd: S,
    (list, polygons): (&DrawList, &[u32; LANES as usize]),
    values: &[f32x8<S>; N],
    wanted: u64,
    powers: &mut u64,
) -> [f32x8<S>; 3] {
    simd.vectorize(
        #[inline(always)]
        || light_by_surface(simd, (list, polygons), values, wanted, powers),
    )
}

#[inline(always)]
fn light_by_surface<S: Simd, const N: usize>(
    simd: S,
    (list, polygons): (&DrawList, &[u32; LANES as usize]),
    values: &[f32x8<S>; N],
    wanted: u64,
    powers: &mut u64,
) -> [f32x8<S>; 3] {
    let (mut wide, mut surfaces) = ([f64x8::splat(simd, 0.0); 9], [0; LANES as usize]);
    let mut number = 0;
    while number < N {
        wide[number] = widened(values[number]);
        number += 1;
    }
    let mut lane = 0;
    while lane < LANES as usize {
        surfaces[lane] = list.polygons[polygons[lane] as usize].surface;
        lane += 1;
    }
    let [nx, ny, nz, ex, ey, ez, red, green, blue] = wide;
    let (six, factor) = ([nx, ny, nz, ex, ey, ez], (N == 9).then_some([red, green, blue]));
    let surfaces = u32x8::from_slice(simd, &surfaces);
    let mut light = [values[0], values[1], values[2]];
    let mut rest = wanted;
    while rest != 0 {
        let surface = surfaces[rest.trailing_zeros() as usize];
        let same = surfaces.simd_eq(u32x8::splat(simd, surface)).to_bitmask() & rest;
        rest &= !same;
        let lit = list.shader.light_counting(surface, (six, factor), mask64x8::from_bitmask(simd, same), powers);
        let mask = mask32x8::from_bitmask(simd, same);
        let mut channel = 0;
        while channel < 3 {
            light[channel] = mask.select(rounded(lit[channel]), light[channel]);
            channel += 1;
        }
    }
    light
}
