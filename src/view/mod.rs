//! View: everything the window shows and does, without a window.
//!
//! ```text
//! Event -STATE-> State, Action
//! State, Scene -MADE, maps, solids, flat, steps-> Board -lens, guide, panel-> Board -> window, PNG
//! ```
//!
//! Why apart from the window: what cannot be made without a display cannot be tested, nor put into a document. The window
//! (`cli::view`) forwards events and shows the board; `farop view --shot` does the same with events that are written down.
//!
//! Reading order: `event`, `state`, `mod`, then one file a thing that is shown. Nothing here opens a file or asks for the time.
//!
//! Space: the board is in pixels. Cost: one frame of the rasterizer; what did not change is kept (`made`).

pub mod board;
pub mod cut;
mod event;
pub mod eye;
mod flat;
pub mod guide;
pub mod keys;
pub mod lens;
pub mod made;
mod maps;
pub mod outside;
mod panel;
pub mod path;
mod show;
mod solids;
pub mod stages;
mod state;
pub mod steer;
mod steps;
pub mod tour;
mod words;

pub use board::Board;
pub use event::{Event, Key, KeysError, read_keys};
pub use show::{Compare, Guide, Show};
pub use state::{Action, Outside, State};

use crate::plan::{Choices, PlanError, Shading, View};
use crate::render::Canvas;
use crate::scene::Scene;
use board::ink;
use guide::Landmark;
use made::{Maker, Named, Wish};
use panel::{Place, panel};
use solids::Shown;
use stages::short;

/// What the window shows, and what it knows.
pub struct Viewer<'a> {
    /// What events change.
    pub state: State,
    maker: Maker<'a>,
    version: u64,
    landmarks: Vec<Landmark>,
    /// Board pixels a dot of a letter; `None`: more on high boards, whose pixels are small.
    pub text_size: Option<u32>,
    /// The last good picture, without overlays, and what it was made for.
    base: Board,
    base_of: Option<BaseKey>,
    stage_text: Vec<String>,
    board: Board,
    trouble: Option<String>,
    broken: Option<String>,
    said: Option<String>,
}

/// Everything that the board without overlays depends on.
type BaseKey = (Wish, Show, Option<usize>, Compare, bool, Outside);

