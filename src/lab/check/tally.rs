//! Tally: counts by name, summed over parts of an experiment that run side by side.
//!
//! Every part has random numbers of its own and parts are added up in order, so the sums depend on the seed alone and not on
//! how many threads there were.

use std::collections::BTreeMap;

/// Threads of an experiment. Fixed: what ran must be comparable from machine to machine.
const THREADS: u64 = 2;

/// Counts by name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Tally {
    counts: BTreeMap<&'static str, u64>,
    /// The first few cases that went wrong, in words.
    pub examples: Vec<String>,
}

impl Tally {
    /// Adds `count` to the count called `name`.
    pub fn add(&mut self, name: &'static str, count: u64) {
        *self.counts.entry(name).or_default() += count;
    }

    /// The count called `name`.
    pub fn of(&self, name: &str) -> u64 {
        self.counts.get(name).copied().unwrap_or(0)
    }

    /// Keeps `example`, if there are not enough already.
    pub fn example(&mut self, example: impl FnOnce() -> String) {
        if self.examples.len() < 3 {
            self.examples.push(example());
        }
    }

    /// Adds the counts of `other`.
    pub fn append(&mut self, other: Tally) {
        for (name, count) in other.counts {
            self.add(name, count);
        }
        self.examples.extend(other.examples);
        self.examples.truncate(3);
    }
}

/// The sum of what `part` finds in parts 0 to before `parts`.
pub(super) fn sum(parts: u64, part: impl Fn(u64, &mut Tally) + Sync) -> Tally {
    let run = |thread: u64| {
        // A contiguous run for every thread, so that examples come in the order of the parts.
        let mut tally = Tally::default();
        for number in parts * thread / THREADS..parts * (thread + 1) / THREADS {
            part(number, &mut tally);
        }
        tally
    };
    let run = &run;
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..THREADS).map(|thread| scope.spawn(move || run(thread))).collect();
        let mut sum = Tally::default();
        for thread in threads {
            match thread.join() {
                Ok(tally) => sum.append(tally),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        sum
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_is_run_once() {
        let tally = sum(7, |number, tally| {
            tally.add("parts", 1);
            tally.add("numbers", number);
        });
        assert_eq!((tally.of("parts"), tally.of("numbers"), tally.of("others")), (7, 21, 0));
    }
}
