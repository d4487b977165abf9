//! Reads SIPP's Bezier files: control points of patches, or of curves that turn about the z axis.
//!
//! Source -BEZIER-> PatchNet or CurveNet -sipp-> Shape of a Scene
//!
//! ```text
//! bezier_patches:  vertices: N  vertex_list: (x y z)*N  patches: K  patch_list: (16 indices)*K
//! bezier_curves:   vertices: N  vertex_list: (x y z)*N  curves: K   curve_list: (4 indices)*K
//! ```
//! Indices count from 1. The four of a curve stand in the file from its end to its start: a file curve runs downward
//! where SIPP's call `bezier_rotcurve`, and so [`CurveNet`], runs upward to show its front outside.
//!
//! Why no memory is reserved for N or K: a file of 40 bytes may announce 10^9 vertices. Lists grow with what is read.
//!
//! Space: the local space of the object that uses it. Cost: one pass.
//! Source: J. Yngvesson and I. Wallin, "SIPP User's Guide", on `bezier_file`.

use super::tokens;
use crate::diagnostic::{Diagnostic, Diagnostics, Source, Span, printable, suggest};
use crate::math::Vec3;
use crate::scene::{CurveNet, PatchNet};

/// What a file looks like, for help lines.
const FORM: &str = "a Bezier file is `bezier_curves: vertices: N vertex_list: ... curves: K curve_list: ...`, or the same with patches";
/// How many wrong indices of one file are told.
const MOST_ERRORS: usize = 20;

/// What a Bezier file holds.
#[derive(Clone, Debug, PartialEq)]
pub enum Net {
    /// Patches.
    Patches(PatchNet),
    /// Curves that turn about the z axis.
    Curves(CurveNet),
}

/// Reads a whole source.
///
/// # Errors
/// The first mistake of form; or up to 20 indices that point nowhere.
pub(super) fn read(source: &Source) -> Result<Net, Diagnostics> {
    let mut reader = Reader { text: &source.text, tail: tokens::skip_space(&source.text), wrong: Vec::new() };
    let result = reader.net();
    let errors = match result {
        Ok(net) if reader.wrong.is_empty() => return Ok(net),
        Ok(_) => reader.wrong,
        Err(error) => reader.wrong.into_iter().chain([error]).collect(),
    };
    Err(Diagnostics::new(source, errors))
}

/// Goes through the words of a file.
struct Reader<'a> {
    text: &'a [u8],
    /// What is left to read; starts with a word, or is empty.
    tail: &'a [u8],
    /// Mistakes that do not stop the reading.
    wrong: Vec<Diagnostic>,
}

/// A number of things that the file announces, and where.
#[derive(Clone, Copy)]
struct Declared {
    count: usize,
    at: Span,
}

impl<'a> Reader<'a> {
    fn net(&mut self) -> Result<Net, Diagnostic> {
        if self.tail.is_empty() {
            let error = Diagnostic::error("a Bezier file without a word in it").at(self.here(), "the file ends here");
            return Err(error.help("it starts with `bezier_patches:` or `bezier_curves:`"));
        }
        let is_patches = self.heading(&["bezier_patches:", "bezier_curves:"])? == 0;
        self.heading(&["vertices:"])?;
        let declared = self.declared("vertices")?;
        self.heading(&["vertex_list:"])?;
        let vertices = self.vertices(declared)?;
        let net = if is_patches {
            self.heading(&["patches:"])?;
            let declared = self.declared("patches")?;
            self.heading(&["patch_list:"])?;
            let patches = self.indices(declared, ("patch", vertices.len()))?;
            Net::Patches(PatchNet { vertices, patches })
        } else {
            self.heading(&["curves:"])?;
            let declared = self.declared("curves")?;
            self.heading(&["curve_list:"])?;
            let mut curves = self.indices(declared, ("curve", vertices.len()))?;
            // From the file's direction to that of the scene.
            curves.iter_mut().for_each(|curve: &mut [u32; 4]| curve.reverse());
            Net::Curves(CurveNet { vertices, curves })
        };
        self.end(if is_patches { "patch" } else { "curve" })?;
        Ok(net)
    }

