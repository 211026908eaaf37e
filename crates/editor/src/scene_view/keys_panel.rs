//! A channel of a node as rows: a diamond for its keys, its name, its numbers.
//!
//! Diamonds are beside the numbers of the node's panels, not in a separate panel: what
//! moves is seen where it is changed, and nothing stands twice.

use egui::{Color32, Response, RichText, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2};
use glam::DQuat;
use vides_engine::scene::{Channel, Node};

use super::values::{KeyState, angles_of, path_moves};
use crate::action::Action;
use crate::entry::Entry;
use crate::number::Number;
use crate::panels::parts::share;
use crate::state::Editor;
use crate::state::scene_view::NodeAction;
use crate::texts::fill;
use crate::theme;

/// The width of a diamond's place.
pub(super) const DIAMOND: f32 = 18.0;

/// The second of the angles of a rotation.
const PITCH: usize = 1;

/// A node that is shown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shown<'a> {
    pub(super) at: usize,
    pub(super) node: &'a Node,
}

/// What a channel is called.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words<'a> {
    pub(super) name: &'a str,
    pub(super) hint: &'a str,
    /// Of several numbers: what each is called, and what of that stands in its field.
    pub(super) parts: &'a [(&'a str, &'a str)],
}

impl<'a> Words<'a> {
    pub(super) const fn new(name: &'a str, hint: &'a str) -> Self {
        Self {
            name,
            hint,
            parts: &[],
        }
    }

    pub(super) const fn of(self, parts: &'a [(&'a str, &'a str)]) -> Self {
        Self { parts, ..self }
    }
}

pub(super) const AXES: [(&str, &str); 3] = [("x", "x"), ("y", "y"), ("z", "z")];

/// Shows a channel: one number beside its name, several below it. A rotation is three angles.
pub(super) fn channel(
    editor: &Editor,
    ui: &mut Ui,
    of: Shown<'_>,
    channel: &Channel,
    words: Words<'_>,
    actions: &mut Vec<Action>,
) {
    let Some((value, is_turn)) = numbers(editor, of, channel) else {
        return;
    };
    let moved = path_moves(of.node, channel);
    let hint = match moved {
        true => editor.texts().node.by_its_path,
        false => words.hint,
    };
    let mut field = |ui: &mut Ui, at: usize, name: &str, label: &str, width: f32| {
        let id = format!("{}.{channel}.{at}", of.at);
        let mut number = Number::new(name, value[at])
            .label(label)
            .hint(hint)
            .of_channel(channel, editor.shown_space())
            .fixed_if(moved);
        if is_turn && at == PITCH {
            // Beyond, the same turn has other angles: those that are dragged would jump.
            number = number.range(-90.0..=90.0);
        }
        let entry = number.show(ui, editor.language(), &id, width);
        if entry != Entry::Idle {
            let turned = matches!(entry, Entry::Set(number) if number.abs() > 180.0);
            let entry = entry.map(|number| {
                let mut new = value.clone();
                new[at] = number;
                new
            });
            let far = is_turn && turned && editor.key_state(of.at, channel) != KeyState::NoTrack;
            let action = NodeAction::Value(of.at, channel.clone(), entry);
            actions.push(Action::Node(action));
            if far {
                actions.push(Action::Complain(
                    editor.texts().node.more_than_half.to_owned(),
                ));
            }
        }
    };
    let mut switched = None;
    if value.len() == 1 {
        ui.horizontal(|ui| {
            switched = diamond(editor, ui, of, channel, words.name);
            let width = ui.available_width();
            field(ui, 0, words.name, words.name, width);
        });
    } else {
        switched = heading(editor, ui, of, channel, words);
        for (row, several) in value.chunks(3).enumerate() {
            ui.horizontal(|ui| {
                let width = share(ui, several.len());
                for at in 3 * row..3 * row + several.len() {
                    let (name, label) = words.parts.get(at).copied().unwrap_or_default();
                    let number = (at + 1).to_string();
                    let name = if name.is_empty() { &number } else { name };
                    let whole = match channel {
                        // Its name is those of its parts.
                        Channel::Rotation => name.to_owned(),
                        _ => format!("{} {name}", words.name),
                    };
                    field(ui, at, &whole, label, width);
                }
            });
        }
    }
    actions.extend(switched);
}

