use std::io::{BufRead, BufReader};
use std::os::unix::fs::{PermissionsExt, chown};
use std::process::{Child, Command, Stdio};
use std::time::Instant;

use glam::DVec3;
use vides_document::{At, Edit};

use super::*;
use crate::files::folders::Folders;
use crate::host::program::Program;
use crate::state::{Editor, Options};
use crate::tests::{started, work_folder};
use crate::texts::Language;

fn document() -> Document {
    Document::new()
}

fn change(document: &mut Document, x: f64) {
    let position = DVec3::new(x, 0.0, 0.5);
    document
        .apply(Edit::set(At::Point(0), "position", position))
        .unwrap();
}

fn x_of(document: &Document) -> f64 {
    document.path().points[0].position.x
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).map(|all| {
        let names = all.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.collect()
    });
    entries.unwrap_or_default()
}

#[test]
fn a_change_is_written_within_a_second_and_no_sooner_asked_again() {
    let folder = work_folder();
    let state = folder.path().join("deep/state");
    let mut document = document();
    let mut autosave = Autosave::new(&state, &document);
    let at = Duration::from_millis;
    assert!(matches!(
        autosave.look_after(&document, document.is_modified(), &Origin::default(), at(0)),
        Saved::Idle
    ));
    change(&mut document, 0.1);
    let Saved::In(wait) = autosave.look_after(
        &document,
        document.is_modified(),
        &Origin::default(),
        at(100),
    ) else {
        panic!("a change is to be looked after");
    };
    assert_eq!(wait, DELAY);
    assert!(names(&state).is_empty());
    // Further changes do not put it off.
    change(&mut document, 0.2);
    assert!(matches!(
        autosave.look_after(
            &document,
            document.is_modified(),
            &Origin::default(),
            at(600)
        ),
        Saved::In(_)
    ));
    change(&mut document, 0.3);
    assert!(matches!(
        autosave.look_after(
            &document,
            document.is_modified(),
            &Origin::default(),
            at(800)
        ),
        Saved::Idle
    ));
    assert_eq!(names(&state).len(), 1);
    // Nothing new: nothing to wake up for.
    assert!(matches!(
        autosave.look_after(
            &document,
            document.is_modified(),
            &Origin::default(),
            at(900)
        ),
        Saved::Idle
    ));
    drop(autosave);
    let found = find(&state, None);
    assert_eq!(found.len(), 1);
    assert_eq!(x_of(&found[0].document().unwrap()), 0.3);
}

#[test]
fn saving_and_undoing_to_the_saved_state_remove_it() {
    let folder = work_folder();
    let mut document = document();
    let mut autosave = Autosave::new(folder.path(), &document);
    for way in [Document::mark_saved as fn(&mut Document), |document| {
        document.undo();
    }] {
        change(&mut document, 0.4);
        autosave.write(&document, &Origin::default()).unwrap();
        assert_eq!(names(folder.path()).len(), 1);
        way(&mut document);
        autosave.look_after(
            &document,
            document.is_modified(),
            &Origin::default(),
            Duration::ZERO,
        );
        assert_eq!(names(folder.path()), [""; 0]);
        change(&mut document, 0.5);
        document.mark_saved();
    }
}

#[test]
fn what_lives_is_offered_to_nobody() {
    let folder = work_folder();
    let mut document = document();
    change(&mut document, 0.25);
    let file = Path::new("/tmp/näher 100%\n.vid");
    let mut first = Autosave::new(folder.path(), &document);
    first
        .write(
            &document,
            &Origin {
                file: Some(file),
                ..Origin::default()
            },
        )
        .unwrap();
    let mut second = Autosave::new(folder.path(), &document);
    second.write(&document, &Origin::default()).unwrap();
    assert_eq!(names(folder.path()).len(), 2);
    assert!(find(folder.path(), None).is_empty());
    // Also not after it was written anew.
    first
        .write(
            &document,
            &Origin {
                file: Some(file),
                ..Origin::default()
            },
        )
        .unwrap();
    assert!(find(folder.path(), None).is_empty());
    drop(first);
    let found = find(folder.path(), None);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].original.as_deref(), Some(file));
    assert!(found[0].document().unwrap().is_modified());
    // Whoever found it holds it.
    assert!(find(folder.path(), None).is_empty());
    drop(found);
    find(folder.path(), None).pop().unwrap().discard();
    assert_eq!(names(folder.path()).len(), 1, "the other one lives");
}

