//! State: everything that keys and pointer change; events in, state and now and then an action out.
//!
//! Event + STATE -> STATE, Action; STATE -> what is drawn
//!
//! Why apart from drawing: what a key does can be tested without a picture, and the same events give the same picture with
//! and without a window. Files are not touched here: an [`Action`] asks the shell to do that.

use super::event::{Event, Key};
use super::eye::{Eye, Gait};
use super::path::Pose;
use super::show::{Compare, Guide, Show};
use crate::math::radians;
use crate::plan::{Choices, Culling, EXACT_SUBPIXELS, Shading};
use crate::scene::Camera;

/// Something only the shell can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Close the window.
    Quit,
    /// Save what is shown.
    SavePicture,
    /// Save the frame of this number.
    SaveFrame(u64),
    /// Write the path.
    SavePath,
    /// Read the path.
    LoadPath,
}

/// Where somebody stands who looks at eye space from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// Degrees round to the right.
    pub round: f64,
    /// Degrees up.
    pub up: f64,
    /// Times nearer.
    pub zoom: f64,
}

/// Everything that events change.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// What is shown.
    pub show: Show,
    /// The step in hand of every [`Show`]; `None`: all at once.
    pub steps: [Option<usize>; Show::ALL.len()],
    /// How it is made.
    pub choices: Choices,
    /// Which rasterizer.
    pub rasterizer: usize,
    /// How many there are.
    pub rasterizers: usize,
    /// Against the reference.
    pub compare: Compare,
    /// Edges over the picture.
    pub edges: bool,
    /// The camera.
    pub eye: Eye,
    /// The camera of the scene.
    pub own: Camera,
    /// The camera of those who look from outside.
    pub outside: Outside,
    /// Where the pointer is.
    pub pointer: (i32, i32),
    /// The pointer's button is down.
    pub is_dragging: bool,
    /// The pixel that is asked about.
    pub inspected: Option<(i32, i32)>,
    /// Board pixels a pixel in the lens.
    pub zoom: i32,
    /// The path recorded or read.
    pub path: Vec<Pose>,
    /// Poses are being added to the path.
    pub is_recording: bool,
    /// The next pose of the path to show.
    pub playing: Option<usize>,
    /// The number of the next frame to save.
    pub movie: Option<u64>,
    /// Help is shown.
    pub help: bool,
    /// Text is shown.
    pub text: bool,
    /// Compass and landmarks.
    pub guide: Guide,
    /// Frames a second, as far as known.
    pub rate: Option<f64>,
    frames: (u32, f64),
}

/// Degrees that an arrow turns, and that a drag over the whole board turns.
const ARROW: f64 = 5.0;
const BOARD: f64 = 180.0;
/// The longest step of time: a window that was hidden for a while does not jump.
const LONGEST: f64 = 0.25;

impl State {
    /// At the start: the picture, from the scene's own camera. `choices` has a size.
    #[must_use]
    pub fn new(own: Camera, choices: Choices, rasterizers: usize) -> State {
        State {
            show: Show::Picture,
            steps: [None; Show::ALL.len()],
            choices,
            rasterizer: 0,
            rasterizers,
            compare: Compare::Yours,
            edges: false,
            eye: Eye::new(&own),
            own,
            outside: Outside { round: 50.0, up: 25.0, zoom: 1.0 },
            pointer: (0, 0),
            is_dragging: false,
            inspected: None,
            zoom: 24,
            path: Vec::new(),
            is_recording: false,
            playing: None,
            movie: None,
            help: false,
            text: true,
            guide: Guide::Nothing,
            rate: None,
            frames: (0, 0.0),
        }
    }

