//! Solids: what is shown of eye space: the stage before clipping, and clipping, plane by plane.
//!
//! Traced -SOLIDS-> areas and lines -outside-> board
//!
//! Eye: fronts are green, backs red, edge-on polygons yellow; the polygon in hand has a bright outline. Clip: what
//! is kept is gray, what a plane cuts off has the color of the plane, faint; the parts not yet cut are brown.

use super::board::{Board, ink, mixed};
use super::cut::{self, Crossing};
use super::outside::{self, Area, Line};
use super::stages::{Traced, points};
use super::state::Outside;
use crate::geometry::Facing;
use crate::math::Vec3;

/// Areas of larger scenes have no outlines.
const MOST_OUTLINES: usize = 20_000;

/// A board, what there is to say, and how many steps there are.
pub(super) type Shown = (Board, Vec<String>, usize);

/// Eye space as culling sees it.
pub(super) fn eye(traced: &Traced, step: Option<usize>, from: Outside) -> Result<Shown, String> {
    let all = &traced.trace.eye;
    let step = step.filter(|_| !all.is_empty()).map(|step| step.min(all.len() - 1));
    let color = |facing: &Facing| match facing {
        Facing::Front { .. } => 0x70_B8_78,
        Facing::Back { .. } => 0xC0_50_48,
        Facing::EdgeOn | Facing::NotFinite => 0xD0_C0_40,
    };
    let area = |number: usize| {
        // A back face that goes on all the same is only reddish.
        let kept = traced.kept[number].is_some() && all[number].facing.is_back();
        let color = if kept { 0xB0_88_70 } else { color(&all[number].facing) };
        Area { corners: all[number].corners.clone(), color, opacity: 1.0 }
    };
    let areas: Vec<_> = (0..all.len()).map(area).collect();
    let hand = step.map(|step| &all[step].corners[..]);
    let board = seen(traced, &areas, hand, from)?;
    let text = step.map_or_else(|| eye_summary(traced), |step| traced.eye_text(step));
    Ok((board, text, all.len()))
}

fn eye_summary(traced: &Traced) -> Vec<String> {
    let all = &traced.trace.eye;
    let count = |is: fn(&Facing) -> bool| all.iter().filter(|polygon| is(&polygon.facing)).count();
    let (fronts, backs) = (count(|facing| matches!(facing, Facing::Front { .. })), count(Facing::is_back));
    let culled = (0..all.len()).filter(|&number| traced.is_culled(number)).count();
    vec![
        format!("in eye space: {}; fronts (green): {fronts}, backs (red): {backs}", all.len()),
        format!("dropped by culling ({}): {culled}", traced.plan.choices.culling.name()),
    ]
}

/// Clipping: all at once, or up to the step in hand.
pub(super) fn clip(traced: &Traced, step: Option<usize>, from: Outside) -> Result<Shown, String> {
    let crossings = traced.crossings();
    let step = step.filter(|_| !crossings.is_empty()).map(|step| step.min(crossings.len() - 1));
    let done = step.map_or(crossings.len(), |step| step + 1);
    let (mut areas, mut hand, mut first) = (Vec::new(), None, 0);
    for number in (0..traced.trace.eye.len()).filter(|&number| !traced.is_culled(number)) {
        let all = crossings[first..].iter().take_while(|crossing| crossing.polygon == number).count();
        let steps = &crossings[first..done.clamp(first, first + all)];
        let in_hand = step.filter(|step| (first..first + all).contains(step)).map(|step| crossings[step]);
        let (mut corners, before) = cut_up(traced, number, steps, (in_hand.is_some(), &mut areas));
        // What is left of it is as the clipper left it, once all its planes are done.
        if let (true, Some(kept)) = (steps.len() == all, traced.kept[number]) {
            corners = traced.eye_corners(kept);
        }
        if let Some(crossing) = in_hand {
            hand = Some((corners.clone(), clip_text(traced, crossing, before, &corners)));
        }
        let untouched = steps.is_empty() && all > 0;
        areas.push(Area { corners, color: if untouched { 0x90_78_60 } else { 0xB8_B8_B8 }, opacity: 1.0 });
        first += all;
    }
    let (outline, text) = hand.unzip();
    let board = seen(traced, &areas, outline.as_deref(), from)?;
    Ok((board, text.unwrap_or_else(|| clip_summary(traced, &crossings)), crossings.len()))
}

