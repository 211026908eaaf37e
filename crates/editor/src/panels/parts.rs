//! The pieces of the panels: headings that fold, buttons, shares of a row.

use egui::{Button, Color32, Response, RichText, Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2};

use crate::action::{Action, PathAction};
use crate::setup::Fold;
use crate::state::Editor;
use crate::texts::fill;
use crate::{keys, theme};

/// Width of the panels, which two, three or four columns with gaps fill exactly.
pub(crate) const WIDTH: f32 = 236.0;

/// A lower window has smaller gaps between the rows.
pub(crate) const MIN_HEIGHT_FOR_GAPS: f32 = 545.0;

/// Distance between two panels, in points.
pub(crate) const APART: f32 = 8.0;

/// A line between two panels.
pub(crate) fn apart(ui: &mut Ui) {
    let gap = ui.spacing().item_spacing.y;
    let size = vec2(ui.available_width(), APART - gap);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let middle = rect.center().y - gap / 2.0;
    let whole = rect.x_range().expand(12.0);
    let painter = ui.painter().with_clip_rect(rect.expand(12.0));
    painter.hline(
        whole,
        middle.round() + 0.5,
        Stroke::new(1.0, theme::palette(ui).line),
    );
}

/// Room for the triangle before a heading, and for the arrow of [`Heading::choice`].
pub(crate) const TRIANGLE: f32 = 14.0;

pub(crate) const ARROW: f32 = 14.0;

/// A panel's heading, which folds and unfolds it.
pub(crate) struct Heading<'a> {
    pub(crate) editor: &'a Editor,
    pub(crate) fold: Fold,
    pub(crate) text: &'a str,
    /// At the right.
    pub(crate) remark: &'a str,
}

impl Heading<'_> {
    /// Whether the panel is open; and the row.
    pub(crate) fn show(&self, ui: &mut Ui, actions: &mut Vec<Action>) -> (bool, Response) {
        self.with_room(ui, 0.0, actions)
    }

    pub(crate) fn with_room(
        &self,
        ui: &mut Ui,
        room: f32,
        actions: &mut Vec<Action>,
    ) -> (bool, Response) {
        let open = !self.editor.setup.folded[self.fold as usize];
        let palette = theme::palette(ui);
        let size = vec2(ui.available_width(), theme::ROW);
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let painter = ui.painter();
        let lively = match response.hovered() || response.has_focus() {
            true => palette.text,
            false => palette.weak,
        };
        let centre = rect.left_center() + vec2(4.0, 0.0);
        painter.add(theme::triangle(centre, open, lively));
        let right = rect.right_center() - vec2(room, 0.0);
        let left = rect.left_center() + vec2(TRIANGLE, 0.0);
        let align = egui::Align2::LEFT_CENTER;
        let title = painter.text(left, align, self.text, theme::heading(), palette.text);
        // Without room for all of the remark, its first parts will do.
        let mut shown = self.remark;
        let laid_out = |words: &str| {
            let galley = painter.layout_no_wrap(words.to_owned(), theme::text(), palette.weak);
            (galley.size().x <= right.x - title.right() - APART, galley)
        };
        let mut galley = laid_out(shown);
        while let (false, Some((first, _))) = (galley.0, shown.rsplit_once(" · ")) {
            shown = first;
            galley = laid_out(shown);
        }
        let (_, galley) = galley;
        let at = egui::Align2::RIGHT_CENTER.anchor_size(right, galley.size());
        painter.galley(at.min, galley, palette.weak);
        let words = match self.remark {
            "" => self.text.to_owned(),
            remark => format!("{}: {remark}", self.text),
        };
        let role = egui::Role::DisclosureTriangle;
        response.widget_info(|| WidgetInfo::selected(role, true, open, &words));
        if response.clicked() {
            actions.push(Action::Fold(self.fold));
        }
        let response = match shown == self.remark {
            true => response,
            false => response.on_hover_text(self.remark),
        };
        (open, response)
    }

    /// Between keys, with the time at which typing makes one in place of the remark, to be clicked
    /// for that: its name and its words. Nothing else moves. Whether the panel is open.
    pub(crate) fn or_new(
        &self,
        ui: &mut Ui,
        here: Option<[&str; 2]>,
        actions: &mut Vec<Action>,
    ) -> bool {
        let Some([name, words]) = here else {
            return self.show(ui, actions).0;
        };
        let editor = self.editor;
        let frame = editor.playing.frame().unwrap_or(1.0);
        let seconds = (frame - 1.0) / editor.document.info().fps;
        let words = fill(words, &[&editor.language().number(seconds, 2)]);
        let heading = Heading {
            remark: "",
            ..*self
        };
        let (open, row) = heading.show(ui, actions);
        let palette = theme::palette(ui);
        let ink = |colour| {
            let font = theme::text();
            ui.painter().layout_no_wrap(words.clone(), font, colour)
        };
        let size = vec2(ink(palette.accent).size().x, theme::ROW);
        let place = egui::Align2::RIGHT_CENTER.anchor_size(row.rect.right_center(), size);
        let response = ui.interact(place, ui.scope_id().with(name), Sense::click());
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(words.clone()),
            ..WidgetInfo::labeled(egui::Role::Button, true, name)
        });
        let lively = response.hovered() || response.has_focus();
        let galley = ink(if lively { palette.text } else { palette.accent });
        let at = egui::Align2::RIGHT_CENTER.anchor_size(place.right_center(), galley.size());
        ui.painter().galley(at.min, galley, palette.accent);
        let hint = editor.texts().position.add_here_hint;
        let add = Action::Path(PathAction::AddHere);
        let keys = keys::words(editor.language(), &add).unwrap_or_default();
        if response.on_hover_text(format!("{hint} ({keys})")).clicked() {
            actions.push(add);
        }
        open
    }

    /// With the remark as what is chosen, to be clicked for a menu called `name`; whether the panel is
    /// open, the row, and what is chosen.
    pub(crate) fn choice(
        &self,
        ui: &mut Ui,
        name: &str,
        actions: &mut Vec<Action>,
    ) -> (bool, [Response; 2]) {
        let (open, heading) = self.with_room(ui, ARROW, actions);
        let (row, chosen) = (heading.rect, self.remark.to_owned());
        let wide = ui.fonts_mut(|fonts| {
            let galley = fonts.layout_no_wrap(chosen.clone(), theme::text(), Color32::PLACEHOLDER);
            galley.size().x
        });
        let place = row.with_min_x(row.right() - ARROW - wide - 4.0);
        let response = ui.interact(place, ui.scope_id().with(name), Sense::click());
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(chosen.clone()),
            ..WidgetInfo::labeled(egui::Role::ComboBox, true, name)
        });
        let palette = theme::palette(ui);
        let colour = match response.hovered() {
            true => palette.text,
            false => palette.weak,
        };
        let at = |x: f32, y: f32| pos2(row.right() - 5.0 + x, row.center().y + 1.0 + y);
        let arrow = vec![at(-3.5, -2.0), at(0.0, 2.0), at(3.5, -2.0)];
        ui.painter()
            .add(Shape::line(arrow, Stroke::new(1.5, colour)));
        (open, [heading, response])
    }
}

