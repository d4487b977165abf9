//! The report without a browser: complete, small, closed to the network, and nobody's name or output is ever a tag.

#[path = "support/base64.rs"]
mod base64;
#[path = "support/command.rs"]
mod command;
#[path = "support/planted.rs"]
mod planted;

use base64::decoded;
use command::Desk;
use farop::grade::html::{class_index, report, write_class_index};
use farop::grade::rubric::Rubric;
use farop::grade::subject::{Answer, Failure};
use farop::grade::write::Results;
use farop::grade::{InProcess, LABS, Subject};
use farop::raster::ZBuffer;
use farop::screen::DrawList;
use farop::screen::file::Sheet;
use planted::{CORNERS, FAR_WINS, judged, planted};
use serde_json::json;

/// What somebody may be called, or print.
const EVIL: &str = "</script></pre><script>window.hacked=1</script><img src=x onerror=\"window.hacked=1\">'&";

/// Fails and says evil things.
struct Evil;

impl Subject for Evil {
    fn draw(&self, _: &DrawList, _: &Sheet) -> Result<Answer, Failure> {
        Err(Failure { message: EVIL.to_string(), hint: EVIL.to_string() })
    }
}

/// Elements in a page by name, with everything between `<` and `>`; what stands in scripts and styles is left out.
fn tags(page: &str) -> Vec<&str> {
    let mut tags = Vec::new();
    let mut rest = page;
    while let Some(start) = rest.find('<') {
        let end = start + rest[start..].find('>').expect("a tag ends");
        let tag = &rest[start + 1..end];
        tags.push(tag);
        rest = &rest[end + 1..];
        for raw in ["script", "style"] {
            if tag == raw || tag.starts_with(&format!("{raw} ")) {
                rest = &rest[rest.find(&format!("</{raw}>")).expect("it is closed")..];
            }
        }
    }
    tags
}

fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
}

