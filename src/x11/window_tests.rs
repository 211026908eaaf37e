//! Whole windows on servers of their own: what is painted is what is shown.

use std::os::fd::{AsFd, AsRawFd};
use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{ConnectionExt as _, ImageFormat};
use x11rb::rust_connection::RustConnection;

use super::stream::wait;
use super::testing::{PATIENCE, Server, until};
use super::{News, Options, Window};
use crate::raster::Area;

/// A window and what it told.
struct Shown {
    window: Window,
    events: Vec<egui::Event>,
    input: egui::RawInput,
    /// What all pixels are made of.
    seed: u32,
    frames: usize,
    close: bool,
}

impl Shown {
    fn open(server: &Server) -> Self {
        let options = Options {
            display: Some(server.display().to_owned()),
            title: "VIDES – Prüfung".to_owned(),
            size: [300.0, 200.0],
            smallest: [100.0, 80.0],
        };
        Self {
            window: Window::open(&options).expect("a window"),
            events: Vec::new(),
            input: egui::RawInput::default(),
            seed: 1,
            frames: 0,
            close: false,
        }
    }

    /// Waits for the window's descriptor and does what an owner does.
    fn turn(&mut self) -> News {
        wait(self.window.as_fd(), libc::POLLIN, Duration::from_millis(20)).unwrap();
        let news = self.window.poll().expect("the server is there");
        if news.input {
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
        self.window.present(&[whole]).expect("the server is there");
        true
    }

    fn id(&self) -> u32 {
        self.window.frame.window
    }

    fn until(&mut self, what: &str, mut holds: impl FnMut(&mut Self) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !holds(self) {
            assert!(Instant::now() < end, "waited too long for {what}");
            self.turn();
        }
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

/// Noise: an error of a row or a column shows.
fn colour(seed: u32, x: u32, y: u32) -> u32 {
    let mixed = (x ^ y.rotate_left(11) ^ seed.rotate_left(22)).wrapping_mul(0x9e37_79b1);
    (mixed ^ mixed >> 15).wrapping_mul(0x85eb_ca77) >> 8
}

/// A look from outside.
struct Looker {
    connection: RustConnection,
    screen: usize,
}

impl Looker {
    fn new(server: &Server) -> Self {
        let (connection, screen) = RustConnection::connect(Some(server.display())).unwrap();
        Self { connection, screen }
    }

    /// Levels of red, green and blue at each place of the screen's image of a
    /// window, and the highest level of each.
    fn levels(&self, window: u32, area: Area) -> (Vec<[u32; 3]>, [u32; 3]) {
        let setup = self.connection.setup();
        let image = self.connection.get_image(
            ImageFormat::Z_PIXMAP,
            window,
            area.x as i16,
            area.y as i16,
            area.width as u16,
            area.height as u16,
            u32::MAX,
        );
        let image = image.unwrap().reply().unwrap();
        let screen = &setup.roots[self.screen];
        let mut visuals = screen
            .allowed_depths
            .iter()
            .flat_map(|depth| &depth.visuals);
        let visual = visuals
            .find(|visual| visual.visual_id == image.visual)
            .unwrap();
        let mut formats = setup.pixmap_formats.iter();
        let format = formats.find(|format| format.depth == image.depth).unwrap();
        let bytes = usize::from(format.bits_per_pixel / 8);
        let pad = usize::from(format.scanline_pad / 8);
        let row = (area.width as usize * bytes).div_ceil(pad) * pad;
        let masks = [visual.red_mask, visual.green_mask, visual.blue_mask];
        let level = |pixel: u32, mask: u32| (pixel & mask) / (mask & mask.wrapping_neg());
        let mut levels = Vec::new();
        for y in 0..area.height as usize {
            for x in 0..area.width as usize {
                let start = y * row + x * bytes;
                let mut pixel = [0; 4];
                pixel[..bytes].copy_from_slice(&image.data[start..start + bytes]);
                let pixel = u32::from_le_bytes(pixel);
                levels.push(masks.map(|mask| level(pixel, mask)));
            }
        }
        (levels, masks.map(|mask| level(mask, mask)))
    }

    /// The window shows what the seed's noise is, as near as the screen can.
    fn check(&self, shown: &Shown, seed: u32, size: (u32, u32)) {
        let area = Area {
            x: 0,
            y: 0,
            width: size.0,
            height: size.1,
        };
        let (levels, most) = self.levels(shown.id(), area);
        for (place, levels) in levels.iter().enumerate() {
            let (x, y) = (place as u32 % size.0, place as u32 / size.0);
            let [_, wanted @ ..] = colour(seed, x, y).to_be_bytes();
            for i in 0..3 {
                let true_level = f64::from(wanted[i]) / 255.0 * f64::from(most[i]);
                let off = (f64::from(levels[i]) - true_level).abs();
                let bound = if most[i] < 255 { 1.0 } else { 0.501 };
                assert!(
                    off < bound,
                    "({x}, {y}): {levels:?} of {most:?} for {wanted:?}"
                );
            }
        }
    }
}

/// Resizes the window as another client would.
fn resize(looker: &Looker, window: u32, width: u32, height: u32) {
    let size = x11rb::protocol::xproto::ConfigureWindowAux::new()
        .width(width)
        .height(height);
    looker.connection.configure_window(window, &size).unwrap();
    looker.connection.flush().unwrap();
}

#[test]
fn what_is_painted_is_shown_at_every_depth_with_and_without_shared_memory() {
    for depth in ["15", "16", "24", "30"] {
        for shared in [true, false] {
            let screen = format!("800x600x{depth}");
            let mut arguments = vec!["-screen", "0", &screen];
            if !shared {
                arguments.extend(["-extension", "MIT-SHM"]);
            }
            let server = Server::with(&arguments);
            let looker = Looker::new(&server);
            let mut shown = Shown::open(&server);
            shown.settle();
            assert_eq!(shown.window.surface.shares(), shared, "depth {depth}");
            looker.check(&shown, 1, (300, 200));
            for (width, height) in [(501, 333), (1, 1), (700, 90), (640, 480)] {
                resize(&looker, shown.id(), width, height);
                shown.until("the new size", |shown| shown.window.size == (width, height));
                shown.settle();
                looker.check(&shown, 1, (width, height));
            }
        }
    }
}
