//! Zoom and field of view of the current orientation (thesis A.4.4).

use egui::{Slider, SliderClamping, Ui};

use super::heading;
use super::orientation::{OwnedMotion, own, with};
use crate::actions::Action;
use crate::limits::{MAX_ZOOM, MIN_ZOOM};
use crate::math::view::HALF_FILM_HEIGHT;
use crate::number::{Entry, Number};
use crate::state::Editor;

const FIELD: f32 = 56.0;

/// Width of the button that gives a slope back.
const OWN: f32 = 76.0;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().zoom;
    let language = editor.language();
    let Some(shown) = editor.shown() else {
        return;
    };
    let missing = shown.has_no_orientation();
    let owns = OwnedMotion::Zoom.is_owned(&shown);
    let (selection, current) = (shown.at, shown.orientation);
    let angle = 2.0 * (HALF_FILM_HEIGHT / current.zoom).atan().to_degrees();
    let words = format!("{}°", language.number(angle, 1));
    heading(ui, texts.heading, &words).on_hover_text(texts.angle_hint);
    ui.horizontal(|ui| {
        let gap = ui.spacing().item_spacing.x;
        let room = if owns { OWN + gap } else { 0.0 };
        ui.spacing_mut().slider_width = super::WIDTH - FIELD - gap - room;
        let mut zoom = current.zoom;
        let slider = Slider::new(&mut zoom, MIN_ZOOM..=MAX_ZOOM)
            .clamping(SliderClamping::Never)
            .show_value(false)
            .step_by(0.5);
        let response = ui.add(slider).on_hover_text(texts.hint);
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_label(texts.slider);
        });
        let edit = |zoom| with(selection, &current, |new| new.zoom = zoom);
        if response.drag_started() {
            actions.push(Action::enter(missing, Entry::Begin));
        }
        if response.changed() {
            let missing = missing && !response.drag_started();
            actions.push(Action::enter(missing, Entry::Drag(edit(zoom))));
        }
        if response.drag_stopped() {
            actions.push(Action::Enter(Entry::End));
        }
        let entry = Number::new(texts.value, current.zoom)
            .hint(texts.hint)
            .decimals(1)
            .faint(missing)
            .range(MIN_ZOOM..=MAX_ZOOM)
            .steps(1.0, 0.2)
            .show(ui, language, "zoom", FIELD);
        actions.push(Action::enter(missing, entry.map(edit)));
        if owns {
            ui.spacing_mut().button_padding.x = 0.0;
            own(editor, ui, OwnedMotion::Zoom, OWN, actions);
        }
    });
}
