//! Doing what is asked for in the window: [`Editor::act`] alone changes it.

mod path;
mod tool;

use vides_document::error::Result;
use vides_document::{Document, Edit, Selection};

use crate::action::Action;
use crate::state::selected::SelectionChange;
use crate::state::windows::{
    CheckWindow, ColourWindow, CompareWindow, CurveWindow, DisplayWindow, HelpWindow, SpaceWindow,
    SpeedWindow,
};
use crate::state::{Editor, LEAST_SHARE, Request};
use crate::texts::fill;
use crate::texts::refusals::of_edit;
use crate::windows;

impl Editor {
    /// Shows a part of the window, and does its actions before the next is shown.
    pub(super) fn part<R>(
        &mut self,
        context: &egui::Context,
        view: impl FnOnce(&Self, &mut Vec<Action>) -> R,
    ) -> R {
        let mut actions = Vec::new();
        let shown = view(self, &mut actions);
        self.act_all(actions, context);
        shown
    }

    /// The same of a part that remembers something in a room of the editor: it changes that while
    /// the rest is only read, and it is back there before an action is done.
    pub(super) fn part_of<T: Default, R>(
        &mut self,
        context: &egui::Context,
        room: impl Fn(&mut Self) -> &mut T,
        view: impl FnOnce(&Self, &mut T, &mut Vec<Action>) -> R,
    ) -> R {
        let mut actions = Vec::new();
        let mut own = std::mem::take(room(self));
        let shown = view(self, &mut own, &mut actions);
        *room(self) = own;
        self.act_all(actions, context);
        shown
    }

    pub(super) fn act_all(
        &mut self,
        actions: impl IntoIterator<Item = Action>,
        context: &egui::Context,
    ) {
        for action in actions {
            self.act(action, context);
        }
    }

    pub(super) fn act(&mut self, action: Action, context: &egui::Context) {
        self.done(action, context);
        self.settle_length();
        self.selected.follow(&self.document);
        self.scene_view.follow(&self.document);
    }

    fn done(&mut self, action: Action, context: &egui::Context) {
        if action.is_command() {
            self.message = None;
        }
        if !action.leaves_tool() {
            self.take_tool();
            self.settle_length();
        }
        match action {
            Action::File(action) => self.file_action(action, context),
            Action::Path(action) => self.path_action(action, context),
            Action::Tool(action) => self.tool_action(action, context),
            Action::Time(action) => self.time_action(action, context),
            Action::Undo if self.windows.tool.is_some() => self.cancel_tool(),
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::Copy => self.copy(context),
            Action::Cut => self.cut(context),
            Action::Paste => Self::ask_for_clipboard(context),
            Action::Pasted(text) => self.pasted(&text),
            Action::HandOver if self.host_takes_poses => self.requests.push(Request::HandOver),
            Action::HandOver => self.complain(self.texts().menu.nobody_takes),
            Action::SwitchHandsOver => {
                self.auto_hand_over = !self.auto_hand_over && self.host_takes_poses
            }
            Action::SpeedCurve | Action::Check if !self.document.edits_path() => {
                self.complain(self.texts().tools.only_path);
            }
            Action::Check => windows::open::<CheckWindow>(self, context),
            Action::GoTo(finding) => self.go_to(&finding),
            Action::Edits(edits) => {
                self.edit_all(edits);
            }
            Action::Mend(finding, edits) => self.mend(&finding, edits),
            Action::Cure(finding) => self.cure(&finding),
            // F2, which has no curve to change there.
            Action::Curve if !self.document.edits_path() => self.name_current_node(),
            Action::Curve => windows::open::<CurveWindow>(self, context),
            Action::SpeedCurve => windows::open::<SpeedWindow>(self, context),
            Action::Colours => windows::open::<ColourWindow>(self, context),
            Action::Display => windows::open::<DisplayWindow>(self, context),
            Action::Space => windows::open::<SpaceWindow>(self, context),
            Action::Theme(theme) => self.choose_theme(theme),
            Action::SensorHeight(height) => self.choose_sensor(height),
            Action::SwitchCameraView => self.setup.camera_view = !self.setup.camera_view,
            Action::CameraPlace(place) => {
                let setup = &mut self.setup;
                setup.camera_place = setup.camera_place.switched(place);
                setup.camera_view = true;
            }
            Action::Fly(camera) => self.fly(camera),
            Action::Keys => windows::open::<HelpWindow>(self, context),
            Action::SelectNodes(nodes) => self.select_nodes(nodes),
            Action::Nodes(command) => self.do_to_nodes(command),
            Action::CompareRotations => windows::open::<CompareWindow>(self, context),
            Action::SelectKeys(keys) => self.select_keys(keys),
            Action::KeysToPath(node) => self.keys_to_path(node),
            Action::Node(action) => self.node_action(action),
            Action::Edit(edit) => {
                self.edit_selected(edit);
            }
            Action::Enter(entry) => self.enter(entry),
            Action::EnterMissing(entry) => self.enter_missing(entry),
            Action::Gesture(gesture) => self.gesture(gesture),
            Action::Select(Selection { point, orientation }) => {
                if let Err(error) = self.document.select(point, orientation) {
                    self.complain_of(&error);
                }
            }
            Action::Choose(SelectionChange::All) if !self.document.edits_path() => {
                self.select_all_nodes();
            }
            Action::Choose(choice) => self.choose(choice),
            Action::View(view) => self.setup.view = view,
            Action::SwitchSliders => self.switch_sliders(),
            Action::SwitchWireframe => self.switch_wireframe(),
            Action::Fold(fold) => self.switch_fold(fold),
            Action::CameraShare(share) => {
                self.camera_share = share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
            }
            Action::Setup(setup) => {
                self.setup = *setup;
                // The movement window has been drawn already.
                context.request_repaint();
            }
            Action::Language(language) => {
                // What is said stands in the other language.
                self.message = None;
                self.choose_language(language);
            }
            Action::CopySpeeds(speeds) => {
                self.windows.copied_speeds = Some(speeds);
                self.say(self.texts().speed_window.copied);
            }
            Action::ApplyCurve(closes) => CurveWindow::apply(self, closes),
            Action::ApplySpace(closes) => {
                SpaceWindow::apply(self, closes);
                context.request_repaint();
            }
            Action::Say(text) => self.say(text),
            Action::Complain(text) => self.complain(text),
        }
    }

