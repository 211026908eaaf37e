//! The curve window (thesis A.4.1): presets, own values, numbers, pending until `Zeigen` or `ok`.

use egui::{Grid, Rect, Sense, Slider, Ui, vec2};
use glam::DVec3;

use crate::state::windows::{Button, CurveWindow};

pub(crate) mod pending;
mod picture;

use self::pending::{Belonging, CurveSource, GivenUp, Pending, orientation, users};
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::curve::{in_place_of_tangents, without_shape};
use crate::state::Editor;
use crate::state::windows::Windows;
use crate::texts::fill;
use crate::theme;
use crate::windows::sub_window::{SubWindow, is_cramped, row_at_right, sub_window};
use vides_document::Document;
use vides_engine::limits::PRESETS;
use vides_engine::path::{Target, Tcb};

/// Widths in points: the presets; a label and three numbers, narrower if cramped.
const LIST: f32 = 136.0;
const LABEL: f32 = 78.0;
const NUMBER: f32 = 82.0;
const NARROW_NUMBER: f32 = 70.0;
/// Height of the picture, and where there is little room.
const PICTURE: f32 = 150.0;
const LOW_PICTURE: f32 = 96.0;

#[derive(Clone, Copy)]
enum Field {
    Shape(usize),
    Position(usize),
    Target(usize),
    Roll,
}

impl Field {
    fn set(self, pending: &mut Pending, document: &Document, value: f64) {
        match self {
            Self::Shape(part) => {
                let mut shape = parts(pending.tcb(document));
                shape[part] = value;
                let [tension, continuity, bias] = shape;
                pending.set_tcb(document, Tcb::new(tension, continuity, bias));
            }
            Self::Position(axis) => pending.position[axis] = Some(value),
            Self::Target(axis) => pending.target[axis] = Some(value),
            Self::Roll => pending.roll = Some(value),
        }
    }
}

impl SubWindow for CurveWindow {
    const ID: &'static str = "curve";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.curve
    }

    fn new(editor: &Editor) -> Self {
        Self {
            pending: Pending::default(),
            belonging: Belonging::of(&editor.document),
            dragged: None,
            pressed: None,
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().curve;
        self.follow(editor, context, actions);
        let pressed = self.pressed.take();
        let mut wrong = false;
        let stays = sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_width(LIST + theme::GAP * 4.0 + rest(ui));
            self.heading(editor, ui);
            let without = without_shape(editor);
            let owns = in_place_of_tangents(editor, editor.document.selection().point);
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = theme::GAP * 4.0;
                ui.vertical(|ui| {
                    ui.set_width(LIST);
                    ui.add_enabled_ui(without.is_none(), |ui| self.list(editor, ui));
                    if let Some(why) = without.or(owns) {
                        ui.colored_label(theme::palette(ui).weak, why);
                    }
                });
                ui.vertical(|ui| {
                    ui.spacing_mut().item_spacing.x = theme::GAP;
                    ui.set_width(rest(ui));
                    let shape =
                        ui.add_enabled_ui(without.is_none(), |ui| self.shape(editor, ui, actions));
                    wrong |= shape.inner;
                    self.picture(editor, ui);
                    wrong |= self.numbers(editor, ui, actions);
                });
            });
            self.buttons(editor, ui);
        });
        if self.pressed.is_some() {
            context.request_repaint();
        }
        if let Some(pressed) = pressed {
            if !wrong {
                actions.push(Action::ApplyCurve(pressed == Button::Ok));
            }
            // The output field has been drawn already.
            context.request_repaint();
        }
        stays
    }
}

impl CurveWindow {
    /// The curve as it will be, if something is pending.
    pub(crate) fn preview(&self, editor: &Editor) -> Option<Vec<Vec<DVec3>>> {
        let waits = !self.pending.is_empty();
        waits.then(|| picture::preview(&editor.document, &self.pending))
    }

    /// Another path is open: what is pending was meant for the old one.
    pub(super) fn lose(&mut self) {
        self.belonging.lose();
    }

    /// Gives up what is pending if what it was meant for is gone.
    fn follow(&mut self, editor: &Editor, context: &egui::Context, actions: &mut Vec<Action>) {
        let Some(gone) = self.belonging.follow(&editor.document) else {
            return;
        };
        self.pressed = None;
        self.dragged = None;
        if !std::mem::take(&mut self.pending).is_empty() {
            let texts = &editor.texts().curve;
            let text = match gone {
                GivenUp::Elsewhere => texts.given_up,
                GivenUp::Changed => texts.given_up_changed,
            };
            actions.push(Action::Say(text.to_owned()));
            context.request_repaint();
        }
    }

    /// Applies what is pending as one step, then closes if `closes`. A refusal changes nothing.
    pub(crate) fn apply(editor: &mut Editor, closes: bool) {
        let Some(mut window) = editor.windows.curve.take() else {
            return;
        };
        let applied = window.apply_pending(editor);
        if !(applied && closes) {
            editor.windows.curve = Some(window);
        }
    }

