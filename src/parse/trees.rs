//! Trees: lists of single trees, as growth models of the USDA Forest Service write them.
//!
//! `.svs` (Stand Visualization System), `.tre` (Forest Vegetation Simulator) -TREES-> TreeList -> measured trees of an area
//!
//! `.svs` has a line of blanks and numbers for every tree: species, number, class, crown class, status, diameter, height, lean, fall, base, four radii of the crown with
//! their shares, expansion, mark, x, y, z. English units, feet and inches, unless `#UNITS` says METRIC. `.tre` has fixed columns and no places: count 31-32,
//! history 33, species 34-36, diameter 37-39 in tenths of an inch, height 45-47 in feet.
//!
//! What does not stand alive is left out and counted: logs (class 90 and above), cut and fallen trees (status other than 1), dead ones (history 6 and above).
//!
//! Space: metres. Source: R. McGaughey, "Stand Visualization System" documentation, FORMAT 2; USDA, "Essential FVS".

use super::load::whole_source;
use crate::diagnostic::{Diagnostic, Diagnostics, Span};
use std::path::Path;

/// Metres of a foot, and of an inch.
const FOOT: f64 = 0.3048;
const INCH: f64 = FOOT / 12.0;
/// How many errors of one file are told.
const MOST_ERRORS: usize = 20;

/// Trees of one file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TreeList {
    /// What the file calls the stand, if it does.
    pub title: Option<String>,
    /// The side of its square plot in metres, if it says one.
    pub plot: Option<f64>,
    /// Living trees.
    pub trees: Vec<ListedTree>,
    /// Lines of trees that do not stand or do not live.
    pub left_out: usize,
}

/// A tree of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct ListedTree {
    /// Species, as the list has it.
    pub code: String,
    /// East and north of the plot's corner; `None`: the list has no places.
    pub at: Option<[f64; 2]>,
    /// Height; `None`: not measured.
    pub height: Option<f64>,
    /// Diameter of the crown; `None`: not known.
    pub crown: Option<f64>,
    /// Diameter at breast height.
    pub dbh: f64,
    /// How many trees this line stands for.
    pub count: f64,
    /// Line of the file.
    pub line: u32,
}

/// Reads a list of trees: `.svs` or `.tre`, plain or with `.gz` behind.
///
/// # Errors
/// The file cannot be read, its ending is not known, or a line is no tree: with line and column.
pub fn load_trees(path: &Path) -> Result<TreeList, Diagnostics> {
    let name = path.to_string_lossy().to_lowercase();
    let plain = name.strip_suffix(".gz").unwrap_or(&name);
    let source = whole_source(path)?;
    let (mut list, mut errors) = (TreeList::default(), Vec::new());
    let is_svs = plain.ends_with(".svs");
    if !is_svs && !plain.ends_with(".tre") {
        let error = Diagnostic::error(format!("`{}` is no list of trees that is known", path.display()));
        return Err(Diagnostics::without_source(error.help("known are `.svs` and `.tre`")));
    }
    let (mut length, mut start) = (FOOT, 0);
    for (number, line) in source.text.split_inclusive(|&byte| byte == b'\n').enumerate() {
        let text = String::from_utf8_lossy(line);
        let place = Line { text: text.trim_end(), start, number: number as u32 + 1 };
        let read = if is_svs { svs(&place, &mut length, &mut list) } else { tre(&place, &mut list) };
        errors.extend(read.err().filter(|_| errors.len() < MOST_ERRORS));
        start += line.len();
    }
    if errors.is_empty() { Ok(list) } else { Err(Diagnostics::new(&source, errors)) }
}

struct Line<'a> {
    text: &'a str,
    /// Where it begins in the file.
    start: usize,
    number: u32,
}

impl Line<'_> {
    fn wrong(&self, at: usize, length: usize, what: String, expected: &str) -> Diagnostic {
        let from = (self.start + at).min(self.start + self.text.len().saturating_sub(1));
        Diagnostic::error(what).at(Span::new(from, from + length.max(1)), format!("expected {expected}"))
    }
}

