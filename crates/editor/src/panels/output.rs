//! The output field (thesis A.2): the current camera setting in columns, or a message.

use egui::{
    Align, Align2, Button, Color32, FontId, Rect, Response, Role, Sense, Ui, WidgetInfo, pos2, vec2,
};
use vides_engine::path::ahead;

use crate::action::Action;
use crate::number::decimals;
use crate::playing::playhead::Missing;
use crate::state::{Editor, Message};
use crate::{keys, theme};

/// One part of the setting.
struct Column {
    /// Before the values if there is room, else above them.
    label: &'static str,
    values: Vec<String>,
    /// The widest value that is expected.
    widest: &'static str,
}

/// Shows it; returns what its button asks for.
pub(crate) fn show(editor: &Editor, ui: &mut Ui) -> Option<Action> {
    let room = ui.available_rect_before_wrap();
    let state = Some(editor.document.state_number());
    let undoes = |message: &Message| message.undoes == state;
    let (room, undone) = match editor.message.as_ref().filter(|message| undoes(message)) {
        Some(_) => undo_button(editor, ui, room),
        None => (room, None),
    };
    let response = ui.allocate_rect(room, Sense::hover());
    match &editor.message {
        Some(message) => {
            let palette = theme::palette(ui);
            let color = if message.error {
                palette.error
            } else {
                palette.text
            };
            show_message(ui, response, &message.text, color);
        }
        None if editor.is_first_screen() => {}
        None => show_setting(editor, ui, response),
    }
    undone
}

/// A button at the right that takes back what the message tells; and the room left of it.
fn undo_button(editor: &Editor, ui: &mut Ui, room: Rect) -> (Rect, Option<Action>) {
    let texts = &editor.texts().menu;
    let width = text_width(ui, texts.undo, theme::text()) + 16.0;
    let (left, right) = room.split_left_right_at_x(room.right() - width - 4.0);
    let place = Rect::from_center_size(right.center(), vec2(width, theme::ROW));
    let response = ui.put(place, Button::new(texts.undo));
    let step = editor
        .language()
        .travel(false, editor.document.step_names()[0]);
    let hint = match keys::words(editor.language(), &Action::Undo) {
        Some(keys) => format!("{step} ({keys})"),
        None => step.into_owned(),
    };
    let clicked = response.on_hover_text(hint).clicked();
    (left, clicked.then_some(Action::Undo))
}

/// A sentence on one line, or small on two; if it is cut, all of it in the tooltip.
fn show_message(ui: &Ui, response: Response, text: &str, color: Color32) {
    let rect = response.rect.shrink2(vec2(12.0, 0.0));
    let painter = ui.painter().with_clip_rect(response.rect);
    let layout = |size: f32, rows: usize| {
        let mut job = egui::text::LayoutJob::simple(
            text.to_owned(),
            FontId::proportional(size),
            color,
            rect.width(),
        );
        job.wrap.max_rows = rows;
        painter.layout_job(job)
    };
    let mut galley = layout(theme::TEXT, 1);
    if galley.elided {
        galley = layout(11.0, 2);
    }
    let size = galley.size();
    let at = pos2(rect.right() - size.x, rect.center().y - size.y / 2.0);
    let elided = galley.elided;
    painter.galley(at, galley, color);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    if elided {
        response.on_hover_text(text);
    }
}

fn show_setting(editor: &Editor, ui: &Ui, response: Response) {
    let mut columns = columns(editor);
    let words = in_words(&columns);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &words));
    let rect = response.rect.shrink2(vec2(12.0, 0.0));
    let width = |text: &str, font: FontId| text_width(ui, text, font);
    // The least important first: panels and tooltip have all of it.
    for left_out in [None, Some(ZOOM), Some(ROLL), Some(POINT), Some(VIEW)] {
        if let Some(at) = left_out.filter(|&at| at < columns.len()) {
            columns.remove(at);
        }
        // Labels beside the numbers if there is room, else above.
        for (above, between) in [
            (false, 20.0),
            (false, 12.0),
            (true, 14.0),
            (true, 8.0),
            (true, 4.0),
        ] {
            let (all, places) = arranged(&columns, above, between, &width);
            if all <= rect.width() || columns.len() == 1 {
                paint(ui, rect, rect.right() - all, &places);
                if above || left_out.is_some() {
                    response.on_hover_text(words);
                }
                return;
            }
        }
    }
}

