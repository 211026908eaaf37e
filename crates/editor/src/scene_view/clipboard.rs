//! Nodes by the clipboard, between windows and programs, as the text of a `.vid` file.

use egui::Context;
use vides_document::{CopiedNodes, Edit};
use vides_engine::scene::Kind;

use crate::action::Action;
use crate::state::Editor;
use crate::state::scene_view::NodeCommand;
use crate::texts::fill;
use crate::texts::refusals::{of_edit, reason_of};

/// As many nodes that aim at nothing are named.
const NAMED: usize = 3;

impl Editor {
    /// Copies the selected nodes with their descendants; false with a message if none is selected.
    pub(crate) fn copy_nodes_out(&mut self, context: &Context) -> bool {
        let which = self.selected_nodes();
        if which.is_empty() {
            self.complain(self.texts().scene.nothing_copied);
            return false;
        }
        match self.document.nodes_as_text(&which) {
            Ok(text) => {
                context.copy_text(text);
                self.say(fill(self.texts().scene.nodes_copied, &[&which.len()]));
                true
            }
            Err(error) => {
                self.complain_of(&error);
                false
            }
        }
    }

    /// Copies the selected nodes and removes them, in one step.
    pub(crate) fn cut_nodes(&mut self, context: &Context) {
        if self.copy_nodes_out(context) {
            let said = self.message.take();
            self.act(Action::Nodes(NodeCommand::Remove), context);
            self.message = self.message.take().or(said);
        }
    }

    /// Adds the nodes of a text in the selected group, else in the scene itself; false: it has none.
    pub(crate) fn paste_nodes(&mut self, text: &str) -> bool {
        let edited = self.document.edited_scene();
        let group = self.current_node().filter(|&node| {
            edited.is_some_and(|edited| edited.scene().nodes()[node].kind == Kind::Group)
        });
        let texts = &self.texts().scene;
        let copied = match self.document.nodes_of_text(text, group) {
            Ok(Some(copied)) => copied,
            Ok(None) => return false,
            Err(error) => {
                let why = self.without_name(&error);
                self.complain(fill(texts.nodes_not_pasted, &[&why]));
                return true;
            }
        };
        let CopiedNodes {
            nodes,
            tops,
            without_aim,
            warnings,
        } = copied;
        // They come behind the others.
        let before = edited.map_or(1, |edited| edited.scene().nodes().len());
        let path = tops
            .first()
            .copied()
            .filter(|top| nodes[top - before].path().is_some());
        let count = tops.len();
        let done = self.edit_and_select(vec![Edit::AddNodes(nodes)], tops, path);
        if let Err(error) = done {
            let why = of_edit(self.language(), &error);
            self.complain(fill(texts.nodes_not_pasted, &[&why]));
        } else if let Some(warning) = warnings.first() {
            self.complain(reason_of(self.language(), warning));
        } else if without_aim.is_empty() {
            self.say_done(fill(texts.nodes_pasted, &[&count]));
        } else {
            let named = without_aim.iter().take(NAMED);
            let named: Vec<String> = named.map(|(node, aim)| format!("{node}: {aim}")).collect();
            let more = if without_aim.len() > NAMED {
                ", …"
            } else {
                ""
            };
            let named = format!("{}{more}", named.join(", "));
            self.say_done(fill(texts.pasted_without_aim, &[&count, &named]));
        }
        true
    }
}

#[cfg(test)]
#[path = "clipboard_tests.rs"]
pub(super) mod tests;
