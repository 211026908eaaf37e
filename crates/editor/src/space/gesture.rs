//! What a hand does in the movement window, and what that changes.

use glam::DVec3;

use super::drag::Handle;
use crate::document::Edit;
use crate::number::decimals;
use crate::path::Target;
use crate::state::Editor;
use crate::texts::fill;

/// A part of a drag, by mouse or by keys: what is moved is one step to be taken back.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Gesture {
    /// A button goes down, on a handle perhaps.
    Press(Option<Handle>),
    /// What is held begins to move.
    Begin,
    /// It moves.
    Move(Handle, Edit),
    /// It stays where it is.
    End,
    /// It goes back.
    Cancel,
}

impl Editor {
    pub(crate) fn gesture(&mut self, gesture: Gesture) {
        match gesture {
            Gesture::Press(what) => {
                self.message = None;
                if what.is_some() {
                    // All that can be taken hold of belongs to a key.
                    self.playing.leave();
                }
                if let Some(Handle::Point(at)) = what
                    && at != self.document.selection().point
                    && let Err(error) = self.document.select(at, 0)
                {
                    self.complain_of(&error);
                }
            }
            Gesture::Begin => self.document.begin_step(),
            Gesture::Move(what, edit) => {
                if self.edit(edit) {
                    self.tell_place(what);
                }
            }
            Gesture::End => {
                self.document.end_step();
                // The running coordinates give way to the pose; what could not be done
                // stays to be read.
                self.message.take_if(|message| !message.error);
                if self.message.is_none() {
                    self.tell_ambiguities();
                }
            }
            Gesture::Cancel => {
                self.document.cancel_step();
                self.message = None;
            }
        }
    }

    /// Shows in the output field where what is held has come to.
    fn tell_place(&mut self, what: Handle) {
        let Some((point, orientation)) = self.point().zip(self.orientation()) else {
            return;
        };
        let texts = &self.texts().space;
        let decimals = decimals(self.document.path().space.half_size);
        let number = |value: f64| self.language().number(value, decimals);
        let place = |text: &str, v: DVec3| fill(text, &[&number(v.x), &number(v.y), &number(v.z)]);
        let text = match what {
            Handle::Point(_) => place(texts.position_at, point.position),
            Handle::Vpn => match orientation.target {
                Target::Absolute(target) => place(texts.target_at, target),
                Target::Relative(offset) => place(texts.offset_at, offset),
            },
            Handle::Vup => fill(
                texts.roll_at,
                &[&self.language().number(orientation.roll, 1)],
            ),
        };
        self.say(text);
    }
}
