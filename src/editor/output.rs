//! The output field (thesis A.2): the current camera setting in steady columns,
//! or what there is to say.

use egui::{Align2, Color32, FontId, Rect, Response, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use super::state::Editor;
use super::texts::Language;
use super::theme;

/// One value: as it is written, and how wide it may become.
struct Column {
    /// Stands before it where there is room.
    label: &'static str,
    /// The numbers.
    values: Vec<String>,
    /// The widest number that is expected.
    widest: &'static str,
}

/// Shows the field in the room that is left.
pub(super) fn show(editor: &Editor, ui: &mut Ui) {
    let room = ui.available_rect_before_wrap();
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
        None => show_setting(editor, ui, response),
    }
}

/// A sentence: on one line, or small on two; all of it in the tooltip.
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

/// The current camera setting.
fn show_setting(editor: &Editor, ui: &Ui, response: Response) {
    let columns = columns(editor);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, in_words(&columns)));
    let rect = response.rect.shrink2(vec2(12.0, 0.0));
    let width = |text: &str| text_width(ui, text);
    let digits = width("0");
    // Labels where there is room for them, else the numbers alone.
    for (labels, between) in [(true, 20.0), (true, 12.0), (false, 14.0), (false, 8.0)] {
        let mut places = Vec::new();
        let mut x = 0.0;
        for column in &columns {
            if labels {
                places.push((x, Align2::LEFT_CENTER, column.label, false));
                x += width(column.label) + digits * 0.75;
            }
            for value in &column.values {
                x += width(column.widest).max(width(value));
                places.push((x, Align2::RIGHT_CENTER, value, true));
                x += digits * 0.75;
            }
            x += between - digits * 0.75;
        }
        let all = x - between;
        if all <= rect.width() || (!labels && between < 10.0) {
            paint(ui, rect, rect.right() - all, &places);
            if !labels {
                response.on_hover_text(in_words(&columns));
            }
            return;
        }
    }
}

fn paint(ui: &Ui, rect: Rect, left: f32, places: &[(f32, Align2, &str, bool)]) {
    let palette = theme::palette(ui);
    let painter = ui.painter().with_clip_rect(rect);
    for &(x, align, text, strong) in places {
        let color = if strong { palette.text } else { palette.weak };
        let at = pos2(left + x, rect.center().y);
        painter.text(at, align, text, theme::text(), color);
    }
}

fn text_width(ui: &Ui, text: &str) -> f32 {
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), theme::text(), Color32::PLACEHOLDER);
    galley.size().x
}

fn columns(editor: &Editor) -> Vec<Column> {
    let texts = &editor.texts().output;
    let language = editor.language;
    let (Some(point), Some(orientation)) = (editor.point(), editor.orientation()) else {
        return Vec::new();
    };
    let view = orientation.view(point.position);
    let three = |v: [f64; 3]| v.map(|value| language.number(value, 3)).to_vec();
    let number = (editor.document.selection().point + 1).to_string();
    vec![
        Column {
            label: texts.point,
            values: vec![number],
            widest: "00",
        },
        Column {
            label: texts.position,
            values: three(point.position.to_array()),
            widest: "−0.000",
        },
        Column {
            label: texts.view,
            values: three(view.to_array()),
            widest: "−0.000",
        },
        Column {
            label: texts.roll,
            values: vec![format!("{}°", language.number(orientation.roll, 1))],
            widest: "−000.0°",
        },
        Column {
            label: texts.zoom,
            values: vec![zoom(language, orientation.zoom)],
            widest: "00.0",
        },
    ]
}

/// A zoom: as many decimals as it has, at most one.
fn zoom(language: Language, zoom: f64) -> String {
    language.number(zoom, 1)
}

/// The setting as a sentence.
fn in_words(columns: &[Column]) -> String {
    let parts: Vec<String> = columns
        .iter()
        .map(|column| format!("{} {}", column.label, column.values.join(" ")))
        .collect();
    parts.join(" · ")
}
