use super::*;

/// However it was made.
impl PartialEq for Table<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.entries == other.entries
    }
}

/// Texts with all that is written plainly, and with what is not.
const TEXTS: [&str; 5] = [
    "version = 1 # one\ntitle = \"Zwölf\"\nclosed = true\n\n[base_speeds]\nmove_frames = 100.0\n\n\
     [[point]]\nposition = [-0.6, 0.2,\n  0.8e-3, ] # here\nown = { tension = 0.2, bias = -1 }\n\
     [[point.orientation]]\nspeed_curve = [1, 2.5, [3]]\n[[point.orientation]]\nroll = 0\n\
     [[point]]\n[point.up.deep]\nway = [[0.1, 1E+2], [2, 3]]\n",
    "a = \"b\\\"c\\\\d\\te\\u00e9\"\nf = \"\"\"\ng \"h\"\n\\\"\\\"i\\r\\u202E\"\"\"\nj = \"\"\n",
    "[a]\nb = 1\n[a.c]\n[[a.d]]\n[[a.d.e]]\n[[a.d]]\nf = [{ g = 1 }]\n",
    "a.b = 1\ni = 1\r\n'c' = 0x1f\nd = 1_000\ne = 1979-05-27\nf = inf\ng = '''\n'''\nh = \"\\e\"\n",
    "x = 99999999999999999999\ny = 1e999\nz = -0.0\nw = -0\nv = 00\n[[x]]\n[z]\n",
];

fn read(text: &str) -> Option<Table<'_>> {
    match super::read(text, usize::MAX) {
        Reading::Plain(table) => Some(table),
        _ => None,
    }
}

fn parsed(text: &str) -> Option<Table<'_>> {
    let table = DeTable::parse(text).ok()?;
    Some(table.into_inner().into())
}

#[test]
fn what_is_written_plainly_needs_no_parser() {
    for text in &TEXTS[..3] {
        assert_eq!(read(text), parsed(text));
        assert!(read(text).is_some());
    }
}

#[test]
fn many_keys_and_deep_arrays_are_left_to_the_parser() {
    let keys = |count| {
        (0..count)
            .map(|k| format!("k{k} = 1\n"))
            .collect::<String>()
    };
    let deep = |count| format!("a = {}{}", "[".repeat(count), "]".repeat(count));
    assert!(read(&keys(64)).is_some() && read(&keys(65)).is_none());
    assert!(read(&deep(8)).is_some() && read(&deep(9)).is_none());
}

/// Whatever is broken at random: what is read here the parser reads too, and as the same.
#[test]
fn the_parser_agrees_about_everything_that_is_read() {
    let mut state = 1u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1);
        (state >> 33) as usize % n
    };
    let (mut read_here, mut tried) = (0, 0);
    let pieces = b"[]{}=.,\"'#\n\r\t -+_eE019atx\\\x7f";
    while tried < 200_000 {
        let mut text = TEXTS[below(TEXTS.len())].as_bytes().to_vec();
        for _ in 0..=below(4) {
            let at = below(text.len());
            match below(4) {
                0 => drop(text.remove(at)),
                1 => text[at] = pieces[below(pieces.len())],
                2 => text.insert(at, pieces[below(pieces.len())]),
                _ => {
                    let to = (at + below(40)).min(text.len());
                    let part = text[at..to].to_vec();
                    let into = below(text.len());
                    text.splice(into..into, part);
                }
            }
        }
        let Ok(text) = String::from_utf8(text) else {
            continue;
        };
        tried += 1;
        if let Some(table) = read(&text) {
            read_here += 1;
            assert_eq!(Some(table), parsed(&text), "{text}");
        }
    }
    assert!(read_here > 5_000, "{read_here}");
}

/// Whatever we write as a text is read without the parser.
#[test]
fn every_text_that_is_written_is_plain() {
    for text in [
        "",
        "a",
        "\"",
        "\"\"\"",
        "a\nb",
        "\n",
        "\"\n\"",
        "\\\t\r\u{1}\u{202e}ü\u{10ffff}",
        "a\n\"\"\"\"\n\t",
    ] {
        let file = format!("a = {}\n", crate::vid::quoted(text));
        let table = read(&file).expect(&file);
        assert_eq!(table.entries[0].1.1, Value::Text(text.into()), "{file}");
        assert_eq!(Some(table), parsed(&file));
    }
}

#[test]
fn memory_is_counted_and_bounded() {
    let rows = "[1, 2, 3], ".repeat(1000);
    let text = format!("a = [{rows}]\nb = \"c\"\n");
    let all = 1000 * (3 * size_of::<Placed<'_>>() + ALLOCATION + ELEMENT);
    for (most, dear) in [(all / 2, true), (2 * all, false)] {
        assert_eq!(matches!(super::read(&text, most), Reading::Dear), dear);
        assert_eq!(fits(&text, most), !dear);
    }
    // What is not written plainly is not called dear.
    assert!(matches!(super::read("a = 'b'", 1 << 20), Reading::Other));
}