/// Where the columns stand when they are left out, those after them first; the view when the point
/// has gone.
const ZOOM: usize = 4;
const ROLL: usize = 3;
const POINT: usize = 0;
const VIEW: usize = 1;

type Place<'a> = (f32, Align2, &'a str, Kind);

/// How wide the columns are, and where their labels and values stand.
fn arranged<'a>(
    columns: &'a [Column],
    above: bool,
    between: f32,
    width: &dyn Fn(&str, FontId) -> f32,
) -> (f32, Vec<Place<'a>>) {
    let digits = width("0", theme::text());
    let mut places = Vec::new();
    let mut x = 0.0;
    for column in columns {
        let label_width = if above {
            places.push((x, Align2::LEFT_BOTTOM, column.label, Kind::Above));
            x + width(column.label, theme::small())
        } else {
            places.push((x, Align2::LEFT_CENTER, column.label, Kind::Beside));
            x += width(column.label, theme::text()) + digits * 0.75;
            x
        };
        for value in &column.values {
            x += width(column.widest, theme::text()).max(width(value, theme::text()));
            let align = if above {
                Align2::RIGHT_TOP
            } else {
                Align2::RIGHT_CENTER
            };
            places.push((x, align, value.as_str(), Kind::Value));
            x += digits * 0.75;
        }
        x = x.max(label_width + digits * 0.75) + between - digits * 0.75;
    }
    (x - between, places)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Value,
    /// A label beside its values.
    Beside,
    /// A small label above them.
    Above,
}

fn paint(ui: &Ui, rect: Rect, left: f32, places: &[Place<'_>]) {
    let palette = theme::palette(ui);
    let painter = ui.painter().with_clip_rect(rect);
    for &(x, align, text, kind) in places {
        let (color, font) = match kind {
            Kind::Value => (palette.text, theme::text()),
            Kind::Beside => (palette.weak, theme::text()),
            Kind::Above => (palette.weak, theme::small()),
        };
        // Two lines meet a little above the middle.
        let line = if align.y() == Align::Center {
            0.0
        } else {
            -2.0
        };
        let at = pos2(left + x, rect.center().y + line);
        painter.text(at, align, text, font, color);
    }
}

fn text_width(ui: &Ui, text: &str, font: FontId) -> f32 {
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER);
    galley.size().x
}

fn columns(editor: &Editor) -> Vec<Column> {
    let texts = &editor.texts().output;
    let language = editor.language();
    let Some(shown) = editor.shown() else {
        return Vec::new();
    };
    let orientation = &shown.orientation;
    let view = match shown.missing {
        Missing::Nothing => {
            ahead::view(editor.document.path(), shown.at.point, shown.at.orientation)
        }
        Missing::Outside => editor.camera().map_or_else(
            || orientation.view(shown.position),
            |(camera, _)| camera.view,
        ),
        Missing::Point | Missing::Orientation => orientation.view(shown.position),
    };
    let three = |v: [f64; 3], digits| v.map(|value| language.number(value, digits)).to_vec();
    let space = decimals(editor.document.path().space.half_size);
    let at = shown.at.point;
    let number = if shown.has_no_point() {
        // Between two points: `at` is that which a point would have there.
        let next = at % editor.document.path().points.len().max(1);
        format!("{at}–{}", next + 1)
    } else {
        (at + 1).to_string()
    };
    let mut position = three(shown.position.to_array(), space);
    let unit = &editor.document.info().unit;
    if !unit.is_empty() {
        position.push(unit.clone());
    }
    vec![
        Column {
            label: texts.point,
            values: vec![number],
            widest: "00",
        },
        Column {
            label: texts.position,
            values: position,
            widest: "−0.000",
        },
        Column {
            label: texts.view,
            values: three(view.to_array(), 3),
            widest: "−0.000",
        },
        Column {
            label: texts.roll,
            values: vec![format!("{}°", language.number(orientation.roll, 1))],
            widest: "−000.0°",
        },
        Column {
            label: texts.zoom,
            values: vec![language.number(orientation.zoom, 1)],
            widest: "00.0",
        },
    ]
}

/// The setting as a sentence.
fn in_words(columns: &[Column]) -> String {
    let parts: Vec<String> = columns
        .iter()
        .map(|column| format!("{} {}", column.label, column.values.join(" ")))
        .collect();
    parts.join(" · ")
}
