//! The orientations of the current point (thesis A.4.2).

use egui::{Button, Popup, Role, Ui, WidgetInfo};
use glam::DVec3;
use vides_document::error::Result;
use vides_document::{Edit, Selection};
use vides_engine::math::rotation_minimising::turned;
use vides_engine::path::{CameraPath, OrientationOverrides, Target, Up, UpVector, ahead};

use super::position::three_numbers;
use crate::action::{Action, OwnedMotion, PathAction};
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, button_row, share};
use crate::playing::playhead::{Missing, Shown};
use crate::setup::Fold;
use crate::state::{Editor, with};
use crate::texts::fill;
use crate::theme;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().orientation;
    let Some(shown) = editor.shown() else {
        return;
    };
    let here = shown.at;
    let point = editor.document.path().points.get(here.point);
    let count = point.map_or(1, |point| point.orientations.len());
    let missing = shown.has_no_orientation();
    let (selection, current) = (shown.at, &shown.orientation);
    let ahead = current.own.ahead.is_some();
    let absolute = !ahead && matches!(current.target, Target::Absolute(_));
    let how = match (ahead, absolute) {
        (true, _) => texts.along_way,
        (_, true) => texts.at_place,
        _ => texts.in_direction,
    };
    let number = Editor::number_of(texts.count, here.orientation, count);
    let heading = Heading {
        editor,
        fold: Fold::View,
        text: texts.heading,
        remark: &format!("{number} · {how}"),
    };
    let words = &editor.texts().position;
    let here = (shown.missing == Missing::Orientation)
        .then_some([words.add_orientation_here, words.new_orientation]);
    if !heading.or_new(ui, here, actions) {
        return;
    }
    button_row(
        editor,
        ui,
        &[
            PanelButton::new(
                texts.absolute,
                texts.absolute_hint,
                Action::Path(PathAction::SetAbsolute(true)),
            )
            .chosen(absolute),
            PanelButton::new(
                texts.relative,
                texts.relative_hint,
                Action::Path(PathAction::SetAbsolute(false)),
            )
            .chosen(!absolute && !ahead),
            PanelButton::new(
                texts.ahead,
                texts.ahead_hint,
                Action::Path(PathAction::LookAhead),
            )
            .chosen(ahead),
        ],
        actions,
    );
    target(editor, ui, &shown, actions);
    if editor.has_object() {
        let button = PanelButton::new(
            texts.whole,
            texts.whole_hint,
            Action::Path(PathAction::ShowObject),
        );
        button_row(editor, ui, &[button], actions);
    }
    up(editor, ui, &shown, actions);
    let language = editor.language();
    let roll = Number::new(texts.roll, current.roll)
        .of_view("roll_degrees")
        .label(texts.roll)
        .hint(texts.roll_hint)
        .faint(missing)
        .show(ui, language, "roll", ui.available_width());
    let roll = roll.try_map(|roll| editor.with_number(selection, current, "roll_degrees", roll));
    actions.push(Action::enter(missing, roll));
}

fn target(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().orientation;
    let (selection, current) = (shown.at, &shown.orientation);
    let missing = shown.has_no_orientation();
    if let Some(distance) = current.own.ahead {
        let entry = Number::new(texts.distance, distance)
            .label(texts.distance)
            .hint(texts.distance_hint)
            .faint(missing)
            .in_space(editor.document.path().space)
            .range(0.0..=f64::MAX)
            .show(ui, editor.language(), "ahead", ui.available_width());
        let entry = entry.try_map(|far| editor.with_number(selection, current, "ahead", far));
        actions.push(Action::enter(missing, entry));
        return;
    }
    let (words, vector) = match current.target {
        Target::Absolute(place) => (("target", texts.target, texts.target_hint), place),
        Target::Relative(way) => (("direction", texts.direction, texts.direction_hint), way),
    };
    let edit = |to| {
        Ok(with(selection, current, |new| {
            new.target = match new.target {
                Target::Absolute(_) => Target::Absolute(to),
                Target::Relative(_) => Target::Relative(to),
            };
        }))
    };
    three_numbers(editor, ui, words, vector, missing, edit, actions);
}

