//! Loading, saving, writing, and the question before work is lost (thesis A.5).

use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use vides_document::{At, Object, ObjectPoint};

use crate::host::warning::{Warning, Warnings};
use crate::screenshots::screenshot;
use crate::tests::*;

/// A window whose file windows begin in this folder.
pub(super) fn window_in(language: Language, folder: &Path) -> Window {
    let mut window = window(language);
    window.state_mut().last_folder = Some(folder.to_owned());
    window
}

/// Types a name over the one that is proposed and presses Enter.
pub(super) fn name(window: &mut Window, name: &str) {
    let label = window.state().texts().files.name;
    press(window, Modifiers::COMMAND, Key::A);
    window.get_by_label(label).type_text(name);
    window.run();
    press(window, Modifiers::NONE, Key::Enter);
}

pub(super) fn modified(window: &Window) -> bool {
    window.state().document.is_modified()
}

/// Why a file is refused is said in the window's language.
#[test]
fn a_broken_file_is_told_in_the_windows_language() {
    for (language, why) in [
        (
            Language::English,
            "line 3: zoom_mm: the zoom must lie between 1 and 2000",
        ),
        (
            Language::German,
            "Zeile 3: zoom_mm: der Zoom muss zwischen 1 und 2000 liegen",
        ),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("broken.vid");
        let text =
            "version = 1\n[[point]]\norientation = [{ zoom_mm = 2001 }]\nposition = [0, 0, 0]\n";
        std::fs::write(&file, text).expect("written");
        let mut window = window(language);
        let said = window.state_mut().load_path(&file).unwrap_err();
        let texts = &language.texts().errors;
        assert_eq!(said, fill(texts.cannot_load, &[&"broken.vid", &why]));
    }
}

/// So is what was wrong with a host's arguments.
#[test]
fn a_hosts_mistake_is_told_in_the_windows_language() {
    let mut warnings = Warnings::default();
    warnings.add(Warning::Misnumbered {
        place: 2,
        number: 5,
    });
    warnings.add(Warning::Speed {
        name: "move_speed",
        given: -0.5,
        taken: 100.0,
    });
    let mut window = window(Language::German);
    window.state_mut().warn(&warnings);
    window.run();
    let german = "Punkt 2 des Objekts hat die Nummer 5; es gilt die Reihenfolge im Feld; \
                  move_speed ist −0,5 und muss endlich und größer als 0 sein: genommen wird 100";
    assert_eq!(said(&window).as_deref(), Some(german));
}

#[test]
fn a_path_is_saved_and_loaded_by_the_keyboard() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let mut window = window_in(language, folder.path());
        click_button(&mut window, |texts| texts.position.add);
        press(&mut window, Modifiers::ALT, Key::S);
        name(&mut window, "flight");
        let file = folder.path().join("flight.vid");
        assert_eq!(
            said(&window),
            Some(fill(texts.output.saved, &[&"flight.vid"]))
        );
        assert!(!modified(&window));
        assert_eq!(window.state().window_title(), "VIDES – flight.vid");
        let saved = Document::load(&file).expect("a path");
        assert_eq!(saved.path(), window.state().document.path());

        let mut other = window_in(language, folder.path());
        press(&mut other, Modifiers::ALT, Key::L);
        press(&mut other, Modifiers::NONE, Key::ArrowDown);
        press(&mut other, Modifiers::NONE, Key::Enter);
        assert_eq!(
            said(&other),
            Some(fill(texts.output.loaded, &[&"flight.vid"]))
        );
        assert_eq!(other.state().document.path(), saved.path());
        assert!(!modified(&other));
    }
}

#[test]
fn a_path_is_saved_and_loaded_by_the_mouse() {
    let texts = Language::German.texts();
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window_in(Language::German, folder.path());
    click_button(&mut window, |texts| texts.position.add);
    click(&mut window, texts.menu.file);
    click(&mut window, texts.menu.save_as);
    // A name is proposed.
    click(&mut window, texts.files.save);
    assert!(folder.path().join("kurve.vid").is_file());
    click_button(&mut window, |texts| texts.position.add);
    press(&mut window, Modifiers::CTRL, Key::S);
    assert!(!modified(&window));
    click(&mut window, texts.menu.file);
    click(&mut window, texts.menu.load);
    click(&mut window, "kurve.vid");
    click(&mut window, texts.files.load);
    assert_eq!(window.state().document.path().points.len(), 4);
}

