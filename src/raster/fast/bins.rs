//! Bins: what is needed of every polygon, made ready once, and which polygons touch which tile.
//!
//! DrawList -BINS-> per tile, in list order: shapes
//!
//! Polygons that cover no sample end here; in a fine mesh that is most of them. The list is cut into segments, contiguous ranges, one
//! for each thread; a tile reads the segments in order, so the order of the list is kept by any number of threads and without a lock.
//!
//! Space: samples; corners in 1/256 of a sample.
//! Cost: some 10 ns a polygon; 4 bytes a polygon and tile it touches.

use super::edges::{Outline, are_in_range};
use super::layout::Layout;
use super::level::Shortcuts;
use super::small::{Small, covered, is_small};
use crate::color::Rgb;
use crate::plan::DepthFormat;
use crate::raster::exact_edge::first_center_from;
use crate::screen::{DrawList, Plane, Precision, ScreenPolygon, ScreenVertex};
use fearless_simd::{Level, Simd, dispatch};
use std::ops::Range;

/// Fixed-point bits of corners: grids of fewer bits are part of this one.
pub(super) const BITS: u32 = 8;
/// Most corners of a polygon whose coverage is decided by edge functions.
pub(super) const MOST_EDGES: usize = 8;

/// How a shape's samples are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// By whole-number edge functions, depth in `f32` from anchors at blocks: many samples at a time.
    Edges,
    /// By the z-buffer's spans, depth as before: outlines that are not convex, or lie on a finer grid or on none.
    Runs,
    /// As the z-buffer does it: spans, and one evaluation a sample.
    Spans,
    /// The same, for surfaces with holes: a sample that is not there leaves depth alone.
    CutOut,
}

/// A polygon that covers samples perhaps, made ready.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// Its place in the list.
    pub polygon: u32,
    /// Its first corner in [`Segment::corners`], for [`Way::Edges`].
    pub first_corner: u32,
    pub corner_count: u8,
    pub way: Way,
    /// Light gets through it: it is kept apart and leaves depth alone.
    pub transparent: bool,
    /// Its surface has holes: a sample is kept apart until its alpha was looked up.
    pub cut_out: bool,
    /// The box of samples it may cover.
    pub columns: [i32; 2],
    pub rows: [i32; 2],
    /// The plane of its depth.
    pub depth: Plane,
}

impl Shape {
    /// Whether samples are put on a list first, and leave depth alone for now.
    #[inline(always)]
    pub fn is_kept_apart(&self) -> bool {
        self.transparent || self.cut_out
    }
}

/// The shapes of one contiguous range of the list. Kept from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Segment {
    /// Which polygons are kept in which way.
    shortcuts: Shortcuts,
    pub smalls: Vec<Small>,
    pub shapes: Vec<Shape>,
    /// Corners in 1/256 of a sample, walked so that the inside is on the right (y runs down).
    pub corners: Vec<[i32; 2]>,
    /// Per tile, what touches it, in the order of the list.
    pub bins: Vec<Vec<Entry>>,
}

/// Where a shape is kept, and which kind it is of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry(u32);

/// Kinds of shapes; each is kept and drawn in a way of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// In [`Segment::smalls`].
    Small,
    /// In [`Segment::shapes`], by edges.
    Edges,
    /// In [`Segment::shapes`], otherwise.
    Other,
}

impl Entry {
    #[inline(always)]
    fn new(index: usize, kind: Kind) -> Entry {
        Entry((index as u32) << 2 | kind as u32)
    }

    #[inline(always)]
    pub fn kind(self) -> Kind {
        match self.0 & 3 {
            0 => Kind::Small,
            1 => Kind::Edges,
            _ => Kind::Other,
        }
    }

    #[inline(always)]
    pub fn index(self) -> usize {
        (self.0 >> 2) as usize
    }
}

/// Columns and rows of samples: first and end.
pub(super) type Reach = [[i32; 2]; 2];

