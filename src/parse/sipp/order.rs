//! The order in which nodes are built, each behind all it is made of; and cycles, which have none.
//!
//! Depth-first search with a stack of its own: a node that is reached while it is still open leads back to itself.
//!
//! Source: R. Tarjan, "Depth-First Search and Linear Graph Algorithms", SIAM J. Comput. 1(2), 1972.
//! Cost: linear in nodes and references.

use super::draft::{Draft, NodeKind};
use super::names::bytes;
use crate::diagnostic::{Diagnostic, Source};
use crate::parse::wording::plain;

/// How many links of a cycle are named.
const MOST_LINKS: usize = 12;

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    Open,
    Done,
}

/// What was found.
pub(super) struct Order {
    /// The nodes below the worlds, and the worlds, children and targets first.
    pub drawn: Vec<u32>,
    /// One for each reference that closes a cycle.
    pub cycles: Vec<Diagnostic>,
}

/// Looks through all nodes; `targets[n]` is what node n refers to.
pub(super) fn order(source: &Source, draft: &Draft, targets: &[Option<u32>]) -> Order {
    let mut search = Search { source, draft, targets, states: vec![State::New; draft.nodes.len()], path: Vec::new() };
    let mut found = Order { drawn: Vec::new(), cycles: Vec::new() };
    let worlds = (0..draft.nodes.len()).filter(|&node| draft.nodes[node].kind == NodeKind::World);
    worlds.for_each(|world| search.from(world as u32, &mut found));
    let drawn = found.drawn.len();
    // What no world reaches is not built, but a cycle is a mistake there, too.
    (0..draft.nodes.len()).for_each(|node| search.from(node as u32, &mut found));
    found.drawn.truncate(drawn);
    found
}

struct Search<'a> {
    source: &'a Source,
    draft: &'a Draft,
    targets: &'a [Option<u32>],
    states: Vec<State>,
    /// Open nodes, and how many of their links were followed.
    path: Vec<(u32, usize)>,
}

impl Search<'_> {
    fn from(&mut self, root: u32, found: &mut Order) {
        self.enter(root);
        while let Some((node, followed)) = self.path.last_mut() {
            let (node, link) = (*node, *followed);
            *followed += 1;
            let children = &self.draft.nodes[node as usize].children;
            let next = children.get(link).copied().or(self.targets[node as usize].filter(|_| link == children.len()));
            match next {
                Some(next) if self.states[next as usize] == State::Open => found.cycles.push(self.cycle(next)),
                Some(next) => self.enter(next),
                None => {
                    self.states[node as usize] = State::Done;
                    self.path.pop();
                    found.drawn.push(node);
                }
            }
        }
    }

    fn enter(&mut self, node: u32) {
        if self.states[node as usize] == State::New {
            self.states[node as usize] = State::Open;
            self.path.push((node, 0));
        }
    }

    /// The innermost open node refers to `start`, which is open, too.
    fn cycle(&self, start: u32) -> Diagnostic {
        let from = self.path.iter().rposition(|&(node, _)| node == start).unwrap_or_default();
        let name = |node: u32| match plain(bytes(self.source, self.draft.nodes[node as usize].name)) {
            name if name.is_empty() => "(no name)".to_string(),
            name => name,
        };
        let is_reference = |node: u32| matches!(self.draft.nodes[node as usize].kind, NodeKind::Reference { .. });
        let objects: Vec<u32> =
            self.path[from..].iter().map(|&(node, _)| node).filter(|&node| !is_reference(node)).collect();
        let mut chain: Vec<String> = objects.iter().take(MOST_LINKS).map(|&node| name(node)).collect();
        if objects.len() > MOST_LINKS {
            chain.push(format!("... ({} more)", objects.len() - MOST_LINKS));
        }
        chain.push(name(start));
        let closing = self.path.last().map_or(start, |&(node, _)| node);
        let message = format!("`{}` uses itself: {}", name(start), chain.join(" -> "));
        Diagnostic::error(message)
            .at(self.draft.nodes[closing as usize].keyword, "this closes the circle")
            .at(self.draft.nodes[start as usize].keyword, "the object it is inside of")
            .help("an object without end cannot be drawn: write the repetition out, or use another object here")
    }
}