#[test]
fn the_filter_decides_what_is_seen() {
    let texts = &Language::German.texts().files;
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["a.vid", "b.txt", ".hidden.vid"] {
        std::fs::write(folder.path().join(name), "").expect("a file");
    }
    std::fs::create_dir(folder.path().join("deep")).expect("a folder");
    let mut window = window_in(Language::German, folder.path());
    press(&mut window, Modifiers::ALT, Key::L);
    let sees = |window: &Window, name: &str| window.query_by_label(name).is_some();
    assert!(sees(&window, "a.vid") && sees(&window, "deep/"));
    assert!(!sees(&window, "b.txt") && !sees(&window, ".hidden.vid"));
    click(&mut window, texts.hidden);
    assert!(sees(&window, ".hidden.vid"));
    click(&mut window, texts.filter);
    window.get_by_label(texts.patterns).click();
    window.run();
    press(&mut window, Modifiers::COMMAND, Key::A);
    window.get_by_label(texts.patterns).type_text("*.txt");
    window.run();
    assert!(sees(&window, "b.txt") && !sees(&window, "a.vid"));
}

/// By name, or the newest or the largest first; directories come before files.
#[test]
fn files_are_listed_by_name_date_or_size() {
    let texts = &Language::English.texts().files;
    let folder = tempfile::tempdir().expect("a folder");
    for (name, size, days) in [("a.vid", 20, 1), ("b.vid", 3000, 2), ("c.vid", 100, 3)] {
        let file = std::fs::File::create(folder.path().join(name)).expect("a file");
        file.set_len(size).expect("its length");
        let date = std::time::UNIX_EPOCH + std::time::Duration::from_secs(days * 86_400);
        file.set_modified(date).expect("its date");
    }
    std::fs::create_dir(folder.path().join("z")).expect("a folder");
    let mut window = window_in(Language::English, folder.path());
    press(&mut window, Modifiers::ALT, Key::L);
    for (order, expected) in [
        (texts.by_name, ["z/", "a.vid", "b.vid", "c.vid"]),
        (texts.by_date, ["z/", "c.vid", "b.vid", "a.vid"]),
        (texts.by_size, ["z/", "b.vid", "c.vid", "a.vid"]),
    ] {
        click(&mut window, order);
        let top = |name: &&str| window.get_by_label(name).rect().top();
        assert!(expected.iter().map(top).is_sorted(), "{order}");
    }
    screenshot(&mut window, "files-sorted.png");
}

#[test]
fn directories_are_walked_through() {
    let texts = &Language::German.texts().files;
    let folder = tempfile::tempdir().expect("a folder");
    let deep = folder.path().join("deep");
    std::fs::create_dir(&deep).expect("a folder");
    Document::new().save(&deep.join("x.vid")).expect("saved");
    let mut window = window_in(Language::German, folder.path());
    press(&mut window, Modifiers::ALT, Key::L);
    // Into it by the keyboard, out of it by the button, into it by its name.
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert!(window.query_by_label("x.vid").is_some());
    click(&mut window, texts.up);
    assert!(window.query_by_label("deep/").is_some());
    window.get_by_label(texts.name).click();
    window.run();
    name(&mut window, "deep");
    assert!(window.query_by_label("x.vid").is_some());
    press(&mut window, Modifiers::ALT, Key::ArrowUp);
    assert!(window.query_by_label("deep/").is_some());
    window.get_by_label(texts.name).click();
    window.run();
    name(&mut window, "deep/x.vid");
    assert_eq!(
        window.state().file.as_deref(),
        Some(deep.join("x.vid").as_path())
    );
}

#[test]
fn a_name_of_any_bytes_is_loaded() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join(OsStr::from_bytes(b"odd\xff.vid"));
    Document::new().save(&file).expect("saved");
    let mut window = window_in(Language::German, folder.path());
    press(&mut window, Modifiers::ALT, Key::L);
    press(&mut window, Modifiers::NONE, Key::ArrowDown);
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(window.state().file.as_deref(), Some(file.as_path()));
}

#[test]
fn nothing_is_overwritten_unasked() {
    for language in BOTH {
        let texts = &language.texts().files;
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("a.vid");
        std::fs::write(&file, "old").expect("a file");
        let mut window = window_in(language, folder.path());
        press(&mut window, Modifiers::ALT, Key::S);
        name(&mut window, "a.vid");
        assert!(
            window
                .query_by_label(&fill(texts.exists, &[&"a.vid"]))
                .is_some()
        );
        click(&mut window, texts.cancel);
        assert_eq!(std::fs::read(&file).expect("there"), b"old");
        click(&mut window, texts.save);
        click(&mut window, texts.overwrite);
        assert!(Document::load(&file).is_ok());
    }
}

