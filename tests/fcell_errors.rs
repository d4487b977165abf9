//! What farop says about bad `.fcell`: every message is a snapshot, next to the text that provokes it.

use farop::parse::read_fcell;

/// An area of one cell, `lines` in it.
fn cell(lines: &str) -> String {
    format!(
        "fcell 1\ncrs EPSG:32629\nspecies PINPN form conifer\nspecies QUERO form broadleaf\ncover 3 paint:grass tile 30\n\
         cell 0 0 size 240\ndem 2 2 0 0 0 0\n{lines}\nend\n"
    )
}

/// `lines` at the head of an area of one flat cell.
fn head(lines: &str) -> String {
    format!("fcell 1\n{lines}\ncell 0 0\ndem 2 2 0 0 0 0\nend\n")
}

fn message(text: &str) -> String {
    match read_fcell("area.fcell", text.as_bytes()) {
        Ok((_, notices)) => format!("(read)\n{notices}"),
        Err(errors) => errors.to_string(),
    }
}

fn transcript(cases: &[String]) -> String {
    let say = |text: &String| format!("======== text\n{}\n-------- says\n{}\n", text.trim_end(), message(text));
    cases.iter().map(say).collect()
}

macro_rules! assert_messages {
    ($name:literal, $cases:expr) => {
        insta::with_settings!({ omit_expression => true, prepend_module_to_snapshot => false }, {
            insta::assert_snapshot!($name, transcript(&$cases));
        });
    };
}

#[test]
fn beginnings_and_ends() {
    assert_messages!(
        "fcell_beginnings_and_ends",
        [
            String::new(),
            "v from 0 0 0".to_string(),
            "fcell 2\n".to_string(),
            "fcell 1\nend\n".to_string(),
            "fcell 1\ncell 0 0\ndem 2 2 0 0 0 0\n".to_string(),
            head("") + "tree PINPN 1 1 1 1\n",
            "fcell 1\ncell 0 0\nend\n".to_string(),
            "fcell 1\ncell 0 0\nv 0 0 1\nend\n".to_string(),
            "FPACK\0".to_string(),
        ]
    );
}

#[test]
fn heads() {
    assert_messages!(
        "fcell_heads",
        [
            head("spcies PINPN"),
            head("species PINPN from conifer"),
            head("species PINPN form connifer"),
            head("species A\nspecies A"),
            head("cover 3 a.png tile 0"),
            head("cover 3 paint:gras"),
            head("cover 3 a.png\ncover 3 b.png"),
            head("seed -1"),
            head("side 0"),
            head("origin 511920"),
            head("mark \"Foia 100 100"),
            head("tree PINPN 1 1 10 3"),
            "fcell 1\ncell 0 0\nseed 3\ndem 2 2 0 0 0 0\nend\n".to_string(),
            "fcell 1\nside 100\ncell 0 0 size 240\ndem 2 2 0 0 0 0\nend\n".to_string(),
            "fcell 1\ncell 0 0\ndem 2 2 0 0 0 0\ncell 0 0\ndem 2 2 0 0 0 0\nend\n".to_string(),
            "fcell 1\ncell 0.5 0\nstand 1 species X\nend\n".to_string(),
        ]
    );
}

#[test]
fn grounds() {
    let ground = |lines: &str| format!("fcell 1\ncell 0 0\n{lines}\nend\n");
    assert_messages!(
        "fcell_grounds",
        [
            ground("dem 3 2 z0 412 1 2 3 4 5"),
            ground("dem 2 2 z0 412 1 2 3 4 5"),
            ground("dem 2 2 1 2 3 4.5"),
            ground("dem 2 2 1 2 3 40000"),
            ground("dem 2 2 1 2 nan 4"),
            ground("dem 1 2 1 2"),
            ground("dem 2 2 - - nodata -"),
            ground("dem 2 2 dz 0 1 2 3 4"),
            ground("dem 2 2 1 2 3 4\ndem 2 2 1 2 3 4"),
            ground("dem 2 2 1 2 3 4\nv 1 2 3"),
            ground("v 0 0 0\nv 240 0 0\nv 0 240 0\nt 0 1 3"),
            ground("v 0 0 0\nv 240 0 0\nv 120 0 9\nt 0 1 2"),
            ground("v 0 0 0\nv 240.1 0 0\nt 0 0 0"),
            ground("demref nowhere.hgt"),
            cell("ground 4"),
        ]
    );
}

