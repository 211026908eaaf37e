//! Windows without an X server: what the table and the loop promise.

mod drags;
mod fake;
mod live;
mod panes;

use std::cell::{Cell, RefCell};
use std::os::unix::net::UnixStream;
use std::rc::Rc;
use std::time::Duration;

use fake::{Fails, Fake, Remote};

use super::clock::{self, pass};
use super::pump::Served;
use super::window::Window;
use super::{
    Closing, Gone, Host, Id, change, close, close_all, dispatch, is_open, main_loop, registry,
    wait, within_a_call,
};
use crate::error::EngineError;
use vides_document::{Document, Poses};
use vides_editor::{Editor, Folders, HostView, Language, Options};
use vides_x11::PollResult;

type OnClose = Box<dyn FnMut(Id) -> bool>;

/// How a window ends.
type End = fn(Id, &Remote);

/// A host whose functions are written in each test.
#[derive(Default)]
struct Calls {
    asked: Cell<usize>,
    closed: Cell<usize>,
    gone: RefCell<Vec<Gone>>,
    /// Opens another window when one has gone.
    opens: Cell<bool>,
    lost: RefCell<Vec<String>>,
    on_close: RefCell<Option<OnClose>>,
    /// It has no room for poses.
    refuses: Cell<bool>,
    handed_over: Cell<usize>,
    /// The panes that it was told of, and whether the window was gone then.
    panes: RefCell<Vec<(u32, [u32; 2], bool)>>,
}

impl Host for Calls {
    fn prepare(&self, _: Id, _: &Poses<'_>) -> vides_document::Result<()> {
        if self.refuses.get() {
            return Err(EngineError::Memory.into());
        }
        Ok(())
    }

    fn hand_over(&self, _: Id) {
        self.handed_over.set(self.handed_over.get() + 1);
    }

    fn may_close(&self, window: Id) -> bool {
        self.asked.set(self.asked.get() + 1);
        let function = self.on_close.borrow_mut().take();
        let Some(mut function) = function else {
            return true;
        };
        let answer = function(window);
        *self.on_close.borrow_mut() = Some(function);
        answer
    }

    fn pane(&self, window: Id, pane: u32, size: [u32; 2]) {
        assert!(within_a_call());
        dispatch();
        let gone = !is_open(window);
        self.panes.borrow_mut().push((pane, size, gone));
    }

    fn lost(&self, why: &str) {
        self.lost.borrow_mut().push(why.to_owned());
    }

    fn closed(&self, _: Id, _: Gone) {
        self.closed.set(self.closed.get() + 1);
    }

    fn gone(&self, window: Id, why: Gone) {
        assert!(within_a_call() && !is_open(window) && self.closed.get() == 1);
        dispatch();
        self.gone.borrow_mut().push(why);
        if self.opens.get() {
            open();
        }
    }
}

const CLOSE: PollResult = PollResult {
    close: true,
    input: false,
    motion: false,
    shown: true,
    new_buffer: false,
    more: false,
};

fn open() -> (Id, Rc<Remote>, Rc<Calls>) {
    open_with(HostView::default())
}

fn open_with(host_view: HostView) -> (Id, Rc<Remote>, Rc<Calls>) {
    let calls = Rc::new(Calls::default());
    let (id, remote) = open_for(Rc::<Calls>::clone(&calls), host_view);
    (id, remote, calls)
}

/// A window of this host.
fn open_for(host: Rc<dyn Host>, host_view: HostView) -> (Id, Rc<Remote>) {
    let (ours, theirs) = UnixStream::pair().expect("a pair");
    ours.set_nonblocking(true).expect("non-blocking");
    let remote = Rc::new(Remote {
        theirs: RefCell::new(theirs),
        news: RefCell::default(),
        fails: Cell::new(Fails::No),
        polls: Cell::new(0),
        presents: Cell::new(0),
        presented: Cell::new(None),
        dropped: Cell::new(false),
        raised: Cell::new(false),
        deadline: Cell::new(None),
        events: RefCell::default(),
        passes: Cell::new(0),
        size: Cell::new([64, 64]),
        shown: RefCell::default(),
        pane: Cell::new(None),
        paneless: Cell::new(false),
        covered: Cell::new(false),
    });
    let editor = Editor::new(Options {
        document: Document::new(),
        file: None,
        title: None,
        language: Some(Language::English),
        host_takes_poses: true,
        fixed_speeds: true,
        folders: Folders::default(),
        program: crate::host_program(false),
        host_view,
    })
    .expect("an editor");
    let screen = Fake {
        ours,
        remote: Rc::clone(&remote),
        pixels: Vec::new(),
        opened: clock::now(),
    };
    let window = Window::new(Box::new(screen), editor, String::new());
    let id = registry::insert(Box::new(window), host).expect("room");
    (id, remote)
}

