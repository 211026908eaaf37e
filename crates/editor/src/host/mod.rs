//! What passes between the window and its host's own picture: where the playhead is and what the
//! camera sees there; the host's camera, shown as a ghost and taken over into the path.

mod first;
mod pane;
pub(crate) mod program;
pub(crate) mod warning;

use std::path::Path;

use egui::{Area, Button, Context, Id, Order, Pos2, Rect, vec2};
use glam::DVec3;
use vides_document::error::{OutOfRange, Refused, Result};
use vides_document::{At, Document, Edit, Object, Selection};
use vides_engine::math::orientation;
use vides_engine::math::view::View;
use vides_engine::path::{Change, Orientation, Overrides, Pose, Space, Target};

use crate::action::{Action, PathAction};
use crate::space::cameras::Camera;
use crate::state::host::{HostPane, PlayheadState};
use crate::state::{Editor, Reason, Request};
use crate::texts::fill;
use crate::texts::refusals::reason_of;
pub use first::{begin_at, check_view};
pub use program::{Date, Program};
pub use warning::{Warning, Warnings};

/// The distance to the target of a view taken over, in units of the space's `half_size`.
const TARGET: f64 = 0.4;

/// How much equal views may differ, in units of `half_size`, radians and shares of the
/// zoom: a hundred roundings of `float`.
const SAME_VIEW: f64 = 1e-5;

impl PlayheadState {
    fn shows_another(&self, before: &Self) -> bool {
        match (self.camera, before.camera) {
            (Some((camera, nodes)), Some((other, same))) => camera != other && nodes == same,
            _ => false,
        }
    }

    /// What led here from `before`.
    pub fn reason(&self, before: &Self) -> Reason {
        if self.plays || before.plays {
            Reason::Played
        } else if self.shows_another(before) {
            Reason::Selected
        } else if self.revision != before.revision {
            Reason::Edited
        } else if self.scrubbed {
            Reason::Scrubbed
        } else {
            Reason::Selected
        }
    }
}

impl Editor {
    /// Where the host draws what the camera sees; `None` if that is hidden or the editor draws it.
    #[must_use]
    pub fn host_pane(&self) -> Option<&HostPane> {
        self.host_pane.as_ref()
    }

    /// The host receives no camera before it changes.
    #[must_use]
    pub fn keeps_host_view(&self) -> bool {
        self.host_view.keeps_view
    }

    /// The host cannot draw what the camera sees: the editor does.
    pub fn draw_pane_itself(&mut self) {
        self.host_view.fills_pane = false;
        self.host_pane = None;
    }

    /// Where the playhead stands.
    pub fn standing(&self) -> PlayheadState {
        let frame = self.playing.frame();
        PlayheadState {
            frame: frame.map(|frame| self.without_preview(frame)),
            ..self.standing_in(self.document())
        }
    }

    fn standing_in(&self, document: &Document) -> PlayheadState {
        PlayheadState {
            revision: document.revision(),
            camera: document.edited_scene().map(|edited| {
                let scene = edited.scene();
                (scene.shown_camera(), scene.nodes().len())
            }),
            selection: document.selection(),
            frame: self.playing.frame(),
            plays: self.playing.is_playing(),
            scrubbed: self.playing.was_scrubbed(),
        }
    }

    /// Whether it plays or a step of the document is open: more is to come.
    pub fn is_under_way(&self) -> bool {
        self.playing.is_playing() || self.document().in_step()
    }

    /// Identifies the path after each step; after undo it is an old number again.
    pub fn step_number(&self) -> (u64, u64) {
        (self.windows.paths, self.document().state_number())
    }

    /// The frame at the playhead, from 1; in a scene, the scene's.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; `ErrorKind::Limit` for too many frames.
    pub fn frame(&self) -> Result<f64> {
        let frame = self.frame_in(self.document())?;
        Ok(self.without_preview(frame))
    }

