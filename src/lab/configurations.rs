//! Configurations: the ways of drawing a scene that the lab compares.
//!
//! Scene, base choices -CONFIGURATIONS-> list of (name, rasterizer, choices)
//!
//! Why not every combination: a dozen knobs multiply to thousands of pictures that nobody reads. The lab takes one base, its
//! neighbors one knob at a time (what does this knob cost, what does it buy?), and all combinations of the three knobs that trade
//! the most: shading, samples, tolerance. `--all` multiplies depth, sub-pixel bits and rasterizers in as well.
//!
//! A knob that a scene gives nothing to turn is left out: tolerance without shapes, integer depth without yon, rules of
//! transparency without anything transparent.

use crate::plan::{
    Choices, ClipLight, Culling, DepthFormat, FlatRule, Interpolation, Plan, PlanError, Shading, Transparency,
};
use crate::raster::Rasterizer;
use crate::scene::Scene;

/// One way of drawing the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Configuration {
    /// What it differs in, as options of the command line without the dashes.
    pub name: String,
    /// Name of the rasterizer in the registry.
    pub rasterizer: String,
    /// What it is drawn with.
    pub choices: Choices,
}

/// Which combinations are wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Spread {
    /// The base, its neighbors, and shading x samples x tolerance.
    #[default]
    Sensible,
    /// The product of all knobs but the historic switches, which stay neighbors of the base.
    All,
}

/// Samples a pixel in each direction, tolerances in pixels, sub-pixel bits: from cheap to accurate.
pub const SAMPLES: [u32; 4] = [1, 2, 3, 4];
/// Silhouette tolerances in pixels.
pub const TOLERANCES: [f64; 4] = [4.0, 1.0, 0.25, 1.0 / 16.0];
/// Sub-pixel bits.
pub const BITS: [u32; 3] = [8, 4, 0];
const SHADINGS: [Shading; 3] = [Shading::Flat, Shading::Gouraud, Shading::Phong];

/// The configurations of `scene`: without doubles and without those that make no plan; the base first.
///
/// `rasterizers` are names and algorithms; the first draws the base.
///
/// # Errors
/// [`PlanError`] when the base itself cannot be drawn.
pub fn configurations(
    scene: &Scene,
    base: &Choices,
    rasterizers: &[(&str, &dyn Rasterizer)],
    spread: Spread,
) -> Result<Vec<Configuration>, PlanError> {
    let Some(&(first, first_algorithm)) = rasterizers.first() else { return Ok(Vec::new()) };
    let plan = Plan::new(scene, base, first_algorithm.accepts())?;
    let has_shapes = plan.survey.shapes > 0 && base.resolution.is_none();
    let mut all = vec![(first, base.clone())];
    all.extend(diagonal(base, has_shapes).into_iter().map(|choices| (first, choices)));
    all.extend(rasterizers.iter().map(|&(name, _)| (name, base.clone())));
    all.extend(neighbors(base, &plan).into_iter().map(|choices| (first, choices)));
    if spread == Spread::All {
        let fine = diagonal(base, has_shapes).into_iter().flat_map(|choices| product(&choices));
        let fine: Vec<Choices> = fine.collect();
        all.extend(rasterizers.iter().flat_map(|&(name, _)| fine.iter().map(move |choices| (name, choices.clone()))));
    }
    let mut found: Vec<Configuration> = Vec::new();
    for (rasterizer, choices) in all {
        let accepts = rasterizers.iter().find(|entry| entry.0 == rasterizer).map(|entry| entry.1.accepts());
        let draws = accepts.is_some_and(|accepts| Plan::new(scene, &choices, accepts).is_ok());
        let known = found.iter().any(|other| other.rasterizer == rasterizer && other.choices == choices);
        if draws && !known {
            let name = name(rasterizer, &choices, (first, base), has_shapes);
            found.push(Configuration { name, rasterizer: rasterizer.to_string(), choices });
        }
    }
    Ok(found)
}

/// Shading x samples x tolerance.
fn diagonal(base: &Choices, has_shapes: bool) -> Vec<Choices> {
    let tolerances = if has_shapes { TOLERANCES.to_vec() } else { vec![base.tolerance] };
    let mut all = Vec::new();
    for shading in SHADINGS {
        for samples in SAMPLES {
            for &tolerance in &tolerances {
                all.push(Choices { shading, samples, tolerance, ..base.clone() });
            }
        }
    }
    all
}

/// Depth x sub-pixel bits around one of the diagonal.
fn product(choices: &Choices) -> Vec<Choices> {
    let depths = DepthFormat::ALL.iter();
    let with = |depth: DepthFormat| BITS.map(|subpixel_bits| Choices { depth, subpixel_bits, ..choices.clone() });
    depths.flat_map(|&depth| with(depth)).collect()
}

/// The base with one knob turned: number formats, then the historic switches.
fn neighbors(base: &Choices, plan: &Plan) -> Vec<Choices> {
    let mut all = Vec::new();
    let mut turned = |turn: &dyn Fn(&mut Choices)| {
        let mut choices = base.clone();
        turn(&mut choices);
        all.push(choices);
    };
    BITS.iter().for_each(|&bits| turned(&|choices| choices.subpixel_bits = bits));
    DepthFormat::ALL.iter().for_each(|&depth| turned(&|choices| choices.depth = depth));
    Interpolation::ALL.iter().for_each(|&way| turned(&|choices| choices.interpolation = way));
    ClipLight::ALL.iter().for_each(|&way| turned(&|choices| choices.clip_light = way));
    let rules = if plan.survey.transparent_surfaces > 0 { Transparency::ALL } else { &[] };
    rules.iter().for_each(|&rule| turned(&|choices| choices.transparency = rule));
    turned(&|choices| choices.triangles = true);
    turned(&|choices| choices.culling = Culling::None);
    turned(&|choices| (choices.shading, choices.flat) = (Shading::Flat, FlatRule::Sipp));
    all.push(as_in_1996(base));
    all
}

/// Integer coordinates, light after clipping, colors linear on the screen.
fn as_in_1996(base: &Choices) -> Choices {
    let (clip_light, interpolation) = (ClipLight::Relight, Interpolation::Screen);
    Choices { subpixel_bits: 0, clip_light, interpolation, ..base.clone() }
}

/// Shading, samples and tolerance, and what else differs from the base.
fn name(rasterizer: &str, choices: &Choices, (first, base): (&str, &Choices), has_shapes: bool) -> String {
    let mut words = vec![choices.shading.name().to_string(), format!("A{}", choices.samples)];
    if has_shapes {
        words.push(format!("tol {}", choices.tolerance));
    }
    if rasterizer != first {
        words.push(format!("-r {rasterizer}"));
    }
    if *choices == as_in_1996(base) {
        words.push("as in 1996".to_string());
        return words.join(" ");
    }
    let mut add = |differs: bool, word: String| words.extend(differs.then_some(word));
    add(choices.subpixel_bits != base.subpixel_bits, format!("bits {}", choices.subpixel_bits));
    add(choices.depth != base.depth, format!("depth {}", choices.depth.name()));
    add(choices.interpolation != base.interpolation, format!("interp {}", choices.interpolation.name()));
    add(choices.clip_light != base.clip_light, choices.clip_light.name().to_string());
    add(choices.transparency != base.transparency, choices.transparency.name().to_string());
    add(choices.triangles != base.triangles, "triangles".to_string());
    add(choices.culling != base.culling, format!("culling {}", choices.culling.name()));
    add(choices.flat != base.flat, "sipp".to_string());
    words.join(" ")
}
