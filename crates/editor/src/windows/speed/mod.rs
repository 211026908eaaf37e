//! The speed curve of the current section, large (thesis A.4.3): ten squares to be dragged up and
//! down, the facing values of the sections before and after, the curve. Or an ease or a given
//! distance in place of the ten speeds, and way or acceleration in place of the speed.

use egui::{Rect, Sense, Ui, vec2};

use crate::state::windows::SpeedWindow;
use crate::windows::speed::section::{ABOUT, Section, Size};

mod distance;
mod ease;
mod graph;
pub(crate) mod join;
mod pace;
pub(crate) mod section;
mod shapes;
mod ten;

pub(crate) use self::ten::shapes;

use self::graph::Axes;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::share;
use crate::state::Editor;
use crate::state::windows::{Quantity, Windows};
use crate::texts::fill;
use crate::theme;
use crate::windows::dock::docked;
use crate::windows::sub_window::SubWindow;
use vides_document::{At, Edit, Info};
use vides_engine::limits::{MAX_FPS, MAX_FRAMES};
use vides_engine::path::{BaseFrames, Pace};

/// Minimum width of the part right of the picture, and the gap.
const BESIDE: f32 = 236.0;
const APART: f32 = 16.0;

impl SubWindow for SpeedWindow {
    const ID: &'static str = "speed";
    const DOCKED: bool = true;

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.speed
    }

    fn new(editor: &Editor) -> Self {
        let pace = editor.orientation().map(|current| &current.own.pace);
        Self {
            // Where there is something to drag.
            shown: match pace {
                Some(Pace::Distance(_)) => Quantity::Distance,
                _ => Quantity::Speed,
            },
            held: None,
            choose: None,
            key: 1,
            removed: None,
            fixed: None,
        }
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().speed_window;
        let section = Section::of(editor).filter(|_| editor.document.edits_path());
        let Some(section) = section else {
            return false;
        };
        let named = (Self::ID, texts.title);
        let end = docked(editor, context, named, None, |ui| {
            let width = Size::of(ui.ctx()).width();
            if ui.available_width() < width + BESIDE {
                self.course(editor, ui, &section, actions);
                self.terms(editor, ui, &section, actions);
                return;
            }
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = APART;
                ui.vertical(|ui| {
                    ui.set_width(width);
                    self.course(editor, ui, &section, actions);
                });
                ui.vertical(|ui| self.terms(editor, ui, &section, actions));
            });
        });
        end.is_none()
    }
}

/// How high the window is in this room, of which it leaves the larger part.
pub(super) fn height(context: &egui::Context, room: Rect) -> f32 {
    let size = Size::of(context);
    let rows = if size.one_row { 2.0 } else { 3.0 };
    let all = ABOUT + size.height + rows * (theme::ROW + theme::GAP);
    all.min(0.6 * room.height()).round()
}

/// Which section it is, and how long it takes.
fn heading(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    let at = editor.document.selection();
    let palette = theme::palette(ui);
    let from = editor.name_of(at.point, at.orientation);
    let text = match section.to {
        Some((point, orientation)) => {
            fill(texts.section, &[&from, &editor.name_of(point, orientation)])
        }
        None => fill(texts.end_of_path, &[&from]),
    };
    ui.label(text);
    match section.frames {
        None => {}
        Some(0) => {
            ui.colored_label(palette.weak, texts.nothing_changes);
        }
        Some(frames) => length(editor, ui, section, frames, actions),
    }
}

/// Its length: frames, seconds, locked or not.
fn length(
    editor: &Editor,
    ui: &mut Ui,
    section: &Section,
    frames: usize,
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().speed_window;
    let mut narrow = false;
    ui.horizontal(|ui| {
        ui.label(texts.frames).on_hover_text(texts.frames_hint);
        let entry = Number::new(texts.frames, frames as f64)
            .hint(texts.frames_hint)
            .faint(section.fixed == 0)
            .of_view("frames")
            .show(ui, editor.language(), "speed.frames", 72.0);
        actions.extend(editor.entered(entry, "frames"));
        let fps = editor.document.info().fps;
        let seconds = editor.language().number(frames as f64 / fps, 2);
        ui.colored_label(theme::palette(ui).weak, fill(texts.seconds, &[&seconds]));
        if ui.available_width() > BESIDE / 2.0 {
            lock(editor, ui, section, actions);
        } else {
            narrow = true;
        }
    });
    if narrow {
        lock(editor, ui, section, actions);
    }
}

/// Whether it keeps its frames when the whole path gets others.
fn lock(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    let mut locked = section.locked;
    let tick = theme::tick(ui, &mut locked, texts.locked);
    if tick.on_hover_text(texts.locked_hint).changed() {
        actions.extend(editor.own_action(|own| own.locked = locked));
    }
}

