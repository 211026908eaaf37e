//! The sections and the keys between them as they can be clicked: the left button selects one, the
//! right one opens the menu with ready paces for it.

use egui::{Button, Popup, Response};
use vides_document::Selection;
use vides_engine::limits::{MAX_HOLD, SPEEDS};
use vides_engine::path::{Orientation, Pace};

use super::axis::Axis;
use super::key_menu::entry;
use super::pins;
use crate::action::Action;
use crate::playing::axis::as_frame;
use crate::state::{Editor, with};
use crate::windows::shapes;
use crate::windows::speed::join::slow_past;

pub(super) fn show(editor: &Editor, response: &Response, axis: &Axis, actions: &mut Vec<Action>) {
    let clicked = response.clicked() || response.secondary_clicked();
    if let Some(pointer) = response.interact_pointer_pos().filter(|_| clicked) {
        let frame = axis.frame(pointer.x);
        let stretches = editor.playing.marks.graph.stretches();
        let there = stretches
            .iter()
            .find(|stretch| frame < as_frame(stretch.end));
        actions.extend(there.map(|stretch| Action::Select(stretch.from)));
    }
    Popup::context_menu(response).show(|ui| {
        if let Some(speeds) = shapes(editor, ui) {
            let edit = editor.orientation_edit(|view| by_ten(view, speeds));
            actions.extend(edit.map(Action::Edit));
            ui.close();
        }
        ui.separator();
        let texts = editor.texts();
        let large = Button::new(texts.menu.speeds);
        if entry(ui, large, texts.menu_hints.speeds) {
            actions.push(Action::SpeedCurve);
        }
    });
}

fn by_ten(view: &mut Orientation, speeds: [f64; SPEEDS]) {
    view.speeds = speeds;
    if let Ok(own) = view.own.with(|own| own.pace = Pace::Speeds) {
        view.own = own;
    }
}

/// The menu of a key: how the camera passes it.
pub(super) fn of_key(
    editor: &Editor,
    response: &Response,
    of: Selection,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().timeline;
    Popup::context_menu(response).show(|ui| {
        let view = |at: Selection| {
            let point = editor.document.path().points.get(at.point)?;
            point.orientations.get(at.orientation)
        };
        let two = slow_past(&editor.document, of);
        let slow = ui.add_enabled(two.is_some(), Button::new(texts.slow_past));
        let slow = slow.on_disabled_hover_text(texts.no_slow_past);
        if slow.on_hover_text(texts.slow_past_hint).clicked() {
            let edits = two
                .into_iter()
                .flatten()
                .filter_map(|(at, speeds)| Some(with(at, view(at)?, |view| by_ten(view, speeds))));
            actions.push(Action::Select(of));
            actions.push(Action::Edits(edits.collect()));
            ui.close();
        }
        let held = view(of).map_or(0, |view| view.hold);
        // Whole, and in the range of a u32.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let second = editor
            .document
            .info()
            .fps
            .round()
            .clamp(1.0, f64::from(MAX_HOLD)) as u32;
        let (words, hint, hold) = match held {
            0 => (texts.rest, texts.rest_hint, second),
            _ => (texts.no_rest, texts.no_rest_hint, 0),
        };
        if entry(ui, Button::new(words), hint) {
            let edit = view(of).map(|view| with(of, view, |new| new.hold = hold));
            actions.push(Action::Select(of));
            actions.extend(edit.map(Action::Edit));
        }
        pins::menu(editor, ui, of.point, actions);
    });
}

#[cfg(test)]
mod tests {
    use egui::PointerButton;

    use crate::playing::tracks::tests as hands;
    use crate::screenshots::screenshot;
    use crate::tests::*;
    use crate::texts::fill;
    use vides_document::Selection;
    use vides_engine::path::CameraPath;

    /// One click selects the section that is seen there, its menu gives it a ready pace in one step.
    #[test]
    fn a_section_is_selected_and_has_a_menu() {
        for language in BOTH {
            let texts = language.texts();
            let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
            let row = window.get_by_role_and_label(Role::Canvas, texts.timeline.all_sections);
            let row = row.rect();
            let click = |window: &mut Window, share: f32, button| {
                hands::click(window, row.lerp_inside(vec2(share, 0.5)), button);
            };
            let speeds = |window: &Window| window.state().orientation().expect("a view").speeds;
            click(&mut window, 0.1, PointerButton::Primary);
            assert_eq!(window.state().document.selection(), Selection::at(0, 0));
            click(&mut window, 0.8, PointerButton::Secondary);
            let chosen = window.state().document.selection();
            assert!(chosen.point > 2, "{chosen:?}");
            let before = speeds(&window);
            crate::tests::click(&mut window, texts.speed_window.both);
            assert_ne!(speeds(&window), before);
            assert!(window.query_by_label(texts.speed_window.both).is_none());
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(speeds(&window), before);
            click(&mut window, 0.8, PointerButton::Secondary);
            crate::tests::click(&mut window, texts.menu.speeds);
            assert!(window.state().windows.speed.is_some());
        }
    }

    /// The right button at a key: slowly past it, or a rest there, each one step.
    #[test]
    fn a_key_has_a_menu_for_how_it_is_passed() {
        for language in BOTH {
            let texts = &language.texts().timeline;
            let mut harness = window_with_points(language, LARGE, 1.0, Theme::Light);
            let click_key = |harness: &mut Window, point: usize| {
                let name = harness.state().name_of(point, 0);
                let place = harness.get_by_label(&fill(texts.key, &[&name])).rect();
                hands::click(harness, place.center(), PointerButton::Secondary);
            };
            let path = |window: &Window| window.state().document.path().clone();
            let before = path(&harness);
            click_key(&mut harness, 4);
            screenshot(&mut harness, &format!("key-menu-{language:?}.png"));
            click(&mut harness, texts.slow_past);
            let slow = path(&harness);
            let speeds = |path: &CameraPath, at: usize| path.points[at].orientations[0].speeds;
            assert!(speeds(&slow, 3)[9] < 0.5 * speeds(&before, 3)[9]);
            assert!(speeds(&slow, 4)[0] < 0.5 * speeds(&before, 4)[0]);
            assert_eq!(harness.state().document.selection(), Selection::at(4, 0));
            press(&mut harness, Modifiers::CTRL, Key::Z);
            assert_eq!(path(&harness), before);
            click_key(&mut harness, 4);
            click(&mut harness, texts.rest);
            assert_eq!(path(&harness).points[4].orientations[0].hold, 25);
            click_key(&mut harness, 4);
            click(&mut harness, texts.no_rest);
            assert_eq!(path(&harness), before);
            // Where the path begins nothing is slowed down.
            click_key(&mut harness, 0);
            click(&mut harness, texts.slow_past);
            assert_eq!(path(&harness), before);
        }
    }
}
