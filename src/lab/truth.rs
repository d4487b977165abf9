//! Truth: the light that every pixel ought to have.
//!
//! Scene -ray oracle-> light of each pixel, which pixels an outline passes
//!
//! A pixel is the mean of the light over its square. Thirteen rays tell whether anything happens in it; where they meet different
//! things, or their light differs by more than a level, 233 rays take their place. The rays stand on a Fibonacci lattice: no
//! grid of A x A samples coincides with it, so no number of samples is flattered, and edges along rows and columns are as
//! well measured as slanted ones (233 rays: about one level rms of a full black-white edge).
//!
//! Where the scene has a shape without an equation, the truth is the finest picture of our own, and says so.
//!
//! Source: for the lattice, Sloan and Joe, "Lattice Methods for Multiple Integration", Oxford, 1994.
//! Cost: 14 to 247 rays a pixel, 1 to 3 microseconds each, on all cores.

use crate::color::{Encoding, Rgb};
use crate::image::Image;
use crate::oracle::ray::{RayError, Tracer};
use crate::plan::{Choices, ClipLight, DepthFormat, FlatRule, Interpolation, PlanError, Shading};
use crate::raster::ZBuffer;
use crate::render;
use crate::scene::Scene;

/// Rays that find out whether anything happens in a pixel, and rays where it does: neighboring Fibonacci numbers.
const FEW: (u32, u32) = (13, 8);
const MANY: (u32, u32) = (233, 144);
/// Light within a pixel that differs by no more than this many levels is even.
const EVEN_LEVELS: f64 = 1.0;

/// What every pixel, or some of them, ought to show.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Width and height in pixels.
    pub size: (u32, u32),
    /// The pixels that are known, row by row; ascending.
    pub pixels: Vec<u32>,
    /// Linear light of each of them.
    pub light: Vec<Rgb>,
    /// An outline or a fast change of light passes it.
    pub uneven: Vec<bool>,
    /// Who says so.
    pub source: Source,
}

/// Where a truth comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// The ray oracle.
    Rays,
    /// The finest own picture, because the oracle has no answer; the reason.
    OwnFinest(RayError),
}

impl Truth {
    /// The truth of the picture of `scene` under the size, angle, culling, encoding and light of `choices`.
    ///
    /// `some`: only these pixels (row by row, ascending).
    ///
    /// # Errors
    /// [`PlanError`] when the scene has no usable view.
    pub fn new(scene: &Scene, choices: &Choices, some: Option<Vec<u32>>) -> Result<Truth, PlanError> {
        let choices = Choices { samples: 1, ..choices.clone() };
        let plan = crate::plan::Plan::new(scene, &choices, crate::plan::Accepts::AnyPolygon)?;
        let size = plan.view.pixels;
        let pixels = some.unwrap_or_else(|| (0..size.0 * size.1).collect());
        match Tracer::new(scene, &choices) {
            Ok(tracer) => Ok(traced(&tracer, choices.encoding, size, pixels)),
            Err(error) => finest(scene, &choices, pixels, error),
        }
    }

    /// The picture; pixels that are not known are black.
    #[must_use]
    pub fn image(&self) -> Image {
        let mut image = Image::new(self.size.0 as usize, self.size.1 as usize, Rgb::gray(0.0));
        for (&pixel, light) in self.pixels.iter().zip(&self.light) {
            image.pixels_mut()[pixel as usize] = light.to_f32();
        }
        image
    }
}

fn traced(tracer: &Tracer<'_>, encoding: Encoding, size: (u32, u32), pixels: Vec<u32>) -> Truth {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    // Interleaved shares: pixels that cost much lie together.
    let share = |first: usize| -> Vec<(Rgb, bool)> {
        let own = pixels.iter().skip(first).step_by(threads);
        own.map(|&pixel| pixel_light(tracer, encoding, (pixel % size.0, pixel / size.0))).collect()
    };
    let share = &share;
    let shares: Vec<Vec<(Rgb, bool)>> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|first| scope.spawn(move || share(first))).collect();
        workers.into_iter().map(|worker| worker.join().expect("rays do not panic")).collect()
    });
    let (light, uneven) = (0..pixels.len()).map(|at| shares[at % threads][at / threads]).unzip();
    Truth { size, pixels, light, uneven, source: Source::Rays }
}

