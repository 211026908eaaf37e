//! The speed curve of the current section, large (thesis A.4.3): ten small
//! squares to be dragged up and down, the facing values of the sections before
//! and after, the curve as it runs.

use egui::{
    Align, Align2, CornerRadius, CursorIcon, EventFilter, Id, Key, Layout, Modifiers, Painter,
    Pos2, Rect, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

mod shapes;

use self::shapes::Shape;
use super::{SubWindow, Windows, is_cramped, row_at_right, sub_window};
use crate::actions::Action;
use crate::document::{Edit, Info};
use crate::limits::{BASE_SPEED, MAX_FPS, MAX_FRAMES, MAX_HOLD, MAX_SPEED, MIN_SPEED, SPEEDS};
use crate::number::{Entry, Number};
use crate::path::speed_curve::SpeedCurve;
use crate::path::{BaseSpeeds, Orientation, Own};
use crate::state::Editor;
use crate::texts::fill;
use crate::theme::{self, Palette};

/// Left of the picture stand the speeds.
const SCALE: f32 = 32.0;
/// Room above 100 and below 1.
const MARGIN: f32 = 14.0;
/// Half the side of a square.
const SQUARE: f32 = 4.5;
/// Straight pieces of the curve.
const PIECES: usize = 180;

/// The speed curve of the current section.
#[derive(Debug)]
pub(crate) struct SpeedWindow {
    /// The square that is dragged, and how far the pointer is from its middle.
    dragged: Option<(usize, f32)>,
    /// The square that was chosen by an arrow key.
    choose: Option<usize>,
}

/// Sizes of the picture, in points.
#[derive(Clone, Copy)]
struct Size {
    /// From one square to the next.
    step: f32,
    height: f32,
    /// All buttons stand in one row.
    one_row: bool,
}

impl Size {
    const ROOMY: Self = Self {
        step: 48.0,
        height: 232.0,
        one_row: true,
    };
    const CRAMPED: Self = Self {
        step: 40.0,
        height: 144.0,
        one_row: false,
    };

    fn of(ui: &Ui) -> Self {
        if is_cramped(ui.ctx()) {
            Self::CRAMPED
        } else {
            Self::ROOMY
        }
    }

    /// Two half steps lie outside the outermost facing values.
    fn width(self) -> f32 {
        SCALE + self.step * 12.0
    }
}

/// What is shown of the current section.
struct Section {
    speeds: [f64; SPEEDS],
    before: Option<f64>,
    after: Option<f64>,
    curve: SpeedCurve,
    hold: u32,
    /// Frames without the hold; none at the end of the path.
    frames: Option<usize>,
    /// They are fixed, whatever the length; kept where the whole path gets others.
    fixed: bool,
    locked: bool,
    /// The point and orientation to which it leads.
    to: Option<(usize, usize)>,
}

impl Section {
    fn of(editor: &Editor) -> Option<Self> {
        let orientation = editor.orientation()?;
        let at = editor.document.selection();
        let path = editor.document.path();
        let speeds = orientation.speeds;
        let (facing, frames) = editor
            .document
            .timeline(
                |timeline| match timeline.section_from(at.point, at.orientation) {
                    Some(section) => (
                        timeline.facing_speeds(path, section),
                        Some(timeline.section(section).frames),
                    ),
                    None => (timeline.facing_speeds(path, timeline.section_count()), None),
                },
            )
            .ok()?;
        let (before, after) = facing;
        let last = path.points.get(at.point)?.orientations.len() == at.orientation + 1;
        let to = match (frames, last) {
            (None, _) => None,
            (Some(_), true) => Some(((at.point + 1) % path.points.len(), 0)),
            (Some(_), false) => Some((at.point, at.orientation + 1)),
        };
        Some(Self {
            curve: SpeedCurve::new(&speeds, before, after),
            speeds,
            before,
            after,
            hold: orientation.hold,
            fixed: orientation.own.frames > 0,
            locked: orientation.own.locked,
            frames,
            to,
        })
    }
}

impl SubWindow for SpeedWindow {
    const ID: &'static str = "speed";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.speed
    }

    fn new(_: &Editor) -> Self {
        Self {
            dragged: None,
            choose: None,
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().speed_window;
        let Some(section) = Section::of(editor) else {
            return false;
        };
        sub_window(context, Self::ID, texts.title, |ui| {
            ui.set_width(Size::of(ui).width());
            heading(editor, ui, &section, actions);
            ui.add_space(theme::GAP);
            self.picture(editor, ui, &section, actions);
            typed(editor, ui, &section, actions);
            ui.add_space(theme::GAP * 2.0);
            buttons(editor, ui, &section, actions);
            ui.add_space(theme::GAP);
            numbers(editor, ui, &section, actions);
            ui.separator();
            base_speeds(editor, ui, actions);
        })
    }
}

/// Which section it is, and how long it takes.
fn heading(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    let at = editor.document.selection();
    let palette = theme::palette(ui);
    let from = editor.name_of(at.point, at.orientation);
    ui.horizontal(|ui| {
        let text = match section.to {
            Some((point, orientation)) => {
                fill(texts.section, &[&from, &editor.name_of(point, orientation)])
            }
            None => fill(texts.end_of_path, &[&from]),
        };
        ui.label(text);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            match section.frames {
                None => {}
                Some(0) => {
                    ui.colored_label(palette.weak, texts.nothing_changes);
                }
                Some(frames) => length(editor, ui, section, frames, actions),
            }
        });
    });
}

