//! Panel: text over the board, on dark plates.
//!
//! lines -PANEL-> board
//!
//! Lines that are too long are broken; what does not fit on the board is counted instead of shown.

use super::board::{Board, ink};
use crate::lab::chart::font;

/// From one line to the next, at scale 1.
const LINE: i64 = 10;
/// Between text and the border.
const MARGIN: i64 = 3;

/// Where a panel stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Along the upper border.
    Top,
    /// Along the lower border.
    Bottom,
}

/// How many letters fit into a line of the board.
pub(super) fn letters(board: &Board, scale: i64) -> usize {
    ((board.width() as i64 - 2 * MARGIN * scale) / (font::ADVANCE as i64 * scale)).max(1) as usize
}

/// Writes lines; returns the row below them.
pub(super) fn panel(board: &mut Board, lines: &[String], place: Place, (scale, color): (i64, u32)) -> i64 {
    let most = ((board.height() as i64 - 2 * MARGIN * scale) / (LINE * scale)).max(1) as usize;
    let width = letters(board, scale);
    let mut broken: Vec<String> = lines.iter().flat_map(|line| pieces(line, width)).collect();
    if broken.len() > most {
        let hidden = broken.len() - (most - 1);
        broken.truncate(most - 1);
        broken.push(format!("... {hidden} more lines"));
    }
    if broken.is_empty() {
        return 0;
    }
    let height = broken.len() as i64 * LINE * scale + 2 * MARGIN * scale;
    let top = if place == Place::Top { 0 } else { board.height() as i64 - height };
    let longest = broken.iter().map(|line| line.chars().count()).max().unwrap_or(0) as i64;
    let right = longest * font::ADVANCE as i64 * scale + 2 * MARGIN * scale;
    board.tint((0, top), (right, top + height), ink::BLACK, 176);
    for (number, line) in broken.iter().enumerate() {
        let y = top + MARGIN * scale + number as i64 * LINE * scale;
        board.text((MARGIN * scale, y), line, scale, color);
    }
    top + height
}

/// A line in pieces of at most `width` letters, broken at blanks where there are any; continued lines are set in.
fn pieces(line: &str, width: usize) -> Vec<String> {
    let mut pieces = Vec::new();
    let mut rest: Vec<char> = line.chars().collect();
    while rest.len() > width {
        let blank = rest[1..=width].iter().rposition(|&letter| letter == ' ').map(|place| place + 1);
        let cut = blank.filter(|&cut| cut > width / 2).unwrap_or(width);
        let behind = rest.split_off(cut);
        pieces.push(rest.iter().collect());
        let behind: String = behind.iter().collect();
        let indent = if width > 8 { "  " } else { "" };
        rest = format!("{indent}{}", behind.trim_start()).chars().collect();
    }
    pieces.push(rest.iter().collect());
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_lines_are_broken_at_blanks_and_nothing_is_lost() {
        assert_eq!(pieces("short", 9), ["short"]);
        assert_eq!(pieces("the quick brown fox", 12), ["the quick", "  brown fox"]);
        assert_eq!(pieces("abcdefghij", 4), ["abcd", "efgh", "ij"]);
    }

    #[test]
    fn what_does_not_fit_is_counted() {
        let mut board = Board::new(200, 40, 0);
        let lines: Vec<String> = (0..9).map(|number| number.to_string()).collect();
        assert_eq!(panel(&mut board, &lines, Place::Top, (1, ink::WHITE)), 36);
        let mut told = Board::new(200, 40, 0);
        let shown = ["0", "1", "... 7 more lines"].map(String::from);
        panel(&mut told, &shown, Place::Top, (1, ink::WHITE));
        // Thousands of numbers are no message.
        assert!(board == told);
    }
}
