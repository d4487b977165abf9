//! Events: what happens to the window, as values; and a notation for them, so that a picture can be made without one.
//!
//! window, `--keys` -EVENT-> state
//!
//! Why characters and not places on the keyboard: a student in Lisbon and one in Zurich press different places for `,`,
//! and the help names the letter.

/// A key that was pressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// A key with a letter on it, as typed.
    Letter(char),
    /// Arrow.
    Left,
    /// Arrow.
    Right,
    /// Arrow.
    Up,
    /// Arrow.
    Down,
    /// Up a page.
    PageUp,
    /// Down a page.
    PageDown,
    /// To the first.
    Home,
    /// To the last.
    End,
    /// Away.
    Escape,
    /// Help.
    F1,
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A key went down.
    Key(Key),
    /// The pointer is over this pixel.
    Pointer(i32, i32),
    /// The button of the pointer went down or up.
    Button(bool),
    /// The wheel turned; positive: away from the user.
    Wheel(f64),
    /// The window has another size.
    Size(u32, u32),
    /// So many seconds passed.
    Time(f64),
}

/// Why `--keys` cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{word}` is no key: write letters as they are, and in angle brackets {NAMED}, at:X,Y, press, release, wheel:N, \
     size:WxH, time:SECONDS or lt; behind `*` how often, as in <right*5>"
)]
pub struct KeysError {
    /// What was found.
    pub word: String,
}

const NAMED: &str = "left, right, up, down, pgup, pgdn, home, end, esc, f1, space";

/// Reads a line of keys: letters as they are, others by name, as in `s2<right*5><at:40,30>i`.
///
/// # Errors
/// [`KeysError`] names the first word that means nothing.
///
/// ```
/// use farop::view::{Event, Key, read_keys};
/// let events = read_keys("s<right*2><at:3,4>").expect("all known");
/// let (s, right) = (Event::Key(Key::Letter('s')), Event::Key(Key::Right));
/// assert_eq!(events, [s, right.clone(), right, Event::Pointer(3, 4)]);
/// assert!(read_keys("<rihgt>").is_err());
/// ```
pub fn read_keys(text: &str) -> Result<Vec<Event>, KeysError> {
    let mut events = Vec::new();
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        rest = &rest[letter.len_utf8()..];
        if letter != '<' {
            events.push(Event::Key(Key::Letter(letter)));
            continue;
        }
        let (word, behind) = rest.split_once('>').ok_or_else(|| KeysError { word: format!("<{rest}") })?;
        rest = behind;
        let (name, count) = word.split_once('*').unwrap_or((word, "1"));
        let event = named(name).zip(count.parse::<usize>().ok().filter(|&count| count <= 100_000));
        let (event, count) = event.ok_or_else(|| KeysError { word: format!("<{word}>") })?;
        events.extend(std::iter::repeat_n(event, count));
    }
    Ok(events)
}

fn named(word: &str) -> Option<Event> {
    let key = match word {
        "left" => Key::Left,
        "right" => Key::Right,
        "up" => Key::Up,
        "down" => Key::Down,
        "pgup" => Key::PageUp,
        "pgdn" => Key::PageDown,
        "home" => Key::Home,
        "end" => Key::End,
        "esc" => Key::Escape,
        "f1" => Key::F1,
        "space" => Key::Letter(' '),
        "lt" => Key::Letter('<'),
        "press" => return Some(Event::Button(true)),
        "release" => return Some(Event::Button(false)),
        _ => return valued(word),
    };
    Some(Event::Key(key))
}

fn valued(word: &str) -> Option<Event> {
    let (name, value) = word.split_once(':')?;
    let finite = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
    match name {
        "at" => {
            let (x, y) = value.split_once(',')?;
            Some(Event::Pointer(x.parse().ok()?, y.parse().ok()?))
        }
        "size" => {
            let (width, height) = value.split_once('x')?;
            Some(Event::Size(width.parse().ok()?, height.parse().ok()?))
        }
        "wheel" => finite(value).map(Event::Wheel),
        "time" => finite(value).filter(|&seconds| seconds >= 0.0).map(Event::Time),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_has_a_name_is_read() {
        let keys = "a <lt><esc><time:0.5><size:4x3><press><release><wheel:-1>";
        let events = read_keys(keys).expect("all are known");
        assert_eq!(events.len(), 9);
        assert_eq!(events[2], Event::Key(Key::Letter('<')));
        assert_eq!(events[4..6], [Event::Time(0.5), Event::Size(4, 3)]);
        for name in NAMED.split(", ") {
            assert_eq!(read_keys(&format!("<{name}>")).map(|events| events.len()), Ok(1), "{name}");
        }
    }

    #[test]
    fn what_means_nothing_is_named() {
        for keys in ["<", "a<left", "<at:1>", "<time:-1>", "<time:nan>", "<left*x>", "<left*100001>", "<>"] {
            let error = read_keys(keys).expect_err(keys).to_string();
            assert!(error.contains('<') && error.contains("pgup"), "{error}");
        }
    }
}
