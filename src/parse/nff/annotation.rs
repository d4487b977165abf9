//! Comments for farop: `#farop light ...` before an `l`, `#farop surface ...` before an `f`.
//!
//! line of words -ANNOTATION-> what the next statement means besides
//!
//! ```text
//! #farop light    intensity I
//! #farop surface  [phong]  [ambient A]  [opacity R G B]  [two_sided]     in any order, at least one
//! ```
//! Other readers skip them as comments; farop reads them strictly, because a misspelled one would be drawn as if it were not there.
//! [`crate::parse`]'s input lets them through, `write/annotation.rs` writes them, decision 11 says why they are comments.

use crate::color::Rgb;
use crate::diagnostic::{printable, suggest};
use crate::parse::tokens;
use crate::parse::wording::quote;

/// The word an annotation starts with.
pub(super) const WORD: &[u8] = b"#farop";

const SUBJECTS: [&str; 2] = ["light", "surface"];
const LIGHT_WORDS: [&str; 1] = ["intensity"];
const SURFACE_WORDS: [&str; 4] = ["phong", "ambient", "opacity", "two_sided"];

/// What an annotation says about the statement behind it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Annotation {
    /// For an `l`.
    Light { intensity: f64 },
    /// For an `f`.
    Surface(SurfaceNote),
}

/// What NFF's `f` cannot say.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct SurfaceNote {
    /// SIPP's `phong` instead of NFF's model.
    pub is_phong: bool,
    pub ambient: Option<f64>,
    /// In place of 1 - T.
    pub opacity: Option<Rgb>,
    pub two_sided: bool,
}

/// A word of the line that makes no sense, counted from 0, the `#farop`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mistake {
    pub word: usize,
    pub message: String,
    pub help: String,
}

impl Annotation {
    /// Reads a line, from `#farop` to its end.
    pub fn read(line: &[u8]) -> Result<Annotation, Mistake> {
        let all = line.split(|&byte| tokens::is_space(byte)).filter(|word| !word.is_empty()).collect();
        let mut words = Words { all, at: 1, seen: Vec::new() };
        match words.next() {
            Some(b"light") => words.light(),
            Some(b"surface") => words.surface(),
            Some(_) => Err(words.unknown(&SUBJECTS)),
            None => Err(words.mistake("`#farop` says nothing", "write `#farop light` or `#farop surface`")),
        }
    }

    /// The keyword of the statement it belongs to, and what it calls itself.
    pub fn belongs_to(&self) -> (&'static [u8], &'static str) {
        match self {
            Annotation::Light { .. } => (b"l", "#farop light"),
            Annotation::Surface(_) => (b"f", "#farop surface"),
        }
    }
}

