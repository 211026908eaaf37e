//! Which sub-windows are open, and what is pending in them.

use std::cell::Cell;

use egui::{Color32, Id, Pos2, Rect, Vec2};
use glam::DVec3;
use vides_document::tool::{Cage, Made, Tool, ToolInput};
use vides_document::{Document, Edit, Note, Selection};
use vides_engine::path::Space;
use vides_engine::scene::Track;
use vides_engine::tools::check::Finding;
use vides_engine::tools::fit::{PoseDeviation, Report, Tolerance};

use crate::background::Background;
use crate::setup::{Colours, Element, Shown};
use crate::state::files::{FileWindow, Question, RecoveryWindow};
use crate::windows::curve::pending::{Belonging, Pending};

#[derive(Debug)]
pub(crate) struct ParentWindow {
    pub(crate) nodes: Vec<usize>,
    pub(crate) parent: Option<usize>,
    /// [`vides_document::EditedScene::number`] of the scene that it asks about.
    pub(crate) number: u64,
    /// Whom it asks about.
    pub(crate) text: String,
    /// Why their way cannot be kept.
    pub(crate) refused: Option<String>,
}

#[derive(Debug)]
pub(crate) struct ColourWindow {
    pub(crate) element: Element,
    /// The colour before a number was dragged.
    pub(crate) before: Option<Color32>,
    /// What Escape gives back: the colours of both themes.
    pub(crate) before_all: (Colours, Colours),
}

#[derive(Debug)]
pub(crate) struct DisplayWindow {
    /// What Escape gives back.
    pub(crate) before: (Shown, bool),
}

#[derive(Debug, Default)]
pub(crate) struct CheckWindow {
    /// The revision that was checked.
    pub(crate) checked: Option<u64>,
    pub(crate) found: Vec<Finding>,
    /// What helps with each of those that are listed.
    /// None: the planner finds it when it is asked for.
    pub(crate) mends: Vec<Option<Vec<Edit>>>,
    pub(crate) notes: Vec<Note>,
    pub(crate) limits: bool,
    pub(crate) trouble: Option<String>,
    /// A check was asked for.
    pub(crate) asked: bool,
    /// What is found at a revision, beside the window.
    pub(crate) checking: Option<(u64, Background<Vec<Finding>>)>,
    /// The revision at which one was fixed, and the number of findings before.
    pub(crate) mended: Option<u64>,
    pub(crate) before: Option<usize>,
    /// What the planner makes of a finding beside the window.
    pub(crate) curing: Option<(Finding, Background<Vec<Edit>>)>,
}

#[derive(Debug, Default)]
pub(crate) struct CompareWindow {
    /// Smoothly through the keys; none: as the track is at first.
    pub(crate) smooth: Option<bool>,
    pub(crate) made: Option<Compared>,
}

/// A rotation in two ways.
#[derive(Debug)]
pub(crate) struct Compared {
    /// Node, number and revision of the document, whether it is smooth.
    pub(crate) of: (usize, (u64, u64), bool),
    /// By quaternions and by angles.
    pub(crate) both: [Track; 2],
    /// The scene's first and last frame.
    pub(crate) range: (f64, f64),
    /// Degrees between the two, from the first frame on, at this spacing in frames.
    pub(crate) angles: Vec<f64>,
    pub(crate) every: f64,
    /// The largest, and its frame.
    pub(crate) largest: (f64, f64),
}

#[derive(Debug)]
pub(crate) struct CurveWindow {
    pub(crate) pending: Pending,
    pub(crate) belonging: Belonging,
    /// The values when a drag began, put back by Escape.
    pub(crate) dragged: Option<Pending>,
    /// A button was pressed: what was being typed arrives one pass later.
    pub(crate) pressed: Option<Button>,
}

/// Which docked windows are open, and where the last one is seen.
#[derive(Debug, Default)]
pub(crate) struct Dock {
    /// In the order in which they were opened.
    pub(crate) order: Vec<&'static str>,
    /// The one that this pass shows, and its place.
    pub(crate) shown: Option<(&'static str, Rect)>,
    /// It has just come: the keyboard goes to what keeps.
    pub(crate) fresh: Cell<bool>,
}

#[derive(Debug)]
pub(crate) struct HelpWindow {
    /// Only rows with these words are shown.
    pub(crate) search: String,
    /// How far to scroll, in pages.
    pub(crate) pages: f32,
}

/// A number picks: clicked, or typed with 0 for ten.
#[derive(Debug)]
pub(crate) struct PointsWindow {
    /// It has just opened, and takes the keyboard.
    pub(crate) fresh: bool,
}

#[derive(Debug)]
pub(crate) struct SpaceWindow {
    /// What the document had when it was last looked at.
    pub(crate) of: (Space, String),
    pub(crate) space: Space,
    pub(crate) unit: String,
    /// The path is fitted into the new space.
    pub(crate) fit: bool,
    /// The space before a number of it is dragged.
    pub(crate) before: Option<Space>,
}

/// What is held: its id, and the pointer's distance from its middle.
pub(crate) type Held = Option<(Id, Vec2)>;

/// What the picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Speed,
    /// Percent of the way.
    Distance,
    /// Change of the speed per second.
    Acceleration,
}