#[test]
fn paths_survive_as_one_line() {
    use std::ffi::OsStr;
    for bytes in [
        &b"/a/b.vid"[..],
        b"/\xff\xfe",
        b"/a b%20\n\t\x7f",
        "/ä→".as_bytes(),
    ] {
        let path = Path::new(OsStr::from_bytes(bytes));
        let text = escaped(path);
        assert_eq!(text.lines().count(), 1);
        assert_eq!(unescaped(&text).as_deref(), Some(path));
    }
    for broken in ["", "%", "%4", "%zz", "%00", "a%"] {
        assert_eq!(unescaped(broken), None, "{broken}");
    }
}

#[test]
fn odd_things_in_the_folder_do_no_harm() {
    let folder = work_folder();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("unsaved-1-1-1.vid.new"), "half").unwrap();
    fs::write(at("unsaved-2-2-2.vid"), "no path at all").unwrap();
    fs::write(at("unsaved-3-3-3.vid"), b"\xff\xfe").unwrap();
    fs::create_dir(at("unsaved-4-4-4.vid")).unwrap();
    std::os::unix::fs::symlink("/etc/passwd", at("unsaved-5-5-5.vid")).unwrap();
    fs::write(at("recent"), "other").unwrap();
    let found = find(folder.path(), None);
    assert_eq!(found.len(), 1);
    assert!(found[0].document().is_err());
    assert!(
        !at("unsaved-1-1-1.vid.new").exists(),
        "left by a dead process"
    );
    assert!(at("recent").exists() && at("unsaved-3-3-3.vid").exists());
    assert!(find(Path::new("/nowhere/at all"), None).is_empty());
}

#[test]
fn where_nothing_can_be_written_it_is_said_once() {
    let mut document = document();
    let mut autosave = Autosave::new(Path::new("/proc/vides"), &document);
    let mut failures = 0;
    for k in 1u32..5 {
        change(&mut document, f64::from(k) / 10.0);
        for ms in [0, 800] {
            let now = Duration::from_secs(k.into()) + Duration::from_millis(ms);
            if let Saved::Failed(error) =
                autosave.look_after(&document, document.is_modified(), &Origin::default(), now)
            {
                assert!(error.to_string().starts_with("/proc/vides: "), "{error}");
                failures += 1;
            }
        }
    }
    assert_eq!(failures, 1);
}

fn editor(folder: &Path) -> Editor {
    let options = Options {
        document: document(),
        file: None,
        title: None,
        language: Some(Language::English),
        host_takes_poses: false,
        fixed_speeds: false,
        folders: Folders {
            state: Some(folder.to_owned()),
            ..Folders::default()
        },
        program: Program::of_tests("tests"),
        host_view: crate::HostView::default(),
    };
    Editor::new(options).unwrap()
}

/// The X server goes away: the editor is dropped in the middle of work.
#[test]
fn a_window_that_vanishes_leaves_its_work() {
    let folder = work_folder();
    let mut vanished = editor(folder.path());
    change(vanished.document_mut(), 0.125);
    drop(vanished);
    let found = find(folder.path(), None);
    assert_eq!(x_of(&found[0].document().unwrap()), 0.125);
    drop(found);
    // One that was asked to close, or that its host has kept, leaves nothing.
    for answered in [true, false] {
        let folder = work_folder();
        let mut closed = editor(folder.path());
        change(closed.document_mut(), 0.5);
        closed
            .autosave
            .as_mut()
            .unwrap()
            .write(&closed.document, &Origin::default())
            .unwrap();
        if answered {
            closed.requests.push(crate::Request::Close);
            assert!(closed.next_request().is_some());
        } else {
            closed.mark_saved();
        }
        drop(closed);
        assert_eq!(names(folder.path()), [""; 0]);
    }
    // Unmodified: nothing either.
    let folder = work_folder();
    drop(editor(folder.path()));
    assert_eq!(names(folder.path()), [""; 0]);
}

/// Names the folder in which [`a_process_at_work`] works.
const AT_WORK: &str = "VIDES_RECOVERY_AT_WORK";

