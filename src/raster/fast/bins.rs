//! Bins: what is needed of every polygon, made ready once, and which polygons touch which tile.
//!
//! DrawList -BINS-> per tile, in list order: shapes
//!
//! Polygons that cover no sample end here; in a fine mesh that is most of them. The list is cut into segments, contiguous ranges, one
//! for each thread; a tile reads the segments in order, so the order of the list is kept by any number of threads and without a lock.
//!
//! Space: samples; corners in 1/256 of a sample.
//! Cost: some 10 ns a polygon; 4 bytes a polygon and tile it touches.

use super::edges::{are_in_range, make_ready};
use super::layout::Layout;
use crate::color::Rgb;
use crate::plan::DepthFormat;
use crate::raster::exact_edge::first_center_from;
use crate::screen::{DrawList, Plane, Precision, ScreenPolygon, ScreenVertex};
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
    /// The box of samples it may cover.
    pub columns: [i32; 2],
    pub rows: [i32; 2],
    /// The plane of its depth.
    pub depth: Plane,
}

/// The shapes of one contiguous range of the list. Kept from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Segment {
    pub shapes: Vec<Shape>,
    /// Corners in 1/256 of a sample, walked so that the inside is on the right (y runs down).
    pub corners: Vec<[i32; 2]>,
    /// Per tile, indices of shapes.
    pub bins: Vec<Vec<u32>>,
}

impl Segment {
    /// Empties it, and fills it with the polygons in `range`.
    pub fn fill(&mut self, list: &DrawList, range: Range<usize>, layout: &Layout) {
        self.shapes.clear();
        self.corners.clear();
        self.bins.iter_mut().for_each(Vec::clear);
        self.bins.resize_with(layout.tiles(), Vec::new);
        for index in range {
            if let Some(shape) = self.shape(list, index, layout) {
                self.bin(shape, layout);
            }
        }
    }

    fn bin(&mut self, shape: Shape, layout: &Layout) {
        let number = self.shapes.len() as u32;
        self.shapes.push(shape);
        let [columns, rows] = layout.touched(shape.columns, shape.rows);
        for row in rows {
            for column in columns.clone() {
                self.bins[row * layout.columns + column].push(number);
            }
        }
    }

    /// The polygon made ready; `None` where it covers no sample.
    #[inline]
    fn shape(&mut self, list: &DrawList, index: usize, layout: &Layout) -> Option<Shape> {
        let polygon = list.polygon(index);
        let first_corner = self.corners.len();
        let on_grid = list.grid.bits <= BITS && polygon.vertices().len() <= MOST_EDGES;
        let (columns, rows, edges) = if on_grid {
            let (least, most) = self.push_corners(polygon.vertices())?;
            let columns = [first_center(least[0]), first_center(most[0])];
            let rows = [first_center(least[1]), first_center(most[1])];
            (columns, rows, are_in_range(least, most, layout.side))
        } else {
            let (columns, rows) = bounds(&polygon, list)?;
            (columns, rows, false)
        };
        let columns = [columns[0].max(0), columns[1].min(layout.width)];
        let rows = [rows[0].max(layout.rows.start), rows[1].min(layout.rows.end)];
        if columns[0] >= columns[1] || rows[0] >= rows[1] {
            self.corners.truncate(first_corner);
            return None;
        }
        let depth = *polygon.depth_plane()?;
        let single = has_single_depth(list, &depth);
        let cut_out = polygon.is_cut_out();
        let edges = edges && single && !cut_out && make_ready(&mut self.corners, first_corner);
        if !edges {
            self.corners.truncate(first_corner);
        }
        let corner_count = (self.corners.len() - first_corner) as u8;
        if edges && corner_count == 0 {
            return None;
        }
        let way = match (edges, single) {
            _ if cut_out => Way::CutOut,
            (true, _) => Way::Edges,
            (false, true) => Way::Runs,
            (false, false) => Way::Spans,
        };
        let (first_corner, transparent) = (first_corner as u32, is_transparent(list, &polygon));
        Some(Shape { polygon: index as u32, first_corner, corner_count, way, transparent, columns, rows, depth })
    }

    /// Adds the corners of an outline, and returns the box around them; none is added where there are none.
    #[inline]
    fn push_corners(&mut self, outline: &[ScreenVertex]) -> Option<([i32; 2], [i32; 2])> {
        let (mut least, mut most) = ([i32::MAX; 2], [i32::MIN; 2]);
        for vertex in outline {
            let [x, y] = [fixed(vertex.x), fixed(vertex.y)];
            least = [least[0].min(x), least[1].min(y)];
            most = [most[0].max(x), most[1].max(y)];
            self.corners.push([x, y]);
        }
        (!outline.is_empty()).then_some((least, most))
    }
}

/// A coordinate in 1/256 of a sample; exact on grids of up to 8 bits.
#[inline]
fn fixed(snapped: f64) -> i32 {
    (snapped * f64::from(1 << BITS)) as i32
}

/// The first column (or row) whose center is at or after a coordinate in 1/256 of a sample.
#[inline]
fn first_center(fixed: i32) -> i32 {
    const HALF: i32 = 1 << (BITS - 1);
    fixed.saturating_add(HALF - 1) >> BITS
}

/// Whether the target keeps its fragments apart.
#[inline]
fn is_transparent(list: &DrawList, polygon: &ScreenPolygon<'_>) -> bool {
    list.shader.opacity(polygon) != Rgb::gray(1.0)
}

/// The box of samples whose centers may be inside: columns, rows; `None` for a polygon without corners.
///
/// A covered center is at or right of a left edge and strictly left of a right one, so between the outermost corners by the same rule.
fn bounds(polygon: &ScreenPolygon<'_>, list: &DrawList) -> Option<([i32; 2], [i32; 2])> {
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
    Some(([reach[0][0], reach[1][0]], [reach[0][1], reach[1][1]]))
}

/// Whether depth is 1/w itself and lanes of `f32` evaluate it.
fn has_single_depth(list: &DrawList, plane: &Plane) -> bool {
    list.precision == Precision::Single && list.depth_mapping.format == DepthFormat::F32 && plane.fits_single()
}
