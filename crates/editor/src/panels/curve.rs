//! The curve at the current point (thesis A.4.1): one menu of what shapes it, and below the numbers of
//! this point and the next.

use egui::{Align, Button, Layout, Popup, RichText, Ui, vec2};
use vides_document::{At, Edit};
use vides_engine::limits::PRESETS;
use vides_engine::path::{CurveKind, CurveParameters, Tcb};

use crate::action::{Action, PathAction};
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, share};
use crate::playing::playhead::Missing;
use crate::setup::Fold;
use crate::state::Editor;
use crate::state::space::Joint;
use crate::texts::fill;
use crate::{keys, theme};

/// Widths of the menu's columns.
const PRESETS_WIDE: f32 = 240.0;
const OTHERS_WIDE: f32 = 170.0;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let Some(shown) = editor.shown() else {
        return;
    };
    let heading = Heading {
        editor,
        fold: Fold::Curve,
        text: texts.curve,
        remark: &chosen(editor),
    };
    let (open, [_, choice]) = heading.choice(ui, texts.choice, actions);
    Popup::menu(&choice).show(|ui| menu(editor, ui, actions));
    choice.on_hover_text(texts.choice_hint);
    if !open || shown.missing != Missing::Nothing {
        return;
    }
    if editor.point().is_some_and(|point| point.keeps_motion) {
        let (text, hint) = (texts.keeps_motion, texts.keeps_motion_hint);
        let action = Action::Path(PathAction::OwnTangents(false));
        let button = PanelButton::new(text, hint, action).chosen(true);
        button.show(editor, ui, ui.available_width(), actions);
    }
    shape(editor, ui, false, actions);
    shape(editor, ui, true, actions);
}

/// The presets, the tangents, the kinds of curve, and the window with all numbers.
fn menu(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let column = Layout::top_down_justified(Align::LEFT);
    ui.horizontal_top(|ui| {
        ui.allocate_ui_with_layout(vec2(PRESETS_WIDE, 0.0), column, |ui| {
            presets(editor, ui, actions);
        });
        ui.allocate_ui_with_layout(vec2(OTHERS_WIDE, 0.0), column, |ui| {
            others(editor, ui, actions);
        });
    });
}

fn others(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let mut entry = |ui: &mut Ui, chosen, (word, hint): (&str, &str), action| {
        let button = ui.add(Button::selectable(chosen, word));
        if button.on_hover_text(hint).clicked() && !chosen {
            actions.push(action);
        }
    };
    let joint = editor.joint();
    let owned = (texts.own_tangents, texts.own_tangents_hint);
    let keeps_motion = editor.point().is_some_and(|point| point.keeps_motion);
    entry(
        ui,
        joint.is_some() && !keeps_motion,
        owned,
        Action::Path(PathAction::OwnTangents(true)),
    );
    if joint.is_some() {
        for kind in Joint::ALL {
            let words = match kind {
                Joint::Smooth => (texts.smooth, texts.smooth_hint),
                Joint::Mirrored => (texts.mirrored, texts.mirrored_hint),
                Joint::Corner => (texts.corner, texts.corner_hint),
            };
            entry(
                ui,
                joint == Some(kind),
                words,
                Action::Path(PathAction::Join(kind)),
            );
        }
        let given = (texts.by_shape, texts.by_shape_hint);
        entry(
            ui,
            false,
            given,
            Action::Path(PathAction::OwnTangents(false)),
        );
    }
    ui.separator();
    ui.weak(texts.kind);
    let now = editor.document.path().curve;
    for kind in CurveKind::ALL {
        let set = Action::Edit(Edit::set(At::Path, "curve", kind));
        entry(ui, kind == now, words_of(editor, kind), set);
    }
    ui.separator();
    let keys = keys::words(editor.language(), &Action::Curve).unwrap_or_default();
    let button = ui.add(Button::new(texts.change).right_text(keys));
    if button.on_hover_text(texts.change_hint).clicked() {
        actions.push(Action::Curve);
    }
}

fn presets(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().position;
    let palette = theme::palette(ui);
    let now = editor.point().map(|point| point.curve);
    let without = without_shape(editor);
    for preset in (0_u8..).take(PRESETS) {
        let chosen = now == Some(CurveParameters::Preset(preset)) && editor.joint().is_none();
        let tcb = editor.document.path().presets[usize::from(preset)];
        let shape = editor.texts().curve.shape(editor.language(), tcb);
        let shape = RichText::new(shape).color(if chosen {
            palette.on_accent
        } else {
            palette.weak
        });
        let button = Button::selectable(chosen, fill(texts.preset, &[&preset])).right_text(shape);
        let button = ui.add_enabled(without.is_none(), button);
        let button = button.on_disabled_hover_text(without.unwrap_or_default());
        if button.clicked() {
            let at = editor.document.selection().point;
            actions.push(Action::Edit(Edit::set(
                At::Point(at),
                "preset",
                usize::from(preset),
            )));
        }
    }
}

