//! Too many or too few numbers: says how many were announced, how many are there, and where they end.

use super::explain::Explain;
use super::grammar::{Corners, Wanted};
use super::wording::{arity, fields_in_order, name, shape, vertices};
use crate::diagnostic::Diagnostic;
use crate::parse::tokens::{self, count_numbers, count_words};
use crate::parse::wording::{ordinal, plain};

impl Explain<'_> {
    /// More numbers than the statement takes, from `rest` on.
    pub(super) fn too_many(&self, statement: &[u8], rest: &[u8], corners: &Corners) -> Diagnostic {
        let keyword = tokens::word(statement);
        let extra = count_numbers(rest);
        let span = self.span_of_word(rest);
        let per_vertex = if keyword == b"pp" { 6 } else { 3 };
        if let (b"p" | b"pp", Some(declared)) = (keyword, corners.declared) {
            let all = corners.positions.len() + extra / per_vertex;
            let (message, help) = if extra.is_multiple_of(per_vertex) {
                let message = format!("{} declares {} but {all} follow", name(keyword), vertices(declared));
                (message, format!("write `{} {all}`, or remove what is too much", plain(keyword)))
            } else {
                let message = format!("{} of {} goes on for {extra} more", name(keyword), vertices(declared));
                (
                    message + if extra == 1 { " number" } else { " numbers" },
                    "remove what is too much, or add what is missing".to_string(),
                )
            };
            let error = Diagnostic::error(message).at(span, "a keyword should follow here");
            return error.at(self.declaration(statement), "declared here").help(help);
        }
        let found = count_numbers(&statement[keyword.len()..]);
        let error = match keyword {
            b"v" => Diagnostic::error("a view ends after its resolution, two whole numbers"),
            _ => Diagnostic::error(format!("`{}` takes {} numbers but {found} follow", plain(keyword), arity(keyword))),
        };
        let help = match keyword {
            b"f" => "a 9th value (ambient light or a texture, for some readers) is not NFF: remove it".to_string(),
            _ => format!("write {}", shape(keyword)),
        };
        let label = if keyword == b"l" { "too many, or too few for a color" } else { "too many from here on" };
        error.at(span, label).help(help)
    }

    /// The statement ends, at the next keyword or the end of the text, before it is complete.
    pub(super) fn too_few(&self, statement: &[u8], tail: &[u8], (wanted, corners): (Wanted, &Corners)) -> Diagnostic {
        let keyword = tokens::word(statement);
        let span = self.span_of_word(tail);
        let ends = if tail.is_empty() { "the file ends here: " } else { "" };
        if let (b"p" | b"pp", Some(declared)) = (keyword, corners.declared) {
            return self.too_few_vertices(statement, tail, (declared, corners));
        }
        let (message, expected, help) = match (keyword, wanted) {
            (b"p" | b"pp", _) => {
                let message = format!("{} does not say how many vertices it has", name(keyword));
                (message, "expected a whole number".to_string(), format!("write {}", shape(keyword)))
            }
            (b"v", Wanted::Field(field)) => {
                (format!("a view without `{field}`"), format!("expected `{field}`"), fields_in_order())
            }
            (b"v", _) => ("a view ends in the middle of a field".into(), "expected a number".into(), fields_in_order()),
            _ => {
                let found = count_words(statement, tail) - 1;
                let message = format!("`{}` takes {} numbers but only {found}", plain(keyword), arity(keyword));
                let message = message + if found == 1 { " follows" } else { " follow" };
                (message, "expected a number".to_string(), format!("write {}", shape(keyword)))
            }
        };
        let error = Diagnostic::error(message).at(span, format!("{ends}{expected}"));
        error.at(self.span_of_word(statement), "starts here").help(help)
    }

    fn too_few_vertices(&self, statement: &[u8], tail: &[u8], (declared, corners): (i64, &Corners)) -> Diagnostic {
        let keyword = tokens::word(statement);
        let found = corners.positions.len();
        // Words behind the keyword and the count that belong to whole vertices; what is left is a vertex cut short.
        let (per_vertex, numbers) =
            if keyword == b"pp" { (6, "six numbers, `x y z nx ny nz`") } else { (3, "three numbers, `x y z`") };
        let left_over = count_words(statement, tail).saturating_sub(2 + found * per_vertex);
        let next = ordinal(found + 1);
        let expected = match left_over {
            0 => format!("expected the {next} vertex: {numbers}"),
            _ => format!("the {next} vertex has only {left_over} of {numbers}"),
        };
        let ends = if tail.is_empty() { "the file ends here: " } else { "" };
        let message = format!("{} declares {} but only {found}", name(keyword), vertices(declared));
        let message = message + if found == 1 { " follows" } else { " follow" };
        let missing = if declared - found as i64 == 1 { "vertex" } else { "vertices" };
        let above = if tail.is_empty() {
            "at the end".to_string()
        } else {
            format!("above line {}", self.source.line(self.span_of_word(tail).start))
        };
        let help = match (left_over, found) {
            (0, 3..) => format!("write `{} {found}`, or add the missing {missing} {above}", plain(keyword)),
            _ => format!("add the missing {missing} {above}"),
        };
        // The place of the mistake is the declaration: that is the line to look at first.
        let error = Diagnostic::error(message).at(self.declaration(statement), "declared here");
        error.at(self.span_of_word(tail), format!("{ends}{expected}")).help(help)
    }
}