/// Whether the descriptor that hosts watch is readable.
fn readable() -> bool {
    let mut poll = libc::pollfd {
        fd: registry::descriptor().expect("a descriptor"),
        events: libc::POLLIN,
        revents: 0,
    };
    #[allow(unsafe_code)]
    // SAFETY: one element, alive during the call.
    unsafe {
        libc::poll(&mut poll, 1, 0) == 1
    }
}

/// Serves until nothing is left to do; pictures arrive at once.
fn settle(windows: &[&Rc<Remote>]) -> Served {
    let mut served = dispatch();
    for _ in 0..100 {
        for remote in windows.iter().filter(|remote| !remote.dropped.get()) {
            remote.send(PollResult {
                shown: true,
                ..PollResult::default()
            });
        }
        let lost = served.lost.take();
        served = dispatch();
        served.lost = served.lost.or(lost);
        if wait().is_none() && !readable() {
            return served;
        }
        pass(wait().unwrap_or_default());
    }
    panic!("it never comes to rest");
}

#[test]
fn a_window_paints_itself_and_then_is_quiet() {
    let (id, remote, _) = open();
    assert!(readable() && remote.polls.get() == 0);
    assert_eq!(settle(&[&remote]).open, 1);
    assert!(remote.presents.get() > 0);
    assert_eq!(wait(), None);
    let polls = remote.polls.get();
    assert!(!readable());
    assert_eq!((remote.polls.get(), is_open(id)), (polls, true));
}

#[test]
fn the_host_may_keep_a_window_open() {
    let (id, remote, calls) = open();
    settle(&[&remote]);
    *calls.on_close.borrow_mut() = Some(Box::new(|_| false));
    remote.send(CLOSE);
    assert_eq!(settle(&[&remote]).open, 1);
    assert_eq!((calls.asked.get(), calls.closed.get()), (1, 0));
    *calls.on_close.borrow_mut() = None;
    remote.send(CLOSE);
    assert_eq!(settle(&[]).open, 0);
    assert_eq!((calls.asked.get(), calls.closed.get()), (2, 1));
    assert!(remote.dropped.get() && !is_open(id) && !close(id));
    assert!(!readable());
}

#[test]
fn a_callback_may_serve_the_others_and_close_them_and_itself() {
    let (first, one, calls) = open();
    let (second, two, others) = open();
    let (third, three, thirds) = open();
    settle(&[&one, &two, &three]);
    let counted = Rc::new(Cell::new(0));
    let (inside, two_inside, one_inside) = (Rc::clone(&counted), Rc::clone(&two), Rc::clone(&one));
    *calls.on_close.borrow_mut() = Some(Box::new(move |id| {
        assert!(within_a_call());
        // Its own input waits, and wakes nobody meanwhile.
        let polls = one_inside.polls.get();
        one_inside.send(PollResult::default());
        two_inside.send(PollResult {
            input: true,
            shown: true,
            ..PollResult::default()
        });
        let before = two_inside.polls.get();
        dispatch();
        assert!(two_inside.polls.get() > before);
        assert_eq!(one_inside.polls.get(), polls);
        two_inside.send(PollResult {
            shown: true,
            ..PollResult::default()
        });
        dispatch();
        assert!(!readable());
        // Another one goes at once, the own one later.
        assert!(close(third) && !is_open(third));
        assert!(close(id) && !close(id) && !is_open(id));
        assert!(!one_inside.dropped.get());
        inside.set(inside.get() + 1);
        false
    }));
    one.send(CLOSE);
    let served = dispatch();
    assert_eq!((served.open, counted.get()), (1, 1));
    assert!(one.dropped.get() && three.dropped.get() && !two.dropped.get());
    // Closed by the host: nobody is told.
    assert_eq!((calls.closed.get(), thirds.closed.get()), (0, 0));
    assert!(!is_open(first) && is_open(second));
    assert_eq!(others.asked.get(), 0);
    close(second);
}

