//! What can be asked for in the window.

use std::path::PathBuf;

use egui::Pos2;
use glam::DVec3;
use vides_document::tool::Tool;
use vides_document::{Edit, Selection};
use vides_engine::limits::SPEEDS;
use vides_engine::path::UpVector;
use vides_engine::tools::check::Finding;
use vides_engine::tools::profile::Quantity;

use crate::entry::Entry;
use crate::playing::axis::Seen;
use crate::setup::{CameraPlace, Fold, Setup, Theme, View};
use crate::space::cameras::Camera;
use crate::state::files::{AfterSave, Purpose};
use crate::state::playing::tracks::KeyMotion;
use crate::state::playing::{Pace, Retiming};
use crate::state::scene_view::{KeyAt, NodeAction, NodeCommand};
use crate::state::selected::SelectionChange;
use crate::state::space::{Gesture, Joint};
use crate::texts::Language;

/// What a menu entry, a key, a button or a field stands for.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    /// Ask for a file and load a path from it.
    /// Begins an empty path.
    New,
    Load,
    /// Save under the known name, else ask for one.
    Save,
    SaveAs,
    Quit,
    Undo,
    Redo,
    /// `Pos.+`.
    AddPoint,
    /// `Pos.++`: ask how many.
    AskPoints,
    /// `Pos.++`: insert this many.
    AddPoints(usize),
    /// A key at the playhead.
    AddHere,
    /// `Pos.-`.
    RemovePoint,
    /// `<< Pos.`
    PreviousPoint,
    /// `Pos. >>`
    NextPoint,
    AppendPoint,
    PrependPoint,
    SwitchClosed,
    /// Give the point own tangents as they are now, or take its own away.
    OwnTangents(bool),
    /// How own tangents are joined.
    Join(Joint),
    /// `Ori.+`.
    AddOrientation,
    /// `Ori.-`.
    RemoveOrientation,
    /// `<< Ori`
    PreviousOrientation,
    /// `Ori >>`
    NextOrientation,
    /// `Abs.` (true) or `Rel.` (false).
    SetAbsolute(bool),
    /// Take away what the current orientation owns of this.
    ClearOverride(OwnedMotion),
    /// Let the current orientation look along the way.
    LookAhead,
    /// Let the current orientation show all of the object.
    ShowObject,
    SetUp(UpVector),
    /// Change between `Abs.` and `Rel.`.
    SwitchAbsolute,
    /// Let every orientation of the path look where the current one does.
    AimAll,
    /// Copy the selected points, or the current orientation.
    Copy,
    /// Copy the selected points, and remove them.
    Cut,
    /// Ask for what the clipboard has.
    Paste,
    /// The clipboard had this.
    Pasted(String),
    PasteOrientation,
    /// Open what was dropped on the window.
    Dropped(Vec<PathBuf>),
    LoadObject,
    Export,
    /// Write into this file, in the format of this name, whatever is lost.
    WriteAs(PathBuf, &'static str),
    Import,
    HandOver,
    /// Hand the poses over after each change, or no longer.
    SwitchHandsOver,
    /// Take over the host's view as a new point, or in place of the current orientation.
    TakeOver {
        replace: bool,
    },
    Tool(Tool),
    Check,
    /// Go to the frames and the key of a finding.
    GoTo(Finding),
    /// Several edits in one step.
    Edits(Vec<Edit>),
    /// Apply the remedy of a finding.
    Mend(Vec<Edit>),
    /// Let the planner cure a finding, beside the window.
    Cure(Finding),
    /// Show the path with the tool applied.
    PreviewTool,
    /// Show what the tool has made beside the window.
    ToolMade,
    /// Move a control point of the tool's cage.
    MoveControl {
        at: usize,
        place: DVec3,
    },
    /// Continue the line being drawn for the tool: in the camera's picture, and in space.
    DrawOn(Pos2, DVec3),
    /// Take or give up that line.
    EndDrawing {
        keeps: bool,
    },
    /// Give the tool a line that was drawn.
    Stroke(Vec<DVec3>),
    /// `OK` of the tool, or its cancellation.
    EndTool {
        keeps: bool,
    },
    Curve,
    SpeedCurve,
    Colours,
    Display,
    Space,
    LoadSetup,
    Recent(usize),
    /// Open unsaved work that was found, by its number in the window.
    Restore(usize),
    SaveSetup,
    /// Dark, light, or the desktop's.
    Theme(Option<Theme>),
    /// The sensor for which the zoom panel tells the lens, by its height in mm.
    SensorHeight(f64),
    /// Show or hide the camera's picture.
    SwitchCameraView,
    /// Put the camera's picture there, or back into its corner.
    CameraPlace(CameraPlace),
    /// Show this in the graph, or else the pace, or no longer.
    Plot(Option<Quantity>),
    /// Open or close the speeds of the whole path.
    SwitchSpeedGraph,
    /// See the camera's picture from there, or else from the path.
    Fly(Option<Camera>),
    PlayOrPause,
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
    /// Move the selected points before this one.
    MoveSelected(usize),
    AimAt(DVec3),
    /// Let every orientation look there.
    AimAllAt(DVec3),
    /// See the movement space from there.
    View(View),
    /// An entry into the play bar's frame.
    Playhead(Entry),
    SwitchLoops,
    SwitchOnlySelected,
    /// Keep the length of the path whatever is changed, or no longer.
    SwitchKeepsLength,
    /// What follows a key that is moved in time moves along, or no longer.
    SwitchMovesAlong,
    /// Move or copy a key in time, in place of what the open step has done.
    Retime(Retiming),
    /// Move or copy keys of the scene, likewise.
    MoveKeys(Box<KeyMotion>),
    /// Move a marker to a frame of the scene, likewise.
    MoveMarker {
        name: String,
        to: f64,
    },
    /// The ruler counts frames, or seconds.
    RulerInFrames(bool),
    /// Show this part of the time on the timeline, or all.
    See(Option<Seen>),
    GraphHeight(f32),
    /// How much of the space's room the camera's picture beside it takes.
    CameraShare(f32),
    /// Show the sliders around the space, or hide them.
    SwitchSliders,
    /// Show objects as lines, or shaded.
    SwitchWireframe,
    /// Fold a panel, or unfold it.
    Fold(Fold),
    Pace(Pace),
    Setup(Box<Setup>),
    /// A language of the window, or the environment's.
    Language(Option<Language>),
    CopySpeeds([f64; SPEEDS]),
    /// Apply what is pending in the curve window; true: and close it.
    ApplyCurve(bool),
    /// Apply what is pending in the space window; true: and close it.
    ApplySpace(bool),
    FileChosen(Purpose, PathBuf),
    /// Discard unsaved work that was found, by its number in the window.
    Discard(usize),
    SaveBefore(AfterSave),
    /// Go on, whatever is lost.
    GoOn(AfterSave),
    Reload,
    /// Save under another name, and then go on.
    SaveAsBefore(Option<AfterSave>),
    /// Overwrite the file that has changed, and then go on.
    Overwrite(Option<AfterSave>),
    /// Show a text in the output field.
    Say(String),
    /// Show what cannot be done in the output field.
    Complain(String),
}

