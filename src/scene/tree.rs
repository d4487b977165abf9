//! Walking the tree of objects without recursion.
//!
//! Why not recursion: nesting depth is input, the stack is not. Why a budget: an object may be used by several
//! parents, so 60 doublings make 2^60 instances out of a short file.

use super::{Object, ObjectId, Scene};
use crate::math::{Affine3, Mat3, Vec3, unit};

/// One instance of an object, with the transform that leads from its local space to world space.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    /// The object.
    pub object: &'a Object,
    /// Which of [`Scene::objects`] it is.
    pub id: ObjectId,
    /// World from local: the product of all transforms up to the root.
    pub world_from_local: Affine3,
}

/// More instances than the budget allows: runaway instancing, or a cycle.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the scene has more than {budget} object instances: objects that use each other multiply")]
pub struct InstanceBudgetExceeded {
    /// The limit that was reached.
    pub budget: usize,
}

/// Memory for walking a tree; keep one and walk frame after frame without allocating.
#[derive(Debug, Default)]
pub struct Walk {
    stack: Vec<(ObjectId, Affine3)>,
    counts: Vec<Option<usize>>,
    open: Vec<bool>,
    counting: Vec<ObjectId>,
}

impl Scene {
    /// How many object instances a scene may have.
    pub const INSTANCE_BUDGET: usize = 20_000_000;

