//! What can be asked for in the window.

mod file;
mod path;
mod time;
mod tool;

pub(crate) use file::FileAction;
pub(crate) use path::PathAction;
pub(crate) use time::TimeAction;
pub(crate) use tool::ToolAction;

use vides_document::{Edit, Selection};
use vides_engine::limits::SPEEDS;
use vides_engine::tools::check::Finding;

use crate::entry::Entry;
use crate::setup::{CameraPlace, Fold, Setup, Theme, View};
use crate::space::cameras::Camera;
use crate::state::scene_view::{KeyAt, NodeAction, NodeCommand};
use crate::state::selected::SelectionChange;
use crate::state::space::Gesture;
use crate::texts::Language;

/// What a menu entry, a key, a button or a field stands for.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    /// Something of files.
    File(FileAction),
    /// Something of the path's points and views.
    Path(PathAction),
    /// Something of the open tool.
    Tool(ToolAction),
    /// Something of the timeline.
    Time(TimeAction),
    Undo,
    Redo,
    /// Copy the selected points, or the current orientation.
    Copy,
    /// Copy the selected points, and remove them.
    Cut,
    /// Ask for what the clipboard has.
    Paste,
    /// The clipboard had this.
    Pasted(String),
    HandOver,
    /// Hand the poses over after each change, or no longer.
    SwitchHandsOver,
    Check,
    /// Go to the frames and the key of a finding.
    GoTo(Finding),
    /// Several edits in one step.
    Edits(Vec<Edit>),
    /// Apply the remedy of a finding.
    Mend(Finding, Vec<Edit>),
    /// Let the planner cure a finding, beside the window.
    Cure(Finding),
    Curve,
    SpeedCurve,
    Colours,
    Display,
    Space,
    /// Dark, light, or the desktop's.
    Theme(Option<Theme>),
    /// The sensor for which the zoom panel tells the lens, by its height in mm.
    SensorHeight(f64),
    /// Show or hide the camera's picture.
    SwitchCameraView,
    /// Put the camera's picture there, or back into its corner.
    CameraPlace(CameraPlace),
    /// See the camera's picture from there, or else from the path.
    Fly(Option<Camera>),
    Keys,
    /// Select nodes of the scene, the current one first; no step.
    SelectNodes(Vec<usize>),
    /// Do something to nodes of the scene.
    Nodes(NodeCommand),
    /// Show the current node's rotation by quaternions and by Euler angles.
    CompareRotations,
    /// Select keys of the scene; no step.
    SelectKeys(Vec<KeyAt>),
    /// Let a camera follow a path in place of its keys.
    KeysToPath(usize),
    /// Something in the panels of a node.
    Node(NodeAction),
    Edit(Edit),
    /// An entry into a number of the path.
    Enter(Entry<Edit>),
    /// The same for the key missing at the playhead, which is added first.
    EnterMissing(Entry<Edit>),
    /// A part of a drag in the movement window.
    Gesture(Gesture),
    Select(Selection),
    /// Select several points.
    Choose(SelectionChange),
    /// See the movement space from there.
    View(View),
    /// The share of the space's width that the camera's picture takes.
    CameraShare(f32),
    /// Show the sliders around the space, or hide them.
    SwitchSliders,
    /// Show objects as lines, or shaded.
    SwitchWireframe,
    /// Fold a panel, or unfold it.
    Fold(Fold),
    Setup(Box<Setup>),
    /// A language of the window, or the environment's.
    Language(Option<Language>),
    CopySpeeds([f64; SPEEDS]),
    /// Apply what is pending in the curve window; true: and close it.
    ApplyCurve(bool),
    /// Apply what is pending in the space window; true: and close it.
    ApplySpace(bool),
    /// Show a text in the output field.
    Say(String),
    /// Show what cannot be done in the output field.
    Complain(String),
}

/// Each kind as an action.
macro_rules! kinds {
    ($($kind:ident($action:ty))*) => { $(
        impl From<$action> for Action {
            fn from(action: $action) -> Self {
                Self::$kind(action)
            }
        }
    )* };
}

kinds! { File(FileAction) Path(PathAction) Tool(ToolAction) Time(TimeAction) }

impl Action {
    /// An entry into a number of the panels; `missing`: the path does not have it yet.
    pub(super) const fn enter(missing: bool, entry: Entry<Edit>) -> Self {
        if missing {
            Self::EnterMissing(entry)
        } else {
            Self::Enter(entry)
        }
    }

    /// Whether there is nothing to do it to on the first screen.
    pub(super) const fn needs_path(&self) -> bool {
        match self {
            Self::Path(action) => !matches!(action, PathAction::Begin(_)),
            Self::Copy
            | Self::Cut
            | Self::HandOver
            | Self::Check
            | Self::Curve
            | Self::SpeedCurve
            | Self::SwitchCameraView
            | Self::Choose(_)
            | Self::Time(_)
            | Self::Node(_)
            | Self::File(FileAction::Export) => true,
            _ => false,
        }
    }

    /// Whether a menu, a key or a button names it, which clears the output field.
    pub(super) const fn is_command(&self) -> bool {
        match self {
            Self::File(action) => action.is_command(),
            Self::Tool(action) => !matches!(action, ToolAction::Preview | ToolAction::Made),
            Self::Time(action) => matches!(
                action,
                TimeAction::PlayOrPause | TimeAction::Plot(_) | TimeAction::SwitchSpeedGraph
            ),
            Self::Edit(_)
            | Self::Enter(_)
            | Self::EnterMissing(_)
            | Self::Gesture(_)
            | Self::Node(_)
            | Self::View(_)
            | Self::SwitchSliders
            | Self::SwitchWireframe
            | Self::Fold(_)
            | Self::CameraShare(_)
            | Self::SelectKeys(_)
            | Self::Setup(_)
            | Self::Language(_)
            | Self::CopySpeeds(_)
            | Self::ApplyCurve(_)
            | Self::ApplySpace(_)
            | Self::Say(_)
            | Self::Complain(_) => false,
            _ => true,
        }
    }

    /// Whether a shown tool stays as it is. Any other action first takes what the tool shows.
    pub(super) const fn leaves_tool(&self) -> bool {
        match self {
            Self::Tool(_)
            | Self::Undo
            | Self::Enter(Entry::Idle | Entry::Wrong(_) | Entry::End)
            | Self::EnterMissing(Entry::Idle | Entry::Wrong(_) | Entry::End)
            | Self::Gesture(Gesture::Press(_) | Gesture::End | Gesture::Cancel)
            | Self::Check
            | Self::GoTo(_)
            | Self::Choose(_)
            | Self::Select(_)
            | Self::View(_)
            | Self::SwitchSliders
            | Self::SwitchWireframe
            | Self::Fold(_)
            | Self::CameraShare(_)
            | Self::Fly(_)
            | Self::SwitchCameraView
            | Self::Setup(_)
            | Self::Theme(_)
            | Self::SensorHeight(_)
            | Self::Language(_)
            | Self::Colours
            | Self::Display
            | Self::Keys
            | Self::HandOver
            | Self::SwitchHandsOver
            | Self::Copy
            | Self::Paste
            | Self::CopySpeeds(_)
            | Self::Say(_)
            | Self::Complain(_) => true,
            Self::File(action) => action.leaves_tool(),
            Self::Path(action) => action.selects(),
            Self::Time(action) => !action.takes_tool(),
            _ => false,
        }
    }
}

/// Something of a motion that an orientation may own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OwnedMotion {
    /// Angular velocities, a part of a turning, the slope of the roll.
    Turning,
    /// The slope of its zoom.
    Zoom,
}
