//! The target: where rasterizers put fragments.
//!
//! Rasterizer -Fragment-> TARGET -> Image
//!
//! It does *not* test depth: deciding what is in front is the rasterizer's work, and the lab. It keeps the depth and
//! color of what was put last, keeps transparent fragments apart (leaving depth alone) and blends them at the end,
//! drops and counts writes outside, and counts what was put.
//!
//! Space: samples, row 0 on top. Depth: larger is nearer, 0 is infinitely far.

use super::external::Confinement;
use super::layers::{Layers, composite};
use super::order::Watch;
use super::put_counts::PutCounts;
use crate::color::Rgb;
use crate::image::Image;
use crate::plan::Transparency;
use crate::screen::Fragment;
use std::ops::Range;

/// The owner of samples that no polygon has been put on.
const NOBODY: u32 = u32::MAX;

/// The memory behind targets: depth, color and owner of every sample. Kept from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    depth: Vec<f64>,
    color: Vec<Rgb<f32>>,
    owner: Vec<u32>,
}

impl Frame {
    /// A target over `rows` of a picture of `width` x `height` samples, showing `background`, infinitely far.
    pub fn target(
        &mut self,
        size: (u32, u32),
        rows: Range<u32>,
        background: Rgb<f32>,
        rule: Transparency,
    ) -> Target<'_> {
        let samples = size.0 as usize * rows.len();
        self.depth.clear();
        self.depth.resize(samples, 0.0);
        self.color.clear();
        self.color.resize(samples, background);
        self.owner.clear();
        self.owner.resize(samples, NOBODY);
        Target {
            width: size.0,
            columns: size.0,
            height: size.1,
            rows,
            watch: None,
            depth: &mut self.depth,
            color: &mut self.color,
            owner: &mut self.owner,
            layers: Layers::default(),
            rule,
            background,
            counts: PutCounts::default(),
            threads: 1,
        }
    }

    /// How much memory it holds, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let (depth, color) = (std::mem::size_of_val(&self.depth[..]), std::mem::size_of_val(&self.color[..]));
        (depth + color + std::mem::size_of_val(&self.owner[..])) as u64
    }

    /// Owner, depth and color of the sample at `index` of the last target, row by row.
    #[must_use]
    pub fn sample(&self, index: usize) -> (Option<u32>, f64, Rgb<f32>) {
        let owner = Some(self.owner[index]).filter(|&owner| owner != NOBODY);
        (owner, self.depth[index], self.color[index])
    }

    /// The picture of the last target.
    #[must_use]
    pub fn image(&self, width: u32, rows: Range<u32>) -> Image {
        let mut image = Image::new(width as usize, rows.len(), Rgb::gray(0.0));
        image.pixels_mut().copy_from_slice(&self.color);
        image
    }
}

/// Rows of a picture that a rasterizer draws into.
#[derive(Debug)]
pub struct Target<'a> {
    width: u32,
    /// Columns that [`Target::index`] finds: all of them. None while the target is watched: then every access takes the way of those
    /// outside, which is rare otherwise, and only that way asks for a watch. So watching costs nothing where nobody watches.
    columns: u32,
    height: u32,
    rows: Range<u32>,
    depth: &'a mut [f64],
    color: &'a mut [Rgb<f32>],
    owner: &'a mut [u32],
    layers: Layers,
    rule: Transparency,
    background: Rgb<f32>,
    counts: PutCounts,
    threads: u32,
    watch: Option<Box<Watch>>,
}

