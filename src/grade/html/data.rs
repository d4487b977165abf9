//! Data: what the page's script needs of each picture, as JSON that no tag can end.

use super::{Extent, pictures_base64};
use crate::grade::case::Case;
use crate::grade::verdict::Shot;
use crate::image::Picture;
use maud::{Markup, PreEscaped, html};
use serde_json::{Value, json};

/// The pictures that can be asked about.
pub(super) struct Atlas {
    extent: Extent,
    cases: Vec<Value>,
}

impl Atlas {
    pub fn new(extent: Extent) -> Atlas {
        Atlas { extent, cases: Vec::new() }
    }

    pub fn extent(&self) -> Extent {
        self.extent
    }

    /// Adds a picture; returns its number.
    pub fn add(&mut self, shot: &Shot, drawn: &Picture, right: &Picture) -> usize {
        let mut value = about(&shot.case, drawn);
        value["right"] = pictures_base64(right).into();
        value["wrong"] = shot.wrong.as_slice().into();
        self.cases.push(value);
        self.cases.len() - 1
    }

    /// Adds a picture that is right, where there is room for it.
    pub fn add_right(&mut self, shot: &Shot, drawn: &Picture) -> Option<usize> {
        (self.extent == Extent::All).then(|| {
            self.cases.push(about(&shot.case, drawn));
            self.cases.len() - 1
        })
    }

    /// The element that the script reads.
    pub fn script(&self) -> Markup {
        // Inside of a script element only `</` and `<!--` mean anything: without `<` neither can stand there.
        let text = Value::from(self.cases.clone()).to_string().replace('<', "\\u003c");
        html! { script #cases type="application/json" { (PreEscaped(text)) } }
    }
}

/// A face is: corners, plane of 1/w, planes of the values over w, opacity.
fn about(case: &Case, drawn: &Picture) -> Value {
    let faces = case.faces.iter().map(|face| json!([face.corners, face.inverse_w, face.over_w, face.opacity]));
    let kind = match (case.lines, case.lamp.is_some()) {
        (true, _) => "lines",
        (_, true) => "lit",
        _ => "faces",
    };
    json!({
        "name": case.name, "kind": kind, "width": drawn.width(), "height": drawn.height(), "samples": case.samples,
        "faces": faces.collect::<Vec<_>>(), "drawn": pictures_base64(drawn),
    })
}
