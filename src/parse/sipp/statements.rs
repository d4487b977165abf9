//! Statements that hold no objects: shaders, lights, camera, background, picture size.
//!
//! Colors of shaders and of the background are display values, those of lights are light.
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide" (defaults of the camera, what `to` means).

use super::Reader;
use super::block::{Block, with_suggestion};
use super::draft::Shader;
use super::notices::Oddity;
use super::table::Parameter;
use super::trouble::Trouble;
use super::vocabulary::{self, BASIC, CAMERA, DIRECTIONAL, ON_OFF, PHONG, POINT, SPOT};
use super::words::Kind;
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Span};
use crate::math::{PI, Vec3, atan};
use crate::parse::nff::is_parallel;
use crate::parse::wording::quote;
use crate::scene::{Camera, Light, LightSource, Material, Place, Reflection, SpotEdge};

/// Width and height where no `image` says otherwise.
const DEFAULT_SIZE: (u32, u32) = (512, 512);

impl Reader<'_> {
    /// `shader NAME phong { ... }`
    pub(super) fn shader(&mut self, line: u32) -> Result<(), Trouble> {
        let name = self.words.name("a shader")?;
        let kind = self.words.expect_word("`shader NAME KIND`", "`phong` or `basic`")?.span;
        let known = match self.words.bytes(kind) {
            b"phong" => PHONG,
            b"basic" => BASIC,
            word => {
                self.words.take();
                self.skip_block();
                return Err(unknown_kind("shader", word, kind, &["phong", "basic"]).into());
            }
        };
        self.words.take();
        let block = self.block(kind, line, &[known])?;
        self.note_bright(&block);
        let texture = if block.broken { None } else { self.texture(&block)? };
        let number = |word: &str, default: f64| block.number(word).unwrap_or(default);
        let is_phong = self.words.bytes(kind) == b"phong";
        let reflection = if is_phong { Reflection::Phong } else { Reflection::Basic { c3: number("c3", 0.2) } };
        let material = Material {
            reflection,
            color: block.color("color").unwrap_or(Rgb::WHITE),
            ambient: Some(number("ambient", 0.3)),
            // `basic` has no coefficient of its own: its diffuse light counts in full.
            diffuse: if is_phong { number("diffuse", 0.6) } else { 1.0 },
            specular: number("specular", 0.3),
            shine: if is_phong { number("exponent", 20.0) } else { 0.0 },
            opacity: block.color("opacity").unwrap_or(Rgb::WHITE),
            refraction: 1.0,
            texture,
        };
        self.draft.shaders.push(Shader { name, line, material });
        Ok(())
    }

    /// `light [NAME] directional { ... }`
    pub(super) fn light(&mut self, line: u32) -> Result<(), Trouble> {
        const KINDS: [&str; 3] = ["directional", "point", "spot"];
        let mut kind = self.words.peek();
        if kind.kind == Kind::Text {
            self.words.name("a light")?;
        } else {
            self.words.expect_word("`light KIND`", "`directional`, `point` or `spot`")?;
            self.words.take();
        }
        // The first word was a name if no block follows it.
        if self.words.peek().kind == Kind::Word || kind.kind == Kind::Text {
            kind = self.words.expect_word("`light NAME KIND`", "`directional`, `point` or `spot`")?;
            self.words.take();
        }
        let known: &[Parameter] = match self.words.bytes(kind.span) {
            b"directional" => DIRECTIONAL,
            b"point" => POINT,
            b"spot" => SPOT,
            word => {
                self.skip_block();
                return Err(unknown_kind("light", word, kind.span, &KINDS).into());
            }
        };
        let block = self.block(kind.span, line, &[known])?;
        if block.broken {
            return Ok(());
        }
        let vector = |word: &str| block.vector(word).unwrap_or_default();
        let source = match self.words.bytes(kind.span) {
            b"directional" => LightSource::Directional { to_light: vector("to") },
            b"point" => LightSource::Point { position: vector("at") },
            _ => self.spot(&block)?,
        };
        let color = block.color("color").unwrap_or(Rgb::WHITE);
        self.draft.lights.push(Light { source, color, intensity: Some(1.0), place: Place { file: 0, line } });
        Ok(())
    }

    fn spot(&mut self, block: &Block) -> Result<LightSource, Trouble> {
        let vector = |word: &str| block.vector(word).unwrap_or_default();
        let (position, at) = (vector("from"), vector("at"));
        if position == at {
            let error = Diagnostic::error("the spot shines nowhere: `from` and `at` are the same point");
            return Err(error.at(block.place("at"), "the same as `from`").help("move one of them").into());
        }
        if self.words.bytes(block.place("shadow")) == b"on" {
            self.notices.note(Oddity::NoShadows, block.place("shadow"));
        }
        let is_soft = self.words.bytes(block.place("edge")) == b"soft";
        let edge = if is_soft { SpotEdge::Soft } else { SpotEdge::Sharp };
        Ok(LightSource::Spot { position, at, opening: block.number("opening").unwrap_or(90.0), edge })
    }

    /// `camera [NAME] { ... }`
    pub(super) fn camera(&mut self, keyword: Span, line: u32) -> Result<(), Trouble> {
        if matches!(self.words.peek().kind, Kind::Word | Kind::Text) {
            self.words.name("a camera")?;
        }
        let block = self.block(keyword, line, &[CAMERA])?;
        if block.broken {
            return Ok(());
        }
        let camera = self.camera_of(&block)?;
        self.replaced(keyword, Oddity::CameraReplaced);
        self.draft.camera = Some(camera);
        Ok(())
    }

    fn camera_of(&mut self, block: &Block) -> Result<Camera, Trouble> {
        let default = default_camera();
        let vector = |word: &str, default: Vec3| block.vector(word).unwrap_or(default);
        let (from, at, up) = (vector("from", default.from), vector("at", default.at), vector("up", default.up));
        if from == at {
            let error = Diagnostic::error("the camera looks nowhere: `from` and `at` are the same point");
            let place = if block.has("at") { "at" } else { "from" };
            return Err(error.at(block.place(place), "").help("move one of them").into());
        }
        if let (Some(focal), Some(angle)) = (block.find("focal"), block.find("angle")) {
            let error = Diagnostic::error("both `focal` and `angle` say how wide the camera sees");
            let error = error.at(angle.keyword, "this").at(focal.keyword, "and this");
            return Err(error.help("keep one: focal is the tangent of half the angle").into());
        }
        let angle = block.number("focal").map_or(default.angle, angle_of_focal);
        let angle = block.number("angle").unwrap_or(angle);
        let distance = (at - from).length();
        let hither = block.number("hither").unwrap_or(distance / 100.0);
        let yon = block.number("yon");
        if hither <= 0.0 {
            self.notices.note(Oddity::NoHither, block.place("hither"));
        }
        let nearest = if hither > 0.0 { hither } else { distance / 1000.0 };
        if yon.is_some_and(|yon| yon <= nearest) {
            let error = Diagnostic::error(format!("`yon` must be beyond `hither`, which is {nearest}"));
            return Err(error
                .at(block.place("yon"), "not beyond it")
                .help("leave it out to see infinitely far")
                .into());
        }
        if is_parallel(up, at - from) {
            self.notices.note(Oddity::UpAlongView, block.keyword);
        }
        let place = Place { file: 0, line: block.line };
        Ok(Camera { from, at, up, angle, hither, yon, resolution: DEFAULT_SIZE, place })
    }

    /// `background R G B`
    pub(super) fn background(&mut self, keyword: Span) -> Result<(), Trouble> {
        let start = self.words.peek().span;
        let color = self.words.vector("`background R G B`")?;
        let color = Rgb::new(color.x, color.y, color.z);
        if color.to_array().iter().any(|&channel| channel < 0.0) {
            let error = Diagnostic::error("a color cannot be negative").at(start, "in this color");
            return Err(error.help("red, green and blue are numbers from 0 to 1").into());
        }
        if color.to_array().iter().any(|&channel| channel > 1.0) {
            self.notices.note(Oddity::BrightColor, start);
        }
        self.replaced(keyword, Oddity::BackgroundReplaced);
        self.draft.background = Some(color);
        Ok(())
    }

    /// `two_sided on`, for the whole file.
    pub(super) fn two_sided(&mut self, keyword: Span) -> Result<(), Trouble> {
        let on = self.on_off("two_sided")?;
        self.replaced(keyword, Oddity::TwoSidedReplaced);
        self.draft.two_sided = on;
        Ok(())
    }

    /// `on` or `off`.
    pub(super) fn on_off(&mut self, owner: &str) -> Result<bool, Trouble> {
        let token = self.words.expect_word(&format!("`{owner}`"), "`on` or `off`")?;
        let word = self.words.bytes(token.span);
        if !ON_OFF.iter().any(|known| known.as_bytes() == word) {
            let error = Diagnostic::error(format!("{} where `{owner}` has `on` or `off`", quote(word)));
            return Err(error.at(token.span, "expected `on` or `off`").into());
        }
        self.words.take();
        Ok(word == b"on")
    }

    /// `image W H`
    pub(super) fn image(&mut self, keyword: Span) -> Result<(), Trouble> {
        let mut sides = [0; 2];
        for side in &mut sides {
            let span = self.words.peek().span;
            let number = self.words.number("`image WIDTH HEIGHT`")?;
            if number.fract() != 0.0 || !(1.0..=f64::from(u32::MAX)).contains(&number) {
                let message = format!("a picture cannot be {number} pixels wide or high");
                let error = Diagnostic::error(message).at(span, "expected a whole number from 1 up");
                return Err(error.help("write width and height in pixels: `image 512 512`").into());
            }
            *side = number as u32;
        }
        self.replaced(keyword, Oddity::ImageReplaced);
        self.draft.image = Some((sides[0], sides[1]));
        Ok(())
    }

    /// Counts the statement before this one of the same kind, if there was one.
    fn replaced(&mut self, keyword: Span, oddity: Oddity) {
        match self.last_of_kind.iter_mut().find(|(known, _)| *known == oddity) {
            Some((_, last)) => {
                let earlier = std::mem::replace(last, keyword);
                self.notices.note(oddity, earlier);
            }
            None => self.last_of_kind.push((oddity, keyword)),
        }
    }

    fn note_bright(&mut self, block: &Block) {
        if block.find("color").is_some_and(|color| color.numbers.iter().any(|&channel| channel > 1.0)) {
            self.notices.note(Oddity::BrightColor, block.place("color"));
        }
    }
}

/// SIPP's own camera, for scenes without one.
pub(super) fn default_camera() -> Camera {
    Camera {
        from: Vec3::new(0.0, 0.0, 10.0),
        at: Vec3::ZERO,
        up: Vec3::Y,
        angle: angle_of_focal(0.25),
        hither: 0.1,
        yon: None,
        resolution: DEFAULT_SIZE,
        place: Place::default(),
    }
}

/// Full opening in degrees; SIPP's focal is the tangent of half of it.
fn angle_of_focal(focal: f64) -> f64 {
    2.0 * atan(focal) * (180.0 / PI)
}

/// A kind of shader or light that is not known.
fn unknown_kind(owner: &str, word: &[u8], span: Span, known: &[&str]) -> Diagnostic {
    if let Some((what, help)) = vocabulary::foreign(word) {
        return Diagnostic::error(format!("{} is {what}", quote(word))).at(span, "not in farop").help(help);
    }
    let error = Diagnostic::error(format!("there is no {owner} of the kind {}", quote(word)));
    with_suggestion(error.at(span, "not known"), word, known)
}
