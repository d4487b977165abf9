//! Rasterizers with a mistake that tests plant: triangles by half planes, sharing nothing with the grader.

#![allow(dead_code, reason = "every test binary uses a part")]

use farop::grade::labs::{self, Aspect};
use farop::grade::{InProcess, Request, Subject, Verdict, grade};
use farop::plan::Accepts;
use farop::raster::{PerPolygon, PolygonRasterizer, Target};
use farop::screen::{Fragment, ScreenPolygon, Shader};

/// What is planted.
#[derive(Clone, Copy)]
pub struct Planted {
    /// Where in a sample is asked.
    pub center: f64,
    pub far_wins: bool,
    /// From this x on it panics.
    pub panics_beyond: i32,
}

pub const RIGHT: Planted = Planted { center: 0.5, far_wins: false, panics_beyond: i32::MAX };
pub const CORNERS: Planted = Planted { center: 0.0, ..RIGHT };
pub const FAR_WINS: Planted = Planted { far_wins: true, ..RIGHT };

fn edge(a: (f64, f64), b: (f64, f64), p: (f64, f64)) -> f64 {
    (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)
}

impl Planted {
    fn covers(&self, corners: &[(f64, f64)], at: (f64, f64)) -> bool {
        let area = edge(corners[0], corners[1], corners[2]);
        (0..3).all(|index| {
            let (mut a, mut b) = (corners[index], corners[(index + 1) % 3]);
            if area < 0.0 {
                (a, b) = (b, a);
            }
            let value = edge(a, b, at);
            area != 0.0 && (value > 0.0 || (value == 0.0 && ((a.1 == b.1 && b.0 > a.0) || b.1 < a.1)))
        })
    }
}

impl PolygonRasterizer for Planted {
    fn draw_polygon(&self, polygon: &ScreenPolygon<'_>, shader: &Shader, target: &mut Target<'_>) {
        let corners: Vec<_> = polygon.vertices().iter().map(|vertex| (vertex.x, vertex.y)).collect();
        for y in 0..target.height() {
            for x in 0..target.width() {
                if !self.covers(&corners, (f64::from(x) + self.center, f64::from(y) + self.center)) {
                    continue;
                }
                assert!(x < self.panics_beyond, "<b>on purpose</b> at {x}");
                let fragment: Fragment = shader.fragment(polygon, x, y);
                let kept = target.depth(x, y);
                let is_nearer =
                    if self.far_wins { kept == 0.0 || fragment.depth < kept } else { fragment.depth > kept };
                if is_nearer {
                    target.put(fragment);
                }
            }
        }
    }

    fn accepts(&self) -> Accepts {
        Accepts::Triangles
    }
}

/// The verdict about a subject in a lab, by visible probes or by hidden ones.
pub fn judged(lab: &str, subject: &dyn Subject, hidden: Option<u64>) -> Verdict {
    let lab = labs::find(lab).expect("a lab");
    let asked = if hidden.is_some() { lab.hidden() } else { *lab };
    let points = |aspect: &Aspect| f64::from(aspect.points) / 2.0;
    let request = Request { lab: &asked, name: "planted".to_string(), seed: hidden.unwrap_or(1), points: &points };
    grade(subject, &request, &mut |_| ())
}

/// The same about what is planted.
pub fn planted(lab: &str, planted: Planted, hidden: Option<u64>) -> Verdict {
    judged(lab, &InProcess(&PerPolygon(planted)), hidden)
}
