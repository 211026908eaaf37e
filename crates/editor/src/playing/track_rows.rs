//! Rows of the keys of nodes: which there are, where they stand, what lies under the pointer.

use egui::{Id, Pos2, Rect, Role, Sense, Shape, Stroke, Ui, WidgetInfo, vec2};
use vides_document::EditedScene;
use vides_engine::scene::{Channel, Node};
use vides_engine::shared_list::SharedList;

use crate::playing::axis::as_frame;
use crate::playing::axis::{Axis, REACH};
use crate::playing::track_curve::Of;
use crate::state::Editor;
use crate::state::playing::tracks::{Memory, Row};
use crate::state::scene_view::KeyAt;
use crate::texts::fill;
use crate::theme;

pub(crate) const ROW: f32 = 20.0;

/// A bracket stands this far outside of the keys between which it scales the time.
pub(crate) const OUTSIDE: f32 = 10.0;

/// Indent of the tracks' names.
pub(crate) const INDENT: f32 = 12.0;

impl Row {
    pub(crate) fn node(self, edited: &EditedScene) -> Option<&Node> {
        edited.scene().nodes().get(self.node)
    }

    pub(crate) fn of(self, edited: &EditedScene) -> Option<Of<'_>> {
        let (scene, node) = (edited.scene(), self.node);
        let track = self.node(edited)?.keys().tracks().get(self.track?)?;
        Some(Of { scene, node, track })
    }

    /// The tracks that it shows: its own, or all of its node.
    pub(crate) fn tracks(self, edited: &EditedScene) -> impl Iterator<Item = Of<'_>> + Clone {
        let (scene, node) = (edited.scene(), self.node);
        let of = self.node(edited);
        let all = of.map_or(SharedList::EMPTY, |node| node.keys().tracks());
        let shown = match self.track {
            Some(at) if at < all.len() => all.range(at..=at),
            Some(_) => all.range(..0),
            None => all.iter(),
        };
        shown.map(move |track| Of { scene, node, track })
    }
}

/// What lies under the pointer.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Hit {
    Nothing,
    Keys(Vec<KeyAt>),
    /// The bracket before the first selected key, or that behind the last one.
    End {
        first: bool,
    },
    /// The bar of a node's path.
    Bar(usize),
}

/// The rows on the screen.
pub(crate) struct Shown<'a> {
    pub(crate) rows: &'a [Row],
    pub(crate) axis: Axis,
    /// Where the first one begins; what is seen of them.
    pub(crate) top: f32,
    pub(crate) ground: Rect,
    /// The selected keys, and the scene's frames between which they lie.
    pub(crate) selected: Vec<KeyAt>,
    pub(crate) ends: Option<(f64, f64)>,
}

impl Shown<'_> {
    pub(crate) fn number_at(&self, y: f32) -> f32 {
        (y - self.top) / ROW
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub(crate) fn row_at(&self, y: f32) -> Option<Row> {
        let number = self.number_at(y);
        let there = number >= 0.0;
        self.rows.get(number as usize).copied().filter(|_| there)
    }

    /// What is there of keys, brackets and bars.
    pub(crate) fn hit(&self, editor: &Editor, at: Pos2) -> Hit {
        let Some((edited, row)) = editor.document.edited_scene().zip(self.row_at(at.y)) else {
            return Hit::Nothing;
        };
        let tracks = row.tracks(edited);
        let near = |of: Of<'_>| {
            let frames = of.track.frames();
            Some(frames[self.axis.nearest(frames, at.x)?])
        };
        let away = |frame: &f64| (self.axis.place(*frame) - at.x).abs();
        let frames = tracks.clone().filter_map(near);
        if let Some(frame) = frames.min_by(|a, b| away(a).total_cmp(&away(b))) {
            let there = |of: Of<'_>| of.at_frame(frame).map(|key| of.key(key));
            return Hit::Keys(tracks.filter_map(there).collect());
        }
        if let Some(brackets) = self.brackets() {
            for (x, first) in brackets.into_iter().zip([true, false]) {
                if (x - at.x).abs() <= 0.5 * REACH {
                    return Hit::End { first };
                }
            }
        }
        let bar = row
            .track
            .is_none()
            .then(|| bar_of(editor, edited, row.node));
        match bar.flatten() {
            Some((first, last))
                if (self.axis.place(first)..=self.axis.place(last)).contains(&at.x) =>
            {
                Hit::Bar(row.node)
            }
            _ => Hit::Nothing,
        }
    }

    /// Where the brackets stand by which the time between the selected keys is scaled.
    pub(crate) fn brackets(&self) -> Option<[f32; 2]> {
        let (first, last) = self.ends.filter(|(first, last)| first < last)?;
        Some([
            self.axis.place(first) - OUTSIDE,
            self.axis.place(last) + OUTSIDE,
        ])
    }
}

