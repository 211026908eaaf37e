//! The timeline's first row: what plays and how, the numbers of frame, second and rate, what is
//! kept while keys move, what else is shown.

use egui::{Align, Button, Layout, Pos2, Rect, Role, Shape, Stroke, Ui, WidgetInfo, vec2};
use vides_document::Edit;
use vides_engine::limits::{MAX_FPS, MAX_FRAMES};
use vides_engine::scene::Part;

use super::buttons::{BUTTON, camera_button, play_button, speed_button};
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::number::Number;
use crate::playing::axis::as_frame;
use crate::state::Editor;
use crate::state::playing::Pace;
use crate::theme;

/// Width of a small button; greatest and least width of a number.
const SMALL: f32 = 28.0;
const FIELDS: (f32, f32) = (88.0, 60.0);
/// Between what belongs together, and between groups.
const NARROW: f32 = 4.0;
const WIDE: f32 = 12.0;

impl Pace {
    /// Film time per second.
    pub(super) const fn factor(self) -> f64 {
        match self {
            Self::Half => 0.5,
            Self::Whole => 1.0,
            Self::Double => 2.0,
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Half => "½×",
            Self::Whole => "1×",
            Self::Double => "2×",
        }
    }

    const fn next(self) -> Self {
        match self {
            Self::Half => Self::Whole,
            Self::Whole => Self::Double,
            Self::Double => Self::Half,
        }
    }
}

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let (first, last) = editor.playing.marks.range;
    let count = match editor.playing.marks.frames {
        0 => 0.0,
        _ => last - first + 1.0,
    };
    // A scene ends when everything in it has ended: its length is not that of one path.
    let of_scene = editor.document.edited_scene().is_some();
    let groups = if ui.available_width() < 700.0 {
        NARROW
    } else {
        WIDE
    };
    let small = if of_scene { 4.0 } else { 3.0 };
    let others = 3.0 * BUTTON
        + small * SMALL
        + times_width(editor, ui)
        + (6.0 + small) * NARROW
        + 3.0 * groups;
    let field = (ui.available_width() - others) / 5.0;
    let field = field.clamp(FIELDS.1, FIELDS.0).floor();
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = NARROW;
        play_button(editor, ui, actions);
        ui.scope(|ui| {
            ui.spacing_mut().button_padding.x = 0.0;
            how(editor, ui, actions);
        });
        ui.add_space(groups - NARROW);
        if count == 0.0 {
            ui.label(texts.too_many_frames);
        } else {
            numbers(editor, ui, field, (count, of_scene), groups, actions);
        }
        ui.add_space(groups - NARROW);
        times(editor, ui, actions);
        along(editor, ui, actions);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            camera_button(editor, ui, actions);
            speed_button(editor, ui, actions);
        });
    });
}

