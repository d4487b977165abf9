//! The words that messages about NFF are made of.

use super::grammar::VIEW_FIELDS;
use crate::parse::wording::list;

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

/// `1 vertex`, `4 vertices`.
pub(super) fn vertices(count: i64) -> String {
    if count == 1 { "1 vertex".to_string() } else { format!("{count} vertices") }
}
