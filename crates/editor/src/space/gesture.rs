//! The parts of a drag in the movement window, and what they change.

use glam::DVec3;
use vides_engine::path::Target;

use crate::number::decimals;
use crate::state::Editor;
use crate::state::space::{Gesture, Handle, NodeChange, Side};
use crate::texts::fill;

impl Editor {
    pub(crate) fn gesture(&mut self, gesture: Gesture) {
        match gesture {
            Gesture::Press(what) => {
                self.message = None;
                if what.is_some_and(Handle::is_of_path) {
                    // Every handle belongs to a key.
                    self.playing.leave();
                }
                if let Some(Handle::Point(at)) = what
                    && at != self.document.selection().point
                    && let Err(error) = self.select_among(at)
                {
                    self.complain_of(&error);
                }
            }
            Gesture::Begin => self.document.begin_step(),
            Gesture::Move(what, edit) => {
                if self.edit_selected(edit) {
                    self.tell_place(what);
                }
            }
            Gesture::Transform(edit, words) => {
                self.restart_step();
                if self.edit(edit) {
                    self.say(words);
                }
            }
            Gesture::Nodes(change, words) => {
                if self.change_nodes(change) {
                    self.say(words);
                }
            }
            Gesture::Refused(why) => self.complain(why),
            // The open step is the tool's: only the view or a control point was dragged.
            Gesture::End | Gesture::Cancel if self.windows.tool.is_some() => {}
            Gesture::End => {
                self.document.end_step();
                // The running coordinates give way to the pose; an error stays to be read.
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

    /// Changes nodes in the open step; false with a message if refused. What the step has done
    /// before is taken back then.
    fn change_nodes(&mut self, change: NodeChange) -> bool {
        let done = match change {
            NodeChange::Values(values) => {
                let mut all = values.into_iter();
                all.all(|(node, channel, value)| self.set_channel(node, &channel, &value))
            }
            NodeChange::Pivot(node, pivot) => {
                // From where it began, so that nothing adds up.
                self.restart_step();
                match self.pivot_edits(node, pivot) {
                    Ok(edits) => self.edit_together(edits),
                    Err(text) => {
                        self.complain(text);
                        false
                    }
                }
            }
            NodeChange::Key(node, key, value) => match self.key_edit(node, key, value) {
                Ok(edit) => self.edit(edit),
                Err(error) => {
                    self.complain_of(&error);
                    false
                }
            },
        };
        if !done {
            self.restart_step();
        }
        done
    }

    /// Shows in the output field where what is held is now.
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
            Handle::Control(_) | Handle::Node(_) | Handle::Key(..) => return,
            Handle::Tangent(side) => {
                let Some(own) = point.tangents else { return };
                let tangent = match side {
                    Side::Before => own.before,
                    Side::After => own.after,
                };
                place(texts.tangent_at, tangent)
            }
            Handle::Vup => fill(
                texts.roll_at,
                &[&self.language().number(orientation.roll, 1)],
            ),
        };
        self.say(text);
    }
}