/// A button of a panel.
pub(crate) struct PanelButton<'a> {
    pub(crate) text: &'a str,
    pub(crate) hint: &'a str,
    pub(crate) action: Action,
    /// Of buttons that exclude each other: whether this one is chosen.
    pub(crate) chosen: Option<bool>,
}

impl<'a> PanelButton<'a> {
    pub(crate) const fn new(text: &'a str, hint: &'a str, action: Action) -> Self {
        Self {
            text,
            hint,
            action,
            chosen: None,
        }
    }

    pub(crate) const fn chosen(mut self, chosen: bool) -> Self {
        self.chosen = Some(chosen);
        self
    }

    pub(crate) fn show(&self, editor: &Editor, ui: &mut Ui, width: f32, actions: &mut Vec<Action>) {
        let chosen = self.chosen == Some(true);
        let palette = theme::palette(ui);
        let mut text = RichText::new(self.text);
        let mut button = Button::new(text.clone());
        if chosen {
            text = text.color(palette.on_accent);
            button = Button::new(text).fill(palette.accent);
        }
        let button = match self.chosen {
            Some(chosen) => button.selected(chosen),
            None => button,
        };
        let response = ui.add_sized([width, theme::ROW], button);
        let hint = match keys::words(editor.language(), &self.action) {
            Some(keys) => format!("{} ({keys})", self.hint),
            None => self.hint.to_owned(),
        };
        if response.on_hover_text(hint).clicked() {
            actions.push(self.action.clone());
        }
    }
}

/// Buttons of equal width that fill a row.
pub(crate) fn button_row(
    editor: &Editor,
    ui: &mut Ui,
    buttons: &[PanelButton<'_>],
    actions: &mut Vec<Action>,
) {
    let width = share(ui, buttons.len());
    ui.horizontal(|ui| {
        // The width is fixed: the words have all of it.
        ui.spacing_mut().button_padding.x = 0.0;
        for button in buttons {
            button.show(editor, ui, width, actions);
        }
    });
}

/// Width of one of `count` things that fill a row.
pub(crate) fn share(ui: &Ui, count: usize) -> f32 {
    let gaps = (count - 1) as f32 * ui.spacing().item_spacing.x;
    ((ui.available_width() - gaps) / count as f32).floor()
}
