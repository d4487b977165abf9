//! Options that every picture-making command shares: text from the command line to [`Choices`] and view overrides.

use crate::color::{Encoding, Rgb};
use crate::lab::promise::Goal;
use crate::math::Vec3;
use crate::plan::{
    AlphaRule, AngleSpan, Choices, ClipLight, Culling, DepthFormat, EXACT_SUBPIXELS, FlatRule, Interpolation,
    LightTerms, NeedsMode, Shading, TextureFilter, Transparency,
};
use crate::scene::{Camera, Light, Place, Scene};
use clap::Args;

/// What the picture is made with.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
pub(super) struct PictureOptions {
    /// Size in pixels: WxH, or N for NxN [default: the scene's own]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<(u32, u32)>,
    /// flat, gouraud, phong or wire
    #[arg(short, long, value_name = "NAME", default_value = "gouraud")]
    shading: Shading,
    /// A: every pixel is the mean of A x A samples
    #[arg(long, value_name = "A", default_value_t = 1)]
    samples: u32,
    /// Silhouette error of shapes, in pixels, where the file gives no `res`
    #[arg(long, value_name = "PX", default_value_t = 0.25)]
    tolerance: f64,
    /// Fixed tessellation instead: 12 N N triangles a sphere, 8 N a cone; other shapes as with `res N`
    #[arg(long, value_name = "N", conflicts_with = "tolerance")]
    pub resolution: Option<u32>,
    /// Sub-pixel bits of screen coordinates, 0 to 16; 0 = FAROP's integers; exact = nothing snapped
    #[arg(long, value_name = "BITS", default_value = "8", value_parser = subpixel_bits)]
    subpixel_bits: u32,
    /// f32, f64, int24 or int16
    #[arg(long, value_name = "FORMAT", default_value = "f32")]
    depth: DepthFormat,
    /// back, nff (T > 0 keeps both faces) or none
    #[arg(long, value_name = "RULE", default_value = "back")]
    culling: Culling,
    /// interpolate, or relight: light cut vertices anew, as in 1996
    #[arg(long, value_name = "HOW", default_value = "interpolate")]
    clip_light: ClipLight,
    /// perspective, screen, or scanline: along edges and scan lines of whole polygons, as in 1971
    #[arg(long, value_name = "HOW", default_value = "perspective")]
    interpolation: Interpolation,
    /// Normal of flat shading: face, vertex (the first's own), or sipp: the mean one at the first vertex clipping leaves
    #[arg(long, value_name = "RULE", default_value = "face")]
    flat: FlatRule,
    /// over, or additive (SIPP's rule)
    #[arg(long, value_name = "RULE", default_value = "over")]
    transparency: Transparency,
    /// Pictures on surfaces: trilinear (mip-mapped), bilinear or nearest
    #[arg(long, value_name = "HOW", default_value = "trilinear")]
    texture_filter: TextureFilter,
    /// Surfaces with holes: coverage (as many samples as alpha says), test (all above the threshold), or paper (nothing repaired)
    #[arg(long, value_name = "RULE", default_value = "coverage")]
    alpha: AlphaRule,
    /// What alpha must be above, in place of the scene's thresholds
    #[arg(long, value_name = "N")]
    alpha_threshold: Option<f64>,
    /// srgb, or linear: numbers straight through, as in 1996
    #[arg(long, value_name = "NAME", default_value = "srgb", value_parser = encoding)]
    pub encoding: Encoding,
    /// Split every polygon into triangles
    #[arg(long)]
    triangles: bool,
    /// NFF's angle spans the picture's edges or the centers of its outer pixels
    #[arg(long, value_name = "SPAN", default_value = "edges")]
    angle: AngleSpan,
    /// derived, or full: compute also what the scene does not need
    #[arg(long, value_name = "MODE", default_value = "derived")]
    needs: NeedsMode,
    /// Refuse larger pictures
    #[arg(long, value_name = "N", default_value_t = 1 << 28)]
    pub max_pixels: u64,
    /// Threads; the picture does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
    #[command(flatten)]
    view: ViewOptions,
}

