//! Whole windows on servers of their own: what is painted is what is shown.

use std::os::fd::AsFd;
use std::time::{Duration, Instant};

use x11rb::connection::Connection as _;
use x11rb::protocol::Event;
use x11rb::protocol::xproto::{
    CONFIGURE_NOTIFY_EVENT, ChangeWindowAttributesAux, ClientMessageEvent, ConfigureNotifyEvent,
    ConfigureWindowAux, ConnectionExt as _, CreateGCAux, DESTROY_NOTIFY_EVENT, DestroyNotifyEvent,
    EXPOSE_EVENT, EventMask, ExposeEvent, ImageFormat, PropMode, Rectangle, UNMAP_NOTIFY_EVENT,
};
use x11rb::rust_connection::RustConnection;
use x11rb::wrapper::ConnectionExt as _;

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
    painted: usize,
    close: bool,
}

impl Shown {
    fn open(server: &Server) -> Self {
        Self {
            window: open(server.display()).expect("a window"),
            events: Vec::new(),
            input: egui::RawInput::default(),
            seed: 1,
            frames: 0,
            painted: 0,
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
        self.painted += 1;
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

fn open(display: &str) -> crate::error::Result<Window> {
    Window::open(&Options {
        display: Some(display.to_owned()),
        title: "VIDES – Prüfung".to_owned(),
        size: [300.0, 200.0],
        smallest: [100.0, 80.0],
    })
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

    /// Resizes a window as a window manager would.
    fn resize(&self, window: u32, width: u32, height: u32) {
        let size = ConfigureWindowAux::new().width(width).height(height);
        self.connection.configure_window(window, &size).unwrap();
        self.connection.flush().unwrap();
    }

    fn root(&self) -> u32 {
        self.connection.setup().roots[self.screen].root
    }

    /// Paints over a window's upper left corner.
    fn spoil(&self, window: u32) {
        let context = self.connection.generate_id().unwrap();
        let colour = CreateGCAux::new().foreground(0x55aa);
        self.connection.create_gc(context, window, &colour).unwrap();
        let place = Rectangle {
            x: 50,
            y: 60,
            width: 100,
            height: 70,
        };
        self.connection
            .poly_fill_rectangle(window, context, &[place])
            .unwrap();
    }

    /// Sends a window an event, as every client can.
    fn send(&self, window: u32, event: impl Into<[u8; 32]>) {
        let sent = self
            .connection
            .send_event(false, window, EventMask::NO_EVENT, event);
        sent.unwrap().ignore_error();
    }

    /// The server has done all that was asked of it here.
    fn sync(&self) {
        self.connection.get_input_focus().unwrap().reply().unwrap();
    }

    fn atom(&self, name: &str) -> u32 {
        let reply = self.connection.intern_atom(false, name.as_bytes());
        reply.unwrap().reply().unwrap().atom
    }

    fn property(&self, window: u32, name: &str) -> Vec<u8> {
        let name = self.atom(name);
        let any = x11rb::protocol::xproto::AtomEnum::ANY;
        let reply = self
            .connection
            .get_property(false, window, name, any, 0, 1 << 20);
        reply.unwrap().reply().unwrap().value
    }

    /// Sets the desktop's resources.
    fn resources(&self, text: &str) {
        let [name, kind] = [self.atom("RESOURCE_MANAGER"), self.atom("STRING")];
        let (root, text) = (self.root(), text.as_bytes());
        let set = self
            .connection
            .change_property8(PropMode::REPLACE, root, name, kind, text);
        set.unwrap().check().unwrap();
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
                looker.resize(shown.id(), width, height);
                shown.until("the new size", |shown| shown.window.size == (width, height));
                shown.settle();
                looker.check(&shown, 1, (width, height));
            }
        }
    }
}

#[test]
fn a_palette_screen_gets_a_true_colour_window() {
    let server = Server::with(&["-screen", "0", "400x300x8", "-cc", "3"]);
    let looker = Looker::new(&server);
    let screen = &looker.connection.setup().roots[0];
    let colours = screen
        .allowed_depths
        .iter()
        .flat_map(|depth| &depth.visuals);
    if colours
        .clone()
        .any(|v| v.class == x11rb::protocol::xproto::VisualClass::TRUE_COLOR)
    {
        let mut shown = Shown::open(&server);
        shown.settle();
        looker.check(&shown, 1, (300, 200));
    } else {
        let error = open(server.display()).map(drop).unwrap_err().to_string();
        let expected = format!(
            "display \"{}\": the screen shows no true colours, which are needed",
            server.display()
        );
        assert_eq!(error, expected);
    }
}

#[test]
fn what_was_covered_comes_back_without_being_painted() {
    for more in [&[][..], &["-extension", "MIT-SHM"][..]] {
        let server = Server::with(more);
        let looker = Looker::new(&server);
        let mut shown = Shown::open(&server);
        shown.settle();
        // Another client spoils the window, and the server asks for it again.
        looker.spoil(shown.id());
        looker
            .connection
            .clear_area(true, shown.id(), 50, 60, 100, 70)
            .unwrap();
        looker.connection.flush().unwrap();
        let before = shown.painted;
        let frames = shown.frames;
        shown.until("the repair", |shown| shown.frames > frames);
        assert_eq!(shown.painted, before);
        looker.check(&shown, 1, (300, 200));
    }
}

#[test]
fn one_frame_is_in_flight_and_then_another_may_be_painted() {
    for more in [&[][..], &["-extension", "MIT-SHM"][..]] {
        let server = Server::with(more);
        let looker = Looker::new(&server);
        let mut shown = Shown::open(&server);
        shown.settle();
        for seed in 2..50 {
            shown.seed = seed;
            assert!(shown.paint());
            assert!(!shown.paint(), "while one is in flight there is no target");
            let frames = shown.frames;
            shown.until("the frame", |shown| shown.frames > frames);
        }
        looker.check(&shown, 49, (300, 200));
    }
}

#[test]
fn parts_are_shown_alone() {
    let server = Server::with(&["-extension", "MIT-SHM"]);
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let target = shown.window.target().unwrap();
    target.pixels.fill(0x0011_2233);
    let part = Area {
        x: 10,
        y: 20,
        width: 30,
        height: 40,
    };
    let frames = shown.frames;
    shown.window.present(&[part]).unwrap();
    shown.until("the part", |shown| shown.frames > frames);
    let around = Area {
        x: 9,
        y: 19,
        width: 32,
        height: 42,
    };
    let (levels, _) = looker.levels(shown.id(), around);
    for (place, levels) in levels.iter().enumerate() {
        let (x, y) = (place as u32 % 32 + 9, place as u32 / 32 + 19);
        let inside = (10..40).contains(&x) && (20..60).contains(&y);
        let [_, old @ ..] = colour(1, x, y).to_be_bytes();
        let wanted = if inside { [0x11, 0x22, 0x33] } else { old };
        assert_eq!(*levels, wanted.map(u32::from), "({x}, {y})");
    }
}

#[test]
fn extreme_sizes_do_no_harm() {
    let server = Server::with(&["-screen", "0", "1024x768x24"]);
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    for (width, height, fitted) in [
        (8000, 8000, (8000, 8000)),
        (1, 1, (1, 1)),
        (32_767, 1, (16_384, 1)),
        (20_000, 20_000, (16_384, 4096)),
        (640, 480, (640, 480)),
    ] {
        looker.resize(shown.id(), width, height);
        shown.until("the new size", |shown| shown.window.size == fitted);
        shown.settle();
        let seen = (fitted.0.min(400), fitted.1.min(400));
        looker.check(&shown, 1, seen);
    }
    // What the window grew to is given back.
    assert!(shown.window.surface.room() <= 16 << 20);
}

#[test]
fn what_others_send_is_not_believed() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let id = shown.id();
    let other = looker.connection.generate_id().unwrap();
    for window in [id, other, looker.root(), 0] {
        let configured = ConfigureNotifyEvent {
            response_type: CONFIGURE_NOTIFY_EVENT,
            window,
            event: window,
            width: 5,
            height: 60_000,
            ..ConfigureNotifyEvent::default()
        };
        looker.send(id, configured);
        let destroyed = DestroyNotifyEvent {
            response_type: DESTROY_NOTIFY_EVENT,
            window: other,
            event: window,
            ..DestroyNotifyEvent::default()
        };
        looker.send(id, destroyed);
        let exposed = ExposeEvent {
            response_type: EXPOSE_EVENT,
            window,
            x: 65_535,
            y: 7,
            width: 65_535,
            height: 65_535,
            ..ExposeEvent::default()
        };
        looker.send(id, exposed);
        for kind in 0..600 {
            looker.send(id, ClientMessageEvent::new(32, window, kind, [kind; 5]));
            looker.send(id, ClientMessageEvent::new(8, window, kind, [7; 20]));
        }
        for kind in 2..128_u8 {
            if kind == DESTROY_NOTIFY_EVENT || kind == UNMAP_NOTIFY_EVENT {
                continue;
            }
            let mut event = [0xff; 32];
            event[0] = kind;
            looker.send(id, event);
        }
    }
    looker.sync();
    for _ in 0..20 {
        shown.turn();
    }
    assert_eq!(shown.window.size, (300, 200));
    assert!(!shown.close);
    shown.until("a target", |shown| shown.paint());
    let frames = shown.frames;
    shown.until("a frame", |shown| shown.frames > frames);
    looker.check(&shown, 1, (300, 200));
}

