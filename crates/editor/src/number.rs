//! A field with a number: shown rounded, dragged to change, clicked or tabbed to be typed into.
//!
//! Enter and Tab apply what was typed ([`typed`]); Escape restores the old value, also in a drag.
//! What is no number or out of range gives a message and leaves the old value. The up and down arrows go by one step; Shift makes a drag ten times finer.
//!
//! It changes nothing itself: an [`Entry`] says what happened, so that one entry or one drag
//! becomes one undoable step ([`Editor::enter`](crate::state::Editor::enter)).

use std::ops::RangeInclusive;

use egui::{
    Align2, Color32, Context, CornerRadius, CursorIcon, Id, Key, Margin, Modifiers, Rect, Role,
    Sense, Stroke, StrokeKind, TextEdit, Ui, Vec2, WidgetInfo, vec2,
};
use vides_engine::path::Space;

use crate::action::Action;
use crate::entry::Entry;
use crate::texts::{Language, fill};
use crate::typed::{Measures, Miss, Quantity, written};
use crate::{keys, theme, typed};

impl Entry {
    /// The same with what the value stands for.
    pub(super) fn map<T>(self, to: impl FnOnce(f64) -> T) -> Entry<T> {
        self.try_map(|value| Ok(to(value)))
    }

    /// The same for a value that may be refused with a reason.
    pub(super) fn try_map<T>(self, to: impl FnOnce(f64) -> Result<T, String>) -> Entry<T> {
        let refused = |made: Result<Entry<T>, String>| made.unwrap_or_else(Entry::Wrong);
        match self {
            Self::Idle => Entry::Idle,
            Self::Begin => Entry::Begin,
            Self::Drag(value) => refused(to(value).map(Entry::Drag)),
            Self::End => Entry::End,
            Self::Cancel => Entry::Cancel,
            Self::Set(value) => refused(to(value).map(Entry::Set)),
            Self::Wrong(text) => Entry::Wrong(text),
        }
    }
}

impl<T> Entry<T> {
    /// The end of a drag: Escape cancels it. (egui ends it before anybody sees the key.)
    pub(super) fn of_end(context: &Context) -> Self {
        match keys::consume_escape(context) {
            true => Self::Cancel,
            false => Self::End,
        }
    }
}

impl Entry {
    /// Applies it to a value of a window's own, which is kept in `before` while it is dragged.
    pub(super) fn apply<T: Clone>(
        self,
        before: &mut Option<T>,
        value: &mut T,
        set: impl FnOnce(&mut T, f64),
        actions: &mut Vec<Action>,
    ) {
        match self {
            Self::Idle => {}
            Self::Begin => *before = Some(value.clone()),
            Self::Drag(new) | Self::Set(new) => set(value, new),
            Self::End => *before = None,
            Self::Cancel => *value = before.take().unwrap_or_else(|| value.clone()),
            Self::Wrong(text) => actions.push(Action::Complain(text)),
        }
    }
}

pub(super) struct Number<'a> {
    name: &'a str,
    label: &'a str,
    hint: &'a str,
    unit: &'a str,
    quantity: Quantity,
    value: Option<f64>,
    decimals: usize,
    range: RangeInclusive<f64>,
    step: f64,
    per_point: f64,
    fixed: bool,
    typed: bool,
    whole: bool,
    pending: bool,
    faint: bool,
}

/// A text being typed, and the value that it began with.
#[derive(Clone, Default)]
struct Typing {
    text: String,
    first: String,
    value: f64,
    /// The pass that showed it last: a text left by a closed window does not apply.
    frame: u64,
}

/// Between a field's edge and its contents, in points.
const INSET: f32 = 6.0;

/// Between its label and its value, in points.
const GAP: f32 = 4.0;

/// Decimals that show a thousandth of a space.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn decimals(half_size: f64) -> usize {
    (3.0 - half_size.log10().floor()).clamp(0.0, 17.0) as usize
}

impl<'a> Number<'a> {
    /// A number with a value (`None` shows a dash) and a name for screen readers and tests.
    pub(super) fn new(name: &'a str, value: impl Into<Option<f64>>) -> Self {
        Self {
            name,
            label: "",
            hint: "",
            unit: "",
            quantity: Quantity::Plain,
            value: value.into(),
            decimals: 3,
            range: f64::MIN..=f64::MAX,
            step: 0.01,
            per_point: 0.005,
            fixed: false,
            typed: false,
            whole: false,
            pending: false,
            faint: false,
        }
    }

    /// A short sign at the left of the field.
    pub(super) fn label(mut self, label: &'a str) -> Self {
        self.label = label;
        self
    }

    pub(super) fn hint(mut self, hint: &'a str) -> Self {
        self.hint = hint;
        self
    }

