//! The plan in words: each need, what it is, why, and what leaving it out saves.

use super::{ClipPlane, Culling, FlatRule, Interpolation, NeedsMode, Plan, Shading, Split};

/// One row of `farop plan`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanRow {
    /// What is decided.
    pub need: &'static str,
    /// How.
    pub decision: String,
    /// Why.
    pub reason: String,
    /// What is not computed because of it; empty where nothing is saved.
    pub saving: String,
}

impl Plan {
    /// The rows of `farop plan`, one need each.
    #[must_use]
    pub fn explain(&self) -> Vec<PlanRow> {
        let mut rows = vec![self.clip_row(), self.light_row(), self.specular_row(), self.blending_row()];
        rows.push(self.depth_row());
        rows.push(self.split_row());
        rows.extend(self.colors_row());
        rows.extend(self.texture_row());
        rows.extend(self.faces_row());
        if self.survey.shapes > 0 {
            rows.push(self.shapes_row());
        }
        if self.choices.needs == NeedsMode::Full {
            for row in &mut rows {
                row.saving = String::new();
                row.reason = format!("--needs full; the scene itself: {}", row.reason);
            }
        }
        rows
    }

    fn clip_row(&self) -> PlanRow {
        let clipped = ClipPlane::ALL.into_iter().filter(|plane| self.needs.clip & plane.bit() != 0);
        let names: Vec<_> = clipped.map(ClipPlane::name).collect();
        let crossing = self.survey.crossing.iter().max().copied().unwrap_or(0);
        let volumes = self.survey.volumes;
        let planes = if self.view.yon.is_infinite() { 5 } else { 6 };
        let saved = planes - names.len().min(planes);
        row(
            "clip",
            if names.is_empty() { "none".into() } else { names.join(", ") },
            format!("up to {crossing} of {volumes} bounding volumes reach over one of these planes"),
            if saved == 0 { String::new() } else { format!("{saved} of {planes} plane tests a vertex") },
        )
    }

    fn light_row(&self) -> PlanRow {
        let shading = self.choices.shading.name();
        let (vertices, lights) = (self.survey.vertices, self.survey.lights);
        if self.needs.light && self.choices.shading != Shading::Wire {
            let per = if self.choices.shading == Shading::Phong { "at every sample" } else { "at the vertices" };
            let per = if self.choices.flat == FlatRule::Sipp {
                "at the first vertex clipping leaves, mean normal"
            } else {
                per
            };
            return row("normals", "yes".into(), format!("shading is {shading}: light {per}"), String::new());
        }
        let saving = format!("normals and {lights} lights at {vertices} vertices");
        row("normals", yes_no(self.needs.light), format!("shading is {shading}: lines have no light"), saving)
    }

    fn specular_row(&self) -> PlanRow {
        let survey = &self.survey;
        let lit = self.choices.shading != Shading::Wire;
        let reason = match (lit, survey.shiny_surfaces) {
            (false, _) => "nothing is lit".to_string(),
            (true, 0) => "no surface has Ks > 0".to_string(),
            (true, shiny) => format!("{shiny} of {} surfaces have Ks > 0", survey.surfaces),
        };
        let powers = survey.matte_vertices * survey.lights;
        let saving = if lit && powers > 0 { format!("up to {powers} cosine powers") } else { String::new() };
        row("specular", yes_no(self.needs.specular), reason, saving)
    }

    fn blending_row(&self) -> PlanRow {
        let (transparent, surfaces) = (self.survey.transparent_surfaces, self.survey.surfaces);
        let reason = match transparent {
            0 => "every surface is opaque".to_string(),
            _ => format!("{transparent} of {surfaces} surfaces are transparent"),
        };
        let saving = if self.needs.blending { "" } else { "a list of layers a sample" };
        row("blending", yes_no(self.needs.blending), reason, saving.into())
    }

    fn depth_row(&self) -> PlanRow {
        let wire = self.choices.shading == Shading::Wire;
        let reason = if wire { "lines hide nothing" } else { "nearer polygons hide farther ones" };
        let saving = if self.needs.depth { "" } else { "a plane of 1/w a polygon" };
        row("depth", yes_no(self.needs.depth), reason.into(), saving.into())
    }

