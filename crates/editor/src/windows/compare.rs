//! A rotation that moves by keys, seen twice: its keys by quaternions and by Euler angles, at the same
//! frame, and the angle between the two (the lecture's comparison). Either can be taken.

use egui::{Button, Context, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};
use glam::DQuat;
use vides_document::Edit;
use vides_document::error::Result;
use vides_engine::scene::{Channel, Interpolation, Part, Track, Warnings};

use crate::action::Action;
use crate::panels::parts::share;
use crate::playing::track_menu::rotation_by;
use crate::state::Editor;
use crate::state::windows::{CompareWindow, Compared, Windows};
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::windows::dock::docked;
use crate::windows::sub_window::SubWindow;
use crate::{space, theme};

/// Height of the graph, in points.
const GRAPH: f32 = 64.0;

/// Most frames of a scene that are looked at; of a longer one each second, third and so on.
const FRAMES: f64 = 20_000.0;

/// The angle between two rotations, in degrees.
fn between(a: DQuat, b: DQuat) -> f64 {
    let way = a.conjugate() * b;
    // Of small angles the cosine would tell little.
    2.0 * way.xyz().length().atan2(way.w.abs()).to_degrees()
}

fn at(tracks: &[Track; 2], frame: f64) -> [DQuat; 2] {
    let warnings = &mut Warnings::default();
    tracks
        .each_ref()
        .map(|track| track.rotation(frame, warnings))
}

impl Compared {
    fn new(track: &Track, range: (f64, f64), of: (usize, (u64, u64), bool)) -> Result<Self> {
        let ways = match of.2 {
            true => [Interpolation::CatmullRom, Interpolation::EulerCatmullRom],
            false => [Interpolation::Linear, Interpolation::EulerLinear],
        };
        let [one, other] = ways.map(|way| rotation_by(track, way));
        let both = [one?, other?];
        let (first, last) = range;
        let every = ((last - first) / FRAMES).ceil().max(1.0);
        let mut made = Self {
            of,
            both,
            range,
            angles: Vec::new(),
            every,
            largest: (0.0, first),
        };
        let mut frame = first;
        while frame <= last {
            let [a, b] = at(&made.both, frame);
            let angle = between(a, b);
            made.angles.push(angle);
            if angle > made.largest.0 {
                made.largest = (angle, frame);
            }
            frame += every;
        }
        Ok(made)
    }
}

impl SubWindow for CompareWindow {
    const ID: &'static str = "compare";
    const DOCKED: bool = true;

    fn slot(windows: &mut Windows) -> &mut Option<Self> {
        &mut windows.compare
    }

    fn new(_: &Editor) -> Self {
        Self::default()
    }

    fn show(&mut self, editor: &Editor, context: &Context, actions: &mut Vec<Action>) -> bool {
        let title = editor.texts().compare.title;
        let end = docked(editor, context, (Self::ID, title), None, |ui| {
            self.contents(editor, ui, actions);
        });
        end.is_none()
    }
}

impl CompareWindow {
    fn contents(&mut self, editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
        let texts = &editor.texts().compare;
        let weak = theme::palette(ui).weak;
        let scene = editor.document.edited_scene().map(|edited| edited.scene());
        let node = scene.zip(editor.current_node());
        let node = node.and_then(|(scene, at)| Some((scene.nodes().get(at)?, at)));
        let track = node.and_then(|(node, _)| node.keys().track(&Channel::Rotation));
        let (Some(scene), Some((node, at)), Some(track)) = (scene, node, track) else {
            ui.colored_label(weak, texts.no_keys);
            return;
        };
        ui.add(egui::Label::new(fill(texts.of, &[&node.name])).truncate());
        let straight = [Interpolation::Linear, Interpolation::EulerLinear];
        let smooth = self
            .smooth
            .unwrap_or(!straight.contains(track.interpolation()));
        self.ways(editor, ui, smooth);
        let document = &editor.document;
        let number = document.edited_scene().map_or(0, |edited| edited.number());
        let of = (at, (number, document.revision()), smooth);
        if self.made.as_ref().is_none_or(|made| made.of != of) {
            match Compared::new(track, scene.frame_range(), of) {
                Ok(made) => self.made = Some(made),
                Err(error) => {
                    ui.colored_label(weak, reason_of(editor.language(), &error));
                    return;
                }
            }
        }
        if let Some(made) = &self.made {
            show(editor, ui, (at, track), made, actions);
        }
    }

