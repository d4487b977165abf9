//! The window itself: forwards what happens, shows the board. Everything else is in [`crate::view`].
//!
//! Why a callback for keys: asking each frame which keys are down loses those that are shorter than a frame.

use super::shell::Shell;
use crate::view::{Event, Key};
use minifb::{InputCallback, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Instant;

/// Seconds between looks at the scene's file.
const LOOK: f64 = 0.5;

/// Keys since the last frame, in order.
struct Keys(Rc<RefCell<Vec<Event>>>);

impl InputCallback for Keys {
    fn add_char(&mut self, letter: u32) {
        let letter = char::from_u32(letter).filter(|letter| !letter.is_control());
        self.0.borrow_mut().extend(letter.map(|letter| Event::Key(Key::Letter(letter))));
    }

    fn set_key_state(&mut self, key: minifb::Key, down: bool) {
        let key = match key {
            minifb::Key::Left => Key::Left,
            minifb::Key::Right => Key::Right,
            minifb::Key::Up => Key::Up,
            minifb::Key::Down => Key::Down,
            minifb::Key::PageUp => Key::PageUp,
            minifb::Key::PageDown => Key::PageDown,
            minifb::Key::Home => Key::Home,
            minifb::Key::End => Key::End,
            minifb::Key::Escape => Key::Escape,
            minifb::Key::F1 => Key::F1,
            _ => return,
        };
        self.0.borrow_mut().extend(down.then_some(Event::Key(key)));
    }
}

/// Opens a window and shows the viewer in it until somebody closes it.
pub(super) fn open(shell: &mut Shell<'_>, title: &str) -> Result<(), String> {
    let (width, height) = shell.viewer.state.size();
    let options = WindowOptions { resize: true, scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
    let window = Window::new(title, width as usize, height as usize, options);
    let mut window = window.map_err(|error| error.to_string())?;
    window.set_target_fps(60);
    let keys = Rc::new(RefCell::new(Vec::new()));
    window.set_input_callback(Box::new(Keys(keys.clone())));
    let (mut last, mut since_look, mut is_old) = (Instant::now(), 0.0, true);
    while window.is_open() {
        let seconds = last.elapsed().as_secs_f64();
        (last, since_look) = (Instant::now(), since_look + seconds);
        let mut events = happened(&window, shell);
        events.append(&mut keys.borrow_mut());
        let rate = shell.viewer.state.rate;
        is_old |= !events.is_empty() || shell.viewer.state.is_moving();
        if !shell.feed(events.into_iter().chain([Event::Time(seconds)])) {
            break;
        }
        if since_look > LOOK {
            (since_look, is_old) = (0.0, shell.look_for_changes() || is_old);
        }
        if is_old || rate != shell.viewer.state.rate {
            shell.viewer.draw();
            is_old = false;
        }
        let board = shell.viewer.board();
        window.update_with_buffer(board.pixels(), board.width(), board.height()).map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// What the pointer did, and whether the size changed.
fn happened(window: &Window, shell: &Shell<'_>) -> Vec<Event> {
    let state = &shell.viewer.state;
    let (width, height) = window.get_size();
    let size = (width as u32, height as u32);
    let pointer = window.get_mouse_pos(MouseMode::Clamp).map(|(x, y)| (x as i32, y as i32));
    let button = window.get_mouse_down(MouseButton::Left);
    let wheel = window.get_scroll_wheel().map(|(_, turns)| f64::from(turns.signum()));
    let events = [
        (size != state.size() && width > 15 && height > 15).then_some(Event::Size(size.0, size.1)),
        pointer.filter(|&pointer| pointer != state.pointer).map(|(x, y)| Event::Pointer(x, y)),
        (button != state.is_dragging).then_some(Event::Button(button)),
        wheel.filter(|&turns| turns != 0.0).map(Event::Wheel),
    ];
    events.into_iter().flatten().collect()
}
