//! Converts X's buttons, motions and crossings to egui's events.
//!
//! Consecutive motions are merged; a motion before a button event gives its place. While a button
//! is held, the pointer belongs to the window, even outside it.

use egui::{
    Event, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Vec2,
};

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pointer {
    inside: bool,
    held: u8,
    /// egui knows a position.
    known: bool,
}

impl Pointer {
    /// A motion, in points.
    pub(super) fn moved(&mut self, pos: Pos2, out: &mut Vec<Event>) {
        self.known = true;
        match out.last_mut() {
            Some(Event::PointerMoved(last)) => *last = pos,
            _ => out.push(Event::PointerMoved(pos)),
        }
    }

    pub(super) fn entered(&mut self, pos: Pos2, out: &mut Vec<Event>) {
        self.inside = true;
        self.moved(pos, out);
    }

    /// The pointer left the window; reported to egui once no button is held.
    pub(super) fn left(&mut self, out: &mut Vec<Event>) {
        self.inside = false;
        self.forget(out);
    }

    /// A press or release by X's button number, from 1; 4 to 7 are the wheel.
    pub(super) fn button(
        &mut self,
        number: u8,
        pressed: bool,
        pos: Pos2,
        modifiers: Modifiers,
        out: &mut Vec<Event>,
    ) {
        let button = match number {
            1 => PointerButton::Primary,
            2 => PointerButton::Middle,
            3 => PointerButton::Secondary,
            8 => PointerButton::Extra1,
            9 => PointerButton::Extra2,
            4..=7 => {
                if pressed {
                    self.moved(pos, out);
                    out.push(wheel(number, modifiers));
                }
                return;
            }
            _ => return,
        };
        let bit = 1 << button as u8;
        if (self.held & bit != 0) == pressed {
            return; // from another device, or half of it was elsewhere
        }
        self.held ^= bit;
        self.moved(pos, out);
        out.push(Event::PointerButton {
            pos,
            button,
            pressed,
            modifiers,
        });
        self.forget(out);
    }

    /// Releases everything when the window vanishes under the pointer.
    pub(super) fn lost(&mut self, pos: Pos2, modifiers: Modifiers, out: &mut Vec<Event>) {
        for button in [1, 2, 3, 8, 9] {
            self.button(button, false, pos, modifiers, out);
        }
        self.left(out);
    }

    fn forget(&mut self, out: &mut Vec<Event>) {
        if !self.inside && self.held == 0 && self.known {
            self.known = false;
            out.push(Event::PointerGone);
        }
    }
}

fn wheel(number: u8, modifiers: Modifiers) -> Event {
    let delta = match number {
        4 => Vec2::new(0.0, 1.0),
        5 => Vec2::new(0.0, -1.0),
        6 => Vec2::new(1.0, 0.0),
        _ => Vec2::new(-1.0, 0.0),
    };
    Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta,
        phase: TouchPhase::Move,
        source: MouseWheelSource::Unknown,
        modifiers,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    const NONE: Modifiers = Modifiers::NONE;

    fn press(button: PointerButton, pressed: bool, pos: Pos2) -> Event {
        Event::PointerButton {
            pos,
            button,
            pressed,
            modifiers: NONE,
        }
    }

    #[test]
    fn of_motions_the_last_before_a_button_counts() {
        let (mut pointer, mut out) = (Pointer::default(), Vec::new());
        pointer.entered(pos2(1.0, 1.0), &mut out);
        for i in 2..50 {
            pointer.moved(pos2(i as f32, 1.0), &mut out);
        }
        pointer.button(1, true, pos2(49.0, 1.0), NONE, &mut out);
        pointer.moved(pos2(60.0, 1.0), &mut out);
        pointer.moved(pos2(61.0, 1.0), &mut out);
        assert_eq!(
            out,
            [
                Event::PointerMoved(pos2(49.0, 1.0)),
                press(PointerButton::Primary, true, pos2(49.0, 1.0)),
                Event::PointerMoved(pos2(61.0, 1.0)),
            ]
        );
    }

    #[test]
    fn a_drag_goes_on_outside() {
        let (mut pointer, mut out) = (Pointer::default(), Vec::new());
        let (inner, outer) = (pos2(5.0, 5.0), pos2(-50.0, 900.0));
        pointer.entered(inner, &mut out);
        pointer.button(3, true, inner, NONE, &mut out);
        pointer.left(&mut out);
        pointer.moved(outer, &mut out);
        assert!(!out.contains(&Event::PointerGone));
        out.clear();
        pointer.button(3, false, outer, NONE, &mut out);
        let released = press(PointerButton::Secondary, false, outer);
        assert_eq!(
            out,
            [Event::PointerMoved(outer), released, Event::PointerGone]
        );
        out.clear();
        pointer.left(&mut out); // the server may say so again
        assert_eq!(out, []);
    }

    #[test]
    fn three_buttons_and_a_wheel() {
        let (mut pointer, mut out) = (Pointer::default(), Vec::new());
        let at = pos2(3.0, 4.0);
        pointer.entered(at, &mut out);
        for (number, button) in [
            (1, PointerButton::Primary),
            (2, PointerButton::Middle),
            (3, PointerButton::Secondary),
            (8, PointerButton::Extra1),
            (9, PointerButton::Extra2),
        ] {
            for pressed in [true, false] {
                out.clear();
                pointer.button(number, pressed, at, Modifiers::CTRL, &mut out);
                let expected = Event::PointerButton {
                    pos: at,
                    button,
                    pressed,
                    modifiers: Modifiers::CTRL,
                };
                assert_eq!(out.last(), Some(&expected));
            }
        }
        for (number, x, y) in [(4, 0.0, 1.0), (5, 0.0, -1.0), (6, 1.0, 0.0), (7, -1.0, 0.0)] {
            out.clear();
            pointer.button(number, true, at, NONE, &mut out);
            pointer.button(number, false, at, NONE, &mut out);
            assert_eq!(out.len(), 2);
            assert!(matches!(out[1], Event::MouseWheel { delta, .. } if delta == Vec2::new(x, y)));
        }
        out.clear();
        pointer.button(200, true, at, NONE, &mut out);
        pointer.button(1, false, at, NONE, &mut out);
        assert_eq!(out, [], "unknown buttons, and releases without a press");
    }

    #[test]
    fn a_vanishing_window_lets_go() {
        let (mut pointer, mut out) = (Pointer::default(), Vec::new());
        let at = pos2(3.0, 4.0);
        pointer.entered(at, &mut out);
        pointer.button(1, true, at, NONE, &mut out);
        out.clear();
        pointer.lost(at, NONE, &mut out);
        let released = press(PointerButton::Primary, false, at);
        assert_eq!(out, [Event::PointerMoved(at), released, Event::PointerGone]);
    }
}