/// A process of its own, in [`killed_at_any_moment`]: edits without end and
/// tells what it does. Elsewhere there is nothing for it to do.
#[test]
fn a_process_at_work() {
    let Some(folder) = std::env::var_os(AT_WORK) else {
        return;
    };
    let mut editor = editor(Path::new(&folder));
    editor.windows.recovery = None;
    let context = egui::Context::default();
    editor.prepare(&context);
    let start = Instant::now();
    let out = std::io::stdout();
    for number in 1u32.. {
        change(editor.document_mut(), f64::from(number) / 1e6);
        let began = start.elapsed().as_micros();
        let input = egui::RawInput {
            time: Some(start.elapsed().as_secs_f64()),
            ..egui::RawInput::default()
        };
        context
            .run_ui(input, |ui| editor.show(ui))
            .textures_delta
            .clear();
        // The pass is over: what was due at its begin has been written.
        if writeln!(out.lock(), "pass {number} {began}").is_err() {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

struct AtWork {
    process: Child,
    folder: tempfile::TempDir,
}

fn at_work() -> AtWork {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(std::env::current_exe().unwrap());
    command
        .args([
            "--exact",
            "files::recovery::tests::a_process_at_work",
            "--nocapture",
        ])
        .env(AT_WORK, folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null());
    AtWork {
        process: started(&mut command),
        folder,
    }
}

/// kill -9 at random moments: the last second's work is lost at most. The time
/// is the process's own, so that a busy machine is no matter.
#[test]
fn killed_at_any_moment() {
    let kills: u64 = std::env::var("VIDES_KILLS").map_or(20, |kills| kills.parse().unwrap());
    let mut random = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .unwrap()
        .subsec_nanos();
    let (mut done, mut longest) = (0, 0);
    while done < kills {
        // Some at a time: most of it is waiting.
        let together: Vec<AtWork> = (0..(kills - done).min(10)).map(|_| at_work()).collect();
        std::thread::sleep(Duration::from_millis(900));
        for mut work in together {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            std::thread::sleep(Duration::from_micros((random >> 13).into()));
            work.process.kill().unwrap();
            work.process.wait().unwrap();
            longest = longest.max(lost(work));
            done += 1;
        }
    }
    println!(
        "{done} kills: at most {} ms of work were lost",
        longest / 1000
    );
    assert!(longest < 1_000_000, "{longest} µs");
}

/// How long before the end of its process the oldest change was made that is
/// lost, in µs; 0 if none is.
fn lost(mut work: AtWork) -> u64 {
    let out = BufReader::new(work.process.stdout.take().unwrap());
    let mut passes = Vec::new();
    for line in out.lines() {
        let line = line.unwrap();
        // The test's own report may stand before it.
        let Some((_, words)) = line.split_once("pass ") else {
            continue;
        };
        let Some((number, began)) = words.split_once(' ') else {
            continue;
        };
        passes.push((
            number.parse::<u32>().unwrap(),
            began.parse::<u64>().unwrap(),
        ));
    }
    let found = find(work.folder.path(), None);
    let restored = found.first().map_or(0, |found| {
        // Whole, whenever it was killed.
        let document = found.document().unwrap();
        (x_of(&document) * 1e6).round() as u32
    });
    assert!(found.len() <= 1);
    let end = passes.last().map_or(0, |&(_, began)| began);
    let mut lost = passes.iter().filter(|(number, _)| *number > restored);
    lost.next().map_or(0, |(_, began)| end - began)
}

/// Root alone can try it: others cannot give a folder away.
#[test]
fn a_folder_of_another_user_is_neither_read_nor_written() {
    let folder = work_folder();
    let mut document = document();
    change(&mut document, 0.1);
    let mut autosave = Autosave::new(folder.path(), &document);
    autosave.write(&document, &Origin::default()).unwrap();
    drop(autosave);
    assert_eq!(find(folder.path(), None).len(), 1);
    let open_to_all = fs::Permissions::from_mode(0o777);
    fs::set_permissions(folder.path(), open_to_all).unwrap();
    assert!(find(folder.path(), None).is_empty());
    fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o700)).unwrap();
    let planted = folder.path().join(&names(folder.path())[0]);
    if chown(&planted, Some(65534), None).is_err() {
        return;
    }
    assert!(find(folder.path(), None).is_empty(), "a planted file");
    chown(&planted, Some(geteuid().as_raw()), None).unwrap();
    assert_eq!(find(folder.path(), None).len(), 1);
    chown(folder.path(), Some(65534), None).unwrap();
    assert!(find(folder.path(), None).is_empty(), "another's folder");
    let mut autosave = Autosave::new(folder.path(), &document);
    let error = autosave.write(&document, &Origin::default()).unwrap_err();
    let place = folder.path().display().to_string();
    assert!(error.to_string().starts_with(&place), "{error}");
    assert_eq!(names(folder.path()).len(), 1);
    chown(folder.path(), Some(geteuid().as_raw()), None).unwrap();
}
