//! The report in a real headless browser: opened, clicked, moved with keys, in the dark, without scripts. Needs chromium; without it
//! the tests say so and pass. Screenshots stay in the target folder's `tmp`, to be looked at.

#![cfg(target_os = "linux")]

#[path = "support/base64.rs"]
mod base64;
#[path = "support/browser.rs"]
mod browser;
#[path = "support/planted.rs"]
mod planted;

use browser::Page;
use farop::grade::Verdict;
use farop::grade::html::report;
use farop::grade::verdict::Shot;
use farop::plan::Accepts;
use farop::render::why::explain;
use planted::{CORNERS, Planted, planted};
use serde_json::json;
use std::path::Path;

const EVIL: &str = "Ana </h1></script><script>window.hacked=1</script><img src=x onerror=\"window.hacked=1\">";

/// Two mistakes, a name and words that try to be tags.
fn graded() -> Verdict {
    let mut verdict = planted("zbuffer", Planted { far_wins: true, ..CORNERS }, None);
    verdict.subject = EVIL.to_string();
    verdict.aspects[0].shots[0].complaint = Some(EVIL.to_string());
    verdict
}

/// The pictures in the order in which the page numbers them: wrong ones by aspect, then right ones.
fn numbered(verdict: &Verdict) -> Vec<&Shot> {
    let wanting = verdict.aspects.iter().filter(|aspect| aspect.cause.is_some());
    wanting.flat_map(|aspect| &aspect.shots).filter(|shot| !shot.is_right() && shot.picture().is_some()).collect()
}

fn write(folder: &Path, verdict: &Verdict) -> String {
    let path = folder.join("report.html");
    std::fs::write(&path, report(verdict)).expect("room for a page");
    format!("file://{}", path.display())
}

fn keep(name: &str, png: &[u8]) {
    let picture = farop::image::decode(png).expect("a PNG");
    assert!(picture.colors().any(|color| color != picture.pixel(0, 0)), "{name} is empty");
    std::fs::write(Path::new(env!("CARGO_TARGET_TMPDIR")).join(name), png).expect("room for a picture");
}

/// Brings a picture of the page to the middle of the window and returns where its pixel (x, y) is.
fn place(page: &mut Page, number: usize, shot: &Shot, (x, y): (usize, usize)) -> (f64, f64) {
    let box_of = format!(
        "(() => {{ const img = document.querySelector('img[data-case=\"{number}\"]'); \
         for (let outer = img.parentElement; outer; outer = outer.parentElement) if (outer.tagName === 'DETAILS') outer.open = true; \
         img.scrollIntoView({{ block: 'center' }}); const r = img.getBoundingClientRect(); return [r.left, r.top, r.width, r.height]; }})()"
    );
    let edges: Vec<f64> = serde_json::from_value(page.value(&box_of)).expect("four numbers");
    let picture = shot.picture().expect("a picture");
    let at = |start: f64, length: f64, pixel: usize, all: usize| start + length * (pixel as f64 + 0.5) / all as f64;
    (at(edges[0], edges[2], x, picture.width()), at(edges[1], edges[3], y, picture.height()))
}

