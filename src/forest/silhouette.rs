//! Silhouettes: a scene without pictures, for rasterizers that know colors only.
//!
//! Scene of a frame -SILHOUETTES-> Scene: a tree is the outline of its picture in one color, ground has the mean color of its picture
//!
//! Why: a program of a student gets polygons and light, no pictures ([`raster::external`](crate::raster::external)). Without them a tree
//! would be a white rectangle. Its outline, found from the picture itself, still looks like a tree, whatever the picture is.
//!
//! The outline has a left and a right point for each of [`BANDS`] heights: the mean of the outermost texels there. So it is one simple
//! polygon, never more; sky between branches is lost. Feet are darker than tops, and no two trees are equally light.
//!
//! Space: that of the scene. Source: ours. Cost: one look at every picture a scene, 2 [`BANDS`] + 2 vertices a tree.

use super::random::mix64;
use crate::color::{Encoding, Rgb};
use crate::image::textures::{Mosaic, Texels, Wrap};
use crate::math::Vec3;
use crate::scene::{Fade, Mesh, Polygon, Scene, Surface, Texture};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Heights between which the outline is straight.
pub const BANDS: u32 = 10;
/// An outline is at least this wide everywhere, as a share of the picture.
const LEAST: f64 = 0.01;

/// What stands for a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Silhouette {
    /// The outline in texture space, counterclockwise; all of the picture where it has no holes.
    pub outline: Vec<[f64; 2]>,
    /// The mean color of what is there: the mean of the light, as a display value.
    pub color: Rgb,
}

impl Silhouette {
    /// The silhouette of a picture: its texels with alpha above `threshold`, or all of them. `None` where nothing is there.
    #[must_use]
    pub fn of(texels: &Texels, threshold: Option<f64>) -> Option<Silhouette> {
        let least = threshold.map_or(0.0, |threshold| threshold * 255.0);
        let is_there = |texel: &[u8; 4]| threshold.is_none() || f64::from(texel[3]) > least;
        let color = mean(texels.rgba().iter().filter(|texel| is_there(texel)))?;
        let outline = match threshold {
            None => vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            Some(_) => outline(texels, is_there)?,
        };
        Some(Silhouette { outline, color })
    }
}

/// The mean light of texels, as a display value.
fn mean<'a>(texels: impl Iterator<Item = &'a [u8; 4]>) -> Option<Rgb> {
    let mut counts = [[0u64; 256]; 3];
    let mut all = 0;
    for texel in texels {
        all += 1;
        counts.iter_mut().zip(texel).for_each(|(counts, &level)| counts[usize::from(level)] += 1);
    }
    let light = |counts: &[u64; 256]| {
        let decoded = (0..256).map(|level| {
            let value = f64::from(level) / 255.0;
            Encoding::Srgb.decode(Rgb::gray(value)).r * counts[level as usize] as f64
        });
        decoded.sum::<f64>() / all as f64
    };
    let shown = |light: f64| f64::from(Encoding::Srgb.level(light as f32)) / 255.0;
    (all > 0).then(|| Rgb::new(shown(light(&counts[0])), shown(light(&counts[1])), shown(light(&counts[2]))))
}

/// Left and right points of a picture at [`BANDS`] + 1 heights.
fn outline(texels: &Texels, is_there: impl Fn(&[u8; 4]) -> bool) -> Option<Vec<[f64; 2]>> {
    let (width, height) = texels.size();
    let rows: Vec<Option<[f64; 2]>> = texels
        .rgba()
        .chunks_exact(width as usize)
        .map(|row| {
            let first = row.iter().position(&is_there)?;
            let last = row.iter().rposition(&is_there)?;
            Some([first as f64 / f64::from(width), (last + 1) as f64 / f64::from(width)])
        })
        .collect();
    let lowest = rows.iter().position(Option::is_some)?;
    let highest = rows.iter().rposition(Option::is_some)?;
    let (bottom, top) = (lowest as f64, (highest + 1) as f64);
    let (mut left, mut right) = (Vec::new(), Vec::new());
    let mut last = rows[lowest]?;
    for band in 0..=BANDS {
        let middle = bottom + (top - bottom) * f64::from(band) / f64::from(BANDS);
        let reach = (top - bottom) / f64::from(BANDS) / 2.0;
        let near = (middle - reach).floor().max(bottom) as usize..(middle + reach).ceil().min(top) as usize;
        let known: Vec<[f64; 2]> = rows[near].iter().flatten().copied().collect();
        if !known.is_empty() {
            last = [0, 1].map(|side| known.iter().map(|row| row[side]).sum::<f64>() / known.len() as f64);
        }
        let v = middle / f64::from(height);
        let slack = ((LEAST - (last[1] - last[0])) / 2.0).max(0.0);
        left.push([last[0] - slack, v]);
        right.push([last[1] + slack, v]);
    }
    right.extend(left.into_iter().rev());
    Some(right)
}

