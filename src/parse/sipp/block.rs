//! Blocks of parameters, `{ radius 1 shader red }`, read by a table of what may stand in them.
//!
//! Why a table: twenty kinds of block have the same mistakes (misspelled, missing, twice, too many numbers, out of range),
//! and each must be told equally well for all of them. A row also *is* the grammar of its parameter.

use super::Reader;
use super::trouble::Trouble;
use super::vocabulary::{FILE_WORDS, ITEM_WORDS};
use super::words::Kind;
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Span, suggest};
use crate::math::Vec3;
use crate::parse::wording::{plain, quote};

/// What follows the word of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Takes {
    /// As many numbers as one of these says.
    Numbers(&'static [usize]),
    /// Pairs of numbers.
    Pairs,
    /// One of these words.
    OneOf(&'static [&'static str]),
    Name,
    Text,
    Nothing,
}

/// Which numbers make sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Range {
    Any,
    From0,
    Above0,
    /// 0 to 1.
    Fraction,
    /// Above 0, at most 1.
    PositiveFraction,
    /// Above 0, below 180.
    Opening,
    /// Whole, 1 to [`MOST_RESOLUTION`].
    Resolution,
    /// Not all of them 0.
    Direction,
}

/// The finest `res`: a sphere then has 8 million polygons.
pub(super) const MOST_RESOLUTION: f64 = 4096.0;

/// One row of a table.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameter {
    pub word: &'static str,
    /// How it is written, for messages.
    pub shape: &'static str,
    takes: Takes,
    range: Range,
    required: bool,
    repeats: bool,
}

/// A row with numbers.
pub(super) const fn numbers(
    word: &'static str,
    shape: &'static str,
    counts: &'static [usize],
    range: Range,
) -> Parameter {
    Parameter { word, shape, takes: Takes::Numbers(counts), range, required: false, repeats: false }
}

/// A row with something other than a fixed count of numbers.
pub(super) const fn other(word: &'static str, shape: &'static str, takes: Takes) -> Parameter {
    Parameter { word, shape, takes, range: Range::Any, required: false, repeats: false }
}

impl Parameter {
    pub const fn required(self) -> Parameter {
        Parameter { required: true, ..self }
    }

    pub const fn repeats(self) -> Parameter {
        Parameter { repeats: true, ..self }
    }
}

/// A parameter as it was given.
#[derive(Debug)]
pub(super) struct Given {
    pub word: &'static str,
    pub keyword: Span,
    /// What follows the keyword; the keyword itself where nothing does.
    pub values: Span,
    pub numbers: Vec<f64>,
}

/// All parameters of a block.
#[derive(Debug)]
pub(super) struct Block {
    /// The word before the block.
    pub keyword: Span,
    pub line: u32,
    pub given: Vec<Given>,
    /// A mistake in it was told: it makes nothing.
    pub broken: bool,
}

impl Block {
    pub fn find(&self, word: &str) -> Option<&Given> {
        self.given.iter().find(|given| given.word == word)
    }

    pub fn all<'b>(&'b self, word: &'static str) -> impl Iterator<Item = &'b Given> {
        self.given.iter().filter(move |given| given.word == word)
    }

    pub fn has(&self, word: &str) -> bool {
        self.find(word).is_some()
    }

    /// Where a parameter's values are; the keyword of the block where it is not given.
    pub fn place(&self, word: &str) -> Span {
        self.find(word).map_or(self.keyword, |given| given.values)
    }

    pub fn number(&self, word: &str) -> Option<f64> {
        self.find(word).and_then(|given| given.numbers.first().copied())
    }

    pub fn vector(&self, word: &str) -> Option<Vec3> {
        self.find(word).map(|given| vector(&given.numbers))
    }

    /// Three numbers, or one for all channels.
    pub fn color(&self, word: &str) -> Option<Rgb> {
        self.find(word).map(|given| match given.numbers[..] {
            [r, g, b] => Rgb::new(r, g, b),
            _ => Rgb::gray(given.numbers.first().copied().unwrap_or(1.0)),
        })
    }
}

/// Three numbers as a vector; missing ones are 0.
pub(super) fn vector(numbers: &[f64]) -> Vec3 {
    let at = |index: usize| numbers.get(index).copied().unwrap_or(0.0);
    Vec3::new(at(0), at(1), at(2))
}

