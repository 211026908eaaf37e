//! What the space itself offers: how to begin with an empty document, and a space for points that
//! lie outside.

mod sign;

use std::path::Path;
use std::time::Duration;

use egui::{Align2, Button, FontId, Rect, Role, Ui, Vec2, WidgetInfo, vec2};
use vides_document::Edit;
use vides_document::tool;
use vides_document::tool::Tool;
use vides_engine::path::Space;

use crate::action::{Action, FileAction, PathAction, ToolAction};
use crate::files::recent::PICTURE;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::files::Picture;
use crate::state::scene_view::NodeAction;
use crate::state::space::Around;
use crate::texts::fill;
use crate::texts::refusals::reason_of;
use crate::theme;

/// Size of a beginning's button, and between two of them.
const BUTTON: Vec2 = vec2(84.0, 54.0);
const GAP: f32 = 4.0;

/// Height of a beginning's name below its sign.
const NAME: f32 = 16.0;

/// Seconds in which a camera flies through a beginning's sign.
const ROUND: f64 = 2.0;
const FRAME: Duration = Duration::from_millis(33);

/// A button with a picture above its name; and how many recent files there are at most.
const PICTURED: Vec2 = vec2(132.0, PICTURE.y + theme::ROW);
const MOST: usize = 4;

/// Above the lower border; what the axes in the corner take, at the left and in height.
const ABOVE: f32 = 10.0;
const AXES: Vec2 = vec2(220.0, 88.0);

/// The moves and tools that are offered.
const TOOLS: [&str; 4] = ["orbit", "flyby", "draw", "tour"];

/// A way to begin.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    Tool(Tool),
    /// With the program's camera as the first point.
    View,
    Open,
}

impl Begin {
    /// Its place among [`TOOLS`].
    fn index(self) -> Option<usize> {
        let Self::Tool(tool) = self else { return None };
        TOOLS.iter().position(|name| *name == tool.name)
    }
}

/// What is offered now, with its place: ways to begin, and files that were open last, the newest
/// first.
#[derive(Debug, Default)]
struct Offered {
    begins: Vec<(Begin, Rect)>,
    /// With their places in the list.
    recent: Vec<(usize, Rect)>,
}

impl Offered {
    fn places(&self) -> impl Iterator<Item = Rect> + '_ {
        let begins = self.begins.iter().map(|(_, place)| *place);
        begins.chain(self.recent.iter().map(|(_, place)| *place))
    }
}

fn offered(editor: &Editor, viewport: Rect) -> Offered {
    let is_open = editor.windows.tool.is_some() || editor.windows.has_modal();
    if is_open || !editor.begins() {
        return Offered::default();
    }
    let tools = TOOLS.iter().filter_map(|name| {
        let mut all = tool::tools();
        all.find(|tool| tool.name == *name).map(Begin::Tool)
    });
    let views = editor.host_view.captures || editor.ghost.is_some();
    let view = views.then_some(Begin::View);
    let mut all: Vec<Begin> = tools.chain(view).chain([Begin::Open]).collect();
    let width = |count: usize, each: f32| count as f32 * (each + GAP) - GAP;
    // Beside the axes, or else above them; what has no room is in the menus.
    let beside = viewport.shrink(ABOVE).with_min_x(viewport.left() + AXES.x);
    let above = viewport.shrink(ABOVE);
    let above = above.with_max_y(above.bottom() - AXES.y);
    let room = match beside.width() >= width(all.len(), BUTTON.x) {
        true => beside,
        false => above,
    };
    // As large as there is room for pictures of an object.
    let each = (room.width() + GAP) / all.len() as f32 - GAP;
    let size = match each.clamp(BUTTON.x, PICTURED.x) {
        wide if editor.has_object() && room.height() >= 4.0 * PICTURED.y => {
            vec2(wide, wide * PICTURE.y / PICTURED.x + NAME + 4.0)
        }
        _ => BUTTON,
    };
    while all.len() > 1 && width(all.len(), size.x) > room.width() {
        all.remove(all.len() - 2);
    }
    if room.height() < 2.0 * size.y {
        return Offered::default();
    }
    let left = room.center().x - width(all.len(), size.x) / 2.0;
    let places = (0..all.len()).map(|at| {
        let left = left + at as f32 * (size.x + GAP);
        Rect::from_min_size(egui::pos2(left, room.bottom() - size.y), size)
    });
    let begins: Vec<(Begin, Rect)> = all.clone().into_iter().zip(places).collect();
    Offered {
        begins,
        recent: recent(editor, room.with_max_y(room.bottom() - size.y - GAP)),
    }
}