impl Action {
    /// An entry into a number of the panels; `missing`: the path does not have it yet.
    pub(super) const fn enter(missing: bool, entry: Entry<Edit>) -> Self {
        if missing {
            Self::EnterMissing(entry)
        } else {
            Self::Enter(entry)
        }
    }

    /// Whether a menu, a key or a button names it, which clears the output field.
    pub(super) const fn is_command(&self) -> bool {
        !matches!(
            self,
            Self::Edit(_)
                | Self::Enter(_)
                | Self::EnterMissing(_)
                | Self::Gesture(_)
                | Self::Node(_)
                | Self::View(_)
                | Self::Playhead(_)
                | Self::SwitchLoops
                | Self::SwitchOnlySelected
                | Self::SwitchKeepsLength
                | Self::SwitchMovesAlong
                | Self::Retime(_)
                | Self::MoveKeys(_)
                | Self::MoveMarker { .. }
                | Self::SwitchSliders
                | Self::SwitchWireframe
                | Self::Fold(_)
                | Self::RulerInFrames(_)
                | Self::See(_)
                | Self::GraphHeight(_)
                | Self::CameraShare(_)
                | Self::Pace(_)
                | Self::SelectKeys(_)
                | Self::Setup(_)
                | Self::Language(_)
                | Self::CopySpeeds(_)
                | Self::ApplyCurve(_)
                | Self::ApplySpace(_)
                | Self::FileChosen(..)
                | Self::PreviewTool
                | Self::ToolMade
                | Self::Discard(_)
                | Self::SaveBefore(_)
                | Self::GoOn(_)
                | Self::Reload
                | Self::SaveAsBefore(_)
                | Self::Overwrite(_)
                | Self::Say(_)
                | Self::Complain(_)
        )
    }

    /// Whether a shown tool stays as it is. Any other action first takes what the tool shows.
    pub(super) const fn leaves_tool(&self) -> bool {
        matches!(
            self,
            Self::Tool(_)
                | Self::PreviewTool
                | Self::ToolMade
                | Self::EndTool { .. }
                | Self::MoveControl { .. }
                | Self::DrawOn(..)
                | Self::EndDrawing { .. }
                | Self::Stroke(_)
                | Self::Undo
                | Self::Enter(Entry::Idle | Entry::Wrong(_) | Entry::End)
                | Self::EnterMissing(Entry::Idle | Entry::Wrong(_) | Entry::End)
                | Self::Gesture(Gesture::Press(_) | Gesture::End | Gesture::Cancel)
                | Self::Check
                | Self::GoTo(_)
                | Self::Choose(_)
                | Self::Select(_)
                | Self::PreviousPoint
                | Self::NextPoint
                | Self::PreviousOrientation
                | Self::NextOrientation
                | Self::View(_)
                | Self::Playhead(_)
                | Self::PlayOrPause
                | Self::SwitchLoops
                | Self::SwitchOnlySelected
                | Self::SwitchKeepsLength
                | Self::SwitchMovesAlong
                | Self::SwitchSliders
                | Self::SwitchWireframe
                | Self::Fold(_)
                | Self::RulerInFrames(_)
                | Self::See(_)
                | Self::GraphHeight(_)
                | Self::CameraShare(_)
                | Self::Pace(_)
                | Self::Plot(_)
                | Self::Fly(_)
                | Self::SwitchCameraView
                | Self::Setup(_)
                | Self::Theme(_)
                | Self::SensorHeight(_)
                | Self::Language(_)
                | Self::Colours
                | Self::Display
                | Self::Keys
                | Self::Copy
                | Self::Paste
                | Self::CopySpeeds(_)
                | Self::FileChosen(Purpose::LoadBlock | Purpose::Import | Purpose::SaveBlock, _)
                | Self::Say(_)
                | Self::Complain(_)
        )
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
