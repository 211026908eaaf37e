//! A Rust program that is told of the flight while it is planned, and whose own camera
//! can be taken over into the path (Ctrl-Enter):
//!
//! ```sh
//! cargo run --features window --example watch
//! ```

use std::rc::Rc;

use vides::document::Document;
use vides::path::Pose;
use vides::window::editor::HostView;
use vides::window::{self, Host, Id, Options, Reason};

/// The program's own picture; this one is of words.
struct Picture {
    camera: Pose,
}

impl Host for Picture {
    fn watches(&self) -> bool {
        true
    }

    fn view(&self, _: Id, pose: &Pose, frame: f64, reason: Reason) {
        println!(
            "frame {frame}, {reason:?}: from {:?} along {:?}",
            pose.vrp, pose.vpn
        );
    }

    fn changed(&self, window: Id) {
        let points = window::read(window, |document| document.path().points.len());
        println!("the path has {} points", points.unwrap_or_default());
    }

    fn capture(&self, _: Id) -> Option<Pose> {
        Some(self.camera)
    }
}

fn main() -> window::Result<()> {
    let camera = Pose {
        vrp: [0.9, 0.6, 0.9],
        vpn: [-1.0, -0.6, -1.0],
        vup: [0.0, 1.0, 0.0],
        zoom: 30.0,
    };
    let mut options = Options::new(Document::new(), Rc::new(Picture { camera }));
    options.editor.host_view = HostView {
        name: Some("watch".to_owned()),
        captures: true,
        ..HostView::default()
    };
    let window = window::open(options)?;
    window::command(window.id(), |editor| editor.set_ghost(Some(&camera))).transpose()?;
    window::main_loop()?;
    Ok(())
}