impl Reader<'_> {
    /// Reads `{ parameters }`; `keyword` is the word the block belongs to.
    pub(super) fn block(&mut self, keyword: Span, line: u32, known: &[&[Parameter]]) -> Result<Block, Trouble> {
        let owner = plain(self.words.bytes(keyword));
        self.words.open(&owner)?;
        self.open_blocks.push(keyword);
        let mut block = Block { keyword, line, given: Vec::new(), broken: false };
        let errors_before = self.errors.len();
        while self.goes_on() && self.words.take_if(Kind::Close).is_none() {
            match self.parameter(&owner, &mut block, known) {
                Ok(true) => {}
                Ok(false) => break,
                Err(trouble) => {
                    self.tell(trouble);
                    self.recover(|word| find(known, word).is_some());
                }
            }
        }
        self.open_blocks.pop();
        block.broken = self.errors.len() > errors_before;
        if !block.broken {
            let missing = known.iter().copied().flatten().filter(|known| known.required && !block.has(known.word));
            let missing: Vec<String> = missing.map(|known| format!("`{}`", known.shape)).collect();
            if let [first, ..] = &missing[..] {
                let error = Diagnostic::error(format!("`{owner}` needs {first}")).at(keyword, "not in this block");
                self.errors.push(error.help(format!("write {} between its braces", missing.join(" and "))));
                block.broken = true;
            }
        }
        Ok(block)
    }

    /// Reads one parameter; `false` when the block was probably meant to end before it.
    fn parameter(&mut self, owner: &str, block: &mut Block, known: &[&[Parameter]]) -> Result<bool, Trouble> {
        let token = self.words.expect_word(&format!("`{owner}`"), "a parameter")?;
        let word = self.words.bytes(token.span);
        let Some(parameter) = find(known, word) else {
            if self.is_misplaced(word) {
                self.not_closed(token.span);
                return Ok(false);
            }
            self.check_text(word, token.span)?;
            self.words.take();
            return Err(unknown_parameter(owner, word, token.span, known).into());
        };
        self.words.take();
        if let (Some(first), false) = (block.find(parameter.word), parameter.repeats) {
            let message = format!("`{}` is given twice in this `{owner}`", parameter.word);
            let error = Diagnostic::error(message).at(token.span, "again").at(first.keyword, "first here");
            self.tell(error.help("keep one of them").into());
        }
        let given = self.values(parameter, token.span)?;
        if let Err(error) = check_range(parameter, &given) {
            self.tell(error.into());
        }
        block.given.push(given);
        Ok(true)
    }

    /// What stands behind the word of a parameter.
    fn values(&mut self, parameter: &Parameter, keyword: Span) -> Result<Given, Trouble> {
        let mut given = Given { word: parameter.word, keyword, values: keyword, numbers: Vec::new() };
        let shape = format!("`{}`", parameter.shape);
        match parameter.takes {
            Takes::Nothing => {}
            Takes::Name => given.values = self.words.name("a shader")?,
            Takes::Text => given.values = self.words.text(&shape)?,
            Takes::OneOf(choices) => {
                let token = self.words.expect_word(&shape, &format!("`{}`", choices.join("` or `")))?;
                let word = self.words.bytes(token.span);
                if !choices.iter().any(|choice| choice.as_bytes() == word) {
                    let error = Diagnostic::error(format!("{} where `{}` has a word", quote(word), parameter.word));
                    let error = error.at(token.span, format!("expected `{}`", choices.join("` or `")));
                    return Err(with_suggestion(error, word, choices).into());
                }
                given.values = self.words.take().span;
            }
            Takes::Numbers(counts) => self.numbers_of(&mut given, counts, &shape)?,
            Takes::Pairs => {
                self.numbers_of(&mut given, &[], &shape)?;
                if given.numbers.len() % 2 == 1 {
                    let message = format!("`{}` is pairs of numbers, found {}", parameter.word, given.numbers.len());
                    return Err(Diagnostic::error(message).at(keyword, format!("expected {shape}")).into());
                }
            }
        }
        Ok(given)
    }

    /// Numbers up to the next word that is none; `counts` says how many there may be (empty: any, but one at least).
    fn numbers_of(&mut self, given: &mut Given, counts: &[usize], shape: &str) -> Result<(), Trouble> {
        let least = counts.first().copied().unwrap_or(1);
        given.values = self.words.peek().span;
        while given.numbers.len() < least || self.words.is_number_next() {
            given.values.end = self.words.peek().span.end;
            given.numbers.push(self.words.number(shape)?);
        }
        if counts.is_empty() || counts.contains(&given.numbers.len()) {
            return Ok(());
        }
        let counts: Vec<String> = counts.iter().map(usize::to_string).collect();
        let numbers = if counts == ["1"] { "number" } else { "numbers" };
        let message =
            format!("`{}` takes {} {numbers}, found {}", given.word, counts.join(" or "), given.numbers.len());
        Err(Diagnostic::error(message).at(self.on_one_line(given.values), format!("expected {shape}")).into())
    }

    /// A span for a label: cut at the end of its first line.
    pub(super) fn on_one_line(&self, span: Span) -> Span {
        let length = self.words.bytes(span).iter().position(|&byte| byte == b'\n');
        length.map_or(span, |length| Span { start: span.start, end: span.start + length as u32 })
    }

    /// A word of the level above, and none that was misspelled: a `}` is missing before it.
    fn is_misplaced(&self, word: &[u8]) -> bool {
        FILE_WORDS.iter().chain(ITEM_WORDS).any(|known| known.as_bytes() == word)
    }
}