#[test]
fn a_window_manager_finds_what_it_looks_for() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    let id = shown.id();
    assert_eq!(looker.property(id, "WM_CLASS"), b"vides\0Vides\0");
    assert_eq!(looker.property(id, "WM_NAME"), b"VIDES - Pr\xfcfung");
    assert_eq!(
        looker.property(id, "_NET_WM_NAME"),
        "VIDES – Prüfung".as_bytes()
    );
    assert_eq!(
        looker.property(id, "_NET_WM_PID"),
        std::process::id().to_ne_bytes()
    );
    let machine = std::fs::read_to_string("/proc/sys/kernel/hostname").unwrap();
    assert_eq!(
        looker.property(id, "WM_CLIENT_MACHINE"),
        machine.trim_end().as_bytes()
    );
    let sizes = looker.property(id, "WM_NORMAL_HINTS");
    let sizes: Vec<_> = sizes
        .chunks(4)
        .map(|b| u32::from_ne_bytes(b.try_into().unwrap()))
        .collect();
    assert_eq!(sizes[0] & 1 << 4, 1 << 4, "there is a smallest size");
    assert_eq!(sizes[5..7], [100, 80]);
    assert!(looker.property(id, "_NET_WM_ICON").len() > 16 * 16 * 4);
    assert_eq!(
        looker.property(id, "_NET_WM_WINDOW_TYPE"),
        looker.atom("_NET_WM_WINDOW_TYPE_NORMAL").to_ne_bytes()
    );
    shown.window.set_title("VIDES – *点\n\0").unwrap();
    until("the title", || {
        (looker.property(id, "_NET_WM_NAME") == "VIDES – *点".as_bytes()).then_some(())
    });
    assert_eq!(looker.property(id, "WM_NAME"), b"VIDES - *?");

    let protocols = looker.atom("WM_PROTOCOLS");
    let close = [looker.atom("WM_DELETE_WINDOW"), 0, 0, 0, 0];
    looker.send(id, ClientMessageEvent::new(32, id, protocols, close));
    looker.connection.flush().unwrap();
    shown.until("the wish to close", |shown| shown.close);

    // The answer to a ping goes to whoever manages the root window.
    let manage = ChangeWindowAttributesAux::new().event_mask(EventMask::SUBSTRUCTURE_REDIRECT);
    looker
        .connection
        .change_window_attributes(looker.root(), &manage)
        .unwrap();
    let ping = [looker.atom("_NET_WM_PING"), 4711, id, 0, 0];
    looker.send(id, ClientMessageEvent::new(32, id, protocols, ping));
    looker.connection.flush().unwrap();
    let end = Instant::now() + PATIENCE;
    loop {
        assert!(Instant::now() < end, "no answer to the ping");
        shown.turn();
        if let Some(Event::ClientMessage(answer)) = looker.connection.poll_for_event().unwrap() {
            assert_eq!((answer.window, answer.type_), (looker.root(), protocols));
            assert_eq!(answer.data.as_data32(), ping);
            break;
        }
    }
}