/// Nothing is fetched, every picture has words, every element is closed.
fn check_page(page: &str) {
    assert!(page.len() < 1_000_000, "{}", page.len());
    assert!(page.contains("default-src 'none'"));
    let mut open = Vec::new();
    for tag in tags(page) {
        let name = tag.trim_start_matches('/').split([' ', '/']).next().expect("a name");
        for address in [attribute(tag, "src"), attribute(tag, "href")].into_iter().flatten() {
            assert!(address.starts_with("data:") || address.starts_with('#') || !address.contains(':'), "{address}");
        }
        if name == "img" {
            assert!(attribute(tag, "alt").is_some_and(|words| words.len() > 5), "{tag}");
            let png = attribute(tag, "src").and_then(|url| url.strip_prefix("data:image/png;base64,")).expect("a PNG");
            farop::image::decode(&decoded(png)).expect("a PNG");
        }
        assert!(!tag.contains("onerror=\"window") || tag.contains("&quot;"), "{tag}");
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') && !matches!(name, "!DOCTYPE" | "meta" | "img" | "br") {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
    // Two scripts: data, and the page's own.
    assert!(page.matches("<script").count() <= 2);
    assert!(!page.contains("<script>window"));
}

#[test]
fn a_report_says_what_how_many_why_and_where() {
    let verdict = planted("zbuffer", CORNERS, None);
    let page = report(&verdict);
    check_page(&page);
    for words in
        ["What", "How many", "Why", "Where", "instead of", "The smallest case", "polygons over each sample", "Hint 1"]
    {
        assert!(page.contains(words), "{words}");
    }
    let fault = verdict.faults.first().expect("a mistake");
    assert!(page.contains(fault.name) && page.contains(fault.cause));
    // Readable without scripts: the first wrong pixel of a picture in words and as a drawing.
    let with_wrong =
        verdict.aspects.iter().flat_map(|aspect| &aspect.shots).filter(|shot| !shot.wrong.is_empty()).count();
    assert_eq!(page.matches("The first wrong pixel").count(), with_wrong);
    assert!(page.matches("<svg").count() >= with_wrong && page.contains("shown: polygon"));
    // The screen file is in the page, whole.
    let witness = verdict.aspects.iter().find_map(|aspect| aspect.witness.as_ref()).expect("a witness");
    let link =
        page.split("href=\"data:text/plain;base64,").nth(1).and_then(|rest| rest.split('"').next()).expect("a link");
    assert_eq!(decoded(link), witness.screen_file().expect("memory"));
}

#[test]
fn lines_lights_and_samples_have_a_report_and_a_right_one_is_calm() {
    for lab in ["wire", "phong", "supersampling"] {
        check_page(&report(&planted(lab, FAR_WINS, None)));
    }
    let page = report(&judged("coverage", &InProcess(&ZBuffer), None));
    check_page(&page);
    assert!(page.contains("Nothing is wrong") && !page.contains("card bad") && !page.contains("Hint 1"));
}

#[test]
fn names_and_output_are_text() {
    let mut verdict = judged("zbuffer", &Evil, None);
    verdict.subject = EVIL.to_string();
    verdict.notes.push(EVIL.to_string());
    check_page(&report(&verdict));
    // A name in the data of the script, too.
    let mut drawn = planted("coverage", CORNERS, None);
    drawn.aspects[0].shots[0].case.name = EVIL.to_string();
    drawn.aspects[0].shots[0].complaint = Some(EVIL.to_string());
    let page = report(&drawn);
    check_page(&page);
    let data = page.split("type=\"application/json\">").nth(1).and_then(|rest| rest.split("</script>").next());
    let cases: serde_json::Value = serde_json::from_str(data.expect("data")).expect("JSON");
    assert!(cases.as_array().is_some_and(|cases| cases.iter().any(|case| case["name"] == EVIL)));
    check_page(&report(Results { refused: Some(EVIL), ..Results::from(&verdict) }));
}

#[test]
fn what_students_do_not_see_is_not_in_the_page() {
    let rubric = Rubric::parse("[visibility]\nties = 'after_due_date'\n'sample position' = 'hidden'\n", &LABS[2])
        .expect("a rubric");
    let (visible, hidden) = (planted("zbuffer", CORNERS, None), planted("zbuffer", CORNERS, Some(987_654_321)));
    let page = report(Results { hidden: Some(&hidden), rubric: Some(&rubric), ..Results::from(&visible) });
    check_page(&page);
    assert!(!page.contains("square on centers") && !page.contains("25 small squares") && page.contains("shown later"));
    assert!(page.contains("pictures that are not handed out"));
    // As many pictures as without hidden probes.
    let alone = report(Results { rubric: Some(&rubric), ..Results::from(&visible) });
    assert_eq!(page.matches("<img").count(), alone.matches("<img").count());
    assert!(!page.contains("987654321"), "the seed of hidden probes");
}

#[test]
fn the_class_page_ranks_links_and_escapes() {
    let class = json!({
        "schema": 1, "lab": "zbuffer", "seed": 1, "most": 125.0,
        "submissions": [
            {"key": "a", "name": EVIL, "id": "17", "points": 95.0, "most": 125.0, "passed": false, "status": "graded", "causes": [EVIL]},
            {"key": "b", "name": "Bia", "id": "18", "points": 125.0, "most": 125.0, "passed": true, "status": "graded", "causes": []}
        ],
        "causes": [{"cause": EVIL, "kind": "named", "why": EVIL, "rule": EVIL, "read": EVIL, "aspect": EVIL, "submissions": ["a"], "points_lost": 30.0}],
        "aspects": [{"name": "ties", "most": 10.0, "mean": 8.5, "right": 1, "wanting": 1}],
        "points": {"submissions": 2, "passed": 1, "least": 95.0, "median": 110.0, "mean": 110.0, "most": 125.0}
    });
    let page = class_index(&class, &|key| (key == "b").then(|| format!("submissions/{key}/report.html")));
    check_page(&page);
    for words in ["href=\"submissions/b/report.html\"", "95 / 125", "8.5 / 10", "30 points lost", "1</strong> of 2"] {
        assert!(page.contains(words), "{words}");
    }
    // Beside a class.json, with links to what is there.
    let desk = Desk::new();
    assert!(write_class_index(&desk.path("")).is_err_and(|words| words.contains("class.json")));
    desk.write("class.json", class.to_string());
    std::fs::create_dir_all(desk.path("submissions/b")).expect("a folder");
    desk.write("submissions/b/report.html", "");
    write_class_index(&desk.path("")).expect("room for a page");
    assert_eq!(String::from_utf8(desk.read("index.html")).expect("text"), page);
    // Nothing at all is a page as well.
    check_page(&class_index(&json!({}), &|_| None));
}

#[test]
fn a_graded_class_has_a_page_that_leads_to_reports() {
    if !cfg!(target_os = "linux") || !std::path::Path::new("/usr/bin/python3").exists() {
        println!("notice: no class is graded here, Linux and python3 are needed");
        return;
    }
    let desk = Desk::new();
    let right = include_str!("../student_rasterizers/other_languages/python/zbuffer.py");
    std::fs::create_dir(desk.path("class")).expect("a folder");
    for (name, text) in [("ana <b>", right.to_string()), ("bia", right.replace("row + 0.5", "row + 0.0"))] {
        std::fs::create_dir(desk.path(&format!("class/{name}"))).expect("a folder");
        desk.write(&format!("class/{name}/zbuffer.py"), text);
    }
    desk.done("grade coverage --class class --jobs 2 --time 60 --unsafe-no-sandbox");
    let index = String::from_utf8(desk.read("class.graded/index.html")).expect("text");
    check_page(&index);
    assert!(index.contains("ana &lt;b&gt;") && index.contains("1</strong> of 2"), "{index}");
    let links: Vec<_> = index.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(links.iter().filter(|link| link.ends_with("/report.html")).count() >= 2, "{links:?}");
    for link in links {
        check_page(&String::from_utf8(desk.read(&format!("class.graded/{link}"))).expect("text"));
    }
    // Points are those of the lab, not shares.
    let bia = String::from_utf8(desk.read("class.graded/submissions/bia/report.html")).expect("text");
    assert!(bia.contains(" of 85 points") && bia.contains("card bad"));
}

#[test]
fn the_command_writes_the_report() {
    let desk = Desk::new();
    desk.done("grade coverage -r zbuffer --report page.html");
    check_page(&String::from_utf8(desk.read("page.html")).expect("text"));
    let outcome = desk.run("grade coverage -r zbuffer --report no/where.html");
    assert!(outcome.code == 2 && outcome.stderr.contains("no folder"), "{}", outcome.stderr);
}