fn find<'t>(known: &[&'t [Parameter]], word: &[u8]) -> Option<&'t Parameter> {
    known.iter().copied().flatten().find(|parameter| parameter.word.as_bytes() == word)
}

fn unknown_parameter(owner: &str, word: &[u8], span: Span, known: &[&[Parameter]]) -> Diagnostic {
    let all: Vec<&str> = known.iter().copied().flatten().map(|parameter| parameter.word).collect();
    if crate::parse::tokens::looks_numeric(word) {
        let error = Diagnostic::error(format!("a number too many in this `{owner}`")).at(span, "belongs to nothing");
        return error.help(format!("parameters of `{owner}`: {}", all.join(", ")));
    }
    let error = Diagnostic::error(format!("`{owner}` has no parameter {}", quote(word))).at(span, "not known here");
    with_suggestion(error, word, &all)
}

/// Adds the known word that was probably meant, or all of them.
pub(super) fn with_suggestion(error: Diagnostic, word: &[u8], known: &[&str]) -> Diagnostic {
    match suggest(&plain(word), known) {
        Some(meant) => error.help(format!("did you mean `{meant}`?")),
        None => error.help(format!("there is {}", known.join(", "))),
    }
}

fn check_range(parameter: &Parameter, given: &Given) -> Result<(), Diagnostic> {
    let word = parameter.word;
    let all = |holds: fn(&f64) -> bool| given.numbers.iter().all(holds);
    let wrong = match parameter.range {
        Range::Any => return Ok(()),
        Range::From0 if !all(|&x| x >= 0.0) => "cannot be negative",
        Range::Above0 if !all(|&x| x > 0.0) => "must be above 0",
        Range::Fraction if !all(|x| (0.0..=1.0).contains(x)) => "must be from 0 to 1",
        Range::PositiveFraction if !all(|&x| x > 0.0 && x <= 1.0) => "must be above 0, at most 1",
        Range::Opening if !all(|&x| x > 0.0 && x < 180.0) => "must be above 0 and below 180 degrees",
        Range::Resolution if !all(|&x| x.fract() == 0.0 && (1.0..=MOST_RESOLUTION).contains(&x)) => {
            "must be a whole number from 1 to 4096"
        }
        Range::Direction if all(|&x| x == 0.0) => "is 0 0 0, which is no direction",
        _ => return Ok(()),
    };
    let error = Diagnostic::error(format!("`{word}` {wrong}")).at(given.values, format!("in `{}`", parameter.shape));
    let help = match word {
        "radius" | "radii" => Some("to see the inside of a shape, write `inside`"),
        "c3" => Some("small is shiny, 1 is dull"),
        "opacity" => Some("0 is invisible, 1 hides what is behind"),
        "to" => Some("it leads from the scene towards the light"),
        "res" => Some("leave `res` out, and the shape is cut as finely as the picture needs"),
        "opening" => Some("it is the full angle of the cone of light"),
        _ => None,
    };
    Err(if let Some(help) = help { error.help(help) } else { error })
}