/// An error instead of the choices that make it.
#[derive(Args, Clone, Debug)]
pub(super) struct PromiseOptions {
    /// Pick shading, samples, tolerance and depth: N levels that 1 pixel in 1000 may exceed, or Npx of the outline
    #[arg(long, value_name = "N|Npx", conflicts_with_all = ["shading", "samples", "tolerance", "resolution", "depth"])]
    pub max_error: Option<Goal>,
}

/// View, light and color: the command line wins over every file.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "View and light")]
struct ViewOptions {
    /// Eye, as X,Y,Z
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    from: Option<Vec3>,
    /// Point in the middle of the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    at: Option<Vec3>,
    /// Direction that is up
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    up: Option<Vec3>,
    /// Full opening in degrees across the smaller side
    #[arg(long, value_name = "DEG", value_parser = finite, allow_hyphen_values = true)]
    angle_of_view: Option<f64>,
    /// Distance of the near plane
    #[arg(long, value_name = "D", value_parser = finite, allow_hyphen_values = true)]
    hither: Option<f64>,
    /// Distance of the far plane [default: infinitely far]
    #[arg(long, value_name = "D", value_parser = finite, allow_hyphen_values = true)]
    yon: Option<f64>,
    /// Color behind everything, 0..1
    #[arg(long, value_name = "R,G,B", value_parser = rgb)]
    background: Option<Rgb>,
    /// A light in place of the scene's; may be repeated
    #[arg(long, value_name = "X,Y,Z[,R,G,B]", value_parser = light, allow_hyphen_values = true)]
    light: Vec<Light>,
    /// Terms of the reflection model, of ambient,diffuse,specular
    #[arg(long, value_name = "TERMS", value_parser = light_terms)]
    light_terms: Option<LightTerms>,
    /// Intensity of the ambient light [default: sqrt(n)/(2n) of n lights]
    #[arg(long, value_name = "N", value_parser = not_negative)]
    ambient: Option<f64>,
    /// Intensity of every light [default: sqrt(n)/(2n) of n lights]
    #[arg(long, value_name = "N", value_parser = not_negative)]
    light_intensity: Option<f64>,
}

impl PictureOptions {
    /// The choices these options make.
    pub fn choices(&self) -> Choices {
        Choices {
            size: self.size,
            shading: self.shading,
            samples: self.samples,
            tolerance: self.tolerance,
            resolution: self.resolution,
            subpixel_bits: self.subpixel_bits,
            depth: self.depth,
            culling: self.culling,
            clip_light: self.clip_light,
            interpolation: self.interpolation,
            flat: self.flat,
            transparency: self.transparency,
            texture_filter: self.texture_filter,
            alpha: self.alpha,
            alpha_threshold: self.alpha_threshold,
            encoding: self.encoding,
            ambient: self.view.ambient,
            light_intensity: self.view.light_intensity,
            light_terms: self.view.light_terms.unwrap_or_default(),
            triangles: self.triangles,
            angle: self.angle,
            needs: self.needs,
            threads: self.threads,
            max_pixels: self.max_pixels,
        }
    }

    /// Lets the view options win over what the files said; returns a notice for each value that was there and lost.
    pub fn override_view(&self, scene: &mut Scene) -> Vec<String> {
        let view = &self.view;
        let mut replaced = Vec::new();
        // SIPP's default camera stands on no line: nobody wrote it.
        let has_camera = scene.camera.is_some_and(|camera| camera.place != Place::default());
        if scene.camera.is_none() && view.from.is_some() {
            scene.camera = Some(self.camera_from_nothing());
        }
        if let Some(camera) = &mut scene.camera {
            replace(&mut camera.from, view.from, "--from", &mut replaced);
            replace(&mut camera.at, view.at, "--at", &mut replaced);
            replace(&mut camera.up, view.up, "--up", &mut replaced);
            replace(&mut camera.angle, view.angle_of_view, "--angle-of-view", &mut replaced);
            replace(&mut camera.hither, view.hither, "--hither", &mut replaced);
            replace_if_there(&mut camera.yon, view.yon, "--yon", &mut replaced);
        }
        // What a file never said cannot lose.
        replaced.retain(|_| has_camera);
        replace_if_there(&mut scene.background, view.background, "--background", &mut replaced);
        if !view.light.is_empty() {
            replaced.extend((!scene.lights.is_empty()).then_some("--light"));
            scene.lights.clone_from(&view.light);
        }
        let notice = |option: &str| format!("{option} wins over the scene's own value");
        replaced.into_iter().map(notice).collect()
    }