/// The scene's frames between which a node's path moves it.
pub(crate) fn bar_of(editor: &Editor, edited: &EditedScene, node: usize) -> Option<(f64, f64)> {
    let path = edited.scene().nodes().get(node)?.path()?;
    if edited.node() == Some(node) {
        // The path as it is now.
        let first = editor.document.start_frame();
        let frames = as_frame(editor.playing.marks.frames.max(1));
        return Some((first, first + frames - 1.0));
    }
    Some(path.first_and_last())
}

/// The frame of a key.
pub(crate) fn frame_of(edited: &EditedScene, at: &KeyAt) -> Option<f64> {
    let of = Of::new(edited, at.node, &at.channel)?;
    of.track.frames().get(at.key).copied()
}

/// What a channel is called.
pub(crate) fn channel_name(editor: &Editor, channel: &Channel) -> String {
    let texts = &editor.texts().timeline;
    match channel {
        Channel::Position => texts.position.to_owned(),
        Channel::Rotation => texts.rotation.to_owned(),
        Channel::Scale => texts.scale.to_owned(),
        Channel::Visible => texts.visible.to_owned(),
        Channel::Zoom => texts.zoom.to_owned(),
        Channel::Roll => texts.roll.to_owned(),
        Channel::Colour => texts.colour.to_owned(),
        Channel::Intensity => texts.intensity.to_owned(),
        Channel::Cone => texts.cone.to_owned(),
        Channel::Weights => texts.weights.to_owned(),
        Channel::AimWeight => texts.aim_weight.to_owned(),
        Channel::Deformation { at, parameter } => {
            let parameter = editor.texts().node.parameter(parameter);
            fill(texts.deformation, &[&(at + 1), &parameter])
        }
        Channel::Value { name, .. } => name.clone(),
    }
}

/// What has the keyboard where keys are selected.
pub(crate) fn id() -> Id {
    Id::unique("tracks of nodes")
}

/// The name of a row; that of a node folds its tracks.
pub(crate) fn caption(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    (row, room): (Row, Rect),
    edited: &EditedScene,
) {
    let palette = theme::palette(ui);
    let Some(node) = row.node(edited) else {
        return;
    };
    let painter = ui.painter_at(room.intersect(ui.clip_rect()));
    let place = room.left_center() + vec2(INDENT, 0.0);
    if let Some(of) = row.of(edited) {
        let words = channel_name(editor, of.track.channel());
        if theme::elided(&painter, place, &words, palette.weak) {
            let id = Id::unique(("name of track", row.node, row.track));
            ui.interact(room, id, Sense::hover()).on_hover_text(words);
        }
        return;
    }
    let response = ui.interact(room, Id::unique(("tracks of", row.node)), Sense::CLICK);
    let words = fill(editor.texts().timeline.tracks_of, &[&node.name]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, words.as_str()));
    let colour = match response.hovered() {
        true => palette.focus,
        false => palette.text,
    };
    if !node.keys().tracks().is_empty() {
        let open = !memory.folded.contains(&row.node);
        painter.add(theme::triangle(
            room.left_center() + vec2(5.0, 0.0),
            open,
            colour,
        ));
    }
    let response = match theme::elided(&painter, place, &node.name, colour) {
        true => response.on_hover_text(&node.name),
        false => response,
    };
    if response.clicked() && !memory.folded.remove(&row.node) {
        memory.folded.insert(row.node);
    }
}

/// A square on its corner.
pub(crate) fn diamond(middle: Pos2, half: f32, fill: egui::Color32, line: Stroke) -> Shape {
    let corners = [(0.0, -half), (half, 0.0), (0.0, half), (-half, 0.0)];
    let corners = corners.map(|(x, y)| middle + vec2(x, y));
    Shape::convex_polygon(corners.to_vec(), fill, line)
}

/// The rows of the selected nodes that move.
pub(crate) fn rows(editor: &Editor, memory: &Memory) -> Vec<Row> {
    let Some(edited) = editor.document.edited_scene() else {
        return Vec::new();
    };
    let nodes = edited.scene().nodes();
    let selected = editor.selected_nodes();
    let mut rows = Vec::with_capacity(2 * selected.len());
    for node in selected {
        let tracks = nodes[node].keys().tracks().len();
        if tracks == 0 && nodes[node].path().is_none() {
            continue;
        }
        rows.push(Row { node, track: None });
        if memory.folded.is_empty() || !memory.folded.contains(&node) {
            rows.extend((0..tracks).map(|track| Row {
                node,
                track: Some(track),
            }));
        }
    }
    rows
}

/// The scene's frames between which keys lie.
pub(crate) fn ends(editor: &Editor, keys: &[KeyAt]) -> Option<(f64, f64)> {
    let edited = editor.document.edited_scene()?;
    let frames = keys.iter().filter_map(|at| frame_of(edited, at));
    let both = frames.map(|frame| (frame, frame));
    both.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}