impl SpeedWindow {
    /// The curve, and what belongs to it.
    fn course(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        self.picture(editor, ui, section, actions);
        self.values(editor, ui, section, actions);
    }

    /// What else there is of the section and of the path.
    fn terms(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        heading(editor, ui, section, actions);
        self.choices(editor, ui, section, actions);
        numbers(editor, ui, section, actions);
        base_speeds(editor, ui, actions);
    }

    /// The curve with its handles.
    fn picture(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        let size = Size::of(ui.ctx());
        let (rect, _) = ui.allocate_exact_size(vec2(size.width(), size.height), Sense::hover());
        let axes = Axes::new(rect, size.step, self.shown, section);
        axes.paint(
            editor,
            &ui.painter().with_clip_rect(rect.expand(1.0)),
            section,
        );
        match (&section.pace, self.shown) {
            (Pace::Speeds | Pace::Part(_), _) => {
                let state = (&mut self.held, &mut self.choose);
                ten::squares(editor, state, ui, &axes, section, actions);
            }
            (Pace::Ease(ease), shown) => {
                let what = (section, *ease);
                ease::corners(editor, &mut self.held, ui, (&axes, shown), what, actions);
            }
            (Pace::Distance(keys), Quantity::Distance) => {
                self.keys(editor, ui, &axes, (section, keys), actions);
            }
            _ => {}
        }
    }

    /// The same as numbers.
    fn values(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        match &section.pace {
            Pace::Speeds | Pace::Part(_) => {
                ten::typed(editor, ui, section, actions);
                ui.add_space(theme::GAP);
                ten::buttons(editor, ui, section, actions);
            }
            Pace::Ease(ease) => ease::typed(editor, ui, *ease, actions),
            Pace::Distance(keys) => self.key_numbers(editor, ui, (section, keys), actions),
        }
    }
}

fn numbers(editor: &Editor, ui: &mut Ui, section: &Section, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    ui.horizontal(|ui| {
        ui.label(texts.hold).on_hover_text(texts.hold_hint);
        let number = Number::new(texts.hold, f64::from(section.hold))
            .hint(texts.hold_hint)
            .of_view("hold_frames");
        let entry = number.show(ui, editor.language(), "speed.hold", 72.0);
        actions.extend(editor.entered(entry, "hold_frames"));
    });
    ui.horizontal(|ui| {
        ui.label(texts.fps).on_hover_text(texts.fps_hint);
        let fps = editor.document.info().fps;
        let number = Number::new(texts.fps, fps)
            .hint(texts.fps_hint)
            .decimals(if fps.fract() == 0.0 { 0 } else { 3 })
            .range(0.001..=MAX_FPS)
            .steps(1.0, 0.5);
        // Where times are fixed keys keep their seconds; else they keep their frames.
        let fixed = editor.times_are_fixed();
        let number = if fixed { number.typed() } else { number };
        let entry = number.show(ui, editor.language(), "speed.fps", 72.0);
        let info = editor.document.info().clone();
        actions.push(match entry {
            Entry::Set(fps) if fixed => Action::Time(TimeAction::Rate(fps)),
            entry => Action::Enter(entry.map(|fps| Edit::SetInfo(Box::new(Info { fps, ..info })))),
        });
    });
}

/// The frames that each kind of change takes at speed 50, for the whole path.
fn base_speeds(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().speed_window;
    let speeds = editor.document.path().base_frames;
    let words = [
        (texts.base_move, texts.base_move_hint),
        (texts.base_turn, texts.base_turn_hint),
        (texts.base_zoom, texts.base_zoom_hint),
        (texts.base_roll, texts.base_roll_hint),
    ];
    ui.label(texts.base).on_hover_text(texts.base_hint);
    let beside = if ui.available_width() < 2.0 * BESIDE {
        2
    } else {
        words.len()
    };
    let width = share(ui, beside);
    ui.horizontal_wrapped(|ui| {
        for (row, (name, hint)) in BaseFrames::PROPERTIES.iter().zip(words) {
            let frames = (row.value)(&speeds).number().unwrap_or_default();
            let full = format!("{}: {name}", texts.base);
            let entry = Number::new(&full, frames)
                .label(name)
                .hint(hint)
                .decimals(if frames.fract() == 0.0 { 0 } else { 3 })
                .range(0.001..=MAX_FRAMES as f64)
                .steps(1.0, 0.5)
                // The host's base speeds are changed neither by files nor here.
                .fixed_if(editor.fixed_speeds)
                .show(ui, editor.language(), &format!("speed.base.{name}"), width);
            let entry = entry.map(|frames| {
                let mut speeds = speeds;
                row.set_number(&mut speeds, frames);
                Edit::set(At::Path, "base_speeds", speeds)
            });
            actions.push(Action::Enter(entry));
        }
    });
}

#[cfg(test)]
mod distance_tests;
#[cfg(test)]
mod pace_tests;
#[cfg(test)]
mod tests;
