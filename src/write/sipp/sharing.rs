//! Which objects stand in several places, and what every object is called.
//!
//! Two objects are the same body when name, surfaces, and children (bodies and transforms) are the same; their own transforms may differ, as
//! those of the instances of a definition do. Bodies are told apart from the leaves up, so a scene whose sharing was taken apart node by
//! node, as `copy` does, is said with `use` again. Nobody can see the difference: a scene that was read does not change.
//!
//! Cost: one look into a hash table for each object; the tables are never walked, so their order shows nowhere.

use super::losses::Losses;
use crate::diagnostic::printable;
use crate::scene::{ObjectId, Scene, SurfaceId};
use std::collections::{HashMap, HashSet};
use std::io;

/// Bodies, how often each is used, and their names.
pub(super) struct Sharing {
    /// For each object of the scene the index of its body; `None` where nothing leads to it.
    body: Vec<Option<u32>>,
    bodies: Vec<Body>,
    /// One object of each body that stands in several places.
    pub definitions: Vec<ObjectId>,
    /// Surfaces of all bodies, in order.
    surfaces: Vec<SurfaceId>,
}

/// What equal objects have in common.
struct Body {
    /// The first object with it.
    object: ObjectId,
    places: usize,
    /// As written in the file, quoted where it must be; may be empty where it stands in one place.
    name: String,
}

/// What makes a body: name, surfaces, children with the bits of their transforms.
type Key<'a> = (&'a str, &'a [SurfaceId], Vec<(u32, [u64; 12])>);

impl Sharing {
    /// Finds the bodies of `scene`.
    ///
    /// # Errors
    /// An object is inside itself.
    pub fn of(scene: &Scene, losses: &mut Losses) -> io::Result<Sharing> {
        let mut sharing = Sharing {
            body: vec![None; scene.objects.len()],
            bodies: Vec::new(),
            definitions: Vec::new(),
            surfaces: Vec::new(),
        };
        let mut known: HashMap<Key<'_>, u32> = HashMap::new();
        for id in children_first(scene)? {
            let object = scene.object(id);
            let child = |&child: &ObjectId| (sharing.body_of(child), bits(scene, child));
            let key = (object.name.as_str(), &object.surfaces[..], object.children.iter().map(child).collect());
            let body = *known.entry(key).or_insert(sharing.bodies.len() as u32);
            if body as usize == sharing.bodies.len() {
                sharing.bodies.push(Body { object: id, places: 0, name: String::new() });
                sharing.surfaces.extend(&object.surfaces);
                object.children.iter().for_each(|&child| sharing.count_place(child));
            }
            sharing.body[id.0 as usize] = Some(body);
        }
        scene.world.iter().for_each(|&id| sharing.count_place(id));
        let shared = sharing.bodies.iter().filter(|body| body.places > 1);
        sharing.definitions = shared.map(|body| body.object).collect();
        sharing.give_names(scene, losses);
        Ok(sharing)
    }

    /// Whether it is written as a definition and uses of it.
    pub fn is_shared(&self, id: ObjectId) -> bool {
        self.bodies[self.body_of(id) as usize].places > 1
    }

    /// Its name as written in the file; may be empty.
    pub fn name(&self, id: ObjectId) -> &str {
        &self.bodies[self.body_of(id) as usize].name
    }

    /// The surfaces that are written.
    pub fn surfaces(&self) -> impl Iterator<Item = SurfaceId> + '_ {
        self.surfaces.iter().copied()
    }

    fn body_of(&self, id: ObjectId) -> u32 {
        self.body[id.0 as usize].expect("children come before their parents")
    }

    fn count_place(&mut self, id: ObjectId) {
        let body = self.body_of(id) as usize;
        self.bodies[body].places += 1;
    }

    /// Nested objects may share names, definitions may not: the first of a name keeps it, the next are `name-2`, `name-3`. Definitions
    /// without a name are `part`.
    fn give_names(&mut self, scene: &Scene, losses: &mut Losses) {
        let is_definition = |body: &&mut Body| body.places > 1;
        let own = |body: &Body| scene.object(body.object).name.as_str();
        for body in &mut self.bodies {
            body.name = sayable(own(body));
            losses.names += usize::from(body.name != own(body));
        }
        // Who has a name of its own keeps it before others get one made up.
        let mut taken: HashSet<String> = HashSet::new();
        let mut later = Vec::new();
        for body in self.bodies.iter_mut().filter(is_definition) {
            if body.name.is_empty() || !taken.insert(body.name.clone()) {
                later.push(body);
            }
        }
        losses.names += later.len();
        // Where the search for a free number goes on, by name.
        let mut numbers: HashMap<String, usize> = HashMap::new();
        for body in later {
            let name = if body.name.is_empty() { "part".to_string() } else { std::mem::take(&mut body.name) };
            let number = numbers.entry(name.clone()).or_insert(1);
            body.name.clone_from(&name);
            while !taken.insert(body.name.clone()) {
                *number += 1;
                body.name = format!("{name}-{number}");
            }
        }
        self.bodies.iter_mut().for_each(|body| body.name = quoted(&body.name));
    }
}

/// All objects that the world leads to, children before their parents.
fn children_first(scene: &Scene) -> io::Result<Vec<ObjectId>> {
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Done,
    }
    let mut order = Vec::new();
    let mut states = vec![State::New; scene.objects.len()];
    // Objects, and how many of their children were looked at.
    let mut stack: Vec<(ObjectId, usize)> = Vec::new();
    for &top in &scene.world {
        stack.push((top, 0));
        while let Some((id, looked_at)) = stack.pop() {
            let state = &mut states[id.0 as usize];
            if *state == State::Done || (*state == State::Open && looked_at == 0) {
                if *state == State::Open {
                    let text = format!("the object `{}` is inside itself", scene.object(id).name);
                    return Err(io::Error::new(io::ErrorKind::InvalidData, text));
                }
                continue;
            }
            *state = State::Open;
            match scene.object(id).children.get(looked_at) {
                Some(&child) => stack.extend([(id, looked_at + 1), (child, 0)]),
                None => {
                    *state = State::Done;
                    order.push(id);
                }
            }
        }
    }
    Ok(order)
}

/// The transform of an object as bits, that equal ones can be found. Both zeros are one.
fn bits(scene: &Scene, id: ObjectId) -> [u64; 12] {
    scene.object(id).parent_from_local.to_cols_array().map(|number| (number + 0.0).to_bits())
}

/// `name` without what cannot stand between quotes, or would not be safe to print.
pub(super) fn sayable(name: &str) -> String {
    printable(name.as_bytes()).replace(['"', '#'], "_")
}

/// A name as written in the file: in quotes, unless it is made of plain letters.
fn quoted(name: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '.' | '-');
    let starts_plain = name.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_');
    if name.is_empty() || starts_plain && name.chars().all(is_plain) { name.to_string() } else { format!("\"{name}\"") }
}
