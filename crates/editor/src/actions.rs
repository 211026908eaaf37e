//! Doing what is asked for in the window: [`Editor::act`] alone changes it.

use glam::DVec3;
use vides_document::error::{Invalid, Result};
use vides_document::tool::ToolInput;
use vides_document::{At, Document, Edit, Selection, no_longer_ahead};
use vides_engine::path::{CameraPath, Tangents, Target, insertion};
use vides_engine::planner::DEFAULT_MARGIN;

use crate::action::Action;
use crate::state::files::{AfterSave, Purpose};
use crate::state::scene_view::NodeCommand;
use crate::state::selected::{SelectionChange, step_around};
use crate::state::windows::{
    CheckWindow, ColourWindow, CompareWindow, CurveWindow, DisplayWindow, HelpWindow, PointsWindow,
    SpaceWindow, SpeedWindow, ToolWindow,
};
use crate::state::{Editor, LEAST_SHARE, Request};
use crate::texts::fill;
use crate::texts::refusals::of_edit;
use crate::windows;

/// The edit that aims an orientation at a place.
fn aimed(path: &CameraPath, point: usize, at: usize, place: DVec3) -> Result<Edit> {
    let mut orientation = no_longer_ahead(path, point, at)?;
    orientation.target = Target::Absolute(place);
    Ok(Edit::SetOrientation {
        point,
        at,
        orientation,
    })
}

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
        let Selection { point, orientation } = self.document.selection();
        match action {
            Action::New => self.ask_before(AfterSave::New),
            Action::Load => self.ask_before(AfterSave::Load),
            Action::Save => {
                self.save(None);
            }
            Action::SaveAs => self.choose_file(Purpose::SavePath(None)),
            Action::Quit => self.ask_to_close(),
            Action::Undo if self.windows.tool.is_some() => self.cancel_tool(),
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::AddPoint => self.add_points(1, context),
            Action::AskPoints if self.has_segment() => {
                windows::open::<PointsWindow>(self, context);
            }
            Action::AskPoints => self.complain(self.texts().position.last_point),
            Action::AddPoints(points) => self.add_points(points, context),
            Action::AddHere => {
                self.add_here();
            }
            Action::RemovePoint if !self.document.edits_path() => {
                self.do_to_nodes(NodeCommand::Remove);
            }
            Action::RemovePoint => {
                let count = self.all_selected().len();
                if self.remove_selected() && count > 1 {
                    self.say_done(fill(self.texts().output.points_removed, &[&count]));
                }
            }
            Action::PreviousPoint => self.go_by_points(false),
            Action::NextPoint => self.go_by_points(true),
            Action::AppendPoint => {
                self.edit(Edit::AppendAfterLast);
            }
            Action::PrependPoint => {
                self.edit(Edit::PrependBeforeFirst);
            }
            Action::SwitchClosed => {
                let closed = !self.document.path().closed;
                self.edit(Edit::set(At::Path, "closed", closed));
            }
            Action::OwnTangents(own) => self.set_own_tangents(own),
            Action::Join(joint) => self.join(joint),
            Action::ClearOverride(what) => self.give_back(what),
            Action::AddOrientation => {
                self.edit(Edit::InsertOrientation {
                    point,
                    at: orientation + 1,
                    orientation: None,
                });
            }
            Action::RemoveOrientation => {
                self.edit(Edit::RemoveOrientation {
                    point,
                    at: orientation,
                });
            }
            Action::PreviousOrientation => self.go_by_orientations(false),
            Action::NextOrientation => self.go_by_orientations(true),
            Action::SetAbsolute(absolute) => {
                self.edit_selected(Edit::SetAbsolute {
                    point,
                    at: orientation,
                    absolute,
                });
            }
            Action::LookAhead => {
                let edit = self.own_action(|own| own.ahead = Some(0.0));
                self.act_all(edit, context);
            }
            Action::ShowObject => self.show_object(),
            Action::SetUp(up) => self.act_all(self.own_action(|own| own.up = up), context),
            Action::SwitchAbsolute => {
                let target = self.orientation().map(|current| current.target);
                let absolute = matches!(target, Some(Target::Absolute(_)));
                self.act(Action::SetAbsolute(!absolute), context);
            }
            Action::AimAll => self.aim_all(),
            Action::Copy => self.copy(context),
            Action::Cut => self.cut(context),
            Action::Paste => Self::ask_for_clipboard(context),
            Action::Pasted(text) => self.pasted(&text),
            Action::PasteOrientation => self.paste_view(),
            Action::Dropped(files) => self.dropped(&files, context),
            Action::LoadObject => self.choose_file(Purpose::LoadObject(None)),
            Action::Export => self.choose_file(Purpose::Export),
            Action::Import => self.choose_file(Purpose::Import),
            Action::WriteAs(file, format) => {
                if let Err(text) = self.write_as(&file, format) {
                    self.complain(text);
                }
            }
            Action::HandOver if self.host_takes_poses => self.requests.push(Request::HandOver),
            Action::HandOver => self.complain(self.texts().menu.nobody_takes),
            Action::SwitchHandsOver => {
                self.auto_hand_over = !self.auto_hand_over && self.host_takes_poses
            }
            Action::TakeOver { replace } => self.ask_for_view(replace),
            Action::Tool(tool) => {
                self.open_tool(tool);
                self.play_tour(context);
            }
            Action::ToolMade => {
                self.tool_made();
                self.play_tour(context);
            }
            Action::Check => windows::open::<CheckWindow>(self, context),
            Action::GoTo(finding) => self.go_to(&finding),
            Action::Edits(edits) => {
                self.edit_all(edits);
            }
            Action::Mend(edits) => self.mend(edits),
            Action::Cure(finding) => self.cure(&finding),
            Action::PreviewTool => {
                self.preview_tool();
                context.request_repaint();
            }
            Action::MoveControl { at, place } => self.move_control(at, place),
            Action::DrawOn(at, place) => self.draw_on(at, place),
            Action::EndDrawing { keeps } => self.end_drawing(keeps),
            Action::Stroke(places) => self.begin_tool_with(ToolInput::Stroke(places)),
            Action::EndTool { keeps } => self.end_tool(keeps),
            // F2, which has no curve to change there.
            Action::Curve if !self.document.edits_path() => self.name_current_node(),
            Action::Curve => windows::open::<CurveWindow>(self, context),
            Action::SpeedCurve => windows::open::<SpeedWindow>(self, context),
            Action::Colours => windows::open::<ColourWindow>(self, context),
            Action::Display => windows::open::<DisplayWindow>(self, context),
            Action::Space => windows::open::<SpaceWindow>(self, context),
            Action::Recent(number) => self.ask_before(AfterSave::Recent(number)),
            Action::Restore(number) => self.ask_before(AfterSave::Restore(number)),
            Action::LoadSetup => self.choose_file(Purpose::LoadSetup),
            Action::SaveSetup => self.choose_file(Purpose::SaveSetup),
            Action::Theme(theme) => self.choose_theme(theme),
            Action::SensorHeight(height) => self.choose_sensor(height),
            Action::SwitchCameraView => self.setup.camera_view = !self.setup.camera_view,
            Action::CameraPlace(place) => {
                let setup = &mut self.setup;
                setup.camera_place = setup.camera_place.switched(place);
                setup.camera_view = true;
            }
            Action::Fly(camera) => self.fly(camera),
            Action::Plot(quantity) => self.plot(quantity),
            Action::SwitchSpeedGraph => self.switch_speed_graph(),
            Action::PlayOrPause => self.play_or_pause(context),
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
            Action::MoveSelected(before) => self.move_selected(before),
            Action::AimAt(place) => self.aim_at(place),
            Action::AimAllAt(place) => self.aim_all_at(place),
            Action::View(view) => self.setup.view = view,
            Action::Playhead(entry) => self.enter_frame(entry),
            Action::SwitchLoops => self.switch_loops(context),
            Action::SwitchOnlySelected => self.switch_only_selected(context),
            Action::SwitchKeepsLength => self.switch_keeps_length(),
            Action::SwitchMovesAlong => self.switch_moves_along(),
            // A host has changed meanwhile what was dragged: the drag has ended.
            Action::Retime(_) | Action::MoveKeys(_) | Action::MoveMarker { .. }
                if !self.document.in_step() => {}
            Action::Retime(retiming) => self.retime(retiming),
            Action::MoveKeys(motion) => self.move_keys(&motion),
            Action::MoveMarker { name, to } => self.move_marker(&name, to),
            Action::SwitchSliders => self.switch_sliders(),
            Action::SwitchWireframe => self.switch_wireframe(),
            Action::Fold(fold) => self.switch_fold(fold),
            Action::See(seen) => self.playing.see(seen),
            Action::RulerInFrames(frames) => self.choose_ruler(frames),
            Action::GraphHeight(height) => self.set_graph_height(height),
            Action::CameraShare(share) => {
                self.camera_share = share.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
            }
            Action::Pace(pace) => self.set_pace(pace, context),
            Action::Setup(setup) => {
                self.setup = *setup;
                // The movement window has been drawn already.
                context.request_repaint();
            }
            Action::Language(language) => self.choose_language(language),
            Action::CopySpeeds(speeds) => {
                self.windows.copied_speeds = Some(speeds);
                self.say(self.texts().speed_window.copied);
            }
            Action::ApplyCurve(closes) => CurveWindow::apply(self, closes),
            Action::ApplySpace(closes) => {
                SpaceWindow::apply(self, closes);
                context.request_repaint();
            }
            Action::FileChosen(purpose, file) => self.file_chosen(purpose, &file),
            Action::Discard(number) => self.discard_found(number),
            Action::SaveBefore(then) => self.save(Some(then)),
            Action::GoOn(then) => self.go_on(then),
            Action::Reload => self.reload(),
            Action::SaveAsBefore(then) => self.choose_file(Purpose::SavePath(then)),
            Action::Overwrite(then) => self.overwrite(then),
            Action::Say(text) => self.say(text),
            Action::Complain(text) => self.complain(text),
        }
    }

    /// Edits the path of another node at the same moment of the scene.
    pub(crate) fn edit_node(&mut self, node: Option<usize>) {
        self.document.end_step();
        let moment = self.frame();
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
        let (before, moment) = (node(self), self.frame());
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
        if self.replaces_tangents(&edit).is_some() {
            return self.edit_together([edit]);
        }
        let done = self.document.apply(edit);
        self.tell(done)
    }

    /// Does edits as one step of their own, or none of them.
    pub(super) fn edit_all(&mut self, edits: impl IntoIterator<Item = Edit>) -> bool {
        self.document.end_step();
        self.edit_together(edits)
    }

    /// The same, as part of an open step.
    pub(super) fn edit_together(&mut self, edits: impl IntoIterator<Item = Edit>) -> bool {
        let mut all = Vec::new();
        for edit in edits {
            let replaced = self.replaces_tangents(&edit);
            all.extend(replaced.map(|at| Edit::set(At::Point(at), "tangents", None::<Tangents>)));
            all.push(edit);
        }
        let done = self.document.apply_all(all);
        self.tell(done)
    }

    /// The point whose own tangents an edit replaces by the shape that it chooses.
    fn replaces_tangents(&self, edit: &Edit) -> Option<usize> {
        let Edit::Set {
            place: At::Point(at),
            property: "own" | "preset",
            ..
        } = *edit
        else {
            return None;
        };
        let owns = self.document.path().points.get(at)?.tangents.is_some();
        owns.then_some(at)
    }

    /// Shows in the output field why an edit was refused.
    fn tell(&mut self, done: Result<()>) -> bool {
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

    /// Puts points at equal distances on the way to the next one, without changing the flight. With
    /// Shift, and where the way has too few frames, copies of the point before, as in 1994.
    fn add_points(&mut self, points: usize, context: &egui::Context) {
        let segment = self.document.selection().point;
        let frames = insertion::dividing_frames(self.document.path(), segment, points);
        let copies = context.input(|input| input.modifiers.shift);
        let Some(frames) = frames.ok().filter(|_| !copies) else {
            self.edit(Edit::DivideSegment { segment, points });
            return;
        };
        let within = self.document.in_step();
        if !within {
            self.document.begin_step();
        }
        let mut frames = frames.into_iter();
        if !frames.all(|frame| self.edit(Edit::InsertOnCurve { frame })) {
            self.document.cancel_step();
            return;
        }
        // There are as many points as asked for, so there is a first one.
        let _ = self.document.select(segment + 1, 0);
        if !within {
            self.document.end_step();
        }
    }

    /// Plays a tour that has just been made.
    fn play_tour(&mut self, context: &egui::Context) {
        let made = self.windows.tool.as_ref();
        if made.is_some_and(ToolWindow::shows_tour) && !self.playing.is_playing() {
            self.play_or_pause(context);
        }
    }

    fn aim_at(&mut self, place: DVec3) {
        let Selection { point, orientation } = self.document.selection();
        match aimed(self.document.path(), point, orientation, place) {
            Ok(edit) => {
                self.edit_selected(edit);
            }
            Err(error) => self.complain_of(&error),
        }
    }

    fn show_object(&mut self) {
        let edit = self.obstacles().and_then(|object| {
            let object = object.ok_or(Invalid::NoGeometry)?;
            self.document
                .object_shown(self.document.selection(), &object, DEFAULT_MARGIN)
        });
        match edit {
            Ok(edit) => {
                self.edit(edit);
            }
            Err(error) => self.complain_of(&error),
        }
    }

    /// Lets every orientation look where the current one does, as one step; no point may be there.
    fn aim_all(&mut self) {
        if let Some(corner) = self.space.lit() {
            return self.aim_all_at(corner);
        }
        let Some((position, current)) = self
            .point()
            .zip(self.orientation())
            .map(|(point, current)| (point.position, current.target))
        else {
            return;
        };
        let place = match current {
            Target::Absolute(place) => place,
            Target::Relative(offset) => position + offset,
        };
        self.aim_all_at(place);
    }

    fn aim_all_at(&mut self, place: DVec3) {
        let path = self.document.path();
        let edits = path
            .points
            .iter()
            .enumerate()
            .flat_map(|(point, of_point)| {
                let all = 0..of_point.orientations.len();
                all.map(move |at| aimed(path, point, at, place))
            });
        match edits.collect::<Result<Vec<Edit>>>() {
            Ok(edits) => {
                let count = edits.len();
                if self.edit_all(edits) {
                    self.say_done(fill(self.texts().orientation.all_aimed, &[&count]));
                }
            }
            Err(error) => self.complain_of(&error),
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

    /// Goes on by one point, round and round.
    fn go_by_points(&mut self, forward: bool) {
        let count = self.document.path().points.len();
        self.select(
            step_around(self.document.selection().point, forward, count),
            0,
        );
    }

    /// Goes on by one orientation of this point, round and round.
    fn go_by_orientations(&mut self, forward: bool) {
        let Selection { point, orientation } = self.document.selection();
        let points = &self.document.path().points;
        let count = points
            .get(point)
            .map_or(1, |point| point.orientations.len());
        if count == 1 {
            self.say(self.texts().orientation.only_one);
        } else {
            self.select(point, step_around(orientation, forward, count));
        }
    }

    pub(super) fn number_of(text: &str, index: usize, count: usize) -> String {
        fill(text, &[&(index + 1), &count])
    }
}
