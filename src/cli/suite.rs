//! `farop suite`: a set of screen files for a lab, from easy to hard, with expected pictures and readers to hand out.
//!
//! For every scene five files: its largest polygon, a few polygons, all of it flat, Gouraud, Phong. Numbers run from easy to
//! hard over all scenes. The same scenes, options and seed give the same bytes. The probes of a lab: [`super::lab_suite`].

use super::dump::{DumpFormat, sheet};
use super::error::{self, CliError};
use super::options::PictureOptions;
use super::scenes::{SceneOptions, make_plan};
use crate::image::save::SaveError;
use crate::image::{encode_for, save};
use crate::plan::{Choices, Shading};
use crate::raster::{Registry, ZBuffer};
use crate::render::{self, Canvas};
use crate::scene::Scene;
use crate::screen::file::READERS;
use crate::screen::{DrawList, ScreenPolygon};
use clap::Args;
use sha2::{Digest, Sha256};
use std::path::{Path, PathBuf};

/// A set of screen files for a lab, with expected pictures and readers
#[derive(Args)]
#[command(
    after_help = "Examples:\n  farop suite spd:gears:1 spd:teapot:4 --size 128 -o lab1\n  farop suite zbuffer -o probes"
)]
pub(super) struct SuiteCommand {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Folder to write; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// Picks the few polygons
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Of a lab: the probes that students do not have, picked by the seed
    #[arg(long)]
    hidden: bool,
    #[command(flatten)]
    format: DumpFormat,
    #[command(flatten)]
    picture: PictureOptions,
}

/// What one file of the set exercises, from easy to hard.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Exercise {
    One,
    Few,
    Flat,
    Gouraud,
    Phong,
}

impl Exercise {
    const ALL: [Exercise; 5] = [Exercise::One, Exercise::Few, Exercise::Flat, Exercise::Gouraud, Exercise::Phong];

    fn name(self) -> &'static str {
        ["one", "few", "flat", "gouraud", "phong"][self as usize]
    }

    fn sentence(self) -> &'static str {
        [
            "one polygon, one color: which samples it covers, the tie rule",
            "a few polygons of one color each: order, depth, overlap",
            "the whole scene, one color a polygon: shared edges, depth",
            "the whole scene, colors interpolated: perspective-correct Gouraud",
            "the whole scene, normals interpolated: light at every sample (Phong)",
        ][self as usize]
    }

    fn shading(self) -> Shading {
        match self {
            Exercise::One | Exercise::Few | Exercise::Flat => Shading::Flat,
            Exercise::Gouraud => Shading::Gouraud,
            Exercise::Phong => Shading::Phong,
        }
    }
}

/// Polygons in a "few" file.
const FEW: usize = 12;

impl SuiteCommand {
    pub fn run(self, _registry: &Registry) -> Result<(), CliError> {
        if let [name] = self.scenes.scenes.as_slice()
            && let Some(lab) = crate::grade::labs::find(name)
            && !Path::new(name).exists()
        {
            let (seed, triangles) = (self.seed, self.picture.choices().triangles);
            let lab = if self.hidden { lab.hidden() } else { *lab };
            return super::lab_suite::write(&lab, &self.output, &self.format, (seed, triangles));
        }
        if self.hidden {
            return Err(CliError::failed(
                "--hidden is for the name of a lab (`farop list labs`): scenes have no probes",
            ));
        }
        // Read everything before the first folder is made: a bad scene leaves nothing behind.
        let mut scenes = Vec::new();
        for name in &self.scenes.scenes {
            let scene = self.scenes.only(name).load(&self.picture)?.scene;
            make_plan(&scene, &self.picture, None)?;
            scenes.push((stem(name), scene));
        }
        let expected = self.output.join("expected");
        make_folder(&self.output)?;
        make_folder(&expected)?;
        let mut entries = Vec::new();
        for exercise in Exercise::ALL {
            // A classic file has no normals to interpolate.
            if exercise == Exercise::Phong && self.format.is_classic() {
                continue;
            }
            for (name, scene) in &scenes {
                let file = format!("{:02}-{name}-{}", entries.len() + 1, exercise.name());
                entries.push(self.write(&file, scene, exercise)?);
            }
        }
        for (name, text) in READERS {
            save::write_whole(&self.output.join(name), text.as_bytes())?;
        }
        let manifest = self.manifest(&entries);
        save::write_whole(&self.output.join("manifest.json"), format!("{manifest:#}\n").as_bytes())?;
        error::print(&format!(
            "{} screen files in {}, expected pictures in {}\n",
            entries.len(),
            self.output.display(),
            expected.display()
        ))
    }

