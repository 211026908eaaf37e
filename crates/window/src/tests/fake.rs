//! A screen without an X server, and what a test does to it from afar.

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::io::{Read as _, Write as _};
use std::os::fd::{AsFd as _, BorrowedFd};
use std::os::unix::net::UnixStream;
use std::rc::Rc;
use std::time::Instant;

use egui::{PlatformOutput, RawInput};

use crate::clock;
use crate::screen::Screen;
use vides_raster::{Area, Target};
use vides_x11::{Error, PanePlace, PaneWindow, PollResult, Result};

/// What a fake screen does, from outside.
pub(super) struct Remote {
    pub(super) theirs: RefCell<UnixStream>,
    pub(super) news: RefCell<VecDeque<PollResult>>,
    /// What poll does in the place of giving news.
    pub(super) fails: Cell<Fails>,
    pub(super) polls: Cell<usize>,
    pub(super) presents: Cell<usize>,
    pub(super) presented: Cell<Option<Instant>>,
    pub(super) dropped: Cell<bool>,
    pub(super) raised: Cell<bool>,
    pub(super) deadline: Cell<Option<Instant>>,
    /// Input since the last pass, and how many passes there were.
    pub(super) events: RefCell<Vec<egui::Event>>,
    pub(super) passes: Cell<usize>,
    /// Pixels across and down, and those that were shown last.
    pub(super) size: Cell<[u32; 2]>,
    pub(super) shown: RefCell<Vec<u32>>,
    /// The pane, if the server has such things.
    pub(super) pane: Cell<Option<PaneWindow>>,
    pub(super) paneless: Cell<bool>,
    /// Nobody sees it: there is nothing to paint into.
    pub(super) covered: Cell<bool>,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Fails {
    No,
    Gone,
    Panics,
    /// News at every poll, for ever.
    Floods,
}

impl Remote {
    pub(super) fn send(&self, news: PollResult) {
        self.news.borrow_mut().push_back(news);
        self.theirs.borrow_mut().write_all(b"x").expect("room");
    }

    pub(super) fn hand(&self, event: egui::Event) {
        let motion = matches!(event, egui::Event::PointerMoved(_));
        self.events.borrow_mut().push(event);
        self.send(PollResult {
            input: !motion,
            motion,
            shown: true,
            ..PollResult::default()
        });
    }

    pub(super) fn fail(&self, how: Fails) {
        self.fails.set(how);
        self.theirs.borrow_mut().write_all(b"x").expect("room");
    }
}

pub(super) struct Fake {
    pub(super) ours: UnixStream,
    pub(super) remote: Rc<Remote>,
    pub(super) pixels: Vec<u32>,
    pub(super) opened: Instant,
}

impl Drop for Fake {
    fn drop(&mut self) {
        self.remote.dropped.set(true);
    }
}

impl Screen for Fake {
    fn connection(&self) -> BorrowedFd<'_> {
        self.ours.as_fd()
    }

    fn poll(&mut self) -> Result<PollResult> {
        self.remote.polls.set(self.remote.polls.get() + 1);
        let _ = self.ours.read(&mut [0; 64]);
        match self.remote.fails.get() {
            Fails::No => {}
            Fails::Gone => return Err(Error::Destroyed),
            Fails::Panics => panic!("on purpose"),
            Fails::Floods => {
                return Ok(PollResult {
                    input: true,
                    shown: true,
                    ..PollResult::default()
                });
            }
        }
        Ok(self
            .remote
            .news
            .borrow_mut()
            .pop_front()
            .unwrap_or_default())
    }

    fn deadline(&self) -> Option<Instant> {
        self.remote.deadline.get()
    }

    fn still(&self) -> bool {
        false
    }

    fn take_input(&mut self) -> RawInput {
        self.remote.passes.set(self.remote.passes.get() + 1);
        let [width, height] = self.remote.size.get().map(|side| side as f32);
        let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(width, height));
        RawInput {
            screen_rect: (width > 64.0).then_some(screen),
            events: self.remote.events.take(),
            time: Some((clock::now() - self.opened).as_secs_f64()),
            ..RawInput::default()
        }
    }

    fn target(&mut self) -> Option<Target<'_>> {
        if self.remote.covered.get() {
            return None;
        }
        let [width, height] = self.remote.size.get();
        self.pixels.resize((width * height) as usize, 0);
        Some(Target {
            pixels: &mut self.pixels,
            stride: width as usize,
            width,
            height,
        })
    }

    fn present(&mut self, areas: &[Area]) -> Result<()> {
        assert!(!areas.is_empty());
        self.remote.presents.set(self.remote.presents.get() + 1);
        self.remote.presented.set(Some(clock::now()));
        self.remote.shown.borrow_mut().clone_from(&self.pixels);
        Ok(())
    }

    fn take_output(&mut self, _: PlatformOutput) -> Result<()> {
        Ok(())
    }

    fn ask_for_clipboard(&mut self) -> Result<()> {
        Ok(())
    }

    fn raise(&mut self) -> Result<()> {
        self.remote.raised.set(true);
        Ok(())
    }

    fn set_title(&mut self, _: &str) -> Result<()> {
        Ok(())
    }

    fn place_pane(&mut self, place: Option<&PanePlace>) -> Result<bool> {
        let able = !self.remote.paneless.get();
        let pane = place.filter(|_| able).map(|place| PaneWindow {
            window: 7,
            width: place.area.width,
            height: place.area.height,
        });
        self.remote.pane.set(pane);
        Ok(able || place.is_none())
    }

    fn pane(&self) -> Option<PaneWindow> {
        self.remote.pane.get()
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}
