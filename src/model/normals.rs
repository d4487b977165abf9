//! Normals of polygons, their mean around a vertex, and how normals are carried to another space.
//!
//! Why the mean takes back faces too: SIPP and FAROP decide a vertex's normal from the surface alone, so that its
//! color does not jump when one of the polygons around it turns away from the eye.
//!
//! Source: H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE Trans. Computers C-20(6), 1971.

use crate::math::{Affine3, Mat3, Vec3, edges, unit};
use crate::scene::{Mesh, Polygon};

/// The unit Newell normal of one polygon; `None` where it has no area (or its square leaves the range of `f64`).
///
/// The same sum as [`crate::math::newell_normal`], without copying the outline's points together first.
#[must_use]
pub fn polygon_normal(mesh: &Mesh, polygon: &Polygon) -> Option<Vec3> {
    let outline = mesh.outline(polygon);
    let origin = mesh.vertices[*outline.first()? as usize];
    let from_origin = |index: u32| mesh.vertices[index as usize] - origin;
    unit(edges(outline).map(|(&a, &b)| from_origin(a).cross(from_origin(b))).sum())
}

/// Writes into `normals`, for every vertex of `mesh`, the unit mean of the unit normals of all polygons around it.
///
/// Zero where there is no mean: no polygon with an area uses the vertex, or the normals around it cancel. Whoever
/// lights such a vertex takes the polygon's own normal. A polygon that visits a vertex twice counts twice.
/// `normals` is emptied first and keeps its memory.
pub fn averaged_normals(mesh: &Mesh, normals: &mut Vec<Vec3>) {
    normals.clear();
    normals.resize(mesh.vertices.len(), Vec3::ZERO);
    for polygon in &mesh.polygons {
        if let Some(normal) = polygon_normal(mesh, polygon) {
            mesh.outline(polygon).iter().for_each(|&index| normals[index as usize] += normal);
        }
    }
    for normal in normals {
        // Two opposite normals rarely sum to exactly zero; what is left of them is rounding, not a direction.
        *normal = if normal.length_squared() < 1e-24 { Vec3::ZERO } else { unit(*normal).unwrap_or(Vec3::ZERO) };
    }
}

/// The matrix that carries normals where `target_from_source` carries points; make its results unit again.
///
/// It is the inverse transpose times the magnitude of the determinant: the matrix of cofactors, which needs no division and so holds
/// for a scale of (1, 1, 1e-8) too. `None` where the map flattens space, as far as rounding can tell, or is not finite: nothing then
/// has two sides.
#[must_use]
pub fn normals_from(target_from_source: &Affine3) -> Option<Mat3> {
    let scaled = scaled_to_one(target_from_source)?;
    let cofactors = Mat3::from_cols(
        scaled.y_axis.cross(scaled.z_axis),
        scaled.z_axis.cross(scaled.x_axis),
        scaled.x_axis.cross(scaled.y_axis),
    );
    let determinant = scaled.determinant();
    // Turned before and after, a flat map has a determinant of noise: a few last places of what it is summed from. Lengths of rows or of
    // columns bound that sum, and the smaller bound keeps a needle that is turned on one side only.
    let bound = |matrix: &Mat3| matrix.x_axis.length() * matrix.y_axis.length() * matrix.z_axis.length();
    let noise = 8.0 * f64::EPSILON * bound(&scaled).min(bound(&scaled.transpose()));
    (determinant.abs() > noise).then(|| if determinant < 0.0 { -cofactors } else { cofactors })
}

/// Whether the map turns a left hand into a right one: outlines must then be reversed to keep their front.
#[must_use]
pub fn mirrors(target_from_source: &Affine3) -> bool {
    scaled_to_one(target_from_source).is_some_and(|matrix| matrix.determinant() < 0.0)
}

