//! What reading a file takes, counted, against what its reader counts.

#[path = "common/counting.rs"]
mod counting;

use counting::cost;
use glam::DVec3;
use vides::document::vid::table;
use vides::document::{Document, Error, Info, ObjectPoint};
use vides::limits::{MAX_OBJECT_POINTS, MAX_TREE_BYTES};
use vides::path::CameraPath;

/// Bytes that the reader asks for before it takes them, for as long as it asks.
const GRANT: usize = 80 << 10;

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
fn what_takes_more_than_it_may_is_refused() {
    let (mut closest, mut refused) = (0.0f64, 0);
    // Lists double: just after that they are at their worst.
    for n in [1000, 8193, 16385] {
        for (kind, text) in dear(n) {
            let mut answer = Ok(());
            let taken = cost(|| answer = table(&text, MAX_TREE_BYTES).map(drop)).peak;
            if answer.is_err() {
                assert!(taken < 1200 * text.len() + 2 * GRANT, "{n} {kind}: {taken}");
                continue;
            }
            // A list that grows is copied by this allocator; the system's moves its pages.
            let less = (taken * 2 / 3).saturating_sub(GRANT);
            let told = (0..64).map(|part| less + part * less / 8);
            let mut enough = told.filter(|&most| table(&text, most).is_ok());
            let enough = enough.next().unwrap_or(usize::MAX);
            let line = matches!(table(&text, less), Err(Error::PieceTooLarge(1)));
            assert!(less == 0 || line, "{n} {kind}: {taken} bytes taken");
            refused += usize::from(line);
            closest = closest.max(less as f64 / enough as f64);
        }
    }
    println!("closest: {closest:.2}");
    assert!(refused > 40, "{refused} refused");
}

/// The largest object can be read again, even if each number takes its 24 characters: else it would
/// not be written.
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
    assert!(document.to_toml().is_ok());
}