/// One line of an `.svs`.
fn svs(line: &Line<'_>, length: &mut f64, list: &mut TreeList) -> Result<(), Diagnostic> {
    if let Some(said) = line.text.strip_prefix('#') {
        return directive(line, said, length, list);
    }
    let words: Vec<&str> = line.text.split_whitespace().collect();
    if words.is_empty() || line.text.starts_with(';') {
        return Ok(());
    }
    let column = |word: &str| word.as_ptr() as usize - line.text.as_ptr() as usize;
    if words.len() < 22 {
        let what = format!("a tree of {} numbers and words", words.len());
        return Err(line.wrong(0, 1, what, "at least 22: species, number, ..., x, y and z (FORMAT 2)"));
    }
    let number = |index: usize, what: &str| match words[index].parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(line.wrong(
            column(words[index]),
            words[index].len(),
            format!("`{}` is not a number", words[index].escape_debug()),
            what,
        )),
    };
    let (class, status) = (number(2, "the class of the tree")?, number(4, "the status of the tree")?);
    let (dbh, height) = (number(5, "a diameter")?, number(6, "a height")?);
    let radii = [10, 12, 14, 16].map(|index| number(index, "a radius of the crown"));
    let mut radius = 0.0;
    for found in radii {
        radius += found? / 4.0;
    }
    let at = [number(20, "x of the place")?, number(21, "y of the place")?];
    if class >= 90.0 || status != 1.0 || height <= 0.0 {
        list.left_out += 1;
        return Ok(());
    }
    list.trees.push(ListedTree {
        code: words[0].to_string(),
        at: Some(at.map(|along| along * *length)),
        height: Some(height * *length),
        crown: Some(2.0 * radius * *length).filter(|crown| *crown > 0.0),
        dbh: dbh * if *length == FOOT { INCH } else { 0.01 },
        count: number(18, "how many trees it stands for")?,
        line: line.number,
    });
    Ok(())
}

fn directive(line: &Line<'_>, said: &str, length: &mut f64, list: &mut TreeList) -> Result<(), Diagnostic> {
    let (keyword, rest) = said.split_once(char::is_whitespace).unwrap_or((said, ""));
    match keyword.to_ascii_uppercase().as_str() {
        "TITLE" => list.title = Some(rest.trim().to_string()),
        "FORMAT" if rest.trim() != "2" => {
            let what = format!("tree lists of FORMAT {} are not known", rest.trim());
            return Err(line.wrong(0, line.text.len(), what, "#FORMAT 2"));
        }
        "UNITS" => match rest.trim().to_ascii_uppercase().as_str() {
            "ENGLISH" => *length = FOOT,
            "METRIC" => *length = 1.0,
            other => {
                return Err(line.wrong(
                    0,
                    line.text.len(),
                    format!("units `{other}` are not known"),
                    "ENGLISH or METRIC",
                ));
            }
        },
        "PLOTSIZE" => {
            list.plot =
                rest.split_whitespace().next().and_then(|side| side.parse().ok()).map(|side: f64| side * *length)
        }
        _ => {}
    }
    Ok(())
}

