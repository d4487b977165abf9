//! Roster: which submissions a folder holds, and whose they are, by the names that course platforms give.
//!
//! Gradescope: `submission_123456789/`, with `submission_metadata.yml` beside. Moodle: `First Last_1234567_assignsubmission_file_/`, or
//! `_onlinetext_`. GitHub Classroom: `assignment-username/`, the first words the same for all. Anything else is called as it is called.
//!
//! Why the metadata are read by hand: of YAML's many ways to write a thing the export uses one, and its author is a program. What cannot be
//! read there is left out, and the folder's number stands for the name.

use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// One entry of a class's folder.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Submission {
    /// A name that is safe for a folder: letters, digits, `.`, `_`, `-`.
    pub key: String,
    /// The entry's own name, as text.
    pub source: String,
    /// The student; several with `, ` between.
    pub name: String,
    /// What the platform calls the student.
    pub id: String,
    /// Empty where nobody says.
    pub email: String,
    /// `gradescope`, `moodle`, `classroom` or `folder`.
    pub origin: &'static str,
    /// Where it lies.
    pub path: PathBuf,
}

/// What an export says of a submission's students.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Student {
    name: String,
    id: String,
    email: String,
}

const METADATA: &str = "submission_metadata.yml";

/// The submissions in `folder`, sorted by key. Hidden entries, links and the platform's own files are none.
///
/// # Errors
/// In words, when the folder cannot be read.
pub fn roster(folder: &Path) -> Result<Vec<Submission>, String> {
    let failed = |error| format!("cannot read the folder of submissions {}: {error}", folder.display());
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        let (name, kind) = (entry.file_name().to_string_lossy().into_owned(), entry.file_type().map_err(failed)?);
        if (kind.is_dir() || kind.is_file()) && !name.starts_with('.') && name != METADATA {
            entries.push((name, entry.path()));
        }
    }
    entries.sort();
    let students = metadata(&std::fs::read_to_string(folder.join(METADATA)).unwrap_or_default());
    let names: Vec<&str> = entries.iter().map(|(name, _)| name.as_str()).collect();
    let common = common_words(&names);
    let mut all: Vec<_> = entries.iter().map(|(name, path)| submission((name, path), &students, common)).collect();
    give_keys(&mut all);
    // Moodle makes two folders of a student who sent a file and a text: the file is it.
    let with_file: Vec<_> =
        all.iter().filter(|one| moodle(&one.source).is_some_and(|found| found.2)).cloned().collect();
    let is_second = |one: &Submission| {
        let is_text = moodle(&one.source).is_some_and(|found| !found.2);
        is_text && with_file.iter().any(|file| file.id == one.id)
    };
    all.retain(|one| !is_second(one));
    all.sort_by(|a, b| a.key.cmp(&b.key));
    Ok(all)
}

fn submission((source, path): (&str, &Path), students: &BTreeMap<String, Student>, common: usize) -> Submission {
    let (student, origin) = if let Some(number) = source.strip_prefix("submission_").filter(|rest| is_number(rest)) {
        let unknown = Student { name: source.to_string(), id: number.to_string(), email: String::new() };
        (students.get(source).cloned().unwrap_or(unknown), "gradescope")
    } else if let Some((name, number, _)) = moodle(source) {
        (Student { name: name.to_string(), id: number.to_string(), email: String::new() }, "moodle")
    } else {
        let stem = if path.is_file() { source.rsplit_once('.').map_or(source, |(stem, _)| stem) } else { source };
        let user = stem.get(common..).filter(|rest| !rest.is_empty()).unwrap_or(stem);
        let origin = if common > 0 { "classroom" } else { "folder" };
        (Student { name: user.to_string(), id: user.to_string(), email: String::new() }, origin)
    };
    let Student { name, id, email } = student;
    Submission { key: String::new(), source: source.to_string(), name, id, email, origin, path: path.to_path_buf() }
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// Name, number, and whether it is the folder of files.
fn moodle(source: &str) -> Option<(&str, &str, bool)> {
    let (front, kind) = source.split_once("_assignsubmission_")?;
    let (name, number) = front.rsplit_once('_').filter(|(_, number)| is_number(number))?;
    Some((name, number, kind.trim_end_matches('_') == "file"))
}

/// How many bytes all names begin with that belong to the assignment: whole words, each ended by `-`. Two names are needed to tell.
fn common_words(names: &[&str]) -> usize {
    let is_other = |name: &&str| moodle(name).is_none() && !name.strip_prefix("submission_").is_some_and(is_number);
    let names: Vec<_> = names.iter().filter(|name| is_other(name)).collect();
    let [first, rest @ ..] = &names[..] else { return 0 };
    if rest.is_empty() {
        return 0;
    }
    let ends = first.match_indices('-').map(|(at, _)| at + 1);
    ends.filter(|&end| rest.iter().all(|name| name.len() > end && name.starts_with(&first[..end]))).max().unwrap_or(0)
}

/// Safe names, no two alike.
fn give_keys(all: &mut [Submission]) {
    let is_safe = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '.' | '_' | '-');
    for submission in all {
        let source = &submission.source;
        let short: String = source.chars().take(80).map(|letter| if is_safe(letter) { letter } else { '_' }).collect();
        // What was changed might now be another's name: eight digits of the whole name tell them apart.
        let hash = Sha256::digest(source.as_bytes());
        let mark: String = hash.iter().take(4).map(|byte| format!("{byte:02x}")).collect();
        submission.key = if short == *source { short } else { format!("{short}-{mark}") };
    }
}

