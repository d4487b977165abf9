//! Font: letters of 5 x 7 pixels, drawn by hand for charts and for the window; two more rows hang below the base line.

/// Pixels of a letter across.
pub const WIDTH: usize = 5;
/// From one letter to the next.
pub const ADVANCE: usize = 6;
/// Rows of a letter.
pub const HEIGHT: usize = 9;

/// The rows of a letter from the top, the leftmost pixel in the highest of 5 bits; blank for letters that are not there.
#[must_use]
pub fn rows(letter: char) -> [u8; HEIGHT] {
    let bits = GLYPHS.iter().find(|glyph| glyph.0 == letter).map_or(0, |glyph| glyph.1);
    std::array::from_fn(|row| (bits >> (WIDTH * (HEIGHT - 1 - row)) & 0x1F) as u8)
}

/// All rows of a letter, the top one in the highest bits.
#[rustfmt::skip]
const GLYPHS: &[(char, u64)] = &[
    ('0', 0x0e8c_eb98_b800), ('1', 0x0461_0842_3800), ('2', 0x0e88_4c88_7c00), ('3', 0x0e88_4c18_b800),
    ('4', 0x0232_a5f1_0800), ('5', 0x1f87_8218_b800), ('6', 0x0644_3d18_b800), ('7', 0x1f08_8844_2000),
    ('8', 0x0e8c_5d18_b800), ('9', 0x0e8c_5e11_3000), ('a', 0x0003_82f8_bc00), ('b', 0x1087_a318_f800),
    ('c', 0x0003_a308_b800), ('d', 0x010b_e318_bc00), ('e', 0x0003_a3f8_3800), ('f', 0x064a_3884_2000),
    ('g', 0x0003_e318_bc2e), ('h', 0x1085_b318_c400), ('i', 0x0403_0842_3800), ('j', 0x0201_8421_0a4c),
    ('k', 0x1084_a98a_4800), ('l', 0x0c21_0842_3800), ('m', 0x0006_ab5a_d400), ('n', 0x0005_b318_c400),
    ('o', 0x0003_a318_b800), ('p', 0x0007_a318_fa10), ('q', 0x0003_e318_bc21), ('r', 0x0005_b308_4000),
    ('s', 0x0003_e0e0_f800), ('t', 0x0847_1084_9800), ('u', 0x0004_6319_b400), ('v', 0x0004_6315_1000),
    ('w', 0x0005_6b5a_a800), ('x', 0x0004_5445_4400), ('y', 0x0004_6318_bc2e), ('z', 0x0007_c444_7c00),
    ('A', 0x0e8c_7f18_c400), ('B', 0x1e8c_7d18_f800), ('C', 0x0e8c_2108_b800), ('D', 0x1e8c_6318_f800),
    ('E', 0x1f84_3d08_7c00), ('F', 0x1f84_3d08_4000), ('G', 0x0e8c_2f18_bc00), ('H', 0x118c_7f18_c400),
    ('I', 0x0e21_0842_3800), ('J', 0x0710_8429_3000), ('K', 0x1195_3149_4400), ('L', 0x1084_2108_7c00),
    ('M', 0x11dd_6b18_c400), ('N', 0x11cd_6718_c400), ('O', 0x0e8c_6318_b800), ('P', 0x1e8c_7d08_4000),
    ('Q', 0x0e8c_6359_3400), ('R', 0x1e8c_7d49_4400), ('S', 0x0f84_1c10_f800), ('T', 0x1f21_0842_1000),
    ('U', 0x118c_6318_b800), ('V', 0x118c_6315_1000), ('W', 0x118c_6b5d_c400), ('X', 0x1151_0845_4400),
    ('Y', 0x1151_0842_1000), ('Z', 0x1f08_8888_7c00), ('.', 0x0000_0006_3000), (',', 0x0000_0006_1100),
    (':', 0x0063_00c6_0000), ('/', 0x0108_8888_4000), ('-', 0x0000_3e00_0000), ('+', 0x0021_3e42_0000),
    ('(', 0x0222_1082_0800), (')', 0x0820_8422_2000), ('=', 0x0007_c1f0_0000), ('_', 0x0000_0000_03e0),
    ('%', 0x19d0_8885_cc00),
    ('!', 0x0421_0840_1000), ('"', 0x0a52_8000_0000), ('#', 0x0a57_d5f5_2800), ('$', 0x047d_1c5f_1000),
    ('&', 0x0c95_1159_3400), ('\'', 0x0421_0000_0000), ('*', 0x0025_5d52_0000), (';', 0x0063_00c2_2000),
    ('<', 0x0222_2082_0800), ('>', 0x0820_8222_2000), ('?', 0x0e88_4440_1000), ('@', 0x0e8d_eb68_3800),
    ('[', 0x0e42_1084_3800), ('\\', 0x0082_0820_8000), (']', 0x0e10_8421_3800), ('^', 0x0454_4000_0000),
    ('`', 0x0820_0000_0000), ('{', 0x0321_1042_0c00), ('|', 0x0421_0842_1000), ('}', 0x1821_0442_6000),
    ('~', 0x0002_2a20_0000),
];

#[cfg(test)]
mod tests {
    use super::rows;

    #[test]
    fn every_printable_letter_of_ascii_is_there_and_like_no_other() {
        let mut seen = std::collections::BTreeSet::new();
        for letter in (b'!'..=b'~').map(char::from) {
            assert!(rows(letter) != [0; 9] && seen.insert(rows(letter)), "{letter}");
        }
    }

    #[test]
    fn a_letter_is_what_it_looks_like() {
        let shown: Vec<String> =
            rows('p').iter().map(|row| format!("{row:05b}").replace('0', ".").replace('1', "#")).collect();
        let drawn = [".....", ".....", "####.", "#...#", "#...#", "#...#", "####.", "#....", "#...."];
        assert_eq!(shown, drawn);
        assert_eq!(rows('\u{e9}'), [0; 9]);
    }
}
