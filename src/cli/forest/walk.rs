//! Where a walk leads: poses read from a file, or made from places; and trees that are in the way.

use super::observer::Observer;
use super::options::{CollideName, ForestCommand, Walk};
use crate::cli::error::{CliError, notice};
use crate::forest::cells::Cells;
use crate::forest::collide::Response;
use crate::image::save;
use crate::math::Vec3;
use crate::view::path::{Pose, read_path, write_path};
use crate::view::steer::{read_steering, steer};
use crate::view::tour::Tour;
use std::io::Read;
use std::path::Path;

/// The radius of an observer in metres: shoulders.
const SHOULDERS: f64 = 0.3;
/// The most bytes of samples.
const MOST_INPUT: u64 = 1 << 25;
/// The eye looks ahead as far as it comes in so many seconds, and at least [`LEAST_AHEAD`] metres.
const SECONDS_AHEAD: f64 = 3.0;
const LEAST_AHEAD: f64 = 20.0;

impl Walk {
    /// Whether somebody walks at all.
    pub fn is_wanted(&self) -> bool {
        self.path.is_some() || self.walk.is_some() || self.input.is_some() || self.tour
    }

    /// Whether anything is to be made of a walk.
    pub fn has_purpose(&self) -> bool {
        self.record.is_some() || self.frames.is_some() || self.hash || self.benchmark
    }
}

/// The poses of the walk that is asked for, trees taken care of, recorded where that is asked for.
pub(super) fn poses(command: &ForestCommand, cells: &Cells, observer: &mut Observer) -> Result<Vec<Pose>, CliError> {
    let walk = &command.walk;
    let mut poses = match &walk.path {
        Some(path) => {
            let text = std::fs::read_to_string(path)
                .map_err(|error| CliError::failed(format!("cannot read the path `{}`: {error}", path.display())))?;
            read_path(&text).map_err(|error| CliError::failed(format!("`{}`: {error}", path.display())))?
        }
        None if walk.input.is_some() => steered(command, cells, observer)?,
        None => made(command, cells, observer)?,
    };
    if let Some(first) = walk.first {
        poses.truncate(usize::try_from(first).unwrap_or(usize::MAX));
    }
    if poses.is_empty() {
        return Err(CliError::failed(
            "the walk has no frames: record a path with the key p of `farop view`, or with --record; --input needs a line a frame",
        ));
    }
    if let Some(how) = walk.collide {
        avoid(&mut poses, how, cells, observer)?;
    }
    if let Some(path) = &walk.record {
        save::write_whole(path, write_path(&poses).as_bytes())?;
    }
    Ok(poses)
}

/// Poses over places, at a height above the ground.
fn made(command: &ForestCommand, cells: &Cells, observer: &mut Observer) -> Result<Vec<Pose>, CliError> {
    let walk = &command.walk;
    if walk.speed <= 0.0 {
        return Err(CliError::failed("--speed: give metres a second, above 0"));
    }
    let places = match &walk.walk {
        Some(text) => triples(text)?,
        None => tour_places(cells, command.eye.height)?,
    };
    let (stride, ahead) = (walk.speed / f64::from(walk.rate), (walk.speed * SECONDS_AHEAD).max(LEAST_AHEAD));
    let mut failed = None;
    let poses = Tour { places, stride, ahead }.poses(|place| {
        // Over voids and outside, the eye keeps the last ground it knew.
        let ground = observer.ground(cells, [place.x, place.y]).unwrap_or_else(|error| {
            failed.get_or_insert(error);
            0.0
        });
        place + Vec3::new(0.0, 0.0, ground)
    });
    match failed {
        Some(error) => Err(error),
        None => poses.map_err(CliError::failed),
    }
}

