//! The classic screen file, read: from FAROP's whole numbers back to a draw list.
//!
//! text -READ-> DrawList (whole-sample corners, planes fitted to them)
//!
//! A corner at whole numbers (x, y) stands at the center of that sample, (x + 1/2, y + 1/2). Depth is counted from the far
//! end, (zmax + 1 - z) / (zmax + 1): 1 at hither, and above 0 at yon, because 0 is where nothing was drawn. Colors run
//! linearly on the screen: the file holds no w to divide by. A polygon of more than three corners gets one plane a value,
//! the one nearest to all of them; which samples it covers is decided on its whole outline, convex or not.
//!
//! Words may stand on lines as they like. A polygon of 127 corners is no end of file: the number of polygons tells.
//! Space: samples. Source: Pereira, "FAROP", IST/INESC 1996, appendix A.2.

use super::classic_write::MAX_RESOLUTION;
use super::fit::fit;
use super::words::{Layout, Words};
use super::{Kind, ReadOptions, ScreenFile, ScreenFileError, Sheet, read_size};
use crate::color::{Encoding, Rgb};
use crate::math::Vec3;
use crate::plan::{DepthFormat, Interpolation};
use crate::screen::{DepthMapping, DrawList, EdgeKind, PolygonRecord, Precision, ScreenVertex, Source};

/// From here on single precision cannot tell neighboring steps of z apart.
const SINGLE_STEPS: u64 = 1 << 23;

/// Reads a classic file. Its picture has one sample per pixel, a black background and no transparency.
///
/// # Errors
/// [`ScreenFileError`] at the first thing that breaks the format.
pub fn read_classic(text: &str, options: &ReadOptions) -> Result<ScreenFile, ScreenFileError> {
    let mut words = Words::new(text, Layout::Free);
    let (width, height) = read_size(&mut words, 1, options)?;
    let zmax = words.whole("zmax", 1..=u64::from(MAX_RESOLUTION))?;
    let cmax = words.whole("cmax", 1..=u64::from(MAX_RESOLUTION))?;
    let count = words.count("the number of polygons", 44)?;
    let mut list = DrawList::new(width, height);
    list.interpolation = Interpolation::Screen;
    let (nearest, farthest) = (1.0, 1.0 / (zmax + 1) as f64);
    let fine = zmax >= SINGLE_STEPS;
    let format = if fine { DepthFormat::F64 } else { DepthFormat::F32 };
    list.precision = if fine { Precision::Double } else { Precision::Single };
    list.depth_mapping = DepthMapping { format, nearest, farthest };
    list.shader.push_unlit_surface();
    list.polygons.reserve_exact(count);
    let mut reader = Reader { words, zmax, cmax, encoding: options.encoding, list };
    for index in 0..count {
        reader.polygon(index, count)?;
    }
    reader.end()?;
    let sheet = Sheet { encoding: options.encoding, ..Sheet::default() };
    Ok(ScreenFile { kind: Kind::Classic, list: reader.list, sheet })
}

struct Reader<'a> {
    words: Words<'a>,
    zmax: u64,
    cmax: u64,
    encoding: Encoding,
    list: DrawList,
}

impl Reader<'_> {
    fn polygon(&mut self, index: usize, count: usize) -> Result<(), ScreenFileError> {
        self.words.whole("the separator before a polygon", 1..=1)?;
        let word = self.words.word();
        let line = word.line();
        let vertex_count = self.words.count_of(word, "the number of vertices", (3, 12)).map_err(|error| {
            let help = format!("this is polygon {} of the {count} that the file declares", index + 1);
            error.with_help(if word.text == "127" { help + "; a 127 ends the file only behind the last" } else { help })
        })?;
        let bottom = self.words.word();
        let top = self.words.word();
        let first_vertex = self.list.vertices.len();
        for _ in 0..vertex_count {
            self.vertex()?;
        }
        self.check_rows(first_vertex, "ymax, the largest y of the polygon", bottom, f64::max)?;
        self.check_rows(first_vertex, "ymin, the smallest y of the polygon", top, f64::min)?;
        let first_plane = self.push_planes(first_vertex);
        self.list.polygons.push(PolygonRecord {
            first_vertex: first_vertex as u32,
            vertex_count: vertex_count as u32,
            first_plane,
            surface: 0,
            source: Source { line: line as u32, number: index as u32, tessellated: false },
        });
        Ok(())
    }

    /// ymax and ymin say again what the vertices say; where they do not, one of the two is wrong.
    fn check_rows(
        &self,
        first_vertex: usize,
        what: &str,
        word: super::words::Word<'_>,
        choose: fn(f64, f64) -> f64,
    ) -> Result<(), ScreenFileError> {
        let rows = self.list.vertices[first_vertex..].iter().map(|vertex| vertex.y - 0.5);
        let row = rows.reduce(choose).unwrap_or(0.0) as u64;
        self.words.whole_of(word, what, row..=row).map(|_| ())
    }

    fn vertex(&mut self) -> Result<(), ScreenFileError> {
        let x = self.words.whole("x", 0..=u64::from(self.list.width) - 1)? as f64 + 0.5;
        let y = self.words.whole("y", 0..=u64::from(self.list.height) - 1)? as f64 + 0.5;
        let z = self.words.whole("z", 0..=self.zmax)?;
        let mut channel = |name: &str| {
            let level = self.words.whole(name, 0..=self.cmax)?;
            Ok::<_, ScreenFileError>(level as f64 / self.cmax as f64)
        };
        let display = Rgb::new(channel("red")?, channel("green")?, channel("blue")?);
        self.list.values.extend(self.encoding.decode(display).to_array());
        let depth = (self.zmax + 1 - z) as f64 / (self.zmax + 1) as f64;
        let homogeneous = Vec3::new(x, y, 1.0) / depth;
        self.list.vertices.push(ScreenVertex { x, y, homogeneous, edge: EdgeKind::Original });
        Ok(())
    }

    /// Fits depth and the three channels to the polygon's corners, those from `first_vertex` on.
    fn push_planes(&mut self, first_vertex: usize) -> u32 {
        let list = &mut self.list;
        let corners = &list.vertices[first_vertex..];
        let depth = fit(corners.iter().map(|v| [v.x, v.y, 1.0 / v.homogeneous.z]), list.precision);
        let values = &list.values[first_vertex * 3..];
        let channel = |channel: usize| {
            let at_corners = corners.iter().zip(values.chunks_exact(3));
            fit(at_corners.map(|(vertex, color)| [vertex.x, vertex.y, color[channel]]), list.precision)
        };
        let channels = [channel(0), channel(1), channel(2)];
        let first_plane = list.planes.len() as u32;
        list.planes.push(depth);
        list.planes.extend(channels);
        first_plane
    }

    fn end(&mut self) -> Result<(), ScreenFileError> {
        self.words.whole("the separator before the end", 1..=1)?;
        self.words.whole("the end mark", 127..=127)?;
        let word = self.words.word();
        if word.text.is_empty() { Ok(()) } else { Err(self.words.error(word, "the end of the file")) }
    }
}
