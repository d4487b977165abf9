//! The ground of a cell: heights on a lattice, triangles, its cover.

use super::Reader;
use crate::diagnostic::{Diagnostic, Span};
use crate::forest::area::Ground;
use crate::math::Vec3;
use crate::parse::area::turn_in_plane;
use crate::parse::wording::quote;

/// The most columns and rows of a lattice.
pub(super) const MOST_SAMPLES: u16 = 4097;
/// The highest and the lowest place, in metres.
pub(super) const HIGHEST: f64 = 100_000.0;
/// The most vertices of a mesh.
const MOST_VERTICES: usize = 4_000_000;

impl Reader<'_> {
    /// `ground COVER`
    pub(super) fn ground_cover(&mut self) -> Result<(), Diagnostic> {
        self.opened()?;
        let cover = self.cover_index()?;
        self.opened()?.cell.cover = Some(cover);
        Ok(())
    }

    /// `dem COLUMNS ROWS [z0 METRES] [dz METRES]` and the counts.
    pub(super) fn dem(&mut self) -> Result<(), Diagnostic> {
        self.begin_ground(false)?;
        let declared = self.words.peek().span;
        let size = self.lattice_size()?;
        let (mut base, mut step) = (0.0, 1.0);
        loop {
            if self.words.take_field("z0") {
                base = self.words.within("z0", -HIGHEST..=HIGHEST)?;
            } else if self.words.take_field("dz") {
                step = self.words.within("dz", 1e-6..=HIGHEST)?;
            } else {
                break;
            }
        }
        let count = usize::from(size[0]) * usize::from(size[1]);
        let mut counts = Vec::new();
        for found in 0..count {
            let next = self.words.peek();
            if next.begins_statement() {
                let error =
                    Diagnostic::error(format!("`dem` has {found} heights instead of {} x {}", size[0], size[1]));
                let error = error.at(declared, "declared here").at(next.span, "expected a height");
                return Err(error.help("voids are heights, too: write `-` where nothing was measured"));
            }
            counts.push(self.height()?);
        }
        let next = self.words.peek();
        if next.is_numeric() || next.is("nodata") {
            let error = Diagnostic::error(format!("`dem` has more heights than {} x {} = {count}", size[0], size[1]));
            return Err(error.at(next.span, "the first one too many").at(declared, "declared here"));
        }
        self.opened()?.cell.ground = Ground::Lattice { size, base, step, counts };
        Ok(())
    }

    /// Columns and rows.
    pub(super) fn lattice_size(&mut self) -> Result<[u16; 2], Diagnostic> {
        let mut length = |what: &str| self.words.whole(what, 2..=MOST_SAMPLES);
        Ok([length("the number of columns")?, length("the number of rows")?])
    }

    /// One count of a lattice; `-` and `nodata` are voids.
    fn height(&mut self) -> Result<i16, Diagnostic> {
        let word = self.words.peek();
        if word.is("-") || word.is("nodata") {
            self.words.take();
            return Ok(Ground::VOID);
        }
        if crate::parse::tokens::number(word.bytes).is_ok_and(|number| number.value.fract() != 0.0) {
            let error = Diagnostic::error(format!("{} is not a whole count of `dz`", quote(word.bytes)));
            let error = error.at(word.span, "heights are z0 + count x dz");
            return Err(error.help("for heights in decimetres write `dz 0.1` and ten times the metres"));
        }
        self.words.whole("a height", -i16::MAX..=i16::MAX)
    }

    /// `v X Y Z`
    pub(super) fn vertex(&mut self) -> Result<(), Diagnostic> {
        self.begin_ground(true)?;
        let [x, y] = self.position("a vertex")?;
        let z = self.words.within("the height of a vertex", -HIGHEST..=HIGHEST)?;
        let keyword = self.words.keyword;
        if let Ground::Mesh { vertices, .. } = &mut self.opened()?.cell.ground {
            if vertices.len() == MOST_VERTICES {
                return Err(Diagnostic::error(format!("more than {MOST_VERTICES} vertices")).at(keyword, "this one"));
            }
            vertices.push(Vec3::new(x, y, z));
        }
        Ok(())
    }

    /// `t I J K [cover NUMBER]`: vertices counted from 0, in either direction around.
    pub(super) fn triangle(&mut self) -> Result<(), Diagnostic> {
        self.begin_ground(true)?;
        let mut corners = [(0_u32, Span::default()); 3];
        for corner in &mut corners {
            let span = self.words.peek().span;
            *corner = (self.words.whole("a vertex", 0..=u32::MAX)?, span);
        }
        let cover = if self.words.take_field("cover") { Some(self.cover_index()?) } else { None };
        let keyword = self.words.keyword;
        let Ground::Mesh { vertices, triangles } = &mut self.opened()?.cell.ground else { return Ok(()) };
        if let Some((index, span)) = corners.iter().find(|(index, _)| *index as usize >= vertices.len()) {
            let error = Diagnostic::error(format!("there is no vertex {index}")).at(*span, "not in this cell");
            return Err(error.help(format!("the cell has {} vertices up to here; they count from 0", vertices.len())));
        }
        let mut outline = corners.map(|(index, _)| index);
        let [a, b, c] = outline.map(|index| vertices[index as usize].truncate().to_array());
        let turn = turn_in_plane(a, b, c);
        if turn == 0.0 {
            let error = Diagnostic::error("a triangle that is a line seen from above").at(keyword, "no ground");
            return Err(error.help("ground has one height at every place: cliffs must lean a little"));
        }
        if turn < 0.0 {
            outline.swap(1, 2);
        }
        triangles.push((outline, cover));
        Ok(())
    }

    /// Notes that the cell in hand gets heights, from one source only.
    pub(super) fn begin_ground(&mut self, is_mesh: bool) -> Result<(), Diagnostic> {
        let keyword = self.words.keyword;
        let text = quote(self.words.keyword_text());
        let open = self.opened()?;
        let first = *open.ground.get_or_insert(keyword);
        // Vertices and triangles add up; everything else says it all.
        let goes_on = is_mesh && matches!(open.cell.ground, Ground::Mesh { .. }) && !self.is_single(first);
        if first == keyword || goes_on || self.is_lost {
            return Ok(());
        }
        let error = Diagnostic::error(format!("{text} in a cell that has its ground already"));
        let error = error.at(keyword, "again").at(first, "here");
        Err(error.help("a cell has one `dem`, or one `demref`, or vertices and triangles"))
    }

    /// Whether the statement there is one that gives all heights: `dem` or `demref`.
    fn is_single(&self, keyword: Span) -> bool {
        self.words.source.text[keyword.start as usize..keyword.end as usize].starts_with(b"dem")
    }
}
