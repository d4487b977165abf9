//! Spheres and ellipsoids: columns and bands by number of segments, or SPD's six cube faces by resolution.
//!
//! Why two patterns: columns and bands have planar quads, half as many polygons as triangles would be, and an error
//! with a closed form ([`super::segments`]). The cube pattern is the one whose triangle counts SPD files are known by.
//!
//! Source: E. Haines, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11), 1987, and the SPD package.

use super::segments::{MAX_SPHERE, MIN_SPHERE};
use super::turn::turn;
use super::{Detail, Sheet};
use crate::math::{PI, Vec3, tan, unit};

/// Adds the sphere; nothing where the radius is not above 0.
pub(super) fn sphere(center: Vec3, radius: f64, detail: Detail, sheet: &mut Sheet<'_>) {
    if !(center.is_finite() && radius.is_finite() && radius > 0.0) {
        return;
    }
    match detail {
        Detail::Segments(n) | Detail::Grid([n, _]) => {
            columns_and_bands(n, sheet, |direction| (center + radius * direction, direction));
        }
        Detail::Resolution(n) => cube_faces(center, radius, n.clamp(1, Detail::MAX_RESOLUTION), sheet),
    }
}

/// Adds the ellipsoid about the origin; nothing where one of its half axes is not above 0.
pub(super) fn ellipsoid(radii: Vec3, detail: Detail, sheet: &mut Sheet<'_>) {
    let smallest = radii.min_element();
    if !radii.is_finite() || smallest <= 0.0 {
        return;
    }
    // Points scale by the half axes, normals by their inverse; relative to the smallest they cannot overflow.
    let inverse = Vec3::splat(smallest) / radii;
    columns_and_bands(detail.pair()[0], sheet, |direction| {
        (direction * radii, unit(direction * inverse).unwrap_or(direction))
    });
}

/// `n` columns around the z axis times `n / 2` bands: quads, and triangles at the two poles.
///
/// `place` says where a direction's vertex stands and what its normal is. The quads stay planar under any affine map.
fn columns_and_bands(n: u32, sheet: &mut Sheet<'_>, place: impl Fn(Vec3) -> (Vec3, Vec3)) {
    let n = n.clamp(MIN_SPHERE, MAX_SPHERE).next_multiple_of(2);
    let bands = n / 2;
    let mut vertex = |direction: Vec3| {
        let (position, normal) = place(direction);
        sheet.vertex(position, normal)
    };

    // Push the poles, then column by column the vertices between them, from north to south.
    let north = vertex(Vec3::Z);
    let south = vertex(Vec3::NEG_Z);
    for column in 0..n {
        let (x, y) = turn(column, n);
        for row in 1..bands {
            let (height, width) = turn(row, n);
            vertex(Vec3::new(x * width, y * width, height));
        }
    }
    let at = |column: u32, row: u32| match row {
        0 => north,
        row if row == bands => south,
        // The last column closes onto the first: the seam has one set of vertices.
        row => south + 1 + (column % n) * (bands - 1) + (row - 1),
    };

    // Push the facets band by band, counterclockwise seen from outside: west side down, east side up.
    for row in 0..bands {
        for column in 0..n {
            let (west, east) = (column, column + 1);
            if row == 0 {
                sheet.facet([north, at(west, 1), at(east, 1)]);
            } else if row == bands - 1 {
                sheet.facet([at(west, row), south, at(east, row)]);
            } else {
                sheet.facet([at(west, row), at(west, row + 1), at(east, row + 1), at(east, row)]);
            }
        }
    }
}

/// SPD's pattern: a cube's six faces, each an n x n grid at equal angles, two triangles a cell.
///
/// SPD turns one face's grid about; here the turns act on integer lattice coordinates 0..n of the cube, so that
/// two faces name the points of their common edge alike and share them.
fn cube_faces(center: Vec3, radius: f64, n: u32, sheet: &mut Sheet<'_>) {
    let first = push_lattice(center, radius, n, sheet);
    let turn_a = |[i, j, k]: [u32; 3]| [n - k, j, i];
    let turn_b = |[i, j, k]: [u32; 3]| [n - j, i, k];
    let turn_c = |[i, j, k]: [u32; 3]| [i, n - k, j];
    for face in 0..6 {
        let corner = |u: u32, v: u32| {
            // The turns add up: face 0 has made one, face 5 all six.
            let turned = (0..=face).fold([u, n - v, n], |point, step| match step % 3 {
                0 => turn_a(point),
                1 => turn_b(point),
                _ => turn_c(point),
            });
            first + lattice_index(turned, n)
        };
        for u in 0..n {
            for v in 0..n {
                let (q0, q1, q2, q3) = (corner(u, v), corner(u, v + 1), corner(u + 1, v + 1), corner(u + 1, v));
                sheet.facet([q0, q1, q2]);
                sheet.facet([q2, q3, q0]);
            }
        }
    }
}

/// Pushes the 6 n^2 + 2 lattice points on the cube's surface, blown up to the sphere, in the order of [`lattice_index`].
fn push_lattice(center: Vec3, radius: f64, n: u32, sheet: &mut Sheet<'_>) -> u32 {
    let first = sheet.mesh.vertices.len() as u32;
    let mut push = |i: u32, j: u32, k: u32| {
        let on_cube = Vec3::new(lattice_coordinate(i, n), lattice_coordinate(j, n), lattice_coordinate(k, n));
        let direction = unit(on_cube).expect("one coordinate is 1 or -1");
        sheet.vertex(center + radius * direction, direction);
    };
    for k in [0, n] {
        for j in 0..=n {
            (0..=n).for_each(|i| push(i, j, k));
        }
    }
    for k in 1..n {
        (0..n).for_each(|i| push(i, 0, k));
        (0..n).for_each(|j| push(n, j, k));
        (0..n).for_each(|i| push(n - i, n, k));
        (0..n).for_each(|j| push(0, n - j, k));
    }
    first
}

/// Where a lattice point of the cube's surface stands: bottom layer, top layer, then ring by ring between them.
fn lattice_index([i, j, k]: [u32; 3], n: u32) -> u32 {
    let layer = (n + 1) * (n + 1);
    if k == 0 || k == n {
        return (k / n) * layer + j * (n + 1) + i;
    }
    let around = match (i, j) {
        (i, 0) if i < n => i,
        (i, j) if i == n && j < n => n + j,
        (i, j) if j == n && i > 0 => 2 * n + (n - i),
        (_, j) => 3 * n + (n - j),
    };
    2 * layer + (k - 1) * 4 * n + around
}

/// Position -1..1 of lattice plane `i` of `0..=n`: the planes stand at equal angles, so the grid does on the sphere.
fn lattice_coordinate(i: u32, n: u32) -> f64 {
    // Count from the middle, so that the two halves are mirror images to the bit.
    let from_middle = 2.0 * f64::from(i) - f64::from(n);
    let distance = if i == 0 || i == n { 1.0 } else { tan(PI / 4.0 * (from_middle.abs() / f64::from(n))) };
    if from_middle < 0.0 { -distance } else { distance }
}
