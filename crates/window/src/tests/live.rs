//! What the host is told while something is done, and when.

use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::time::{Duration, Instant};

use egui::{Event, Modifiers, PointerButton, pos2};

use super::{Remote, open_for};
use crate::clock::{self, pass};
use crate::{
    Closing, Gone, Host, Id, Reason, change, close, command, dispatch, is_open, look, wait,
};
use vides_document::{At, Edit, Poses, Result};
use vides_editor::HostView;
use vides_engine::path::{CameraPath, Pose};
use vides_engine::scene::{Extrapolation, FollowPath, Kind, Node, Scene};
use vides_x11::PollResult;

/// What a host does when it is told of a view.
type OnView = Box<dyn FnMut(Id)>;

/// A host that watches.
#[derive(Default)]
struct Watcher {
    views: RefCell<Vec<(Instant, f64, Reason, Pose)>>,
    frames: RefCell<Vec<(f64, Reason)>>,
    changes: Cell<usize>,
    handed_over: Cell<usize>,
    camera: Cell<Option<Pose>>,
    on_view: RefCell<Option<OnView>>,
    takes: Cell<Duration>,
}

impl Host for Watcher {
    fn prepare(&self, _: Id, _: &Poses<'_>) -> Result<()> {
        Ok(())
    }

    fn hand_over(&self, _: Id) {
        self.handed_over.set(self.handed_over.get() + 1);
    }

    fn may_close(&self, _: Id) -> bool {
        true
    }

    fn watches(&self) -> bool {
        true
    }

    fn view(&self, window: Id, pose: &Pose, frame: f64, reason: Reason) {
        let now = clock::now();
        self.views.borrow_mut().push((now, frame, reason, *pose));
        pass(self.takes.get());
        let function = self.on_view.borrow_mut().take();
        if let Some(mut function) = function {
            function(window);
            self.on_view.borrow_mut().get_or_insert(function);
        }
    }

    fn frame(&self, _: Id, frame: f64, reason: Reason) {
        self.frames.borrow_mut().push((frame, reason));
    }

    fn changed(&self, _: Id) {
        self.changes.set(self.changes.get() + 1);
    }

    fn capture(&self, _: Id) -> Option<Pose> {
        self.camera.get()
    }

    fn lost(&self, _: &str) {}

    fn closed(&self, _: Id, _: Gone) {}
}

impl Watcher {
    fn reasons(&self) -> Vec<Reason> {
        self.views.borrow().iter().map(|view| view.2).collect()
    }

    fn forget(&self) {
        self.views.borrow_mut().clear();
        self.frames.borrow_mut().clear();
        self.changes.set(0);
        self.handed_over.set(0);
    }
}

fn open() -> (Id, Rc<Remote>, Rc<Watcher>) {
    let host = Rc::new(Watcher::default());
    let view = HostView {
        captures: true,
        ..HostView::default()
    };
    let (id, remote) = open_for(Rc::<Watcher>::clone(&host), view);
    remote.size.set([900, 700]);
    (id, remote, host)
}

/// Serves until the host has been told that nothing moves any more.
fn rest(remote: &Remote) {
    rest_all(&[remote]);
}

fn rest_all(remotes: &[&Remote]) {
    let mut quiet = 0;
    for _ in 0..2000 {
        for remote in remotes {
            remote.send(PollResult {
                shown: true,
                ..PollResult::default()
            });
        }
        dispatch();
        // Once may be while a picture was on its way.
        match wait() {
            Some(wait) => pass(wait.min(Duration::from_millis(20))),
            None if quiet == 2 => return,
            None => quiet += 1,
        }
    }
    panic!("it never comes to rest");
}

