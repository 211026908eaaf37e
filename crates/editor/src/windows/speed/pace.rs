//! The pace of a section. When another is chosen, the section lasts as long as before, if possible.

use std::sync::Arc;

use egui::{Button, Ui};
use vides_document::Selection;
use vides_engine::limits::{BASE_SPEED, MAX_SPEED, MIN_SPEED};
use vides_engine::path::{Ease, EaseKind, Pace};

use super::distance::sampled;
use crate::action::Action;
use crate::state::Editor;
use crate::state::windows::{Quantity, SpeedWindow};
use crate::theme;
use crate::windows::speed::section::Section;

/// The initial shares of the time for speeding up and slowing down.
const SHARE: f64 = 0.25;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Also a part of another pace, which its ten speeds are near.
    Ten,
    Ease(EaseKind),
    Distance,
}

impl Kind {
    fn of(pace: &Pace) -> Self {
        match pace {
            Pace::Speeds | Pace::Part(_) => Self::Ten,
            Pace::Ease(ease) => Self::Ease(ease.kind),
            Pace::Distance(_) => Self::Distance,
        }
    }

    /// Such a pace with about this mean speed.
    fn pace(self, section: &Section, mean: f64) -> Pace {
        let kind = match self {
            Self::Ten => return Pace::Speeds,
            Self::Distance => return Pace::Distance(Arc::from(sampled(&section.timing))),
            Self::Ease(kind) => kind,
        };
        let (rise, fall) = match section.pace {
            Pace::Ease(ease) => (ease.rise, ease.fall),
            _ => (SHARE, SHARE),
        };
        let mut ease = Ease {
            kind,
            rise,
            fall,
            cruise: 1.0,
        };
        let cruise = mean / ease.mean();
        ease.cruise = (cruise * 10.0).round() / 10.0;
        ease.cruise = ease.cruise.clamp(MIN_SPEED, MAX_SPEED);
        Pace::Ease(ease)
    }
}

impl SpeedWindow {
    /// Which pace the section has, and what the picture shows.
    pub(super) fn choices(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        section: &Section,
        actions: &mut Vec<Action>,
    ) {
        let texts = &editor.texts().speed_window;
        let kinds = [
            (Kind::Ten, texts.ten, texts.ten_hint),
            (Kind::Ease(EaseKind::Sine), texts.sine, texts.sine_hint),
            (
                Kind::Ease(EaseKind::Parabolic),
                texts.parabolic,
                texts.parabolic_hint,
            ),
            (Kind::Distance, texts.distance, texts.distance_hint),
        ];
        let now = Kind::of(&section.pace);
        if let Some(kind) = one_of(ui, texts.pace, now, kinds) {
            actions.extend(self.choose_pace(editor, section, kind));
        }
        let names = [
            (texts.graph_speed, texts.graph_speed_hint),
            (texts.graph_distance, texts.graph_distance_hint),
            (texts.graph_acceleration, texts.graph_acceleration_hint),
        ];
        let mut names = names.into_iter();
        let quantities = Quantity::ALL.map(|quantity| {
            let (name, hint) = names.next().unwrap_or_default();
            (quantity, name, hint)
        });
        if let Some(quantity) = one_of(ui, texts.graph, self.shown, quantities) {
            self.shown = quantity;
        }
    }

    fn choose_pace(&mut self, editor: &Editor, section: &Section, kind: Kind) -> Option<Action> {
        let at = editor.document.selection();
        let mine = |fixed: &(Selection, u32)| *fixed == (at, section.fixed);
        let unfixes = self.fixed.take().filter(mine).is_some();
        // A given distance has no speed of its own: only its frames say how long it takes.
        let fixes = kind == Kind::Distance
            && section.fixed == 0
            && editor.several().is_none()
            && (section.timing.mean() - BASE_SPEED).abs() > 1e-9;
        let frames = match section.frames.and_then(|frames| u32::try_from(frames).ok()) {
            Some(frames) if fixes && frames > 0 => {
                self.fixed = Some((at, frames));
                frames
            }
            _ if unfixes => 0,
            _ => section.fixed,
        };
        match kind {
            Kind::Ten => self.shown = Quantity::Speed,
            Kind::Ease(_) => {}
            Kind::Distance => self.shown = Quantity::Distance,
        }
        // The shown speeds are real ones where the length decides the number of frames.
        let scale = if unfixes { section.scale } else { 1.0 };
        let mean = section.timing.mean() * scale;
        editor.own_action(|own| {
            own.pace = kind.pace(section, mean);
            own.frames = frames;
        })
    }
}

/// A row of choices; returns the one that was clicked, if it is another.
fn one_of<T: Copy + PartialEq, const N: usize>(
    ui: &mut Ui,
    title: &str,
    now: T,
    all: [(T, &str, &str); N],
) -> Option<T> {
    let mut clicked = None;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        theme::label(ui, 48.0, title);
        for (value, name, hint) in all {
            let chosen = value == now;
            let button = ui.add(Button::selectable(chosen, name).frame_when_inactive(true));
            button.widget_info(|| {
                let name = format!("{title}: {name}");
                egui::WidgetInfo::selected(egui::Role::RadioButton, true, chosen, name)
            });
            if button.on_hover_text(hint).clicked() && !chosen {
                clicked = Some(value);
            }
        }
    });
    clicked
}
