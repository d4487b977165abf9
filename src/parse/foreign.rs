//! Words that look like NFF and are not: other formats with the same look, and what beginners write.
//!
//! Why by name: "unknown keyword `fm`" sends somebody looking for a typing mistake; "belongs to AFF" does not.
//! Sources: the AFF page of the BART benchmark (Lext, Assarsson, Möller); what other readers of NFF accept on top.

use crate::diagnostic::suggest;

/// Where a keyword comes from and what to do about it; `None` for words that no known dialect has.
#[must_use]
pub fn keyword(word: &[u8]) -> Option<(&'static str, &'static str)> {
    let aff = "AFF, the animated format of the BART scenes";
    let extended = "a dialect of NFF that some model viewers read";
    Some(match word {
        [b'%', ..] => (aff, "comments start with `#`"),
        b"fm" => (aff, "write the surface as `f red green blue Kd Ks shine T index-of-refraction`"),
        b"am" => (aff, "NFF has no ambient light: remove it, and give it on the command line with `--ambient`"),
        b"la" => (aff, "write the light as `l x y z red green blue`"),
        b"t" | b"tt" | b"ta" => (aff, "write the triangle as `p 3` or `pp 3`, without texture and motion"),
        b"m" => (aff, "write the triangles of the mesh one by one as `pp 3`"),
        b"x" | b"xs" => (aff, "NFF has no transforms: write the vertices where they end up"),
        b"k" | b"a" => (aff, "NFF has no motion: remove it"),
        b"i" => (aff, "NFF has no includes: give farop several files, they merge"),
        b"d" => (aff, "NFF has no levels of detail: keep the finest"),
        b"{" | b"}" => (aff, "NFF has no groups: remove the braces"),
        b"tpp" => (extended, "write it as `pp` and leave out the two texture coordinates of each vertex"),
        b"tess" | b"shader" => (extended, "remove it"),
        b"dod" | b"oct" | b"tet" | b"hex" => (extended, "write the faces of the solid as polygons: `p n`"),
        b"pb" | b"pn" | b"pnn" => (extended, "write it as `p n` or `pp n`"),
        _ => return None,
    })
}

/// The keyword that a misspelled or spelled-out one was meant to be.
#[must_use]
pub fn meant(word: &[u8]) -> Option<&'static str> {
    let text = str::from_utf8(word).ok()?.to_ascii_lowercase();
    let long_forms: [(&str, &str); 20] = [
        ("view", "v"),
        ("viewpoint", "v"),
        ("camera", "v"),
        ("background", "b"),
        ("light", "l"),
        ("fill", "f"),
        ("color", "f"),
        ("colour", "f"),
        ("surface", "f"),
        ("material", "f"),
        ("cone", "c"),
        ("cylinder", "c"),
        ("sphere", "s"),
        ("ball", "s"),
        ("polygon", "p"),
        ("poly", "p"),
        ("triangle", "p 3"),
        ("patch", "pp"),
        ("polypatch", "pp"),
        ("ppp", "pp"),
    ];
    let in_capitals = super::nff::KEYWORDS.into_iter().find(|keyword| *keyword == text);
    let exact = || long_forms.iter().find(|(long, _)| *long == text).map(|&(_, keyword)| keyword);
    let similar = || {
        let names: Vec<&str> = long_forms.iter().map(|&(long, _)| long).filter(|long| long.len() > 3).collect();
        let name = suggest(&text, &names).filter(|_| text.len() > 3)?;
        long_forms.iter().find(|(long, _)| *long == name).map(|&(_, keyword)| keyword)
    };
    // `p3`, `s0`: the space after the keyword is missing.
    let glued = || {
        let letters = text.trim_end_matches(|character: char| character.is_ascii_digit() || character == '.');
        super::nff::KEYWORDS.into_iter().find(|keyword| *keyword == letters)
    };
    in_capitals.or_else(exact).or_else(similar).or_else(glued)
}

/// The numbers of a common X11 color name.
#[must_use]
pub fn color(name: &[u8]) -> Option<[f64; 3]> {
    Some(match name.to_ascii_lowercase().as_slice() {
        b"black" => [0.0, 0.0, 0.0],
        b"white" => [1.0, 1.0, 1.0],
        b"red" => [1.0, 0.0, 0.0],
        b"green" => [0.0, 1.0, 0.0],
        b"blue" => [0.0, 0.0, 1.0],
        b"yellow" => [1.0, 1.0, 0.0],
        b"cyan" => [0.0, 1.0, 1.0],
        b"magenta" => [1.0, 0.0, 1.0],
        b"gray" | b"grey" => [0.745, 0.745, 0.745],
        b"orange" => [1.0, 0.647, 0.0],
        b"brown" => [0.647, 0.165, 0.165],
        b"pink" => [1.0, 0.753, 0.796],
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_meant() {
        for (word, keyword) in [
            ("P", "p"),
            ("PP", "pp"),
            ("sphere", "s"),
            ("shpere", "s"),
            ("Light", "l"),
            ("p3", "p"),
            ("triangle", "p 3"),
        ] {
            assert_eq!(meant(word.as_bytes()), Some(keyword), "{word}");
        }
        for word in ["zzz", "q", "3", "\u{e9}"] {
            assert_eq!(meant(word.as_bytes()), None, "{word}");
        }
    }
}
