//! Style: how objects look, and which ones look how.
//!
//! attributes -STYLE-> color, width, fill of one object
//!
//! Space: display values of color, 0 to 255; lengths in metres of the ground or pixels of the map.

use crate::forest::vector::{Attribute, Feature};

/// What a length is counted in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Metres on the ground: near is wide.
    #[default]
    Metres,
    /// Pixels, wherever it is.
    Pixels,
}

/// A width or a size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    /// Above 0.
    pub value: f64,
    /// Of what.
    pub unit: Unit,
}

/// How an object looks; what is `None` is said elsewhere, or not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Style {
    /// Of lines, outlines and points.
    pub color: Option<[u8; 3]>,
    /// Of lines and outlines.
    pub width: Option<Length>,
    /// Of the inside of polygons.
    pub fill: Option<[u8; 3]>,
    /// Metres that are drawn, and left out.
    pub dash: Option<[f64; 2]>,
    /// Diameter of points.
    pub size: Option<Length>,
}

/// How an attribute is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// The same number or text.
    Equal,
    /// Another one, or none at all.
    Unequal,
    /// A smaller number.
    Less,
    /// A number that is not larger.
    AtMost,
    /// A larger number.
    More,
    /// A number that is not smaller.
    AtLeast,
}

/// What an object must be.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Which attribute.
    pub attribute: String,
    /// Compared how.
    pub operator: Operator,
    /// With what.
    pub value: Attribute,
}

/// A look by attribute.
#[derive(Clone, Debug, PartialEq)]
pub enum Case {
    /// Objects that fit look so.
    Class(Condition, Style),
    /// The attribute's number says how much.
    Ramp(Ramp),
}

/// Between two looks by a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Ramp {
    /// Which attribute.
    pub attribute: String,
    /// Its numbers at both ends; beyond them the look stays.
    pub range: [f64; 2],
    /// The looks at both ends; both say the same things.
    pub ends: [Style; 2],
}

impl Condition {
    /// Whether an object is so. Numbers that are texts in the file count as numbers.
    #[must_use]
    pub fn holds(&self, feature: &Feature) -> bool {
        let Some(found) = feature.attributes.get(&self.attribute) else { return self.operator == Operator::Unequal };
        match (number(found), number(&self.value)) {
            (Some(found), Some(value)) => match self.operator {
                Operator::Equal => found == value,
                Operator::Unequal => found != value,
                Operator::Less => found < value,
                Operator::AtMost => found <= value,
                Operator::More => found > value,
                Operator::AtLeast => found >= value,
            },
            _ => match self.operator {
                Operator::Equal => text(found) == text(&self.value),
                Operator::Unequal => text(found) != text(&self.value),
                _ => false,
            },
        }
    }
}

/// An attribute as a number.
fn number(attribute: &Attribute) -> Option<f64> {
    match attribute {
        Attribute::Number(number) => Some(*number),
        Attribute::Text(text) => text.trim().parse().ok().filter(|number: &f64| number.is_finite()),
    }
}

fn text(attribute: &Attribute) -> String {
    match attribute {
        Attribute::Number(number) => number.to_string(),
        Attribute::Text(text) => text.clone(),
    }
}

impl Style {
    /// What this says, and of what it does not say, what `other` says.
    #[must_use]
    pub fn or(self, other: Style) -> Style {
        Style {
            color: self.color.or(other.color),
            width: self.width.or(other.width),
            fill: self.fill.or(other.fill),
            dash: self.dash.or(other.dash),
            size: self.size.or(other.size),
        }
    }

    /// How an object looks, of a theme with this style and these cases: every ramp counts, and of the classes the first that fits.
    #[must_use]
    pub fn of(self, cases: &[Case], feature: &Feature) -> Style {
        let mut style = Style::default();
        let mut is_classed = false;
        for case in cases {
            match case {
                Case::Class(condition, looks) if !is_classed && condition.holds(feature) => {
                    is_classed = true;
                    style = style.or(*looks);
                }
                Case::Ramp(ramp) => style = style.or(ramp.of(feature).unwrap_or_default()),
                Case::Class(..) => {}
            }
        }
        style.or(self)
    }
}

impl Ramp {
    /// The look of an object that has such a number.
    fn of(&self, feature: &Feature) -> Option<Style> {
        let value = number(feature.attributes.get(&self.attribute)?)?;
        let [low, high] = self.range;
        let share = ((value - low) / (high - low)).clamp(0.0, 1.0);
        let [first, second] = self.ends;
        let mixed = |from: f64, to: f64| from + (to - from) * share;
        let color = |from: Option<[u8; 3]>, to: Option<[u8; 3]>| {
            let (from, to) = (from?, to?);
            Some([0, 1, 2].map(|channel| mixed(f64::from(from[channel]), f64::from(to[channel])).round() as u8))
        };
        let length = |from: Option<Length>, to: Option<Length>| {
            let (from, to) = (from?, to?);
            Some(Length { value: mixed(from.value, to.value), unit: from.unit })
        };
        Some(Style {
            color: color(first.color, second.color),
            width: length(first.width, second.width),
            fill: color(first.fill, second.fill),
            dash: None,
            size: length(first.size, second.size),
        })
    }
}
