//! What platforms get: every writer against the fields its platform lists, hidden probes that tell nothing, files that outlive
//! a grader that is stopped.
//!
//! The checkers are written from the platforms' documents and know nothing of the writers.

#[path = "support/base64.rs"]
mod base64;
#[path = "support/command.rs"]
mod command;
#[path = "support/planted.rs"]
mod planted;

use base64::decoded;
use command::Desk;
use farop::grade::folder::files;
use farop::grade::labs;
use farop::grade::rubric::Rubric;
use farop::grade::subject::{Answer, Failure};
use farop::grade::write::{self, Results};
use farop::grade::{LABS, Subject, Verdict};
use farop::plan::Accepts;
use farop::raster::{PerPolygon, Rasterizer, Watkins, Wire, ZBuffer};
use farop::screen::DrawList;
use farop::screen::file::{Attributes, Sheet, write_v2};
use planted::{CORNERS, FAR_WINS, Planted, RIGHT, judged, planted};
use serde_json::Value;

/// What a field may hold.
enum Kind {
    Text,
    Number,
    Flag,
    /// One of these words.
    OneOf(&'static [&'static str]),
    Any,
}

const FORMATS: Kind = Kind::OneOf(&["text", "html", "simple_format", "md", "ansi"]);
const SEEN: Kind = Kind::OneOf(&["hidden", "after_due_date", "after_published", "visible"]);

/// Fails on a field that the platform does not list, that is of another kind, or, where it is needed, missing.
fn check(value: &Value, fields: &[(&str, bool, Kind)]) {
    let object = value.as_object().unwrap_or_else(|| panic!("no object: {value}"));
    for (name, field) in object {
        let (_, _, kind) =
            fields.iter().find(|(known, ..)| known == name).unwrap_or_else(|| panic!("unknown field {name}"));
        let fits = match kind {
            Kind::Text => field.is_string(),
            Kind::Number => field.as_f64().is_some_and(f64::is_finite),
            Kind::Flag => field.is_boolean(),
            Kind::OneOf(words) => field.as_str().is_some_and(|word| words.contains(&word)),
            Kind::Any => true,
        };
        assert!(fits, "{name}: {field}");
    }
    let missing = fields.iter().find(|(name, is_needed, _)| *is_needed && !object.contains_key(*name));
    assert!(missing.is_none(), "{} is missing", missing.map_or("", |(name, ..)| name));
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value[name].as_array().unwrap_or_else(|| panic!("{name} is no list"))
}

fn check_gradescope(value: &Value) {
    check(
        value,
        &[
            ("score", false, Kind::Number),
            ("execution_time", true, Kind::Number),
            ("output", true, Kind::Text),
            ("output_format", true, FORMATS),
            ("test_output_format", false, FORMATS),
            ("test_name_format", false, FORMATS),
            ("visibility", true, SEEN),
            ("stdout_visibility", true, SEEN),
            ("extra_data", false, Kind::Any),
            ("tests", true, Kind::Any),
            ("leaderboard", false, Kind::Any),
        ],
    );
    // A score at the top would take the place of the tests' sum.
    assert!(value.get("score").is_none() && value["extra_data"].is_object());
    for test in list(value, "tests") {
        check(
            test,
            &[
                ("score", true, Kind::Number),
                ("max_score", true, Kind::Number),
                ("status", true, Kind::OneOf(&["passed", "failed"])),
                ("name", true, Kind::Text),
                ("name_format", false, FORMATS),
                ("number", true, Kind::Text),
                ("output", true, Kind::Text),
                ("output_format", true, FORMATS),
                ("tags", true, Kind::Any),
                ("visibility", true, SEEN),
                ("extra_data", true, Kind::Any),
            ],
        );
        assert!(list(test, "tags").iter().all(Value::is_string));
        assert!(test["score"].as_f64() <= test["max_score"].as_f64(), "{test}");
        let is_full = test["score"].as_f64() >= test["max_score"].as_f64();
        assert!(test["status"] != "passed" || is_full, "{test}");
        let number = test["number"].as_str().expect("a text");
        assert!(number.split('.').all(|part| part.parse::<u32>().is_ok()), "{number}");
    }
    for entry in value.get("leaderboard").and_then(Value::as_array).into_iter().flatten() {
        check(
            entry,
            &[("name", true, Kind::Text), ("value", true, Kind::Any), ("order", false, Kind::OneOf(&["asc", "desc"]))],
        );
        assert!(entry["value"].is_number() || entry["value"].is_string());
    }
}

fn check_images(value: &Value) {
    for image in list(value, "images") {
        check(image, &[("label", true, Kind::Text), ("url", true, Kind::Text)]);
        let url = image["url"].as_str().expect("a text");
        let png = decoded(url.strip_prefix("data:image/png;base64,").expect("a picture inside"));
        farop::image::decode(&png).expect("a PNG");
    }
}