struct Words<'a> {
    all: Vec<&'a [u8]>,
    /// The next word.
    at: usize,
    /// Words that may stand once.
    seen: Vec<&'a [u8]>,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        let word = self.all.get(self.at).copied();
        self.at += usize::from(word.is_some());
        word
    }

    fn light(&mut self) -> Result<Annotation, Mistake> {
        let mut intensity = None;
        while let Some(word) = self.next() {
            match word {
                b"intensity" => intensity = Some(self.once(word)?.number(f64::MAX)?),
                _ => return Err(self.unknown(&LIGHT_WORDS)),
            }
        }
        let intensity = intensity.ok_or_else(|| {
            self.mistake("`#farop light` says nothing about the light", "write `#farop light intensity 1`")
        })?;
        Ok(Annotation::Light { intensity })
    }

    fn surface(&mut self) -> Result<Annotation, Mistake> {
        let mut note = SurfaceNote::default();
        while let Some(word) = self.next() {
            match word {
                b"phong" => note.is_phong = self.once(word).map(|_| true)?,
                b"two_sided" => note.two_sided = self.once(word).map(|_| true)?,
                b"ambient" => note.ambient = Some(self.once(word)?.number(f64::MAX)?),
                b"opacity" => {
                    self.once(word)?;
                    note.opacity = Some(Rgb::new(self.number(1.0)?, self.number(1.0)?, self.number(1.0)?));
                }
                _ => return Err(self.unknown(&SURFACE_WORDS)),
            }
        }
        if self.seen.is_empty() {
            let help = "write at least one of `phong`, `ambient A`, `opacity R G B`, `two_sided`";
            return Err(self.mistake("`#farop surface` says nothing about the surface", help));
        }
        Ok(Annotation::Surface(note))
    }

    /// Refuses a word that stood before.
    fn once(&mut self, word: &'a [u8]) -> Result<&mut Self, Mistake> {
        if self.seen.contains(&word) {
            return Err(self.mistake(format!("{} stands twice", quote(word)), "remove one of the two"));
        }
        self.seen.push(word);
        Ok(self)
    }

    /// The next word as a number from 0 to `most`.
    fn number(&mut self, most: f64) -> Result<f64, Mistake> {
        let range = if most == 1.0 { "a number from 0 to 1" } else { "a number from 0 up" };
        let Some(word) = self.next() else {
            return Err(self.mistake("the line ends too early", format!("{range} should follow on the same line")));
        };
        let number = tokens::number(word).ok().map(|number| number.value).filter(|value| (0.0..=most).contains(value));
        number.ok_or_else(|| {
            let of = self.seen.last().copied().unwrap_or_default();
            self.mistake(format!("{} is not {range}", quote(word)), format!("it belongs to {}", quote(of)))
        })
    }

    fn unknown(&self, known: &[&str]) -> Mistake {
        let word = self.all[self.at - 1];
        let names = || format!("here may stand `{}`", known.join("`, `"));
        let help = suggest(&printable(word), known).map_or_else(names, |meant| format!("did you mean `{meant}`?"));
        self.mistake(format!("{} means nothing to farop here", quote(word)), help)
    }

    /// A mistake at the word that was read last.
    fn mistake(&self, message: impl Into<String>, help: impl Into<String>) -> Mistake {
        Mistake { word: self.at - 1, message: message.into(), help: help.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_in_any_order() {
        assert_eq!(Annotation::read(b"#farop light\tintensity 0.25 "), Ok(Annotation::Light { intensity: 0.25 }));
        let opacity = Some(Rgb::new(1.0, 0.5, 0.0));
        let note = SurfaceNote { is_phong: true, ambient: Some(0.4), opacity, two_sided: true };
        for line in ["phong ambient .4 opacity 1 .5 0 two_sided", "two_sided opacity 1 .5 0 ambient 4e-1 phong"] {
            assert_eq!(
                Annotation::read(format!("#farop surface {line}").as_bytes()),
                Ok(Annotation::Surface(note)),
                "{line}"
            );
        }
    }

    #[test]
    fn mistakes_know_their_word() {
        for (line, word, part) in [
            ("#farop", 0, "says nothing"),
            ("#farop lihgt intensity 1", 1, "means nothing"),
            ("#farop light", 1, "says nothing"),
            ("#farop light intensity", 2, "ends too early"),
            ("#farop light intensity -1", 3, "from 0 up"),
            ("#farop light intensity nan", 3, "from 0 up"),
            ("#farop light intensity 1 2", 4, "means nothing"),
            ("#farop surface opacity 1 2 1", 4, "0 to 1"),
            ("#farop surface phong two_sided phong", 4, "twice"),
        ] {
            let mistake = Annotation::read(line.as_bytes()).expect_err(line);
            assert_eq!(mistake.word, word, "{line}: {mistake:?}");
            assert!(mistake.message.contains(part), "{line}: {mistake:?}");
        }
        assert_eq!(
            Annotation::read(b"#farop surface ambeint 1").expect_err("misspelled").help,
            "did you mean `ambient`?"
        );
    }
}
