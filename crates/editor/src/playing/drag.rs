//! The one drag along the time, whatever is held: a key of the path, keys of nodes, a path's bar, a
//! marker. With Shift it goes finer, with Ctrl copies move, a number can be typed; Enter ends it,
//! Escape gives back.

use egui::{
    CornerRadius, CursorIcon, Id, Key, Modifiers, Order, Pos2, Rect, Response, Stroke, StrokeKind,
    Ui, pos2, vec2,
};
use vides_document::Edit;

use super::axis::Axis;
use crate::action::Action;
use crate::entry::Entry;
use crate::space::typed::Typed;
use crate::state::Editor;
use crate::state::playing::drag::Drag;
use crate::texts::fill;
use crate::theme;

/// Factor of a drag with Shift.
pub(super) const FINE: f64 = 0.1;

/// Parts of a frame to which keys are moved with Shift.
pub(super) const PARTS: f64 = 10.0;

/// A pass in which something is held.
pub(crate) struct Pass<'a> {
    pub(super) editor: &'a Editor,
    pub(super) ui: &'a Ui,
    /// Of what was taken.
    pub(super) response: &'a Response,
    /// As the scene counts.
    pub(super) axis: &'a Axis,
    /// Words about it end here.
    pub(super) top: f32,
}

/// Where it is dragged.
pub(crate) struct To {
    /// From this frame of the scene by so many, exactly.
    pub(super) from: f64,
    pub(super) by: f64,
    /// To this frame of the scene: a whole one, or a tenth of one with Shift.
    pub(super) frame: f64,
    /// With Shift.
    pub(super) fine: bool,
    /// A copy is to move.
    pub(super) copies: bool,
}

/// What can be dragged along the time.
pub(crate) trait Moves {
    /// What is to be done, if that is another.
    fn go_on(&mut self, pass: &Pass<'_>, to: &To) -> Option<Action>;

    /// The scene's frame at which it is now.
    fn at(&self, editor: &Editor, from: f64) -> f64;

    /// Whether a copy moves.
    fn copies(&self) -> bool {
        false
    }

    /// Lines about it besides where it is.
    fn more(&self, _editor: &Editor) -> Vec<String> {
        Vec::new()
    }

    fn cursor(&self) -> CursorIcon {
        match self.copies() {
            true => CursorIcon::Copy,
            false => CursorIcon::ResizeHorizontal,
        }
    }
}

impl<T: Moves> Drag<T> {
    pub(super) fn new(of: T, name: String, from: f64, pointer: Pos2) -> Box<Self> {
        Box::new(Self {
            of,
            name,
            from,
            pointer: pointer.x,
            gone: 0.0,
            typed: Typed::default(),
            copies: false,
        })
    }

    /// Goes on with the pointer or what is typed; how it ends, if it does in this pass.
    pub(super) fn go_on(
        &mut self,
        pass: &Pass<'_>,
        actions: &mut Vec<Action>,
    ) -> Option<Entry<Edit>> {
        if pass.response.dragged() {
            let to = self.to(pass);
            actions.extend(self.of.go_on(pass, &to));
            self.tell(pass);
            pass.ui.set_cursor_icon(self.of.cursor());
        }
        ended(pass.ui, pass.response, actions)
    }

    fn to(&mut self, pass: &Pass<'_>) -> To {
        let held = pass.ui.input(|input| input.modifiers);
        if let Some(pointer) = pass.response.interact_pointer_pos() {
            let share = if held.shift { FINE } else { 1.0 };
            let each = pass.axis.frames_per_point();
            self.gone += f64::from(pointer.x - self.pointer) * each * share;
            self.pointer = pointer.x;
        }
        let typed = &mut self.typed;
        pass.ui
            .input_mut(|input| input.events.retain(|event| !typed.take(event)));
        if self.typed.text().is_empty() {
            self.copies = held.ctrl || held.command;
        }
        let to = self.wanted(pass.editor);
        let frame = match held.shift {
            true => (to * PARTS).round() / PARTS,
            // What does not move stays where it is, between two frames, too.
            false if self.gone == 0.0 && self.typed.text().is_empty() => self.from,
            false => to.round(),
        };
        To {
            from: self.from,
            by: to - self.from,
            frame,
            fine: held.shift,
            copies: self.copies,
        }
    }

