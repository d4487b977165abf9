//! `farop forest`: bad input ends with a message, exit code 2 and no file; packs, walks and films do what they say.

#[path = "support/command.rs"]
mod command;

use command::Desk;

/// A cell with trees, a road, a void and two places; tests replace parts of it.
const AREA: &str = "fcell 1
species PIN form umbrella
species OAK form broadleaf
cover 1 paint:grass tile 30
mark \"The Hut\" 60 200
mark \"Ford\" 180 60
cell 0 0 size 240 seed 7
ground 1
dem 3 3 z0 400 dz 0.5  0 10 20  4 14 24  8 18 28
stand 12 species PIN h 14 2 crown 4 0.8 dens 100 hcb 6 year 2011
stand 12 species PIN h 18 2 crown 5 0.8 dens 40 hcb 6 year 2026
poly 1 stand 12 outer 4 0 0 120 0 120 240 0 240
line road w 6 2 0 100 240 120
tree OAK 200 200 12 8 0
end
";

fn desk() -> Desk {
    let desk = Desk::new();
    desk.write("area.fcell", AREA);
    desk
}

/// The desk with the area as a pack, too.
fn packed() -> Desk {
    let desk = desk();
    desk.done("forest pack area.fcell -o area.fpack");
    desk
}

#[test]
fn what_is_in_it() {
    let desk = packed();
    let told = desk.done("forest area.fpack").text().to_string();
    for part in
        ["1 cell of 240 m, 5.8 ha", "400.0 to 414.0 m", "about 288 trees", "years 2011, 2026", "\"Ford\" at 180 60"]
    {
        assert!(told.contains(part), "{part}\n{told}");
    }
    let later = desk.done("forest area.fpack --year 2026").text().to_string();
    assert!(later.contains("about 115 trees in 2026"), "{later}");
}

/// A pack remembers files and lines, so two packs of one text by two names differ in these; as text they are the same.
#[test]
fn packing_again_changes_nothing() {
    let desk = packed();
    desk.done("forest unpack area.fpack -o again.fcell");
    desk.done("forest pack again.fcell -o again.fpack");
    desk.done("forest unpack again.fpack -o third.fcell");
    assert_eq!(desk.read("again.fcell"), desk.read("third.fcell"));
    assert_eq!(desk.done("forest unpack area.fpack -o -").stdout, desk.read("again.fcell"));
}

/// Runs what must fail: exit code 2, the parts in the message, and no file that was not there before.
fn fails(desk: &Desk, arguments: &str, parts: &[&str]) {
    let before = desk.entries();
    let outcome = desk.run(arguments);
    assert_eq!(outcome.code, 2, "farop {arguments}\n{}", outcome.stderr);
    for part in parts {
        assert!(outcome.stderr.contains(part), "farop {arguments}: no `{part}` in\n{}", outcome.stderr);
    }
    assert!(!outcome.stderr.contains("panicked"), "{}", outcome.stderr);
    assert_eq!(desk.entries(), before, "farop {arguments}");
}

#[test]
fn bad_areas_leave_no_picture() {
    let desk = desk();
    let heights = "0 10 20  4 14 24  8 18 28";
    for (name, from, to, parts) in [
        ("void", heights, "- - -  - - -  - - -", &["error"][..]),
        ("short", heights, "0 10 20  4 14 24  8 18", &["short.fcell:"]),
        ("long", heights, "0 10 20  4 14 24  8 18 28 30", &["long.fcell:"]),
        ("bowtie", "4 0 0 120 0 120 240 0 240", "4 0 0 120 240 120 0 0 240", &["bowtie.fcell:12", "cross"]),
        ("dense", "dens 100", "dens 1000000000", &["dense.fcell:10"]),
        ("unknown", "ground 1", "grund 1", &["did you mean `ground`"]),
        ("cut", "hcb 6 year 2011", "hcb", &["cut.fcell:"]),
        ("tile", "cover 1 paint:grass tile 30", "demref missing.hgt", &["tile.fcell:"]),
    ] {
        let text = AREA.replace(from, to);
        assert_ne!(text, AREA, "{name}");
        desk.write(&format!("{name}.fcell"), text);
        fails(&desk, &format!("forest {name}.fcell -o picture.png --size 32x24"), parts);
    }
    desk.write("tile.asc", "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 120\n1 2 3\n4 5 6\n7");
    desk.write("grid.fcell", AREA.replace(&format!("dem 3 3 z0 400 dz 0.5  {heights}"), "demref tile.asc"));
    fails(&desk, "forest grid.fcell -o picture.png", &["tile.asc"]);
    fails(&desk, "forest pack bowtie.fcell -o bowtie.fpack", &["bowtie.fcell:12"]);
}

