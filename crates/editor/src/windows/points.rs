//! The small window behind `Pos.++`: how many points (thesis A.4.1)?

use egui::{Button, Key, Modifiers, vec2};
use vides_engine::limits::MAX_DIVISION;

use crate::action::{Action, PathAction};
use crate::state::Editor;
use crate::state::windows::{PointsWindow, Windows};
use crate::texts::fill;
use crate::windows::sub_window::{SubWindow, sub_window, takes_keyboard};
use crate::{keys, theme};

/// The digits in the order of the numbers that they pick.
const DIGITS: [Key; MAX_DIVISION] = [
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::Num8,
    Key::Num9,
    Key::Num0,
];

impl SubWindow for PointsWindow {
    const ID: &'static str = "points";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.points
    }

    fn new(_: &Editor) -> Self {
        Self { fresh: true }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().position;
        let mut picked = None;
        let mut stays = sub_window(context, Self::ID, texts.how_many, |ui| {
            let point = editor.document.selection().point + 1;
            let hint = fill(texts.how_many_hint, &[&point]);
            ui.colored_label(theme::palette(ui).weak, &hint);
            let gaps = (MAX_DIVISION / 2 - 1) as f32 * ui.spacing().item_spacing.x;
            let share = (ui.min_rect().width() - gaps) / (MAX_DIVISION / 2) as f32;
            let size = vec2(share.floor().max(48.0), 28.0);
            for row in 0..2 {
                ui.horizontal(|ui| {
                    for column in 1..=MAX_DIVISION / 2 {
                        let count = row * MAX_DIVISION / 2 + column;
                        let button = Button::new(count.to_string()).min_size(size);
                        let response = ui.add(button);
                        takes_keyboard(ui, &response, &mut self.fresh);
                        if response.clicked() {
                            picked = Some(count);
                        }
                    }
                });
            }
        });
        if !keys::was_typing(context) {
            picked = picked.or_else(|| {
                let pressed =
                    |key: &Key| context.input_mut(|input| input.consume_key(Modifiers::NONE, *key));
                DIGITS.iter().position(pressed).map(|index| index + 1)
            });
        }
        if let Some(count) = picked {
            actions.push(Action::Path(PathAction::AddPoints(count)));
            stays = false;
        }
        stays
    }
}