    fn camera_from_nothing(&self) -> Camera {
        let (from, at, up) = (self.view.from.unwrap_or(Vec3::Z), Vec3::ZERO, Vec3::Y);
        let (angle, hither, yon, place) = (45.0, 0.0, None, Place::default());
        Camera { from, at, up, angle, hither, yon, resolution: (512, 512), place }
    }
}

fn replace<T>(value: &mut T, option: Option<T>, name: &'static str, replaced: &mut Vec<&'static str>) {
    if let Some(option) = option {
        *value = option;
        replaced.push(name);
    }
}

/// As [`replace`], for a value that the scene may not have.
fn replace_if_there<T>(value: &mut Option<T>, option: Option<T>, name: &'static str, replaced: &mut Vec<&'static str>) {
    if let Some(option) = option {
        replaced.extend(value.is_some().then_some(name));
        *value = Some(option);
    }
}

/// `WxH` or `N`.
pub(super) fn size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = text.split_once(['x', 'X']).unwrap_or((text, text));
    let number = |text: &str| {
        text.trim().parse::<u32>().map_err(|_| format!("expected WxH or N, as in 640x480; found `{text}`"))
    };
    Ok((number(width)?, number(height)?))
}

/// A number, or `exact`.
fn subpixel_bits(text: &str) -> Result<u32, String> {
    match text {
        "exact" => Ok(EXACT_SUBPIXELS),
        _ => text.parse().map_err(|_| "expected a whole number from 0 to 16, or `exact`".to_string()),
    }
}

pub(super) fn encoding(text: &str) -> Result<Encoding, String> {
    let known = [Encoding::Srgb, Encoding::Linear].into_iter().find(|encoding| encoding.name() == text);
    known.ok_or_else(|| "there is srgb, linear".to_string())
}

fn numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(finite).collect()
}

pub(super) fn finite(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().map_err(|_| format!("`{text}` is not a number"))?;
    if number.is_finite() { Ok(number) } else { Err(format!("`{text}` is not a finite number")) }
}

pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    finite(text).and_then(|number| if number >= 0.0 { Ok(number) } else { Err(format!("{number} is negative")) })
}

pub(super) fn point(text: &str) -> Result<Vec3, String> {
    match numbers(text)?[..] {
        [x, y, z] => Ok(Vec3::new(x, y, z)),
        _ => Err("expected three numbers, as in 1,-2,0.5".to_string()),
    }
}

fn rgb(text: &str) -> Result<Rgb, String> {
    match numbers(text)?[..] {
        [r, g, b] if r.min(g).min(b) >= 0.0 => Ok(Rgb::new(r, g, b)),
        _ => Err("expected three numbers from 0 to 1, as in 0.1,0.4,0.8".to_string()),
    }
}

fn light(text: &str) -> Result<Light, String> {
    let (position, color) = match numbers(text)?[..] {
        [x, y, z] => (Vec3::new(x, y, z), Rgb::WHITE),
        [x, y, z, r, g, b] if r.min(g).min(b) >= 0.0 => (Vec3::new(x, y, z), Rgb::new(r, g, b)),
        _ => return Err("expected a position, as in 6,6,6, or a position and a color, as in 6,6,6,1,1,0.5".to_string()),
    };
    Ok(Light::point(position, color, Place::default()))
}

fn light_terms(text: &str) -> Result<LightTerms, String> {
    let mut terms = LightTerms { ambient: false, diffuse: false, specular: false };
    for name in text.split(',') {
        match name.trim() {
            "ambient" => terms.ambient = true,
            "diffuse" => terms.diffuse = true,
            "specular" => terms.specular = true,
            other => return Err(format!("`{other}`: there is ambient, diffuse, specular")),
        }
    }
    Ok(terms)
}