#[test]
fn broken_packs_are_told_and_lose_nothing_else() {
    let desk = desk();
    let other = AREA.split_once("cell 0 0 size 240").expect("a cell").1.replace("end\n", "");
    desk.write("area.fcell", AREA.replace("end\n", &format!("cell 1 0{other}end\n")));
    desk.done("forest pack area.fcell -o area.fpack");
    let whole = desk.read("area.fpack");

    // The last byte belongs to the second cell.
    let mut broken = whole.clone();
    *broken.last_mut().expect("bytes") ^= 1;
    desk.write("broken.fpack", &broken);
    let outcome = desk.run("forest broken.fpack");
    assert_eq!(outcome.code, 2);
    assert!(outcome.text().contains("1 cell of 240 m"), "the other one is told: {}", outcome.text());
    assert!(outcome.stderr.contains("cell 1 0 of `broken.fpack`"), "{}", outcome.stderr);
    fails(&desk, "forest broken.fpack -o picture.png --size 32x24", &["cell 1 0"]);
    fails(&desk, "forest broken.fpack --tour --frames film.gif --size 32x24", &["cell 1 0"]);

    desk.write("cut.fpack", &whole[..60]);
    desk.write("none.fpack", b"PNG");
    let mut later = whole.clone();
    later[8] = 9;
    desk.write("later.fpack", &later);
    fails(&desk, "forest cut.fpack", &["cut.fpack"]);
    fails(&desk, "forest none.fpack -o picture.png", &["no pack"]);
    fails(&desk, "forest later.fpack -o picture.png", &["version 9"]);
    fails(&desk, "forest missing.fpack", &["missing.fpack"]);
}

#[test]
fn contradictions_have_advice() {
    let desk = packed();
    desk.write("bad.path", "farop-path 1\n1 2 3\n");
    for (arguments, part) in [
        ("forest", "FILE"),
        ("forest area.fpack --tour", "--frames OUT"),
        ("forest area.fpack --hash", "--tour"),
        ("forest area.fpack --tour -o a.png", "--frames OUT"),
        ("forest area.fpack --tour --frames film.mp4", ".y4m"),
        ("forest area.fpack --walk 1,2 --hash", "three numbers a place"),
        ("forest area.fpack --walk 1,2,3,1,2,9 --hash", "two different places"),
        ("forest area.fpack --tour --speed 0 --hash", "--speed"),
        ("forest area.fpack --path bad.path --hash", "line 2"),
        ("forest area.fpack --path missing.path --hash", "missing.path"),
        ("forest area.fpack --at-mark Frod -o a.png", "there is \"The Hut\", \"Ford\""),
        ("forest area.fpack -o a.jpg", ".png"),
        ("forest area.fpack -o a.png -r nobody", "there is no rasterizer"),
        ("forest area.fpack --compare 2011 2026", "--output"),
        ("forest area.fpack -o a.png --tolerance 0", "tolerance"),
        ("forest area.fpack -o a.png --horizon 1e9", "horizon"),
        ("forest pack area.fpack -o b.fpack", "a pack already"),
        ("forest pack area.fcell -o b.txt", ".fpack"),
        ("forest unpack area.fcell -o b.fcell", "no pack"),
        ("forest new --hectares 0 -o b.fpack", "landscape of 0 ha"),
        ("forest new --hectares 10 -o missing/b.fpack", "there is no folder"),
    ] {
        fails(&desk, arguments, &[part]);
    }
}

/// Acceptance test 8: a recorded walk gives the same pictures whenever it is played, also led around trees.
#[test]
fn playing_a_walk_twice_gives_the_same_frames() {
    let desk = packed();
    desk.done("forest area.fpack --walk 10,10,1.7,110,230,1.7 --collide --speed 60 --rate 5 --record walk.path");
    let play = "forest area.fpack --path walk.path --hash --size 32x24";
    let first = desk.done(play).stdout;
    let lines: Vec<&[u8]> = first.split(|&byte| byte == b'\n').filter(|line| !line.is_empty()).collect();
    assert!(lines.len() > 15 && lines.iter().all(|line| line.len() == 64), "{} frames", lines.len());
    assert!(lines.windows(2).any(|pair| pair[0] != pair[1]), "something moves");
    assert_eq!(desk.done(&format!("{play} --threads 1 -r zbuffer")).stdout, first);
    // From its middle: nothing of the frames before is in a frame.
    let text = String::from_utf8(desk.read("walk.path")).expect("a path is text");
    let poses: Vec<&str> = text.lines().filter(|line| !line.starts_with(['#', 'f'])).collect();
    desk.write("late.path", format!("farop-path 1\n{}\n", poses[10..].join("\n")));
    let late = desk.done("forest area.fpack --path late.path --hash --size 32x24").stdout;
    assert_eq!(late, first[10 * 65..]);
}

