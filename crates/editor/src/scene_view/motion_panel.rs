//! The panel of what moves a node: nothing, keys or a path.

use egui::{Button, Popup, Role, Ui, WidgetInfo, vec2};
use vides_document::Edit;
use vides_engine::limits::MAX_COORDINATE;
use vides_engine::scene::{Extrapolation, Part};
use vides_engine::tools::fit::Tolerance;

use super::keys_panel::Shown;
use crate::action::Action;
use crate::entry::Entry;
use crate::number::{Number, decimals};
use crate::panels::parts::{Heading, PanelButton, apart, button_row, share};
use crate::setup::Fold;
use crate::state::Editor;
use crate::state::scene_view::{Moves, NodeAction};
use crate::texts::fill;
use crate::theme;
use crate::typed::Quantity;

pub(super) fn show(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    apart(ui);
    let heading = Heading {
        editor,
        fold: Fold::Motion,
        text: texts.motion,
        remark: "",
    };
    if !heading.show(ui, actions).0 {
        return;
    }
    let now = editor.moves(of.at);
    let choice = |moves, text, hint| {
        let action = Action::Node(NodeAction::Motion(of.at, moves));
        PanelButton::new(text, hint, action).chosen(moves == now)
    };
    let all = [
        choice(Moves::Nothing, texts.none, texts.none_hint),
        choice(Moves::Keys, texts.by_keys, texts.by_keys_hint),
        choice(Moves::Path, texts.by_path, texts.by_path_hint),
    ];
    button_row(editor, ui, &all, actions);
    match now {
        Moves::Nothing => {}
        Moves::Path => {
            start(editor, ui, of, actions);
            beyond(editor, ui, of, actions);
            let action = |action| Action::Node(action);
            let each = action(NodeAction::Motion(of.at, Moves::Keys));
            let few = action(NodeAction::FewKeys(of.at));
            let buttons = [
                PanelButton::new(texts.path_to_keys, texts.path_to_keys_hint, each),
                PanelButton::new(texts.few_keys, texts.few_keys_hint, few),
            ];
            near(editor, ui, actions);
            button_row(editor, ui, &buttons, actions);
        }
        Moves::Keys => {
            near(editor, ui, actions);
            let size = vec2(ui.available_width(), theme::ROW);
            let button = ui.add_sized(size, Button::new(texts.keys_to_path));
            let hint = editor.texts().scene.keys_to_path_hint;
            if button.on_hover_text(hint).clicked() {
                actions.push(Action::Node(NodeAction::Motion(of.at, Moves::Path)));
            }
        }
    }
}

/// How near a path comes to keys, and keys to a path.
fn near(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let Tolerance { position, angle } = editor.tolerance();
    let half_size = editor.shown_space().half_size;
    ui.horizontal(|ui| {
        let width = share(ui, 2);
        let least = 1e-6 * half_size;
        let far = Number::new(texts.nearness, position)
            .label("±")
            .hint(texts.nearness_hint)
            .quantity(Quantity::Length)
            .decimals(decimals(half_size) + 1)
            .range(least..=half_size)
            .steps(1e-3 * half_size, 1e-4 * half_size)
            .show(ui, editor.language(), "near.position", width);
        let turned = Number::new(texts.nearness_angle, angle)
            .label("±")
            .hint(texts.nearness_angle_hint)
            .degrees()
            .decimals(2)
            .range(0.01..=90.0)
            .steps(0.1, 0.01)
            .show(ui, editor.language(), "near.angle", width);
        for (entry, is_angle) in [(far, false), (turned, true)] {
            match entry {
                Entry::Drag(value) | Entry::Set(value) => {
                    let (position, angle) = match is_angle {
                        true => (position, value),
                        false => (value, angle),
                    };
                    actions.push(Action::Node(NodeAction::Near(position, angle)));
                }
                Entry::Wrong(text) => actions.push(Action::Complain(text)),
                _ => {}
            }
        }
    });
}

/// The frame in which the path begins, as people count.
fn start(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let Some(follow) = of.node.path() else {
        return;
    };
    let texts = &editor.texts().node;
    let edited = editor.document.edited_scene();
    let is_edited = edited.is_some_and(|edited| edited.node() == Some(of.at));
    let pinned = edited.is_some_and(|edited| {
        let mut pins = edited.scene().pins().iter();
        pins.any(|pin| pin.node == of.at)
    });
    let start = match is_edited {
        true => editor.document.start_frame(),
        false => follow.start_frame(),
    };
    let more = f64::from(editor.document.info().first_frame) - 1.0;
    let beyond = follow.extrapolation();
    let hint = match pinned {
        true => texts.pinned_start,
        false => texts.start_hint,
    };
    let entry = Number::new(texts.start, start + more)
        .label(texts.start)
        .hint(hint)
        .decimals(0)
        .range(-MAX_COORDINATE..=MAX_COORDINATE)
        .steps(1.0, 0.5)
        .fixed_if(pinned)
        .show(
            ui,
            editor.language(),
            &format!("{}.start", of.at),
            ui.available_width(),
        );
    if entry != Entry::Idle {
        let node = of.at;
        let entry = entry.map(|frame| {
            let start_frame = frame - more;
            let part = Part::Start {
                node,
                start_frame,
                beyond,
            };
            Edit::Part(Box::new(part))
        });
        actions.push(Action::Node(NodeAction::Enter(Box::new(entry))));
    }
}

/// How motion continues before and after the path.
fn beyond(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let Some(follow) = of.node.path() else {
        return;
    };
    let texts = &editor.texts().node;
    let words = |beyond| match beyond {
        Extrapolation::Repeat => texts.repeat,
        Extrapolation::PingPong => texts.pingpong,
        _ => texts.hold,
    };
    let now = follow.extrapolation();
    let size = vec2(ui.available_width(), theme::ROW);
    let text = fill(texts.beyond, &[&words(now)]);
    let response = ui.add_sized(size, Button::new(text).truncate());
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(words(now).to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, true, texts.beyond_name)
    });
    Popup::menu(&response).show(|ui| {
        use Extrapolation::{Hold, PingPong, Repeat};
        for choice in [Hold, Repeat, PingPong] {
            let button = ui.add(Button::selectable(choice == now, words(choice)));
            if button.clicked() && choice != now {
                let part = Part::Start {
                    node: of.at,
                    start_frame: follow.start_frame(),
                    beyond: choice,
                };
                actions.push(Action::Edits(vec![Edit::Part(Box::new(part))]));
            }
        }
    });
    response.on_hover_text(texts.beyond_hint);
}
