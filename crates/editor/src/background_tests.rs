use std::cell::RefCell;
use std::thread::JoinHandle;

use egui::Context;
use egui_kittest::kittest::NodeT;
use glam::DVec3;
use vides_document::{At, Edit, Object, is_planned};
use vides_engine::path::CameraPath;
use vides_engine::scene::Mesh;

use crate::screenshots::screenshot;
use crate::tests::*;

/// A thread whose work is never done at once.
fn late(work: Box<dyn FnOnce() + Send>) -> bool {
    let thread = std::thread::spawn(|| {
        std::thread::sleep(3 * super::AT_ONCE);
        work();
    });
    LATE.with_borrow_mut(|late| late.push(thread));
    true
}

thread_local! {
    /// What this test has begun beside itself.
    static LATE: RefCell<Vec<JoinHandle<()>>> = const { RefCell::new(Vec::new()) };
}

/// A window with a small tetrahedron in its space.
fn beside(language: Language, start: super::Start) -> Window {
    let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
    window.state_mut().work_beside(start);
    let corners = [
        [-0.1, -0.1, -0.1],
        [0.1, -0.1, 0.1],
        [0.1, 0.1, -0.1],
        [-0.1, 0.1, 0.1],
    ];
    let mut info = window.state().document.info().clone();
    info.object = Object::of_mesh(Mesh {
        points: corners.map(DVec3::from_array).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
        ..Mesh::default()
    })
    .unwrap();
    window.state_mut().edit(Edit::SetInfo(Box::new(info)));
    window.run();
    window
}

fn tour(window: &mut Window) {
    let language = window.state().language();
    open_menu(window, 3);
    click(window, &format!("{} …", language.tool("tour")));
}

fn path(window: &Window) -> CameraPath {
    window.state().document.path().clone()
}

fn is_able(window: &Window) -> bool {
    let ok = window.state().texts().tools.ok;
    let ok = window.get_all_by_label(ok).last().expect("a button");
    !ok.accesskit_node().is_disabled()
}

/// Steps until something is true.
fn comes(window: &mut Window, what: impl Fn(&Window) -> bool) {
    until("what was begun", || {
        window.step();
        what(window).then_some(())
    });
}

/// Steps when all work is done; whatever comes of it has come then.
fn when_done(window: &mut Window) {
    for thread in LATE.take() {
        thread.join().unwrap();
    }
    for _ in 0..3 {
        window.step();
    }
}

#[test]
fn a_tool_works_while_the_window_goes_on() {
    for language in BOTH {
        let mut window = beside(language, late);
        let before = path(&window);
        tour(&mut window);
        assert_eq!(path(&window), before);
        assert!(!is_able(&window));
        screenshot(&mut window, &format!("work-{language:?}.png"));
        // One looks round meanwhile.
        window.state_mut().scrub(7.0);
        comes(&mut window, |window| path(window) != before);
        window.step();
        assert!(is_able(&window) && window.state().playing.is_playing());
        click(&mut window, language.texts().tools.cancel);
        assert_eq!(path(&window), before);
    }
}

#[test]
fn who_cancels_need_not_wait() {
    let mut window = beside(Language::English, late);
    let before = path(&window);
    tour(&mut window);
    click(&mut window, "Cancel");
    assert!(window.state().windows.tool.is_none());
    assert_eq!(path(&window), before);
    // Another edit gives it up, too.
    tour(&mut window);
    let edit = Edit::set(At::Path, "closed", true);
    window
        .state_mut()
        .act(crate::action::Action::Edit(edit), &egui::Context::default());
    assert!(window.state().windows.tool.is_none() && path(&window).closed);
    when_done(&mut window);
    assert_eq!(path(&window).points.len(), before.points.len());
}

#[test]
fn without_threads_to_be_had_nothing_is_lost() {
    let mut window = beside(Language::English, |_| false);
    let before = path(&window);
    tour(&mut window);
    assert!(window.query_by_label_contains("cancelled").is_some() && !is_able(&window));
    assert_eq!(path(&window), before);
}

#[test]
fn a_long_film_is_checked_while_the_window_goes_on() {
    for cancels in [false, true] {
        let mut window = beside(Language::English, late);
        let long = Edit::FitFrames {
            first: 0,
            last: 5,
            frames: 30_000,
        };
        window.state_mut().edit(long);
        open_menu(&mut window, 3);
        click(&mut window, "Check …");
        click(&mut window, "Check now");
        let found = |window: &Window| {
            let check = window.state().windows.check.as_ref().unwrap();
            (check.checked.is_some(), check.found().to_vec())
        };
        assert!(window.query_by_label("Check now").is_none() && !found(&window).0);
        // One looks round meanwhile.
        window.state_mut().scrub(7.0);
        if cancels {
            click(&mut window, "Cancel");
            when_done(&mut window);
            assert!(window.query_by_label("Check now").is_some() && !found(&window).0);
        } else {
            comes(&mut window, |window| found(window).0);
            let document = &window.state().document;
            let object = document.clearance(None).unwrap();
            let wanted = document
                .check_against(object.as_ref(), &mut |_, _| true)
                .unwrap();
            assert_eq!(found(&window).1.len(), wanted.len());
        }
    }
}

#[test]
fn a_finding_is_cured_while_the_window_goes_on() {
    for cancels in [false, true] {
        let mut window = beside(Language::English, late);
        let mut info = window.state().document.info().clone();
        let kind = vides_engine::tools::check::FindingKind::Speed;
        info.limits.set(kind, 0.05).unwrap();
        window.state_mut().edit(Edit::SetInfo(Box::new(info)));
        open_menu(&mut window, 3);
        click(&mut window, "Check …");
        let found = window
            .state()
            .windows
            .check
            .as_ref()
            .unwrap()
            .found()
            .to_vec();
        let finding = *found.iter().find(|found| found.kind == kind).unwrap();
        assert!(is_planned(kind));
        let before = path(&window);
        let cure = crate::action::Action::Cure(finding);
        window.state_mut().act(cure, &egui::Context::default());
        window.step();
        assert_eq!(path(&window), before);
        if cancels {
            click(&mut window, "Cancel");
            when_done(&mut window);
            assert_eq!(path(&window), before);
        } else {
            comes(&mut window, |window| path(window) != before);
            let left = window.state().document.check(None).unwrap();
            assert!(!left.iter().any(|left| left.kind == kind));
        }
    }
}

#[test]
fn a_panic_of_the_work_is_the_windows() {
    for start in [None, Some(late as super::Start)] {
        let begun = std::panic::catch_unwind(|| {
            let mut begun = super::Background::<()>::begin(start, |_| panic!("a fault"));
            while !begun.is_done(&Context::default()) {}
        });
        assert_eq!(begun.unwrap_err().downcast_ref(), Some(&"a fault"));
    }
}
