//! `farop plan`: what the scene needs, what is chosen, and why.

use super::error::{self, CliError};
use super::options::{PictureOptions, PromiseOptions};
use super::scenes::{SceneOptions, as_rasterizer, find_rasterizer, make_plan};
use crate::lab::promise::{self, Goal, Promise};
use crate::plan::{Choices, EXACT_SUBPIXELS, Plan, PlanRow};
use crate::raster::{Rasterizer, Registry};
use crate::scene::Scene;
use clap::Args;

/// What scenes need, what is chosen, why, and what is saved
#[derive(Args)]
#[command(after_help = "Examples:\n  farop plan spd:balls\n  farop plan scene.nff --shading wire")]
pub(super) struct PlanCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Rasterizer the plan is made for
    #[arg(short, long, value_name = "NAME", default_value = "zbuffer")]
    rasterizer: String,
    #[command(flatten)]
    promise: PromiseOptions,
    #[command(flatten)]
    picture: PictureOptions,
}

impl PlanCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let registered = find_rasterizer(registry, &self.rasterizer)?;
        if let Some(goal) = self.promise.max_error {
            let areas = as_rasterizer(&registered).filter(|_| self.rasterizer != "wire");
            let promise = promise(&loaded.scene, &self.picture.choices(), areas, goal)?;
            let accepts = areas.map_or(crate::plan::Accepts::AnyPolygon, Rasterizer::accepts);
            let plan = Plan::new(&loaded.scene, &promise.choices, accepts)?;
            return error::print(&(promise.text() + &text(&plan)));
        }
        let plan = make_plan(&loaded.scene, &self.picture, as_rasterizer(&registered))?;
        error::print(&text(&plan))
    }
}

/// The choices that keep `goal` with a rasterizer that draws areas.
pub(super) fn promise(
    scene: &Scene,
    base: &Choices,
    areas: Option<&dyn Rasterizer>,
    goal: Goal,
) -> Result<Promise, CliError> {
    let areas =
        areas.ok_or_else(|| CliError::failed("--max-error needs a rasterizer that draws areas, as -r zbuffer"))?;
    promise::keep(scene, base, areas, goal).map_err(CliError::failed)
}

/// Levels of light, and the reflection models where there are others than NFF's.
fn light_line(plan: &Plan) -> String {
    let survey = &plan.survey;
    let chosen = survey.lights - survey.own_intensities;
    let mut text =
        format!("light      ambient {:.3}, each of {chosen} lights {:.3}", plan.ambient, plan.light_intensity);
    let (phong, basic) = (survey.phong_surfaces, survey.basic_surfaces);
    for (count, what) in
        [(survey.own_intensities, "lights with their own"), (phong, "surfaces of phong"), (basic, "surfaces of basic")]
    {
        if count > 0 {
            text += &format!(", {count} {what}");
        }
    }
    text + "\n"
}

/// The plan as a table.
pub(super) fn text(plan: &Plan) -> String {
    let (width, height) = plan.view.pixels;
    let choices = &plan.choices;
    let mut text = format!(
        "picture    {width}x{height} pixels of {0} x {0} samples, {1} shading, {2}\n",
        choices.samples,
        choices.shading.name(),
        match choices.subpixel_bits {
            EXACT_SUBPIXELS => "nothing snapped".to_string(),
            bits => format!("{bits} sub-pixel bits"),
        }
    );
    text += &light_line(plan);
    let rows = plan.explain();
    let width = |of: fn(&PlanRow) -> &str| rows.iter().map(|row| of(row).len()).max().unwrap_or(0);
    let (needs, decisions) = (width(|row| row.need).max(10), width(|row| &row.decision));
    for row in &rows {
        text += &format!("{:needs$} {:decisions$}  {}", row.need, row.decision, row.reason);
        if !row.saving.is_empty() {
            text += &format!("; saves {}", row.saving);
        }
        text.push('\n');
    }
    text
}
