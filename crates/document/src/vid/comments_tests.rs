use super::*;
use crate::{At, Document, Edit, Selection};

const FILE: &str = "\
# The flight over the lake.

# By Ada.
version = 1 # the only one
title = \"no # comment\" # a title
closed = true
# too fast?
fps = 50

# Slow.
[base_speeds] # frames
move_frames = 200 # a way
[presets]
3 = { tension = 0.5 } # tight
# The first point.
[[point]]
# Over the shore.
position = [ # x
  0.1, 0.2, # and y
  0.3 ]
name = 'it is \"#1\"'
preset = 3 # the tight one
# Looks at the boat.
[[point.orientation]]
target = [0, 0, 0] # the boat
[[point.orientation]] # then the sun
roll_degrees = 0
hold_frames = 0 # no hold

# The second point.
[[point]]
position = [1, 0, 0] # two
[[point]]
position = [1, 1, 0] # three
# The end.
";

fn loaded() -> Document {
    Document::from_toml(FILE).unwrap()
}

fn saved(document: &Document) -> String {
    document.to_toml().unwrap()
}

/// Those of `all` that are in the text, in its order: the comment, and the line that it
/// stands before or on, blanks left out.
fn comments(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut waiting: Vec<String> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty()) {
        if line.starts_with('#') {
            waiting.push(line.to_owned());
            continue;
        }
        // No text of this file has a `# ` in it but the title.
        let (words, behind) = match line.rsplit_once(" # ") {
            Some((words, behind)) if !behind.starts_with("comment") => (words, Some(behind)),
            _ => (line, None),
        };
        let behind = behind.map(|behind| format!("# {behind}"));
        let all = waiting.drain(..).chain(behind);
        found.extend(all.map(|comment| (comment, words.to_owned())));
    }
    found.extend(waiting.into_iter().map(|comment| (comment, String::new())));
    found.retain(|(comment, _)| !OURS.contains(&&**comment));
    found
}

fn has(text: &str, comment: &str, stands_at: &str) {
    let all = comments(text);
    let found = all.iter().find(|(known, _)| known == comment);
    let at = found.map(|(_, at)| at.as_str());
    assert_eq!(at, Some(stands_at), "{comment} in\n{text}");
}

#[test]
fn every_comment_stays_at_what_it_stood_at() {
    let text = saved(&loaded());
    for (comment, at) in [
        ("# The flight over the lake.", "version = 1"),
        ("# By Ada.", "version = 1"),
        ("# the only one", "version = 1"),
        ("# a title", "title = \"no # comment\""),
        ("# too fast?", "fps = 50.0"),
        ("# Slow.", "[base_speeds]"),
        ("# frames", "[base_speeds]"),
        ("# a way", "move_frames = 200.0"),
        (
            "# tight",
            "3 = { tension = 0.5, continuity = 0.0, bias = 0.0 }",
        ),
        ("# The first point.", "[[point]]"),
        ("# Over the shore.", "position = [0.1, 0.2, 0.3]"),
        ("# x", "position = [0.1, 0.2, 0.3]"),
        ("# and y", "position = [0.1, 0.2, 0.3]"),
        ("# the tight one", "preset = 3"),
        ("# Looks at the boat.", "[[point.orientation]]"),
        ("# the boat", "target = [0.0, 0.0, 0.0]"),
        // Its key is not written: it goes to its table.
        ("# no hold", "[[point.orientation]]"),
        ("# then the sun", "[[point.orientation]]"),
        ("# two", "position = [1.0, 0.0, 0.0]"),
        ("# three", "position = [1.0, 1.0, 0.0]"),
        ("# The end.", ""),
    ] {
        has(&text, comment, at);
    }
    assert_eq!(comments(&text).len(), FILE.matches("# ").count() - 1);
    // The empty line too, by which it is no comment of the version's.
    assert!(text.starts_with("# The flight over the lake.\n\n# By Ada.\nversion = 1 # "));
    // Nothing else differs, and nothing more happens the next time.
    let again = Document::from_toml(&text).unwrap();
    assert_eq!(again.path(), loaded().path());
    assert_eq!(saved(&again), text);
    let copy = again.try_clone().unwrap().as_opened();
    assert_eq!(saved(&copy), text);
}

