//! One picture on the page: drawn, right, difference, how many faces lie over each sample, and its first wrong pixel under the lens.

use super::data::Atlas;
use super::lens;
use crate::color::Encoding;
use crate::grade::pictures::{self, HEAT};
use crate::grade::verdict::Shot;
use crate::grade::write::png_url;
use crate::image::Picture;
use crate::plan::Accepts;
use crate::render::Canvas;
use crate::render::why::Asked;
use maud::{Markup, html};

/// Column and row of a pixel.
pub(super) fn place(shot: &Shot, at: usize) -> (usize, usize) {
    let width = (shot.case.width / shot.case.samples) as usize;
    (at % width, at / width)
}

/// A level with a swatch of it.
pub(super) fn level([r, g, b]: [u8; 3]) -> Markup {
    html! { span.swatch style=(format!("background:rgb({r},{g},{b})")) {} " " span.level { (r) "," (g) "," (b) } }
}

/// Everything about a picture that is wrong.
pub(super) fn figure(shot: &Shot, atlas: &mut Atlas) -> Markup {
    let Some(drawn) = shot.picture() else { return failure(shot) };
    let right = pictures::right(&shot.case);
    let id = atlas.add(shot, drawn, &right);
    let (name, wrong) = (&shot.case.name, shot.wrong.len());
    html! {
        figure id=(format!("case{id}")) {
            figcaption { strong { (name) } " " span.quiet { (shot.case.width) " × " (shot.case.height) " samples, " (wrong) " of " (shot.judged) " pixels wrong" } }
            @if let Some(complaint) = &shot.complaint { p.said { (complaint) } }
            div.pictures {
                (tile(drawn, "drawn", &format!("{name}, as it was drawn"), id))
                (tile(&right, "right", &format!("{name}, as it is right"), id))
                (tile(&pictures::difference(shot), "difference", &format!("{wrong} wrong pixels of {name} in red"), id))
                @if !shot.case.lines { (overdraw(shot, id)) }
            }
            @if !shot.wrong.is_empty() { (first_wrong(shot, drawn, &right)) }
        }
    }
}

/// A picture as a button: where it is clicked, that pixel is asked about.
fn tile(picture: &Picture, label: &str, alt: &str, id: usize) -> Markup {
    let url = png_url(&pictures::png(picture));
    html! {
        div.tile {
            img src=(url) alt=(alt) width=(picture.width()) height=(picture.height()) data-case=(id)
                style=(format!("--columns:{};--rows:{}", picture.width(), picture.height()));
            span.label { (label) }
        }
    }
}

fn overdraw(shot: &Shot, id: usize) -> Markup {
    let covering = pictures::overdraw(&shot.case);
    let most = covering.iter().copied().max().unwrap_or(0);
    let covered = covering.iter().filter(|&&faces| faces > 0).count();
    let alt = format!("how many polygons lie over each sample: at most {most}; {covered} samples are covered");
    let legend = (0..=(most as usize).min(HEAT.len() - 1)).map(|faces| (faces, HEAT[faces]));
    html! {
        div.tile {
            (tile(&pictures::overdraw_map(&shot.case), "polygons over each sample", &alt, id))
            ul.legend aria-label="legend" {
                @for (faces, [r, g, b]) in legend {
                    li { span.swatch style=(format!("background:rgb({r},{g},{b})")) {} (faces) @if faces + 1 == HEAT.len() { " and more" } }
                }
            }
            @if let Some(puts) = shot.answer.as_ref().ok().and_then(|answer| answer.puts.as_ref()) {
                span.quiet { (puts.puts) " puts, " (puts.overdraw) " over others" }
            }
        }
    }
}

/// The first wrong pixel, enlarged and in words; what is shown where no script runs.
fn first_wrong(shot: &Shot, drawn: &Picture, right: &Picture) -> Markup {
    let (x, y) = place(shot, shot.wrong[0]);
    html! {
        details.first {
            summary { "The first wrong pixel, (" (x) ", " (y) "): edges, sample points and values" }
            div.lens {
                (lens::around(shot, (drawn, right), (x, y)))
                div {
                    p { "drawn " (level(drawn.pixel(x, y))) ", right " (level(right.pixel(x, y))) }
                    pre.words { (why(shot, (x, y))) }
                }
            }
        }
    }
}

/// What lies over the samples of a pixel, in the words of `farop why`.
fn why(shot: &Shot, (x, y): (usize, usize)) -> String {
    let case = &shot.case;
    if case.lines {
        return "Lines: a sample shows one whose diamond the line leaves.\n".to_string();
    }
    let (list, samples) = (case.list(Accepts::AnyPolygon), case.samples as usize);
    let canvas = Canvas { threads: 1, ..Canvas::of_sheet(&case.sheet()) };
    let asked = Asked { list: &list, scene: None, canvas, encoding: Encoding::Linear };
    let all =
        (0..samples * samples).map(|at| ((x * samples + at % samples) as i32, (y * samples + at / samples) as i32));
    all.map(|sample| asked.sample(sample, None)).collect()
}

/// A picture that did not come.
fn failure(shot: &Shot) -> Markup {
    let Err(failure) = &shot.answer else { return html! {} };
    html! {
        figure.failed {
            figcaption { strong { (shot.case.name) } " " span.quiet { "no picture" } }
            pre { (failure.message) }
            @if !failure.hint.is_empty() { p { (failure.hint) } }
        }
    }
}

/// A right picture, small.
pub(super) fn thumb(shot: &Shot, atlas: &mut Atlas) -> Markup {
    let Some(drawn) = shot.picture() else { return html! {} };
    let id = atlas.add_right(shot, drawn);
    html! {
        figure.thumb id=[id.map(|id| format!("case{id}"))] {
            img src=(png_url(&pictures::png(drawn))) alt=(format!("{}, right", shot.case.name)) data-case=[id]
                width=(drawn.width()) height=(drawn.height())
                style=(format!("--columns:{};--rows:{}", drawn.width(), drawn.height()));
            figcaption { (shot.case.name) }
        }
    }
}
