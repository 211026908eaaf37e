//! The one count of frames: the playhead and the axis are the scene's, whatever node is selected; an
//! edited path counts its own, and people see the number that the first frame has.

use egui::Context;

use vides_document::Selection;

use super::axis::Axis;
use super::zoom;
use crate::playing::axis::as_frame;
use crate::state::Editor;
use crate::state::playing::Mark;

/// A part of a frame that is rounding.
const HAIR: f64 = 1e-6;

impl Editor {
    #[allow(clippy::cast_possible_truncation)]
    pub(crate) fn shown_frame(&self) -> Option<i64> {
        let frame = self.playing.frame?.round() as i64;
        Some(frame - 1 + i64::from(self.document.info().first_frame))
    }

    /// The scene's frame of the edited path's first one; without a path that of the scene, which is
    /// not searched in all nodes each time.
    fn start_of_path(&self) -> f64 {
        match self.document.edited_scene().map(|edited| edited.node()) {
            Some(None) => self.playing.marks.range.0,
            _ => self.document.start_frame(),
        }
    }

    /// A frame of the scene as one of the edited path, which may not have begun or be over.
    pub(crate) fn frame_on_path(&self, frame: f64) -> f64 {
        match self.document.edited_scene() {
            Some(_) => nearly_whole(frame - self.start_of_path() + 1.0),
            None => frame,
        }
    }

    /// The frame of the edited path that is seen at one of the scene.
    pub(super) fn seen_on_path(&self, frame: f64) -> Option<f64> {
        match self.document.edited_scene().map(|edited| edited.node()) {
            Some(Some(_)) => Some(nearly_whole(self.document.seen_frame_of_path(frame).ok()?)),
            _ => Some(self.frame_on_path(frame)),
        }
    }

    /// The axis as the edited path counts.
    pub(super) fn axis_of_path(&self, axis: &Axis) -> Axis {
        match self.document.edited_scene() {
            Some(_) => {
                let more = 1.0 - self.start_of_path();
                axis.counted(more, as_frame(self.playing.marks.frames))
            }
            None => *axis,
        }
    }

    /// A frame of the scene in the number that people see.
    pub(crate) fn frame_for_people(&self, frame: f64) -> String {
        let frame = nearly_whole(frame) - 1.0 + f64::from(self.document.info().first_frame);
        match frame.fract() == 0.0 {
            true => frame.to_string(),
            false => self.language().number(frame, 1),
        }
    }

    /// The scene's frames of the edited path's first and last pose, if the playhead is not between
    /// them.
    pub(crate) fn outside_path(&self) -> Option<(f64, f64)> {
        self.document.edited_scene()?.node()?;
        let at = self.frame_on_path(self.playing.frame?);
        let last = as_frame(self.playing.marks.frames);
        (!(1.0..=last).contains(&at)).then(|| {
            let of_scene = |frame| self.document.frame_of_scene(frame);
            (of_scene(1.0), of_scene(last))
        })
    }

    /// The frames that are played: all, or those in which what is selected moves.
    pub(super) fn played(&self) -> (f64, f64) {
        let all = self.playing.marks.range;
        if !self.playing.only_selected {
            return all;
        }
        let within = zoom::of_nodes(self).map(|(first, last)| (first.max(all.0), last.min(all.1)));
        within.filter(|(first, last)| first < last).unwrap_or(all)
    }

    /// Plays only what is selected, or all again.
    pub(crate) fn switch_only_selected(&mut self, context: &Context) {
        self.playing.only_selected = !self.playing.only_selected;
        let (first, last) = self.played();
        if self.playing.is_playing() {
            self.playing.frame = Some(self.position_on_bar().clamp(first, last));
        }
        self.go_on_from_here(context);
    }

    pub(super) fn put_playhead(&mut self, frame: f64) {
        // The path may have changed since they were shown; too many frames leave it without marks.
        let _ = self.playing.marks.update(&self.document);
        let (first, last) = self.playing.marks.range;
        self.playing.frame = Some(frame.clamp(first, last));
    }

    /// The frame of the path in which a point is reached.
    pub(crate) fn frame_of_point(&mut self, point: usize) -> Option<f64> {
        self.playing.marks.update(&self.document).ok()?;
        let mark = self.playing.mark_of(Selection {
            point,
            orientation: 0,
        });
        mark.map(Mark::first)
    }

    /// Has the playhead at a frame, whatever is edited now, and goes on playing.
    pub(crate) fn stay_at(&mut self, frame: f64) {
        self.put_playhead(frame);
        if self.playing.is_playing() {
            self.playing.selection = self.document.selection();
        } else {
            self.select_at_playhead();
        }
    }
}

/// Rounded, if it is whole except for rounding errors.
fn nearly_whole(frame: f64) -> f64 {
    let whole = frame.round();
    if (frame - whole).abs() < HAIR {
        whole
    } else {
        frame
    }
}

#[cfg(test)]
#[path = "moment_tests.rs"]
mod tests;