#[test]
fn what_is_open_stays_when_loading_fails() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("broken.vid"), "version = 1\nspeed = 3\n")
            .expect("a file");
        let mut window = window_in(language, folder.path());
        press(&mut window, Modifiers::ALT, Key::L);
        name(&mut window, "broken.vid");
        let words = said(&window).expect("a message");
        let line = match language {
            Language::English => "line 2:",
            Language::German => "Zeile 2:",
        };
        let begin = fill(texts.errors.cannot_load, &[&"broken.vid", &""]);
        assert!(words.starts_with(&begin) && words.contains(line), "{words}");
        assert_eq!(window.state().file, None);
        name(&mut window, "missing.vid");
        let missing = fill(
            texts.errors.cannot_load,
            &[&"missing.vid", &texts.errors.not_found],
        );
        assert_eq!(said(&window), Some(missing));
        // The window is still there for another try.
        assert!(window.query_by_label(texts.files.load_path).is_some());
    }
}

#[test]
fn what_cannot_be_written_is_told() {
    let texts = Language::German.texts();
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window_in(Language::German, folder.path());
    click_button(&mut window, |texts| texts.position.add);
    press(&mut window, Modifiers::ALT, Key::S);
    name(&mut window, "nowhere/a.vid");
    let words = said(&window).expect("a message");
    assert_eq!(
        words,
        fill(
            texts.errors.cannot_save,
            &[&"a.vid", &texts.errors.not_found]
        )
    );
    assert!(modified(&window));
    // Where one may not write. (Root may everywhere.)
    let closed = folder.path().join("closed");
    std::fs::create_dir(&closed).expect("a folder");
    std::fs::set_permissions(&closed, std::fs::Permissions::from_mode(0o555)).expect("closed");
    if std::fs::write(closed.join("try"), "").is_err() {
        name(&mut window, "closed/a.vid");
        let words = said(&window).expect("a message");
        assert_eq!(
            words,
            fill(
                texts.errors.cannot_save,
                &[&"a.vid", &texts.errors.permission]
            )
        );
    }
}

#[test]
fn poses_are_written_as_lines_of_ten_numbers() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let mut window = window_in(language, folder.path());
        open_menu(&mut window, 2);
        let export = window.state().texts().menu.export;
        click(&mut window, export);
        click(&mut window, texts.files.write);
        let name = format!("{}.txt", texts.files.poses);
        let written = std::fs::read_to_string(folder.path().join(&name)).expect("a file");
        assert_eq!(written.lines().count(), 121);
        assert!(written.lines().all(|line| line.split(' ').count() == 10));
        assert_eq!(
            written.lines().next(),
            Some("-0.6000 0.2000 0.8000 0.0000 0.0000 -1.0000 0.0000 1.0000 0.0000 24.0000")
        );
        assert_eq!(
            said(&window),
            Some(fill(texts.output.written, &[&121, &name]))
        );
    }
}

/// By the ending, in letters of either case; what says nothing is lines, as ever.
#[test]
fn the_ending_chooses_the_format_of_poses() {
    let text = |folder: &Path, file: &str| {
        let mut window = window_in(Language::English, folder);
        open_menu(&mut window, 2);
        let export = window.state().texts().menu.export;
        click(&mut window, export);
        name(&mut window, file);
        let file = folder.join(file);
        let said = said(&window);
        std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{said:?}: {error}"))
    };
    let folder = tempfile::tempdir().expect("a folder");
    for file in ["poses.csv", "POSES.CSV"] {
        let csv = text(folder.path(), file);
        assert!(csv.starts_with("frame,vrp_x,"), "{csv:.60}");
        assert_eq!(csv.lines().count(), 122);
    }
    let json = text(folder.path(), "poses.json");
    assert!(json.starts_with("{\n  \"title\": ") && json.ends_with("]\n}\n"));
    for file in ["poses.txt", "poses.dat", "csv.d"] {
        assert_eq!(text(folder.path(), file).lines().count(), 121, "{file}");
    }
}