impl Segment {
    /// Empties it, and fills it with the polygons in `range`.
    pub fn fill(
        &mut self,
        list: &DrawList,
        range: Range<usize>,
        (layout, shortcuts): (&Layout, Shortcuts),
        level: Level,
    ) {
        self.shortcuts = shortcuts;
        self.smalls.clear();
        self.shapes.clear();
        self.corners.clear();
        self.bins.iter_mut().for_each(Vec::clear);
        self.bins.resize_with(layout.tiles(), Vec::new);
        dispatch!(level, simd => self.fill_by(simd, list, range.clone(), layout));
    }

    #[inline(always)]
    fn fill_by<S: Simd>(&mut self, simd: S, list: &DrawList, range: Range<usize>, layout: &Layout) {
        for index in range {
            self.add(simd, index, list, layout);
        }
    }

    /// Whether samples of the polygon are decided as the z-buffer does.
    #[inline(always)]
    fn is_one_by_one(&self, subject: &Subject<'_>) -> bool {
        !self.shortcuts.holes && subject.is_cut_out()
    }

    fn bin(&mut self, entry: Entry, [columns, rows]: Reach, layout: &Layout) {
        let [columns, rows] = layout.touched(columns, rows);
        for row in rows {
            for column in columns.clone() {
                self.bins[row * layout.columns + column].push(entry);
            }
        }
    }

    /// Makes the polygon ready and bins it, unless it covers no sample.
    #[inline(always)]
    fn add<S: Simd>(&mut self, simd: S, index: usize, list: &DrawList, layout: &Layout) {
        let record = &list.polygons[index];
        if record.is_shared() {
            let triangle = list.shared.triangle(record);
            let subject = Subject::new(list, index);
            let outline = Outline::of_three(list.shared.places(triangle));
            return self.add_outline(simd, (subject, || list.shared.depth_plane(triangle)), outline, layout);
        }
        let polygon = list.polygon_in_arrays(index);
        let (subject, depth) = (Subject::new(list, index), || polygon.depth_plane().copied());
        if list.grid.bits > BITS || polygon.vertices().len() > MOST_EDGES {
            if let Some(inside) = bounds(&polygon, list).and_then(|area| cut(area, layout))
                && let Some(depth) = depth()
            {
                self.add_shape(&subject, depth, (inside, None), layout);
            }
            return;
        }
        let Some(outline) = Outline::new(polygon.vertices()) else { return };
        self.add_outline(simd, (subject, depth), outline, layout);
    }

    /// Bins a polygon whose edges may be looked at; its plane of depth is asked for when it covers something.
    #[inline(always)]
    fn add_outline<S: Simd>(
        &mut self,
        simd: S,
        (subject, depth): (Subject<'_>, impl Fn() -> Option<Plane>),
        mut outline: Outline,
        layout: &Layout,
    ) {
        let whole = [
            [first_center(outline.least[0]), first_center(outline.most[0])],
            [first_center(outline.least[1]), first_center(outline.most[1])],
        ];
        let Some(inside) = cut(whole, layout) else { return };
        let may_be_small = self.shortcuts.small && is_small(inside) && inside == whole && !self.is_one_by_one(&subject);
        if may_be_small && outline.make_ready() {
            let covered = covered(simd, &outline, inside);
            if covered == 0 {
                return;
            }
            let Some(depth) = depth() else { return };
            if has_single_depth(subject.list, &depth) {
                let entry = Entry::new(self.smalls.len(), Kind::Small);
                let what = (subject.index, subject.is_transparent(), subject.is_cut_out());
                self.smalls.push(Small::new(&depth, covered, inside, what));
                return self.bin(entry, inside, layout);
            }
            return self.add_shape(&subject, depth, (inside, Some(outline)), layout);
        }
        if let Some(depth) = depth() {
            self.add_shape(&subject, depth, (inside, Some(outline)), layout);
        }
    }

    /// Bins a polygon that is not small.
    fn add_shape(
        &mut self,
        subject: &Subject<'_>,
        depth: Plane,
        (inside, outline): (Reach, Option<Outline>),
        layout: &Layout,
    ) {
        let single = has_single_depth(subject.list, &depth) && !self.is_one_by_one(subject);
        let first_corner = self.corners.len() as u32;
        let cut_out = subject.is_cut_out();
        let is_fit = |outline: &Outline| single && are_in_range(outline.least, outline.most, layout.side);
        let outline = outline.filter(is_fit);
        let mut corner_count = 0;
        if let Some(mut outline) = outline
            && outline.make_ready()
        {
            if outline.corners().is_empty() {
                return;
            }
            self.corners.extend_from_slice(outline.corners());
            corner_count = outline.corners().len() as u8;
        }
        let (way, kind) = match (corner_count > 0, single) {
            (true, _) => (Way::Edges, Kind::Edges),
            (false, true) => (Way::Runs, Kind::Other),
            (false, false) if cut_out => (Way::CutOut, Kind::Other),
            (false, false) => (Way::Spans, Kind::Other),
        };
        let entry = Entry::new(self.shapes.len(), kind);
        let (polygon, transparent) = (subject.index, subject.is_transparent());
        let [columns, rows] = inside;
        self.shapes.push(Shape {
            polygon,
            first_corner,
            corner_count,
            way,
            transparent,
            cut_out,
            columns,
            rows,
            depth,
        });
        self.bin(entry, inside, layout);
    }
}

/// A polygon of the list and what is asked of it beside its outline.
struct Subject<'a> {
    list: &'a DrawList,
    index: u32,
    surface: u32,
}

