//! `farop plan`: what the scene needs, what is chosen, and why.

use super::error::{self, CliError};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, as_rasterizer, find_rasterizer, make_plan};
use crate::plan::{EXACT_SUBPIXELS, Plan, PlanRow};
use crate::raster::Registry;
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
    picture: PictureOptions,
}

impl PlanCommand {
    pub fn run(self, registry: &Registry) -> Result<(), CliError> {
        let loaded = self.scenes.load(&self.picture)?;
        let registered = find_rasterizer(registry, &self.rasterizer)?;
        let plan = make_plan(&loaded.scene, &self.picture, as_rasterizer(&registered))?;
        error::print(&text(&plan))
    }
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
