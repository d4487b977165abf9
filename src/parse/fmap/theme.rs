//! Themes: which objects of a layer are shown, and how they look.

use super::{Reader, again, found};
use crate::diagnostic::Diagnostic;
use crate::forest::map::{Case, Condition, Length, Operator, Ramp, Style, Theme, Unit};
use crate::forest::vector::Attribute;

/// What a look is made of.
pub(super) const LOOKS: &[&str] = &["color", "width", "fill", "dash", "size"];
pub(super) const FIELDS: &[&str] = &["layer", "where", "color", "width", "fill", "dash", "size"];

const OPERATORS: [(&str, Operator); 7] = [
    ("=", Operator::Equal),
    ("!=", Operator::Unequal),
    ("<", Operator::Less),
    ("<=", Operator::AtMost),
    (">", Operator::More),
    (">=", Operator::AtLeast),
    ("==", Operator::Equal),
];
const UNITS: [(&str, Unit); 2] = [("m", Unit::Metres), ("px", Unit::Pixels)];
/// Metres, or pixels.
const WIDEST: f64 = 100_000.0;

impl Reader<'_> {
    /// `theme NAME layer LAYER [where NAME OPERATOR VALUE]... LOOK`
    pub(super) fn theme(&mut self) -> Result<(), Diagnostic> {
        let place = self.place();
        let (name, span) = self.words.text("the theme's name")?;
        if self.map.themes.iter().any(|theme| theme.name == name) {
            return Err(again("theme", &name, span));
        }
        if !self.words.take_field("layer") {
            let next = self.words.peek();
            return Err(self.words.ends_early(next, "`layer` and the layer's name"));
        }
        let (layer, at) = self.words.text("a layer")?;
        let known: Vec<&str> = self.map.layers.iter().map(|layer| layer.name.as_str()).collect();
        let layer = found(&layer, at, "layer", &known)?;
        let mut conditions = Vec::new();
        while self.words.take_field("where") {
            conditions.push(self.condition(layer)?);
        }
        let style = self.style()?;
        self.map.themes.push(Theme { name, layer, conditions, style, cases: Vec::new(), place });
        Ok(())
    }

    /// `case NAME OPERATOR VALUE LOOK`
    pub(super) fn case(&mut self) -> Result<(), Diagnostic> {
        let condition = self.condition(self.layer_above()?)?;
        let style = self.style()?;
        self.push_case(Case::Class(condition, style));
        Ok(())
    }

    /// `ramp NAME LOW HIGH [color R G B R G B] [fill R G B R G B] [width A B UNIT] [size A B UNIT]`
    pub(super) fn ramp(&mut self) -> Result<(), Diagnostic> {
        let attribute = self.attribute(self.layer_above()?)?;
        let at = self.words.peek().span;
        let range = [self.words.number("the lower number")?, self.words.number("the higher number")?];
        if range[0] >= range[1] {
            let error = Diagnostic::error(format!("a ramp from {} to {}", range[0], range[1]));
            return Err(error.at(at, "expected the lower number first"));
        }
        let mut ends = [Style::default(); 2];
        loop {
            if self.words.take_field("color") {
                (ends[0].color, ends[1].color) = (Some(self.color()?), Some(self.color()?));
            } else if self.words.take_field("fill") {
                (ends[0].fill, ends[1].fill) = (Some(self.color()?), Some(self.color()?));
            } else if self.words.take_field("width") {
                let [low, high] = self.lengths("a width")?;
                (ends[0].width, ends[1].width) = (Some(low), Some(high));
            } else if self.words.take_field("size") {
                let [low, high] = self.lengths("a size")?;
                (ends[0].size, ends[1].size) = (Some(low), Some(high));
            } else {
                break;
            }
        }
        self.push_case(Case::Ramp(Ramp { attribute, range, ends }));
        Ok(())
    }

    fn push_case(&mut self, case: Case) {
        if let Some(theme) = self.map.themes.last_mut() {
            theme.cases.push(case);
        }
    }

    /// The layer of the theme above.
    fn layer_above(&self) -> Result<usize, Diagnostic> {
        self.map.themes.last().map(|theme| theme.layer).ok_or_else(|| {
            let error = Diagnostic::error("a look outside of a theme").at(self.words.keyword, "belongs to nothing");
            error.help("write `theme NAME layer LAYER` above")
        })
    }

    fn condition(&mut self, layer: usize) -> Result<Condition, Diagnostic> {
        let attribute = self.attribute(layer)?;
        let operator = self.words.choice("comparison", &OPERATORS)?;
        let at = self.words.peek().span;
        let value = self.value()?;
        let is_order = !matches!(operator, Operator::Equal | Operator::Unequal);
        if is_order && matches!(value, Attribute::Text(_)) {
            return Err(Diagnostic::error("texts are not larger or smaller").at(at, "expected a number"));
        }
        Ok(Condition { attribute, operator, value })
    }

    /// The name of an attribute that some object of the layer has.
    fn attribute(&mut self, layer: usize) -> Result<String, Diagnostic> {
        let (name, span) = self.words.text("the name of an attribute")?;
        let layer = &self.map.layers[layer];
        if layer.features.iter().any(|feature| feature.attributes.contains_key(&name)) || layer.features.is_empty() {
            return Ok(name);
        }
        let mut known: Vec<&str> =
            layer.features.iter().flat_map(|feature| feature.attributes.keys().map(String::as_str)).collect();
        known.sort_unstable();
        known.dedup();
        let error = Diagnostic::error(format!("no object of layer `{}` has an attribute `{name}`", layer.name));
        let error = error.at(span, "not there");
        if known.is_empty() {
            return Err(error.help("its objects have no attributes"));
        }
        Err(error.help(crate::parse::statements::did_you_mean(name.as_bytes(), &known)))
    }

    fn style(&mut self) -> Result<Style, Diagnostic> {
        let mut style = Style::default();
        loop {
            if self.words.take_field("color") {
                style.color = Some(self.color()?);
            } else if self.words.take_field("fill") {
                style.fill = Some(self.color()?);
            } else if self.words.take_field("width") {
                style.width = Some(self.length("a width")?);
            } else if self.words.take_field("size") {
                style.size = Some(self.length("a size")?);
            } else if self.words.take_field("dash") {
                let mut length = || self.words.within("a length of dashes", 0.01..=WIDEST);
                style.dash = Some([length()?, length()?]);
            } else {
                return Ok(style);
            }
        }
    }

    fn color(&mut self) -> Result<[u8; 3], Diagnostic> {
        let mut channel = |what| self.words.within(what, 0.0..=1.0).map(|value| (value * 255.0).round() as u8);
        Ok([channel("red")?, channel("green")?, channel("blue")?])
    }

    fn length(&mut self, what: &str) -> Result<Length, Diagnostic> {
        let value = self.words.within(what, 0.01..=WIDEST)?;
        Ok(Length { value, unit: self.words.choice("unit", &UNITS)? })
    }

    fn lengths(&mut self, what: &str) -> Result<[Length; 2], Diagnostic> {
        let low = self.words.within(what, 0.01..=WIDEST)?;
        let high = self.length(what)?;
        Ok([Length { value: low, unit: high.unit }, high])
    }
}
