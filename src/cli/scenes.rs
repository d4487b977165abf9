//! Scene arguments: files, standard input and built-in scenes, merged from left to right.

use super::error::{self, CliError, notice};
use super::options::PictureOptions;
use crate::diagnostic::Diagnostics;
use crate::parse::{self, Format, ParseOptions, Parsed, Winding};
use crate::plan::Plan;
use crate::raster::external::External;
use crate::raster::{PutCounts, Rasterizer, Registered, Registry};
use crate::report::{StageTime, StageTimer};
use crate::scene::{NormalSource, Scene};
use crate::spd::{Curves, SpdScene, bench};
use clap::Args;
use std::path::Path;

/// Which scenes, and how their text is read.
#[derive(Args, Clone, Debug)]
pub(super) struct SceneOptions {
    /// Scene files, `-`, or built-in ones, spd:NAME[:SIZE] and bench:NAME[:SIZE]; several merge
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<String>,
    /// Format of standard input and of unknown endings
    #[arg(long, value_name = "FORMAT", value_parser = ["nff", "sipp", "ftri", "fcell"])]
    format: Option<String>,
    /// file, or auto: turn polygons round whose normals point the other way
    #[arg(long, value_name = "RULE", default_value = "file", value_parser = ["file", "auto"])]
    winding: String,
    /// Normals of NFF's `p`: facet, or smooth: the mean over the surface
    #[arg(long, value_name = "KIND", default_value = "facet", value_parser = ["facet", "smooth"])]
    normals: String,
}

/// The merged scene, with what there is to say about its reading.
pub(super) struct Loaded {
    pub scene: Scene,
    pub notices: Vec<String>,
    pub parse_time: StageTime,
}

impl SceneOptions {
    /// The same options for one scene alone.
    pub fn only(&self, name: &str) -> SceneOptions {
        SceneOptions { scenes: vec![name.to_string()], ..self.clone() }
    }

    /// The options that read one scene by its name alone.
    pub fn named(name: &str, format: Option<&str>) -> SceneOptions {
        let (winding, normals) = ("file".to_string(), "facet".to_string());
        SceneOptions { scenes: vec![name.to_string()], format: format.map(str::to_string), winding, normals }
    }

    /// Reads one scene once more and tells only how long it took.
    pub fn load_silently(&self, picture: &PictureOptions) -> Result<StageTime, CliError> {
        let timer = StageTimer::start();
        let parsed = self.parsed(&self.scenes[0], picture.resolution)?;
        let time = timer.stop();
        // Freed outside the time.
        drop(parsed);
        Ok(time)
    }

    /// Reads and merges all scenes, then lets the command line's view win.
    pub fn load(&self, picture: &PictureOptions) -> Result<Loaded, CliError> {
        let timer = StageTimer::start();
        let mut notices = Vec::new();
        let mut merged = Scene::default();
        let mut default_camera = None;
        for name in &self.scenes {
            let parsed = match super::forest::frame::of_large_pack(Path::new(name), picture)? {
                Some((scene, text)) => {
                    notice(&text);
                    notices.push(text);
                    Parsed { scene, notices: Diagnostics::default(), default_camera: None }
                }
                None => self.read(name, picture.resolution, &mut notices)?,
            };
            default_camera = parsed.default_camera.or(default_camera);
            for parameter in merged.merge(parsed.scene) {
                let text = format!("the {parameter} of {name} wins over that of the scenes before it");
                notice(&text);
                notices.push(text);
            }
        }
        // Only where nobody wrote a camera, in whatever order the scenes come.
        merged.camera = merged.camera.or(default_camera);
        let overridden = picture.override_view(&mut merged);
        overridden.iter().for_each(|text| notice(text));
        notices.extend(overridden);
        Ok(Loaded { scene: merged, notices, parse_time: timer.stop() })
    }

    fn read(&self, name: &str, resolution: Option<u32>, notices: &mut Vec<String>) -> Result<Parsed, CliError> {
        let parsed = self.parsed(name, resolution)?;
        if !parsed.notices.is_empty() {
            error::diagnose(&parsed.notices.render(error::stderr_has_color()));
            notices.extend(parsed.notices.list.iter().map(|notice| notice.message.clone()));
        }
        Ok(parsed)
    }