/// One line of a `.tre`.
fn tre(line: &Line<'_>, list: &mut TreeList) -> Result<(), Diagnostic> {
    let field = |from: usize, to: usize| line.text.get(from - 1..to.min(line.text.len())).unwrap_or_default().trim();
    let code = field(34, 36);
    if code.is_empty() {
        // A plot without trees.
        list.left_out += usize::from(!line.text.trim().is_empty());
        return Ok(());
    }
    let number = |from: usize, to: usize, what: &str| match field(from, to) {
        "" => Ok(None),
        text => text.parse::<f64>().map(Some).map_err(|_| {
            line.wrong(from - 1, to + 1 - from, format!("`{}` is not a number", text.escape_debug()), what)
        }),
    };
    let count = number(31, 32, "how many trees, in columns 31 and 32")?.unwrap_or(1.0);
    let history = number(33, 33, "the history of the tree, in column 33")?.unwrap_or(1.0);
    let dbh = number(37, 39, "a diameter in tenths of an inch, in columns 37 to 39")?;
    let height = number(45, 47, "a height in feet, in columns 45 to 47")?.filter(|height| *height > 0.0);
    if history >= 6.0 {
        list.left_out += 1;
        return Ok(());
    }
    let height = height.map(|feet| feet * FOOT);
    let dbh = dbh.unwrap_or_default() * 0.1 * INCH;
    list.trees.push(ListedTree {
        code: code.to_string(),
        at: None,
        height,
        crown: None,
        dbh,
        count,
        line: line.number,
    });
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, text: &str) -> Result<TreeList, String> {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("written");
        load_trees(&path).map_err(|errors| errors.render(false))
    }

    const SVS: &str = "#TITLE A stand\n#FORMAT 2\n#PLOTSIZE 208.71 208.71\n#UNITS ENGLISH\n;species\n\
        DF  1  0 0 1  10.0  100. 0  0 0  8.0 0.5 10.0 0.5  8.0 0.5 10.0 0.5 1 0  20.0  30.0 0\n\
        DF  2 94 0 0  10.0  100. 0  0 0  8.0 0.5 10.0 0.5  8.0 0.5 10.0 0.5 1 0  20.0  30.0 0\n\
        DF  3  0 0 2  10.0  100. 0  0 0  8.0 0.5 10.0 0.5  8.0 0.5 10.0 0.5 1 0  20.0  30.0 0\n";

    #[test]
    fn feet_and_inches_become_metres_and_what_lies_is_left_out() {
        let list = read("a.svs", SVS).expect("a list");
        assert_eq!((list.trees.len(), list.left_out, list.title.as_deref()), (1, 2, Some("A stand")));
        let tree = &list.trees[0];
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-9;
        assert!(near(tree.height.expect("known"), 30.48) && near(tree.crown.expect("known"), 18.0 * 0.3048));
        assert!(near(tree.dbh, 0.254) && near(list.plot.expect("said"), 208.71 * 0.3048));
        assert_eq!((tree.at, tree.line, tree.code.as_str()), (Some([20.0 * FOOT, 30.0 * FOOT]), 6, "DF"));
        let metric = read("a.svs", &SVS.replace("ENGLISH", "METRIC")).expect("a list");
        assert_eq!((metric.trees[0].height, metric.trees[0].at), (Some(100.0), Some([20.0, 30.0])));
    }

    #[test]
    fn columns_of_a_tre_are_fixed() {
        let text = "   1      248112       0101   011LP 11510   0734   00111     0  0\n   \
            5      248112       0102   018SP 346            10322     0  0\n   6\n";
        let list = read("a.tre", text).expect("a list");
        assert_eq!((list.trees.len(), list.left_out), (1, 2));
        let tree = &list.trees[0];
        assert!((tree.height.expect("known") - 73.0 * FOOT).abs() < 1e-9 && (tree.dbh - 11.5 * INCH).abs() < 1e-9);
    }

    #[test]
    fn wrong_lines_have_their_places() {
        for (text, part) in [
            (SVS.replace("DF  1  0 0 1  10.0", "DF  1  0 0 1  ten"), "a.svs:6:15"),
            (SVS.replace("#FORMAT 2", "#FORMAT 5"), "a.svs:2:1"),
            (SVS.replace("ENGLISH", "FURLONGS"), "a.svs:4:1"),
            (SVS.replace(" 20.0  30.0 0\n", "\n"), "a.svs:6:1"),
        ] {
            let told = read("a.svs", &text).expect_err(part);
            assert!(told.contains(part), "no {part} in\n{told}");
        }
        let told = read("a.tre", "   1      248112       0101   011LP 1x510   0734").expect_err("no number");
        assert!(told.contains("a.tre:1:37"), "{told}");
        assert!(read("a.csv", "").is_err());
    }
}
