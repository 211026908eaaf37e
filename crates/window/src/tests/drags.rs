//! What a drag costs: which part of the window is made how often.

use std::cell::Cell;
use std::time::{Duration, Instant};

use egui::{Event, Modifiers, PointerButton, Pos2, pos2, vec2};
use glam::DVec3;

use super::{Remote, open, settle};
use crate::document::{Document, Edit};
use crate::window::FILM_STEP;
use crate::x11::News;
use crate::{change, close, dispatch, read, wait};

fn button(pos: Pos2, button: PointerButton, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

fn hand(remote: &Remote, event: Event) {
    remote.hand(event);
    dispatch();
}

/// The picture is shown, and nothing else comes: waits until `counted` goes up by
/// itself.
fn until_it_settles(remote: &Remote, counted: &Cell<usize>) {
    let before = counted.get();
    remote.send(News {
        shown: true,
        ..News::default()
    });
    dispatch();
    while counted.get() == before {
        std::thread::sleep(wait().expect("a pass to come"));
        dispatch();
    }
}

/// In a drag the space follows each motion, and egui runs now and then.
#[test]
fn egui_does_not_run_for_each_motion_of_a_drag() {
    let (id, remote, _) = open();
    remote.size.set([900, 700]);
    settle(&[&remote]);
    // In the empty part of the space, which turns.
    let at = |x: f32| pos2(300.0 + x, 560.0);
    let button = |pressed| button(at(0.0), PointerButton::Primary, pressed);
    let hand = |event| hand(&remote, event);
    hand(Event::PointerMoved(at(0.0)));
    hand(button(true));
    hand(Event::PointerMoved(at(20.0)));
    // On a machine that is busy a motion may come so late that egui runs.
    let (mut followed, mut ran) = (0, 0);
    for step in (0..100_u8).cycle().take(100_000) {
        let (runs, presents) = (remote.runs.get(), remote.presents.get());
        hand(Event::PointerMoved(at(30.0 + f32::from(step))));
        assert_eq!(remote.presents.get() - presents, 1, "step {step}");
        match remote.runs.get() - runs {
            0 => followed += 1,
            _ => ran += 1,
        }
        if followed >= 50 && ran >= 2 {
            break;
        }
    }
    assert!(followed >= 50 && ran >= 2, "{followed} followed, {ran} ran");
    // The whole is shown by itself when the hand rests. In the space it shows
    // nothing else.
    let space = |pixels: &[u32]| -> Vec<u32> {
        let rows = pixels.chunks(900).take(560).skip(120);
        rows.flat_map(|row| row[300..560].to_vec()).collect()
    };
    loop {
        let before = remote.runs.get();
        hand(Event::PointerMoved(at(10.0)));
        if remote.runs.get() > before {
            continue;
        }
        let followed_to = space(&remote.shown.borrow());
        until_it_settles(&remote, &remote.runs);
        assert!(followed_to == space(&remote.shown.borrow()));
        break;
    }
    remote.hand(button(false));
    settle(&[&remote]);
    assert_eq!(wait(), None);
    close(id);
}

/// Between two runs of egui the camera follows what is dragged, too.
#[test]
fn what_the_camera_sees_is_a_film() {
    let (id, remote, _) = open();
    remote.size.set([900, 700]);
    let first = |document: &Document| document.path().points[0].position;
    let position = DVec3::new(0.1, 0.2, 0.1);
    change(id, |document| {
        let edit = Edit::SetPosition { at: 0, position };
        document.apply(edit).expect("a place");
        document.select(0, 0).expect("the first");
    });
    settle(&[&remote]);
    let hand = |event| hand(&remote, event);
    let moved = |id| read(id, |document| first(document) != position) == Some(true);
    let button = |at, pressed| button(at, PointerButton::Middle, pressed);
    // It stands in the middle of the room, wherever that is exactly.
    let places = (0..30_u8).flat_map(|y| (0..30_u8).map(move |x| (x, y)));
    let mut places = places.map(|(x, y)| pos2(400.0, 200.0) + 8.0 * vec2(x.into(), y.into()));
    let at = places.find(|&at| {
        hand(Event::PointerMoved(at));
        hand(button(at, true));
        hand(Event::PointerMoved(at + vec2(10.0, 10.0)));
        let held = moved(id);
        if !held {
            hand(button(at, false));
        }
        held
    });
    let at = at.expect("the point");
    // In the upper right corner.
    let pane = |pixels: &[u32]| -> Vec<u32> {
        let rows = pixels.chunks(900).take(180).skip(100);
        rows.flat_map(|row| row[660..800].to_vec()).collect()
    };
    let mut filmed = 0;
    for step in (0..50_u8).cycle().take(100_000) {
        let (runs, before) = (remote.runs.get(), pane(&remote.shown.borrow()));
        hand(Event::PointerMoved(at + vec2(20.0 + f32::from(step), 20.0)));
        if remote.runs.get() == runs && before != pane(&remote.shown.borrow()) {
            filmed += 1;
        }
        if filmed == 3 {
            break;
        }
    }
    assert_eq!(filmed, 3);
    hand(button(at, false));
    settle(&[&remote]);
    close(id);
}

/// egui wants a second pass after every event; in a drag the next motion comes
/// first.
#[test]
fn a_motion_of_a_drag_costs_one_pass() {
    let (id, remote, _) = open();
    settle(&[&remote]);
    let button = |pressed| button(pos2(30.0, 30.0), PointerButton::Primary, pressed);
    hand(&remote, button(true));
    // What the press asked for.
    let mut begun = Instant::now();
    hand(&remote, Event::PointerMoved(pos2(31.0, 30.0)));
    // On a machine that is busy a motion may come so late that it settles first:
    // that tells nothing.
    let mut in_time = 0;
    for step in (0..20_u8).cycle() {
        let before = remote.passes.get();
        let last = std::mem::replace(&mut begun, Instant::now());
        let at = pos2(32.0 + f32::from(step), 30.0);
        hand(&remote, Event::PointerMoved(at));
        let (passes, next) = (remote.passes.get() - before, wait());
        if last.elapsed() < FILM_STEP {
            assert_eq!(passes, 1);
            assert_ne!(next, Some(Duration::ZERO));
            in_time += 1;
        }
        if in_time == 20 {
            break;
        }
    }
    // When the hand rests it settles all the same.
    let before = remote.passes.get();
    until_it_settles(&remote, &remote.passes);
    assert_eq!(remote.passes.get() - before, 1);
    remote.hand(button(false));
    settle(&[&remote]);
    assert_eq!(wait(), None);
    close(id);
}
