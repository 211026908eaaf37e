//! Long work costs no memory: a process of its own drags and takes back, again
//! and again, and looks at what it has.

use std::process::{Command, Stdio};

use egui::{Event, Key, Modifiers, PointerButton, vec2};

use crate::tests::started;

use super::tests::{image, key, motion, press, pyramid_window, release};

/// Says how often [`a_process_that_drags`] drags.
const DRAGS: &str = "VIDES_DRAGS_HERE";

/// What may stay behind each drag, in bytes, however many there are: far less
/// than a copy of the path or of a picture.
const LEFT_BEHIND: u64 = 256;

/// And once in all: the allocator keeps what was freed in pieces.
const ONCE: u64 = 512 << 10;

/// Memory of this process that is in use, in bytes.
fn memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("RssAnon:"));
    let words: Vec<&str> = line.unwrap().split_whitespace().collect();
    words[1].parse::<u64>().unwrap() << 10
}

/// A process of its own, in [`drags_cost_no_memory`]. Elsewhere there is
/// nothing for it to do.
#[test]
fn a_process_that_drags() {
    let Some(drags) = std::env::var_os(DRAGS) else {
        return;
    };
    let drags: u64 = drags.to_str().unwrap().parse().unwrap();
    let mut harness = pyramid_window();
    let before = harness.state().document.path().clone();
    let from = image(&harness, before.points[1].position);
    let mut at_first = 0;
    for number in 0..drags {
        // Everything that is made once has been made by then.
        if number == drags / 4 {
            at_first = memory();
        }
        let far = 10.0 + (number % 37) as f32;
        let way = vec2(far, 20.0 - far);
        press(&mut harness, from, PointerButton::Middle);
        motion(&mut harness, from + way / 2.0);
        motion(&mut harness, from + way);
        release(&mut harness, from + way, PointerButton::Middle);
        assert!(harness.state().document.can_undo(), "drag {number}");
        key(&mut harness, Key::Z, true, Modifiers::CTRL);
        key(&mut harness, Key::Z, false, Modifiers::CTRL);
        assert_eq!(*harness.state().document.path(), before, "drag {number}");
    }
    harness.event(Event::PointerGone);
    println!("memory {at_first} {}", memory());
}

#[test]
fn drags_cost_no_memory() {
    let drags: u64 = std::env::var("VIDES_DRAGS").map_or(400, |drags| drags.parse().unwrap());
    let mut command = Command::new(std::env::current_exe().unwrap());
    command
        .args([
            "--exact",
            "space::memory_tests::a_process_that_drags",
            "--nocapture",
        ])
        .env(DRAGS, drags.to_string())
        .stdout(Stdio::piped());
    let done = started(&mut command).wait_with_output().unwrap();
    let said = String::from_utf8(done.stdout).unwrap();
    let (_, numbers) = said.split_once("memory ").expect("it came to its end");
    let numbers: Vec<u64> = numbers
        .split_whitespace()
        .take(2)
        .map(|number| number.parse().unwrap())
        .collect();
    let more = numbers[1].saturating_sub(numbers[0]);
    println!("{drags} drags: {} bytes, then {more} more", numbers[0]);
    assert!(
        more < ONCE + LEFT_BEHIND * drags,
        "{drags} drags leave {more} bytes behind"
    );
}
