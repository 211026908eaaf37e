//! The state of one window: what is edited and what is seen of it.

pub(crate) mod files;
pub(crate) mod host;
pub(crate) mod length;
pub(crate) mod obstacles;
pub(crate) mod playing;
pub(crate) mod points_list;
pub(crate) mod scene_view;
pub(crate) mod selected;
pub(crate) mod space;
pub(crate) mod windows;

use std::path::PathBuf;

use vides_document::error::{EngineError, Error, Result};
use vides_document::{Document, Edit, Fingerprint, Selection};
use vides_engine::limits;
use vides_engine::path::{Orientation, OrientationOverrides, Pose, SupportPoint};

use crate::action::{Action, FileAction};
use crate::background::Start;
use crate::entry::Entry;
use crate::files::folders::Folders;
use crate::files::recovery::Autosave;
use crate::host::program::Program;
use crate::host::warning::Warnings;
use crate::setup::{Element, Setup, View};
use crate::space::cameras::Camera;
use crate::state::files::{AfterSave, Order, Pictures, Question};
use crate::state::host::{HostPane, PlayheadState};
use crate::state::length::Length;
use crate::state::obstacles::Obstacles;
use crate::state::selected::Selected;
use crate::state::space::Around;
use crate::texts::refusals::reason_of;
use crate::texts::{Language, Texts, fill};
use crate::theme;

/// How a window begins.
#[derive(Debug)]
pub struct Options {
    /// The path to be edited, or a scene with it; its object is shown.
    pub document: Document,
    /// The file that the path came from.
    pub file: Option<PathBuf>,
    /// What follows `VIDES` in the title; the file's name if none.
    pub title: Option<String>,
    /// The window's language unless the user has set one up; the environment's if none.
    pub language: Option<Language>,
    /// The host takes poses that are handed over directly.
    pub host_takes_poses: bool,
    /// The base speeds are the host's: a loaded file's are ignored.
    pub fixed_speeds: bool,
    /// Where setup, unsaved work and recent files are kept.
    pub folders: Folders,
    /// Whose window it is.
    pub program: Program,
    /// The host's own view.
    pub host_view: HostView,
}

/// What a window knows at first of the host's own view (its camera in its picture).
#[derive(Clone, Debug, Default)]
pub struct HostView {
    /// What the window calls it; by default `program`.
    pub name: Option<String>,
    /// The host can be asked for it.
    pub captures: bool,
    /// The host draws what the camera sees.
    pub fills_pane: bool,
    /// The host's picture shows its own view at first: it receives the camera at the playhead only
    /// when that has changed.
    pub keeps_view: bool,
}

/// Why the host receives the camera at the playhead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Another point, orientation or camera became current.
    Selected,
    /// Something is being dragged or was changed.
    Edited,
    /// Another frame was chosen.
    Scrubbed,
    /// It plays.
    Played,
    /// Nothing moves any more; the last after a series of the others.
    Rested,
}

/// What only the program around the editor can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// Hand the poses over to the host.
    HandOver,
    /// Give its view, for [`Editor::take_over`].
    Capture {
        /// In place of the current orientation.
        replace: bool,
    },
    /// Close the window: unsaved work was asked about, but the host may refuse.
    Close,
}

