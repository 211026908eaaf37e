//! The question what is to become of unsaved work that was left behind.

use std::time::{Duration, SystemTime};

use egui::{Align, Button, Key, Layout, Modifiers, vec2};

use super::{modal, row_at_right};
use crate::editor::filing::short;
use crate::editor::recovery::Found;
use crate::editor::refusals::reason_of;
use crate::editor::state::Editor;
use crate::editor::texts::{Language, fill};
use crate::editor::theme;

/// So many are listed; the others come at later starts.
const LISTED: usize = 6;

/// What was found, held for this window while the question stands.
#[derive(Debug)]
pub(in crate::editor) struct RescueWindow {
    found: Vec<Found>,
    fresh: bool,
}

#[derive(Clone, Copy)]
enum Answer {
    Restore(usize),
    Discard(usize),
    Later,
}

impl RescueWindow {
    pub(in crate::editor) fn new(mut found: Vec<Found>) -> Self {
        found.truncate(LISTED);
        Self { found, fresh: true }
    }

    /// Shows it; what was answered is done.
    pub(super) fn show(mut self, editor: &mut Editor, context: &egui::Context) {
        let texts = &editor.texts().rescue;
        let mut answer = None;
        modal(context, "rescue", texts.title, 480.0, |ui| {
            ui.label(texts.question);
            ui.add_space(8.0);
            let now = SystemTime::now();
            for (index, found) in self.found.iter().enumerate() {
                ui.horizontal(|ui| {
                    let name = found
                        .original
                        .as_deref()
                        .map_or_else(|| editor.texts().questions.this_path.to_owned(), short);
                    let age = now.duration_since(found.written).unwrap_or(Duration::ZERO);
                    ui.vertical(|ui| {
                        ui.set_width(220.0);
                        ui.spacing_mut().item_spacing.y = 0.0;
                        let label = ui.add(egui::Label::new(name).truncate());
                        if let Some(original) = &found.original {
                            label.on_hover_text(original.display().to_string());
                        }
                        let weak = theme::palette(ui).weak;
                        ui.colored_label(weak, age_in_words(editor.language(), age));
                    });
                    let size = vec2(104.0, 28.0);
                    row_at_right(ui, &[texts.restore, texts.discard], size.x, |ui| {
                        let restore = ui.add(Button::new(texts.restore).min_size(size));
                        if self.fresh && index == 0 {
                            restore.request_focus();
                        }
                        if restore.clicked() {
                            answer = Some(Answer::Restore(index));
                        }
                        if ui.add(Button::new(texts.discard).min_size(size)).clicked() {
                            answer = Some(Answer::Discard(index));
                        }
                    });
                });
                ui.add_space(4.0);
            }
            self.fresh = false;
            ui.add_space(8.0);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let later = ui.add(Button::new(texts.later).min_size(vec2(104.0, 28.0)));
                if later.on_hover_text(texts.later_hint).clicked() {
                    answer = Some(Answer::Later);
                }
            });
        });
        if context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape)) {
            answer = Some(Answer::Later);
        }
        match answer {
            // What is not answered stays where it is, for the next start.
            Some(Answer::Later) => return,
            Some(Answer::Restore(index)) => {
                let found = self.found.remove(index);
                match editor.restore(&found) {
                    Ok(()) => {
                        found.discard();
                        return;
                    }
                    Err(error) => {
                        let why = reason_of(editor.language(), &error);
                        editor.complain(fill(texts.broken, &[&why]));
                    }
                }
            }
            Some(Answer::Discard(index)) => self.found.remove(index).discard(),
            None => {}
        }
        if !self.found.is_empty() {
            editor.windows.rescue = Some(self);
        }
    }
}

fn age_in_words(language: Language, age: Duration) -> String {
    let texts = &language.texts().rescue;
    let minutes = age.as_secs() / 60;
    match minutes {
        0 => texts.just_now.to_owned(),
        1..120 => fill(texts.minutes, &[&minutes]),
        120..2880 => fill(texts.hours, &[&(minutes / 60)]),
        _ => fill(texts.days, &[&(minutes / 1440)]),
    }
}
