//! The words that messages about every format are made of.

use super::tokens;
use crate::diagnostic::printable;

/// What a badly written number should have been, as a help line.
pub fn number_meant(word: &[u8]) -> Option<String> {
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

/// A word of the file for a message: safe to print, and not endless.
pub fn quote(word: &[u8]) -> String {
    format!("`{}`", plain(word))
}

/// A word of the file without quotes.
pub fn plain(word: &[u8]) -> String {
    let most = 40;
    let mut text: String = printable(&word[..word.len().min(4 * most)]).chars().take(most).collect();
    if text.len() < word.len() && word.len() > most {
        text += "...";
    }
    text
}

/// Words behind each other.
pub fn list(words: &[&str]) -> String {
    words.join(" ")
}

/// `1st`, `22nd`, `13th`.
pub fn ordinal(n: usize) -> String {
    let ending = match (n % 10, n % 100) {
        (_, 11..=13) => "th",
        (1, _) => "st",
        (2, _) => "nd",
        (3, _) => "rd",
        _ => "th",
    };
    format!("{n}{ending}")
}