#[test]
fn the_mouse_is_followed() {
    let server = Server::start();
    let mut shown = Shown::open(&server);
    shown.settle();
    let expect = |shown: &mut Shown, arguments: &[&str], wanted: egui::Event| {
        shown.events.clear();
        server.run("xdotool", arguments);
        shown.until("an event", |shown| shown.events.contains(&wanted));
    };
    let at = |x, y| egui::pos2(x, y);
    let go = |x, y| ["mousemove", x, y];
    let inside = egui::Event::PointerMoved(at(20.0, 30.0));
    for _ in 0..2 {
        expect(&mut shown, &go("20", "30"), inside.clone());
        expect(&mut shown, &go("400", "300"), egui::Event::PointerGone);
    }
    expect(&mut shown, &go("20", "30"), inside);
    for (number, button) in [
        ("1", egui::PointerButton::Primary),
        ("2", egui::PointerButton::Middle),
        ("3", egui::PointerButton::Secondary),
    ] {
        for (what, pressed) in [("mousedown", true), ("mouseup", false)] {
            let wanted = egui::Event::PointerButton {
                pos: at(20.0, 30.0),
                button,
                pressed,
                modifiers: egui::Modifiers::NONE,
            };
            expect(&mut shown, &[what, number], wanted);
        }
    }
    // A drag leads out of the window and back.
    server.run("xdotool", &["mousedown", "1"]);
    expect(
        &mut shown,
        &go("390", "310"),
        egui::Event::PointerMoved(at(390.0, 310.0)),
    );
    assert!(!shown.events.contains(&egui::Event::PointerGone));
    shown.events.clear();
    server.run("xdotool", &["mouseup", "1"]);
    shown.until("the end", |shown| {
        shown.events.last() == Some(&egui::Event::PointerGone)
    });
    assert!(shown.input.screen_rect.unwrap().size() == egui::vec2(300.0, 200.0));
}

