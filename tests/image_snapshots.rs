//! The picture assertion as a user's crate sees it: by its public path, with its files in `tests/`.

use farop::color::{Encoding, Rgb};
use farop::image::Image;
use farop::snapshot::{Tolerance, VARIABLE, assert_picture};

/// A disk of many colors: a round edge, smooth shades, something to see in 32 x 16 characters.
fn disk() -> Image {
    let mut image = Image::new(64, 64, Rgb::gray(0.0));
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
        let (dx, dy) = (x as f32 - 31.5, y as f32 - 31.5);
        if dx * dx + dy * dy < 24.0 * 24.0 {
            image.set_pixel(x, y, Rgb::new(x as f32 / 63.0, 0.25, y as f32 / 63.0));
        }
    }
    image
}

/// The disk with one gray pixel in it.
fn disk_with_a_fault() -> Image {
    let mut image = disk();
    image.set_pixel(31, 20, Rgb::gray(0.5));
    image
}

// One test for all, because they share an accepted picture, and tests run at the same time.
#[test]
fn one_picture_in_all_ways() {
    assert_picture!("image_disk", disk());
    assert_picture!(String::from("image_disk"), &disk().encode(Encoding::Srgb));
    assert_picture!("image_disk", &disk_with_a_fault(), tolerance = Tolerance { max_diff: 0, max_pixels: 1 });
    if std::env::var(VARIABLE).is_ok_and(|mode| mode == "accept") {
        println!("notice: pictures are being accepted, so the wrong one is not tried");
        return;
    }
    let failure = std::panic::catch_unwind(|| assert_picture!("image_disk", disk_with_a_fault())).expect_err("fails");
    let message = failure.downcast_ref::<String>().expect("a message");
    assert!(message.contains("1 of 4096 pixels differs"), "{message}");
    assert!(message.contains("x 31, y 20"), "{message}");
    // Passing once more takes away what the failure left in the target folder.
    assert_picture!("image_disk", disk());
}
