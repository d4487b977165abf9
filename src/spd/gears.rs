//! gears: size^3 interlocking gearwheels, some of glass; 146 size^3 + 1 polygons.
//!
//! What it tests: concave polygons of 144 vertices beside small quadrilaterals, transparency, many surfaces,
//! back faces, all six clip planes.
//!
//! Source: SPD 3.14. Size 4 is the scene of FAROP's published diagnostics (9345 polygons).

use super::nff::{NO_HIGHLIGHT, Nff, SKY, View};
use super::{Counts, SpdScene, power};
use crate::math::{PI, Vec3, cos, sin};
use std::io;

pub(super) const SCENE: SpdScene = SpdScene {
    name: "gears",
    default_size: 4,
    summary: "size^3 meshing gearwheels with concave faces of 144 vertices, some of glass",
    sized: true,
    fixed_resolution: None,
    view,
    body,
    count: |size, _| {
        let gears = power(size.into(), 3);
        Counts { p: 146 * gears + 1, l: 5, f: gears + 1, ..Counts::default() }
    },
};

const TEETH: u32 = 36;

fn view(_size: u32) -> View {
    View {
        background: SKY,
        from: Vec3::new(-1.1, -2.1, 2.6),
        at: Vec3::ZERO,
        up: Vec3::Z,
        angle: 45.0,
        hither: 1.0,
        resolution: 512,
        lights: vec![
            Vec3::new(2.0, 4.0, 4.0),
            Vec3::new(-2.0, 4.0, 3.0),
            Vec3::new(2.0, -2.5, 2.5),
            Vec3::new(-1.0, -4.0, 2.0),
            Vec3::new(-1.111, -2.121, 2.626),
        ],
    }
}

fn body(nff: &mut Nff<'_>, size: u32) -> io::Result<()> {
    nff.surface([1.0, 0.85, 0.7], [0.3, 0.6, 3.0827, 0.0, 0.0])?;
    nff.polygon(&[(2.0, 2.0), (-2.0, 2.0), (-2.0, -2.0), (2.0, -2.0)].map(|(x, y)| Vec3::new(x, y, 0.0)))?;

    let count = f64::from(size);
    let radius = 1.0 / (count - 0.05 * (count - 1.0));
    let thickness = (1.0 / (2.0 * count)).min(0.1);
    for iz in 0..size {
        for iy in 0..size {
            for ix in 0..size {
                let along = |place: u32| -1.0 + radius + 1.9 * radius * f64::from(place);
                let center = Vec3::new(along(ix), along(iy), 1.0 - f64::from(iz) / count);
                let turned = f64::from((ix + iy + iz) % 2) * PI / f64::from(TEETH);
                surface(nff, [ix, iy, iz])?;
                Gear { center, radius, turned }.draw(nff, thickness)?;
            }
        }
    }
    Ok(())
}

/// A color that neighbors do not share; every fifth gear is of glass.
fn surface(nff: &mut Nff<'_>, [ix, iy, iz]: [u32; 3]) -> io::Result<()> {
    // Multiplied first, then divided: a multiple of 7 must leave a fraction of exactly 0.
    let shade = |number: u32| {
        let sevenths = f64::from(number) / 7.0;
        0.01 + (sevenths - sevenths.floor())
    };
    let color = [
        shade(5 * (3 * ix + 2 * iy + iz + 1)),
        shade(3 * (3 * iy + 2 * iz + ix + 1)),
        shade(2 * (3 * iz + 2 * ix + iy + 1)),
    ];
    let largest = color.into_iter().fold(0.0, f64::max);
    let glass = (4 * ix + 2 * iy + iz) % 5 == 0;
    let finish = if glass { [0.2, 0.0, NO_HIGHLIGHT, 0.8, 1.1] } else { [1.0, 0.0, NO_HIGHLIGHT, 0.0, 0.0] };
    nff.surface(color.map(|channel| channel / largest), finish)
}

struct Gear {
    center: Vec3,
    radius: f64,
    /// The angle of tooth 0: neighbors are half a tooth apart, so that they mesh.
    turned: f64,
}

impl Gear {
    fn draw(&self, nff: &mut Nff<'_>, thickness: f64) -> io::Result<()> {
        let top = self.face(1.0, 0.0);
        let down = Vec3::new(0.0, 0.0, thickness);
        nff.polygon(&top)?;
        for (&here, &next) in crate::math::edges(&top) {
            nff.polygon(&[here, here - down, next - down, next])?;
        }
        nff.polygon(&self.face(-1.0, -thickness))
    }

    /// The outline of a face at height `z`: counterclockwise from above for `sense` 1, clockwise for -1.
    fn face(&self, sense: f64, z: f64) -> Vec<Vec3> {
        let tooth = 2.0 * PI / f64::from(TEETH);
        let (outer, inner) = (0.995 * self.radius, 0.9 * self.radius);
        let corners = [(outer, -0.19), (outer, 0.19), (inner, 0.3), (inner, 0.7)];
        let outline = (0..TEETH).flat_map(|k| {
            let middle = self.turned + sense * f64::from(k) * tooth;
            corners.map(|(radius, place)| {
                let angle = middle + place * sense * tooth;
                self.center + Vec3::new(radius * cos(angle), radius * sin(angle), z)
            })
        });
        outline.collect()
    }
}
