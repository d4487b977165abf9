//! Fast: the z-buffer's picture, byte for byte, at the speed of the machine.
//!
//! DrawList -bins-> tiles -edges, planes-> depth and owner -shade-> light -mean-> pixels
//!
//! The z-buffer defines the picture; this draws the same one in another order of work. The picture is cut into tiles that fit into the
//! nearest caches. Every polygon is made ready once and put on the lists of the tiles it touches; every tile draws its list, keeping depth and owner of its
//! samples, then shades each sample once and averages A x A of them to a pixel. Threads take tiles. `docs/fast.md` tells the whole story.
//!
//! Why the same bytes: coverage is exact in both; a plane has one value at a sample, whoever asks ([`crate::screen::lane`]); ties are decided
//! by the order of the list, which bins keep; and shading asks the same functions. Nothing depends on tiles, threads or lanes.
//!
//! Source: Molnar, Cox, Ellsworth and Fuchs, "A Sorting Classification of Parallel Rendering", IEEE CG&A 14(4), 1994 (sort-middle); Abrash,
//! "Rasterization on Larrabee", Dr. Dobb's 2009 (tiles, descent into blocks); Burns and Hunt, "The Visibility Buffer", JCGT 2(2), 2013.
//! Cost: see `docs/fast.md`.

mod bins;
mod color;
mod cover;
mod edges;
mod layout;
mod level;
mod mean;
mod planes;
mod shade;
mod shown;
mod sink;
mod small;
mod textured;
mod tile;

pub use level::{Instructions, Shortcuts, VARIABLE};

use self::bins::Segment;
use self::layout::{LARGEST_SIDE, Layout, side_of_whole_pixels};
use self::shade::Behind;
use self::sink::{PixelRows, Samples, Sink};
use self::tile::{Counts, Depth, Tile};
use super::{Pixels, PutCounts, Rasterizer, Target, ZBuffer};
use crate::screen::{DrawList, Precision, lanes};
use fearless_simd::Level;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// Draws tile by tile.
#[derive(Debug)]
pub struct Fast {
    /// Samples of a tile's side, 8 to 256; rounded to what holds whole pixels. The picture does not depend on it.
    pub tile_side: u32,
    /// Instructions of the inner loops. The picture does not depend on it.
    pub instructions: Instructions,
    /// Shortcuts of the inner loops. The picture does not depend on them.
    pub shortcuts: Shortcuts,
    /// Memory of earlier pictures; its contents count for nothing.
    pool: Mutex<Vec<Memory>>,
}

impl Default for Fast {
    /// With the instructions that [`VARIABLE`] asks for; the best if that is no name.
    fn default() -> Self {
        Fast::new(64, Instructions::asked().unwrap_or_default())
    }
}

/// Memory that is kept from frame to frame: fresh pages cost more than the work in them.
#[derive(Debug, Default)]
struct Memory {
    segments: Vec<Segment>,
    order: Vec<u32>,
    single: Vec<Tile<f32>>,
    double: Vec<Tile<f64>>,
}

/// What is drawn and how.
struct Job<'a> {
    list: &'a DrawList,
    layout: Layout,
    behind: Behind,
    threads: usize,
    instructions: Instructions,
    shortcuts: Shortcuts,
}

impl Fast {
    /// For tiles of `tile_side` samples.
    #[must_use]
    pub fn new(tile_side: u32, instructions: Instructions) -> Fast {
        Fast { tile_side, instructions, shortcuts: Shortcuts::default(), pool: Mutex::default() }
    }

    fn run(&self, job: &Job<'_>, sink: &(impl Sink<f32> + Sink<f64>)) -> PutCounts {
        let mut memory = self.pool.lock().unwrap_or_else(PoisonError::into_inner).pop().unwrap_or_default();
        job.fill(&mut memory.segments);
        let Memory { segments, order, single, double } = &mut memory;
        job.sort(segments, order);
        let counts = match job.list.precision {
            Precision::Single => job.draw((segments, order), single, sink),
            Precision::Double => job.draw((segments, order), double, sink),
        };
        self.pool.lock().unwrap_or_else(PoisonError::into_inner).push(memory);
        let mut puts = PutCounts { puts: counts.puts, ..PutCounts::default() };
        puts.own.insert("tiles", job.layout.tiles() as u64);
        puts.own.insert("polygons in tiles, by edges", counts.edges);
        puts.own.insert("polygons in tiles, by spans", counts.runs);
        puts.own.insert("polygons in tiles, sample by sample", counts.spans);
        puts
    }
}