    /// Reads one of the words of `known` and returns which.
    fn heading(&mut self, known: &[&'static str]) -> Result<usize, Diagnostic> {
        let word = self.word();
        if let Some(index) = known.iter().position(|known| known.as_bytes() == word) {
            self.skip(word.len());
            return Ok(index);
        }
        let expected = known.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" or ");
        if word.is_empty() {
            let error = Diagnostic::error(format!("the file ends before {expected}"));
            return Err(error.at(self.here(), "expected here").help(FORM));
        }
        let error = Diagnostic::error(format!("expected {expected} but found {}", self.quoted()));
        let error = error.at(self.here(), "not expected here");
        if tokens::looks_numeric(word) {
            return Err(error.help("there are more numbers than announced: remove them, or correct the count above"));
        }
        // A colon too few is one mistake in the word, and a blank before the colon too.
        let spelled = printable(word);
        Err(match suggest(&spelled, known).or(suggest(&format!("{spelled}:"), known)) {
            Some(similar) => error.help(format!("did you mean `{similar}`? The colon belongs to the word")),
            None => error.help(FORM),
        })
    }

    /// Reads how many there are.
    fn declared(&mut self, what: &str) -> Result<Declared, Diagnostic> {
        let (word, at) = (self.word(), self.here());
        let count = whole_number(word).filter(|&count| count > 0);
        let Some(count) = count else {
            let error = Diagnostic::error(format!("the number of {what} is {}", self.quoted()));
            return Err(error.at(at, "expected a whole number above 0"));
        };
        self.skip(word.len());
        Ok(Declared { count: usize::try_from(count).unwrap_or(usize::MAX), at })
    }

    fn vertices(&mut self, declared: Declared) -> Result<Vec<Vec3>, Diagnostic> {
        let mut vertices = Vec::new();
        while vertices.len() < declared.count {
            let mut position = [0.0; 3];
            for (axis, coordinate) in position.iter_mut().enumerate() {
                *coordinate = self.coordinate((vertices.len(), axis), declared)?;
            }
            vertices.push(Vec3::from_array(position));
        }
        Ok(vertices)
    }

    fn coordinate(&mut self, (vertex, axis): (usize, usize), declared: Declared) -> Result<f64, Diagnostic> {
        let word = self.word();
        match tokens::number(word) {
            Ok(number) => {
                self.skip(word.len());
                Ok(number.value)
            }
            Err(_) if tokens::looks_numeric(word) => {
                let error = Diagnostic::error(format!("{} is not a number", self.quoted()));
                let axis = ["x", "y", "z"][axis];
                let error = error.at(self.here(), format!("expected {axis} of vertex {}", vertex + 1));
                Err(error.help("numbers are decimal and finite, like `-0.5` or `1e-3`"))
            }
            Err(_) => {
                let found = if axis == 0 {
                    format!("only {vertex} follow")
                } else {
                    format!("vertex {} has only {axis} of its three numbers", vertex + 1)
                };
                Err(self.too_few(format!("{} vertices are announced but {found}", declared.count), declared))
            }
        }
    }

    /// Reads `SIZE` indices, counted from 1 in the file and from 0 here, for each `noun`.
    fn indices<const SIZE: usize>(
        &mut self,
        declared: Declared,
        (noun, vertices): (&str, usize),
    ) -> Result<Vec<[u32; SIZE]>, Diagnostic> {
        let mut list = Vec::new();
        while list.len() < declared.count {
            let mut indices = [0; SIZE];
            for (place, index) in indices.iter_mut().enumerate() {
                let word = self.word();
                if !tokens::looks_numeric(word) {
                    let read = list.len() * SIZE + place;
                    let message =
                        format!("{SIZE} indices for each {noun} make {}", declared.count.saturating_mul(SIZE));
                    return Err(self.too_few(format!("{message}, but only {read} follow"), declared));
                }
                *index = self.index(word, vertices)?;
                self.skip(word.len());
            }
            list.push(indices);
        }
        Ok(list)
    }

