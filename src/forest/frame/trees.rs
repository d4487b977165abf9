//! Trees of a frame: from records of 8 bytes to polygons.
//!
//! Stocked cells, eye -TREES-> quads in a sink
//!
//! Squares of trees are sorted from near to far, not trees. A square out of view, behind the horizon or behind land is dropped whole; what is left
//! asks each tree for its size, then [`detail`] for its looks.
//!
//! Cost: `cargo run --release --example forest_frames` prints it.

use super::choices::{Choices, FrameCounts, Trees};
use super::dress::Dress;
use super::sink::{CROWN, Quad, Sink, Stand, UPRIGHT, add_quad, add_solid, add_triangle};
use crate::forest::area::{CellIndex, Head};
use crate::forest::detail::{self, Form, Look, Looks};
use crate::forest::frustum::Frustum;
use crate::forest::place::{Size, Sizes};
use crate::forest::terrain::Terrain;
use crate::forest::terrain::horizon::{Horizon, Square};
use crate::forest::terrain::relief::distance_to_cell;
use crate::forest::window::{Grove, SQUARES, Stock, Stocked};
use crate::math::{Vec3, cos, sin};

/// Metres; wider crowns may be cut where their square is out of view.
const WIDEST_CROWN: f64 = 24.0;

/// Who looks.
#[derive(Clone, Copy)]
pub(super) struct Eye {
    pub at: Vec3,
    pub frustum: Frustum,
    pub focal: f64,
    /// To the right of the camera, on the map.
    pub right: Vec3,
}

/// What stays the same for all trees of a frame.
pub(super) struct Planter<'a> {
    pub head: &'a Head,
    pub choices: &'a Choices,
    pub terrain: &'a Terrain,
    pub stock: &'a Stock,
    pub dress: &'a Dress,
    pub eye: Eye,
}

/// Lists that frames share.
#[derive(Default)]
pub(super) struct Order {
    cells: Vec<(f64, CellIndex)>,
    squares: Vec<(f64, usize)>,
    horizon: Horizon,
}