#[test]
fn they_go_with_their_points_and_come_back_with_them() {
    let mut document = loaded();
    let whole = saved(&document);
    let moved = Edit::set(At::Point(1), "position", glam::DVec3::new(0.5, 0.0, 0.0));
    let divided = Edit::DivideSegment {
        segment: 0,
        points: 3,
    };
    let removed = Edit::RemovePoint { at: 0 };
    for edit in [divided, removed.clone(), moved, removed] {
        document.apply(edit).unwrap();
    }
    document.select(0, 0).unwrap();
    let text = saved(&document);
    has(&text, "# three", "position = [1.0, 1.0, 0.0]");
    has(&text, "# two", "position = [1.0, 0.0, 0.0]");
    for gone in ["# The first point.", "# the boat", "# Over the shore."] {
        assert!(!text.contains(gone), "{gone} in\n{text}");
    }
    // And those of the file stay whatever becomes of its points.
    has(&text, "# The end.", "");
    let back: Vec<Selection> =
        std::iter::from_fn(|| document.undo().then(|| document.selection())).collect();
    assert_eq!(back.len(), 4);
    assert_eq!(saved(&document), whole);
    while document.redo() {}
    assert_eq!(saved(&document), text);
}

#[test]
fn they_go_with_points_that_get_other_numbers() {
    let mut document = loaded();
    let whole = saved(&document);
    document.apply(Edit::MovePoint { from: 0, to: 2 }).unwrap();
    assert_eq!(document.selection(), Selection::at(2, 0));
    let text = saved(&document);
    has(&text, "# The second point.", "[[point]]");
    has(&text, "# Over the shore.", "position = [0.1, 0.2, 0.3]");
    has(&text, "# the boat", "target = [0.0, 0.0, 0.0]");
    let [second, first] = ["# The second", "# The first"].map(|words| text.find(words));
    assert!(second.is_some() && second < first, "{text}");
    assert!(document.undo());
    assert_eq!(saved(&document), whole);
    assert!(document.redo());
    assert_eq!(saved(&document), text);
}

#[test]
fn they_go_with_their_orientations_too() {
    let mut document = loaded();
    let whole = saved(&document);
    let edit = Edit::InsertOrientation {
        point: 0,
        at: 0,
        orientation: None,
    };
    document.apply(edit).unwrap();
    document
        .apply(Edit::SetAbsolute {
            point: 0,
            at: 1,
            absolute: false,
        })
        .unwrap();
    let text = saved(&document);
    assert!(
        text.contains("offset = [-0.1, -0.2, -0.3] # the boat"),
        "{text}"
    );
    document
        .apply(Edit::RemoveOrientation { point: 0, at: 1 })
        .unwrap();
    let text = saved(&document);
    assert!(
        !text.contains("the boat") && text.contains("the sun"),
        "{text}"
    );
    while document.undo() {}
    assert_eq!(saved(&document), whole);
}

#[test]
fn another_path_has_not_got_them() {
    let mut document = loaded();
    let whole = saved(&document);
    let (other, _) = Document::new().into_parts();
    document.apply(Edit::ReplacePath(Box::new(other))).unwrap();
    let text = saved(&document);
    assert!(
        !text.contains("point.\n") && text.contains("# By Ada."),
        "{text}"
    );
    assert!(document.undo());
    assert_eq!(saved(&document), whole);
    assert!(document.redo());
    assert_eq!(saved(&document), text);
}

/// How many comments there are that are not ours, a line each.
fn comments_in(text: &str) -> usize {
    let mut count = 0;
    statements(text, |statement| {
        let lines = kept(statement.before) + &statement.within;
        count += lines.lines().filter(|line| !line.is_empty()).count();
        count += usize::from(!statement.behind.is_empty());
    });
    count
}

/// However odd: the file says the same, and each comment is in it once.
#[test]
fn any_way_of_writing_keeps_them() {
    for (text, wanted) in [
        (
            "version = 1\r\n# a\r\n[[point]]\r\nposition=[0,0,0]# b\r\n[[point]]\r\nposition=[1,0,0]",
            2,
        ),
        (
            "\u{feff}# a\nversion=1\n\"comment\" = '''x # no\n''' # b\npoint=[{position=[0,0,0]}, # c\n{position=[1,1,1]}]#d",
            4,
        ),
        (
            "version=1\nbase_speeds.move_frames=3 # a\n[ space ] # b\n [[ point ]]#c\nposition=[0,0,0]\n[[point]]\nposition=[1,0,0]\n#e",
            4,
        ),
        (
            "version=1 # \"a\ncomment=\"\"\"\n# no \\\"\"\" # nor\"\"\"\"\" # b\n[[point]]\nposition=[0,0,0]\n[[point]]\nposition=[1,0,0]\n[presets]\n# c\n",
            3,
        ),
    ] {
        let first = Document::from_toml(text).unwrap();
        let text = saved(&first);
        let found = comments_in(&text);
        assert_eq!(found, wanted, "{text}");
        let again = Document::from_toml(&text).unwrap_or_else(|error| panic!("{error} in\n{text}"));
        assert_eq!((again.path(), again.info()), (first.path(), first.info()));
        assert_eq!(saved(&again), text);
    }
}