    /// The index `word` means; one that points nowhere is noted, and 0 stands for it.
    fn index(&mut self, word: &[u8], vertices: usize) -> Result<u32, Diagnostic> {
        let number = whole_number(word);
        if let Some(index) = number.filter(|&index| index >= 1 && index <= vertices as i64) {
            return Ok((index - 1) as u32);
        }
        let (message, help) = match number {
            None => (format!("{} is not a whole number", self.quoted()), None),
            Some(0) => ("there is no vertex 0".to_string(), Some("indices count from 1, not from 0")),
            Some(index) => (format!("there is no vertex {index}"), None),
        };
        let error = Diagnostic::error(message).at(self.here(), format!("an index from 1 to {vertices} belongs here"));
        let error = if let Some(help) = help { error.help(help) } else { error };
        if self.wrong.len() + 1 < MOST_ERRORS {
            self.wrong.push(error);
            return Ok(0);
        }
        Err(error)
    }

    fn too_few(&self, message: String, declared: Declared) -> Diagnostic {
        let ends = if self.tail.is_empty() { "the file ends here" } else { "expected a number" };
        let error = Diagnostic::error(message).at(declared.at, "announced here").at(self.here(), ends);
        error.help("correct the count, or add what is missing")
    }

    fn end(&self, noun: &str) -> Result<(), Diagnostic> {
        if self.tail.is_empty() {
            return Ok(());
        }
        let error = Diagnostic::error(format!("the file goes on behind its last {noun}"));
        let error = error.at(self.here(), "nothing should follow");
        Err(error.help("one file holds one list; is the count above too small?"))
    }

    /// The word in hand; it ends behind a colon. Empty at the end.
    fn word(&self) -> &'a [u8] {
        let word = tokens::word(self.tail);
        &word[..word.iter().position(|&byte| byte == b':').map_or(word.len(), |colon| colon + 1)]
    }

    fn skip(&mut self, length: usize) {
        self.tail = tokens::skip_space(&self.tail[length..]);
    }

    /// Where the word in hand stands.
    fn here(&self) -> Span {
        let start = self.text.len() - self.tail.len();
        Span::new(start, start + self.word().len())
    }

    /// The word in hand for a message: safe to print, and not endless.
    fn quoted(&self) -> String {
        let (word, most) = (self.word(), 40);
        match word.len() {
            0 => "missing".to_string(),
            length if length > most => format!("`{}...`", printable(&word[..most])),
            _ => format!("`{}`", printable(word)),
        }
    }
}

/// A whole number that fits; `+3` and `3.0` are none.
fn whole_number(word: &[u8]) -> Option<i64> {
    let is_plain = word.iter().all(|byte| byte.is_ascii_digit() || *byte == b'-');
    str::from_utf8(word).ok().filter(|_| is_plain).and_then(|digits| digits.parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn net(text: &str) -> Net {
        read(&Source::verbatim("a.bez", text.as_bytes())).unwrap_or_else(|errors| panic!("{errors}"))
    }

    #[test]
    fn curves_run_the_other_way() {
        let Net::Curves(net) = net("bezier_curves: vertices:5 vertex_list: 1 0 0 2 0 1 3 0 2 4 0 3 5 0 4\n\
             curves: 2\ncurve_list: 4 3 2 1  5 5 5 4\n")
        else {
            panic!("curves")
        };
        assert_eq!(net.vertices[4], Vec3::new(5.0, 0.0, 4.0));
        assert_eq!(net.curves, [[0, 1, 2, 3], [3, 4, 4, 4]]);
    }

    #[test]
    fn patches_keep_their_order() {
        let text = "bezier_patches: vertices: 2 vertex_list: 0 0 0 1e-3 -.5 2 patches: 1 patch_list: ";
        let Net::Patches(net) = net(&format!("{text} 2 {}", "1 ".repeat(15))) else { panic!("patches") };
        assert_eq!(net.vertices[1].to_array(), [1e-3, -0.5, 2.0]);
        assert_eq!((net.patches[0][0], net.patches[0][15]), (1, 0));
    }
}