fn check_prairielearn(value: &Value) {
    check(
        value,
        &[
            ("gradable", true, Kind::Flag),
            ("format_errors", false, Kind::Any),
            ("score", true, Kind::Number),
            ("message", true, Kind::Text),
            ("output", true, Kind::Text),
            ("images", true, Kind::Any),
            ("tests", true, Kind::Any),
        ],
    );
    assert!((0.0..=1.0).contains(&value["score"].as_f64().expect("a number")));
    assert!(value.to_string().len() <= 1_000_000);
    assert_eq!(value["gradable"] == false, value.get("format_errors").is_some());
    check_images(value);
    for test in list(value, "tests") {
        check(
            test,
            &[
                ("name", true, Kind::Text),
                ("description", true, Kind::Text),
                ("points", true, Kind::Number),
                ("max_points", true, Kind::Number),
                ("message", true, Kind::Text),
                ("output", true, Kind::Text),
                ("images", true, Kind::Any),
            ],
        );
        check_images(test);
    }
}

fn check_classroom(text: &str) -> Value {
    assert!(text.trim_end().chars().all(|letter| letter.is_ascii_alphanumeric() || "+/=".contains(letter)));
    let value: Value = serde_json::from_slice(&decoded(text.trim_end())).expect("JSON");
    const WORDS: Kind = Kind::OneOf(&["pass", "fail", "error"]);
    check(
        &value,
        &[
            ("version", true, Kind::Number),
            ("status", true, WORDS),
            ("max_score", true, Kind::Number),
            ("tests", true, Kind::Any),
        ],
    );
    assert_eq!(value["version"], 1);
    for test in list(&value, "tests") {
        check(
            test,
            &[
                ("name", true, Kind::Text),
                ("status", true, WORDS),
                ("message", true, Kind::Text),
                ("test_code", true, Kind::Text),
                ("filename", true, Kind::Text),
                ("line_no", true, Kind::Number),
                ("execution_time", true, Kind::Any),
                ("score", true, Kind::Number),
            ],
        );
    }
    value
}

/// Elements of an XML text with their attributes; fails where a tag is not closed, or stands in the wrong place.
fn check_junit(text: &str) -> Vec<(String, String)> {
    let text = text.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>").expect("an XML head");
    let (mut open, mut elements): (Vec<String>, Vec<(String, String)>) = (Vec::new(), Vec::new());
    for part in text.split('<').skip(1) {
        let (tag, words) = part.split_once('>').expect("a tag ends");
        assert!(
            words
                .split('&')
                .skip(1)
                .all(|rest| { ["amp;", "lt;", "gt;", "quot;"].iter().any(|entity| rest.starts_with(entity)) })
        );
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let name = tag.split([' ', '/']).next().expect("a name").to_string();
        let parent = match name.as_str() {
            "testsuites" => None,
            "testsuite" => Some("testsuites"),
            "testcase" => Some("testsuite"),
            "failure" | "error" | "skipped" => Some("testcase"),
            "system-out" => Some("testsuite"),
            other => panic!("unknown element {other}"),
        };
        assert_eq!(open.last().map(String::as_str), parent, "{tag}");
        elements.push((name.clone(), tag.to_string()));
        if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty());
    for (name, tag) in &elements {
        let needed: &[&str] = match name.as_str() {
            "testsuite" => &["name=", "tests=", "failures=", "errors=", "skipped=", "time="],
            "testcase" => &["classname=", "name=", "time="],
            _ => &[],
        };
        assert!(needed.iter().all(|attribute| tag.contains(attribute)), "{tag}");
    }
    elements
}

fn check_all(results: Results<'_>) {
    check_gradescope(&write::gradescope(results));
    check_prairielearn(&write::prairielearn(results));
    check_classroom(&write::classroom(results));
    check_junit(&write::junit(results));
}

#[test]
fn every_writer_has_the_fields_of_its_platform() {
    let rubric =
        Rubric::parse("[visibility]\nties = 'after_due_date'\n[hidden]\nshare = 0.5\n", &LABS[2]).expect("a rubric");
    for (visible, hidden) in [(RIGHT, RIGHT), (CORNERS, CORNERS)] {
        let (visible, hidden) = (planted("zbuffer", visible, None), planted("zbuffer", hidden, Some(7)));
        let results =
            Results { hidden: Some(&hidden), rubric: Some(&rubric), leaderboard: true, ..Results::from(&visible) };
        check_all(results);
        check_all(Results { hidden: None, ..results });
        check_all(Results { refused: Some("the program does not <start> & \"run\""), ..results });
        let value = write::gradescope(results);
        let score: f64 = list(&value, "tests").iter().filter_map(|test| test["score"].as_f64()).sum();
        assert!((score - results.earned()).abs() < 1e-9);
        assert_eq!(list(&value, "leaderboard")[0]["name"], "points");
        let ties = list(&value, "tests").iter().find(|test| test["name"] == "ties").expect("an aspect");
        assert_eq!((&ties["visibility"], &ties["number"]), (&"after_due_date".into(), &"6.1".into()));
    }
}

