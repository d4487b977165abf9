//! Line spans: which face a sample of a line shows when faces are told apart by whole spans, as scan-line programs do.
//!
//! A span: neighboring samples that the same faces cover. Cost: faces times samples of the line, and halving.

use super::case::Case;
use super::rules::{LineSpans, Rules};
use super::stack::Stack;

/// A span: samples from `first` up to `end`, and the faces that are thought to cover all of it.
struct Span {
    first: i32,
    end: i32,
    faces: Vec<usize>,
}

/// What the samples of row `y` show; `None` when each is asked by itself.
pub(super) fn stacks<I: Iterator<Item = usize>>(
    case: &Case,
    rules: &Rules,
    y: i32,
    covers: &impl Fn(i32) -> I,
) -> Option<Vec<Stack>> {
    if rules.line == LineSpans::None {
        return None;
    }
    let covering: Vec<Vec<usize>> = (0..case.width as i32).map(|x| covers(x).collect()).collect();
    if let Some(faces) = events(case, rules, y, &covering) {
        let stack = |(x, faces): (usize, &Vec<usize>)| Stack::of(case, rules, (x as i32, y), faces.iter().copied());
        return Some(faces.iter().enumerate().map(stack).collect());
    }
    let mut spans = cut(&covering, rules.line);
    match rules.line {
        LineSpans::LastLost => drop(spans.pop()),
        LineSpans::FirstLost if !spans.is_empty() => drop(spans.remove(0)),
        LineSpans::LastSampleLost => spans.iter_mut().for_each(|span| span.end -= 1),
        LineSpans::FirstSampleLost => spans.iter_mut().for_each(|span| span.first += 1),
        _ => {}
    }
    let mut line = Line { case, rules, y, shown: vec![Stack::default(); covering.len()] };
    for span in spans {
        line.show(&span.faces, (span.first, span.end - 1), true);
    }
    Some(line.shown)
}

/// The faces that every sample is thought to have, where they come and go from event to event; `None` for other rules.
fn events(case: &Case, rules: &Rules, y: i32, covering: &[Vec<usize>]) -> Option<Vec<Vec<usize>>> {
    if matches!(rules.line, LineSpans::ListOrder | LineSpans::ListOrderOnward) {
        return Some(in_list_order(case.faces.len(), covering, rules.line == LineSpans::ListOrderOnward));
    }
    if !matches!(rules.line, LineSpans::NothingBehind | LineSpans::NothingUntilNext | LineSpans::LatestBegun) {
        return None;
    }
    let nearest = |x: usize, faces: &[usize]| {
        Stack::of(case, rules, (x as i32, y), faces.iter().copied()).front.map(|front| front.0)
    };
    let (mut known, mut before, mut seen): (Vec<usize>, &[usize], Vec<Vec<usize>>) = (Vec::new(), &[], Vec::new());
    for (x, faces) in covering.iter().enumerate() {
        let begins: Vec<usize> = faces.iter().filter(|face| !before.contains(face)).copied().collect();
        let front = if x > 0 { nearest(x - 1, &known) } else { None };
        let has_lost_front = front.is_some_and(|front| !faces.contains(&front));
        known.retain(|face| faces.contains(face));
        match rules.line {
            LineSpans::LatestBegun if !begins.is_empty() => known = begins,
            LineSpans::LatestBegun if known.is_empty() => known.clone_from(faces),
            LineSpans::LatestBegun => {}
            _ if has_lost_front => known = begins,
            LineSpans::NothingUntilNext if !begins.is_empty() => known.clone_from(faces),
            _ => known.extend(begins),
        }
        known.sort_unstable();
        seen.push(known.clone());
        before = faces;
    }
    Some(seen)
}

/// Spans between events that are in the order of the list: what runs backward is empty.
fn in_list_order(count: usize, covering: &[Vec<usize>], is_onward: bool) -> Vec<Vec<usize>> {
    let has = |x: usize, face: usize| covering.get(x).is_some_and(|faces| faces.contains(&face));
    let mut events: Vec<(usize, usize)> = Vec::new();
    for face in 0..count {
        let changes = (0..=covering.len()).filter(|&x| has(x, face) != (x > 0 && has(x - 1, face)));
        events.extend(changes.map(|x| (x, face)));
    }
    let (mut open, mut seen): (Vec<usize>, Vec<Vec<usize>>) = (Vec::new(), vec![Vec::new(); covering.len()]);
    let mut drawn = 0;
    for (number, &(x, face)) in events.iter().enumerate() {
        match open.iter().position(|&other| other == face) {
            Some(at) => drop(open.remove(at)),
            None => open.push(face),
        }
        let end = events.get(number + 1).map_or(x, |next| next.0);
        drawn = drawn.max(x);
        for faces in seen.iter_mut().take(end).skip(if is_onward { drawn } else { x }) {
            faces.clone_from(&open);
        }
    }
    seen
}

fn cut(covering: &[Vec<usize>], rule: LineSpans) -> Vec<Span> {
    let is_cut = |before: &[usize], here: &[usize]| {
        let begins = here.iter().any(|face| !before.contains(face));
        let ends = before.iter().any(|face| !here.contains(face));
        match rule {
            LineSpans::EndsCutNothing => begins,
            LineSpans::BeginningsCutNothing => ends || before.is_empty(),
            _ => begins || ends,
        }
    };
    let mut spans: Vec<Span> = Vec::new();
    let last = covering.iter().rposition(|faces| !faces.is_empty()).map_or(0, |last| last + 1);
    for (x, faces) in covering[..last].iter().enumerate() {
        let x = x as i32;
        match spans.last_mut() {
            Some(span) if !is_cut(&covering[x as usize - 1], faces) => span.end = x + 1,
            _ => spans.push(Span { first: x, end: x + 1, faces: faces.clone() }),
        }
    }
    spans.retain(|span| !span.faces.is_empty());
    spans
}

struct Line<'a> {
    case: &'a Case,
    rules: &'a Rules,
    y: i32,
    shown: Vec<Stack>,
}

impl Line<'_> {
    fn at(&self, faces: &[usize], x: i32) -> Stack {
        Stack::of(self.case, self.rules, (x, self.y), faces.iter().copied())
    }

    /// Shows a span, both ends included.
    fn show(&mut self, faces: &[usize], (first, last): (i32, i32), is_whole: bool) {
        if first > last {
            return;
        }
        let (left, right, middle) = (self.at(faces, first), self.at(faces, last), (first + last) / 2);
        let front = |stack: &Stack| stack.front.map(|front| front.0);
        let is_same = front(&left) == front(&right);
        match self.rules.line {
            LineSpans::LeftEnd => self.fill((first, last), &left),
            LineSpans::RightEnd => self.fill((first, last), &right),
            LineSpans::Middle => self.fill((first, last), &self.at(faces, middle)),
            LineSpans::HalvedOnce | LineSpans::MiddleLost if is_same => self.fill((first, last), &left),
            LineSpans::HalvedOnce => {
                self.fill((first, middle), &left);
                self.fill((middle + 1, last), &right);
            }
            LineSpans::MiddleLost => {
                self.show(faces, (first, middle - 1), false);
                self.show(faces, (middle + 1, last), false);
            }
            _ if is_whole => {
                for x in first..=last {
                    self.shown[x as usize] = self.at(faces, x);
                }
            }
            _ => {}
        }
    }

    fn fill(&mut self, (first, last): (i32, i32), stack: &Stack) {
        for x in first..=last {
            self.shown[x as usize] = stack.clone();
        }
    }
}