/// Which way is up: a choice, and the point if it is one; also whether the turning is custom.
fn up(editor: &Editor, ui: &mut Ui, shown: &Shown, actions: &mut Vec<Action>) {
    let texts = &editor.texts().orientation;
    let current = &shown.orientation.own.up;
    let words = |up: &UpVector| match up {
        UpVector::Axis => (texts.up_axis, texts.up_axis_hint),
        UpVector::Point(_) => (texts.up_place, texts.up_place_hint),
        UpVector::Path(_) => (texts.up_path, texts.up_path_hint),
        UpVector::Minimal => (texts.up_minimal, texts.up_minimal_hint),
        UpVector::Frenet => (texts.up_frenet, texts.up_frenet_hint),
        UpVector::Fixed(Up::Y) => (texts.up_y, texts.up_fixed_hint),
        UpVector::Fixed(Up::Z) => (texts.up_z, texts.up_fixed_hint),
    };
    let turns = OwnedMotion::Turning.is_owned(shown);
    let width = share(ui, 1 + usize::from(turns));
    let row = ui.horizontal(|ui| {
        ui.spacing_mut().button_padding.x = 0.0;
        let button = Button::new(fill(texts.up, &[&words(current).0]));
        let response = ui.add_sized([width, theme::ROW], button);
        if turns {
            own(editor, ui, OwnedMotion::Turning, width, actions);
        }
        response
    });
    let response = row.inner;
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(words(current).0.to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, true, fill(texts.up, &[&""]).trim_end())
    });
    Popup::menu(&response).show(|ui| {
        let place = UpVector::Point(up_place(editor).unwrap_or_default());
        let path = path_for_up(editor.document.path());
        let all = [
            Some(UpVector::Axis),
            Some(place),
            path,
            Some(UpVector::Minimal),
            Some(UpVector::Frenet),
            Some(UpVector::Fixed(Up::Y)),
            Some(UpVector::Fixed(Up::Z)),
        ];
        for up in all.into_iter().flatten() {
            let chosen = up.name() == current.name();
            let (word, hint) = words(&up);
            let button = ui.add(Button::selectable(chosen, word)).on_hover_text(hint);
            if button.clicked() && !chosen {
                actions.push(Action::Path(PathAction::SetUp(up)));
            }
        }
    });
    response.on_hover_text(texts.up_hint);
    if let UpVector::Point(place) = *current {
        let words = ("up", texts.up_at, texts.up_at_hint);
        let edit = |to| {
            editor.with_own(shown.at, &shown.orientation, |own| {
                own.up = UpVector::Point(to)
            })
        };
        three_numbers(
            editor,
            ui,
            words,
            place,
            shown.has_no_orientation(),
            edit,
            actions,
        );
    }
}

impl OwnedMotion {
    pub(super) fn is_owned(self, shown: &Shown) -> bool {
        let own = &shown.orientation.own;
        let turns = || own.velocities.is_some() || own.turning.is_some();
        !shown.has_no_orientation()
            && match self {
                Self::Turning => turns() || own.roll_slope.is_some(),
                Self::Zoom => own.zoom_slope.is_some(),
            }
    }
}

/// Says that the orientation owns this, and gives it back.
pub(super) fn own(
    editor: &Editor,
    ui: &mut Ui,
    what: OwnedMotion,
    width: f32,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().orientation;
    let (text, hint) = match what {
        OwnedMotion::Turning => (texts.own_turning, texts.own_turning_hint),
        OwnedMotion::Zoom => (texts.own_slope, texts.own_slope_hint),
    };
    let button =
        PanelButton::new(text, hint, Action::Path(PathAction::ClearOverride(what))).chosen(true);
    button.show(editor, ui, width, actions);
}

impl Editor {
    /// Removes what the current orientation owns of this.
    pub(crate) fn give_back(&mut self, what: OwnedMotion) {
        match self.without(what) {
            Ok(edits) => {
                self.edit_all(edits);
            }
            Err(error) => self.complain_of(&error),
        }
    }

    fn without(&self, what: OwnedMotion) -> Result<Vec<Edit>> {
        let path = self.document.path();
        let here = self.document.selection();
        let mut edits = Vec::new();
        let mut change =
            |at: Selection, change: &dyn Fn(&mut OrientationOverrides)| -> Result<()> {
                let points = path.points.get(at.point);
                let key = points.and_then(|point| point.orientations.get(at.orientation));
                let Some(key) = key else { return Ok(()) };
                let own = key.own.with(change)?;
                if own != key.own {
                    edits.push(with(at, key, |new| new.own = own));
                }
                Ok(())
            };
        match what {
            OwnedMotion::Zoom => change(here, &|own| own.zoom_slope = None)?,
            OwnedMotion::Turning => {
                change(here, &|own| {
                    own.velocities = None;
                    own.turning = None;
                    own.roll_slope = None;
                })?;
                // A part of a turning that leads here would reach it as before.
                if let Some(before) = before(path, here) {
                    change(before, &|own| own.turning = None)?;
                }
            }
        }
        Ok(edits)
    }
}

/// The orientation before another, around the end of a closed path.
fn before(path: &CameraPath, at: Selection) -> Option<Selection> {
    if let Some(orientation) = at.orientation.checked_sub(1) {
        return Some(Selection::at(at.point, orientation));
    }
    let last = path.closed.then(|| path.points.len() - 1);
    let point = at.point.checked_sub(1).or(last)?;
    Some(Selection::at(
        point,
        path.points[point].orientations.len() - 1,
    ))
}

/// A point above the current camera, half a space away, with which its picture stays.
fn up_place(editor: &Editor) -> Option<DVec3> {
    let Selection { point, orientation } = editor.document.selection();
    let path = editor.document.path();
    let view = ahead::view(path, point, orientation);
    let up = editor.document.up(point, orientation).ok()?;
    let unrolled = turned(up, view, -editor.orientation()?.roll.to_radians());
    Some(editor.point()?.position + path.space.half_size * unrolled)
}

/// The first path that an orientation has for its up.
fn path_for_up(path: &CameraPath) -> Option<UpVector> {
    let mut all = path.points.iter().flat_map(|point| &point.orientations);
    let found = all.find(|key| matches!(key.own.up, UpVector::Path(_)))?;
    Some(found.own.up.clone())
}
