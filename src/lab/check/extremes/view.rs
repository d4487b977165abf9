//! Items 19 to 38: views and sizes.

use super::super::random_scenes::camera;
use super::tools::{
    SIDE, TRIANGLE, VIEW, both_sides, covered, draw, ensure, exactly, made, mask, noticed, on_screen, picture, refused,
};
use super::{Effort, Item, Outcome, Trial::Run};
use crate::math::Vec3;
use crate::plan::{AngleSpan, Choices, Plan, PlanError};
use crate::render::list;
use crate::scene::Camera;
use crate::screen::file::{ClassicOptions, ReadOptions, read, write_classic};

pub(super) const ITEMS: &[Item] = &[
    (19, "from and at the same: refused", Run(|_| refused(VIEW.replace("at 0 0 0", "at 0 0 5"), &["x.nff:"]))),
    (20, "up along the view: another axis, with a warning", Run(up_along_view)),
    (21, "up 0: refused", Run(|_| refused(VIEW.replace("up 0 1 0", "up 0 0 0"), &["x.nff:4:"]))),
    (22, "angle 1e-6: drawn", Run(|_| angle("1e-6"))),
    (23, "angle 0: refused", Run(|_| refused(VIEW.replace("angle 45", "angle 0"), &["x.nff:5:"]))),
    (24, "angle 179.999: drawn", Run(|_| angle("179.999"))),
    (25, "angle 180 or below 0: refused", Run(no_angle)),
    (26, "hither 0 or below: one is chosen, with a warning", Run(hither)),
    (27, "yon not behind hither: refused", Run(yon)),
    (28, "hither 1e-30, yon 1e30: order exact", Run(wide_range)),
    (29, "the eye in a polygon's plane: 0 pixels", Run(edge_on)),
    (30, "a polygon that passes the eye: clipped", Run(around_the_eye)),
    (31, "the eye at a corner: drawn", Run(eye_at_corner)),
    (32, "all behind: the background", Run(all_behind)),
    (33, "1 x 1 pixel: drawn", Run(one_pixel)),
    (34, "no pixels, or less: refused", Run(no_pixels)),
    (35, "65535 x 1 and 1 x 65535: drawn", Run(long_pictures)),
    (36, "65536 x 65536: refused unless --max-pixels says so", Run(large_picture)),
    (37, "A = 0: refused; A = 64: drawn", Run(samples)),
    (38, "depth or color resolution 1 or 2^31 in a screen file", Run(resolutions)),
];

fn scene_text() -> String {
    format!("{VIEW}{TRIANGLE}")
}

fn up_along_view(_: &Effort) -> Outcome {
    let parsed = noticed(scene_text().replace("up 0 1 0", "up 0 0 5"), "up")?;
    ensure(covered(&draw(&parsed.scene, &Choices::default())?.list) > 100, "nothing to see")
}

fn angle(degrees: &str) -> Outcome {
    let drawn = picture(scene_text().replace("angle 45", &format!("angle {degrees}")))?;
    // Through a keyhole the triangle is all there is; from the widest angle it is less than a pixel.
    ensure(covered(&drawn.list) == if degrees == "1e-6" { 1024 } else { 0 }, format!("{}", covered(&drawn.list)))
}

fn no_angle(_: &Effort) -> Outcome {
    refused(VIEW.replace("angle 45", "angle 180"), &["x.nff:5:"])?;
    refused(VIEW.replace("angle 45", "angle -20"), &["x.nff:5:"])
}

fn hither(_: &Effort) -> Outcome {
    let expected = picture(scene_text())?.image;
    for value in ["0", "-1"] {
        let parsed = noticed(scene_text().replace("hither 1", &format!("hither {value}")), "hither")?;
        ensure(draw(&parsed.scene, &Choices::default())?.image == expected, "another picture")?;
    }
    Ok(())
}

fn yon(_: &Effort) -> Outcome {
    for yon in [1.0, 0.5, 0.0, -1.0, f64::NAN] {
        let view = Camera { yon: Some(yon), ..camera(8, 8) };
        let scene = crate::scene::Scene { camera: Some(view), ..made(&[]) };
        let plan = Plan::new(&scene, &Choices::default(), crate::plan::Accepts::AnyPolygon);
        ensure(matches!(plan, Err(PlanError::YonNotBehindHither { .. })), format!("yon {yon} was taken"))?;
    }
    Ok(())
}

fn wide_range(_: &Effort) -> Outcome {
    for w in [1e-29, 1e-15, 1.0, 1e15, 1e29] {
        let places = [(10.0, 10.0), (50.0, 12.0), (30.0, 55.0)];
        let (near, far) = (on_screen(&places, w), on_screen(&places, w * 1.0001));
        for (outlines, front) in [([near.clone(), far.clone()], 0), ([far, near], 1)] {
            let mut scene = made(&outlines);
            scene.camera = Some(Camera { hither: 1e-30, yon: Some(1e30), ..camera(SIDE, SIDE) });
            let list = draw(&scene, &both_sides())?.list;
            let owners = super::super::agree::owners(&list, &crate::raster::ZBuffer);
            let shown = owners.iter().flatten().filter(|&&owner| owner == front).count();
            ensure(shown > 500 && owners.iter().flatten().count() <= shown + 4, format!("wrong order at w = {w}"))?;
        }
    }
    Ok(())
}

fn edge_on(_: &Effort) -> Outcome {
    let plane = vec![Vec3::new(-1.0, -1.0, 2.0), Vec3::new(1.0, 1.0, 2.0), Vec3::new(2.0, 2.0, 8.0)];
    let drawn = draw(&made(&[plane]), &both_sides())?;
    ensure(covered(&drawn.list) == 0 && drawn.counts.skipped == 1, "something covers a sample, or nothing was counted")
}