/// How long it takes, from right to left: locked or not, seconds, frames.
fn length(
    editor: &Editor,
    ui: &mut Ui,
    section: &Section,
    frames: usize,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().speed_window;
    // Without memory for it all stays as it is.
    let change = |orientation: &mut Orientation, change: &dyn Fn(&mut Own)| {
        if let Ok(own) = orientation.own.with(change) {
            orientation.own = own;
        }
    };
    let mut locked = section.locked;
    let tick = theme::tick(ui, &mut locked, texts.locked);
    if tick.on_hover_text(texts.locked_hint).changed() {
        let edit = editor.orientation_edit(|new| change(new, &|own| own.locked = locked));
        actions.extend(edit.map(Action::Edit));
    }
    let fps = editor.document.info().fps;
    let seconds = editor.language().number(frames as f64 / fps, 2);
    ui.colored_label(theme::palette(ui).weak, fill(texts.seconds, &[&seconds]));
    let entry = Number::new(texts.frames, frames as f64)
        .hint(texts.frames_hint)
        .faint(!section.fixed)
        .whole()
        .range(0.0..=MAX_FRAMES as f64)
        .steps(1.0, 0.5)
        .show(ui, editor.language(), "speed.frames", 72.0);
    // Whole, and within an u32.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    actions.extend(entered(editor, entry, |new, frames| {
        change(new, &|own| own.frames = frames as u32);
    }));
    ui.label(texts.frames).on_hover_text(texts.frames_hint);
}

impl SpeedWindow {
    fn picture(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        let size = Size::of(ui);
        let (rect, _) = ui.allocate_exact_size(vec2(size.width(), size.height), Sense::hover());
        let palette = theme::palette(ui);
        let painter = ui.painter().with_clip_rect(rect.expand(1.0));
        let frame = Frame::new(rect, size.step);
        frame.paint_ground(&painter, palette, editor);
        frame.paint_curve(&painter, palette, section);
        for at in 0..SPEEDS {
            self.square(editor, ui, &frame, section, at, actions);
        }
    }

