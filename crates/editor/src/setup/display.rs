//! What the movement window shows (thesis A.5): a switch for each element. Changes show at once.

use crate::action::Action;
use crate::setup::{Element, Shown};
use crate::state::Editor;
use crate::state::windows::{DisplayWindow, Windows};
use crate::theme;
use crate::windows::dock::docked;
use crate::windows::sub_window::SubWindow;

impl SubWindow for DisplayWindow {
    const ID: &'static str = "display";
    const DOCKED: bool = true;

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.display
    }

    fn new(editor: &Editor) -> Self {
        Self {
            before: (editor.setup.shown, editor.setup.camera_view),
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().display;
        let tools = &editor.texts().tools;
        let mut setup = editor.setup.clone();
        let named = (Self::ID, texts.title);
        let keeps = ([tools.ok, tools.ok_hint], true);
        let end = docked(editor, context, named, Some(keeps), |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            // The background is always there.
            for element in Element::ALL
                .into_iter()
                .filter(|element| element.has_switch())
            {
                let mut on = setup.shown.has(element);
                if theme::tick(ui, &mut on, texts.name(element)).changed() {
                    setup.shown.set(element, on);
                }
            }
            theme::tick(ui, &mut setup.camera_view, texts.camera_view);
            let all = setup.shown == Shown::default();
            let button = ui.add_enabled(!all, egui::Button::new(texts.all));
            if button.on_hover_text(texts.all_hint).clicked() {
                setup.shown = Shown::default();
            }
        });
        if end == Some(false) {
            (setup.shown, setup.camera_view) = self.before;
        }
        if setup != editor.setup {
            actions.insert(0, Action::Setup(Box::new(setup)));
        }
        end.is_none()
    }
}