/// The host is called for poses that are there; that there are none is told in the
/// window.
#[test]
fn a_hand_over_that_fails_is_told() {
    let (id, remote, calls) = open();
    remote.size.set([900, 700]);
    settle(&[&remote]);
    let hand_over = |refuses| {
        calls.refuses.set(refuses);
        for pressed in [true, false] {
            remote.hand(egui::Event::Key {
                key: egui::Key::U,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: egui::Modifiers::ALT,
            });
            settle(&[&remote]);
        }
        (calls.handed_over.get(), remote.shown.borrow().clone())
    };
    let nothing_told = remote.shown.borrow().clone();
    let (none, failure) = hand_over(true);
    let (one, success) = hand_over(false);
    let (still_one, failure_again) = hand_over(true);
    assert_eq!([none, one, still_one], [0, 1, 1]);
    assert!(failure != nothing_told && failure != success);
    assert!(failure == failure_again);
    close(id);
}

#[test]
fn what_the_screen_waits_for_wakes_the_host() {
    let (id, one, _) = open();
    settle(&[&one]);
    assert_eq!(wait(), None);
    let polls = one.polls.get();
    (one.deadline).set(Some(clock::now() + Duration::from_millis(20)));
    dispatch();
    assert!(wait().is_some_and(|wait| wait <= Duration::from_millis(20)));
    one.deadline.set(None);
    dispatch();
    assert!(one.polls.get() > polls && wait().is_none());
    close(id);
}

#[test]
fn a_callback_may_open_windows() {
    let (_, one, calls) = open();
    settle(&[&one]);
    let opened = Rc::new(RefCell::new(Vec::new()));
    let inside = Rc::clone(&opened);
    *calls.on_close.borrow_mut() = Some(Box::new(move |_| {
        inside.borrow_mut().push(open());
        inside.borrow().len() >= 3
    }));
    for round in 1..=3 {
        one.send(CLOSE);
        dispatch();
        assert_eq!(opened.borrow().len(), round);
    }
    assert!(one.dropped.get());
    assert_eq!(dispatch().open, 3);
    for (id, remote, _) in opened.borrow().iter() {
        assert!(remote.polls.get() > 0 && close(*id));
    }
}

#[test]
fn a_lost_screen_takes_its_window_alone() {
    let (_, one, first) = open();
    let (id, two, _) = open();
    settle(&[&one, &two]);
    one.fail(Fails::Gone);
    let served = settle(&[&two]);
    assert_eq!(served.open, 1);
    let lost = served.lost.expect("told");
    assert_eq!(
        (lost.why.as_str(), lost.gone),
        ("the window was closed from outside", Gone::FromOutside)
    );
    assert_eq!((first.closed.get(), first.asked.get()), (1, 0));
    assert_eq!(*first.lost.borrow(), ["the window was closed from outside"]);
    assert!(one.dropped.get() && is_open(id));
    close(id);
}

#[test]
fn a_host_is_told_once_that_a_window_has_gone_unless_it_closed_that() {
    let closes_own: End = |id, _| assert!(close(id));
    let ends: [(End, &[Gone]); 5] = [
        (|_, remote| remote.send(CLOSE), &[Gone::ByUser]),
        (|_, remote| remote.fail(Fails::Gone), &[Gone::FromOutside]),
        (|_, remote| remote.fail(Fails::Panics), &[Gone::Fault]),
        (
            |_, _| assert_eq!(close_all(false).expect("descriptors"), Closing::Done),
            &[Gone::WithAll],
        ),
        (closes_own, &[]),
    ];
    for (end, told) in ends {
        let (id, remote, calls) = open();
        settle(&[&remote]);
        end(id, &remote);
        settle(&[]);
        dispatch();
        assert_eq!(*calls.gone.borrow(), told);
        assert!(!is_open(id));
    }
}

#[test]
fn a_second_closing_of_all_asks_nobody() {
    let (_, remote, calls) = open();
    settle(&[&remote]);
    *calls.on_close.borrow_mut() = Some(Box::new(|_| {
        assert_eq!(close_all(true).expect("descriptors"), Closing::Asking);
        false
    }));
    for asked in 1..=2 {
        assert_eq!(close_all(true).expect("descriptors"), Closing::Refused);
        assert_eq!(calls.asked.get(), asked);
    }
    assert_eq!(close_all(false).expect("descriptors"), Closing::Done);
}

