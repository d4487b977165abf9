//! Quads: what a tree is drawn as, two upright rectangles that cross.
//!
//! Why two and no billboard: they need no frame by frame turning and are right from close by; only from straight above they are a cross.
//!
//! Space: a tree of height 1 and crown 1, its foot at the origin; a tree's transform makes it as large as it is.
//! Source: Landscaper 2.0, "two crossed rectangles"; both sides are drawn.

use super::growth::Standing;
use crate::math::{Affine3, Mat3, Vec3, cos, radians, sin};
use crate::scene::{Mesh, NormalSource};

/// The two rectangles; `line` is what messages name.
pub(super) fn crossed(line: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for across in [Vec3::X, Vec3::Y] {
        let corners = [(-0.5, 0.0), (0.5, 0.0), (0.5, 1.0), (-0.5, 1.0)];
        let outline = corners.map(|(side, up)| {
            let index = mesh.push_vertex(across * side + Vec3::Z * up);
            mesh.texture.resize(mesh.vertices.len() - 1, Vec3::ZERO);
            mesh.texture.push(Vec3::new(side + 0.5, up, 0.0));
            index
        });
        mesh.push_polygon(&outline, NormalSource::Facet, line);
    }
    mesh
}

/// Where a tree stands, turned and scaled.
pub(super) fn placed(tree: &Standing) -> Affine3 {
    let (sine, cosine) = (sin(radians(tree.turn)), cos(radians(tree.turn)));
    let x = Vec3::new(cosine, sine, 0.0) * tree.crown;
    let y = Vec3::new(-sine, cosine, 0.0) * tree.crown;
    Affine3 { matrix3: Mat3::from_cols(x, y, Vec3::Z * tree.height), translation: tree.foot }
}
