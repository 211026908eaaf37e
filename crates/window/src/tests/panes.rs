//! The camera pane that the host fills: when it is told of what.

use super::*;

/// A window of this size with a pane.
fn filled(size: [u32; 2]) -> (Id, Rc<Remote>, Rc<Calls>) {
    let (id, remote, calls) = open_with(HostView {
        fills_pane: true,
        ..HostView::default()
    });
    remote.size.set(size);
    settle(&[&remote]);
    (id, remote, calls)
}

fn told(calls: &Calls) -> Vec<(u32, [u32; 2], bool)> {
    calls.panes.take()
}

const GONE: (u32, [u32; 2], bool) = (0, [0, 0], true);

#[test]
fn the_host_is_told_of_its_size_and_of_its_end() {
    let (id, remote, calls) = filled([1200, 800]);
    let [(7, [width, height], false)] = told(&calls)[..] else {
        panic!("one pane");
    };
    // That of the film.
    assert!(width > 150 && (f64::from(width) / f64::from(height) - 1.5).abs() < 0.02);
    settle(&[&remote]);
    assert_eq!(told(&calls), [], "nothing has changed");
    remote.size.set([850, 700]);
    remote.send(PollResult {
        input: true,
        shown: true,
        ..PollResult::default()
    });
    settle(&[&remote]);
    let smaller = told(&calls);
    let (7, [less, _], false) = smaller[smaller.len() - 1] else {
        panic!("a pane");
    };
    assert!(less < width, "{less} of {width}");
    assert!(close(id));
    assert!(remote.dropped.get());
    assert_eq!(told(&calls), [GONE]);
}

#[test]
fn however_a_window_ends_the_host_is_told_once() {
    for end in 0..4 {
        let (id, remote, calls) = filled([1200, 800]);
        assert_eq!(told(&calls).len(), 1);
        match end {
            0 => remote.send(CLOSE),
            1 => remote.fail(Fails::Gone),
            2 => remote.fail(Fails::Panics),
            _ => assert!(close(id)),
        }
        settle(&[]);
        assert_eq!(told(&calls), [GONE], "end {end}");
        assert!(!is_open(id) && !within_a_call());
    }
    // Without a pane there is nothing to be told.
    let (id, remote, calls) = open();
    remote.size.set([1200, 800]);
    settle(&[&remote]);
    assert!(close(id));
    assert_eq!(told(&calls), []);
}

#[test]
fn a_pane_that_is_lost_comes_back() {
    let (_, remote, calls) = filled([1200, 800]);
    let first = told(&calls);
    remote.pane.set(None);
    remote.send(PollResult {
        input: true,
        shown: true,
        ..PollResult::default()
    });
    settle(&[&remote]);
    assert_eq!(told(&calls), [(0, [0, 0], false), first[0]]);
}

#[test]
fn where_there_can_be_none_the_editor_draws() {
    let (ours, remote, calls) = open_with(HostView {
        fills_pane: true,
        ..HostView::default()
    });
    remote.size.set([1200, 800]);
    remote.paneless.set(true);
    settle(&[&remote]);
    settle(&[&remote]); // the next picture
    assert_eq!(told(&calls), []);
    let (theirs, plain, _) = open();
    plain.size.set([1200, 800]);
    settle(&[&plain]);
    assert!(
        *remote.shown.borrow() == *plain.shown.borrow(),
        "the same picture"
    );
    assert!(close(ours) && close(theirs));
}