#[test]
fn the_same_mistake_has_the_same_place_in_every_file() {
    let verdict = planted("zbuffer", FAR_WINS, None);
    let gradescope = write::gradescope(&verdict);
    let failed: Vec<_> = list(&gradescope, "tests").iter().filter(|test| test["status"] == "failed").collect();
    let names: Vec<_> = failed.iter().filter_map(|test| test["name"].as_str()).collect();
    assert!(names.contains(&"depth"), "{names:?}");
    let classroom = check_classroom(&write::classroom(&verdict));
    let also: Vec<_> = list(&classroom, "tests").iter().filter(|test| test["status"] == "fail").collect();
    assert_eq!(also.iter().filter_map(|test| test["name"].as_str()).collect::<Vec<_>>(), names);
    assert_eq!(classroom["status"], "fail");
    let junit = check_junit(&write::junit(&verdict));
    assert_eq!(junit.iter().filter(|(name, _)| name == "failure").count(), names.len());
    let prairielearn = write::prairielearn(&verdict);
    let depth = list(&prairielearn, "tests").iter().find(|test| test["name"] == "depth").expect("an aspect");
    assert!(
        !list(depth, "images").is_empty() && depth["output"].as_str().is_some_and(|text| text.contains("far wins"))
    );
    let score = prairielearn["score"].as_f64().expect("a number");
    assert!((score - verdict.earned() / verdict.most()).abs() < 1e-9 && score < 1.0);
}

/// Says its whole input when it fails, as a program may that wants to know what is asked.
struct Tells;

impl Subject for Tells {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let mut text = Vec::new();
        write_v2(list, sheet, Attributes::default(), &mut text).expect("memory");
        Err(Failure { message: String::from_utf8(text).expect("ASCII"), hint: "<script>alert(1)</script>".into() })
    }
}

/// What of hidden probes must not be in a text: pictures, places, levels, input, what a program printed.
fn assert_tells_nothing(text: &str, hidden: &Verdict) {
    for word in ["smallest case", "the first at", "1/w", "vertex", "<script", "edges, and where", "instead of"] {
        assert!(!text.contains(word), "{word}: {text}");
    }
    for shot in hidden.aspects.iter().flat_map(|aspect| &aspect.shots) {
        assert!(!text.contains(&format!("{}:", shot.case.name)), "{}", shot.case.name);
    }
}

#[test]
fn hidden_probes_tell_neither_picture_nor_place_nor_what_a_program_printed() {
    for hidden in [planted("zbuffer", CORNERS, Some(9)), judged("zbuffer", &Tells, Some(9))] {
        let visible = planted("zbuffer", RIGHT, None);
        let results = Results { hidden: Some(&hidden), ..Results::from(&visible) };
        for test in list(&write::gradescope(results), "tests")
            .iter()
            .filter(|test| test["number"].as_str().is_some_and(|number| number.ends_with(".2")))
        {
            assert_tells_nothing(&test.to_string(), &hidden);
            assert_eq!(test["visibility"], "hidden");
        }
        let prairielearn = write::prairielearn(results);
        let of_hidden = list(&prairielearn, "tests")
            .iter()
            .filter(|test| test["name"].as_str().is_some_and(|name| name.ends_with("hidden probes")));
        for test in of_hidden {
            assert!(list(test, "images").is_empty());
            assert_tells_nothing(&test.to_string(), &hidden);
        }
        assert_tells_nothing(&check_classroom(&write::classroom(results)).to_string(), &hidden);
        assert_tells_nothing(&write::junit(results), &hidden);
        assert_tells_nothing(&write::hidden_text(&hidden), &hidden);
        // What is printed says how hidden probes ended.
        assert_eq!(write::gradescope(results)["stdout_visibility"], "hidden");
    }
}

#[test]
fn a_visible_aspect_that_is_made_hidden_tells_as_little() {
    let rubric = Rubric::parse("[visibility]\n'sample position' = 'hidden'\n", &LABS[2]).expect("a rubric");
    let verdict = planted("zbuffer", CORNERS, None);
    let value = write::gradescope(Results { rubric: Some(&rubric), ..Results::from(&verdict) });
    let test = list(&value, "tests").iter().find(|test| test["name"] == "sample position").expect("an aspect");
    assert_eq!(test["visibility"], "hidden");
    assert_tells_nothing(&test.to_string(), &verdict);
}

