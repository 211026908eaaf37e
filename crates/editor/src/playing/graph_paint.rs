//! What the graph of tracks paints besides its curves: the scale, keys with their handles, what stands
//! above them and at their side.

use egui::{
    Color32, Id, Painter, Pos2, Rect, Role, ScrollArea, Sense, Stroke, Ui, UiBuilder, WidgetInfo,
    pos2, vec2,
};
use vides_engine::scene::Channel;

use super::axis::step;
use super::track_curve::Of;
use super::track_rows;
use crate::playing::track_dots::{Shown, keys_between};
use crate::playing::track_rows::{ROW, caption, channel_name};
use crate::state::Editor;
use crate::state::playing::track_graph::Memory;
use crate::state::playing::tracks::{self, Row};
use crate::theme;

/// Half of a key's sign.
const DOT: f32 = 3.5;

/// Points between two lines of the scale at the least.
const APART: f64 = 24.0;

/// The colour of a number: those of the axes, of one alone that of what matters.
pub(super) fn colour(ui: &Ui, part: usize, width: usize) -> Color32 {
    let palette = theme::palette(ui);
    let dark = palette.field.r() < 0x80;
    let [on_dark, on_light] = match part % 3 {
        _ if width == 1 => return palette.text,
        0 => [0xff_7b72, 0xb3_261e],
        1 => [0x7c_d67c, 0x1f_7a33],
        _ => [0x6c_b2ff, 0x0b_57c4],
    };
    theme::rgb(if dark { on_dark } else { on_light })
}

/// What a number of a channel is called; nothing where it has but one.
pub(super) fn part_name(editor: &Editor, of: &Of<'_>, part: usize) -> String {
    let texts = &editor.texts().node;
    let names: [&str; 3] = match of.track.channel() {
        _ if of.width() == 1 => return String::new(),
        Channel::Rotation => [texts.yaw, texts.pitch, texts.roll],
        Channel::Colour => [texts.red, texts.green, texts.blue],
        Channel::Cone => [texts.inner, texts.outer, ""],
        Channel::Position | Channel::Scale => ["x", "y", "z"],
        _ => [""; 3],
    };
    let name = names.get(part).copied().unwrap_or_default();
    match name.is_empty() {
        true => (part + 1).to_string(),
        false => name.to_owned(),
    }
}