#[test]
fn pictures_and_films_are_written_whole() {
    let desk = packed();
    let walk = "forest area.fpack --walk 60,20,30,120,200,30 --speed 100 --rate 4 --size 32x24";
    desk.done(&format!("{walk} --frames film.gif --labels"));
    desk.done(&format!("{walk} --frames film.y4m"));
    desk.done(&format!("{walk} --frames film"));
    let film = std::fs::File::open(desk.path("film.gif")).expect("a film");
    let decoder = image::codecs::gif::GifDecoder::new(std::io::BufReader::new(film)).expect("a GIF");
    let frames = image::AnimationDecoder::into_frames(decoder).collect_frames().expect("frames").len();
    assert!(frames > 5, "{frames}");
    assert_eq!(std::fs::read_dir(desk.path("film")).expect("a folder").count(), frames);
    assert_eq!(
        desk.read("film.y4m").len() % (6 + 3 * 32 * 24),
        "YUV4MPEG2 W32 H24 F4:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n".len()
    );
    fails(&desk, &format!("{walk} --frames film"), &["not empty"]);

    let both = desk.made("forest area.fpack --compare 2011 2026 --size 66x24", "both.png");
    let both = farop::image::decode(&both).expect("a picture");
    assert_eq!((both.width(), both.pixel(32, 12)), (66, [255; 3]), "two halves and a line");
    let half = |start: usize| (0..24 * 32).map(|at| both.pixel(start + at % 32, at / 32)).collect::<Vec<_>>();
    assert_ne!(half(0), half(34), "years differ");
    let plain = desk.made("forest area.fpack --at-mark ford --height 40 --size 64x48", "plain.png");
    let labeled = desk.made("forest area.fpack --at-mark ford --height 40 --size 64x48 --labels", "labeled.png");
    assert_ne!(plain, labeled);
    let told = desk.done(&format!("{walk} --benchmark")).text().to_string();
    assert!(told.contains("frames/s") && told.contains("overdraw") && told.contains("MB at most"), "{told}");
}

/// The share of a picture's pixels that are rather green.
fn greens(picture: &[u8]) -> f64 {
    let picture = farop::image::decode(picture).expect("a picture");
    let greens = picture.colors().filter(|[red, green, blue]| green > red && green > blue).count();
    greens as f64 / (picture.width() * picture.height()) as f64
}

/// Programs outside farop get colors and no pictures: trees arrive as outlines in their mean color.
#[test]
fn a_program_outside_draws_a_forest() {
    let desk = packed();
    let view = "forest area.fpack --at-mark ford --height 40 --heading 300 --pitch -10 --size 64x48";
    let own = desk.made(&format!("{view} -r zbuffer --trees silhouettes"), "own.png");
    let bare = desk.made(&format!("{view} -r zbuffer --trees none"), "bare.png");
    assert_ne!(own, bare, "trees are seen");
    assert!(greens(&own) > 0.1, "{}", greens(&own));
    if std::process::Command::new("python3").arg("--version").output().is_err() {
        println!("notice: there is no python3: no program outside is tried");
        return;
    }
    let program = concat!(env!("CARGO_MANIFEST_DIR"), "/student_rasterizers/other_languages/python/zbuffer.py");
    std::fs::copy(program, desk.path("mine.py")).expect("it can be copied");
    let drawn = std::process::Command::new(env!("CARGO_BIN_EXE_farop"))
        .args(view.split(' '))
        .args(["-r", "exec:python3 mine.py", "-o", "program.png"])
        .current_dir(desk.path("."))
        .output()
        .expect("farop runs");
    let said = String::from_utf8_lossy(&drawn.stderr).into_owned();
    assert!(drawn.status.success() && said.contains("silhouettes"), "{said}");
    let [own, drawn] = [own, desk.read("program.png")].map(|bytes| farop::image::decode(&bytes).expect("a picture"));
    // The program answers in 8 bits of linear light: dark levels are up to 13 apart. Its coverage is the z-buffer's.
    let far =
        own.colors().zip(drawn.colors()).filter(|(a, b)| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 14)).count();
    assert!(far < 64 * 48 / 50, "{far} pixels differ");
}