    fn wanted(&self, editor: &Editor) -> f64 {
        let Some(number) = self.typed.number() else {
            return self.from + self.gone;
        };
        let info = editor.document.info();
        // A sign: from where it stood.
        match (self.typed.has_sign(), editor.setup.ruler_frames) {
            (true, true) => self.from + number,
            (true, false) => self.from + number * info.fps,
            (false, true) => number - f64::from(info.first_frame) + 1.0,
            (false, false) => number * info.fps + 1.0,
        }
    }

    /// Where it is, in numbers, above the ruler.
    fn tell(&self, pass: &Pass<'_>) {
        let editor = pass.editor;
        let (language, info) = (editor.language(), editor.document.info());
        let at = self.of.at(editor, self.from);
        let second = language.number((at - 1.0) / info.fps, 2);
        let by = (at - self.from) / info.fps;
        let sign = if by > 0.0 { "+" } else { "" };
        let by = format!("{sign}{}", language.number(by, 2));
        let frame = editor.frame_for_people(at);
        let texts = &editor.texts().timeline;
        let name = match self.of.copies() {
            true => fill(texts.copy_of, &[&self.name]),
            false => self.name.clone(),
        };
        let mut lines = vec![fill(texts.moved, &[&name, &second, &by, &frame])];
        lines.extend(self.of.more(editor));
        if !self.typed.text().is_empty() {
            let unit = if editor.setup.ruler_frames { "" } else { " s" };
            lines.push(format!("› {}{unit}", self.typed.text()));
        }
        bubble(
            pass.ui,
            pos2(pass.axis.place(at), pass.top),
            lines.join("\n"),
        );
    }
}

/// Where a drag begins in this pass, with the left button.
pub(super) fn begun(ui: &Ui, response: &Response) -> Option<Pos2> {
    let at = ui.input(|input| {
        let other = input.pointer.middle_down() || input.pointer.secondary_down();
        input.pointer.press_origin().filter(|_| !other)
    });
    at.filter(|_| response.drag_started())
}

/// How what is held ends, if it does in this pass: let go, by Enter, or given back by Escape.
pub(super) fn ended(
    ui: &Ui,
    response: &Response,
    actions: &mut Vec<Action>,
) -> Option<Entry<Edit>> {
    let enter = || ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    let end = match response.dragged() {
        false => Entry::of_end(ui.ctx()),
        true if enter() => {
            ui.ctx().stop_dragging();
            Entry::End
        }
        true => return None,
    };
    actions.push(Action::Enter(end.clone()));
    Some(end)
}

/// The box that selects, from where it began.
pub(super) fn select_box(ui: &Ui, ground: Rect, place: Rect) {
    let palette = theme::palette(ui);
    let painter = ui.painter_at(ground.intersect(ui.clip_rect()));
    let line = Stroke::new(1.0, palette.accent);
    let fill = palette.accent.gamma_multiply(0.15);
    painter.rect(place, 0.0, fill, line, StrokeKind::Inside);
}

/// Words in a box above a place.
pub(super) fn bubble(ui: &Ui, place: Pos2, words: String) {
    let palette = theme::palette(ui);
    let layer = egui::LayerId::new(Order::Tooltip, Id::unique("key in time"));
    let painter = ui.ctx().layer_painter(layer);
    let galley = painter.layout_no_wrap(words, theme::text(), palette.text);
    let room = ui.ctx().content_rect().shrink(4.0);
    let size = galley.size() + vec2(16.0, 8.0);
    let most = (room.right() - size.x).max(room.left());
    let left = (place.x - size.x / 2.0).clamp(room.left(), most);
    let rect = Rect::from_min_size(pos2(left, place.y - size.y - 4.0), size);
    let stroke = Stroke::new(1.0, palette.rim);
    let corners = CornerRadius::same(4);
    painter.rect(rect, corners, palette.panel, stroke, StrokeKind::Inside);
    painter.galley(rect.min + vec2(8.0, 4.0), galley, palette.text);
}

#[cfg(test)]
#[path = "drag_tests.rs"]
mod tests;