impl Job<'_> {
    /// Makes every polygon ready, a segment a thread.
    fn fill(&self, segments: &mut Vec<Segment>) {
        segments.resize_with(self.threads, Segment::default);
        let each = self.list.len().div_ceil(self.threads).max(1);
        let range = |number: usize| (number * each).min(self.list.len())..((number + 1) * each).min(self.list.len());
        let (level, shortcuts) = (self.instructions.level(), self.shortcuts);
        in_threads(segments, |number, segment| {
            segment.fill(self.list, range(number), (&self.layout, shortcuts), level);
        });
    }

    /// Puts tiles in the order in which they are drawn: on several threads the longest lists first, so that none is left for the end.
    fn sort(&self, segments: &[Segment], order: &mut Vec<u32>) {
        order.clear();
        order.extend(0..self.layout.tiles() as u32);
        if self.threads > 1 {
            let length = |&tile: &u32| segments.iter().map(|segment| segment.bins[tile as usize].len()).sum::<usize>();
            order.sort_unstable_by_key(|tile| (std::cmp::Reverse(length(tile)), *tile));
        }
    }

    /// Draws all tiles, each by the first thread that is free.
    fn draw<D: Depth>(
        &self,
        (segments, order): (&[Segment], &[u32]),
        tiles: &mut Vec<Tile<D>>,
        sink: &impl Sink<D>,
    ) -> Counts {
        tiles.resize_with(self.threads, Tile::new);
        let next = AtomicUsize::new(0);
        let level = self.instructions.level();
        in_threads(tiles, |_, tile: &mut Tile<D>| {
            tile.counts = Counts::default();
            while let Some(&number) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
                self.draw_tile(segments, number as usize, (tile, level), sink);
            }
        });
        tiles.iter().fold(Counts::default(), |sum, tile| sum + tile.counts)
    }

    fn draw_tile<D: Depth>(
        &self,
        segments: &[Segment],
        number: usize,
        (tile, level): (&mut Tile<D>, Level),
        sink: &impl Sink<D>,
    ) {
        if segments.iter().all(|segment| segment.bins[number].is_empty()) {
            return sink.fill(&self.layout.area(number), self.behind.background);
        }
        tile.shortcuts = self.shortcuts;
        tile.clear(self.layout.area(number), self.layout.side as usize);
        tile.draw(self.list, segments, number, level);
        tile.shade(self.list, self.behind, level);
        sink.take(tile, level);
    }
}

/// Calls `work` for each part and its number, on a thread of its own if there are several.
fn in_threads<T: Send>(parts: &mut [T], work: impl Fn(usize, &mut T) + Sync) {
    let Some((own, others)) = parts.split_first_mut() else { return };
    let work = &work;
    if others.is_empty() {
        // A scope alone costs an allocation.
        return work(0, own);
    }
    std::thread::scope(|scope| {
        for (number, part) in others.iter_mut().enumerate() {
            scope.spawn(move || work(number + 1, part));
        }
        work(0, own);
    });
}

impl Rasterizer for Fast {
    fn draw(&self, list: &DrawList, target: &mut Target<'_>) {
        if !list.has_depth {
            return hand_over(list, target);
        }
        let side = self.tile_side.clamp(layout::LANES, LARGEST_SIDE) / layout::LANES * layout::LANES;
        let layout = Layout::new(target.width(), target.row_range(), side);
        let behind = Behind { background: target.background(), rule: target.transparency() };
        let threads = target.threads().max(1) as usize;
        let job = Job { list, layout, behind, threads, instructions: self.instructions, shortcuts: self.shortcuts };
        let counts = self.run(&job, &Samples(Mutex::new(&mut *target)));
        counts.own.into_iter().for_each(|(name, count)| target.count(name, count));
    }

    fn reads_shared(&self) -> bool {
        true
    }

    fn draw_pixels(&self, list: &DrawList, pixels: &mut Pixels<'_>) -> bool {
        let Some(side) = side_of_whole_pixels(self.tile_side, pixels.samples).filter(|_| list.has_depth) else {
            return false;
        };
        let layout = Layout::new(list.width as i32, 0..list.height as i32, side);
        let behind = Behind { background: pixels.background, rule: pixels.rule };
        let threads = pixels.threads.max(1) as usize;
        let job = Job { list, layout, behind, threads, instructions: self.instructions, shortcuts: self.shortcuts };
        let counts = self.run(&job, &PixelRows::new(pixels, side));
        pixels.counts += counts;
        true
    }
}

/// Lists without depth (wire) have nothing that could be in front: the z-buffer says what they show.
fn hand_over(list: &DrawList, target: &mut Target<'_>) {
    target.count("lists_handed_to_zbuffer", 1);
    ZBuffer.draw(list, target);
}
