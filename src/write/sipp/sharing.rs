//! Which objects stand in several places, and what every object is called.
//!
//! Two objects are the same body when name, surfaces, and children (bodies and transforms) are the same; their own transforms may differ, as
//! those of the instances of a definition do. Bodies are told apart from the leaves up, so a scene whose sharing was taken apart node by
//! node, as `copy` does, is said with `use` again. Nobody can see the difference: a scene that was read does not change.
//!
//! Cost: one look into a hash table for each object; the tables are never walked, so their order shows nowhere.

use super::losses::Losses;
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

    /// The first body of a name keeps it; the next are `name-2`, `name-3`. Shared bodies without a name are `part`.
    fn give_names(&mut self, scene: &Scene, losses: &mut Losses) {
        let mut taken: HashSet<String> = HashSet::new();
        let mut later = Vec::new();
        for (index, body) in self.bodies.iter_mut().enumerate() {
            let own = &scene.object(body.object).name;
            let name = sayable(own);
            if name.is_empty() && body.places <= 1 {
                continue;
            }
            if name == *own && !name.is_empty() && taken.insert(name.clone()) {
                body.name = quoted(&name);
            } else {
                later.push((index, if name.is_empty() { "part".to_string() } else { name }));
            }
        }
        losses.names += later.len();
        // Where the search for a free number goes on, by name.
        let mut next: HashMap<String, usize> = HashMap::new();
        for (index, name) in later {
            let number = next.entry(name.clone()).or_insert(1);
            let mut free = name.clone();
            while !taken.insert(free.clone()) {
                *number += 1;
                free = format!("{name}-{number}");
            }
            self.bodies[index].name = quoted(&free);
        }
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

/// `name` without what cannot stand between quotes.
fn sayable(name: &str) -> String {
    name.chars().map(|letter| if letter.is_control() || matches!(letter, '"' | '#') { '_' } else { letter }).collect()
}

/// A name as written in the file: in quotes, unless it is made of plain letters.
fn quoted(name: &str) -> String {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '.' | '-');
    let starts_plain = name.starts_with(|letter: char| letter.is_ascii_alphabetic() || letter == '_');
    if starts_plain && name.chars().all(is_plain) { name.to_string() } else { format!("\"{name}\"") }
}
