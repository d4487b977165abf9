//! What farop says about bad Bezier files: every message is a snapshot, next to the text that provokes it.
//!
//! Read the snapshots as a user would: is the place right, does the last line say what to do?

use farop::parse::read_bezier;
use proptest::prelude::*;

const CURVES: &str = "bezier_curves:\nvertices: 2\nvertex_list:\n1 0 0\n1 0 2\ncurves: 1\ncurve_list:\n2 2 1 1\n";

fn message(text: &[u8]) -> String {
    match read_bezier("vase.bez", text) {
        Ok(net) => format!("(read) {net:?}\n"),
        Err(errors) => errors.to_string(),
    }
}

#[test]
fn every_mistake_is_told_with_its_place() {
    let changed = |from: &str, to: &str| {
        assert!(CURVES.contains(from), "{from}");
        CURVES.replacen(from, to, 1)
    };
    let cases = [
        String::new(),
        "# nothing but a comment\n".to_string(),
        "v\nfrom 0 0 5\n".to_string(),
        changed("bezier_curves:", "bezier_curve:"),
        changed("bezier_curves:", "bezier_patch:"),
        changed("vertices:", "vertices :"),
        changed("vertices: 2", "vertices: two"),
        changed("vertices: 2", "vertices: 0"),
        changed("vertices: 2", "vertices: -2"),
        changed("vertices: 2", "vertices: 2.0"),
        changed("vertices: 2", "vertices: 99999999999"),
        changed("vertices: 2", "vertices: 99999999999999999999999"),
        changed("vertices: 2", "vertices: 1"),
        changed("vertices: 2", "vertices: 3"),
        changed("1 0 2", "1 0"),
        changed("1 0 2", "1 nan 2"),
        changed("1 0 2", "1 1e999 2"),
        changed("1 0 2", "1 0,5 2"),
        changed("vertex_list:", "vertexlist:"),
        changed("curves: 1\ncurve_list:", "patches: 1\npatch_list:"),
        changed("curves: 1", "curves: 2"),
        changed("2 2 1 1", "2 2 0 3"),
        changed("2 2 1 1", "2 2 1 1.5"),
        changed("2 2 1 1", "2 2 1 -1"),
        changed("2 2 1 1", "2 2 1 1 1"),
        changed("2 2 1 1", "2 2 1 1\nsphere { radius 1 }"),
        changed("2 2 1 1", "2 2 1"),
        "bezier_patches:\nvertices: 1 vertex_list: 0 0 0\npatches: 1 patch_list: 1 1 1 1\n".to_string(),
        format!("{}{}", changed("1\ncurve_list:\n2 2 1 1\n", "20 curve_list:\n"), "9\n".repeat(80)),
        changed("1 0 2", "1 0 \x1b[31m\0"),
    ];
    let mut transcript = String::new();
    for text in &cases {
        let shown = text.escape_debug().to_string().replace("\\n", "\n");
        transcript += &format!("======== text\n{}\n-------- says\n{}\n", shown.trim_end(), message(text.as_bytes()));
    }
    insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!("bezier_files", transcript);
    });
}

#[test]
fn announcing_much_costs_nothing() {
    for count in ["4000000000", "18446744073709551615", "9223372036854775807"] {
        assert!(read_bezier("", format!("bezier_patches: vertices: {count} vertex_list: 1 2 3").as_bytes()).is_err());
        let text = format!("bezier_curves: vertices: 1 vertex_list: 1 2 3 curves: {count} curve_list: 1 1 1 1");
        assert!(read_bezier("", text.as_bytes()).is_err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bytes_never_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        message(&bytes);
    }

    /// A legal text with a few bytes changed gets deeper into the reader than noise does.
    #[test]
    fn mangled_text_never_panics(changes in proptest::collection::vec((0usize..200, any::<u8>()), 1..6)) {
        let mut bytes = CURVES.as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at % bytes.len();
            if byte < 128 { bytes[at] = byte } else { bytes.truncate(at.max(1)) }
        }
        message(&bytes);
    }

    #[test]
    fn shuffled_words_never_panic(words in proptest::collection::vec(0usize..12, 0..40)) {
        let known = ["bezier_curves:", "bezier_patches:", "vertices:", "vertex_list:", "curves:", "curve_list:",
            "patches:", "patch_list:", "1", "2", "-1", "0.5"];
        let text: Vec<&str> = words.into_iter().map(|word| known[word]).collect();
        message(text.join(" ").as_bytes());
    }
}
