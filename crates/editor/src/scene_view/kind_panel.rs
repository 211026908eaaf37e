//! The panel of what a node's kind has: lens, light, colour and mesh; and the values that only the
//! host knows how to use.

use std::path::Path;

use egui::{Button, CornerRadius, Rect, Rgba, Stroke, StrokeKind, Ui, vec2};
use vides_engine::limits::MAX_COORDINATE;
use vides_engine::scene::{Camera, Channel, Kind, Light, Object, Rest};

use super::keys_panel::{Shown, Words, channel, indent};
use super::list_row;
use super::node_panel::{enter_rest, rest_edit};
use crate::action::Action;
use crate::files::short;
use crate::number::Number;
use crate::panels::parts::{Heading, PanelButton, apart, button_row, share};
use crate::setup::Fold;
use crate::state::Editor;
use crate::state::files::Purpose;
use crate::state::scene_view::NodeAction;
use crate::texts::fill;
use crate::theme;

pub(super) fn show(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let has_values = values(of).next().is_some();
    if matches!(of.node.kind, Kind::Group) && !has_values {
        return;
    }
    apart(ui);
    let name = match of.node.kind {
        Kind::Group => editor.texts().node.values.to_owned(),
        _ => capital(list_row::kind(editor, of.node)),
    };
    let heading = Heading {
        editor,
        fold: Fold::Kind,
        text: &name,
        remark: "",
    };
    if !heading.show(ui, actions).0 {
        return;
    }
    match &of.node.kind {
        Kind::Group => {}
        Kind::Camera(planes) => camera(editor, ui, of, *planes, actions),
        Kind::Light(kind) => light(editor, ui, of, *kind, actions),
        Kind::Object(object) => {
            colour(editor, ui, of, actions);
            mesh(editor, ui, of, object, actions);
        }
    }
    for value in values(of) {
        let Channel::Value { name, .. } = value else {
            continue;
        };
        let words = Words::new(name, editor.texts().node.value_hint);
        channel(editor, ui, of, value, words, actions);
    }
}

/// Words that begin a heading.
fn capital(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).collect()
}

/// The channels of the host's own.
fn values<'a>(of: Shown<'a>) -> impl Iterator<Item = &'a Channel> {
    let channels = of.node.keys().tracks().iter().map(|track| track.channel());
    channels.filter(|channel| matches!(channel, Channel::Value { .. }))
}

fn camera(editor: &Editor, ui: &mut Ui, of: Shown<'_>, planes: Camera, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let zoom = Words::new(texts.zoom, texts.zoom_hint);
    channel(editor, ui, of, &Channel::Zoom, zoom, actions);
    let roll = Words::new(texts.camera_roll, texts.camera_roll_hint);
    channel(editor, ui, of, &Channel::Roll, roll, actions);
    for (name, hint, value, is_far) in [
        (texts.near, texts.near_hint, planes.near, false),
        (texts.far, texts.far_hint, planes.far, true),
    ] {
        ui.horizontal(|ui| {
            indent(ui);
            let id = format!("{}.{}", of.at, if is_far { "far" } else { "near" });
            // By a hundredth of what it is, since these span many powers of ten.
            let entry = Number::new(name, value)
                .label(name)
                .hint(hint)
                .decimals(3)
                .range(0.0..=MAX_COORDINATE)
                .steps(0.01 * value, 0.01 * value)
                .show(ui, editor.language(), &id, ui.available_width());
            enter_rest(of, entry, actions, |rest: &mut Rest, value| {
                rest.kind = Kind::Camera(match is_far {
                    true => Camera {
                        far: value,
                        ..planes
                    },
                    false => Camera {
                        near: value,
                        ..planes
                    },
                });
            });
        });
    }
}

fn light(editor: &Editor, ui: &mut Ui, of: Shown<'_>, kind: Light, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let choice = |light: Light, text, hint| {
        let mut rest = Rest::of(of.node);
        rest.kind = Kind::Light(light);
        let action = Action::Edits(vec![rest_edit(of, rest)]);
        PanelButton::new(text, hint, action).chosen(light == kind)
    };
    let all = [
        choice(
            Light::Directional,
            texts.directional,
            texts.directional_hint,
        ),
        choice(Light::Point, texts.point, texts.point_hint),
        choice(Light::Spot, texts.spot, texts.spot_hint),
    ];
    button_row(editor, ui, &all, actions);
    colour(editor, ui, of, actions);
    let words = Words::new(texts.intensity, texts.intensity_hint);
    channel(editor, ui, of, &Channel::Intensity, words, actions);
    if kind == Light::Spot {
        let parts = [(texts.inner, ""), (texts.outer, "")];
        let words = Words::new(texts.cone, texts.cone_hint).of(&parts);
        channel(editor, ui, of, &Channel::Cone, words, actions);
    }
}

fn colour(editor: &Editor, ui: &mut Ui, of: Shown<'_>, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let parts = [
        (texts.red, texts.red),
        (texts.green, texts.green),
        (texts.blue, texts.blue),
    ];
    let words = Words::new(texts.colour, texts.colour_hint).of(&parts);
    let row = ui.cursor().min;
    channel(editor, ui, of, &Channel::Colour, words, actions);
    if let Some(&[r, g, b]) = editor.channel_value(of.at, &Channel::Colour).as_deref() {
        let size = vec2(24.0, 14.0);
        let right = row.x + ui.available_width();
        let place = egui::pos2(right - size.x, row.y + (theme::ROW - size.y) / 2.0);
        #[allow(clippy::cast_possible_truncation)]
        let [r, g, b] = [r, g, b].map(|part| part.min(1.0) as f32);
        ui.painter().rect(
            Rect::from_min_size(place, size),
            CornerRadius::same(3),
            Rgba::from_rgb(r, g, b),
            Stroke::new(1.0, theme::palette(ui).rim),
            StrokeKind::Inside,
        );
    }
}

/// The mesh: where it comes from, how large it is, another one.
fn mesh(editor: &Editor, ui: &mut Ui, of: Shown<'_>, object: &Object, actions: &mut Vec<Action>) {
    let texts = &editor.texts().node;
    let missing = editor.missing_mesh(Some(of.at)).is_some();
    let points = match missing {
        true => texts.mesh_missing.to_owned(),
        false => fill(texts.mesh_points, &[&object.mesh().points.len()]),
    };
    let name = match object.source() {
        Some(source) => format!("{} · {points}", short(Path::new(&source.file))),
        None => points,
    };
    let label = egui::Label::new(fill(texts.mesh, &[&name])).truncate();
    let label = ui.add(label);
    if let Some(source) = object.source() {
        label.on_hover_text(&source.file);
    }
    ui.horizontal(|ui| {
        let width = share(ui, 2);
        let size = vec2(width, theme::ROW);
        let (word, hint) = match missing {
            true => (texts.find, texts.find_hint),
            false => (texts.load, texts.load_mesh_hint),
        };
        let load = ui.add_sized(size, Button::new(word));
        if load.on_hover_text(hint).clicked() {
            let ask = NodeAction::AskFile(Purpose::LoadMesh(of.at));
            actions.push(Action::Node(ask));
        }
        let from_file = object.source().is_some();
        let reload = Button::new(texts.reload).min_size(size);
        let reload = ui.add_enabled(from_file, reload);
        let reload = reload.on_disabled_hover_text(texts.no_mesh_file);
        if reload.on_hover_text(texts.reload_hint).clicked() {
            actions.push(Action::Node(NodeAction::Reload(of.at)));
        }
    });
}