/// The mean light of a pixel, and whether it is uneven.
fn pixel_light(tracer: &Tracer<'_>, encoding: Encoding, (x, y): (u32, u32)) -> (Rgb, bool) {
    let lattice = |(count, step): (u32, u32), ray: u32| (f64::from(ray), f64::from(ray * step % count));
    // The few reach from border to border: rays at the middles of thirteen rows miss a level edge in the outer 4 % of a pixel,
    // and 4 % of a bright light on black are 50 display levels.
    let stretched = |ray: u32| {
        let (across, down) = lattice(FEW, ray);
        let last = f64::from(FEW.0 - 1);
        (f64::from(x) + across / last, f64::from(y) + down / last)
    };
    let inside = |ray: u32| {
        let (across, down) = lattice(MANY, ray);
        let count = f64::from(MANY.0);
        (f64::from(x) + (across + 0.5) / count, f64::from(y) + (down + 0.5) / count)
    };
    let mut seen = None;
    let (mut sum, mut low, mut high, mut even) = (Rgb::BLACK, [f64::MAX; 3], [f64::MIN; 3], true);
    for ray in 0..FEW.0 {
        let (across, down) = stretched(ray);
        let (light, hit) = tracer.light(across, down);
        let met = hit.map(|hit| (hit.instance, hit.surface, hit.part));
        even &= *seen.get_or_insert(met) == met;
        for (axis, level) in levels(encoding, light).into_iter().enumerate() {
            (low[axis], high[axis]) = (low[axis].min(level), high[axis].max(level));
        }
        sum += light;
    }
    if even && (0..3).all(|axis| high[axis] - low[axis] <= EVEN_LEVELS) {
        return (sum * (1.0 / f64::from(FEW.0)), false);
    }
    let mut sum = Rgb::BLACK;
    for ray in 0..MANY.0 {
        let (across, down) = inside(ray);
        sum += tracer.light(across, down).0;
    }
    (sum * (1.0 / f64::from(MANY.0)), true)
}

/// Display levels, 0 to 255, not rounded.
#[must_use]
pub fn levels(encoding: Encoding, light: Rgb) -> [f64; 3] {
    encoding.encode(light).to_array().map(|value| (value * 255.0).clamp(0.0, 255.0))
}

/// Our own picture with everything turned up.
fn finest(scene: &Scene, choices: &Choices, pixels: Vec<u32>, error: RayError) -> Result<Truth, PlanError> {
    let choices = Choices {
        shading: Shading::Phong,
        samples: 9,
        tolerance: 1.0 / 64.0,
        subpixel_bits: 12,
        interpolation: Interpolation::Perspective,
        clip_light: ClipLight::Interpolate,
        flat: FlatRule::Face,
        depth: DepthFormat::F32,
        ..choices.clone()
    };
    let image = render::render(scene, &choices, Some(&ZBuffer))?.image;
    let size = (image.width() as u32, image.height() as u32);
    let light: Vec<Rgb> = pixels.iter().map(|&pixel| image.pixels()[pixel as usize].to_f64()).collect();
    // Without rays, a pixel is uneven where its neighbors differ.
    let of = |x: usize, y: usize| levels(choices.encoding, image.pixel(x, y).to_f64());
    let differs = |a: [f64; 3], b: [f64; 3]| (0..3).any(|axis| (a[axis] - b[axis]).abs() > 2.0 * EVEN_LEVELS);
    let uneven = |&pixel: &u32| {
        let (x, y) = ((pixel % size.0) as usize, (pixel / size.0) as usize);
        let around = [(x + 1, y), (x, y + 1), (x.wrapping_sub(1), y), (x, y.wrapping_sub(1))];
        let inside = around.into_iter().filter(|&(x, y)| x < image.width() && y < image.height());
        inside.into_iter().any(|(u, v)| differs(of(u, v), of(x, y)))
    };
    Ok(Truth { size, uneven: pixels.iter().map(uneven).collect(), pixels, light, source: Source::OwnFinest(error) })
}
