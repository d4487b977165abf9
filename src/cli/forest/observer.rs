//! The observer: where it stands and looks, the ground below it, the trees around it.

use super::options::Eye;
use crate::cli::error::CliError;
use crate::diagnostic::suggest;
use crate::forest::area::{Cell, CellIndex, Head};
use crate::forest::cells::Cells;
use crate::forest::collide::{Obstacles, Volume, of_tree};
use crate::forest::heights::{Heights, height};
use crate::forest::place::{Placement, Sizes, base_of, grow};
use crate::math::{Vec3, cos, radians, sin};
use crate::scene::{Camera, Place};

/// Nothing nearer than this is seen, metres.
const HITHER: f64 = 0.5;

/// What an observer knows of the area.
#[derive(Default)]
pub(super) struct Observer {
    heights: Heights,
    /// The last ground that was known.
    last: f64,
    year: Option<i32>,
    /// Boxes around what stands on the area.
    boxes: Vec<Volume>,
    /// The obstacles of the cell in hand and those around it.
    obstacles: Option<(CellIndex, Obstacles)>,
}

impl Observer {
    pub fn new(year: Option<i32>) -> Observer {
        Observer { year, ..Observer::default() }
    }

    /// What stands in these boxes is in the way, as trees are.
    pub fn stand_in_the_way(&mut self, boxes: Vec<[Vec3; 2]>) {
        self.boxes = boxes.into_iter().map(|[low, high]| Volume::Box { low, high }).collect();
    }

    /// The ground at a position; over voids and outside the last one that was known.
    pub fn ground(&mut self, cells: &Cells, position: [f64; 2]) -> Result<f64, CliError> {
        let found = self.heights.at(cells, position).map_err(CliError::failed)?;
        self.last = found.unwrap_or(self.last);
        Ok(self.last)
    }

    /// The trees of the cell below `eye` and of those around it.
    pub fn obstacles(&mut self, cells: &Cells, eye: Vec3) -> Result<&Obstacles, CliError> {
        let index = cells.head().cell_at([eye.x, eye.y]);
        let made = match self.obstacles.take() {
            Some(made) if made.0 == index => made,
            _ => (index, self.volumes_around(cells, index)?),
        };
        Ok(&self.obstacles.insert(made).1)
    }

    fn volumes_around(&mut self, cells: &Cells, [column, row]: CellIndex) -> Result<Obstacles, CliError> {
        let mut volumes = self.boxes.clone();
        for row in row.saturating_sub(1)..=row.saturating_add(1) {
            for column in column.saturating_sub(1)..=column.saturating_add(1) {
                if let Some(cell) = self.heights.cell(cells, [column, row]).map_err(CliError::failed)? {
                    volumes_of(cells.head(), cell, self.year, &mut volumes)?;
                }
            }
        }
        Ok(Obstacles::new(volumes))
    }

    /// The camera that the options describe.
    pub fn camera(&mut self, eye: &Eye, cells: &Cells, size: (u32, u32)) -> Result<Camera, CliError> {
        let head = cells.head();
        let bounds =
            cells.bounds().ok_or_else(|| CliError::failed("there is nothing to see: the area has no cells"))?;
        let (low, high) = (head.corner(bounds[0]), head.corner([bounds[1][0] + 1, bounds[1][1] + 1]));
        let middle = (low + high) * 0.5;
        let middle = Vec3::new(middle.x, middle.y, self.ground(cells, [middle.x, middle.y])?);
        let from = match (&eye.from, &eye.at_mark) {
            (Some(from), _) => *from,
            (None, Some(name)) => {
                let [x, y] = mark(head, name)?;
                Vec3::new(x, y, self.ground(cells, [x, y])? + eye.height)
            }
            (None, None) => {
                // To the south of the middle, and above the ground by a third of that.
                let back = ((high.y - low.y) * 0.5).min(1500.0);
                Vec3::new(middle.x, middle.y - back, middle.z + back / 3.0)
            }
        };
        let (at, up) = look(eye, from, middle);
        let (angle, place) = (eye.angle_of_view, Place::default());
        Ok(Camera { from, at, up, angle, hither: HITHER, yon: None, resolution: size, place })
    }
}

/// What an observer looks at, and what is up.
fn look(eye: &Eye, from: Vec3, middle: Vec3) -> (Vec3, Vec3) {
    if eye.heading.is_none() && eye.pitch == 0.0 {
        let level = Vec3::new(middle.x, middle.y, from.z);
        let wanted = if eye.at_mark.is_some() { level } else { middle };
        let at = eye.at.unwrap_or(wanted);
        let at = if at == from { from + Vec3::Y } else { at };
        let is_upright = at.x == from.x && at.y == from.y;
        return (at, if is_upright { Vec3::Y } else { Vec3::Z });
    }
    let to_middle = Vec3::new(middle.x - from.x, middle.y - from.y, 0.0);
    let level = match eye.heading {
        Some(degrees) => Vec3::new(sin(radians(degrees)), cos(radians(degrees)), 0.0),
        None => crate::math::unit(to_middle).unwrap_or(Vec3::Y),
    };
    let pitch = radians(eye.pitch);
    let forward = level * cos(pitch) + Vec3::Z * sin(pitch);
    // Straight up and down, the top of the picture is where the heading points from or to.
    let up = Vec3::Z * cos(pitch) - level * sin(pitch);
    (from + forward * 100.0, up)
}

/// Where a named place is.
fn mark(head: &Head, name: &str) -> Result<[f64; 2], CliError> {
    if let Some(mark) = head.marks.iter().find(|mark| mark.name.eq_ignore_ascii_case(name)) {
        return Ok(mark.at);
    }
    let names: Vec<&str> = head.marks.iter().map(|mark| mark.name.as_str()).collect();
    let help = match (suggest(name, &names), names.is_empty()) {
        (Some(similar), _) => format!("did you mean \"{similar}\"?"),
        (None, true) => "the area names no places; use --from X,Y,Z".to_string(),
        (None, false) => format!(
            "there is {}",
            names.iter().take(12).map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", ")
        ),
    };
    Err(CliError::failed(format!("there is no place \"{name}\"\nhelp: {help}")))
}

/// The volumes of the trees of a cell, world space.
fn volumes_of(head: &Head, cell: &Cell, year: Option<i32>, volumes: &mut Vec<Volume>) -> Result<(), CliError> {
    let (corner, base) = (head.corner(cell.index), base_of(cell));
    let ground = |at: [f64; 2]| height(&cell.ground, head.side, at).unwrap_or(f64::NAN);
    let trees = grow(head, cell, year, Placement::Lattice, &ground).map_err(CliError::failed)?;
    let sizes = Sizes::new(head, cell, year);
    for tree in trees {
        let ([x, y], size) = (tree.at(head.side), sizes.of(tree));
        let foot = corner + Vec3::new(x, y, tree.height_above_sea(base));
        let state = tree.stand().and_then(|stand| cell.stands.get(stand)).and_then(|stand| stand.in_year(year));
        volumes.extend(of_tree(foot, size.height, size.crown, state.and_then(|state| state.crown_base)));
    }
    Ok(())
}