    pub(super) fn unit(mut self, unit: &'a str) -> Self {
        self.unit = unit;
        self
    }

    /// What it counts: other units of that can be typed.
    pub(super) fn quantity(mut self, quantity: Quantity) -> Self {
        self.quantity = quantity;
        self
    }

    pub(super) fn decimals(mut self, decimals: usize) -> Self {
        self.decimals = decimals;
        self
    }

    pub(super) fn range(mut self, range: RangeInclusive<f64>) -> Self {
        self.range = range;
        self
    }

    /// The value waits to be applied: any number may be typed, and the range is checked later.
    pub(super) fn pending(mut self) -> Self {
        self.pending = true;
        self
    }

    /// A place or a length in a space: sets decimals, steps and range.
    pub(super) fn in_space(self, space: Space) -> Self {
        let (half_size, far) = (space.half_size, space.farthest());
        let far = space.centre.abs().max_element() + far;
        self.quantity(Quantity::Length)
            .decimals(decimals(half_size))
            .steps(0.01 * half_size, 0.005 * half_size)
            .range(-far..=far)
    }

    /// The width in points that fits any coordinate within a space.
    pub(super) fn room_in_space(ui: &Ui, language: Language, space: Space) -> f32 {
        let widest = -(space.centre.abs().max_element() + space.half_size);
        let text = language.number(widest, decimals(space.half_size));
        let [text, label] = [text, "x".to_owned()].map(|text| {
            let galley = (ui.painter()).layout_no_wrap(text, theme::text(), Color32::PLACEHOLDER);
            galley.size().x
        });
        text + label + GAP + 2.0 * INSET
    }

    pub(super) fn degrees(self) -> Self {
        self.unit("°")
            .quantity(Quantity::Degrees)
            .decimals(1)
            .steps(1.0, 0.5)
    }

    pub(super) fn seconds(self) -> Self {
        self.unit(" s").quantity(Quantity::Seconds).decimals(2)
    }

    /// The changes by an arrow key, and by one point of dragging.
    pub(super) fn steps(mut self, arrow: f64, point: f64) -> Self {
        (self.step, self.per_point) = (arrow, point);
        self
    }

    /// It is typed, never dragged: each value would begin where the last one ended.
    pub(super) fn typed(mut self) -> Self {
        self.typed = true;
        self
    }

    pub(super) fn fixed(mut self) -> Self {
        self.fixed = true;
        self
    }

    pub(super) fn fixed_if(self, fixed: bool) -> Self {
        if fixed { self.fixed() } else { self }
    }

    /// A value between those of keys.
    pub(super) fn faint(mut self, faint: bool) -> Self {
        self.faint = faint;
        self
    }

    pub(super) fn whole(mut self) -> Self {
        self.whole = true;
        self.decimals(0)
    }

    /// Shows it, one row high. `id` tells it from all others in the window.
    pub(super) fn show(self, ui: &mut Ui, language: Language, id: &str, width: f32) -> Entry {
        let (_, rect) = ui.allocate_space(vec2(width, theme::ROW));
        let id = Id::unique(("number", id));
        let Some(value) = self.value.filter(|_| ui.is_enabled() && !self.fixed) else {
            self.show_still(ui, language, id, rect);
            return Entry::Idle;
        };
        let focused = ui.memory_mut(|memory| {
            memory.interested_in_focus(id, ui.layer_id());
            memory.has_focus(id)
        });
        let mut entry = Entry::Idle;
        if !focused {
            entry = self.finish(ui, language, id, value);
        }
        if focused {
            if let Some(stepped) = self.step_by_keys(ui, language, id, value) {
                entry = Entry::Set(stepped);
            }
            self.show_typing(ui, language, id, rect, value);
        } else {
            let dragged = self.show_dragging(ui, language, id, rect, value);
            if dragged != Entry::Idle {
                entry = dragged;
            }
        }
        entry
    }

    fn shown(&self, language: Language) -> String {
        match self.value {
            Some(value) => format!("{}{}", language.number(value, self.decimals), self.unit),
            None => "–".to_owned(),
        }
    }

    /// A field that cannot be changed.
    fn show_still(&self, ui: &mut Ui, language: Language, id: Id, rect: Rect) {
        let response = ui.interact(rect, id, Sense::hover());
        let shortened = self.paint(ui, language, rect, false);
        self.describe(ui, language, &response);
        self.tell(response, language, shortened);
    }

