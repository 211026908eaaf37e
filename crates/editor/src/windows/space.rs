//! Where the path lies in the world: centre and `half_size` of the movement space, its unit, its
//! up axis. What is entered is pending until it is applied, as one step.

use egui::{Button, Grid, Ui, vec2};
use vides_document::Edit;
use vides_engine::path::{Space, Up};

use crate::action::Action;
use crate::number::Number;
use crate::state::Editor;
use crate::state::windows::{SpaceWindow, Windows};
use crate::texts::refusals;
use crate::theme;
use crate::windows::sub_window::{SubWindow, row_at_right, sub_window};

/// Between two choices, points.
const APART: f32 = 14.0;

/// Width of a name, of a number, of a button.
const NAME: f32 = 96.0;
const NUMBER: f32 = 100.0;
const BUTTON: f32 = 96.0;

impl SubWindow for SpaceWindow {
    const ID: &'static str = "space";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.space
    }

    fn new(editor: &Editor) -> Self {
        let of = known(editor);
        Self {
            space: of.0,
            unit: of.1.clone(),
            of,
            fit: false,
            before: None,
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        // Undone, or another file: what is pending was meant for the old one.
        if known(editor) != self.of {
            *self = Self::new(editor);
        }
        let texts = &editor.texts().space_window;
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_width(NAME + 3.0 * (NUMBER + theme::GAP));
            Grid::new("space")
                .num_columns(2)
                .spacing(vec2(theme::GAP, theme::GAP))
                .show(ui, |ui| self.fields(editor, ui, actions));
            ui.add_space(theme::GAP);
            ui.horizontal(|ui| self.fitting(editor, ui, actions));
            ui.add_space(theme::GAP);
            row_at_right(ui, &[texts.apply, texts.ok], BUTTON, |ui| {
                let mut button = |text: &str, hint: &str| {
                    let button = Button::new(text).min_size(vec2(BUTTON, theme::ROW));
                    ui.add(button).on_hover_text(hint).clicked()
                };
                let apply = button(texts.apply, texts.apply_hint);
                let ok = button(texts.ok, texts.ok_hint);
                if apply || ok {
                    actions.push(Action::ApplySpace(ok));
                }
            });
        })
    }
}

fn known(editor: &Editor) -> (Space, String) {
    let document = &editor.document;
    (document.path().space, document.info().unit.clone())
}

impl SpaceWindow {
    fn fields(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        let texts = &editor.texts().space_window;
        theme::label(ui, NAME, texts.centre).on_hover_text(texts.centre_hint);
        ui.horizontal(|ui| {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                let called = format!("{} {letter}", texts.centre);
                let number = Number::new(&called, self.space.centre[axis])
                    .label(letter)
                    .hint(texts.centre_hint);
                let id = format!("space.centre.{axis}");
                self.number(editor, ui, number, &id, actions, |space, value| {
                    space.centre[axis] = value;
                });
            }
        });
        ui.end_row();
        theme::label(ui, NAME, texts.half_size).on_hover_text(texts.half_size_hint);
        ui.horizontal(|ui| {
            let number =
                Number::new(texts.half_size, self.space.half_size).hint(texts.half_size_hint);
            self.number(editor, ui, number, "space.half", actions, |space, value| {
                space.half_size = value;
            });
            ui.label(texts.unit);
            let (width, words) = (NUMBER, (texts.unit, texts.unit_hint));
            theme::line_edit(ui, &mut self.unit, "space.unit", width, words);
        });
        ui.end_row();
        theme::label(ui, NAME, texts.up).on_hover_text(texts.up_hint);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = APART;
            for up in [Up::Y, Up::Z] {
                let choice = theme::choice(ui, self.space.up == up, up.name());
                if choice.on_hover_text(texts.up_hint).clicked() {
                    self.space.up = up;
                }
            }
        });
        ui.end_row();
        theme::label(ui, NAME, texts.path).on_hover_text("");
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = APART;
            for (fit, text, hint) in [
                (false, texts.keep, texts.keep_hint),
                (true, texts.fit, texts.fit_hint),
            ] {
                let choice = theme::choice(ui, self.fit == fit, text);
                if choice.on_hover_text(hint).clicked() {
                    self.fit = fit;
                }
            }
        });
        ui.end_row();
    }

    /// Finds the space for the object or for the path.
    fn fitting(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        let texts = &editor.texts().space_window;
        let has_object = !editor.document.info().object.is_empty();
        let object = ui.add_enabled(has_object, Button::new(texts.to_object));
        let object = object
            .on_hover_text(texts.to_object_hint)
            .on_disabled_hover_text(texts.no_object);
        let path = ui.button(texts.to_path).on_hover_text(texts.to_path_hint);
        let found = if object.clicked() {
            editor.document.space_around_object()
        } else if path.clicked() {
            editor.document.space_around_path()
        } else {
            return;
        };
        match found {
            Ok(found) => {
                self.space = Space {
                    up: self.space.up,
                    ..found
                };
            }
            Err(error) => {
                let text = refusals::reason_of(editor.language(), &error);
                actions.push(Action::Complain(text));
            }
        }
    }

    fn number(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        number: Number<'_>,
        id: &str,
        actions: &mut Vec<Action>,
        set: impl Fn(&mut Space, f64),
    ) {
        // What is pending may be no valid space.
        let half_size = self.space.half_size.abs();
        let number = number.in_space(Space {
            half_size,
            ..self.space
        });
        let entry = number.pending().show(ui, editor.language(), id, NUMBER);
        entry.apply(&mut self.before, &mut self.space, set, actions);
    }

    /// Applies what is pending as one step; `closes` the window, too, unless that was refused.
    pub(crate) fn apply(editor: &mut Editor, closes: bool) {
        let Some(mut window) = editor.windows.space.take() else {
            return;
        };
        let mut info = editor.document.info().clone();
        info.unit.clone_from(&window.unit);
        let info = (info != *editor.document.info()).then(|| Edit::SetInfo(Box::new(info)));
        let Space { up, .. } = window.space;
        let old = editor.document.path().space.up;
        let keeps = !window.fit && up != old && editor.document.edits_path();
        let turned = keeps.then_some(Edit::ChangeUp(up));
        let space = Edit::SetSpace {
            space: window.space,
            fit: window.fit,
        };
        editor.message = None;
        let done = editor.edit_all([turned, Some(space), info].into_iter().flatten());
        window.of = known(editor);
        if !(closes && done) {
            editor.windows.space = Some(window);
        }
    }
}