/// The contents of one window.
pub struct Editor {
    pub(super) document: Document,
    pub(super) file: Option<PathBuf>,
    /// The title given by the host.
    pub(super) title: Option<String>,
    /// The window's language unless the setup has one.
    pub(super) given_language: Language,
    pub(super) host_takes_poses: bool,
    pub(super) fixed_speeds: bool,
    pub(super) folders: Folders,
    pub(super) program: Program,
    pub(super) host_view: HostView,
    /// The host's camera as it was shown last.
    pub(super) ghost: Option<Pose>,
    /// Where the camera of the picture has flown, and what was shown then.
    pub(super) flown: Option<(Camera, PlayheadState)>,
    /// Poses are handed over after each change.
    pub(super) auto_hand_over: bool,
    pub(super) host_pane: Option<HostPane>,
    /// The share of the space's width that the camera's picture takes.
    pub(super) camera_share: f32,
    /// What the file contained when it was last read or written here, if there was one.
    pub(super) known: Option<Fingerprint>,
    /// The file's time and length when it was last looked at.
    pub(super) written: Option<(std::time::SystemTime, u64)>,
    /// The state last handed over, where a hand-over saves.
    pub(super) handed_state: Option<u64>,
    pub(super) obstacles: Obstacles,
    /// The view that was copied last.
    pub(super) copied: Option<Copied>,
    /// The points selected together with the current one.
    pub(super) selected: Selected,
    /// How own tangents are joined, as chosen for this point.
    pub(super) joint: (usize, space::Joint),
    /// Where the last file was chosen.
    pub(super) last_folder: Option<PathBuf>,
    /// In which order files were listed last.
    pub(super) file_order: Order,
    /// Where the last block was chosen.
    pub(super) block_folder: Option<PathBuf>,
    /// What is to be done once the text being typed has been applied.
    pub(super) waiting: Option<Action>,
    pub(super) typing: bool,
    /// Shown in the output field instead of the current pose.
    pub(super) message: Option<Message>,
    pub(super) length: Length,
    pub(super) requests: Vec<Request>,
    /// How threads are started; none: all is done at once.
    pub(super) start: Option<Start>,
    /// The desktop asks for no animations.
    pub(super) still: bool,
    pub(super) setup: Setup,
    /// The view of the movement space with which a document is shown at first.
    pub(super) first_view: View,
    pub(super) space: space::MovementWindow,
    pub(super) scene_view: scene_view::SceneView,
    pub(super) playing: playing::Playing,
    pub(super) points_list: points_list::PointsList,
    pub(super) windows: windows::Windows,
    pub(super) recent: Vec<PathBuf>,
    pub(super) recent_pictures: Pictures<Vec<PathBuf>>,
    pub(super) begin_pictures: Pictures<Around>,
    pub(super) autosave: Option<Autosave>,
    /// Closing was asked for, and nothing has happened since.
    pub(super) closing: bool,
}

/// A line for the output field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Message {
    pub(super) text: String,
    /// It says what could not be done.
    pub(super) error: bool,
    /// It offers to undo the step that led to this state.
    pub(super) undoes: Option<u64>,
}