impl Target<'_> {
    /// Samples across.
    #[must_use]
    pub fn width(&self) -> i32 {
        self.width as i32
    }

    /// Samples down, of the whole picture.
    #[must_use]
    pub fn height(&self) -> i32 {
        self.height as i32
    }

    /// The rows this target keeps: usually all. Others need not be drawn; what is put there is dropped.
    #[must_use]
    pub fn row_range(&self) -> Range<i32> {
        self.rows.start as i32..self.rows.end as i32
    }

    /// How many threads a rasterizer may use; the picture must not depend on it.
    #[must_use]
    pub fn threads(&self) -> u32 {
        self.threads
    }

    /// The same target, for that many threads.
    #[must_use]
    pub fn with_threads(self, threads: u32) -> Self {
        Target { threads: threads.max(1), ..self }
    }

    /// Depth of what was put last at sample (x, y); 0, infinitely far, where nothing was, and outside.
    #[must_use]
    pub fn depth(&self, x: i32, y: i32) -> f64 {
        match self.index(x, y) {
            Some(index) => self.depth[index],
            None => self.depth_outside(x, y),
        }
    }

    /// The same target, which also notes in which order fragments are put and whether depth is read: [`PutCounts::order`].
    #[must_use]
    pub fn watched(self) -> Self {
        let watch = Watch::new((self.width, self.height));
        Target { columns: 0, watch: Some(Box::new(watch)), ..self }
    }

    /// Linear light behind everything.
    #[must_use]
    pub fn background(&self) -> Rgb<f32> {
        self.background
    }

    /// How transparent layers add up.
    #[must_use]
    pub fn transparency(&self) -> Transparency {
        self.rule
    }

    /// Shows `color` at sample (x, y): a piece of a picture that was finished elsewhere, by nobody knows which polygon. What is not
    /// in this target is dropped.
    pub fn show(&mut self, x: i32, y: i32, color: Rgb<f32>) {
        if let Some(index) = self.index(x, y).or_else(|| self.watched_index(x, y)) {
            self.counts.shown += 1;
            self.color[index] = color;
        }
    }

    /// There is no picture, and `why`: whoever asked for one says so and writes none.
    pub fn fail(&mut self, why: impl std::fmt::Display) {
        self.counts.failure.get_or_insert_with(|| why.to_string());
    }

    /// The picture comes from a program that was held `by` this: `--stats` prints it.
    pub fn confined(&mut self, by: Confinement) {
        self.counts.confinement.get_or_insert(by);
    }

    /// Adds `count` to what the rasterizer counts under `name`: `--stats` prints it.
    pub fn count(&mut self, name: &'static str, count: u64) {
        *self.counts.own.entry(name).or_default() += count;
    }

    /// As [`Target::count`], for a number of which only the largest matters.
    pub fn count_most(&mut self, name: &'static str, count: u64) {
        let most = self.counts.most.entry(name).or_default();
        *most = count.max(*most);
    }

    /// Shows `fragment`, whatever was there before. Opacity below 1 keeps it apart and leaves depth alone; a hole is nothing.
    pub fn put(&mut self, fragment: Fragment) {
        if fragment.is_hole() {
            return;
        }
        match self.index(fragment.x, fragment.y) {
            Some(index) => self.put_at(index, fragment),
            None => self.put_outside(fragment),
        }
    }

    /// As [`Target::put`], if the fragment is in front of what was put there: nearer, or as near and earlier in the list.
    ///
    /// For algorithms that decide whole spans, and then have to look at surfaces with holes sample by sample.
    pub fn put_if_in_front(&mut self, fragment: Fragment) {
        let depth = self.depth(fragment.x, fragment.y);
        let index = self.index_within(self.width, fragment.x, fragment.y);
        let is_first = index.is_some_and(|index| fragment.polygon < self.owner[index]);
        if fragment.depth > depth || (fragment.depth == depth && is_first) {
            self.put(fragment);
        }
    }

    fn put_at(&mut self, index: usize, fragment: Fragment) {
        self.counts.puts += 1;
        if fragment.opacity != Rgb::gray(1.0) {
            self.layers.push(index, self.depth.len(), fragment);
            return;
        }
        self.counts.overdraw += u64::from(self.owner[index] != NOBODY);
        self.depth[index] = fragment.depth;
        self.color[index] = fragment.color;
        self.owner[index] = fragment.polygon;
    }

    /// A fragment that is not in the picture; or any, of a target that is watched.
    #[cold]
    fn put_outside(&mut self, fragment: Fragment) {
        let index = self.watched_index(fragment.x, fragment.y);
        if let (Some(index), Some(watch)) = (index, &mut self.watch) {
            watch.put((fragment.x, fragment.y), fragment.opacity == Rgb::gray(1.0));
            return self.put_at(index, fragment);
        }
        // Rows of the picture that another target keeps are not stray.
        let stray = !(0..self.width()).contains(&fragment.x) || !(0..self.height()).contains(&fragment.y);
        self.counts.stray_writes += u64::from(stray);
    }

    #[cold]
    fn depth_outside(&self, x: i32, y: i32) -> f64 {
        let (Some(index), Some(watch)) = (self.watched_index(x, y), &self.watch) else { return 0.0 };
        watch.read((x, y));
        self.depth[index]
    }

    /// As [`Target::index`], of a target that is watched.
    fn watched_index(&self, x: i32, y: i32) -> Option<usize> {
        self.watch.as_ref()?;
        self.index_within(self.width, x, y)
    }

    /// Lets `draw` fill this target in `count` bands of rows on as many threads; the picture is the same as in one.
    ///
    /// # Panics
    /// When `draw` panics.
    pub fn bands(&mut self, count: u32, draw: impl Fn(&mut Target<'_>) + Sync) {
        let draw = &draw;
        let bands = self.split(count);
        let counts: Vec<_> = std::thread::scope(|scope| {
            let start = |mut band: Target<'_>| {
                draw(&mut band);
                band.finish()
            };
            let workers: Vec<_> = bands.into_iter().map(|band| scope.spawn(move || start(band))).collect();
            workers.into_iter().map(std::thread::ScopedJoinHandle::join).collect()
        });
        for band in counts {
            match band {
                Ok(counts) => self.counts += counts,
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    }

    /// Disjoint targets over equal shares of the rows.
    fn split(&mut self, count: u32) -> Vec<Target<'_>> {
        let (width, height, rule, background) = (self.width, self.height, self.rule, self.background);
        let (columns, is_watched) = (self.columns, self.watch.is_some());
        let all = self.rows.clone();
        let rows_each = (all.len() as u32).div_ceil(count.max(1)).max(1);
        let samples_each = rows_each as usize * width as usize;
        let memory = self.depth.chunks_mut(samples_each).zip(self.color.chunks_mut(samples_each));
        let memory = memory.zip(self.owner.chunks_mut(samples_each));
        let starts = all.clone().step_by(rows_each as usize);
        let band = |(start, ((depth, color), owner)): (u32, _)| {
            let rows = start..(start + rows_each).min(all.end);
            let (layers, counts) = (Layers::default(), PutCounts::default());
            let watch = is_watched.then(|| Box::new(Watch::new((width, height))));
            Target {
                width,
                columns,
                height,
                rows,
                depth,
                color,
                owner,
                layers,
                rule,
                background,
                counts,
                threads: 1,
                watch,
            }
        };
        starts.zip(memory).map(band).collect()
    }

    /// Blends the transparent fragments in front of each opaque sample, and tells what was put.
    pub fn finish(mut self) -> PutCounts {
        if let Some(watch) = self.watch.take() {
            self.counts.order.get_or_insert_default().add(watch.order());
        }
        if !self.layers.is_empty() {
            let mut sorted = Vec::new();
            for index in 0..self.depth.len() {
                self.layers.in_front(index, self.depth[index], self.owner[index], &mut sorted);
                if !sorted.is_empty() {
                    self.color[index] = composite(&sorted, self.color[index], self.rule);
                }
            }
        }
        self.counts
    }

    fn index(&self, x: i32, y: i32) -> Option<usize> {
        self.index_within(self.columns, x, y)
    }

    fn index_within(&self, columns: u32, x: i32, y: i32) -> Option<usize> {
        let (column, row) = (u32::try_from(x).ok()?, u32::try_from(y).ok()?);
        let inside = column < columns && self.rows.contains(&row);
        inside.then(|| (row - self.rows.start) as usize * self.width as usize + column as usize)
    }
}