    fn show_dragging(
        &self,
        ui: &mut Ui,
        language: Language,
        id: Id,
        rect: Rect,
        value: f64,
    ) -> Entry {
        let sense = if self.typed {
            Sense::click()
        } else {
            Sense::click_and_drag()
        };
        let response = ui.interact(rect, id, sense);
        let lively = response.hovered() || response.dragged();
        let shortened = self.paint(ui, language, rect, lively);
        self.describe(ui, language, &response);
        let exact = id.with("exact");
        let mut entry = Entry::Idle;
        if response.clicked() {
            ui.memory_mut(|memory| memory.request_focus(id));
        } else if response.drag_started() {
            // How far it has moved by now counts as well, from the next pass on.
            let moved = response.total_drag_delta().unwrap_or_default();
            ui.data_mut(|data| data.insert_temp(exact, (value, moved)));
            ui.ctx().request_repaint();
            entry = Entry::Begin;
        } else if let Some((before, late)) = ui.data(|data| data.get_temp::<(f64, Vec2)>(exact)) {
            // egui itself ends a drag on Escape.
            let escape = ui.input(|input| input.key_pressed(Key::Escape));
            if escape || (!response.dragged() && late == Vec2::ZERO) {
                ui.data_mut(|data| data.remove::<(f64, Vec2)>(exact));
                return if escape { Entry::Cancel } else { Entry::End };
            }
            let moved = response.drag_delta() + late;
            let fine = if ui.input(|input| input.modifiers.shift) {
                0.1
            } else {
                1.0
            };
            let way = f64::from(moved.x - moved.y) * self.per_point * fine;
            let now = (before + way).clamp(*self.range.start(), *self.range.end());
            ui.data_mut(|data| data.insert_temp(exact, (now, Vec2::ZERO)));
            if !response.dragged() {
                ui.ctx().request_repaint();
            }
            if way != 0.0 {
                entry = Entry::Drag(self.rounded(now));
            }
        }
        if lively {
            ui.set_cursor_icon(if self.typed {
                CursorIcon::Text
            } else {
                CursorIcon::ResizeHorizontal
            });
        }
        self.tell(response, language, shortened);
        entry
    }

