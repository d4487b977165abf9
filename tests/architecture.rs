//! The house rules, checked on the sources: data goes one way, every file says what it is, rooms stay readable.

use std::fs;
use std::path::{Path, PathBuf};

/// The rooms from left to right: a file may use only what stands to the left of its own room.
const ORDER: &[&str] = &[
    "math",
    "color",
    "image",
    "diagnostic",
    "report",
    "scene",
    "model",
    "spd",
    "forest",
    "parse",
    "write",
    "plan",
    "screen",
    "geometry",
    "raster",
    "oracle",
    "render",
    "lab",
    "grade",
    "view",
    "cli",
];

fn sources() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut folders, mut files) = (vec![root], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the source folder can be read").flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    files
}

/// The room a source file stands in: the first part of its path below `src`, without the ending.
fn room(path: &Path) -> String {
    let below = path.strip_prefix(Path::new(env!("CARGO_MANIFEST_DIR")).join("src")).expect("below src");
    let first = below.components().next().expect("a file name").as_os_str().to_string_lossy().into_owned();
    first.trim_end_matches(".rs").to_string()
}

/// The part of a file that is not tests, without comments.
fn code(text: &str) -> String {
    let before_tests = text.split("#[cfg(test)]\nmod tests").next().unwrap_or(text);
    before_tests.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The rooms that `code` names after `crate::`, `crate::{a, b}` included.
fn used_rooms(code: &str) -> Vec<String> {
    let mut rooms = Vec::new();
    for (start, _) in code.match_indices("crate::") {
        let rest = &code[start + "crate::".len()..];
        if rest.starts_with('{') {
            let group = &rest[1..rest.find("};").unwrap_or(rest.len())];
            rooms.extend(group.split(',').map(|name| name.trim().split("::").next().unwrap_or("").to_string()));
        } else {
            rooms.push(rest.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect());
        }
    }
    rooms.retain(|room| ORDER.contains(&room.as_str()));
    rooms
}

#[test]
fn data_goes_one_way() {
    let position = |room: &str| ORDER.iter().position(|&name| name == room);
    let mut wrong = Vec::new();
    for path in sources() {
        let own = room(&path);
        if matches!(own.as_str(), "lib" | "main") {
            continue;
        }
        let own_position = position(&own).unwrap_or_else(|| panic!("{} is in no room of the house", path.display()));
        let text = fs::read_to_string(&path).expect("a source can be read");
        for used in used_rooms(&code(&text)) {
            if position(&used) > Some(own_position) {
                wrong.push(format!("{} uses crate::{used}, which stands to its right", path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_wrong_direction_would_be_seen() {
    let planted = "use crate::{color, cli::main};\nfn f() { crate::raster::g() }\n// crate::view\n#[cfg(test)]\nmod tests { use crate::lab; }";
    assert_eq!(used_rooms(&code(planted)), ["color", "cli", "raster"]);
}

#[test]
fn every_file_says_what_it_is() {
    for path in sources() {
        let text = fs::read_to_string(&path).expect("a source can be read");
        assert!(text.starts_with("//!"), "{} does not open with a //! line", path.display());
    }
}

#[test]
fn rooms_stay_readable() {
    // About 250 lines of code are the budget; this is where "about" ends.
    let too_long: Vec<_> = sources()
        .into_iter()
        .filter_map(|path| {
            let text = fs::read_to_string(&path).expect("a source can be read");
            let lines = code(&text).lines().filter(|line| !line.trim().is_empty()).count();
            (lines > 320).then(|| format!("{}: {lines} lines of code", path.display()))
        })
        .collect();
    assert!(too_long.is_empty(), "{}", too_long.join("\n"));
}

#[test]
fn unsafe_code_stays_where_it_is_allowed() {
    for path in sources() {
        let text = code(&fs::read_to_string(&path).expect("a source can be read"));
        let allowed =
            path.to_string_lossy().contains("raster/fast") || path.to_string_lossy().contains("external/library");
        assert!(allowed || !text.contains("unsafe "), "{} has unsafe code", path.display());
    }
}
