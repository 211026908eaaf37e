//! Zoom and field of view of the current orientation (thesis A.4.4).

use egui::{Grid, Popup, PopupCloseBehavior, Response, Slider, SliderClamping, Ui};
use vides_engine::limits::{MAX_LIST_ZOOM, MAX_ZOOM, MIN_ZOOM};
use vides_engine::math::view::HALF_FILM_HEIGHT;

use super::orientation::own;
use crate::action::{Action, OwnedMotion};
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::Heading;
use crate::setup::{Fold, MAX_SENSOR, MIN_SENSOR};
use crate::state::{Editor, with};

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
    let lens = current.zoom * of_sensor(editor);
    let mut words = format!("{}°", language.number(angle, 1));
    if lens != current.zoom {
        words += &format!(" · {} mm", language.number(lens, 1));
    }
    let edit = |zoom| with(selection, &current, |new| new.zoom = zoom);
    let heading = Heading {
        editor,
        fold: Fold::Lens,
        text: texts.heading,
        remark: &words,
    };
    let (open, [row, choice]) = heading.choice(ui, texts.sensor, actions);
    row.on_hover_text(texts.angle_hint);
    if let Some(entry) = sensor(editor, &choice, lens, actions) {
        actions.push(Action::enter(missing, entry.map(edit)));
    }
    choice.on_hover_text(texts.sensor_hint);
    if !open {
        return;
    }
    ui.horizontal(|ui| {
        let gap = ui.spacing().item_spacing.x;
        let room = if owns { OWN + gap } else { 0.0 };
        ui.spacing_mut().slider_width = super::WIDTH - FIELD - gap - room;
        let mut zoom = current.zoom;
        // Longer lenses are typed; such a value stands at the end, and stays.
        let slider = Slider::new(&mut zoom, MIN_ZOOM..=MAX_LIST_ZOOM)
            .clamping(SliderClamping::Never)
            .show_value(false)
            .step_by(0.5);
        let response = ui.add(slider).on_hover_text(texts.hint);
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_label(texts.slider);
        });
        if response.drag_started() {
            actions.push(Action::enter(missing, Entry::Begin));
        }
        if response.changed() {
            let missing = missing && !response.drag_started();
            let entry = match response.dragged() {
                true => Entry::Drag(edit(zoom)),
                false => Entry::Set(edit(zoom)),
            };
            actions.push(Action::enter(missing, entry));
        }
        if response.drag_stopped() {
            actions.push(Action::Enter(Entry::End));
        }
        let entry = Number::new(texts.value, current.zoom)
            .of_view("zoom_mm")
            .hint(texts.hint)
            .faint(missing)
            .show(ui, language, "zoom", FIELD);
        actions.push(Action::enter(missing, entry.map(edit)));
        if owns {
            ui.spacing_mut().button_padding.x = 0.0;
            own(editor, ui, OwnedMotion::Zoom, OWN, actions);
        }
    });
}

/// The focal length that a sensor of the chosen height needs, by that for a picture of 24 mm.
fn of_sensor(editor: &Editor) -> f64 {
    editor.setup.sensor_height / (2.0 * HALF_FILM_HEIGHT)
}

/// The menu with the height of another sensor and the lens that sees the same on it; the zoom that
/// was entered by that.
fn sensor(
    editor: &Editor,
    choice: &Response,
    lens: f64,
    actions: &mut Vec<Action>,
) -> Option<Entry> {
    let (texts, language) = (&editor.texts().zoom, editor.language());
    let scale = of_sensor(editor);
    let menu = Popup::menu(choice).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let shown = menu.show(|ui| {
        let rows = Grid::new("sensor").num_columns(2).show(ui, |ui| {
            ui.label(texts.sensor);
            let height = Number::new(texts.sensor, editor.setup.sensor_height)
                .hint(texts.sensor_hint)
                .decimals(2)
                .unit(" mm")
                .range(MIN_SENSOR..=MAX_SENSOR)
                .steps(1.0, 0.1)
                .typed()
                .show(ui, language, "sensor", 2.0 * FIELD);
            match height {
                Entry::Set(height) => actions.push(Action::SensorHeight(height)),
                Entry::Wrong(words) => actions.push(Action::Complain(words)),
                _ => {}
            }
            ui.end_row();
            ui.label(texts.lens);
            Number::new(texts.lens, lens)
                .hint(texts.lens_hint)
                .decimals(1)
                .unit(" mm")
                .range(MIN_ZOOM * scale..=MAX_ZOOM * scale)
                .steps(1.0, 0.2)
                .typed()
                .show(ui, language, "lens", 2.0 * FIELD)
        });
        rows.inner
    });
    // Rounding must not lead beyond an end.
    let zoom = |lens: f64| (lens / scale).clamp(MIN_ZOOM, MAX_ZOOM);
    shown.map(|shown| shown.inner.map(zoom))
}