    fn show_typing(&self, ui: &mut Ui, language: Language, id: Id, rect: Rect, value: f64) {
        let fresh = || {
            let first = written(language, value, self.decimals);
            Typing {
                text: first.clone(),
                first,
                value,
                frame: 0,
            }
        };
        let known = ui.data(|data| data.get_temp::<Typing>(id));
        let selects = known.is_none();
        // If the value changed meanwhile, for instance by undo, the text no longer applies.
        let mut typing = known
            .filter(|typing| typing.value == value)
            .unwrap_or_else(fresh);
        if selects {
            theme::select(ui, id, &typing.text);
        }
        let response = ui.put(
            rect,
            TextEdit::singleline(&mut typing.text)
                .id(id)
                .font(theme::text())
                .frame(theme::field(ui))
                .align(Align2::RIGHT_CENTER)
                .margin(Margin::symmetric(6, 0))
                .clip_text(true)
                .desired_width(rect.width())
                .min_size(rect.size()),
        );
        // All of it, not the digits before the point alone.
        if response.double_clicked() {
            theme::select(ui, id, &typing.text);
        }
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_label(self.name);
        });
        typing.frame = ui.ctx().cumulative_frame_nr();
        ui.data_mut(|data| data.insert_temp(id, typing));
    }

    /// The value that a text stands for here.
    fn read(&self, ui: &Ui, text: &str, before: f64) -> Result<f64, Miss> {
        let measures = ui.data(|data| data.get_temp::<Measures>(Id::NULL));
        let field = typed::Field {
            quantity: self.quantity,
            unit: self.unit,
            before,
            measures: &measures.unwrap_or_default(),
        };
        typed::value(text, &field)
    }

    /// The keyboard went elsewhere: what was typed applies, unless by Escape.
    fn finish(&self, ui: &Ui, language: Language, id: Id, value: f64) -> Entry {
        let Some(typing) = ui.data_mut(|data| data.remove_temp::<Typing>(id)) else {
            return Entry::Idle;
        };
        let escaped = ui.input(|input| input.key_pressed(Key::Escape));
        let stale = typing.frame + 1 < ui.ctx().cumulative_frame_nr();
        if stale || escaped || typing.value != value || typing.text.trim() == typing.first {
            return Entry::Idle;
        }
        let texts = &language.texts().errors;
        let new = match self.read(ui, &typing.text, value) {
            Ok(new) => new,
            Err(Miss::Number) => {
                return Entry::Wrong(fill(texts.no_number, &[&self.name, &typing.text.trim()]));
            }
            Err(Miss::Unit(unit)) => {
                return Entry::Wrong(fill(texts.no_unit, &[&self.name, &unit]));
            }
        };
        if self.whole && new.fract() != 0.0 {
            return Entry::Wrong(fill(texts.not_whole, &[&self.name]));
        }
        if !self.pending && !self.range.contains(&new) {
            let bound = |value: f64| written(language, value, 0);
            let (low, high) = (bound(*self.range.start()), bound(*self.range.end()));
            return Entry::Wrong(fill(texts.out_of_range, &[&self.name, &low, &high]));
        }
        Entry::Set(new)
    }

    fn step_by_keys(&self, ui: &Ui, language: Language, id: Id, value: f64) -> Option<f64> {
        let steps = ui.input_mut(|input| {
            let mut count = |key| input.count_and_consume_key(Modifiers::NONE, key) as f64;
            count(Key::ArrowUp) - count(Key::ArrowDown)
        });
        if steps == 0.0 {
            return None;
        }
        let typed = ui
            .data(|data| data.get_temp::<Typing>(id))
            .filter(|typing| typing.value == value && typing.text != typing.first)
            .and_then(|typing| self.read(ui, &typing.text, value).ok());
        let now = (typed.unwrap_or(value) + steps * self.step)
            .clamp(*self.range.start(), *self.range.end());
        let now = self.rounded(now);
        let first = written(language, now, self.decimals);
        let typing = Typing {
            text: first.clone(),
            first,
            value: now,
            frame: ui.ctx().cumulative_frame_nr(),
        };
        ui.data_mut(|data| data.insert_temp(id, typing));
        (now != value).then_some(now)
    }

    /// A dragged value has only the decimals that are shown.
    fn rounded(&self, value: f64) -> f64 {
        let scale = 10f64.powi(i32::try_from(self.decimals).unwrap_or(0));
        let rounded = (value * scale).round() / scale;
        if rounded.is_finite() { rounded } else { value }
    }

    /// Paints it; true if the value had to be shortened.
    fn paint(&self, ui: &Ui, language: Language, rect: Rect, hovered: bool) -> bool {
        let palette = theme::palette(ui);
        let fixed = self.fixed || self.value.is_none() || !ui.is_enabled();
        let border = match (fixed, hovered) {
            (true, _) => palette.field,
            (false, true) => palette.accent,
            (false, false) => palette.edge,
        };
        let painter = ui.painter();
        painter.rect(
            rect,
            CornerRadius::same(4),
            palette.field,
            Stroke::new(1.0, border),
            StrokeKind::Inside,
        );
        let inner = rect.shrink2(vec2(INSET, 0.0));
        let label = painter.text(
            inner.left_center(),
            Align2::LEFT_CENTER,
            self.label,
            theme::text(),
            palette.weak,
        );
        let gap = if self.label.is_empty() { 0.0 } else { GAP };
        let words = self.fitting(ui, language, inner.right() - label.right() - gap);
        let shortened = words != self.shown(language);
        painter.text(
            inner.right_center(),
            Align2::RIGHT_CENTER,
            words,
            theme::text(),
            if ui.is_enabled() && !self.faint {
                palette.text
            } else {
                palette.weak
            },
        );
        shortened
    }

    /// The value no wider than this: with fewer decimals or, if need be, as a power of ten.
    fn fitting(&self, ui: &Ui, language: Language, width: f32) -> String {
        let whole = self.shown(language);
        let Some(value) = self.value else {
            return whole;
        };
        let fits = |text: &String| {
            let galley =
                (ui.painter()).layout_no_wrap(text.clone(), theme::text(), Color32::PLACEHOLDER);
            galley.size().x <= width
        };
        let decimals = (0..=self.decimals).rev();
        let powers = (0..self.decimals.max(3)).rev();
        decimals
            .map(|decimals| language.number(value, decimals))
            .chain(powers.map(|digits| language.power(value, digits)))
            .map(|number| format!("{number}{}", self.unit))
            .find(fits)
            .unwrap_or(whole)
    }

    fn describe(&self, ui: &Ui, language: Language, response: &egui::Response) {
        let enabled = ui.is_enabled() && !self.fixed && self.value.is_some();
        response.widget_info(|| WidgetInfo::labeled(Role::SpinButton, enabled, self.name));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_value(self.shown(language));
        });
    }

    /// The tooltip, with the whole value if that was shortened.
    fn tell(&self, response: egui::Response, language: Language, shortened: bool) {
        let mut words = Vec::new();
        if shortened {
            words.push(format!("{} {}", self.name, self.shown(language)));
        }
        if !self.hint.is_empty() {
            words.push(self.hint.to_owned());
        }
        if !words.is_empty() {
            response.on_hover_text(words.join("\n"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_refused_is_told() {
        let refused = |_| Err::<f64, _>("no memory".to_owned());
        for entry in [Entry::Drag(1.0), Entry::Set(1.0)] {
            let told = Entry::Wrong("no memory".to_owned());
            assert_eq!(entry.try_map(refused), told);
        }
        assert_eq!(Entry::Cancel.try_map(refused), Entry::Cancel);
    }
}