    /// The same with what a tool shows.
    pub(crate) fn previewed_frame(&self) -> Result<f64> {
        self.frame_in(&self.document)
    }

    /// A frame of what is shown in [`Editor::document`], which may be shorter.
    fn without_preview(&self, frame: f64) -> f64 {
        let document = self.document();
        if std::ptr::eq(document, &raw const self.document) {
            return frame;
        }
        let range = document.frame_range();
        range.map_or(frame, |(first, last)| frame.clamp(first, last))
    }

    fn frame_in(&self, document: &Document) -> Result<f64> {
        if let Some(frame) = self.playing.frame() {
            return Ok(frame);
        }
        let Selection { point, orientation } = document.selection();
        let sampler = document.sampler()?;
        let section = document.timeline(|timeline| {
            let at = timeline.section_from(point, orientation)?;
            Some((at, timeline.section(at).change))
        })?;
        let point = document.path().points.get(point);
        let key = point.and_then(|point| point.orientations.get(orientation));
        let hold = key.map_or(0, |key| key.hold as usize);
        let frame = match section {
            None => sampler.frame_count() - hold,
            // Nothing rests there.
            Some((at, Change::Nothing)) => sampler.first_frame(at),
            Some((at, _)) => sampler.first_frame(at) - 1 - hold,
        };
        #[allow(clippy::cast_precision_loss)]
        Ok(document.frame_of_scene(frame as f64))
    }

    /// The camera at the playhead, with its frame.
    ///
    /// # Errors
    /// As [`Editor::frame`].
    pub fn view(&self) -> Result<(Pose, f64)> {
        let frame = self.frame()?;
        let pose = match self.scene_pose()? {
            Some(pose) => pose,
            None => self.document().sampler()?.pose(frame)?,
        };
        Ok((pose, frame))
    }

    /// Moves the playhead to a frame, from 1, and leaves it there; in a scene, to any frame of its
    /// range.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such frame; as [`Editor::frame`].
    pub fn set_frame(&mut self, frame: f64) -> Result<()> {
        let document = self.document();
        if document.edited_scene().is_none() {
            document.sampler()?.pose(frame)?;
        }
        let (first, last) = document.frame_range()?;
        if !(first..=last).contains(&frame) {
            return Err(OutOfRange::NoFrame { frame, first, last }.into());
        }
        self.scrub(frame);
        Ok(())
    }

    /// Plays from the next pass on, or stops.
    pub fn set_playing(&mut self, plays: bool) {
        self.playing.order(plays);
    }

    /// Whether it plays, or will from the next pass on.
    #[must_use]
    pub fn plays(&self) -> bool {
        self.playing.will_play()
    }

    /// Makes a point and one of its orientations current, both counted from 0. Ends an open tool.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such one; `ErrorKind::Argument` if no path is edited.
    pub fn select_key(&mut self, point: usize, orientation: usize) -> Result<()> {
        if !self.document.edits_path() {
            return Err(Refused::NoPathEdited.into());
        }
        self.document_mut().select(point, orientation)?;
        self.select(point, orientation);
        Ok(())
    }

