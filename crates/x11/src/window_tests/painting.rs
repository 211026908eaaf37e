//! What is painted is what is shown.

use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::ConnectionExt as _;

use super::looker::Looker;
use super::{Shown, colour, open};
use crate::testing::Server;
use vides_raster::Area;

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