/// Poses as a device steers, from where the options stand.
fn steered(command: &ForestCommand, cells: &Cells, observer: &mut Observer) -> Result<Vec<Pose>, CliError> {
    let path = command.walk.input.as_deref().unwrap_or(Path::new("-"));
    let is_standard = path == Path::new("-");
    let mut text = Vec::new();
    let read = if is_standard {
        std::io::stdin().lock().take(MOST_INPUT).read_to_end(&mut text)
    } else {
        std::fs::File::open(path).and_then(|file| file.take(MOST_INPUT).read_to_end(&mut text))
    };
    let name = if is_standard { "<stdin>".to_string() } else { path.display().to_string() };
    read.map_err(|error| CliError::failed(format!("cannot read `{name}`: {error}")))?;
    if text.len() as u64 == MOST_INPUT {
        return Err(CliError::failed(format!(
            "`{name}` does not end: more than {MOST_INPUT} bytes, ten hours of steering"
        )));
    }
    let steering = read_steering(&text).map_err(|error| CliError::failed(format!("`{name}`: {error}")))?;
    if let Some(cut) = &steering.cut {
        notice(&format!("`{name}` ends in the middle of a line, which is left out: {cut:?}"));
    }
    let start = observer.camera(&command.eye, cells, command.picture.size)?.from;
    let height = command.eye.height;
    steer(&steering.samples, [start.x, start.y], command.walk.rate, |place| {
        Ok(Vec3::new(place[0], place[1], observer.ground(cells, place)? + height))
    })
}

/// `X Y H X Y H ...`; commas count as blanks.
fn triples(text: &str) -> Result<Vec<Vec3>, CliError> {
    let words = text.split([' ', ',', '\t', '\n']).filter(|word| !word.is_empty());
    let numbers: Option<Vec<f64>> =
        words.map(|word| word.parse().ok().filter(|number: &f64| number.is_finite())).collect();
    match numbers {
        Some(numbers) if !numbers.is_empty() && numbers.len() % 3 == 0 => {
            Ok(numbers.as_chunks::<3>().0.iter().map(|&place| Vec3::from(place)).collect())
        }
        _ => Err(CliError::failed(
            "--walk: expected three numbers a place, east, north and metres above the ground, as in \"100 100 1.7 400 900 1.7\"",
        )),
    }
}

/// The named places that lie in the area; where there are less than two, four places across it.
fn tour_places(cells: &Cells, height: f64) -> Result<Vec<Vec3>, CliError> {
    let head = cells.head();
    let marks = head.marks.iter().filter(|mark| cells.contains(head.cell_at(mark.at)));
    let places: Vec<Vec3> = marks.map(|mark| Vec3::new(mark.at[0], mark.at[1], height)).collect();
    if places.len() > 1 {
        return Ok(places);
    }
    let [[west, south], [east, north]] =
        cells.bounds().ok_or_else(|| CliError::failed("there are no cells to walk over"))?;
    let (low, high) = (head.corner([west, south]), head.corner([east + 1, north + 1]));
    let place = |x: f64, y: f64| {
        let place = low + (high - low) * Vec3::new(x, y, 0.0);
        Vec3::new(place.x, place.y, height)
    };
    Ok(vec![place(0.2, 0.2), place(0.5, 0.4), place(0.8, 0.3), place(0.6, 0.8)])
}

/// Leads the poses around trees. The eye comes back to the path as soon as it can, at no more than twice its speed.
fn avoid(poses: &mut [Pose], how: CollideName, cells: &Cells, observer: &mut Observer) -> Result<(), CliError> {
    let response = match how {
        CollideName::Slide => Response::Slide,
        CollideName::Stop => Response::Stop,
    };
    let mut hits = 0;
    let (mut wanted, mut there) = (poses[0].from, poses[0].from);
    for pose in poses.iter_mut() {
        let stride = 2.0 * pose.from.distance(wanted);
        wanted = pose.from;
        let way = wanted - there;
        let to = if way.length() > stride { there + way * (stride / way.length()) } else { wanted };
        let step = observer.obstacles(cells, there)?.advance((there, to), SHOULDERS, response);
        hits += u64::from(step.hit.is_some());
        there = step.to;
        // It looks as it would have looked.
        *pose = Pose { from: there, at: pose.at - wanted + there, up: pose.up };
    }
    notice(&format!("trees were in the way in {hits} of {} frames", poses.len()));
    Ok(())
}
