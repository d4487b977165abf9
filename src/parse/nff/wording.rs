//! The words that messages about NFF are made of.

use super::grammar::VIEW_FIELDS;
use crate::diagnostic::printable;
use crate::parse::tokens;

/// What a badly written number should have been, as a help line.
pub(super) fn number_meant(word: &[u8]) -> Option<String> {
    let text = printable(word).to_ascii_lowercase();
    let unsigned = text.trim_start_matches(['+', '-']);
    if unsigned.starts_with("nan") || unsigned.starts_with("inf") {
        return Some("only finite numbers make a scene; was something divided by 0 when it was written?".to_string());
    }
    if unsigned.starts_with("0x") {
        return Some("numbers are decimal".to_string());
    }
    let is_number = |text: &str| tokens::number(text.as_bytes()).is_ok();
    let with_point = text.replace(',', ".");
    if is_number(&with_point) {
        return Some(format!("the decimal sign is a point: `{with_point}`; between numbers stands a space"));
    }
    if text.split(',').all(|part| part.is_empty() || is_number(part)) {
        return Some("between numbers stands a space, no comma".to_string());
    }
    let with_e = text.replace('d', "e");
    if is_number(&with_e) {
        return Some(format!("the sign of an exponent is `e`: `{with_e}`"));
    }
    is_number(unsigned.trim_end_matches('f')).then(|| "numbers have no `f` behind them".to_string())
}

/// The help line for a view.
pub(super) fn fields_in_order() -> String {
    format!("the fields of a view, in this order: {}", list(&VIEW_FIELDS))
}

/// What a `p` or `pp` is called.
pub(super) fn name(keyword: &[u8]) -> &'static str {
    if keyword == b"pp" { "patch" } else { "polygon" }
}

/// How many numbers follow a keyword.
pub(super) fn arity(keyword: &[u8]) -> &'static str {
    match keyword {
        b"b" => "3",
        b"l" => "3 or 6",
        b"s" => "4",
        _ => "8",
    }
}

/// A statement as it should be written.
pub(super) fn shape(keyword: &[u8]) -> &'static str {
    match keyword {
        b"b" => "`b red green blue`",
        b"l" => "`l x y z` or `l x y z red green blue`",
        b"f" => "`f red green blue Kd Ks shine T index-of-refraction`",
        b"s" => "`s x y z radius`",
        b"c" => "`c x y z radius x y z radius`",
        b"p" => "`p n` and then n times `x y z`",
        b"pp" => "`pp n` and then n times `x y z nx ny nz`",
        _ => "`v from x y z at x y z up x y z angle a hither h resolution w h`",
    }
}

/// A word of the file for a message: safe to print, and not endless.
pub(super) fn quote(word: &[u8]) -> String {
    format!("`{}`", plain(word))
}

/// A word of the file without quotes.
pub(super) fn plain(word: &[u8]) -> String {
    let most = 40;
    let mut text: String = printable(&word[..word.len().min(4 * most)]).chars().take(most).collect();
    if text.len() < word.len() && word.len() > most {
        text += "...";
    }
    text
}

/// Words behind each other.
pub(super) fn list(words: &[&str]) -> String {
    words.join(" ")
}

/// `1 vertex`, `4 vertices`.
pub(super) fn vertices(count: i64) -> String {
    if count == 1 { "1 vertex".to_string() } else { format!("{count} vertices") }
}

/// `1st`, `22nd`, `13th`.
pub(super) fn ordinal(n: usize) -> String {
    let ending = match (n % 10, n % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{n}{ending}")
}