    fn split_row(&self) -> PlanRow {
        let many = self.survey.many_sided;
        let shading = self.choices.shading.name();
        let (decision, reason) = match self.needs.split {
            Split::All if self.choices.triangles => ("all".into(), "--triangles".into()),
            Split::All => ("all".into(), "the rasterizer takes triangles only".into()),
            Split::None if self.choices.interpolation == Interpolation::ScanLine => {
                let reason = format!("--interpolation scanline runs {shading} along scan lines over whole polygons");
                ("no".into(), reason)
            }
            Split::None => {
                ("no".into(), format!("the rasterizer takes any polygon, and {shading} varies nothing over it"))
            }
            Split::NotAffine if many == 0 => {
                ("no".into(), "no polygon of the file has more than three vertices".into())
            }
            Split::NotAffine => {
                let what = if self.choices.shading == Shading::Flat { "a picture" } else { shading };
                let reason = format!("{what} is not linear over a polygon with different values at 4 or more vertices");
                (format!("up to {many} of {} polygons", self.survey.polygons), reason)
            }
        };
        let saving = match self.needs.split {
            Split::All => String::new(),
            Split::None => format!("{} polygons stay whole", self.survey.polygons),
            Split::NotAffine => format!("{} polygons stay whole", self.survey.polygons - many),
        };
        row("split", decision, reason, saving)
    }

    /// Only where the scene has any.
    fn colors_row(&self) -> Option<PlanRow> {
        let (colored, surfaces) = (self.survey.colored_surfaces, self.survey.surfaces);
        let decision = match self.choices.shading {
            Shading::Phong => "carried to every sample",
            Shading::Gouraud | Shading::Flat => "in the light of the vertices",
            Shading::Wire => "no",
        };
        let reason = format!("the vertices of {colored} of {surfaces} surfaces have colors of their own");
        (colored > 0).then(|| row("colors", decision.into(), reason, String::new()))
    }

    /// Only where the scene has something to do with pictures.
    fn texture_row(&self) -> Option<PlanRow> {
        let survey = &self.survey;
        let (textured, surfaces) = (survey.textured_surfaces, survey.surfaces);
        if textured == 0 && !self.needs.texture {
            return None;
        }
        let reason = match (self.choices.shading, textured, survey.cut_out_surfaces) {
            (Shading::Wire, ..) => "lines show no pictures".to_string(),
            (_, 0, _) => "no surface has a picture".to_string(),
            (_, _, 0) => format!("{textured} of {surfaces} surfaces have a picture"),
            (_, _, holes) => format!("{textured} of {surfaces} surfaces have a picture, {holes} of these with holes"),
        };
        let saving = if self.needs.texture { "" } else { "planes of u and v a polygon" };
        Some(row("texture", yes_no(self.needs.texture), reason, saving.into()))
    }

    /// Only where the scene says something about it.
    fn faces_row(&self) -> Option<PlanRow> {
        let (two_sided, surfaces) = (self.survey.two_sided_surfaces, self.survey.surfaces);
        let reason = format!("{two_sided} of {surfaces} surfaces are two-sided and keep their back faces");
        let decision = match self.choices.culling {
            Culling::None => "all".to_string(),
            culling => format!("{}, or both", culling.name()),
        };
        (two_sided > 0).then(|| row("culling", decision, reason, String::new()))
    }

    fn shapes_row(&self) -> PlanRow {
        let (shapes, outside) = (self.survey.shapes, self.survey.shapes_outside);
        let by_choice = match self.choices.resolution {
            Some(resolution) => format!("resolution {resolution}"),
            None => format!("by tolerance {} px", self.choices.tolerance),
        };
        let decision = match self.survey.shapes_with_resolution {
            0 => by_choice,
            all if all == shapes => "by their own res".to_string(),
            some => format!("{some} by their own res, the others {by_choice}"),
        };
        let reason = format!("{outside} of {shapes} shapes lie outside the view");
        let saving = if outside > 0 { format!("all vertices of {outside} shapes") } else { String::new() };
        row("shapes", decision, reason, saving)
    }
}

fn row(need: &'static str, decision: String, reason: String, saving: String) -> PlanRow {
    PlanRow { need, decision, reason, saving }
}

fn yes_no(needed: bool) -> String {
    if needed { "yes".into() } else { "no".into() }
}
