//! A section whose way over time is given: its keys as squares to be dragged, and as numbers.

use egui::{Button, CursorIcon, Id, Key, Modifiers, Rect, Sense, Ui, Vec2, WidgetInfo, pos2};
use vides_engine::path::speed_curve::CurveEnd;
use vides_engine::path::{Orientation, Overrides, Pace, Timing};

use super::graph::{Axes, Handle};
use crate::action::Action;
use crate::number::Number;
use crate::state::Editor;
use crate::state::windows::SpeedWindow;
use crate::texts::fill;
use crate::theme;
use crate::windows::speed::section::{Section, entered_own};

/// Keys of the way: share of the time, share of the way.
pub(super) type Keys = [[f64; 2]];

/// How near the curve a click must be.
const NEAR: f32 = 10.0;

/// How far apart dragged keys stay, in time and in way.
const APART: f64 = 0.002;

/// How many equal parts of the time a way is sampled at: as few as come this near it everywhere,
/// in shares of the way.
const PARTS: [usize; 8] = [1, 2, 3, 4, 6, 9, 12, 18];
const NEAR_IT: f64 = 0.002;

/// A few keys near the way of a section, exactly on it where they stand.
pub(super) fn sampled(timing: &Timing) -> Vec<[f64; 2]> {
    let mut keys = Vec::new();
    for parts in PARTS {
        let times = (0..=parts).map(|part| part as f64 / parts as f64);
        keys = times.map(|time| [time, timing.fraction(time)]).collect();
        let pace = Pace::Distance(keys.as_slice().into());
        let Ok(own) = Overrides::default().with(|own| own.pace = pace) else {
            break;
        };
        let orientation = Orientation {
            own,
            ..Orientation::default()
        };
        let Ok(now) = Timing::new(&orientation, [CurveEnd::Free; 2]) else {
            break;
        };
        let off = |u: f64| (now.fraction(u) - timing.fraction(u)).abs();
        if (1..100).all(|u| off(f64::from(u) / 100.0) < NEAR_IT) {
            break;
        }
    }
    keys
}

fn set(editor: &Editor, keys: Vec<[f64; 2]>) -> Option<Action> {
    editor.own_action(|own| own.pace = Pace::Distance(keys.into()))
}

/// The keys with one of them at another place, as far as its neighbours leave room.
fn with_key(keys: &Keys, at: usize, to: [f64; 2]) -> Vec<[f64; 2]> {
    let mut new = keys.to_vec();
    for (part, wanted) in to.into_iter().enumerate() {
        let (low, high) = (keys[at - 1][part] + APART, keys[at + 1][part] - APART);
        if low <= high {
            new[at][part] = wanted.clamp(low, high);
        }
    }
    new
}

impl SpeedWindow {
    /// The squares of the keys; a click on the curve between them adds one.
    pub(super) fn keys(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        axes: &Axes,
        (section, keys): (&Section, &Keys),
        actions: &mut Vec<Action>,
    ) {
        let texts = &editor.texts().speed_window;
        let palette = theme::palette(ui);
        let place = |[time, way]: [f64; 2]| pos2(axes.x(time), axes.y(100.0 * way));
        // Drags too, or they would move the window.
        let sense = Sense::click_and_drag();
        let ground = ui.interact(axes.rect, Id::unique("way over time"), sense);
        ground.widget_info(|| WidgetInfo::labeled(egui::Role::Canvas, true, texts.way_graph));
        let on_curve = |pointer: egui::Pos2| {
            let time = axes.time(pointer.x);
            let key = [time, section.timing.fraction(time)];
            (place(key).distance(pointer) < NEAR && time > 0.0 && time < 1.0).then_some(key)
        };
        if let Some(key) = ground.hover_pos().and_then(on_curve) {
            ui.set_cursor_icon(CursorIcon::Crosshair);
            axes.paint_fixed(ui.painter(), palette, place(key));
        }
        let clicked = ground.interact_pointer_pos().filter(|_| ground.clicked());
        if let Some(key) = clicked.and_then(on_curve) {
            actions.extend(self.add(editor, keys, key));
        }
        ground.on_hover_text(texts.way_graph_hint);
        let mut removed = self.removed.take();
        for (at, &key) in keys.iter().enumerate() {
            let middle = place(key);
            if at == 0 || at + 1 == keys.len() {
                axes.paint_fixed(ui.painter(), palette, middle);
                continue;
            }
            let [time, way] = key.map(|share| editor.language().number(100.0 * share, 1));
            let handle = Handle {
                id: key_id(at),
                middle,
                place: Rect::from_center_size(middle, Vec2::splat(20.0)),
                name: &fill(texts.way_key, &[&(at + 1)]),
                value: 100.0 * key[1],
                words: fill(texts.way_at, &[&way, &time]),
                rises: true,
                cursor: CursorIcon::Move,
            };
            let moved = handle.show(&mut self.held, ui, axes.rect, actions);
            let mut to = None;
            if let Some((to_pos, fine)) = moved.to {
                let scale = if fine { 1e4 } else { 1e3 };
                let place = [axes.time(to_pos.x), axes.value(to_pos.y) / 100.0];
                to = Some(place.map(|share| (share * scale).round() / scale));
            }
            if moved.steps != [0.0; 2] {
                to = Some([0, 1].map(|part| key[part] + moved.steps[part] / 100.0));
            }
            if let Some(to) = to {
                actions.extend(set(editor, with_key(keys, at, to)));
            }
            if moved.response.has_focus() {
                self.key = at;
            }
            if moved.response.secondary_clicked() {
                removed = Some(at);
            }
        }
        if let Some(&key) = keys.get(self.shown(keys)) {
            axes.paint_chosen(ui.painter(), palette, place(key));
        }
        if let Some(at) = removed {
            actions.extend(self.remove(editor, keys, at));
        }
    }