/// Cuts a polygon by some planes; what goes is added to the areas, the last of it brighter where it is in hand. Returns what stays,
/// and how many corners there were before the last cut.
fn cut_up(
    traced: &Traced,
    number: usize,
    steps: &[Crossing],
    (is_in_hand, areas): (bool, &mut Vec<Area>),
) -> (Vec<Vec3>, usize) {
    let mut corners = traced.trace.eye[number].corners.clone();
    let mut before = corners.len();
    for (place, crossing) in steps.iter().enumerate() {
        before = corners.len();
        let [kept, gone] = cut::cut(&corners, crossing.plane, &traced.plan);
        let opacity = if is_in_hand && place + 1 == steps.len() { 0.75 } else { 0.35 };
        areas.push(Area { corners: gone, color: ink::WHEEL[crossing.plane as usize], opacity });
        corners = kept;
    }
    (corners, before)
}

fn clip_summary(traced: &Traced, crossings: &[Crossing]) -> Vec<String> {
    let counts = &traced.counts;
    let by_plane = crate::plan::ClipPlane::ALL.map(|plane| {
        let crossing = crossings.iter().filter(|crossing| crossing.plane == plane).count();
        (crossing > 0).then(|| format!("{} {crossing}", plane.name()))
    });
    let names: Vec<_> = by_plane.into_iter().flatten().collect();
    let outside = counts.clipped + counts.tessellated.clipped;
    vec![
        format!("polygons left by clipping: {}, outside: {outside}", traced.trace.clipped.len()),
        if names.is_empty() { "no plane is crossed".to_string() } else { format!("crossings: {}", names.join(", ")) },
    ]
}

fn clip_text(traced: &Traced, Crossing { polygon, plane }: Crossing, before: usize, kept: &[Vec3]) -> Vec<String> {
    let (kx, ky) = traced.plan.view.clip_from_eye();
    let clip = kept.iter().map(|corner| vec![corner.x * kx, corner.y * ky, corner.z]);
    let after = if kept.is_empty() { "nothing is left".to_string() } else { format!("{} corners", kept.len()) };
    vec![
        format!("polygon {polygon} against the plane {}, {}: {before} corners", cut::equation(plane), plane.name()),
        format!("-> {after}"),
        format!("(x, y, w) {}", points(clip)),
    ]
}

/// Areas, the view volume and the polygon in hand, from outside.
fn seen(traced: &Traced, areas: &[Area], hand: Option<&[Vec3]>, from: Outside) -> Result<Board, String> {
    let view = &traced.plan.view;
    let kept = traced.trace.clipped.iter().flat_map(|polygon| polygon.vertices.iter().map(|vertex| vertex.position.z));
    let far = kept.fold(view.hither * 2.0, f64::max);
    let (around, mut lines) = outside::volume(view, far);
    // Of very many polygons outlines would hide the areas.
    for area in areas.iter().filter(|area| area.opacity == 1.0 && areas.len() <= MOST_OUTLINES) {
        lines.extend(outside::outline(&area.corners, mixed(area.color, ink::BLACK, 128), 0));
    }
    if let Some(hand) = hand {
        lines.extend(outside::outline(hand, ink::YELLOW, 200));
    }
    let axes = [(Vec3::X, ink::RED), (Vec3::Y, ink::GREEN), (Vec3::Z, ink::BLUE)];
    let length = far / 12.0;
    lines.extend(axes.map(|(axis, color)| Line { from: Vec3::ZERO, to: axis * length, color, through: 256 }));
    let around: Vec<_> = around.into_iter().chain([Vec3::ZERO]).collect();
    outside::draw(areas, &lines, &around, from, view.pixels)
}
