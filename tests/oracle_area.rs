//! The area oracle against sums of many samples, and supersampling against it.

mod support;

use farop::color::Rgb;
use farop::oracle::Vertices;
use farop::oracle::area::{picture, share};
use farop::raster::ZBuffer;
use farop::screen::{DrawList, Grid};
use support::draw;
use support::random::Random;

/// The share of pixel (x, y) by `n` level lines and exact crossings on each: the error falls as 1 / n.
fn by_lines(outline: &[(f64, f64)], (x, y): (f64, f64), n: u32) -> f64 {
    let mut sum = 0.0;
    for line in 0..n {
        let height = y + (f64::from(line) + 0.5) / f64::from(n);
        let mut crossings: Vec<f64> = (0..outline.len())
            .filter_map(|i| {
                let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
                ((a.1 <= height) != (b.1 <= height)).then(|| a.0 + (height - a.1) * (b.0 - a.0) / (b.1 - a.1))
            })
            .map(|at| at.clamp(x, x + 1.0))
            .collect();
        crossings.sort_by(f64::total_cmp);
        sum += crossings.chunks_exact(2).map(|pair| pair[1] - pair[0]).sum::<f64>();
    }
    sum / f64::from(n)
}

/// The area of the whole outline, by the shoelace formula.
fn whole(outline: &[(f64, f64)]) -> f64 {
    let edges = (0..outline.len()).map(|i| (outline[i], outline[(i + 1) % outline.len()]));
    (edges.map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum::<f64>() / 2.0).abs()
}

fn star(random: &mut Random, side: f64, count: usize) -> Vec<(f64, f64)> {
    (0..count)
        .map(|i| {
            let angle = (i as f64 + random.between(0.0, 0.8)) / count as f64 * std::f64::consts::TAU;
            let radius = random.between(0.1, 0.5) * side;
            let at = |offset: f64| ((side / 2.0 + radius * offset) * 256.0).round() / 256.0;
            (at(angle.cos()), at(angle.sin()))
        })
        .collect()
}

#[test]
fn shares_equal_sums_of_many_lines() {
    let mut random = Random::new(9);
    for round in 0..60 {
        let mut outline = star(&mut random, 6.0, 3 + round % 7);
        if round % 3 == 0 {
            // Crosses itself.
            outline.swap(0, 2);
        }
        for (x, y) in (0..36).map(|at| (f64::from(at % 6), f64::from(at / 6))) {
            let (found, expected) = (share(&outline, (x, y)), by_lines(&outline, (x, y), 2000));
            assert!((found.area - expected).abs() < 2e-3, "{outline:?} ({x}, {y}): {} {expected}", found.area);
        }
    }
}

#[test]
fn shares_add_up_to_the_whole() {
    let mut random = Random::new(10);
    let (mut worst, mut bound) = (0.0_f64, 0.0_f64);
    for round in 0..40 {
        let side = [4.0, 40.0, 400.0][round % 3];
        let outline = star(&mut random, side, 3 + round % 6);
        let pixels = side as u32;
        let all = (0..pixels * pixels).map(|at| share(&outline, (f64::from(at % pixels), f64::from(at / pixels))));
        let (sum, error) = all.fold((0.0, 0.0_f64), |(sum, error), one| (sum + one.area, error.max(one.error)));
        worst = worst.max((sum - whole(&outline)).abs() / whole(&outline));
        bound = bound.max(error);
    }
    println!("worst relative difference {worst:e}, largest bound {bound:e}");
    assert!(worst < 1e-13 && bound < 1e-12, "{worst:e} {bound:e}");
}

/// A half plane through the middle pixel of 3 x 3, at A x A samples a pixel.
fn half_plane(angle: f64, offset: f64, samples: u32) -> DrawList {
    let (c, s) = (angle.cos(), angle.sin());
    let at = |along: f64, across: f64| {
        let (x, y) = (1.5 + c * along - s * across, 1.5 + s * along + c * across);
        (x * f64::from(samples), y * f64::from(samples))
    };
    let mut list = DrawList::new(3 * samples, 3 * samples);
    list.grid = Grid { bits: 16 };
    // The z-buffer takes what reaches beyond the picture, too: its target drops the rest.
    list.push_flat(&[at(-9.0, offset), at(9.0, offset), at(9.0, 9.0), at(-9.0, 9.0)], 1.0, [1.0; 3]);
    list
}

#[test]
fn supersampling_errs_as_samples_to_the_power_of_minus_one_and_a_half() {
    // All angles in equal steps: the mean is carried by the few near the axes and near simple fractions.
    const ANGLES: u32 = 3000;
    let mut logs = Vec::new();
    for samples in [2_u32, 4, 8, 16] {
        let mut random = Random::new(77);
        let (mut squares, mut count, mut largest) = (0.0, 0.0, 0.0_f64);
        for step in 0..ANGLES {
            let angle = (f64::from(step) + random.unit()) / f64::from(ANGLES) * std::f64::consts::TAU;
            let list = half_plane(angle, random.between(-0.5, 0.5), samples);
            let (exact, bound) = picture(&list, Vertices::Snapped, samples, Rgb::BLACK);
            assert!(bound < 1e-12);
            let drawn = draw(&list, &ZBuffer).0.average(samples as usize);
            for (drawn, exact) in drawn.pixels().iter().zip(exact.pixels()).filter(|(_, e)| e.r > 0.0 && e.r < 1.0) {
                let error = f64::from(drawn.r) - f64::from(exact.r);
                squares += error * error;
                count += 1.0;
                largest = largest.max(error.abs());
            }
        }
        let rms = f64::sqrt(squares / count);
        let law = 0.25 * f64::from(samples).powf(-1.5);
        println!("A = {samples}: rms {rms:.5}, {:.3} of 0.25 A^-1.5, largest {largest:.4}, {count} pixels", rms / law);
        assert!(largest <= 0.5 / f64::from(samples) + 1e-3, "{largest}");
        logs.push((f64::from(samples).ln(), rms.ln()));
    }
    let mean = |f: fn(&(f64, f64)) -> f64| logs.iter().map(f).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let run: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
    let slope = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / run;
    println!("slope {slope:.3}");
    assert!((slope + 1.5).abs() < 0.03, "{slope}");
}
