//! What rasterizers put into targets, counted.
//!
//! Target -finish-> PUT COUNTS -> `--stats`, the grader

use super::external::Confinement;
use super::order::Order;
use std::collections::BTreeMap;

/// What was put, for `--stats`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PutCounts {
    /// Fragments put inside the picture.
    pub puts: u64,
    /// Opaque fragments put where an opaque one already was.
    pub overdraw: u64,
    /// Fragments outside the picture: dropped.
    pub stray_writes: u64,
    /// Samples of a picture that was finished elsewhere: nobody knows which polygon they show; see [`super::Target::show`].
    pub shown: u64,
    /// What the rasterizer itself counted, by name; see [`super::Target::count`].
    pub own: BTreeMap<&'static str, u64>,
    /// As `own`, for numbers of which only the largest matters; see [`super::Target::count_most`].
    pub most: BTreeMap<&'static str, u64>,
    /// Why there is no picture: a program outside farop that did not give one; see [`super::Target::fail`].
    pub failure: Option<String>,
    /// What held the program outside farop that drew the picture; see [`super::Target::confined`].
    pub confinement: Option<Confinement>,
    /// In which order fragments were put, and whether depth was read: only of a target that watches, see [`super::Target::watched`].
    pub order: Option<Order>,
}

impl std::ops::AddAssign for PutCounts {
    fn add_assign(&mut self, other: Self) {
        self.puts += other.puts;
        self.overdraw += other.overdraw;
        self.stray_writes += other.stray_writes;
        self.shown += other.shown;
        for (name, count) in other.own {
            *self.own.entry(name).or_default() += count;
        }
        for (name, count) in other.most {
            let most = self.most.entry(name).or_default();
            *most = count.max(*most);
        }
        self.failure = self.failure.take().or(other.failure);
        self.confinement = self.confinement.take().or(other.confinement);
        if let Some(order) = other.order {
            self.order.get_or_insert_default().add(order);
        }
    }
}