/// What the fields of a channel show, and whether that are the angles of a quaternion.
fn numbers(editor: &Editor, of: Shown<'_>, channel: &Channel) -> Option<(Vec<f64>, bool)> {
    let value = editor.channel_value(of.at, channel)?;
    Some(match (channel, value.as_slice()) {
        (Channel::Rotation, &[w, x, y, z]) => {
            (angles_of(DQuat::from_xyzw(x, y, z, w)).to_vec(), true)
        }
        _ => (value, false),
    })
}

/// A channel's diamond and name, above its numbers or without any.
pub(super) fn heading(
    editor: &Editor,
    ui: &mut Ui,
    of: Shown<'_>,
    channel: &Channel,
    words: Words<'_>,
) -> Option<Action> {
    ui.horizontal(|ui| {
        let switched = diamond(editor, ui, of, channel, words.name);
        let name = RichText::new(words.name).color(theme::palette(ui).weak);
        ui.add(egui::Label::new(name).truncate())
            .on_hover_text(words.hint);
        switched
    })
    .inner
}

/// The sign of a channel's keys: small and empty without a track, hollow without a key at the
/// playhead, else filled. A click makes a key or removes it.
pub(super) fn diamond(
    editor: &Editor,
    ui: &mut Ui,
    of: Shown<'_>,
    channel: &Channel,
    name: &str,
) -> Option<Action> {
    let size = vec2(DIAMOND, theme::ROW);
    if path_moves(of.node, channel) {
        ui.allocate_exact_size(size, Sense::hover());
        return None;
    }
    let texts = &editor.texts().node;
    let state = editor.key_state(of.at, channel);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let palette = theme::palette(ui);
    let (half, fill_with, line) = match state {
        KeyState::NoTrack => (3.5, Color32::TRANSPARENT, palette.edge),
        KeyState::NotHere => (5.5, Color32::TRANSPARENT, palette.accent),
        KeyState::Here => (5.5, palette.accent, palette.accent),
    };
    let line = match response.hovered() {
        true => palette.text,
        false => line,
    };
    let ways = [Vec2::UP, Vec2::RIGHT, Vec2::DOWN, Vec2::LEFT];
    let corners = ways.map(|way| rect.center() + half * way).to_vec();
    let stroke = Stroke::new(1.5, line);
    let shape = Shape::convex_polygon(corners, fill_with, stroke);
    ui.painter().add(shape);
    let here = state == KeyState::Here;
    let label = fill(texts.key_of, &[&name]);
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, here, &label));
    let response = response.on_hover_text(match state {
        KeyState::NoTrack => texts.key_no_track,
        KeyState::NotHere => texts.key_not_here,
        KeyState::Here => texts.key_here,
    });
    let switched = || Action::Node(NodeAction::SwitchKey(of.at, channel.clone()));
    response.clicked().then(switched)
}

/// Leaves out the place of a diamond.
pub(super) fn indent(ui: &mut Ui) {
    ui.allocate_exact_size(vec2(DIAMOND, theme::ROW), Sense::hover());
}

/// A small button with a sign, called `name`.
pub(super) fn sign(ui: &mut Ui, sign: Sign, name: &str, enabled: bool) -> bool {
    let size = vec2(DIAMOND, theme::ROW);
    let sense = match enabled {
        true => Sense::click(),
        false => Sense::hover(),
    };
    let (rect, response): (_, Response) = ui.allocate_exact_size(size, sense);
    let palette = theme::palette(ui);
    let colour = match (enabled, response.hovered()) {
        (false, _) => palette.line,
        (true, true) => palette.text,
        (true, false) => palette.weak,
    };
    let (centre, stroke) = (rect.center(), Stroke::new(1.5, colour));
    let line = |points: &[Vec2]| {
        let points = points.iter().map(|&way| centre + way).collect();
        Shape::line(points, stroke)
    };
    let shape = match sign {
        Sign::Up => line(&[vec2(-4.0, 2.0), vec2(0.0, -2.0), vec2(4.0, 2.0)]),
        Sign::Down => line(&[vec2(-4.0, -2.0), vec2(0.0, 2.0), vec2(4.0, -2.0)]),
        Sign::Remove => line(&[vec2(-4.5, 0.0), vec2(4.5, 0.0)]),
    };
    ui.painter().add(shape);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    response.on_hover_text(name).clicked()
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Sign {
    Up,
    Down,
    Remove,
}
