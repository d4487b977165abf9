//! Emit: what culling left of a part, lit, clipped, split and projected.
//!
//! survivors -LIGHT, CLIP, SPLIT, PROJECT-> DrawList
//!
//! The second half of the loop of figure 4. A triangle that no plane cuts goes the same way as all others; its three corners just stand
//! on the stack, where the compiler unrolls what is done to them.
//!
//! Space: clip space; corners were brought to samples when they were asked for.

use super::Hand;
use crate::geometry::clip::{ClipVertex, ClipVolume, Clipped, MAX_ATTRIBUTES, Outcode};
use crate::geometry::cull::Survivor;
use crate::geometry::light::LightWork;
use crate::geometry::project::{Corner, Outline};
use crate::geometry::walk::{EyeMesh, Side};
use crate::geometry::{ClippedPolygon, Part, Setting, wear};
use crate::plan::Split;
use crate::scene::NormalSource;
use crate::screen::{DrawList, OWN, PolygonRecord, SharedTriangle};

/// What the polygons of a part have in common on their way to the screen.
struct Way<'a> {
    part: Part<'a>,
    mesh: &'a EyeMesh,
    setting: &'a Setting<'a>,
}

impl Hand {
    /// Light, clip, split, project: appends to `list` what is left of `survivors`.
    pub fn emit(
        &mut self,
        (part, mesh): (Part<'_>, &EyeMesh),
        survivors: &[Survivor],
        setting: &Setting<'_>,
        list: &mut DrawList,
    ) {
        let on_the_way = Way { part, mesh, setting };
        for survivor in survivors {
            let polygon = &part.mesh.polygons[survivor.polygon as usize];
            if mesh.shares
                && !survivor.crossed
                && let &[a, b, c] = part.mesh.outline(polygon)
            {
                let outline = if part.mirrored { [a, c, b] } else { [a, b, c] };
                self.share(&on_the_way, survivor, outline, list);
                continue;
            }
            // Three corners need no memory, and what follows is unrolled for them; it is the same code.
            match (part.mesh.outline(polygon), part.mirrored) {
                (&[a, b, c], false) if !survivor.crossed => self.inside(&on_the_way, survivor, [a, b, c], list),
                (&[a, b, c], true) if !survivor.crossed => self.inside(&on_the_way, survivor, [a, c, b], list),
                _ => self.any(&on_the_way, survivor, list),
            }
        }
    }

    /// A triangle that no plane cuts, for a rasterizer that makes the rest of it.
    #[inline]
    fn share(&mut self, way: &Way<'_>, survivor: &Survivor, outline: [u32; 3], list: &mut DrawList) {
        let Way { part, mesh, setting } = *way;
        self.counts.add_rendered(part.tessellated, false, 3);
        let (corners, lit) = mesh.shared(outline, Side::of(survivor));
        let is_facet = part.mesh.polygons[survivor.polygon as usize].normals == NormalSource::Facet;
        let values = match lit.filter(|_| !is_facet) {
            Some(lit) => lit,
            None => {
                let mut corners = [Corner::default(); 3];
                way.light(survivor, (&outline, &mut corners), &mut self.light);
                let count = if setting.lighting.is_one_color() { 1 } else { 3 };
                let own = &mut list.shared.own;
                let first = own.light.len() as u32 | OWN;
                own.light.extend(corners[..count].iter().map(|corner| corner.values));
                if setting.lighting.carries_factors() {
                    own.factors.extend(corners[..count].iter().map(|corner| corner.factor));
                }
                [0, 1, 2].map(|corner| first + corner.min(count as u32 - 1))
            }
        };
        let number = list.shared.triangles.len() as u32;
        list.shared.triangles.push(SharedTriangle { corners, values });
        list.polygons.push(PolygonRecord::shared(number, part.shading, part.source(survivor.polygon)));
    }

    /// A triangle that no plane cuts.
    #[inline]
    fn inside(&mut self, way: &Way<'_>, survivor: &Survivor, outline: [u32; 3], list: &mut DrawList) {
        let ready = |index| way.mesh.ready(index, way.setting.projector);
        let corner = |index| Corner { ready: ready(index), ..Corner::default() };
        let mut corners = [corner(outline[0]), corner(outline[1]), corner(outline[2])];
        way.light(survivor, (&outline, &mut corners), &mut self.light);
        self.handed_on(way, survivor, &outline, &corners);
        self.project(way, survivor, (&mut corners, None), list);
    }

    /// A polygon of any number of corners.
    fn any(&mut self, way: &Way<'_>, survivor: &Survivor, list: &mut DrawList) {
        self.outline.clear();
        self.outline.extend(way.part.outline(&way.part.mesh.polygons[survivor.polygon as usize]));
        let (outline, mut corners) = (std::mem::take(&mut self.outline), std::mem::take(&mut self.corners));
        corners.clear();
        let ready = |index| way.mesh.ready(index, way.setting.projector);
        corners.extend(outline.iter().map(|&index| Corner { ready: ready(index), ..Corner::default() }));
        // Light belongs to the vertices of the scene (with `relight`, normals take its place until clipping is done).
        way.light(survivor, (&outline, &mut corners), &mut self.light);
        self.clipped.clear();
        let is_in_view = if survivor.crossed {
            self.clip(way, survivor, &outline, &corners)
        } else {
            self.handed_on(way, survivor, &outline, &corners);
            true
        };
        if is_in_view {
            let mut clipped = std::mem::take(&mut self.clipped);
            let cut = (!clipped.is_empty()).then_some(clipped.as_mut_slice());
            self.project(way, survivor, (&mut corners, cut), list);
            self.clipped = clipped;
        }
        (self.outline, self.corners) = (outline, corners);
    }

    /// Clip: leaves in `clipped` what lies inside the view volume, or nothing where all of it does; `false` when none of it does.
    ///
    /// A polygon that crosses no plane passes untouched, to the last bit.
    fn clip(&mut self, way: &Way<'_>, survivor: &Survivor, outline: &[u32], corners: &[Corner]) -> bool {
        let Way { part, setting, .. } = *way;
        let view = &setting.plan.view;
        let volume = ClipVolume { hither: view.hither, yon: Some(view.yon) };
        let planes = if setting.plan.is_unsnapped() { Outcode::DEPTHS } else { Outcode::ALL };
        self.polygon.clear();
        self.polygon.extend(outline.iter().zip(corners).map(|(&index, corner)| way.clip_vertex(index, corner)));
        match self.clipper.clip_by(planes, &self.polygon, &volume, way.carried()) {
            Clipped::Inside => self.handed_on(way, survivor, outline, corners),
            Clipped::Cut(vertices) => {
                self.counts.add_rendered(part.tessellated, true, vertices.len());
                if let Some(trace) = &mut self.trace {
                    let source = part.source(survivor.polygon);
                    trace.clipped.push(ClippedPolygon { source, vertices: vertices.to_vec() });
                }
                self.clipped.extend(vertices.iter().map(|vertex| {
                    let [a, b, c, u, v, red, green, blue] = vertex.attributes;
                    let ready = setting.projector.ready(vertex.position, vertex.edge);
                    Corner { ready, values: [a, b, c], place: [u, v], factor: [red, green, blue] }
                }));
            }
            Clipped::Outside => {
                self.counts.add_clipped(part.tessellated);
                return false;
            }
            Clipped::NotFinite => {
                self.counts.skipped += 1;
                return false;
            }
        }
        true
    }

    /// Counts a polygon that passes clipping as it was.
    #[inline]
    fn handed_on(&mut self, way: &Way<'_>, survivor: &Survivor, outline: &[u32], corners: &[Corner]) {
        self.counts.add_rendered(way.part.tessellated, survivor.crossed, corners.len());
        if let Some(trace) = &mut self.trace {
            let vertices = outline.iter().zip(corners).map(|(&index, corner)| way.clip_vertex(index, corner)).collect();
            trace.clipped.push(ClippedPolygon { source: way.part.source(survivor.polygon), vertices });
        }
    }

    /// Relight where that is chosen, split where the plan says so, and project to the screen: the corners before clipping, and what
    /// clipping left where it cut.
    ///
    /// An outline that crosses itself has no triangles that cover what even-odd covers: it stays whole, if it may, and what
    /// varies follows its first three corners.
    #[inline(always)]
    fn project(
        &mut self,
        way: &Way<'_>,
        survivor: &Survivor,
        (before, cut): (&mut [Corner], Option<&mut [Corner]>),
        list: &mut DrawList,
    ) {
        let Way { part, setting, .. } = *way;
        let (lighting, newell) = (setting.lighting, survivor.facing.newell());
        let from_clipped = lighting.belongs_to_clipped();
        let constants = setting.projector.constants(before);
        let settle = |left: &mut [Corner], work| {
            lighting.relight(part.shading, left, setting.shader, work);
            if !from_clipped {
                left.iter_mut().for_each(|corner| constants.hold(corner));
            }
        };
        let (before, clipped) = match cut {
            Some(cut) => {
                settle(cut, &mut self.light);
                (&*before, &*cut)
            }
            None => {
                settle(before, &mut self.light);
                (&*before, &*before)
            }
        };
        let affine = self.crosses_itself(way, survivor) || lighting.is_affine(before, clipped);
        let outline = Outline { before, clipped, from_clipped, newell, affine };
        let owner = (part.shading, part.source(survivor.polygon));
        let split = match setting.plan.needs.split {
            Split::All => true,
            Split::NotAffine => !affine,
            Split::None => false,
        };
        if split && clipped.len() > 3 {
            self.counts.split += 1;
            let report = setting.projector.emit_triangles(&outline, owner, &mut self.triangles, list);
            self.counts.forced_ears += report.forced as u64;
        } else {
            setting.projector.emit(&outline, owner, list);
        }
    }

    /// Whether an outline crosses itself; it is counted. Shapes make none that does, and three corners cannot.
    #[inline]
    fn crosses_itself(&mut self, way: &Way<'_>, survivor: &Survivor) -> bool {
        let polygon = &way.part.mesh.polygons[survivor.polygon as usize];
        if way.part.tessellated || polygon.count < 4 {
            return false;
        }
        self.places.clear();
        self.places.extend(way.part.outline(polygon).map(|index| way.mesh.positions[index as usize]));
        let crosses = self.crossing.is_in(&self.places, survivor.facing.newell());
        self.counts.self_crossing += u64::from(crosses);
        crosses
    }
}

impl Way<'_> {
    /// Light: what varies at the corners of an outline.
    #[inline(always)]
    fn light(&self, survivor: &Survivor, (outline, corners): (&[u32], &mut [Corner]), work: &mut LightWork) {
        let lit = (self.part, self.mesh, self.setting.shader);
        self.setting.lighting.light_corners(lit, survivor, (outline, corners), work);
        if self.setting.plan.needs.texture {
            wear::dress(self.part, outline, corners);
        }
    }

    /// How many numbers a vertex carries through clipping.
    fn carried(&self) -> usize {
        let places = if self.setting.plan.needs.texture { 5 } else { 0 };
        self.setting.lighting.carried().max(places)
    }

    /// A corner as clipping sees it.
    fn clip_vertex(&self, index: u32, corner: &Corner) -> ClipVertex {
        let position = self.setting.projector.clip_space(self.mesh.positions[index as usize]);
        let mut vertex = ClipVertex { position, ..ClipVertex::default() };
        vertex.attributes = attributes(corner);
        vertex
    }
}

/// What a corner carries through clipping; what is behind [`Way::carried`] is 0.
fn attributes(corner: &Corner) -> [f64; MAX_ATTRIBUTES] {
    let ([a, b, c], [u, v], [red, green, blue]) = (corner.values, corner.place, corner.factor);
    [a, b, c, u, v, red, green, blue]
}
