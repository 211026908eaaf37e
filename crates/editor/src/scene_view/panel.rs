//! What stands around the list of the nodes: its own window, and what is said where no path is edited.

use egui::{Button, Context, Rect, RichText, Ui, vec2};
use vides_document::StepName;
use vides_engine::tools::fit::Tolerance;

use super::list::{is_shown, list};
use crate::action::Action;
use crate::number::decimals;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// Its width at first, in points.
const WIDTH: f32 = 190.0;

/// Rows seen at once.
const ROWS: f32 = 12.0;

/// Shows the list in a separate window, if there is a scene and the column of lists is folded.
pub(crate) fn show(editor: &Editor, context: &Context, viewport: Rect, actions: &mut Vec<Action>) {
    if editor.document.edited_scene().is_none() || editor.points_list.is_open(context) {
        return;
    }
    // While the column is being folded it has shown the list.
    if is_shown(editor, context) {
        return;
    }
    egui::Window::new(editor.texts().scene.title)
        .id(egui::Id::unique("scene"))
        .default_pos(viewport.left_top() + vec2(12.0, 30.0))
        .default_width(WIDTH)
        .constrain_to(viewport)
        .resizable([true, false])
        .show(context, |ui| list(editor, ui, ROWS * theme::ROW, actions));
}

/// What hinders a node, such as a function that no program has registered.
pub(super) fn trouble(editor: &Editor) -> Option<String> {
    let text = editor.with_scene(|now| {
        let (node, why) = now.trouble.as_ref()?;
        let name = &now.scene.nodes()[*node].name;
        Some(format!("{name}: {}", reason_of(editor.language(), why)))
    });
    text.ok().flatten().flatten()
}

/// Stands in place of the panels where no path is edited.
pub(crate) fn no_path(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let (texts, weak) = (&editor.texts().scene, theme::palette(ui).weak);
    let camera = camera_by_keys(editor);
    let text = match &camera {
        Some((_, name)) => fill(texts.runs_by_keys, &[name]),
        None => texts.no_path.to_owned(),
    };
    ui.label(RichText::new(text).color(weak));
    let Some((node, _)) = camera else {
        return;
    };
    ui.add_space(theme::GAP);
    let size = vec2(ui.available_width(), theme::ROW);
    let button = Button::new(texts.keys_to_path);
    if ui
        .add_sized(size, button)
        .on_hover_text(texts.keys_to_path_hint)
        .clicked()
    {
        actions.push(Action::KeysToPath(node));
    }
}

/// The camera that is shown, with its name, if it moves but follows no path.
fn camera_by_keys(editor: &Editor) -> Option<(usize, String)> {
    let scene = editor.document.edited_scene()?.scene();
    let node = scene.shown_camera()?;
    let camera = &scene.nodes()[node];
    let moves = camera.aim.is_some() || !camera.keys().tracks().is_empty();
    (moves && camera.path().is_none()).then(|| (node, camera.name.clone()))
}

impl Editor {
    /// How near a path comes to keys, and keys to a path.
    pub(super) fn tolerance(&self) -> Tolerance {
        let chosen = self.scene_view.tolerance;
        chosen.unwrap_or_else(|| self.document.usual_tolerance())
    }

    /// Lets a node move by as few keys as stay near its path, in one step.
    pub(super) fn path_to_few_keys(&mut self, node: usize) {
        let made = match self.document.path_to_few_keys(node, self.tolerance()) {
            Ok(made) => made,
            Err(error) => return self.complain_of(&error),
        };
        self.select_nodes(vec![node]);
        if self.edit_all(made.edits) {
            let language = self.language();
            let off = language.number(made.off, decimals(self.shown_space().half_size) + 1);
            let turned = language.number(made.turned, 2);
            let text = self.texts().node.became_few_keys;
            self.say_done(fill(text, &[&made.keys, &off, &turned]));
        }
    }

    /// Lets a camera follow a path in place of its keys, in one step.
    pub(crate) fn keys_to_path(&mut self, node: usize) {
        let edited = self.document.edited_scene();
        let of = edited.and_then(|edited| edited.scene().nodes().get(node));
        let aimed = of.is_some_and(|of| of.aim.is_some());
        let made = match self.document.keys_to_path(node, self.tolerance()) {
            Ok(made) => made,
            Err(error) => return self.complain_of(&error),
        };
        self.document.begin_step();
        self.document.name_step(StepName::KeysToPath);
        if !self.edit_together(made.edits) {
            self.document.cancel_step();
            return;
        }
        self.document.end_step();
        let language = self.language();
        let off = language.number(made.off, decimals(self.document.path().space.half_size) + 1);
        let turned = language.number(made.turned, 2);
        let text = self.texts().scene.became_path;
        let mut text = fill(text, &[&made.points, &off, &turned]);
        if aimed {
            text += self.texts().scene.aim_became_views;
        }
        self.say(text);
    }
}