/// The scene with silhouettes in place of pictures.
#[must_use]
pub fn without_pictures(scene: &Scene) -> Scene {
    // Pictures are shared by many textures of a frame, and looked at once each.
    let mut known = BTreeMap::new();
    let surfaces = scene.surfaces.iter().map(|surface| {
        let Some((_, texture)) = scene.picture_on(surface) else { return surface.clone() };
        // A map is neither a tree nor ground.
        if texture.lookup.is_some() {
            return Surface { mesh: Mesh::default(), ..surface.clone() };
        }
        let threshold = texture.cut_out.map(|cut_out| cut_out.threshold);
        let key = (Arc::as_ptr(&texture.texels) as usize, threshold.map(f64::to_bits));
        match known.entry(key).or_insert_with(|| Silhouette::of(&texture.texels, threshold)) {
            Some(silhouette) if is_the_larger(texture.fade) => changed(surface, texture, silhouette),
            _ => Surface { mesh: Mesh::default(), ..surface.clone() },
        }
    });
    Scene { surfaces: surfaces.collect(), textures: Vec::new(), ..scene.clone() }
}

/// Of two surfaces that fade into each other, the one with more samples is shown, of two equal ones that with the lower ranks.
fn is_the_larger(fade: Option<Fade>) -> bool {
    fade.is_none_or(|Fade { from, to }| {
        let (shown, rest) = (to.saturating_sub(from), Fade::RANKS.saturating_sub(to.saturating_sub(from)));
        shown > rest || (shown == rest && from == 0)
    })
}

/// A surface in the color of its picture; polygons with holes become outlines.
fn changed(surface: &Surface, texture: &Texture, silhouette: &Silhouette) -> Surface {
    let mut changed = surface.clone();
    let material = &mut changed.material;
    material.texture = None;
    // Products of light, not of display values.
    let product = Encoding::Srgb.decode(material.color) * Encoding::Srgb.decode(silhouette.color);
    material.color = product.map(|light| f64::from(Encoding::Srgb.level(light as f32)) / 255.0);
    let mesh = &surface.mesh;
    if let Some(mosaic) = &texture.mosaic {
        changed.material.color = surface.material.color;
        changed.mesh.colors = colors_of(mesh, mosaic, texture.wrap);
    }
    if texture.cut_out.is_none() {
        changed.mesh.texture = Vec::new();
        return changed;
    }
    changed.mesh = Mesh::default();
    for polygon in &mesh.polygons {
        outlined(mesh, polygon, &silhouette.outline, &mut changed.mesh);
    }
    changed
}

/// At every vertex, the mean color of the tile there.
fn colors_of(mesh: &Mesh, mosaic: &Mosaic, wrap: Wrap) -> Vec<Rgb> {
    let tiles: Vec<Rgb> = mosaic
        .tiles()
        .iter()
        .map(|tile| Silhouette::of(&tile.texels, None).map_or(Rgb::WHITE, |silhouette| silhouette.color))
        .collect();
    let own = |vertex: usize| mesh.colors.get(vertex).copied().unwrap_or(Rgb::WHITE);
    let at = |place: &Vec3| tiles[mosaic.at([place.x, place.y], wrap).0];
    mesh.texture.iter().enumerate().map(|(vertex, place)| own(vertex) * at(place)).collect()
}

/// How light a tree is at a height (0 to 1): darker at its foot, and each a little different, or a wood would be one sheet of color.
fn shade(number: u32, height: f64) -> f64 {
    let chance = mix64(u64::from(number)) >> 11;
    let own = chance as f64 / (1u64 << 53) as f64;
    (0.6 + 0.4 * height.clamp(0.0, 1.0)) * (0.75 + 0.25 * own)
}