#[test]
fn right_rasterizers_pass_the_hidden_probes_and_mistakes_keep_their_names() {
    for lab in LABS {
        let rasterizer: Box<dyn Rasterizer> = match lab.name {
            "wire" => Box::new(PerPolygon(Wire)),
            "watkins" => Box::new(Watkins),
            _ => Box::new(ZBuffer),
        };
        for seed in [1, 2] {
            let verdict = judged(lab.name, &farop::grade::InProcess(&*rasterizer), Some(seed));
            assert!(verdict.is_passed() && verdict.faults.is_empty(), "{}\n{}", lab.name, write::text(&verdict));
        }
    }
    for (mistake, name) in [(CORNERS, "sampled at corners"), (FAR_WINS, "far wins")] {
        let named: Vec<_> = [None, Some(5)]
            .map(|hidden| planted("zbuffer", mistake, hidden))
            .iter()
            .map(|verdict| verdict.faults.first().map(|fault| fault.name))
            .collect();
        assert_eq!(named[0], named[1], "{name}");
        assert!(named[0].is_some(), "{name}");
    }
}

/// Answers every visible probe by heart and nothing else.
struct ByHeart(Vec<(DrawList, Sheet)>);

impl Subject for ByHeart {
    fn draw(&self, list: &DrawList, sheet: &Sheet) -> Result<Answer, Failure> {
        let (list, sheet) = self
            .0
            .iter()
            .find(|(known, of)| known == list && of == sheet)
            .ok_or(Failure { message: "never seen".into(), hint: String::new() })?;
        farop::grade::InProcess(&ZBuffer).draw(list, sheet)
    }
}

#[test]
fn who_knows_the_visible_probes_by_heart_gets_nothing_for_the_hidden_ones() {
    let lab = labs::find("zbuffer").expect("a lab");
    let known = files(lab, 1).into_iter().map(|(_, case)| (case.list(Accepts::AnyPolygon), case.sheet())).collect();
    let by_heart = ByHeart(known);
    let (visible, hidden) = (judged("zbuffer", &by_heart, None), judged("zbuffer", &by_heart, Some(1)));
    assert!(visible.earned() > 0.8 * visible.most(), "{}", write::text(&visible));
    // "cost" has no pictures.
    assert!(hidden.earned() <= 2.5, "{}", write::text(&hidden));
}

#[test]
fn a_grade_that_is_not_whole_is_valid_in_every_file() {
    let lab = labs::find("coverage").expect("a lab");
    let points = |aspect: &labs::Aspect| f64::from(aspect.points);
    let request = farop::grade::Request { lab, name: "stopped".to_string(), seed: 1, points: &points };
    let rasterizer = PerPolygon(Planted { panics_beyond: 9, ..RIGHT });
    let mut count = 0;
    let verdict = farop::grade::grade(&farop::grade::InProcess(&rasterizer), &request, &mut |so_far| {
        // Most of the time goes into the check.
        if count % 12 == 0 {
            check_all(Results::from(so_far));
        }
        count += 1;
    });
    assert!(count > 30);
    check_all(Results::from(&verdict));
    let text = write::junit(&verdict);
    assert!(text.contains("&lt;b&gt;on purpose&lt;/b&gt;"), "{text}");
}

#[test]
fn the_command_writes_all_files_and_a_refusal_into_each() {
    let desk = Desk::new();
    let all = "--gradescope g.json --leaderboard --prairielearn p.json --classroom c.txt --junit j.xml";
    desk.done(&format!("grade coverage -r zbuffer --hidden 5 {all}"));
    let parsed = |name: &str| serde_json::from_slice::<Value>(&desk.read(name)).expect("JSON");
    let text = |name: &str| String::from_utf8(desk.read(name)).expect("text");
    check_gradescope(&parsed("g.json"));
    check_prairielearn(&parsed("p.json"));
    assert_eq!(parsed("p.json")["score"], 1.0);
    assert_eq!(check_classroom(&text("c.txt"))["status"], "pass");
    let suites = check_junit(&text("j.xml"));
    assert_eq!(suites.iter().filter(|(name, _)| name == "testsuite").count(), 2);

    // What is not there at all is not graded; a program that draws nothing is, and costs no attempt where there are attempts.
    for (name, code) in [("nobody", 2), ("exec:false", 1)] {
        let outcome = desk.run(&format!("grade coverage -r {name} {all}"));
        assert_eq!(outcome.code, code, "{}", outcome.stderr);
        check_gradescope(&parsed("g.json"));
        let total: f64 = list(&parsed("g.json"), "tests").iter().filter_map(|test| test["score"].as_f64()).sum();
        assert_eq!(total, 0.0);
        check_prairielearn(&parsed("p.json"));
        assert_eq!(parsed("p.json")["gradable"], false);
        assert_eq!(check_classroom(&text("c.txt"))["status"], "error", "{name}");
        check_junit(&text("j.xml"));
    }
}