    /// Changes the document; the playhead stays where it was put, if that frame is still there, else
    /// it goes to the current point.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut Document) -> R) -> R {
        let document = self.document_mut();
        let done = change(document);
        let range = self.document.frame_range();
        match (self.playing.frame(), range) {
            (Some(frame), Ok((first, last))) if (first..=last).contains(&frame) => {
                self.stay_at(frame);
            }
            (Some(_), _) if !self.playing.is_playing() => self.playing.leave(),
            _ => {}
        }
        done
    }

    /// Shows another object, in one undoable step.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn set_object(&mut self, object: Object) -> Result<()> {
        self.cancel_tool();
        let mut info = self.document.info().clone();
        info.object = object;
        self.document.apply(Edit::SetInfo(Box::new(info)))
    }

    /// What follows `VIDES` in the title; `None`: the file's name.
    pub fn set_title(&mut self, title: Option<String>) {
        self.title = title;
    }

    /// Saves under a name, by default its own, and edits that file from now on.
    ///
    /// # Errors
    /// `ErrorKind::Argument` without a name, or if its own file has changed since it was read or
    /// written here: nothing is written then. `ErrorKind::Io`.
    pub fn save_as(&mut self, file: Option<&Path>) -> Result<()> {
        let own = self.file.clone();
        let Some(name) = file.or(own.as_deref()) else {
            return Err(Refused::NoFile.into());
        };
        if self.write(name, file.is_some())? {
            return Ok(());
        }
        Err(Refused::FileChanged.into())
    }

    /// Shows the host's camera, or hides it.
    ///
    /// # Errors
    /// `ErrorKind::Argument`, `ErrorKind::Range` for a pose that is not valid.
    pub fn set_ghost(&mut self, pose: Option<&Pose>) -> Result<()> {
        let space = self.document.path().space;
        let checked = pose.map(|pose| checked(pose, space)).transpose()?;
        self.ghost = checked;
        Ok(())
    }

    /// Where the camera of the picture has flown, until something else is shown.
    pub(crate) fn flown(&self) -> Option<Camera> {
        let (camera, standing) = self.flown?;
        (standing == self.standing_in(&self.document)).then_some(camera)
    }

    pub(crate) fn fly(&mut self, camera: Option<Camera>) {
        if camera.is_some() && self.playing.is_playing() {
            self.playing.order(false);
        }
        let standing = self.standing_in(&self.document);
        self.flown = camera.map(|camera| (camera, standing));
    }

    pub(crate) fn has_host_view(&self) -> bool {
        self.host_view.captures || self.ghost.is_some() || self.flown().is_some()
    }

    pub(crate) fn ask_for_view(&mut self, replace: bool) {
        if let Some(flown) = self.flown() {
            self.take_over(Some(&flown.into()), replace);
        } else if self.host_view.captures {
            self.requests.push(Request::Capture { replace });
        } else {
            self.take_over(None, replace);
        }
    }

    /// Takes over the given view, else the ghost: as a new point after the current one, or in place
    /// of the current orientation.
    pub fn take_over(&mut self, given: Option<&Pose>, replace: bool) {
        self.take_tool();
        let texts = &self.texts().space;
        let name = self.host_name().to_owned();
        let Some(pose) = given.or(self.ghost.as_ref()) else {
            self.complain(fill(texts.no_host_view, &[&name]));
            return;
        };
        let space = self.document.path().space;
        let pose = match checked(pose, space) {
            Ok(pose) => pose,
            Err(error) => {
                let why = reason_of(self.language(), &error);
                self.complain(fill(texts.host_view_refused, &[&name, &why]));
                return;
            }
        };
        let Selection { point, orientation } = self.document.selection();
        let Some(current) = self.orientation() else {
            return;
        };
        if self.has_view(&pose) {
            let number = (point + 1).to_string();
            self.say(fill(self.texts().space.same_view, &[&number]));
            return;
        }
        let taken = seen_by(&pose, space, current);
        let position = DVec3::from_array(pose.vrp);
        self.document.begin_step();
        let done = if replace {
            // In the other order the old target might lie where the point comes to.
            let edits = [
                Edit::SetOrientation {
                    point,
                    at: orientation,
                    orientation: taken,
                },
                Edit::set(At::Point(point), "position", position),
            ];
            edits.into_iter().all(|edit| self.edit(edit))
        } else {
            self.add_point_at(point + 1, position, taken)
        };
        if done {
            self.document.end_step();
            self.playing.leave();
        } else {
            self.document.cancel_step();
        }
    }

    /// Whether the current orientation looks as a valid pose does, which a host may have rounded.
    fn has_view(&self, pose: &Pose) -> bool {
        let Selection { point, orientation } = self.document.selection();
        let Some(key) = Camera::at(&self.document, point, orientation) else {
            return false;
        };
        let near = |a: DVec3, b: [f64; 3], most: f64| a.distance(DVec3::from_array(b)) <= most;
        near(
            key.position,
            pose.vrp,
            SAME_VIEW * self.document.path().space.half_size,
        ) && near(key.view, pose.vpn, SAME_VIEW)
            && near(key.up, pose.vup, SAME_VIEW)
            && (key.zoom - pose.zoom).abs() <= SAME_VIEW * key.zoom
    }

    fn add_point_at(&mut self, at: usize, position: DVec3, orientation: Orientation) -> bool {
        if !self.edit(Edit::InsertPoint { at, position }) {
            return false;
        }
        let copied = self.point().map_or(1, |point| point.orientations.len());
        let alone = (1..copied).rev().all(|number| {
            self.edit(Edit::RemoveOrientation {
                point: at,
                at: number,
            })
        });
        alone
            && self.edit(Edit::SetOrientation {
                point: at,
                at: 0,
                orientation,
            })
            && self.document.select(at, 0).is_ok()
    }

    /// What the window calls the host's view.
    pub(crate) fn host_name(&self) -> &str {
        let name = self.host_view.name.as_deref();
        name.filter(|name| !name.is_empty())
            .unwrap_or(self.texts().space.host_view)
    }
}