/// Lines at round numbers, and what they are at the left.
pub(super) fn scale(
    editor: &Editor,
    ui: &Ui,
    painter: &Painter,
    (shown, (low, high)): (&Shown<'_>, (f64, f64)),
    left: f32,
) {
    let (palette, ground) = (theme::palette(ui), shown.ground);
    painter.rect_filled(ground, 3.0, palette.field);
    let (wide, _) = step(shown.fit.per_point * APART);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let decimals = (-wide.log10().floor()).clamp(0.0, 9.0) as usize;
    for at in 0..64_u32 {
        let value = wide * ((low / wide).ceil() + f64::from(at));
        if value > high {
            break;
        }
        let y = shown.fit.y(value);
        painter.hline(ground.x_range(), y, Stroke::new(1.0, palette.line));
        let words = match value.abs() < 1e7 {
            true => editor.language().number(value, decimals),
            false => editor.language().power(value, 2),
        };
        let galley = painter.layout_no_wrap(words, theme::small(), palette.weak);
        // Beside the playhead where that is at the beginning.
        let place = pos2(ground.left() + 12.0, y - galley.size().y);
        if place.x >= left && place.y > ground.top() + 14.0 {
            painter.galley(place, galley, palette.weak);
        }
    }
}

/// The keys and the handles of those that are selected.
pub(super) fn signs(memory: &Memory, ui: &Ui, painter: &Painter, shown: &Shown<'_>) {
    let palette = theme::palette(ui);
    let ends = [shown.ground.left(), shown.ground.right()].map(|x| shown.axis.frame(x));
    for (dot, _, place) in shown.handles(&memory.parts) {
        let Some(of) = shown.track_of(&dot.at) else {
            continue;
        };
        let line = Stroke::new(1.2, palette.accent);
        painter.line_segment([shown.place(&of, dot.at.key, dot.part), place], line);
        painter.circle(place, DOT, palette.field, line);
    }
    for of in &shown.tracks {
        let width = of.width();
        let mut last = vec![Pos2::new(f32::INFINITY, 0.0); width];
        for key in keys_between(of.track, ends) {
            for (part, last) in last.iter_mut().enumerate() {
                let place = shown.place(of, key, part);
                // Another one stands there.
                if (place - *last).abs().max_elem() < 1.0 {
                    continue;
                }
                *last = place;
                let (colour, line) = (colour(ui, part, width), Stroke::new(1.0, palette.field));
                let (fill, line) = match of.is_read_only() {
                    true => (palette.field, Stroke::new(1.2, colour)),
                    false => (colour, line),
                };
                painter.add(track_rows::diamond(place, DOT, fill, line));
            }
        }
    }
    for dot in shown.dots(&memory.parts) {
        let Some(of) = shown.track_of(&dot.at) else {
            continue;
        };
        let place = shown.place(&of, dot.at.key, dot.part);
        let line = Stroke::new(1.5, palette.text);
        let sign = track_rows::diamond(place, DOT + 2.0, palette.accent, line);
        painter.add(sign);
    }
}

/// What the curves are, with their numbers at the playhead.
pub(super) fn headings(editor: &Editor, ui: &Ui, painter: &Painter, shown: &Shown<'_>) {
    let palette = theme::palette(ui);
    let frame = editor.position_on_bar();
    let mut place = shown.ground.left_top() + vec2(4.0, 1.0);
    let mut put = |words: String, colour: Color32, gap: f32| {
        let galley = painter.layout_no_wrap(words, theme::small(), colour);
        let right = place.x + galley.size().x;
        if right < shown.ground.right() {
            painter.galley(place, galley, colour);
        }
        place.x = right + gap;
    };
    for of in &shown.tracks {
        let name = channel_name(editor, of.track.channel());
        put(name, palette.text, 6.0);
        for (part, value) in of.at(frame).into_iter().enumerate() {
            let value = editor.language().number(value, 3);
            let words = format!("{} {value}", part_name(editor, of, part));
            put(words.trim().to_owned(), colour(ui, part, of.width()), 8.0);
        }
        put(String::new(), palette.text, 8.0);
    }
}

/// What the graph is, where it is chosen.
pub(super) fn switch(editor: &Editor, on: &mut bool, ui: &Ui, place: Rect) {
    let texts = &editor.texts().timeline;
    let response = ui.interact(place, egui::Id::unique("graph of keys"), Sense::click());
    let chosen = *on;
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, chosen, texts.graph_switch));
    let visuals = ui.style().interact_selectable(&response, *on);
    let painter = ui.painter_at(place);
    painter.rect(
        place,
        4.0,
        visuals.weak_bg_fill,
        visuals.bg_stroke,
        egui::StrokeKind::Inside,
    );
    let wave = (0..=10_u8).map(|step| {
        let share = f32::from(step) / 10.0;
        let up = (share * std::f32::consts::TAU).sin();
        place.center() + vec2(share.mul_add(12.0, -6.0), up * -4.0)
    });
    painter.line(wave.collect(), Stroke::new(1.5, visuals.fg_stroke.color));
    if response.on_hover_text(texts.graph_tip).clicked() {
        *on = !*on;
    }
}

/// The names of the rows, by which curves are chosen.
pub(super) fn names(
    editor: &Editor,
    memory: &mut tracks::Memory,
    ui: &mut Ui,
    rect: Rect,
    rows: &[Row],
) {
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    let seen = memory.graph.shows(editor, edited, rows);
    let inside = UiBuilder::new().max_rect(rect).id_salt("names of tracks");
    ui.scope_builder(inside, |ui| {
        ui.set_clip_rect(rect.intersect(ui.clip_rect()));
        ui.spacing_mut().item_spacing.y = 0.0;
        let area = ScrollArea::vertical().id_salt("names of tracks");
        let area = area.max_height(rect.height()).auto_shrink(false);
        area.show_rows(ui, ROW, rows.len(), |ui, numbers| {
            for row in rows.get(numbers).unwrap_or_default() {
                let (_, room) = ui.allocate_space(vec2(ui.available_width(), ROW));
                let room = room.with_max_x(rect.right() - theme::GAP);
                caption(editor, memory, ui, (*row, room), edited);
                let Some(of) = row.of(edited) else {
                    continue;
                };
                let id = Id::unique(("curve of", row.node, row.track));
                let response = ui.interact(room, id, Sense::CLICK);
                let channel = channel_name(editor, of.track.channel());
                let on = seen.contains(row);
                response.widget_info(|| WidgetInfo::selected(Role::Button, true, on, &channel));
                if on || response.hovered() {
                    let palette = theme::palette(ui);
                    let bar = room.with_max_x(room.left() + 3.0).shrink2(vec2(0.0, 3.0));
                    let colour = match response.hovered() {
                        true => palette.focus,
                        false => palette.accent,
                    };
                    ui.painter().rect_filled(bar, 1.0, colour);
                }
                if response.clicked() {
                    let adds = ui.input(|input| input.modifiers.ctrl || input.modifiers.shift);
                    memory.graph.choose(editor, edited, (rows, *row), adds);
                }
                response.on_hover_text(editor.texts().timeline.curve_tip);
            }
        });
    });
}
