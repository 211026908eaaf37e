//! The menu of a point or of empty space, opened by a right click.

use egui::containers::menu::menu_style;
use egui::{Align, Button, Key, Layout, Popup, PopupKind, Pos2, Rect, SetOpenCommand, Ui};
use glam::DVec3;
use vides_engine::path::Up;

use super::picking::REACH;
use super::projection::{Projection, from_pos};
use super::surface::projection_of;
use crate::action::{Action, PathAction};
use crate::setup::{Element, View};
use crate::state::Editor;
use crate::state::space::solid::Sight;
use crate::state::space::{Handle, PointMenu};
use crate::texts::fill;

/// Shows the menu if it is open, and opens it where it was `asked` for.
pub(super) fn show(
    menu: &mut PointMenu,
    mut asked: Option<(Pos2, Option<Handle>)>,
    sight: Option<&Sight>,
    editor: &Editor,
    ui: &Ui,
    viewport: Rect,
    actions: &mut Vec<Action>,
) {
    let id = ui.scope_id().with("point menu");
    let context = ui.ctx();
    let projection = projection_of(editor, viewport);
    // Shift-F10 is the menu key everywhere.
    if asked.is_none()
        && !Popup::is_any_open(context)
        && context.input_mut(|input| input.consume_key(egui::Modifiers::SHIFT, Key::F10))
    {
        let at = editor.document.selection().point;
        if let Some(point) = editor.document.path().points.get(at) {
            let place = projection.pos(point.position);
            asked = Some((viewport.clamp(place), Some(Handle::Point(at))));
        }
    }
    let open = asked.map(|(at, what)| {
        *menu = PointMenu {
            at,
            of_point: what.is_some(),
            corner: corner_at(editor, &projection, at).or_else(|| sight?.place(at)),
        };
        SetOpenCommand::Bool(true)
    });
    let PointMenu {
        at,
        of_point,
        corner,
    } = *menu;
    Popup::new(id, context.clone(), at, ui.layer_id())
        .kind(PopupKind::Menu)
        .layout(Layout::top_down_justified(Align::Min))
        .style(menu_style)
        .open_memory(open)
        .show(|ui| {
            ui.set_min_width(200.0);
            if let Some(corner) = corner {
                aims(editor, ui, corner, actions);
                ui.separator();
            }
            if editor.has_host_view() {
                take_over(editor, ui, actions);
                ui.separator();
            }
            if of_point {
                entries(editor, ui, actions);
            } else {
                views(editor, ui, actions);
            }
        });
}

/// The corner of the object at a place on the screen, the front one of several.
pub(super) fn corner_at(editor: &Editor, projection: &Projection, at: Pos2) -> Option<DVec3> {
    if !editor.setup.shown.has(Element::Object) {
        return None;
    }
    let away = |corner: DVec3| projection.image(corner).distance(from_pos(at));
    let corners = editor.document.info().object.iter();
    let near = corners.map(|point| point.position).filter(|&corner| {
        // Written so that NaN is not near.
        away(corner) <= 1.5 * REACH
    });
    let depth = |corner: DVec3| corner.dot(projection.toward());
    near.max_by(|&a, &b| depth(a).total_cmp(&depth(b)))
}

/// Entries that aim cameras at a corner of the object.
fn aims(editor: &Editor, ui: &mut Ui, corner: DVec3, actions: &mut Vec<Action>) {
    let (texts, hints) = (&editor.texts().space, &editor.texts().menu_hints);
    let button = ui.button(texts.aim_here).on_hover_text(hints.aim_here);
    if button.clicked() {
        actions.push(Action::Path(PathAction::AimAt(corner)));
    }
    let button = ui.button(texts.aim_all_here);
    if button.on_hover_text(hints.aim_all_here).clicked() {
        actions.push(Action::Path(PathAction::AimAllAt(corner)));
    }
}

