//! The list of the nodes, to choose whose path is edited.

use egui::{Button, Context, Rect, RichText, ScrollArea, Ui, vec2};
use vides_engine::scene::{Kind, Node, Scene};

use crate::action::Action;
use crate::document::StepName;
use crate::number::decimals;
use crate::state::Editor;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// Its width at first, in points.
const WIDTH: f32 = 190.0;

/// The indent of each level of the tree, and the deepest level that is indented.
const INDENT: f32 = 12.0;
const DEEPEST: usize = 6;

/// Rows seen at once.
const ROWS: f32 = 12.0;

/// Shows the list in a window of its own, if there is a scene and the column of lists is folded.
pub(crate) fn show(editor: &Editor, context: &Context, viewport: Rect, actions: &mut Vec<Action>) {
    if editor.document.edited_scene().is_none() || editor.points_list.is_open(context) {
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

/// The list, at most this high, if there is a scene.
pub(crate) fn list(editor: &Editor, ui: &mut Ui, highest: f32, actions: &mut Vec<Action>) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    let rows = rows(edited.scene());
    ui.spacing_mut().item_spacing.y = 0.0;
    ScrollArea::vertical()
        .id_salt("scene")
        .max_height(highest)
        .auto_shrink([false, true])
        .show_rows(ui, theme::ROW, rows.len() + 1, |ui, shown| {
            for row in shown {
                let of = row.checked_sub(1).map(|row| rows[row]);
                actions.extend(row_of(editor, ui, edited.scene(), of));
            }
        });
    if let Some(trouble) = trouble(editor) {
        ui.add_space(theme::GAP);
        ui.label(RichText::new(trouble).color(theme::palette(ui).error));
    }
}

/// What hinders a node, such as a function that no program has registered.
fn trouble(editor: &Editor) -> Option<String> {
    let text = editor.with_scene(|now| {
        let (node, why) = now.trouble.as_ref()?;
        let name = &now.scene.nodes()[*node].name;
        Some(format!("{name}: {}", reason_of(editor.language(), why)))
    });
    text.ok().flatten().flatten()
}

/// The nodes by number, each below its parent, with their levels.
fn rows(scene: &Scene) -> Vec<(usize, usize)> {
    let nodes = scene.nodes();
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); nodes.len() + 1];
    for (at, node) in nodes.iter().enumerate() {
        children[node.parent.map_or(0, |parent| parent + 1)].push(at);
    }
    let mut rows = Vec::with_capacity(nodes.len());
    let mut open: Vec<(usize, usize)> = children[0].iter().rev().map(|&at| (at, 0)).collect();
    while let Some((at, level)) = open.pop() {
        rows.push((at, level));
        open.extend(children[at + 1].iter().rev().map(|&at| (at, level + 1)));
    }
    rows
}

/// A node, or the whole scene.
fn row_of(
    editor: &Editor,
    ui: &mut Ui,
    scene: &Scene,
    of: Option<(usize, usize)>,
) -> Option<Action> {
    let texts = &editor.texts().scene;
    let node = of.map(|(at, level)| (at, level, &scene.nodes()[at]));
    let edited = editor.document.edited_scene()?.node();
    let chosen = edited == of.map(|(at, _)| at);
    let (name, kind, hint, possible) = match node {
        None => (texts.whole, "", texts.whole_hint, true),
        Some((_, _, node)) => {
            let hint = match (node.path(), node.keys().tracks().is_empty()) {
                (Some(_), _) => texts.edit_hint,
                (None, false) => texts.by_keys,
                (None, true) => texts.still,
            };
            let name = node.name.as_str();
            (name, kind(editor, node), hint, node.path().is_some())
        }
    };
    let level = node.map_or(0, |(_, level, _)| level.min(DEEPEST));
    let response = ui
        .horizontal(|ui| {
            #[allow(clippy::cast_precision_loss)]
            ui.add_space(INDENT * level as f32);
            // Readable, though nothing of it is edited here.
            let name = match possible || chosen {
                true => RichText::new(name),
                false => RichText::new(name).color(theme::palette(ui).weak),
            };
            let mut button = Button::selectable(chosen, name);
            if !kind.is_empty() {
                let small = RichText::new(kind).size(11.0);
                button = button.right_text(if chosen { small } else { small.weak() });
            }
            let button = button
                .truncate()
                .min_size(vec2(ui.available_width(), theme::ROW));
            ui.add(button)
        })
        .inner;
    let clicked = response.clicked() && !chosen && possible;
    response.on_hover_text(hint);
    clicked.then_some(Action::EditNode(of.map(|(at, _)| at)))
}

pub(super) fn kind(editor: &Editor, node: &Node) -> &'static str {
    let texts = &editor.texts().scene;
    match node.kind {
        Kind::Group => texts.group,
        Kind::Object(_) => texts.object,
        Kind::Light(_) => texts.light,
        Kind::Camera(_) => texts.camera,
    }
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
    /// Lets a camera follow a path in place of its keys, in one step.
    pub(crate) fn keys_to_path(&mut self, node: usize) {
        let made = match self.document.keys_to_path(node) {
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
        self.say(fill(text, &[&made.points, &off, &turned]));
    }
}
