//! What the pointer costs: how often egui runs.

use std::time::{Duration, Instant};

use egui::{Event, Modifiers, PointerButton, Pos2, pos2};

use super::{Remote, open, settle};
use crate::live::FRAME;
use crate::window::DRAG_PAUSE;
use crate::{close, dispatch, wait};
use vides_x11::PollResult;

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

/// Sends an event and serves; how many passes that took.
fn hand(remote: &Remote, event: Event) -> usize {
    let before = remote.passes.get();
    remote.hand(event);
    dispatch();
    remote.passes.get() - before
}

/// The picture is shown, and no input comes: waits for the next pass.
fn until_it_settles(remote: &Remote) {
    let before = remote.passes.get();
    remote.send(PollResult {
        shown: true,
        ..PollResult::default()
    });
    dispatch();
    while remote.passes.get() == before {
        std::thread::sleep(wait().expect("a pass to come"));
        dispatch();
    }
}

/// A mouse tells a thousand times a second where it is; a screen shows sixty pictures.
#[test]
fn motions_share_a_picture() {
    let (id, remote, _) = open();
    remote.size.set([900, 700]);
    settle(&[&remote]);
    // In the empty part of the space, which turns.
    let at = |x: f32| pos2(300.0 + x, 470.0);
    hand(&remote, Event::PointerMoved(at(0.0)));
    assert!(hand(&remote, button(at(0.0), true)) >= 1);
    let (begun, before) = (Instant::now(), remote.passes.get());
    let mut step = 0.0;
    while remote.passes.get() < before + 10 {
        step += 1.0;
        let presents = remote.presents.get();
        let passes = hand(&remote, Event::PointerMoved(at(20.0 + step % 100.0)));
        assert_eq!(remote.presents.get() - presents, passes);
    }
    // The first and the last of ten have nine steps between them.
    assert!(begun.elapsed() >= 9 * FRAME, "{:?}", begun.elapsed());
    // What came after the last picture is shown without another motion.
    let shown = loop {
        if hand(&remote, Event::PointerMoved(at(150.0))) == 0 {
            break remote.shown.borrow().clone();
        }
    };
    until_it_settles(&remote);
    assert!(*remote.shown.borrow() != shown);
    // Whatever else comes does not wait, and finds the motion done.
    loop {
        let moved = hand(&remote, Event::PointerMoved(at(10.0)));
        let shown = remote.shown.borrow().clone();
        assert!(hand(&remote, button(at(10.0), false)) >= 1);
        if moved == 0 {
            assert!(*remote.shown.borrow() != shown);
            break;
        }
        hand(&remote, button(at(10.0), true));
        hand(&remote, Event::PointerMoved(at(60.0)));
    }
    settle(&[&remote]);
    assert_eq!(wait(), None);
    close(id);
}

/// egui wants a second pass after every event; in a drag the next motion comes
/// first.
#[test]
fn a_motion_of_a_drag_costs_one_pass() {
    let (id, remote, _) = open();
    settle(&[&remote]);
    hand(&remote, button(pos2(30.0, 30.0), true));
    // On a machine that is busy a motion may come so late that it settles first:
    // that tells nothing.
    let mut in_time = 0;
    let mut begun = Instant::now();
    for step in (0..20_u8).cycle() {
        std::thread::sleep(FRAME);
        let last = std::mem::replace(&mut begun, Instant::now());
        let at = pos2(32.0 + f32::from(step), 30.0);
        let passes = hand(&remote, Event::PointerMoved(at));
        if last.elapsed() < DRAG_PAUSE {
            assert_eq!(passes, 1);
            assert_ne!(wait(), Some(Duration::ZERO));
            in_time += 1;
        }
        if in_time == 20 {
            break;
        }
    }
    // When the pointer rests it settles all the same.
    until_it_settles(&remote);
    remote.hand(button(pos2(30.0, 30.0), false));
    settle(&[&remote]);
    assert_eq!(wait(), None);
    close(id);
}
