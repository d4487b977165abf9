//! Layers: objects that stand in the text, and files of them.

use super::{Reader, again};
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::polygon::Point;
use crate::forest::vector::{Attribute, Crs, Feature, Geometry, Layer, Rings};
use crate::parse::fcell::outline::flaw;
use crate::parse::tokens;
use crate::parse::vector::{load_vectors, told};
use std::collections::BTreeMap;

/// The largest coordinate of a map, and the most positions of an object.
const FARTHEST: f64 = 1e9;
const MOST_POSITIONS: usize = 10_000_000;

impl Reader<'_> {
    /// `layer NAME [from FILE]`
    pub(super) fn layer(&mut self) -> Result<(), Diagnostic> {
        let (name, span) = self.words.text("the layer's name")?;
        if self.map.layers.iter().any(|layer| layer.name == name) {
            return Err(again("layer", &name, span));
        }
        self.is_file = self.words.take_field("from");
        if !self.is_file {
            self.map.layers.push(Layer { name, files: self.map.files.clone(), crs: self.crs, ..Layer::default() });
            return Ok(());
        }
        let (file, at) = self.words.text("a file of vectors")?;
        let read = load_vectors(&self.folder.join(&file)).map_err(|errors| {
            let first = errors.list.first();
            let place = first.and_then(|error| errors.place(error)).map_or(String::new(), |place| format!("{place}: "));
            let what = first.map_or(String::new(), |error| error.message.clone());
            let error = Diagnostic::error(format!("{place}{what}")).at(at, "in this file");
            match first.and_then(|error| error.help.clone()) {
                Some(help) => error.help(help),
                None => error,
            }
        })?;
        if !read.notices.is_empty() {
            self.notices.push(read.notices);
        }
        self.map.layers.push(Layer { name, ..read.layer });
        Ok(())
    }

    /// `point`, `line`, `polygon`: an object of the layer above.
    pub(super) fn object(&mut self, keyword: &[u8]) -> Result<(), Diagnostic> {
        let place = self.place();
        if self.map.layers.is_empty() || self.is_file {
            let error = Diagnostic::error("an object outside of a layer").at(self.words.keyword, "belongs to nothing");
            return Err(error.help("write `layer NAME` above; a layer `from` a file has the file's objects alone"));
        }
        let geometry = match keyword {
            b"point" => Geometry::Points(vec![self.position()?]),
            b"line" => Geometry::Lines(vec![self.positions(2, "position")?]),
            _ => Geometry::Polygons(vec![self.polygon()?]),
        };
        let mut attributes = BTreeMap::new();
        while self.words.take_field("is") {
            let (name, span) = self.words.text("an attribute")?;
            let value = self.value()?;
            if attributes.insert(name.clone(), value).is_some() {
                return Err(Diagnostic::error(format!("the attribute `{name}` is said twice")).at(span, "again"));
            }
        }
        if let Some(layer) = self.map.layers.last_mut() {
            layer.features.push(Feature { attributes, geometry, place });
        }
        Ok(())
    }

    /// A number, or a text.
    pub(super) fn value(&mut self) -> Result<Attribute, Diagnostic> {
        let word = self.words.peek();
        if !word.is_quoted && tokens::number(word.bytes).is_ok() {
            return self.words.number("a value").map(Attribute::Number);
        }
        self.words.text("a value").map(|(text, _)| Attribute::Text(text))
    }

    fn position(&mut self) -> Result<Point, Diagnostic> {
        let at = self.words.peek().span;
        let place = [self.coordinate("x")?, self.coordinate("y")?];
        if self.crs == Some(Crs::Degrees) && (place[0].abs() > 180.0 || place[1].abs() > 90.0) {
            let error = Diagnostic::error(format!("{} {} is no longitude and latitude", place[0], place[1]));
            let is_swapped = place[0].abs() <= 90.0 && place[1].abs() <= 180.0;
            return Err(error.at(at, "this position").help(match is_swapped {
                true => "are the axes swapped? longitude comes first",
                false => "are these metres? then say their projection: `crs EPSG:326zz`",
            }));
        }
        Ok(place)
    }

    fn coordinate(&mut self, what: &str) -> Result<f64, Diagnostic> {
        self.words.within(what, -FARTHEST..=FARTHEST)
    }

    fn positions(&mut self, least: usize, what: &str) -> Result<Vec<Point>, Diagnostic> {
        let count: usize = self.words.whole(&format!("the number of {what}s"), least..=MOST_POSITIONS)?;
        (0..count).map(|_| self.position()).collect()
    }

    fn polygon(&mut self) -> Result<Rings, Diagnostic> {
        let mut spans: Vec<Span> = vec![self.words.peek().span];
        if !self.words.take_field("outer") {
            let next = self.words.peek();
            return Err(self.words.ends_early(next, "`outer`, the number of corners and their positions"));
        }
        let mut rings = vec![self.ring()?];
        loop {
            let at = self.words.peek().span;
            if !self.words.take_field("hole") {
                break;
            }
            spans.push(at);
            rings.push(self.ring()?);
        }
        if let Some(flaw) = flaw(&rings) {
            return Err(Diagnostic::error(told(&flaw))
                .at(spans[0], "of this polygon")
                .help("bring its corners in order"));
        }
        let outer = rings.remove(0);
        Ok(Rings { outer, holes: rings })
    }

    /// Rings close by themselves; a first corner that is written again at the end is left out.
    fn ring(&mut self) -> Result<Vec<Point>, Diagnostic> {
        let at = self.words.peek().span;
        let mut ring = self.positions(3, "corner")?;
        if ring.first() == ring.last() {
            ring.pop();
        }
        ring.dedup();
        if ring.len() < 3 {
            return Err(Diagnostic::error("a ring of less than 3 corners").at(at, "the last corner is the first again"));
        }
        Ok(ring)
    }
}
