//! What is opened is shown as in a new window, and all that shows it agrees.

use std::path::Path;

use vides_document::Selection;

use crate::files::recovery;
use crate::playing::Seen;
use crate::setup::View;
use crate::state::selected::SelectionChange;
use crate::tests::*;

/// A window in which everything stands elsewhere than at first.
fn moved_on(options: Options) -> Window {
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    window.state_mut().windows.recovery = None;
    let editor = window.state_mut();
    editor.setup.view = View {
        rotation: 40.0,
        tilt: 30.0,
        ..View::default()
    };
    editor.choose(SelectionChange::These(vec![2, 3]));
    let (_, last) = editor.document.frame_range().unwrap();
    editor.scrub((0.6 * last).round());
    editor.playing.see(Some(Seen {
        first: 5.0,
        last: 20.0,
    }));
    window.run();
    assert!(window.state().playing.frame().is_some());
    window
}

fn all_show_the_first_point(window: &mut Window, what: &str) {
    window.run();
    let editor = window.state();
    assert_eq!(editor.document.selection(), Selection::default(), "{what}");
    assert_eq!(editor.playing.frame(), None, "{what}");
    assert_eq!(editor.shown().unwrap().at, Selection::default(), "{what}");
    assert_eq!(editor.frame().unwrap(), 1.0, "{what}");
    assert_eq!(editor.setup.view, View::default(), "{what}");
    assert_eq!(editor.playing.seen, None, "{what}");
    assert!(editor.several().is_none(), "{what}");
    let count = editor.document.path().points.len();
    let text = Editor::number_of(editor.texts().position.count, 0, count);
    let all = window.query_all_by_label_contains(&text);
    assert!(all.count() > 0, "{what}: {text}");
    // A roll that is typed is that of the first point.
    let before = window.state().document.path().clone();
    let roll = window.state().texts().orientation.roll;
    enter(window, roll, "7");
    let after = window.state().document.path().clone();
    assert_eq!(after.points[0].orientations[0].roll, 7.0, "{what}");
    assert!(
        after.points.range(1..).eq(before.points.range(1..)),
        "{what}"
    );
}

fn options_in(folder: &Path) -> Options {
    Options {
        document: some_points(),
        folders: Folders {
            state: Some(folder.to_owned()),
            ..Folders::default()
        },
        ..options(Language::English)
    }
}

#[test]
fn opening_shows_the_first_point_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("film.vid");
    some_points().save(&file).unwrap();
    let lost = folder.path().join("lost");
    std::fs::create_dir(&lost).unwrap();
    let state = folder.path().join("state");
    std::fs::create_dir(&state).unwrap();
    let new = |window: &mut Window| {
        window
            .state_mut()
            .go_on(crate::state::files::AfterSave::New);
    };
    let open = |window: &mut Window| window.state_mut().load_path(&file).unwrap();
    let revert = |window: &mut Window| {
        window.state_mut().file = Some(file.clone());
        window.state_mut().reload();
    };
    let restore = |window: &mut Window| {
        let mut other = Editor::new(options_in(&lost)).unwrap();
        let step = Edit::set(At::Point(0), "name", "A".to_owned());
        other.document.apply(step).unwrap();
        drop(other);
        let found = recovery::find(&lost, None);
        window.state_mut().restore(&found[0]).unwrap();
    };
    type Opening<'a> = (&'a str, &'a dyn Fn(&mut Window));
    let all: [Opening<'_>; 4] = [
        ("new", &new),
        ("open", &open),
        ("revert", &revert),
        ("recovery", &restore),
    ];
    for (what, opening) in all {
        let mut window = moved_on(options_in(&state));
        opening(&mut window);
        all_show_the_first_point(&mut window, what);
    }
}

/// A host's path is a step in the same document: the view stays, and what is shown of it agrees.
#[test]
fn a_path_of_the_host_is_shown_at_one_place() {
    let folder = tempfile::tempdir().unwrap();
    let short = {
        let mut document = Document::new();
        let edit = Edit::FitFrames {
            first: 0,
            last: 1,
            frames: 10,
        };
        document.apply(edit).unwrap();
        document.into_parts().0
    };
    let long = some_points().into_parts().0;
    for (path, kept) in [(short, false), (long, true)] {
        let mut window = moved_on(options_in(folder.path()));
        let frame = window.state().playing.frame();
        let view = window.state().setup.view;
        let edit = Edit::ReplacePath(Box::new(path));
        window
            .state_mut()
            .change(|document| document.apply(edit))
            .unwrap();
        window.run();
        let editor = window.state();
        assert_eq!(editor.playing.frame(), frame.filter(|_| kept));
        assert_eq!(editor.setup.view, view);
        // The point whose values are shown is the one that a change is of.
        let shown = editor.shown().unwrap();
        let mark = frame
            .filter(|_| kept)
            .and_then(|frame| editor.playing.mark_before(frame));
        let point = mark.map_or(0, |mark| mark.point);
        assert_eq!(editor.document.selection().point, point);
        assert!(shown.at.point == point || kept);
    }
}