/// Entries that make the host's view one of the path.
fn take_over(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    for (text, hint, replace) in [
        (texts.take_over, texts.take_over_tip, false),
        (texts.take_over_here, texts.take_over_here_tip, true),
    ] {
        if ui.button(text).on_hover_text(hint).clicked() {
            actions.push(Action::Path(PathAction::TakeOver { replace }));
        }
    }
}

/// Entries for the current point.
fn entries(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = editor.texts();
    let (space, menu, hints) = (&texts.space, &texts.menu, &texts.menu_hints);
    let (position, output) = (&texts.position, &texts.output);
    let closed = editor.document.path().closed;
    let count = editor.document.path().points.len();
    // The tooltip says why an entry is disabled.
    let entry = |ui: &mut Ui, text: &str, hint: &str, not: Option<&str>| {
        ui.add_enabled(not.is_none(), Button::new(text))
            .on_hover_text(hint)
            .on_disabled_hover_text(not.unwrap_or_default())
            .clicked()
    };
    let no_ends = closed.then_some(position.closed_has_no_ends);
    if entry(ui, menu.append, hints.append, no_ends) {
        actions.push(Action::Path(PathAction::AppendPoint));
    }
    if entry(ui, menu.prepend, hints.prepend, no_ends) {
        actions.push(Action::Path(PathAction::PrependPoint));
    }
    let (text, hint) = if closed {
        (space.make_open, hints.open)
    } else {
        (space.make_closed, hints.close)
    };
    if entry(ui, text, hint, None) {
        actions.push(Action::Path(PathAction::SwitchClosed));
    }
    let (text, hint) = if editor.joint().is_some() {
        (position.by_shape, position.by_shape_hint)
    } else {
        (position.own_tangents, position.own_tangents_hint)
    };
    if entry(ui, text, hint, None) {
        actions.push(Action::Path(PathAction::OwnTangents(
            editor.joint().is_none(),
        )));
    }
    crate::playing::pin_menu(editor, ui, editor.document.selection().point, actions);
    ui.separator();
    let (copy, hint) = match editor.several() {
        Some(_) => (menu.copy_points, hints.copy_points),
        None => (menu.copy_orientation, hints.copy_orientation),
    };
    if entry(ui, copy, hint, None) {
        actions.push(Action::Copy);
    }
    if entry(ui, menu.paste, hints.paste, None) {
        actions.push(Action::Paste);
    }
    let nothing = editor.copied.is_none().then_some(output.nothing_copied);
    if entry(ui, menu.paste_orientation, hints.paste_orientation, nothing) {
        actions.push(Action::Path(PathAction::PasteOrientation));
    }
    if entry(ui, menu.aim_all, hints.aim_all, None) {
        actions.push(Action::Path(PathAction::AimAll));
    }
    ui.separator();
    let two = (count <= vides_engine::limits::MIN_POINTS).then_some(position.two_remain);
    if entry(ui, &editor.removal(), position.remove_hint, two) {
        actions.push(Action::Path(PathAction::RemovePoint));
    }
}

pub(super) fn views(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let (texts, hints) = (&editor.texts().space, &editor.texts().menu_hints);
    let [right, upright, front] = match editor.document.path().space.up {
        Up::Y => ["x", "y", "z"],
        Up::Z => ["y", "z", "x"],
    };
    let along = |axis: &str| fill(hints.view_along, &[&axis]);
    let whole = View::default();
    let seen_from = |rotation: f64, tilt: f64| View {
        rotation,
        tilt,
        ..whole
    };
    let views = [
        (texts.view_reset, hints.view_reset.to_owned(), whole),
        (texts.view_front, along(front), seen_from(0.0, 0.0)),
        (texts.view_right, along(right), seen_from(-90.0, 0.0)),
        (texts.view_above, along(upright), seen_from(0.0, 90.0)),
    ];
    for (text, hint, view) in views {
        if ui.button(text).on_hover_text(hint).clicked() {
            actions.push(Action::View(view));
        }
    }
}