    /// One square: dragged by the pointer, moved by the arrow keys.
    fn square(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        frame: &Frame,
        section: &Section,
        at: usize,
        actions: &mut Vec<Action>,
    ) {
        let speed = section.speeds[at];
        let middle = pos2(frame.x(at as f32), frame.y(speed));
        let id = Id::unique(("speed square", at));
        let response = ui.interact(
            Rect::from_center_size(middle, vec2(frame.step * 0.6, 28.0)),
            id,
            Sense::click_and_drag(),
        );
        let name = fill(editor.texts().speed_window.speed, &[&(at + 1)]);
        response.widget_info(|| WidgetInfo::slider(true, speed, name.as_str()));
        if self.choose == Some(at) {
            self.choose = None;
            response.request_focus();
        }
        if response.clicked() {
            response.request_focus();
        }
        let pointer = response.interact_pointer_pos();
        if response.drag_started()
            && let Some(pointer) = ui.input(|input| input.pointer.press_origin())
        {
            actions.push(Action::Enter(Entry::Begin));
            self.dragged = Some((at, pointer.y - middle.y));
            response.request_focus();
        }
        let mine = self.dragged.filter(|dragged| dragged.0 == at);
        if let (Some((_, grip)), Some(pointer)) = (mine, pointer)
            && response.dragged()
        {
            let fine = ui.input(|input| input.modifiers.shift);
            let exact = frame.speed(pointer.y - grip);
            let rounded = if fine {
                (exact * 10.0).round() / 10.0
            } else {
                exact.round()
            };
            actions.extend(set_speed(editor, at, rounded));
        }
        if response.drag_stopped() && mine.is_some() {
            // egui ends a drag on Escape before anybody sees the key.
            if ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
                actions.push(Action::Enter(Entry::Cancel));
            } else {
                actions.push(Action::Enter(Entry::End));
            }
            self.dragged = None;
        }
        if response.has_focus() {
            self.keys(editor, ui, id, (at, speed), actions);
        }
        if response.hovered() || response.dragged() {
            ui.set_cursor_icon(CursorIcon::ResizeVertical);
        }
        let palette = theme::palette(ui);
        let lively = response.hovered() || response.dragged() || response.has_focus();
        let size = if lively { SQUARE + 1.5 } else { SQUARE };
        ui.painter().rect(
            Rect::from_center_size(middle, vec2(2.0 * size, 2.0 * size)),
            CornerRadius::same(1),
            if lively {
                palette.focus
            } else {
                palette.accent
            },
            Stroke::new(1.0, palette.field),
            StrokeKind::Outside,
        );
        if lively {
            let above = middle.y - frame.rect.top() > 26.0;
            let away = if above { -10.0 } else { 10.0 };
            ui.painter().text(
                pos2(middle.x, middle.y + away),
                if above {
                    Align2::CENTER_BOTTOM
                } else {
                    Align2::CENTER_TOP
                },
                editor.language().number(speed, 1),
                theme::text(),
                palette.text,
            );
        }
    }

    /// Arrow keys: up and down change, left and right choose.
    fn keys(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        id: Id,
        (at, speed): (usize, f64),
        actions: &mut Vec<Action>,
    ) {
        let filter = EventFilter {
            horizontal_arrows: true,
            vertical_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
        let (rise, aside) = ui.input_mut(|input| {
            let mut pressed = |key, modifiers| input.count_and_consume_key(modifiers, key) as f64;
            let mut both =
                |more, less, modifiers| pressed(more, modifiers) - pressed(less, modifiers);
            let far = both(Key::ArrowUp, Key::ArrowDown, Modifiers::SHIFT);
            let page = both(Key::PageUp, Key::PageDown, Modifiers::NONE);
            let near = both(Key::ArrowUp, Key::ArrowDown, Modifiers::NONE);
            let aside = both(Key::ArrowRight, Key::ArrowLeft, Modifiers::NONE);
            (near + 10.0 * (far + page), aside)
        });
        if rise != 0.0 {
            actions.extend(set_speed(editor, at, speed + rise));
        }
        let next = if aside > 0.0 {
            at + 1
        } else {
            at.wrapping_sub(1)
        };
        if aside != 0.0 && next < SPEEDS {
            self.choose = Some(next);
            ui.ctx().request_repaint();
        }
    }
}

/// Where a speed stands in the picture.
struct Frame {
    rect: Rect,
    /// From one square to the next.
    step: f32,
}

impl Frame {
    fn new(rect: Rect, step: f32) -> Self {
        let rect = Rect::from_min_max(pos2(rect.left() + SCALE, rect.top()), rect.max);
        Self { rect, step }
    }

    /// Across: 0 is the first square, 9 the last.
    fn x(&self, at: f32) -> f32 {
        self.rect.left() + self.step * (at + 1.5)
    }

    fn y(&self, speed: f64) -> f32 {
        let share = (speed - MIN_SPEED) / (MAX_SPEED - MIN_SPEED);
        let room = self.rect.height() - 2.0 * MARGIN;
        self.rect.bottom() - MARGIN - share as f32 * room
    }

    fn speed(&self, y: f32) -> f64 {
        let room = self.rect.height() - 2.0 * MARGIN;
        let share = f64::from((self.rect.bottom() - MARGIN - y) / room);
        (MIN_SPEED + share * (MAX_SPEED - MIN_SPEED)).clamp(MIN_SPEED, MAX_SPEED)
    }

    fn paint_ground(&self, painter: &Painter, palette: &Palette, editor: &Editor) {
        let border = Stroke::new(1.0, palette.line);
        let corner = CornerRadius::same(4);
        painter.rect(self.rect, corner, palette.field, border, StrokeKind::Inside);
        for speed in [MIN_SPEED, 25.0, BASE_SPEED, 75.0, MAX_SPEED] {
            let y = self.y(speed);
            let stroke = if speed == BASE_SPEED {
                Stroke::new(1.0, palette.rim)
            } else {
                border
            };
            painter.hline(self.rect.left() + 1.0..=self.rect.right() - 1.0, y, stroke);
            painter.text(
                pos2(self.rect.left() - 6.0, y),
                Align2::RIGHT_CENTER,
                editor.language().number(speed, 0),
                theme::small(),
                palette.weak,
            );
        }
        // The section lies between these.
        for at in [0.0, (SPEEDS - 1) as f32] {
            let ends = self.rect.top() + 1.0..=self.rect.bottom() - 1.0;
            painter.vline(self.x(at), ends, border);
        }
    }