impl Editor {
    /// The contents of a window that opens.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn new(options: Options) -> Result<Self> {
        let known = options.document.fingerprint();
        let mut editor = Self {
            written: None,
            known: known.filter(|_| options.file.is_some()),
            handed_state: None,
            document: options.document,
            file: options.file,
            title: options.title,
            given_language: options.language.unwrap_or_else(Language::of_environment),
            host_takes_poses: options.host_takes_poses,
            fixed_speeds: options.fixed_speeds,
            folders: options.folders,
            program: options.program,
            host_view: options.host_view,
            ghost: None,
            flown: None,
            auto_hand_over: false,
            host_pane: None,
            camera_share: 0.5,
            obstacles: Obstacles::default(),
            copied: None,
            selected: Selected::default(),
            joint: Default::default(),
            last_folder: None,
            file_order: Order::default(),
            block_folder: None,
            waiting: None,
            typing: false,
            message: None,
            length: Length::default(),
            requests: Vec::new(),
            start: None,
            still: false,
            setup: Setup::default(),
            first_view: View::default(),
            space: space::MovementWindow::default(),
            scene_view: scene_view::SceneView::default(),
            playing: playing::Playing::default(),
            points_list: points_list::PointsList::default(),
            windows: windows::Windows::default(),
            recent: Vec::new(),
            recent_pictures: Default::default(),
            begin_pictures: Default::default(),
            autosave: None,
            closing: false,
        };
        editor.read_first_setup();
        editor.read_recent();
        editor.space.opened = editor.file.is_some() && !editor.fixed_speeds;
        if let Some(file) = editor.file.clone() {
            editor.note_file(&file);
        }
        editor.begin_recovery();
        Ok(editor)
    }

    /// Prepares a new egui context, once: fonts, style, no blinking caret (an idle window sleeps).
    pub fn prepare(&self, context: &egui::Context) {
        theme::apply(context, self.setup.theme());
        // A press and a release at one place are a click, however long a busy machine takes.
        context.options_mut(|options| options.input_options.max_click_duration = f64::INFINITY);
    }

    /// Whether closing was asked for and not refused yet.
    pub fn asks_to_close(&self) -> bool {
        self.waiting == Some(Action::File(FileAction::Quit))
            || self.requests.contains(&Request::Close)
            || self.windows.has_modal()
    }

    /// Whether poses are to be handed over after each change.
    pub fn auto_hand_over(&self) -> bool {
        self.auto_hand_over
    }

    /// Takes the oldest open request.
    pub fn next_request(&mut self) -> Option<Request> {
        let request = (!self.requests.is_empty()).then(|| self.requests.remove(0));
        self.closing = request == Some(Request::Close);
        request
    }

    /// Asks about unsaved work, if there is any, and then makes a [`Request::Close`]. While a text
    /// is being typed this waits for the next pass, which applies the text.
    pub fn ask_to_close(&mut self) {
        if self.typing {
            self.waiting = Some(Action::File(FileAction::Quit));
        } else {
            self.ask_before(AfterSave::Close);
        }
    }

    /// Shows a sentence in the output field.
    pub fn say(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.message = Some(Message {
            text,
            error: false,
            undoes: None,
        });
    }

    /// Says what the last step has done, with a button that takes it back.
    pub(super) fn say_done(&mut self, text: String) {
        self.message = Some(Message {
            text,
            error: false,
            undoes: Some(self.document.state_number()),
        });
    }

    /// Shows in the output field what could not be done.
    pub fn complain(&mut self, text: impl Into<String>) {
        let text = text.into();
        self.message = Some(Message {
            text,
            error: true,
            undoes: None,
        });
    }

    /// Shows another document as a new window does: playhead, view and selection are not those of the
    /// one before.
    pub(super) fn show_anew(&mut self) {
        self.playing.show_anew(self.document.selection());
        self.points_list.show_anew();
        self.space = space::MovementWindow::default();
        self.scene_view = scene_view::SceneView::default();
        self.setup.view = self.first_view;
        self.selected = Selected::default();
        self.joint = Default::default();
        self.flown = None;
        self.length = Length::default();
        self.windows.path_replaced();
    }

    /// Puts an error into the output field.
    pub(crate) fn complain_of(&mut self, error: &Error) {
        self.complain(reason_of(self.language(), error));
    }

    /// Reports why a hand-over failed.
    pub(crate) fn complain_of_hand_over(&mut self, error: &Error) {
        let texts = &self.texts().errors;
        let why = match error {
            Error::Engine(EngineError::Limit(_)) => fill(texts.frames, &[&limits::MAX_FRAMES]),
            other => reason_of(self.language(), other),
        };
        self.complain(fill(texts.cannot_hand_over, &[&why]));
    }

    /// Lets work that takes long be done by threads, while the window goes on.
    pub fn work_beside(&mut self, start: Start) {
        self.start = Some(start);
    }

    /// Whether the desktop asks for no animations.
    pub const fn keep_still(&mut self, still: bool) {
        self.still = still;
    }

    /// Shows in the output field what was wrong with what the host gave.
    pub fn warn(&mut self, warnings: &Warnings) {
        if !warnings.is_empty() {
            self.complain(self.language().warnings(warnings));
            let outside: Vec<String> = warnings.outside().collect();
            if self.file.is_some() && !outside.is_empty() {
                self.windows.question = Some(Question::outside(outside));
            }
        }
    }

    /// Reports a hand-over: why it failed or, if it was `asked` for, the number of poses.
    pub fn handed_over(&mut self, result: Result<usize, Error>, asked: bool) {
        match result {
            Ok(count) => {
                if self.program.hand_over_saves {
                    self.mark_saved();
                }
                if !asked {
                    return;
                }
                self.say(fill(self.texts().output.handed_over, &[&count]));
            }
            Err(error) => self.complain_of_hand_over(&error),
        }
    }

    /// The host has kept what is in the window.
    pub fn mark_saved(&mut self) {
        self.handed_state = Some(self.document().state_number());
    }

    /// Whether work would be lost with the window: work in no file and, where a hand-over saves,
    /// not with the host.
    pub fn is_unsaved(&self) -> bool {
        let document = self.document();
        document.is_modified() && self.handed_state != Some(document.state_number())
    }

    /// The window's title: begins with `VIDES`, marks unsaved work.
    pub fn window_title(&self) -> String {
        // A file lacks what only the host has.
        let changed = self.document().is_modified() && self.file.is_some();
        let mark = if changed || self.is_unsaved() {
            "*"
        } else {
            ""
        };
        let file = self.file.as_deref().and_then(|file| file.file_name());
        match (&self.title, file) {
            (Some(title), _) => {
                let title = title.replace(char::is_control, " ");
                format!("VIDES – {mark}{title}")
            }
            (None, Some(file)) => format!("VIDES – {mark}{}", file.to_string_lossy()),
            (None, None) => format!("VIDES{mark}"),
        }
    }

    /// The colour where nothing is painted.
    pub fn background(&self) -> egui::Color32 {
        self.setup.colours().of(Element::Background)
    }

    /// The path that is edited, without what a tool shows of it: what is saved, kept for recovery,
    /// handed over and shown to the host.
    pub fn document(&self) -> &Document {
        self.windows.without_preview(&self.document)
    }

    /// For edits from outside, which can be undone like the user's. Ends an open tool.
    pub fn document_mut(&mut self) -> &mut Document {
        self.cancel_tool();
        &mut self.document
    }

    /// Does what was entered into a [`Number`](crate::number::Number) as one undoable step.
    pub(super) fn enter(&mut self, entry: Entry<Edit>) {
        self.enter_with(entry, |editor, edit| {
            editor.edit_selected(edit);
        });
    }

    /// Does what was entered as one step. A drag ends where a host has changed what is dragged.
    pub(super) fn enter_with<T>(&mut self, entry: Entry<T>, set: impl FnOnce(&mut Self, T)) {
        match entry {
            Entry::Idle => {}
            Entry::Begin => self.document.begin_step(),
            Entry::Drag(_) if !self.document.in_step() => {}
            Entry::Drag(value) | Entry::Set(value) => set(self, value),
            Entry::End => self.document.end_step(),
            Entry::Cancel => self.document.cancel_step(),
            Entry::Wrong(text) => self.complain(text),
        }
    }

    /// Changes when something is done.
    pub(super) fn stamp(&self) -> impl PartialEq + use<> {
        let message = self.message.clone();
        (
            self.document.state_number(),
            self.document.selection(),
            self.selected.clone(),
            message,
            self.setup.theme(),
            self.windows.front(),
        )
    }

    pub(super) fn point(&self) -> Option<&SupportPoint> {
        let at = self.document.selection().point;
        self.document.path().points.get(at)
    }

    pub(super) fn orientation(&self) -> Option<&Orientation> {
        let at = self.document.selection().orientation;
        self.point()?.orientations.get(at)
    }

    pub(super) fn orientation_edit(&self, change: impl FnOnce(&mut Orientation)) -> Option<Edit> {
        Some(with(self.document.selection(), self.orientation()?, change))
    }

    /// The edit that changes an orientation's custom values, or a reason, since that takes memory.
    pub(super) fn with_own(
        &self,
        at: Selection,
        current: &Orientation,
        change: impl FnOnce(&mut OrientationOverrides),
    ) -> Result<Edit, String> {
        let own = current.own.with(change);
        let own = own.map_err(|error| reason_of(self.language(), &error.into()))?;
        Ok(with(at, current, |new| new.own = own))
    }

    /// The same for the current orientation, as an action.
    pub(super) fn own_action(
        &self,
        change: impl FnOnce(&mut OrientationOverrides),
    ) -> Option<Action> {
        let edit = self.with_own(self.document.selection(), self.orientation()?, change);
        Some(edit.map_or_else(Action::Complain, Action::Edit))
    }

    pub(super) fn set_orientation(&mut self, change: impl FnOnce(&mut Orientation)) {
        if let Some(edit) = self.orientation_edit(change) {
            self.edit_selected(edit);
        }
    }

    pub(super) fn language(&self) -> Language {
        self.setup.language.unwrap_or(self.given_language)
    }

    /// Whether the sliders are around the space: as it was chosen, else where the host fixes the
    /// speeds, as those of 1994 do.
    pub(super) fn shows_sliders(&self) -> bool {
        self.setup.sliders.unwrap_or(self.fixed_speeds)
    }

    /// Whether a new point is a copy of the current one, as the manual of 1994 has it: in the
    /// windows of hosts of that time. Else it leaves the flight as it is.
    pub(super) const fn adds_copies(&self) -> bool {
        self.fixed_speeds
    }

    /// What *+ Point* does, and what inserting several points does.
    pub(super) fn add_hints(&self) -> [&'static str; 2] {
        let texts = &self.texts().position;
        match self.adds_copies() {
            true => [texts.copy_hint, texts.copy_many_hint],
            false => [texts.add_hint, texts.add_many_hint],
        }
    }

    pub(super) fn texts(&self) -> &'static Texts {
        self.language().texts()
    }
}

/// A view that was copied, with its text in the clipboard.
#[derive(Clone, Debug)]
pub(crate) struct Copied {
    pub(crate) view: Orientation,
    pub(crate) text: String,
}

/// The edit that changes an orientation.
pub(crate) fn with(
    at: Selection,
    current: &Orientation,
    change: impl FnOnce(&mut Orientation),
) -> Edit {
    let mut orientation = current.clone();
    change(&mut orientation);
    Edit::SetOrientation {
        point: at.point,
        at: at.orientation,
        orientation,
    }
}

/// The least share of the room that space and picture have side by side.
pub(crate) const LEAST_SHARE: f32 = 0.25;