/// Frame, second and rate.
fn numbers(
    editor: &Editor,
    ui: &mut Ui,
    field: f32,
    (count, of_scene): (f64, bool),
    groups: f32,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let info = editor.document.info();
    // What people see is that much more than the frame.
    let (fps, more) = (info.fps, f64::from(info.first_frame) - 1.0);
    let at = editor.position_on_bar().round();
    let language = editor.language();
    let (begin, end) = editor.playing.marks.range;
    let (first, last) = (begin + more, end + more);
    let seconds = |frames: f64| (frames - 1.0) / fps;
    // The frames of the whole path; each section gets its share of them.
    let points = editor.document.path().points.len();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let fit = |frames: f64| Edit::FitFrames {
        first: 0,
        last: points.saturating_sub(1),
        frames: frames as usize,
    };
    let entry = Number::new(texts.frame_number, at + more)
        .label(texts.timeline)
        .hint(texts.frame_tip)
        .whole()
        .range(first..=last)
        .steps(1.0, 1.0)
        .show(ui, language, "playing.frame", field);
    actions.push(Action::Time(TimeAction::Playhead(
        entry.map(|value| value - more),
    )));
    // A scene ends where it is told to.
    let range = |last: f64| match editor.document.own_frame_range() {
        Ok(own) if own == (begin, last) => None,
        _ => Some((begin, last)),
    };
    let end_at = |last: f64| match of_scene {
        true => Edit::Part(Box::new(Part::Range(range(last)))),
        false => fit(last - begin + 1.0),
    };
    let [last_tip, duration_tip] = match of_scene {
        true => [texts.scene_last_tip; 2],
        false => [texts.last_frame_tip, texts.duration_tip],
    };
    let entry = Number::new(texts.last_frame, last)
        .label(texts.of)
        .hint(last_tip)
        .whole()
        .typed()
        .range(first + 1.0..=first + as_frame(MAX_FRAMES) - 1.0)
        .steps(1.0, 0.0)
        .show(ui, language, "playing.last", field);
    actions.push(Action::Enter(entry.map(|last| end_at(last - more))));
    ui.add_space(groups - NARROW);
    let entry = Number::new(texts.second, seconds(at))
        .hint(texts.second_tip)
        .seconds()
        .range(seconds(begin)..=seconds(end))
        .steps(1.0 / fps, 1.0 / fps)
        .show(ui, language, "playing.second", field);
    let entry = entry.map(|value| (value * fps).round() + 1.0);
    actions.push(Action::Time(TimeAction::Playhead(entry)));
    // The last frame is shown as long as every other one; seconds count from the first frame that
    // a scene can have.
    let entry = Number::new(texts.duration, (begin - 1.0 + count) / fps)
        .label(texts.of)
        .hint(duration_tip)
        .seconds()
        .typed()
        .range((begin + 1.0) / fps..=(begin - 1.0 + as_frame(MAX_FRAMES)) / fps)
        .steps(1.0, 0.0)
        .show(ui, language, "playing.duration", field);
    let entry = entry.map(|seconds| end_at((seconds * fps).round()));
    actions.push(Action::Enter(entry));
    let entry = Number::new(texts.rate, fps)
        .hint(texts.rate_tip)
        .unit(texts.rate_unit)
        .decimals(if fps.fract() == 0.0 { 0 } else { 3 })
        .range(0.001..=MAX_FPS)
        .typed()
        .steps(1.0, 0.0)
        .show(ui, language, "playing.fps", field);
    match entry {
        Entry::Set(fps) => actions.push(Action::Time(TimeAction::Rate(fps))),
        Entry::Wrong(why) => actions.push(Action::Complain(why)),
        _ => {}
    }
}

/// A small button that bears a picture: whether it was clicked, its middle, the picture's colour.
fn pictured(ui: &mut Ui, name: &str, tip: &str, on: bool) -> (bool, Pos2, egui::Color32) {
    let response = ui.add_sized([SMALL, theme::ROW], Button::new("").selected(on));
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, on, name));
    let visuals = ui.style().interact_selectable(&response, on);
    let (centre, colour) = (response.rect.center(), visuals.fg_stroke.color);
    (response.on_hover_text(tip).clicked(), centre, colour)
}

/// The button by which what follows a key moves along with it.
fn along(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().timeline;
    let on = editor.playing.moves_along;
    let (clicked, centre, color) = pictured(ui, texts.along, texts.along_tip, on);
    ui.painter().extend(keys_along(centre, color));
    if clicked {
        actions.push(Action::Time(TimeAction::SwitchMovesAlong));
    }
}

/// A key, and an arrow that takes the next one along.
fn keys_along(centre: Pos2, color: egui::Color32) -> Vec<Shape> {
    let stroke = Stroke::new(1.5, color);
    let at = |x: f32, y: f32| centre + vec2(x, y);
    let key = |x: f32| {
        let corners = [at(x, -4.0), at(x + 4.0, 0.0), at(x, 4.0), at(x - 4.0, 0.0)];
        corners.to_vec()
    };
    let head = vec![at(5.0, -4.0), at(10.0, 0.0), at(5.0, 4.0)];
    vec![
        Shape::convex_polygon(key(-6.0), color, Stroke::NONE),
        Shape::line_segment([at(-1.0, 0.0), at(6.0, 0.0)], stroke),
        Shape::convex_polygon(head, color, Stroke::NONE),
    ]
}

