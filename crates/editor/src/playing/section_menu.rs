//! The sections as they can be clicked: the left button selects one, the right one opens the menu with
//! ready paces for it.

use egui::{Button, Popup, Response};

use super::as_frame;
use super::axis::Axis;
use crate::action::Action;
use crate::path::Pace;
use crate::state::Editor;
use crate::windows::shapes;

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
            let edit = editor.orientation_edit(|orientation| {
                orientation.speeds = speeds;
                if let Ok(own) = orientation.own.with(|own| own.pace = Pace::Speeds) {
                    orientation.own = own;
                }
            });
            actions.extend(edit.map(Action::Edit));
            ui.close();
        }
        ui.separator();
        let texts = editor.texts();
        let large = ui.add(Button::new(texts.menu.speeds));
        if large.on_hover_text(texts.menu_hints.speeds).clicked() {
            actions.push(Action::SpeedCurve);
            ui.close();
        }
    });
}

#[cfg(test)]
mod tests {
    use egui::PointerButton;

    use crate::document::Selection;
    use crate::tests::*;

    /// One click selects the section that is seen there, its menu gives it a ready pace in one step.
    #[test]
    fn a_section_is_selected_and_has_a_menu() {
        for language in BOTH {
            let texts = language.texts();
            let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
            let row = window.get_by_role_and_label(Role::Canvas, texts.timeline.all_sections);
            let row = row.rect();
            let click = |window: &mut Window, share: f32, button| {
                let pos = row.lerp_inside(vec2(share, 0.5));
                window.hover_at(pos);
                window.run();
                for pressed in [true, false] {
                    window.event(egui::Event::PointerButton {
                        pos,
                        button,
                        pressed,
                        modifiers: Modifiers::NONE,
                    });
                    window.run();
                }
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
}
