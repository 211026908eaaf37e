//! What parsing takes, counted, against what is told from the text beforehand
//! (`crates/document/src/vid/weight.rs`, compiled here as a module of its own, since
//! it is no part of the crate's interface).

#[path = "common/counting.rs"]
mod counting;
#[path = "../crates/document/src/vid/weight.rs"]
mod weight;

use counting::cost;
use glam::DVec3;
use toml::de::DeTable;
use vides::document::{Document, Info, ObjectPoint};
use vides::limits::{MAX_OBJECT_POINTS, MAX_PARSE_BYTES};
use vides::path::CameraPath;

/// Texts with `n` of something, each kind as dear for its size as can be.
fn dear(n: usize) -> Vec<(&'static str, String)> {
    let deep = "a.".repeat(70);
    let each = |line: &dyn Fn(usize) -> String| (0..n).map(line).collect::<String>();
    let few = |line: &dyn Fn(usize) -> String| (0..n / 70 + 1).map(line).collect::<String>();
    let nested = format!("{}{},", "[".repeat(70), "]".repeat(70));
    vec![
        ("line ends", "\n".repeat(n)),
        ("blanks", " \t".repeat(n)),
        ("comments", "#\n".repeat(n)),
        ("closing brackets", "]".repeat(n)),
        ("equals signs", " = ".repeat(n)),
        ("quotes", "\"\"".repeat(n)),
        ("numbers", format!("a=[{}]", "1,".repeat(n))),
        ("points", format!("a=[{}]", "[0.1, -0.25, 1e9], ".repeat(n))),
        ("texts", format!("a=[{}]", "'',".repeat(n))),
        ("empty arrays", format!("a=[{}]", "[],".repeat(n))),
        (
            "nested arrays",
            format!("a=[{}]", nested.repeat(n / 70 + 1)),
        ),
        ("empty tables", format!("a=[{}]", "{},".repeat(n))),
        ("tables", format!("a=[{}]", "{a=1},".repeat(n))),
        (
            "tables of three",
            format!("a=[{}]", "{a=1,b=2,c=3},".repeat(n)),
        ),
        ("dotted tables", format!("a=[{}]", "{a.b.c=1},".repeat(n))),
        ("numbers as names", format!("a=[{}]", "{1.1=1},".repeat(n))),
        ("keys", each(&|i| format!("{i:x}=1\n"))),
        ("two-part keys", each(&|i| format!("{i}.1=1\n"))),
        ("spaced keys", each(&|i| format!("{i} . 1 . 1=1\n"))),
        ("quoted keys", each(&|i| format!("\"{i}\".\"\".''=1\n"))),
        ("deep keys", few(&|i| format!("b{i}.{deep}a=1\n"))),
        (
            "deep numbers",
            few(&|i| format!("{i}.{}1=1\n", "1.".repeat(70))),
        ),
        ("a key too deep", format!("{}a=1", "a.".repeat(n))),
        ("headers", each(&|i| format!("[{i:x}]\n"))),
        ("two-part headers", each(&|i| format!("[{i}.1]\n"))),
        ("commented headers", each(&|i| format!("[{i}.1]#\n"))),
        ("deep headers", each(&|i| format!("[{i}.1.1.1.1.1]\n"))),
        ("points of a path", "[[point]]\n".repeat(n)),
        ("arrays of tables", each(&|i| format!("[[{i}.1]]\n"))),
        ("arrays within", "[[a.b]]\n".repeat(n)),
        ("escapes", format!("a=\"{}\"", "\\n".repeat(n))),
    ]
}

#[test]
fn parsing_takes_no_more_than_was_told() {
    let mut closest = 0.0f64;
    // Lists double: just after that they are at their worst.
    for n in [1, 2, 5, 11, 12, 100, 1000, 4097, 8193, 16385] {
        for (kind, text) in dear(n) {
            let taken = cost(|| drop(DeTable::parse(&text))).peak;
            let told = weight::memory(&text);
            assert!(
                taken <= told,
                "{n} {kind}: {taken} bytes taken for {}, {told} told",
                text.len()
            );
            if n == 16385 {
                let share = taken as f64 / told as f64;
                println!(
                    "{kind}: {} bytes, {taken} taken, {share:.2} of what was told",
                    text.len()
                );
                closest = closest.max(share);
            }
        }
    }
    println!("closest: {closest:.2}");
}

/// Files that could take many gigabytes are refused at once, with their line.
#[test]
fn dear_texts_are_refused_before_they_fill_the_memory() {
    let mut refused = 0;
    for (kind, text) in dear(600_000) {
        let text = format!("version = 1\n{text}");
        // Points are read piece by piece.
        if weight::memory(&text) <= MAX_PARSE_BYTES || text.contains("\n[[point]]") {
            continue;
        }
        let mut answer = String::new();
        let peak = cost(|| {
            answer = Document::from_toml(&text).unwrap_err().to_string();
        })
        .peak;
        // What is written as we write it takes far less than the parser would for it.
        if answer.contains("unknown key") {
            assert!(
                peak < 120 * text.len(),
                "{kind}: {peak} bytes for {}",
                text.len()
            );
            continue;
        }
        assert_eq!(
            answer,
            "line 1: what begins here could take more than 2048 MiB of memory to be read"
        );
        assert!(peak < 1 << 20, "{kind}: {peak} bytes");
        refused += 1;
    }
    assert!(refused > 5, "{refused} refused");
}

/// The largest object is not among them, even if each number takes its 24
/// characters.
#[test]
fn the_largest_object_can_be_read() {
    let draw = ObjectPoint {
        position: DVec3::splat(-1.234_567_890_123_456_7e-300),
        draw: true,
    };
    let info = Info {
        object: vec![draw; MAX_OBJECT_POINTS].into(),
        ..Info::default()
    };
    let document = Document::from_parts(CameraPath::default(), info).unwrap();
    let told = weight::memory(&document.to_toml().unwrap());
    println!("{told} bytes told");
    assert!(told <= MAX_PARSE_BYTES, "{told}");
}
