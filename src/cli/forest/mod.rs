//! `farop forest`: what is in a forest, pictures of it, walks through it.
//!
//! `.fcell`, `.fpack` -cells-> report, or observer -Composer-> Scene a frame -> picture, movie, hashes, figures
//!
//! One command and three verbs: the command looks, `pack`, `unpack` and `new` make files.

mod inspect;
mod options;
mod stock;
mod walk;

use super::error::CliError;
use crate::raster::Registry;
pub(super) use options::ForestCommand;
use options::Verb;

impl ForestCommand {
    pub fn run(self: Box<Self>, registry: &Registry) -> Result<(), CliError> {
        match self.verb {
            Some(Verb::Pack(ref pack)) => pack.run(),
            Some(Verb::Unpack(ref unpack)) => unpack.run(),
            Some(Verb::New(ref new)) => new.run(),
            None => self.look(registry),
        }
    }

    fn look(&self, _registry: &Registry) -> Result<(), CliError> {
        let Some(path) = &self.file else {
            return Err(CliError::failed("name a forest, as in `farop forest area.fpack`"));
        };
        let cells = stock::open(path)?;
        inspect::report(path, &cells, self.year)
    }
}