    /// The key that the numbers show.
    fn shown(&self, keys: &Keys) -> usize {
        self.key.min(keys.len() - 1)
    }

    fn add(&mut self, editor: &Editor, keys: &Keys, key: [f64; 2]) -> Option<Action> {
        let mut keys = keys.to_vec();
        self.key = keys.partition_point(|other| other[0] < key[0]);
        keys.insert(self.key, key);
        set(editor, keys)
    }

    fn remove(&mut self, editor: &Editor, keys: &Keys, at: usize) -> Option<Action> {
        if at == 0 || at + 1 >= keys.len() {
            return None;
        }
        let mut keys = keys.to_vec();
        keys.remove(at);
        set(editor, keys)
    }

    /// One key as numbers, and buttons to add one and to remove it.
    pub(super) fn key_numbers(
        &mut self,
        editor: &Editor,
        ui: &mut Ui,
        (section, keys): (&Section, &Keys),
        actions: &mut Vec<Action>,
    ) {
        let texts = &editor.texts().speed_window;
        let at = self.shown(keys);
        let fixed = at == 0 || at + 1 == keys.len();
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = theme::GAP;
            let which = fill(texts.which_key, &[&(at + 1), &keys.len()]);
            theme::label(ui, 112.0, &which);
            let parts = [
                (texts.key_time, texts.key_time_hint),
                (texts.key_way, texts.key_way_hint),
            ];
            for (part, (name, hint)) in parts.into_iter().enumerate() {
                let shown = (keys[at][part] * 1e11).round() / 1e9;
                let range = if fixed {
                    shown..=shown
                } else {
                    let apart = 100.0 * APART;
                    let neighbours = [keys[at - 1][part], keys[at + 1][part]];
                    let [low, high] = neighbours.map(|share| (share * 1e5).round() / 1e3);
                    low + apart..=(high - apart).max(low + apart)
                };
                let number = Number::new(name, shown)
                    .label(name)
                    .hint(hint)
                    .unit("\u{a0}%")
                    .decimals(1)
                    .range(range)
                    .steps(1.0, 0.1)
                    .fixed_if(fixed);
                let id = format!("speed.key.{part}");
                let entry = number.show(ui, editor.language(), &id, 104.0);
                actions.extend(entered_own(editor, entry, |own, value| {
                    let mut keys = keys.to_vec();
                    keys[at][part] = value / 100.0;
                    own.pace = Pace::Distance(keys.into());
                }));
            }
            if ui
                .button(texts.new_key)
                .on_hover_text(texts.new_key_hint)
                .clicked()
            {
                let gap = |pair: &&[[f64; 2]]| pair[1][0] - pair[0][0];
                let gaps = keys.windows(2);
                let widest = gaps.max_by(|a, b| gap(a).total_cmp(&gap(b)));
                let time = widest.map_or(0.5, |pair| f64::midpoint(pair[0][0], pair[1][0]));
                let key = [time, section.timing.fraction(time)];
                actions.extend(self.add(editor, keys, key));
            }
            let remove = ui.add_enabled(!fixed, Button::new(texts.remove_key));
            if remove.on_hover_text(texts.remove_key_hint).clicked() {
                actions.extend(self.remove(editor, keys, at));
            }
        });
    }

    /// Takes Delete where a key has the keyboard: that key is removed.
    pub(crate) fn take_keys(&mut self, context: &egui::Context) {
        let focused = context.memory(|memory| memory.focused());
        if focused == Some(key_id(self.key))
            && context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Delete))
        {
            self.removed = Some(self.key);
        }
    }
}

fn key_id(at: usize) -> Id {
    Id::unique(("distance key", at))
}
