//! The row below the numbers of a point: their window, the kind of curve, the point's own tangents.

use egui::{Button, Popup, Response, RichText, Role, Ui, WidgetInfo};

use super::{PanelButton, share};
use crate::action::Action;
use crate::document::{At, Edit};
use crate::path::CurveKind;
use crate::space::Joint;
use crate::state::Editor;
use crate::theme;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let width = share(ui, 3);
    ui.horizontal(|ui| {
        ui.spacing_mut().button_padding.x = 0.0;
        let change = PanelButton::new(texts.change, texts.change_hint, Action::Curve);
        change.show(editor, ui, width, actions);
        kind(editor, ui, width, actions);
        tangents(editor, ui, width, actions);
    });
}

/// Why tension, continuity and bias have no effect, if they have none.
pub(crate) fn without_shape(editor: &Editor) -> Option<&'static str> {
    match editor.document.path().curve {
        CurveKind::Tcb => None,
        CurveKind::Cubic | CurveKind::Linear => Some(editor.texts().position.no_shape_kind),
    }
}

/// The hint for them at a point that owns its tangents.
pub(crate) fn in_place_of_tangents(editor: &Editor, point: usize) -> Option<&'static str> {
    let path = editor.document.path();
    let owns = path.points.get(point)?.tangents.is_some();
    (owns && path.curve == CurveKind::Tcb).then_some(editor.texts().position.in_place_of_tangents)
}

/// Name and hint of a kind of curve.
pub(super) fn words_of(editor: &Editor, kind: CurveKind) -> (&'static str, &'static str) {
    let texts = &editor.texts().position;
    match kind {
        CurveKind::Tcb => (texts.tcb, texts.tcb_hint),
        CurveKind::Cubic => (texts.cubic, texts.cubic_hint),
        CurveKind::Linear => (texts.linear, texts.linear_hint),
    }
}

fn kind(editor: &Editor, ui: &mut Ui, width: f32, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let now = editor.document.path().curve;
    let word = words_of(editor, now).0;
    let response = choice(ui, width, word, texts.kind, word, false);
    Popup::menu(&response).show(|ui| {
        for kind in [CurveKind::Tcb, CurveKind::Cubic, CurveKind::Linear] {
            let (word, hint) = words_of(editor, kind);
            let button = ui.add(Button::selectable(kind == now, word));
            if button.on_hover_text(hint).clicked() && kind != now {
                actions.push(Action::Edit(Edit::set(At::Path, "curve", kind)));
            }
        }
    });
    response.on_hover_text(texts.kind_hint);
}

fn tangents(editor: &Editor, ui: &mut Ui, width: f32, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let words_of = |joint| match joint {
        Joint::Smooth => (texts.smooth, texts.smooth_hint),
        Joint::Mirrored => (texts.mirrored, texts.mirrored_hint),
        Joint::Corner => (texts.corner, texts.corner_hint),
    };
    let now = editor.joint();
    let value = now.map_or(texts.by_shape, |joint| words_of(joint).0);
    let name = texts.tangents;
    let response = choice(ui, width, name, name, value, now.is_some());
    Popup::menu(&response).show(|ui| {
        let mut entry = |ui: &mut Ui, chosen, (word, hint): (&str, &str), action| {
            let button = ui.add(Button::selectable(chosen, word));
            if button.on_hover_text(hint).clicked() {
                actions.push(action);
            }
        };
        let switch = (texts.own_tangents, texts.own_tangents_hint);
        let owns = now.is_some();
        entry(ui, owns, switch, Action::OwnTangents(!owns));
        if owns {
            ui.separator();
            for joint in Joint::ALL {
                let chosen = now == Some(joint);
                entry(ui, chosen, words_of(joint), Action::Join(joint));
            }
        }
    });
    response.on_hover_text(texts.tangents_hint);
}

/// A button that opens a choice; `name` and `value` are for screen readers.
fn choice(ui: &mut Ui, width: f32, text: &str, name: &str, value: &str, lit: bool) -> Response {
    let palette = theme::palette(ui);
    let button = if lit {
        Button::new(RichText::new(text).color(palette.on_accent)).fill(palette.accent)
    } else {
        Button::new(text)
    };
    let response = ui.add_sized([width, theme::ROW], button);
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(value.to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, true, name)
    });
    response
}