#[test]
fn a_host_that_always_opens_another_window_can_close_all() {
    for ask in [true, false] {
        let (id, remote, calls) = open();
        settle(&[&remote]);
        calls.opens.set(true);
        assert_eq!(close_all(ask).expect("descriptors"), Closing::Done);
        assert!(!is_open(id));
        assert_eq!(dispatch().open, 1);
        assert_eq!(close_all(false).expect("descriptors"), Closing::Done);
    }
}

#[test]
fn what_took_many_windows_is_said_once() {
    let windows = [open(), open(), open()];
    dispatch();
    for (_, remote, _) in &windows {
        remote.fail(Fails::Gone);
        assert!(dispatch().lost.is_some());
    }
    let said: usize = windows
        .iter()
        .map(|(_, _, calls)| calls.lost.borrow().len())
        .sum();
    assert_eq!(said, 1);
    // A window that opens later is another matter.
    let (_, remote, calls) = open();
    remote.fail(Fails::Gone);
    dispatch();
    assert_eq!((calls.lost.borrow().len(), calls.closed.get()), (1, 1));
}

#[test]
fn a_panic_spoils_one_window() {
    let (_, one, first) = open();
    let (id, two, _) = open();
    settle(&[&one, &two]);
    one.fail(Fails::Panics);
    let served = settle(&[&two]);
    assert_eq!((served.open, first.closed.get()), (1, 1));
    let lost = served.lost.expect("told");
    assert!(
        lost.gone == Gone::Fault && lost.why.contains("on purpose"),
        "{}",
        lost.why
    );
    two.send(CLOSE);
    assert_eq!(settle(&[]).open, 0);
    assert!(!is_open(id) && one.dropped.get());
}

#[test]
fn what_a_panic_took_outside_the_loop_is_told_by_it() {
    let (id, ..) = open();
    let (asking, one, calls) = open();
    assert!(change(id, |_| panic!("on purpose")).is_none());
    let lost = dispatch().lost.expect("told");
    assert!(lost.gone == Gone::Fault && lost.why.contains("on purpose"));
    assert!(dispatch().lost.is_none(), "told again");
    // From within a callback, also if that serves the others.
    let (id, ..) = open();
    *calls.on_close.borrow_mut() = Some(Box::new(move |_| {
        assert!(change(id, |_| panic!("within a call")).is_none());
        assert!(dispatch().lost.is_some());
        false
    }));
    one.send(CLOSE);
    let lost = settle(&[&one]).lost.expect("told");
    assert!(lost.gone == Gone::Fault && lost.why.contains("within a call"));
    // A window that opens later is another matter.
    let (id, ..) = open();
    assert!(change(id, |_| panic!("on purpose")).is_none());
    let (id, ..) = open();
    assert!(dispatch().lost.is_none());
    close(id);
    close(asking);
}

#[test]
fn a_flood_lets_the_others_and_the_host_go_on() {
    let (id, one, _) = open();
    let (other, two, _) = open();
    settle(&[&one, &two]);
    one.fail(Fails::Floods);
    let (before, others) = (one.polls.get(), two.polls.get());
    dispatch();
    let polls = one.polls.get() - before;
    assert!((2..100).contains(&polls), "{polls}");
    assert!(two.polls.get() - others >= polls / 2);
    // There is more to do: whoever watches comes back at once.
    assert!(readable() && wait().is_some_and(|wait| wait.is_zero()));
    close(id);
    close(other);
}

#[test]
fn the_main_loop_ends_with_the_last_window() {
    assert_eq!(main_loop().expect("no window").open, 0);
    let (_, one, _) = open();
    let (_, two, second) = open();
    one.send(CLOSE);
    two.fail(Fails::Gone);
    let served = main_loop().expect("descriptors");
    assert_eq!(served.open, 0);
    assert!(served.lost.is_some() && second.closed.get() == 1);
    assert!(one.dropped.get() && two.dropped.get());
}

#[test]
fn a_thread_that_ends_closes_its_windows() {
    struct Shared(Rc<Remote>);
    // SAFETY: looked at only after the thread has ended.
    #[allow(unsafe_code)]
    unsafe impl Send for Shared {}
    let remote = std::thread::spawn(|| {
        let (_, remote, _) = open();
        dispatch();
        Shared(remote)
    })
    .join()
    .expect("no panic");
    assert!(remote.0.dropped.get());
}
