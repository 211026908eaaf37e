//! What the pointer costs: how often egui runs.

use std::time::Duration;

use egui::{Event, Modifiers, PointerButton, Pos2, pos2};

use super::{Remote, open, settle};
use crate::clock::{self, pass};
use crate::live::FRAME;
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
        pass(wait().expect("a pass to come"));
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
    let (begun, before) = (clock::now(), remote.passes.get());
    let mut step = 0.0;
    while remote.passes.get() < before + 10 {
        step += 1.0;
        pass(Duration::from_millis(1));
        let presents = remote.presents.get();
        let passes = hand(&remote, Event::PointerMoved(at(20.0 + step % 100.0)));
        assert_eq!(remote.presents.get() - presents, passes);
    }
    // Each comes with the first motion after its time.
    let took = clock::now() - begun;
    assert!(
        took >= 9 * FRAME && took <= 10 * FRAME + Duration::from_millis(10),
        "{took:?}"
    );
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
    for step in 0..20_u8 {
        pass(FRAME);
        let at = pos2(32.0 + f32::from(step), 30.0);
        assert_eq!(hand(&remote, Event::PointerMoved(at)), 1);
        assert_ne!(wait(), Some(Duration::ZERO));
    }
    // When the pointer rests it settles all the same.
    until_it_settles(&remote);
    remote.hand(button(pos2(30.0, 30.0), false));
    settle(&[&remote]);
    assert_eq!(wait(), None);
    close(id);
}
