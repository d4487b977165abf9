//! Threads: surfaces and shapes shared among hands, in such a way that the list does not tell how many there were.
//!
//! tasks -THREADS-> hands, a list for each part -JOIN-> DrawList
//!
//! Small tasks are handed out in groups of neighbors; a large surface is cut into ranges, once for each step. A part gets a list of
//! its own, and the lists are joined in the order of the scene. What is shared (vertices, their light) is computed once, however many
//! threads there are, so that even the counts are the same.
//!
//! Why not one list that all write into: how long a part gets is known only when its polygons are clipped.
//! Space: as `hand`. Cost: two thirds of the list are copied once where two threads or more are at work.

use super::cull::Survivor;
use super::hand::Hand;
use super::walk::EyeMesh;
use super::{Setting, Task};
use crate::screen::{DrawList, OWN, PolygonRecord, Shared, SharedTriangle};
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Below this weight, in polygons, starting threads takes longer than what they save.
const SMALL: usize = 4096;
/// Groups of small tasks for each thread: more of them even out what nobody knew beforehand.
const GROUPS: usize = 4;

/// Those who do the work, and memory for what they share. Kept from frame to frame.
#[derive(Default)]
pub(super) struct Crew {
    /// One for each thread; the first is the caller's.
    pub hands: Vec<Hand>,
    /// A list for each part but the first, which goes straight to the end of the frame's.
    lists: Vec<DrawList>,
    /// Vertices of the large surface in hand.
    mesh: EyeMesh,
    /// What culling left of its ranges.
    survivors: Vec<Vec<Survivor>>,
}

impl Task {
    /// How much work it is, roughly, in polygons.
    fn weight(&self) -> usize {
        self.polygons.len() + 256 * self.shapes.len()
    }

    /// Worth cutting up: polygons only, and many.
    fn is_large(&self) -> bool {
        self.shapes.is_empty() && self.polygons.len() >= 2 * SMALL
    }
}

impl Crew {
    /// Appends to `list` what the tasks make, in their order.
    pub fn work(&mut self, tasks: &[Task], setting: &Setting<'_>, list: &mut DrawList) {
        let weight = |tasks: &[Task]| tasks.iter().map(Task::weight).sum::<usize>();
        // Asking how many threads there are takes time, too.
        let threads = if weight(tasks) < SMALL { 1 } else { setting.threads() };
        self.hands.resize_with(self.hands.len().max(threads), Hand::default);
        for run in tasks.chunk_by(|a, b| threads == 1 || !(a.is_large() || b.is_large())) {
            match run {
                [task] if task.is_large() && threads > 1 => self.large(task, threads, setting, list),
                _ if threads > 1 && weight(run) >= SMALL => self.many(run, threads, setting, list),
                _ => run.iter().for_each(|task| self.hands[0].task(task, setting, list)),
            }
        }
    }

    /// Many small tasks: each thread takes a group of neighbors, and then the next.
    fn many(&mut self, tasks: &[Task], threads: usize, setting: &Setting<'_>, list: &mut DrawList) {
        let groups = groups(tasks, threads * GROUPS);
        self.lists.resize_with(self.lists.len().max(groups.len()), || DrawList::new(0, 0));
        let Crew { hands, lists, .. } = self;
        let lists = &mut lists[..groups.len() - 1];
        let targets = prepared(list, lists);
        share(&mut hands[..threads], groups.into_iter().zip(targets).collect(), |hand, (group, list)| {
            group.iter().for_each(|task| hand.task(task, setting, list));
        });
        join(list, lists, Corners::InParts);
    }

    /// One large surface: each step is done by all threads, a range each.
    fn large(&mut self, task: &Task, threads: usize, setting: &Setting<'_>, list: &mut DrawList) {
        let part = task.part(setting.scene);
        self.lists.resize_with(self.lists.len().max(threads), || DrawList::new(0, 0));
        self.survivors.resize_with(self.survivors.len().max(threads), Vec::new);
        let Crew { hands, lists, mesh, survivors } = self;
        let (hands, survivors) = (&mut hands[..threads], &mut survivors[..threads]);
        // Vertices.
        mesh.stand_behind(&list.shared);
        let vertices = mesh.open(part.mesh, setting, &mut hands[0].counts.work).parts(threads);
        share(hands, vertices, |_, range| range.fill(&task.world_from_local, setting.plan, setting.level));
        // Culling; then, in the order of the polygons, what the survivors ask for.
        let shared: &EyeMesh = mesh;
        let ranges = even(&task.polygons, threads).zip(survivors.iter_mut()).collect();
        share(hands, ranges, |hand, (range, survivors): (Range<usize>, &mut Vec<_>)| {
            survivors.clear();
            hand.cull(part, shared, range, setting, survivors);
        });
        survivors.iter().for_each(|survivors| mesh.ask(part, survivors));
        let asked = mesh.asked(setting);
        share(hands, asked.parts(threads), |hand, asked| hand.compute(asked, part, setting));
        // Light, clipping, splitting, projecting.
        let shared: &EyeMesh = mesh;
        let lists = &mut lists[..threads - 1];
        let parts = survivors.iter().zip(prepared(list, lists)).collect();
        share(hands, parts, |hand, (survivors, list): (&Vec<_>, &mut DrawList)| {
            hand.emit((part, shared), survivors, setting, list);
        });
        join(list, lists, Corners::Together);
        mesh.hand_over(&mut list.shared);
    }
}