impl<'a> Viewer<'a> {
    /// Looks at `scene`. The first of `rasterizers` draws to begin with.
    ///
    /// # Errors
    /// The scene has no usable view, or the picture is too large.
    pub fn new(scene: Scene, choices: &Choices, rasterizers: Vec<Named<'a>>) -> Result<Viewer<'a>, PlanError> {
        let own = scene.camera.ok_or(PlanError::NoCamera)?;
        let size = choices.size.unwrap_or(own.resolution);
        let choices = Choices { size: Some(size), ..choices.clone() };
        // Before memory is asked for: a size that the plan refuses has no board.
        View::new(&own, &choices)?;
        Ok(Viewer {
            state: State::new(own, choices, rasterizers.len()),
            landmarks: guide::landmarks(&scene),
            maker: Maker::new(scene, rasterizers),
            version: 0,
            text_size: None,
            base: Board::new(size.0 as usize, size.1 as usize, ink::BLACK),
            base_of: None,
            stage_text: Vec::new(),
            board: Board::default(),
            trouble: None,
            broken: None,
            said: None,
        })
    }

    /// What `event` changes; what is asked of the shell.
    pub fn handle(&mut self, event: &Event) -> Option<Action> {
        if matches!(event, Event::Key(_)) {
            self.said = None;
        }
        self.state.handle(event)
    }

    /// The scene was read again: a good one takes the place of the last, a broken one only leaves its message.
    ///
    /// The eye stays where it is, unless the scene's own view has changed.
    pub fn reload(&mut self, read: Result<Scene, String>) {
        let scene = read.and_then(|scene| match scene.camera {
            Some(own) => Ok((scene, own)),
            None => Err(PlanError::NoCamera.to_string()),
        });
        match scene {
            Ok((scene, own)) => {
                if own != self.state.own {
                    self.state.own = own;
                    self.state.eye = eye::Eye::new(&own).with_gait(self.state.eye.gait);
                }
                self.landmarks = guide::landmarks(&scene);
                self.maker.scene = scene;
                self.version += 1;
                self.broken = None;
            }
            Err(message) => self.broken = Some(message),
        }
    }

    /// Board pixels a dot of a letter.
    fn scale(&self) -> i64 {
        // On higher boards pixels are smaller than a letter's dots should be.
        const HIGH: i64 = 1400;
        self.text_size.map_or(1 + self.base.height() as i64 / HIGH, i64::from)
    }

    /// Shows a message until the next key.
    pub fn say(&mut self, message: impl Into<String>) {
        self.said = Some(message.into());
    }

    /// Why the last picture is not what was asked for: a broken scene, choices that contradict each other, a rasterizer that panicked.
    #[must_use]
    pub fn trouble(&self) -> Option<&str> {
        self.broken.as_deref().or(self.trouble.as_deref())
    }

    /// The board as it was drawn last.
    #[must_use]
    pub fn board(&self) -> &Board {
        &self.board
    }

    /// Draws what there is to see. Where that fails, the last good picture stays and [`Viewer::trouble`] says why.
    pub fn draw(&mut self) -> &Board {
        self.trouble = self.draw_base().err();
        self.board.clone_from(&self.base);
        self.draw_guide();
        self.draw_lens();
        self.draw_text();
        &self.board
    }

    /// What the picture in hand depends on.
    #[must_use]
    pub fn wish(&self) -> Wish {
        let state = &self.state;
        let mut choices = state.choices.clone();
        match state.show {
            Show::Picture => {}
            Show::Normals => {
                (choices.shading, choices.flat) = (Shading::Phong, Choices::default().flat);
            }
            // Lines have no stages, no depth and no owners.
            _ if choices.shading == Shading::Wire => choices.shading = Shading::Gouraud,
            _ => {}
        }
        Wish { camera: state.eye.camera(&state.own), choices, rasterizer: state.rasterizer, version: self.version }
    }

    fn draw_base(&mut self) -> Result<(), String> {
        let wish = self.wish();
        let State { show, compare, edges, outside, .. } = self.state;
        let key = (wish.clone(), show, self.state.step(), compare, edges, outside);
        if self.base_of.as_ref() == Some(&key) {
            return Ok(());
        }
        self.base_of = None;
        if show == Show::Picture && compare == Compare::Yours && !edges {
            // The picture alone: straight into the memory of the last one.
            let pictured = self.maker.pictured(&wish)?;
            let threads = Canvas::new(&self.maker.scene, &wish.choices).threads;
            self.base.show(&pictured.image, wish.choices.encoding, threads);
            self.stage_text.clear();
        } else {
            let (board, text, total) = self.shown(&wish)?;
            (self.base, self.stage_text) = (board, text);
            self.state.hold_step(total);
        }
        self.base_of = Some((wish, show, self.state.step(), compare, edges, outside));
        Ok(())
    }

    fn shown(&mut self, wish: &Wish) -> Result<Shown, String> {
        let (step, from) = (self.state.step(), self.state.outside);
        let maker = &mut self.maker;
        match self.state.show {
            Show::Picture => self.compared(wish),
            Show::Eye => solids::eye(&*maker.traced(wish)?, step, from),
            Show::Clip => solids::clip(&*maker.traced(wish)?, step, from),
            Show::Split => Ok(flat::split(&*maker.traced(wish)?, step, dark(maker, wish)?)),
            Show::Screen => Ok(flat::polygons(&*maker.traced(wish)?, step, dark(maker, wish)?)),
            Show::Raster => {
                let listed = maker.listed(wish)?;
                if maker.rasterizers.get(wish.rasterizer).is_some_and(|named| named.0 == "watkins") {
                    return Ok(steps::scan_line(&listed, step, bright(maker, wish)?));
                }
                let canvas = Canvas::new(&maker.scene, &wish.choices);
                steps::polygon(&listed, step, (maker.rasterizer(wish), &canvas))
            }
            Show::Depth => {
                let (board, range) = maps::depth(&*maker.samples(wish)?, &*maker.listed(wish)?);
                let said = |(far, near)| format!("distance along the view: {} to {}", short(near), short(far));
                Ok((board, range.map(said).into_iter().collect(), 0))
            }
            Show::Normals => {
                let text = "red: to the right, green: up, blue: towards the eye".to_string();
                Ok((maps::normals(&*maker.samples(wish)?, &*maker.listed(wish)?), vec![text], 0))
            }
            Show::Overdraw => {
                let (board, most) = maps::overdraw(&*maker.samples(wish)?, &*maker.listed(wish)?);
                let scale = "dark 0, blue 1, green 2, yellow 3, orange 4, red 5, white more";
                Ok((board, vec![format!("at most {most} polygons over a sample: {scale}")], 0))
            }
            Show::Polygons => {
                let listed = maker.listed(wish)?;
                let board = maps::polygons(&*maker.samples(wish)?, &listed);
                Ok((board, vec![format!("{} polygons, a color each", listed.list.len())], 0))
            }
        }
    }

    /// The picture, the reference, or where they differ; edges over it if asked for.
    fn compared(&mut self, wish: &Wish) -> Result<Shown, String> {
        let yours = bright(&mut self.maker, wish)?;
        let (mut board, text) = match self.state.compare {
            Compare::Yours => (yours, Vec::new()),
            which => {
                let reference = self.maker.reference(wish)?.image.encode(wish.choices.encoding);
                let reference = Board::of_picture(&reference);
                let differs = |(yours, right): &(&u32, &u32)| yours != right;
                let pixels = yours.pixels().iter().zip(reference.pixels());
                let count = pixels.filter(differs).count();
                let text = format!("{count} of {} pixels differ from the reference (zbuffer)", yours.pixels().len());
                let board = if which == Compare::Reference { reference } else { difference(&yours, &reference) };
                (board, vec![text])
            }
        };
        if self.state.edges {
            let wish = Wish {
                choices: Choices { shading: solid(wish.choices.shading), ..wish.choices.clone() },
                ..wish.clone()
            };
            let listed = self.maker.listed(&wish)?;
            maps::edges(&mut board, &listed.list, wish.choices.samples, ink::WHITE);
        }
        Ok((board, text, 0))
    }

    fn draw_guide(&mut self) {
        let scale = self.scale();
        if self.state.guide == Guide::Nothing || self.state.show.is_outside() {
            return;
        }
        if self.state.guide == Guide::Landmarks
            && let Ok(listed) = self.maker.listed(&self.wish())
        {
            guide::names(&mut self.board, &self.landmarks, &listed.plan.view, scale);
        }
        guide::compass(&mut self.board, &self.state.eye, scale);
    }

    fn draw_lens(&mut self) {
        let Some(pixel) = self.state.inspected.filter(|_| !self.state.show.is_outside()) else { return };
        let listed = self.maker.listed(&self.wish()).ok();
        let list = listed.as_ref().map(|listed| (&listed.list, listed.plan.choices.samples));
        let (width, height) = (self.board.width() as i64, self.board.height() as i64);
        let side = width.min(height) / 2;
        let lens = lens::lens(&self.base, list, pixel, self.state.zoom, side);
        // Not over the pixel that is asked about.
        let is_under = i64::from(pixel.0) >= width - side && i64::from(pixel.1) >= height - side;
        let left = if is_under { 0 } else { width - side };
        for y in 0..side {
            for x in 0..side {
                self.board.put(left + x, height - side + y, lens.pixel(x, y).unwrap_or(ink::BLACK));
            }
        }
        let at = (f64::from(pixel.0), f64::from(pixel.1));
        self.board.outline(
            &[(at.0 - 1.0, at.1 - 1.0), (at.0 + 1.0, at.1 - 1.0), (at.0 + 1.0, at.1 + 1.0), (at.0 - 1.0, at.1 + 1.0)],
            ink::YELLOW,
        );
    }

    fn draw_text(&mut self) {
        let scale = self.scale();
        if self.state.help {
            let letters = panel::letters(&self.board, scale);
            panel(&mut self.board, &keys::help(letters), Place::Top, (scale, ink::WHITE));
            return;
        }
        if self.state.text {
            let lines = self.text();
            panel(&mut self.board, &lines, Place::Top, (scale, ink::WHITE));
        }
        if let Some(trouble) = self.trouble() {
            let lines: Vec<String> = trouble.lines().map(String::from).collect();
            panel(&mut self.board, &lines, Place::Bottom, (scale, 0xFF_90_80));
        } else if let Some(said) = self.said.clone() {
            panel(&mut self.board, &[said], Place::Bottom, (scale, ink::YELLOW));
        }
    }
}

/// Lines have no edges of polygons to lay over.
fn solid(shading: Shading) -> Shading {
    if shading == Shading::Wire { Shading::Gouraud } else { shading }
}

fn bright(maker: &mut Maker<'_>, wish: &Wish) -> Result<Board, String> {
    let pictured = maker.pictured(wish)?;
    Ok(Board::of_picture(&pictured.image.encode(wish.choices.encoding)))
}

/// The picture as a background.
fn dark(maker: &mut Maker<'_>, wish: &Wish) -> Result<Board, String> {
    let mut board = bright(maker, wish)?;
    board.dim(176);
    Ok(board)
}

/// Red where two boards differ, the reference in the dark elsewhere.
fn difference(yours: &Board, reference: &Board) -> Board {
    let mut board = reference.clone();
    board.dim(176);
    for y in 0..reference.height() as i64 {
        for x in 0..reference.width() as i64 {
            if yours.pixel(x, y) != reference.pixel(x, y) {
                board.put(x, y, ink::RED);
            }
        }
    }
    board
}