#[test]
fn stands() {
    let stand = |fields: &str| cell(&format!("stand 12 {fields}"));
    assert_messages!(
        "fcell_stands",
        [
            stand("species PINPN h 14 2 crown 4 1 dens 1000000000"),
            stand("species PINPM h 14 2 crown 4 1 dens 520"),
            stand("species PINPN h 14 2 crown 4 1"),
            stand("species PINPN h 14 2 3 crown 4 1 dens 520"),
            stand("species PINPN hight 14 2 crown 4 1 dens 520"),
            stand("species PINPN h -14 2 crown 4 1 dens 520"),
            stand("species PINPN h 14 2 crown 4 1 dens 520 hcb 15"),
            stand("species PINPN h 14 2 crown 4 1 dens 520 plant row"),
            stand("species PINPN h 14 2 crown 4 1 dens 520 cover 5"),
            stand("species PINPN h 14 h 15 crown 4 1 dens 520"),
            stand(
                "species PINPN h 14 2 crown 4 1 dens 520 year 2018\nstand 12 species QUERO h 9 crown 5 dens 300 year 2018"
            ),
            stand("species PINPN h 14 2 crown 4 1 dens 520\nstand 12 species QUERO h 9 crown 5 dens 300 year 2018"),
            stand("species PINPN h 14,5 2 crown 4 1 dens 520"),
        ]
    );
}

#[test]
fn polygons() {
    let poly = |text: &str| cell(&format!("stand 12 species PINPN h 14 crown 4 dens 520\npoly 3 {text}"));
    assert_messages!(
        "fcell_polygons",
        [
            poly("stand 21 outer 3 0 0 9 0 0 9"),
            poly("cover 4 outer 3 0 0 9 0 0 9"),
            poly("outer 3 0 0 9 0 0 9"),
            poly("stand 12"),
            poly("stand 12 outer 4 0 0 9 0 0 9"),
            poly("stand 12 outer 3 0 0 9 0 0 9 5 5"),
            poly("stand 12 outer 2 0 0 9 0"),
            poly("stand 12 outer 3 0 0 240.5 0 0 9"),
            poly("stand 12 outer 3 -0.0005 0 240.0004 0 0 9"),
            poly("stand 12 outer 4 0 0 9 9 9 0 0 9"),
            poly("stand 12 outer 3 0 0 5 5 9 9"),
            poly("stand 12 outer 4 0 0 9 0 0 9 0 0"),
            poly("stand 12 outer 3 0 0 9 0 0 0"),
            poly("stand 12 outer 4 0 0 9 0 9 0 0 9"),
            poly("stand 12 outer 4 0 0 90 0 90 90 0 90 hole 3 95 5 99 5 95 9"),
            poly("stand 12 outer 4 0 0 90 0 90 90 0 90 hole 3 5 5 9 5 5 9 hole 3 6 6 99 5 95 9"),
            poly("stand 12 outer 4 0 0 90 0 90 90 0 90 hole 3 5 5 9 5"),
            poly("stand 12 outer 4000000000 0 0"),
        ]
    );
}

#[test]
fn things() {
    assert_messages!(
        "fcell_things",
        [
            cell("tree PINPN 10 10 14"),
            cell("tree PINPN 10 10 1e999 3"),
            cell("tree PINPN 300 10 14 3"),
            cell("tree PINPN 10 10 14 3 90 5"),
            cell("line road 6 2 0 0 9 9"),
            cell("line raod w 6 2 0 0 9 9"),
            cell("line road w 6 3 0 0 9 9"),
            cell("mark \"\" 1 2"),
            cell("mark Foia 1"),
            cell("\"tree\" 1 2"),
            cell("12 13"),
            cell("a\nb\nc\nd\ne\nf\ng\nh\ni\nj\nk\nl\nm\nn\no\np\nq\nr\ns\nw\nx\ny\nz"),
        ]
    );
}

/// No way of cutting or mangling a text panics, and what is read has only numbers.
#[test]
fn mangled_text_is_told() {
    let text = cell(
        "ground 3\nstand 12 species PINPN h 14 2 crown 4 1 dens 520 hcb 5 year 2018 plant rows tex 1 cover 3\n\
         poly 1 stand 12 outer 4 0 0 90 0 90 90 0 90 hole 3 5 5 9 5 5 9\ntree PINPN 1 2 3 4 5\n\
         line road w 6 2 0 0 9 9\nmark \"A b\" 1 2",
    );
    assert!(read_fcell("", text.as_bytes()).is_ok(), "{}", message(&text));
    for cut in 0..text.len() - 4 {
        assert!(read_fcell("", &text.as_bytes()[..cut]).is_err(), "cut at {cut}");
    }
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((state >> 33) as usize) % below
    };
    for _ in 0..2000 {
        let mut bytes = text.clone().into_bytes();
        for _ in 0..=random(4) {
            let at = random(bytes.len());
            match random(3) {
                0 => bytes[at] = b"09.-\" \n#eatc\xFF\0"[random(14)],
                1 => drop(bytes.drain(at..(at + random(9)).min(bytes.len()))),
                _ => bytes.insert(at, b"1 \n\"x"[random(5)]),
            }
        }
        match read_fcell("", &bytes) {
            Ok((_, notices)) => drop(notices.to_string()),
            Err(errors) => assert!(!errors.to_string().is_empty()),
        }
    }
}