/// A valid pose, with perpendicular vectors of length 1.
fn checked(pose: &Pose, space: Space) -> Result<Pose> {
    let [position, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    space.check_place(position)?;
    View::from_pose(DVec3::ZERO, view, up, pose.zoom, 1.5, 1e-3, 1.0)?;
    let view = orientation::unit(view);
    let up = orientation::unit(up);
    let up = orientation::unit(up - view * up.dot(view));
    let made = Pose {
        vpn: view.to_array(),
        vup: up.to_array(),
        ..*pose
    };
    seen_by(&made, space, &Orientation::default()).check(position, space)?;
    Ok(made)
}

/// The orientation of a pose, with the speeds and the hold of another one.
fn seen_by(pose: &Pose, space: Space, other: &Orientation) -> Orientation {
    let target = Target::Relative(DVec3::from_array(pose.vpn) * TARGET * space.half_size);
    // As the path will read it: near a pole each bit of the direction counts.
    let view = orientation::unit(target.offset_from(DVec3::from_array(pose.vrp)));
    let up = DVec3::from_array(pose.vup);
    let roll = orientation::roll_from_up(space.up.upright(view), space.up.upright(up));
    Orientation {
        target,
        roll: orientation::wrap_degrees(roll.to_degrees()),
        zoom: pose.zoom,
        own: Overrides::default(),
        ..other.clone()
    }
}

/// The button beside the ghost, which is at this place of the movement window.
pub(crate) fn button(
    editor: &Editor,
    context: &Context,
    viewport: Rect,
    ghost: Pos2,
) -> Option<Action> {
    let id = Id::unique("take over the view");
    let text = editor.texts().space.take_over;
    let tip = editor.texts().space.take_over_tip;
    let size = context
        .data(|data| data.get_temp(id))
        .unwrap_or(vec2(120.0, 24.0));
    let room = Rect::from_min_max(viewport.min, viewport.max - size).shrink(6.0);
    let shown = Area::new(id)
        .order(Order::Middle)
        .fixed_pos(room.clamp(ghost + vec2(14.0, 10.0)))
        .constrain(false)
        .show(context, |ui| {
            ui.add(Button::new(text).small()).on_hover_text(tip)
        });
    context.data_mut(|data| data.insert_temp(id, shown.response.rect.size()));
    let replace = context.input(|input| input.modifiers.shift);
    shown
        .inner
        .clicked()
        .then_some(Action::Path(PathAction::TakeOver { replace }))
}

#[cfg(test)]
mod tests;