    /// Width and height of the board.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        self.choices.size.unwrap_or(self.own.resolution)
    }

    /// The step in hand of what is shown.
    #[must_use]
    pub fn step(&self) -> Option<usize> {
        self.steps[self.show as usize]
    }

    /// What `event` changes, and what it asks of the shell.
    pub fn handle(&mut self, event: &Event) -> Option<Action> {
        match *event {
            Event::Key(key) => return self.press(key),
            Event::Pointer(x, y) => self.point((x, y)),
            Event::Button(down) => {
                self.is_dragging = down;
                if down && self.inspected.is_some() {
                    self.inspected = Some(self.pointer);
                }
            }
            Event::Wheel(turns) => self.nearer(turns.clamp(-8.0, 8.0)),
            Event::Size(width, height) => {
                let side = |side: u32| side.clamp(16, 16_384);
                self.choices.size = Some((side(width), side(height)));
                self.inspected = self.inspected.map(|pixel| self.inside(pixel));
            }
            Event::Time(seconds) => return self.pass(seconds),
        }
        None
    }

    fn point(&mut self, to: (i32, i32)) {
        let (dx, dy) = (f64::from(to.0) - f64::from(self.pointer.0), f64::from(to.1) - f64::from(self.pointer.1));
        self.pointer = self.inside(to);
        if self.inspected.is_some() {
            self.inspected = Some(self.pointer);
        } else if self.is_dragging {
            let per_pixel = BOARD / f64::from(self.size().0.max(self.size().1));
            self.turn(dx * per_pixel, -dy * per_pixel);
        }
    }

    fn inside(&self, (x, y): (i32, i32)) -> (i32, i32) {
        let (width, height) = self.size();
        (x.clamp(0, width as i32 - 1), y.clamp(0, height as i32 - 1))
    }

    /// Turns whatever camera is looked through, degrees.
    fn turn(&mut self, right: f64, up: f64) {
        if self.show.is_outside() {
            self.outside.round = (self.outside.round - right) % 360.0;
            self.outside.up = (self.outside.up - up).clamp(-89.0, 89.0);
        } else {
            self.playing = None;
            self.eye.turn(radians(right), radians(up));
        }
    }

    fn nearer(&mut self, steps: f64) {
        let factor = crate::math::pow(1.125, steps);
        if self.inspected.is_some() {
            self.zoom = (f64::from(self.zoom) * factor).round().clamp(4.0, 256.0) as i32;
        } else if self.show.is_outside() {
            self.outside.zoom = (self.outside.zoom * factor).clamp(0.1, 20.0);
        } else {
            self.eye.approach(1.0 / factor);
        }
    }

    fn pass(&mut self, seconds: f64) -> Option<Action> {
        self.count_frame(seconds);
        match self.playing {
            Some(next) if next < self.path.len() => {
                self.eye.pose = self.path[next];
                self.playing = Some(next + 1);
            }
            Some(_) => {
                self.playing = None;
                return None;
            }
            None => self.eye.advance(seconds.min(LONGEST)),
        }
        if self.is_recording {
            self.path.push(self.eye.pose);
        }
        let frame = self.movie?;
        self.movie = Some(frame + 1);
        Some(Action::SaveFrame(frame))
    }

    /// Frames a second, from half a second of them.
    fn count_frame(&mut self, seconds: f64) {
        self.frames = (self.frames.0 + 1, self.frames.1 + seconds);
        if self.frames.1 >= 0.5 {
            self.rate = Some(f64::from(self.frames.0) / self.frames.1);
            self.frames = (0, 0.0);
        }
    }

    /// Whether time changes what is shown.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.playing.is_some() || self.movie.is_some() || self.eye.is_moving()
    }

    fn press(&mut self, key: Key) -> Option<Action> {
        match key {
            Key::Letter(letter) => return self.letter(letter),
            Key::F1 => self.help = !self.help,
            Key::Home => self.set_step(Some(0)),
            Key::End => self.set_step(None),
            Key::Escape if self.help => self.help = false,
            Key::Escape if self.inspected.is_some() => self.inspected = None,
            Key::Escape => return Some(Action::Quit),
            Key::Left | Key::Right | Key::Up | Key::Down => self.arrow(key),
            Key::PageUp => self.eye.rise(1.0 / 32.0),
            Key::PageDown => self.eye.rise(-1.0 / 32.0),
        }
        None
    }

    fn arrow(&mut self, key: Key) {
        let (right, down) = match key {
            Key::Left => (-1, 0),
            Key::Right => (1, 0),
            Key::Up => (0, -1),
            _ => (0, 1),
        };
        if let Some((x, y)) = self.inspected {
            self.inspected = Some(self.inside((x + right, y + down)));
        } else if down != 0 && self.eye.gait != Gait::Orbit && !self.show.is_outside() {
            self.eye.steps = (self.eye.steps - down).clamp(-12, 12);
        } else {
            self.turn(ARROW * f64::from(right), -ARROW * f64::from(down));
        }
    }

    fn letter(&mut self, letter: char) -> Option<Action> {
        match letter {
            '0'..='9' => self.show = Show::of_digit(letter),
            'e' => self.edges = !self.edges,
            'x' => self.compare = next(&Compare::ALL, self.compare, true),
            'c' => self.eye.gait = next(&Gait::ALL, self.eye.gait, true),
            'v' => self.eye = Eye::new(&self.own).with_gait(self.eye.gait),
            ' ' => self.eye.steps = 0,
            'n' => self.guide = next(&Guide::ALL, self.guide, true),
            'i' => self.inspected = if self.inspected.is_some() { None } else { Some(self.pointer) },
            '+' | '=' => self.nearer(1.0),
            '-' => self.nearer(-1.0),
            '.' => self.step_by(1),
            ',' => self.step_by(-1),
            '>' => self.step_by(10),
            '<' => self.step_by(-10),
            't' => self.text = !self.text,
            'h' | '?' => self.help = !self.help,
            _ => return self.file_letter(letter),
        }
        None
    }

    fn file_letter(&mut self, letter: char) -> Option<Action> {
        match letter {
            'q' => return Some(Action::Quit),
            'f' => return Some(Action::SavePicture),
            'w' => return Some(Action::SavePath),
            'l' => return Some(Action::LoadPath),
            'm' => self.movie = if self.movie.is_some() { None } else { Some(0) },
            'o' => self.playing = if self.playing.is_some() { None } else { Some(0) },
            'p' => {
                self.is_recording = !self.is_recording;
                if self.is_recording {
                    self.path = vec![self.eye.pose];
                }
            }
            _ => self.choose(letter.to_ascii_lowercase(), letter.is_ascii_lowercase()),
        }
        None
    }

    /// The next of some choices, or the one before.
    fn choose(&mut self, letter: char, onward: bool) {
        const SAMPLES: [u32; 4] = [1, 2, 4, 8];
        const BITS: [u32; 6] = [8, 4, 2, 0, EXACT_SUBPIXELS, 16];
        let choices = &mut self.choices;
        match letter {
            's' => choices.shading = next(Shading::ALL, choices.shading, onward),
            'a' => choices.samples = next(&SAMPLES, choices.samples, onward),
            'b' => choices.culling = next(Culling::ALL, choices.culling, onward),
            'g' => choices.subpixel_bits = next(&BITS, choices.subpixel_bits, onward),
            'r' => {
                let all: Vec<_> = (0..self.rasterizers).collect();
                self.rasterizer = next(&all, self.rasterizer, onward);
            }
            _ => {}
        }
    }

    fn set_step(&mut self, step: Option<usize>) {
        self.steps[self.show as usize] = step.filter(|_| self.show.has_steps());
    }

    /// All at once stands before the first step.
    fn step_by(&mut self, by: i64) {
        let place = self.step().map_or(0, |step| step as i64 + 1) + by;
        self.set_step(usize::try_from(place - 1).ok());
    }

    /// Keeps the step in hand below `total`, which only drawing knows.
    pub fn hold_step(&mut self, total: usize) {
        let step = self.step().map(|step| step.min(total.saturating_sub(1)));
        self.set_step(step.filter(|_| total > 0));
    }
}

/// The one behind (or before) `now` in a list, round and round; the first where it is not there.
fn next<T: PartialEq + Copy>(list: &[T], now: T, onward: bool) -> T {
    let place = list.iter().position(|&entry| entry == now);
    let step = if onward { 1 } else { list.len() - 1 };
    list[place.map_or(0, |place| (place + step) % list.len())]
}