    /// The choice between straight and smooth.
    fn ways(&mut self, editor: &Editor, ui: &mut Ui, smooth: bool) {
        let (texts, names) = (&editor.texts().compare, &editor.texts().timeline);
        ui.vertical(|ui| {
            for (each, name, hint) in [
                (false, names.linear, texts.straight_hint),
                (true, names.catmull_rom, texts.smooth_hint),
            ] {
                if theme::choice(ui, each == smooth, name)
                    .on_hover_text(hint)
                    .clicked()
                {
                    self.smooth = Some(each);
                }
            }
        });
    }
}

fn show(
    editor: &Editor,
    ui: &mut Ui,
    (node, now): (usize, &Track),
    made: &Compared,
    actions: &mut Vec<Action>,
) {
    let (texts, language) = (&editor.texts().compare, editor.language());
    let frame = editor.previewed_frame().unwrap_or(made.range.0);
    let turns = at(&made.both, frame);
    ui.add_space(theme::GAP);
    ui.horizontal(|ui| {
        let width = share(ui, 2);
        for (turn, name) in turns.into_iter().zip([texts.quaternions, texts.angles]) {
            let (rect, response) = ui.allocate_exact_size(vec2(width, width), Sense::hover());
            response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
            space::turned_node(editor, ui, rect, node, turn);
        }
    });
    ui.horizontal(|ui| {
        let width = share(ui, 2);
        for name in [texts.quaternions, texts.angles] {
            theme::label(ui, width, name);
        }
    });
    ui.horizontal(|ui| {
        let width = share(ui, 2);
        for (track, name) in made.both.iter().zip([texts.quaternions, texts.angles]) {
            let other = track != now;
            let button = Button::new(texts.use_these).min_size(vec2(width, theme::ROW));
            let button = ui.add_enabled(other, button);
            let name = fill(texts.use_these_of, &[&name]);
            button.widget_info(|| WidgetInfo::labeled(Role::Button, other, &name));
            let button = button.on_hover_text(texts.use_hint);
            if button.on_disabled_hover_text(texts.in_use).clicked() {
                actions.push(used(editor, node, track));
            }
        }
    });
    ui.add_space(theme::GAP);
    let [a, b] = turns;
    let number = |angle: f64| language.number(angle, 2);
    ui.label(fill(texts.angle, &[&number(between(a, b))]));
    let (largest, at) = made.largest;
    let told = at - 1.0 + f64::from(editor.document.info().first_frame);
    let decimals = usize::from(told.fract() != 0.0);
    let told = language.number(told, decimals);
    ui.label(fill(texts.largest, &[&number(largest), &told]));
    graph(editor, ui, made, frame);
}

/// What makes the track so.
fn used(editor: &Editor, node: usize, track: &Track) -> Action {
    let part = track.clone();
    match Part::track(node, Channel::Rotation, Some(part)) {
        Ok(part) => Action::Edits(vec![Edit::Part(Box::new(part))]),
        Err(error) => Action::Complain(reason_of(editor.language(), &error.into())),
    }
}

/// The angle over the frames of the scene, and the playhead.
fn graph(editor: &Editor, ui: &mut Ui, made: &Compared, frame: f64) {
    let size = vec2(ui.available_width(), GRAPH);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let name = editor.texts().compare.graph;
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
    let palette = theme::palette(ui);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 3.0, palette.button);
    let inner: Rect = rect.shrink(4.0);
    let (first, last) = made.range;
    let most = made.largest.0.max(1e-9);
    #[allow(clippy::cast_possible_truncation)]
    let x = |frame: f64| {
        let share = (frame - first) / (last - first).max(1.0);
        inner.left() + inner.width() * share as f32
    };
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)]
    let points = made.angles.iter().enumerate().map(|(at, angle)| {
        let high = inner.height() * (angle / most) as f32;
        pos2(x(first + made.every * at as f64), inner.bottom() - high)
    });
    let line = egui::Shape::line(points.collect(), Stroke::new(1.4, palette.accent));
    painter.add(line);
    let now = x(frame.clamp(first, last));
    painter.vline(now, rect.y_range(), Stroke::new(1.0, palette.text));
}

#[cfg(test)]
#[path = "compare_tests.rs"]
mod tests;