    fn parsed(&self, name: &str, resolution: Option<u32>) -> Result<Parsed, CliError> {
        let options = ParseOptions {
            winding: if self.winding == "auto" { Winding::Auto } else { Winding::File },
            polygon_normals: if self.normals == "smooth" { NormalSource::Averaged } else { NormalSource::Facet },
        };
        let parsed = match name.split_once(':') {
            Some(("spd", built_in)) => {
                let curves = resolution.map_or(Curves::Kept, Curves::Patches);
                parse::read_nff(name, &built_in_text(built_in, curves)?, options)
            }
            Some(("bench", built_in)) => {
                parse::scene_of_triangles(name, &bench::triangles(built_in).map_err(CliError::failed)?)
            }
            _ => parse::load(Path::new(name), self.format.as_deref().and_then(Format::by_name), options),
        };
        parsed.map_err(|errors| CliError::Diagnosed(errors.render(error::stderr_has_color())))
    }
}

/// The text of `NAME[:SIZE]`.
pub(super) fn built_in_text(built_in: &str, curves: Curves) -> Result<Vec<u8>, CliError> {
    parse::built_in::text(built_in, curves).map_err(CliError::failed)
}

/// The built-in scene of that name, or an error that lists them.
pub(super) fn find_built_in(name: &str) -> Result<&'static SpdScene, CliError> {
    parse::built_in::find(name).map_err(CliError::failed)
}

/// What follows `-r`: a rasterizer of the registry, or one outside farop.
pub(super) enum Chosen<'a> {
    Registered(&'a Registered),
    Outside(External),
}

impl Chosen<'_> {
    /// What was asked for.
    pub fn name(&self) -> &str {
        match self {
            Chosen::Registered(entry) => &entry.name,
            Chosen::Outside(external) => external.name(),
        }
    }

    /// As the driver takes it.
    pub fn rasterizer(&self) -> &dyn Rasterizer {
        match self {
            Chosen::Registered(entry) => &*entry.rasterizer,
            Chosen::Outside(external) => external,
        }
    }
}

/// The rasterizer named after `-r`; `None` for `none`.
pub(super) fn find_rasterizer<'a>(registry: &'a Registry, name: &str) -> Result<Option<Chosen<'a>>, CliError> {
    if name == "none" {
        return Ok(None);
    }
    if let Some(registered) = registry.find(name) {
        return Ok(Some(Chosen::Registered(registered)));
    }
    External::from_name(name).map(|external| Some(Chosen::Outside(external))).ok_or_else(|| {
        let names: Vec<_> = registry.iter().map(|entry| entry.name.as_str()).collect();
        CliError::failed(format!(
            "there is no rasterizer `{name}` in this program; there is {}, none\n\
             help: a rasterizer of your own runs in your own crate: `farop student new ana`, then\n      \
             `cargo run -p student_ana -- render spd:gears -r {name}`;\n      \
             one in another language is `-r exec:COMMAND` or `-r lib:PATH`",
            names.join(", ")
        ))
    })
}

/// The chosen rasterizer, as the driver takes it.
pub(super) fn as_rasterizer<'a>(chosen: &'a Option<Chosen<'_>>) -> Option<&'a dyn Rasterizer> {
    chosen.as_ref().map(Chosen::rasterizer)
}

/// Ends the command where a rasterizer outside farop gave no picture.
pub(super) fn check_drawn(puts: &PutCounts) -> Result<(), CliError> {
    puts.failure.as_ref().map_or(Ok(()), |failure| Err(CliError::failed(failure)))
}

/// The plan of `scene` for a rasterizer.
pub(super) fn make_plan(
    scene: &Scene,
    picture: &PictureOptions,
    rasterizer: Option<&dyn Rasterizer>,
) -> Result<Plan, CliError> {
    let accepts = rasterizer.map_or(crate::plan::Accepts::AnyPolygon, Rasterizer::accepts);
    Ok(Plan::new(scene, &picture.choices(), accepts)?)
}
