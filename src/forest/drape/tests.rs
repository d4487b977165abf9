//! Tests of drapes: the figures of papers and prototypes, and what must hold for every view.

use super::*;
use crate::scene::Place;

/// The six views whose figures are known: metres above the land, degrees below level, near plane.
const VIEWS: [(f64, f64, f64); 6] = [
    (2.0, 5.0, 0.5),
    (40.0, 10.0, 1.0),
    (650.0, 30.0, 5.0),
    (650.0, 50.0, 5.0),
    (650.0, 70.0, 5.0),
    (650.0, 85.0, 5.0),
];

/// Land 4 km wide and 50 m high, seen 2 km far with an opening of 1 radian, turned by `turn` degrees.
fn view((above, down, near): (f64, f64, f64), turn: f64) -> View {
    let (down, turn) = (crate::math::radians(down), crate::math::radians(turn));
    let (sin, cos) = (crate::math::sin(down), crate::math::cos(down));
    let from = Vec3::new(1e5, 4e6, 50.0 + above);
    let ahead = Vec3::new(cos * crate::math::sin(turn), cos * crate::math::cos(turn), -sin);
    let camera = Camera {
        from,
        at: from + ahead,
        up: Vec3::Z,
        angle: 1.0_f64.to_degrees(),
        hither: near,
        yon: None,
        resolution: (1024, 768),
        place: Place::default(),
    };
    let half = Vec3::new(2000.0, 2000.0, 0.0);
    let middle = Vec3::new(from.x, from.y, 0.0);
    View::of_camera(&camera, (1024, 768), 2000.0, [middle - half, middle + half + Vec3::Z * 50.0])
}

fn texels(method: Method, view: &View) -> Option<(f64, f64)> {
    let texels = Texels::of(&Drape::new(method, view)?, view, 1024)?;
    Some((texels.first_percentile, texels.median))
}

/// What was measured with prototypes of their own: `shared/forest.md` 4.5.
#[test]
fn the_known_figures_come_out() {
    let uniform = [(0.002, 0.040), (0.028, 0.084), (0.333, 0.508), (0.338, 0.510), (0.623, 0.766), (0.846, 0.917)];
    let thesis = [Some((0.084, 0.170)), Some((0.805, 0.923)), Some((0.611, 0.755)), Some((0.195, 0.335)), None, None];
    let program = [(0.092, 0.627), (0.613, 0.853), (0.725, 0.834), (0.384, 0.557), (0.178, 0.305), (0.657, 0.785)];
    let searched = [(0.280, 0.430), (0.922, 0.949), (0.950, 0.966), (0.932, 0.955), (0.925, 0.964), (0.926, 0.962)];
    for (index, &height) in VIEWS.iter().enumerate() {
        let view = view(height, 0.0);
        let near = |found: (f64, f64), known: (f64, f64), share: f64| {
            let off = |found: f64, known: f64| (found - known).abs() < share * known + 0.0015;
            off(found.0, known.0) && off(found.1, known.1)
        };
        let found = texels(Method::Uniform, &view).expect("land in view");
        assert!(near(found, uniform[index], 0.02), "uniform {height:?}: {found:?}");
        match (texels(Method::Thesis, &view), thesis[index]) {
            (Some(found), Some(known)) => assert!(near(found, known, 0.02), "thesis {height:?}: {found:?}"),
            (found, known) => assert_eq!(found, known, "{height:?}"),
        }
        let found = texels(Method::Program, &view).expect("an answer");
        assert!(near(found, program[index], 0.05), "program {height:?}: {found:?}");
        let (found, known) = (texels(Method::Searched, &view).expect("an answer"), searched[index]);
        assert!(found.0 >= 0.95 * known.0 && found.1 >= 0.95 * known.1, "searched {height:?}: {found:?}");
    }
}