    /// Writes one screen file and its picture; returns its entry in the manifest.
    fn write(&self, name: &str, scene: &Scene, exercise: Exercise) -> Result<serde_json::Value, CliError> {
        let choices = Choices { shading: exercise.shading(), ..self.picture.choices() };
        let mut list = render::list(scene, &choices, None)?;
        match exercise {
            Exercise::One => keep_largest(&mut list),
            Exercise::Few => keep_few(&mut list, self.seed),
            _ => {}
        }
        let mut text = Vec::new();
        self.format.write_to(&mut text, &list, &sheet(scene, &choices)).map_err(CliError::failed)?;
        let file = self.output.join(format!("{name}.scr"));
        save::write_whole(&file, &text)?;
        let picture = render::draw(&list, Some(&ZBuffer), &Canvas::new(scene, &choices)).0.encode(choices.encoding);
        let picture_file = self.output.join("expected").join(format!("{name}.png"));
        let png = encode_for(&picture_file, &picture).map_err(CliError::failed)?;
        save::write_whole(&picture_file, &png)?;
        Ok(serde_json::json!({
            "file": format!("{name}.scr"),
            "expected": format!("expected/{name}.png"),
            "exercises": exercise.sentence(),
            "shading": choices.shading.name(),
            "polygons": list.len(),
            "vertices": list.vertices.len(),
            "width": picture.width(),
            "height": picture.height(),
            "sha256": hash(&text),
            "picture_sha256": hash(picture.rgb()),
        }))
    }

    fn manifest(&self, entries: &[serde_json::Value]) -> serde_json::Value {
        let choices = self.picture.choices();
        let names: Vec<_> = self.scenes.scenes.iter().map(|name| stem(name)).collect();
        serde_json::json!({
            "schema": 1,
            "format": if self.format.is_classic() { "classic" } else { "v2" },
            "scenes": names,
            "seed": self.seed,
            "options": {
                "samples": choices.samples,
                "subpixel_bits": match choices.subpixel_bits {
                    crate::plan::EXACT_SUBPIXELS => serde_json::Value::from("exact"),
                    bits => bits.into(),
                },
                "triangles": choices.triangles,
                "culling": choices.culling.name(),
                "depth": choices.depth.name(),
                "encoding": choices.encoding.name(),
                "interpolation": choices.interpolation.name(),
            },
            "note": "picture_sha256 is of the decoded pixels: red, green, blue, rows from the top",
            "files": entries,
        })
    }
}

pub(super) fn make_folder(path: &Path) -> Result<(), CliError> {
    let made = if path.is_dir() { Ok(()) } else { std::fs::create_dir(path) };
    made.map_err(|error| CliError::from(SaveError::at(path, error)))
}

/// A file name's middle: `spd:gears:4` gives `gears-4`, `scenes/a.nff` gives `a`.
fn stem(name: &str) -> String {
    let text = name.strip_prefix("spd:").unwrap_or(name);
    let file = Path::new(text).file_name().map_or(text.to_string(), |name| name.to_string_lossy().into_owned());
    let base = file.split('.').next().unwrap_or("scene").replace(':', "-");
    base.chars()
        .map(|letter| if letter.is_alphanumeric() || letter == '-' || letter == '_' { letter } else { '_' })
        .collect()
}

pub(super) fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Leaves the polygon with the largest area on the screen; the first of equals.
fn keep_largest(list: &mut DrawList) {
    let area = |polygon: &ScreenPolygon<'_>| {
        let twice = |(a, b): (&crate::screen::ScreenVertex, &crate::screen::ScreenVertex)| a.x * b.y - b.x * a.y;
        crate::math::edges(polygon.vertices()).map(twice).sum::<f64>().abs()
    };
    let larger = |best: (usize, f64), next: (usize, f64)| if next.1 > best.1 { next } else { best };
    let areas = list.polygons().map(|polygon| area(&polygon)).enumerate();
    let largest = areas.reduce(larger).map(|(index, _)| list.polygons[index]);
    list.polygons = largest.into_iter().collect();
    list.compact();
}

/// Leaves [`FEW`] polygons that the seed picks, in scene order.
fn keep_few(list: &mut DrawList, seed: u64) {
    let mut state = seed;
    // A stable order of polygons by a hash of seed and position (splitmix64), the smallest first.
    let mut ranked: Vec<(u64, usize)> = (0..list.len()).map(|index| (splitmix(&mut state), index)).collect();
    ranked.sort_unstable();
    let mut chosen: Vec<_> = ranked.iter().take(FEW).map(|&(_, index)| index).collect();
    chosen.sort_unstable();
    list.polygons = chosen.into_iter().map(|index| list.polygons[index]).collect();
    list.compact();
}

/// Source: Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
fn splitmix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut mixed = *state;
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}