fn around_the_eye(_: &Effort) -> Outcome {
    // A floor just below the eye, from far behind to far ahead.
    let floor = [(-9.0, -9.0), (9.0, -9.0), (9.0, 90.0), (-9.0, 90.0)].map(|(x, w)| Vec3::new(x, -1e-9, w)).to_vec();
    let (drawn, _) = exactly(&[floor], &both_sides())?;
    ensure(drawn.counts.cut == 1, format!("{} cut", drawn.counts.cut))?;
    let tilted = [(-9.0, -9.0), (9.0, -9.0), (0.0, 90.0)].map(|(x, w)| Vec3::new(x, w / 9.0 - 0.3, w)).to_vec();
    let (drawn, truth) = exactly(&[tilted], &both_sides())?;
    ensure(drawn.counts.cut == 1 && truth.counts.covered > 0, "not cut, or nothing left")
}

fn eye_at_corner(_: &Effort) -> Outcome {
    let outline = vec![Vec3::ZERO, Vec3::new(1.0, 0.5, 4.0), Vec3::new(-1.0, 0.5, 4.0)];
    ensure(covered(&draw(&made(&[outline]), &both_sides())?.list) == 0, "seen edge-on, it covers something")
}

fn all_behind(_: &Effort) -> Outcome {
    let outline = vec![Vec3::new(-1.0, -1.0, -3.0), Vec3::new(1.0, -1.0, -3.0), Vec3::new(0.0, 1.0, -9.0)];
    let drawn = draw(&made(&[outline]), &both_sides())?;
    ensure(drawn.list.is_empty() && drawn.counts.clipped == 1, "not clipped")
}

fn one_pixel(_: &Effort) -> Outcome {
    for angle in [AngleSpan::Edges, AngleSpan::Centers] {
        let scene = super::tools::read(scene_text())?.scene;
        let drawn = draw(&scene, &Choices { size: Some((1, 1)), angle, ..Choices::default() })?;
        ensure(covered(&drawn.list) == 1, "the pixel is empty")?;
    }
    Ok(())
}

fn no_pixels(_: &Effort) -> Outcome {
    refused(VIEW.replace("32 32", "0 64"), &["x.nff:7:"])?;
    refused(VIEW.replace("32 32", "64 -64"), &["x.nff:7:"])?;
    let size = draw(&made(&[]), &Choices { size: Some((0, 5)), ..Choices::default() });
    ensure(size.is_err(), "0 x 5 was drawn")
}

fn long_pictures(_: &Effort) -> Outcome {
    let scene = made(&[on_screen(&[(1.0, 1.0), (63.0, 2.0), (20.0, 63.0)], 2.0)]);
    for size in [(65_535, 1), (1, 65_535)] {
        let list = draw(&scene, &Choices { size: Some(size), ..both_sides() })?.list;
        ensure(covered(&list) > 0, format!("{size:?} is empty"))?;
        super::tools::exact_list(&list)?;
    }
    Ok(())
}

fn large_picture(_: &Effort) -> Outcome {
    let plan = |max_pixels| {
        let choices = Choices { size: Some((65_536, 65_536)), max_pixels, ..Choices::default() };
        Plan::new(&made(&[]), &choices, crate::plan::Accepts::AnyPolygon)
    };
    ensure(matches!(plan(1 << 28), Err(PlanError::PictureTooLarge { .. })), "taken")?;
    plan(1 << 32).map(|_| ()).map_err(|error| error.to_string())
}

fn samples(_: &Effort) -> Outcome {
    let scene = made(&[on_screen(&[(1.0, 1.0), (63.0, 2.0), (20.0, 63.0)], 2.0)]);
    let of = |samples| draw(&scene, &Choices { samples, size: Some((16, 16)), ..both_sides() });
    ensure(of(0).is_err() && of(65).is_err(), "A = 0 or 65 was drawn")?;
    let list = of(64)?.list;
    let inside = mask(&list).iter().filter(|&&covered| covered).count() as f64;
    // 62 x 61 less two corners: the area, in samples of a 64th of a pixel each.
    let area = ((62.0 * 62.0) - (19.0 * 1.0)) / 2.0 * f64::from(list.width * list.height) / f64::from(SIDE * SIDE);
    ensure((inside / area - 1.0).abs() < 1e-3, format!("{inside} samples of {area}"))
}

fn resolutions(_: &Effort) -> Outcome {
    let scene = made(&[on_screen(&[(1.0, 1.0), (63.0, 2.0), (20.0, 63.0)], 2.0)]);
    let list = list(&scene, &both_sides(), None).map_err(|error| error.to_string())?;
    let mut header = String::new();
    for resolution in [1, 1 << 31] {
        let options = ClassicOptions {
            z_resolution: resolution,
            color_resolution: resolution,
            yon: Some(9.0),
            ..ClassicOptions::default()
        };
        let mut text = Vec::new();
        write_classic(&list, &options, &mut text).map_err(|error| error.to_string())?;
        header = String::from_utf8_lossy(&text).into_owned();
        let back = read(&header, &ReadOptions::default()).map_err(|error| error.to_string())?;
        super::tools::exact_list(&back.list)?;
        ensure(covered(&back.list) > 1000, "nothing was read back")?;
    }
    for bad in ["0", "2147483649", "-1"] {
        let text = header.replacen("2147483648", bad, 1);
        ensure(read(&text, &ReadOptions::default()).is_err(), format!("resolution {bad} was read"))?;
    }
    Ok(())
}