/// The files that were open last, above what else is offered.
fn recent(editor: &Editor, room: Rect) -> Vec<(usize, Rect)> {
    // The object that is loaded is no other.
    let source = editor.document.info().object.source();
    let own = source.map(|source| Path::new(&source.file));
    let others = (0..editor.recent.len()).filter(|&at| own != Some(&*editor.recent[at]));
    let others: Vec<usize> = others.collect();
    let fit = ((room.width() + GAP) / (PICTURED.x + GAP)).max(0.0) as usize;
    let high = room.height() >= 2.0 * BUTTON.y;
    let count = fit.min(MOST).min(others.len() * usize::from(high));
    let step = PICTURED.x + GAP;
    let left = room.center().x - (count as f32 * step - GAP) / 2.0;
    // Where pictures would cover the path there are the names alone.
    let height = match room.height() + BUTTON.y < 5.0 * PICTURED.y {
        true => theme::ROW,
        false => PICTURED.y,
    };
    let places = (0..count).map(|at| {
        let corner = egui::pos2(left + at as f32 * step, room.bottom() - height);
        Rect::from_min_size(corner, vec2(PICTURED.x, height))
    });
    others.into_iter().zip(places).collect()
}

impl Editor {
    /// Whether nothing has been done to the path yet: it can be begun with a tool, or around an
    /// object.
    pub(crate) fn begins(&self) -> bool {
        let document = &self.document;
        let of_none = self.file.is_none() && document.edited_scene().is_none();
        of_none && document.is_new()
    }
}

/// How many points lie outside the space, where nothing is dragged.
fn outside(editor: &Editor) -> usize {
    if editor.document.in_step() || !editor.document.edits_path() {
        return 0;
    }
    editor.document.points_outside()
}

/// The words on the button for them, and its place.
fn notice(editor: &Editor, viewport: Rect) -> Option<(String, Rect)> {
    let texts = &editor.texts().space;
    let missing = editor.first_missing_mesh();
    let text = match (missing, outside(editor)) {
        (Some((_, file)), _) => {
            let name = crate::files::short(Path::new(file));
            fill(editor.texts().node.find_mesh, &[&name])
        }
        (None, 0) => return None,
        (None, 1) => texts.one_outside.to_owned(),
        (None, many) => fill(texts.some_outside, &[&many]),
    };
    let size = vec2(
        (viewport.width() - 2.0 * ABOVE).clamp(120.0, 290.0),
        theme::ROW,
    );
    let wide = viewport.width() > AXES.x + size.x + 2.0 * ABOVE;
    let middle = match wide {
        true => (viewport.left() + AXES.x + viewport.right()) / 2.0,
        false => viewport.center().x,
    };
    let above = if wide { ABOVE } else { AXES.y + ABOVE };
    let bottom = viewport.bottom() - above;
    let place = egui::pos2(middle, bottom - size.y / 2.0);
    Some((text, Rect::from_center_size(place, size)))
}

/// What lies above the space: not to be dragged there.
pub(super) fn rooms(editor: &Editor, viewport: Rect) -> impl Iterator<Item = Rect> + use<> {
    let offered = offered(editor, viewport);
    let notice = notice(editor, viewport).map(|(_, place)| place);
    offered
        .places()
        .chain(notice)
        .collect::<Vec<_>>()
        .into_iter()
}

/// Shows both.
pub(super) fn show(editor: &Editor, ui: &mut Ui, viewport: Rect, actions: &mut Vec<Action>) {
    let offered = offered(editor, viewport);
    let around = (!offered.begins.is_empty()).then(|| Around::of(editor));
    for (begin, place) in &offered.begins {
        let around = around.as_ref().and_then(Option::as_ref);
        show_beginning(editor, ui, (*begin, *place, around), actions);
    }
    let names = editor.recent_names();
    for &(at, place) in &offered.recent {
        show_recent(editor, ui, (at, place, &names[at]), actions);
    }
    show_notice(editor, ui, viewport, actions);
}