    fn paint_curve(&self, painter: &Painter, palette: &Palette, section: &Section) {
        let last = (SPEEDS - 1) as f32;
        let faces = [
            (section.before, -1.0, 0.0),
            (section.after, last + 1.0, last),
        ];
        for (facing, at, end) in faces {
            let Some(speed) = facing else { continue };
            let (there, here) = (pos2(self.x(at), self.y(speed)), self.end(section, end));
            painter.extend(egui::Shape::dashed_line(
                &[there, here],
                Stroke::new(1.0, palette.weak),
                4.0,
                4.0,
            ));
            painter.rect(
                Rect::from_center_size(there, vec2(2.0 * SQUARE, 2.0 * SQUARE)),
                CornerRadius::same(1),
                palette.field,
                Stroke::new(1.5, palette.weak),
                StrokeKind::Inside,
            );
        }
        let line: Vec<Pos2> = (0..=PIECES)
            .map(|k| {
                let u = k as f64 / PIECES as f64;
                pos2(self.x(last * u as f32), self.y(section.curve.speed(u)))
            })
            .collect();
        painter.line(line, Stroke::new(2.0, palette.accent));
    }

    fn end(&self, section: &Section, at: f32) -> Pos2 {
        let u = f64::from(at) / (SPEEDS - 1) as f64;
        pos2(self.x(at), self.y(section.curve.speed(u)))
    }
}

/// The ten values as numbers, each below its square.
fn typed(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        let step = Size::of(ui).step;
        ui.add_space(SCALE + step);
        for at in 0..SPEEDS {
            let name = fill(texts.speed, &[&(at + 1)]);
            let number = Number::new(&name, section.speeds[at])
                .decimals(if section.speeds[at].fract() == 0.0 {
                    0
                } else {
                    1
                })
                .range(MIN_SPEED..=MAX_SPEED)
                .steps(1.0, 0.5);
            let id = format!("speed.{at}");
            let entry = number.show(ui, editor.language(), &id, step - theme::GAP);
            let speeds = section.speeds;
            actions.extend(entered(editor, entry, |orientation, value| {
                orientation.speeds = speeds;
                if let Some(speed) = orientation.speeds.get_mut(at) {
                    *speed = value;
                }
            }));
        }
    });
}

/// Shapes on the left; copy, paste and reset on the right, or below.
fn buttons(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let mut new = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        new = shapes(editor, ui, section);
        if Size::of(ui).one_row {
            new = new.or(exchange(editor, ui, section, actions));
        }
    });
    if !Size::of(ui).one_row {
        ui.horizontal(|ui| new = new.or(exchange(editor, ui, section, actions)));
    }
    if let Some(speeds) = new {
        let edit = editor.orientation_edit(|orientation| orientation.speeds = speeds);
        actions.extend(edit.map(Action::Edit));
    }
}

fn shapes(editor: &Editor, ui: &mut Ui, section: &Section) -> Option<[f64; SPEEDS]> {
    let texts = &editor.texts().speed_window;
    let names = [
        (texts.constant, texts.constant_hint),
        (texts.ease_in, texts.ease_in_hint),
        (texts.ease_out, texts.ease_out_hint),
        (texts.both, texts.both_hint),
    ];
    let mut new = None;
    for (shape, (name, hint)) in Shape::ALL.into_iter().zip(names) {
        if ui.button(name).on_hover_text(hint).clicked() {
            new = Some(shape.speeds(&section.speeds, section.before, section.after));
        }
    }
    new
}