#[test]
fn a_click_asks_about_the_pixel_under_it() {
    let Some(program) = browser::program() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let verdict = graded();
    let address = write(folder.path(), &verdict);
    let mut page = Page::open(program, folder.path());
    let window = json!({ "width": 1100, "height": 1300, "deviceScaleFactor": 1, "mobile": false });
    page.ask("Emulation.setDeviceMetricsOverride", window);
    page.go(&address);
    assert_eq!(page.value("document.querySelectorAll('#inspector').length"), 0);
    keep("report_top.png", &page.screenshot());

    // A picture with two polygons over one of its wrong pixels.
    let shots = numbered(&verdict);
    let list = |shot: &Shot| shot.case.list(Accepts::AnyPolygon);
    let place_of = |shot: &Shot, at: usize| {
        let width = shot.picture().expect("a picture").width();
        (at % width, at / width)
    };
    let over = |shot: &Shot, at: usize| {
        let (x, y) = place_of(shot, at);
        explain(&list(shot), x as i32, y as i32).candidates
    };
    let found = shots.iter().enumerate().find_map(|(number, shot)| {
        let at = shot.wrong.iter().find(|&&at| shot.case.samples == 1 && over(shot, at).len() >= 2)?;
        Some((number, *shot, *at))
    });
    let (number, shot, at) = found.expect("a pixel with two polygons");
    let (x, y) = place_of(shot, at);
    let clicked = place(&mut page, number, shot, (x, y));
    page.click(clicked);
    let text = page.text("document.querySelector('#inspector').innerText");
    assert!(text.contains(&format!("Pixel ({x}, {y})")), "{text}");
    assert_eq!(page.text("location.hash"), format!("#inspect={number},{x},{y}"));
    let level = |[r, g, b]: [u8; 3]| format!("{r},{g},{b}");
    let drawn = level(shot.picture().expect("a picture").pixel(x, y));
    let right = level(farop::grade::pictures::right(&shot.case).pixel(x, y));
    let said = page.text("document.querySelector('#inspected').innerText");
    assert_eq!(said.split_whitespace().collect::<Vec<_>>().join(" "), format!("drawn {drawn}, right {right}"));
    // The page computes anew what `farop why` says: the same polygons, the same edges, the same one in front.
    let candidates = over(shot, at);
    let rows = "[...document.querySelectorAll('#inspector tbody tr')].map((row) => [...row.children].map((cell) => cell.innerText))";
    let rows: Vec<Vec<String>> = serde_json::from_value(page.value(rows)).expect("a table");
    assert_eq!(rows.len(), candidates.len(), "{text}");
    let winner = explain(&list(shot), x as i32, y as i32).winner;
    for (index, (row, candidate)) in rows.iter().zip(&candidates).enumerate() {
        let front = if winner == Some(index) { ", in front" } else { "" };
        assert_eq!(row[0], format!("{}{front}", candidate.polygon));
        let edges: Vec<f64> = row[3]
            .split(", ")
            .map(|text| text.split(' ').next().expect("a number").parse().expect("a number"))
            .collect();
        for (shown, edge) in edges.iter().zip(&candidate.edges) {
            assert!((shown - edge).abs() <= 1e-5 * edge.abs().max(1.0), "{shown} {edge}");
        }
        let depth: f64 = row[1].parse().expect("a number");
        assert!((depth - candidate.depth).abs() < 1e-5, "{depth} {}", candidate.depth);
    }
    // Pens do not grow with the picture, and there is a sample point in every pixel that is shown.
    assert_eq!(
        page.text("getComputedStyle(document.querySelector('#inspector polygon.edge')).vectorEffect"),
        "non-scaling-stroke"
    );
    let dots = page.text("document.querySelector('#inspector path.dots').getAttribute('d')").matches('M').count();
    assert_eq!(Some(dots as u64), page.value("document.querySelectorAll('#inspector path[fill]:not(.bad)').length - document.querySelectorAll('#inspector path.bad').length").as_u64());
    page.value("document.querySelector('#inspector').scrollIntoView({ block: 'center' })");
    keep("report_inspector.png", &page.screenshot());

    // Keys move on; a click in the enlarged picture does, too.
    page.press("ArrowDown", 40);
    let text = page.text("document.querySelector('#inspector h3').innerText");
    assert_eq!(text, format!("Pixel ({x}, {})", (y + 1).min(shot.picture().expect("a picture").height() - 1)));
    page.value("[...document.querySelectorAll('#inspector button')].find((button) => button.innerText === 'Next wrong pixel').click()");
    let hash = page.text("location.hash");
    assert!(
        shot.wrong
            .iter()
            .any(|&at| hash == format!("#inspect={number},{},{}", place_of(shot, at).0, place_of(shot, at).1)),
        "{hash}"
    );
    ties_are_decided_alike(&mut page, &shots);
    nothing_came_in(&mut page);
}