fn show_beginning(
    editor: &Editor,
    ui: &mut Ui,
    (begin, place, around): (Begin, Rect, Option<&Around>),
    actions: &mut Vec<Action>,
) {
    let texts = &editor.texts().space;
    let (name, hint, action) = match begin {
        Begin::Tool(tool) => (
            editor.language().tool(tool.name),
            editor.language().tool_hint(&tool),
            Action::Tool(ToolAction::Open(tool)),
        ),
        Begin::View => (
            texts.begin_view,
            texts.take_over_here_tip,
            Action::Path(PathAction::TakeOver { replace: true }),
        ),
        Begin::Open => (
            texts.begin_open,
            texts.begin_open_tip,
            Action::File(FileAction::Load),
        ),
    };
    let response = ui.put(place, Button::new("").frame_when_inactive(true));
    let moves = response.hovered() && !editor.still;
    let way = moves.then(|| {
        ui.ctx().request_repaint_after(FRAME);
        (ui.input(|input| input.time) / ROUND).fract() as f32
    });
    let told = fill(texts.begin_with, &[&name]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
    let (above, foot) = place.split_top_bottom_at_y(place.bottom() - NAME - 2.0);
    let mut color = ui.style().interact(&response).fg_stroke.color;
    let text_color = color;
    let mut is_drawn = false;
    if let Some((around, at)) = around.zip(begin.index()) {
        let paint = |picture: &Picture| {
            picture.paint(editor, ui, above.shrink(2.0), way);
            is_drawn = picture.has_path();
            // A sign on the object stands out from it as a path does.
            color = editor.setup.colours().of(Element::Curve);
        };
        let known = &editor.begin_pictures;
        known.show((editor, ui.ctx()), around, sign::pictures, (at, paint));
    }
    if !is_drawn {
        sign::paint(&ui.painter_at(place), begin, above.center(), color, way);
    }
    let foot = foot.center_bottom() - vec2(0.0, 4.0);
    let font = FontId::proportional(11.5);
    ui.painter()
        .text(foot, Align2::CENTER_BOTTOM, name, font, text_color);
    if response.on_hover_text(hint).clicked() {
        actions.push(action);
    }
}

fn show_recent(
    editor: &Editor,
    ui: &mut Ui,
    (at, place, name): (usize, Rect, &str),
    actions: &mut Vec<Action>,
) {
    let response = ui.put(place, Button::new("").frame_when_inactive(true));
    let (above, foot) = place.split_top_bottom_at_y(place.bottom() - theme::ROW);
    if above.height() > 0.0 {
        editor.paint_recent(ui, at, Rect::from_center_size(above.center(), PICTURE));
    }
    let text = egui::WidgetText::from(egui::RichText::new(name).font(theme::small()));
    let room = foot.width() - 12.0;
    let wrap = Some(egui::TextWrapMode::Truncate);
    let galley = text.into_galley(ui, wrap, room, egui::TextStyle::Small);
    let color = ui.style().interact(&response).fg_stroke.color;
    let corner = foot.center() - galley.size() / 2.0;
    ui.painter().galley(corner, galley, color);
    let told = fill(editor.texts().space.begin_with, &[&name]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, told.as_str()));
    let file = editor.recent.get(at).map(|file| file.display().to_string());
    let hint = fill(
        editor.texts().menu_hints.recent,
        &[&file.unwrap_or_default()],
    );
    if response.on_hover_text(hint).clicked() {
        actions.push(Action::File(FileAction::Recent(at)));
    }
}

fn show_notice(editor: &Editor, ui: &mut Ui, viewport: Rect, actions: &mut Vec<Action>) {
    let Some((text, place)) = notice(editor, viewport) else {
        return;
    };
    let button = Button::new(egui::RichText::new(text).font(theme::small()));
    let response = ui.put(place, button.truncate());
    if let Some((purpose, file)) = editor.first_missing_mesh() {
        let hint = format!("{file}\n{}", editor.texts().node.find_hint);
        if response.on_hover_text(hint).clicked() {
            actions.push(Action::Node(NodeAction::AskFile(purpose)));
        }
        return;
    }
    if response
        .on_hover_text(editor.texts().space.outside_tip)
        .clicked()
    {
        let space = editor.document.path().space;
        actions.push(match editor.document.space_around_path() {
            Ok(around) => Action::Edit(Edit::SetSpace {
                space: Space {
                    up: space.up,
                    ..around
                },
                fit: false,
            }),
            Err(error) => Action::Complain(reason_of(editor.language(), &error)),
        });
    }
}

#[cfg(test)]
mod tests;