fn button(x: f32, y: f32, pressed: bool) -> Event {
    Event::PointerButton {
        pos: pos2(x, y),
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

fn move_first_point(id: Id, x: f64) {
    change(id, |document| {
        let mut position = document.path().points[0].position;
        position.x = x;
        document.apply(Edit::set(At::Point(0), "position", position))
    })
    .expect("open")
    .expect("possible");
}

#[test]
fn a_row_of_views_ends_with_a_rest() {
    let (id, remote, host) = open();
    rest(&remote);
    assert_eq!(host.reasons(), [Reason::Selected, Reason::Rested]);
    assert_eq!(host.changes.get(), 0);
    host.forget();
    move_first_point(id, 0.25);
    rest(&remote);
    assert_eq!(host.reasons(), [Reason::Edited, Reason::Rested]);
    assert_eq!(host.changes.get(), 1);
    assert!(host.views.borrow().iter().all(|view| view.3.vrp[0] == 0.25));
    host.forget();
    command(id, |editor| editor.set_frame(33.5))
        .expect("open")
        .expect("a frame");
    rest(&remote);
    assert_eq!(host.reasons(), [Reason::Scrubbed, Reason::Rested]);
    assert!(host.views.borrow().iter().all(|view| view.1 == 33.5));
    let expected = look(id, |editor| editor.document().sampler().unwrap().pose(33.5));
    assert_eq!(host.views.borrow()[1].3, expected.unwrap().unwrap());
    // The same again is nothing new.
    host.forget();
    command(id, |editor| editor.set_frame(33.5))
        .expect("open")
        .expect("a frame");
    rest(&remote);
    assert_eq!(host.reasons(), []);
    // Undone and redone.
    for undo in [true, false] {
        host.forget();
        change(id, |document| {
            if undo {
                document.undo()
            } else {
                document.redo()
            }
        });
        rest(&remote);
        assert_eq!(host.changes.get(), 1);
    }
    close(id);
}

/// The host's picture follows the window's, and waits for nothing.
#[test]
fn the_view_follows_the_picture_of_a_drag() {
    let (id, remote, host) = open();
    rest(&remote);
    host.forget();
    // The frames' bar is dragged.
    let at = |x: f32| pos2(345.0 + x, 599.0);
    remote.hand(Event::PointerMoved(at(0.0)));
    dispatch();
    remote.hand(button(at(0.0).x, at(0.0).y, true));
    dispatch();
    let mut told = 0;
    for step in 0..60_u8 {
        let seen = host.views.borrow().len();
        remote.hand(Event::PointerMoved(at(4.0 * f32::from(step))));
        dispatch();
        if host.views.borrow().len() > seen {
            assert_eq!(
                host.views.borrow().len(),
                seen + 1,
                "more than one a picture"
            );
            let when = host.views.borrow()[seen].0;
            assert_eq!(Some(when), remote.presented.get(), "it does not wait");
            told += 1;
        }
        pass(Duration::from_millis(17));
    }
    assert!(!host.reasons().contains(&Reason::Rested), "it is held");
    assert!(
        host.reasons()
            .iter()
            .all(|&reason| reason == Reason::Scrubbed)
    );
    remote.hand(button(at(236.0).x, at(236.0).y, false));
    rest(&remote);
    assert_eq!(host.reasons().last(), Some(&Reason::Rested));
    assert!(told >= 30, "{told} views");
    close(id);
}

#[test]
fn a_slow_host_has_time_for_itself_and_is_told_the_last() {
    let (id, remote, host) = open();
    rest(&remote);
    host.forget();
    host.takes.set(Duration::from_millis(60));
    let began = clock::now();
    let mut x = 0.0;
    while clock::now() - began < Duration::from_millis(600) {
        x += 0.001;
        move_first_point(id, x);
        remote.send(PollResult {
            shown: true,
            ..PollResult::default()
        });
        let start = clock::now();
        dispatch();
        assert!(
            clock::now() - start < Duration::from_millis(300),
            "more than a call"
        );
        pass(Duration::from_millis(2));
    }
    rest(&remote);
    let views = host.views.borrow();
    // A call and as long again: at most one in 120 ms.
    assert!(views.len() <= 8, "{}", views.len());
    let last = views.last().expect("views");
    assert_eq!((last.2, last.3.vrp[0]), (Reason::Rested, x));
    close(id);
}

#[test]
fn what_a_callback_changes_it_is_not_called_for() {
    let (id, remote, host) = open();
    rest(&remote);
    host.forget();
    let told = Rc::clone(&host);
    *host.on_view.borrow_mut() = Some(Box::new(move |window| {
        move_first_point(window, 0.125);
        command(window, |editor| editor.set_frame(12.0))
            .expect("open")
            .expect("a frame");
        command(window, |editor| editor.select_key(1, 0))
            .expect("open")
            .expect("a key");
        assert_eq!(told.views.borrow().len(), 1);
        *told.on_view.borrow_mut() = Some(Box::new(|_| {}));
    }));
    command(id, |editor| editor.set_frame(40.0))
        .expect("open")
        .expect("a frame");
    rest(&remote);
    assert_eq!(host.reasons(), [Reason::Scrubbed, Reason::Rested]);
    assert_eq!(host.changes.get(), 0);
    let at = look(id, |editor| editor.frame())
        .expect("open")
        .expect("a frame");
    assert_eq!(host.views.borrow()[1].1, at);
    // And it may close its own window.
    *host.on_view.borrow_mut() = Some(Box::new(|window| assert!(close(window))));
    command(id, |editor| editor.set_frame(30.0))
        .expect("open")
        .expect("a frame");
    dispatch();
    assert!(!is_open(id));
}

#[test]
fn the_hosts_camera_is_taken_over() {
    let (id, remote, host) = open();
    rest(&remote);
    let camera = Pose {
        vrp: [0.5, 0.25, -0.125],
        vpn: [0.0, 0.0, 2.0],
        vup: [0.0, 3.0, 0.0],
        zoom: 30.0,
    };
    let take_over = |camera: Option<Pose>| {
        host.camera.set(camera);
        for pressed in [true, false] {
            remote.hand(Event::Key {
                key: egui::Key::Enter,
                physical_key: None,
                pressed,
                repeat: false,
                modifiers: Modifiers::CTRL,
            });
            rest(&remote);
        }
        look(id, |editor| editor.document().path().points.len()).expect("open")
    };
    assert_eq!(take_over(Some(camera)), 3);
    assert_eq!(host.views.borrow().last().unwrap().3.vrp, camera.vrp);
    assert_eq!(take_over(None), 3);
    let parallel = Pose {
        vup: camera.vpn,
        ..camera
    };
    assert_eq!(take_over(Some(parallel)), 3);
    close(id);
}

#[test]
fn windows_are_closed_all_at_once() {
    let (one, remote, _) = open();
    let (other, other_remote, _) = open();
    rest_all(&[&remote, &other_remote]);
    assert_eq!(crate::close_all(true).expect("descriptors"), Closing::Done);
    assert!(!is_open(one) && !is_open(other));
    let (id, _, _) = open();
    assert_eq!(crate::close_all(false).expect("descriptors"), Closing::Done);
    assert!(!is_open(id));
}

/// A scene with a camera on a path from frame 11 on, and a car on another path.
fn two_paths() -> Scene {
    let follow =
        |start| FollowPath::new(CameraPath::default(), start, Extrapolation::Hold).unwrap();
    let mut scene = Scene::new();
    let mut car = Node::new("car", Kind::Group);
    car.set_path(Some(follow(1.0))).unwrap();
    scene.add(car).unwrap();
    let mut camera = Node::new("camera", Kind::Camera(Default::default()));
    camera.set_path(Some(follow(11.0))).unwrap();
    scene.add(camera).unwrap();
    scene
}

#[test]
fn a_host_that_draws_the_scene_is_told_its_frame() {
    let (id, remote, host) = open();
    rest(&remote);
    assert_eq!(
        *host.frames.borrow(),
        [(1.0, Reason::Selected), (1.0, Reason::Rested)]
    );
    let edit = |edit: Edit| {
        host.forget();
        change(id, |document| document.apply(edit))
            .expect("open")
            .expect("possible");
        rest(&remote);
    };
    edit(Edit::ReplaceScene(Box::new(two_paths())));
    // The camera's path begins later; what it sees there is the same as before.
    assert_eq!(
        *host.frames.borrow(),
        [(11.0, Reason::Edited), (11.0, Reason::Rested)]
    );
    assert_eq!(host.changes.get(), 1);
    host.forget();
    command(id, |editor| editor.set_frame(20.5))
        .expect("open")
        .expect("a frame");
    rest(&remote);
    assert_eq!(
        *host.frames.borrow(),
        [(20.5, Reason::Scrubbed), (20.5, Reason::Rested)]
    );
    assert_eq!(host.views.borrow()[0].1, 20.5);
    // The camera stays what it is while the car's path is edited, and the scene does not.
    edit(Edit::EditNode(Some(0)));
    assert_eq!(host.changes.get(), 0);
    host.forget();
    move_first_point(id, 0.25);
    rest(&remote);
    assert_eq!(host.reasons(), []);
    assert_eq!(host.frames.borrow().last().unwrap().1, Reason::Rested);
    assert_eq!(host.changes.get(), 1);
    // One that is refused tells nothing.
    host.forget();
    assert!(
        command(id, |editor| editor.set_frame(1e6))
            .expect("open")
            .is_err()
    );
    rest(&remote);
    assert!(host.frames.borrow().is_empty());
    close(id);
}

/// A covered, iconified or hung window shows no picture; the host flies along nevertheless.
#[test]
fn the_host_is_told_though_nothing_can_be_shown() {
    let (covered, remote, host) = open();
    remote.covered.set(true);
    let (hung, never, other) = open();
    // The two of them serve one another; one that hangs never says that a picture has arrived.
    let quiet = || {
        for _ in 0..2000 {
            dispatch();
            match wait() {
                Some(wait) => pass(wait.min(Duration::from_millis(20))),
                None => return,
            }
        }
        panic!("it never comes to rest");
    };
    quiet();
    for (id, host) in [(covered, &host), (hung, &other)] {
        assert_eq!(host.reasons(), [Reason::Selected, Reason::Rested]);
        host.forget();
        command(id, |editor| editor.set_frame(33.5))
            .expect("open")
            .expect("a frame");
        dispatch();
        assert_eq!(host.reasons(), [Reason::Scrubbed], "at once");
        move_first_point(id, 0.25);
        quiet();
        assert_eq!(host.views.borrow().last().unwrap().3.vrp, {
            let view = look(id, |editor| editor.view().unwrap().0).unwrap();
            view.vrp
        });
        assert_eq!(host.reasons().last(), Some(&Reason::Rested));
        assert_eq!(host.changes.get(), 1);
        command(id, |editor| editor.select_key(0, 0))
            .expect("open")
            .expect("a key");
        quiet();
        host.forget();
        let began = clock::now();
        command(id, |editor| editor.set_playing(true)).expect("open");
        while clock::now() - began < Duration::from_millis(500) {
            dispatch();
            pass(wait().unwrap_or_default().min(Duration::from_millis(5)));
        }
        command(id, |editor| editor.set_playing(false)).expect("open");
        quiet();
        let views = host.views.borrow();
        let played = views.iter().filter(|view| view.2 == Reason::Played);
        let frames: Vec<f64> = played.map(|view| view.1).collect();
        // 25 a second, from the first frame on.
        let last = frames[frames.len() - 1];
        assert!(
            frames.len() >= 12 && (12.5..=13.5).contains(&last),
            "{frames:?}"
        );
        assert_eq!(views.last().unwrap().2, Reason::Rested);
    }
    assert_eq!((remote.presents.get(), never.presents.get()), (0, 1));
    close(covered);
    close(hung);
}

/// However often something changes; the last pose always comes.
#[test]
fn the_host_is_told_sixty_times_a_second_at_most() {
    let (id, remote, host) = open();
    rest(&remote);
    host.forget();
    let (mut x, began) = (0.0, clock::now());
    while clock::now() - began < Duration::from_millis(500) {
        pass(Duration::from_millis(1));
        x += 0.001;
        move_first_point(id, x);
        remote.send(PollResult {
            shown: true,
            ..PollResult::default()
        });
        dispatch();
    }
    rest(&remote);
    let views = host.views.borrow();
    // The first at once, thirty more, and the rest.
    assert_eq!(views.len(), 32);
    assert!(host.changes.get() <= 32, "{} steps", host.changes.get());
    assert_eq!(views.last().unwrap().3.vrp[0], x);
    close(id);
}
