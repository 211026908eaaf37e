//! The section whose speeds are shown, the room for them, and entries into it.

use vides_engine::limits::SPEEDS;
use vides_engine::path::joint::Neighbour;
use vides_engine::path::speed_curve::CurveEnd;
use vides_engine::path::{Orientation, OrientationOverrides, Pace, Timing};

use crate::action::Action;
use crate::entry::Entry;
use crate::state::{Editor, with};
use crate::windows::sub_window::{is_cramped, is_low};

/// Room for the values left of the picture.
pub(crate) const SCALE: f32 = 32.0;

/// Height of all about the picture and its rows.
pub(crate) const ABOUT: f32 = 64.0;

/// Sizes of the picture, in points.
#[derive(Clone, Copy)]
pub(crate) struct Size {
    /// From one square to the next.
    pub(crate) step: f32,
    pub(crate) height: f32,
    /// All buttons stand in one row.
    pub(crate) one_row: bool,
}

impl Size {
    pub(crate) const ROOMY: Self = Self {
        step: 48.0,
        height: 160.0,
        one_row: true,
    };
    pub(crate) const CRAMPED: Self = Self {
        step: 40.0,
        height: 112.0,
        one_row: false,
    };

    pub(crate) fn of(context: &egui::Context) -> Self {
        if is_low(context) {
            // The numbers below it matter more than its height.
            let height = 88.0;
            Self {
                height,
                ..Self::CRAMPED
            }
        } else if is_cramped(context) {
            Self::CRAMPED
        } else {
            Self::ROOMY
        }
    }

    /// Half a step lies outside each outermost facing value.
    pub(crate) fn width(self) -> f32 {
        SCALE + self.step * 12.0
    }
}

pub(crate) struct Section {
    pub(crate) speeds: [f64; SPEEDS],
    pub(crate) before: Option<f64>,
    pub(crate) after: Option<f64>,
    pub(crate) pace: Pace,
    pub(crate) timing: Timing,
    pub(crate) hold: u32,
    /// Frames without the hold; `None` at the end of the path.
    pub(crate) frames: Option<usize>,
    /// The fixed number of frames, whatever the length; 0: none.
    pub(crate) fixed: u32,
    /// They stay when the whole path gets others.
    pub(crate) locked: bool,
    /// How much faster it is because it has fewer frames than its length asks for.
    pub(crate) scale: f64,
    /// How long it takes; 1 if no time.
    pub(crate) seconds: f64,
    /// The point and orientation where it ends.
    pub(crate) to: Option<(usize, usize)>,
}

impl Section {
    pub(crate) fn of(editor: &Editor) -> Option<Self> {
        let orientation = editor.orientation()?;
        let at = editor.document.selection();
        let path = editor.document.path();
        let (facing, frames, unrounded) = editor
            .document
            .timeline(
                |timeline| match timeline.section_from(at.point, at.orientation) {
                    Some(section) => (
                        timeline.facing_speeds(path, section),
                        Some(timeline.section(section).frames),
                        timeline.unrounded_frames(path, section),
                    ),
                    None => {
                        let end = timeline.section_count();
                        (timeline.facing_speeds(path, end), None, 0.0)
                    }
                },
            )
            .ok()?;
        let (before, after) = facing;
        let last = path.points.get(at.point)?.orientations.len() == at.orientation + 1;
        let to = match (frames, last) {
            (None, _) => None,
            (Some(_), true) => Some(((at.point + 1) % path.points.len(), 0)),
            (Some(_), false) => Some((at.point, at.orientation + 1)),
        };
        let moves = frames
            .filter(|&frames| frames > 0)
            .map(|frames| frames as f64);
        Some(Self {
            timing: timing(editor, orientation)?,
            pace: orientation.own.pace.clone(),
            speeds: orientation.speeds,
            before,
            after,
            hold: orientation.hold,
            fixed: orientation.own.frames,
            locked: orientation.own.locked,
            scale: moves.map_or(1.0, |frames| unrounded / frames),
            seconds: moves.map_or(1.0, |frames| frames / editor.document.info().fps),
            frames,
            to,
        })
    }
}

/// The pace of the selected section if it began with this orientation.
pub(super) fn timing(editor: &Editor, orientation: &Orientation) -> Option<Timing> {
    let (at, path) = (editor.document.selection(), editor.document.path());
    let made = editor.document.timeline(|timeline| {
        let Some(section) = timeline.section_from(at.point, at.orientation) else {
            let (before, _) = timeline.facing_speeds(path, timeline.section_count());
            return Timing::new(orientation, [before.into(), CurveEnd::Free]);
        };
        let [before, after] = timeline.neighbours(path, section);
        let work = timeline.neighbour(path, section).work;
        Neighbour { orientation, work }.timing(before, after)
    });
    made.ok()?.ok()
}

/// Whether a section goes by its ten speeds, or by a pace that they are near.
pub(crate) const fn goes_by_ten(pace: &Pace) -> bool {
    matches!(pace, Pace::Speeds | Pace::Part(_))
}

/// An entry into a number of the current orientation.
pub(crate) fn entered(
    editor: &Editor,
    entry: Entry,
    change: impl FnOnce(&mut Orientation, f64),
) -> Option<Action> {
    let (at, current) = (editor.document.selection(), editor.orientation()?);
    let edit = |value| with(at, current, |new| change(new, value));
    Some(Action::Enter(entry.map(edit)))
}

impl Editor {
    /// The same for a number by its key in files.
    pub(crate) fn entered(&self, entry: Entry, key: &str) -> Option<Action> {
        let (at, current) = (self.document.selection(), self.orientation()?);
        let edit = |value| self.with_number(at, current, key, value);
        Some(Action::Enter(entry.try_map(edit)))
    }
}

/// The same for what it owns.
pub(crate) fn entered_own(
    editor: &Editor,
    entry: Entry,
    change: impl FnOnce(&mut OrientationOverrides, f64),
) -> Option<Action> {
    let (at, current) = (editor.document.selection(), editor.orientation()?);
    Some(Action::Enter(entry.try_map(|value| {
        editor.with_own(at, current, |own| change(own, value))
    })))
}