impl<'a> Subject<'a> {
    #[inline(always)]
    fn new(list: &'a DrawList, index: usize) -> Subject<'a> {
        Subject { list, index: index as u32, surface: list.polygons[index].surface }
    }

    /// Whether the surface has holes.
    #[inline(always)]
    fn is_cut_out(&self) -> bool {
        self.list.shader.is_cut_out(self.surface)
    }

    /// Whether the target keeps its fragments apart.
    #[inline(always)]
    fn is_transparent(&self) -> bool {
        self.list.shader.opacity_of(self.surface) != Rgb::gray(1.0)
    }
}

/// The part of a box that is inside the picture and among the rows that are drawn; `None` where there is none.
#[inline(always)]
fn cut([columns, rows]: Reach, layout: &Layout) -> Option<Reach> {
    let columns = [columns[0].max(0), columns[1].min(layout.width)];
    let rows = [rows[0].max(layout.rows.start), rows[1].min(layout.rows.end)];
    (columns[0] < columns[1] && rows[0] < rows[1]).then_some([columns, rows])
}

/// The first column (or row) whose center is at or after a coordinate in 1/256 of a sample.
#[inline]
fn first_center(fixed: i32) -> i32 {
    const HALF: i32 = 1 << (BITS - 1);
    fixed.saturating_add(HALF - 1) >> BITS
}

/// The box of samples whose centers may be inside: columns, rows; `None` for a polygon without corners.
///
/// A covered center is at or right of a left edge and strictly left of a right one, so between the outermost corners by the same rule.
fn bounds(polygon: &ScreenPolygon<'_>, list: &DrawList) -> Option<Reach> {
    let center = |vertex: &ScreenVertex| {
        let corner = vertex.homogeneous;
        if list.grid.is_exact() {
            return [corner.x, corner.y].map(|along| first_center_from(along, corner.z) as i32);
        }
        // Exact: coordinates have at most 16 bits behind the point, and half a sample is on any finer grid.
        [vertex.x, vertex.y].map(|along| (along - 0.5).ceil() as i32)
    };
    let mut vertices = polygon.vertices().iter();
    let first = center(vertices.next()?);
    let reach = vertices.map(center).fold([first, first], |[least, most], [x, y]| {
        [[least[0].min(x), least[1].min(y)], [most[0].max(x), most[1].max(y)]]
    });
    Some([[reach[0][0], reach[1][0]], [reach[0][1], reach[1][1]]])
}

/// Whether depth is 1/w itself and lanes of `f32` evaluate it.
fn has_single_depth(list: &DrawList, plane: &Plane) -> bool {
    list.precision == Precision::Single && list.depth_mapping.format == DepthFormat::F32 && plane.fits_single()
}
