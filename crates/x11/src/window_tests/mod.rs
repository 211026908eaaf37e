//! Whole windows on servers of their own, seen by another client.

mod desktop;
mod embedded;
mod looker;
mod painting;
mod pane;

use rustix::event::PollFlags;
use std::os::fd::AsFd;
use std::time::Duration;

use super::stream::wait;
use super::testing::{Server, until};
use super::{Options, PollResult, Window};
use vides_raster::Area;

/// A window and what it told.
struct Shown {
    window: Window,
    events: Vec<egui::Event>,
    input: egui::RawInput,
    /// What all pixels are made of.
    seed: u32,
    frames: usize,
    painted: usize,
    close: bool,
}

impl Shown {
    fn open(server: &Server) -> Self {
        Self::of(open(server.display()).expect("a window"))
    }

    fn of(window: Window) -> Self {
        Self {
            window,
            events: Vec::new(),
            input: egui::RawInput::default(),
            seed: 1,
            frames: 0,
            painted: 0,
            close: false,
        }
    }

    /// Waits for the window's descriptor and does what an owner does.
    fn turn(&mut self) -> PollResult {
        wait(
            self.window.as_fd(),
            PollFlags::IN,
            Duration::from_millis(20),
        )
        .unwrap();
        let news = self.window.poll().expect("the server is there");
        if news.input || news.motion {
            self.input = self.window.take_input();
            self.events.append(&mut self.input.events.clone());
        }
        self.close |= news.close;
        self.frames += usize::from(news.shown);
        if news.new_buffer {
            self.paint();
        }
        news
    }

    /// Paints everything anew and shows it, if that can be now.
    fn paint(&mut self) -> bool {
        let seed = self.seed;
        let Some(target) = self.window.target() else {
            return false;
        };
        let (width, height) = (target.width, target.height);
        for y in 0..height {
            for x in 0..width {
                target.pixels[y as usize * target.stride + x as usize] = colour(seed, x, y);
            }
        }
        let whole = Area {
            x: 0,
            y: 0,
            width,
            height,
        };
        self.painted += 1;
        self.window.present(&[whole]).expect("the server is there");
        true
    }

    fn id(&self) -> u32 {
        self.window.frame.window
    }

    fn until(&mut self, what: &str, mut holds: impl FnMut(&mut Self) -> bool) {
        until(what, || {
            self.turn();
            holds(self).then_some(())
        });
    }

    /// Everything is painted and has arrived.
    fn settle(&mut self) {
        self.until("a painted frame", |shown| {
            shown.window.surface.is_free() && shown.frames > 0 && shown.painted_size()
        });
    }

    fn painted_size(&mut self) -> bool {
        self.window
            .target()
            .is_some_and(|target| target.pixels[0] == colour(1, 0, 0))
    }
}

fn open(display: &str) -> crate::error::Result<Window> {
    Window::open(&options(display))
}

fn options(display: &str) -> Options {
    Options {
        display: Some(display.to_owned()),
        title: "VIDES – Prüfung".to_owned(),
        application: "a host".to_owned(),
        size: [300.0, 200.0],
        smallest: [100.0, 80.0],
        ..Options::default()
    }
}

/// Noise: an error of a row or a column shows.
fn colour(seed: u32, x: u32, y: u32) -> u32 {
    let mixed = (x ^ y.rotate_left(11) ^ seed.rotate_left(22)).wrapping_mul(0x9e37_79b1);
    (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca77) >> 8
}
