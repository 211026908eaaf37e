//! What is done to points and views.

use glam::DVec3;
use vides_document::error::{Invalid, Result};
use vides_document::{At, Edit, Selection, no_longer_ahead};
use vides_engine::path::{CameraPath, Target, insertion};
use vides_engine::planner::DEFAULT_MARGIN;

use crate::action::{Action, PathAction};
use crate::state::Editor;
use crate::state::scene_view::NodeCommand;
use crate::state::selected::step_around;
use crate::state::windows::PointsWindow;
use crate::texts::fill;
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
    pub(super) fn path_action(&mut self, action: PathAction, context: &egui::Context) {
        let Selection { point, orientation } = self.document.selection();
        match action {
            PathAction::AddPoint => {
                self.add_points(1, context.input(|input| input.modifiers.shift))
            }
            PathAction::AddPointOtherwise => self.add_points(1, true),
            PathAction::AskPoints if !self.document.edits_path() => {
                self.complain(self.texts().tools.only_path);
            }
            PathAction::AskPoints if self.has_segment() => {
                windows::open::<PointsWindow>(self, context);
            }
            PathAction::AskPoints => self.complain(self.texts().position.last_point),
            PathAction::AddPoints(points) => {
                self.add_points(points, context.input(|input| input.modifiers.shift));
            }
            PathAction::AddHere => {
                self.add_here();
            }
            PathAction::Begin(places) => self.begin_path(places),
            PathAction::RemovePoint if !self.document.edits_path() => {
                self.do_to_nodes(NodeCommand::Remove);
            }
            PathAction::RemovePoint => {
                let count = self.all_selected().len();
                if self.remove_selected() && count > 1 {
                    self.say_done(fill(self.texts().output.points_removed, &[&count]));
                }
            }
            PathAction::PreviousPoint => self.go_by_points(false),
            PathAction::NextPoint => self.go_by_points(true),
            PathAction::AppendPoint => {
                self.edit(Edit::AppendAfterLast);
            }
            PathAction::PrependPoint => {
                self.edit(Edit::PrependBeforeFirst);
            }
            PathAction::SwitchClosed => {
                let closed = !self.document.path().closed;
                self.edit(Edit::set(At::Path, "closed", closed));
            }
            PathAction::OwnTangents(own) => self.set_own_tangents(own),
            PathAction::Join(joint) => self.join(joint),
            PathAction::ClearOverride(what) => self.give_back(what),
            PathAction::AddOrientation => {
                self.edit(Edit::InsertOrientation {
                    point,
                    at: orientation + 1,
                    orientation: None,
                });
            }
            PathAction::RemoveOrientation => {
                self.edit(Edit::RemoveOrientation {
                    point,
                    at: orientation,
                });
            }
            PathAction::PreviousOrientation => self.go_by_orientations(false),
            PathAction::NextOrientation => self.go_by_orientations(true),
            PathAction::SetAbsolute(absolute) => {
                self.edit_selected(Edit::SetAbsolute {
                    point,
                    at: orientation,
                    absolute,
                });
            }
            PathAction::LookAhead => {
                let edit = self.own_action(|own| own.ahead = Some(0.0));
                self.act_all(edit, context);
            }
            PathAction::ShowObject => self.show_object(),
            PathAction::SetUp(up) => self.act_all(self.own_action(|own| own.up = up), context),
            PathAction::SwitchAbsolute => {
                let target = self.orientation().map(|current| current.target);
                let absolute = matches!(target, Some(Target::Absolute(_)));
                self.act(Action::Path(PathAction::SetAbsolute(!absolute)), context);
            }
            PathAction::AimAll => self.aim_all(),
            PathAction::PasteOrientation => self.paste_view(),
            PathAction::TakeOver { replace } => self.ask_for_view(replace),
            PathAction::MoveSelected(before) => self.move_selected(before),
            PathAction::AimAt(place) => self.aim_at(place),
            PathAction::AimAllAt(place) => self.aim_all_at(place),
        }
    }

    /// Puts points at equal distances on the way to the next one: as this window does it, or the
    /// other way. One way makes copies of the point before, the other leaves the flight as it is.
    /// Where the way has too few frames for that, they are copies.
    fn add_points(&mut self, points: usize, otherwise: bool) {
        let segment = self.document.selection().point;
        let frames = insertion::dividing_frames(self.document.path(), segment, points);
        let copies = self.adds_copies() != otherwise;
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

    /// Puts the two points of a new path where they were clicked, as one step.
    fn begin_path(&mut self, places: [DVec3; 2]) {
        let mut edits = Vec::new();
        for (at, place) in places.into_iter().enumerate() {
            edits.push(Edit::set(At::Point(at), "position", place));
            let point = Selection {
                point: at,
                orientation: 0,
            };
            let view = &self.document.path().points[at].orientations[0];
            match self.with_own(point, view, |own| own.ahead = Some(0.0)) {
                Ok(edit) => edits.push(edit),
                Err(text) => return self.complain(text),
            }
        }
        if self.edit_all(edits) {
            self.select(1, 0);
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

    /// Lets every orientation look at the place under the pointer, or where the current one does,
    /// as one step; no point may be there.
    fn aim_all(&mut self) {
        if let Some(place) = self.space.pointed() {
            return self.aim_all_at(place);
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
}