/// Adds the outline where a polygon wears its picture; nothing where the picture has no place on it.
fn outlined(mesh: &Mesh, polygon: &Polygon, outline: &[[f64; 2]], into: &mut Mesh) {
    let corners = mesh.outline(polygon);
    let of = |corner: u32| (mesh.vertices[corner as usize], mesh.texture[corner as usize]);
    let (origin, start) = of(corners[0]);
    // The map from texture space to the polygon's plane: from its first corner and the two that span most of the picture with it.
    let mut best = (0.0, Vec3::ZERO, Vec3::ZERO);
    for pair in corners[1..].windows(2) {
        let ((p, a), (q, b)) = (of(pair[0]), of(pair[1]));
        let (a, b) = (a - start, b - start);
        let area = a.x * b.y - a.y * b.x;
        if area.abs() > f64::abs(best.0) {
            let (p, q) = (p - origin, q - origin);
            best = (area, (p * b.y - q * a.y) / area, (q * a.x - p * b.x) / area);
        }
    }
    let (area, along_u, along_v) = best;
    if area == 0.0 {
        return;
    }
    let normal = mesh.normals.get(corners[0] as usize).copied();
    let own = mesh.colors.get(corners[0] as usize).copied().unwrap_or(Rgb::WHITE);
    let mut added: Vec<u32> = Vec::with_capacity(outline.len());
    for [u, v] in outline {
        let place = origin + along_u * (u - start.x) + along_v * (v - start.y);
        added.push(match normal {
            Some(normal) => into.push_vertex_with_normal(place, normal),
            None => into.push_vertex(place),
        });
        // The first color makes room for those before it.
        into.colors.resize(into.vertices.len(), Rgb::WHITE);
        if let Some(color) = into.colors.last_mut() {
            *color = own * Rgb::gray(shade(polygon.line, *v));
        }
    }
    // The front stays the front.
    if area < 0.0 {
        added.reverse();
    }
    into.push_polygon(&added, polygon.normals, polygon.line);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::textures::{FirstRow, Tile};
    use crate::scene::{Material, NormalSource, Place, TextureId};

    /// A triangle of green on nothing, point up, drawn by hand: 8 x 8.
    fn fir() -> Texels {
        let green = |x: i32, y: i32| (2 * (x - 4).abs() <= 8 - y && 2 * (3 - x).abs() <= 8 - y) as u8 * 255;
        let rgba = (0..64).map(|at| [30, 90, 30, green(at % 8, at / 8)]).collect();
        Texels::new(8, 8, rgba, FirstRow::AtV0).expect("64 texels")
    }

    #[test]
    fn an_outline_follows_the_picture() {
        let silhouette = Silhouette::of(&fir(), Some(0.5)).expect("there is something");
        assert_eq!(silhouette.outline.len(), 2 * (BANDS as usize + 1));
        let widths: Vec<f64> = (0..=BANDS as usize)
            .map(|band| silhouette.outline[band][0] - silhouette.outline[2 * BANDS as usize + 1 - band][0])
            .collect();
        assert!(widths.windows(2).all(|pair| pair[0] >= pair[1]), "narrower upwards: {widths:?}");
        assert!(widths[0] > 0.9 && widths[BANDS as usize] < 0.3, "{widths:?}");
        assert_eq!(silhouette.color, Rgb::new(30.0, 90.0, 30.0).map(|level| level / 255.0));
        let whole = Silhouette::of(&fir(), None).expect("all of it");
        assert_eq!(whole.outline.len(), 4);
        assert_eq!(
            Silhouette::of(&Texels::new(1, 1, vec![[9, 9, 9, 0]], FirstRow::Top).expect("one"), Some(0.5)),
            None
        );
    }

    fn wearing(texture: Texture, corners: &[([f64; 3], [f64; 2])]) -> Scene {
        let mut mesh = Mesh::default();
        let outline: Vec<u32> = corners.iter().map(|(place, _)| mesh.push_vertex(Vec3::from(*place))).collect();
        mesh.texture = corners.iter().map(|(_, [u, v])| Vec3::new(*u, *v, 0.0)).collect();
        mesh.push_polygon(&outline, NormalSource::Facet, 7);
        let material = Material { texture: Some(TextureId(0)), ..Material::default() };
        let surface = Surface { material, mesh, primitives: Vec::new(), two_sided: true, place: Place::default() };
        Scene { surfaces: vec![surface], textures: vec![texture], ..Scene::default() }
    }

    #[test]
    fn a_tree_becomes_its_outline_where_it_stands() {
        let quad = [
            ([10.0, 5.0, 2.0], [0.0, 0.0]),
            ([14.0, 5.0, 2.0], [1.0, 0.0]),
            ([14.0, 5.0, 12.0], [1.0, 1.0]),
            ([10.0, 5.0, 12.0], [0.0, 1.0]),
        ];
        let scene = without_pictures(&wearing(Texture::cut_out("fir", fir(), 0.5), &quad));
        let mesh = &scene.surfaces[0].mesh;
        assert!(scene.textures.is_empty() && scene.surfaces[0].material.texture.is_none() && mesh.texture.is_empty());
        assert_eq!((mesh.polygons.len(), mesh.polygons[0].line), (1, 7));
        let (low, high) = mesh
            .vertices
            .iter()
            .fold((mesh.vertices[0], mesh.vertices[0]), |(low, high), v| (low.min(*v), high.max(*v)));
        assert!(
            (low - Vec3::new(10.0, 5.0, 2.0)).abs().max_element() < 0.3
                && (high - Vec3::new(14.0, 5.0, 12.0)).abs().max_element() < 1.5,
            "{low} {high}"
        );
        let (foot, top) = (mesh.colors[0], mesh.colors[BANDS as usize]);
        assert!(mesh.colors.len() == mesh.vertices.len() && foot.g < top.g, "darker at its foot: {foot:?} {top:?}");
        // Turned round, it stays where it is, and its front is the other side.
        let turned: Vec<_> = quad.iter().rev().copied().collect();
        let back = without_pictures(&wearing(Texture::cut_out("fir", fir(), 0.5), &turned));
        let normal = |scene: &Scene| {
            let mesh = &scene.surfaces[0].mesh;
            let corner = |n: usize| mesh.vertices[mesh.outlines[n] as usize];
            (corner(BANDS as usize) - corner(0)).cross(corner(BANDS as usize + 5) - corner(0)).y
        };
        assert!(normal(&scene) * normal(&back) < 0.0);
    }

    #[test]
    fn a_mosaic_gives_its_colors_to_the_vertices_and_of_two_that_fade_one_is_left() {
        let tile = |color: [u8; 4]| Tile {
            texels: Texels::new(1, 1, vec![color], FirstRow::Top).expect("one").into(),
            repeat: [3.0; 2],
        };
        let tiles = vec![tile([255, 0, 0, 255]), tile([0, 0, 255, 255])];
        let mosaic = Mosaic::new((2, 1), vec![0, 1], FirstRow::Top, tiles).expect("legal");
        let quad = [([0.0; 3], [0.1, 0.0]), ([9.0, 0.0, 0.0], [0.9, 0.0]), ([9.0, 9.0, 0.0], [0.9, 1.0])];
        let scene = without_pictures(&wearing(Texture::mosaic("land", mosaic), &quad));
        let (red, blue) = (Rgb::new(1.0, 0.0, 0.0), Rgb::new(0.0, 0.0, 1.0));
        assert_eq!(scene.surfaces[0].mesh.colors, [red, blue, blue]);
        let left = |from: u8, to: u8| {
            let faded = Texture::cut_out("fir", fir(), 0.5).faded(from, to);
            without_pictures(&wearing(faded, &quad)).surfaces[0].mesh.polygons.len()
        };
        for k in 0..=16 {
            assert_eq!(left(0, k) + left(k, 16), 1, "{k}");
        }
    }

    #[test]
    fn ground_keeps_its_polygons_and_has_the_color_of_its_picture() {
        let quad = [([0.0; 3], [0.0, 0.0]), ([9.0, 0.0, 0.0], [8.0, 0.0]), ([9.0, 9.0, 0.0], [8.0, 8.0])];
        let black_and_white = Texels::new(2, 1, vec![[0, 0, 0, 255], [255; 4]], FirstRow::Top).expect("two");
        let scene = without_pictures(&wearing(Texture::opaque("floor", black_and_white), &quad));
        // The mean of light is brighter than that of levels.
        assert_eq!(scene.surfaces[0].material.color, Rgb::gray(188.0 / 255.0));
        assert_eq!(scene.surfaces[0].mesh.vertices.len(), 3);
    }
}
