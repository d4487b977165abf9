//! `farop terrain`: grids of heights in, a relief of few triangles out: as a scene, as a picture, as figures.

mod command;
mod covers;
mod maps;
mod progressive;
mod relief;
mod report;

pub(super) use command::TerrainCommand;