#[test]
fn all_that_can_be_seen_is_on_the_map() {
    for height in VIEWS {
        for turn in [0.0, 33.0, 90.0, 180.0, 271.5] {
            let view = view(height, turn);
            let body = body::seen(&view);
            assert!(body.len() > 8, "{height:?}");
            for method in [Method::Uniform, Method::Searched] {
                let drape = Drape::new(method, &view).expect("land in view");
                for &point in &body {
                    let place = drape.place(point.truncate()).expect("ahead of the center");
                    assert!(place.min_element() > -1e-6 && place.max_element() < 1.0 + 1e-6, "{height:?} {place}");
                }
            }
        }
    }
}

/// By differences: the program takes derivatives.
#[test]
fn texels_are_those_of_small_steps() {
    let view = view(VIEWS[1], 20.0);
    let pixel = |point: Vec3| {
        let arm = point - view.from;
        Vec2::new(arm.dot(view.right), arm.dot(view.up)) * (view.focal / arm.dot(view.ahead))
    };
    for method in [Method::Uniform, Method::Searched] {
        let drape = Drape::new(method, &view).expect("land in view");
        for spot in measure::points(&view).into_iter().step_by(37) {
            let point = spot.point;
            let worst = (0..3600).map(|angle| {
                let angle = f64::from(angle) / 3600.0 * crate::math::PI;
                let step = Vec3::new(crate::math::cos(angle), crate::math::sin(angle), 0.0) * 1e-3;
                let on_map = |point: Vec3| drape.place(point.truncate()).expect("on the map");
                (on_map(point + step) - on_map(point - step)).length()
                    / (pixel(point + step) - pixel(point - step)).length()
            });
            let worst = worst.fold(f64::INFINITY, f64::min);
            let found = measure::worst(&drape, &view, &[spot]);
            assert!((found / worst - 1.0).abs() < 1e-3, "{point}: {found} {worst}");
        }
    }
}

/// A plane half as high as the box: judged by its own faces a map is at least as sharp on it as one that is fit to the box.
#[test]
fn the_land_itself_is_a_better_measure_than_its_box() {
    for (height, slope) in VIEWS.into_iter().zip([0.0, 0.02, -0.01, 0.01, 0.0, 0.02]) {
        let mut view = view(height, 10.0);
        view.land[1].z += 400.0;
        view.land[0].z -= 400.0;
        let middle = view.from.truncate();
        let at = |x: f64, y: f64| (middle + Vec2::new(x, y) * 100.0).extend(25.0 + slope * 100.0 * x);
        let faces: Vec<[Vec3; 4]> = (-20..20)
            .flat_map(|x| (-20..20).map(move |y| (f64::from(x), f64::from(y))))
            .map(|(x, y)| [at(x, y), at(x + 1.0, y), at(x + 1.0, y + 1.0), at(x, y + 1.0)])
            .collect();
        let (drape, texels) =
            Drape::on_land(Method::Searched, &view, 1024, faces.iter().map(<[Vec3; 4]>::as_slice)).expect("in view");
        let spots: Vec<Spot> = faces
            .iter()
            .map(|face| (body::in_view(&view, face), newell_normal(face)))
            .filter(|(part, _)| part.len() > 2)
            .map(|(part, normal)| Spot { point: part.iter().sum::<Vec3>() / part.len() as f64, normal })
            .collect();
        let of_box = Drape::new(Method::Searched, &view).expect("in view");
        let by_box = Texels::at(&of_box, &view, &spots, 1024).expect("in view");
        assert!(texels.first_percentile >= 0.99 * by_box.first_percentile, "{height:?}: {texels:?} {by_box:?}");
        for spot in spots {
            let place = drape.place(spot.point.truncate()).expect("ahead of the center");
            assert!(place.min_element() > -1e-9 && place.max_element() < 1.0 + 1e-9);
        }
    }
}

#[test]
fn no_land_no_drape() {
    let mut aside = view(VIEWS[2], 0.0);
    aside.land = aside.land.map(|corner| corner + Vec3::new(0.0, -9000.0, 0.0));
    for method in [Method::Uniform, Method::Thesis, Method::Program, Method::Searched] {
        assert_eq!(Drape::new(method, &aside), None);
    }
}