    /// Edits the path of another node at the same moment of the scene.
    pub(crate) fn edit_node(&mut self, node: Option<usize>) {
        self.document.end_step();
        let moment = self.previewed_frame();
        if self.edit(Edit::EditNode(node))
            && let Ok(moment) = moment
        {
            self.stay_at(moment);
        }
    }

    fn undo(&mut self) {
        match self.travel(Document::undo) {
            true => self.select_touched(),
            false => self.say(self.texts().output.nothing_to_undo),
        }
    }

    fn redo(&mut self) {
        match self.travel(Document::redo) {
            true => self.select_touched(),
            false => self.say(self.texts().output.nothing_to_redo),
        }
    }

    /// Undoes or redoes; where another path is edited then, the playhead stays where it is.
    fn travel(&mut self, way: impl FnOnce(&mut Document) -> bool) -> bool {
        let node = |editor: &Self| editor.document.edited_scene().map(|edited| edited.node());
        let (before, moment) = (node(self), self.previewed_frame());
        let done = way(&mut self.document);
        if let Ok(moment) = moment
            && node(self) != before
        {
            self.stay_at(moment);
        }
        done
    }

    /// Does an edit; a refusal goes to the output field.
    pub(crate) fn edit(&mut self, edit: Edit) -> bool {
        let done = match self.times_are_fixed() {
            true => self.document.apply_keeping_times(edit),
            false => self.document.apply(edit),
        };
        self.tell(done)
    }

    /// Applies edits as one separate step, or none of them.
    pub(super) fn edit_all(&mut self, edits: impl IntoIterator<Item = Edit>) -> bool {
        self.document.end_step();
        self.edit_together(edits)
    }

    /// The same, as part of an open step.
    pub(super) fn edit_together(&mut self, edits: impl IntoIterator<Item = Edit>) -> bool {
        let done = match self.times_are_fixed() {
            true => self.document.apply_all_keeping_times(edits),
            false => self.document.apply_all(edits),
        };
        self.tell(done)
    }

    /// Shows in the output field why an edit was refused.
    pub(super) fn tell(&mut self, done: Result<()>) -> bool {
        match done {
            Ok(()) => {
                self.message = None;
                self.tell_ambiguities();
                true
            }
            Err(error) => {
                self.complain(of_edit(self.language(), &error));
                false
            }
        }
    }

    /// Whether a segment begins at the current point.
    pub(super) fn has_segment(&self) -> bool {
        self.document.selection().point < self.document.path().segment_count()
    }

    pub(super) fn select(&mut self, point: usize, orientation: usize) {
        self.message = None;
        self.playing.leave();
        // Whoever asks for one that is not there has an old number: nothing changes.
        let _ = self.document.select(point, orientation);
    }

    pub(super) fn number_of(text: &str, index: usize, count: usize) -> String {
        fill(text, &[&(index + 1), &count])
    }
}