#[derive(Debug)]
pub(crate) struct SpeedWindow {
    /// What the picture shows.
    pub(crate) shown: Quantity,
    pub(crate) held: Held,
    /// The square of the ten speeds that was chosen by an arrow key.
    pub(crate) choose: Option<usize>,
    /// The key of a given distance whose numbers are shown.
    pub(crate) key: usize,
    /// The key for which Delete was pressed.
    pub(crate) removed: Option<usize>,
    /// The frames given to a section along with its distance, so that it takes as long as before.
    pub(crate) fixed: Option<(Selection, u32)>,
}

/// How well a path follows recorded poses.
#[derive(Debug)]
pub(crate) struct FitShown {
    /// The given one, or the least that leads to the number of points.
    pub(crate) tolerance: Tolerance,
    pub(crate) report: Report,
    /// Over the time, at the first frame of each place.
    pub(crate) places: Vec<PoseDeviation>,
    /// Indices of the poses that do not count, in order.
    pub(crate) left_out: Vec<usize>,
}

#[derive(Debug)]
pub(crate) struct ToolWindow {
    pub(crate) tool: Tool,
    pub(crate) material: ToolInput,
    pub(crate) numbers: Vec<f64>,
    /// The numbers before one of them is dragged.
    pub(crate) before: Option<Vec<f64>>,
    /// Why the numbers will not do.
    pub(crate) trouble: Option<String>,
    /// The document without the tool, while the path is shown with the tool applied.
    pub(crate) unapplied: Option<Box<Document>>,
    /// The cage with which it deforms, and its control point that the fields show.
    pub(crate) cage: Option<Cage>,
    pub(crate) control: usize,
    /// A line being drawn in the camera's picture: its places there, and in space.
    pub(crate) drawn: Vec<(Pos2, DVec3)>,
    /// Points and frames of what is to be written to a file.
    pub(crate) written: Option<[usize; 2]>,
    /// How well the shown path follows recorded poses.
    pub(crate) fit: Option<FitShown>,
    /// The numbers that were last previewed.
    pub(crate) asked: Vec<f64>,
    /// What the tool makes beside the window.
    pub(crate) work: Option<Background<Made>>,
    /// The frame of the path in which it begins, if it is put into the path.
    pub(crate) from: Option<f64>,
    /// Where the playhead stood.
    pub(crate) stood: (Option<f64>, Selection),
}

/// Which of them are open, and what is pending in them.
#[derive(Debug, Default)]
pub(crate) struct Windows {
    pub(crate) dock: Dock,
    /// How many paths were loaded in place of the first.
    pub(crate) paths: u64,
    pub(crate) curve: Option<CurveWindow>,
    pub(crate) speed: Option<SpeedWindow>,
    /// Ten speeds to be pasted.
    pub(crate) copied_speeds: Option<[f64; vides_engine::limits::SPEEDS]>,
    pub(crate) colours: Option<ColourWindow>,
    pub(crate) display: Option<DisplayWindow>,
    pub(crate) points: Option<PointsWindow>,
    pub(crate) space: Option<SpaceWindow>,
    pub(crate) help: Option<HelpWindow>,
    pub(crate) check: Option<CheckWindow>,
    pub(crate) compare: Option<CompareWindow>,
    /// It shows what is in the open step of the document.
    pub(crate) tool: Option<ToolWindow>,
    /// What moving nodes keep in another parent.
    pub(crate) parent: Option<ParentWindow>,
    /// A file is being chosen: modal.
    pub(crate) files: Option<FileWindow>,
    /// A path that was dropped, while there is that question.
    pub(crate) dropped: Option<std::path::PathBuf>,
    /// A question before unsaved work is lost: modal.
    pub(crate) question: Option<Question>,
    /// A question about a file that has changed: modal.
    pub(crate) changed: Option<Question>,
    /// Unsaved work that was left behind is offered.
    pub(crate) recovery: Option<RecoveryWindow>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Button {
    Show,
    Ok,
}