#[test]
fn the_file_window_offers_all_formats_of_poses() {
    for language in BOTH {
        let texts = &language.texts().files;
        let folder = tempfile::tempdir().expect("a folder");
        for file in ["a.txt", "b.csv", "c.json", "d.vid"] {
            std::fs::write(folder.path().join(file), "").expect("a file");
        }
        let mut window = window_in(language, folder.path());
        open_menu(&mut window, 2);
        let export = window.state().texts().menu.export;
        click(&mut window, export);
        for (file, seen) in [
            ("a.txt", true),
            ("b.csv", true),
            ("c.json", true),
            ("d.vid", false),
        ] {
            assert_eq!(window.query_by_label(file).is_some(), seen, "{file}");
        }
        let shown = |window: &Window| {
            let button = window.get_by_role_and_label(Role::ComboBox, texts.format);
            button.value().expect("a format")
        };
        assert_eq!(shown(&window), "ASCII");
        let place = |window: &Window| window.get_by_label(texts.name).value();
        for (format, entry, ending) in [
            ("CSV", "CSV (*.csv)", "csv"),
            ("JSON", "JSON (*.json)", "json"),
            ("ASCII", "ASCII (*.txt)", "txt"),
            ("TUM", "TUM (*.tum)", "tum"),
        ] {
            window
                .get_by_role_and_label(Role::ComboBox, texts.format)
                .click();
            window.run();
            // In a low window the list scrolls.
            window.get_by_label(entry).scroll_to_me();
            window.run();
            click(&mut window, entry);
            assert_eq!(shown(&window), format);
            let name = format!("{}.{ending}", texts.poses);
            assert_eq!(place(&window).as_deref(), Some(&*name));
        }
        window.get_by_label(texts.name).click();
        name(&mut window, "my.flight.csv");
        let file = folder.path().join("my.flight.csv");
        let csv = std::fs::read_to_string(file).expect("a file");
        assert!(csv.starts_with("frame,"));
    }
}

#[test]
fn the_hosts_speeds_and_object_stand() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.vid");
    Document::new().save(&file).expect("saved");
    let mut hosts = Document::new();
    let mut speeds = hosts.path().base_frames;
    speeds.movement = 7.0;
    hosts
        .apply(Edit::set(At::Path, "base_speeds", speeds))
        .expect("possible");
    let mut info = hosts.info().clone();
    let point = ObjectPoint {
        position: DVec3::ONE,
        draw: false,
    };
    info.object = Object::from(vec![point]);
    hosts
        .apply(Edit::SetInfo(Box::new(info)))
        .expect("possible");
    hosts.mark_saved();
    let options = Options {
        document: hosts,
        fixed_speeds: true,
        ..options(Language::German)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    window.state_mut().load_path(&file).expect("loaded");
    window.run();
    let document = &window.state().document;
    assert_eq!(document.path().base_frames.movement, 7.0);
    assert_eq!(document.info().object.len(), 1);
    assert!(!document.is_modified() && !document.can_undo());
}

/// As two programs do: whoever looks finds a whole path, in the end one of the two.
#[test]
fn two_windows_that_save_to_one_file_leave_it_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("both.vid");
    Document::new().save(&file).expect("a file");
    let work = |step: &str| {
        let mut options = options(Language::English);
        options.document = Document::load(&file).expect("a path");
        options.file = Some(file.clone());
        let mut window = window_of(options, [1200.0, 800.0], 1.0, Theme::Dark);
        let texts = Language::English.texts();
        for _ in 0..20 {
            click(&mut window, step);
            press(&mut window, Modifiers::CTRL, Key::S);
            if window.query_by_label(texts.questions.changed).is_some() {
                click(&mut window, texts.files.overwrite);
            }
            assert!(!modified(&window), "{:?}", said(&window));
        }
        window.state().document.to_toml().expect("a text")
    };
    let texts = std::thread::scope(|scope| {
        let both = [
            Language::English.texts().position.add,
            Language::English.texts().orientation.add,
        ]
        .map(|step| scope.spawn(move || work(step)));
        while !both.iter().all(|window| window.is_finished()) {
            Document::load(&file).expect("a whole path");
        }
        both.map(|window| window.join().expect("a window"))
    });
    assert_ne!(texts[0], texts[1]);
    let left = std::fs::read_to_string(&file).expect("a text");
    assert!(texts.contains(&left));
    let names = std::fs::read_dir(folder.path()).expect("a folder");
    assert_eq!(names.count(), 1);
}

/// A scene in which nothing moves on a path is no broken file.
#[test]
fn a_scene_without_a_path_has_a_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    std::fs::copy(examples.join("car.vid"), folder.path().join("car.vid")).expect("copied");
    std::fs::write(folder.path().join("broken.vid"), "version = ").expect("written");
    for language in BOTH {
        let texts = &language.texts().recovery;
        let mut window = window_in(language, folder.path());
        press(&mut window, Modifiers::ALT, Key::L);
        click(&mut window, "broken.vid");
        assert!(window.query_by_label(texts.unreadable).is_some());
        click(&mut window, "car.vid");
        assert!(window.query_by_label(texts.unreadable).is_none());
        let picture = window.get_by_label(texts.scene).rect();
        crate::screenshots::screenshot(&mut window, &format!("files-scene-{language:?}.png"));
        let colour = window
            .state()
            .setup
            .colours()
            .of(crate::setup::Element::Object);
        let lines = window.output().shapes.iter().filter(|clipped| {
            matches!(&clipped.shape, egui::Shape::LineSegment { points, stroke }
                if stroke.color == colour && picture.contains(points[0]))
        });
        assert!(lines.count() > 20);
    }
}