/// Where the current point's shape comes from.
fn chosen(editor: &Editor) -> String {
    let texts = &editor.texts().position;
    if editor.joint().is_some() {
        return texts.tangents.to_owned();
    }
    let kind = editor.document.path().curve;
    if !kind.has_shape() {
        return words_of(editor, kind).0.to_owned();
    }
    match editor.point().map(|point| point.curve) {
        Some(CurveParameters::Preset(preset)) => {
            let preset = usize::from(preset);
            let tcb = editor.document.path().presets[preset];
            editor.texts().curve.preset_name(preset, tcb)
        }
        Some(CurveParameters::Own(_)) => texts.own.to_owned(),
        None => String::new(),
    }
}

/// Why tension, continuity and bias have no effect, if they have none.
pub(crate) fn without_shape(editor: &Editor) -> Option<&'static str> {
    let without = !editor.document.path().curve.has_shape();
    without.then_some(editor.texts().position.no_shape_kind)
}

/// The hint for them at a point that owns its tangents.
pub(crate) fn in_place_of_tangents(editor: &Editor, point: usize) -> Option<&'static str> {
    let path = editor.document.path();
    let owns = path.points.get(point)?.tangents.is_some();
    (owns && path.curve.has_shape()).then_some(editor.texts().position.in_place_of_tangents)
}

/// Name and hint of a kind of curve.
fn words_of(editor: &Editor, kind: CurveKind) -> (&'static str, &'static str) {
    let texts = &editor.texts().position;
    match kind {
        CurveKind::Tcb => (texts.tcb, texts.tcb_hint),
        CurveKind::Centripetal => (texts.centripetal, texts.centripetal_hint),
        CurveKind::Chordal => (texts.chordal, texts.chordal_hint),
        CurveKind::Cubic => (texts.cubic, texts.cubic_hint),
        CurveKind::Linear => (texts.linear, texts.linear_hint),
    }
}

/// Tension, continuity and bias of the current point, or those of the `next` one to be read only.
fn shape(editor: &Editor, ui: &mut Ui, next: bool, actions: &mut Vec<Action>) {
    let texts = editor.texts();
    let path = editor.document.path();
    let at = editor.document.selection().point;
    let point = match next {
        false => Some(at),
        true if at + 1 < path.points.len() => Some(at + 1),
        true => path.closed.then_some(0),
    };
    let tcb = point.map(|point| path.tcb(point));
    let width = share(ui, 3);
    let language = editor.language();
    let without = without_shape(editor);
    let owns = point.filter(|_| !next);
    let owns = owns.and_then(|point| in_place_of_tangents(editor, point));
    let hint = if let Some(why) = without.or(owns) {
        why
    } else if next {
        texts.position.next_shape_hint
    } else {
        texts.position.shape_hint
    };
    type Part = fn(&mut Tcb) -> &mut f64;
    let parts: [(&str, &str, Part); 3] = [
        ("T", texts.curve.tension, |tcb| &mut tcb.tension),
        ("C", texts.curve.continuity, |tcb| &mut tcb.continuity),
        ("B", texts.curve.bias, |tcb| &mut tcb.bias),
    ];
    ui.horizontal(|ui| {
        for (letter, name, part) in parts {
            let value = tcb.map(|mut tcb| *part(&mut tcb));
            let label = if next {
                format!("{letter} \u{203a}")
            } else {
                letter.to_owned()
            };
            // As the thesis calls it, so that no other number has the same name.
            let name = format!("{name} ({}{})", letter.to_lowercase(), 1 + u8::from(next));
            let number = Number::new(&name, value)
                .label(&label)
                .hint(hint)
                .decimals(2)
                .range(-1.0..=1.0)
                .steps(0.01, 0.01)
                .fixed_if(next || without.is_some());
            let entry = number.show(ui, language, &format!("shape {label}"), width);
            if let Some(tcb) = tcb.filter(|_| !next) {
                let edit = |value| {
                    let mut tcb = tcb;
                    *part(&mut tcb) = value;
                    Edit::set(At::Point(at), "own", tcb)
                };
                actions.push(Action::Enter(entry.map(edit)));
            }
        }
    });
}