impl Planter<'_> {
    /// Adds the trees of all cells, from near to far.
    pub fn plant(&self, order: &mut Order, sink: &mut Sink, counts: &mut FrameCounts) {
        let side = self.head.side;
        order.cells.clear();
        order.horizon.start(self.eye.at);
        for stocked in self.stock.cells() {
            counts.trees += stocked.trees().len() as u64;
            order.cells.push((distance_to_cell(stocked.cell.index, side, self.eye.at), stocked.cell.index));
        }
        order.cells.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let cells = std::mem::take(&mut order.cells);
        for &(distance, index) in &cells {
            let Some(stocked) = self.stock.at(index) else { continue };
            order.horizon.advance(distance);
            self.cell(stocked, distance, order, (sink, counts));
            if self.choices.hiding {
                // What is drawn may be lower than what was measured by what the tolerance lets show.
                let farthest = distance + 2.0 * side;
                let error = self.choices.tolerance * farthest / self.eye.focal;
                self.terrain.add_to(&mut order.horizon, index, error);
            }
        }
        order.cells = cells;
    }

    fn cell(&self, stocked: &Stocked, distance: f64, order: &mut Order, (sink, counts): (&mut Sink, &mut FrameCounts)) {
        let all = stocked.trees().len() as u64;
        let (index, side) = (stocked.cell.index, self.head.side);
        let corner = self.head.corner(index);
        let range = self.terrain.range(index).unwrap_or((0.0, 0.0));
        let (center, radius) = crate::forest::frustum::sphere([corner.x, corner.y], side, range);
        let reach = self.reach(distance + 2.0 * side);
        if all == 0 || distance > self.choices.horizon || !self.eye.frustum.sees(center, radius + reach) {
            counts.out_of_view += all;
            return;
        }
        if order.horizon.hides(Square { corner: [corner.x, corner.y], side }.widened(reach), range.1 + reach) {
            counts.hidden += all;
            return;
        }
        let step = side / SQUARES as f64;
        order.squares.clear();
        for at in (0..SQUARES * SQUARES).filter(|&at| !stocked.grove(at).trees.is_empty()) {
            let place = self.place(corner, step, at);
            let (x, y) = (place[0] + step / 2.0 - self.eye.at.x, place[1] + step / 2.0 - self.eye.at.y);
            order.squares.push((x * x + y * y, at));
        }
        order.squares.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let sizes = Sizes::new(self.head, &stocked.cell, self.choices.year);
        for &(_, at) in &order.squares {
            let grove = stocked.grove(at);
            let square = Square { corner: self.place(corner, step, at), side: step };
            self.grove(stocked, &grove, (square, reach), &order.horizon, &sizes, (sink, counts));
        }
    }

    /// Metres that trees may be drawn beyond the place of their feet and tops: crowns, and those that stand for others, which are drawn
    /// up to [`detail::SINGLE`] pixels high and perhaps twice as wide.
    fn reach(&self, farthest: f64) -> f64 {
        WIDEST_CROWN / 2.0 + 2.0 * detail::SINGLE * farthest / self.eye.focal
    }

    fn place(&self, corner: Vec3, step: f64, at: usize) -> [f64; 2] {
        [corner.x + step * (at % SQUARES) as f64, corner.y + step * (at / SQUARES) as f64]
    }

    fn grove(
        &self,
        stocked: &Stocked,
        grove: &Grove<'_>,
        (square, reach): (Square, f64),
        horizon: &Horizon,
        sizes: &Sizes<'_>,
        (sink, counts): (&mut Sink, &mut FrameCounts),
    ) {
        let all = grove.trees.len() as u64;
        let (center, radius) =
            crate::forest::frustum::sphere(square.corner, square.side, (grove.range[0], grove.range[1]));
        let radius = radius + reach;
        if !self.eye.frustum.sees(center, radius) {
            counts.out_of_view += all;
            return;
        }
        if horizon.hides(square.widened(reach), grove.range[1] + reach) {
            counts.hidden += all;
            return;
        }
        let is_inside = self.eye.frustum.holds(center, radius);
        let corner = self.head.corner(stocked.cell.index);
        let before = counts.submitted;
        for &tree in grove.trees {
            let [x, y] = tree.at(self.head.side);
            let foot = Vec3::new(corner.x + x, corner.y + y, tree.height_above_sea(stocked.base));
            let size = sizes.of(tree);
            let Some(picture) = self.dress.picture(size.species, tree.picture()) else { continue };
            self.tree(foot, &size, picture, is_inside, (sink, counts));
        }
        counts.out_of_view += all - (counts.submitted - before);
        sink.count((counts.submitted - before) as usize);
    }

    #[inline]
    fn tree(
        &self,
        foot: Vec3,
        size: &Size,
        picture: usize,
        is_inside: bool,
        (sink, counts): (&mut Sink, &mut FrameCounts),
    ) {
        let away = foot - self.eye.at;
        let level = away.x * away.x + away.y * away.y;
        if level > self.choices.horizon * self.choices.horizon {
            return;
        }
        let half = size.height / 2.0;
        let middle = Vec3::new(foot.x, foot.y, foot.z + half);
        if !is_inside && !self.eye.frustum.sees(middle, half + size.crown) {
            return;
        }
        counts.submitted += 1;
        let rise = away.z + half;
        let distance = (level + rise * rise).sqrt();
        let down = if distance > 0.0 { -rise / distance } else { 0.0 };
        let looks = self.looks(size.height * self.eye.focal / distance.max(1e-3), down, size.chance);
        counts.thinned += u64::from(looks.is_nothing());
        for look in looks.iter() {
            let tree = Drawn { foot, away, size, picture, scale: looks.scale };
            match look.form {
                Form::Solid => self.solid(&tree, look, sink, counts),
                _ => self.draw(&tree, look, sink, counts),
            }
        }
    }

    #[inline]
    fn looks(&self, pixels: f64, down: f64, chance: u32) -> Looks {
        match self.choices.trees {
            Trees::Auto => match self.choices.solid_above {
                Some(limit) => detail::looks_with_solids(pixels, down, chance, limit),
                None => detail::looks(pixels, down, chance),
            },
            Trees::Solids => Looks::only(Form::Solid),
            Trees::Crossed => Looks::only(Form::Crossed),
            Trees::Billboards => Looks::only(Form::Facing),
            Trees::None => Looks::default(),
        }
    }

    #[inline]
    fn draw(&self, tree: &Drawn<'_>, look: Look, sink: &mut Sink, counts: &mut FrameCounts) {
        let Drawn { foot, away, size, picture, scale } = *tree;
        let is_narrow = look.form == Form::Narrow;
        let key = Dress::key(picture, is_narrow, look.from, look.to);
        let mesh = sink.mesh(self.dress, key);
        let (width, height) = (size.crown * scale, size.height * scale);
        match look.form {
            // It is no picture and has its own way.
            Form::Solid => {}
            Form::Narrow => {
                counts.narrow += 1;
                counts.tree_polygons += 1;
                // A triangle of the picture's area: twice its share of the rectangle, as wide as that makes it.
                let (right, up) = detail::facing(away, self.eye.right);
                let reach = right * (width * self.dress.shares[picture]);
                let is_worn = look.from > 0;
                add_triangle(mesh, [foot - reach, foot + reach, foot + up * height], is_worn, size.chance);
            }
            Form::Facing => {
                counts.facing += 1;
                counts.tree_polygons += 1;
                let (right, up) = detail::facing(away, self.eye.right);
                let quad = Quad { corner: foot - right * (width / 2.0), along: right * width, up: up * height };
                add_quad(mesh, quad, &UPRIGHT, size.chance);
            }
            Form::Crossed => {
                counts.crossed += 1;
                counts.tree_polygons += 2;
                let along = Vec3::new(cos(size.turn), sin(size.turn), 0.0) * width;
                for along in [along, Vec3::new(-along.y, along.x, 0.0)] {
                    let quad = Quad { corner: foot - along / 2.0, along, up: Vec3::Z * height };
                    add_quad(mesh, quad, &UPRIGHT, size.chance);
                }
            }
            Form::Lying => {
                counts.tree_polygons += 1;
                let middle = foot + Vec3::Z * (0.6 * height);
                add_quad(mesh, lying(middle, size.turn, width), &CROWN, size.chance);
            }
        }
    }

    fn solid(&self, tree: &Drawn<'_>, look: Look, sink: &mut Sink, counts: &mut FrameCounts) {
        let Drawn { foot, size, picture, .. } = *tree;
        let solid = &self.dress.solids[picture];
        counts.solid += 1;
        counts.solid_triangles += solid.triangles.len() as u64;
        counts.tree_polygons += solid.triangles.len() as u64;
        let at = Stand { foot, turn: (cos(size.turn), sin(size.turn)), size: (size.crown, size.height) };
        // A fading mesh wears one texel, and any place in it will do.
        add_solid(sink.mesh(self.dress, Dress::solid_key(picture, look.to)), solid, &at, (look.to < 16, size.chance));
    }
}

/// A level picture around a place.
fn lying(middle: Vec3, turn: f64, width: f64) -> Quad {
    let along = Vec3::new(cos(turn), sin(turn), 0.0) * width;
    let up = Vec3::new(-along.y, along.x, 0.0);
    Quad { corner: middle - (along + up) / 2.0, along, up }
}

/// A tree that is drawn.
#[derive(Clone, Copy)]
struct Drawn<'a> {
    foot: Vec3,
    away: Vec3,
    size: &'a Size,
    picture: usize,
    scale: f64,
}

impl Square {
    /// With the crowns that reach beyond it.
    fn widened(self, reach: f64) -> Square {
        Square { corner: self.corner.map(|at| at - reach), side: self.side + 2.0 * reach }
    }
}
