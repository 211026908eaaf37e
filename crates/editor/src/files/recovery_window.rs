//! Unsaved work that was left behind, offered beside the work: nothing waits for an answer.

use std::time::{Duration, SystemTime};

use egui::{Button, Ui, Vec2, vec2};

use crate::action::{Action, FileAction};
use crate::files::recovery::Found;
use crate::files::{picture, short};
use crate::host::program::Date;
use crate::state::Editor;
use crate::state::files::{Offered, Picture, RecoveryWindow};
use crate::state::windows::Windows;
use crate::texts::{Language, fill};
use crate::theme;
use crate::windows::sub_window::{SubWindow, sub_window_as};

/// How many are listed; the others come at later starts.
const LISTED: usize = 6;
/// How many are seen at once.
const SEEN: usize = 2;
const WIDTH: f32 = 420.0;
const PICTURE: Vec2 = vec2(84.0, 64.0);
const BUTTON: Vec2 = vec2(120.0, 28.0);
/// Its upper left corner from the window's at first: below the bar, right of the list of points,
/// where nothing to begin with lies.
const CORNER: Vec2 = vec2(156.0, 64.0);

/// An action, or `None`: nothing before the next start.
type Answer = Option<Action>;

impl RecoveryWindow {
    pub(crate) fn of(mut found: Vec<Found>) -> Self {
        found.truncate(LISTED);
        let offered = found.into_iter().map(|found| Offered {
            picture: found
                .document()
                .ok()
                .map(|document| Picture::of(&document, PICTURE)),
            found,
            goes: false,
        });
        Self {
            offered: offered.collect(),
        }
    }

    /// Takes out what is offered under this number.
    pub(crate) fn found(&mut self, number: usize) -> Option<Found> {
        let is_there = number < self.offered.len();
        is_there.then(|| self.offered.remove(number).found)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.offered.is_empty()
    }

    fn show_list(&mut self, editor: &Editor, ui: &mut Ui) -> Option<Answer> {
        let texts = &editor.texts().recovery;
        let palette = theme::palette(ui);
        let mut answer = None;
        for (index, offered) in self.offered.iter_mut().enumerate() {
            ui.horizontal(|ui| {
                picture::show(editor, ui, PICTURE, offered.picture.as_ref());
                ui.vertical(|ui| {
                    let gap = ui.spacing().item_spacing.x;
                    ui.set_width(ui.available_width() - BUTTON.x - gap);
                    describe(editor, ui, &offered.found);
                });
                let size = vec2(BUTTON.x, PICTURE.y);
                let column = egui::Layout::top_down_justified(egui::Align::Center);
                ui.allocate_ui_with_layout(size, column, |ui| {
                    let button = |text| Button::new(text).min_size(BUTTON);
                    let restore = ui.add(button(texts.restore));
                    if restore.on_hover_text(texts.restore_hint).clicked() {
                        answer = Some(Some(Action::File(FileAction::Restore(index))));
                    }
                    let words = match offered.goes {
                        true => egui::RichText::new(texts.discard_now).color(palette.error),
                        false => egui::RichText::new(texts.discard),
                    };
                    let discard = ui.add(Button::new(words).min_size(BUTTON));
                    if discard.on_hover_text(texts.discard_hint).clicked() {
                        let goes = std::mem::replace(&mut offered.goes, true);
                        answer = goes.then_some(Some(Action::File(FileAction::Discard(index))));
                    }
                });
            });
        }
        answer
    }
}

impl SubWindow for RecoveryWindow {
    const ID: &'static str = "rescue";

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.recovery
    }

    fn new(_: &Editor) -> Self {
        Self::of(Vec::new())
    }

    fn show(
        &mut self,
        editor: &Editor,
        context: &egui::Context,
        actions: &mut Vec<Action>,
    ) -> bool {
        let texts = &editor.texts().recovery;
        let mut answer = None;
        let corner = context.content_rect().left_top() + CORNER;
        let stays = sub_window_as(
            context,
            Self::ID,
            texts.title,
            // Without a size it opens so wide that it is moved from its place.
            |window| window.default_pos(corner).default_size([WIDTH, PICTURE.y]),
            |ui| {
                ui.set_width(WIDTH);
                ui.label(texts.question);
                ui.add_space(4.0);
                let rows = self.offered.len().min(SEEN) as f32;
                let height = rows * (PICTURE.y + ui.spacing().item_spacing.y);
                let list = egui::ScrollArea::vertical().max_height(height);
                answer = list.show(ui, |ui| self.show_list(editor, ui)).inner;
                ui.add_space(4.0);
                ui.horizontal(|ui| {
                    ui.add_space(ui.available_width() - BUTTON.x);
                    let later = ui.add(Button::new(texts.later).min_size(BUTTON));
                    if later.on_hover_text(texts.later_hint).clicked() {
                        answer = Some(None);
                    }
                });
            },
        );
        match answer {
            None => stays,
            // What is not answered stays for the next start.
            Some(None) => false,
            Some(Some(action)) => {
                actions.push(action);
                true
            }
        }
    }
}

fn describe(editor: &Editor, ui: &mut Ui, found: &Found) {
    ui.spacing_mut().item_spacing.y = 2.0;
    let name = found
        .original
        .as_deref()
        .map_or_else(|| editor.texts().questions.this_path.to_owned(), short);
    let label = ui.add(egui::Label::new(name).truncate());
    if let Some(original) = &found.original {
        label.on_hover_text(original.display().to_string());
    }
    let weak = theme::palette(ui).weak;
    let line = |ui: &mut Ui, text: String| {
        let text = egui::RichText::new(text).color(weak).font(theme::small());
        ui.add(egui::Label::new(text).truncate());
    };
    if let Some(program) = &found.program {
        line(ui, program.clone());
    }
    let age = SystemTime::now().duration_since(found.written);
    let age = age_in_words(editor.language(), age.unwrap_or(Duration::ZERO));
    match (editor.program.local_time)(found.written) {
        Some(date) => {
            line(ui, date_in_words(editor.language(), date));
            line(ui, age);
        }
        None => line(ui, age),
    }
}

pub(super) fn date_in_words(language: Language, date: Date) -> String {
    let two = |number: i32| format!("{number:02}");
    let text = language.texts().recovery.date;
    let (month, day) = (two(date.month), two(date.day));
    let (hour, minute) = (two(date.hour), two(date.minute));
    fill(text, &[&date.year, &month, &day, &hour, &minute])
}

fn age_in_words(language: Language, age: Duration) -> String {
    let texts = &language.texts().recovery;
    let minutes = age.as_secs() / 60;
    match minutes {
        0 => texts.just_now.to_owned(),
        1..120 => fill(texts.minutes, &[&minutes]),
        120..2880 => fill(texts.hours, &[&(minutes / 60)]),
        _ => fill(texts.days, &[&(minutes / 1440)]),
    }
}
