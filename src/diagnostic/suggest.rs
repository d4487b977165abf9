//! "Did you mean": the known word that is fewest typing mistakes away.
//!
//! Source: F. Damerau, "A Technique for Computer Detection and Correction of Spelling Errors", CACM 7(3), 1964
//! (a mistake is a wrong, missing, extra, or swapped letter); V. Levenshtein, Soviet Physics Doklady 10(8), 1966.
//! Cost: the product of the lengths of the two words; words over 32 bytes are not compared.

/// The word of `known` that `word` was probably meant to be: at most a third of its letters are wrong, case aside.
///
/// `None` when nothing is that near. Of equally near words the first wins.
///
/// ```
/// use farop::diagnostic::suggest;
/// assert_eq!(suggest("hihter", &["from", "hither", "angle"]), Some("hither"));
/// assert_eq!(suggest("ANGLE", &["from", "hither", "angle"]), Some("angle"));
/// assert_eq!(suggest("teapot", &["from", "hither", "angle"]), None);
/// ```
#[must_use]
pub fn suggest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let word = word.to_lowercase();
    let longest_compared = 32;
    if word.len() > longest_compared {
        return None;
    }
    let distances = known.iter().map(|&candidate| (mistakes(word.as_bytes(), candidate.as_bytes()), candidate));
    let (distance, candidate) = distances.min_by_key(|&(distance, _)| distance)?;
    (distance <= word.len().max(candidate.len()) / 3 || distance == 0).then_some(candidate)
}

/// The number of typing mistakes between two words.
fn mistakes(a: &[u8], b: &[u8]) -> usize {
    // Row i of the table holds the distances from the first i letters of `a` to every beginning of `b`.
    let mut two_above: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let wrong = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let missing_or_extra = above[j].min(row[j - 1]) + 1;
            let swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            let swap = if swapped { two_above[j - 2] + 1 } else { usize::MAX };
            row.push(wrong.min(missing_or_extra).min(swap));
        }
        two_above = std::mem::replace(&mut above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_of_mistake_counts_once() {
        for (a, b, expected) in
            [("from", "from", 0), ("form", "from", 1), ("fom", "from", 1), ("frrom", "from", 1), ("frem", "from", 1)]
        {
            assert_eq!(mistakes(a.as_bytes(), b.as_bytes()), expected, "{a} {b}");
        }
        assert_eq!(mistakes(b"", b"up"), 2);
    }
}