    /// Calls `visit` for every object instance, a parent before its children, children in order.
    ///
    /// # Errors
    /// [`InstanceBudgetExceeded`] when there are more than [`Scene::INSTANCE_BUDGET`] instances.
    pub fn walk(&self, visit: impl FnMut(Placed<'_>)) -> Result<(), InstanceBudgetExceeded> {
        self.walk_with(&mut Walk::default(), visit)
    }

    /// As [`Scene::walk`], with memory that was used before.
    ///
    /// # Errors
    /// As [`Scene::walk`].
    pub fn walk_with(&self, walk: &mut Walk, mut visit: impl FnMut(Placed<'_>)) -> Result<(), InstanceBudgetExceeded> {
        // Counted beforehand: 20 million visits take seconds, to no end.
        if self.instances(walk).is_none() {
            return Err(InstanceBudgetExceeded { budget: Scene::INSTANCE_BUDGET });
        }
        // Children go onto the stack in reverse, so that the first comes off first.
        let stack = &mut walk.stack;
        stack.clear();
        stack.extend(self.world.iter().rev().map(|&id| (id, self.object(id).parent_from_local)));
        while let Some((id, mut world_from_local)) = stack.pop() {
            let object = self.object(id);
            // Most scenes have none.
            if !self.facing.is_empty() && self.facing.contains(&id) {
                world_from_local = self.facing_the_eye(&world_from_local);
            }
            visit(Placed { object, id, world_from_local });
            let children = object.children.iter().rev();
            stack.extend(children.map(|&child| (child, world_from_local * self.object(child).parent_from_local)));
        }
        Ok(())
    }

    /// The same place, with the object's front turned to the eye about its own z axis. An eye on that axis sees it as it stands.
    ///
    /// No angle is needed: across is square to the axis and to the way to the eye (Caralo's `atan` divides by zero where the eye is in line).
    fn facing_the_eye(&self, placed: &Affine3) -> Affine3 {
        let [x, y, z] = [placed.matrix3.x_axis, placed.matrix3.y_axis, placed.matrix3.z_axis];
        let way = self.camera.map_or(Vec3::ZERO, |camera| camera.from - placed.translation);
        let Some(axis) = unit(z) else { return *placed };
        let Some(ahead) = unit(way - axis * axis.dot(way)) else { return *placed };
        let across = axis.cross(ahead);
        let matrix3 = Mat3::from_cols(across * x.length(), -ahead * y.length(), z);
        Affine3 { matrix3, translation: placed.translation }
    }

    /// How many instances there are; `None` for more than the budget and for an object within itself. Every object is looked at once.
    fn instances(&self, walk: &mut Walk) -> Option<usize> {
        let Walk { counts, open, counting: stack, .. } = walk;
        counts.clear();
        counts.resize(self.objects.len(), None);
        open.clear();
        open.resize(self.objects.len(), false);
        let of = |counts: &[Option<usize>], ids: &[ObjectId]| {
            let sum = ids.iter().try_fold(0_usize, |sum, id| Some(sum.saturating_add(counts[id.0 as usize]?)));
            sum.filter(|&sum| sum <= Scene::INSTANCE_BUDGET)
        };
        stack.clear();
        stack.extend_from_slice(&self.world);
        while let Some(&id) = stack.last() {
            let (index, children) = (id.0 as usize, &self.object(id).children);
            if counts[index].is_some() {
                stack.pop();
            } else if open[index] {
                // Everything below has been counted, unless it leads back here.
                counts[index] = Some(1 + of(counts, children)?);
                stack.pop();
            } else {
                open[index] = true;
                stack.extend(children.iter().filter(|child| !open[child.0 as usize]));
            }
        }
        of(counts, &self.world)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Camera, Place};

    fn object(name: &str, x: f64, children: &[u32]) -> Object {
        Object {
            name: name.to_string(),
            parent_from_local: Affine3::from_translation(Vec3::new(x, 0.0, 0.0)),
            surfaces: Vec::new(),
            children: children.iter().map(|&id| ObjectId(id)).collect(),
            place: Place::default(),
        }
    }

    #[test]
    fn what_faces_the_camera_does_so_from_everywhere() {
        let camera = |from: Vec3| Camera {
            from,
            at: Vec3::ZERO,
            up: Vec3::Z,
            angle: 45.0,
            hither: 1.0,
            yon: None,
            resolution: (8, 8),
            place: Place::default(),
        };
        let placed = |from: Vec3| {
            let scale = Affine3::from_scale(Vec3::new(2.0, 3.0, 5.0));
            let parent_from_local = Affine3::from_translation(Vec3::new(1.0, 2.0, 3.0)) * scale;
            let objects = vec![Object { parent_from_local, ..object("tree", 0.0, &[]) }];
            let world = vec![ObjectId(0)];
            let facing = world.iter().copied().collect();
            let scene = Scene { objects, world, facing, camera: Some(camera(from)), ..Scene::default() };
            let mut found = Affine3::IDENTITY;
            scene.walk(|placed| found = placed.world_from_local).expect("one object");
            found
        };
        let mut before = placed(Vec3::new(11.0, 2.0, 40.0)).matrix3;
        for degree in 0..=360 {
            let angle = crate::math::radians(f64::from(degree));
            let (sin, cos) = (crate::math::sin(angle), crate::math::cos(angle));
            let found = placed(Vec3::new(1.0 + 10.0 * cos, 2.0 + 10.0 * sin, 40.0));
            let matrix = found.matrix3;
            assert!((matrix.y_axis - Vec3::new(-3.0 * cos, -3.0 * sin, 0.0)).length() < 1e-12, "{degree}");
            assert!((matrix.x_axis.length() - 2.0).abs() < 1e-12 && matrix.z_axis == Vec3::new(0.0, 0.0, 5.0));
            assert!((matrix.determinant() - 30.0).abs() < 1e-9 && (matrix.x_axis - before.x_axis).length() < 0.05);
            assert_eq!(found.translation, Vec3::new(1.0, 2.0, 3.0));
            before = matrix;
        }
        // Straight above and at no distance it stands as it does.
        for from in [Vec3::new(1.0, 2.0, 40.0), Vec3::new(1.0, 2.0, 3.0)] {
            assert_eq!(placed(from).matrix3.x_axis, Vec3::new(2.0, 0.0, 0.0));
        }
    }

    #[test]
    fn parents_come_before_children_and_transforms_multiply() {
        let objects = vec![object("arm", 1.0, &[1, 2]), object("hand", 10.0, &[]), object("clock", 20.0, &[])];
        let scene = Scene { objects, world: vec![ObjectId(0)], ..Scene::default() };
        let mut seen = Vec::new();
        scene
            .walk(|placed| seen.push((placed.object.name.clone(), placed.world_from_local.translation.x)))
            .expect("small");
        assert_eq!(seen, [("arm".into(), 1.0), ("hand".into(), 11.0), ("clock".into(), 21.0)]);
    }

    #[test]
    fn a_hundred_thousand_nested_objects_walk_and_drop() {
        let count = 100_000;
        let objects: Vec<_> = (0..count).map(|i| object("", 1.0, if i + 1 < count { &[0] } else { &[] })).collect();
        let mut scene = Scene { objects, world: vec![ObjectId(0)], ..Scene::default() };
        for (index, object) in scene.objects.iter_mut().enumerate() {
            object.children.iter_mut().for_each(|child| *child = ObjectId(index as u32 + 1));
        }
        let mut deepest = 0.0;
        scene.walk(|placed| deepest = placed.world_from_local.translation.x).expect("within the budget");
        assert_eq!(deepest, f64::from(count));
    }

    #[test]
    fn doubling_sixty_times_is_an_error() {
        let objects = (0..60).map(|i| object("", 0.0, &[i + 1, i + 1])).chain([object("", 0.0, &[])]).collect();
        let scene = Scene { objects, world: vec![ObjectId(0)], ..Scene::default() };
        assert!(scene.walk(|_| ()).is_err());
    }

    #[test]
    fn an_object_within_itself_is_an_error() {
        let two = vec![object("", 0.0, &[1]), object("", 0.0, &[2, 0]), object("", 0.0, &[])];
        for objects in [vec![object("", 0.0, &[0])], two] {
            let scene = Scene { objects, world: vec![ObjectId(0)], ..Scene::default() };
            assert!(scene.walk(|_| ()).is_err());
        }
    }

    #[test]
    fn a_shared_child_is_visited_by_every_parent() {
        let objects = vec![object("", 0.0, &[1, 2, 1]), object("", 0.0, &[2]), object("leaf", 0.0, &[])];
        let scene = Scene { objects, world: vec![ObjectId(0), ObjectId(1)], ..Scene::default() };
        let mut leaves = 0;
        scene.walk(|placed| leaves += u32::from(placed.object.name == "leaf")).expect("small");
        assert_eq!(leaves, 4);
    }
}
