//! Outlines that cross themselves: drawn even-odd and counted, even where their parts cancel and no normal is left.

mod support;

use farop::color::{Encoding, Rgb};
use farop::math::Vec3;
use farop::plan::{Choices, Shading};
use farop::raster::{Rasterizer, Watkins, ZBuffer};
use farop::render::render;
use farop::report::Counts;
use farop::scene::Material;
use support::digits;
use support::scenes::{camera, facets, scene, surface, world};

/// Draws outlines, eye space, over 8 x 8 samples of an opening of 90 degrees: digit 1 where any of them is.
fn picture(outlines: &[&[Vec3]], rasterizer: &dyn Rasterizer) -> (String, Counts) {
    let outlines: Vec<Vec<Vec3>> =
        outlines.iter().map(|outline| outline.iter().copied().map(world).collect()).collect();
    let material = Material { color: Rgb::gray(1.0 / 16.0), ambient: Some(1.0), ..Material::default() };
    let mut scene = scene(camera(8, 8), vec![surface(material, facets(&outlines))]);
    scene.lights.clear();
    let choices =
        Choices { encoding: Encoding::Linear, ambient: Some(1.0), shading: Shading::Gouraud, ..Choices::default() };
    let drawn = render(&scene, &choices, Some(rasterizer)).expect("has a view");
    (digits(&drawn.image), drawn.counts)
}

fn across(corners: &[(f64, f64)], w: f64) -> Vec<Vec3> {
    corners.iter().map(|&(x, y)| Vec3::new(x, y, 1.0) * w).collect()
}

const BOW_TIE: [(f64, f64); 4] = [(-1.0, -1.0), (1.0, 1.0), (1.0, -1.0), (-1.0, 1.0)];

#[test]
fn a_bow_tie_without_a_normal_is_drawn_and_counted() {
    // Extreme 53: the two wings have areas of opposite signs.
    let expected = "
        1 . . . . . . 1
        1 1 . . . . 1 1
        1 1 1 . . 1 1 1
        1 1 1 1 1 1 1 1
        1 1 1 1 1 1 1 1
        1 1 1 . . 1 1 1
        1 1 . . . . 1 1
        1 . . . . . . 1";
    let rows = |picture: &str| {
        picture.lines().map(|line| line.trim().to_string()).filter(|line| !line.is_empty()).collect::<Vec<_>>()
    };
    // Scaled so that Newell's sum is exactly 0, or rounding; walked either way and from any corner.
    for w in [2.0, 3.3, 1e20, 1.1e5] {
        for start in 0..4 {
            for turned_round in [false, true] {
                let mut outline = across(&BOW_TIE, w);
                outline.rotate_left(start);
                if turned_round {
                    outline.reverse();
                }
                for rasterizer in [&ZBuffer as &dyn Rasterizer, &Watkins] {
                    let (drawn, counts) = picture(&[&outline], rasterizer);
                    assert_eq!((counts.self_crossing, counts.backfacing, counts.skipped), (1, 0, 0), "{w} {start}");
                    // The samples on the diagonals belong to one wing or to the gap, by the tie rule.
                    let (drawn, expected) = (rows(&drawn), rows(expected));
                    let differing = drawn
                        .iter()
                        .zip(&expected)
                        .flat_map(|(a, b)| a.chars().zip(b.chars()).collect::<Vec<_>>())
                        .filter(|(a, b)| a != b);
                    assert!(differing.count() <= 8, "{}", drawn.join("\n"));
                    assert!(drawn.iter().flat_map(|row| row.chars()).filter(|&c| c == '1').count() >= 28);
                }
            }
        }
    }
}

#[test]
fn crossing_outlines_are_counted_and_others_are_not() {
    let star: Vec<(f64, f64)> = [90.0_f64, 234.0, 18.0, 162.0, 306.0]
        .map(|a| (a.to_radians().cos() * 0.9, a.to_radians().sin() * 0.9))
        .to_vec();
    let star = across(&star, 2.0);
    let square = across(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)], 2.0);
    let notch = across(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 0.0), (-1.0, 1.0)], 2.0);
    let counts = |outline: &[Vec3]| picture(&[outline], &ZBuffer).1;
    assert_eq!([&star, &square, &notch].map(|outline| counts(outline).self_crossing), [1, 0, 0]);
    // The pentagon in the middle is wound twice: even-odd leaves it open.
    let (drawn, _) = picture(&[&star], &ZBuffer);
    assert_eq!(drawn.lines().nth(4).and_then(|row| row.split(' ').nth(4)), Some("."), "{drawn}");
    // A spike has no area either, but covers nothing: culled as ever.
    let spike = across(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 0.0)], 2.0);
    assert_eq!((counts(&spike).backfacing, counts(&spike).self_crossing), (1, 0));
    // A bow-tie whose plane holds the eye is seen edge-on.
    let edge_on: Vec<Vec3> =
        [(-1.0, 1.0), (1.0, 3.0), (1.0, 1.0), (-1.0, 3.0)].map(|(x, w)| Vec3::new(x, 0.0, w)).to_vec();
    assert_eq!(counts(&edge_on).backfacing, 1);
}