    fn apply_pending(&mut self, editor: &mut Editor) -> bool {
        let done = editor.edit_all(self.pending.edits(&editor.document));
        if done {
            self.pending = Pending::default();
        }
        self.belonging = Belonging::of(&editor.document);
        done
    }

    fn heading(&self, editor: &Editor, ui: &mut Ui) {
        let texts = &editor.texts().curve;
        let selection = editor.document.selection();
        let (point, orientation) = (selection.point + 1, selection.orientation + 1);
        let palette = theme::palette(ui);
        ui.horizontal(|ui| {
            ui.colored_label(palette.weak, fill(texts.of, &[&point, &orientation]));
            if !self.pending.is_empty() {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    ui.colored_label(palette.accent, texts.waiting);
                });
            }
        });
        ui.add_space(theme::GAP);
    }

    fn list(&mut self, editor: &Editor, ui: &mut Ui) {
        let texts = &editor.texts().curve;
        let now = self.pending.choice(&editor.document);
        let owns = editor.joint().is_some();
        let mut choose = None;
        let mut radio = |ui: &mut Ui, choice, name: String, shape: String| {
            let response = theme::choice(ui, now == choice, &name).on_hover_text(shape);
            if response.clicked() && (now != choice || owns) {
                choose = Some(choice);
            }
        };
        for preset in 0..PRESETS {
            let changed = self
                .pending
                .presets
                .get(preset)
                .is_some_and(Option::is_some);
            let mark = if changed { " *" } else { "" };
            let tcb = self.pending.preset(&editor.document, preset);
            let name = format!("{}{mark}", texts.preset_name(preset, tcb));
            let shape = texts.shape(editor.language(), tcb);
            let hint = format!("{}: {shape}", fill(texts.preset, &[&preset]));
            radio(ui, CurveSource::Preset(preset), name, hint);
        }
        let own = texts.own.to_owned();
        radio(ui, CurveSource::Own, own, texts.own_hint.to_owned());
        if let Some(choice) = choose {
            self.pending.choose(&editor.document, choice);
        }
        ui.add_space(theme::GAP);
        if let Some((preset, all)) = self.pending.for_all(&editor.document) {
            let count = users(&editor.document, preset);
            let hint = fill(texts.for_all_hint, &[&preset]);
            for (meant, name) in [
                (false, texts.for_this.to_owned()),
                (true, fill(texts.for_all, &[&count])),
            ] {
                let choice = theme::choice(ui, all == meant, &name);
                if choice.on_hover_text(&hint).clicked() {
                    self.pending.mean_all(&editor.document, meant);
                }
            }
            return;
        }
        let users = match self.pending.choice(&editor.document) {
            CurveSource::Preset(preset) => users(&editor.document, preset),
            CurveSource::Own => 1,
        };
        let text = if users == 1 {
            texts.used_once.to_owned()
        } else {
            fill(texts.used, &[&users])
        };
        ui.colored_label(theme::palette(ui).weak, text);
    }

    /// The three sliders with their numbers. True: a typed text is no number.
    fn shape(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) -> bool {
        let texts = &editor.texts().curve;
        let names = [
            (texts.tension, texts.tension_hint),
            (texts.continuity, texts.continuity_hint),
            (texts.bias, texts.bias_hint),
        ];
        let mut wrong = false;
        Grid::new("shape")
            .num_columns(3)
            .spacing(vec2(theme::GAP, theme::GAP))
            .show(ui, |ui| {
                for (part, (name, hint)) in names.into_iter().enumerate() {
                    let label = theme::label(ui, LABEL, name).on_hover_text(hint);
                    let value = parts(self.pending.tcb(&editor.document))[part];
                    let mut slid = value.clamp(-1.0, 1.0);
                    ui.spacing_mut().slider_width = 2.0 * number(ui) + theme::GAP;
                    let slider = Slider::new(&mut slid, -1.0..=1.0)
                        .show_value(false)
                        // It runs both ways from the middle.
                        .trailing_fill(false)
                        .step_by(0.01);
                    let response = ui.add(slider).labelled_by(label.id).on_hover_text(hint);
                    // egui rounds to steps even where nobody touches it.
                    if response.changed() && (slid - value.clamp(-1.0, 1.0)).abs() > 1e-9 {
                        let rounded = (slid * 100.0).round() / 100.0;
                        Field::Shape(part).set(&mut self.pending, &editor.document, rounded);
                    }
                    let number = Number::new(name, value)
                        .hint(hint)
                        .decimals(2)
                        .range(-1.0..=1.0)
                        .steps(0.01, 0.01);
                    wrong |= self.number(editor, ui, number, Field::Shape(part), actions);
                    ui.end_row();
                }
            });
        wrong
    }

    fn picture(&self, editor: &Editor, ui: &mut Ui) {
        ui.add_space(theme::GAP);
        let palette = theme::palette(ui);
        let height = if is_cramped(ui.ctx()) {
            LOW_PICTURE
        } else {
            PICTURE
        };
        let (rect, response) = ui.allocate_exact_size(vec2(rest(ui), height), Sense::hover());
        let name = editor.texts().curve.picture;
        response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, name));
        let painter = ui.painter().with_clip_rect(rect);
        painter.rect(
            rect,
            egui::CornerRadius::same(4),
            palette.field,
            egui::Stroke::new(1.0, palette.line),
            egui::StrokeKind::Inside,
        );
        picture::paint(&painter, rect, palette, &editor.document, &self.pending);
        self.legend(editor, &painter, rect);
        ui.add_space(theme::GAP);
    }

    /// Which curve is which, once there are two.
    fn legend(&self, editor: &Editor, painter: &egui::Painter, rect: Rect) {
        if self.pending.is_empty() {
            return;
        }
        let texts = &editor.texts().curve;
        let palette = editor.setup.theme().palette();
        let font = theme::small();
        let mut at = rect.left_bottom() + vec2(8.0, -6.0);
        for (text, colour) in [(texts.before, palette.weak), (texts.after, palette.accent)] {
            let end = painter.text(at, egui::Align2::LEFT_BOTTOM, text, font.clone(), colour);
            at.x = end.right() + 12.0;
        }
    }

    /// Position, target and roll. True: a typed text is no number.
    fn numbers(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) -> bool {
        let texts = &editor.texts().curve;
        let absolute = matches!(orientation(&editor.document).target, Target::Absolute(_));
        let (kind, hint) = if absolute {
            (texts.target, texts.target_hint)
        } else {
            (texts.offset, texts.offset_hint)
        };
        let mut wrong = false;
        Grid::new("numbers")
            .num_columns(4)
            .spacing(vec2(theme::GAP, theme::GAP))
            .show(ui, |ui| {
                let position = self.pending.position(&editor.document);
                theme::label(ui, LABEL, texts.position);
                for (axis, sign) in ["x", "y", "z"].into_iter().enumerate() {
                    let name = format!("{} {sign}", texts.position);
                    let number = Number::new(&name, position[axis])
                        .label(sign)
                        .in_space(editor.document.path().space);
                    wrong |= self.number(editor, ui, number, Field::Position(axis), actions);
                }
                ui.end_row();
                let target = self.pending.target(&editor.document);
                let name = format!("{} ({kind})", texts.orientation);
                theme::label(ui, LABEL, &name).on_hover_text(hint);
                for (axis, sign) in ["x", "y", "z"].into_iter().enumerate() {
                    let name = format!("{} {sign}", texts.orientation);
                    let number = Number::new(&name, target[axis])
                        .label(sign)
                        .hint(hint)
                        .in_space(editor.document.path().space);
                    wrong |= self.number(editor, ui, number, Field::Target(axis), actions);
                }
                ui.end_row();
                let roll = self.pending.roll(&editor.document);
                theme::label(ui, LABEL, texts.roll).on_hover_text(texts.roll_hint);
                let number = Number::new(texts.roll, roll)
                    .hint(texts.roll_hint)
                    .degrees();
                wrong |= self.number(editor, ui, number, Field::Roll, actions);
                ui.end_row();
            });
        wrong
    }

    /// Shows one number and takes what is entered. True: a typed text is no number.
    fn number(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        number: Number<'_>,
        field: Field,
        actions: &mut Vec<Action>,
    ) -> bool {
        let id = match field {
            Field::Shape(part) => format!("curve.shape.{part}"),
            Field::Position(axis) => format!("curve.position.{axis}"),
            Field::Target(axis) => format!("curve.target.{axis}"),
            Field::Roll => "curve.roll".to_owned(),
        };
        let width = self::number(ui);
        let entry = number.pending().show(ui, editor.language(), &id, width);
        let wrong = matches!(entry, Entry::Wrong(_));
        if wrong {
            ui.ctx().request_repaint();
        }
        let set = |pending: &mut Pending, value| field.set(pending, &editor.document, value);
        entry.apply(&mut self.dragged, &mut self.pending, set, actions);
        wrong
    }

    fn buttons(&mut self, editor: &Editor, ui: &mut Ui) {
        let texts = &editor.texts().curve;
        ui.add_space(theme::GAP * 2.0);
        let size = vec2(96.0, theme::ROW);
        row_at_right(ui, &[texts.show, texts.ok], size.x, |ui| {
            let mut button = |text: &str, hint: &str| {
                ui.add_sized(size, egui::Button::new(text))
                    .on_hover_text(hint)
                    .clicked()
            };
            if button(texts.show, texts.show_hint) {
                self.pressed = Some(Button::Show);
            }
            if button(texts.ok, texts.ok_hint) {
                self.pressed = Some(Button::Ok);
            }
        });
    }
}

fn number(ui: &Ui) -> f32 {
    if is_cramped(ui.ctx()) {
        NARROW_NUMBER
    } else {
        NUMBER
    }
}

/// Width of the part right of the list.
fn rest(ui: &Ui) -> f32 {
    LABEL + 3.0 * (number(ui) + theme::GAP)
}

fn parts(tcb: Tcb) -> [f64; 3] {
    [tcb.tension, tcb.continuity, tcb.bias]
}

#[cfg(test)]
mod tests;