/// The word that says whether times are fixed, and the button that changes it.
fn times(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let (word, tip) = match editor.times_are_fixed() {
        true => (texts.times_fixed, texts.times_fixed_tip),
        false => (texts.times_follow, texts.times_follow_tip),
    };
    let response = ui.add_sized([times_width(editor, ui), theme::ROW], Button::new(word));
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(word.to_owned()),
        ..WidgetInfo::labeled(Role::Button, true, texts.times)
    });
    if response.on_hover_text(tip).clicked() {
        actions.push(Action::Time(TimeAction::SwitchFixedTimes));
    }
}

/// Room for either word.
fn times_width(editor: &Editor, ui: &Ui) -> f32 {
    let texts = &editor.texts().space;
    let font = egui::TextStyle::Button.resolve(ui.style());
    let width = |word: &str| {
        let color = egui::Color32::PLACEHOLDER;
        let galley = ui
            .painter()
            .layout_no_wrap(word.to_owned(), font.clone(), color);
        galley.size().x
    };
    let words = [texts.times_fixed, texts.times_follow].map(width);
    (words[0].max(words[1]) + 2.0 * NARROW).ceil()
}

/// The buttons for looping and for the pace.
fn how(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let loops = editor.playing.loops;
    let (clicked, centre, color) = pictured(ui, texts.again, texts.again_tip, loops);
    ui.painter().extend(arrows_round(centre, color));
    if clicked {
        actions.push(Action::Time(TimeAction::SwitchLoops));
    }
    if editor.document.edited_scene().is_some() {
        only_selected(editor, ui, actions);
    }
    let pace = editor.playing.pace;
    let response = ui.add_sized([SMALL, theme::ROW], Button::new(pace.words()));
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(pace.words().to_owned()),
        ..WidgetInfo::labeled(Role::Button, true, texts.pace)
    });
    if response.on_hover_text(texts.pace_tip).clicked() {
        actions.push(Action::Time(TimeAction::Pace(pace.next())));
    }
}

/// The button by which only what is selected is played.
fn only_selected(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().space;
    let on = editor.playing.only_selected;
    let (name, tip) = (texts.only_selected, texts.only_selected_tip);
    let (clicked, centre, color) = pictured(ui, name, tip, on);
    // A bar between two ends.
    let bar = Rect::from_center_size(centre, vec2(9.0, 4.0));
    ui.painter().rect_filled(bar, 1.0, color);
    for way in [-1.0, 1.0] {
        let at = |x: f32, y: f32| centre + vec2(way * x, y);
        let bracket = [at(6.0, -5.5), at(9.0, -5.5), at(9.0, 5.5), at(6.0, 5.5)];
        let stroke = Stroke::new(1.5, color);
        ui.painter().add(Shape::line(bracket.to_vec(), stroke));
    }
    if clicked {
        actions.push(Action::Time(TimeAction::SwitchOnlySelected));
    }
}

fn arrows_round(centre: Pos2, color: egui::Color32) -> Vec<Shape> {
    let stroke = Stroke::new(1.5, color);
    let half = |sign: f32| {
        let at = |x: f32, y: f32| centre + vec2(x, y) * sign;
        let way = vec![at(-7.0, 2.0), at(-7.0, -4.0), at(4.0, -4.0)];
        let head = vec![at(3.0, -7.0), at(7.5, -4.0), at(3.0, -1.0)];
        [
            Shape::line(way, stroke),
            Shape::convex_polygon(head, color, Stroke::NONE),
        ]
    };
    [half(1.0), half(-1.0)].concat()
}