/// Hands out `parts` in their order, each to the first hand that is free.
fn share<T: Send>(hands: &mut [Hand], parts: Vec<T>, work: impl Fn(&mut Hand, T) + Sync) {
    let parts = Mutex::new(parts.into_iter());
    let next = || parts.lock().unwrap_or_else(PoisonError::into_inner).next();
    let take = |hand: &mut Hand| {
        while let Some(part) = next() {
            work(hand, part);
        }
    };
    let (own, others) = hands.split_at_mut(1);
    std::thread::scope(|scope| {
        others.iter_mut().for_each(|hand| drop(scope.spawn(|| take(hand))));
        own.iter_mut().for_each(take);
    });
}

/// The frame's list and emptied ones, for the parts of a task in their order.
fn prepared<'a>(list: &'a mut DrawList, lists: &'a mut [DrawList]) -> impl Iterator<Item = &'a mut DrawList> {
    lists.iter_mut().for_each(DrawList::clear);
    std::iter::once(list).chain(lists)
}

/// `range` in `count` parts of nearly the same length.
fn even(range: &Range<usize>, count: usize) -> impl Iterator<Item = Range<usize>> {
    let (start, length) = (range.start, range.len());
    (0..count).map(move |part| start + length * part / count..start + length * (part + 1) / count)
}

/// Neighbors in at most `count` groups of nearly the same weight.
fn groups(tasks: &[Task], count: usize) -> Vec<&[Task]> {
    let each = tasks.iter().map(Task::weight).sum::<usize>().div_ceil(count).max(1);
    let (mut rest, mut groups) = (tasks, Vec::new());
    while !rest.is_empty() {
        let mut weight = 0;
        let is_full = |task: &Task| {
            weight += task.weight();
            weight >= each
        };
        let length = rest.iter().position(is_full).map_or(rest.len(), |last| last + 1);
        let (group, others) = rest.split_at(length);
        groups.push(group);
        rest = others;
    }
    groups
}

/// Where corners of shared triangles are.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Corners {
    /// In the lists of the parts, as theirs.
    InParts,
    /// In a mesh that all parts have in common.
    Together,
}

/// Appends `parts` to `list`, its arrays side by side.
fn join(list: &mut DrawList, parts: &[DrawList], corners: Corners) {
    let DrawList { vertices, values, planes, polygons, shared, .. } = list;
    let mut first = [vertices.len(), planes.len(), shared.triangles.len()].map(|length| length as u32);
    std::thread::scope(|scope| {
        if parts.iter().any(|part| !part.vertices.is_empty()) {
            scope.spawn(move || {
                parts.iter().for_each(|part| planes.extend_from_slice(&part.planes));
                parts.iter().for_each(|part| values.extend_from_slice(&part.values));
            });
        }
        parts.iter().for_each(|part| vertices.extend_from_slice(&part.vertices));
        for part in parts {
            polygons.extend(part.polygons.iter().map(|record| match record.is_shared() {
                true => PolygonRecord { first_vertex: record.first_vertex + first[2], ..*record },
                false => PolygonRecord {
                    first_vertex: record.first_vertex + first[0],
                    first_plane: record.first_plane + first[1],
                    ..*record
                },
            }));
            join_shared(shared, &part.shared, corners);
            let lengths = [part.vertices.len(), part.planes.len(), part.shared.triangles.len()];
            first = [0, 1, 2].map(|array| first[array] + lengths[array] as u32);
        }
    });
}

/// Appends the shared triangles of a part, and what belongs to them.
fn join_shared(shared: &mut Shared, part: &Shared, corners: Corners) {
    let own = shared.own.light.len() as u32;
    let before = match corners {
        Corners::InParts => [shared.places.len() as u32, shared.of_vertices.light.len() as u32],
        Corners::Together => [0; 2],
    };
    let value = |value: u32| if value & OWN != 0 { value + own } else { value + before[1] };
    shared.triangles.extend(part.triangles.iter().map(|triangle| SharedTriangle {
        corners: triangle.corners.map(|corner| corner + before[0]),
        values: triangle.values.map(value),
    }));
    shared.places.extend_from_slice(&part.places);
    shared.corners.extend_from_slice(&part.corners);
    shared.uv.extend_from_slice(&part.uv);
    shared.of_vertices.append(&part.of_vertices);
    shared.own.append(&part.own);
}