fn exchange(
    editor: &Editor,
    ui: &mut Ui,
    section: &Section,
    actions: &mut Vec<Action>,
) -> Option<[f64; SPEEDS]> {
    let texts = &editor.texts().speed_window;
    let mut new = None;
    ui.spacing_mut().item_spacing.x = theme::GAP;
    let names = [texts.copy, texts.paste, texts.reset];
    row_at_right(ui, &names, 0.0, |ui| {
        let button = |ui: &mut Ui, enabled, name: &str, hint: &str| {
            ui.add_enabled(enabled, egui::Button::new(name))
                .on_hover_text(hint)
                .clicked()
        };
        if button(ui, true, texts.copy, texts.copy_hint) {
            actions.push(Action::CopySpeeds(section.speeds));
        }
        let known = editor.windows.copied_speeds;
        if button(ui, known.is_some(), texts.paste, texts.paste_hint) {
            new = known;
        }
        if button(ui, true, texts.reset, texts.reset_hint) {
            new = Some([BASE_SPEED; SPEEDS]);
        }
    });
    new
}

/// Hold and frame rate.
fn numbers(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP * 2.0;
        ui.label(texts.hold).on_hover_text(texts.hold_hint);
        let number = Number::new(texts.hold, f64::from(section.hold))
            .hint(texts.hold_hint)
            .decimals(0)
            .whole()
            .range(0.0..=f64::from(MAX_HOLD))
            .steps(1.0, 0.5);
        let entry = number.show(ui, editor.language(), "speed.hold", 72.0);
        actions.extend(entered(editor, entry, |orientation, value| {
            // In range and whole: the number saw to that.
            orientation.hold = value.round() as u32;
        }));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let fps = editor.document.info().fps;
            let number = Number::new(texts.fps, fps)
                .hint(texts.fps_hint)
                .decimals(if fps.fract() == 0.0 { 0 } else { 3 })
                .range(0.001..=MAX_FPS)
                .steps(1.0, 0.5);
            let entry = number.show(ui, editor.language(), "speed.fps", 80.0);
            let info = editor.document.info().clone();
            let entry = entry.map(|fps| Edit::SetInfo(Box::new(Info { fps, ..info })));
            actions.push(Action::Enter(entry));
            ui.label(texts.fps).on_hover_text(texts.fps_hint);
        });
    });
}

/// How many frames each kind of change takes at speed 50, for the whole path.
fn base_speeds(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    type Part = fn(&mut BaseSpeeds) -> &mut f64;
    let texts = &editor.texts().speed_window;
    let speeds = editor.document.path().speeds;
    let parts: [(&str, &str, Part); 4] = [
        (texts.base_move, texts.base_move_hint, |speeds| {
            &mut speeds.movement
        }),
        (texts.base_turn, texts.base_turn_hint, |speeds| {
            &mut speeds.turning
        }),
        (texts.base_zoom, texts.base_zoom_hint, |speeds| {
            &mut speeds.zoom
        }),
        (texts.base_roll, texts.base_roll_hint, |speeds| {
            &mut speeds.rolling
        }),
    ];
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        ui.label(texts.base).on_hover_text(texts.base_hint);
        let gaps = theme::GAP * (parts.len() - 1) as f32;
        let width = ((ui.available_width() - gaps) / parts.len() as f32).floor();
        for (name, hint, part) in parts {
            let mut now = speeds;
            let frames = *part(&mut now);
            let full = format!("{}: {name}", texts.base);
            let entry = Number::new(&full, frames)
                .label(name)
                .hint(hint)
                .decimals(if frames.fract() == 0.0 { 0 } else { 3 })
                .range(0.001..=MAX_FRAMES as f64)
                .steps(1.0, 0.5)
                // Where they are the host's no file changes them, nor anybody here.
                .fixed_if(editor.fixed_speeds)
                .show(ui, editor.language(), &format!("speed.base.{name}"), width);
            let entry = entry.map(|frames| {
                let mut speeds = speeds;
                *part(&mut speeds) = frames;
                Edit::SetSpeeds(speeds)
            });
            actions.push(Action::Enter(entry));
        }
    });
}

/// What was entered into a number of the current orientation.
fn entered(
    editor: &Editor,
    entry: Entry,
    change: impl FnOnce(&mut Orientation, f64),
) -> Option<Action> {
    let at = editor.document.selection();
    let mut orientation = editor.orientation()?.clone();
    Some(Action::Enter(entry.map(|value| {
        change(&mut orientation, value);
        Edit::SetOrientation {
            point: at.point,
            at: at.orientation,
            orientation,
        }
    })))
}

/// Gives one of the ten speeds another value.
fn set_speed(editor: &Editor, at: usize, speed: f64) -> Option<Action> {
    let speed = speed.clamp(MIN_SPEED, MAX_SPEED);
    let edit = editor.orientation_edit(|orientation| {
        if let Some(old) = orientation.speeds.get_mut(at) {
            *old = speed;
        }
    });
    edit.map(Action::Edit)
}

#[cfg(test)]
mod tests;