/// The linear part with its largest number brought to 1, so that a scale of 1e-150 has a determinant.
fn scaled_to_one(map: &Affine3) -> Option<Mat3> {
    let largest = map.matrix3.to_cols_array().into_iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
    let finite = map.matrix3.is_finite() && map.translation.is_finite();
    // Identity stays identity to the bit.
    (finite && largest > 0.0).then(|| Mat3::from_cols_array(&map.matrix3.to_cols_array().map(|x| x / largest)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::NormalSource;

    /// Two squares that meet at a right angle along the z axis, and a third vertex list entry nobody uses.
    fn corner() -> Mesh {
        let mut mesh = Mesh::default();
        let points = [(0., 0., 0.), (1., 0., 0.), (1., 0., 1.), (0., 0., 1.), (0., 1., 0.), (0., 1., 1.), (9., 9., 9.)];
        points.iter().for_each(|&(x, y, z)| {
            mesh.push_vertex(Vec3::new(x, y, z));
        });
        mesh.push_polygon(&[0, 1, 2, 3], NormalSource::Averaged, 1);
        mesh.push_polygon(&[0, 3, 5, 4], NormalSource::Averaged, 2);
        mesh
    }

    #[test]
    fn a_shared_vertex_gets_the_mean_of_its_polygons() {
        let mut normals = vec![Vec3::ONE; 99];
        averaged_normals(&corner(), &mut normals);
        // The first square faces -y, the second -x... seen from their fronts.
        let diagonal = Vec3::new(-1.0, -1.0, 0.0) / 2f64.sqrt();
        let expected = [diagonal, Vec3::NEG_Y, Vec3::NEG_Y, diagonal, Vec3::NEG_X, Vec3::NEG_X, Vec3::ZERO];
        assert_eq!(normals.len(), 7);
        for (normal, expected) in normals.iter().zip(expected) {
            assert!((*normal - expected).length() < 1e-15, "{normal} {expected}");
        }
    }

    #[test]
    fn normals_that_cancel_leave_zero() {
        let mut mesh = corner();
        mesh.push_polygon(&[3, 2, 1, 0], NormalSource::Averaged, 3);
        let mut normals = Vec::new();
        averaged_normals(&mesh, &mut normals);
        assert_eq!(normals[1], Vec3::ZERO);
        assert!((normals[0] - Vec3::NEG_X).length() < 1e-15);
    }

    #[test]
    fn carried_normals_stay_square_to_the_surface() {
        let squash = Affine3::from_scale(Vec3::new(1.0, -2.0, 1e-8));
        let (a, b) = (Vec3::new(1.0, 0.3, -0.5), Vec3::new(0.2, 1.0, 0.4));
        let normal = normals_from(&squash).expect("not flat") * a.cross(b);
        let carried = (squash.transform_vector3(a), squash.transform_vector3(b));
        assert!(unit(normal).expect("finite").dot(unit(carried.0).expect("finite")).abs() < 1e-15);
        // A mirror keeps the front in front: reversed, the carried outline has the carried normal.
        assert!(mirrors(&squash));
        assert!(normal.dot(carried.1.cross(carried.0)) > 0.0);
        assert_eq!(normals_from(&Affine3::IDENTITY), Some(Mat3::IDENTITY));
        assert_eq!(normals_from(&Affine3::from_scale(Vec3::new(1.0, 1.0, 0.0))), None);
        assert!(normals_from(&Affine3::from_scale(Vec3::splat(1e-150))).is_some());
    }

    #[test]
    fn a_flat_map_is_known_behind_turns_and_a_needle_is_not_flat() {
        let turns = [0.3, 1.1, 2.9]
            .map(|angle| Affine3::from_axis_angle(unit(Vec3::new(1.0, angle, -0.4)).expect("a way"), angle));
        for (before, after) in turns.iter().flat_map(|before| turns.iter().map(move |after| (before, after))) {
            for flat in [Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 3.0, 1e3), Vec3::new(1e-20, 0.0, 0.0)] {
                assert_eq!(normals_from(&(*after * Affine3::from_scale(flat) * *before)), None, "{flat}");
            }
            let plate = Affine3::from_scale(Vec3::new(1.0, 1e-10, 1.0));
            let needle = Affine3::from_scale(Vec3::new(1e-8, 1.0, 1e-8));
            for map in [*after * plate * *before, *after * needle, needle * *before] {
                assert!(normals_from(&map).is_some());
            }
        }
    }
}