/// Students by folder, from Gradescope's metadata.
fn metadata(text: &str) -> BTreeMap<String, Student> {
    let mut all: BTreeMap<String, Student> = BTreeMap::new();
    let mut folder = None;
    for line in text.lines() {
        let field = line.trim().trim_start_matches("- ");
        if let Some(name) = line.strip_suffix(':').filter(|name| name.starts_with("submission_")) {
            folder = Some(name.to_string());
            all.insert(name.to_string(), Student::default());
        }
        let Some(student) = folder.as_ref().and_then(|folder| all.get_mut(folder)) else { continue };
        let fields = [(":name:", &mut student.name), (":sid:", &mut student.id), (":email:", &mut student.email)];
        for (label, kept) in fields {
            let Some(value) = field.strip_prefix(label) else { continue };
            // A group has several of each.
            let gap = if kept.is_empty() { "" } else { ", " };
            *kept += &format!("{gap}{}", value.trim().trim_matches(['\'', '"']));
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(names: &[&str], yaml: &str) -> Vec<(String, String, String)> {
        let folder = tempfile::tempdir().expect("a folder");
        names.iter().for_each(|name| std::fs::create_dir(folder.path().join(name)).expect("made"));
        std::fs::write(folder.path().join(METADATA), yaml).expect("written");
        let all = roster(folder.path()).expect("readable");
        all.into_iter().map(|one| (one.name, one.id, one.origin.to_string())).collect()
    }

    fn one(name: &str, id: &str, origin: &str) -> (String, String, String) {
        (name.to_string(), id.to_string(), origin.to_string())
    }

    #[test]
    fn gradescope_names_stand_in_the_metadata() {
        let yaml = "---\nsubmission_12:\n  :submitters:\n  - :name: Ana Silva\n    :sid: '0042'\n    :email: ana@example.org\n  - :name: Rui\n    \
                    :sid: '7'\n  :created_at: 2026-12-01\nsubmission_9:\n  :submitters: []\n";
        let all = named(&["submission_12", "submission_13"], yaml);
        assert_eq!(all, [one("Ana Silva, Rui", "0042, 7", "gradescope"), one("submission_13", "13", "gradescope")]);
    }

    #[test]
    fn moodle_names_have_numbers_and_files_go_before_texts() {
        let names = [
            "Ana Maria_17_assignsubmission_file_",
            "Ana Maria_17_assignsubmission_onlinetext_",
            "Zé_18_assignsubmission_onlinetext_",
            "Rui_a_19_assignsubmission_file",
        ];
        let mut all = named(&names, "");
        all.sort();
        assert_eq!(all, [one("Ana Maria", "17", "moodle"), one("Rui_a", "19", "moodle"), one("Zé", "18", "moodle")]);
    }

    #[test]
    fn classroom_names_begin_alike() {
        let all = named(&["lab-zbuffer-ana-silva", "lab-zbuffer-rui", "lab-zbuffer-zoe"], "");
        assert_eq!(all[0], one("ana-silva", "ana-silva", "classroom"));
        assert_eq!(
            named(&["ana-silva", "rui"], ""),
            [one("ana-silva", "ana-silva", "folder"), one("rui", "rui", "folder")]
        );
    }

    #[cfg(unix)]
    #[test]
    fn keys_are_safe_and_differ_and_links_are_nobody() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["a b", "a_b", ".hidden", "a\nb"] {
            std::fs::create_dir(folder.path().join(name)).expect("made");
        }
        std::os::unix::fs::symlink("/etc", folder.path().join("link")).expect("linked");
        let all = roster(folder.path()).expect("readable");
        let mut keys: Vec<_> = all.iter().map(|one| one.key.clone()).collect();
        assert!(keys.iter().all(|key| !key.contains(['\n', '/', ' ']) && !key.is_empty()), "{keys:?}");
        keys.dedup();
        assert_eq!(keys.len(), 3, "{keys:?}");
    }
}
