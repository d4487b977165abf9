//! Labels: compass and named places over a picture, two pictures side by side.

use super::observer::Observer;
use crate::cli::error::CliError;
use crate::forest::cells::Cells;
use crate::image::Picture;
use crate::math::Vec3;
use crate::plan::{Choices, View};
use crate::scene::Camera;
use crate::view::Board;
use crate::view::board::ink;
use crate::view::guide::{self, Landmark};

/// The named places of an area, on its ground.
pub(super) fn landmarks(cells: &Cells, observer: &mut Observer) -> Result<Vec<Landmark>, CliError> {
    let place = |mark: &crate::forest::area::Mark| {
        let ground = observer.ground(cells, mark.at)?;
        Ok(Landmark { name: mark.name.chars().map(plain).collect(), place: Vec3::new(mark.at[0], mark.at[1], ground) })
    };
    cells.head().marks.iter().map(place).collect()
}

/// A letter that the small font has: accents are left out, as on old maps.
fn plain(letter: char) -> char {
    const FAMILIES: [(&str, char); 16] = [
        ("àáâãäå", 'a'),
        ("ÀÁÂÃÄÅ", 'A'),
        ("èéêë", 'e'),
        ("ÈÉÊË", 'E'),
        ("ìíîï", 'i'),
        ("ÌÍÎÏ", 'I'),
        ("òóôõöø", 'o'),
        ("ÒÓÔÕÖØ", 'O'),
        ("ùúûü", 'u'),
        ("ÙÚÛÜ", 'U'),
        ("ç", 'c'),
        ("Ç", 'C'),
        ("ñ", 'n'),
        ("Ñ", 'N'),
        ("ýÿ", 'y'),
        ("Ý", 'Y'),
    ];
    FAMILIES.iter().find(|(letters, _)| letters.contains(letter)).map_or(letter, |family| family.1)
}

/// The picture with a compass and the places that lie in it.
pub(super) fn over(
    picture: &Picture,
    camera: &Camera,
    choices: &Choices,
    landmarks: &[Landmark],
) -> Result<Picture, CliError> {
    let view = View::new(camera, choices)?;
    let mut board = Board::of_picture(picture);
    guide::over(&mut board, camera, &view, landmarks);
    Ok(board.picture())
}

/// Two pictures of one size side by side, a line between them, a name in each.
pub(super) fn side_by_side(pictures: [Picture; 2], names: [&str; 2]) -> Picture {
    let [left, right] = pictures;
    let (width, height) = (left.width(), left.height());
    let mut board = Board::new(2 * width + LINE, height, ink::WHITE);
    for (picture, start) in [(&left, 0), (&right, width + LINE)] {
        for (at, color) in picture.colors().enumerate() {
            let (x, y) = (start + at % width, at / width);
            board.put(x as i64, y as i64, crate::view::board::packed(color));
        }
    }
    for (name, start) in names.into_iter().zip([0, width + LINE]) {
        let end = start as i64 + 6 + 6 * name.chars().count() as i64;
        board.tint((start as i64 + 3, 3), (end + 1, 15), ink::BLACK, 150);
        board.text((start as i64 + 6, 6), name, 1, ink::WHITE);
    }
    board.picture()
}

/// Pixels between two pictures.
pub(super) const LINE: usize = 2;
