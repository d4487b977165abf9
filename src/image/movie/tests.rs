//! Movies are read again, by readers that share nothing with the writers.

use super::*;
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;
use std::fs;
use std::io::BufReader;

fn frame(width: usize, height: usize, number: usize) -> Picture {
    let level = |value: usize| (value % 256) as u8;
    let colors = (0..width * height).flat_map(|at| [level(at * 3 + number), level(at / 7), level(number * 40)]);
    Picture::from_rgb(width, height, colors.collect()).expect("three bytes a pixel")
}

fn written(path: &Path, frames: &[Picture]) {
    let size = (frames[0].width(), frames[0].height());
    let mut movie = Movie::create(path, size, 25).expect("begun");
    for picture in frames {
        assert!(!path.is_file(), "it has its name before it is whole");
        movie.push(picture).expect("pushed");
    }
    assert_eq!(movie.finish().expect("finished"), frames.len() as u64);
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder").flatten();
    let mut names: Vec<_> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn gif_frames(path: &Path) -> Vec<(Picture, u32)> {
    let decoder = GifDecoder::new(BufReader::new(fs::File::open(path).expect("a file"))).expect("a GIF");
    let frames = decoder.into_frames().collect_frames().expect("frames");
    let of = |frame: image::Frame| {
        let milliseconds = frame.delay().numer_denom_ms();
        let pixels = frame.into_buffer();
        let (width, height) = (pixels.width() as usize, pixels.height() as usize);
        let rgb = pixels.pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        (Picture::from_rgb(width, height, rgb).expect("three bytes a pixel"), milliseconds.0 / milliseconds.1)
    };
    frames.into_iter().map(of).collect()
}

#[test]
fn a_gif_of_few_colors_comes_back_as_it_was() {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("a.gif");
    let frames: Vec<_> = (0..4).map(|number| frame(12, 9, number)).collect();
    written(&path, &frames);
    let read = gif_frames(&path);
    assert_eq!(read.iter().map(|frame| frame.0.clone()).collect::<Vec<_>>(), frames);
    assert!(read.iter().all(|frame| frame.1 == 40), "25 a second");
    assert_eq!(names_in(folder.path()), ["a.gif"]);
}

#[test]
fn a_gif_of_many_colors_is_near_and_the_same_twice() {
    let folder = tempfile::tempdir().expect("temporary folder");
    let paths = ["a.gif", "b.gif"].map(|name| folder.path().join(name));
    let ramp = (0..64 * 64).flat_map(|at| [(at % 64 * 4) as u8, (at / 64 * 4) as u8, 128]).collect();
    let picture = Picture::from_rgb(64, 64, ramp).expect("three bytes a pixel");
    paths.iter().for_each(|path| written(path, std::slice::from_ref(&picture)));
    assert_eq!(fs::read(&paths[0]).expect("a"), fs::read(&paths[1]).expect("b"));
    let read = gif_frames(&paths[0]).remove(0).0;
    // 256 boxes of a square of 256 x 256 levels: 16 x 16 levels each, nothing farther than half of that from its mean, and a step.
    let farthest = read.rgb().iter().zip(picture.rgb()).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(farthest <= Some(12), "{farthest:?}");
    let colors: std::collections::BTreeSet<_> = read.colors().collect();
    assert!(colors.len() > 200 && colors.len() <= palette::MOST, "{}", colors.len());
}

/// The frames of a Y4M file as the recommendation says, in floating point.
fn y4m_frames(bytes: &[u8]) -> Vec<Vec<[f64; 3]>> {
    let end = bytes.iter().position(|&byte| byte == b'\n').expect("a header");
    let header = std::str::from_utf8(&bytes[..end]).expect("text");
    assert!(header.starts_with("YUV4MPEG2 ") && header.contains(" C444 ") && header.contains(" F25:1 "), "{header}");
    let number = |letter: char| {
        let word = header.split(' ').find_map(|word| word.strip_prefix(letter)).expect("a size");
        word.parse::<usize>().expect("a number")
    };
    let count = number('W') * number('H');
    bytes[end + 1..]
        .chunks_exact(6 + 3 * count)
        .map(|frame| {
            let planes = frame.strip_prefix(b"FRAME\n").expect("a frame");
            let at = |plane: usize, pixel: usize| f64::from(planes[plane * count + pixel]);
            (0..count)
                .map(|pixel| {
                    let y = (at(0, pixel) - 16.0) * 255.0 / 219.0;
                    let [b, r] = [1, 2].map(|plane| (at(plane, pixel) - 128.0) * 255.0 / 224.0);
                    [y + 1.402 * r, y - 0.344_136 * b - 0.714_136 * r, y + 1.772 * b]
                })
                .collect()
        })
        .collect()
}

#[test]
fn y4m_comes_back_within_its_own_steps() {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("a.y4m");
    let extremes: Vec<u8> = (0..8).flat_map(|bits: u8| [0, 1, 2].map(|bit| 255 * (bits >> bit & 1))).collect();
    let frames = [Picture::from_rgb(4, 2, extremes).expect("eight pixels"), frame(4, 2, 3)];
    written(&path, &frames);
    let bytes = fs::read(&path).expect("a file");
    let header = 1 + bytes.iter().position(|&byte| byte == b'\n').expect("a header");
    assert_eq!(bytes.len(), header + 2 * (6 + 24), "nothing but header and frames");
    for (read, written) in y4m_frames(&bytes).iter().zip(&frames) {
        for (color, expected) in read.iter().zip(written.colors()) {
            let worst = color.iter().zip(expected).map(|(a, b)| (a - f64::from(b)).abs()).fold(0.0, f64::max);
            // Half a step of brightness and one of a difference, times its weight.
            assert!(worst <= 0.6 + 0.6 * 1.8, "{color:?} {expected:?}");
        }
    }
    let (black, white) = (bytes[header + 6], bytes[header + 6 + 7]);
    assert_eq!((black, white), (16, 235), "studio range");
}

#[test]
fn numbered_frames_come_back_and_mix_with_no_others() {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("walk");
    let frames: Vec<_> = (0..3).map(|number| frame(5, 4, number)).collect();
    fs::create_dir(&path).expect("an empty folder is no obstacle");
    written(&path, &frames);
    assert_eq!(names_in(&path), ["frame-00000.png", "frame-00001.png", "frame-00002.png"]);
    for (number, picture) in frames.iter().enumerate() {
        let read = crate::image::read(&path.join(format!("frame-{number:05}.png"))).expect("a picture");
        assert_eq!(read, *picture);
    }
    assert!(matches!(Movie::create(&path, (5, 4), 25), Err(MovieError::FolderInUse { .. })));
    assert_eq!(names_in(folder.path()), ["walk"]);
}

#[test]
fn what_is_not_finished_leaves_nothing() {
    let folder = tempfile::tempdir().expect("temporary folder");
    for name in ["a.gif", "a.y4m", "a"] {
        let path = folder.path().join(name);
        let mut movie = Movie::create(&path, (5, 4), 25).expect(name);
        movie.push(&frame(5, 4, 0)).expect(name);
        let changed = movie.push(&frame(4, 5, 0)).expect_err("another size").to_string();
        assert!(changed.contains("frame 1 is 4 x 5"), "{changed}");
        drop(movie);
        assert!(matches!(Movie::create(&path, (5, 4), 25).expect(name).finish(), Err(MovieError::Empty)));
        assert_eq!(names_in(folder.path()), [""; 0], "{name}");
    }
    assert!(Movie::create(Path::new("a.mp4"), (5, 4), 25).expect_err("mp4").to_string().contains(".y4m"));
    assert!(matches!(Movie::create(&folder.path().join("a.gif"), (0, 4), 25), Err(MovieError::Size { .. })));
    assert!(Movie::create(&folder.path().join("no/a.gif"), (5, 4), 25).is_err());
}
