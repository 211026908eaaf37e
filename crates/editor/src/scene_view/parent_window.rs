//! The question what nodes keep that move and get another parent.

use egui::{Button, Context, vec2};
use vides_engine::scene::Keep;

use crate::action::Action;
use crate::state::Editor;
use crate::state::scene_view::NodeCommand;
use crate::state::windows::ParentWindow;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;
use crate::windows::sub_window::sub_window;

/// The width of its buttons.
const WIDTH: f32 = 260.0;

impl ParentWindow {
    pub(crate) const ID: &'static str = "parent";

    /// A question about these nodes, of which `moving` move.
    pub(super) fn of(
        editor: &Editor,
        nodes: Vec<usize>,
        parent: Option<usize>,
        moving: &[usize],
    ) -> Option<Self> {
        let (texts, edited) = (&editor.texts().scene, editor.document.edited_scene()?);
        let name = |node: usize| edited.scene().nodes()[node].name.as_str();
        let text = match moving {
            [one] => fill(texts.one_moves, &[&name(*one)]),
            several => fill(
                texts.several_move,
                &[&name(*several.first()?), &several.len()],
            ),
        };
        let kept = editor.document.scene().and_then(|scene| {
            let mut moving = moving.iter();
            Ok(moving.try_for_each(|&node| scene.way_in(node, parent).map(drop))?)
        });
        let language = editor.language();
        Some(Self {
            nodes,
            parent,
            number: edited.number(),
            text,
            refused: kept.err().map(|error| reason_of(language, &error)),
        })
    }

    /// Shows it; false: it closes.
    pub(crate) fn show(
        &mut self,
        editor: &Editor,
        context: &Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let edited = editor.document.edited_scene();
        if edited.is_none_or(|edited| edited.number() != self.number) {
            return false;
        }
        let texts = &editor.texts().scene;
        let mut chosen = None;
        let stays = sub_window(context, Self::ID, texts.other_parent, |ui| {
            ui.set_max_width(WIDTH);
            ui.label(&self.text);
            ui.add_space(theme::GAP);
            let size = vec2(WIDTH, theme::ROW);
            let along = ui.add_sized(size, Button::new(texts.go_along));
            if along.on_hover_text(texts.go_along_hint).clicked() {
                chosen = Some(Keep::Numbers);
            }
            let button = Button::new(texts.keep_way).min_size(size);
            let way = ui.add_enabled(self.refused.is_none(), button);
            if way.on_hover_text(texts.keep_way_hint).clicked() {
                chosen = Some(Keep::Way);
            }
            if let Some(why) = &self.refused {
                ui.colored_label(theme::palette(ui).weak, why);
            }
        });
        let Some(keep) = chosen else {
            return stays;
        };
        let command = NodeCommand::PutAs(std::mem::take(&mut self.nodes), self.parent, keep);
        actions.push(Action::Nodes(command));
        false
    }
}