#[test]
fn the_resolution_is_followed() {
    let server = Server::start();
    let looker = Looker::new(&server);
    looker.resources("Xft.dpi:\t144\n");
    let mut shown = Shown::open(&server);
    shown.settle();
    assert_eq!((shown.window.scale, shown.window.size), (1.5, (450, 300)));
    assert_eq!(
        shown.input.screen_rect.unwrap().size(),
        egui::vec2(300.0, 200.0)
    );
    assert_eq!(shown.input.viewport().native_pixels_per_point, Some(1.5));
    looker.resources("Xft.dpi:\t192\n");
    shown.until("another scale", |shown| shown.window.scale == 2.0);
    assert_eq!(
        shown.input.screen_rect.unwrap().size(),
        egui::vec2(225.0, 150.0)
    );
}

#[test]
fn a_window_destroyed_by_others_says_so() {
    let server = Server::start();
    let looker = Looker::new(&server);
    let mut shown = Shown::open(&server);
    shown.settle();
    looker.connection.destroy_window(shown.id()).unwrap();
    looker.sync();
    let error = until("the end", || shown.window.poll().err());
    assert_eq!(error.to_string(), "the window was closed from outside");
    assert!(shown.window.target().is_none());
    for error in [
        shown.window.present(&[]).unwrap_err(),
        shown.window.set_title("x").unwrap_err(),
        shown.window.raise().unwrap_err(),
        shown.window.poll().map(drop).unwrap_err(),
    ] {
        assert_eq!(error.to_string(), "the window was closed from outside");
    }
}
