//! A small picture of a node with its descendants, turned another way.

use egui::{Rect, Stroke, Ui};
use glam::{DMat3, DQuat, DVec3};

use super::held_nodes::parent_in_space;
use super::projection::Projection;
use crate::scene_view::wires;
use crate::setup::{Element, View};
use crate::state::Editor;
use crate::theme;

/// Most lines of the picture; of more each second, third and so on.
const LINES: usize = 4_000;

/// How much of half its side the picture fills.
const FILL: f64 = 0.85;

/// Draws a node with what is in it about its pivot, turned so in its parent, seen as in the space.
pub(crate) fn turned_node(editor: &Editor, ui: &Ui, rect: Rect, node: usize, turn: DQuat) {
    let painter = ui.painter_at(rect);
    let colours = editor.setup.colours();
    painter.rect_filled(rect, 3.0, colours.of(Element::Background));
    painter.rect_stroke(
        rect,
        3.0,
        Stroke::new(1.0, theme::palette(ui).line),
        egui::StrokeKind::Inside,
    );
    let found = editor.with_scene(|now| {
        let nodes = now.scene.nodes();
        let of = nodes.get(node)?;
        let within = now.scene.with_all_in(&[node]).ok()?;
        let into = now.states[node].world().inverse();
        let mut lines: Vec<[DVec3; 2]> = Vec::new();
        wires(editor, now, |wire| {
            if within[wire.node] {
                let own = wire.ends.map(|end| into.transform_point3(end) - of.pivot);
                lines.push(own);
            }
        });
        // Out of a flat node there is no way back.
        lines.retain(|ends| ends.iter().all(|end| end.is_finite()));
        let scale = of.rest.scale;
        let parent = parent_in_space(now, of.parent).matrix3;
        Some((lines, scale, parent))
    });
    let Some((lines, scale, parent)) = found.ok().flatten().flatten() else {
        return;
    };
    let space = editor.document.path().space;
    let view = View {
        size: 1.0,
        shift: [0.0, 0.0],
        ..editor.setup.view
    };
    let projection = Projection::of(&view, rect, space);
    let own = parent * DMat3::from_quat(turn) * DMat3::from_diagonal(scale);
    let far = |end: &DVec3| (parent * (scale * *end)).length();
    let reach = lines.iter().flatten().map(far).fold(0.0, f64::max);
    let unit = if reach > 0.0 { reach } else { 1.0 };
    let half = 0.5 * f64::from(rect.width()) * FILL;
    // Points for a unit across the line of sight.
    let fitting = half / unit / (projection.scale() / space.half_size);
    let centre = rect.center();
    let place = |way: DVec3| {
        let image = projection.image_of_way(way) * fitting;
        #[allow(clippy::cast_possible_truncation)]
        let image = egui::vec2(image.x as f32, image.y as f32);
        centre + image
    };
    let every = lines.len().div_ceil(LINES).max(1);
    let stroke = Stroke::new(1.2, colours.of(Element::Object));
    for ends in lines.iter().step_by(every) {
        let [from, to] = ends.map(|end| place(own * end));
        painter.line_segment([from, to], stroke);
    }
    // Its axes, and a sign at the end of each.
    let turned = parent * DMat3::from_quat(turn);
    for (axis, letter) in [(DVec3::X, "x"), (DVec3::Y, "y"), (DVec3::Z, "z")] {
        let way = (turned * axis).normalize_or_zero() * unit;
        let stroke = Stroke::new(1.0, colours.of(Element::Axes));
        painter.line_segment([centre, place(way * 0.85)], stroke);
        let color = colours.of(Element::Numbers);
        painter.text(
            place(way),
            egui::Align2::CENTER_CENTER,
            letter,
            theme::small(),
            color,
        );
    }
}