/// The yellow sample points are those that the tie rule covers, in whole pictures, centers on edges included.
fn ties_are_decided_alike(page: &mut Page, shots: &[&Shot]) {
    page.value(
        "for (let times = 0; times < 12; times++) document.querySelector('#inspector button[title=smaller]').click()",
    );
    let small = |shot: &Shot| shot.case.samples == 1 && shot.case.width <= 25 && shot.case.height <= 25;
    let on_edges = |shot: &Shot| {
        let list = shot.case.list(Accepts::AnyPolygon);
        let mut all = (0..shot.case.height as i32).flat_map(|y| (0..shot.case.width as i32).map(move |x| (x, y)));
        all.any(|(x, y)| explain(&list, x, y).candidates.iter().any(|candidate| candidate.edges.contains(&0.0)))
    };
    let ties: Vec<_> = shots.iter().enumerate().filter(|(_, shot)| small(shot) && on_edges(shot)).collect();
    assert!(ties.len() >= 3, "{}", ties.len());
    for (number, shot) in ties.into_iter().take(6) {
        page.value(&format!("location.hash = '#inspect={number},0,0'; dispatchEvent(new Event('hashchange'))"));
        let path = page.text("document.querySelector('#inspector path.inside').getAttribute('d')");
        let list = shot.case.list(Accepts::AnyPolygon);
        let covered = |x: i32, y: i32| !explain(&list, x, y).candidates.is_empty();
        for y in 0..shot.case.height as i32 {
            for x in 0..shot.case.width as i32 {
                assert_eq!(path.contains(&format!("M{x}.5 {y}.5h0")), covered(x, y), "{}: {x},{y}", shot.case.name);
            }
        }
    }
}

/// Nobody's words ran, and nothing was fetched but the file itself.
fn nothing_came_in(page: &mut Page) {
    assert_eq!(page.text("typeof window.hacked"), "undefined");
    assert_eq!(page.text("document.querySelector('h1').innerText"), EVIL);
    let requests = page.events.iter().filter(|event| event["method"] == "Network.requestWillBeSent");
    let addresses: Vec<_> = requests.filter_map(|event| event["params"]["request"]["url"].as_str()).collect();
    assert!(
        addresses.iter().all(|address| address.starts_with("file:") || address.starts_with("data:")),
        "{addresses:?}"
    );
    let failed = page.events.iter().find(|event| event["method"] == "Runtime.exceptionThrown");
    assert!(failed.is_none(), "{failed:?}");
}

#[test]
fn an_address_asks_as_a_click_does_and_it_can_be_read_in_the_dark() {
    let Some(program) = browser::program() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let verdict = graded();
    let address = write(folder.path(), &verdict);
    let mut page = Page::open(program, folder.path());
    let window = json!({ "width": 1100, "height": 1300, "deviceScaleFactor": 1, "mobile": false });
    page.ask("Emulation.setDeviceMetricsOverride", window);
    page.go(&format!("{address}#inspect=1,2,3"));
    assert_eq!(page.text("document.querySelector('#inspector h3').innerText"), "Pixel (2, 3)");
    // Words against what lies behind them: at least 4.5 to 1, by daylight and in the dark.
    let contrasts = include_str!("support/contrast.js");
    for scheme in ["light", "dark"] {
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        page.ask("Emulation.setEmulatedMedia", media);
        let pale = page.value(contrasts);
        assert_eq!(pale, json!([]), "{scheme}");
        keep(&format!("report_{scheme}.png"), &page.screenshot());
    }
    // On a telephone nothing is wider than the window.
    let window = json!({ "width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": true });
    page.ask("Emulation.setDeviceMetricsOverride", window);
    assert_eq!(page.value("document.documentElement.scrollWidth <= 390"), true);
    page.value("scrollTo(0, 0)");
    keep("report_small.png", &page.screenshot());
    nothing_came_in(&mut page);
}

#[test]
fn without_scripts_everything_is_there_to_read() {
    let Some(program) = browser::program() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let verdict = graded();
    let address = write(folder.path(), &verdict);
    let mut page = Page::open(program, folder.path());
    page.ask("Emulation.setScriptExecutionDisabled", json!({ "value": true }));
    page.go(&format!("{address}#inspect=1,2,3"));
    let root = page.ask("DOM.getDocument", json!({}))["root"]["nodeId"].clone();
    let html =
        page.ask("DOM.getOuterHTML", json!({ "nodeId": root }))["outerHTML"].as_str().expect("a page").to_string();
    assert!(!html.contains("id=\"inspector\"") && !html.contains("class=\"scripted\""), "a script ran");
    let shots = numbered(&verdict).iter().filter(|shot| !shot.wrong.is_empty()).count();
    assert_eq!(html.matches("The first wrong pixel").count(), shots);
    for fault in &verdict.faults {
        assert!(html.contains(fault.name) && html.contains(fault.rule.split(['<', '>', '&']).next().expect("words")));
    }
    keep("report_without_scripts.png", &page.screenshot());
}
